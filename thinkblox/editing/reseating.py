"""The seats of a table that becomes another one: drawn up to it again where they are not any more."""

from collections.abc import Callable, Sequence

from thinkblox.assets import facts_of
from thinkblox.editing.carrying import put_back, take
from thinkblox.editing.company import SITTING, seats_at
from thinkblox.editing.goals import Related
from thinkblox.editing.reaching import Reaching, ties_of
from thinkblox.editing.work import Work
from thinkblox.scene.bearings import bearing
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene

ASKEW = 30.0
"""From how far beside its table a seat looks that does not sit at it [degrees]."""
LONG = 1.3
"""From how many times its width on a table has long sides, along which seats do not look at its middle."""


def with_seats(work: Work, id: str, become: Callable[[], bool], *, asked: bool = False) -> bool:
    """Let a table become another one, and its seats stand around that; whether it could become so.

    Seats that stand at it as before stay where they are. Where they do not, or are in its way, all are drawn up anew;
    where that cannot be, they stay, and the table becomes so without them if it can: that is told, or noted as not done
    where it was `asked` that they stand around it. What stands
    about a low table is no seat of it, unless it was asked.
    """
    seats = seats_at(work.scene, id, besides=work.kept)
    if not asked and work.scene[id].size[2] < SITTING:
        seats = []
    if not seats:
        return become()
    before, saved, said = work.scene, work.saved(), (len(work.failed), len(work.notes))
    done = become()
    still = done and facts_of(work.scene[id].category).is_in("tables", "desks", "counters")
    if done and not (still and _left(work.scene, id, seats)):
        return True
    alone = work.world, work.failed[said[0] :], work.notes[said[1] :], work.done[saved[1] :], work.wishes[saved[2] :]
    work.restore(saved)
    del work.failed[said[0] :], work.notes[said[1] :]
    taken = take(work, seats)
    if (
        become()
        and facts_of(work.scene[id].category).is_in("tables", "desks", "counters")
        and _drawn_up(work, before, id, taken)
    ):
        moved = [seat for seat in seats if work.scene[seat] != before[seat]]
        if moved:
            work.done.append(f"{', '.join(moved)} drawn up to {id} anew")
        return True
    work.restore(saved)
    del work.failed[said[0] :], work.notes[said[1] :]
    work.world, work.failed[said[0] :], work.notes[said[1] :] = alone[:3]
    work.done += alone[3]
    work.wishes += alone[4]
    if done and (left := _left(work.scene, id, seats)):
        (work.failed if asked else work.notes).append(f"{', '.join(left)} stayed: there is no room for all at {id}")
    return done


def _left(scene: Scene, id: str, seats: Sequence[str]) -> list[str]:
    """The seats that do not stand at a table any more, or do not look at it."""
    return [seat for seat in seats if seat in scene and not _sits(scene, seat, id)]


def _sits(scene: Scene, seat: str, id: str) -> bool:
    mark, table = things(scene, seat)[0], things(scene, id)[0]
    if not measure(scene, "at", seat, (id,)).holds:
        return False
    wide, narrow = sorted(scene[id].size[:2], reverse=True)
    return (
        wide > LONG * narrow
        or mark.front == "any"
        or turn_between(mark.gaze, bearing(mark.centre, table.centre)) <= ASKEW
    )


def _drawn_up(work: Work, before: Scene, id: str, taken: Sequence[Placement]) -> bool:
    """Put seats that were taken out around a table; whether all of them, with what rests on them, could be."""
    seats = [p for p in taken if p.support not in {other.id for other in taken}]
    for index, old in enumerate(seats):
        asset = work.assets[old.asset]
        goals = (Related("around", (id,), index=index, count=len(seats), measured="at"),)
        target = work.target(old.id, old.category, ties_of(goals), asset.attributes)
        if not Reaching(work, target, asset, goals, search=False).run():
            return False
        if put_back(work, old, [p for p in taken if p.id != old.id], before):
            return False
    return not _left(work.scene, id, [p.id for p in seats])
