"""What a relation can refer to, as one kind of thing: objects, and walls, corners, openings, the middle of a room."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from shapely import LineString, Point, Polygon, union_all
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.value import Vec2

WINDOW_ZONE = 0.5
"""Depth of the floor that belongs to a window [m]; SceneEval's OpeningClearance. A door's is as deep as it is wide."""
_SAME_LENGTH = 0.01
_MOSTLY_TOP = 0.4
"""Least share of its footprint that the tops of a thing take, for nothing else of it to be over anything."""


@dataclass(frozen=True)
class Landmark:
    """Something with a place and a frame.

    Attributes:
        kind: what it is; objects carry their own front, a wall and an opening face into the room.
        footprint: the floor it takes or, for an opening, needs [m].
        centre: origin of its frame [m].
        yaw: direction of its front [degrees].
        half: half its extents along its front and across [m].
        base, top: its lowest and highest points [m].
        front: how many ways round look the same, as for an asset.
        carries: heights at which it can carry something [m].
        holds: those of its heights at which something is inside it [m].
        solid: whether it can be touched; a rug cannot.
        hung: fixed to a wall or the ceiling.
        gaze: where one looks who uses it [degrees]: its yaw, or the other way, as its asset says.
        roof: what of its footprint is under its tops, where these are several; None for all of it.
    """

    name: str
    kind: Literal["object", "wall", "opening", "corner", "centre", "floor", "ceiling"]
    footprint: BaseGeometry
    centre: Vec2
    yaw: float = 0.0
    half: Vec2 = (0.0, 0.0)
    base: float = 0.0
    top: float = 0.0
    front: Literal["one", "two", "any"] = "one"
    carries: tuple[float, ...] = ()
    holds: tuple[float, ...] = ()
    solid: bool = True
    hung: bool = False
    gaze: float = 0.0
    roof: BaseGeometry | None = None

    @property
    def heading(self) -> Vec2:
        """Unit vector its front faces."""
        return (math.cos(math.radians(self.yaw)), math.sin(math.radians(self.yaw)))

    def to_local(self, point: Vec2) -> Vec2:
        """A point of the room in its frame, x to its front and y to its left [m]."""
        (fx, fy), dx, dy = self.heading, point[0] - self.centre[0], point[1] - self.centre[1]
        return (dx * fx + dy * fy, dy * fx - dx * fy)

    def edge(self, direction: Vec2) -> LineString:
        """The side of its bounding rectangle in a local `direction` of length 1; (-1, 0) is its back."""
        (hx, hy), (dx, dy) = self.half, direction
        ends = (
            [(dx * hx - dy * hy * s, dy * hy + dx * hy * s) for s in (-1, 1)]
            if dx
            else [(hx * s, dy * hy) for s in (-1, 1)]
        )
        return LineString([self._to_room(end) for end in ends])

    def _to_room(self, local: Vec2) -> Vec2:
        (fx, fy), (x, y) = self.heading, local
        return (self.centre[0] + fx * x - fy * y, self.centre[1] + fy * x + fx * y)


def things(scene: Arrangement, name: str) -> tuple[Landmark, ...]:
    """Everything in the scene that `name` can mean: one object by its id, or the parts of the room of that Place.

    A wall's own name ("north_wall_2") and an opening's id ("window_1") are understood too. Empty when there is none.
    """
    if name in scene:
        return (_object(scene, scene[name]),)
    if name == "corner":
        return corners(scene.room)
    if name == "centre":
        return (_middle(scene.room),)
    if name == "floor":
        return (_floor(scene.room),)
    if name == "ceiling":
        return (_ceiling(scene.room),)
    openings = [o for o in scene.room.openings if name in (o.kind, o.id)]
    if openings:
        return tuple(_opening(scene.room, o) for o in openings)
    return tuple(_wall(scene.room, wall) for wall in walls(scene.room, name))


def walls(room: Room, place: str) -> tuple[Wall, ...]:
    """The walls that a Place names; "north_wall" is every wall on that side; empty for what is not a wall.

    A long wall is at least as long as the room's mean wall, a short one at most; in a square all are both.
    "one_wall" and "opposite_wall" can be any: a plan says which are meant.
    """
    mean = sum(wall.length for wall in room.walls) / len(room.walls)
    if place in ("wall", "one_wall", "opposite_wall"):
        return room.walls
    if place == "long_wall":
        return tuple(wall for wall in room.walls if wall.length >= mean - _SAME_LENGTH)
    if place == "short_wall":
        return tuple(wall for wall in room.walls if wall.length <= mean + _SAME_LENGTH)
    return tuple(wall for wall in room.walls if wall.name == place or wall.name.rpartition("_")[0] == place)


def corners(room: Room, places: Sequence[str] = ()) -> tuple[Landmark, ...]:
    """The corners that something can stand in: those with an interior angle under 180 degrees, facing into the room.

    With `places`, only those where each of them is one of the two walls: ("north_wall", "east_wall") is one corner of a
    rectangle, ("north_wall",) are two.
    """
    found = []
    wanted = [walls(room, place) for place in places if place != "corner"]
    for before, wall in zip(room.walls[-1:] + room.walls[:-1], room.walls, strict=True):
        if not all(before in sides or wall in sides for sides in wanted):
            continue
        (ax, ay), (bx, by) = before.along, wall.along
        if ax * by - ay * bx > 1e-6:
            nx, ny = before.inward[0] + wall.inward[0], before.inward[1] + wall.inward[1]
            yaw = math.degrees(math.atan2(ny, nx))
            name = f"corner of {before.name} and {wall.name}"
            found.append(Landmark(name, "corner", Point(wall.start), wall.start, yaw=yaw, top=room.height))
    return tuple(found)


def _object(scene: Arrangement, placement: Placement) -> Landmark:
    asset, (x, y, z) = scene.asset_of(placement), placement.position
    return Landmark(
        name=placement.id,
        kind="object",
        footprint=placement.footprint,
        centre=(x, y),
        yaw=placement.yaw,
        half=(placement.size[0] / 2, placement.size[1] / 2),
        base=z,
        top=placement.top,
        front=asset.front,
        hung=asset.mount in ("wall", "ceiling"),
        gaze=placement.yaw + (180.0 if asset.gaze == "back" else 0.0),
        carries=tuple(z + surface.position[2] for surface in asset.surfaces if not surface.within),
        holds=tuple(z + surface.position[2] for surface in asset.surfaces if surface.inner),
        solid=asset.collides,
        roof=_roof(placement, asset.surfaces),
    )


def _roof(placement: Placement, surfaces: Sequence[Surface]) -> BaseGeometry | None:
    """The tops of what has several at one height, as a desk round a corner has, where they are most of it."""
    height = max((s.position[2] for s in surfaces if not s.inner), default=0.0)
    tops = [s for s in surfaces if not s.inner and height - s.position[2] <= _SAME_LENGTH]
    if len(tops) < 2:
        return None
    roof = union_all([Polygon([placement.to_room(corner) for corner in _corners_of(top)]) for top in tops])
    return roof if roof.area >= _MOSTLY_TOP * placement.footprint.area else None


def _corners_of(top: Surface) -> tuple[Vec2, ...]:
    (x, y, _), (a, b) = top.position, (top.size[0] / 2, top.size[1] / 2)
    return (x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)


def _wall(room: Room, wall: Wall) -> Landmark:
    yaw = math.degrees(math.atan2(wall.inward[1], wall.inward[0]))
    return Landmark(
        name=wall.name,
        kind="wall",
        footprint=LineString([wall.start, wall.end]),
        centre=wall.point(wall.length / 2),
        yaw=yaw,
        gaze=yaw,
        half=(0.0, wall.length / 2),
        top=room.height,
    )


def _opening(room: Room, opening: Opening) -> Landmark:
    wall = room.walls[opening.wall]
    depth = opening.width if opening.kind == "door" else WINDOW_ZONE
    start, end = opening.offset, opening.offset + opening.width
    yaw = math.degrees(math.atan2(wall.inward[1], wall.inward[0]))
    zone = Polygon([wall.point(start), wall.point(end), wall.point(end, depth), wall.point(start, depth)])
    return Landmark(
        name=opening.id,
        kind="opening",
        footprint=zone,
        centre=wall.point((start + end) / 2),
        yaw=yaw,
        gaze=yaw,
        half=(0.0, opening.width / 2),
        base=opening.sill,
        top=opening.sill + opening.height,
    )


def _floor(room: Room) -> Landmark:
    x, y = room.polygon.centroid.coords[0]
    half = (room.extent[0] / 2, room.extent[1] / 2)
    return Landmark("the floor", "floor", room.polygon, (x, y), half=half, front="any", carries=(0.0,))


def _ceiling(room: Room) -> Landmark:
    floor = _floor(room)
    return replace(floor, name="the ceiling", kind="ceiling", base=room.height, top=room.height, carries=())


def _middle(room: Room) -> Landmark:
    centre = room.polygon.centroid
    half = (room.extent[0] / 2, room.extent[1] / 2)
    return Landmark("the room's centre", "centre", centre, (centre.x, centre.y), half=half, front="any")
