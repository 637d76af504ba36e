"""A noun in an order: what it is done to, or what else it says of it."""

from dataclasses import replace

from thinkblox.editing.grammar import is_filler, means
from thinkblox.editing.orders import AWAY_SIDE, BEARS, BORE, SAME, NounPhrase
from thinkblox.editing.reading.cutting import Item, OrderMark
from thinkblox.editing.reading.draft import OF_THOSE, TO_WALL, WITH_ALONG, OrderDraft, is_it, is_theirs
from thinkblox.editing.reading.facing import is_back, is_head, read_behind, take_not_faced
from thinkblox.editing.reading.going_along import as_theirs, is_theirs_too
from thinkblox.editing.reading.locating import with_corner
from thinkblox.editing.reading.looks import pass_look
from thinkblox.editing.reading.phrasing import as_another, merged, phrase_of
from thinkblox.editing.reading.sharing_out import (
    comes_along,
    is_each_of_new,
    is_one_of_company,
    is_one_of_them,
    shares_new,
    shares_out,
    tell_apart,
)
from thinkblox.errors import InputError
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.nodes import Where

_OF_ROOM = ("make", "rearrange", "free", "keep", "only")
_OF_ALL = ("remove", "keep", "move", "put", "free", "turn", "rearrange")
"""Orders that "everything" can be said with."""
_THE_ONES = ("the one", "the ones", "those", "that")
"""What is said to be where of what was just named."""
_STANDING = ("verbs", "participles")
"""Words between a thing and what it stands on."""
_STOOD = ("was", "were", "stood", "sat", "lay", "rested", "used")
"""Those of them that speak of before."""
_AREAS = ("area", "zone")
"""Words for the surroundings of a thing."""


def read_noun(draft: OrderDraft, noun: Noun) -> None:
    """Take a noun."""
    order = draft.order
    if noun.kind == "thing" and noun.value == "enough":
        raise InputError(f"'{order.text}': how large '{noun.text}' is is not said; say a size, such as '2 by 3 m'")
    if (
        _is_address(draft, noun)
        or _is_apposition(draft, noun)
        or _told_by_rider(draft, noun)
        or is_each_of_new(draft, noun)
        or is_one_of_company(draft, noun)
        or _is_second_anchor(draft, noun)
    ):
        return
    noun = as_another(draft, merged(draft, noun))
    negated, draft.negated = draft.negated, False
    phrase = phrase_of(draft, noun)
    if negated and order.doing == "turn" and order.facing and order.things:
        take_not_faced(draft, noun)
    elif negated and order.things and draft.mode == "things":
        order.things[-1].spared.append(phrase)
        draft.excepted = phrase
    elif negated:
        order.lost.append(f"not {noun.text}")
    elif draft.pending is not None and (draft.mode != "so" or draft.so):
        _compared(draft, phrase)
    elif draft.excepted is not None:
        (order.things[-1].spared if order.things else order.spared).append(phrase)
        draft.excepted = phrase
    elif not _in_mode(draft, phrase) and not _is_of_room(draft, noun):
        _thing(draft, phrase)


def _is_apposition(draft: OrderDraft, noun: Noun) -> bool:
    """Whether it says of what was just named which of them that are: "two of the desks, the ones by the door"."""
    before = draft.before()
    following = draft.ahead()
    last = draft.order.things[-1] if draft.order.things else None
    bare = noun.kind in ("number", "pronoun") and noun.text.lower() in _THE_ONES
    told = isinstance(following, Connector) and following.sort == "prepositions"
    paused = isinstance(before, Connector) and before.sort == "mark"
    known = last is not None and last.noun.kind == "thing" and (last.noun.definite or bool(last.noun.of_known))
    return bare and told and paused and known and last is not None and not last.places


