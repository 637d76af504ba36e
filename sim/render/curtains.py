"""Curtains at the windows of a picture, where nothing stands in their way."""

from typing import NamedTuple

import numpy as np
from shapely import Polygon

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

DEPTH = 0.13
"""How far it stands into the room [m]."""
ROD = 0.09
"""Height of the rod above the window [m]."""
_LONG, _SHORT, _OVER_SILL = 0.02, 0.12, 0.2
"""Where it ends: above the floor, below the sill, or above it [m]."""
FOLDS = 9


class Drape(NamedTuple):
    """How the two curtains of a window hang [m].

    Attributes:
        bottom: height of their lower edge.
        beyond: how far each reaches beyond the window.
        over: how far it covers the pane.
    """

    bottom: float
    beyond: float
    over: float


_WIDE, _CLOSE = (0.27, 0.05), (0.02, 0.22)
"""How far curtains reach beyond a window and over its pane: drawn back beside it, and before it [m]."""


def curtains_at(scene: Scene) -> dict[str, Drape]:
    """How curtains hang at each window that has them, by the window's id.

    They reach the floor where that is free on both sides, else the sill, or a little of the pane, and hang beside the
    windows, or before the panes where something stands close beside one. All windows are dressed alike: where one is
    hemmed in, or curtains are among the furniture, none has any.
    """
    if scene.surfaces.curtains is None or any("curtain" in p.category for p in scene.placements):
        return {}
    windows = [o for o in scene.room.openings if o.kind == "window" and o.sill > 0.3]
    for beyond, over in (_WIDE, _CLOSE):
        found = [_drape(scene, window, beyond, over) for window in windows]
        hung = {window.id: drape for window, drape in zip(windows, found, strict=True) if drape is not None}
        if len(hung) == len(windows):
            return hung
    return {}


def top_of(opening: Opening, room: Room) -> float:
    """Height of the rod [m]."""
    return min(opening.sill + opening.height + ROD, room.height - 0.02)


def sides_of(opening: Opening, drape: Drape) -> tuple[Vec2, Vec2]:
    """From where to where along the wall the two curtains of a window hang [m]."""
    start, end = opening.offset, opening.offset + opening.width
    return (start - drape.beyond, start + drape.over), (end - drape.over, end + drape.beyond)


def _drape(scene: Scene, window: Opening, beyond: float, over: float) -> Drape | None:
    """The longest curtains that hang free at a window; None where none do."""
    ends = (_LONG, window.sill - _SHORT, window.sill + _OVER_SILL)
    drapes = (Drape(end, beyond, min(over, window.width / 4)) for end in ends)
    return next((drape for drape in drapes if _is_free(scene, window, drape)), None)


def _is_free(scene: Scene, window: Opening, drape: Drape) -> bool:
    room, bottom = scene.room, drape.bottom
    wall, top = room.walls[window.wall], top_of(window, room)
    for start, end in sides_of(window, drape):
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
