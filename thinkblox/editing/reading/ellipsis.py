"""Orders that share one verb: "make the wardrobe white and the desk black", "20 cm to the left and 10 cm forward"."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from thinkblox.editing.grammar import means
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reading.clause import Clause
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where

_SHARING = ("move", "put", "make", "turn", "swap", "replace")
_LINKS = (",", "and", "then", "but", "also")
_TO = ("to", "into", "onto", "against", "over to")
ReadClause = Callable[[Clause], Order]


def each_order(clause: Clause, read: ReadClause) -> Iterator[Order]:
    """The orders of a clause: more than one where parts of it say each what and how, or how each way.

    Args:
        clause: with one verb.
        read: reads a clause as one order.
    """
    whole = _of_looks(read(clause))
    if _looks_and_stands(whole):
        yield replace(whole, doing="make", things=[replace(p, places=[]) for p in whole.things], places=[])
        yield replace(whole, doing="put", looks=[], ruled_out=[], change="", lost=[])
        return
    if _looks_and_more(whole):
        known, *new = whole.things
        yield replace(whole, doing="make", things=[known], places=[], company=[])
        yield replace(whole, doing="put", things=new, looks=[], ruled_out=[], change="", lost=[])
        return
    if clause.doing not in _SHARING or whole.doing not in _SHARING:
        yield whole
        return
    for end, begin in _joints(clause):
        parts = [replace(clause, tokens=clause.tokens[:end]), replace(clause, tokens=clause.tokens[begin:])]
        first, second = (read(part) for part in parts)
        if len(first.lost) + len(second.lost) > len(whole.lost):
            continue
        if _is_step(first) and _is_step(second) and first.things and not second.things and not second.places:
            second.things = [_again(first)]
            yield from (first, second)
            return
        if (
            (first.things or first.room)
            and _is_change(first)
            and (_is_change(second) or _is_size(second))
            and not second.looks
        ):
            if second.things or second.room:
                continue
            second.things, second.room = [_again(first)] if first.things else [], first.room
            yield from (first, second)
            return
        if _are_two(first, second):
            yield first
            yield from each_order(parts[1], read)
            return
    yield whole


def _of_looks(order: Order) -> Order:
    """An order that says how a thing is to look, which is told by its distance, as one that makes it so."""
    return replace(order, doing="make") if _looks_and_stands(order) and _is_told_by_distance(order) else order


def stand_between(last: Order | None, order: Order) -> None:
    """Let "in between" be between the two that the order before has named: "put a bin in between".

    Raises:
        InputError: it has not named two.
    """
    nouns = [phrase.noun for phrase in last.things] if last is not None else []
    said = [phrase.noun for _, phrase in (*last.closer, *last.apart)] if last is not None else []
    said += [w.noun for p in last.things for w in p.places if w.noun is not None] if last is not None else []
    known = [noun for noun in (*nouns, *said) if noun.kind in ("thing", "place") and noun.definite]
    if len(known) != 2 or len(order.things) != 1 or order.things[0].places:
        raise InputError(f"'{order.text}': between what? Name the two things")
    order.things[0].places.append(Where("between", known[0], second=known[1], text="between"))
    order.lost = []


def _looks_and_stands(order: Order) -> bool:
    """Whether it says of a thing that is there how it is to look, and where it is to be: "green, and by the door"."""
    known = bool(order.things) and all(phrase.noun.definite or phrase.id for phrase in order.things)
    placed = bool(order.places) or any(phrase.places for phrase in order.things)
    return order.doing == "put" and bool(order.looks) and known and placed and not order.lengths


def _is_told_by_distance(order: Order) -> bool:
    """Whether its only place says which of several it is about: "the armchair closer to the door should be red"."""
    places = [*order.places, *(where for phrase in order.things for where in phrase.places)]
    return all(where.word in ("near", "far") and _is_superlative(where.text) for where in places)


def _is_superlative(text: str) -> bool:
    return any(means(section, word) for word in text.lower().split() for section in ("nearest", "nearer_of_two"))


def _looks_and_more(order: Order) -> bool:
    """Whether it says how one thing is to look, and what else is to be there: "the sofa in green and a lamp by it"."""
    known = [phrase.noun.definite or bool(phrase.id) for phrase in order.things]
    first = known[:1] == [True] and not order.things[0].places and len(known) > 1 and not any(known[1:])
    placed = bool(order.places) or all(phrase.places for phrase in order.things[1:])
    return order.doing == "put" and bool(order.looks) and first and placed and not order.lengths


def _joints(clause: Clause) -> Iterator[tuple[int, int]]:
    """Where one part ends, and where the next begins."""
    tokens = clause.tokens
    for end in range(1, len(tokens) - 1):
        if tokens[end].text in _LINKS and tokens[end - 1].text not in _LINKS:
            begin = end + 1
            while begin < len(tokens) and tokens[begin].text in _LINKS:
                begin += 1
            if begin < len(tokens):
                yield end, begin


def _are_two(first: Order, second: Order) -> bool:
    """Whether both parts say what they are about, and how that is to be."""
    named = bool(first.things and second.things)
    if not named or second.things[0].noun.kind not in ("thing", "pronoun", "number") or _is_of_before(second):
        return False
    if first.doing == "replace":
        return bool(first.instead and second.instead) and second.things[0].noun.definite
    if first.doing == "swap":
        return first.split == second.split == 1 and len(first.things) == len(second.things) == 2
    if _at_spot(first) and any(phrase.places for phrase in second.things):
        return True
    if _is_mutual_beside(first, second) or _is_mutual_beside(second, first):
        return True
    placed = any(where.text.lower() in _TO for phrase in second.things for where in phrase.places)
    return _says_how(first) and (_says_how(second) or (placed and not first.closer))


def _is_mutual_beside(one: Order, other: Order) -> bool:
    """Whether only one part says how things stand to each other: "the desk at the wall and the chairs side by side"."""
    several = len(one.things) > 1 or any(phrase.noun.many for phrase in one.things)
    placed = _says_how(other) or any(phrase.places for phrase in other.things)
    return bool(one.mutual) and several and not other.mutual and placed


def _is_of_before(order: Order) -> bool:
    noun = order.things[0].noun
    return noun.kind == "number" and not noun.definite


def _says_how(order: Order) -> bool:
    looks = order.looks or (order.change and order.doing in ("make", "put")) or order.lengths
    return bool(looks or order.direction or order.turn is not None or order.closer or order.apart or order.facing)


def _at_spot(order: Order) -> bool:
    return any(where.word == "spot" for phrase in order.things for where in phrase.places)


def _is_change(order: Order) -> bool:
    """Whether it says how the size of a thing or the room changes."""
    return order.doing == "make" and bool(order.change) and not order.change.endswith("=")


def _is_size(order: Order) -> bool:
    """Whether it says how large a side of a thing is to be: "2 m wide"."""
    return order.doing == "make" and not order.change and any(axis for _, axis in order.lengths)


def _is_step(order: Order) -> bool:
    """Whether it says by how much, or a bit, which way."""
    return order.doing in ("move", "put") and bool(order.direction)


def _again(order: Order) -> NounPhrase:
    """What the part before was about."""
    word = "them" if len(order.things) > 1 or order.things[0].noun.many else "it"
    return NounPhrase(Noun("pronoun", word, 0, 0, word))
