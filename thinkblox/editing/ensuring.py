"""Orders on how many there are to be, and what is to be larger than it is: no more than is lacking is added."""

import dataclasses

from thinkblox.editing.acting import related
from thinkblox.editing.adding import add, category_of
from thinkblox.editing.finding import Finder
from thinkblox.editing.grammar import means
from thinkblox.editing.making import make
from thinkblox.editing.moving import move
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.removing import take_away
from thinkblox.editing.wheres import bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where


def bring(work: Work, finder: Finder, order: Order) -> None:
    """Add what is new, with what goes along; "use a larger rug" makes the one that is there larger."""
    if order.company and order.things:
        along = [Where("with", phrase.noun, text="with") for phrase in order.company]
        last = dataclasses.replace(order.things[-1], places=[*order.things[-1].places, *along])
        order = dataclasses.replace(order, things=[*order.things[:-1], last], company=[])
    placed = any(p.places for p in order.things) or order.places or order.there
    kinds = [category_of(work, p.noun, ()) for p in order.things if p.noun.kind == "thing"]
    hung = all(work.source.usual(kind)[1] != "ceiling" for kind in kinds)
    if order.text.lower().startswith("hang ") and not placed and hung:
        wall = Noun("place", "wall", 0, 0, "a wall", det="a")
        order = dataclasses.replace(order, places=[Where("on", wall, text="on")])
    known = [p for p in order.things if p.noun.of_known and p.noun.kind == "thing" and finder.matching(p.noun)]
    if known and len(known) == len(order.things):
        move(work, finder, dataclasses.replace(order, doing="move"))
        return
    compared = [p for p in order.things if p.noun.degree and not p.noun.id]
    if not compared:
        add(work, finder, order)
        return
    if len(order.things) > 1:
        raise InputError(f"'{order.text}' compares with what is there and names more; give two orders")
    phrase = compared[0]
    found = held(finder, phrase)
    if len(found) != 1:
        there = ", ".join(found) or finder.listed()
        raise InputError(f"'{phrase.noun.text}': {phrase.noun.degree} than what? There is {there}; say which by its id")
    phrase.id, phrase.places = found[0], []
    make(
        work, finder, Order("make", order.text, things=[phrase], change=change_of(phrase), looks=phrase.noun.attributes)
    )


def change_of(phrase: NounPhrase) -> str:
    """How a thing is to change by a comparative."""
    change = means("comparatives", phrase.noun.degree)
    if not change:
        raise InputError(f"'{phrase.noun.text}': what '{phrase.noun.degree}' means of it is not known")
    return change


def held(finder: Finder, phrase: NounPhrase) -> list[str]:
    """What a phrase fits and is where it says."""
    found = finder.matching(phrase.noun)
    for where in phrase.places if found else ():
        there = bound(where, found[0].category, finder)
        found = [p for p in found if p.id not in there.anchors and there.holds(finder.scene, p.id)]
    return [p.id for p in found]


def ensure(work: Work, finder: Finder, order: Order) -> None:
    """Add as many as are lacking; take away what must not be there, or is too many."""
    for number, phrase in enumerate(order.things):
        phrase.places = phrase.places or next((p.places for p in order.things[number:] if p.places), order.places)
    for phrase in order.things:
        noun = phrase.noun
        if noun.kind != "thing" or noun.definite or phrase.id:
            move(work, finder, Order("move", order.text, things=[phrase], facing=order.facing))
            continue
        if any(w.noun is not None and w.noun.each for w in phrase.places):
            _at_each(work, finder, order, phrase)
            continue
        there = held(finder, phrase)
        if noun.det in ("no", "none"):
            take_away(work, work.touched(there))
            work.done += [] if there else [f"no {noun.word} is there: it is so already"]
            continue
        wanted = noun.count or (2 if noun.plural else 1)
        if len(there) < wanted:
            phrase.noun = _so_many(noun, wanted - len(there))
            add(work, finder, Order("add", order.text, things=[phrase], facing=order.facing, closer=order.closer))
        elif len(there) > wanted and (order.total or (noun.count or 0) > 1):
            take_away(work, work.touched(there[wanted:]))
        else:
            work.done.append(f"{', '.join(there)} is there: it is so already")
        finder.scene = work.scene


def _at_each(work: Work, finder: Finder, order: Order, phrase: NounPhrase) -> None:
    """Add to each of several places what is lacking there: "every table should have four chairs"."""
    noun, alike = phrase.noun, finder.matching(phrase.noun)
    where = next(w for w in phrase.places if w.noun is not None and w.noun.each)
    more = 0
    for slot in slots_of(where, noun.value if noun.named else "", finder):
        goal = related(slot, alike[0].category) if alike else None
        there = [p.id for p in alike if goal is not None and goal.check(work.scene, work.scene, p.id)[0]]
        lacking = (noun.count or 1) - len(there)
        if lacking <= 0:
            continue
        more += lacking
        at = Noun("thing", work.scene[slot.anchors[0]].category, 0, 0, "it", det="the", id=slot.anchors[0])
        here = dataclasses.replace(phrase, noun=_so_many(noun, lacking), places=[dataclasses.replace(where, noun=at)])
        add(work, finder, Order("add", order.text, things=[here], facing=order.facing, closer=order.closer))
        finder.scene = work.scene
    if not more:
        work.done.append(f"'{order.text}': it is so already")


def _so_many(noun: Noun, count: int) -> Noun:
    return dataclasses.replace(noun, count=count, plural=count > 1)
