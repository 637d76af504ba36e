"""Ideas on top of something: where a hand would put it, beside what stands there already."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from thinkblox.assets import facts_of
from thinkblox.knowledge.stacks import load_stacks
from thinkblox.phrases import Constraint
from thinkblox.plan import Target, Tie, carries
from thinkblox.policies.expert import partners
from thinkblox.policies.expert.ground import TOUCH
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.judge import boxes, depth_in_others
from thinkblox.policies.expert.place_settings import axis_of_seat, by_seats
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.sizing import SHRINK, scaled, shares_of
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.saying import turned
from thinkblox.value import Vec2, Vec3

EDGE = 0.03
"""Kept free at the edge of a surface where there is room [m]."""
OVERHANG = 0.02
"""Half of how far a thing may reach over the front edge [m]: feet stand inside its outline."""
SLIGHTLY_OVER = 0.006
"""How far things reach over an edge of a surface on which not all that are to be there would have room else [m]."""
EXACT = 1e-6
BETWEEN = 0.06
"""Left on either side of what comes between two [m]."""
APART = 0.02
"""Left between things side by side [m]."""
CROWDED, CROWDED_BY_ONES = 0.3, 0.5
"""Share of a top that things take together, from which each kind of them keeps to its own stretch; one of a kind."""
BESIDE_OTHERS = 0.5
"""Cost of standing right beside what is on a shelf."""
CLOSE = 0.004
"""Left between things in a ring, and to the wall around what is in a hollow [m]."""
TIGHT = 2.0
"""Cost of lying so that not all of its kind have room."""
LONG = 1.8
"""Times its width from which a thing is long."""
OFF = 30.0
"""Cost of reaching over the edge of a round surface."""
ALIKE = 0.01
"""Lengths that differ by less are the same [m]."""
LOWER = 3.0
"""Cost of a shelf of what has a top, for what is to be on it; and of the top of shelves, for what nobody asked for."""
FLAT = 0.5
"""Share of its shorter side that a thing is high at most, of which others like it lie on it."""
AT_HAND = 1.1
"""Height at which things on shelves are seen and taken best [m]: the shelves are filled from there."""
REACHED = 1.6
"""A top of shelves that is higher takes what is asked for only where no board has room, and nothing else [m]."""
HEADROOM = 0.02
"""Air left under the next shelf [m]."""
SIDES_OF_TOP: dict[str, Vec2] = {
    "left_of": (0.0, 1.0), "right_of": (0.0, -1.0), "in_front_of": (1.0, 0.0), "behind": (-1.0, 0.0),
}  # fmt: skip
"""Where on a top what is at a side of it lies, as a share of how far it can."""
STEPS = 5
"""How often a place further in is tried there."""


def on_surfaces(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Places on each surface of the anchor, or inside it, that is large and high enough."""
    surfaces = tuple(s for s in situation.scene.asset_of(anchor).surfaces if _serves(s, tie))
    if facts_of(anchor.category).is_in("shelves"):
        surfaces = tuple(sorted(surfaces, key=lambda s: abs(anchor.position[2] + s.position[2] - AT_HAND)))
    tops = tuple(s for s in surfaces if s.headroom is None)
    if tie.kind == "inside" or not tops or _is_of_boards(anchor, surfaces):
        yield from _on_those(situation, anchor, tie, surfaces)
        return
    below = tuple(s for s in surfaces if s.headroom is not None) or _lower_boards(situation, anchor)
    if facts_of(anchor.category).is_in("beds"):
        tops, below = tops[:1], (*tops[1:], *below)
    high = not tie.asked and any(anchor.position[2] + top.position[2] > REACHED for top in tops)
    shelved = (high or not situation.target.asked) and bool(below) and facts_of(anchor.category).is_in("shelves")
    first, then = (below, tops) if shelved else (tops, below)
    yield from _on_those(situation, anchor, tie, first)
    if shelved and high and not situation.target.asked:
        return
    yield from (replace(idea, cost=idea.cost + LOWER) for idea in _on_those(situation, anchor, tie, then))


def _lower_boards(situation: Situation, anchor: Placement) -> tuple[Surface, ...]:
    """The open boards under the top of a thing, for what has no room on that."""
    asset = situation.scene.asset_of(anchor)
    return () if asset.opens else tuple(s for s in asset.surfaces if s.within and s.headroom is not None)


