"""What goes along with a thing that is moved or turned because the order says so: "the table with its chairs"."""

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace

from thinkblox.assets import facts_of
from thinkblox.editing.carrying import place_anew, put_back, take
from thinkblox.editing.finding import Finder, nearest_to
from thinkblox.editing.goals import EXACT, At, DrawnUp, Goal, Related
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.spots import BESIDE, Pose
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.plan import Tie
from thinkblox.scene.asset import Asset
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.nearby import BACK_GAP
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene

ASIDE = 0.3
"""How far it may then stand from where it stood to that thing, at most half as far as it has come [m]."""
SAME_GAP = 0.05
"""By how much further than from another of its kind something may stand from what it belongs to [m]."""
SITTING = 0.55
"""How high a table is at least that seats are drawn up to, so that they go along with it [m]."""
TOO_FAR = 1.2
"""From how far a low table that is turned would have to be moved its seats go along, if it need not be then [m]."""
REACH = 0.8
"""How far from a thing its company stands at most [m]."""


def with_company(work: Work, finder: Finder, order: Order, id: str, do: Callable[[], None]) -> None:
    """Do something with one thing, and bring what the order names along to the same places beside it.

    Where nothing is named, the seats that are drawn up to it stay as they are, unless it cannot be done without them.
    """
    mates = company_of(work, finder, order, id)
    if mates:
        bring_together(work, id, mates, do)
        return
    if bring_overhead(work, [id], do):
        return
    seats = [] if order.rest or order.company else seats_at(work.scene, id, besides={*finder.named, *work.kept})
    if seats:
        _first_without(work, id, seats, do, turned=order.doing == "turn")
    else:
        do()


def bring_or_leave(work: Work, id: str, seats: Sequence[str], do: Callable[[], None], says: str) -> bool:
    """Do something with a thing and its seats; False where that cannot be: then nothing is done."""
    before = work.scene
    if not done_or_undone(work, lambda: bring_together(work, id, seats, do)):
        return False
    if work.scene[id] != before[id]:
        work.notes.append(f"{', '.join(seats)} {says}.")
    return True


def _first_without(work: Work, id: str, seats: Sequence[str], do: Callable[[], None], *, turned: bool) -> None:
    """Do something with a table or desk, with the seats that are at it only where it cannot be done without them."""
    before, saved, said = work.scene, work.saved(), (len(work.failed), len(work.notes))
    do()
    shifted = turned and math.dist(before[id].position, work.scene[id].position) > TOO_FAR
    if len(work.failed) == said[0] and not shifted:
        say_left(work, id, seats)
        return
    alone = work.world, work.failed[said[0] :], work.notes[said[1] :], work.done[saved[1] :], work.wishes[saved[2] :]
    work.restore(saved)
    del work.failed[said[0] :], work.notes[said[1] :]
    if bring_or_leave(work, id, seats, do, f"went along, as {id} cannot be there without them"):
        return
    work.world, work.failed[said[0] :], work.notes[said[1] :] = alone[:3]
    work.done += alone[3]
    work.wishes += alone[4]
    say_left(work, id, seats)


def bring_overhead(work: Work, ids: Sequence[str], do: Callable[[], None]) -> bool:
    """Do something with things over which something hangs that goes where they go, as a hood with its stove.

    False where nothing does, or where it cannot come along: then nothing is done.
    """
    over = {
        p.id: id
        for p in work.scene.placements
        for id in ids
        if facts_of(p.category).is_in("goes_along_below")
        and p.id not in work.kept
        and measure(work.scene, "above", p.id, (id,)).holds
    }
    if not over:
        return False
    below = next(iter(over.values()))
    along = [name for name, id in over.items() if id == below]
    return done_or_undone(work, lambda: bring_together(work, below, along, do))


def done_or_undone(work: Work, do: Callable[[], None]) -> bool:
    """Do something, and take it back with what was said of it where any of it failed; whether it is done."""
    saved, said = work.saved(), (len(work.failed), len(work.notes))
    do()
    if len(work.failed) == said[0]:
        return True
    work.restore(saved)
    del work.failed[said[0] :], work.notes[said[1] :]
    return False


