"""Where something is added of which no place is said, or only what it is by: where such things usually are."""

from collections.abc import Sequence

from thinkblox.assets import facts_of
from thinkblox.editing.acting import related
from thinkblox.editing.adding_goals import related_to_those
from thinkblox.editing.adding_one import add_one
from thinkblox.editing.carrying import CARRIERS, usual_carriers
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Goal, Related
from thinkblox.editing.wheres import Bound
from thinkblox.editing.work import Work
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure

NEIGHBOUR = 0.6
"""How far from a thing something stands at most on which small things are by that [m]."""

_BESIDE = ("next_to", "near", "left_of", "right_of")


def at_their_table(work: Work, category: str, noun: Noun) -> str:
    """Add one more seat to the table that all others like it are drawn up to; empty where that cannot be.

    What is said to be one more of them goes nowhere else; any other may.
    """
    alike = [p.id for p in work.scene.placements if p.category == category]
    if not alike or not facts_of(category).is_in("seating"):
        return ""
    tables = [p.id for p in work.scene.placements if facts_of(p.category).is_in("tables")]
    theirs = [table for table in tables if all(measure(work.scene, "at", id, (table,)).holds for id in alike)]
    saved, said = work.saved(), len(work.failed)
    goals = [related_to_those(work, Bound("around", (table,)), category, 0, 1) for table in theirs[:1]]
    id = add_one(work, category, noun, goals) if goals else ""
    if goals and not id and noun.det != "another":
        work.restore(saved)
        del work.failed[said:]
    return id


def on_usual(work: Work, finder: Finder, category: str, noun: Noun) -> str:
    """Add something small to the first of what usually carries it that has room; empty where none has.

    What was spoken of last comes first of these.
    """
    carriers = usual_carriers(work.scene, category) if work.source.usual(category)[1] == "surface" else []
    carriers = sorted(carriers, key=lambda id: id not in finder.recent)
    saved, said = work.saved(), len(work.failed)
    for carrier in carriers[:CARRIERS]:
        if id := add_one(work, category, noun, [related(Bound("on", (carrier,)), category)]):
            return id
        work.restore(saved)
        del work.failed[said:]
    return ""


def at_window(work: Work, category: str) -> list[Goal]:
    """That what hangs at windows, as curtains do, hangs at one also where nothing is said."""
    habit = next(iter(load_habits().of(category)), None)
    hangs = habit is not None and habit.anchors[:1] == ("window",) and work.source.usual(category)[1] == "wall"
    return [Related(habit.kind, ("window",))] if hangs and habit is not None else []


def on_neighbour(work: Work, category: str, noun: Noun, here: Sequence[Bound], goals: Sequence[Goal]) -> str:
    """Add something small by a thing on the floor to what carries such things beside that: "a kettle by the stove".

    Empty where nothing beside it carries it, or where it is said otherwise.
    """
    scene, beside = work.scene, [bound for bound in here if bound.kind in _BESIDE and not bound.negated]
    anchors = [name for bound in beside for name in bound.anchors if name in scene]
    plain = len(anchors) == len(beside) == len(here) == 1 and len(goals) <= 2
    let_in = plain and facts_of(scene[anchors[0]].category).is_in("built_in")
    if not plain or work.source.usual(category)[1] != "surface":
        return ""
    if not let_in and (beside[0].upon or len(goals) > 1 or scene[anchors[0]].support in scene):
        return ""
    mark, saved, said = things(scene, anchors[0])[0], work.saved(), len(work.failed)
    away = {id: ground_gap(things(scene, id)[0], mark) for id in usual_carriers(scene, category) if id != anchors[0]}
    side = beside[0].kind if beside[0].kind in ("left_of", "right_of") else "near"
    for carrier in sorted((id for id in away if away[id] <= NEIGHBOUR), key=lambda id: away[id]):
        on: list[Goal] = [Related(side, (anchors[0],)), Related("on", (carrier,))]
        if id := add_one(work, category, noun, on):
            return id
        work.restore(saved)
        del work.failed[said:]
    return ""
