"""Two things face to face or back to back: brought together in the middle of the room, or the one to the other."""

import math
from collections.abc import Callable, Iterator, Sequence

from thinkblox.assets import facts_of
from thinkblox.editing.acting import reach_goals, say
from thinkblox.editing.company import bring_together, seats_at
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import EXACT, At, Goal, Turned
from thinkblox.editing.orders import Order
from thinkblox.editing.spots import near_offsets
from thinkblox.editing.telling import named
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.landmarks import things
from thinkblox.value import Vec2

TOUCHING, TALKING = (0.01,), (1.0, 1.4, 0.7)
"""How far apart two tables, or the backs of two things, are put, and two seats whose users look at each other [m]."""
MIDDLE = 0.6
"""How far from the middle of the room the two may meet [m]."""
TRIES = 60
"""So many places are tried at most."""
_WORKED_AT = ("tables", "desks", "counters", "worktops")


def pair_up(work: Work, finder: Finder, order: Order) -> None:
    """Bring two things face to face or back to back, each with the seats that are drawn up to it.

    Raises:
        InputError: they are not two, do not stand on the floor, or go somewhere that is not followed.
    """
    ids = list(dict.fromkeys(id for phrase in order.things for id in named(finder, phrase, ())))
    if len(ids) != 2 or any(work.scene[id].support != "floor" for id in ids):
        raise InputError(f"'{order.text}': two things on the floor can stand so; it names {', '.join(ids) or 'none'}")
    ids = list(work.touched(ids))
    places = [*order.places, *(where for phrase in order.things for where in phrase.places)]
    if len(ids) != 2 or not all(map(_is_centre, places)):
        raise InputError(f"'{order.text}': two things stand so where the one is, or 'in the middle of the room'")
    before, saved, said = work.scene, work.saved(), (len(work.failed), len(work.notes))
    seats = {id: seats_at(before, id, besides={*ids, *work.kept}) for id in ids}
    why = ""
    for poses in _poses(work, ids, order.mutual, placed=bool(places)):
        for id in ids:
            bring_together(work, id, seats[id], _to(work, id, poses[id]))
        if len(work.failed) == said[0]:
            finder.recent = ids
            return
        why = why or work.failed[said[0]]
        work.restore(saved)
        del work.failed[said[0] :], work.notes[said[1] :]
    work.failed.append(f"{' and '.join(ids)} do not stand so: {why or 'there is no room for both'}")


def _is_centre(where: Where) -> bool:
    noun = where.noun
    room = noun is not None and (noun.value == "centre" or (noun.kind == "part" and noun.value == "middle"))
    return room and (where.whole is None or where.whole.kind == "room") and not where.negated


def _poses(work: Work, ids: Sequence[str], mutual: str, *, placed: bool) -> Iterator[dict[str, tuple[Vec2, float]]]:
    """Where each of the two stands, and how it is turned: about the middle of the room, or the first where it is."""
    tables = all(facts_of(work.scene[id].category).is_in(*_WORKED_AT) for id in ids)
    away = {id: mutual == "back_to_back" or turns_its_back(work, id) for id in ids}
    for gap in TOUCHING if tables or mutual == "back_to_back" else TALKING:
        for middle, way in _middles(work, ids[0], gap, placed=placed, away=away[ids[0]]):
            poses: dict[str, tuple[Vec2, float]] = {}
            for id, out in zip(ids, (way, way + 180.0), strict=True):
                spot = _out(middle, out, (work.scene[id].size[0] + gap) / 2)
                poses[id] = (spot, round((out + (0.0 if away[id] else 180.0)) % 360.0, 3) % 360.0)
            yield poses


def _middles(work: Work, first: str, gap: float, *, placed: bool, away: bool) -> Iterator[tuple[Vec2, float]]:
    """Where the two meet and which way the first of them is from there [degrees], the best first.

    Where nobody says where, that is the place of the first; what has no room there comes to the middle of the room.
    """
    if not placed:
        thing = work.scene[first]
        way = thing.yaw + (0.0 if away else 180.0)
        yield _out(thing.position[:2], way, -(thing.size[0] + gap) / 2), way
    centre = work.scene.room.polygon.centroid.coords[0]
    found = [(step, turn) for step in near_offsets(MIDDLE)[::4] for turn in (0.0, 90.0)]
    for (x, y), turn in found[:TRIES]:
        yield (centre[0] + x, centre[1] + y), turn


def _out(spot: Vec2, way: float, length: float) -> Vec2:
    angle = math.radians(way)
    return (round(spot[0] + length * math.cos(angle), 4), round(spot[1] + length * math.sin(angle), 4))


def turns_its_back(work: Work, id: str) -> bool:
    """Whether who uses a thing looks over its back, as at a desk or workbench."""
    mark = things(work.scene, id)[0]
    worked_at = facts_of(work.scene[id].category).is_in(*_WORKED_AT)
    return worked_at or abs((mark.gaze - work.scene[id].yaw + 180.0) % 360.0 - 180.0) > 90.0


def _to(work: Work, id: str, pose: tuple[Vec2, float]) -> Callable[[], None]:
    def do() -> None:
        before, (spot, yaw) = work.scene[id], pose
        goals: list[Goal] = [At(spot, EXACT), Turned((yaw,))]
        direct = iter([((*spot, before.position[2]), yaw)])
        failed = reach_goals(work, id, goals, direct=direct, search=False)
        say(work, id, before, failed, goals)

    return do