def seats_at(scene: Scene, id: str, *, besides: Collection[str]) -> list[str]:
    """The seats that are drawn up to a thing and to nothing else."""
    if not facts_of(scene[id].category).is_in("tables", "desks", "counters"):
        return []
    others = [p.id for p in scene.placements if p.category == scene[id].category and p.id != id]
    seats = [p.id for p in scene.placements if facts_of(p.category).is_in("seating") and p.id not in besides]
    drawn = [seat for seat in seats if measure(scene, "at", seat, (id,)).holds]
    return [seat for seat in drawn if not any(measure(scene, "at", seat, (other,)).holds for other in others)]


def say_left(work: Work, id: str, seats: Sequence[str]) -> None:
    """Note which seats a thing has left."""
    left = [seat for seat in seats if seat in work.scene and not measure(work.scene, "at", seat, (id,)).holds]
    work.left += [(id, left)] if left else []


def left_behind(work: Work) -> Iterator[str]:
    """What is to be said of seats that things have left, and that stand there still."""
    for id, seats in work.left:
        still = [s for s in seats if s in work.scene and id in work.scene and work.scene[s] == work.start[s]]
        still = [seat for seat in still if not measure(work.scene, "at", seat, (id,)).holds]
        if still:
            yield f"{', '.join(still)} stayed, away from {id} now: what is to go along has to be named."


def bring_together(work: Work, id: str, mates: Sequence[str], do: Callable[[], None]) -> None:
    """Do something with one thing, and bring others to the same places beside it; all of it or nothing."""
    if not mates:
        do()
        return
    before, saved, failures = work.scene, work.saved(), len(work.failed)
    taken = take(work, mates)
    do()
    why = "" if len(work.failed) == failures else f"{id} stays"
    if not why and work.scene[id] == before[id]:
        work.world = saved[0]
        return
    for mate in mates if not why else ():
        why = _bring(work, before, taken, id, mate)
        if why:
            break
    if why:
        said = work.failed[failures:]
        work.restore(saved)
        work.failed[failures:] = said or [f"{id} was left where it is with {', '.join(mates)}: {why}"]
        return
    work.done.append(f"{', '.join(mates)} went along with {id}")


def gathered(work: Work, finder: Finder, order: Order) -> Order:
    """An order in which the seats that are named after their table go along with it: "turn the table and chairs"."""
    if order.doing not in ("move", "put", "turn") or len(order.things) != 2 or order.mutual or order.split:
        return order
    head, seats = order.things
    noun = seats.noun
    plain = head.noun.kind == noun.kind == "thing" and not (head.places or seats.id or seats.spared or seats.share)
    if not plain or order.together or order.scatter or noun.ordinal or noun.count or noun.det not in ("", "the", "all"):
        return order
    table = finder.matching(head.noun) if not head.id else [work.scene[head.id]]
    found = [p for p in finder.matching(noun) if facts_of(p.category).is_in("seating")]
    if len(table) != 1 or not facts_of(table[0].category).is_in("tables", "desks"):
        return order
    there = [p for p in found if measure(work.scene, "at", p.id, (table[0].id,)).holds]
    if not there or (noun.det and len(there) < len(found)):
        return order
    its = replace(noun, det="my", plural=len(there) > 1, text=f"its {noun.word}")
    head = replace(head, places=seats.places)
    return replace(order, things=[head], company=[*order.company, NounPhrase(its)])


def company_of(work: Work, finder: Finder, order: Order, id: str) -> list[str]:
    """What an order lets go along with a thing, by itself and not on it.

    Raises:
        InputError: as `mates_of`.
    """
    found: list[str] = []
    for phrase in order.company:
        found += mates_of(work, finder, phrase, id)
    riding = {rider.id for rider in work.scene.riders(id)}
    return [mate for mate in dict.fromkeys(found) if mate != id and mate not in riding and mate not in work.kept]


