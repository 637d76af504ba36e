"""How rows can be laid out, wherever they are: directions, distances, and which way each member is turned."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from thinkblox.plan import Tie
from thinkblox.policies.expert.partners import beside_each, gaps_in_row
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.room import turn_between
from thinkblox.value import Vec2

FACE_TO_FACE = (1.8, 1.6, 2.1, 1.4, 1.2)
"""Free distance between two rows that look at each other [m]."""
UNEVEN = 1.5
"""How much dearer a block is of which a corner stays empty, in other ways to share out the rows."""
WITH_SEATS = (1.6, 1.4, 1.2)
"""Free distance between tables that people sit around, each way [m]."""
WIDEST_WITH_SEATS = 2.4
"""How far tables are drawn apart to use a large floor [m]."""
ONE_WAY = 1.2
"""Cost of two rows that are used from the aisle between them, and look the same way."""
BACK_TO_BACK, BETWEEN_BLOCKS = 0.02, (2.0, 1.8)
"""Free distance between desks whose backs are together, and between two blocks of them, with two seats [m]."""
FEWEST_IN_BLOCK, LONGEST_BLOCK = 4, 4
"""From so many on desks stand in blocks, and how many are side by side in one at most, if it can be."""
WAY, NO_WAY = 0.6, 1.5
"""Least free width of the way between neighbours of which only so many form a row [m], and what it costs to have none.

