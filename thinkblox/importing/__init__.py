"""Layouts of other generators as scenes: every convention is converted here and nowhere else."""
