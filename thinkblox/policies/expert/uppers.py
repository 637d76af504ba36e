"""Wall cabinets in line over a run: as wide as the units below, none over a hob or before a window.

They share out the wall over the worktop: the k-th of n takes its part of the stretches that are free.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from thinkblox.assets import facts_of
from thinkblox.plan import carries
from thinkblox.policies.expert.hung import hang
from thinkblox.policies.expert.idea import WALL_GAP, Idea
from thinkblox.policies.expert.run_orders import TALL
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Wall, turn_between

IN_LINE = -4.0
"""What it is worth to hang in line over the run."""
NARROW = 0.4
"""What is narrower is left bare [m]."""
JOINT = 0.06
"""Units with no more between them stand in one line [m]."""
BETWEEN = 0.004
"""Left between neighbours on the wall [m]."""
BY_WINDOW = 0.06
"""Left beside a window [m]."""
DOOR_ROOM = 0.03
"""Left past the unit in a corner for the doors of what hangs on the next wall [m]."""
EARLIER = 0.05
"""What it costs to take a shorter stretch first."""
FLAT = 0.05
"""What is no deeper hangs on a wall without taking it from cabinets [m]."""


class _Unit(NamedTuple):
    """What stands in a run: from where to where along its wall, and whether cabinets may hang over it [m]."""

    low: float
    high: float
    open: bool


def hangs_over_run(situation: Situation) -> bool:
    """Whether the target belongs over a run, and nothing else is asked of its place."""
    if situation.asset.mount != "wall" or not situation.facts.is_in("over_run"):
        return False
    run = {p.id for p in _run(situation)}
    asked = [tie for tie in situation.target.ties if tie.asked and tie.kind != "on"]
    given = all(tie.kind in ("above", "against_wall") and _is_given(tie.anchors, run) for tie in asked)
    return bool(run) and given and not any(tie.spread for tie in asked)


def _is_given(anchors: tuple[str, ...], run: set[str]) -> bool:
    return anchors == ("wall",) or set(anchors) <= run


def upper_ideas(situation: Situation) -> Iterator[Idea]:
    """Over each stretch of the run, the longest first; as wide as the target's share of them."""
    targets = situation.observation.plan.targets
    left = sum(t.request == situation.target.request and t.id not in situation.scene for t in targets)
    run = _run(situation)
    top = max(p.top for p in run if p.size[2] <= TALL)
    z = min(top + situation.facts.hanging.above, situation.room.height - situation.size[2] - 0.02)
    walls = enumerate(situation.room.walls)
    found = [(wall, edges) for number, wall in walls for edges in _stretches(situation, number, wall, run, z)]
    found.sort(key=lambda each: each[1][0] - each[1][-1])
    for rank, (wall, edges) in enumerate(found):
        share = max(1, left - len(found) + 1) if rank == 0 else 1
        for low, high in _places(situation, edges, share):
            size = (situation.size[0], round(high - low - BETWEEN, 3), situation.size[2])
            why = "it hangs in line over the units below"
            idea = hang(situation, wall, (low + high) / 2, z, why=why, cost=IN_LINE + EARLIER * rank, size=size)
            yield idea if abs(size[1] - situation.size[1]) > 0.002 else replace(idea, size=None)


def hood_ideas(situation: Situation) -> Iterator[Idea]:
    """Over the unit on which one cooks, no wider than that."""
    if situation.asset.mount != "wall" or any(situation.target.size):
        return
    above = (anchor for tie in situation.target.ties if tie.kind == "above" for anchor in situation.placed(tie.anchors))
    for hot in (anchor for anchor in above if facts_of(anchor.category).is_in("clear_above")):
        run = {p.id: p for p in _run(situation)}
        unit = run.get(hot.support, run.get(hot.id))
        for wall in situation.room.walls if unit is not None else ():
            if unit is None or turn_between(unit.yaw, wall.yaw) > 1.0:
                continue
            along, _ = wall.coordinates((unit.position[0], unit.position[1]))
            x, y, high = situation.size
            size = (x, round(min(y, unit.size[1] - BETWEEN), 3), high)
            z = min(hot.top + situation.facts.hanging.above, situation.room.height - high - 0.02)
            why = f"it belongs over {hot.id}"
            idea = hang(situation, wall, along, z, why=why, cost=IN_LINE, size=None if size[1] == y else size)
            yield idea


