"""Orders that belong together: "move the desk and turn it to the door", "keep the chairs around it"."""

import dataclasses
from collections.abc import Sequence

from thinkblox.editing.grammar import means
from thinkblox.editing.orders import HERE, NounPhrase, Order
from thinkblox.editing.telling import by_distance
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where

_ONTO_KNOWN = ("move", "put", "add", "resite", "replace")
_TURNABLE = ("replace", "move", "put", "add", "make", "swap")
"""Orders after which "keep them facing the window" says how what they were about is turned."""
_CARRYING = ("move", "put", "turn", "replace", "make")


def _only_faces(order: Order) -> bool:
    """Whether an order to turn things says what they are to face, and no more."""
    way = order.turn is not None or order.sense or order.slight or order.direction or order.backs or order.mutual
    return order.doing == "turn" and not way


def joined(orders: Sequence[Order]) -> list[Order]:
    """The orders, where "and turn it to face the room" belongs to the move before it.

    "Take a chair and put it there" is one order, and "keep the chairs around it" says what goes along.
    """
    joined: list[Order] = []
    for order in _with_seats_apart(_of_those_kept(orders)):
        last = joined[-1] if joined else None
        _as_is_meant(last, order)
        goes = last is not None and _takes(last) and order.doing in ("put", "move") and not _is_larger_one(last)
        goes |= last is not None and _grasps(last) and order.doing in ("put", "move")
        if last is not None and goes and (_is_of_it(order) or _share_out(last, order)):
            taken = dataclasses.replace(last.things[-1], places=_both(last, order))
            order.things, order.places, order.doing = [*last.things[:-1], taken, *order.things[1:]], [], "move"
            joined[-1] = order
            continue
        back = order.doing == "keep" or (order.doing in ("put", "move") and "back" in order.text.lower().split())
        along = last is not None and order.doing in ("put", "move") and _is_with_it(order)
        if last is not None and (along or (back and _keeps_by_it(order))) and last.doing in _CARRYING:
            last.company += [dataclasses.replace(phrase, places=[]) for phrase in order.things]
            continue
        if last is not None and last.doing == "remove" and _comes_there(order):
            order.doing, order.instead, order.things, order.there = "replace", order.things, last.things, False
            joined[-1] = order
            continue
        if last is not None and order.doing in ("put", "add"):
            _name_one(last, order)
        same = order.things and all(phrase.noun.kind == "pronoun" for phrase in order.things)
        if joined and same and _only_faces(order) and joined[-1].doing in _ONTO_KNOWN[:3]:
            facing = [w.noun for p in order.things for w in p.places if w.word == "facing" and w.noun is not None]
            joined[-1].facing += [_went_to(noun, joined[-1]) for noun in (*order.facing, *facing)]
        else:
            joined.append(order)
    for order in joined:
        if _taken_off(order):
            order.doing = "remove"
    return joined


def _went_to(noun: Noun, last: Order) -> Noun:
    """Read "(move it towards the door and turn it) to face it" as to face what it went to."""
    said = [w.noun for phrase in last.things for w in phrase.places if w.noun is not None]
    said += [phrase.noun for _, phrase in (*last.closer, *last.apart)]
    known = [other for other in said if other.kind in ("thing", "place")]
    return known[-1] if known and (noun.kind, noun.value) == ("pronoun", "it") else noun


def _with_seats_apart(orders: Sequence[Order]) -> list[Order]:
    """The orders with "make the table bigger, with six chairs" as that, and an order that six chairs are around it."""
    left: list[Order] = []
    for order in orders:
        left.append(order)
        for phrase in order.things if order.doing == "make" and (order.change or order.looks or order.lengths) else ():
            said = [w for w in phrase.places if w.word == "with" and w.noun is not None and w.noun.kind == "thing"]
            along = [w for w in said if w.noun is not None and w.noun.count]
            theirs = [w.noun for w in said if w.noun is not None and w.noun.det == "my" and w.noun.plural]
            order.company += [NounPhrase(noun) for noun in theirs]
            phrase.places = [w for w in phrase.places if w not in along and w.noun not in theirs]
            head = dataclasses.replace(phrase.noun, det="the")
            seats = [
                NounPhrase(w.noun, places=[Where("around", head, text="around")]) for w in along if w.noun is not None
            ]
            left += [Order("ensure", order.text, things=[seat], total=True) for seat in seats]
    return left


def _as_is_meant(last: Order | None, order: Order) -> None:
    """Let "but keep them facing the door" turn what was replaced, and "get another chair (and put it there)" add it."""
    if last is not None and last.doing in _TURNABLE and _keeps_facing(order):
        order.doing = "turn"
    if last is not None and _fetches_another(last):
        last.doing = "add"


def _of_those_kept(orders: Sequence[Order]) -> list[Order]:
    """The orders with "keep four desks and remove the rest" as one by which only four of the desks stay."""
    left: list[Order] = []
    for order in orders:
        if left and left[-1].doing in ("keep", "only") and _is_of_other_rows(left[-1], order):
            left[-1].doing = "only"
            continue
        if left and left[-1].doing == "keep" and _is_rest_of_them(left[-1], order):
            order.doing, order.things, order.rest, order.total = "only", left.pop().things, False, True
        left.append(order)
    return left


def _is_of_other_rows(last: Order, order: Order) -> bool:
    """Whether "(keep only the front row and remove) the other desks and chairs" takes what is in the other rows."""
    rows = bool(last.things) and all(phrase.noun.rows for phrase in last.things)
    others = [phrase.noun for phrase in order.things]
    bare = bool(others) and others[0].det == "other" and not any(phrase.places for phrase in order.things)
    return rows and order.doing == "remove" and bare and all(noun.det in ("other", "") for noun in others)