def _is_of_boards(anchor: Placement, surfaces: tuple[Surface, ...]) -> bool:
    """Whether it is nothing but shelves, of which the topmost is one: things are on any of them."""
    return facts_of(anchor.category).is_in("shelves") and len(_alike(surfaces)) == len(surfaces)


def _on_those(situation: Situation, anchor: Placement, tie: Tie, surfaces: tuple[Surface, ...]) -> Iterator[Idea]:
    """Places on some surfaces of the anchor, at the largest size that has room there beside what is there already."""
    shares = shares_of(situation.size, situation.observation.sizes) if _may_shrink(situation) else SHRINK[:1]
    for step, share in enumerate(shares):
        size = scaled(situation.size, share)
        if share > shares[-1] and not _room_for_all(situation, surfaces, size, tie):
            continue
        turned = _in_turn(surfaces, size, tie)
        ideas = list(_at_size(situation, anchor, tie, turned, size))
        if not ideas and situation.asset.foot is not None:
            ideas = list(_at_size(situation, anchor, tie, turned, size, foot=_foot(situation.asset.foot, share)))
        ideas = [replace(i, cost=i.cost + step, size=None if share == 1.0 else size) for i in ideas]
        yield from ideas
        if ideas and bool((depth_in_others(situation, ideas, boxes(situation, ideas)) <= TOUCH).any()):
            return


def _may_shrink(situation: Situation) -> bool:
    """Whether nobody says how large it is, and it is not made for what is to be on, in or under it."""
    target = situation.target
    if not any(target.size):
        return True
    asked = (r for r in situation.observation.plan.brief.requests if r.key == target.request and any(r.size))
    ties = (tie for later in situation.followers for tie in later.ties if target.id in tie.anchors)
    return next(asked, None) is None and not any(carries(tie) or tie.kind == "under" for tie in ties)


def on_its_like(situation: Situation, lower: Placement) -> Iterator[Idea]:
    """Right on another of its request that lies flat, as a cookie does on a cookie, where nothing lies on that."""
    flat = lower.size[2] <= FLAT * min(lower.size[:2])
    level = not situation.scene.asset_of(lower).surfaces or load_stacks().is_piled(lower.category)
    alike = lower in situation.siblings and level
    if not (flat and alike) or situation.scene.resting_on(lower.id):
        return
    x, y, _ = lower.position
    words = (
        Constraint(kind="on", anchors=(lower.id,)),
        Constraint(kind="offset", anchors=(lower.id,), values=(0.0, 0.0)),
        turned(lower.yaw),
    )
    passed = (lower.id, *situation.enclosing(lower))
    yield Idea((x, y, lower.top), lower.yaw, words, f"it lies on {lower.id}", 0.0, passed, lower.size)


def _serves(surface: Surface, tie: Tie) -> bool:
    return surface.inner if tie.kind == "inside" else not surface.within


def _room_for_all(situation: Situation, surfaces: tuple[Surface, ...], size: Vec3, tie: Tie) -> bool:
    """Whether as many of that size as the tie counts have room, side by side on all surfaces together."""
    if _looks_ahead(situation):
        return (
            sum(int(s.size[1] / (size[1] + APART)) for s in surfaces if s.size[0] + 2 * OVERHANG >= size[0])
            >= tie.count
        )
    turned = (size[1], size[0])
    disc = _is_disc(situation.asset.front, size)
    return sum(max(_fitting(s, size[:2], disc=disc), _fitting(s, turned, disc=disc)) for s in surfaces) >= tie.count


def _looks_ahead(situation: Situation) -> bool:
    """Whether it looks over the front of what carries it, as a screen does, and is seldom turned aside."""
    return situation.facts.is_in("screens")


def _fitting(surface: Surface, size: Vec2, *, tight: bool = True, disc: bool = True) -> int:
    """How many things of a size fit on a surface in lines, or on a round one in a line or a ring; see `_free_half`.

    What is no `disc` takes all about its corners in a ring.
    """
    if surface.round:
        return max(_in_disc(min(surface.size) / 2, size, disc=disc), 1)
    free = _free_half(size, surface, tight=tight)
    if free is None:
        return 0
    return (1 + int(2 * free[0] / (size[0] + CLOSE) + EXACT)) * (1 + int(2 * free[1] / (size[1] + CLOSE) + EXACT))


