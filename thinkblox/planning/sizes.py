"""How large the objects of a plan are to be: as the prompt says, and counters as long as who sits at them needs."""

from collections.abc import Sequence
from math import ceil

import numpy as np

from thinkblox.assets import kind_of
from thinkblox.assets.category import Category
from thinkblox.assets.make import make_thing
from thinkblox.assets.sizing import size_for, sizes_of
from thinkblox.brief import Measures, Request
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.stacks import load_stacks
from thinkblox.planning.loads import (
    height_over,
    in_it,
    on_it,
    size_of_unknown,
    size_under,
    sizes_given,
    top_for_loads,
    usual_size,
    width_of,
    words_of,
)
from thinkblox.planning.members import Member, Members
from thinkblox.planning.seat_heights import seat_height
from thinkblox.scene.asset import Surface
from thinkblox.value import Vec2, Vec3

_PLACE = 0.6
"""Width of a place at a counter [m]."""
_AXES = ("depth", "width", "height")
_WIDER = 2.0
"""How much wider than usual a basket, crate or bowl is made at most: more lies on what is in it."""
_LONGER = (1.0, 1.2, 1.4, 1.6)
"""How much longer than usual shelves or a cabinet are made for what they hold, tried in turn."""
_SMALLER, _CLOSE, _EXACT = 0.8, 0.004, 1e-6
"""How small things may be on shelves, as a share of their usual size, and what is left between them [m]."""
_APART, _PACKED = 0.02, 1.3
"""Left about a thing in a basket [m], and how much wider than their areas together several are packed."""
_WORKTOP = 0.2
"""Worktop on either side of what is let into it [m]."""
FULL_HEIGHT = "full-height"
"""What reaches from the floor to the ceiling."""
_BELOW_CEILING = 0.04
"""Left between that and the ceiling [m]."""
OPEN: Measures = (None, None, None)


def size_of(member: Member, members: Members, room_height: float) -> Measures:
    """What the asset of an object must measure in a room of that height [m]."""
    needed, (_, drawn) = _needed(member, members, room_height), sizes_given(member, members)
    unknown = size_of_unknown(member, members) or OPEN
    x, y, z = (need or own or small for need, own, small in zip(needed, drawn, unknown, strict=True))
    return (x, y, z)


def _needed(member: Member, members: Members, room_height: float) -> Measures:
    """What it must measure for what is said of it, and for what is on, in, under and at it [m]."""
    kind = kind_of(member.category)
    asked, _ = sizes_given(member, members)
    sizes = sizes_of(kind, words_of(member, members))
    depth, width, height = (s if _lies_in(s, sizes, axis) else None for axis, s in enumerate(asked))
    if height is None and FULL_HEIGHT in member.request.attributes and _fits(room_height - _BELOW_CEILING, kind, 2):
        height = round(room_height - _BELOW_CEILING, 3)
    if depth is None and width is None:
        if across := _for_contents(member, members, kind):
            return (*across, height)
        if height is None and (smaller := size_under(member, members)):
            return smaller
        depth, width = (
            _for_built_in(member, members, kind)
            or top_for_loads(member, members)
            or _for_boards(member, members, kind)
            or (None, None)
        )
    seats = None if any(member.request.size[:2]) else _for_seats(member, members, kind)
    return (
        depth,
        max(filter(None, (width, seats)), default=None),
        height or height_over(member, members) or seat_height(member, members),
    )


def size_note(request: Request) -> str:
    """The sentence on a size that the prompt asks for and that cannot be made; empty when there is none."""
    kind = kind_of(request.category)
    least, most = kind.size_range
    wrong = [
        f"its {name} can be {least[axis]:g} to {most[axis]:g} m, not {size:g} m"
        for axis, (name, size) in enumerate(zip(_AXES, request.size, strict=True))
        if size is not None and not _fits(size, kind, axis)
    ]
    return f"{request.phrase or kind.noun}: {' and '.join(wrong)}" if wrong else ""


def _fits(size: float | None, kind: Category, axis: int) -> bool:
    return _lies_in(size, kind.size_range, axis)


def _lies_in(size: float | None, sizes: tuple[Vec3, Vec3], axis: int) -> bool:
    return size is not None and sizes[0][axis] <= size <= sizes[1][axis]


def _for_contents(member: Member, members: Members, kind: Category) -> tuple[float, float] | None:
    """Depth and width of a basket, crate, bowl or bin in which all that it holds has room side by side."""
    inside = in_it(member, members)
    if not inside:
        return None
    words, usual = words_of(member, members), usual_size(member, members)
    inner = [s for s in make_thing(kind.name, seed=0, attributes=words).surfaces if s.inner]
    bottoms = [s for s in inner if s.headroom is None]
    if not bottoms:
        held = [usual_size(m, members) for m in inside]
        return _for_shelves(inner, held, usual, kind) if kind.large else _for_tiers(inner, held, usual, kind)
    side = min(bottoms[0].size)
    across = [width_of(held, members) for held in _beside_each_other(inside, members, side, usual[2])]
    needed = across[0] + _APART if len(across) == 1 else _PACKED * sum(d * d for d in across) ** 0.5
    bottom = min(bottoms[0].size) if bottoms[0].round or len(across) == 1 else float(np.prod(bottoms[0].size)) ** 0.5
    most = kind.size_range[1]
    share = min(needed / bottom, _WIDER, *(high / u for high, u in zip(most[:2], usual[:2], strict=True)))
    return (round(share * usual[0], 3), round(share * usual[1], 3)) if share > 1.0 else None


