"""Several new things of one order, and what comes with each of them."""

from dataclasses import replace
from typing import cast

from thinkblox.assets import facts_of
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.reading.draft import OrderDraft, is_it
from thinkblox.editing.reading.locating import read_where
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.nodes import Where


def is_each_of_new(draft: OrderDraft, noun: Noun) -> bool:
    """Whether it says of every one of what is added what comes with it: "two desks, each with a chair"."""
    new = draft.order.doing in ("add", "put", "ensure") and bool(draft.order.things)
    following = draft.ahead()
    along = draft.mode == "instead" and len(draft.order.instead) > 1 and not draft.order.instead[-1].places
    ends = following is None or (isinstance(following, Connector) and following.sort == "mark")
    if along and noun.kind == "pronoun" and noun.det == "each" and ends:
        draft.order.eached = True
        return True
    linked = isinstance(following, Connector) and following.value == "with"
    said = new and linked and noun.kind == "pronoun" and noun.det in ("each", "both", "all")
    said |= new and noun.kind == "pronoun" and noun.det == "each" and _is_along(draft)
    draft.eached |= said
    return said


def _is_along(draft: OrderDraft) -> bool:
    """Whether what was named last comes along with something new: "(four plates with) a glass (each)"."""
    places = draft.order.things[-1].places
    along = bool(draft.order.company) or any(where.word == "with" for where in places)
    return along and not draft.order.things[-1].noun.definite


def is_one_of_company(draft: OrderDraft, noun: Noun) -> bool:
    """Take where each of what goes along is to be: "(two chairs,) one on each side"; whether it was that."""
    company = draft.order.company if draft.order.doing in ("add", "put", "ensure") else []
    one = noun.kind == "pronoun" and noun.value == "one" and not noun.det
    if not (company and one and (company[-1].noun.count or 0) > 1 and draft.each_follows()):
        return False
    link = cast(Connector, draft.items[draft.at])
    draft.at += 1
    company[-1].places.append(read_where(draft, link))
    return True


def comes_along(draft: OrderDraft, *, each: bool) -> None:
    """Read "(two desks with a chair and) a monitor each" as what comes with every one of what is added.

    Where nobody says "each", what usually rests on such a thing does.
    """
    things = draft.order.things
    head = next((n for n, p in enumerate(things) if any(w.word == "with" for w in p.places)), None)
    if head is None or things[head].noun.definite:
        return
    later, kind = things[head + 1 :], things[head].noun.value
    bare = [p for p in later if not (p.noun.det or p.noun.count or p.noun.id)]
    if later and len(bare) == len(later) and not any(p.places for p in later[:-1]) and _is_along_only(things[head]):
        theirs = [where for where in later[-1].places if not _is_on_it(where)]
        things[head].places += theirs
        later[-1].places = [where for where in later[-1].places if where not in theirs]
    on_it = [p for p in later if p.places and all(_is_on_it(where) for where in p.places)]
    new = all(p.noun.kind == "thing" and not (p.noun.definite or (p.places and p not in on_it) or p.id) for p in later)
    usual = all(
        any(habit.kind == "on" and kind in habit.anchors for habit in load_habits().of(p.noun.value)) for p in later
    )
    usual |= facts_of(kind).is_in("seating") and all(facts_of(p.noun.value).is_in("small") for p in later)
    if later and new and (each or usual or later[-1] in on_it):
        things[head].places += [Where("with", p.noun, text="with") for p in later]
        del things[head + 1 :]


def _is_along_only(phrase: NounPhrase) -> bool:
    """Whether what comes along with it is all that is said of where it goes."""
    return all(where.word == "with" for where in phrase.places)


def _is_on_it(where: Where) -> bool:
    """Whether it is "on it", said of what comes with a thing."""
    return where.word in ("on", "on_top") and where.noun is not None and is_it(where.noun) and not where.negated


def is_one_of_them(draft: OrderDraft, noun: Noun) -> bool:
    """Whether it tells how one of several new things looks: "two cushions, a red one and a blue one"."""
    last = draft.order.things[-1].noun if draft.order.things else None
    looks = noun.text.lower().split()[-1:] == ["one"] and bool(noun.attributes)
    new = draft.order.doing in ("add", "put", "ensure") and last is not None and last.kind == "thing"
    several = last is not None and ((last.count or 0) > 1 or last is draft.left)
    return new and looks and several and last is not None and not last.definite


def tell_apart(draft: OrderDraft, noun: Noun) -> None:
    """Take one thing out of several that are added, which looks as is said."""
    phrase = draft.order.things.pop()
    count = (phrase.noun.count or 1) - 1
    looks = [*phrase.noun.attributes, *noun.attributes]
    one = replace(phrase.noun, count=1, plural=False, det="a", attributes=looks)
    draft.left = replace(phrase.noun, count=count, plural=count > 1)
    draft.order.things.append(replace(phrase, noun=one, places=list(phrase.places)))
    draft.order.things += [replace(phrase, noun=draft.left)] if count else []


def shares_new(draft: OrderDraft, noun: Noun) -> bool:
    """Whether a number says where each of several is that come instead: "two benches, one on each long side"."""
    one = noun.kind == "pronoun" and noun.value == "one" and not noun.det
    several = bool(draft.order.instead) and (draft.order.instead[-1].noun.count or 0) > 1
    return draft.mode == "instead" and one and several and not draft.order.instead[-1].places and draft.each_follows()


def shares_out(draft: OrderDraft, noun: Noun) -> bool:
    """Whether a number says how many of what is added go to each of several places: "two plants, one in each"."""
    last = draft.order.things[-1] if draft.order.things else None
    one = noun.kind == "pronoun" and noun.value == "one"
    bare = one or (noun.kind == "number" and not noun.det and not noun.ordinal and not noun.rows)
    return (
        draft.order.doing in ("add", "put", "ensure")
        and last is not None
        and bare
        and ((last.noun.count or 0) > 1 or (one and last.noun.plural and draft.each_follows()))
        and (not last.places or draft.each_follows())
    )
