"""Several things, and rows of them, that are moved as one."""

import dataclasses
import math
from collections.abc import Sequence

from thinkblox.editing.acting import (
    say,
)
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import (
    EXACT,
    At,
)
from thinkblox.editing.orders import Order
from thinkblox.editing.rows import SAME_WAY, looks_to, rows_of
from thinkblox.editing.scattering import moved_to
from thinkblox.editing.stepping import way_of, ways_of
from thinkblox.editing.wheres import bound
from thinkblox.editing.work import Work
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.english.rooms import COMPASS
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.room import turn_between

TO_WALL = 0.05
"""How far the nearest of a row stands from the wall that it goes to [m]."""
_TO_FRONT = ("forward", "back")


def shifted_at_once(work: Work, order: Order, groups: Sequence[tuple[tuple[str, ...], list[Where]]]) -> bool:
    """Shift several things by the same length in the same direction as one; whether that could be and was all."""
    ids = list(dict.fromkeys(id for ids, _ in groups for id in ids))
    ids = [id for id in ids if not set(ids) & set(work.scene.carriers(id))]
    told = order.closer or order.apart or order.facing or order.backs or order.company or order.turn or order.slight
    plain = len(order.lengths) == 1 and order.direction not in ("", "up", "down") and not (told or order.seated)
    if not plain or len(ids) < 2 or any(places for _, places in groups):
        return False
    before, (metres, _) = work.scene, order.lengths[0]
    ways = {id: way_of(work, order, before[id]) for id in ids}
    spots = {
        id: (before[id].position[0] + metres * x, before[id].position[1] + metres * y) for id, (x, y, _) in ways.items()
    }
    if moved_to(work, ids, spots, off=EXACT):
        work.world = work.world.with_scene(before)
        return False
    for id in ids:
        say(work, id, before[id], None, [At(spots[id])])
    return True


def row_to_wall(
    work: Work, finder: Finder, order: Order, groups: Sequence[tuple[tuple[str, ...], list[Where]]]
) -> bool:
    """Move a row as it stands to the wall that is named; whether that is what the order says, which is noted.

    The back wall of what stands in rows is that behind them.
    """
    ids = [id for ids, _ in groups for id in ids]
    places = [where for _, some in groups for where in some]
    noun = places[0].noun if len(places) == 1 else None
    rows = len(groups) == 1 and any(phrase.noun.rows for phrase in order.things) and len(ids) > 1
    if not rows or noun is None or noun.kind != "place" or "wall" not in noun.value or places[0].negated:
        return False
    finder.about = ids[0]
    seen = {"far_wall": 180.0, "near_wall": 0.0}.get(noun.value)
    names = bound(places[0], work.scene[ids[0]].category, finder).anchors
    gaze = looks_to(work.scene, work.scene[ids[0]])
    found = [
        wall
        for wall in work.scene.room.walls
        if (wall.name in names if seen is None else turn_between(wall.yaw + 180.0, gaze + seen) < SAME_WAY)
    ]
    if len(found) != 1:
        return False
    wall, before = found[0], work.scene
    gaps = [ground_gap(things(before, id)[0], things(before, wall.name)[0]) for id in ids]
    step = max(0.0, min(gaps) - TO_WALL)
    spots = {id: (before[id].position[0] - step * wall.inward[0], before[id].position[1] - step * wall.inward[1])
             for id in ids}  # fmt: skip
    if why := moved_to(work, ids, spots, off=EXACT):
        work.world = work.world.with_scene(before)
        work.failed.append(f"{', '.join(ids)} were left where they are: {why}")
    for id in ids if not why else ():
        say(work, id, before[id], None, [At(spots[id])])
    return True


def by_rows(work: Work, order: Order, ids: Sequence[str]) -> Order:
    """The order, where all of the things that stand in rows go to the front or back: that which they look to.

    A desk of its own has its front where one sits at it; of a class the front is where everybody looks.
    """
    many = any(phrase.noun.many or phrase.noun.each for phrase in order.things)
    rows = rows_of(work.scene, [work.scene[id] for id in ids]) if many and order.direction in _TO_FRONT else []
    if sum(len(row) > 1 for row in rows) < 2:
        return order
    gaze = looks_to(work.scene, rows[0][0]) + (0.0 if order.direction == "forward" else 180.0)
    sides = {name: math.degrees(math.atan2(y, x)) for name, (x, y, _) in ways_of(work.scene[ids[0]]).items()
             if name in COMPASS}  # fmt: skip
    side = min(sides, key=lambda name: turn_between(sides[name], gaze))
    return dataclasses.replace(order, direction=side) if turn_between(sides[side], gaze) <= SAME_WAY else order
