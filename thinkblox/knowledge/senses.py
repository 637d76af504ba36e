"""What a word can mean besides itself, and under which conditions: a "lamp" on a nightstand is a table lamp."""

from functools import lru_cache
from typing import NamedTuple

from thinkblox.assets import revision
from thinkblox.knowledge.things import things


class Sense(NamedTuple):
    """A category that a word means where all conditions hold: "many", "few", or "<fact>:<value>|<value>"."""

    category: str
    conditions: tuple[str, ...]


def senses_of(noun: str) -> tuple[Sense, ...]:
    """What a noun can mean, the first that holds before the others; none where it means itself."""
    return _senses(revision()).get(noun, ())


@lru_cache(maxsize=1)
def _senses(revision: int) -> dict[str, tuple[Sense, ...]]:
    return {noun: tuple(_sense(line) for line in kind.senses) for noun, kind in things().items() if kind.senses}


def _sense(line: str) -> Sense:
    category, _, conditions = line.partition(" if ")
    return Sense(category, tuple(conditions.split()))
