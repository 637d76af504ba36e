"""Curtains at the windows of a picture, where nothing stands in their way."""

import numpy as np
from shapely import Polygon

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

SIDE = 0.27
"""How far a drawn-back curtain reaches beyond its window [m]."""
OVER = 0.05
"""How far it covers the pane [m]."""
DEPTH = 0.13
"""How far it stands into the room [m]."""
ROD = 0.09
"""Height of the rod above the window [m]."""
_LONG, _SHORT = 0.02, 0.12
"""Where it ends: above the floor, or below the sill [m]."""
FOLDS = 9


def curtain_ends(scene: Scene) -> dict[str, float]:
    """The height of the lower edge of the curtains of each window that has them [m], by the window's id.

    They reach the floor where that is free on both sides, the sill where only that is; a window that is hemmed in, or
    in a room with curtains among its furniture, has none.
    """
    if scene.surfaces.curtains is None or any("curtain" in p.category for p in scene.placements):
        return {}
    found: dict[str, float] = {}
    for opening in scene.room.openings:
        if opening.kind == "window" and opening.sill > 0.3:
            free = (end for end in (_LONG, opening.sill - _SHORT) if _is_free(scene, opening, end))
            end = next(free, None)
            if end is not None:
                found[opening.id] = end
    return found


def top_of(opening: Opening, room: Room) -> float:
    """Height of the rod [m]."""
    return min(opening.sill + opening.height + ROD, room.height - 0.02)


def sides_of(opening: Opening) -> tuple[Vec2, Vec2]:
    """From where to where along the wall the two curtains of a window hang [m]."""
    end = opening.offset + opening.width
    return (opening.offset - SIDE, opening.offset + OVER), (end - OVER, end + SIDE)


def _is_free(scene: Scene, window: Opening, bottom: float) -> bool:
    room = scene.room
    wall, top = room.walls[window.wall], top_of(window, room)
    for start, end in sides_of(window):
        if start < 0.02 or end > wall.length - 0.02 or _meets_opening(room, window, start, end, bottom):
            return False
        area = _strip(wall, start, end)
        for placement in scene.placements:
            low = placement.position[2]
            if low < top and low + placement.size[2] > bottom and placement.footprint.intersects(area):
                return False
    return True


def _meets_opening(room: Room, window: Opening, start: float, end: float, bottom: float) -> bool:
    others = (o for o in room.openings if o.wall == window.wall and o.id != window.id)
    return any(
        o.offset - 0.08 < end and o.offset + o.width + 0.08 > start for o in others if o.sill + o.height > bottom
    )


def _strip(wall: Wall, start: float, end: float) -> Polygon:
    corners = [wall.point(start, 0.001), wall.point(end, 0.001), wall.point(end, DEPTH), wall.point(start, DEPTH)]
    return Polygon(np.array(corners))
