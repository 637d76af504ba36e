"""Where the doors and windows of a room go."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from thinkblox.assets import facts_of, kind_of
from thinkblox.brief import Brief, Request
from thinkblox.knowledge.habits import Habit, load_habits
from thinkblox.knowledge.rooms import RoomType, room_type
from thinkblox.planning.space import rows_along_walls
from thinkblox.planning.walls import COMPASS, SIDES, speaks_of_sides, wall_meant
from thinkblox.scene.room import Opening, Room, Wall

DOOR = (0.9, 2.1)
"""Width and height of a door [m]."""
_WINDOW_HEIGHT, _SILL = 1.2, 0.9
_USUAL_HEIGHT = 2.6
"""Height of a room whose windows are as high as that [m]."""
_NARROWEST, _WIDEST = 1.0, 2.6
"""Widths of a window in a wall that has room for either [m]."""
_CORNER = 0.2
"""Least distance of an opening to a corner [m]."""
_FILLED_CORNER = 0.9
"""Least distance of an opening to a corner in which something will stand [m]."""
_CLOSET, _SHORT = 4.6, 2.0
"""Floor [m2] and shorter side [m] below which a room is entered by a narrow door that opens outwards."""
_LEAST_DOOR, _LEAST_WINDOW = 0.7, 0.4
"""An opening is made narrower, down to this, before it is left out [m]."""
_LEAF = 1.2
"""A door that is wider than this does not turn into the room [m]."""
_DOORS_APART = 3.0
"""Doors that are further apart do not get in each other's way [m]."""
_MANY_WINDOWS, _MAYBE_TWO = 30.0, 14.0
"""Floor from which a room has two windows, and from which it may, where the prompt does not say [m2]."""
_TWICE = 0.35
"""How often it does."""
_ROW = 3
"""So many seats before what hangs on a wall need a whole one."""
_SHIFTS = (0.0, 0.0, -0.2, 0.2)
"""How far a window is off the middle of its stretch of wall, as a share of what that leaves free."""
_CABIN, _LONG = 6.0, 1.5
"""Floor below which a window leaves room for what is long and high, and from what length that is so [m2, m]."""
_BY_WINDOWS = ("next_to", "near", "left_of", "right_of")
_VARIED, _ASIDE = 1.06, 0.15
"""How much wider than usual a thing may come out, and how far it is from the opening and the corner together [m]."""


def with_openings(room: Room, brief: Brief, rng: np.random.Generator) -> Room:
    """The room with the doors and windows that the brief asks for, and those that go without saying."""
    bunk = _beside_bunks(brief, room)
    planner = _Openings(
        room,
        rng,
        kind=room_type(brief.room_type),
        spared=_spared(brief, room) | _for_row(brief, room),
        corners={"door": max(_corner_distance(brief), _beside_doors(brief)), "window": _corner_distance(brief)},
        beside=_beside_windows(brief) or bunk,
        bunks=bunk > 0.0,
    )
    for wanted in _wanted(brief, room, rng):
        planner.add(wanted)
    return Room(floor=room.floor, height=room.height, openings=tuple(planner.openings))


def opening_notes(brief: Brief, room: Room) -> Iterator[str]:
    """A sentence for every kind of opening that the brief asks for and the room has too few of."""
    for wanted in openings_wanted(brief, room):
        if wanted.there < wanted.number:
            plural = "s" * (wanted.number > 1)
            yield f"{wanted.number - wanted.there} of {wanted.number} {wanted.kind}{plural}{wanted.where} did not fit"


class OpeningCount(NamedTuple):
    """How many doors or windows a brief asks for, and how many there are; `where` is " in the east wall", or empty."""

    kind: str
    where: str
    number: int
    there: int


def openings_wanted(brief: Brief, room: Room) -> Iterator[OpeningCount]:
    """Every kind of opening that the brief asks for in one wall, or in any, and what the room has of it."""
    wanted: dict[tuple[str, str], int] = {}
    for request in brief.openings:
        key = (request.kind, wall_meant(request.wall, room))
        wanted[key] = wanted.get(key, 0) + request.count
    for (kind, wall), count in wanted.items():
        where = f" in the {wall.replace('_', ' ')}" if wall else ""
        yield OpeningCount(kind, where, count, _openings_there(room, kind, wall))


def _openings_there(room: Room, kind: str, wall: str) -> int:
    """How many doors or windows a room has; with the name of a wall, in the walls that it can mean."""
    named = set(_walls_named(room, wall)) if wall else None
    return sum(o.kind == kind and (named is None or o.wall in named) for o in room.openings)


