"""Orders that bring something: add it, or let it come in place of another thing."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain, pairwise

from msgspec import structs

from thinkblox.assets import GENERAL_WORDS, facts_of
from thinkblox.assets.plurals import singular
from thinkblox.brief import Measures
from thinkblox.editing.acting import bears_nothing, centred, looking, mark_names, prefer_sides, related
from thinkblox.editing.carrying import CARRIERS, usual_carriers, usual_ties
from thinkblox.editing.finding import SAME_SIZE, Finder
from thinkblox.editing.goals import LOW_HUNG, Abreast, Across, Apart, At, Goal, Hung, Laid, Related, Spot, Unhidden
from thinkblox.editing.more_rows import add_rows, is_row
from thinkblox.editing.orders import SAME, NounPhrase, Order
from thinkblox.editing.place_settings import (
    are_seats_around,
    is_laid_before,
    is_set_beside,
    seat_like,
    settings_on,
    so_many,
)
from thinkblox.editing.reaching import Reaching, ties_of
from thinkblox.editing.rows import rows_of
from thinkblox.editing.spots import Pose, between, likely, spots
from thinkblox.editing.telling import anchored, named
from thinkblox.editing.wheres import Bound, corner_told, slots_for, spot_of, told_by
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.judging import asset_for
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.things import things as known_things
from thinkblox.plan import Target
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.measures import object_size
from thinkblox.reading.own_names import own_name
from thinkblox.reading.senses import choose_senses
from thinkblox.scene.asset import Asset
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.nearby import BACK_GAP, EYE
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

THERE = 0.75
"""How far from where something was another may stand that comes there [m]."""
NEIGHBOUR = 0.6
"""How far from a thing something stands at most on which small things are by that [m]."""
_BESIDE = ("next_to", "near", "left_of", "right_of")
MOST = 20
"""Most things that one order adds."""


def add(work: Work, finder: Finder, order: Order) -> None:
    """Add things where an order says, or where such things usually stand."""
    if not order.things:
        what = (
            f"'{', '.join(order.lost)}' is nothing that can be added" if order.lost else "that does not say what to add"
        )
        raise InputError(f"'{order.text}': {what}")
    recent: list[str] = []
    before = bool(finder.recent or finder.past.about)
    _fix_it(finder, order)
    for number, phrase in enumerate(order.things):
        if number and not recent and any(map(_is_by_it, phrase.places)):
            work.failed.append(f"{phrase.text} was not added: what it is to go by was not added either")
            continue
        later = next((p.places for p in order.things[number:] if p.places), order.places)
        if not before:
            later = [w for w in later if w.noun is None or w.noun.kind != "pronoun"]
        recent += _add(work, finder, order, phrase, phrase.places or later)
        finder.scene, finder.recent = work.scene, recent or finder.recent
    finder.recent = recent


def _is_by_it(where: Where) -> bool:
    """Whether a place is at "it", or a side of it."""
    nouns = [noun for noun in (where.noun, where.whole) if noun is not None]
    side = where.whole is None and any(noun.kind == "part" and noun.det == "my" for noun in nouns)
    return side or any(noun.kind == "pronoun" and noun.value == "it" for noun in nouns)


def _fix_it(finder: Finder, order: Order) -> None:
    """Let "it" be what an order before named, where what is added first carries nothing: "a bowl and a plate on it"."""
    small = [facts_of(p.noun.value).is_in("small") for p in order.things if p.noun.named]
    if len(order.things) < 2 or not all(small[:1] or [False]) or not finder.recent or order.things[0].places:
        return
    for where in (w for phrase in order.things for w in phrase.places):
        if where.noun is not None and where.noun.kind == "pronoun" and where.noun.value == "it":
            where.noun = replace(where.noun, id=finder.recent[-1])


def _add(work: Work, finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]) -> list[str]:
    phrase = _one_more(finder, phrase)
    noun = phrase.noun
    if (in_rows := _add_in_rows(work, finder, order, phrase, places)) is not None:
        return in_rows
    _check(noun)
    if noun.definite and not noun.id and noun.det == "the" and (there := finder.matching(noun)):
        raise InputError(f"'{noun.text}' is there already: {', '.join(p.id for p in there)}; add 'a' or 'another' one")
    finder.about = _one_at(finder, phrase, places)
    places = anchored(finder, places)
    within, places = _with(places)
    spots_said, places = [w for w in places if w.word == "spot"], [w for w in places if w.word != "spot"]
    guess = noun.value if noun.value not in GENERAL_WORDS else category_of(work, noun, ())
    slots = [slots_for(where, guess, finder, noun.count) for where in places]
    slots = _besides(finder, order, phrase, slots)
    if (there_already := _there_already(work, noun, guess, slots)) is not None:
        return there_already
    places, slots = _of_those(finder, places, slots)
    if noun.degree and noun.degree != SAME:
        raise InputError(f"'{noun.text}': {noun.degree} than what? Say a size, or replace one that is there")
    left = [finder.left_place(order.text)] if order.there else []
    left += [spot_of(where, "", work.start, finder) for where in spots_said]
    floor = [Bound("on", (spot.support,)) for spot in left if spot.support == "floor"]
    category = category_of(work, noun, [*(bounds[0] for bounds in slots), *floor])
    several = next((len(bounds) for bounds in slots if len(bounds) > 1), 1)
    if any(len(bounds) not in (1, several) for bounds in slots):
        raise InputError(f"'{order.text}' names several places of two kinds at once; give two orders")
    count = _how_many(noun, places, several)
    if count > MOST:
        raise InputError(f"'{noun.text}': one order adds at most {MOST} things; that would be {count}")
    added: list[str] = []
    for index in range(count):
        here = [bounds[index % len(bounds)] for bounds in slots]
        middles = [centred(work.scene, w) if order.centred else (w, []) for w in here]
        here = [w for w, _ in middles]
        goals = [goal for _, more in middles for goal in more]
        goals += [_related(work, one, category, index, count) for w in here for one in _under_each(w)]
        goals += [Related("on", (w.upon,)) for w in here if w.upon]
        goals += [Related("on", beside, negated=True) for w in places if (beside := told_by(w, finder))]
        goals += [looking(finder, n) for n in order.facing]
        goals += [_compared(finder, category, nearer, other) for nearer, other in order.closer]
        goals += [goal for spot in left for goal in _there_where(work, spot, category)]
        goals += [Apart(mark_names(finder, other), away, order.bound) for away, other in order.apart]
        goals = goals or _at_window(work, category)
        goals = _abreast(goals, order, added)
        tried = len(work.failed)
        id = (_at_their_table(work, category, noun) or _on_usual(work, finder, category, noun)) if not goals else ""
        id = id or (_on_neighbour(work, category, noun, here, goals) if len(work.failed) == tried else "")
        id = id or (add_one(work, category, noun, goals) if len(work.failed) == tried else "")
        if not id and several < 2:
            break
        added += [id] if id else []
        finder.scene = work.scene
    if len(added) < count and count > 1:
        work.failed.append(f"{len(added)} of {count} {category.replace('_', ' ')} were added")
    return added + add_with(work, finder, order, added, within)


def _laid_for_each(work: Work, finder: Finder, order: Order, noun: Noun, places: Sequence[Where]) -> list[str]:
    """Lay so many things on a table before the seats that are at it; empty where they do not lie so, or cannot."""
    onto = places[0] if len(places) == 1 and places[0].word in ("on", "to") and not places[0].negated else None
    table = onto.noun if onto is not None and onto.whole is None else None
    if table is None or table.kind not in ("thing", "pronoun") or table.many or order.facing or order.closer:
        return []
    ids = finder.ids(NounPhrase(table, id=table.id))
    spots = settings_on(work, noun.value, ids[0], noun.count or 1) if len(ids) == 1 else []
    saved, said = work.saved(), (len(work.done), len(work.failed))
    added: list[str] = []
    one = replace(noun, count=1, plural=False)
    for kind, id in spots:
        mark = Noun("thing", work.scene[id].category, 0, 0, id, det="the", id=id)
        came = _add(work, finder, Order("add", order.text), NounPhrase(replace(one)), [Where(kind, mark, text=kind)])
        if not came or work.scene[came[0]].support != ids[0]:
            work.restore(saved)
            del work.done[said[0] :], work.failed[said[1] :]
            finder.scene = work.scene
            return []
        added += came
    return added


def _one_more(finder: Finder, phrase: NounPhrase) -> NounPhrase:
    """Read "another one" as one more of what was named last, in this instruction or the edit before, which is said."""
    noun, last = phrase.noun, [id for id in (*finder.recent, *finder.past.about) if id in finder.scene]
    bare = noun.kind in ("number", "pronoun") and noun.text.lower() in ("another", "another one", "one more")
    if not bare or not last:
        return phrase
    category = finder.scene[last[-1]].category
    finder.seen.append(
        f"'{noun.text}' is taken to be another {category.replace('_', ' ')}, as {last[-1]} was named last"
    )
    one = Noun("thing", category, 0, 0, f"another {category.replace('_', ' ')}", det="another", named=True)
    return replace(phrase, noun=one)


def _add_in_rows(
    work: Work, finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]
) -> list[str] | None:
    """Add another row, more to one that is there, or one before each seat of a table; None where it is other."""
    if is_row(phrase.noun):
        return add_rows(work, finder, order, phrase, places)
    if laid := _laid_for_each(work, finder, order, phrase.noun, places):
        return laid
    line = _line_said(work, finder, phrase.noun, places)
    if not line or order.facing or order.closer or order.apart:
        return None
    return _add_to_line(work, phrase.noun, line)


def _line_said(work: Work, finder: Finder, noun: Noun, places: Sequence[Where]) -> list[str]:
    """Those of its kind that stand beside each other at a wall, which "to the row (along the wall)" names."""
    row = next((w.noun for w in places if w.noun is not None and w.noun.kind == "thing" and w.noun.rows == -1), None)
    if row is None or row.value != noun.value or row.text.lower().split()[-1] != "row":
        return []
    found = finder.matching(replace(row, rows=0, plural=True, count=None))
    walls = [[w.name for w in work.scene.room.walls if measure(work.scene, "against_wall", p.id, (w.name,)).holds]
             for p in found]  # fmt: skip
    first = next((names[0] for names in walls if names), "")
    kept = [p for p, names in zip(found, walls, strict=True) if first and first in names]
    if len(kept) < 2 or len(rows_of(work.scene, kept)) != 1:
        return []
    way = kept[0].left
    return [p.id for p in sorted(kept, key=lambda p: p.position[0] * way[0] + p.position[1] * way[1])]


def _add_to_line(work: Work, noun: Noun, line: list[str]) -> list[str]:
    """Add so many more at either end of those that stand beside each other at a wall."""
    added: list[str] = []
    count = noun.count or (2 if noun.plural else 1)
    for _ in range(min(count, MOST)):
        saved, said = work.saved(), len(work.failed)
        for end in (0, -1):
            goals: list[Goal] = [Abreast("next_to", (line[end],)), Related("against_wall", ("wall",))]
            if id := add_one(work, work.scene[line[end]].category, noun, goals):
                del work.failed[said:]
                line.insert(0 if end == 0 else len(line), id)
                added.append(id)
                break
            work.restore(saved)
        else:
            del work.failed[said + 1 :]
            break
    return added


def _under_each(where: Bound) -> list[Bound]:
    """A place under several things as one under each of them: "(three cushions and a rug) under them"."""
    several = where.kind == "under" and len(where.anchors) > 1
    return [replace(where, anchors=(name,)) for name in where.anchors] if several else [where]


def _abreast(goals: list[Goal], order: Order, came: Sequence[str]) -> list[Goal]:
    """What is asked of the second of several side by side, or across from one thing: to look where the first does."""
    related_ = [goal for goal in goals if isinstance(goal, Related) and not goal.negated]
    if not came or not (order.mutual == "next_to" or any(isinstance(goal, Across) for goal in goals)):
        return goals
    looks = [Related("facing", goal.anchors) for goal in related_ if goal.kind in ("opposite", "facing")]
    return [*(goal for goal in goals if goal not in related_), *looks, Abreast("next_to", (came[-1],))]


def _there_already(work: Work, noun: Noun, category: str, slots: list[list[Bound]]) -> list[str] | None:
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


def _there_where(work: Work, spot: Placement, category: str) -> list[Goal]:
    """At the spot of something that is gone: on what that stood on, and not on what is nearby."""
    mount, there = work.source.usual(category)[1], Spot(spot.position[:2], THERE, old=spot)
    stands = spot.support == "floor" and mount in ("floor", "surface")
    rests = spot.support in work.scene and mount == "surface"
    return [there, Related("on", (spot.support,))] if stands or rests else [there]


def _at_their_table(work: Work, category: str, noun: Noun) -> str:
    """Add one more seat to the table that all others like it are drawn up to; empty where that cannot be.

    What is said to be one more of them goes nowhere else; any other may.
    """
    alike = [p.id for p in work.scene.placements if p.category == category]
    if not alike or not facts_of(category).is_in("seating"):
        return ""
    tables = [p.id for p in work.scene.placements if facts_of(p.category).is_in("tables")]
    theirs = [table for table in tables if all(measure(work.scene, "at", id, (table,)).holds for id in alike)]
    saved, said = work.saved(), len(work.failed)
    goals = [_related(work, Bound("around", (table,)), category, 0, 1) for table in theirs[:1]]
    id = add_one(work, category, noun, goals) if goals else ""
    if goals and not id and noun.det != "another":
        work.restore(saved)
        del work.failed[said:]
    return id


def _on_usual(work: Work, finder: Finder, category: str, noun: Noun) -> str:
    """Add something small to the first of what usually carries it that has room; empty where none has.

    What was spoken of last comes first of these.
    """
    carriers = usual_carriers(work.scene, category) if work.source.usual(category)[1] == "surface" else []
    carriers = sorted(carriers, key=lambda id: id not in finder.recent)
    saved, said = work.saved(), len(work.failed)
    for carrier in carriers[:CARRIERS]:
        if id := add_one(work, category, noun, [related(Bound("on", (carrier,)), category)]):
            return id
        work.restore(saved)
        del work.failed[said:]
    return ""


def _at_window(work: Work, category: str) -> list[Goal]:
    """That what hangs at windows, as curtains do, hangs at one also where nothing is said."""
    habit = next(iter(load_habits().of(category)), None)
    hangs = habit is not None and habit.anchors[:1] == ("window",) and work.source.usual(category)[1] == "wall"
    return [Related(habit.kind, ("window",))] if hangs and habit is not None else []


def _one_at(finder: Finder, phrase: NounPhrase, places: Sequence[Where]) -> str:
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


def _on_neighbour(work: Work, category: str, noun: Noun, here: Sequence[Bound], goals: Sequence[Goal]) -> str:
    """Add something small by a thing on the floor to what carries such things beside that: "a kettle by the stove".

    Empty where nothing beside it carries it, or where it is said otherwise.
    """
    scene, beside = work.scene, [bound for bound in here if bound.kind in _BESIDE and not bound.negated]
    anchors = [name for bound in beside for name in bound.anchors if name in scene]
    plain = len(anchors) == len(beside) == len(here) == 1 and len(goals) <= 2
    let_in = plain and facts_of(scene[anchors[0]].category).is_in("built_in")
    if not plain or work.source.usual(category)[1] != "surface":
        return ""
    if not let_in and (beside[0].upon or len(goals) > 1 or scene[anchors[0]].support in scene):
        return ""
    mark, saved, said = things(scene, anchors[0])[0], work.saved(), len(work.failed)
    away = {id: ground_gap(things(scene, id)[0], mark) for id in usual_carriers(scene, category) if id != anchors[0]}
    for carrier in sorted((id for id in away if away[id] <= NEIGHBOUR), key=lambda id: away[id]):
        on: list[Goal] = [Related("near", (anchors[0],)), Related("on", (carrier,))]
        if id := add_one(work, category, noun, on):
            return id
        work.restore(saved)
        del work.failed[said:]
    return ""


def _besides(finder: Finder, order: Order, phrase: NounPhrase, slots: list[list[Bound]]) -> list[list[Bound]]:
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


def _of_those(finder: Finder, places: list[Where], slots: list[list[Bound]]) -> tuple[list[Where], list[list[Bound]]]:
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


def _check(noun: Noun) -> None:
    """Refuse what nothing can be added by.

    Raises:
        InputError: it is no thing, or says how many in a way that means nothing here.
    """
    words = noun.value.split("_")
    known = any(word in known_things() or f"any_{word}" in GENERAL_WORDS for word in map(singular, words[:-1]))
    bare = not noun.named and not (noun.det or noun.count or noun.plural or noun.id)
    if noun.kind != "thing" or noun.det in ("no", "none") or (not noun.named and known) or bare:
        raise InputError(f"'{noun.text}' is no thing that can be added")
    if noun.rows or noun.groups:
        raise InputError(f"'{noun.text}': rows and groups are not added as such; say how many, and where each goes")
    if noun.det in ("both", "half", "other", "each") or noun.fraction[1] or noun.every or noun.ordinal > 2:
        raise InputError(f"'{noun.text}' points at things that are there; say how many are to be added")


def _how_many(noun: Noun, places: Sequence[Where], several: int) -> int:
    """How many are added: of several places so many at each, unless the number is that of the places."""
    if several < 2:
        return noun.count or (2 if noun.plural else 1)
    each = any(where.noun is not None and where.noun.each and where.noun.det != "either" for where in places)
    if noun.count and noun.count > 1 and not each and noun.count % several == 0:
        return noun.count
    if noun.count and noun.count > 1 and not each:
        raise InputError(f"'{noun.text}' for {several} places: say how many go to each")
    return several * (noun.count or 1)


def _with(places: Sequence[Where]) -> tuple[list[Where], list[Where]]:
    """What is added along ("a table with four chairs"), and where things go."""
    along = [w for w in places if w.word == "with" and w.noun is not None and w.noun.kind == "thing"]
    return along, [w for w in places if w not in along]


def add_with(work: Work, finder: Finder, order: Order, heads: Sequence[str], along: Sequence[Where]) -> list[str]:
    """Add what goes with things that were added, at each of them."""
    added: list[str] = []
    for head in heads if along else ():
        finder.scene, finder.recent = work.scene, [head]
        for where in along:
            noun = seat_like(work, where.noun, head) if where.noun is not None else None
            it = Noun("thing", work.scene[head].category, 0, 0, "it", det="the", id=head)
            noun = so_many(work, noun, head, several=len(heads) > 1) if noun is not None else None
            if noun is not None and is_laid_before(work, noun.value, head):
                one = replace(noun, count=1, plural=False) if noun.plural and not noun.count else noun
                added += _add(work, finder, Order("add", order.text), NounPhrase(one), [Where("in_front_of", it)])
            elif noun is not None and is_set_beside(work, noun.value, head):
                added += _add(work, finder, Order("add", order.text), NounPhrase(noun), [Where("next_to", it)])
            elif noun is not None and are_seats_around(work, noun, head):
                around = [Where("around", it, text="around")]
                added += _add(work, finder, Order("add", order.text), NounPhrase(noun), around)
            elif noun is not None:
                added += _add(work, finder, Order("add", order.text), NounPhrase(noun), [Where("to", it, text="at")])
    return added


def _compared(finder: Finder, category: str, nearer: bool, other: NounPhrase) -> Goal:
    """Closer to something than things are that are added, which is near; or far from it."""
    return Related("near" if nearer else "far", mark_names(finder, other))


def _related(work: Work, where: Bound, category: str, index: int, count: int) -> Goal:
    """The goal of one of several that are added to those that are there."""
    there = _there(work, where, category)
    return related(where, category, there + (0 if where.kind == "around" else index), there + count - index)


def _there(work: Work, where: Bound, category: str) -> int:
    """How many of its kind are around the same thing already."""
    if where.kind != "around":
        return 0
    alike = [p.id for p in work.scene.placements if p.category == category]
    return sum(Bound("at", where.anchors).holds(work.scene, id) for id in alike)


def category_of(work: Work, noun: Noun, wheres: Sequence[Bound]) -> str:
    """The category that a noun means in this room and at that place: a "lamp" on a nightstand is a table lamp."""
    draft = Draft()
    thing = Mention(noun=noun.value, count=noun.count, plural=noun.plural, attributes=list(noun.attributes))
    draft.things.append(thing)
    draft.room = work.planned.brief.room_type if work.planned is not None else ""
    for where in wheres:
        for anchor in where.anchors:
            whole = Mention(work.scene[anchor].category) if anchor in work.scene else anchor
            draft.bonds.append(Bond(where.kind, thing, (whole,)))
    choose_senses(draft, {p.category for p in work.scene.placements})
    _, mount = work.source.usual(thing.noun)
    general = f"any_{noun.word}"
    raised = [b for b in wheres if b.kind == "on" and b.anchors and b.anchors[0] in work.scene]
    if raised and mount == "floor" and general in GENERAL_WORDS and noun.value != general:
        return category_of(work, replace(noun, value=general), wheres)
    return thing.noun


def add_one(
    work: Work,
    category: str,
    noun: Noun,
    goals: Sequence[Goal],
    *,
    asset: Asset | None = None,
    first: Sequence[Pose] = (),
) -> str:
    """Add one thing, as it is said or of an asset; its id, or an empty text where that cannot be, which is noted.

    Args:
        work: the edit.
        category: of the thing.
        noun: what is said of it.
        goals: where it is to be.
        asset: which it is to be; one as is said when not given.
        first: poses that are tried before others.
    """
    id = work.new_id(category)
    if load_habits().is_in(category, "screens"):
        others = [p.id for p in work.scene.placements if load_habits().is_in(p.category, "screens")]
        others = [name for name in others if work.asset_of(name).mount == "surface"]
        goals = [*goals, Unhidden(tuple(others))] if others else goals
    attributes, ties = tuple(noun.attributes), ties_of(goals)
    if all(tie.kind in ("facing", "opposite") for tie in ties):
        ties = (*usual_ties(work.scene, category), *ties)
    if work.source.usual(category)[1] == "wall" and _is_by_hung(work.scene, goals):
        goals = [*goals, Hung()]
    target = structs.replace(
        work.target(id, category, ties, attributes),
        size=object_size(category, noun.size),
        called=own_name(noun.called, category),
    )
    asset = asset or _asset(work, target, same=noun.degree == SAME)
    seats = [goal for goal in goals if isinstance(goal, Related) and goal.measured == "at"]
    seated = any(goal.anchors[0] in work.start for goal in seats)
    direct = chain(first, _between(work.scene, asset, goals), spots(work.scene, asset, goals) if seated else ())
    if any(isinstance(goal, Laid) for goal in goals):
        direct = chain(likely(work.scene, asset, goals), direct)
    direct = chain(_where_it_was(asset, goals), direct)
    spot = next((goal.point for goal in goals if isinstance(goal, At)), None)
    begin = _begin(work.scene, asset, spot) if spot is not None else None
    reaching = Reaching(work, target, asset, goals, direct=direct, begin=begin, more=likely(work.scene, asset, goals))
    saved = work.saved()
    reached = reaching.run()
    if not reached:
        why = bears_nothing(work, goals) or reaching.why.removeprefix(f"{id}: ")
        work.failed.append(f"{_named(work, category)} was not added: {why}")
        return ""

    def reach(other: Sequence[Goal]) -> bool:
        return Reaching(work, target, asset, other, direct=spots(work.scene, asset, other), ask=False).run()

    prefer_sides(work, id, goals, saved, reach)
    work.wish(id, goals)
    placement = work.scene[id]
    says = dict.fromkeys(goal.check(work.before, work.scene, id)[1] for goal in goals)
    found = "; ".join(filter(None, says))
    x, y, _ = placement.position
    on = f" on {placement.support}" if placement.support != "floor" else ""
    work.done.append(f"{id} added at ({x:.2f}, {y:.2f}){on}{f' ({found})' if found else ''}")
    return id


def _is_by_hung(scene: Scene, goals: Sequence[Goal]) -> bool:
    """Whether all that a place names hangs on a wall, as that which comes to it does then."""
    names = [name for goal in goals if isinstance(goal, Related) and not goal.negated for name in goal.anchors]
    known = [scene[name] for name in names if name in scene]
    return bool(known) and all(scene.asset_of(p).mount == "wall" and p.position[2] >= LOW_HUNG for p in known)


def _where_it_was(asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The very place of what stood on the floor where something comes now, turned as that was."""
    for old in (goal.old for goal in goals if isinstance(goal, Spot) and goal.old is not None):
        if asset.mount in ("floor", "surface") and old.support == "floor":
            yield (*old.position[:2], 0.0), old.yaw


