"""Prepositions, verbs and other words between the nouns of an order."""

from thinkblox.assets import facts_of
from thinkblox.editing.grammar import means
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.reading.cutting import Item, OrderMark
from thinkblox.editing.reading.draft import BEING, OF_THOSE, SPOT, OrderDraft
from thinkblox.editing.reading.facing import is_back, read_facing, takes_compass, takes_with_side
from thinkblox.editing.reading.going_along import takes_all_on_it
from thinkblox.editing.reading.locating import read_spot, read_where
from thinkblox.editing.reading.phrasing import merged
from thinkblox.editing.reading.placing import attach, place
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Adjective, Connector, Measured, Noun
from thinkblox.reading.english.nodes import Where

_SHAPES = ("round",)
_OF_LOOKS = ("make", "replace", "add", "put", "ensure")
"""Orders in which "in grey" is how something is to look."""
_TOWARDS = ("to", "to face", "facing", "face", "towards", "toward")
_OF_NEW = ("add", "put", "ensure", "replace")
_OF_TWO = {"face to face": "face_to_face", "back to back": "back_to_back"}
"""How two things stand that are brought together so."""


def read_connector(draft: OrderDraft, link: Connector) -> None:
    """Take a word between nouns."""
    match link.sort:
        case "prepositions":
            _preposition(draft, link)
        case "negations" if link.value == "not":
            draft.negated = True
        case "negations" if link.value == "only" and draft.mode == "instead":
            draft.only = True
        case "negations" if link.value == "only" and draft.order.doing in ("keep", "ensure"):
            draft.order.total |= not draft.order.rest
        case "verbs" if link.value in ("face", *BEING):
            _verb(draft, link)
        case "mutual":
            _mutual(draft, link)
        case "joins" if link.text.lower() in SPOT and (noun := read_spot(draft)) is not None:
            attach(draft, Where("spot", noun, text=link.text))
        case "joins" if link.value in ("or", "stop", "but"):
            _join(draft, link)
        case "joins" | "mark" | "participles" | "fillers":
            pass
        case _:
            draft.lose(link)


def _verb(draft: OrderDraft, link: Connector) -> None:
    if link.value == "face":
        read_facing(draft)
    elif draft.mode == "so" and _is_free_next(draft):
        draft.order.free += [phrase.noun for phrase in draft.so]
    elif _is_other_order(draft, link):
        raise InputError(f"'{draft.order.text}': '{link.text}' begins another order; give each as a sentence")


def _is_other_order(draft: OrderDraft, link: Connector) -> bool:
    """Whether a verb behind "and" would begin an order of another kind: "remove this and stand that there"."""
    before = draft.before()
    joined = isinstance(before, Connector) and before.text.lower() in ("and", "then")
    return joined and draft.order.doing in OF_THOSE and means("verbs", link.text.lower()) == "put"


def _join(draft: OrderDraft, link: Connector) -> None:
    """Read "all of the chairs but one"; "or" and reasons are not followed."""
    if link.value != "but":
        draft.lose(link)
    elif (_is_exception(draft) or _is_of_places(draft)) and (noun := draft.next_noun()) is not None:
        place(draft, Where("except", merged(draft, noun), text=link.text))


def _is_exception(draft: OrderDraft) -> bool:
    noun = draft.ahead()
    said = draft.order.things[-1].noun if draft.order.things else None
    if said is None and draft.order.rest:
        return isinstance(noun, Noun) and noun.kind == "thing"
    every = said is not None and (said.det in ("all", "each") or said.plural)
    counted = isinstance(noun, Noun) and noun.kind in ("thing", "number", "pronoun")
    return every and counted and draft.mode in ("things", "instead")


def _is_of_places(draft: OrderDraft) -> bool:
    """Whether it excepts some of the places at each of which something is put: "on every table but the last"."""
    noun, places = draft.ahead(), draft.places()[-1:]
    each = bool(places) and places[0].noun is not None and places[0].noun.each
    return each and isinstance(noun, Noun) and noun.kind in ("thing", "number", "pronoun")