def _told_by_rider(draft: OrderDraft, noun: Noun) -> bool:
    """Take "(the table) the printer was standing on", "it stands on", by which that is told; whether it was so.

    Raises:
        InputError: it is not said how the second of two things is to the first: "remove the desk the lamp".
    """
    before = draft.before()
    following = draft.ahead()
    if isinstance(before, Noun) and isinstance(following, Noun) and noun.text.lower() in ("that", "which"):
        del draft.items[draft.at - 1]
        draft.at -= 1
        return True
    if not isinstance(before, Noun) or before.kind != "thing" or noun.kind not in ("thing", "pronoun"):
        return False
    if not (noun.definite or noun.id or is_it(noun)) or before.det not in ("the", "my", "all", "each", "both"):
        return False
    at, past = draft.at, False
    while at < len(draft.items):
        verb = draft.items[at]
        if not isinstance(verb, Connector) or verb.sort not in _STANDING:
            break
        past |= verb.text.lower() in _STOOD
        at += 1
    link = draft.items[at] if at < len(draft.items) else None
    after = draft.items[at + 1] if at + 1 < len(draft.items) else None
    on = isinstance(link, Connector) and link.value in ("on", "in", "inside", "on_top") and at > draft.at
    if on and not isinstance(after, Noun):
        held = _owner_of(draft, before)
        if held is None:
            return False
        held.append(Where("with", noun, text=BORE if past else BEARS))
        draft.at = at + 1
        return True
    if draft.order.doing == "remove" and noun.kind == "thing":
        raise InputError(
            f"'{draft.order.text}': how '{noun.text}' is to '{before.text}' is not understood; name what is to go"
        )
    return False


def _owner_of(draft: OrderDraft, noun: Noun) -> list[Where] | None:
    """The places of the phrase that a noun is the head of; None where it is none."""
    held = [p.places for p in draft.order.things if p.noun is noun or p.noun.text == noun.text]
    held += [p.places for p in draft.order.things if p.places and p.places[-1].noun is noun]
    return held[0] if held else None


def _in_mode(draft: OrderDraft, phrase: NounPhrase) -> bool:
    """Take what is said of a result, of what is not to be blocked or comes instead; whether it was one of these."""
    order, noun = draft.order, phrase.noun
    if (is_back(noun) or is_head(draft, noun)) and (behind := read_behind(draft)) is not None:
        at_it = behind.text == "against" or behind.word == "under"
        if at_it and behind.noun is not None and order.doing in TO_WALL and order.things:
            order.doing = "move" if order.doing == "turn" else order.doing
            order.things[-1].places.append(behind)
            order.backs += [behind.noun] if behind.word == "under" else []
        elif behind.noun is not None:
            order.backs.append(behind.noun)
    elif draft.mode == "so":
        draft.so.append(phrase)
    elif draft.mode == "unblock" and noun.kind in ("place", "part"):
        order.free.append(noun)
        draft.mode = "things"
    elif draft.mode == "instead" and noun.kind in ("thing", "number"):
        order.instead.append(phrase)
    else:
        return False
    return True


def _is_of_room(draft: OrderDraft, noun: Noun) -> bool:
    """Take a noun that names the room, a space or part of it, or how something looks; whether it was one."""
    order, part = draft.order, noun.kind in ("place", "part")
    about = _about(draft, noun)
    if about is not None:
        order.places.append(Where("around", about, text="around"))
    elif _is_space(draft, noun):
        order.space = True
        draft.more |= noun.text.lower().startswith("more ")
    elif (noun.kind == "room" or noun.word in ("furniture", "layout")) and order.doing in _OF_ROOM:
        order.room = True
    elif part and noun.value == "ceiling" and order.doing == "make":
        order.room = order.ceiling = True
    elif order.doing == "free" and part:
        where = with_corner(draft, Where("in", noun, text="in"))
        if where.whole is None and where.second is None:
            order.free.append(noun)
        else:
            order.places.append(where)
    elif draft.mode == "instead" and order.instead and noun.word == "size" and "same" in noun.text.split():
        order.instead[-1].noun = replace(order.instead[-1].noun, degree=SAME)
    elif noun.word == "size" and "same" in noun.text.lower().split() and (new := draft.new_thing()) is not None:
        new.degree = SAME
    elif noun.kind in ("abstract", "part") and order.doing in ("make", "replace") and means("looks", noun.word):
        pass_look(draft, noun)
    else:
        return False
    return True


