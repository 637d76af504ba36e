"""Orders that move things: to a place, by so much, nearer to or away from others, or just elsewhere."""

import dataclasses
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, permutations

from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.editing.acting import (
    backing,
    centred,
    findings,
    looking,
    mark_names,
    prefer_sides,
    reach_goals,
    related,
    say,
)
from thinkblox.editing.beside_at_wall import beside_at_wall
from thinkblox.editing.carrying import usual_carriers, usual_ties
from thinkblox.editing.company import company_of, gathered, with_company
from thinkblox.editing.finding import Finder, Picks, nearest_to
from thinkblox.editing.goals import (
    ELSEWHERE,
    ELSEWHERE_SMALL,
    Abreast,
    Across,
    Apart,
    At,
    BackTo,
    Central,
    Elsewhere,
    Free,
    Goal,
    IntoRoom,
    MidOf,
    Midway,
    Nearing,
    OnSide,
    Raised,
    Related,
    Spot,
)
from thinkblox.editing.grammar import means, sections
from thinkblox.editing.into_corners import into_corner
from thinkblox.editing.lengthwise import beside_wall, lengthwise
from thinkblox.editing.moving_rows import by_rows, row_to_wall, shifted_at_once
from thinkblox.editing.off_floor import lifted
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.pairing import pair_up
from thinkblox.editing.parting import with_room_between
from thinkblox.editing.reaching import Reaching, without
from thinkblox.editing.scattering import scatter
from thinkblox.editing.spots import (
    Pose,
    along_walls,
    at_wall,
    between,
    by_gap,
    likely,
    middle_off,
    shifted,
    spots,
    whole_floor,
)
from thinkblox.editing.stepping import SLIGHT, SLIGHT_STEPS, STEPS, by_step, way_of
from thinkblox.editing.taking_place import THERE, at_spot, is_there, there_where
from thinkblox.editing.telling import anchored, by_distance, named, spare
from thinkblox.editing.turning import face_each_other, turn_by, turns
from thinkblox.editing.wheres import Bound, bound, slots_for, slots_of, spot_of, told_by
from thinkblox.editing.work import Work
from thinkblox.editing.zones import place_named
from thinkblox.errors import InputError
from thinkblox.plan import Tie, is_object
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things, walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene

OTHER_CORNER = 1.5
"""How far from where it was something stands at least that goes to another corner [m]."""
LEFT = 0.3
"""How far from where it was something stands at least that is said to leave a part of the room [m]."""
MIDDLE = 0.3
"""How far from the middle that is asked for something may stand that is left where it is [m]."""
AT_IT = 0.06
"""How far something may stand from what it is put against [m]."""
TOUCHING = 0.005
"""A gap that cannot be made smaller [m]."""
_RESTS = ("on", "from", "in", "inside", "on_top")
MOST_SLOTS = 5
"""Most things that are shared out to places so that as few as can be have to move."""
SHARES = (0.5, 0.65, 0.35, 0.8, 0.2, 0.95)
"""Which share of a gap is closed where nobody says it."""
_LOOKS = ("facing", "opposite")
_PUSHED = ("push", "shove")
"""Verbs by which things come together without a gap, where that can be."""
FAR_OFF, NEARER = 1.5, 0.7
"""From how far off what stands at a wall comes closer along walls [m], and to which share of the way at most."""
SLIGHT_SHARES = (0.25, 0.15, 0.35)
"""The same for "a bit"."""


def move(work: Work, finder: Finder, order: Order) -> None:
    """Move things to where an order says, or by as much, or nearer to or away from something."""
    if order.together or order.scatter or order.mutual not in ("", "facing"):
        _to_each_other(work, finder, order)
        return
    if " ".join(order.text.lower().split()[:2]) in _lined_up() and (wall := _any_wall(order)) is not None:
        _line_up(work, finder, order, wall)
        return
    if order.touching:
        raise InputError(f"'{order.text}': without a gap to what? Say 'against the bed', or 'side by side'")
    if order.besides:
        raise InputError(f"'{order.text}' excepts places of what is moved; say where it goes")
    seen: set[tuple[str, str]] = set()
    order = gathered(work, finder, order)
    groups = list(_groups(work, finder, order))
    moving = {id for ids, _ in groups for id in ids}
    order = by_rows(work, order, sorted(moving))
    if shifted_at_once(work, order, groups) or row_to_wall(work, finder, order, groups):
        finder.recent = [id for ids, _ in groups for id in ids]
        return
    along = {mate for id in moving - _seats(work, moving) for mate in company_of(work, finder, order, id)}
    for ids, places in groups:
        _check_says_where(order, places)
        ids = tuple(id for id in ids if id not in along and not moving & set(work.before.carriers(id)))
        ids = _by_slots(work, finder, ids, places)
        told = _to_one_wall(work, order, ids)
        came: list[str] = []
        for index, id in enumerate(_foremost_first(work, finder, order, ids)):
            said = (id, " ".join(f"{w.text} {w.noun.text if w.noun else ''}" for w in places))
            if said in seen:
                continue
            seen.add(said)
            finder.scene, finder.about = work.scene, id
            goals = _abreast(_goals(work, finder, told, id, places, index, len(ids)), came)
            came.append(id)
            with_company(work, finder, order, id, lambda id=id, goals=goals: _move_and_turn(work, order, id, goals))  # type: ignore[misc]
        finder.recent = list(ids)
    if order.mutual == "facing":
        face_each_other(work, finder, order)


