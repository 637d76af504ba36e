"""What a prompt leaves open may differ from room to room: other things besides those that everybody expects."""

from collections.abc import Iterator
from typing import cast

import numpy as np
from msgspec.structs import replace

from thinkblox.assets import kind_of
from thinkblox.brief import Brief, Relation, RelationKind, Request
from thinkblox.knowledge.dressing import dressing
from thinkblox.knowledge.rooms import Usual, room_type
from thinkblox.knowledge.things import are_alike, counts_as

_BARE = 1
"""Things that a prompt names at most, of which most is left open."""
_LEAST = 4
"""Kinds of things that are assumed at least where a room is furnished for its name."""
_OUT, _IN = (0, 1, 2), (1, 2, 3)
"""How many kinds of things are left out, and how many come in."""
_DRAWN_UP = ("at", "around")
"""Relations of seats without which nobody sits at a table."""
_PLACES = frozenset({"wall", "corner", "centre", "window", "door"})
_SALT = 2_000_003


def varied(brief: Brief, seed: int) -> Brief:
    """The brief with some of what it assumes for a mere name of a room left out, and with some more.

    What a prompt names stays, with what that needs, and what every such room has; so does a brief that assumes little.
    The same seed gives the same.
    """
    assumed = [request for request in brief.requests if not request.asked]
    if brief.empty or len(brief.requests) - len(assumed) > _BARE or len(assumed) < _LEAST:
        return brief
    rng = np.random.default_rng((seed, _SALT))
    loose = [request for request in assumed if _is_loose(brief, request)]
    count = min(int(rng.choice(_OUT)), len(loose))
    gone = {loose[int(at)].key for at in rng.permutation(len(loose))[:count]}
    brief = replace(
        brief,
        requests=tuple(r for r in brief.requests if r.key not in gone),
        relations=tuple(r for r in brief.relations if r.subject not in gone),
    )
    more = list(_more(brief, gone))
    for at in sorted(map(int, rng.permutation(len(more))[: int(rng.choice(_IN))])):
        brief = _with(brief, more[at])
    return brief


def _is_loose(brief: Brief, request: Request) -> bool:
    """Whether nothing else stands to it, nobody sits on it at a table, and no such room must have it."""
    needed = any(request.key in relation.anchors for relation in brief.relations)
    needed |= any(r.kind in _DRAWN_UP and r.subject == request.key for r in brief.relations)
    essential = any(are_alike(usual.category, request.category) for usual in room_type(brief.room_type).expected)
    first = room_type(brief.room_type).usual[0].category
    return not needed and not essential and not are_alike(first, request.category)


def _more(brief: Brief, gone: set[str]) -> Iterator[Usual]:
    """What else such a room may hold that it does not yet, and that stands by itself or by what is there."""
    there = {request.category for request in brief.requests}
    for usual in dressing().furniture(brief.room_type):
        known = any(are_alike(usual.category, name) or counts_as(usual.category, name) for name in (*there, *gone))
        unwanted = any(counts_as(usual.category, name) or are_alike(usual.category, name) for name in brief.excluded)
        if not known and not unwanted and all(_anchor(brief, anchors) for _, anchors, _ in usual.relations):
            yield usual


def _anchor(brief: Brief, anchors: str) -> str:
    """The first of "a|b" that is there: the key of a request, or a place of the room; empty where none is."""
    keys = {request.category: request.key for request in brief.requests}
    return next((keys.get(name, name) for name in anchors.split("|") if name in keys or name in _PLACES), "")


def _with(brief: Brief, usual: Usual) -> Brief:
    """The brief with one kind of thing more."""
    count = min(usual.count, 2) if kind_of(usual.category).mount == "wall" else 1
    request = Request(key=usual.category, category=usual.category, count=count, asked=False)
    relations = tuple(
        Relation(kind=cast(RelationKind, kind), subject=request.key, anchors=(_anchor(brief, anchors),), asked=False)
        for kind, anchors, _ in usual.relations
    )
    return replace(brief, requests=(*brief.requests, request), relations=(*brief.relations, *relations))
