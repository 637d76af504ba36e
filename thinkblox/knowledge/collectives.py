"""What words for things of many kinds mean: appliances, seats, furniture."""

import tomllib
from functools import lru_cache
from pathlib import Path

import msgspec

from thinkblox.knowledge.habits import load_habits
from thinkblox.value import Value


class Collective(Value, frozen=True, kw_only=True):
    """What some words mean; each field is a list with commas between.

    Attributes:
        words: the words, in the singular.
        groups: groups of the catalogue of which they can mean any category.
        things: categories that they can mean besides.
        but: groups of which they mean none.
    """

    words: str
    groups: str = ""
    things: str = ""
    but: str = ""

    def means(self, category: str) -> bool:
        """Whether a category can be meant."""
        habits = load_habits()
        if self.but and habits.is_in(category, *_listed(self.but)):
            return False
        if not (self.groups or self.things):
            return True
        return category in _listed(self.things) or (bool(self.groups) and habits.is_in(category, *_listed(self.groups)))

    def names(self, category: str) -> bool:
        """Whether a category is listed though the word is the end of its name: a washing machine is a machine."""
        return category in _listed(self.things) and category not in _listed(self.words)


def collective(word: str) -> Collective | None:
    """What a word in the singular means, where it is one for things of many kinds."""
    return _collectives().get(word)


@lru_cache(maxsize=1)
def _collectives() -> dict[str, Collective]:
    table = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    rows = msgspec.convert(table["collective"], list[Collective])
    return {word: row for row in rows for word in _listed(row.words)}


@lru_cache(maxsize=256)
def _listed(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(",") if part.strip())