def _abreast(goals: list[Goal], came: Sequence[str]) -> list[Goal]:
    """The goals, where the second of several that go across from a thing stands beside the first."""
    across = [goal for goal in goals if isinstance(goal, Across)]
    if not across or not came:
        return goals
    beside: list[Goal] = [Related("facing", across[0].anchors), Abreast("next_to", (came[-1],))]
    return [goal for goal in goals if goal not in across] + beside


def _to_each_other(work: Work, finder: Finder, order: Order) -> None:
    """Bring things to where they stand to each other as an order says."""
    if order.mutual in ("face_to_face", "back_to_back"):
        pair_up(work, finder, order)
        return
    _together(work, finder, order)
    if order.mutual == "facing":
        face_each_other(work, finder, dataclasses.replace(order, things=[]))


def _seats(work: Work, ids: Iterable[str]) -> set[str]:
    return {id for id in ids if facts_of(work.scene[id].category).is_in("seating")}


def _lined_up() -> frozenset[str]:
    return frozenset(" ".join(words) for words in sections()["rows_of"])


def _any_wall(order: Order) -> Where | None:
    """The place of an order that is a wall, and does not say which."""
    places = [*order.places, *(where for phrase in order.things for where in phrase.places)]
    walls = [where for where in places if where.noun is not None and where.noun.value == "wall" and not where.negated]
    return walls[0] if walls and walls[0].whole is None and walls[0].second is None else None


def _line_up(work: Work, finder: Finder, order: Order, where: Where) -> None:
    """Let all that is named stand at one wall: at the longest at which it can."""
    said, saved, before, noun = (len(work.done), len(work.failed)), work.saved(), work.scene, where.noun
    failed: list[str] = []
    lined = [p.position[:2] for phrase in order.things for p in finder.matching(phrase.noun)]
    walls_ = sorted(
        work.scene.room.walls,
        key=lambda wall: (-round(wall.length, 1), sum(wall.coordinates(spot)[1] for spot in lined)),
    )
    if noun is not None and noun.degree:
        named_ = bound(where, "", finder).anchors
        walls_ = [wall for wall in walls_ if wall.name in named_]
    for wall in walls_:
        where.noun = dataclasses.replace(noun, value=wall.name, degree="") if noun is not None else None
        plain = dataclasses.replace(order, text=wall.name)
        move(work, finder, plain)
        if len(work.failed) == said[1]:
            break
        failed = failed or work.failed[said[1] :]
        work.restore(saved)
        del work.done[said[0] :], work.failed[said[1] :]
        finder.scene = work.before = before
    else:
        work.failed += [f"no wall has room for all of them: {failed[0]}"]


def _groups(work: Work, finder: Finder, order: Order) -> Iterable[tuple[tuple[str, ...], list[Where]]]:
    """What is moved; of several that go nearer to something, or away from it, those in front first."""
    if not order.closer or order.direction or len(order.things) < 2:
        return _moved(work, finder, order)
    groups = [group for group in _moved(work, finder, order) if group[0]]
    ranks = {id: n for n, id in enumerate(_foremost_first(work, finder, order, [ids[0] for ids, _ in groups]))}
    return sorted(groups, key=lambda group: ranks[group[0][0]])


def _by_slots(work: Work, finder: Finder, ids: Sequence[str], places: Sequence[Where]) -> tuple[str, ...]:
    """Things in the order of the places that a phrase names for them, so that as few as can be have to move."""
    if not 1 < len(ids) <= MOST_SLOTS or len(places) != 1 or places[0].word == "spot":
        return tuple(ids)
    finder.about = ids[0]
    category = work.scene[ids[0]].category
    slots = slots_of(places[0], category, finder)
    if len(ids) % len(slots):
        return tuple(ids)
    slots *= len(ids) // len(slots)
    goals = [related(slot, category) for slot in slots]
    held = {(id, n): goal.check(work.scene, work.scene, id)[0] for id in ids for n, goal in enumerate(goals)}
    return max(permutations(ids), key=lambda ordered: sum(held[id, n] for n, id in enumerate(ordered)))


def _to_one_wall(work: Work, order: Order, ids: Sequence[str]) -> Order:
    """The order, where a row that goes "closer to the wall" goes to that which is nearest to all of it together."""
    bare = [phrase.noun.value == "wall" and not phrase.noun.degree for _, phrase in order.closer]
    if len(ids) < 2 or not any(bare) or not any(phrase.noun.rows for phrase in order.things):
        return order
    marks = [things(work.scene, id)[0] for id in ids]
    wall = min(
        walls(work.scene.room, "wall"), key=lambda w: sum(ground_gap(m, things(work.scene, w.name)[0]) for m in marks)
    )
    closer = [
        (
            nearer,
            dataclasses.replace(phrase, noun=dataclasses.replace(phrase.noun, value=wall.name)) if plain else phrase,
        )
        for (nearer, phrase), plain in zip(order.closer, bare, strict=True)
    ]
    return dataclasses.replace(order, closer=closer)


