"""Which of several things a phrase means by where it is said to be, by what it carries, and by whose it is."""

import dataclasses
import math
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from itertools import pairwise
from typing import get_args

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.editing.finding import Finder, Picks
from thinkblox.editing.goals import PartOfTop
from thinkblox.editing.grammar import means
from thinkblox.editing.orders import BEARS, BORE, NounPhrase
from thinkblox.editing.rows import rows_of
from thinkblox.editing.wheres import SIDED, Bound, bound, opening_named, place_text, slots_of, table_of, walls_of
from thinkblox.errors import InputError
from thinkblox.knowledge.things import are_alike
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import Landmark, corners, things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene

_THEIRS = ("its", "their", "his", "her")
BELONGING = 0.8
"""How far from a thing what belongs to it stands at most [m]."""
NEARNESS = (
    "next_to",
    "near",
    "at",
    "around",
    "in_corner",
    "against_wall",
    "in_front_of",
    "behind",
    "left_of",
    "right_of",
)
"""Relations by which the nearest of several is meant, where none has them by measure."""
CLOSE = 2.0
"""How far the nearest may be then [m]."""
TIE = 0.01
"""Two distances that differ by less are the same [m]."""
AS_NEAR = 0.3
"""How much further than the nearest of several another may be that is one of the nearest [m]."""
_SIDE_OF = {"in_front_of": (1, 0), "behind": (-1, 0), "left_of": (0, 1), "right_of": (0, -1)}


def anchored(finder: Finder, places: Sequence[Where]) -> list[Where]:
    """Places, where what follows an anchor of which there are several says which: "next to the chair by the window"."""
    settled: list[Where] = []
    for where in places:
        last = settled[-1].noun if settled else None
        if settled and (second := _told_second(finder, settled[-1], where)) is not None:
            settled[-1] = dataclasses.replace(settled[-1], second=second)
            continue
        told = bool(by_distance(where)) or where.text in (BEARS, BORE)
        if last is None or last.kind != "thing" or last.id or last.many or not last.definite or where.negated:
            settled.append(where)
            continue
        found = finder.matching(last)
        if len(found) == 1 and where.text in (BEARS, BORE):
            _named(finder, NounPhrase(last), [where], ())
            continue
        if len(found) == 1 and _is_bare_part(where) and settled[-1].word in ("on", "in"):
            settled[-1] = dataclasses.replace(where, whole=dataclasses.replace(last, id=found[0].id))
            continue
        if len(found) < 2 or not (told or where.noun is None or where.noun.kind in ("place", "thing", "part")):
            settled.append(where)
            continue
        id = _named(finder, NounPhrase(last), [where], ())[0]
        settled[-1] = dataclasses.replace(settled[-1], noun=dataclasses.replace(last, id=id))
    return [_by_carrier(finder, where, settled) for where in settled]


def _told_second(finder: Finder, where: Where, told: Where) -> Noun | None:
    """The second of two things between which something goes, by what follows it: "the sofa and the plant there"."""
    second, noun = where.second, told.noun
    if where.word != "between" or second is None or second.kind != "thing" or second.id or second.many:
        return None
    if not second.definite or told.negated or noun is None or noun.kind not in ("place", "thing", "part"):
        return None
    if len(finder.matching(second)) < 2:
        return None
    return dataclasses.replace(second, id=_named(finder, NounPhrase(second), [told], ())[0])


def _is_bare_part(where: Where) -> bool:
    """Whether it is a part of what was named before it: "on the table, in the middle"."""
    noun = where.noun
    part = noun is not None and noun.kind == "part" and noun.value in ("middle", *get_args(PartOfTop))
    return part and where.whole is None and where.word in ("on", "in", "at") and noun is not None and not noun.owner


def _by_carrier(finder: Finder, where: Where, places: Sequence[Where]) -> Where:
    """A place, where another names what its anchor rests on: "on the sideboard, next to the clock"."""
    noun = where.noun
    if noun is None or noun.kind != "thing" or noun.id or noun.many or not noun.definite or where.negated:
        return where
    found = finder.matching(noun)
    carriers = {
        p.id for w in places if w is not where and not w.negated and w.noun is not None for p in _alone(finder, w)
    }
    there = [p for p in found if carriers & set(finder.scene.carriers(p.id))]
    if len(found) < 2 or len(there) != 1:
        return where
    return dataclasses.replace(where, noun=dataclasses.replace(noun, id=there[0].id))