def _only_turned(surfaces: Sequence[Surface], plan: Vec2, tie: Tie) -> bool:
    """Whether all that the tie counts have room when turned by 90 degrees, and not as they are."""
    one, other = sum(_fitting(s, plan) for s in surfaces), sum(_fitting(s, plan[::-1]) for s in surfaces)
    return one < tie.count <= other


def _in_disc(radius: float, size: Vec2, *, disc: bool) -> int:
    """How many things of a size fit on a disc, in a line along their depth or in a ring.

    In a ring they are thought of as discs.
    """
    half = math.sqrt(max(0.0, radius**2 - (size[1] / 2) ** 2))
    in_line = int(2 * half / (size[0] + APART))
    own = _round_own(size) if disc else math.hypot(*size) / 2
    reach = radius - own - CLOSE
    if own + CLOSE >= reach or max(size) >= LONG * min(size):
        return in_line
    in_ring = int(math.pi / math.asin((own + CLOSE) / reach))
    return max(in_line, in_ring + (in_ring > 4 and reach >= 2 * own + CLOSE))


def _round_own(plan: Vec2) -> float:
    """Radius of the disc that stands for a thing: of what is as deep as wide its half, of others about all of it."""
    return max(plan) / 2 if abs(plan[0] - plan[1]) < ALIKE else math.hypot(*plan) / 2


class _Foot(NamedTuple):
    """Where a thing stands: its middle in the thing's frame, and its sides [m]."""

    middle: Vec2
    size: Vec2


def _foot(box: tuple[float, float, float, float], share: float) -> _Foot:
    x0, y0, x1, y1 = (share * side for side in box)
    return _Foot(((x0 + x1) / 2, (y0 + y1) / 2), (x1 - x0, y1 - y0))


def _at_size(
    situation: Situation,
    anchor: Placement,
    tie: Tie,
    surfaces: tuple[Surface, ...],
    size: Vec3,
    *,
    foot: _Foot | None = None,
) -> Iterator[Idea]:
    """Places for a thing of a size; with a foot, it may reach past the edges with all that is not its foot."""
    shelves = len(_alike(surfaces)) if tie.count > 1 else 1
    passed = (anchor.id, *situation.seats, *situation.enclosing(anchor))
    discs = _discs_on(situation, anchor) if _is_disc(situation.asset.front, size) else ()
    tight = tie.count > 1 and sum(_fitting(s, size[:2], tight=False) for s in surfaces) < tie.count
    (ox, oy), stands = foot or _Foot((0.0, 0.0), (size[0], size[1]))
    for rank, surface in enumerate(surfaces):
        for turn in _turns(situation, anchor, surface):
            plan = stands if turn % 180.0 == 0.0 else (stands[1], stands[0])
            free = _free_half(plan, surface, tight=tight)
            if free is None:
                continue
            forward = max(0.0, (plan[0] - surface.size[0]) / 2)
            c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
            crowding = TIGHT if _only_turned(surfaces, plan, tie) else 0.0
            for (x, y), cost in _spots(situation, anchor, surface, tie, free, shelves, plan):
                dearer = cost + 0.4 * rank + (0.6 if turn % 180.0 else 0.0) + crowding
                spot = (x + forward - (ox * c - oy * s), y - (ox * s + oy * c))
                idea = _idea(situation, anchor, surface, spot, turn, dearer, size, passed)
                if discs:
                    idea = replace(idea, ignore=(*idea.ignore, *_clear_of(discs, idea, size[0] / 2)))
                if tie.kind != "inside" or idea.cost < OFF:
                    yield idea


def _is_disc(front: str, size: Vec3) -> bool:
    return front == "any" and abs(size[0] - size[1]) < ALIKE


def _discs_on(situation: Situation, anchor: Placement) -> tuple[Placement, ...]:
    """What is round and stands on or in a thing: the corners of its box are free."""
    riders = situation.scene.resting_on(anchor.id)
    return tuple(p for p in riders if _is_disc(situation.scene.asset_of(p).front, p.size))


def _clear_of(discs: Sequence[Placement], idea: Idea, own: float) -> Iterator[str]:
    """Those discs that a round thing does not meet at an idea's place, though their boxes may."""
    for p in discs:
        if math.dist(p.position[:2], idea.position[:2]) >= own + p.size[0] / 2:
            yield p.id


