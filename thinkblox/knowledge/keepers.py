"""What things are kept in, and the words for a place where they are."""

import tomllib
from functools import lru_cache
from pathlib import Path

import msgspec

from thinkblox.value import Value


class Keepers(Value, frozen=True, kw_only=True):
    """What is known of where things are kept.

    Attributes:
        spots: what a place is called where something is kept, separated by commas.
        ways: how it is said what that is for.
        keepers: the category of what each category is kept in.
    """

    spots: str
    ways: str
    keepers: dict[str, str]


@lru_cache(maxsize=1)
def load_keepers() -> Keepers:
    """What is known of where things are kept."""
    text = Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    return msgspec.convert(tomllib.loads(text), Keepers)


@lru_cache(maxsize=1)
def keeping_openings() -> dict[str, frozenset[tuple[str, ...]]]:
    """The words before what is kept ("place for", "somewhere to hang"): what may follow the first of them."""
    known = load_keepers()
    ways = frozenset(tuple(way.split()) for way in known.ways.split(", "))
    return dict.fromkeys(known.spots.split(", "), ways)
