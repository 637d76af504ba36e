"""Circulation: ways through the room, from its doors to all that stands in it."""

import shapely
from shapely import Point
from shapely.geometry.base import BaseGeometry

from thinkblox.knowledge.uses import MAIN_WAY, SIDE_WAY
from thinkblox.scoring.rating import Rating
from thinkblox.scoring.standing import Standing

REACH = 0.25
"""How far beyond the edge of a way something is still come to [m]."""
BY_SIDE_WAY = 0.7
"""Weight of what a way of 0.6 m leads to; the rest is that of a way of 0.9 m."""


def circulation(standing: Standing) -> Rating:
    """To how much of what stands on the floor ways lead from a door, and how much of the free floor they reach.

    Merrell et al. 2011, circulation: the free floor, shrunk by half the width of a way, should hang together. Here
    the share of large things and of free floor that the doors' part of it reaches, meaned; for ways of 0.6 m (Neufert,
    a side way) by BY_SIDE_WAY, and of 0.9 m (the main way) for the rest. Without a door the largest part is taken.
    """
    if not standing.large:
        return Rating(None, {"things": 0.0})
    side, cut_off, floor = _reached(standing, SIDE_WAY)
    main, _, _ = _reached(standing, MAIN_WAY)
    score = BY_SIDE_WAY * (side + floor) / 2 + (1.0 - BY_SIDE_WAY) * main
    worst = f"no way {SIDE_WAY:g} m wide leads to {', '.join(cut_off)}" if cut_off else ""
    numbers = {"things": len(standing.large), "by_side_way": side, "by_main_way": main, "floor_reached": floor}
    return Rating(score, numbers, worst)


def _reached(standing: Standing, width: float) -> tuple[float, list[str], float]:
    """Share of the large things that a way of some width leads to, those it does not, and the share of free floor."""
    feet = {thing.id: thing.placement.footprint for thing in standing.large}
    taken = shapely.union_all(shapely.buffer(list(feet.values()), width / 2, quad_segs=4))
    free = standing.room.polygon.buffer(-width / 2, join_style="mitre").difference(taken)
    parts = [part for part in getattr(free, "geoms", [free]) if part.area > 0.0]
    ways = _at_doors(standing, parts, width)
    if ways is None:
        return 0.0, list(feet), 0.0
    away = shapely.distance(list(feet.values()), ways)
    cut_off = [id for id, distance in zip(feet, away, strict=True) if distance > width / 2 + REACH]
    return 1.0 - len(cut_off) / len(feet), cut_off, ways.area / sum(part.area for part in parts)


def _at_doors(standing: Standing, parts: list[BaseGeometry], width: float) -> BaseGeometry | None:
    """The parts of the free floor that the doors open onto; of a room without doors, the largest part."""
    if not parts:
        return None
    walls = standing.room.walls
    doors = [
        Point(walls[o.wall].point(o.offset + o.width / 2, width / 2))
        for o in standing.room.openings
        if o.kind == "door"
    ]
    if not doors:
        return max(parts, key=lambda part: part.area)
    near = [part for part in parts if min(part.distance(door) for door in doors) < width / 2 + REACH]
    return shapely.union_all(near) if near else None
