"""Orders that take things away: those that are named, what rests on one, or everything but some."""

import dataclasses
from collections.abc import Sequence
from dataclasses import replace

from thinkblox.editing.carrying import place_anew, put_back, take
from thinkblox.editing.company import mates_of
from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.rows import rows_of_all
from thinkblox.editing.telling import named, spare
from thinkblox.editing.wheres import bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import corners, things
from thinkblox.scene.scene import Scene

IN_CORNER = 0.3
"""How much further from a corner than the nearest of several another may be that stands in it too [m]."""
_RESTS = ("on", "from", "in", "inside", "on_top")


def remove(work: Work, finder: Finder, order: Order) -> None:
    """Take things away; what rested on them is placed anew."""
    if order.rest and not order.things:
        take_away(work, left_over(work, finder, order))
        on = [w.noun for w in order.places if w.word in _RESTS and w.noun is not None and w.noun.kind == "thing"]
        finder.recent = [id for noun in on for id in finder.ids(NounPhrase(noun)) if id in work.scene] or finder.recent
        return
    if order.rest and order.places:
        _with_all_that_rests(work, finder, order)
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    ids: dict[str, None] = {}
    for number, phrase in enumerate(order.things):
        if phrase.noun.kind in ("place", "part"):
            raise InputError(f"'{phrase.noun.text}' is no thing that can be taken away; there {finder.listed()}")
        meant = _meant(finder, phrase, next((p.places for p in order.things[number:] if p.places), []))
        ids |= dict.fromkeys(meant)
        if phrase.laden:
            ids |= dict.fromkeys(rider.id for id in meant for rider in work.scene.riders(id))
    for phrase in order.company:
        ids |= dict.fromkeys(mate for id in tuple(ids) for mate in mates_of(work, finder, phrase, id))
    take_away(work, work.touched(ids))
    finder.recent = list(ids)


def _with_all_that_rests(work: Work, finder: Finder, order: Order) -> None:
    """Take what rests on several things: "everything from the bookcase and the table" is of the table too.

    Of "everything on the desk and the chair", on which nothing rests, the chair goes itself.

    Raises:
        InputError: "everything on the desk and the table" could be either.
    """
    carriers, others = [where for where in order.places if where.word in _RESTS], list[NounPhrase]()
    for phrase in order.things:
        ids = named(finder, phrase, phrase.places)
        bears = any(work.scene.riders(id) for id in ids)
        last = carriers[-1] if carriers else None
        if last is not None and not phrase.places and (last.word == "from" or bears):
            if last.word != "from":
                raise InputError(
                    f"'{order.text}': {phrase.noun.text} could be what goes, or what everything goes from; say it in"
                    " two orders"
                )
            order.places.append(replace(last, noun=phrase.noun))
        else:
            others.append(phrase)
    gone = [id for where in order.places for id in left_over(work, finder, replace(order, places=[where], things=[]))]
    gone += [id for phrase in others for id in named(finder, phrase, phrase.places)]
    take_away(work, work.touched(dict.fromkeys(gone)))
    finder.recent = gone


def _meant(finder: Finder, phrase: NounPhrase, places: Sequence[Where]) -> tuple[str, ...]:
    """What a phrase means; what is said behind the last of several says also which of the others: "from the desk"."""
    try:
        return named(finder, phrase, phrase.places)
    except InputError:
        if phrase.places or not places:
            raise
    return named(finder, phrase, places)


def keep_only(work: Work, finder: Finder, order: Order) -> None:
    """Take away what is not named: of "only two chairs" the other chairs, of "only the sofa" everything else."""
    if not order.things:
        raise InputError(f"'{order.text}' does not say what is to be kept; there {finder.listed()}")
    if all(phrase.noun.count and not phrase.noun.definite for phrase in order.things):
        for phrase in order.things:
            alike = [p.id for p in finder.matching(phrase.noun)]
            if len(alike) < (phrase.noun.count or 0):
                raise InputError(f"'{order.text}': there are only {len(alike)}: {', '.join(alike)}")
            each = [where for where in phrase.places if where.noun is not None and where.noun.each]
            if each:
                slots = slots_of(each[0], work.scene[alike[0]].category, finder)
                there = [[id for id in alike if slot.holds(work.scene, id)] for slot in slots]
                kept = tuple(id for ids in there for id in ids[: phrase.noun.count])
            else:
                kept = named(finder, phrase, phrase.places)
            take_away(work, work.touched(id for id in alike if id not in kept))
        return
    if all(phrase.noun.kind == "number" and phrase.noun.rows for phrase in order.things):
        stay = {id for phrase in order.things for id in named(finder, phrase, ())}
        rows = [p.id for row in rows_of_all(work.scene) for p in row]
        take_away(work, work.touched(id for id in rows if id not in stay))
        return
    order.spared = [*order.spared, *order.things]
    resting = [w for p in order.things for w in p.places if w.word in ("on", "in", "inside", "on_top")]
    if not order.places and resting and all(p.places[-1:] == resting[-1:] or not p.places for p in order.things):
        order.places = resting[-1:]
    take_away(work, left_over(work, finder, order))


