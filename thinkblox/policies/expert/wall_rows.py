"""Rows with their backs to a wall, or to two walls across from each other: the beds of a ward."""

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from thinkblox.plan import Tie
from thinkblox.policies.expert.idea import WALL_GAP
from thinkblox.policies.expert.partners import beside_each, gaps_in_row, shared_gaps
from thinkblox.policies.expert.row_layout import is_in_blocks
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.walls import named_walls, oriented
from thinkblox.scene.room import Wall, turn_between
from thinkblox.value import Vec2

WIDEST = 1.6
"""How far neighbours are drawn apart to use a long wall [m]."""
PAIRS = 0.3
"""Free distance between pairs that have something between them, at most [m]."""
PLACES = 13
"""Places tried along a wall."""
ONE_WALL, ASKED_WALL = 0.6, 4.0
"""Cost of one long row where two were meant, or of two where one was: by habit, and along a wall as asked."""
LONG, TOO_LONG = 6, 2.0
"""Members of a row that is not yet long, and the cost of each more where more rows were meant."""
UNEVEN = 1.0
"""Cost of a row that has fewer than the one across the room."""


def belongs_to_wall(situation: Situation) -> bool:
    """Whether such a thing stands with its back to a wall, and nobody sits all around it."""
    habits = (habit for habit in situation.facts.habits if " if " not in habit)
    amid = is_in_blocks(situation) or situation.facts.is_in("islands") or _is_sat_round(situation)
    return not amid and next(habits, "").startswith("against_wall")


def _is_sat_round(situation: Situation) -> bool:
    own = situation.target.id
    return any(
        tie.kind in ("around", "at_long_side") and own in tie.anchors for t in situation.followers for tie in t.ties
    )


def wall_rows(situation: Situation, tie: Tie) -> Iterator[tuple[list[Vec2], list[float], float]]:
    """Centres [m] and yaws [degrees] of all members of a request along walls, and what each way costs."""
    shared = shared_gaps(situation)
    paired = 0 < len(shared) < tie.count - 1
    told = tie.rows and (tie.asked or (shared and not paired))
    along = any(t.kind == "against_wall" and t.asked for t in situation.target.ties)
    for rows in (tie.rows,) if told else (1, 2):
        columns = -(-tie.count // rows)
        columns += columns % 2 if paired else 0
        dear = (ASKED_WALL if along else ONE_WALL) * (rows != tie.rows) + UNEVEN * (tie.count % rows > 0)
        dear += TOO_LONG * max(0, columns - LONG) * (rows < tie.rows)
        counts = [min(columns, tie.count - row * columns) for row in range(rows)]
        for walls in _walls(_told(situation), len(counts)):
            for rank, gap in enumerate(_gaps(situation, walls[0], columns)):
                for share in np.linspace(0.0, 1.0, PLACES):
                    found = _row(situation, walls, counts, gap, float(share))
                    if found is not None:
                        cost = 0.1 * rank + dear + 0.3 * abs(float(share) - 0.5)
                        yield (*found, cost)


def _told(situation: Situation) -> tuple[Wall, ...]:
    """The walls that the target may be against: all where none is named."""
    places = [tie.anchors[0] for tie in situation.target.ties if tie.kind == "against_wall" and tie.anchors]
    return named_walls(situation.room, places[0]) if places else situation.room.walls


def _walls(walls: tuple[Wall, ...], rows: int) -> Iterator[tuple[Wall, ...]]:
    """The walls of one row each: any one, or two that look at each other."""
    if rows == 1:
        yield from ((wall,) for wall in walls)
    elif rows == 2:
        yield from (pair for pair in permutations(walls, 2) if turn_between(pair[0].yaw, pair[1].yaw) > 179.0)


def _gaps(situation: Situation, wall: Wall, columns: int) -> tuple[float, ...]:
    """Free distances to the neighbour, for what stands in line as even as the wall allows; then the usual ones [m]."""
    if between := gaps_in_row(situation):
        return between
    least = beside_each(situation)
    usual = tuple(dict.fromkeys(max(gap, least) for gap in situation.facts.row.beside))
    if not situation.facts.is_in("in_line", "beds"):
        return usual
    _, (_, width) = oriented(situation.size, situation.asset.front)
    even = (wall.length - columns * width) / columns
    return (min(even, max(WIDEST, least)), *usual) if even > usual[0] else usual


def _row(
    situation: Situation, walls: tuple[Wall, ...], counts: list[int], gap: float, share: float
) -> tuple[list[Vec2], list[float]] | None:
    turn, (depth, width) = oriented(situation.size, situation.asset.front)
    shared = shared_gaps(situation)
    close = min(gap, *situation.facts.row.beside, PAIRS) if shared else gap
    apart = [gap if not shared or n in shared else close for n in range(sum(counts))]
    length = counts[0] * width + sum(apart[: counts[0] - 1])
    free = walls[0].length - length - 2 * WALL_GAP
    if free < 0.0:
        return None
    slots: list[Vec2] = []
    yaws: list[float] = []
    for row, (wall, count) in enumerate(zip(walls, counts, strict=True)):
        for column in range(count):
            first = sum(counts[:row])
            along = WALL_GAP + share * free + column * width + sum(apart[first : first + column]) + width / 2
            if row:
                x, y = walls[0].point(along, 0.0)
                along = wall.coordinates((x, y))[0]
            slots.append(wall.point(along, WALL_GAP + depth / 2))
            yaws.append((wall.yaw + turn) % 360.0)
    return slots, yaws
