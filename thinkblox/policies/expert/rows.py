"""Ideas for things that stand in rows: the whole block is laid out, then each member takes its place in it."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from thinkblox.phrases import Constraint
from thinkblox.places import WORKED_AT
from thinkblox.plan import Tie
from thinkblox.policies.expert.idea import Idea, turned
from thinkblox.policies.expert.situation import Situation
from thinkblox.rects import Rects, outside, overlap_depth
from thinkblox.value import Vec2

BESIDE = {"school_desk": (0.7, 0.5, 0.35), "desk": (0.8, 0.5), "bookcase": (0.005,)}
"""Free distance between neighbours in a row, the best first [m]."""
AISLE = {"school_desk": (0.9, 0.75), "bookcase": (1.2, 1.05, 0.95), "shelving_unit": (1.2, 1.0), "chair": (0.9, 0.6)}
"""Free distance from row to row, the best first [m]."""
FACE_TO_FACE = (1.8, 1.6, 2.1, 1.4, 1.2)
"""Free distance between two rows that look at each other [m]."""
WITH_SEATS = (1.6, 1.4, 1.2)
"""Free distance between tables that people sit around, each way [m]."""
FIRST_ROW = 2.0
"""Free distance from a board to the first row that looks at it [m]."""


@dataclass(frozen=True)
class _Block:
    """Rows of one kind: per slot its centre and yaw; cost of the layout as such."""

    slots: tuple[tuple[Vec2, float], ...]
    cost: float


def in_rows(situation: Situation, tie: Tie, *, facing: tuple[str, ...], mutual: bool) -> Iterator[Idea]:
    """Every block of rows that fits; from each, the next free slot.

    Args:
        situation: the decision.
        tie: its "in_rows" tie.
        facing: ids that the rows look at, when they look at something.
        mutual: two rows look at each other.
    """
    blocks = list(_blocks(situation, tie, facing=facing, mutual=mutual))
    costs = _fit(situation, blocks)
    order = sorted(range(len(blocks)), key=lambda i: costs[i])[:12]
    for i in order:
        slot = _free_slot(situation, blocks[i])
        if slot is None:
            continue
        (x, y), yaw = slot
        words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
        why = f"it is number {tie.index + 1} of {tie.count} in rows"
        yield Idea((x, y, 0.0), yaw, words, why, costs[i])


def _free_slot(situation: Situation, block: _Block) -> tuple[Vec2, float] | None:
    taken = [p.position[:2] for p in situation.siblings]
    for centre, yaw in block.slots:
        if all(math.dist(centre, t) > 0.15 for t in taken):
            return centre, yaw
    return None


def _fit(situation: Situation, blocks: list[_Block]) -> list[float]:
    """Cost of each block: how much of it is outside or occupied, and how far it is from the placed members."""
    if not blocks:
        return []
    size, top = situation.size, situation.size[2]
    rows = [(c, (size[0], size[1]), yaw, 0.0, top) for block in blocks for c, yaw in block.slots]
    rects = Rects.of(rows)
    others = [i for i, p in enumerate(situation.solid) if p not in situation.siblings]
    bad = outside(rects, situation.room.polygon) * 40.0
    bad += overlap_depth(rects, situation.solids.take(others)).sum(-1) * 40.0
    bad += overlap_depth(rects, situation.door_zones).sum(-1) * 20.0
    bad += overlap_depth(rects, situation.clearances).sum(-1) * 4.0
    bad += overlap_depth(rects, situation.reserved).sum(-1) * 4.0
    bad += overlap_depth(rects, situation.promised).sum(-1) * 4.0
    starts = np.cumsum([0, *(len(block.slots) for block in blocks)])
    sums = [float(bad[a:b].sum()) for a, b in pairwise(starts)]
    return [b.cost + s + 10.0 * _strays(situation, b) for b, s in zip(blocks, sums, strict=True)]


def _strays(situation: Situation, block: _Block) -> int:
    """Placed members that have no slot in this block."""
    return sum(all(math.dist(p.position[:2], centre) > 0.1 for centre, _ in block.slots) for p in situation.siblings)


def _blocks(situation: Situation, tie: Tie, *, facing: tuple[str, ...], mutual: bool) -> Iterator[_Block]:
    rows = tie.rows or max(1, round(math.sqrt(tie.count / 2)))
    columns = -(-tie.count // rows)
    for yaw in _directions(situation, facing):
        for beside, aisle in _spacings(situation, mutual=mutual):
            yield from _shifted(situation, rows, columns, yaw, beside, aisle, tie.count, facing, mutual=mutual)


def _spacings(situation: Situation, *, mutual: bool) -> Iterator[tuple[float, float]]:
    """Free distances to the neighbour in the row and to the next row."""
    category = situation.target.category
    if any(tie.kind == "around" for follower in situation.followers for tie in follower.ties):
        yield from ((gap, gap) for gap in WITH_SEATS)
        return
    for beside in BESIDE.get(category, (0.08, 0.03)):
        for aisle in FACE_TO_FACE if mutual else AISLE.get(category, (1.0, 0.8)):
            yield beside, aisle


def _directions(situation: Situation, facing: tuple[str, ...]) -> tuple[float, ...]:
    anchors = situation.placed(facing)
    if not anchors:
        return (0.0, 90.0, 180.0, 270.0)
    away = situation.target.category in WORKED_AT
    return ((anchors[0].yaw + (0.0 if away else 180.0)) % 360.0,)


def _shifted(
    situation: Situation,
    rows: int,
    columns: int,
    yaw: float,
    beside: float,
    aisle: float,
    count: int,
    facing: tuple[str, ...],
    *,
    mutual: bool,
) -> Iterator[_Block]:
    depth, width = situation.size[0], situation.size[1]
    angle = math.radians(yaw)
    (ux, uy), (vx, vy) = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    away = bool(facing) and situation.target.category in WORKED_AT
    local = []
    for number in range(count):
        row, column = divmod(number, columns)
        u = ((rows - 1) / 2 - row) * (depth + aisle) * (-1 if away else 1)
        v = ((columns - 1) / 2 - column) * (width + beside)
        local.append((u, v, yaw + (180.0 if mutual and row % 2 == 0 else 0.0)))
    cx, cy = situation.room.polygon.centroid.coords[0]
    for du in _shifts(situation, 2.4):
        for dv in _shifts(situation, 1.6):
            centre = (cx + ux * du + vx * dv, cy + uy * du + vy * dv)
            slots = tuple(
                ((centre[0] + ux * u + vx * v, centre[1] + uy * u + vy * v), turn % 360.0) for u, v, turn in local
            )
            cost = 0.3 * (abs(du) + abs(dv)) + _first_row_cost(situation, slots[0][0], depth, facing)
            yield _Block(slots, cost)


def _shifts(situation: Situation, reach: float) -> tuple[float, ...]:
    reach = min(reach, max(situation.room.extent) / 3)
    return tuple(reach * k / 4 for k in (0, 1, -1, 2, -2, 3, -3, 4, -4))


def _first_row_cost(situation: Situation, first: Vec2, depth: float, facing: tuple[str, ...]) -> float:
    anchors = situation.placed(facing)
    if not anchors:
        return 0.0
    ahead = anchors[0].to_local(first)[0] - anchors[0].size[0] / 2 - depth / 2
    return 0.6 * abs(ahead - FIRST_ROW)