So pews stand on both sides of an aisle.
"""


@dataclass(frozen=True)
class RowLayout:
    """One block of rows about its own middle: per slot the centre [m] and the yaw [degrees]."""

    slots: tuple[Vec2, ...]
    yaws: tuple[float, ...]
    cost: float


@dataclass(frozen=True)
class _Spacing:
    beside: float
    aisle: float
    cost: float


def layouts(situation: Situation, tie: Tie, *, facing: tuple[str, ...], mutual: bool) -> Iterator[RowLayout]:
    """Every way to lay out the members of a request in rows."""
    if is_in_blocks(situation) and not facing and not mutual and not tie.asked:
        yield from _in_blocks(situation, tie.count)
        return
    for rank, rows in enumerate((tie.rows,) if gaps_in_row(situation) and tie.rows else _row_counts(tie)):
        columns = -(-tie.count // rows)
        dear = rank + UNEVEN * bool(tie.count % rows)
        for yaw in _directions(situation, facing, mutual=mutual):
            for spacing in _spacings(situation, rows, columns, yaw, mutual=mutual):
                dearer = replace(spacing, cost=spacing.cost + 0.4 * dear)
                aisle = rows == 2 and not facing and situation.facts.is_in("from_aisles")
                one_way = replace(dearer, cost=dearer.cost + ONE_WAY) if aisle and not mutual else dearer
                yield _layout(situation, tie.count, columns, yaw, one_way, inward=mutual, away=bool(facing))
                if aisle:
                    yield _layout(situation, tie.count, columns, yaw, dearer, inward=True, away=False)


def is_in_blocks(situation: Situation) -> bool:
    """Whether the target is one of so many desks that they stand in blocks amid the room."""
    return situation.facts.is_in("in_blocks") and situation.target.count >= FEWEST_IN_BLOCK


def _in_blocks(situation: Situation, count: int) -> Iterator[RowLayout]:
    """Rows in pairs, back to back: who works at one of them looks at who works at the other."""
    depth, width, _ = situation.size
    beside = BACK_TO_BACK
    for rows in range(2, count, 2):
        columns = -(-count // rows)
        if columns * (rows - 1) >= count:
            break
        dear = UNEVEN * 0.4 * bool(count % rows) + 0.4 * abs(rows - _blocks_for(count))
        for rank, aisle in enumerate(BETWEEN_BLOCKS if rows > 2 else BETWEEN_BLOCKS[:1]):
            for yaw in (0.0, 90.0):
                pitches = [
                    row // 2 * (2 * depth + BACK_TO_BACK + aisle) + row % 2 * (depth + BACK_TO_BACK)
                    for row in range(rows)
                ]
                yield _turned(pitches, columns, count, width + beside, yaw, 0.1 * rank + dear)


def _blocks_for(count: int) -> int:
    """In how many rows so many desks stand, two to a block."""
    return 2 * -(-count // (2 * LONGEST_BLOCK))


def _turned(outs: list[float], columns: int, count: int, pitch: float, yaw: float, cost: float) -> RowLayout:
    """Slots in rows so far out from the first, every second row turned round."""
    angle = math.radians(yaw)
    (ux, uy), (vx, vy) = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    slots, yaws = [], []
    for number in range(count):
        row, column = divmod(number, columns)
        u, v = outs[-1] / 2 - outs[row], ((columns - 1) / 2 - column) * pitch
        slots.append((ux * u + vx * v, uy * u + vy * v))
        yaws.append((yaw + 180.0 * (row % 2)) % 360.0)
    return RowLayout(tuple(slots), tuple(yaws), cost)


def _row_counts(tie: Tie) -> tuple[int, ...]:
    """How many rows, as asked for; where nobody asked, nearly square as well."""
    square = max(1, round(math.sqrt(tie.count)))
    usual = tie.rows or max(1, round(math.sqrt(tie.count / 2)))
    return (usual,) if (tie.asked and tie.rows) or square == usual else (usual, square)


def _directions(situation: Situation, facing: tuple[str, ...], *, mutual: bool) -> tuple[float, ...]:
    anchors = situation.placed(facing)
    if anchors:
        away = situation.asset.gaze == "back"
        towards = (anchors[0].yaw + (0.0 if away else 180.0)) % 360.0
        along_walls = min((wall.yaw for wall in situation.room.walls), key=lambda yaw: turn_between(yaw, towards))
        return (along_walls,)
    return (0.0, 90.0) if mutual or situation.asset.front != "one" else (0.0, 90.0, 180.0, 270.0)


def _spacings(situation: Situation, rows: int, columns: int, yaw: float, *, mutual: bool) -> Iterator[_Spacing]:
    """Free distances to the neighbour in the row and to the next row."""
    extent = situation.room.extent if yaw % 180.0 == 0.0 else situation.room.extent[::-1]
    even_aisle = _even(extent[0], rows, situation.size[0])
    if any(
        tie.kind in ("around", "at_long_side", "at_short_side")
        for follower in situation.followers
        for tie in follower.ties
    ):
        even = _even(extent[1], columns, situation.size[1])
        ways = [tuple(min(max(gap, WITH_SEATS[-1]), WIDEST_WITH_SEATS) for gap in (even, even_aisle))]
        ways += [(gap, gap) for gap in WITH_SEATS]
        yield from (_Spacing(beside, aisle, 0.15 * rank) for rank, (beside, aisle) in enumerate(ways))
        return
    aisles = FACE_TO_FACE if mutual else situation.facts.row.aisle
    costs = {aisle: 0.1 * rank for rank, aisle in enumerate(aisles if rows > 1 else aisles[:1])}
    if situation.facts.is_in("from_aisles") and rows > 1 and even_aisle > aisles[0]:
        costs |= {round(aisles[0] + (even_aisle - aisles[0]) * k / 3, 2): 0.05 * k for k in (1, 2, 3, 4)}
    least = beside_each(situation)
    usual = dict.fromkeys(max(gap, least) for gap in situation.facts.row.beside)
    for order, beside in enumerate(gaps_in_row(situation) or usual):
        dear = 0.1 * order + NO_WAY * (situation.facts.row.abreast > 1 and beside < WAY)
        yield from (_Spacing(beside, aisle, cost + dear) for aisle, cost in costs.items())


def _even(length: float, count: int, size: float) -> float:
    """The gap that spreads `count` things over a length, with half a gap at its ends [m]."""
    return (length - count * size) / count


def _layout(
    situation: Situation, count: int, columns: int, yaw: float, spacing: _Spacing, *, inward: bool, away: bool
) -> RowLayout:
    """Rows one behind the other, the first ahead; `inward`: every other row is turned to the one before it."""
    depth, width = situation.size[0], situation.size[1]
    rows = -(-count // columns)
    front_first = -1.0 if away and situation.asset.gaze == "back" else 1.0
    angle = math.radians(yaw)
    (ux, uy), (vx, vy) = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    slots, yaws = [], []
    for number in range(count):
        row, column = divmod(number, columns)
        u = ((rows - 1) / 2 - row) * (depth + spacing.aisle) * front_first
        v = ((columns - 1) / 2 - column) * (width + spacing.beside)
        slots.append((ux * u + vx * v, uy * u + vy * v))
        yaws.append((yaw + (180.0 if inward and row % 2 == 0 else 0.0)) % 360.0)
    return RowLayout(tuple(slots), tuple(yaws), spacing.cost)
