"""Where a run that is built in one line may stand: along one wall, round corners, or along two walls across a room.

What is low fills its stretch of wall under one worktop, as far as cabinets of a usual width can; what is tall stands at
an end.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise, permutations, product
from typing import NamedTuple

import numpy as np

from thinkblox.policies.expert.idea import WALL_GAP
from thinkblox.policies.expert.run_orders import (
    TALL,
    Line,
    RunMember,
    ends,
    neighbours_cost,
    order_cost,
    orders,
    ways_cost,
    with_corners,
)
from thinkblox.scene.room import Room, Wall, turn_between
from thinkblox.scene.stretches import Stretch, is_inner_corner, stretches

GAP = 0.004
"""Left between neighbours in a run [m]."""
TALL_GAP = 0.02
"""Left beside what is tall [m]."""
CORNER = 0.06
"""Left past the depth of the other part where a run goes round a corner that nothing fills, for its doors [m]."""
STEPS = 12
"""Places tried along a wall besides its ends."""
NARROWEST, USUAL, WIDEST = 0.4, 0.6, 0.8
"""Widths of a cabinet whose width follows from its wall [m]."""
SLACK = 0.006
"""Left at the end of a stretch that is filled [m]."""
ROUND_CORNER, ON_TWO_WALLS = 3.5, 4.5
"""Cost of a run that goes round a corner that nothing fills, and of one on two walls across from each other."""
NOT_AS_MEANT = 6.0
"""Cost of another layout than the one that the room is called by."""
AWAY_FROM_CORNER, UNFILLED, UNUSUAL = 0.25, 0.4, 1.0
"""Costs per metre from the nearest corner, per metre of wall that is left beside a run, up to one, and by which
cabinets are wider or narrower than usual."""
UNEVEN = 0.8
"""Cost per metre by which the parts of a run differ that is to be on two walls."""
MAKESHIFT = 8
"""Ways to line up a run that are tried on two walls where it is better along one."""
PARTED_WORKTOP = 3.0
"""Cost per metre of a gap between two corners that should be filled."""
BETWEEN_ARMS, WIDE_APART = 1.1, 0.5
"""Least free floor between parts that face each other [m], and cost per metre of more."""


class RunSlot(NamedTuple):
    """Where a member stands: against which wall, and how far along it its middle is [m]."""

    member: RunMember
    wall: int
    along: float


@dataclass(frozen=True)
class RunLayout:
    """A slot for each member of a run, and what speaks against it so far."""

    slots: tuple[RunSlot, ...]
    cost: float


class _Fit(NamedTuple):
    """A part of a run as wide as its wall has it, and what that costs."""

    line: Line
    length: float
    cost: float


def layouts(room: Room, members: Sequence[RunMember], meant: str) -> Iterator[RunLayout]:
    """Layouts of a run in a room that is called by one of them, if it is: round as many corners as it has units for."""
    corners = [m for m in members if m.corner]
    low = [m for m in members if not (m.corner or m.is_tall)]
    tall = [m for m in members if not m.corner and m.is_tall]
    depth = max((m.size[0] for m in members if not m.corner), default=0.6) + WALL_GAP
    height = max((m.size[2] for m in low), default=TALL)
    free = [stretches(room, number, depth=depth, height=height) for number in range(len(room.walls))]
    for rank, ((order, dear), (first, last)) in enumerate(product(orders(low, tall), ends(tall))):
        line = [*first, *order, *last]
        dear += ways_cost(line) + neighbours_cost(line)
        if corners:
            for layout in _round_corners(room, free, line, corners):
                yield layout
            continue
        for layout in _straight(free, line):
            yield RunLayout(layout.slots, layout.cost + dear + (NOT_AS_MEANT if meant else 0.0))
        for layout in _on_two(room, free, line, meant) if meant or rank < MAKESHIFT else ():
            yield RunLayout(layout.slots, layout.cost + dear)


def _straight(free: Sequence[Sequence[Stretch]], line: Line) -> Iterator[RunLayout]:
    """All in one line along one wall: filling a stretch of it, or at several places of that."""
    for number, spans in enumerate(free):
        for low, high in spans:
            start, end = low + WALL_GAP, high - WALL_GAP
            if (fit := _filled(line, end - start)) is not None:
                yield RunLayout(_slots(fit.line, number, start), fit.cost)
            spare = end - start - length_of(line)
            if spare < 0.0:
                continue
            left = UNFILLED * min(1.0, spare)
            for share in np.unique(np.linspace(0.0, 1.0, STEPS + 1)):
                aside = float(share) * spare
                away = AWAY_FROM_CORNER * min(aside, spare - aside)
                yield RunLayout(_slots(line, number, start + aside), away + left)


def _filled(line: Line, room: float) -> _Fit | None:
    """The line with such widths that it takes all the room there is [m]; None where that is not a cabinet's width."""
    open_ = [m for m in line if m.open]
    if not open_:
        return None
    taken = length_of(line) - sum(m.size[1] for m in open_)
    width = round((room - SLACK - taken) / len(open_), 3)
    if not NARROWEST <= width <= WIDEST:
        return None
    fitted = [_as_wide(m, width) if m.open else m for m in line]
    return _Fit(fitted, length_of(fitted), UNUSUAL * abs(width - USUAL))


