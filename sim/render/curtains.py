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
_LONG, _SHORT, _OVER_SILL = 0.02, 0.12, 0.2
"""Where it ends: above the floor, below the sill, or above it [m]."""
FOLDS = 9


def curtain_ends(scene: Scene) -> dict[str, float]:
    """The height of the lower edge of the curtains of each window that has them [m], by the window's id.

    They reach the floor where that is free on both sides, else the sill, or a little of the pane. All windows are
    dressed alike: where one is hemmed in, or curtains are among the furniture, none has any.
    """
    if scene.surfaces.curtains is None or any("curtain" in p.category for p in scene.placements):
        return {}
    found: dict[str, float] = {}
    for opening in scene.room.openings:
        if opening.kind == "window" and opening.sill > 0.3:
            ends = (_LONG, opening.sill - _SHORT, opening.sill + _OVER_SILL)
            end = next((end for end in ends if _is_free(scene, opening, end)), None)
            if end is None:
                return {}
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
