"""What comes along with something small: laid before a seat, beside a plate, or else on what it comes with."""

from functools import lru_cache

from thinkblox.assets import facts_of
from thinkblox.editing.work import Work
from thinkblox.knowledge.dressing import dressing
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import read_usual


def is_laid_before(work: Work, category: str, seat: str) -> bool:
    """Whether what comes along with a seat lies before it on its table, as a plate does, and not on the seat itself."""
    own = work.scene[seat].category
    small = facts_of(own).is_in("seating") and facts_of(category).is_in("small")
    habits = [habit for habit in load_habits().of(category) if habit.kind == "on"]
    return small and not any(own in habit.anchors for habit in habits)


def is_set_beside(work: Work, category: str, head: str) -> bool:
    """Whether what comes along with something on a top stands beside it there, as a glass beside a plate does."""
    return work.scene[head].support in work.scene and frozenset((category, work.scene[head].category)) in _settings()


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
