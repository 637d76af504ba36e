"""Rows of things that look the same way: the front row, the last, the second."""

import math
from collections.abc import Sequence

from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene

STEP = 0.35
"""Least distance between two rows, from middle to middle [m]."""
SAME_WAY = 20.0
"""How far the gazes of things of one row may differ [degrees]."""


def rows_of(scene: Scene, found: Sequence[Placement]) -> list[list[Placement]]:
    """The rows that things form across the way that they look, the front one first.

    What looks another way than most of them belongs to none.
    """
    gazes = {p.id: things(scene, p.id)[0].gaze for p in found}
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
    return rows


def row_of(scene: Scene, found: Sequence[Placement], noun: Noun) -> list[Placement]:
    """The row that a phrase means, by its number from the front.

    Raises:
        InputError: the things form no such row, or it is not said which.
    """
    rows = rows_of(scene, found)
    if len(rows) < 2:
        raise InputError(f"'{noun.text}': {', '.join(p.id for p in found)} do not stand in rows")
    if not noun.ordinal:
        raise InputError(f"'{noun.text}': there are {len(rows)} rows; say which, such as 'the first row of'")
    number = noun.ordinal - 1 if noun.ordinal > 0 else len(rows) - 1
    if number >= len(rows):
        raise InputError(f"'{noun.text}': there are only {len(rows)} rows")
    return rows[number]
