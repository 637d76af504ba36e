"""Runs that are built in one line along a wall: a kitchen's cabinets and appliances, planned as a whole.

What is low stands side by side under one worktop height, appliances between cabinets; what is tall stands at an end.
A run that is too long for every wall goes round a corner or is shared by two walls across from each other.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, pairwise, permutations
from typing import NamedTuple

import numpy as np

from thinkblox.assets import facts_of
from thinkblox.knowledge.rooms import room_type
from thinkblox.phrases import Constraint
from thinkblox.plan import Target, Tie
from thinkblox.policies.expert.ground import darkens, zone_costs
from thinkblox.policies.expert.idea import WALL_GAP, Idea
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.walls import named_walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth
from thinkblox.scene.room import Wall, turn_between
from thinkblox.scene.saying import turned
from thinkblox.scene.zones import beside
from thinkblox.value import Vec3

GAP = 0.008
"""Left between neighbours in a run [m]."""
TALL = 1.2
"""What is higher than this stands at an end of the run [m]."""
SPARE = 1.07
"""How much wider than usual a tall thing may come."""
TALL_GAP = 0.02
"""Left beside what is tall [m]."""
CORNER = 0.06
"""Left past the depth of the other part where a run goes round a corner, for its doors [m]."""
STEPS = 12
"""Places tried along a wall besides its ends."""
USED = 0.9
"""Free depth before a run [m]."""
ROUND_CORNER, ON_TWO_WALLS = 1.5, 2.5
"""Cost of a run that goes round a corner, and of one that is on two walls across from each other."""
NOT_AS_MEANT = 6.0
"""Cost of another layout than the one that the room is called by."""
AWAY_FROM_CORNER = 0.25
"""Cost per metre from the nearest corner."""
HARD = 30.0
"""Cost of a member outside, in something, in a door's swing or before a window."""
NEXT_TO = ("next_to", "left_of", "right_of", "between")
"""Relations of neighbours in a run."""
HOT_BY_WINDOW = 6.0
"""Cost of cooking under a window."""
HOT_BY_WET, NO_WORKTOP, APPLIANCES, PARTED = 3.0, 1.0, 0.5, 4.0
"""Costs of a hob beside a sink, of one with no worktop at a side, of two appliances side by side, and of parting two
that are asked to be side by side."""
UNEVEN = 0.8
"""Cost per metre by which the parts of a run differ that is to be on two walls."""
ORDERS = 4
"""Ways to line up a run that are tried, each from either end."""
MOST_TRIED = 8000
"""Orders of a run that are compared."""
BY_WINDOW = ("under", "near", "next_to", "in_front_of")
"""Relations to a window that a place in a run can meet."""
SAME_PLACE = 0.12
"""A member stands in a slot when it is nearer than this [m]."""
FINALISTS = 6
"""Layouts of which each gives an idea."""


class RunMember(NamedTuple):
    """One thing of a run.

    Attributes:
        size: along its front axis, across and up [m].
        cabinet: whether it has a worktop.
        walls: the numbers of the walls that it may stand against.
        window: whether it, or what is built into it, is to be by a window.
        hot: whether one cooks on it; no window is above that, and no water beside.
        wet: whether a sink is built into it.
        beside: those that it is asked to stand beside.
    """

    id: str
    size: Vec3
    cabinet: bool
    walls: frozenset[int]
    window: bool
    hot: bool = False
    wet: bool = False
    beside: frozenset[str] = frozenset()

    @property
    def is_free(self) -> bool:
        """Whether its top is there to work on."""
        return self.cabinet and not (self.hot or self.wet)


class RunSlot(NamedTuple):
    """Where a member stands: against which wall, and how far along it its middle is [m]."""

    member: RunMember
    wall: int
    along: float


@dataclass(frozen=True)
class _Layout:
    slots: tuple[RunSlot, ...]
    cost: float


def is_built(situation: Situation) -> bool:
    """Whether the target is one of a run that is built in one line."""
    return situation.asset.mount == "floor" and len(_company(situation)) > 1


def run_ideas(situation: Situation) -> Iterator[Idea]:
    """The target's place in the best layouts of its whole run that hold the members placed so far."""
    members = _members(situation)
    own = situation.target.id
    layouts = [layout for layout in _layouts(situation, members) if _may_be(situation, layout)]
    costs = _costs(situation, layouts)
    order = sorted(range(len(layouts)), key=lambda i: costs[i])[: 4 * FINALISTS]
    taken: list[tuple[int, float]] = []
    for i in order:
        slot = _closed_up(situation, layouts[i], own)
        if any(wall == slot.wall and abs(along - slot.along) < SAME_PLACE for wall, along in taken):
            continue
        taken.append((slot.wall, slot.along))
        yield _idea(situation, slot, float(costs[i]), len(members))
        if len(taken) == FINALISTS:
            return