def _foremost_first(work: Work, finder: Finder, order: Order, ids: Sequence[str]) -> Sequence[str]:
    """Things that go one way, those in front first, so that none runs into the next."""
    if len(ids) < 2 or not (order.direction or order.closer):
        return ids
    if not order.direction:
        nearer, phrase = order.closer[0]
        if phrase.noun.det == "my":
            return ids
        gap = Nearing(mark_names(finder, phrase), nearer)
        return sorted(ids, key=lambda id: gap.of(work.scene, id) * (1.0 if nearer else -1.0))
    x, y, _ = way_of(work, order, work.scene[ids[0]])
    return sorted(ids, key=lambda id: -(work.scene[id].position[0] * x + work.scene[id].position[1] * y))


def _move_and_turn(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> None:
    """Move one thing, and turn it where the same order says by how much."""
    if goals or order.direction:
        move_one(work, order, id, goals)
    if order.turn is not None:
        turn_by(work, id, order)


def _is_told(order: Order) -> bool:
    """Whether an order says how far or which way things go, or what they are to face."""
    return bool(order.closer or order.apart or order.direction or order.facing or order.backs or order.seated)


def _check_says_where(order: Order, places: Sequence[Where]) -> None:
    told = (order.closer, order.apart, order.direction, order.facing, order.backs, order.seated, order.mutual)
    if not (places or any(told) or order.there or order.free):
        raise InputError(f"'{order.text}' does not say where to; say a place, such as 'next to the bed'")
    if order.lengths and not (order.closer or order.direction or order.seated == "out" or order.scatter):
        said = ", ".join(f"{metres:.4g} m" for metres, _ in order.lengths)
        raise InputError(
            f"'{order.text}': it is not clear what {said} is; say 'to the left', 'from the wall' and so on"
        )
    if order.direction and order.closer:
        raise InputError(f"'{order.text}' says two ways at once; give two orders")


def _moved(work: Work, finder: Finder, order: Order) -> Iterator[tuple[tuple[str, ...], list[Where]]]:
    """What is moved, with what is said of where it goes."""
    if order.rest and not order.things and (carried := _all_on(work, finder, order)) is not None:
        yield carried
        return
    if order.rest and not order.things:
        floor = [p for p in work.scene.placements if p.support == "floor"]
        everything = [p.id for p in floor if order.direction or work.scene.asset_of(p).collides]
        destination = [w for w in order.places if w.word != "except"]
        yield work.touched(spare(finder, everything, order.spared)), destination
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    for number, phrase in enumerate(order.things):
        later = next((p.places for p in order.things[number:] if p.places), order.places)
        places = phrase.places or later
        if phrase.noun.kind in ("place", "part"):
            raise InputError(f"'{phrase.noun.text}' is no thing that can be moved; there {finder.listed()}")
        qualifiers, destination = _split(finder, order, phrase, places)
        destination = anchored(finder, destination)
        phrase = _for_each(finder, phrase, destination)
        ids = named(finder, phrase, qualifiers, picks=_picks(finder, order, phrase, destination))
        leaves = any(w.word == "from" and w.noun is not None and w.noun.kind == "place" for w in qualifiers)
        if leaves and not destination and not _is_told(order):
            out = [w for w in qualifiers if w.word == "from" and w.noun is not None and w.noun.kind == "place"]
            destination = [dataclasses.replace(w, word="in", negated=True) for w in out]
        order.leaves |= leaves and bool(destination)
        yield work.touched(ids), destination


def _for_each(finder: Finder, phrase: NounPhrase, places: Sequence[Where]) -> NounPhrase:
    """As many as all places hold, where so many are to be at each: "two of the chairs on each side of the table"."""
    noun = phrase.noun
    each = places[0].noun if len(places) == 1 else None
    if each is None or not each.each or not noun.of_known or (noun.count or 0) < 2 or noun.kind != "thing":
        return phrase
    found = finder.matching(dataclasses.replace(noun, count=None, plural=True))
    slots = slots_of(places[0], found[0].category, finder) if found else []
    return dataclasses.replace(phrase, noun=dataclasses.replace(noun, count=(noun.count or 1) * max(len(slots), 1)))


def _all_on(work: Work, finder: Finder, order: Order) -> tuple[tuple[str, ...], list[Where]] | None:
    """What rests on a thing, and where it goes: "everything on the desk to the shelf"; None where that is not said.

    Raises:
        InputError: nothing rests there.
    """
    here = next((w for w in order.places if w.word in _RESTS and not w.negated), None)
    destination = [w for w in order.places if w is not here and w.word != "except"]
    if here is None or here.noun is None or here.noun.kind not in ("thing", "pronoun") or not destination:
        return None
    carriers = finder.ids(NounPhrase(here.noun, id=here.noun.id))
    resting = [p.id for p in work.scene.placements if p.support in carriers]
    if not resting:
        raise InputError(f"'{order.text}': nothing rests on {', '.join(carriers)}")
    return work.touched(spare(finder, resting, order.spared)), destination


def _split(
    finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]
) -> tuple[list[Where], list[Where]]:
    """Where the thing is said to be now, and where it is to go."""
    here = [w for w in places if w.word in ("from", "of")]
    rest = [w for w in places if w.word not in ("from", "of")]
    if phrase.places is not places and not phrase.places:
        return here, rest
    told = [w for w in rest if not w.negated and by_distance(w)]
    more = len(told) < len(rest) or order.mutual or order.together or _is_told(order)
    if told and phrase.noun.definite and more:
        here, rest = [*here, *told], [w for w in rest if w not in told]
    apart = order.scatter and order.doing == "move"
    directed = next((n for n, w in enumerate(rest) if w.text.lower() in ("to", "into", "onto", "over to")), None)
    if order.closer or order.direction or order.seated or apart or order.doing == "resite":
        at = len(rest) if directed is None or not order.closer else directed
        return [*here, *rest[:at]], rest[at:]
    if directed is not None and directed > 0:
        return [*here, *rest[:directed]], rest[directed:]
    wanted = [w for w in rest if not w.negated]
    if len(wanted) > 1 and directed is None and phrase.noun.kind == "thing":
        known = bool(phrase.id or phrase.noun.id or phrase.noun.ordinal)
        several = len(finder.matching(phrase.noun)) > 1 and not phrase.noun.many and not here and not known
        several |= all(w.word == "on" and w.noun is not None and w.noun.kind == "thing" for w in wanted[:2])
        if several or (wanted[0].word in ("next_to", "on", "in", "by", "at") and wanted[1].word in ("to", "next_to")):
            return [*here, *rest[:1]] if several else here, rest[1:] if several else rest
    return here, rest