def _beside_each_other(held: Sequence[Member], members: Members, side: float, height: float) -> list[Member]:
    """What lies on the bottom of a holder: of wide things that lie on each other there, as few as reach its height."""
    found: list[Member] = []
    for kind in dict.fromkeys(member.category for member in held):
        alike = [member for member in held if member.category == kind]
        piled = load_stacks().is_piled(kind) and width_of(alike[0], members) > side / 2
        high = max(1, int(height / usual_size(alike[0], members)[2])) if piled else 1
        found += alike[: ceil(len(alike) / high)]
    return found


def _for_built_in(member: Member, members: Members, kind: Category) -> tuple[None, float] | None:
    """Width of a counter that nobody asked for and that is there for what is let into it alone."""
    loads = on_it(member, members)
    if member.request.asked or kind.is_in("built_in_line") or not all(_is_let_in(m) for m in loads) or not loads:
        return None
    return (None, round(sum(usual_size(m, members)[1] + 2 * _WORKTOP for m in loads), 3))


def _is_let_in(member: Member) -> bool:
    return load_habits().is_in(member.category, "built_in")


def _for_boards(member: Member, members: Members, kind: Category) -> Vec2 | None:
    """Depth and width of what carries on boards alone, one over another, all that is on it."""
    loads = on_it(member, members)
    if not loads or kind.large or kind.is_in("shelves", "surfaces"):
        return None
    usual = usual_size(member, members)
    boards = make_thing(kind.name, seed=0, attributes=words_of(member, members)).surfaces
    if not boards or any(s.within or s.headroom is None for s in boards):
        return None
    return _for_tiers(boards, [usual_size(load, members) for load in loads], usual, kind)


def _for_tiers(tiers: Sequence[Surface], held: Sequence[Vec3], usual: Vec3, kind: Category) -> Vec2 | None:
    """Depth and width of a rack or case with boards on which all that it holds has room side by side."""
    high = [t for t in tiers if t.headroom is not None and t.headroom > max(size[2] for size in held)]
    if not high:
        return None
    area = sum(t.size[0] * t.size[1] for t in high)
    needed = _PACKED * sum((x + _APART) * (y + _APART) for x, y, _ in held) / area
    share = min(needed, _WIDER, kind.size_range[1][1] / usual[1])
    return (usual[0], round(share * usual[1], 3)) if share > 1.0 else None


def _for_shelves(tiers: Sequence[Surface], held: Sequence[Vec3], usual: Vec3, kind: Category) -> Vec2 | None:
    """Depth and width of shelves or a cabinet that are longer than usual, as all that they hold has no room else."""
    taken = {s: sum(1.0 / max(1, _room_on(tiers, s, size)) for size in held) for s in _LONGER}
    share = min(_LONGER, key=lambda s: (max(1.0, taken[s]), s))
    share = min(share, kind.size_range[1][1] / usual[1])
    return (usual[0], round(share * usual[1], 3)) if share > 1.0 else None


def _room_on(tiers: Sequence[Surface], longer: float, size: Vec3) -> int:
    """How many things of a size, made smaller if need be, have room on boards that are so much longer."""
    count = 0
    for tier in tiers:
        depth, width = tier.size[0], longer * tier.size[1]
        share = min(_SMALLER, depth / min(size[:2]), (tier.headroom or size[2]) / size[2])
        x, y = share * size[0] + _CLOSE, share * size[1] + _CLOSE
        count += max(
            int((depth + _CLOSE) / a + _EXACT) * int((width + _CLOSE) / b + _EXACT) for a, b in ((x, y), (y, x))
        )
    return count


def _for_seats(member: Member, members: Members, kind: Category) -> float | None:
    """Width of a counter or table that is longer than usual because several sit at it."""
    ties = [
        tie.kind
        for m in members.all
        if load_habits().is_in(m.category, "seating")
        for tie in m.ties
        if member.id in tie.anchors
    ]
    words = frozenset(member.request.attributes)
    return width_for_seats(
        kind, words, before=ties.count("at") + ties.count("in_front_of"), along=ties.count("at_long_side")
    )


def width_for_seats(kind: Category, words: frozenset[str], *, before: int, along: int) -> float | None:
    """Width [m] that something needs to seat so many, where that is more than usual.

    Args:
        kind: what they sit at.
        words: what is said of it.
        before: how many sit in one line before it, as at a counter.
        along: how many share its two long sides.
    """
    counter = load_habits().is_in(kind.name, "counters")
    places = max(before if counter else 0, (along + 1) // 2)
    if places < 2:
        return None
    depth, usual, _ = size_for(kind, words, np.random.default_rng(0))
    needed = round(min(_PLACE * places + 0.1, kind.size_range[1][1]), 3)
    return needed if needed > usual >= depth else None
