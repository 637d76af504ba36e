"""A room: floor polygon, height, and the doors and windows in its walls. Metres, z up, y north, x east."""

import math
from functools import lru_cache
from itertools import combinations
from typing import Annotated, Literal

from msgspec import Meta
from shapely import Polygon
from shapely.validation import explain_validity

from thinkblox.checked import CheckedValue, Coordinate
from thinkblox.errors import InputError
from thinkblox.scene.surfaces import Surfaces
from thinkblox.value import Value, Vec2

MIN_EXTENT = 0.5
"""Smallest side of a room's bounding box that is accepted [m]."""
MAX_EXTENT = 100.0
MAX_HEIGHT = 50.0
"""Largest side of a room's bounding box that is accepted [m]."""
MAX_CORNERS = 200
"""Most corners of a floor."""
MAX_OPENINGS = 200
"""Most doors and windows of a room."""
_COMPASS = ("east", "north_east", "north", "north_west", "west", "south_west", "south", "south_east")

Upward = Annotated[float, Meta(ge=0.0, le=1000.0)]
Width = Annotated[float, Meta(gt=0.0, le=1000.0)]


STEP_IN = 0.45
"""Depth of the floor that stays free inside a door which opens to the outside [m]."""


class Opening(CheckedValue, frozen=True, kw_only=True):
    """A door or window in a wall.

    Attributes:
        id: "door_1", "window_1".
        wall: index of the wall; wall i runs from floor[i] to floor[i + 1].
        offset: from the wall's start to the near edge of the opening, along the wall [m].
        sill: height of its lower edge above the floor [m]; 0 for a door.
        hinge: which end of the opening a door turns about, seen along the wall from its start.
        opens: whether a door turns into the room or, as those of closets do, out of it.
    """

    id: Annotated[str, Meta(pattern=r"^[a-z][a-z0-9_]*\Z", max_length=80)]
    kind: Literal["door", "window"]
    wall: Annotated[int, Meta(ge=0, le=1000)]
    offset: Upward
    width: Width
    height: Width
    sill: Upward = 0.0
    hinge: Literal["start", "end"] = "start"
    opens: Literal["in", "out"] = "in"

    @property
    def swept(self) -> float:
        """How deep the floor inside a door stays free for its leaf, or for who steps in [m]."""
        return self.width if self.opens == "in" else min(self.width, STEP_IN)


class Wall(Value, frozen=True, kw_only=True):
    """One side of the room, seen from inside.

    Attributes:
        name: by the compass direction it bounds: "north_wall", or "north_wall_2" for the second one counter-clockwise.
        start, end: its ends, counter-clockwise round the floor [m].
        inward: unit normal that points into the room.
    """

    name: str
    start: Vec2
    end: Vec2
    inward: Vec2

    @property
    def length(self) -> float:
        """Length [m]."""
        return math.dist(self.start, self.end)

    @property
    def along(self) -> Vec2:
        """Unit vector from start to end."""
        return ((self.end[0] - self.start[0]) / self.length, (self.end[1] - self.start[1]) / self.length)

    @property
    def yaw(self) -> float:
        """Yaw of an object with its back to this wall [degrees, 0 to 360)."""
        return round(math.degrees(math.atan2(self.inward[1], self.inward[0])) % 360.0, 3) % 360.0

    def is_faced(self, yaw: float) -> bool:
        """Whether a front of that yaw [degrees] points into the wall: less than 60 degrees from straight at it."""
        return turn_between(yaw, self.yaw) > 120.0

    def point(self, along: float, inward: float = 0.0) -> Vec2:
        """The point `along` metres from the start and `inward` metres into the room."""
        (ax, ay), (nx, ny) = self.along, self.inward
        return (self.start[0] + ax * along + nx * inward, self.start[1] + ay * along + ny * inward)

    def coordinates(self, point: Vec2) -> Vec2:
        """(along, inward) of a point [m]: the inverse of `point`."""
        dx, dy = point[0] - self.start[0], point[1] - self.start[1]
        (ax, ay), (nx, ny) = self.along, self.inward
        return (dx * ax + dy * ay, dx * nx + dy * ny)


