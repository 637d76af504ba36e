"""Exact geometry of solids in a room, without the engine: boundaries, openings, swings, ways, free space."""
