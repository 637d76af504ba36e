"""How many cabinets a run has that is built in one line: as many as the walls of its room take, round corners too."""

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np
from msgspec.structs import replace

from thinkblox.assets import facts_of, kind_of
from thinkblox.brief import Brief, Relation, Request
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import kinds_of_room, room_type
from thinkblox.planning.space import extent
from thinkblox.scene.room import Room
from thinkblox.scene.stretches import is_inner_corner, stretches

_MODULE = 0.6
"""Width of a cabinet, about which those of a run may be narrower or wider [m]."""
_DEPTH, _HEIGHT = 0.64, 0.9
"""How far a run reaches into the room, and how high what is low of it is [m]."""
_LOSS = 0.06
"""Length of wall that a run loses at its ends and between its parts [m]."""
_LONGEST = {"": 5.4, "corner": 4.8, "sides": 5.4, "facing": 6.6}
"""How long a run becomes, by its shape, the units in its corners aside [m]."""
_LONGEST_ARM, _LONGEST_ELSEWHERE = 3.6, 2.6
"""How long one part of several becomes, and a run in a room that is no kitchen [m]."""
_LEAST_RUN, _PER_AREA = 3.6, 0.28
"""How long a run may be in any kitchen [m], and for each square metre of its floor."""
_LEAST_ARM = 1.2
"""How long a part of a run round a corner is at least, besides the unit in the corner [m]."""
_AT_WORK = 2
"""Cabinets with worktop that a run has besides those into which something is built, where they fit."""
_OFTEN_ROUND, _SQUARE = 0.4, 0.7
"""How often a kitchen that says nothing of it goes round a corner, and the least proportion of such a room."""
_FEW_BUILT_IN = 2
_CORNERS = {"corner": 1, "sides": 2}
"""How many corners a run of a shape goes round."""
_SALT = 4_000_037


def with_run(brief: Brief, room: Room, seed: int) -> Brief:
    """The brief with so many of the cabinets that it assumes that they fill the walls along which they stand.

    A run that is too long for every wall, or is called so, gets a unit for each corner that it goes round. What the
    prompt says of cabinets stays.
    """
    base = next((r for r in brief.requests if _is_unit(r)), None)
    if base is None or brief.empty:
        return brief
    if not _is_open(brief, base):
        meant = room_type(brief.room_type).run
        return _with_corners(brief, base, _CORNERS.get(meant, 0) if meant and _length(brief, room, meant) else 0)
    run = [r for r in brief.requests if _is_of_run(r) and facts_of(r.category).runs_with(facts_of(base.category))]
    others = sum(r.count * extent(r)[1] for r in run if r.key != base.key)
    let_in = (r for r in brief.relations if r.kind == "on" and base.key in r.anchors)
    built_in = max(1, sum(r.subject in _built_in(brief) for r in let_in))
    least = built_in + (1 if built_in < _FEW_BUILT_IN else _AT_WORK)
    shape = _shape(brief, room, others + least * _MODULE, seed)
    corners = _CORNERS.get(shape, 0)
    count = max(built_in + 1, round((_length(brief, room, shape) - others) / _MODULE))
    return _with_corners(_counted(brief, base, count), base, corners)


def _is_unit(request: Request) -> bool:
    return facts_of(request.category).is_in("takes_built_in") and _is_of_run(request)


def _is_open(brief: Brief, base: Request) -> bool:
    """Whether the prompt leaves it to us how many cabinets there are, and where."""
    units = [r for r in brief.requests if _is_of_run(r)]
    named = any(r.asked and facts_of(r.category).is_in("takes_built_in", "fills_corner") for r in units)
    placed = any(r.asked and base.key in (r.subject, *r.anchors) for r in brief.relations)
    return not (base.asked or named or placed)


def _is_of_run(request: Request) -> bool:
    return facts_of(request.category).is_in("built_in_line") and kind_of(request.category).mount == "floor"


def _corner_unit() -> str:
    """What fills a corner."""
    return load_habits().group("fills_corner")[0]


def _built_in(brief: Brief) -> set[str]:
    return {r.key for r in brief.requests if facts_of(r.category).is_in("built_in")}


def _shape(brief: Brief, room: Room, least: float, seed: int) -> str:
    """How the run goes: as the room is called, along one wall, or round a corner where no wall is long enough."""
    meant = room_type(brief.room_type).run
    if meant:
        return meant if meant == "facing" or _length(brief, room, meant) else "corner" if _corners(room) else ""
    if "kitchen" not in kinds_of_room(brief.room_type):
        return ""
    straight, round_ = _length(brief, room, ""), _length(brief, room, "corner")
    lit = _is_lit(brief) and round_ > straight
    width, depth = sorted(room.extent)
    often = np.random.default_rng((seed, _SALT)).random() < _OFTEN_ROUND and width / depth > _SQUARE
    return "corner" if round_ >= min(least, straight) > 0.0 and (straight < least or lit or often) else ""


