"""Rows of things that look the same way: the front row, the last, the second."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from thinkblox.assets import facts_of
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene

MIDDLE_ROW = 1000
"""The number of the middle row, of which there is one where the rows are an odd number."""
STEP = 0.35
"""Least distance between two rows, from middle to middle [m]."""
STRAY = 1.25
"""From how many times the distance between the rows a single thing is in none of them."""
SAME_WAY = 20.0
"""How far the gazes of things of one row may differ [degrees]."""


def looks_to(scene: Scene, placement: Placement) -> float:
    """Where one looks who uses a thing, or what it rests on: the lamp on a desk is in the row of the desk [degrees]."""
    carriers = scene.carriers(placement.id)
    return things(scene, carriers[-1] if carriers else placement.id)[0].gaze


def rows_of(scene: Scene, found: Sequence[Placement]) -> list[list[Placement]]:
    """The rows that things form across the way that they look, the front one first.

    What looks another way than most of them belongs to none.
    """
    gazes = {p.id: looks_to(scene, p) for p in found}
    same = {p.id: [q for q in found if turn_between(gazes[p.id], gazes[q.id]) <= SAME_WAY] for p in found}
    alike = max(same.values(), key=len, default=[])
    if not alike:
        return []
    way = math.radians(gazes[alike[0].id])
    ahead = {p.id: p.position[0] * math.cos(way) + p.position[1] * math.sin(way) for p in alike}
    rows: list[list[Placement]] = []
    for placement in sorted(alike, key=lambda p: -ahead[p.id]):
        if rows and ahead[rows[-1][-1].id] - ahead[placement.id] < STEP:
            rows[-1].append(placement)
        else:
            rows.append([placement])
    rows = _without_strays([ahead[row[0].id] for row in rows], rows)
    return [sorted(row, key=lambda p: p.position[0] * math.sin(way) - p.position[1] * math.cos(way)) for row in rows]


def _without_strays(ahead: Sequence[float], rows: Sequence[list[Placement]]) -> list[list[Placement]]:
    """Rows without a single thing before or behind them all that stands further off than they do from each other."""
    left = list(zip(ahead, rows, strict=True))
    for end, nearest in ((0, 1), (-1, -2)):
        if len(left) < 3 or len(left[end][1]) > 1:
            continue
        rest = [row for row in left if row is not left[end]]
        between = max(one[0] - other[0] for one, other in pairwise(rest))
        if abs(left[end][0] - left[nearest][0]) > STRAY * between and max(len(row) for _, row in rest) > 1:
            left = rest
    return [row for _, row in left]


def rows_of_all(scene: Scene) -> list[list[Placement]]:
    """The rows of the room: of desks and tables with the seats drawn up to them, else of seats, else of what does."""
    standing = [p for p in scene.placements if p.support == "floor" and scene.asset_of(p).collides]
    tables = [p for p in standing if facts_of(p.category).is_in("tables", "desks", "counters")]
    seats = [p for p in standing if facts_of(p.category).is_in("seating")]
    others = [p for p in standing if p not in tables and p not in seats]
    for found in (tables, seats, others):
        rows = rows_of(scene, found)
        if len(rows) > 1 and max(map(len, rows)) > 1:
            rows = [row for row in rows if len(row) > 1]
            return [[*row, *_seats_at(scene, row, seats if found is tables else ())] for row in rows]
    return []


def _seats_at(scene: Scene, row: Sequence[Placement], seats: Sequence[Placement]) -> list[Placement]:
    return [seat for seat in seats if any(measure(scene, "at", seat.id, (p.id,)).holds for p in row)]


def row_of(scene: Scene, found: Sequence[Placement], noun: Noun, member: int = 0) -> list[Placement]:
    """The row that a phrase means, by its number from the front; or one of it, by its number from the left or its side.

    Left is that of somebody who looks to the front.

    Args:
        scene: the room.
        found: what forms the rows; everything that does where the phrase names no kind.
        noun: says which row, and which of it by a side.
        member: which of the row, -1 for the last; 0 where nothing is said.

    Raises:
        InputError: the things form no such row, or it is not said which.
    """
    if {"column", "columns", "file"} & {*noun.text.lower().split()}:
        raise InputError(f"'{noun.text}': only rows are told, from the front to the back; name the things by id")
    rows = rows_of(scene, found) if found else rows_of_all(scene)
    if len(rows) < 2:
        names = f"{', '.join(p.id for p in found)} do" if found else "the things of the room do"
        raise InputError(f"'{noun.text}': {names} not stand in rows")
    if _is_every(noun):
        return [placement for row in rows for placement in row]
    noun = _told(noun, len(rows))
    if noun.ordinal == MIDDLE_ROW and len(rows) % 2 == 0:
        raise InputError(f"'{noun.text}': there are {len(rows)} rows; none is in the middle")
    number = noun.ordinal - 1 if noun.ordinal > 0 else len(rows) - 1
    number = len(rows) // 2 if noun.ordinal == MIDDLE_ROW else number
    if number >= len(rows):
        raise InputError(f"'{noun.text}': there are only {len(rows)} rows")
    several = max(noun.count or 1, noun.rows)
    if several > 1 and not member and not noun.side:
        first = number if noun.ordinal > 0 else max(0, len(rows) - several)
        return [placement for row in rows[first : first + several] for placement in row]
    row = rows[number]
    if not member and not noun.side:
        return row
    at = {"left": 0, "right": len(row) - 1, "middle": (len(row) - 1) // 2}.get(
        noun.side, -1 if member < 0 else member - 1
    )
    if at >= len(row) or (noun.side == "middle" and len(row) % 2 == 0):
        says = "none is in the middle" if noun.side == "middle" else "it has no such place"
        raise InputError(f"'{noun.text}': that row holds {', '.join(p.id for p in row)}; {says}")
    return [row[at]]


def _is_every(noun: Noun) -> bool:
    """Whether it is "the rows", all of them."""
    return noun.rows < 0 and not noun.ordinal and noun.side != "middle" and noun.det in ("the", "all", "both")


def _told(noun: Noun, count: int) -> Noun:
    """The phrase with the number of its row: "the middle row" has one too.

    Raises:
        InputError: it is not said which.
    """
    if not noun.ordinal and noun.side == "middle":
        return replace(noun, ordinal=MIDDLE_ROW, side="", rows=1)
    if not noun.ordinal:
        raise InputError(f"'{noun.text}': there are {count} rows; say which, such as 'the first row of'")
    return noun