def _places(situation: Situation, edges: list[float], share: int) -> list[tuple[float, float]]:
    """Where along a stretch the target may hang: its share of it from either end, or its own width there [m]."""
    start, end = edges[0], edges[-1]
    sizes = situation.observation.sizes
    if sizes is None or any(situation.target.size):
        wide = situation.size[1] + BETWEEN
        return [(low, low + wide) for low in edges if low + wide <= end + BETWEEN]
    most, least = sizes[1][1], max(NARROW, sizes[0][1])
    share = max(share, -int(-(end - start) // most))
    wanted = (end - start) / share
    inner = edges[1:-1]
    upto = min([end, *inner], key=lambda edge: abs(edge - start - wanted))
    down = min([start, *inner], key=lambda edge: abs(end - edge - wanted))
    found = [(start, upto), (down, end)] if share > 1 else [(start, end)]
    return [(low, high) for low, high in found if least <= high - low - BETWEEN <= most]


def _run(situation: Situation) -> list[Placement]:
    """What stands in runs of kitchens."""
    run = [p for p in situation.solid if facts_of(p.category).is_in("built_in_line") and p.position[2] < 0.1]
    tops = [p for p in run if facts_of(p.category).is_in("takes_built_in")]
    return [p for p in run if any(facts_of(p.category).runs_with(facts_of(t.category)) for t in tops)]


def _stretches(situation: Situation, number: int, wall: Wall, run: list[Placement], z: float) -> Iterator[list[float]]:
    """The edges of the units under each stretch of a wall that is free over a run [m]."""
    units = sorted(_units(situation, wall, run))
    blocked = [*_blocked(situation, number, wall, z)]
    line: list[float] = []
    for unit in units:
        for low, high in _cut(unit, blocked):
            if line and low - line[-1] <= JOINT:
                line[-1] = min(line[-1], low) if len(line) > 1 else line[-1]
                line.append(high)
                continue
            yield from _long_enough(line)
            line = [low, high]
    yield from _long_enough(line)


def _long_enough(line: list[float]) -> Iterator[list[float]]:
    if len(line) > 1 and line[-1] - line[0] >= NARROW:
        yield line


def _cut(unit: _Unit, blocked: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """What is left of a unit's width between what is in the way."""
    pieces = [(unit.low, unit.high)] if unit.open else []
    for a, b in blocked:
        pieces = [
            piece
            for low, high in pieces
            for piece in ((low, min(high, a)), (max(low, b), high))
            if piece[1] - piece[0] > BETWEEN
        ]
    return pieces


def _units(situation: Situation, wall: Wall, run: list[Placement]) -> Iterator[_Unit]:
    """The units along a wall; one that fills its corner is along both walls of that."""
    for p in run:
        along, out = wall.coordinates((p.position[0], p.position[1]))
        corner = facts_of(p.category).is_in("fills_corner")
        depth = p.size[0] if turn_between(p.yaw, wall.yaw) < 1.0 else p.size[1]
        behind = turn_between(p.yaw, wall.yaw) < 1.0 or (corner and turn_between(p.yaw - 90.0, wall.yaw) < 1.0)
        if not behind or abs(out - depth / 2 - WALL_GAP) > JOINT or not 0.0 < along < wall.length:
            continue
        half = (p.size[1] if turn_between(p.yaw, wall.yaw) < 1.0 else p.size[0]) / 2
        low, high = along - half, along + half
        if corner:
            first = turn_between(p.yaw, wall.yaw) >= 1.0
            yield _Unit(low, wall.length - 0.01 if first else high, first)
        else:
            yield _Unit(low, high, not (_is_hot(situation, p) or p.size[2] > TALL))


def _is_hot(situation: Situation, unit: Placement) -> bool:
    """Whether one cooks on it, or will."""
    targets = situation.observation.plan.targets
    later = (t.category for t in targets if any(carries(tie) and unit.id in tie.anchors for tie in t.ties))
    placed = (p.category for p in situation.scene.resting_on(unit.id))
    return any(facts_of(category).is_in("clear_above") for category in (unit.category, *placed, *later))


def _blocked(situation: Situation, number: int, wall: Wall, z: float) -> Iterator[tuple[float, float]]:
    """What is in the way on a wall: windows, and what hangs there at that height or stands before it."""
    for o in situation.room.openings:
        if o.wall == number and o.sill + o.height > z:
            yield o.offset - BY_WINDOW, o.offset + o.width + BY_WINDOW
    for p in situation.solid:
        if p.top <= z or p.position[2] >= z + situation.size[2]:
            continue
        seen = [wall.coordinates((float(x), float(y))) for x, y in p.footprint.exterior.coords]
        if min(y for _, y in seen) < situation.size[0] + FLAT:
            aside = DOOR_ROOM if min(y for _, y in seen) > FLAT else 0.0
            yield min(x for x, _ in seen) - aside, max(x for x, _ in seen) + aside