def _picks(finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]) -> tuple[Picks, ...]:
    """Of several that fit, those of which an order makes sense: what is not yet where it is to go."""

    def left_there(found: Sequence[Placement]) -> Sequence[Placement]:
        for where in (w for w in places if w.negated):
            away = bound(where, found[0].category, finder)
            found = [p for p in found if not away.holds(finder.scene, p.id)]
        return found

    def not_yet(found: Sequence[Placement]) -> Sequence[Placement]:
        if phrase.noun.det == "all" or any(_is_seen_from_it(w) for w in places):
            return found
        wanted = [bound(w, found[0].category, finder) for w in places if not w.negated and w.word != "spot"]
        return [p for p in found if not all(b.holds(finder.scene, p.id) for b in wanted if not b.of_room)]

    picks: list[Picks] = [left_there] if any(w.negated for w in places) else []
    if any(not w.negated and w.word != "spot" for w in places):
        picks.append(not_yet)
    for _, anchor in order.closer:
        if anchor.noun.det == "my":
            continue
        name = anchor.noun.value if anchor.noun.kind == "place" else ""
        if not name:
            name = finder.ids(anchor)[0]
        count = 2 if phrase.noun.det == "both" else phrase.noun.count or 0
        if count > 1:
            picks.append(nearest_to(finder.scene, name, count))
    return tuple(picks)


def _is_seen_from_it(where: Where) -> bool:
    """Whether a place depends on what is moved: "to the other side", "the nearest wall", "in each corner"."""
    noun = where.noun
    seen = noun is not None and (noun.det == "other" or noun.each or bool(means("nearest", noun.degree)))
    return seen or (noun is not None and noun.kind == "place" and "opposite" in noun.text.lower().split())


def _goals(
    work: Work, finder: Finder, order: Order, id: str, places: Sequence[Where], index: int, count: int
) -> list[Goal]:
    goals = [goal for where in places for goal in _at_place(work, finder, order, id, where, index, count)]
    if order.there:
        goals.append(there_where(work, id, finder.left_place(order.text)))
    goals += [Elsewhere(LEFT)] if order.leaves else []
    goals += [Free(place_named(noun)) for noun in order.free]
    if order.slight and (order.closer or order.direction):
        goals.append(At(work.scene[id].position[:2], SLIGHT))
    if order.seated:
        goals += _seated(work, id, order)
    said = [phrase.noun for _, phrase in order.apart]
    closer = [(nearer, phrase) for nearer, phrase in order.closer if not any(noun is phrase.noun for noun in said)]
    goals += [_nearing(work, finder, order, id, nearer, phrase) for nearer, phrase in closer]
    goals += [Apart(mark_names(finder, phrase), away, order.bound) for away, phrase in order.apart]
    goals += [backing(finder, noun) for noun in order.backs]
    return goals + [looking(finder, noun) for noun in order.facing]


def _at_place(
    work: Work, finder: Finder, order: Order, id: str, where: Where, index: int, count: int
) -> Iterator[Goal]:
    """What a place wants of one of several that are moved there."""
    if where.word == "spot":
        old = spot_of(where, id, work.start, finder)
        yield Spot(old.position[:2], THERE, old=old)
        return
    if where.text in ("long_side", "short_side") and where.noun is not None:
        yield from lengthwise(work, finder, id, where)
        return
    if where.noun is not None and _is_any_other_corner(where, where.noun):
        yield Related("in_corner", ("corner",))
        yield Elsewhere(OTHER_CORNER)
        return
    category = work.scene[id].category
    slots = slots_for(where, category, finder, count)
    text = f"{where.text} {where.noun.text if where.noun else ''}"
    if len(slots) > max(count, 1) and where.noun is not None and where.noun.kind == "thing" and where.noun.det == "the":
        slots = slots[: max(count, 1)]
    if len(slots) > max(count, 1):
        raise InputError(f"'{order.text}': '{text}' names {len(slots)} places, for {count} to be moved")
    there = slots[index % len(slots)]
    if id in there.anchors and not there.negated:
        raise InputError(f"{id} cannot be put where it is itself: '{text}'")
    yield from _strictly(work, finder, where, there, category)
    if order.centred:
        there, more = centred(work.scene, there)
        yield from more
        if any(isinstance(goal, Midway) for goal in more):
            return
    if order.abreast and there.kind == "next_to" and not there.negated and all(map(is_object, there.anchors)):
        yield Abreast("next_to", there.anchors)
        return
    yield related(there, category, index, count)


