"""Verdicts: candidates instantiated in MuJoCo, measured, let go, and judged."""