def _in_turn(surfaces: tuple[Surface, ...], size: Vec3, tie: Tie) -> tuple[Surface, ...]:
    """The surfaces in the order to try: alike things take the shelves in turn."""
    fitting = [s for s in surfaces if s.headroom is None or size[2] + HEADROOM <= s.headroom]
    alike = _alike(fitting)
    if len(alike) < 2 or tie.count < 2:
        return tuple(fitting)
    start = tie.index % len(alike)
    rest = [s for s in fitting if s not in alike]
    return (*alike[start:], *alike[:start], *rest)


def _alike(surfaces: Sequence[Surface]) -> list[Surface]:
    """Those as large as the first, as the shelves of a rack are."""
    return [s for s in surfaces if max(abs(a - b) for a, b in zip(s.size, surfaces[0].size, strict=True)) < ALIKE]


def _turns(situation: Situation, anchor: Placement, surface: Surface) -> tuple[float, ...]:
    if _users_way(anchor) < 0.0 and situation.asset.front == "one":
        return (180.0,)
    served = facts_of(anchor.category).is_in("served_over")
    if situation.facts.is_in("staff_side") and served and not _against_wall(situation, anchor):
        return (180.0,)
    if situation.asset.front == "any" or (_looks_ahead(situation) and situation.target.count > 1):
        return (0.0,)
    if situation.size[1] > surface.size[1] or situation.asset.front == "two":
        return (0.0, 90.0)
    return (0.0, 90.0, 270.0)


def _users_way(anchor: Placement) -> float:
    """1, or -1 where who works at it sits behind it: what is before them is at the back."""
    return -1.0 if facts_of(anchor.category).is_in("worked_behind") else 1.0


def _against_wall(situation: Situation, anchor: Placement) -> bool:
    back = anchor.to_room((-anchor.size[0] / 2, 0.0))
    return any(abs(wall.coordinates(back)[1]) < 0.4 for wall in situation.room.walls)


def _free_half(plan: Vec2, surface: Surface, *, tight: bool = False) -> Vec2 | None:
    """Half extents over which the middle of what is so deep and wide may move; None when it does not fit at all.

    Where it is tight, no edge is kept free, and what is no hollow has things a little over its edge.
    """
    half = ((surface.size[0] - plan[0]) / 2, (surface.size[1] - plan[1]) / 2)
    if min(half) < -OVERHANG:
        return None
    if tight:
        over = 0.0 if surface.within or surface.round else SLIGHTLY_OVER
        aside = over if surface.headroom is None else 0.0  # A board below another has uprights at its ends.
        return (max(0.0, half[0]) + over, max(0.0, half[1]) + aside)
    edge = CLOSE if surface.within and not surface.round else EDGE
    margin_x, margin_y = min(edge, max(0.0, half[0]) / 2), min(edge, max(0.0, half[1]) / 2)
    return (max(0.0, half[0] - margin_x), max(0.0, half[1] - margin_y))


def _spots(
    situation: Situation, anchor: Placement, surface: Surface, tie: Tie, free: Vec2, shelves: int, plan: Vec2
) -> Iterator[tuple[Vec2, float]]:
    side = _side_of_top(situation, anchor)
    if side is not None or tie.kind == "in_centre":
        yield from _middle(free, anchor) if side is None else _towards(side, free, surface)
        return
    yield from _by_companion(situation, anchor, surface, free)
    yield from _by_partners(situation, anchor, surface, free)
    yield from by_seats(situation, anchor, surface, free)
    way = _users_way(anchor)
    marked = tuple((way * u, way * v) for u, v in situation.facts.spots)
    if surface.headroom is not None and tie.kind == "on":
        yield from _beside_others(situation, anchor, surface, free, plan)
    if tie.count > 1 and not (marked and 1 < shelves >= tie.count):
        marked = _spread(tie, surface, free, shelves, plan, turns=situation.asset.front == "any")
        if _looks_ahead(situation) and marked[0][0] == 0.0:
            marked = ((way * situation.facts.spots[0][0], marked[0][1]),)
    ends = [way * _leaving_room(situation, surface, axis) for axis in (0, 1)]
    if any(ends):
        usual = marked[0] if marked else (0.0, 0.0)
        marked = ((ends[0] or usual[0], ends[1] or usual[1]),)
    elif surface.headroom is None and (tie.kind == "on" or (tie.kind == "inside" and not surface.round)):
        marked = _share_of(situation, anchor, surface, free, tie) or marked
    marked = (*_before_who_works(situation, anchor, surface, free, marked, tie), *marked)
    for rank, (u, v) in enumerate(marked):
        yield (u * free[0], v * free[1]), 0.1 * rank
    columns = max(3, min(21, round(free[1] / 0.06)))
    rows = max(3, min(9, round(free[0] / 0.06)))
    wanted = marked[0] if marked else (0.0, 0.0)
    for i in range(rows):
        for j in range(columns):
            u, v = 2 * i / (rows - 1) - 1, 2 * j / (columns - 1) - 1
            yield (u * free[0], v * free[1]), 0.3 + 0.5 * math.hypot(u - wanted[0], v - wanted[1])