def _strictly(work: Work, finder: Finder, where: Where, there: Bound, category: str) -> Iterator[Goal]:
    """What a place asks for besides its relation: in the middle about there, against a thing close to it."""
    if there.kind == "in_centre" and _carries(work, there.anchors, category):
        yield Related("on", there.anchors)
    if there.upon:
        yield Related("on", (there.upon,))
    if beside := told_by(where, finder):
        yield Related("on", beside, negated=True)
    if there.kind == "in_centre" and there.anchors == ("centre",) and not there.negated:
        yield Central()
    if there.kind == "in_front_of" and not there.negated and _sits_before(work, there.anchors, category):
        yield Related("at", there.anchors)
    if there.kind == "next_to" and where.word == "against" and not there.negated:
        yield Apart(there.anchors, AT_IT, "le")


def _is_any_other_corner(where: Where, noun: Noun) -> bool:
    """Whether it is "another corner", whichever."""
    bare = where.whole is None and where.second is None and not where.negated and "opposite" not in noun.text.lower()
    return noun.value == "corner" and noun.det in ("other", "another") and bare and not noun.many


def _nearing(work: Work, finder: Finder, order: Order, id: str, nearer: bool, phrase: NounPhrase) -> Goal:
    """How far nearer to something, or away from it; of "their desks" to the one that is nearest."""
    by = order.lengths[0][0] if order.lengths else None
    if phrase.noun.det == "my" and phrase.noun.text.lower().split()[0] in ("its", "their"):
        many = dataclasses.replace(phrase.noun, plural=True, count=None)
        own = tuple(p.id for p in finder.matching(many) if p.id != id)
        if not own:
            raise finder.nothing(phrase.noun.text)
        nearest = min(own, key=lambda name: Nearing((name,), nearer=True).of(work.scene, id))
        return Nearing((nearest,), nearer, by, order.slight)
    anchors = mark_names(finder, phrase)
    if anchors == ("wall",) and not nearer and at_wall(work.scene, id):
        behind = [w.name for w in work.scene.room.walls if measure(work.scene, "against_wall", id, (w.name,)).holds]
        anchors = tuple(behind[:1])
    if order.rest and not nearer and by is not None:
        return Apart(anchors, by, "ge")
    return Nearing(anchors, nearer, by, order.slight)


def _sits_before(work: Work, anchors: Sequence[str], category: str) -> bool:
    """Whether a chair is put before a desk or table, to which it is drawn up then."""
    tables = [facts_of(work.scene[name].category) for name in anchors if name in work.scene]
    drawn = facts_of(category).is_in("seats")
    return drawn and bool(tables) and all(facts.is_in("tables", "desks") for facts in tables)


def _carries(work: Work, anchors: Sequence[str], category: str) -> bool:
    """Whether something small goes on a thing of which it is to be in the middle."""
    surfaced = [name for name in anchors if name in work.scene and work.asset_of(name).surfaces]
    return bool(surfaced) and facts_of(category).is_in("small")


