"""Orders on how many there are to be, and what is to be larger than it is: no more than is lacking is added."""

import dataclasses
from collections.abc import Mapping, Sequence

from thinkblox.assets import facts_of
from thinkblox.editing.acting import related
from thinkblox.editing.adding import add
from thinkblox.editing.adding_one import category_of
from thinkblox.editing.finding import Finder
from thinkblox.editing.grammar import means
from thinkblox.editing.making import make
from thinkblox.editing.moving import move
from thinkblox.editing.moving_one import move_one
from thinkblox.editing.orders import SAME, NounPhrase, Order
from thinkblox.editing.removing import take_away
from thinkblox.editing.telling import BELONGING, named
from thinkblox.editing.wheres import Bound, bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.scene import Scene

_SIDES = ("left_of", "right_of", "in_front_of", "behind")


def bring(work: Work, finder: Finder, order: Order) -> None:
    """Add what is new, with what goes along; "use a larger rug" makes the one that is there larger."""
    if order.company and order.things and (_is_compared(order.things[-1]) or _at_places(order)):
        _bring_having(work, finder, order)
        return
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
    compared = [p for p in order.things if _is_compared(p) and not p.noun.id]
    if len(order.things) == 1 and (sides := _sides_with_some(finder, order.things[0])):
        _complete(work, finder, order, sides)
        return
    if not compared:
        add(work, finder, order)
        return
    if len(order.things) > 1 and len(compared) < len(order.things):
        raise InputError(f"'{order.text}' compares with what is there and names more; give two orders")
    if len(order.things) > 1:
        for phrase in order.things:
            bring(work, finder, dataclasses.replace(order, things=[phrase]))
            finder.scene = work.before = work.scene
        return
    _make_otherwise(work, finder, order, compared[0])


def _make_otherwise(work: Work, finder: Finder, order: Order, phrase: NounPhrase) -> None:
    """Make the one that is there larger, taller, ... where "a larger one" is wanted.

    Raises:
        InputError: none is there, or several are.
    """
    found = held(finder, phrase)
    if len(found) != 1:
        there = ", ".join(found) or finder.listed()
        raise InputError(f"'{phrase.noun.text}': {phrase.noun.degree} than what? There is {there}; say which by its id")
    phrase.id, phrase.places = found[0], []
    make(
        work, finder, Order("make", order.text, things=[phrase], change=change_of(phrase), looks=phrase.noun.attributes)
    )


def _is_compared(phrase: NounPhrase) -> bool:
    return phrase.noun.degree not in ("", SAME)


def _bring_having(work: Work, finder: Finder, order: Order) -> None:
    """Bring what has so many others at it: "a smaller table with two chairs, one on each side"."""
    known = held(finder, order.things[-1]) if _is_compared(order.things[-1]) else []
    for phrase in order.company if len(known) == 1 else ():
        it = Noun("thing", work.scene[known[0]].category, 0, 0, "it", det="the", id=known[0])
        there = held(finder, dataclasses.replace(phrase, places=[Where("at", it, text="at")]))
        if len(there) > (phrase.noun.count or len(there)):
            _let_have(work, finder, order, known[0], dataclasses.replace(phrase, places=[]))
    finder.scene = work.before = work.scene
    bring(work, finder, dataclasses.replace(order, company=[]))
    for phrase in order.company if finder.recent and finder.recent[-1] in work.scene else ():
        _let_have(work, finder, order, finder.recent[-1], phrase)


def _at_places(order: Order) -> bool:
    """Whether it is said where what comes along stands: "a table with two chairs, one on each side"."""
    return any(phrase.places for phrase in order.company)