def _closed_up(situation: Situation, layout: _Layout, id: str) -> RunSlot:
    """The slot of a member as it follows from the nearest that stands there: not all are as wide as was thought."""
    at = next(n for n, slot in enumerate(layout.slots) if slot.member.id == id)
    own = layout.slots[at]
    there = [n for n, slot in enumerate(layout.slots) if slot.wall == own.wall and n != at]
    standing = [n for n in there if layout.slots[n].member.id in situation.scene]
    if not standing:
        return own
    nearest = min(standing, key=lambda n: abs(n - at))
    placed = situation.scene[layout.slots[nearest].member.id]
    along, _ = situation.room.walls[own.wall].coordinates((placed.position[0], placed.position[1]))
    line = [slot.member for slot in layout.slots[min(at, nearest) : max(at, nearest) + 1]]
    apart = _length(line) - (line[0].size[1] + line[-1].size[1]) / 2
    return own._replace(along=along + (apart if at > nearest else -apart))


def _company(situation: Situation) -> list[Target]:
    """All of the plan that are built in one line with the target; none where one of them is asked to be elsewhere."""
    if not situation.facts.is_in("built_in_line"):
        return []
    run = situation.facts.run
    alike = [t for t in situation.observation.plan.targets if facts_of(t.category).run == run]
    ids = {t.id for t in alike}
    return alike if all(_is_free(target, ids) for target in alike) else []


def _is_free(target: Target, run: set[str]) -> bool:
    """Whether all that is asked of its place is what a run gives: a wall, or a neighbour in the run."""
    places = {"against_wall", *BY_WINDOW}
    given = (not t.asked or set(t.anchors) <= run or (t.kind in places and _is_given(t)) for t in target.ties)
    return all(given) and not any(tie.spread for tie in target.ties)


def _is_given(tie: Tie) -> bool:
    return tie.kind == "against_wall" or tie.anchors == ("window",)


def _members(situation: Situation) -> list[RunMember]:
    built_in = [t for t in situation.observation.plan.targets if facts_of(t.category).is_in("built_in")]
    on = {anchor: t.category for t in built_in for tie in t.ties if tie.kind == "on" for anchor in tie.anchors}
    return [
        RunMember(
            t.id,
            _size(situation, t),
            facts_of(t.category).is_in("takes_built_in"),
            _walls_of(situation, t),
            any(tie.kind in BY_WINDOW and tie.anchors == ("window",) for tie in t.ties),
            hot=facts_of(on.get(t.id, t.category)).is_in("clear_above"),
            wet=t.id in on and not facts_of(on[t.id]).is_in("clear_above"),
            beside=frozenset(a for tie in t.ties if tie.asked and tie.kind in NEXT_TO for a in tie.anchors),
        )
        for t in _company(situation)
    ]


def _walls_of(situation: Situation, target: Target) -> frozenset[int]:
    walls = situation.room.walls
    meant = set(range(len(walls)))
    for tie in target.ties:
        if tie.asked and tie.kind == "against_wall":
            meant &= {walls.index(wall) for place in tie.anchors for wall in named_walls(situation.room, place)}
    return frozenset(meant)


def _size(situation: Situation, target: Target) -> Vec3:
    if target.id == situation.target.id:
        return situation.size
    if target.id in situation.scene:
        return situation.scene[target.id].size
    depth, width, height = situation.kind(target).size
    return (depth, width * (SPARE if height > TALL else 1.0), height)


def _layouts(situation: Situation, members: list[RunMember]) -> Iterator[_Layout]:
    low = [m for m in members if m.size[2] <= TALL]
    tall = [m for m in members if m.size[2] > TALL]
    walls = situation.room.walls
    meant = room_type(situation.observation.plan.brief.room_type).run
    for order, dear in _orders(low):
        for ends in _ends(tall):
            for number in range(len(walls)):
                for slots, away in _straight(walls, number, order, ends):
                    yield _Layout(slots, AWAY_FROM_CORNER * away + dear + (NOT_AS_MEANT if meant else 0.0))
            for layout in _on_two(walls, order, ends, meant):
                yield replace(layout, cost=layout.cost + dear)


def _orders(low: list[RunMember]) -> list[tuple[list[RunMember], float]]:
    """The best ways to line up what is low, seen from either end, with what each costs; plain cabinets stay in turn."""
    plain = [m for m in low if m.is_free and not (m.beside or m.window)]
    special = [m for m in low if m not in plain]
    found: list[tuple[float, list[RunMember]]] = []
    for places in islice(permutations(range(len(low)), len(special)), MOST_TRIED):
        at = dict(zip(places, special, strict=True))
        rest = iter(plain)
        line = [at[n] if n in at else next(rest) for n in range(len(low))]
        found.append((_order_cost(line), line))
    found.sort(key=lambda pair: pair[0])
    least = found[0][0] if found else 0.0
    best = found[:ORDERS] or [(0.0, [])]
    return [
        (order, cost - least) for cost, line in best for order in ((line, line[::-1]) if len(line) > 1 else (line,))
    ]


