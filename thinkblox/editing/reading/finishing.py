"""What an order says as a whole, once all its words are read."""

import re

from thinkblox.editing.grammar import longest
from thinkblox.editing.heeding import SAID
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.reading.draft import OrderDraft, are_several
from thinkblox.editing.reading.sharing_out import comes_along
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.tokens import tokenise

_PILED = re.compile(r"\b(?:in|into) (?:a |one )?(?:neat )?(?:stack|pile|heap)s?\b")
"""How several things are to lie on each other."""
_LESS = ("smaller", "shorter", "narrower", "lower")


def finish(draft: OrderDraft) -> None:
    """Settle what only the whole order tells."""
    order = draft.order
    _is_followed(draft)
    _goes_somewhere(draft)
    order.slight &= not order.lengths
    if draft.fraction and order.change and not order.change.endswith("="):
        order.times = 1.0 + (-draft.fraction if order.change in _LESS else draft.fraction)
    elif draft.fraction:
        order.lost.append("by a part of it")
    _by_verb(draft)
    _closer_around(draft)
    if draft.pending is False and order.direction:
        draft.pending = None
    if draft.pending is not None:
        order.together, order.scatter = draft.pending, not draft.pending
    _spaced(draft)
    if draft.up_to and order.doing == "make" and order.change and not order.by:
        order.change = f"{order.change.removesuffix('=')}="
    somewhere = order.places and not order.things and not order.rest and not order.room
    if draft.clears and order.doing == "free" and not order.free and not order.space and not somewhere:
        order.doing = "clear"
    if order.doing == "keep" and order.total:
        order.doing = "only"
    if order.doing == "add" and _is_had_by_each(draft):
        order.doing = "ensure"
    _along(draft)
    if order.doing in ("add", "put", "ensure"):
        comes_along(draft, each=draft.eached)
    _nearer_one(draft)
    _beside_one(draft)
    _shared_out(draft)
    _looked(draft)


def _is_followed(draft: OrderDraft) -> None:
    """Lose what a result is told of where that has asked for nothing: "so that people feel at home".

    That there is more space comes of what is made smaller.
    """
    order = draft.order
    if draft.so and draft.unsaid == repr(order):
        order.lost += [phrase.text for phrase in draft.so]
    if order.doing == "make" and order.change in _LESS and order.free and order.things:
        order.purpose, order.free = [*order.purpose, *order.free], []


def _goes_somewhere(draft: OrderDraft) -> None:
    """Read "out of the way, against the wall" as to that place, which is said behind that it goes elsewhere."""
    order = draft.order
    later = draft.places()[draft.told :] if draft.told is not None else []
    if order.doing == "resite" and any(not w.negated and w.word not in ("from", "except") for w in later):
        order.doing = "move"


def _along(draft: OrderDraft) -> None:
    """Read "take the chair along" as what goes with that which was moved before it."""
    order = draft.order
    if order.doing == "move" and order.things and order.lost == ["along"] and not draft.places():
        order.lost = []
        order.things[-1].places.append(Where("with", Noun("pronoun", "it", 0, 0, "it"), text="along"))


def _nearer_one(draft: OrderDraft) -> None:
    """Read "(remove) the lamp closer to the door" as the one of several that is so."""
    order = draft.order
    for nearer, phrase in order.closer if order.doing in ("remove", "replace") and order.things else ():
        text = "nearest to" if nearer else "farthest from"
        order.things[-1].places.append(Where("near", phrase.noun, text=text))
    order.closer = [] if order.doing in ("remove", "replace") and order.things else order.closer


def _shared_out(draft: OrderDraft) -> None:
    """Read "I want four stools, two on each side of the island" as how many there are to be."""
    order = draft.order
    verb = longest("verbs", tokenise(order.text.lower()), 0)
    new = bool(order.things) and not order.things[-1].noun.definite
    if draft.shared and new and order.doing == "put" and verb is not None and verb[0] == "want":
        order.doing, order.total = "ensure", True


def _beside_one(draft: OrderDraft) -> None:
    """Read "(next to the desk) so that they stand side by side" as how one thing comes to stand beside another."""
    order, beside = draft.order, [w for w in draft.places() if w.word == "next_to" and not w.negated]
    if order.mutual == "next_to" and order.abreast and len(order.things) == 1 and beside:
        order.mutual = ""


def _by_verb(draft: OrderDraft) -> None:
    """What a verb says of the place: "centre the table" in the room, and "stack the books" is not followed."""
    order = draft.order
    order.centred |= draft.centring and order.doing in ("move", "put")
    if order.centred and order.things and not (draft.places() or order.closer or order.direction):
        middle = Noun("place", "centre", 0, 0, "the middle of the room", det="the")
        order.things[-1].places.append(Where("in", middle, text="in"))
    piled = draft.piling or _PILED.search(order.text.lower()) is not None
    if piled and (len(order.things) > 1 or any(map(are_several, order.things))):
        order.lost.append(order.text.split(" ", 1)[0].lower() if draft.piling else "in a pile")


