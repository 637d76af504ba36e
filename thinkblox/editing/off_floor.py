"""Small things that go by something: they stand on what is there and carries them, rather than on the floor."""

from collections.abc import Callable, Iterable, Iterator, Sequence

from thinkblox.assets import facts_of
from thinkblox.editing.carrying import usual_carriers
from thinkblox.editing.goals import Goal, Related
from thinkblox.editing.work import Work
from thinkblox.knowledge.habits import load_habits
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene

NEIGHBOUR = 0.6
"""How far from a thing, a door or a window something is at most on which small things are by that [m]."""
REACHED = 1.4
"""How high a top is at most on which something is put that nobody said is to go up there [m]."""
_BESIDE = ("next_to", "near", "left_of", "right_of", "in_front_of", "in_corner", "against_wall")
_SOFT = ("seating", "beds", "lounges", "covers")


def lifted(
    work: Work, id: str, goals: Sequence[Goal], reach: Callable[[Sequence[Goal]], bool]
) -> Sequence[Goal] | None:
    """Put something that rests on a thing, and is to go by another, on what carries it there.

    Args:
        work: the edit.
        id: of what is moved.
        goals: what is asked of it.
        reach: brings it to other goals; whether it could.

    Returns:
        What it meets then; None where it is not moved so, as nothing that is there carries it.
    """
    scene = work.scene
    by = by_something(goals)
    if by is None or scene[id].support not in scene or not is_for_tops(scene, id):
        return None
    for carrier in carriers_by(scene, scene[id].category, by.anchors):
        near = Related("near", by.anchors) if by.kind == "next_to" else by
        other: list[Goal] = [near, Related("on", (carrier,))]
        if carrier != id and id not in scene.carriers(carrier) and reach(other):
            return other
    return None


def by_something(goals: Sequence[Goal]) -> Related | None:
    """The one place that is asked for, where it is by something and not on anything."""
    one = goals[0] if len(goals) == 1 else None
    beside = isinstance(one, Related) and one.kind in _BESIDE and bool(one.anchors) and not one.negated
    return one if isinstance(one, Related) and beside else None


def is_for_tops(scene: Scene, id: str) -> bool:
    """Whether something is such that it stands on other things, and never on the floor."""
    habits = load_habits().of(scene[id].category)
    small = scene.asset_of(scene[id]).mount == "surface" and facts_of(scene[id].category).is_in("small")
    return small and bool(habits) and all(habit.kind == "on" for habit in habits)


def carriers_by(scene: Scene, category: str, anchors: Sequence[str]) -> list[str]:
    """What carries such things and stands by something, the nearest first; what usually carries them before others."""
    marks = [mark for name in anchors for mark in things(scene, name)]
    usual = usual_carriers(scene, category)
    tops = [p.id for p in scene.placements if p.support == "floor" and _is_in_reach(scene, p)]
    tops = [id for id in tops if id not in anchors and not facts_of(scene[id].category).is_in(*_SOFT)]
    away = {id: min((ground_gap(things(scene, id)[0], mark) for mark in marks), default=NEIGHBOUR) for id in tops}
    return sorted((id for id in tops if away[id] < NEIGHBOUR), key=lambda id: (id not in usual, away[id]))


def _is_in_reach(scene: Scene, thing: Placement) -> bool:
    """Whether something has a top, and none that is high up."""
    tops = [surface.position[2] for surface in scene.asset_of(thing).surfaces]
    return bool(tops) and max(tops) <= REACHED


def on_floor(work: Work, ids: Iterable[str]) -> Iterator[str]:
    """Notes on what stands on the floor now, and did not, though such things stand on others and nobody said so."""
    said = {wish.id for wish in work.wishes if isinstance(wish.goal, Related) and "floor" in wish.goal.anchors}
    for id in (id for id in ids if id in work.scene and id not in said):
        was = work.start[id].support if id in work.start else ""
        if work.scene[id].support == "floor" != was and is_for_tops(work.scene, id):
            yield f"{id} stands on the floor, as nothing that carries such a thing is free there."
