"""What Blender makes of exported rooms."""