def _mutual(draft: OrderDraft, link: Connector) -> None:
    """Read "so that they face each other", "next to each other", or not so."""
    things = draft.order.things
    if draft.negated:
        draft.negated = False
        if link.value != "next_to" or len(things) != 2 or draft.order.doing not in ("move", "put"):
            draft.order.lost.append(f"not {link.text}")
            return
        things[0].places.append(Where("next_to", things.pop().noun, negated=True, text=link.text))
    elif link.value == "in_row" and draft.order.doing in ("add", "put", "move") and things:
        draft.order.in_line = True
    elif link.text.lower() in _OF_TWO:
        _of_two(draft, _OF_TWO[link.text.lower()], link)
    elif (link.value == "facing" and draft.order.doing in ("move", "put", "turn", "rearrange", "make")) or (
        link.value == "next_to" and draft.order.doing in ("move", "put", "add", "turn")
    ):
        draft.order.doing = "move" if link.value == "next_to" and draft.order.doing == "turn" else draft.order.doing
        draft.order.mutual = link.value
        draft.order.abreast |= link.text.lower() == "side by side"
    elif link.value == "next_to" and draft.order.doing == "replace" and draft.mode == "instead":
        draft.order.abreast = True
    else:
        draft.lose(link)


def _of_two(draft: OrderDraft, mutual: str, link: Connector) -> None:
    """Read "face to face", "back to back" of two things that are moved; such things are not turned alone.

    Raises:
        InputError: the order is no such.
    """
    if draft.order.doing not in ("move", "put"):
        raise InputError(
            f"'{draft.order.text}': how things stand '{link.text}' is followed where two are put so; say 'put'"
        )
    draft.order.mutual = mutual


def _is_free_next(draft: OrderDraft) -> bool:
    item = draft.ahead()
    free = isinstance(item, Connector | Noun) and bool(means("clear", item.text.lower()))
    draft.at += free
    return free


def _preposition(draft: OrderDraft, link: Connector) -> None:
    order, following = draft.order, draft.ahead()
    if not isinstance(following, Noun):
        _without_noun(draft, link, following)
        return
    _narrowed(draft)
    if _with_own(draft, link, following):
        return
    towards = link.text.lower() in ("towards", "toward")
    if _comes_instead(draft, link, following):
        draft.mode = "instead"
    elif order.doing == "swap" and link.value in ("with", "for", "and"):
        order.split = order.split or len(order.things)
    elif _becomes(draft, link, following) or _is_purpose(draft, link, following):
        draft.at += 1
    elif towards and order.doing in ("move", "put"):
        draft.pending = True
    elif order.doing == "turn" and link.value == "at" and not towards and (draft.excepted or _faces_later(draft)):
        place(draft, read_where(draft, link))
    elif order.doing == "turn" and (towards or link.value in ("to", "facing", "at", "in_front_of")):
        read_facing(draft)
    elif not (following.kind in ("part", "place") and following.value == "ceiling" and order.doing == "make"):
        place(draft, read_where(draft, link))


def _with_own(draft: OrderDraft, link: Connector, following: Noun) -> bool:
    """Take "with its back (to it)", "with its long side along it", "with everything on it"; whether it was that."""
    if link.value == "with" and takes_with_side(draft, following):
        return True
    if link.value == "with" and following.kind == "part" and following.value in ("back", "head"):
        following.det = "my" if following.det == "the" else following.det
    return (link.value in ("with", "so") and is_back(following)) or takes_all_on_it(draft, link, following)


def _faces_later(draft: OrderDraft) -> bool:
    """Whether what things are to face is still to come: "turn the chairs at the table towards the door"."""
    later = draft.items[draft.at :]
    return any(isinstance(item, Connector) and item.text.lower() in _TOWARDS for item in later)