def _as_wide(member: RunMember, width: float) -> RunMember:
    return member._replace(size=(member.size[0], width, member.size[2]))


def _fitted(line: Line, room: float) -> _Fit | None:
    """The line as it fills the room there is, or as it usually is; None where it does not fit."""
    if (fit := _filled(line, room)) is not None:
        return fit
    length = length_of(line)
    return _Fit(line, length, UNFILLED * min(1.0, room - length)) if length <= room else None


def _on_two(room: Room, free: Sequence[Sequence[Stretch]], line: Line, meant: str) -> Iterator[RunLayout]:
    """A part along one wall and the rest along the next, from their corner, or along the one across the room.

    Where one of these is meant, the parts are about as long.
    """
    walls = room.walls
    for cut in range(1, len(line)):
        first, second = line[:cut], line[cut:]
        uneven = UNEVEN * abs(length_of(first) - length_of(second))
        for one, other in permutations(range(len(walls)), 2):
            turn = turn_between(walls[one].yaw, walls[other].yaw)
            if turn > 179.0:
                dear = uneven if meant == "facing" else ON_TWO_WALLS + (NOT_AS_MEANT if meant else 0.0)
                yield from _across(free, (one, other), first, second, dear)
            elif other == (one + 1) % len(walls) and is_inner_corner(room, one):
                dear = uneven if meant == "corner" else ROUND_CORNER + (NOT_AS_MEANT if meant else 0.0)
                yield from _past_corner(walls, (one, other), first, second, dear)


def _past_corner(
    walls: Sequence[Wall], pair: tuple[int, int], first: Line, second: Line, cost: float
) -> Iterator[RunLayout]:
    """Round the corner at the end of the first wall: both parts begin past the depth of the other."""
    depths = [max(m.size[0] for m in part) + WALL_GAP + CORNER for part in (first, second)]
    start = walls[pair[0]].length - depths[1] - length_of(first)
    if start >= 0.0 and depths[0] + length_of(second) <= walls[pair[1]].length:
        slots = (*_slots(first, pair[0], start), *_slots(second, pair[1], depths[0]))
        yield RunLayout(slots, cost)