def _walls_named(room: Room, name: str) -> list[int]:
    """Indices of the walls that a name can mean; all for one that means any."""
    meant = wall_meant(name, room)
    if meant in COMPASS:
        return [i for i, wall in enumerate(room.walls) if wall.name.startswith(meant)]
    if meant in ("long_wall", "short_wall"):
        return _by_length(room, meant)
    return list(range(len(room.walls)))


@dataclass(frozen=True, slots=True)
class _Wanted:
    """An opening to be: its kind, its wall ("" for any), and which of how many in that wall it is."""

    kind: str
    wall: str = ""
    index: int = 0
    count: int = 1


def _wanted(brief: Brief, room: Room, rng: np.random.Generator) -> list[_Wanted]:
    """The openings to be, doors first."""
    type_ = room_type(brief.room_type)
    asked = {kind: [r for r in brief.openings if r.kind == kind] for kind in ("door", "window")}
    wanted = [
        _Wanted(kind, r.wall, n, r.count if r.wall else 1)
        for kind in ("door", "window")
        for r in asked[kind]
        for n in range(r.count)
    ]
    if not any(opening.kind == "door" for opening in wanted):
        end = "short_wall" if type_.entered_at_end else ""
        wanted.insert(0, _Wanted("door", "near_wall" if speaks_of_sides(brief) else end))
    if not asked["window"]:
        named = any("window" in relation.anchors for relation in brief.relations)
        usual, panes = not type_.windowless, type_.panes
        twice = rng.uniform() < _TWICE and room.polygon.area > _MAYBE_TWO and not _hangs_above(brief)
        usually = 2 if twice or room.polygon.area > _MANY_WINDOWS else 1
        usually = 1 if _for_row(brief, room) else usually
        count = max(1, panes.count - _walls_needed(brief)) if panes and panes.count else usually
        if usual and type_.entered_at_end:
            wanted += _along_sides(brief, room, count)
        else:
            wanted += [_Wanted("window")] * (count if usual else int(named))
    return wanted


