"""What a prompt leaves open differs from room to room: other things besides those that everybody expects."""

from collections.abc import Iterator, Sequence
from typing import cast

import numpy as np
from msgspec.structs import replace

from thinkblox.assets import kind_of
from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import stand_in
from thinkblox.brief import Brief, Relation, RelationKind, Request
from thinkblox.fills import Fill
from thinkblox.knowledge.dressing import dressing
from thinkblox.knowledge.goods import goods_in
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, Usual, kinds_of_room, room_type
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.knowledge.variety import Option, do_alike, varieties
from thinkblox.planning.rooms import is_open
from thinkblox.planning.space import furniture_area, least_area, run_length

_BARE = 1
"""Things that a prompt names at most, of which most is left open."""
_LEAST = 4
"""Kinds of things that are assumed at least where a room is furnished for its name."""
_SKETCHED = 5
"""Who names so many kinds of things has said what the room holds."""
_TOLD = 6
"""Who names so many lacks nothing that is only usual."""
_OUT, _IN = (0, 1, 2, 3), (2, 3, 4, 5)
"""How many kinds of things are left out where all is open, and how many come in."""
_IN_SKETCHED = (1, 2, 3, 4)
"""How many kinds of things come in where some are named."""
_FOR_FLOOR = 3
"""So many more come in where what is there needs less floor than such a room has at least."""
_FINISHES = 2
"""How many kinds of things on walls and floor come in where much is named."""
_CLOSE = 1.3
"""By how much more floor than there is what a room needs may take by the handbook."""
_RUN = 0.85
"""Share of a wall that a run takes at most, of which the door and the corners take some too."""
_FIRST = 3
"""The first of so many parts of what a room usually holds is what it is for."""
_FEWER = 0.4
"""How often there is one less of what there may be."""
_DRAWN_UP = ("at", "around")
"""Relations of seats without which nobody sits at a table."""
_ALONE = ("above", "under", "at_foot_of", "in_front_of", "opposite", "in_centre")
"""Relations whose space is taken by whatever came first."""
_PLACES = frozenset({"wall", "long_wall", "short_wall", "corner", "centre", "window", "door"})
_SALT = 2_000_003


def varied(brief: Brief, seed: int, fill: Fill = "essentials") -> Brief:
    """The brief with some of what it assumes left out, and with some more, as rooms of its type differ.

    What a prompt names stays, with what that needs, and what every such room has. Who says how things stand to each
    other gets these, and something on the walls and the floor besides; who names many gets only the latter, and who
    wants nothing else gets that.
    The same seed gives the same.

    Args:
        brief: what is asked for, with what that takes for granted.
        seed: of the choices.
        fill: what the room is filled with; shelves of a lived-in one are left for the books that will be put there.
    """
    bare = _is_bare(brief)
    rng = np.random.default_rng((seed, _SALT))
    if brief.empty or not brief.requests:
        return brief
    if not (bare or _is_sketched(brief)):
        return brief if fill == "named" else _finished(_complete(brief, rng, fill, always=_is_told(brief)), rng, fill)
    gone: set[str] = set()
    if bare:
        brief, gone = _lessened(brief, rng)
        brief = _fewer(brief, rng)
    brief = _complete(brief, rng, fill)
    if _is_sparse(brief):
        return brief
    options = [option for option in _options(brief) if is_open(brief) or not _is_laid(option)]
    return _with_some(brief, options, int(rng.choice(_IN if bare else _IN_SKETCHED)), gone, rng, fill)


def _finished(brief: Brief, rng: np.random.Generator, fill: Fill) -> Brief:
    """The brief with something on the walls and the floor, and with more where few things leave much of it bare."""
    named = any(request.asked for request in brief.requests)
    if not named or _is_sparse(brief) or varieties().of(brief.room_type) is None:
        return brief
    options = [option for option in _options(brief) if not _is_laid(option)]
    finishes = [option for option in options if all(_is_finish(usual.category) for usual in option)]
    brief = _with_some(brief, finishes, _FINISHES, (), rng, fill)
    others = [option for option in options if option not in finishes and is_open(brief) and not _is_told(brief)]
    return _with_some(brief, others, 0, (), rng, fill)