def _across(
    free: Sequence[Sequence[Stretch]], pair: tuple[int, int], first: Line, second: Line, cost: float
) -> Iterator[RunLayout]:
    """Along two walls across from each other, each part at an end of its stretch, or as long as that."""
    for spans in product(free[pair[0]], free[pair[1]]):
        rooms = [high - low - 2 * WALL_GAP for low, high in spans]
        fits = [_fitted(part, room) for part, room in zip((first, second), rooms, strict=True)]
        if fits[0] is None or fits[1] is None:
            continue
        spare = [room - fit.length for room, fit in zip(rooms, fits, strict=True) if fit is not None]
        for ends_ in product((0.0, 1.0), repeat=2):
            starts = [low + WALL_GAP + end * over for (low, _), end, over in zip(spans, ends_, spare, strict=True)]
            slots = (*_slots(fits[0].line, pair[0], starts[0]), *_slots(fits[1].line, pair[1], starts[1]))
            yield RunLayout(slots, cost + fits[0].cost + fits[1].cost)


def _round_corners(room: Room, free: Sequence[Sequence[Stretch]], line: Line, corners: Line) -> Iterator[RunLayout]:
    """Along as many walls as there are units for the corners between them, and one more."""
    count = len(room.walls)
    for cuts in combinations(range(1, len(line)), len(corners)):
        parts = [line[a:b] for a, b in pairwise((0, *cuts, len(line)))]
        dear = order_cost(with_corners(parts, corners))
        for start in range(count):
            numbers = [(start + n) % count for n in range(len(parts))]
            if all(is_inner_corner(room, number) for number in numbers[:-1]):
                yield from _path(room, free, numbers, parts, corners, dear)


def _path(
    room: Room,
    free: Sequence[Sequence[Stretch]],
    numbers: Sequence[int],
    parts: Sequence[Line],
    corners: Line,
    cost: float,
) -> Iterator[RunLayout]:
    """The parts of a run along walls in turn, from corner to corner, and what fills these."""
    slots: list[RunSlot] = []
    for n, (number, part) in enumerate(zip(numbers, parts, strict=True)):
        length, after, before = room.walls[number].length, n > 0, n < len(corners)
        span = next((s for s in free[number] if _reaches(s, length, after=after, before=before)), None)
        if span is None:
            return
        low = span[0] + WALL_GAP + ((corners[n - 1].size[1] + GAP) if after else 0.0)
        high = span[1] - WALL_GAP - ((corners[n].size[0] + GAP) if before else 0.0)
        fit = _fitted(part, high - low)
        if fit is None:
            return
        spare = high - low - fit.length
        cost += fit.cost + (PARTED_WORKTOP * max(0.0, spare - 2 * SLACK) if after and before else 0.0)
        if after:
            corner = corners[n - 1]
            slots.append(RunSlot(corner, number, WALL_GAP + corner.size[1] / 2))
        slots += _slots(fit.line, number, high - fit.length if before and not after else low)
    if len(parts) > 2:
        arms = sum(max(m.size[0] for m in part) + WALL_GAP for part in (parts[0], parts[2]))
        between = room.walls[numbers[1]].length - arms
        cost += NOT_AS_MEANT * (between < BETWEEN_ARMS) + WIDE_APART * max(0.0, between - BETWEEN_ARMS)
    lengths = [length_of(part) for part in (parts[0], parts[-1])]
    yield RunLayout(tuple(slots), cost + UNEVEN / 2 * abs(lengths[0] - lengths[1]))


def _reaches(span: Stretch, length: float, *, after: bool, before: bool) -> bool:
    """Whether a stretch goes to the corners between which it is to be."""
    return (not after or span[0] <= 0.0) and (not before or span[1] >= length)


def length_of(line: Line) -> float:
    """How long a line is, with what is left between neighbours [m]."""
    return sum(m.size[1] for m in line) + sum(_between(a, b) for a, b in pairwise(line))


def _between(one: RunMember, other: RunMember) -> float:
    return TALL_GAP if one.is_tall or other.is_tall else GAP


def _slots(line: Line, wall: int, start: float) -> tuple[RunSlot, ...]:
    slots, at = [], start
    for number, member in enumerate(line):
        slots.append(RunSlot(member, wall, at + member.size[1] / 2))
        at += member.size[1] + (_between(member, line[number + 1]) if number + 1 < len(line) else 0.0)
    return tuple(slots)