def _about(draft: OrderDraft, noun: Noun) -> Noun | None:
    """The thing of which a phrase names the surroundings: "the sofa area"; None where it names none.

    Raises:
        InputError: it names a part of the room by what is no thing.
    """
    words = noun.text.lower().split()
    if noun.kind != "room" or draft.order.doing not in ("rearrange", "free") or words[-1] not in _AREAS:
        return None
    if words[:-1] == [noun.det] or not words[:-1]:
        return None
    if known := means("areas", words[-2]):
        return Noun("thing", known, 0, 0, noun.text, det="the", named=True)
    chunks, _ = cut(draft.lexicon, draft.lexicon.tokens(" ".join(words[:-1])))
    found = [chunk for chunk in chunks if isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.named]
    if len(found) != 1:
        raise InputError(f"'{noun.text}': which part of the room that is is not known; name a thing that is there")
    return replace(found[0], det="the")


def _thing(draft: OrderDraft, phrase: NounPhrase) -> None:
    order, noun = draft.order, phrase.noun
    everything = noun.kind == "abstract" and noun.text.lower() == "anything" and order.doing == "keep"
    if everything or (noun.kind == "pronoun" and noun.value == "all" and order.doing in _OF_ALL):
        order.rest = True
    elif (order.things and is_theirs(noun) and order.doing in WITH_ALONG) or is_theirs_too(draft, noun):
        order.company.append(replace(phrase, noun=as_theirs(draft, noun)))
    elif _is_within(draft, noun):
        order.apart.append((order.lengths.pop()[0], phrase))
        draft.distance, draft.anchors = False, [noun]
    elif order.doing == "add" and order.things and noun.kind == "pronoun" and noun.det in ("both", "all", "each"):
        comes_along(draft, each=True)
    elif is_one_of_them(draft, noun):
        tell_apart(draft, noun)
    elif shares_out(draft, noun) or shares_new(draft, noun):
        draft.shared = True
    elif noun.kind in ("thing", "pronoun", "number", "place", "part"):
        if order.things and is_theirs(order.things[-1].noun) and noun.kind == "thing" and not noun.det:
            phrase.noun = replace(noun, det="my", text=f"{order.things[-1].noun.text.split()[0]} {noun.text}")
        if order.things and order.things[-1].noun.rows and noun.kind == "thing" and _is_of_row(draft, noun):
            phrase.noun = replace(noun, det="my", text=f"their {noun.text.removeprefix('the ')}")
        order.things.append(_at_another(draft, phrase))
        draft.anchors, draft.former = [], draft.anchors
    else:
        draft.lose(noun)


def _is_of_row(draft: OrderDraft, noun: Noun) -> bool:
    """Whether what is named after things in a row is theirs: "(remove the chairs in that row and) the monitors too"."""
    too = draft.order.text.lower().endswith((" too", " as well"))
    theirs = too and draft.order.doing == "remove" and noun.det == "the" and noun.plural
    return not noun.count and (not noun.det or theirs)


def _is_second_anchor(draft: OrderDraft, noun: Noun) -> bool:
    """Take another thing that a new one is to be at as well: "(a rug) under the armchair and (the) side table"."""
    order, before, following = draft.order, draft.before(), draft.ahead()
    last = order.things[-1] if order.things else None
    joined = isinstance(before, Connector) and before.text.lower() == "and"
    goes_on = isinstance(following, Connector) and following.sort == "prepositions"
    otherwise = draft.negated or draft.mode != "things" or draft.pending is not None or draft.excepted is not None
    if order.doing not in ("add", "put") or last is None or not last.places or not joined or goes_on or otherwise:
        return False
    where = last.places[-1]
    anchor = where.noun if where.second is None and where.whole is None and where.word != "with" else None
    new = last.noun.kind == "thing" and not last.noun.definite and not last.noun.id
    known = anchor is not None and anchor.kind == "thing" and (anchor.det == "the" or bool(anchor.id))
    bare = noun.kind == "thing" and not (noun.count or noun.plural) and noun.det in ("", "the")
    if new and known and bare:
        last.places.append(replace(where, noun=replace(noun, det=noun.det or "the")))
    return new and known and bare


