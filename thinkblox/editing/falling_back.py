"""What is done only where something else cannot be: "..., otherwise ...", "remove the stool if it is in the way"."""

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import Instruction, NounPhrase, Order
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.scene import Scene

_CANNOT = r"(?:doesn't|does not|don't|do not|won't|will not|can't|cannot|didn't)"
_ELSE = re.compile(
    rf"[\s,;.]+(?:and |but )?(?:if (?:it|that|they|this) {_CANNOT} (?:fit|work|go)(?: there| in)?"
    r"|otherwise|or else|else|if not)[\s,]+(?:then )?",
    re.IGNORECASE,
)
_IN_WAY = re.compile(
    r"[\s,;.]+(?:and |but )?(?P<other>(?:remove|move away|take away|get rid of) [^,;.]+?)"
    r"(?: if (?:it is|it's|they are|they're|that is|that's)| that is| which is| that are)? in (?:the|its) way",
    re.IGNORECASE,
)
_SENTENCE = re.compile(r"[.;!?]")
_MAKING_ROOM = ("remove", "clear", "free", "make")
_AGAIN = ("it", "them")


@dataclass(frozen=True)
class Reading:
    """One way in which an instruction may be carried out.

    Attributes:
        instruction: its orders.
        says: what is noted where it is carried out so.
    """

    instruction: Instruction
    says: str = ""


def readings(text: str, scene: Scene) -> Iterator[Reading]:
    """The ways in which an instruction may be carried out, the next where one cannot be; one where it names no other.

    What makes room ("if it doesn't fit, remove the cabinet") is followed by what needs that, anything else comes
    instead of it.

    Raises:
        InputError: as `read_instruction`.
    """
    ids = [p.id for p in scene.placements]
    found = _IN_WAY.search(text) or _ELSE.search(text) if isinstance(text, str) else None
    first = text[: found.start()] if found is not None else ""
    if found is None or not first.strip():
        yield Reading(read_instruction(text, ids))
        if (freed := _freed_first(read_instruction(text, ids))) is not None:
            yield Reading(freed, "What goes was taken away first, as what comes has no room beside it.")
        return
    other, rest = (
        (found["other"], text[found.end() :]) if "other" in found.groupdict() else _parted(text[found.end() :])
    )
    known = read_instruction(first, ids)
    later = read_instruction(rest, ids) if rest.strip(" .;!?,") else Instruction("", (), ())
    yield Reading(
        Instruction(text, (*known.orders, *later.orders), (*known.unknown, *later.unknown)),
        f"'{other}' was not needed.",
    )
    for orders, unknown in _others(first, other, ids, scene):
        again = read_instruction(rest, ids).orders if later.orders else ()
        says = f"'{known.orders[-1].text}' could not be done by itself, so '{other}' was done."
        yield Reading(Instruction(text, (*orders, *again), (*unknown, *later.unknown)), says)


def _freed_first(read: Instruction) -> Instruction | None:
    """The orders with what is taken away before what comes: "add a desk and take out the armchair".

    None where nothing is, or "it" may be what was named before.
    """
    gone = [order for order in read.orders if order.doing == "remove"]
    places = [w for order in read.orders for w in (*order.places, *(w for p in order.things for w in p.places))]
    nouns = [noun for where in places for noun in (where.noun, where.whole, where.second) if noun is not None]
    nouns += [phrase.noun for order in read.orders for phrase in order.things]
    again = any(noun.kind == "pronoun" or noun.det == "my" for noun in nouns)
    orders = (*gone, *(order for order in read.orders if order not in gone))
    return replace(read, orders=orders) if gone and not again and orders != read.orders else None


def _parted(text: str) -> tuple[str, str]:
    """A sentence, and what follows it."""
    end = _SENTENCE.search(text)
    return (text[: end.start()], text[end.end() :]) if end is not None else (text, "")


def _others(
    first: str, other: str, ids: Collection[str], scene: Scene
) -> Iterator[tuple[tuple[Order, ...], tuple[str, ...]]]:
    """The orders with what is to be done where the last of the first cannot be.

    Raises:
        InputError: it cannot be read.
    """
    try:
        said = read_instruction(other, ids)
    except InputError:
        said = read_instruction(f"put it {other}", ids)
        known = read_instruction(first, ids)
        places = said.orders[0].things[0].places if said.orders and said.orders[0].things else []
        if not places or not known.orders[-1].things:
            raise
        last = known.orders[-1]
        things = [replace(phrase, places=list(places)) for phrase in last.things]
        yield (*known.orders[:-1], replace(last, things=things, places=[])), said.unknown
        return
    for choice in _each_meant(said.orders[0], scene):
        known, said = read_instruction(first, ids), read_instruction(other, ids)
        orders = [_of(said.orders[0], choice), *said.orders[1:]] if choice else list(said.orders)
        if _makes_room(orders[0]):
            yield (*known.orders[:-1], *orders, known.orders[-1]), (*known.unknown, *said.unknown)
        else:
            yield (*known.orders[:-1], *_named_in(known.orders[-1], orders)), (*known.unknown, *said.unknown)


def _makes_room(order: Order) -> bool:
    """Whether it is about something else than what does not fit."""
    about = [phrase.noun for phrase in order.things]
    again = any(noun.kind == "pronoun" and noun.value in _AGAIN for noun in about)
    return not again and (order.doing in _MAKING_ROOM or (order.doing == "move" and bool(about)))


def _named_in(last: Order, orders: list[Order]) -> list[Order]:
    """The orders with what the last one is about in place of "it"."""
    for order in orders:
        for phrase in order.things:
            if phrase.noun.kind == "pronoun" and phrase.noun.value in _AGAIN and last.things:
                phrase.noun, phrase.id = last.things[-1].noun, last.things[-1].id
    return orders


def _each_meant(order: Order, scene: Scene) -> list[str]:
    """Each thing that the one which is in the way may be; one empty text where it is known, or several are named."""
    one = order.things[0] if len(order.things) == 1 else None
    if one is None or one.id or one.noun.kind != "thing" or one.noun.many or one.places:
        return [""]
    found = [p.id for p in Finder(scene).matching(one.noun)]
    return found if len(found) > 1 else [""]


def _of(order: Order, id: str) -> Order:
    return replace(order, things=[NounPhrase(order.things[0].noun, id=id)])