class Room(CheckedValue, frozen=True, kw_only=True, cache_hash=True):
    """Floor polygon (simple, counter-clockwise, its bounding box starting at the origin), height [m] and openings.

    `surfaces` says what it is finished with; None leaves that open.

    Raises:
        InputError: fewer than three corners, crossing or coinciding edges, clockwise order, an extent outside
            MIN_EXTENT to MAX_EXTENT, a height out of range, an opening that its wall cannot hold or that is called as a
            part of the room is, two openings that overlap or share an id, or an accent on a wall that does not exist.
    """

    floor: tuple[tuple[Coordinate, Coordinate], ...]
    height: Annotated[float, Meta(ge=1.5, le=MAX_HEIGHT)] = 2.6
    openings: tuple[Opening, ...] = ()
    surfaces: Surfaces | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_floor(self.floor)
        if len(self.openings) > MAX_OPENINGS:
            raise InputError(f"room.openings has {len(self.openings)} entries; at most {MAX_OPENINGS} are read")
        taken = {"floor", "ceiling"} | {wall.name for wall in self.walls}
        for opening in self.openings:
            if opening.id in taken:
                raise InputError(f"an opening is called {opening.id!r}, which is the name of a part of the room")
            _check_opening(self, opening)
        _check_apart(self.openings)
        accent = None if self.surfaces is None else self.surfaces.accent_wall
        if accent is not None and accent >= len(self.floor):
            raise InputError(f"room.surfaces.accent_wall is {accent}; walls are 0 to {len(self.floor) - 1}")

    @property
    def polygon(self) -> Polygon:
        """The floor as a polygon."""
        return _polygon(self.floor)

    @property
    def extent(self) -> Vec2:
        """Size of the floor's bounding box along x and y [m]."""
        x0, y0, x1, y1 = self.polygon.bounds
        return (x1 - x0, y1 - y0)

    @property
    def walls(self) -> tuple[Wall, ...]:
        """The walls, counter-clockwise; wall i starts at floor[i]."""
        return _walls(self.floor)

    def wall(self, name: str) -> Wall:
        """The wall called `name`; raises KeyError that lists the names that exist."""
        for wall in self.walls:
            if wall.name == name:
                return wall
        raise KeyError(f"no wall {name!r}; there are {', '.join(w.name for w in self.walls)}")


@lru_cache(maxsize=64)
def _polygon(floor: tuple[Vec2, ...]) -> Polygon:
    return Polygon(floor)


@lru_cache(maxsize=64)
def _walls(floor: tuple[Vec2, ...]) -> tuple[Wall, ...]:
    walls: list[Wall] = []
    counts: dict[str, int] = {}
    for start, end in zip(floor, floor[1:] + floor[:1], strict=True):
        length = math.dist(start, end)
        inward = ((start[1] - end[1]) / length, (end[0] - start[0]) / length)
        outward_angle = math.degrees(math.atan2(-inward[1], -inward[0])) % 360.0
        side = _COMPASS[round(outward_angle / 45.0) % 8]
        counts[side] = counts.get(side, 0) + 1
        name = f"{side}_wall" if counts[side] == 1 else f"{side}_wall_{counts[side]}"
        walls.append(Wall(name=name, start=start, end=end, inward=inward))
    return tuple(walls)


def _check_floor(floor: tuple[Vec2, ...]) -> None:
    if len(floor) < 3:
        raise InputError(f"room.floor has {len(floor)} corners; a floor needs at least 3, counter-clockwise, in metres")
    if len(floor) > MAX_CORNERS:
        raise InputError(f"room.floor has {len(floor)} corners; at most {MAX_CORNERS} are read")
    if any(math.dist(a, b) < 0.01 for a, b in zip(floor, floor[1:] + floor[:1], strict=True)):
        raise InputError("room.floor has two corners in a row closer than 1 cm; remove one of them")
    polygon = _polygon(floor)
    if not polygon.is_valid:
        raise InputError(f"room.floor is not a simple polygon: {explain_validity(polygon)}")
    x0, y0, x1, y1 = polygon.bounds
    if min(x1 - x0, y1 - y0) < MIN_EXTENT or max(x1 - x0, y1 - y0) > MAX_EXTENT:
        raise InputError(
            f"room.floor measures {x1 - x0:g} m by {y1 - y0:g} m; each side must be {MIN_EXTENT:g} to {MAX_EXTENT:g} m"
        )
    if not polygon.exterior.is_ccw:
        raise InputError("room.floor runs clockwise; list its corners counter-clockwise, seen from above")


def _check_opening(room: Room, opening: Opening) -> None:
    if opening.wall >= len(room.floor):
        raise InputError(
            f"opening {opening.id}: wall {opening.wall} does not exist; walls are 0 to {len(room.floor) - 1}"
        )
    length = room.walls[opening.wall].length
    if opening.offset + opening.width > length + 1e-6:
        raise InputError(
            f"opening {opening.id}: {opening.offset:g} m + {opening.width:g} m is past the end of its {length:g} m wall"
        )
    if opening.sill + opening.height > room.height + 1e-6:
        raise InputError(f"opening {opening.id}: its top is above the room's height of {room.height:g} m")


def _check_apart(openings: tuple[Opening, ...]) -> None:
    for first, second in combinations(openings, 2):
        if first.id == second.id:
            raise InputError(f"two openings are called {first.id!r}; ids must differ")
        if first.wall == second.wall and _overlap(first, second):
            raise InputError(f"openings {first.id} and {second.id} overlap in wall {first.wall}")


def _overlap(a: Opening, b: Opening) -> bool:
    across = min(a.offset + a.width, b.offset + b.width) - max(a.offset, b.offset)
    up = min(a.sill + a.height, b.sill + b.height) - max(a.sill, b.sill)
    return across > 1e-6 and up > 1e-6


def turn_between(a: float, b: float, *, period: float = 360.0) -> float:
    """Smallest turn between two yaws that repeat every `period` [degrees]."""
    turn = (a - b) % period
    return min(turn, period - turn)


def rectangle(width: float, depth: float, *, height: float = 2.6, openings: tuple[Opening, ...] = ()) -> Room:
    """A rectangular room, `width` along x and `depth` along y [m]; wall 0 is the south wall."""
    return Room(floor=((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)), height=height, openings=openings)
