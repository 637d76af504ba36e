"""Runs that are built in one line along a wall: a kitchen's cabinets and appliances, planned as a whole.

What is low stands side by side under one worktop height, appliances between cabinets; what is tall stands at an end.
A run that is too long for every wall goes round a corner or is shared by two walls across from each other.
"""

from collections.abc import Iterator

import numpy as np

from thinkblox.assets import facts_of
from thinkblox.knowledge.rooms import room_type
from thinkblox.phrases import Constraint
from thinkblox.plan import Target, Tie
from thinkblox.policies.expert.ground import darkens, zone_costs
from thinkblox.policies.expert.idea import WALL_GAP, Idea
from thinkblox.policies.expert.run_layouts import RunLayout, RunSlot, layouts, length_of
from thinkblox.policies.expert.run_orders import TALL, RunMember
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.walls import named_walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth
from thinkblox.scene.room import turn_between
from thinkblox.scene.saying import turned
from thinkblox.scene.zones import beside
from thinkblox.value import Vec3

SPARE = 1.07
"""How much wider than usual a tall thing may come."""
USED = 0.9
"""Free depth before a run [m]."""
HARD = 30.0
"""Cost of a member outside, in something, in a door's swing or before a window."""
NEXT_TO = ("next_to", "left_of", "right_of", "between")
"""Relations of neighbours in a run."""
HOT_BY_WINDOW, WET_BY_WINDOW = 6.0, -1.2
"""Costs of cooking under a window, and of washing up there."""
NO_UPPERS, UPPERS = (2.5, 6.0), 0.6
"""Cost of a run over which no wall cabinets can hang that are to come, assumed and asked for, and how long each of
these is [m]."""
BY_WINDOW = ("under", "near", "next_to", "in_front_of")
"""Relations to a window that a place in a run can meet."""
SAME_PLACE = 0.12
"""A member stands in a slot when it is nearer than this [m]."""
SAME_WIDTH = 0.002
"""Widths that differ by less are the same [m]."""
WORSE = 1.5
"""How much dearer each place is that another than the best layout gives, so that all parts keep to one."""
FINALISTS = 6
"""Layouts of which each gives an idea."""


def is_built(situation: Situation) -> bool:
    """Whether the target is one of a run that is built in one line."""
    return situation.asset.mount == "floor" and len(_company(situation)) > 1


def run_ideas(situation: Situation) -> Iterator[Idea]:
    """The target's place in the best layouts of its whole run that hold the members placed so far."""
    members = _members(situation)
    own = situation.target.id
    meant = room_type(situation.observation.plan.brief.room_type).run
    found = [layout for layout in layouts(situation.room, members, meant) if _may_be(situation, layout)]
    costs = _costs(situation, found)
    order = sorted(range(len(found)), key=lambda i: costs[i])[: 4 * FINALISTS]
    taken: list[tuple[int, float]] = []
    for i in order:
        slot = _closed_up(situation, found[i], own)
        if any(wall == slot.wall and abs(along - slot.along) < SAME_PLACE for wall, along in taken):
            continue
        taken.append((slot.wall, slot.along))
        yield _idea(situation, slot, float(costs[i]) + WORSE * (len(taken) - 1), len(members))
        if len(taken) == FINALISTS:
            return


def _closed_up(situation: Situation, layout: RunLayout, id: str) -> RunSlot:
    """The slot of a member as it follows from the nearest that stands there: not all are as wide as was thought."""
    at = next(n for n, slot in enumerate(layout.slots) if slot.member.id == id)
    own = layout.slots[at]
    there = [n for n, slot in enumerate(layout.slots) if slot.wall == own.wall and n != at]
    standing = [n for n in there if layout.slots[n].member.id in situation.scene]
    if not standing or own.member.corner:
        return own
    nearest = min(standing, key=lambda n: abs(n - at))
    placed = situation.scene[layout.slots[nearest].member.id]
    along, _ = situation.room.walls[own.wall].coordinates((placed.position[0], placed.position[1]))
    line = [slot.member for slot in layout.slots[min(at, nearest) : max(at, nearest) + 1]]
    apart = length_of(line) - (line[0].size[1] + line[-1].size[1]) / 2
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
            facts_of(t.category).is_in("takes_built_in", "fills_corner"),
            _walls_of(situation, t),
            any(tie.kind in BY_WINDOW and tie.anchors == ("window",) for tie in t.ties),
            hot=facts_of(on.get(t.id, t.category)).is_in("clear_above"),
            wet=t.id in on and not facts_of(on[t.id]).is_in("clear_above"),
            beside=_asked_by(t, *NEXT_TO),
            left_of=_asked_by(t, "left_of"),
            right_of=_asked_by(t, "right_of"),
            corner=facts_of(t.category).is_in("fills_corner"),
            open=t.id not in on and _is_open(situation, t),
        )
        for t in _company(situation)
    ]


def _asked_by(target: Target, *kinds: str) -> frozenset[str]:
    """What a target is asked to stand by in some way."""
    return frozenset(a for tie in target.ties if tie.asked and tie.kind in kinds for a in tie.anchors)


def _is_open(situation: Situation, target: Target) -> bool:
    """Whether it is a cabinet of the usual width, of which nothing is said, that does not stand yet."""
    if target.id in situation.scene or not facts_of(target.category).is_in("takes_built_in"):
        return False
    own = target.id == situation.target.id
    sized = own and situation.observation.sizes is None
    usual = situation.observation.kinds[target.category].size[1]
    return not (sized or any(target.size)) and abs(situation.kind(target).size[1] - usual) < SAME_WIDTH


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


