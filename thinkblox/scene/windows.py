"""What hangs at windows."""

from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room

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


def covered_openings(room: Room, hung: Placement) -> tuple[Opening, ...]:
    """The doors and windows of which something that hangs on a wall covers a part."""
    found = []
    for opening in room.openings:
        wall = room.walls[opening.wall]
        along, _ = wall.coordinates(hung.position[:2])
        begin, end = along - hung.size[1] / 2, along + hung.size[1] / 2
        beside = end <= opening.offset or opening.offset + opening.width <= begin
        over_or_under = hung.top <= opening.sill or opening.sill + opening.height <= hung.position[2]
        if wall.name == hung.support and not beside and not over_or_under:
            found.append(opening)
    return tuple(found)
