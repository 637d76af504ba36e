"""What is asked of each thing that is added, as goals that can be measured."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.editing.acting import mark_names, related
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Abreast, Across, Goal, Related, Spot
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.wheres import Bound
from thinkblox.editing.work import Work
from thinkblox.scene.placement import Placement

THERE = 0.75
"""How far from where something was another may stand that comes there [m]."""


def under_each(where: Bound) -> list[Bound]:
    """A place under several things as one under each of them: "(three cushions and a rug) under them"."""
    several = where.kind == "under" and len(where.anchors) > 1
    return [replace(where, anchors=(name,)) for name in where.anchors] if several else [where]


def abreast(goals: list[Goal], order: Order, came: Sequence[str]) -> list[Goal]:
    """What is asked of the second of several side by side, or across from one thing: to look where the first does."""
    related_ = [goal for goal in goals if isinstance(goal, Related) and not goal.negated]
    beside = order.mutual == "next_to" or _stand_in_line(order, goals)
    if not came or not (beside or any(isinstance(goal, Across) for goal in goals)):
        return goals
    looks = [Related("facing", goal.anchors) for goal in related_ if goal.kind in ("opposite", "facing")]
    return [*(goal for goal in goals if goal not in related_), *looks, Abreast("next_to", (came[-1],))]


def there_where(work: Work, spot: Placement, category: str) -> list[Goal]:
    """At the spot of something that is gone: on what that stood on, and not on what is nearby."""
    mount, there = work.source.usual(category)[1], Spot(spot.position[:2], THERE, old=spot)
    stands = spot.support == "floor" and mount in ("floor", "surface")
    rests = spot.support in work.scene and mount == "surface"
    return [there, Related("on", (spot.support,))] if stands or rests else [there]


def _stand_in_line(order: Order, goals: Sequence[Goal]) -> bool:
    """Whether several are to stand in one line, at the place of the first: what hangs over a thing hangs over it."""
    return order.in_line and not any(isinstance(goal, Related) and goal.kind == "above" for goal in goals)


def compared(finder: Finder, category: str, nearer: bool, other: NounPhrase) -> Goal:
    """Closer to something than things are that are added, which is near; or far from it."""
    return Related("near" if nearer else "far", mark_names(finder, other))


def related_to_those(work: Work, where: Bound, category: str, index: int, count: int) -> Goal:
    """The goal of one of several that are added to those that are there."""
    there = _there(work, where, category)
    return related(where, category, there + (0 if where.kind == "around" else index), there + count - index)


def _there(work: Work, where: Bound, category: str) -> int:
    """How many of its kind are around the same thing already."""
    if where.kind != "around":
        return 0
    alike = [p.id for p in work.scene.placements if p.category == category]
    return sum(Bound("at", where.anchors).holds(work.scene, id) for id in alike)