def _is_finish(category: str) -> bool:
    """Whether it lies on the floor or hangs on a wall."""
    kind = kind_of(category)
    return kind.flat or kind.mount == "wall"


def _with_some(
    brief: Brief,
    options: Sequence[Option],
    count: int,
    gone: Sequence[str] | set[str],
    rng: np.random.Generator,
    fill: Fill,
) -> Brief:
    """The brief with `count` of the options, as far as there is a place for them, and more where much floor is bare."""
    come, most = 0, count + _FOR_FLOOR
    for at in map(int, rng.permutation(len(options))):
        taken = furniture_area(brief)
        if come >= (most if taken < least_area(brief) else count):
            break
        wanted = _wanted(brief, options[at], gone)
        more = _with(brief, wanted, fill)
        stands = come < count or furniture_area(more) > taken
        if wanted and stands and _has_room(brief, more):
            brief, come = more, come + 1
    return brief


def _complete(brief: Brief, rng: np.random.Generator, fill: Fill, *, always: bool = False) -> Brief:
    """The brief with what a room of its type has in one form or another, or only what it `always` has."""
    choices = varieties().of(brief.room_type)
    for need in choices.needs if choices is not None else ():
        there = {request.category for request in brief.requests}
        taken = {request.category for request in brief.requests if _is_taken_up(brief, request)}
        if (always and not need.always) or not need.arises(there) or any(map(need.is_met_by, there - taken)):
            continue
        if _is_sparse(brief) and all(_is_finish(option[0].category) for option in need.options):
            continue
        unlike = (*need.despite.split(", "), *taken)
        found = [_wanted(brief, option, (), unlike) for option in need.options]
        forms = [_with(brief, option, fill) for option in found if option]
        forms = [form for form in forms if _has_room(brief, form, _CLOSE)]
        brief = forms[int(rng.integers(len(forms)))] if forms else brief
    return brief


def _is_taken_up(brief: Brief, request: Request) -> bool:
    """Whether it is assumed for what is built into it, which leaves nothing of its top."""
    on = (r for r in brief.relations if r.kind == "on" and request.key in r.anchors)
    built_in = (load_habits().is_in(brief.request(r.subject).category, "built_in") for r in on)
    return not request.asked and request.count == 1 and any(built_in)


def _is_bare(brief: Brief) -> bool:
    """Whether little but the room is named, and it is furnished for its name."""
    assumed = sum(not request.asked for request in brief.requests)
    return len(brief.requests) - assumed <= _BARE and assumed >= _LEAST


def _is_sketched(brief: Brief) -> bool:
    """Whether a few things are named, and not how what such a room is for stands to others."""
    asked = [request for request in brief.requests if request.asked]
    few = len({request.category for request in asked}) < _SKETCHED
    if brief.room_type in ("", UNKNOWN_ROOM) or not asked or not few:
        return False
    keys = {request.key for request in asked}
    arranged = any(r.asked and r.kind not in _DRAWN_UP and not keys.isdisjoint(r.anchors) for r in brief.relations)
    core = room_type(brief.room_type).core
    return not (arranged and any(are_alike(name, request.category) for name in core for request in asked))


def _is_told(brief: Brief) -> bool:
    """Whether so many kinds of things are named that what is not is not wanted."""
    return len({request.category for request in brief.requests if request.asked}) >= _TOLD


def _is_sparse(brief: Brief) -> bool:
    return not set(varieties().sparse.split(", ")).isdisjoint(brief.style)


def _lessened(brief: Brief, rng: np.random.Generator) -> tuple[Brief, set[str]]:
    """The brief with some of what it assumes left out, and the keys of that."""
    loose = [request for request in brief.requests if _is_loose(brief, request)]
    count = min(int(rng.choice(_OUT)), len(loose))
    gone = {loose[int(at)].key for at in rng.permutation(len(loose))[:count]}
    requests = tuple(r for r in brief.requests if r.key not in gone)
    relations = tuple(r for r in brief.relations if r.subject not in gone)
    return replace(brief, requests=requests, relations=relations), gone


