"""What comes along with something small: laid before a seat, beside a plate, or else on what it comes with."""

from dataclasses import replace
from functools import lru_cache

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.editing.work import Work
from thinkblox.knowledge.dressing import dressing
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import read_usual
from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene


def is_laid_before(work: Work, category: str, seat: str) -> bool:
    """Whether what comes along with a seat lies before it on its table, as a plate does, and not on the seat itself."""
    own = work.scene[seat].category
    small = facts_of(own).is_in("seating") and facts_of(category).is_in("small")
    tables = [p.id for p in work.scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    small &= any(measure(work.scene, "at", seat, (table,)).holds for table in tables)
    habits = [habit for habit in load_habits().of(category) if habit.kind == "on"]
    return small and not any(own in habit.anchors for habit in habits)


def is_set_beside(work: Work, category: str, head: str) -> bool:
    """Whether what comes along with something on a top stands beside it there, as a glass beside a plate does."""
    return work.scene[head].support in work.scene and frozenset((category, work.scene[head].category)) in _settings()


def so_many(work: Work, noun: Noun, head: str, *, several: bool) -> Noun:
    """How many come along with each of several things where nobody says it: one, or as many as such tables have."""
    if not noun.plural or noun.count:
        return noun
    category = work.scene[head].category
    if are_seats_around(work, noun, head):
        tables = [p.id for p in work.start.placements if p.category == category]
        seats = max((_seats_at(work.start, id) for id in tables), default=0)
        return replace(noun, count=seats) if seats > 1 else noun
    return replace(noun, count=1, plural=False) if several else noun


def seat_like(work: Work, noun: Noun, head: str) -> Noun:
    """The chair that comes along with a desk or table as those are that stand at all others of its kind."""
    if noun.value != "chair" or noun.attributes or not facts_of(work.scene[head].category).is_in("desks", "tables"):
        return noun
    others = [p.id for p in work.start.placements if p.category == work.scene[head].category]
    seats = [p for p in work.start.placements if facts_of(p.category).is_in("seating")]
    kinds = {p.category for p in seats for id in others if measure(work.start, "at", p.id, (id,)).holds}
    return replace(noun, value=kinds.pop()) if len(kinds) == 1 else noun


def _seats_at(scene: Scene, table: str) -> int:
    """How many seats are drawn up to a table."""
    seats = [p.id for p in scene.placements if facts_of(p.category).is_in("seating")]
    return sum(measure(scene, "at", seat, (table,)).holds for seat in seats)


def are_seats_around(work: Work, noun: Noun, table: str) -> bool:
    """Whether several seats come along with a table, which stand at all its sides and not side by side."""
    several = noun.plural or (noun.count or 1) > 1
    return several and facts_of(noun.value).is_in("seating") and facts_of(work.scene[table].category).is_in("tables")


def settings_on(work: Work, category: str, table: str, count: int) -> list[tuple[RelationKind, str]]:
    """Where each of so many things of which everybody has one lies on a table; empty where they lie anywhere on it.

    Each lies beside what it belongs to, where so many are there already, as a glass beside each plate, or else before
    a seat.
    """
    scene = work.scene
    if count < 2 or not any(category in pair for pair in _settings()):
        return []
    there = [p for p in scene.placements if p.support == table]
    for kind in dict.fromkeys(p.category for p in there if frozenset((category, p.category)) in _settings()):
        beside = [p.id for p in there if p.category == kind]
        if len(beside) == count and kind != category:
            return [("next_to", id) for id in beside]
    seats = [p.id for p in scene.placements if facts_of(p.category).is_in("seating")]
    seats = [id for id in seats if measure(scene, "at", id, (table,)).holds]
    free = [id for id in seats if not any(measure(scene, "in_front_of", p.id, (id,)).holds for p in there
                                          if p.category == category)]  # fmt: skip
    return [("in_front_of", id) for id in free[:count]] if len(free) >= count else []


@lru_cache(maxsize=1)
def _settings() -> frozenset[frozenset[str]]:
    """The pairs of things of which as many lie on a table: one of each for everybody who sits there."""
    pairs: set[frozenset[str]] = set()
    for tops in dressing().tops:
        several = [usual for usual in read_usual(tops.things) if usual.count > 1]
        seated = any(facts_of(name).is_in("tables") for name in tops.on.split(", "))
        for one in several if seated else ():
            pairs |= {frozenset((one.category, u.category)) for u in several if u is not one and u.count == one.count}
    return frozenset(pairs)