def _alone(finder: Finder, where: Where) -> list[Placement]:
    """The one thing that a place is at; none where it could be several."""
    noun = where.noun
    found = finder.matching(noun) if noun is not None and noun.kind == "thing" else []
    return found if len(found) == 1 else []


def named(finder: Finder, phrase: NounPhrase, said: Sequence[Where], *, picks: Sequence[Picks] = ()) -> tuple[str, ...]:
    """The objects that a phrase means, by where they are said to be, without those that it excepts.

    Raises:
        InputError: as `Finder.ids`, none of them is there, or all are excepted.
    """
    other = phrase.noun.det == "other"
    if phrase.spared and (other or (phrase.noun.of_known and phrase.noun.count)):
        every = tuple(p.id for p in finder.matching(phrase.noun))
        among = spare(finder, every, phrase.spared, phrase.noun)
        noun = dataclasses.replace(phrase.noun, det="the") if other else phrase.noun
        one = dataclasses.replace(phrase, noun=noun, spared=[])
        return finder.ids(one, picks=picks, among=[finder.scene[id] for id in among])
    if phrase.noun.det == "my" and phrase.noun.text.lower().split()[:1][0] in _THEIRS and not phrase.id:
        ids = _of_owners(finder, phrase)
        return spare(finder, ids, phrase.spared, phrase.noun)
    ids = _of_each_row(finder, phrase, said) or _at_each(finder, phrase, said)
    ids = ids or _named(finder, phrase, said, picks)
    finder.owners, finder.several = list(ids), [*finder.several, *ids]
    left = spare(finder, ids, phrase.spared, phrase.noun if phrase.noun.kind == "thing" else None)
    if ids and not left:
        raise InputError(f"'{phrase.text}' means nothing but what it excepts: {', '.join(ids)}")
    return left


def _at_each(finder: Finder, phrase: NounPhrase, said: Sequence[Where]) -> tuple[str, ...]:
    """So many at each of several places: "one chair on each side of the table"; none where that is not said.

    Raises:
        InputError: there are fewer at one of them.
    """
    noun = phrase.noun
    where = next((w for w in said if w.noun is not None and w.noun.each and not w.negated), None)
    count = noun.count or int(noun.det == "a")
    row = where is not None and any(n is not None and n.rows for n in (where.noun, where.whole))
    if where is None or row or not count or noun.definite or noun.kind != "thing":
        return ()
    found = finder.matching(dataclasses.replace(noun, plural=True, count=None))
    if not found:
        raise finder.nothing(noun.text)
    where, taken = of_their_table(finder, where, found), list[str]()
    count = 1 if where.text.lower().startswith("one ") else count
    for slot in slots_of(where, found[0].category, finder):
        left = [p.id for p in found if p.id not in taken]
        held = [id for id in left if slot.holds(finder.scene, id)]
        drawn = dataclasses.replace(slot, kind="at", side=None)
        held = held or [id for id in left if slot.anchors and slot.side is None and drawn.holds(finder.scene, id)]
        if len(held) < count:
            raise InputError(f"'{phrase.text}': there are only {len(held)} at {' and '.join(slot.anchors)}")
        taken += held[-count:]
    return tuple(taken)