def _along_sides(brief: Brief, room: Room, count: int) -> list[_Wanted]:
    """So many windows, shared out over the long walls, or those aside of the door, at equal distances in each."""
    long = [room.walls[i].name for i in _by_length(room, "long_wall")]
    sides = ["right_wall", "left_wall"] if speaks_of_sides(brief) else long
    shares = {name: -(-(count - at) // len(sides)) for at, name in enumerate(sides)}
    return [_Wanted("window", name, index, share) for name, share in shares.items() for index in range(share)]


def _spared(brief: Brief, room: Room) -> frozenset[int]:
    """Walls that the prompt gives to something ("a screen on the short wall"), and so to nothing opposite either."""
    places = {anchor for relation in brief.relations if relation.asked for anchor in relation.anchors}
    named = [place for place in places if place in ("short_wall", "long_wall", *COMPASS, *SIDES)]
    return frozenset(i for place in named for i in _walls_named(room, place))


def _for_row(brief: Brief, room: Room) -> frozenset[int]:
    """The longest walls, where a row will stand along one, or seats before what hangs there: a mirror before each."""
    hung = {r.category: r.count for r in brief.requests if kind_of(r.category).mount == "wall"}
    seats = [r for r in brief.requests if r.count >= _ROW and facts_of(r.category).is_in("seating")]
    rows = (hung.get(a) == r.count for r in seats for h in load_habits().of(r.category) for a in _looked_into(h))
    return frozenset(_by_length(room, "long_wall")) if any(rows) or rows_along_walls(brief) else frozenset()


def _hangs_above(brief: Brief) -> bool:
    """Whether something is asked to hang over what stands: a wall with a window has no place for it."""
    mounts = {request.key: kind_of(request.category).mount for request in brief.requests}
    above = (r for r in brief.relations if r.asked and r.kind == "above" and mounts.get(r.subject) == "wall")
    return any(mounts.get(anchor) == "floor" for relation in above for anchor in relation.anchors)


def _looked_into(habit: Habit) -> tuple[str, ...]:
    return habit.anchors if habit.kind == "in_front_of" and not habit.company else ()


def _by_length(room: Room, place: str) -> list[int]:
    lengths = [wall.length for wall in room.walls]
    wanted = max(lengths) if place == "long_wall" else min(lengths)
    return [i for i, length in enumerate(lengths) if abs(length - wanted) < 0.05]


def _corner_distance(brief: Brief) -> float:
    """Doors keep away from corners that are to be filled."""
    filled = any(r.kind == "in_corner" and (r.each or r.spread > 1) for r in brief.relations)
    return _FILLED_CORNER if filled else _CORNER


def _beside_doors(brief: Brief) -> float:
    """Width of wall between a door and its corner for one of several that are asked to be next to a door [m].

    One alone has its place on the other side.
    """
    by = _asked_by(brief, "door", ("next_to",))
    return max(map(_width_of_wall, by)) if sum(request.count for request in by) > 1 else 0.0


def _walls_needed(brief: Brief) -> int:
    """One wall of a house of glass for what is asked to stand against one, or to hang there, and would darken it."""
    by = _asked_by(brief, "wall", ("against_wall", "on"))
    high = (kind_of(r.category).mount == "wall" or kind_of(r.category).size[2] > _SILL for r in by)
    return int(any(high))


def _beside_windows(brief: Brief) -> float:
    """Width of wall that the widest of what is asked to stand by a window needs there, where it would darken it [m]."""
    kinds = ((request, kind_of(request.category)) for request in _asked_by(brief, "window", _BY_WINDOWS))
    tall = [request for request, kind in kinds if kind.mount == "floor" and kind.size[2] > _SILL]
    return max(map(_width_of_wall, tall), default=0.0)


def _beside_bunks(brief: Brief, room: Room) -> float:
    """Width of wall between a corner and the window that a small room needs for what is long and high there [m]."""
    kinds = [kind_of(request.category) for request in brief.requests if request.asked]
    long = [k.size for k in kinds if k.mount == "floor" and k.size[2] > _SILL and max(k.size[:2]) > _LONG]
    return max((min(size[:2]) for size in long), default=0.0) * _VARIED if room.polygon.area < _CABIN else 0.0


def _asked_by(brief: Brief, place: str, kinds: tuple[str, ...]) -> list[Request]:
    """What is asked to be by a door or a window."""
    by = [r.subject for r in brief.relations if r.asked and place in r.anchors and r.kind in kinds]
    return [request for request in brief.requests if request.key in by]


def _width_of_wall(request: Request) -> float:
    """How much wall one of a request needs between an opening and a corner [m]."""
    return max(kind_of(request.category).size[:2]) * _VARIED + _ASIDE


class _Openings:
    """Takes openings one at a time and finds each a free stretch of wall."""

    def __init__(
        self,
        room: Room,
        rng: np.random.Generator,
        *,
        kind: RoomType,
        spared: frozenset[int],
        corners: Mapping[str, float],
        beside: float,
        bunks: bool,
    ) -> None:
        self.kind = kind
        self.room = room
        self.rng = rng
        self.spared = spared
        self.corners = corners
        self.beside = beside
        self.bunks = bunks
        self.openings: list[Opening] = []

    def add(self, wanted: _Wanted) -> None:
        """Put a door or window into the named wall, or into the best one that has space for it."""
        walls = self._walls(wanted.kind, wanted.wall)
        for share in (1.0, 0.75, 0.5):
            for index in walls:
                if (opening := self._fit(wanted, index, share)) is not None:
                    self.openings.append(opening)
                    return

    def _walls(self, kind: str, name: str) -> list[int]:
        """Indices of the walls to try, best first; of a named wall only those it can mean."""
        walls = self.room.walls
        if name and name != "wall":
            built = Room(floor=self.room.floor, height=self.room.height, openings=tuple(self.openings))
            return _walls_named(built, name)
        taken = {opening.wall for opening in self.openings}
        chance = self.rng.permutation(len(walls))
        order = sorted(
            range(len(walls)), key=lambda i: (i in self.spared, i in taken, _dislike(kind, walls[i]), chance[i])
        )
        if self.bunks:
            order.sort(key=lambda i: self._with_bunks(kind, i))
        return order

    def _with_bunks(self, kind: str, index: int) -> tuple[bool, float]:
        """A bunk takes a long wall, the door is in the other, and the window at the end of the room away from it."""
        is_short = index not in _by_length(self.room, "long_wall")
        apart = self._from_doors(index, self.room.walls[index].length / 2.0) if kind == "window" else 0.0
        return is_short == (kind == "door"), -apart

    def _fit(self, wanted: _Wanted, index: int, share: float) -> Opening | None:
        wall, kind = self.room.walls[index], wanted.kind
        closet = self._is_closet()
        door, high = (_LEAST_DOOR if closet else DOOR[0]), DOOR[1]
        if self.kind.entrance is not None and not self.openings:
            door, high = self.kind.entrance.width, self.kind.entrance.height
        usual = door if kind == "door" else self._window_width(wall.length / wanted.count)
        if kind == "window" and wanted.count == 1 and self.beside:
            usual = min(usual, wall.length - self.beside - _CORNER)
        width = round(max(_LEAST_DOOR if kind == "door" else _LEAST_WINDOW, share * usual), 2)
        number = sum(opening.kind == kind for opening in self.openings) + 1
        offset = self._offset(wanted, index, width)
        top = self.room.height - 0.1
        if offset is None:
            return None
        if kind == "door":
            hinge: Literal["start", "end"] = "start" if offset < wall.length / 2.0 else "end"
            return Opening(
                id=f"door_{number}",
                kind="door",
                wall=index,
                offset=offset,
                width=width,
                height=min(high, top),
                hinge=hinge,
                opens="out" if closet or width > _LEAF else "in",
            )
        sill, height = self._upright(top)
        return Opening(
            id=f"window_{number}",
            kind="window",
            wall=index,
            offset=offset,
            width=width,
            height=round(height, 3),
            sill=sill,
        )

    def _upright(self, top: float) -> tuple[float, float]:
        """Sill and height of a window that ends below `top` [m]."""
        panes = self.kind.panes
        sill = min(panes.sill if panes else _SILL, top - 0.5)
        if panes:
            return sill, max(0.5, min(self.room.height - panes.top, top) - sill)
        return sill, min(_WINDOW_HEIGHT * max(1.0, self.room.height / _USUAL_HEIGHT), top - sill)

    def _is_closet(self) -> bool:
        """Whether a door that opened inwards would take most of the floor."""
        sides = np.ptp(np.array(self.room.floor), axis=0)
        return bool(self.room.polygon.area < _CLOSET and sides.min() < _SHORT) if len(self.room.floor) == 4 else False

    def _window_width(self, space: float) -> float:
        """A third to a half of a wall, but neither a slit nor a shop front."""
        if self.kind.panes is not None:
            return round(max(_LEAST_WINDOW, min(self.kind.panes.width, 0.7 * space)), 2)
        usual = float(self.rng.uniform(0.33, 0.5)) * space
        return round(max(0.4, min(max(usual, _NARROWEST), _WIDEST, 0.5 * space)), 2)

    def _offset(self, wanted: _Wanted, index: int, width: float) -> float | None:
        """Near a corner for a door, in the middle of its share of the wall for a window [m]."""
        length = self.room.walls[index].length
        gaps = [(a, b) for a, b in self._gaps(wanted.kind, index, length) if b - a >= width]
        if not gaps:
            return None
        if wanted.kind == "window":
            share = length * (wanted.index + 0.5) / wanted.count
            start, end = max(gaps, key=lambda gap: (gap[0] <= share <= gap[1], gap[1] - gap[0]))
            free = end - start - width
            middle = share if wanted.count > 1 else (start + end) / 2.0 + free * float(self.rng.choice(_SHIFTS))
            if wanted.count == 1 and self.beside and self._has_door(index - 1):
                middle = min(middle, length - self.beside - width / 2.0)
            elif wanted.count == 1 and self.beside:
                middle = max(middle, self.beside + width / 2.0)
            return round(min(max(middle - width / 2.0, start), end - width), 3)
        if self.kind.entered_at_end:
            start, end = max(gaps, key=lambda gap: gap[1] - gap[0])
            return round((start + end - width) / 2.0, 3)
        corners = [gaps[0][0], gaps[-1][1] - width]
        usual = corners[int(self.rng.integers(2))]
        apart = {offset: self._from_doors(index, offset + width / 2) for offset in corners}
        best = max(corners, key=lambda offset: (apart[offset], offset == usual))
        return round(best, 3)

    def _has_door(self, index: int) -> bool:
        return any(o.kind == "door" and o.wall == index % len(self.room.walls) for o in self.openings)

    def _from_doors(self, index: int, along: float) -> float:
        """Distance of a point of a wall from the nearest door, as far as it matters for their swings [m]."""
        walls = self.room.walls
        doors = [walls[o.wall].point(o.offset + o.width / 2) for o in self.openings if o.kind == "door"]
        return min([_DOORS_APART, *(math.dist(walls[index].point(along), door) for door in doors)])

    def _gaps(self, kind: str, index: int, length: float) -> list[tuple[float, float]]:
        taken = sorted((o.offset, o.offset + o.width) for o in self.openings if o.wall == index)
        corner = min(self.corners[kind], max(_CORNER, (length - DOOR[0]) / 2.0))
        starts = [corner, *(end + _CORNER for _, end in taken)]
        ends = [*(start - _CORNER for start, _ in taken), length - corner]
        return [(start, end) for start, end in zip(starts, ends, strict=True) if end > start]


def _dislike(kind: str, wall: Wall) -> int:
    """The camera looks in from the south: windows are seen in the north and west, doors stay out of the way."""
    side = "_".join(wall.name.split("_")[:2])
    order = ("west_wall", "north_wall") if kind == "window" else ("east_wall", "south_wall")
    return 0 if side in order else 1