def _becomes(draft: OrderDraft, link: Connector, following: Noun) -> bool:
    """Read "into a reading corner"; "in the room" says nothing."""
    order = draft.order
    into = link.text.lower() == "into" and order.doing in ("turn", "make")
    if into and following.kind == "thing" and order.things:
        order.doing, draft.mode = "replace", "instead"
        draft.at -= 1
        return True
    if following.kind != "room":
        return False
    turned = order.doing == "turn" and following.det == "the"
    if link.text.lower() == "into" and order.doing in ("move", "put") and order.lengths and not order.closer:
        order.closer.append((False, NounPhrase(Noun("place", "wall", 0, 0, "the wall", det="the"))))
        return True
    if order.doing in ("rearrange", "make", "replace", "turn") and link.value in ("in", "as") and not turned:
        order.into = following.value if order.doing != "make" else ""
        order.doing = "rearrange" if order.doing in ("turn", "replace") else order.doing
        return True
    return link.value in ("in", "of", "from", "to", "around")


def _is_purpose(draft: OrderDraft, link: Connector, following: Noun) -> bool:
    """Whether words say what for: "make room for a wheelchair", "a chair for the teacher", "a shelf for toys"."""
    if link.value != "for":
        return False
    new = draft.new_thing()
    people = following.kind == "people" or (following.kind == "number" and not following.det)
    table = new is not None and (new.value == "any_table" or facts_of(new.value).is_in("tables"))
    if people and following.count and table and new is not None:
        new.attributes.append(f"for-{following.count}")
        return True
    told = following.det == "the" and not following.plural
    kept_in_it = following.kind == "thing" and following.plural and not (following.det or following.count)
    if (following.kind == "people" and not told) or (kept_in_it and draft.order.doing in _OF_NEW):
        draft.order.purpose.append(following)
        return True
    if following.kind == "people":
        draft.order.lost.append(f"{link.text} {following.text}")
    elif draft.order.doing in ("free", "gap"):
        draft.order.purpose.append(following)
    return following.kind == "people" or draft.order.doing in ("free", "gap")


def _without_noun(draft: OrderDraft, link: Connector, following: Item | None) -> None:
    """A preposition that no noun follows says how a thing is, waits for a length, or is lost."""
    order, text = draft.order, link.text.lower()
    if isinstance(following, Connector) and following.text.lower() in SPOT:
        return
    if link.value == "facing" and takes_compass(draft, following):
        return
    if text in _SHAPES and order.doing in ("make", "put") and order.things:
        order.looks.append(text)
    elif (isinstance(following, Adjective) and order.doing in _OF_LOOKS and link.value in ("to", "in")) or (
        link.value == "of" and isinstance(following, Noun | OrderMark)
    ):
        pass
    elif not isinstance(following, OrderMark | Measured | Connector) or (
        isinstance(following, Connector) and following.sort not in ("prepositions", "verbs", "fillers", "mutual")
    ):
        draft.lose(link)


def _narrowed(draft: OrderDraft) -> None:
    """After "but only" places say which things are meant: "change the chairs for stools but only at a desk"."""
    if draft.mode == "instead" and draft.only:
        draft.mode, draft.only = "things", False


def _comes_instead(draft: OrderDraft, link: Connector, following: Noun) -> bool:
    """Whether what follows comes in place of the thing: "replace A with a B", "swap A for a B"."""
    order = draft.order
    if following.kind not in ("thing", "number") or not order.things:
        return False
    if link.value == "for" and order.instead and following.kind == "number":
        return False
    pointed = following.of_known or following.definite or following.id or following.det in ("the", "other")
    new = not pointed and (following.det in ("a", "another", "") or (following.kind == "number" and not following.rows))
    if order.doing == "replace":
        return link.value in ("with", "by", "for") or (link.value in ("in", "to") and new)
    if order.doing == "swap" and (link.value == "for" or (link.value == "with" and new)) and new:
        order.doing = "replace"
        return True
    return False