def _order_cost(line: list[RunMember]) -> float:
    """What is wrong with a line: a hob by the sink or without worktop, appliances in a heap, a dishwasher far off."""
    cost = 0.0
    for one, other in pairwise(line):
        cost += HOT_BY_WET * ((one.hot and other.wet) or (one.wet and other.hot))
        cost += APPLIANCES * (not one.cabinet and not other.cabinet)
        cost -= 0.1 * ((one.wet and not (other.cabinet or other.hot)) or (other.wet and not (one.cabinet or one.hot)))
    for n, member in enumerate(line):
        near = [line[k] for k in (n - 1, n + 1) if 0 <= k < len(line)]
        cost += NO_WORKTOP * member.hot * (2 - sum(m.is_free for m in near))
        cost += NO_WORKTOP / 2 * member.wet * (not any(m.is_free for m in near))
        beside = {m.id for m in near}
        cost += PARTED * len((member.beside & {m.id for m in line}) - beside)
    return cost


def _ends(tall: list[RunMember]) -> list[tuple[list[RunMember], list[RunMember]]]:
    """Ways to share what is tall between the beginning and the end."""
    return [([], tall), (tall, [])] if tall else [([], [])]


def _straight(
    walls: Sequence[Wall], number: int, order: list[RunMember], ends: tuple[list[RunMember], list[RunMember]]
) -> Iterator[tuple[tuple[RunSlot, ...], float]]:
    """All in one line along one wall, at several places, and how far each is from a corner [m]."""
    line = [*ends[0], *order, *ends[1]]
    free = walls[number].length - _length(line) - 2 * WALL_GAP
    if free < 0.0:
        return
    for share in np.unique(np.linspace(0.0, 1.0, STEPS + 1)):
        start = float(share) * free
        yield _slots(line, number, start + WALL_GAP), min(start, free - start)


def _on_two(
    walls: Sequence[Wall], order: list[RunMember], ends: tuple[list[RunMember], list[RunMember]], meant: str
) -> Iterator[_Layout]:
    """A part along one wall and the rest along the next, from their corner, or along the one across the room.

    Where one of these is meant, the parts are about as long.
    """
    line = [*ends[0], *order, *ends[1]]
    for cut in range(1, len(line)):
        first, second = line[:cut], line[cut:]
        uneven = UNEVEN * abs(_length(first) - _length(second))
        for one, other in permutations(range(len(walls)), 2):
            turn = turn_between(walls[one].yaw, walls[other].yaw)
            if turn > 179.0:
                dear = uneven if meant == "facing" else ON_TWO_WALLS + (NOT_AS_MEANT if meant else 0.0)
                yield from _across(walls, (one, other), first, second, dear)
            elif turn > 1.0 and other == (one + 1) % len(walls):
                dear = uneven if meant == "corner" else ROUND_CORNER + (NOT_AS_MEANT if meant else 0.0)
                yield from _round(walls, (one, other), first, second, dear)


def _round(
    walls: Sequence[Wall], pair: tuple[int, int], first: list[RunMember], second: list[RunMember], cost: float
) -> Iterator[_Layout]:
    """Round the corner at the end of the first wall: both parts begin past the depth of the other."""
    depths = [max(m.size[0] for m in part) + WALL_GAP + CORNER for part in (first, second)]
    start = walls[pair[0]].length - depths[1] - _length(first)
    if start >= 0.0 and depths[0] + _length(second) <= walls[pair[1]].length:
        slots = (*_slots(first, pair[0], start), *_slots(second, pair[1], depths[0]))
        yield _Layout(slots, cost)


def _across(
    walls: Sequence[Wall], pair: tuple[int, int], first: list[RunMember], second: list[RunMember], cost: float
) -> Iterator[_Layout]:
    lengths = [walls[n].length - _length(part) - 2 * WALL_GAP for n, part in zip(pair, (first, second), strict=True)]
    if min(lengths) < 0.0:
        return
    for a in (0.0, lengths[0]):
        for b in (0.0, lengths[1]):
            slots = (*_slots(first, pair[0], a + WALL_GAP), *_slots(second, pair[1], b + WALL_GAP))
            yield _Layout(slots, cost)


def _length(line: list[RunMember]) -> float:
    return sum(m.size[1] for m in line) + sum(_between(a, b) for a, b in pairwise(line))


