"""Prompts for demonstrations: rooms of all our types, of many sizes, in many moods, with things that people name."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from thinkblox.assets import CATALOGUE
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, room_types

MOODS = (
    "cosy", "bright", "small", "spacious", "modern", "simple", "rustic", "quiet", "tidy", "elegant", "sunny", "plain",
)  # fmt: skip
_NUMBERS = ("a", "two", "three", "four")
_SIDES = (3.0, 6.5)
"""Sides of the rooms whose size is said [m]."""


def sample_prompt(rng: np.random.Generator) -> str:
    """A prompt: a type of room, sometimes a mood, a size, and up to eight kinds of things that are named."""
    mood = f"{_one(rng, MOODS)} " if rng.random() < 0.4 else ""
    room = _one(rng, _rooms()).replace("_", " ")
    size = ""
    if rng.random() < 0.5:
        width, depth = (round(rng.uniform(*_SIDES) * 2) / 2 for _ in range(2))
        size = f", {width:g} m by {depth:g} m"
    named = [_named(rng) for _ in range(int(rng.choice([0, 0, 2, 3, 4, 6, 8])))]
    things = f" with {' and '.join([', '.join(named[:-1]), named[-1]] if named[1:] else named)}" if named else ""
    article = "An" if (mood + room)[0] in "aeiou" else "A"
    return f"{article} {mood}{room}{size}{',' if size and things else ''}{things}."


def _named(rng: np.random.Generator) -> str:
    category = CATALOGUE[_one(rng, _things())]
    count = int(rng.choice([1, 1, 1, 2, 3, 4]))
    if count > 1 and category.noun[-1] not in "sxyfhz":
        return f"{_NUMBERS[count - 1]} {category.noun}s"
    return f"{'an' if category.noun[0] in 'aeiou' else 'a'} {category.noun}"


def _one(rng: np.random.Generator, names: Sequence[str]) -> str:
    return names[int(rng.integers(len(names)))]


@lru_cache
def _rooms() -> tuple[str, ...]:
    return tuple(name for name in sorted(room_types()) if name != UNKNOWN_ROOM)


@lru_cache
def _things() -> tuple[str, ...]:
    """Things of some size and a shape of their own, that a room can have more than one of."""
    return tuple(name for name, kind in sorted(CATALOGUE.items()) if not kind.plain and max(kind.size) >= 0.25)