def _closer_around(draft: OrderDraft) -> None:
    """Read "closer around the table" as closer to it."""
    around = next((w for w in draft.places() if w.word == "around" and w.noun is not None), None)
    if not draft.pending or around is None or around.noun is None:
        return
    draft.order.closer.append((True, NounPhrase(around.noun)))
    for held in (draft.order.places, *(phrase.places for phrase in draft.order.things)):
        held[:] = [w for w in held if w is not around]
    draft.pending = None


def _looked(draft: OrderDraft) -> None:
    """Tell a wish about looks, and what is to face something, from an order to move."""
    order = draft.order
    if order.doing == "put" and order.things and _is_about_looks(draft):
        order.doing = "make"
    if order.doing == "make" and _is_other_count(draft):
        order.doing, order.things, order.total = "ensure", order.things[1:], True
    if order.doing == "rearrange" and _only_faces(draft):
        order.doing = "turn"
    if order.doing == "make" and (order.facing or order.backs or order.mutual) and order.things and not order.room:
        order.doing = "turn"
    if draft.around and order.facing:
        order.turn = None
    if draft.around and order.backs:
        order.turn = None
    if order.doing == "remove" and order.facing and order.things:
        order.things[-1].places += [Where("facing", noun, text="facing") for noun in order.facing]
        order.facing = []
    if order.doing == "turn" and order.closer and not order.lengths and not any(near for near, _ in order.closer):
        order.backs += [phrase.noun for _, phrase in order.closer]
        order.closer = []
    if order.doing == "put" and _only_looks(draft):
        order.doing = "turn"


def _only_faces(draft: OrderDraft) -> bool:
    """Whether all that is said of how things are arranged is what they look at: "so that everyone can see the TV"."""
    order = draft.order
    known = bool(order.things) and all(p.noun.kind in ("thing", "pronoun") and not p.places for p in order.things)
    more = order.places or order.mutual or order.into or order.room or order.rest or order.split or order.lengths
    return bool(order.facing) and known and not more


def _is_other_count(draft: OrderDraft) -> bool:
    """Whether it is said how many there are to be: "make it three chairs"."""
    phrases = [phrase.noun for phrase in draft.order.things]
    pointed = len(phrases) == 2 and phrases[0].kind == "pronoun" and phrases[0].value in ("it", "them", "that")
    return pointed and phrases[1].kind == "thing" and bool(phrases[1].count) and not phrases[1].definite


def _spaced(draft: OrderDraft) -> None:
    """Read what is said of the space between things, or of more space at one of them."""
    order = draft.order
    about = [w for w in (*order.places, *(w for p in order.things for w in p.places)) if w.word == "between"]
    if (
        order.doing in ("free", "keep", "make", "move", "put")
        and about
        and (order.space or order.lengths)
        and (not order.things or order.doing in ("free", "keep"))
    ):
        order.doing, order.places = "gap", about[:1]
        more = draft.more and not order.lengths and not order.change
        order.change = "wider" if more else order.change
        compared = bool(order.change) and not order.change.endswith("=") and not draft.up_to
        order.by |= compared and bool(order.lengths) and not order.bound
    measured = order.doing in ("keep", "free", "make") and order.space and order.places and not order.things
    if measured and len(order.apart) == 1:
        order.lengths, order.apart = [(order.apart[0][0], "")], []
    if (order.doing == "put" or measured) and order.space and order.places and not order.things:
        order.doing = "free"


def _is_had_by_each(draft: OrderDraft) -> bool:
    """Whether it is said how many each of several has: "every table should have four chairs"."""
    counted = any((phrase.noun.count or 1) > 1 for phrase in draft.order.things)
    return draft.had and counted and any(w.noun is not None and w.noun.each for w in draft.places())


def _only_looks(draft: OrderDraft) -> bool:
    """Whether all that is asked of things is what they face: they are turned, and not moved far for that."""
    order = draft.order
    said = any(getattr(order, field) for field in SAID if field not in ("facing", "backs", "company", "rest", "spared"))
    whole = ("each", "all", "both")
    known = all(phrase.noun.definite or phrase.id or phrase.noun.det in whole for phrase in order.things)
    placed = any(phrase.places for phrase in order.things)
    return bool((order.facing or order.backs) and order.things) and known and not placed and not said


def _is_about_looks(draft: OrderDraft) -> bool:
    """Whether a wish is about how a thing is, not where: "I want the sofa bigger"."""
    order = draft.order
    placed = order.places or order.closer or order.direction or order.facing or any(p.places for p in order.things)
    sized = len(order.lengths) > 1 and not (order.mutual or order.apart or order.scatter or order.together)
    return not placed and bool(order.looks or order.ruled_out or order.change or sized)
