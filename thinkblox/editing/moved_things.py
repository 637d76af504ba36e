"""Which things an order moves, and which of its places say where they go rather than which they are."""

import dataclasses
import re
from collections.abc import Iterator, Sequence

from thinkblox.editing.finding import Finder, Picks, nearest_to
from thinkblox.editing.grammar import means
from thinkblox.editing.orders import HERE, NounPhrase, Order
from thinkblox.editing.telling import anchored, by_distance, named, spare
from thinkblox.editing.wheres import SIDED, bound, slots_of
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.placement import Placement

_CLOSER_TOGETHER = re.compile(r"\b(?:closer|nearer) (?:in )?together\b", re.IGNORECASE)
"""Behind things with a place, which says which they are then: "the tables by the window closer together"."""
_RESTS = ("on", "from", "in", "inside", "on_top")


def _is_told(order: Order) -> bool:
    """Whether an order says how far or which way things go, or what they are to face."""
    return bool(order.closer or order.apart or order.direction or order.facing or order.backs or order.seated)


def check_says_where(order: Order, places: Sequence[Where]) -> None:
    """Refuse an order to move things that does not say where to.

    Raises:
        InputError: it says no place, two ways at once, or a length of nothing.
    """
    told = (order.closer, order.apart, order.direction, order.facing, order.backs, order.seated, order.mutual)
    if not (places or any(told) or order.there or order.free or order.level):
        raise InputError(f"'{order.text}' does not say where to; say a place, such as 'next to the bed'")
    if order.lengths and not (order.closer or order.direction or order.seated == "out" or order.scatter):
        said = ", ".join(f"{metres:.4g} m" for metres, _ in order.lengths)
        raise InputError(
            f"'{order.text}': it is not clear what {said} is; say 'to the left', 'from the wall' and so on"
        )
    if order.direction and order.closer:
        raise InputError(f"'{order.text}' says two ways at once; give two orders")


def moved_things(work: Work, finder: Finder, order: Order) -> Iterator[tuple[tuple[str, ...], list[Where]]]:
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
        qualifiers, destination = split_places(finder, order, phrase, places)
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
    return work.touched(spare(finder, resting, order.spared)), anchored(finder, destination)


def split_places(
    finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]
) -> tuple[list[Where], list[Where]]:
    """Where the thing is said to be now, and where it is to go."""
    here = [w for w in places if w.word in ("from", "of") or w.text.startswith(HERE)]
    rest = [w for w in places if w not in here]
    if phrase.places is not places and not phrase.places:
        return here, rest
    if order.together and phrase.noun.definite and _CLOSER_TOGETHER.search(order.text):
        return list(places), []
    if order.doing == "resite":
        return [*here, *(w for w in rest if not w.negated)], [w for w in rest if w.negated]
    told = [w for w in rest if not w.negated and by_distance(w)]
    more = len(told) < len(rest) or order.mutual or order.together or _is_told(order)
    if told and phrase.noun.definite and more:
        here, rest = [*here, *told], [w for w in rest if w not in told]
    apart = order.scatter and order.doing == "move"
    directed = next((n for n, w in enumerate(rest) if w.text.lower() in ("to", "into", "onto", "over to")), None)
    if order.closer or order.direction or order.seated or apart:
        at = len(rest) if directed is None or not order.closer else directed
        return [*here, *rest[:at]], rest[at:]
    if directed is not None and directed > 0:
        return [*here, *rest[:directed]], rest[directed:]
    wanted = [w for w in rest if not w.negated]
    if len(wanted) > 1 and directed is None and phrase.noun.kind == "thing":
        known = bool(phrase.id or phrase.noun.id or phrase.noun.ordinal)
        several = len(finder.matching(phrase.noun)) > 1 and not phrase.noun.many and not here and not known
        several |= _are_at_sides(phrase, wanted)
        several |= all(w.word == "on" and w.noun is not None and w.noun.kind == "thing" for w in wanted[:2])
        if several or (wanted[0].word in ("next_to", "on", "in", "by", "at") and wanted[1].word in ("to", "next_to")):
            return [*here, *rest[:1]] if several else here, rest[1:] if several else rest
    return here, rest


def _are_at_sides(phrase: NounPhrase, places: Sequence[Where]) -> bool:
    """Whether several are told by the sides of a thing that they are at: "the chairs at the ends against the wall"."""
    (part, goal) = (where.noun for where in places[:2])
    sided = part is not None and part.kind == "part" and part.value in SIDED
    return sided and phrase.noun.definite and phrase.noun.many and goal is not None and goal.kind != "part"


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
    """Whether a place depends on what is moved: "to the other side", "the nearest wall", "the back corners"."""
    noun = where.noun
    seen = noun is not None and (noun.det == "other" or noun.each or bool(means("nearest", noun.degree)))
    seen |= noun is not None and noun.kind == "place" and noun.plural
    return seen or (noun is not None and noun.kind == "place" and "opposite" in noun.text.lower().split())