def _of_each_row(finder: Finder, phrase: NounPhrase, said: Sequence[Where]) -> tuple[str, ...]:
    """The same one of every row: "the middle desk of each row", "the first desk in every row"; none of other phrases.

    Raises:
        InputError: a row has no such, or it is not said which.
    """
    noun, where = phrase.noun, said[0] if len(said) == 1 else None
    row = where.whole or where.noun if where is not None else None
    if where is None or row is None or row.kind != "number" or not row.rows or not row.each or noun.kind != "thing":
        return ()
    part = where.noun.value if where.noun is not None and where.noun.kind == "part" else noun.side
    rows = rows_of(
        finder.scene, finder.matching(dataclasses.replace(noun, plural=True, count=None, side="", ordinal=0))
    )
    rows = [row for row in rows if len(row) > 1]
    places = {"left": 1, "right": -1, "middle": 0}
    number = places.get(part) if part else noun.ordinal or None
    if number is None or (number == 0 and any(len(row) % 2 == 0 for row in rows)) or not rows:
        raise InputError(f"'{phrase.text}': which of each of {len(rows)} rows is not known; name them by id")
    at = [len(row) // 2 if number == 0 else number - 1 if number > 0 else number for row in rows]
    if any(n >= len(row) for n, row in zip(at, rows, strict=True)):
        raise InputError(f"'{phrase.text}': a row has fewer")
    return tuple(row[n].id for n, row in zip(at, rows, strict=True))


def _of_owners(finder: Finder, phrase: NounPhrase) -> tuple[str, ...]:
    """What belongs to what the same order named before: "the desks in the front row and their chairs".

    Raises:
        InputError: nothing of the kind is at any of them, or nothing was named before.
    """
    noun, named_last = phrase.noun, finder.owners or finder.recent or list(finder.past.about)
    if noun.text.lower().startswith("their ") and len(named_last) == 1 and len(finder.several) > 1:
        named_last = finder.several
    owners = [id for id in dict.fromkeys(named_last) if id in finder.scene]
    found = [p for p in finder.matching(noun) if p.id not in owners]
    if not found:
        raise finder.nothing(noun.text)
    if not owners:
        raise InputError(f"'{noun.text}': nothing was named before whose they are; name them by place or id")
    if own := tuple(p.id for p in finder.matching(noun) if p.id in owners):
        return own
    return _at_owners(finder, noun, owners, found)


def _at_owners(finder: Finder, noun: Noun, owners: Sequence[str], found: Sequence[Placement]) -> tuple[str, ...]:
    """What rests on some things, is drawn up to them or stands by them.

    Raises:
        InputError: nothing of it does.
    """
    found = [p for p in found if p.id not in owners]
    marks = {id: things(finder.scene, id)[0] for id in owners}
    away = {p.id: min(ground_gap(things(finder.scene, p.id)[0], mark) for mark in marks.values()) for p in found}
    seated = {p.id: any(measure(finder.scene, "at", p.id, (id,)).holds for id in owners) for p in found}
    resting = [p for p in found if set(finder.scene.carriers(p.id)) & set(owners)]
    near = resting or [p for p in found if seated[p.id]] or [p for p in found if away[p.id] <= BELONGING]
    if not near and finder.start is not None and finder.scene is not finder.start:
        begun = [p for p in finder.start.placements if p.id in away]
        return _at_owners(dataclasses.replace(finder, scene=finder.start), noun, owners, begun)
    if not near:
        raise InputError(f"'{noun.text}': none of {', '.join(away)} is within {BELONGING:g} m of {', '.join(owners)}")
    if not resting:
        near = [p for p in near if _nearest_owner(finder.scene, p, owners) in owners] or near
    if noun.det == "my" and not noun.many:
        near = _one_each(finder, noun, owners, near)
    return tuple(p.id for p in near)


def _nearest_owner(scene: Scene, placement: Placement, owners: Sequence[str]) -> str:
    """Of all things of the kinds of some owners that at which something stands, or which it is nearest to."""
    kinds = {scene[id].category for id in owners}
    rivals = [p.id for p in scene.placements if p.category in kinds and p.id != placement.id]
    mark = things(scene, placement.id)[0]
    drawn = facts_of(placement.category).is_in("seating")

    def rank(id: str) -> tuple[bool, float, float]:
        seated = drawn and measure(scene, "at", placement.id, (id,)).holds
        gap = round(ground_gap(mark, things(scene, id)[0]), 2)
        return not seated, gap, math.dist(placement.position[:2], scene[id].position[:2])

    return min(rivals, key=rank)


def _one_each(finder: Finder, noun: Noun, owners: Sequence[str], near: Sequence[Placement]) -> list[Placement]:
    """The one thing of each owner: "its plate", "their lamp".

    Raises:
        InputError: one of them has several that rest on it, or are as near to it.
    """
    scene, meant = finder.scene, list[Placement]()
    for owner in owners:
        own = [p for p in near if owner in scene.carriers(p.id)]
        if len(own) > 1:
            says = ", ".join(p.id for p in own)
            raise InputError(f"'{noun.text}' could be {says}, which are on {owner}; say which, or 'all of them'")
        own = own or [p for p in near if _nearest_owner(scene, p, owners) == owner]
        mark = things(scene, owner)[0]
        own.sort(
            key=lambda p: (
                round(ground_gap(things(scene, p.id)[0], mark), 2),
                math.dist(p.position, scene[owner].position),
            )
        )
        meant += [p for p in own[:1] if p not in meant]
    return meant


def spare(finder: Finder, ids: Sequence[str], spared: Sequence[NounPhrase], of: Noun | None = None) -> tuple[str, ...]:
    """Objects without those that are excepted: "except two" is the first two of them, "the one" one of `of`."""
    for phrase in spared:
        one = phrase.noun.kind == "pronoun" and phrase.noun.value == "one"
        if (one or phrase.noun.kind == "number") and not phrase.places and not phrase.noun.rows:
            ids = ids[1 if one else phrase.noun.count or 0 :]
        else:
            if phrase.noun.kind == "number" and of is not None:
                noun = dataclasses.replace(of, det="the", count=phrase.noun.count, plural=(phrase.noun.count or 1) > 1)
                phrase = dataclasses.replace(phrase, noun=noun)
            out = _spoken_of(finder, phrase, ids) or _of_them(finder, phrase, ids, of)
            out = out or _named(finder, phrase, phrase.places, ())
            ids = [id for id in ids if id not in out]
    return tuple(ids)


def _spoken_of(finder: Finder, phrase: NounPhrase, ids: Sequence[str]) -> tuple[str, ...]:
    """What a bare phrase excepts of some objects, where it fits one of them, and none of the others that are there."""
    noun = phrase.noun
    bare = noun.kind == "thing" and noun.definite and not (phrase.places or phrase.id or noun.id or noun.many)
    among = [p for p in finder.matching(noun) if p.id in ids] if bare else []
    if bare and not among:
        among = [p for p in finder.scene.placements if p.id in ids and are_alike(p.category, noun.value)]
    return (among[0].id,) if len(among) == 1 else ()


def _of_them(finder: Finder, phrase: NounPhrase, ids: Sequence[str], of: Noun | None) -> tuple[str, ...]:
    """Which of some objects a phrase of the same kind excepts by its side, number or size: "the left one" of them."""
    noun = phrase.noun
    told = noun.side or noun.ordinal or phrase.rank or noun.degree
    if of is None or noun.kind != "thing" or noun.value != of.value or phrase.places or noun.rows or not told:
        return ()
    return finder.ids(phrase, among=[finder.scene[id] for id in ids])


def _named(finder: Finder, phrase: NounPhrase, said: Sequence[Where], picks: Sequence[Picks]) -> tuple[str, ...]:
    if (sided := next((w for w in said if _is_of_side(w)), None)) is not None and sided.noun is not None:
        if phrase.noun.ordinal and sided.word in ("on", "at"):
            raise InputError(f"'{phrase.text}' can be counted in several ways; say which by its id or its place")
        phrase = dataclasses.replace(phrase, noun=dataclasses.replace(phrase.noun, side=sided.noun.value))
        said = [where for where in said if where is not sided]
    if not (phrase.id or phrase.noun.id) and (mark := _corner_of_word(finder.scene, phrase.noun)) is not None:
        return finder.ids(phrase, picks=picks, among=_foremost(finder, phrase.noun, mark))
    if not said or phrase.id or phrase.noun.kind == "pronoun":
        return finder.ids(phrase, picks=picks)
    said = anchored(finder, said) if len(said) > 1 else said
    every = finder.matching(phrase.noun, wide=True)
    found = every if any(by_distance(where) for where in said) else finder.matching(phrase.noun)
    if not found:
        raise finder.nothing(phrase.noun.text)
    if len(every) > len(found):
        for among in (found, every):
            with suppress(InputError):
                return finder.ids(phrase, picks=picks, among=_told(finder, phrase, said, among, just=True))
    try:
        found = _told(finder, phrase, said, found)
    except InputError:
        if len(every) <= len(found):
            raise
        found = _told(finder, phrase, said, every)
    return finder.ids(phrase, picks=picks, among=found)


def _corner_of_word(scene: Scene, noun: Noun) -> Landmark | None:
    """The corner of the room that is said of a thing itself: "the back left desk"."""
    words = noun.text.lower().split() if noun.kind == "thing" else []
    for depth, side in pairwise(words):
        if (wall := means("depths", depth)) and side in ("left", "right"):
            walls = {walls_of(scene, wall), walls_of(scene, f"{side}_wall")}
            of_walls = ((c, {*c.name.removeprefix("corner of ").split(" and ")}) for c in corners(scene.room))
            return next((corner for corner, names in of_walls if walls <= names), None)
    return None


def _foremost(finder: Finder, noun: Noun, mark: Landmark) -> list[Placement]:
    """The one of a kind that is nearest to a corner; the only one where it is on that side.

    Raises:
        InputError: the only one is on another side.
    """
    found = finder.matching(noun, wide=True)
    if not found:
        raise finder.nothing(noun.text)
    others = [c for c in corners(finder.scene.room) if c.name != mark.name]
    best = min(found, key=lambda p: math.dist(p.position[:2], mark.centre))
    if any(math.dist(best.position[:2], c.centre) < math.dist(best.position[:2], mark.centre) for c in others):
        raise InputError(
            f"there is no {noun.word} there: '{noun.text}'; there is {', '.join(map(finder.described, found))}"
        )
    return [best]


def _told(
    finder: Finder, phrase: NounPhrase, said: Sequence[Where], found: list[Placement], *, just: bool = False
) -> list[Placement]:
    """Those of several that are at all places that are said of them; `just` rules out what is only nearly there.

    Raises:
        InputError: none is.
    """
    for where in (of_their_table(finder, where, found) for where in said):
        if (owned := _by_other(finder, phrase, where, found)) is not None:
            found = owned
        elif superlative := by_distance(where):
            found = _by_distance(finder, phrase, where, found, far=superlative == "farthest")
        else:
            found = _by_any(finder, phrase, where, found) or _held(finder, phrase, where, found, just=just)
    return found


def of_their_table(finder: Finder, where: Where, found: Sequence[Placement]) -> Where:
    """A place, where a side or an end of nothing is that of the one table that most of some seats are drawn up to."""
    noun = where.noun
    bare = noun is not None and noun.kind == "part" and noun.value in SIDED and not (noun.owner or where.whole)
    if not bare or not all(facts_of(p.category).is_in("seating") for p in found):
        return where
    at = Counter(table for p in found if (table := table_of(finder.scene, p.id)))
    if not at or len(at) > 1:
        return where
    its = finder.scene[next(iter(at))]
    whole = Noun("thing", its.category, 0, 0, f"the {its.category.replace('_', ' ')}", det="the", id=its.id)
    return dataclasses.replace(where, whole=whole)


def _by_other(finder: Finder, phrase: NounPhrase, where: Where, found: Sequence[Placement]) -> list[Placement] | None:
    """Those that belong to another thing, carry it or carried it; None where a place says nothing like that."""
    noun = where.noun
    if noun is None or noun.kind not in ("thing", "pronoun"):
        return None
    if where.word == "of":
        return [finder.scene[id] for id in _at_owners(finder, phrase.noun, finder.ids(NounPhrase(noun)), found)]
    if where.text == BORE:
        return _carrier_before(finder, phrase, noun, found)
    if where.word == "with" and (noun.kind == "thing" or where.text == BEARS):
        return _bearing(finder, phrase, noun, found)
    return None


def _held(
    finder: Finder, phrase: NounPhrase, where: Where, found: Sequence[Placement], *, just: bool
) -> list[Placement]:
    """Those that are somewhere, or nearly so where that will do.

    Raises:
        InputError: none is.
    """
    part = where.noun is not None and where.noun.kind == "part" and where.noun.plural and where.whole is not None
    sides = slots_of(where, found[0].category, finder) if part and not where.negated else []
    there = sides[0] if sides else bound(where, found[0].category, finder)
    at = sides or [there]
    held = [p for p in found if p.id not in there.anchors and any(side.holds(finder.scene, p.id) for side in at)]
    if there.seat and not phrase.noun.many:
        held = [p for p in held if _nearest_owner(finder.scene, p, [there.seat]) == there.seat]
    walled = bool(there.anchors) and all(name.endswith("wall") for name in there.anchors)
    if not held and walled and where.noun is not None and "side" in where.noun.text.lower().split():
        held = _on_that_side(finder.scene, found, there.anchors)
    if not held and where.word in ("from", "on") and walled:
        there = dataclasses.replace(there, kind="against_wall")
        held = [p for p in found if there.holds(finder.scene, p.id)]
        there = dataclasses.replace(there, kind="on")
    elif not held and where.word == "from":
        there = dataclasses.replace(there, kind="at")
        held = [p for p in found if there.holds(finder.scene, p.id)]
        there = dataclasses.replace(there, kind="near")
    if there.kind in NEARNESS and not (just or there.negated or sides) and len(held) < (phrase.noun.count or 1):
        held = _nearly(finder.scene, phrase.noun, found, there)
    if not held:
        says = ", ".join(finder.described(p) for p in found)
        raise InputError(f"there is no {phrase.noun.word} {place_text(where)}; there is {says}")
    return held


def _bearing(finder: Finder, phrase: NounPhrase, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
    """Those on which something rests: "the sideboard with the vase".

    Raises:
        InputError: nothing of it rests on any of them.
    """
    resting = finder.ids(NounPhrase(noun)) if noun.kind == "pronoun" else [p.id for p in finder.matching(noun)]
    carriers = {id for rider in resting for id in finder.scene.carriers(rider)}
    if bearing := [p for p in found if p.id in carriers]:
        return bearing
    raise InputError(f"there is no {phrase.noun.word} with {noun.text} on it; there {finder.listed()}")


def _carrier_before(finder: Finder, phrase: NounPhrase, noun: Noun, found: Sequence[Placement]) -> list[Placement]:
    """That on which something was standing before it was moved, or stands still: "the table it was standing on".

    Raises:
        InputError: it stood on none of them.
    """
    riders = finder.ids(NounPhrase(noun, id=noun.id))
    stood = {id: finder.left_carrier(id) for id in riders}
    if held := [p for p in found if p.id in stood.values()]:
        return held
    says = ", ".join(f"{id} stood on {carrier or 'nothing that is known'}" for id, carrier in stood.items())
    raise InputError(f"there is no {phrase.noun.word} that {noun.text} was standing on: {says}")


def _on_that_side(scene: Scene, found: Sequence[Placement], walls: Sequence[str]) -> list[Placement]:
    """Those of seats around one table that are at its side towards a wall."""
    tables = [p for p in scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    at = [t for t in tables if all(measure(scene, "at", p.id, (t.id,)).holds for p in found)]
    side = next((wall for wall in scene.room.walls if wall.name in walls), None)
    if len(at) != 1 or side is None:
        return []
    x, y = -side.inward[0], -side.inward[1]
    ahead, across = (x * way[0] + y * way[1] for way in (at[0].front, at[0].left))
    kind: RelationKind = "in_front_of" if ahead > 0 else "behind"
    if abs(across) > abs(ahead):
        kind = "left_of" if across > 0 else "right_of"
    return [p for p in found if measure(scene, kind, p.id, (at[0].id,)).holds]


def _by_any(finder: Finder, phrase: NounPhrase, where: Where, found: Sequence[Placement]) -> list[Placement]:
    """So many as are meant that are at any of several anchors: "the plant next to the bookcase", of which one is so.

    None where the anchor is told, or others would be meant too.
    """
    noun = where.noun
    if noun is None or noun.kind != "thing" or noun.id or noun.many or not noun.definite or where.negated:
        return []
    anchors = finder.matching(noun)
    if len(anchors) < 2 or where.second is not None or noun.degree or noun.side or noun.ordinal:
        return []
    at = (dataclasses.replace(where, noun=dataclasses.replace(noun, id=p.id)) for p in anchors)
    places = [bound(one, found[0].category, finder) for one in at]
    held = [p for p in found if any(p.id not in b.anchors and b.holds(finder.scene, p.id) for b in places)]
    wanted = 2 if phrase.noun.det == "both" else phrase.noun.count or (0 if phrase.noun.many else 1)
    return held if len(held) == wanted else []


def by_distance(where: Where) -> str:
    """Whether it says which of several by their distance: "nearest" or "farthest"; empty where it does not."""
    words = where.text.lower().split()
    return next((found for word in words if (found := means("nearest", word) or means("nearer_of_two", word))), "")


def _is_of_side(where: Where) -> bool:
    """Whether it says which of several by their side: "the chairs on the left"."""
    noun = where.noun
    plain = noun is not None and noun.kind == "part" and not (where.whole or where.negated or noun.owner)
    sided = plain and noun is not None and noun.value in ("left", "right") and noun.det == "the"
    return sided and where.word in ("on", "from")


def _by_distance(
    finder: Finder, phrase: NounPhrase, where: Where, found: Sequence[Placement], *, far: bool
) -> list[Placement]:
    """The one that is nearest to a place or thing, or farthest from it; of several so many as are said."""
    noun = where.noun
    if noun is None or noun.kind not in ("place", "thing", "pronoun"):
        raise InputError(f"'{place_text(where)}' is no place to be near to")
    names = (opening_named(finder.scene, noun),) if noun.kind == "place" else finder.ids(NounPhrase(noun, id=noun.id))
    marks = [mark for name in names for mark in things(finder.scene, name)]
    if not marks:
        raise InputError(f"the room has no {noun.value.replace('_', ' ')}")
    away = {p.id: min(ground_gap(things(finder.scene, p.id)[0], mark) for mark in marks) for p in found}
    ordered = sorted((p for p in found if p.id not in names), key=lambda p: -away[p.id] if far else away[p.id])
    count = 2 if phrase.noun.det == "both" else phrase.noun.count or 1
    alike = phrase.noun.plural and not phrase.noun.count and phrase.noun.det != "both"
    if not alike and len(ordered) > count and abs(away[ordered[count].id] - away[ordered[count - 1].id]) < TIE:
        near = [p.id for p in ordered if abs(away[p.id] - away[ordered[count].id]) < TIE]
        raise InputError(f"'{phrase.text}': {', '.join(near)} are as near as each other; say which by its id")
    if alike:
        return [p for n, p in enumerate(ordered) if n < 2 or abs(away[p.id] - away[ordered[0].id]) <= AS_NEAR]
    return ordered[:count]


def _nearly(scene: Scene, noun: Noun, found: Sequence[Placement], there: Bound) -> list[Placement]:
    """Those that are nearly where they are said to be: on that side of a thing, or not far from it."""
    if there.kind in _SIDE_OF and len(there.anchors) == 1 and there.anchors[0] in scene:
        found = [p for p in found if _is_on_side(scene[there.anchors[0]], p, there.kind)]
    several = noun.many and not noun.count
    marks = _marks(scene, there)
    near = _nearest(scene, found, marks, len(found) if several else noun.count or 1)
    if not several:
        return near
    return [p for p in near if min(ground_gap(things(scene, p.id)[0], mark) for mark in marks) <= CLOSE / 2]


def _is_on_side(thing: Placement, placement: Placement, kind: str) -> bool:
    """Whether something is further out on one side of a thing than on another, by that thing's outline."""
    ahead, left = (
        at / max(side, 1e-6) for at, side in zip(thing.to_local(placement.position[:2]), thing.size[:2], strict=True)
    )
    x, y = _SIDE_OF[kind]
    return ahead * x + left * y > 0.0 and (abs(ahead) >= abs(left)) == bool(x)


def _marks(scene: Scene, there: Bound) -> list[Landmark]:
    """From what a distance to a place counts: of a corner it is that corner, not the walls that meet there."""
    if there.kind == "in_corner" and there.anchors != ("corner",):
        found = [
            c for c in corners(scene.room) if {*there.anchors} <= {*c.name.removeprefix("corner of ").split(" and ")}
        ]
        if found:
            return found
    return [mark for name in there.anchors for mark in things(scene, name)]


def _nearest(scene: Scene, found: Sequence[Placement], marks: Sequence[Landmark], count: int) -> list[Placement]:
    away = {p.id: min((ground_gap(things(scene, p.id)[0], mark) for mark in marks), default=CLOSE) for p in found}
    return [p for p in sorted(found, key=lambda p: away[p.id])[:count] if away[p.id] < CLOSE]
