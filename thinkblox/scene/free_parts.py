"""Parts of a room that are to stay free of furniture: where they are, and what stands in them."""

from typing import NamedTuple

import numpy as np

from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.landmarks import WINDOW_ZONE, corners, walls
from thinkblox.scene.pairs import AGAINST_WALL, CORNER
from thinkblox.scene.rectangles import Rects, overlap_depth
from thinkblox.scene.room import Room, Wall
from thinkblox.value import Vec2

MIDDLE_SHARE = 1.0 / 3.0
"""Share of each side of the room that its middle takes."""
HEAD_HEIGHT = 1.9
"""What hangs higher than this leaves the floor under it free [m]."""
TOUCH = 0.005
"""Reaching in by less than this is not taking space [m]."""
ANY_WALL = ("wall", "one_wall", "opposite_wall")
_Row = tuple[Vec2, Vec2, float, float, float]


class FreePart(NamedTuple):
    """One part of a room: its name, and the boxes that stay free."""

    name: str
    boxes: Rects


def parts(room: Room, place: str) -> tuple[FreePart, ...]:
    """The parts that a Place, or the name of a wall, can mean; of several any one that is free will do."""
    if place == "centre":
        x, y = room.polygon.centroid.coords[0]
        size = (room.extent[0] * MIDDLE_SHARE, room.extent[1] * MIDDLE_SHARE)
        return (FreePart("the middle", Rects.of([((x, y), size, 0.0, 0.0, HEAD_HEIGHT)])),)
    if place == "corner":
        return tuple(FreePart(f"the {c.name}", Rects.of([_corner(c.centre, c.yaw)])) for c in corners(room))
    if place in ("door", "window"):
        rows = [_opening(room, n) for n, o in enumerate(room.openings) if o.kind == place]
        return (FreePart(f"before each {place}", Rects.of(rows)),) if rows else ()
    named = walls(room, place)
    if place in ANY_WALL:
        return tuple(FreePart(wall.name, Rects.of([_strip(room, wall)])) for wall in named)
    return (FreePart(place, Rects.of([_strip(room, wall) for wall in named])),) if named else ()


def takers(scene: Arrangement, part: FreePart, *, besides: frozenset[str] = frozenset()) -> tuple[str, ...]:
    """Ids of what stands or hangs in a part of the room; what is only walked on does not count, nor `besides`."""
    solid = tuple(p for p in scene.placements if scene.asset_of(p).collides and p.id not in besides)
    if not solid:
        return ()
    depth = overlap_depth(Rects.of_placements(solid), part.boxes).max(-1, initial=0.0)
    return tuple(p.id for p, deep in zip(solid, np.asarray(depth), strict=True) if deep > TOUCH)


def measure_free(scene: Arrangement, place: str, *, besides: frozenset[str] = frozenset()) -> tuple[bool, str]:
    """Whether a part of the room is free, and what was found; `besides` may stand there."""
    found = [(part.name, takers(scene, part, besides=besides)) for part in parts(scene.room, place)]
    if not found:
        return True, f"the room has no {place.replace('_', ' ')}"
    name, ids = min(found, key=lambda pair: len(pair[1]))
    return not ids, f"{name.replace('_', ' ')}: {', '.join(ids)}" if ids else f"nothing in {name.replace('_', ' ')}"


def _strip(room: Room, wall: Wall) -> _Row:
    middle = wall.point(wall.length / 2, AGAINST_WALL / 2)
    return (middle, (AGAINST_WALL, wall.length), wall.yaw, 0.0, room.height)


def _corner(at: Vec2, yaw: float) -> _Row:
    turn = np.radians(yaw)
    reach = CORNER / 2 * np.sqrt(2.0)
    centre = (at[0] + reach * float(np.cos(turn)), at[1] + reach * float(np.sin(turn)))
    return (centre, (CORNER, CORNER), yaw - 45.0, 0.0, HEAD_HEIGHT)


def _opening(room: Room, number: int) -> _Row:
    opening = room.openings[number]
    wall = room.walls[opening.wall]
    depth = opening.width if opening.kind == "door" else WINDOW_ZONE
    centre = wall.point(opening.offset + opening.width / 2, depth / 2)
    return (centre, (depth, opening.width), wall.yaw, opening.sill, opening.sill + opening.height)
