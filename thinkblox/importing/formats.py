"""The formats of layouts that are read."""

FORMATS: tuple[str, ...] = ("holodeck", "idesign", "il3d", "layoutgpt", "layoutvlm", "metaspatial", "sceneeval")
"""By name; MetaSpatial's is I-Design's."""