def _is_rest_of_them(last: Order, order: Order) -> bool:
    """Whether "(keep four desks and remove) the rest", "the others" are the others of the same kind."""
    nouns = [phrase.noun for phrase in last.things]
    counted = bool(nouns) and all(noun.kind == "thing" and noun.count and not noun.definite for noun in nouns)
    bare = order.rest and not (order.things or order.places) and "rest" in order.text.lower().split()
    others = [(phrase.noun.kind, phrase.noun.value) for phrase in order.things] == [("pronoun", "other")]
    return counted and not last.places and order.doing == "remove" and (bare or others)


def _fetches_another(order: Order) -> bool:
    """Whether it says "get another chair", which is added wherever it goes then."""
    fetched = bool(means("fetching", order.text.split(" ", 1)[0].lower()))
    return fetched and _takes(order) and all(phrase.noun.det == "another" for phrase in order.things)


def _name_one(last: Order, order: Order) -> None:
    """Let "a round one" that is put somewhere be a new one of what was just taken away."""
    noun, known = (o.things[-1].noun if o.things else None for o in (order, last))
    if last.doing != "remove" or noun is None or known is None or len(order.things) != 1:
        return
    if noun.kind == "number" and noun.det in ("a", "another") and known.kind == "thing" and not noun.degree:
        named = dataclasses.replace(noun, kind="thing", value=known.value, named=known.named)
        order.things[-1] = dataclasses.replace(order.things[-1], noun=named)


def _comes_there(order: Order) -> bool:
    """Whether "a bigger one" is put where something was taken away."""
    return order.doing in ("put", "add") and order.there and [p.noun.kind for p in order.things] == ["number"]


def _taken_off(order: Order) -> bool:
    """Whether "take the lamp off the desk" is all that is said: it is taken away."""
    off = [w for phrase in order.things for w in phrase.places if w.word == "from"]
    everything = order.rest and not order.things and [w.word for w in order.places] == ["from"]
    last = bool(off) and not any(phrase.places for phrase in order.things[:-1])
    taken = (_takes(order) and last) or (order.doing == "move" and everything)
    return taken and order.text.lower().startswith("take ")


def _takes(order: Order) -> bool:
    """Whether an order names things to be moved and not where to."""
    alone = not (order.closer or order.apart or order.direction or order.facing or order.seated or order.away)
    places = [*order.places, *(w for phrase in order.things for w in phrase.places)]
    placed = any(w.word != "from" and not by_distance(w) for w in places)
    return order.doing == "move" and alone and bool(order.things) and not placed


def _grasps(order: Order) -> bool:
    """Whether "take the plant next to the sofa" says where a thing is that goes somewhere then, and marks it so."""
    grasped = order.doing == "move" and bool(means("grasping", order.text.split(" ", 1)[0].lower()))
    if not grasped or len(order.things) != 1 or order.closer or order.direction or order.seated or order.away:
        return False
    places = order.things[0].places
    order.things[0].places = [dataclasses.replace(w, text=f"{HERE}{w.text}") for w in places]
    return True


def _is_larger_one(order: Order) -> bool:
    """Whether it gets "a bigger desk", which makes the one that is there so before that is put somewhere."""
    noun = order.things[-1].noun
    return noun.kind == "thing" and noun.det == "a" and bool(means("comparatives", noun.degree))


def _is_of_it(order: Order) -> bool:
    return (
        bool(order.things) and order.things[0].noun.kind == "pronoun" and order.things[0].noun.value in ("it", "them")
    )


def _share_out(last: Order, order: Order) -> bool:
    """Let "(take two chairs and put) one at each end" bring each of them to its own place; whether it says so."""
    taken, one = last.things[-1].noun, order.things[0] if len(order.things) == 1 else None
    if one is None or (one.noun.kind, one.noun.value) != ("pronoun", "one") or (taken.count or 0) < 2:
        return False
    where = one.places[0] if len(one.places) == 1 else None
    if where is None or where.noun is None or not where.noun.each:
        return False
    where.noun = dataclasses.replace(where.noun, det="all", plural=True)
    return True


def _both(last: Order, order: Order) -> list[Where]:
    """Where a thing is taken from, and where it is put."""
    return [*last.things[-1].places, *last.places, *order.things[0].places, *order.places]


def _is_with_it(order: Order) -> bool:
    """Whether things are to come along with what was just named: "and bring the nightstands with it"."""
    said = [w for phrase in order.things for w in phrase.places]
    told = order.places or order.closer or order.apart or order.direction or order.facing
    return bool(said) and not told and all(w.word == "with" and is_that(w.noun) for w in said)


def is_that(noun: Noun | None) -> bool:
    """Whether it is "it" or "them"."""
    return noun is not None and noun.kind == "pronoun" and noun.value in ("it", "them")


def _keeps_facing(order: Order) -> bool:
    """Whether an order keeps what was just named turned to something: "but keep them facing the window"."""
    places = [w for phrase in order.things for w in phrase.places]
    told = bool(order.facing or order.backs or places) and all(w.word == "facing" for w in places)
    return order.doing == "keep" and told and bool(order.things) and all(is_that(p.noun) for p in order.things)


def _keeps_by_it(order: Order) -> bool:
    """Whether an order keeps things where they stand to what was just named: "keep the chairs around it"."""
    nouns = [w.noun for phrase in order.things for w in phrase.places]
    return bool(nouns) and all(map(is_that, nouns))
