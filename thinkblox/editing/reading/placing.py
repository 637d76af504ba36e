"""A place that an order names: of what, or what else it says."""

from dataclasses import replace

from thinkblox.editing.grammar import means
from thinkblox.editing.orders import AWAY_SIDE, INSTEAD, NounPhrase
from thinkblox.editing.reading.draft import IN_ROW, SIDED, WITH_ALONG, OrderDraft, is_it
from thinkblox.editing.reading.facing import takes_lengthwise
from thinkblox.editing.reading.going_along import takes_along, takes_rider
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.english.rooms import COMPASS

_ON_KNOWN = ("move", "turn", "replace", "remove", "swap", "free", "resite", "make", "keep", "only")
"""Orders whose things are in the room already."""
_INTO = ("to", "onto", "into")


def place(draft: OrderDraft, where: Where) -> None:
    """Take a place, or what else a preposition and its nouns say."""
    order = draft.order
    if where.word == "except" and where.noun is not None:
        _except(draft, where.noun)
        return
    if where.word == "instead" and where.noun is not None:
        _instead_of(draft, where, where.noun)
        return
    if where.word == "as" and where.noun is not None and where.noun.value == "possible":
        _utmost(draft, draft.places()[-1] if draft.places() else where)
        return
    if "possible" in where.text.lower().split():
        _utmost(draft, where)
    said: tuple[bool, ...] = (_is_on_new(draft, where), _is_on_what_bears(draft, where), _is_like_those(draft, where))
    said = (*said, _tells_side(draft, where), _takes_height(draft, where), _is_across_it(draft, where))
    if any(said) or _is_without_gap(draft, where):
        return
    order.centred |= where.word == "between" and bool(means("halfway", where.text.lower().split()[0]))
    on_it = where.noun is not None and is_it(where.noun)
    _refer(draft, where)
    if takes_along(draft, where) or (on_it and takes_rider(draft, where)):
        return
    of_wall = bool(order.closer) and where.word == "with"
    far_off = draft.distance and bool(order.lengths) and where.word not in ("between", "to", "along")
    if far_off and where.noun is not None and not of_wall:
        draft.distance = False
        phrase = NounPhrase(where.noun, id=where.noun.id)
        order.apart.append((order.lengths.pop()[0], phrase))
        draft.anchors = [where.noun]
        if where.word in ("from", "far", "near", "next_to", "by"):
            return
    attach(draft, where)


def _is_across_it(draft: OrderDraft, where: Where) -> bool:
    """Take "(turn them to face each other) across the table" as what is between them; whether it was that."""
    order, noun = draft.order, where.noun
    over = order.doing == "turn" and order.mutual == "facing" and where.text.lower() in ("across", "over")
    order.across += [noun] if over and noun is not None else []
    return over and noun is not None


def _takes_height(draft: OrderDraft, where: Where) -> bool:
    """Take "at the same height", "level with it" as how high something is to hang; whether it was that."""
    order, noun = draft.order, where.noun
    if noun is None or order.doing not in ("add", "put", "move"):
        return False
    beside = [w.noun for w in draft.places() if w.word in ("next_to", "left_of", "right_of", "near", "by")]
    words = where.text.lower().split()
    if words[-1:] == ["with"] and {"level", "height"} & {*words} and noun.kind in ("thing", "pronoun"):
        order.level = [mark for mark in beside[-1:] if is_it(noun) and mark is not None] or [noun]
        return True
    same = noun.kind == "abstract" and noun.word in ("height", "level") and "same" in noun.text.lower().split()
    order.level = [mark for mark in beside[-1:] if same and mark is not None]
    return bool(order.level)


_TOWARDS = ("facing", "near", "next_to", "by", "opposite")
"""Prepositions before what a side of a thing is towards."""


def _tells_side(draft: OrderDraft, where: Where) -> bool:
    """Take "(the chairs on the side) facing the window" as which side of a thing that is; whether it was that."""
    places = draft.places()
    side, noun = places[-1] if places else None, where.noun
    part = side.noun if side is not None else None
    one = part is not None and part.kind == "part" and part.value in ("side", "end") and not (part.plural or part.each)
    known = noun is not None and noun.kind in ("place", "thing") and noun.definite and not where.negated
    far = any(means("nearest", word) == "farthest" for word in where.text.lower().split())
    if not one or not known or side is None or side.second is not None or where.word not in (*_TOWARDS, "far"):
        return False
    if where.word == "far" and not far:
        return False
    side.second, side.text = noun, AWAY_SIDE if far else side.text
    return True


