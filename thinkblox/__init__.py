"""Physics-verified indoor scenes: a prompt in, a furnished room that MuJoCo has measured out."""
