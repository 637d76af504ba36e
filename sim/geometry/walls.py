"""The walls of a room as boxes outside its floor, with the doors and windows left open."""

import itertools
import math
from collections.abc import Iterator
from functools import lru_cache

import shapely

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.value import Value, Vec3

THINNEST = 0.005
"""Below this a slab between two parts of one floor is left out [m]."""


class Slab(Value, kw_only=True, frozen=True):
    """One box of a wall: centre [m], full size along the wall, across and up [m], yaw of its length [degrees]."""

    name: str
    position: Vec3
    size: Vec3
    yaw: float


@lru_cache(maxsize=64)
def wall_slabs(room: Room, thickness: float) -> tuple[Slab, ...]:
    """Boxes just outside the floor polygon, `thickness` [m] or as thick as a narrow part of the floor plan leaves."""
    return tuple(slab for i, wall in enumerate(room.walls) for slab in _slabs(room, i, wall, thickness))


def _slabs(room: Room, index: int, wall: Wall, thickness: float) -> Iterator[Slab]:
    depth = wall_depth(room, wall, thickness)
    if not depth:
        return
    openings = sorted((o for o in room.openings if o.wall == index), key=lambda o: o.offset)
    for number, (start, end, low, high) in enumerate(_pieces(room, wall, openings)):
        x, y = wall.point((start + end) / 2, -depth / 2)
        yield Slab(
            name=wall.name if number == 0 else f"{wall.name}/{number}",
            position=(x, y, (low + high) / 2),
            size=(end - start, depth, high - low),
            yaw=math.degrees(math.atan2(wall.along[1], wall.along[0])),
        )


def _pieces(room: Room, wall: Wall, openings: list[Opening]) -> Iterator[tuple[float, float, float, float]]:
    """(start, end, low, high) of each solid rectangle of a wall."""
    cuts = sorted({0.0, wall.length, *(min(e, wall.length) for o in openings for e in (o.offset, o.offset + o.width))})
    for start, end in itertools.pairwise(cuts):
        middle = (start + end) / 2
        holes = sorted((o.sill, o.sill + o.height) for o in openings if o.offset < middle < o.offset + o.width)
        low = 0.0
        for sill, lintel in [*holes, (room.height, room.height)]:
            if sill - low > 1e-6 and end - start > 1e-6:
                yield (start, end, low, sill)
            low = max(low, lintel)


def wall_depth(room: Room, wall: Wall, thickness: float) -> float:
    """The thickness that fits before the floor begins again behind the wall [m]; 0 where hardly any does."""
    depth = thickness
    while depth >= THINNEST:
        slab = shapely.Polygon([wall.start, wall.point(0.0, -depth), wall.point(wall.length, -depth), wall.end])
        if shapely.area(shapely.intersection(slab, room.polygon)) < 1e-9:
            return depth
        depth /= 2
    return 0.0