def left_over(work: Work, finder: Finder, order: Order) -> tuple[str, ...]:
    """Everything that an order speaks of by "everything" or "the room", without what it excepts and what is kept.

    What carries a thing that stays cannot go either; that is noted.
    """
    ids = [p.id for p in work.scene.placements]
    for where in (w for w in order.places if w.noun is not None and w.noun.word != "furniture"):
        ids = _there(work, finder, where, ids)
    if any(w.noun is not None and w.noun.word == "furniture" for w in order.places):
        floor = [id for id in ids if work.scene[id].support == "floor"]
        ids = list(dict.fromkeys(i for id in floor for i in (id, *(rider.id for rider in work.scene.riders(id)))))
    going = [id for id in spare(finder, ids, order.spared) if id not in work.kept]
    bearing = {c: id for id in ids if id not in going for c in work.scene.carriers(id) if c in going}
    work.failed += [f"{c} was not taken away: {id}, which is to stay, rests on it" for c, id in bearing.items()]
    return tuple(id for id in going if id not in bearing)


def _there(work: Work, finder: Finder, where: Where, ids: Sequence[str]) -> list[str]:
    """Those of some objects that are somewhere: on a thing at any height, or in a relation to it."""
    if where.noun is not None and where.noun.kind in ("thing", "pronoun") and where.word in _RESTS:
        carriers = finder.ids(NounPhrase(where.noun))
        return [id for id in ids if set(work.scene.carriers(id)) & set(carriers)]
    there = {c: bound(where, c, finder) for c in {work.scene[id].category for id in ids}}
    held = [
        id
        for id in ids
        if id not in there[work.scene[id].category].anchors and there[work.scene[id].category].holds(work.scene, id)
    ]
    corner = next((b.anchors for b in there.values() if b.kind == "in_corner" and not b.negated), ())
    return _foremost_in_corner(work.scene, held, corner) if held and corner else held


def _foremost_in_corner(scene: Scene, ids: Sequence[str], walls: Sequence[str]) -> list[str]:
    """Those of what is near to a corner that stand in it, not behind what does, with what rests on them."""
    marks = [m for m in corners(scene.room) if set(walls) <= {*m.name.removeprefix("corner of ").split(" and ")}]
    base = {id: (id, *scene.carriers(id))[-1] for id in ids}
    away = {
        id: min(ground_gap(things(scene, base[id])[0], mark) for mark in marks or things(scene, "corner")) for id in ids
    }
    return [id for id in ids if away[id] <= min(away.values()) + IN_CORNER]


def clear(work: Work, finder: Finder, order: Order) -> None:
    """Take away what is in the room, or what rests on a thing; a thing that carries nothing ever goes itself."""
    if order.room or order.rest or any(w.word == "from" for p in order.things for w in p.places):
        if order.things and not order.room:
            for phrase in order.things:
                phrase.places = [dataclasses.replace(w, word="on") if w.word == "from" else w for w in phrase.places]
            remove(work, finder, order)
            return
        ids = left_over(work, finder, order)
        take_away(work, ids)
        if not ids and not work.failed:
            work.done.append("nothing is there to be taken away: it is so already")
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what is to be cleared; say a thing, or a part of the room")
    cleared: dict[str, tuple[str, ...]] = {}
    for phrase in order.things:
        ids, spared = _cleared(work, finder, phrase)
        cleared |= dict.fromkeys(ids, spared)
    for id, stays in cleared.items():
        riders = tuple(r.id for r in work.scene.riders(id) if r.id not in work.kept and r.id not in stays)
        take_away(work, riders)
        if riders:
            continue
        if work.asset_of(id).surfaces:
            work.done.append(f"nothing rests on {id} that could be taken away: it is so already")
        else:
            take_away(work, work.touched((id,)))
    finder.recent = [id for id in cleared if id in work.scene]


def _cleared(work: Work, finder: Finder, phrase: NounPhrase) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The things that a phrase says are to be cleared, and what stays on them: "the table except the lamp"."""
    ids = named(finder, dataclasses.replace(phrase, spared=[]), phrase.places)
    riders = [rider.id for id in ids for rider in work.scene.riders(id)]
    alike = {p.id: p.category for p in finder.matching(phrase.noun)} if phrase.noun.kind == "thing" else {}
    of_these = [
        s for s in phrase.spared if s.noun.kind != "thing" or {p.id for p in finder.matching(s.noun)} & {*alike}
    ]
    resting = [s for s in phrase.spared if s not in of_these]
    left = spare(finder, riders, resting) if riders else ()
    for stays in resting if riders else ():
        if spare(finder, riders, [stays]) == tuple(riders):
            raise InputError(f"'{stays.text}' is not on {', '.join(ids)}; there is {', '.join(riders)}")
    return spare(finder, ids, of_these, phrase.noun), tuple(id for id in riders if id not in left)


def take_away(work: Work, ids: Sequence[str]) -> None:
    """Take objects out of the room and give what rested on them, and is not one of them, another place."""
    before = work.scene
    taken = take(work, ids)
    work.done += [f"{id} taken away" for id in ids]
    off = [p for p in taken if p.id not in ids]
    for rider in off:
        if rider.support in {p.id for p in off}:
            continue
        if place_anew(work, rider):
            put_back(work, rider, [p for p in off if p.id != rider.id], before)
            work.done.append(
                f"{rider.id}, which rested on {rider.support}, placed anew on {work.scene[rider.id].support}"
            )
        else:
            gone = [rider.id, *(p.id for p in off if rider.id in before.carriers(p.id))]
            work.failed.append(f"{', '.join(gone)} went with {rider.support}: nothing else in the room carries it")