def _may_be(situation: Situation, layout: RunLayout) -> bool:
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


def _is_before_window(situation: Situation, slot: RunSlot) -> bool:
    """Whether any part of it is before a window."""
    half = slot.member.size[1] / 2
    windows = (o for o in situation.room.openings if o.kind == "window" and o.wall == slot.wall)
    return any(o.offset < slot.along + half and slot.along - half < o.offset + o.width for o in windows)


def _costs(situation: Situation, found: list[RunLayout]) -> Array:
    """What each layout costs: its own, what is in its way, and the floor that is missing before it."""
    if not found:
        return np.zeros(0)
    count = len(found[0].slots)
    rects = _rects(situation, found)
    own = {slot.member.id for slot in found[0].slots}
    alone = situation.without(own)
    bad = HARD * (outside(rects, situation.room.polygon) > 0.0005)
    bad += HARD * (overlap_depth(rects, alone.solids).max(-1, initial=0.0) > 0.001)
    bad += HARD * (overlap_depth(rects, situation.door_zones).max(-1, initial=0.0) > 0.001)
    bad += HARD * (overlap_depth(rects, situation.kept_free).max(-1, initial=0.0) > 0.001)
    bad += HARD * darkens(situation, rects)
    before = zone_costs(alone, beside(rects, "front", USED), weight=2.0)
    used = 3.0 * overlap_depth(rects, alone.clearances).max(-1, initial=0.0)
    meant = 2.0 * overlap_depth(rects, situation.reserved).max(-1, initial=0.0)
    each = (bad + before + used + meant).reshape(len(found), count).sum(-1)
    windows = (_window_costs(situation, layout) for layout in found)
    each += np.fromiter(windows, dtype=float, count=len(found))
    return np.asarray(each + [layout.cost for layout in found])


def _window_costs(situation: Situation, layout: RunLayout) -> float:
    """What it costs which members are under a window, and that too little wall is left for what is to hang above."""
    at = [_is_by_window(situation, slot) for slot in layout.slots]
    cost = HOT_BY_WINDOW * sum(slot.member.hot and _is_before_window(situation, slot) for slot in layout.slots)
    cost += WET_BY_WINDOW * any(by and slot.member.wet for by, slot in zip(at, layout.slots, strict=True))
    above = [t for t in situation.observation.plan.targets if facts_of(t.category).is_in("over_run")]
    if above:
        weight = NO_UPPERS[any(t.asked for t in above)]
        low = (s for s in layout.slots if not (s.member.hot or s.member.is_tall or _is_before_window(situation, s)))
        cost += weight * max(0.0, 1.0 - sum(slot.member.size[1] for slot in low) / (UPPERS * len(above)))
    return cost


def _rects(situation: Situation, found: list[RunLayout]) -> Rects:
    rows = []
    for layout in found:
        for slot in layout.slots:
            wall, size = situation.room.walls[slot.wall], slot.member.size
            centre = wall.point(slot.along, WALL_GAP + size[0] / 2)
            rows.append((centre, (size[0], size[1]), wall.yaw, 0.0, size[2]))
    return Rects.of(rows)


def _idea(situation: Situation, slot: RunSlot, cost: float, count: int) -> Idea:
    wall, size = situation.room.walls[slot.wall], slot.member.size
    x, y = wall.point(slot.along, WALL_GAP + size[0] / 2)
    words = (Constraint(kind="against", anchors=(wall.name,)), turned(wall.yaw))
    why = f"it is one of {count} in a line along the {wall.name.replace('_', ' ')}"
    fitted = None if abs(size[1] - situation.size[1]) < SAME_WIDTH else size
    return Idea((x, y, 0.0), wall.yaw % 360.0, words, why, cost, size=fitted, against=(wall.name,))


def middle_of_run(situation: Situation, part: Placement) -> float:
    """How far to the left of the middle of a part that is of the straight row that it stands in [m]; 0 where alone.

    Seats that stand in line form a row too.
    """
    row = _row(situation, part)
    ends = [(part.to_local((p.position[0], p.position[1]))[1], p.size[1] / 2) for p in row]
    return (max(y + half for y, half in ends) + min(y - half for y, half in ends)) / 2


def middle_unit(situation: Situation, part: Placement) -> Placement:
    """The unit at the middle of the straight row that is built in one line with a part; the part itself where alone."""
    if not facts_of(part.category).is_in("built_in_line"):
        return part
    middle = middle_of_run(situation, part)
    row = _row(situation, part)
    return min(row, key=lambda p: abs(part.to_local((p.position[0], p.position[1]))[1] - middle))


def _row(situation: Situation, part: Placement) -> list[Placement]:
    """What stands in one straight row with a part, and that itself first."""
    own = facts_of(part.category)
    row = [part]
    for p in situation.solid:
        x, _ = part.to_local((p.position[0], p.position[1]))
        in_line = turn_between(p.yaw, part.yaw) < 1.0 and abs(x) < part.size[0] / 2
        alike = own.is_in("chairs") and p.category == part.category
        if p.id != part.id and in_line and (alike or own.runs_with(facts_of(p.category))):
            row.append(p)
    return row
