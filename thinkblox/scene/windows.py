"""What hangs at windows."""

from thinkblox.scene.arrangement import Arrangement

_BY_WALL = 0.3
"""The middle of what hangs at a window is no further from its wall [m]."""


def hangs_at_window(scene: Arrangement, id: str) -> bool:
    """Whether the middle of a thing is by a wall between the sides of one of its windows, however high."""
    x, y, _ = scene[id].position
    for opening in scene.room.openings:
        along, inward = scene.room.walls[opening.wall].coordinates((x, y))
        between = opening.offset <= along <= opening.offset + opening.width
        if opening.kind == "window" and between and abs(inward) <= _BY_WALL:
            return True
    return False
