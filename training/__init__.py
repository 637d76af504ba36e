"""Demonstrations, rewards and trainers."""