def _before_who_works(
    situation: Situation, anchor: Placement, surface: Surface, free: Vec2, marked: tuple[Vec2, ...], tie: Tie
) -> tuple[Vec2, ...]:
    """Where a screen is before the one seat at a desk, which need not be drawn up to its middle."""
    aside = axis_of_seat(situation, anchor, surface) if tie.count == 1 and situation.facts.is_in("screens") else 0.0
    v = min(max(aside, -free[1]), free[1]) / max(free[1], EDGE)
    return ((marked[0][0] if marked else 0.0, v),) if aside else ()


def _by_companion(
    situation: Situation, anchor: Placement, surface: Surface, free: Vec2
) -> Iterator[tuple[Vec2, float]]:
    companion = situation.facts.companion
    if companion is None:
        return
    way = _users_way(anchor)
    du, dv = way * companion.side[0], way * companion.side[1]
    for p in situation.scene.resting_on(anchor.id):
        if p.category == companion.category:
            x, y = anchor.to_local((p.position[0], p.position[1]))
            u = x - surface.position[0] + du * (p.size[0] / 2 + situation.size[0] / 2 + 0.06)
            v = y - surface.position[1] + dv * (p.size[1] / 2 + situation.size[1] / 2 + 0.06)
            if abs(u) <= free[0] + EDGE and abs(v) <= free[1] + EDGE:
                yield (u, v), -0.2


def _by_partners(situation: Situation, anchor: Placement, surface: Surface, free: Vec2) -> Iterator[tuple[Vec2, float]]:
    """Midway between the two that it is to be between, or with room for what is to be between it and another."""
    ways: list[Vec2] = []
    for width, other in partners.parted_on(situation, anchor):
        x, y = anchor.to_local((other.position[0], other.position[1]))
        reach = max(other.size[:2]) / 2 + width + situation.size[1] / 2 + 2 * BETWEEN
        ways += [(x, y + reach), (x, y - reach)]
    if (pair := partners.between_on(situation, anchor)) is not None:
        (x, y), (a, b) = (anchor.to_local((p.position[0], p.position[1])) for p in pair)
        ways.append(((x + a) / 2, (y + b) / 2))
    for x, y in ways:
        spot = (x - surface.position[0], y - surface.position[1])
        if abs(spot[0]) <= free[0] + EDGE and abs(spot[1]) <= free[1] + EDGE:
            yield spot, -0.4


def _beside_others(
    situation: Situation, anchor: Placement, surface: Surface, free: Vec2, plan: Vec2
) -> Iterator[tuple[Vec2, float]]:
    """Right beside what is on a shelf already, which leaves the largest gap for what comes."""
    for p in situation.scene.resting_on(anchor.id):
        if abs(p.position[2] - anchor.position[2] - surface.position[2]) > APART:
            continue
        _, y = anchor.to_local((p.position[0], p.position[1]))
        across = round((p.yaw - anchor.yaw) / 90.0) % 2 == 1
        reach = (p.size[0] if across else p.size[1]) / 2 + plan[1] / 2 + APART
        for v in (y - surface.position[1] + reach, y - surface.position[1] - reach):
            if abs(v) <= free[1] + EDGE:
                yield (0.0, v), BESIDE_OTHERS


def _leaving_room(situation: Situation, surface: Surface, axis: int) -> float:
    """To which end of a surface it goes, from -1 to 1, so that another thing has room at one side of it; 0 for none.

    Args:
        situation: of what is placed.
        surface: where.
        axis: 0 for what is to be before or behind it, 1 for what is to be left or right of it.
    """
    own, kinds = situation.target.id, [kind for kind, way in SIDES_OF_TOP.items() if way[axis]]
    later = [(t, tie.kind) for t in situation.followers for tie in t.ties if own in tie.anchors and tie.kind in kinds]
    if len({kind for _, kind in later}) != 1:
        return 0.0
    beside = [situation.kind(target).size[axis] + APART for target, _ in later]
    if (surface.size[axis] - situation.size[axis]) / 2 >= (sum(beside) if axis else max(beside)):
        return 0.0
    return -SIDES_OF_TOP[later[0][1]][axis]


