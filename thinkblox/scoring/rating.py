"""What a guideline makes of a room: a score, the numbers behind it and the worst case in words."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple


class Rating(NamedTuple):
    """A score from 0 to 1, or None where there is nothing to rate; the numbers that made it; and the worst case."""

    score: float | None
    numbers: Mapping[str, float]
    worst: str = ""


class Case(NamedTuple):
    """One thing that a guideline speaks of: its score from 0 to 1, and what was measured of it in words."""

    score: float
    says: str


def rated(cases: Sequence[Case], **numbers: float) -> Rating:
    """The mean over some cases."""
    if not cases:
        return Rating(None, {**numbers, "things": 0.0})
    worst = min(cases, key=lambda case: case.score)
    mean = sum(case.score for case in cases) / len(cases)
    return Rating(
        mean,
        {**numbers, "things": float(len(cases)), "good": float(sum(case.score > _GOOD for case in cases))},
        worst.says if worst.score <= _GOOD else "",
    )


def plateau(value: float, zero: float, low: float, high: float, end: float) -> float:
    """1 from `low` to `high`, falling linearly to 0 at `zero` below and at `end` above."""
    if value < low:
        return max(0.0, (value - zero) / (low - zero))
    return 1.0 if value <= high else max(0.0, (end - value) / (end - high))


_GOOD = 0.9
"""A case above this is as the guideline wants it."""