def _seated(work: Work, id: str, order: Order) -> list[Goal]:
    """A seat is pushed in to the table that is nearest to it, or pulled out from it.

    Raises:
        InputError: it is no seat, or no table is there.
    """
    tables = [p.id for p in work.scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    if not facts_of(work.scene[id].category).is_in("seating") or not tables:
        raise InputError(f"'{order.text}': {id} is no seat at a table; say where to")
    mark = things(work.scene, id)[0]
    table = min(tables, key=lambda name: ground_gap(mark, things(work.scene, name)[0]))
    if order.seated == "in":
        return [Related("at", (table,))]
    return [Nearing((table,), nearer=False, by=order.lengths[0][0] if order.lengths else None, slight=order.slight)]


def move_one(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> None:
    """Move one object to where it meets the goals, and the order's direction; notes what became of it."""
    before = work.scene[id]
    if not order.direction and into_corner(work, id, goals):
        return
    if goals and not order.direction and all(_is_so(work, goal, id) for goal in goals):
        work.done.append(f"{id} stays: it is so already ({'; '.join(findings(work, goals, id))})")
        work.wish(id, goals)
        return
    if order.direction in ("up", "down") and work.asset_of(id).free and not (goals or order.lengths):
        _to_other_height(work, order, id)
        return
    gap = next((goal for goal in goals if isinstance(goal, Nearing)), None)
    if gap is not None and gap.nearer and gap.by is None and gap.of(work.scene, id) < TOUCHING:
        work.done.append(f"{id} stays: it is at {', '.join(gap.anchors)} already")
        return
    if gap is not None:
        direct: Iterator[Pose] = chain(_along_wall_to(work, id, gap), _by_so_much(work.scene, before, gap))
        done = reach_goals(work, id, goals, direct=direct, ask=True)
    elif order.direction and not order.closer:
        direct, more = by_step(work, order, before)
        goals = [*goals, *more]
        done = reach_goals(work, id, goals, direct=direct, ask=False, search=not order.lengths)
    else:
        done, goals = _to_place(work, order, id, goals)
    if done is None or not _with_its_worktop(work, id, goals):
        say(work, id, before, done, goals)


def _to_place(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> tuple[Reaching | None, Sequence[Goal]]:
    """Move one object to a place that is said; what was tried where that failed, and the goals that were met."""

    def reach(other: Sequence[Goal]) -> bool:
        return reach_goals(work, id, other, direct=_spots(work, id, other)) is None

    if (upon := lifted(work, id, goals, reach)) is not None:
        return None, upon
    if (walled := beside_at_wall(work, id, goals)) is not None:
        return None, walled
    before = work.scene[id]
    direct: Iterator[Pose] = chain(
        at_spot(work, id, goals),
        _midway(work.scene, before, goals),
        _onto_line(work.scene, before, goals),
        beside_wall(work.scene, work.asset_of(id), before, goals),
        _in_line(work.scene, before, goals),
        _so_far(work.scene, before, goals),
        _spots(work, id, goals),
    )
    if any(isinstance(goal, Related) and goal.kind == "against_wall" and goal.count > 1 for goal in goals):
        direct = chain(direct, likely(without(work.scene, [id]), work.asset_of(id), goals))
    if any(isinstance(goal, Apart) for goal in goals):
        direct = chain(_aside(work.scene, before, goals), direct)
    done = _reach_beside(work, id, goals, direct)
    if done is not None and (half := _in_half(order, goals)):
        goals = half
        done = reach_goals(work, id, goals, direct=_half_poses(work, id, half), ask=False)
    if done is not None and _with_others(work, id, goals):
        done = None
    return done, goals


def _with_others(work: Work, id: str, goals: Sequence[Goal]) -> bool:
    """Move one thing to between two others that are moved apart for it."""
    return with_room_between(
        work, id, goals, lambda: reach_goals(work, id, goals, direct=_spots(work, id, goals)) is None
    )


def _with_its_worktop(work: Work, id: str, goals: Sequence[Goal]) -> bool:
    """Move the cabinet that a sink or hob is let into, with that and all else on it, to where that is to be."""
    carrier = work.scene[id].support
    if not facts_of(work.scene[id].category).is_in("built_in") or carrier not in work.scene:
        return False
    if carrier in work.kept or any(carrier in getattr(goal, "anchors", ()) for goal in goals):
        return False
    before = work.scene[carrier]
    if reach_goals(work, carrier, goals, direct=_spots(work, carrier, goals)) is not None:
        return False
    say(work, carrier, before, None, goals)
    work.notes.append(f"{id} is let into {carrier}, and goes where that goes")
    return True


def _in_half(order: Order, goals: Sequence[Goal]) -> list[Goal]:
    """The goals with the half of the room at a wall in place of that wall, where a side of the room is said."""
    nouns = [w.noun for w in (*order.places, *(w for p in order.things for w in p.places)) if w.noun is not None]
    sided = any(noun.kind == "place" and "side" in noun.text.lower().split() for noun in nouns)
    walled = [g for g in goals if type(g) is Related and g.kind == "against_wall" and len(g.anchors) == 1]
    if not sided or len(walled) != 1 or walled[0].negated:
        return []
    return [OnSide(walled[0].anchors[0]) if goal is walled[0] else goal for goal in goals]


def _half_poses(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Along the walls of that half, the nearest to the middle of its wall first, and then on its whole floor."""
    wall = next(work.scene.room.wall(goal.wall) for goal in goals if isinstance(goal, OnSide))
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    middle = wall.point(wall.length / 2, 0.0)
    asset, before = work.asset_of(id), work.scene[id]
    x, y = work.scene.room.polygon.centroid.coords[0]
    _, half = wall.coordinates((x, y))
    poses = chain(
        along_walls(empty, asset, middle, math.inf) if at_wall(work.scene, id) else (),
        whole_floor(empty, asset, structs.replace(before, position=(*middle, before.position[2]))),
    )
    yield from (pose for pose in poses if wall.coordinates(pose[0][:2])[1] < half)


def _reach_beside(work: Work, id: str, goals: Sequence[Goal], direct: Iterator[Pose]) -> Reaching | None:
    """As `reach_goals`; what is to be beside a thing stands at its left or right where it can."""
    saved = work.saved()
    done = reach_goals(work, id, goals, direct=direct, ask=True)
    if done is None:
        prefer_sides(
            work, id, goals, saved, lambda other: reach_goals(work, id, other, direct=_spots(work, id, other)) is None
        )
    return done


def _is_so(work: Work, goal: Goal, id: str) -> bool:
    """Whether a goal is met as it is: of what is to be in the middle or between things not only about so."""
    near = (
        not isinstance(goal, Related)
        or isinstance(goal, Midway)
        or middle_off(work.scene, id, goal.kind, goal.anchors) <= MIDDLE
    )
    if isinstance(goal, At) and goal.reach >= THERE:
        near = is_there(work, goal, id)
    if isinstance(goal, Related) and goal.kind in ("at", "around") and id in _seats(work, [id]):
        near = _sits_at(work.scene, id) in goal.anchors
    return near and goal.check(work.before, work.scene, id)[0]


def _sits_at(scene: Scene, id: str) -> str:
    """The table or counter that a seat is nearest to."""
    tables = [p.id for p in scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    mark = things(scene, id)[0]
    return min(tables, key=lambda name: ground_gap(mark, things(scene, name)[0]), default="")


def _spots(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Places that the goals name, seen without the object and what rests on it."""
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    before = work.scene[id]
    if any(isinstance(goal, Related) and goal.kind == "in_centre" and goal.anchors == ("centre",) for goal in goals):
        x, y = work.scene.room.polygon.centroid.coords[0]
        yield from whole_floor(empty, work.asset_of(id), structs.replace(before, position=(x, y, before.position[2])))
    if any(isinstance(g, Related) and g.kind == "against_wall" and g.anchors == ("wall",) for g in goals):
        yield from along_walls(empty, work.asset_of(id), before.position[:2], math.inf)
    for goal in goals:
        if isinstance(goal, Related) and goal.kind == "between" and work.asset_of(id).mount == "floor":
            yield from between(empty, work.asset_of(id), goal.anchors, before.yaw)
    yield from spots(empty, work.asset_of(id), goals)


def _midway(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, moved along the line between two things to the middle of it."""
    for goal in (g for g in goals if isinstance(g, Midway)):
        off, way = goal.off(scene, before.position[:2])
        yield shifted(before, (-off * way[0], -off * way[1], 0.0)), before.yaw


def _onto_line(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, moved aside onto the line through the middle of a thing."""
    for goal in [MidOf(g.anchors[0]) if isinstance(g, Across) else g for g in goals]:
        if not isinstance(goal, MidOf):
            continue
        mark = things(scene, goal.anchor)[0]
        ahead, left = mark.to_local(before.position[:2])
        off, way = (ahead, mark.yaw) if goal.across else (left, mark.yaw + 90.0)
        x, y = math.cos(math.radians(way)), math.sin(math.radians(way))
        yield shifted(before, (-off * x, -off * y, 0.0)), before.yaw


def _in_line(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, where only the front is to point elsewhere."""
    if goals and all(
        isinstance(goal, IntoRoom | BackTo) or (isinstance(goal, Related) and goal.kind == "facing") for goal in goals
    ):
        yield from turns(scene, before, goals)


def _so_far(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Before, behind and beside a thing, at the distance that is wanted and turned to it."""
    for goal in (g for g in goals if isinstance(g, Apart)):
        for anchor in (scene[name] for name in goal.anchors if name in scene):
            for turn in (0.0, 180.0, 90.0, 270.0):
                way = math.radians(anchor.yaw + turn)
                deep = anchor.size[0] if turn in (0.0, 180.0) else anchor.size[1]
                reach = (deep + before.size[0]) / 2 + goal.away
                x, y = anchor.position[0] + reach * math.cos(way), anchor.position[1] + reach * math.sin(way)
                yaw = (anchor.yaw + turn + 180.0) % 360.0
                yield (round(x, 4), round(y, 4), before.position[2]), yaw


def _by_so_much(scene: Scene, placement: Placement, gap: Nearing) -> Iterator[Pose]:
    """Nearer to something, or further from it: by what is said, or by several shares of the way."""
    now = gap.of(scene, placement.id)
    if gap.by is not None:
        lengths: tuple[float, ...] = (gap.by,)
    elif gap.nearer:
        shares = SLIGHT_SHARES if gap.slight else SHARES
        lengths = tuple(share * now for share in shares) if now > 0.005 else ()
    else:
        lengths = SLIGHT_STEPS if gap.slight else STEPS
    yield from by_gap(scene, placement, gap.anchors, [-length if gap.nearer else length for length in lengths])


def _along_wall_to(work: Work, id: str, gap: Nearing) -> Iterator[Pose]:
    """About half of the way to what is far off, for what stands at a wall: at a wall again."""
    before, asset = work.scene[id], work.asset_of(id)
    marks = [mark for name in gap.anchors for mark in things(work.scene, name)]
    plain = gap.nearer and gap.by is None and not gap.slight and len(marks) == 1
    if not plain or not at_wall(work.scene, id) or gap.of(work.scene, id) < FAR_OFF:
        return
    now, there = math.dist(before.position[:2], marks[0].centre), marks[0].centre
    poses = along_walls(without(work.scene, [id, *(r.id for r in work.scene.riders(id))]), asset, there, NEARER * now)
    yield from sorted(poses, key=lambda pose: abs(math.dist(pose[0][:2], there) - now / 2))


def _aside(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, moved to the distance that is wanted."""
    for goal in (g for g in goals if isinstance(g, Apart)):
        if any(things(scene, name) for name in goal.anchors):
            yield from by_gap(scene, before, goal.anchors, [goal.away - goal.of(scene, before.id)])


def _to_other_height(work: Work, order: Order, id: str) -> None:
    """Put what rests on something on what is higher, or lower, and carries it: what usually does first."""
    before, up = work.scene[id], order.direction == "up"
    usual = usual_carriers(work.scene, before.category)
    others = [p for p in work.scene.placements if p.id not in usual and work.asset_of(p.id).surfaces and p.id != id]
    near = [p.id for p in sorted(others, key=lambda p: math.dist(p.position, before.position))]
    failed: Reaching | None = None
    for carrier in [*usual, *near]:
        tops = [work.scene[carrier].position[2] + s.position[2] for s in work.asset_of(carrier).surfaces]
        if carrier == before.support or (max(tops) > before.position[2] + TOUCHING) != up:
            continue
        goals: list[Goal] = [Related("on", (carrier,)), Raised(up)]
        if (why := reach_goals(work, id, goals, direct=_spots(work, id, goals), ask=True)) is None:
            say(work, id, before, None, goals)
            return
        failed = failed or why
    if failed is not None:
        say(work, id, before, failed, ())
        return
    raise InputError(f"'{order.text}': nothing that is {'higher' if up else 'lower'} than {id} carries such a thing")


def _together(work: Work, finder: Finder, order: Order) -> None:
    """Bring things nearer to each other, or further apart: the largest stays."""
    ids = list(dict.fromkeys(id for ids, _ in _moved(work, finder, order) for id in ids))
    if len(ids) < 2:
        raise InputError(f"'{order.text}' names one thing; say what it is to come closer to, or away from")
    if order.scatter and len(ids) > 2:
        if _placed(order):
            raise InputError(f"'{order.text}' says how far apart things are to be and where; give two orders")
        scatter(work, ids, by=order.lengths[0][0] if order.lengths else None, slight=order.slight)
        finder.recent = ids
        return
    fixed, *rest = sorted(ids, key=lambda id: -work.scene[id].size[0] * work.scene[id].size[1])
    by = order.lengths[0][0] if order.lengths else None
    also = _also(work, finder, order, fixed)
    if also:
        move_one(work, order, fixed, also)
    looks = [goal for goal in also if isinstance(goal, IntoRoom) or (isinstance(goal, Related) and goal.kind in _LOOKS)]
    placed = [fixed]
    for id in rest:
        beside = order.mutual == "next_to"
        next_to = Abreast("next_to", (placed[-1],)) if order.abreast else Related("next_to", (fixed,))
        goal = next_to if beside else Nearing((fixed,), order.together, by, order.slight)
        there = _also(work, finder, order, id) if also and not _cornered(also) else looks
        there = [Related("facing", goal.anchors) if isinstance(goal, Across) else goal for goal in there]
        close = Apart((placed[-1] if order.abreast else fixed,), AT_IT, "le")
        pushed = beside and order.text.lower().split(" ", 1)[0] in _PUSHED
        saved, said = work.saved(), len(work.failed)
        move_one(work, order, id, [goal, *([close] if order.touching or pushed else []), *there])
        if len(work.failed) > said and pushed and not order.touching:
            work.restore(saved)
            del work.failed[said:]
            move_one(work, order, id, [goal, *there])
        placed.append(id)
    finder.recent = ids


def _cornered(goals: Sequence[Goal]) -> bool:
    """Whether there is room for one thing alone: in a corner, or where another stood."""
    return any(isinstance(goal, At) or (isinstance(goal, Related) and goal.kind == "in_corner") for goal in goals)


def _placed(order: Order) -> bool:
    """Whether an order says where things go, besides how they stand to each other."""
    told = (order.places, order.facing, order.backs, order.direction, order.company, order.there, order.free)
    places = [w for phrase in order.things for w in phrase.places if w.word not in ("from", "of")]
    return any(told) or any(not phrase.noun.many or len(order.things) == 1 for phrase in order.things if places)


def _also(work: Work, finder: Finder, order: Order, id: str) -> list[Goal]:
    """Where things that are brought together go besides, and what they face: the largest of them leads.

    Raises:
        InputError: the order says more than that of them.
    """
    told = {"direction": order.direction, "angle": order.turn, "seat": order.seated, "company": order.company,
            "distance": order.closer or order.apart}  # fmt: skip
    if over := ", ".join(name for name, said in told.items() if said):
        raise InputError(f"'{order.text}' says how things stand to each other and a {over} too; give two orders")
    places = next((p.places for p in reversed(order.things) if p.places), order.places)
    known = [p for p in order.things if p.places is places]
    _, destination = _split(finder, order, known[0], places) if known else ([], places)
    finder.scene, finder.about = work.scene, id
    return _goals(work, finder, dataclasses.replace(order, slight=False), id, destination, 0, 1)


def resite(work: Work, finder: Finder, order: Order) -> None:
    """Find another place for things."""
    for ids, _ in _moved(work, finder, order):
        for id in ids:
            before = work.scene[id]
            goal = Elsewhere(ELSEWHERE if before.support == "floor" else ELSEWHERE_SMALL)
            planned = work.usual_ties(id) or usual_ties(work.scene, before.category)
            failed: Reaching | None = None
            for ties in (planned, ()):
                failed = _anywhere(work, id, goal, ties)
                if failed is None:
                    break
            say(work, id, before, failed, [goal])
        finder.recent = list(ids)


def _anywhere(work: Work, id: str, goal: Goal, ties: Sequence[Tie]) -> Reaching | None:
    target = work.target(id, work.scene[id].category, ties, work.asset_of(id).attributes)
    reaching = Reaching(work, target, work.asset_of(id), [goal])
    return None if reaching.run() else reaching
