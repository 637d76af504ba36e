"""Stretches of floor that are to be free: parts of the room, and what lies before, beside, around or between things."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from shapely import MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Free, Goal, OutOf
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.wheres import bound, opening_named
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.free_parts import HEAD_HEIGHT, measure_free, parts, takers
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene

PASSAGE = 0.9
"""How wide a way is that somebody goes [m], and how much floor lies before a thing that is used."""
AROUND = 0.6
"""How far the space around a thing reaches [m]."""
TAKEN = 0.002
"""Floor that something may take of it without counting [m2]."""
_SIDES = {"in_front_of": (1, 0), "behind": (-1, 0), "left_of": (0, 1), "right_of": (0, -1)}
_BEFORE = ("in_front_of", "by", "at", "near", "next_to", "around", "under", "to", "on", "in", "along", "against")


class Zone(Protocol):
    """A stretch of floor that is to be free."""

    @property
    def goal(self) -> Goal:
        """What every single thing has to meet for that."""
        ...

    def takers(self, scene: Scene) -> list[str]:
        """What stands or hangs in it, each by what it rests on."""
        ...

    def measure(self, scene: Scene) -> tuple[bool, str]:
        """Whether it is free, and what was found."""
        ...


@dataclass(frozen=True)
class PlaceZone:
    """A part of the room, as plans know it."""

    place: str

    @property
    def goal(self) -> Goal:
        """Nothing in it."""
        return Free(self.place)

    def takers(self, scene: Scene) -> list[str]:
        """Of several such parts the emptiest counts."""
        found = [takers(scene, part) for part in parts(scene.room, self.place)]
        return _roots(scene, min(found, key=len, default=()))

    def measure(self, scene: Scene) -> tuple[bool, str]:
        """As the report measures it."""
        return measure_free(scene, self.place)


@dataclass(frozen=True)
class Area:
    """A stretch of floor by its outline [m]; what it lies at is not in its way."""

    outline: Polygon
    name: str
    besides: frozenset[str]

    @property
    def goal(self) -> Goal:
        """Outside its outline."""
        return OutOf(self.outline, self.name)

    def takers(self, scene: Scene) -> list[str]:
        """What takes any of it."""
        solid = [p for p in scene.placements if scene.asset_of(p).collides and p.position[2] < HEAD_HEIGHT]
        solid = [p for p in solid if self.besides or scene.asset_of(p).mount != "wall"]
        found = [p.id for p in solid if p.footprint.intersection(self.outline).area > TAKEN]
        there = [id for id in self.besides if id in scene]
        mine = {*there, *(rider.id for id in there for rider in scene.riders(id))}
        mine |= {carrier for id in there for carrier in scene.carriers(id)}
        return [id for id in _roots(scene, found) if id not in mine]

    def measure(self, scene: Scene) -> tuple[bool, str]:
        """By footprints."""
        found = self.takers(scene)
        return not found, f"{', '.join(found) or 'nothing'} in {self.name}"


def _roots(scene: Scene, found: Sequence[str]) -> list[str]:
    return list(dict.fromkeys((scene.carriers(id) or (id,))[-1] for id in found))


def zones_of(scene: Scene, finder: Finder, where: Where, depth: float | None = None) -> list[Zone]:
    """The stretches of floor that a place names: one before each window that is meant, of all else one.

    Raises:
        InputError: it names none.
    """
    noun = where.noun
    window = noun is not None and noun.kind == "place" and noun.value == "window" and where.word in _BEFORE
    if not window or noun is None or where.whole is not None or where.second is not None:
        return [zone_of(scene, finder, where, depth)]
    named = [mark.name for mark in things(scene, opening_named(scene, noun))]
    if not named:
        raise InputError("the room has no window")
    zones: list[Zone] = []
    for opening in (o for o in scene.room.openings if o.id in named):
        wall, ends = scene.room.walls[opening.wall], (opening.offset, opening.offset + opening.width)
        near, far = ([wall.point(end, depth) for end in ends] for depth in (0.0, depth or AROUND))
        zones.append(Area(_in_room(scene, Polygon([*near, *far[::-1]])), f"the space before {opening.id}", frozenset()))
    return zones


def zone_of(scene: Scene, finder: Finder, where: Where, depth: float | None = None) -> Zone:
    """The stretch of floor that a place names: "(the space) in front of the window", "around the table".

    Raises:
        InputError: it names none.
    """
    noun = where.noun
    if noun is None:
        raise InputError(f"'{where.text}' does not say where")
    if noun.kind == "place" and (where.whole is not None or where.second is not None):
        return _corner_zone(scene, finder, where)
    if noun.kind in ("place", "part"):
        if where.word not in _BEFORE:
            raise InputError(f"'{where.text} {noun.text}' is no part of the room that could be kept free")
        if depth is not None:
            raise InputError(f"'{where.text} {noun.text}': how far is followed of windows and things alone")
        return PlaceZone(place_named(noun))
    ids = finder.ids(NounPhrase(noun))
    if len(ids) != 1:
        raise InputError(f"'{noun.text}' is {', '.join(ids)}; say of which one")
    thing = scene[ids[0]]
    side = _SIDES.get(where.word)
    if where.word == "next_to":
        side = None
    elif side is None and where.word not in ("around", "near", "by"):
        raise InputError(f"'{where.text} {noun.text}' is no stretch of floor that could be kept free")
    name = f"the space {where.text} {thing.id}"
    if side is None:
        ring = thing.footprint.buffer(depth or AROUND, join_style="mitre").difference(thing.footprint)
        return Area(_in_room(scene, ring), name, frozenset(ids))
    return Area(_in_room(scene, _beside(thing, side, depth or PASSAGE)), name, frozenset(ids))


def _corner_zone(scene: Scene, finder: Finder, where: Where) -> Area:
    """The floor of one corner: "the corner by the door"."""
    walls = bound(where, "", finder).anchors
    found = [part for part in parts(scene.room, "corner") if part.name == f"the corner of {walls[0]} and {walls[-1]}"]
    if len(walls) != 2 or not found:
        raise InputError(f"'{where.text} {where.noun.text if where.noun else ''}' is no corner that could be kept free")
    return Area(Polygon(found[0].boxes.corners[0]), found[0].name, frozenset())


def place_named(noun: Noun) -> str:
    """The part of the room that a noun names.

    Raises:
        InputError: it names none.
    """
    name = noun.value.split()[0] if noun.kind == "place" else ""
    if noun.kind == "part" and noun.value == "middle":
        return "centre"
    if not name:
        raise InputError(f"'{noun.text}' is no part of the room that could be kept free")
    return name


def between(scene: Scene, one: str, other: str) -> Area:
    """What lies between two things, or a thing and a part of the room."""
    first = things(scene, one)[0]
    second = min(things(scene, other), key=lambda mark: mark.footprint.distance(first.footprint))
    hull = MultiPoint([*_corners(first.footprint), *_corners(second.footprint)]).convex_hull
    strip = hull.difference(first.footprint.buffer(0.01)).difference(second.footprint.buffer(0.01))
    return Area(_in_room(scene, strip), f"the space between {one} and {other}", frozenset({one, other}))


def _corners(shape: BaseGeometry) -> list[tuple[float, float]]:
    outline = shape.exterior if isinstance(shape, Polygon) else shape
    return [(float(x), float(y)) for x, y in outline.coords]


def _beside(thing: Placement, side: tuple[int, int], depth: float) -> Polygon:
    """The stretch before one side of a thing, as wide as that side."""
    half_x, half_y = thing.size[0] / 2, thing.size[1] / 2
    ahead, across = side
    near, far = (half_x, half_x + depth) if ahead else (half_y, half_y + depth)
    ends = [(near, -1), (far, -1), (far, 1), (near, 1)]
    corners = [(ahead * out, half_y * end) if ahead else (half_x * end, across * out) for out, end in ends]
    return Polygon([thing.to_room(corner) for corner in corners])


def _in_room(scene: Scene, shape: BaseGeometry) -> Polygon:
    inside = shape.intersection(scene.room.polygon)
    if isinstance(inside, Polygon):
        return inside
    hull = inside.convex_hull
    return hull if isinstance(hull, Polygon) else Polygon()