def _length(brief: Brief, room: Room, shape: str) -> float:
    """How much wall there is for what stands in a run of that shape, the units in its corners aside [m].

    No more is taken than a room of that size has use for.
    """
    parts = _parts(brief, room, shape)
    kitchen = "kitchen" in kinds_of_room(brief.room_type)
    most = _LONGEST.get(shape, 0.0) if kitchen else _LONGEST_ELSEWHERE
    share = max(_LEAST_RUN, _PER_AREA * room.polygon.area) if shape in ("", "corner") else most
    best: tuple[float, ...] = ()
    if parts:
        best = min(parts, key=_middle) if shape == "sides" else max(parts, key=sum)
    return min(sum(best), most, share)


def _parts(brief: Brief, room: Room, shape: str) -> list[tuple[float, ...]]:
    """The lengths of the parts of each run of a shape that a room has walls for [m]."""
    if shape == "corner":
        return list(_corners(room))
    if shape == "sides":
        return list(_sides(room))
    return list(_facing(room)) if shape == "facing" else [(length,) for length in _straight(brief, room)]


def _middle(parts: Sequence[float]) -> float:
    return parts[len(parts) // 2]


def _free(room: Room) -> list[list[tuple[float, float]]]:
    return [stretches(room, number, depth=_DEPTH, height=_HEIGHT) for number in range(len(room.walls))]


def _straight(brief: Brief, room: Room) -> Iterator[float]:
    """The lengths of wall for a run in one line [m]; with a window, where a part of it is to be by one."""
    lit = _is_lit(brief)
    windowed = {o.wall for o in room.openings if o.kind == "window"}
    for number, spans in enumerate(_free(room)):
        if not lit or number in windowed:
            yield from (high - low - _LOSS for low, high in spans)


def _is_lit(brief: Brief) -> bool:
    """Whether a part of the run is to be by a window."""
    keys = {r.key for r in brief.requests if _is_of_run(r)} | _built_in(brief)
    return any(r.anchors == ("window",) and r.subject in keys for r in brief.relations)


def _corners(room: Room) -> list[tuple[float, float]]:
    """The lengths on both sides of each corner that a run can go round [m]."""
    free, found = _free(room), []
    for number, wall in enumerate(room.walls):
        after = (number + 1) % len(free)
        one = [high - low for low, high in free[number] if high >= wall.length]
        other = [high - low for low, high in free[after] if low <= 0.0]
        if is_inner_corner(room, number) and one and other:
            arms = _arm(one[0], corners=1), _arm(other[0], corners=1)
            if min(arms) >= _LEAST_ARM:
                found.append(arms)
    return found


def _sides(room: Room) -> list[tuple[float, float, float]]:
    """The lengths of the three parts of each run that can go round two corners [m]."""
    free, found = _free(room), []
    for number, wall in enumerate(room.walls):
        second, third = (number + 1) % len(free), (number + 2) % len(free)
        one = [high - low for low, high in free[number] if high >= wall.length]
        whole = [high - low for low, high in free[second] if low <= 0.0 and high >= room.walls[second].length]
        other = [high - low for low, high in free[third] if low <= 0.0]
        inner = is_inner_corner(room, number) and is_inner_corner(room, second)
        if inner and one and whole and other:
            parts = _arm(one[0], corners=1), _arm(whole[0], corners=2, most=False), _arm(other[0], corners=1)
            if min(parts[0], parts[2]) >= _MODULE and parts[1] >= _MODULE:
                found.append(parts)
    return found


def _facing(room: Room) -> list[tuple[float, float]]:
    free = _free(room)
    half = len(free) // 2
    pairs = (product(free[n], free[n + half]) for n in range(half)) if len(free) == 4 else ()
    lengths = ((a[1] - a[0] - _LOSS, b[1] - b[0] - _LOSS) for pair in pairs for a, b in pair)
    return [(min(_LONGEST_ARM, a), min(_LONGEST_ARM, b)) for a, b in lengths]


def _arm(wall: float, *, corners: int, most: bool = True) -> float:
    length = wall - _LOSS - corners * kind_of(_corner_unit()).size[0]
    return min(_LONGEST_ARM, length) if most else length


def _counted(brief: Brief, base: Request, count: int) -> Brief:
    requests = tuple(replace(r, count=count) if r.key == base.key else r for r in brief.requests)
    return replace(brief, requests=requests)


def _with_corners(brief: Brief, base: Request, count: int) -> Brief:
    """The brief with units for so many corners, right after the cabinets."""
    unit = _corner_unit()
    if not count or any(r.category == unit for r in brief.requests):
        return brief
    at = next(n for n, r in enumerate(brief.requests) if r.key == base.key) + 1
    corner = Request(key=unit, category=unit, count=count, asked=False)
    placed = Relation(kind="in_corner", subject=unit, anchors=("corner",), asked=False)
    requests = (*brief.requests[:at], corner, *brief.requests[at:])
    return replace(brief, requests=requests, relations=(*brief.relations, placed))
