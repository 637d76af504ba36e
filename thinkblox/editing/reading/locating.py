"""A preposition and the nouns behind it as one place: "in the corner by the window"."""

from dataclasses import replace
from typing import cast

from thinkblox.editing.reading.cutting import Item
from thinkblox.editing.reading.draft import ASIDE, BEING, IN_ROW, SIDED, SPOT, OrderDraft
from thinkblox.editing.reading.phrasing import merged
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.nodes import Where

_OF_WALL = ("opposite", "behind", "facing")
_ACROSS = ("opposite", "far", "facing")


def read_spot(draft: OrderDraft) -> Noun | None:
    """Read "(where) the bookcase stands"; None where something else follows."""
    noun, verb = (draft.ahead(), draft.ahead(1))
    told = isinstance(verb, Connector) and verb.sort in ("verbs", "participles") and verb.value in (*BEING, "stand")
    if not isinstance(noun, Noun) or noun.kind not in ("thing", "pronoun", "number") or not told:
        return None
    draft.at += 2
    return merged(draft, noun) if noun.kind == "thing" else noun


def read_where(draft: OrderDraft, link: Connector) -> Where:
    """Read the place that a preposition begins."""
    word = "from" if link.text.lower() == "out of" else link.value
    where = Where(word, None, negated=draft.negated, text=link.text)
    draft.negated = False
    noun = draft.next_noun()
    noun = _one_of_several(draft, noun) if noun is not None else None
    where.noun = merged(draft, noun) if noun is not None else None
    if link.value == "per" and where.noun is not None:
        where.word, where.noun = "to", replace(where.noun, det="each")
    if where.noun is not None and where.noun.value == "wall" and "new" in where.noun.text.lower().split():
        where.noun = replace(where.noun, states=["new"])
    item = draft.ahead()
    if isinstance(item, Connector) and item.value == "of" and where.noun is not None:
        draft.at += 1
        whole = draft.next_noun()
        where.whole = merged(draft, whole) if whole is not None and whole.kind == "number" else whole
    elif _is_side_of_it(draft, where.noun):
        where.whole = Noun("pronoun", "it", 0, 0, "it")
    elif _is_other_part(draft, where.noun):
        where.whole = draft.whole
    draft.whole = where.whole or draft.whole
    if link.value == "between" and _is_and(draft):
        draft.at += 1
        where.second = draft.next_noun()
    return with_corner(draft, where)


def _one_of_several(draft: OrderDraft, noun: Noun) -> Noun:
    """Read "(a lamp on each nightstand and a book on) the one on the left" as one of those named before."""
    several = draft.former[-1] if draft.former else None
    one = noun.kind == "number" and noun.text.lower() in ("the one", "the ones")
    if not one or several is None or several.kind != "thing" or not (several.each or several.many):
        return noun
    plural = noun.text.lower() == "the ones"
    one_of = replace(several, det="the", count=None, plural=plural, text=f"the {several.word}")
    link, side = draft.ahead(), draft.ahead(1)
    sided = isinstance(link, Connector) and link.value == "on" and isinstance(side, Noun) and side.kind == "part"
    if sided and isinstance(side, Noun) and side.value in ("left", "right") and not side.owner:
        draft.at += 2
        return replace(one_of, side=side.value, text=f"the {side.value} {several.word}")
    return one_of


def _is_other_part(draft: OrderDraft, noun: Noun | None) -> bool:
    """Whether it is a part of what another thing goes to a part of: "to the left end of it, the lamp to the right".

    What is said of one thing alone is a part of the room.
    """
    part = noun is not None and noun.kind == "part" and noun.value in (*IN_ROW, *SIDED) and not noun.owner
    return part and draft.whole is not None and len(draft.order.things) > 1


def _is_side_of_it(draft: OrderDraft, noun: Noun | None) -> bool:
    """Whether an order to add names sides or ends, and not of what: "add two chairs at the ends"."""
    sided = noun is not None and noun.kind == "part" and noun.value in SIDED and not noun.owner
    return sided and draft.order.doing in ("add", "put") and noun is not None and (noun.plural or noun.each)


def with_corner(draft: OrderDraft, where: Where) -> Where:
    """Read "the corner by the window", "the corner opposite the door" as one place."""
    noun, link = where.noun, draft.ahead()
    beside = draft.ahead(1)
    cornered = noun is not None and noun.kind == "place" and noun.value.split()[0] in ("corner", "wall")
    if where.word == "from" and isinstance(link, Connector) and link.text.lower() == "to":
        return where
    if not cornered or noun is None or where.whole is not None or _told_by(draft, where, noun, link, beside):
        return where
    each = noun.each or noun.plural
    if each and (not isinstance(link, Connector) or link.value not in ASIDE or not noun.value.startswith("corner")):
        return where
    if noun.value.startswith("wall") and (not isinstance(link, Connector) or link.value not in _OF_WALL):
        return where
    if (
        not isinstance(link, Connector)
        or not isinstance(beside, Noun)
        or link.value not in (*ASIDE, *_ACROSS, "behind")
    ):
        return where
    if beside.kind in ("number", "pronoun"):
        beside = merged(draft, beside)
    if beside.kind not in ("place", "thing"):
        return where
    if each and beside.kind != "place":
        return where
    draft.at += 2
    if link.value in _ACROSS:
        where.second = beside
    else:
        where.whole = beside
    return where


def _told_by(draft: OrderDraft, where: Where, noun: Noun, link: Item | None, beside: Item | None) -> bool:
    """Read "the corner where the plant is", "the wall with the window"; whether it was that."""
    if isinstance(link, Connector) and link.text.lower() in SPOT:
        draft.at += 1
        where.whole = read_spot(draft)
        draft.at -= where.whole is None
        return True
    if not noun.value.startswith("wall") or not _is_wall_of(noun, link, beside):
        return False
    draft.at += 2
    where.noun = replace(noun, text="the wall with", states=[], unshown=[])
    where.whole = cast(Noun, beside)
    return True


def _is_wall_of(wall: Noun, link: Item | None, item: Item | None) -> bool:
    """Whether a wall is told by what is at it: "the same wall as the door", "the wall with the window"."""
    word = "as" if "same" in wall.text.lower().split() else "with"
    if not isinstance(link, Connector) or link.value != word or not isinstance(item, Noun):
        return False
    opening = item.kind == "place" and item.value.split()[0] in ("window", "door")
    return opening or (item.kind == "thing" and item.definite)


def _is_and(draft: OrderDraft) -> bool:
    item = draft.ahead()
    after = draft.ahead(1)
    return isinstance(item, Connector) and item.sort == "joins" and isinstance(after, Noun)