def _side_of_top(situation: Situation, anchor: Placement) -> Vec2 | None:
    """Towards which side of the top of the anchor it is to lie, from -1 to 1 along each axis; None for none."""
    ties = [t for t in situation.target.ties if t.asked and anchor.id in t.anchors]
    sides = [SIDES_OF_TOP[tie.kind] for tie in ties if tie.kind in SIDES_OF_TOP]
    return (sum(u for u, _ in sides), sum(v for _, v in sides)) if sides else None


def _towards(side: Vec2, free: Vec2, surface: Surface) -> Iterator[tuple[Vec2, float]]:
    """Near a side of a top, then further in, and along that side where the edge is taken."""
    for step in range(STEPS):
        inwards = 1.0 - 0.15 * step
        for aside in (0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0):
            u, v = (along * inwards if along else aside for along in side)
            if all(side) and aside:
                continue
            far = math.hypot(u * free[0], v * free[1]) > min(surface.size) / 2 if surface.round else False
            if not far:
                yield (u * free[0], v * free[1]), 0.1 * step + 0.3 * abs(aside)


def _middle(free: Vec2, anchor: Placement) -> Iterator[tuple[Vec2, float]]:
    """The very middle, and around it where that is taken, within the middle half of what carries it."""
    yield (0.0, 0.0), 0.0
    for ring in (1, 2, 3):
        for step in range(8):
            angle = math.pi * step / 4
            x, y = (
                ring * anchor.size[axis] / 14 * turn for axis, turn in enumerate((math.cos(angle), math.sin(angle)))
            )
            if abs(x) <= free[0] and abs(y) <= free[1]:
                yield (x, y), 0.2 * ring