def _is_loose(brief: Brief, request: Request) -> bool:
    """Whether such rooms usually have it, but need not, nothing else stands to it, and nobody sits on it at a table."""
    needed = any(request.key in relation.anchors for relation in brief.relations)
    shows = [r.key for r in brief.requests if r.category in varieties().shows.split(", ")]
    needed |= any(r.kind == "on" and r.subject == request.key and r.anchors[0] in shows for r in brief.relations)
    needed |= any(r.kind in _DRAWN_UP and r.subject == request.key for r in brief.relations)
    usual = room_type(brief.room_type).usual
    first = usual[: max(1, len(usual) // _FIRST)]
    essential = _is_essential(brief, request) or any(are_alike(u.category, request.category) for u in first)
    common = any(u.category == request.category for u in usual)
    return common and not (request.asked or needed or essential)


def _is_essential(brief: Brief, request: Request) -> bool:
    """Whether every such room has it, or such a shop is called by it."""
    if request.category == goods_in([word.text for word in brief.account]):
        return True
    return any(are_alike(usual.category, request.category) for usual in room_type(brief.room_type).expected)


def _fewer(brief: Brief, rng: np.random.Generator) -> Brief:
    """The brief with one less of some things of which it assumes several, and of what each of them has."""
    known = varieties().fewer.split(", ")
    for request in brief.requests:
        open_ = not request.asked and request.count > 1 and request.category in known
        if open_ and not _is_essential(brief, request) and rng.random() < _FEWER:
            brief = _lowered(brief, request)
    return brief


def _lowered(brief: Brief, request: Request) -> Brief:
    """The brief with one less of a thing; unchanged where not all that belongs to it is assumed and one for each."""
    before = request.count
    ties = [r for r in brief.relations if request.key in r.anchors]
    subjects = [brief.request(r.subject) for r in ties]
    shared = all(r.each and not s.asked and s.count % before == 0 for r, s in zip(ties, subjects, strict=True))
    if not shared:
        return brief
    counts = {s.key: s.count // before * (before - 1) for s in subjects} | {request.key: before - 1}
    requests = tuple(replace(r, count=counts.get(r.key, r.count)) for r in brief.requests)
    return replace(brief, requests=requests)


def _options(brief: Brief) -> Iterator[Option]:
    """What such a room may hold besides: what is said of its type; else what it usually holds, or lived in."""
    choices = varieties().of(brief.room_type)
    if choices is not None:
        yield from choices.options
        return
    for usual in room_type(brief.room_type).usual:
        yield (usual,)
    if not kinds_of_room(brief.room_type).isdisjoint(dressing().rooms):
        for usual in dressing().furniture(brief.room_type):
            count = min(usual.count, 2) if kind_of(usual.category).mount == "wall" else 1
            yield (Usual(count, usual.category, usual.relations),)


def _is_laid(option: Option) -> bool:
    """Whether it lies on what would have to grow for it."""
    return any(kind == "on" for kind, _, _ in option[0].relations)


def _wanted(brief: Brief, option: Option, gone: Sequence[str] | set[str], unlike: Sequence[str] = ()) -> Option:
    """As much of an option as the room lacks; nothing where it has that, or where what it belongs to is absent.

    What is `unlike` does not do instead.
    """
    there = [request.category for request in brief.requests if request.category not in unlike]
    first = option[0].category
    if any(counts_as(first, name) or _does_for(name, first) for name in (*there, *gone)):
        return ()
    asked = [name for request in brief.requests if request.asked for name in (request.category, _called(request))]
    wanted: list[Usual] = []
    for usual in option:
        drawn_up = any(kind in _DRAWN_UP for kind, _, _ in usual.relations)
        if usual.category in there and not drawn_up:
            continue
        named = usual.category in asked or any(_is_named(usual.category, name) for name in asked)
        unwanted = any(counts_as(usual.category, name) or are_alike(usual.category, name) for name in brief.excluded)
        found = [(kind, _anchor(brief, anchors, wanted)) for kind, anchors, _ in usual.relations]
        if named or unwanted or not all(anchor for _, anchor in found) or _is_taken(brief, usual, found):
            return ()
        if any(kind == "at_foot_of" and _count(brief, anchor) > 1 for kind, anchor in found):
            return ()
        wanted.append(usual)
    return tuple(wanted)


def _count(brief: Brief, key: str) -> int:
    """How many of a request there are; one of a place."""
    return next((request.count for request in brief.requests if request.key == key), 1)


def _stands_in_line(request: Request) -> bool:
    """Whether it is several beds, which stand side by side: what is beside them is between any two."""
    return request.count > 1 and load_habits().is_in(request.category, "in_line", "beds")


def _called(request: Request) -> str:
    """What it is called in one word, though it is made as one of several kinds: who counts tables counts low ones."""
    words = request.phrase.lower().split()
    named = " ".join([*words[:-1], *map(singular, words[-1:])])
    return "" if not words or request.category.replace("_", " ") in named else singular(words[-1])


def _is_named(category: str, name: str) -> bool:
    """Whether who names a <name> has said what there is of such things: a mop bucket is a bucket, a poster a picture.

    One kind of chairs to lean back in is enough, and one kind of rugs.
    """
    if category.endswith(f"_{name}") or varieties().stands_for(category, name):
        return True
    habits = load_habits()
    if habits.is_in(category, "covers") and habits.is_in(name, "covers"):
        return True
    return habits.is_in(category, "lounges") and are_alike(category, name)


def _does_for(name: str, wanted: str) -> bool:
    """Whether a <name> does where a <wanted> may be: a grand piano for a piano."""
    return do_alike(wanted, name) or counts_as(name, wanted) or stand_in(name).like == wanted


def _is_taken(brief: Brief, usual: Usual, found: Sequence[tuple[str, str]]) -> bool:
    """Whether something of its mount has the place that it is to have."""
    kind = kind_of(usual.category)
    taken = [
        (relation.kind, anchor)
        for relation in brief.relations
        if kind_of((subject := brief.request(relation.subject)).category).mount == kind.mount
        and kind_of(subject.category).flat == kind.flat
        for anchor in relation.anchors
    ]
    return any(relation in _ALONE and (relation, anchor) in taken for relation, anchor in found)


def _anchor(brief: Brief, anchors: str, besides: Sequence[Usual] = ()) -> str:
    """The first of "a|b" that is there: the key of a request, or a place of the room; empty where none is."""
    keys = {usual.category: usual.category for usual in besides}
    keys |= {request.category: request.key for request in reversed(brief.requests)}
    for name in anchors.split("|"):
        if name in keys:
            return keys[name]
        if name in _PLACES:
            return "" if name in brief.free else name
    return ""


def _has_room(brief: Brief, more: Brief, factor: float = 1.0) -> bool:
    """Whether a floor that is given, or is to be small, is large enough for more that stands on it.

    It is taken for `factor` times as large; what is built in one line has room along a wall.
    """
    if is_open(brief):
        return True
    if brief.width and brief.depth:
        wall = _RUN * max(brief.width, brief.depth)
        if run_length(more) > max(wall, run_length(brief)):
            return False
    taken = furniture_area(brief)
    area = brief.area or (brief.width or 0.0) * (brief.depth or 0.0) or taken
    return furniture_area(more) <= max(factor * area, taken)


def _with(brief: Brief, option: Option, fill: Fill) -> Brief:
    """The brief with some things more."""
    for usual in option:
        taken = [request.key for request in brief.requests]
        numbered = (f"{usual.category}-{number}" for number in range(2, len(taken) + 3))
        key = next(name for name in (usual.category, *numbered) if name not in taken)
        count, relations = usual.count, []
        for kind, anchors, each in usual.relations:
            anchor = _anchor(brief, anchors)
            owner = next((request for request in brief.requests if request.key == anchor), None)
            count *= owner.count if each and owner is not None else 1
            if kind == "next_to" and owner is not None and _stands_in_line(owner):
                count = owner.count - 1
            relations.append(
                Relation(
                    kind=cast(RelationKind, kind),
                    subject=key,
                    anchors=(anchor,),
                    each=each and owner is not None and owner.count > 1,
                    asked=False,
                )
            )
        filled = fill == "essentials" and usual.category in varieties().filled.split(", ")
        request = Request(
            key=key,
            category=usual.category,
            count=count,
            asked=False,
            attributes=("filled",) if filled else (),
        )
        brief = replace(brief, requests=(*brief.requests, request), relations=(*brief.relations, *relations))
    return brief
