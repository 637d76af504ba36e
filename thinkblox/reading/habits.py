"""Where things usually stand, read from habits.toml: used to attach words to each other and to fill in a plan."""

import tomllib
from collections.abc import Collection
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import cast

from thinkblox.brief import RelationKind


@dataclass(frozen=True, slots=True)
class Habit:
    """A usual relation to any of `anchors`: categories, or one place of the room; where there is a `company`."""

    kind: RelationKind
    anchors: tuple[str, ...]
    company: str = ""


@dataclass(frozen=True, slots=True)
class Habits:
    """Groups of categories, and the habits of each category in order of preference."""

    groups: dict[str, tuple[str, ...]]
    habits: dict[str, tuple[Habit, ...]]

    def of(self, category: str) -> tuple[Habit, ...]:
        """The habits of a category; none for one that may stand anywhere."""
        return self.habits.get(category, ())

    def group(self, name: str) -> tuple[str, ...]:
        """The categories of a group."""
        return self.groups[name]

    def is_in(self, category: str, *names: str) -> bool:
        """Whether a category belongs to one of these groups."""
        return any(category in self.groups[name] for name in names)

    def tie(self, category: str, anchor: str) -> RelationKind | None:
        """How `category` usually relates to `anchor`; None when they have nothing to do with each other."""
        for habit in self.of(category):
            if anchor in habit.anchors:
                return habit.kind
        return None

    def known(self) -> Collection[str]:
        """Every category that has an entry."""
        return self.habits.keys()


@lru_cache(maxsize=1)
def load_habits() -> Habits:
    """The table of habits.toml."""
    data = tomllib.loads(Path(__file__).with_name("habits.toml").read_text(encoding="utf-8"))
    groups = {name: tuple(members.split()) for name, members in data["groups"].items()}
    habits = {category: tuple(_habit(line, groups) for line in lines) for category, lines in data["habits"].items()}
    return Habits(groups, habits)


def _habit(line: str, groups: dict[str, tuple[str, ...]]) -> Habit:
    line, _, company = line.partition(" if ")
    kind, _, anchor = line.partition(" ")
    anchors = groups[anchor[1:]] if anchor.startswith("@") else (anchor,) if anchor else ()
    return Habit(cast(RelationKind, kind), anchors, company)
