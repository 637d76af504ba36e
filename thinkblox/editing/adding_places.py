"""Which of several places things are added at: those that are not excepted, and not those that have one."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from thinkblox.assets import facts_of
from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.telling import named
from thinkblox.editing.wheres import Bound, corner_told
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things


def there_already(work: Work, noun: Noun, category: str, slots: list[list[Bound]]) -> list[str] | None:
    """What is to be added and is there, which is noted; None where something has to be added."""
    if noun.det != "another" and not _without_laid(work, category, slots):
        work.done.append(f"{noun.text} is before each of them: it is so already")
        return []
    if noun.det in ("a", "") and not noun.attributes and (lies := _lies_there(work, category, slots)):
        work.done.append(f"{lies} lies there: it is so already")
        return [lies]
    return None


def _lies_there(work: Work, category: str, slots: Sequence[Sequence[Bound]]) -> str:
    """The rug that lies already where one is to be added; empty where none does."""
    alike = [p.id for p in work.scene.placements if p.category == category and facts_of(category).is_in("covers")]
    single = [bounds[0] for bounds in slots if len(bounds) == 1]
    under = bool(single) and len(single) == len(slots) and all(bound.kind == "under" for bound in single)
    there = [id for id in alike if under and all(bound.holds(work.scene, id) for bound in single)]
    return there[0] if there else ""


def one_at(finder: Finder, phrase: NounPhrase, places: Sequence[Where]) -> str:
    """One of its kind from which "the other side of the island" is seen; empty where none is."""
    other = [w for w in places if w.noun is not None and w.noun.kind == "part" and w.noun.det == "other"]
    whole = other[0].whole if len(other) == 1 else None
    if whole is None or whole.kind != "thing":
        return ""
    marks = finder.matching(whole)
    kind = replace(phrase.noun, det="all", count=None, plural=True, attributes=[], unshown=[])
    if len(marks) != 1:
        return ""
    mark = things(finder.scene, marks[0].id)[0]
    alike = sorted(finder.matching(kind), key=lambda p: ground_gap(mark, things(finder.scene, p.id)[0]))
    return alike[0].id if alike else ""


def besides(finder: Finder, order: Order, phrase: NounPhrase, slots: list[list[Bound]]) -> list[list[Bound]]:
    """The places of several without those that are excepted: "a plant to every desk except the last".

    Raises:
        InputError: there is no such place among them, or nothing that could be excepted from.
    """
    if phrase.spared:
        raise InputError(f"'{order.text}': of what is added nothing can be excepted; say how many")
    if not order.besides:
        return slots
    corners = [bounds for bounds in slots if bounds[0].kind == "in_corner"]
    if corners and all(p.noun.kind != "thing" or p.noun.text.endswith("one") for p in order.besides):
        told = [where for other in order.besides for where in other.places]
        there = [corner_told(finder, where.noun) for where in told if where.noun is not None]
        return [[slot for slot in bounds if slot.anchors not in there] for bounds in slots]
    out = {id for other in order.besides for id in named(finder, other, other.places)}
    left = [[slot for slot in bounds if not out & set(slot.anchors)] for bounds in slots]
    if not any(len(a) < len(b) for a, b in zip(left, slots, strict=True)) or not all(left):
        raise InputError(f"'{order.text}': {', '.join(sorted(out))} is none of several places that are named")
    return left


def _without_laid(work: Work, category: str, slots: list[list[Bound]]) -> bool:
    """Leave out the seats of several before which such a thing lies already; False where none is left."""
    scene = work.scene
    laid = [p for p in scene.placements if p.category == category]
    for at, bounds in enumerate(slots):
        seats = [bound.seat for bound in bounds]
        if len(seats) < 2 or not all(seats):
            continue
        near = [min(seats, key=lambda seat: math.dist(scene[seat].position[:2], p.position[:2])) for p in laid]
        served = {seat for seat, p in zip(near, laid, strict=True) if bounds[seats.index(seat)].holds(scene, p.id)}
        slots[at] = [bound for bound in bounds if bound.seat not in served]
    return all(slots)


def of_those(finder: Finder, places: list[Where], slots: list[list[Bound]]) -> tuple[list[Where], list[list[Bound]]]:
    """Of each of several things those that are where it is said behind them: "to every table near the window".

    Raises:
        InputError: it is a corner, which things have as well.
    """
    for at, (where, told) in enumerate(pairwise(places)):
        noun, place = where.noun, told.noun
        each = noun is not None and noun.kind == "thing" and noun.each and not where.negated
        if not each or noun is None or place is None or place.kind != "place" or told.negated:
            continue
        if place.value.split()[0] == "corner":
            raise InputError(
                f"'{told.text} {place.text}' could be a corner of the room or of what carries it; say 'on the left side"
                " of'"
            )
        meant = named(finder, NounPhrase(replace(noun, det="all", plural=True)), [told])
        slots[at] = [slot for slot in slots[at] if set(slot.anchors) & set(meant)]
        return [*places[: at + 1], *places[at + 2 :]], [*slots[: at + 1], *slots[at + 2 :]]
    return places, slots


def before_each(slots: list[list[Bound]]) -> list[list[Bound]]:
    """The places, where those before several seats are one for each: "a plate in front of chair 6 and chair 7".

    That it is on their table goes without saying then.
    """
    tables = [bound.anchors for bounds in slots for bound in bounds if bound.seat]
    slots = [b for b in slots if b[0].seat or b[0].part or b[0].kind != "on" or b[0].anchors not in tables]
    seated = [bounds for bounds in slots if len(bounds) == 1 and bounds[0].seat]
    if len(seated) < 2:
        return slots
    return [*(bounds for bounds in slots if bounds not in seated), [bounds[0] for bounds in seated]]


def of_lacking(places: Sequence[Where]) -> tuple[list[Where], Noun | None]:
    """The places without what each of several is told by that it does not carry: "on each table without a plate"."""
    each = any(w.noun is not None and w.noun.kind == "thing" and w.noun.each and not w.negated for w in places)
    said = [w for w in places if each and w.word == "without" and w.noun is not None and w.noun.kind == "thing"]
    return [w for w in places if w not in said], said[0].noun if said else None


def not_bearing(finder: Finder, slots: list[list[Bound]], load: Noun) -> list[list[Bound]]:
    """Of several places those at what carries no such thing.

    Raises:
        InputError: there is no such place among them.
    """
    loads = finder.matching(replace(load, det="all", count=None, plural=True))
    carriers = {id for p in loads for id in finder.scene.carriers(p.id)}
    left = [[slot for slot in bounds if not carriers & {*slot.anchors}] for bounds in slots]
    if not all(left):
        raise InputError(f"none of {', '.join(s.anchors[0] for s in slots[0] if s.anchors)} is without {load.text}")
    return left


def how_many(noun: Noun, places: Sequence[Where], several: int) -> int:
    """How many are added: of several places so many at each, unless the number is that of the places."""
    if several < 2:
        return noun.count or (2 if noun.plural else 1)
    each = any(where.noun is not None and where.noun.each and where.noun.det != "either" for where in places)
    if noun.count and noun.count > 1 and not each and noun.count % several == 0:
        return noun.count
    if noun.count and noun.count > 1 and not each:
        raise InputError(f"'{noun.text}' for {several} places: say how many go to each")
    return several * (noun.count or 1)