def _let_have(work: Work, finder: Finder, order: Order, head: str, phrase: NounPhrase) -> None:
    """Let a thing have so many of others at it, and no more, each where that is said."""
    finder.scene, finder.recent, finder.about = work.scene, [head], ""
    it = Noun("thing", work.scene[head].category, 0, 0, "it", det="the", id=head)
    so_many = dataclasses.replace(phrase, places=[Where("at", it, text="at")])
    ensure(work, finder, Order("ensure", order.text, things=[so_many], total=True))
    mates = held(dataclasses.replace(finder, scene=work.scene), so_many)
    if not phrase.places or not mates:
        return
    if len(mates) > 1:
        mates = mates[: phrase.noun.count] if phrase.noun.count else mates
    finder.scene = work.before = work.scene
    places = [dataclasses.replace(w, whole=it if w.whole is not None else None) for w in phrase.places]
    slots = [slot for where in places for slot in slots_of(where, work.scene[mates[0]].category, finder)]
    slots = [slot for slot in slots for _ in range(max(1, len(mates) // len(slots)))]
    stay = _at_slots(work.scene, mates, slots)
    known = [NounPhrase(dataclasses.replace(phrase.noun, det="the", count=None, id=id), id=id) for id in mates]
    go = [one for one in known if one.id not in stay]
    for one, slot in zip(go, (slot for n, slot in enumerate(slots) if n not in stay.values()), strict=False):
        goals = [related(slot, work.scene[one.id].category)]
        finder.scene = work.scene
        move_one(work, order, one.id, goals)
    finder.recent = [head]


def _at_slots(scene: Scene, ids: Sequence[str], slots: Sequence[Bound]) -> dict[str, int]:
    """Which of some things are already at which of several places, of each of which there is one."""
    there: dict[str, int] = {}
    for id in ids:
        free = [n for n in range(len(slots)) if n not in there.values()]
        goals = {n: related(slots[n], scene[id].category) for n in free}
        at = next((n for n in free if goals[n].check(scene, scene, id)[0]), None)
        there |= {id: at} if at is not None else {}
    return there


def _with_sides(finder: Finder, phrase: NounPhrase) -> str:
    """The thing at all whose sides so many are to be and no more: "only two chairs, one on each side of the table"."""
    where = phrase.places[0] if len(phrase.places) == 1 else None
    part, whole = (where.noun, where.whole) if where is not None else (None, None)
    sides = part is not None and part.kind == "part" and (part.each or part.plural or part.det in ("all", "both"))
    ids = finder.ids(NounPhrase(whole, id=whole.id)) if sides and whole is not None and whole.kind == "thing" else ()
    return ids[0] if len(ids) == 1 else ""


def _sides_with_some(finder: Finder, phrase: NounPhrase) -> dict[Bound, str]:
    """What stands already at the sides of a thing, of each of which one is to be: "a nightstand on each side of it".

    What stands beside the thing, and at none of its sides as it should, is that of the side that it is nearest to.
    Empty where nothing is there, or so many are not one for each.
    """
    noun, where = phrase.noun, phrase.places[0] if len(phrase.places) == 1 else None
    one = noun.kind == "thing" and (noun.count or 1) == 1 and noun.det in ("a", "") and not (noun.plural or noun.degree)
    if not one or where is None or where.noun is None or not where.noun.each or where.noun.kind != "part":
        return {}
    scene, found = finder.scene, finder.matching(noun)
    slots = slots_of(where, found[0].category, finder) if found else []
    beside = [slot for slot in slots if slot.kind in _SIDES and not slot.part and slot.anchors[0] in scene]
    if len(beside) != 2 or len(slots) != 2:
        return {}
    mark = things(scene, beside[0].anchors[0])[0]
    left = [p.id for p in found if ground_gap(things(scene, p.id)[0], mark) <= BELONGING]
    sides = {slot: next((id for id in left if slot.holds(scene, id)), "") for slot in beside}
    for id in (id for id in left if id not in sides.values()):
        sides |= dict.fromkeys([s for s, there in sides.items() if not there][:1], id)
    return sides if any(sides.values()) else {}


def _complete(work: Work, finder: Finder, order: Order, sides: Mapping[Bound, str]) -> None:
    """Let one stand at each side of a thing: those that are there stay or move to it, and only what lacks is added."""
    phrase, recent = order.things[0], list[str]()
    for slot, id in sides.items():
        at = Noun("thing", work.scene[slot.anchors[0]].category, 0, 0, "it", det="the", id=slot.anchors[0])
        there = [Where(slot.kind, at, text=slot.kind.replace("_", " "))]
        head = Noun("part", "head", 0, 0, "the head", det="the")
        there += [Where("at", head, at, text="at")] if facts_of(at.value).is_in("beds") else []
        known = dataclasses.replace(phrase.noun, det="the", id=id) if id else phrase.noun
        one = dataclasses.replace(order, things=[dataclasses.replace(phrase, noun=known, id=id, places=there)])
        (move if id else add)(work, finder, dataclasses.replace(one, doing="move" if id else "add"))
        finder.scene = work.before = work.scene
        recent += finder.recent
    finder.recent = recent


def change_of(phrase: NounPhrase) -> str:
    """How a thing is to change by a comparative."""
    change = means("comparatives", phrase.noun.degree)
    if not change:
        raise InputError(f"'{phrase.noun.text}': what '{phrase.noun.degree}' means of it is not known")
    return change


def held(finder: Finder, phrase: NounPhrase) -> list[str]:
    """What a phrase fits and is where it says."""
    found = finder.matching(phrase.noun)
    for where in phrase.places:
        there = bound(where, found[0].category, finder) if found else None
        found = [p for p in found if there and p.id not in there.anchors and there.holds(finder.scene, p.id)]
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
        if order.total and (head := _with_sides(finder, phrase)):
            sides = 2 if any(w.noun is not None and w.noun.each for w in phrase.places) else 1
            so_many = dataclasses.replace(phrase, noun=_so_many(phrase.noun, (phrase.noun.count or 1) * sides))
            _let_have(work, finder, order, head, so_many)
            continue
        if any(map(_is_of_each, phrase.places)):
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


def _is_of_each(where: Where) -> bool:
    """Whether it speaks of each of several things, as what several have is had by each: "give the tables a lamp"."""
    noun = where.noun
    had = noun is not None and noun.kind == "thing" and noun.many and where.word == "to" and not where.negated
    return noun is not None and (noun.each or had)


def _at_each(work: Work, finder: Finder, order: Order, phrase: NounPhrase) -> None:
    """Add to each of several places what is lacking there: "every table should have four chairs"."""
    noun, alike = phrase.noun, finder.matching(phrase.noun)
    where = next(filter(_is_of_each, phrase.places))
    told = [w for w in phrase.places if w is not where and w.noun is not None and w.noun.kind == "place"]
    of = dataclasses.replace(where.noun, det="all", plural=True) if where.noun is not None else noun
    meant = named(finder, NounPhrase(of), told) if told else ()
    where = dataclasses.replace(where, noun=of)
    phrase = dataclasses.replace(phrase, places=[w for w in phrase.places if w not in told])
    more = 0
    for slot in slots_of(where, noun.value if noun.named else "", finder):
        if told and not {*slot.anchors} & {*meant}:
            continue
        goal = related(slot, alike[0].category) if alike else None
        there = [p.id for p in alike if goal is not None and goal.check(work.scene, work.scene, p.id)[0]]
        lacking = (noun.count or 1) - len(there)
        more += abs(lacking) if lacking > 0 or order.total else 0
        if lacking < 0 and order.total:
            take_away(work, work.touched(there[lacking:]))
            finder.scene = work.scene
        if lacking <= 0:
            continue
        at = Noun("thing", work.scene[slot.anchors[0]].category, 0, 0, "it", det="the", id=slot.anchors[0])
        here = dataclasses.replace(phrase, noun=_so_many(noun, lacking), places=[dataclasses.replace(where, noun=at)])
        add(work, finder, Order("add", order.text, things=[here], facing=order.facing, closer=order.closer))
        finder.scene = work.scene
    if not more:
        work.done.append(f"'{order.text}': it is so already")


def _so_many(noun: Noun, count: int) -> Noun:
    return dataclasses.replace(noun, count=count, plural=count > 1)
