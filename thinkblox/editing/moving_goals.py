"""What an order asks of each thing that it moves, as goals that can be measured."""

import dataclasses
from collections.abc import Iterator, Sequence

from thinkblox.assets import facts_of
from thinkblox.editing.acting import (
    backing,
    centred,
    level,
    looking,
    mark_names,
    related,
)
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import (
    Abreast,
    Across,
    Apart,
    At,
    Central,
    Elsewhere,
    Free,
    Goal,
    Midway,
    Nearing,
    Related,
    Spot,
)
from thinkblox.editing.lengthwise import lengthwise
from thinkblox.editing.moving_one import LEFT, OTHER_CORNER
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.spots import (
    at_wall,
)
from thinkblox.editing.stepping import SLIGHT
from thinkblox.editing.taking_place import THERE, there_where
from thinkblox.editing.wheres import Bound, slots_for, spot_of, told_by
from thinkblox.editing.work import Work
from thinkblox.editing.zones import place_named
from thinkblox.errors import InputError
from thinkblox.plan import is_object
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure

AT_IT = 0.06
"""How far something may stand from what it is put against [m]."""


def stood_abreast(goals: list[Goal], came: Sequence[str]) -> list[Goal]:
    """The goals, where the second of several that go across from a thing stands beside the first."""
    across = [goal for goal in goals if isinstance(goal, Across)]
    if not across or not came:
        return goals
    beside: list[Goal] = [Related("facing", across[0].anchors), Abreast("next_to", (came[-1],))]
    return [goal for goal in goals if goal not in across] + beside


def goals_of(
    work: Work, finder: Finder, order: Order, id: str, places: Sequence[Where], index: int, count: int
) -> list[Goal]:
    """What an order asks of the one of `count` things that comes at `index`, as goals."""
    goals = [goal for where in places for goal in _at_place(work, finder, order, id, where, index, count)]
    if order.there:
        goals.append(there_where(work, id, finder.left_place(order.text)))
    goals += [Elsewhere(LEFT)] if order.leaves else []
    goals += [level(finder, noun, order.text) for noun in order.level]
    goals += [Free(place_named(noun)) for noun in order.free]
    if order.slight and (order.closer or order.direction):
        goals.append(At(work.scene[id].position[:2], SLIGHT))
    if order.seated:
        goals += _seated(work, id, order)
    said = [phrase.noun for _, phrase in order.apart]
    bounded = order.bound and not order.lengths
    closer = [(near, phrase) for near, phrase in order.closer if bounded or not any(n is phrase.noun for n in said)]
    goals += [_nearing(work, finder, order, id, nearer, phrase) for nearer, phrase in closer]
    goals += [Apart(mark_names(finder, phrase), away, order.bound) for away, phrase in order.apart]
    goals += [backing(finder, noun) for noun in order.backs]
    return goals + [looking(finder, noun) for noun in order.facing]


def _at_place(
    work: Work, finder: Finder, order: Order, id: str, where: Where, index: int, count: int
) -> Iterator[Goal]:
    """What a place wants of one of several that are moved there."""
    if where.word == "spot":
        old = spot_of(where, id, work.start, finder)
        yield Spot(old.position[:2], THERE, old=old)
        return
    if where.text in ("long_side", "short_side") and where.noun is not None:
        yield from lengthwise(work, finder, id, where)
        return
    if where.noun is not None and _is_any_other_corner(where, where.noun):
        yield Related("in_corner", ("corner",))
        yield Elsewhere(OTHER_CORNER)
        return
    category = work.scene[id].category
    slots = slots_for(where, category, finder, count)
    text = f"{where.text} {where.noun.text if where.noun else ''}"
    if len(slots) > max(count, 1) and where.noun is not None and where.noun.kind == "thing" and where.noun.det == "the":
        slots = slots[: max(count, 1)]
    if len(slots) > max(count, 1):
        raise InputError(f"'{order.text}': '{text}' names {len(slots)} places, for {count} to be moved")
    there = slots[index % len(slots)]
    if id in there.anchors and not there.negated:
        raise InputError(f"{id} cannot be put where it is itself: '{text}'")
    yield from _strictly(work, finder, where, there, category, touching=order.touching)
    if order.centred:
        there, more = centred(work.scene, there)
        yield from more
        if any(isinstance(goal, Midway) for goal in more):
            return
    if order.abreast and there.kind == "next_to" and not there.negated and all(map(is_object, there.anchors)):
        yield Abreast("next_to", there.anchors)
        return
    yield related(there, category, index, count)