def _spread(tie: Tie, surface: Surface, free: Vec2, shelves: int, plan: Vec2, *, turns: bool) -> tuple[Vec2, ...]:
    """Evenly along the longer side for up to six on one of the shelves, in two staggered lines for more.

    On a disc, in a ring, to its very edge what `turns` as a disc does; what is long lies there side by side.
    """
    count, index = -(-tie.count // shelves), tie.index // shelves
    if surface.round and max(plan) < LONG * min(plan) and (surface.within or count > 3):
        own = _round_own(plan) if turns else math.hypot(*plan) / 2
        away = max(0.0, min(surface.size) / 2 - own - CLOSE)
        return _ring(count, index, (away / max(free[0], 1e-9), away / max(free[1], 1e-9)))
    lengthwise = 1 if (plan[1] <= plan[0] if surface.round else surface.size[1] >= surface.size[0]) else 0
    lines = _lines(count, plan[lengthwise], surface.size[lengthwise])
    per_line = -(-count // lines)
    line, place = divmod(index, per_line)
    half = surface.size[lengthwise] / 2
    if surface.round:
        half = math.sqrt(max(0.0, half**2 - (plan[1 - lengthwise] / 2) ** 2))
    along = (2 * (place + 0.5) / per_line - 1) * half / max(free[lengthwise], 1e-9)
    across = (2 * (line + 0.5) / lines - 1) * surface.size[1 - lengthwise] / 2 / max(free[1 - lengthwise], 1e-9)
    along, across = min(max(along, -1.0), 1.0), min(max(across, -1.0), 1.0)
    return ((across, along),) if lengthwise else ((along, across),)


def _lines(count: int, own: float, length: float) -> int:
    """In how many lines so many stand along a length: in one up to six that have room there, else in two or more."""
    fewest = 1 if count <= 6 else 2
    return next((n for n in range(fewest, count) if -(-count // n) * (own + CLOSE) <= length), fewest)


def _ring(count: int, index: int, reach: Vec2) -> tuple[Vec2, ...]:
    """On a ring round the middle of a disc, `reach` away along each axis; of more than five, one in the middle."""
    around = count - 1 if count > 5 else count
    if index == around:
        return ((0.0, 0.0),)
    angle = 2 * math.pi * index / around
    return ((reach[0] * math.cos(angle), reach[1] * math.sin(angle)),)


def _share_of(situation: Situation, anchor: Placement, surface: Surface, free: Vec2, tie: Tie) -> tuple[Vec2, ...]:
    """Where the target stands among the kinds of things that crowd one top: each kind has a stretch of it, in lines.

    Empty where the top is not crowded, or one kind alone is on it.
    """
    groups = _kinds_on(situation, anchor, tie)
    own = next((n for n, group in enumerate(groups) if situation.target in group), None)
    central = any(tie.kind == "in_centre" and anchor.id in tie.anchors for tie in situation.target.ties)
    if own is None or len(groups) < 2 or central or _looks_ahead(situation):
        return ()
    areas = [sum(_area(situation, target) for target in group) for group in groups]
    least = CROWDED if len(groups[own]) > 1 else CROWDED_BY_ONES
    if sum(areas) < least * surface.size[0] * surface.size[1]:
        return ()
    lengthwise = 1 if surface.size[1] >= surface.size[0] else 0
    length, depth = surface.size[lengthwise], surface.size[1 - lengthwise]
    start, share = sum(areas[:own]) / sum(areas), areas[own] / sum(areas)
    number, count = groups[own].index(situation.target), len(groups[own])
    x, y = situation.size[lengthwise], situation.size[1 - lengthwise]
    lines = max(1, min(count, int(depth / (y + APART)), round(math.sqrt(count * depth / (share * length) * x / y))))
    per_line = -(-count // lines)
    line, place = divmod(number, per_line)
    along = (2 * (start + share * (place + 0.5) / per_line) - 1) * length / 2 / max(free[lengthwise], 1e-9)
    across = (2 * (line + 0.5) / lines - 1) * depth / 2 / max(free[1 - lengthwise], 1e-9)
    along, across = min(max(along, -1.0), 1.0), min(max(across, -1.0), 1.0)
    return ((across, along),) if lengthwise else ((along, across),)


def _kinds_on(situation: Situation, anchor: Placement, tie: Tie) -> list[list[Target]]:
    """What the plan has on the anchor, or in it as the tie says, by request, in its order."""
    groups: dict[str, list[Target]] = {}
    for target in situation.observation.plan.targets:
        if any(other.kind == tie.kind and anchor.id in other.anchors for other in target.ties):
            groups.setdefault(target.request, []).append(target)
    return list(groups.values())


def _area(situation: Situation, target: Target) -> float:
    if target.id in situation.scene:
        size: Vec3 = situation.scene[target.id].size
    else:
        size = situation.size if target.request == situation.target.request else situation.kind(target).size
    return (size[0] + APART) * (size[1] + APART)


def _idea(
    situation: Situation,
    anchor: Placement,
    surface: Surface,
    spot: Vec2,
    turn: float,
    cost: float,
    size: Vec3,
    passed: tuple[str, ...],
) -> Idea:
    local = (surface.position[0] + spot[0], surface.position[1] + spot[1])
    if surface.round:
        cost += _off_ellipse(situation, surface, spot, size, turn)
    x, y = anchor.to_room(local)
    z = anchor.position[2] + surface.position[2]
    yaw = (anchor.yaw + turn) % 360.0
    words = (
        Constraint(kind="on", anchors=(anchor.id,)),
        Constraint(kind="offset", anchors=(anchor.id,), values=(round(local[0], 3), round(local[1], 3))),
        turned(yaw),
    )
    return Idea((x, y, z), yaw, words, f"{anchor.id} carries it, within reach", cost, passed)


def _off_ellipse(situation: Situation, surface: Surface, spot: Vec2, size: Vec3, turn: float) -> float:
    """What it costs to reach over the edge of a round surface; a thing that is round itself does so with no corners."""
    a, b = surface.size[0] / 2, surface.size[1] / 2
    if situation.asset.front == "any" and abs(size[0] - size[1]) < ALIKE:
        a, b, corner = a - size[0] / 2, b - size[1] / 2, (abs(spot[0]), abs(spot[1]))
    else:
        deep, wide = (size[1], size[0]) if turn % 180.0 else (size[0], size[1])
        corner = (abs(spot[0]) + deep / 2, abs(spot[1]) + wide / 2)
    if min(a, b) <= 0.0:
        return 0.0 if math.hypot(*spot) < ALIKE and not surface.within else OFF
    inside = (corner[0] / a) ** 2 + (corner[1] / b) ** 2 <= 1.0
    return 0.0 if inside or (math.hypot(*spot) < ALIKE and not surface.within) else OFF
