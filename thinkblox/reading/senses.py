"""Chooses what a general word means from its company: a "lamp" on a nightstand is a table lamp."""

from collections.abc import Collection

from msgspec import structs

from thinkblox.assets import GENERAL_WORDS
from thinkblox.assets.stand_ins import stand_in
from thinkblox.brief import Brief
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, kinds_of_room, room_type
from thinkblox.knowledge.senses import senses_of
from thinkblox.reading.draft import Bond, Draft, Mention

_ROUNDS = 2
_FEW = 4
"""So many at most are few."""


def choose_senses(draft: Draft, expected: Collection[str] = ()) -> None:
    """Give every thing a category. Twice over, as the sense of one word can hang on that of another.

    Args:
        draft: what was read.
        expected: categories that will be in its company, though the prompt does not name them.
    """
    for _ in range(_ROUNDS):
        company = {thing.noun for thing in draft.things} | set(expected)
        bonds: dict[int, list[Bond]] = {}
        for bond in (b for b in draft.bonds if not b.negated):
            for thing in {bond.subject, *(a for a in bond.anchors if isinstance(a, Mention))}:
                bonds.setdefault(id(thing), []).append(bond)
        final = [_sense(thing, draft.room, company, bonds.get(id(thing), [])) for thing in draft.things]
        for thing, noun in zip(draft.things, final, strict=True):
            thing.noun = noun


def with_senses(brief: Brief) -> Brief:
    """A brief of anybody's with a category in place of every general word."""
    mentions = {
        r.key: Mention(r.category, r.count, attributes=list(r.attributes), asked=r.asked) for r in brief.requests
    }
    bonds = [
        Bond(r.kind, mentions[r.subject], tuple(mentions.get(a, a) for a in r.anchors), r.each, r.asked)
        for r in brief.relations
        if not r.negated
    ]
    choose_senses(Draft(things=list(mentions.values()), bonds=bonds, room=brief.room_type))
    general = (r.category in GENERAL_WORDS for r in brief.requests)
    found = (
        structs.replace(r, category=mentions[r.key].noun) if is_general else r
        for r, is_general in zip(brief.requests, general, strict=True)
    )
    return structs.replace(brief, requests=tuple(found))


def _sense(thing: Mention, room: str, company: set[str], bonds: list[Bond]) -> str:
    hung = any(b.anchors == ("ceiling",) for b in bonds if b.subject is thing)
    facts = {
        "attr": {*thing.attributes, *(["hanging"] if hung else [])},
        "state": {state.replace(" ", "-") for state in thing.states},
        "room": set(kinds_of_room(room)),
        "usual": {usual.category for usual in room_type(room).usual},
        "rel": {name for b in bonds if b.subject is thing for name in _relations(b)},
        "to": {a.noun if isinstance(a, Mention) else a for b in bonds if b.subject is thing for a in b.anchors},
        "from": {b.subject.noun for b in bonds if b.subject is not thing},
        "behind_it": {b.subject.noun for b in bonds if b.subject is not thing and b.kind == "behind"},
        "before_it": {b.subject.noun for b in bonds if b.subject is not thing and b.kind == "in_front_of"},
        "has_to_it": {name for b in bonds if b.subject is not thing for name in _relations(b)},
        "has": company,
    }
    for category, conditions in senses_of(thing.noun):
        if all(_holds(condition, facts, thing) for condition in conditions):
            return category
    return _usual_there(thing.noun, room)


def _usual_there(noun: str, room: str) -> str:
    """What "machines" are in a laundromat: what is usual in such a room whose name ends so; else the noun itself."""
    if noun in load_habits().known() or noun in GENERAL_WORDS:
        return noun
    usual = next((u.category for u in room_type(room).usual if u.category.endswith(f"_{noun}")), noun)
    return noun if stand_in(noun).like == usual else usual


def _relations(bond: Bond) -> tuple[str, ...]:
    """The relations by which a sense is known; what hangs on a wall is against it too."""
    on_wall = (
        bond.kind == "on" and bond.anchors and isinstance(bond.anchors[0], str) and bond.anchors[0].endswith("wall")
    )
    if bond.kind == "between" and bond.each:
        return ("between", "between_neighbours")
    return ("on_wall", "against_wall") if on_wall else (str(bond.kind),)


def _holds(condition: str, facts: dict[str, set[str]], thing: Mention) -> bool:
    match condition:
        case "many":
            return thing.many
        case "few":
            return (thing.count or 1) <= _FEW
        case "seated":
            return thing.seats > 0
    name, _, values = condition.partition(":")
    if name == "unusual":
        return bool(facts["room"] - {UNKNOWN_ROOM}) and facts["usual"].isdisjoint(values.split("|"))
    if name == "without":
        return facts["has"].isdisjoint(values.split("|"))
    return not facts[name].isdisjoint(values.split("|"))