def _strictly(
    work: Work, finder: Finder, where: Where, there: Bound, category: str, *, touching: bool
) -> Iterator[Goal]:
    """What a place asks for besides its relation: in the middle about there, against a thing close to it."""
    if there.kind == "in_centre" and _carries(work, there.anchors, category):
        yield Related("on", there.anchors)
    if there.upon:
        yield Related("on", (there.upon,))
    if beside := told_by(where, finder):
        yield Related("on", beside, negated=True)
    if there.kind == "in_centre" and there.anchors == ("centre",) and not there.negated:
        yield Central()
    if there.kind == "in_front_of" and not there.negated and _sits_before(work, there.anchors, category):
        yield Related("at", there.anchors)
    against = (there.kind == "next_to" and where.word == "against") or (touching and all(map(is_object, there.anchors)))
    if against and not there.negated:
        yield Apart(there.anchors, AT_IT, "le")


def _is_any_other_corner(where: Where, noun: Noun) -> bool:
    """Whether it is "another corner", whichever."""
    bare = where.whole is None and where.second is None and not where.negated and "opposite" not in noun.text.lower()
    return noun.value == "corner" and noun.det in ("other", "another") and bare and not noun.many


def _nearing(work: Work, finder: Finder, order: Order, id: str, nearer: bool, phrase: NounPhrase) -> Goal:
    """How far nearer to something, or away from it; of "their desks" to the one that is nearest."""
    by = order.lengths[0][0] if order.lengths else None
    if phrase.noun.det == "my" and phrase.noun.text.lower().split()[0] in ("its", "their"):
        many = dataclasses.replace(phrase.noun, plural=True, count=None)
        own = tuple(p.id for p in finder.matching(many) if p.id != id)
        if not own:
            raise finder.nothing(phrase.noun.text)
        nearest = min(own, key=lambda name: Nearing((name,), nearer=True).of(work.scene, id))
        return Nearing((nearest,), nearer, by, order.slight)
    anchors = mark_names(finder, phrase)
    if anchors == ("wall",) and not nearer and at_wall(work.scene, id):
        behind = [w.name for w in work.scene.room.walls if measure(work.scene, "against_wall", id, (w.name,)).holds]
        anchors = tuple(behind[:1])
    if order.rest and not nearer and by is not None:
        return Apart(anchors, by, "ge")
    return Nearing(anchors, nearer, by, order.slight)


def _sits_before(work: Work, anchors: Sequence[str], category: str) -> bool:
    """Whether a chair is put before a desk or table, to which it is drawn up then."""
    tables = [facts_of(work.scene[name].category) for name in anchors if name in work.scene]
    drawn = facts_of(category).is_in("seats")
    return drawn and bool(tables) and all(facts.is_in("tables", "desks") for facts in tables)


def _carries(work: Work, anchors: Sequence[str], category: str) -> bool:
    """Whether something small goes on a thing of which it is to be in the middle."""
    surfaced = [name for name in anchors if name in work.scene and work.asset_of(name).surfaces]
    return bool(surfaced) and facts_of(category).is_in("small")


def _seated(work: Work, id: str, order: Order) -> list[Goal]:
    """A seat is pushed in to the table that is nearest to it, or pulled out from it.

    Raises:
        InputError: it is no seat, or no table is there.
    """
    tables = [p.id for p in work.scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    if not facts_of(work.scene[id].category).is_in("seating") or not tables:
        raise InputError(f"'{order.text}': {id} is no seat at a table; say where to")
    mark = things(work.scene, id)[0]
    table = min(tables, key=lambda name: ground_gap(mark, things(work.scene, name)[0]))
    if order.seated == "in":
        return [Related("at", (table,))]
    return [Nearing((table,), nearer=False, by=order.lengths[0][0] if order.lengths else None, slight=order.slight)]
