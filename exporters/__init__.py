"""Scenes as files: MJCF, USD, and the output folder."""