def _between(scene: Scene, asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Places between two things, nearest to the middle of the way first."""
    for goal in goals:
        if isinstance(goal, Related) and goal.kind == "between" and asset.mount in ("floor", "wall"):
            yield from between(scene, asset, goal.anchors, 0.0)


def _named(work: Work, category: str) -> str:
    """What could not be added: "a plant", or "another plant" where one is there."""
    name = category.replace("_", " ")
    if any(p.category == category for p in work.scene.placements):
        return f"another {name}"
    return f"{'an' if name[:1] in 'aeiou' else 'a'} {name}"


def _begin(scene: Scene, asset: Asset, spot: Vec2) -> Pose:
    """Where the search for a place at a spot begins: what hangs begins at the wall that is nearest, at eye height."""
    if asset.mount != "wall":
        return (*spot, 0.0), 0.0
    wall = min(scene.room.walls, key=lambda wall: abs(wall.coordinates(spot)[1]))
    x, y = wall.point(wall.coordinates(spot)[0], asset.size[0] / 2 + BACK_GAP)
    return (x, y, max(0.0, EYE - asset.size[2] / 2)), wall.yaw


def _asset(work: Work, target: Target, *, same: bool = False) -> Asset:
    """What is added: another one like those that are there, unless something else is said of it."""
    alike = [p for p in work.scene.placements if p.category == target.category]
    if same and not alike:
        raise InputError(f"there is no {target.category.replace('_', ' ')} yet that another could be as large as")
    if same:
        made = asset_for(target, work.scene, work.source) if target.attributes else work.scene.asset_of(alike[-1])
        return made if made.size == alike[-1].size else work.source.fit(made, alike[-1].size)
    if alike and not target.attributes and target.size == (None, None, None):
        asset = work.scene.asset_of(alike[-1])
        return asset.called(target.called) if target.called else asset
    return of_size(asset_for(target, work.scene, work.source), target.size)


def of_size(made: Asset, size: Measures) -> Asset:
    """An asset that is to have a size, as far as one is said.

    Raises:
        InputError: it is not made so.
    """
    if any(wanted is not None and abs(wanted - side) > SAME_SIZE for wanted, side in zip(size, made.size, strict=True)):
        says = " by ".join(f"{wanted:.2f} m" for wanted in size if wanted is not None)
        is_now = " by ".join(f"{side:.2f}" for side in made.size)
        raise InputError(f"no {made.description} is made of {says}; the nearest is {is_now} m")
    return made
