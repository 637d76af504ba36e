"""The room as the judge sees it: walls, corners, doors and windows, and how far an object is from them."""

import math
from dataclasses import dataclass
from functools import cached_property

from shapely import LineString, Point, Polygon

from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.room_file import RoomRecord, Vec2

_STRAIGHT = 15.0
"""Two walls that meet at an angle nearer than this to a straight line make no corner [degrees]."""


@dataclass(frozen=True)
class WallLine:
    """A wall seen from above; `inward` points into the room."""

    line: LineString
    inward: Vec2

    @property
    def start(self) -> Vec2:
        """Where it begins, counter-clockwise round the floor [m]."""
        x, y = self.line.coords[0]
        return (x, y)

    def gap(self, body: Body) -> float:
        """How far the object's footprint is from the wall's face [m]."""
        return float(self.line.distance(body.footprint))

    def covers(self, body: Body) -> float:
        """The share of the object's extent along the wall that lies before the wall, 0 to 1."""
        (nx, ny), (sx, sy) = self.inward, self.start
        along = [(x - sx) * ny - (y - sy) * nx for x, y in body.footprint.exterior.coords]
        low, high = min(along), max(along)
        inside = min(high, self.line.length) - max(low, 0.0)
        return max(0.0, inside) / (high - low) if high > low else 0.0


class Enclosure:
    """A room's parts, made once for all objects in it."""

    def __init__(self, room: RoomRecord) -> None:
        self.height = room.height
        self.floor = Polygon(room.floor)
        self._room = room

    @cached_property
    def walls(self) -> tuple[WallLine, ...]:
        """One for each side of the floor."""
        return tuple(_wall(a, b) for a, b in self._sides)

    @cached_property
    def corners(self) -> tuple[tuple[WallLine, WallLine], ...]:
        """The pairs of walls that meet in a corner one can stand something into."""
        pairs = zip((self.walls[-1], *self.walls[:-1]), self.walls, strict=True)
        return tuple((a, b) for a, b in pairs if _turn(a, b) > _STRAIGHT)

    def openings(self, kind: str) -> tuple[LineString, ...]:
        """The doors or windows, seen from above."""
        found = [opening for opening in self._room.openings if opening.kind == kind]
        return tuple(
            LineString([line.interpolate(o.offset), line.interpolate(o.offset + o.width)])
            for o, line in ((o, self.walls[o.wall].line) for o in found)
        )

    def corner_points(self) -> tuple[Point, ...]:
        """Where the walls of each corner meet."""
        return tuple(Point(second.start) for _, second in self.corners)

    @property
    def _sides(self) -> list[tuple[Vec2, Vec2]]:
        floor = self._room.floor
        return list(zip(floor, (*floor[1:], floor[0]), strict=True))

    @property
    def diagonal(self) -> float:
        """The longest way across [m]."""
        x0, y0, x1, y1 = self.floor.bounds
        return math.hypot(x1 - x0, y1 - y0)


def _wall(start: Vec2, end: Vec2) -> WallLine:
    length = math.dist(start, end)
    return WallLine(LineString([start, end]), ((start[1] - end[1]) / length, (end[0] - start[0]) / length))


def _turn(a: WallLine, b: WallLine) -> float:
    """By how much the second wall turns to the left of the first [degrees]; right turns make no corner to stand in."""
    cross = a.inward[0] * b.inward[1] - a.inward[1] * b.inward[0]
    dot = a.inward[0] * b.inward[0] + a.inward[1] * b.inward[1]
    return math.degrees(math.atan2(cross, dot))