def _except(draft: OrderDraft, noun: Noun) -> None:
    """Take what is excepted: of things, or of the places at each of which something is put."""
    order = draft.order
    draft.excepted = NounPhrase(noun, id=noun.id)
    each = [w.noun for w in draft.places() if w.noun is not None and w.noun.each]
    if order.doing not in ("add", "put", "ensure") or not each:
        (order.things[-1].spared if order.things else order.spared).append(draft.excepted)
        return
    if noun.text.lower() in ("the one", "the ones", "one"):
        kind = replace(noun, kind="thing", value=each[0].value, named=True, det=noun.det or "the")
        draft.excepted = NounPhrase(kind)
    order.besides.append(draft.excepted)


def _is_on_new(draft: OrderDraft, where: Where) -> bool:
    """Whether what comes along with a new thing is said to be on that: "two tables with a lamp on each"."""
    order, noun = draft.order, where.noun
    said = order.things[-1].places[-1:] if order.things and not order.company else []
    along = bool(order.company) or (bool(said) and said[0].word == "with")
    new = order.doing in ("add", "put", "ensure") and along and bool(order.things)
    it = noun is not None and noun.kind == "pronoun" and noun.value in ("it", "them", "each")
    return new and it and where.word in ("on", "on_top") and not order.things[-1].noun.definite


def _is_on_what_bears(draft: OrderDraft, where: Where) -> bool:
    """Whether it is the end of "(keep) the sideboard with the vase on it", which is told by that."""
    said = draft.order.things[-1].places[-1:] if draft.order.things else []
    bears = bool(said) and said[0].word == "with" and said[0].noun is not None and said[0].noun.kind == "thing"
    return bears and where.word in ("on", "on_top") and where.noun is not None and is_it(where.noun)


def _is_like_those(draft: OrderDraft, where: Where) -> bool:
    """Whether a new thing is to be "like the others", as it is anyway."""
    other = where.noun is not None and where.noun.det == "other"
    return where.word == "as" and other and draft.order.doing in ("add", "put", "ensure")


def _is_without_gap(draft: OrderDraft, where: Where) -> bool:
    """Take "(side by side) without a gap"; whether it was that."""
    gap = where.noun is not None and means("distances", where.noun.word) == "gap"
    draft.order.touching |= where.word == "without" and gap
    return where.word == "without" and gap


def _utmost(draft: OrderDraft, where: Where) -> None:
    """Read "as far from it as possible" as the corner farthest from it, "as near as possible" as beside it."""
    if where.word == "far" and where.noun is not None and where.noun.kind in ("thing", "place"):
        where.word, where.second, where.text = "in", where.noun, "in"
        where.noun = Noun("place", "corner", 0, 0, "the corner", det="the")
    elif where.word in ("near", "next_to", "by"):
        where.word = "next_to"
    else:
        draft.order.lost.append("as possible")


def _instead_of(draft: OrderDraft, where: Where, noun: Noun) -> None:
    """Read "on the stand instead of the table", "add a stool instead of the chair"."""
    order = draft.order
    places = order.things[-1].places if order.things else order.places
    known = bool(order.things) and (order.things[-1].noun.definite or bool(order.things[-1].id))
    if "place" in where.text.lower().split() and known and not places and order.doing in ("put", "move"):
        places.append(Where("spot", noun, text="where"))
    elif places:
        places.append(Where(places[-1].word, noun, negated=True, text=INSTEAD))
    elif order.doing in ("add", "put", "ensure") and order.things and _is_other_number(draft, noun):
        order.doing, order.total = "ensure", True
    elif order.doing in ("add", "put", "ensure") and order.things and noun.kind == "thing":
        order.doing, order.instead, order.things = "replace", order.things, [NounPhrase(noun, id=noun.id)]
    else:
        order.lost.append(f"{where.text} {noun.text}")


def _is_other_number(draft: OrderDraft, noun: Noun) -> bool:
    """Whether there are to be so many of one kind, not another number of them: "four chairs instead of two"."""
    last = draft.order.things[-1].noun
    of_them = noun.kind == "number" or (noun.kind == "thing" and noun.value == last.value and not noun.attributes)
    return of_them and bool(noun.count and last.count) and last.kind == "thing" and not last.definite


def _refer(draft: OrderDraft, where: Where) -> None:
    """Let "it" mean what the same clause named before: an anchor of the thing, or another thing that is there."""
    noun, things = where.noun, draft.order.things
    if noun is not None and is_it(noun) and where.word != "with":
        walled = bool(draft.anchors) and draft.anchors[-1].kind == "place" and bool(draft.former)
        if (walled and "wall" in draft.anchors[-1].value) or _is_across(draft, where):
            where.noun = draft.former[-1]
        elif draft.anchors[-1:] and draft.anchors[-1].value == "floor":
            pass
        elif draft.anchors:
            where.noun = draft.anchors[-1]
        elif len(things) > 1 and draft.order.doing in _ON_KNOWN and things[-2].noun.kind == "thing":
            where.noun = things[-2].noun
    known = things[-2].noun if len(things) > 1 and things[-2].noun.definite else None
    known = known or (draft.anchors[-1] if draft.anchors and len(things) == 1 else None)
    if where.whole is not None and is_it(where.whole) and known is not None and known.kind == "thing":
        where.whole = known
    if where.word != "with" or draft.order.doing not in ("add", "remove", *WITH_ALONG):
        draft.anchors += [n for n in (where.noun, where.whole, where.second) if n and n.kind in ("thing", "place")]


