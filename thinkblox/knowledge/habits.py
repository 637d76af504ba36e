"""Where things usually stand, as their categories say: used to attach words to each other and to fill in a plan."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import lru_cache
from operator import itemgetter
from typing import cast, get_args

from thinkblox.assets import Facts, facts_of, revision
from thinkblox.assets.groups import GROUPS
from thinkblox.brief import Place, RelationKind
from thinkblox.knowledge.things import things

_PLACES = frozenset(get_args(Place))


@dataclass(frozen=True, slots=True)
class Habit:
    """A usual relation to any of `anchors`: categories, or one place of the room; where there is a `company`."""

    kind: RelationKind
    anchors: tuple[str, ...]
    company: str = ""


@dataclass(frozen=True, slots=True)
class Habits:
    """Groups of categories, in order and as sets, and the habits of each category in order of preference."""

    groups: dict[str, tuple[str, ...]]
    habits: dict[str, tuple[Habit, ...]]
    members: dict[str, frozenset[str]]

    def of(self, category: str) -> tuple[Habit, ...]:
        """The habits of a category; none for one that may stand anywhere."""
        if category in self.habits or category in _PLACES:
            return self.habits.get(category, ())
        return tuple(_habit(line, self.groups) for line in facts_of(category).habits)

    def group(self, name: str) -> tuple[str, ...]:
        """The categories of a group."""
        return self.groups[name]

    def is_in(self, category: str, *names: str) -> bool:
        """Whether a category belongs to one of these groups."""
        if category in self.habits or category in _PLACES:
            for name in names:  # noqa: SIM110 - a generator costs thrice as much, and this is asked thousands of times
                if category in self.members[name]:
                    return True
            return False
        return facts_of(category).is_in(*names)

    def tie(self, category: str, anchor: str) -> RelationKind | None:
        """How `category` usually relates to `anchor`; None when they have nothing to do with each other."""
        for habit in self.of(category):
            if anchor in habit.anchors:
                return habit.kind
        return None

    def is_served_on(self, category: str, anchor: str) -> bool:
        """Whether what is at such a counter is on it: it never stands on the floor."""
        return {habit.kind for habit in self.of(category)} == {"on"} and self.is_in(anchor, "served_over")

    def known(self) -> Collection[str]:
        """Every category that has an entry."""
        return self.habits.keys()


def load_habits() -> Habits:
    """The groups and habits of everything that a noun can name, as the catalogue is now."""
    return _collected(revision())


@lru_cache(maxsize=1)
def _collected(revision: int) -> Habits:
    known = things()
    groups = _groups(known)
    read: dict[str, Habit] = {}
    for line in {line for kind in known.values() for line in kind.habits}:
        read[line] = _habit(line, groups)
    habits = {name: tuple(read[line] for line in kind.habits) for name, kind in known.items()}
    return Habits(groups, habits, {name: frozenset(group) for name, group in groups.items()})


def _groups(known: Mapping[str, Facts]) -> dict[str, tuple[str, ...]]:
    """The members of every group in their places, those without one last."""
    members: dict[str, list[tuple[int, str]]] = {group: [] for group in GROUPS}
    for name, kind in known.items():
        for group, place in kind.places.items():
            members[group].append((place, name))
    return {group: tuple(name for _, name in sorted(found, key=itemgetter(0))) for group, found in members.items()}


def _habit(line: str, groups: dict[str, tuple[str, ...]]) -> Habit:
    line, _, company = line.partition(" if ")
    kind, _, anchor = line.partition(" ")
    anchors = groups[anchor[1:]] if anchor.startswith("@") else (anchor,) if anchor else ()
    return Habit(cast(RelationKind, kind), anchors, company)