def _is_within(draft: OrderDraft, noun: Noun) -> bool:
    """Whether a noun is that of which something is to be within a length."""
    order, before = draft.order, draft.before()
    measured = isinstance(before, OrderMark) and before.sort == "lengths" and order.bound == "le"
    known = noun.kind in ("thing", "place") and bool(order.things) and len(order.lengths) == 1
    return measured and known and draft.distance and order.doing in ("move", "put", "add")


def _at_another(draft: OrderDraft, phrase: NounPhrase) -> NounPhrase:
    """Read "the monitors on desk 2 and desk 3" as those on either, where both are of one kind."""
    last = draft.order.things[-1] if draft.order.things else None
    before = draft.before()
    joined = isinstance(before, Connector) and before.sort in ("joins", "mark")
    if last is None or not last.places or not joined or draft.order.doing not in OF_THOSE or phrase.places:
        return phrase
    where, noun = last.places[-1], phrase.noun
    same = where.noun is not None and noun.kind == where.noun.kind == "thing" and noun.value == where.noun.value
    if not same or where.second is not None or where.whole is not None or last.noun.value == noun.value:
        return phrase
    return replace(last, noun=replace(last.noun), places=[*last.places[:-1], replace(where, noun=noun)], spared=[])


def _is_space(draft: OrderDraft, noun: Noun) -> bool:
    """Whether a noun is the room between or before things: "the gap between", "the area in front of"."""
    following = draft.ahead()
    located = isinstance(following, Connector) and following.sort == "prepositions"
    waits = isinstance(following, OrderMark) and following.sort == "lengths"
    whole_room = noun.kind == "room" and noun.word == "room" and bool(noun.det)
    known = means("distances", noun.word) == "gap" or noun.value == "space"
    spoken = noun.kind in ("abstract", "room") and not whole_room and known
    whole = isinstance(following, Connector) and following.value in ("of", "with", "to", "as", "by")
    after = draft.ahead(1)
    whole &= not (isinstance(after, OrderMark) and after.sort == "lengths")
    return (
        spoken
        and draft.order.doing in ("free", "keep", "make", "put", "move")
        and ((located and not whole) or waits or _is_free_noun(draft, following))
    )


def _is_free_noun(draft: OrderDraft, following: Item | None) -> bool:
    return draft.order.space and following is None


def _compared(draft: OrderDraft, phrase: NounPhrase) -> None:
    """Read what a thing comes nearer to; "opposite the piano and 2 m away from it" is how far it is to be."""
    if _is_side_towards(draft, phrase.noun):
        return
    order, again = draft.order, bool(draft.anchors) and is_it(phrase.noun)
    if again:
        phrase = NounPhrase(draft.anchors[-1])
    elif phrase.noun.kind == "pronoun" and phrase.noun.value == "each":
        order.lost.append(phrase.noun.text)
    draft.anchors += [phrase.noun] if phrase.noun.kind in ("thing", "place") else []
    if again and not draft.pending and order.lengths:
        order.apart.append((order.lengths.pop()[0], phrase))
    else:
        order.closer.append((bool(draft.pending), phrase))
    draft.pending = None


def _is_side_towards(draft: OrderDraft, noun: Noun) -> bool:
    """Take "(next to the fridge,) on the side away from the stove" as one of its sides; whether it was that."""
    places = draft.order.things[-1].places if draft.order.things else []
    side, anchors = places[-1] if places else None, [n for n in draft.anchors if n.kind == "thing"]
    part = side is not None and side.noun is not None and side.noun.kind == "part" and side.noun.value == "side"
    if not part or side is None or side.whole is not None or not anchors or noun.kind not in ("thing", "place"):
        return False
    side.whole, side.second = anchors[-1], noun
    side.text = "on the side towards" if draft.pending else AWAY_SIDE
    draft.pending = None
    return True


def _is_address(draft: OrderDraft, noun: Noun) -> bool:
    """Whether a noun speaks to somebody: "please, my dear"; one that nobody knows after a comma is lost alone."""
    if is_filler(noun.text):
        return True
    before = draft.before()
    after_comma = isinstance(before, Connector) and before.sort == "mark"
    own = noun.kind == "thing" and not noun.named and noun.det in ("my", "our", "") and not noun.id
    if after_comma and own and draft.order.things and draft.order.doing != "add" and draft.at == len(draft.items):
        draft.lose(noun)
        return True
    return False