def _between(one: RunMember, other: RunMember) -> float:
    return TALL_GAP if max(one.size[2], other.size[2]) > TALL else GAP


def _slots(line: list[RunMember], wall: int, start: float) -> tuple[RunSlot, ...]:
    slots, at = [], start
    for number, member in enumerate(line):
        slots.append(RunSlot(member, wall, at + member.size[1] / 2))
        at += member.size[1] + (_between(member, line[number + 1]) if number + 1 < len(line) else 0.0)
    return tuple(slots)


def _may_be(situation: Situation, layout: _Layout) -> bool:
    """Whether every member is at a wall that it is asked to be at, and each that is placed stands in its slot."""
    for slot in layout.slots:
        if slot.wall not in slot.member.walls or (slot.member.window and not _is_by_window(situation, slot)):
            return False
        if slot.member.id in situation.scene and slot.member.id != situation.target.id:
            placed = situation.scene[slot.member.id]
            wall = situation.room.walls[slot.wall]
            along, out = wall.coordinates((placed.position[0], placed.position[1]))
            away = abs(out - placed.size[0] / 2 - WALL_GAP)
            if max(abs(along - slot.along), away) > SAME_PLACE or turn_between(wall.yaw, placed.yaw) > 1.0:
                return False
    return True


def _is_by_window(situation: Situation, slot: RunSlot) -> bool:
    windows = (o for o in situation.room.openings if o.kind == "window" and o.wall == slot.wall)
    return any(o.offset - 0.1 <= slot.along <= o.offset + o.width + 0.1 for o in windows)


def _costs(situation: Situation, layouts: list[_Layout]) -> Array:
    """What each layout costs: its own, what is in its way, and the floor that is missing before it."""
    if not layouts:
        return np.zeros(0)
    count = len(layouts[0].slots)
    rects = _rects(situation, layouts)
    own = {slot.member.id for slot in layouts[0].slots}
    alone = situation.without(own)
    bad = HARD * (outside(rects, situation.room.polygon) > 0.0005)
    bad += HARD * (overlap_depth(rects, alone.solids).max(-1, initial=0.0) > 0.001)
    bad += HARD * (overlap_depth(rects, situation.door_zones).max(-1, initial=0.0) > 0.001)
    bad += HARD * (overlap_depth(rects, situation.kept_free).max(-1, initial=0.0) > 0.001)
    bad += HARD * darkens(situation, rects)
    before = zone_costs(alone, beside(rects, "front", USED), weight=2.0)
    used = 3.0 * overlap_depth(rects, alone.clearances).max(-1, initial=0.0)
    meant = 2.0 * overlap_depth(rects, situation.reserved).max(-1, initial=0.0)
    each = (bad + before + used + meant).reshape(len(layouts), count).sum(-1)
    hot = (sum(slot.member.hot and _is_by_window(situation, slot) for slot in layout.slots) for layout in layouts)
    each += HOT_BY_WINDOW * np.fromiter(hot, dtype=float, count=len(layouts))
    return np.asarray(each + [layout.cost for layout in layouts])


def _rects(situation: Situation, layouts: list[_Layout]) -> Rects:
    rows = []
    for layout in layouts:
        for slot in layout.slots:
            wall, size = situation.room.walls[slot.wall], slot.member.size
            centre = wall.point(slot.along, WALL_GAP + size[0] / 2)
            rows.append((centre, (size[0], size[1]), wall.yaw, 0.0, size[2]))
    return Rects.of(rows)


def _idea(situation: Situation, slot: RunSlot, cost: float, count: int) -> Idea:
    wall = situation.room.walls[slot.wall]
    x, y = wall.point(slot.along, WALL_GAP + situation.size[0] / 2)
    words = (Constraint(kind="against", anchors=(wall.name,)), turned(wall.yaw))
    why = f"it is one of {count} in a line along the {wall.name.replace('_', ' ')}"
    return Idea((x, y, 0.0), wall.yaw % 360.0, words, why, cost, against=(wall.name,))


def middle_of_run(situation: Situation, part: Placement) -> float:
    """How far to the left of the middle of a part that is of the straight row that it stands in [m]; 0 where alone.

    Seats that stand in line form a row too.
    """
    own = facts_of(part.category)
    row = [part]
    for p in situation.solid:
        x, _ = part.to_local((p.position[0], p.position[1]))
        in_line = turn_between(p.yaw, part.yaw) < 1.0 and abs(x) < part.size[0] / 2
        alike = own.is_in("chairs") and p.category == part.category
        if p.id != part.id and in_line and (alike or own.runs_with(facts_of(p.category))):
            row.append(p)
    ends = [(part.to_local((p.position[0], p.position[1]))[1], p.size[1] / 2) for p in row]
    return (max(y + half for y, half in ends) + min(y - half for y, half in ends)) / 2