def _is_across(draft: OrderDraft, where: Where) -> bool:
    """Whether a thing goes to the other side of what the one before goes to: "left of the sofa and ... right of it"."""
    before = draft.order.things[-2].places[-1:] if len(draft.order.things) > 1 else []
    sides = {before[0].word, where.word} if before else set()
    known = bool(draft.former) and not draft.anchors and draft.former[-1].kind == "thing"
    return known and sides in ({"left_of", "right_of"}, {"in_front_of", "behind"}, {"above", "under"})


def attach(draft: OrderDraft, where: Where) -> None:
    """Give a place to what it is of."""
    noun = where.noun
    if draft.order.room and draft.order.doing == "make" and noun is not None and where.whole is None:
        side = next((side for side in COMPASS if noun.value in (side, f"{side}_wall")), "")
        if side and not draft.order.direction:
            draft.order.direction = side
            return
    if draft.shared and where.noun is not None and where.noun.each:
        where.noun = replace(where.noun, det="all", plural=True)
    if draft.mode == "so":
        _of_result(draft, where)
    elif draft.excepted is not None and not (where.text.lower() in _INTO and draft.order.doing in ("move", "put")):
        draft.excepted.places.append(where)
    elif _is_laden(draft, where):
        draft.order.things[-1].laden, draft.order.rest = True, False
    elif draft.order.closer and not draft.order.closer[-1][1].places and not _is_whereto(where):
        draft.order.closer[-1][1].places.append(where)
    elif draft.mode == "instead" and draft.order.instead:
        draft.order.instead[-1].places.append(where)
    elif draft.order.things:
        draft.order.things[-1].places.append(where)
    else:
        draft.order.places.append(where)


def _is_whereto(where: Where) -> bool:
    """Whether a place behind "away from the window," is where a thing goes: "into the corner"."""
    return where.word in ("to", "on") or where.text.lower() in _INTO


def _is_laden(draft: OrderDraft, where: Where) -> bool:
    """Whether this is what rests on the thing itself: "the table and what is on it"."""
    things = draft.order.things
    alone = where.noun is not None and is_it(where.noun) and where.word in ("on", "in", "inside", "on_top")
    told = draft.order.rest if draft.order.doing == "keep" else draft.order.doing in _ON_KNOWN
    alone &= draft.mode != "instead" and where.text.lower() not in _INTO
    return alone and bool(things) and things[-1].noun.kind == "thing" and told


def _of_result(draft: OrderDraft, where: Where) -> None:
    """Read "so that it is next to the bed", "so that nothing stands in the centre", "so there is room in it"."""
    said = draft.so[-1].noun if draft.so else None
    apart = where.word == "between" and where.second is not None and where.noun is not None and is_it(where.noun)
    if apart and draft.order.lengths and where.second is not None:
        draft.order.apart.append((draft.order.lengths.pop()[0], NounPhrase(where.second, id=where.second.id)))
        return
    if said is not None and takes_lengthwise(draft, said, where):
        return
    if said is not None and said.kind == "part" and said.value in (*SIDED, *IN_ROW, "front"):
        draft.order.lost.append(f"{said.text} {where.text} {where.noun.text if where.noun else ''}".strip())
        return
    if _is_borne(draft, where):
        return
    kept_clear = said is None or said.kind in ("room", "abstract") or said.text.lower().startswith(("no", "more"))
    if kept_clear and where.noun is not None:
        draft.order.free.append(where.noun)
    elif draft.order.things:
        draft.order.things[-1].places.append(where)
        if draft.order.doing == "turn" and _is_at_wall(where):
            draft.order.doing, draft.order.turn = "put", None


def _is_at_wall(where: Where) -> bool:
    """Whether it is at a wall, to which the back of what is turned so that it stands there comes."""
    noun = where.noun
    walled = noun is not None and noun.kind == "place" and "wall" in noun.value and not where.negated
    return walled and where.word in ("along", "against", "at", "by", "next_to", "on")


def _is_borne(draft: OrderDraft, where: Where) -> bool:
    """Take "(make the rug bigger so that) the sofa and both armchairs are on it"; whether it was that."""
    order = draft.order
    it = where.noun is not None and is_it(where.noun) and where.word in ("on", "on_top") and not where.negated
    known = bool(draft.so) and all(p.noun.kind == "thing" and (p.noun.definite or p.id) for p in draft.so)
    if not (it and known and order.doing == "make" and len(order.things) == 1):
        return False
    order.bears += draft.so
    return True
