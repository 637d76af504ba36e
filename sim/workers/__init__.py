"""Work in processes of its own: pools of verdicts for trainers, and a fence round foreign input."""