def mates_of(work: Work, finder: Finder, phrase: NounPhrase, id: str) -> list[str]:
    """The things that a phrase means of what stands by an object: "its chairs".

    Raises:
        InputError: none is there, or none stands by it.
    """
    noun = phrase.noun
    own = noun.det == "my" and noun.text.lower().startswith(("its ", "their ", "her ", "his "))
    if phrase.id or noun.id or not (noun.many or own):
        return list(finder.ids(phrase, picks=(nearest_to(work.scene, id, 1),)))
    found = [p.id for p in finder.matching(noun)]
    if not found:
        raise finder.nothing(noun.text)
    mark = things(work.scene, id)[0]
    away = {name: ground_gap(things(work.scene, name)[0], mark) for name in found}
    rivals = [p.id for p in work.scene.placements if p.category == work.scene[id].category and p.id != id]
    by_it = [name for name in found if away[name] <= REACH and not _is_of_another(work.scene, name, id, rivals)]
    if own and not noun.many:
        by_it = sorted(by_it, key=lambda name: away[name])[:1]
    elif noun.count:
        by_it = sorted(found, key=lambda name: away[name])[: noun.count]
    if not by_it:
        raise InputError(f"'{noun.text}': none of {', '.join(found)} stands within {REACH:g} m of {id}")
    return by_it


def _is_of_another(scene: Scene, name: str, id: str, rivals: Sequence[str]) -> bool:
    """Whether something belongs to another thing of the same kind: it is drawn up to that, or stands nearer to it."""
    if not rivals:
        return False
    at = [other for other in (id, *rivals) if measure(scene, "at", name, (other,)).holds]
    if at:
        return id not in at
    mark = things(scene, name)[0]
    away = {other: ground_gap(mark, things(scene, other)[0]) for other in (id, *rivals)}
    return away[id] > min(away.values()) + SAME_GAP


def _bring(work: Work, before: Scene, taken: list[Placement], id: str, mate: str) -> str:
    """Put one thing where it stood beside another, as that stands now; why not, where that cannot be."""
    old, asset = before[mate], work.assets[before[mate].asset]
    seated = facts_of(old.category).is_in("seating") and measure(before, "at", mate, (id,)).holds
    kind = "at" if seated else "near"
    pose = _along(old, before[id], work.scene[id])
    moved = math.dist(old.position[:2], pose[0][:2])
    sides = [side for side in BESIDE if seated and measure(before, side, mate, (id,)).holds]
    drawn = DrawnUp("at", (id,), side=sides[0]) if sides else Related("at", (id,))
    goals: list[Goal] = [drawn if kind == "at" else At(pose[0][:2], min(ASIDE, max(moved / 2, EXACT)))]
    ties = (Tie(kind="around" if kind == "at" else "near", anchors=(id,)),)
    target = work.target(mate, old.category, ties, asset.attributes)
    poses = (pose, _hung(work.scene, asset, pose)) if asset.mount == "wall" else (pose,)
    reaching = Reaching(work, target, asset, goals, direct=poses, begin=poses[-1])
    if not reaching.run():
        return reaching.why
    for rider in put_back(work, old, [p for p in taken if p.id != mate], before):
        lost = next(p for p in taken if p.id == rider)
        if not place_anew(work, lost, carriers=(mate,)):
            return f"{rider} could not go along with {mate}"
    return ""


def _hung(scene: Scene, asset: Asset, pose: Pose) -> Pose:
    """The same place right at the wall that is nearest to it."""
    (x, y, z), _ = pose
    wall = min(scene.room.walls, key=lambda wall: abs(wall.coordinates((x, y))[1]))
    spot = wall.point(wall.coordinates((x, y))[0], asset.size[0] / 2 + BACK_GAP)
    return (*spot, z), wall.yaw


def _along(mate: Placement, old: Placement, new: Placement) -> Pose:
    """Where something stands to a thing as it stood to it before that moved and turned."""
    turn = new.yaw - old.yaw
    way, dx, dy = math.radians(turn), mate.position[0] - old.position[0], mate.position[1] - old.position[1]
    x = new.position[0] + dx * math.cos(way) - dy * math.sin(way)
    y = new.position[1] + dx * math.sin(way) + dy * math.cos(way)
    return (round(x, 4), round(y, 4), mate.position[2]), round((mate.yaw + turn) % 360.0, 4) % 360.0
