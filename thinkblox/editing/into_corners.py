"""Things that are put into a corner stand right in it."""

from collections.abc import Sequence

from thinkblox.editing.acting import (
    reach_goals,
    say,
)
from thinkblox.editing.goals import (
    SNUG,
    Goal,
    IntoCorner,
    Related,
)
from thinkblox.editing.reaching import without
from thinkblox.editing.spots import (
    likely,
)
from thinkblox.editing.work import Work
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import corners, things


def into_corner(work: Work, id: str, goals: Sequence[Goal]) -> bool:
    """Move something right into its corner; False where that is nowhere near, it is there, or cannot be."""
    wanted = [g for g in goals if isinstance(g, Related) and g.kind == "in_corner" and not g.negated]
    if len(wanted) != 1 or work.asset_of(id).mount != "floor":
        return False
    before, mark = work.scene[id], things(work.scene, id)[0]
    found = corners(work.scene.room, wanted[0].anchors)
    near = [corner for corner in found if ground_gap(mark, corner) <= SNUG]
    there = [corner for corner in found if wanted[0].check(work.before, work.scene, id)[0]]
    if near or not there:
        return False
    corner = min(found, key=lambda corner: ground_gap(mark, corner))
    names = tuple(corner.name.removeprefix("corner of ").split(" and "))
    snug: list[Goal] = [IntoCorner("in_corner", names), *(goal for goal in goals if goal is not wanted[0])]
    saved, said = work.saved(), len(work.failed)
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    failed = reach_goals(work, id, snug, direct=likely(empty, work.asset_of(id), snug), ask=False)
    if failed is None:
        say(work, id, before, None, goals)
        return True
    work.restore(saved)
    del work.failed[said:]
    work.notes.append(f"{id} cannot stand right in the corner: {failed.why}.")
    return False
