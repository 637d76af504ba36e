"""Ideas on top of something: where a hand would put it, beside what stands there already."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.assets import facts_of
from thinkblox.phrases import Constraint
from thinkblox.plan import Tie
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.place_settings import by_seats
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.saying import turned
from thinkblox.value import Vec2, Vec3

EDGE = 0.03
"""Kept free at the edge of a surface where there is room [m]."""
OVERHANG = 0.02
"""Half of how far a thing may reach over the front edge [m]: feet stand inside its outline."""
APART = 0.02
"""Left between things side by side [m]."""
SHRINK = (1.0, 0.85, 0.7, 0.6)
"""Sizes tried, as shares, for what is too large for every surface of its support."""
OFF = 30.0
"""Cost of reaching over the edge of a round surface."""
ALIKE = 0.01
"""Lengths that differ by less are the same [m]."""
EYE_LEVEL = 1.5
"""What is on something stands on its very top rather than on a shelf, if that is no higher [m]."""
HEADROOM = 0.02
"""Air left under the next shelf [m]."""


def on_surfaces(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Places on each surface of the anchor, or inside it, that is large and high enough."""
    surfaces = tuple(s for s in situation.scene.asset_of(anchor).surfaces if _serves(s, tie))
    low_tops = tuple(s for s in surfaces if s.headroom is None and s.position[2] <= EYE_LEVEL)
    shelves = facts_of(anchor.category).is_in("shelves")
    if tie.kind == "on" and not shelves and _room_for_all(low_tops, situation.size, tie):
        surfaces = low_tops
    shares = SHRINK[:1] if any(situation.target.size) else SHRINK
    for step, share in enumerate(shares):
        size = _scaled(situation.size, share)
        if share > shares[-1] and not _room_for_all(surfaces, size, tie):
            continue
        ideas = list(_at_size(situation, anchor, tie, _in_turn(surfaces, size, tie), size))
        yield from (replace(i, cost=i.cost + step, size=None if share == 1.0 else size) for i in ideas)
        if ideas:
            return


def _serves(surface: Surface, tie: Tie) -> bool:
    return surface.inner if tie.kind == "inside" else not surface.within


def _room_for_all(surfaces: tuple[Surface, ...], size: Vec3, tie: Tie) -> bool:
    """Whether as many of that size as the tie counts have room, side by side on all surfaces together."""
    turned = (size[1], size[0])
    return sum(max(_fitting(s, size[:2]), _fitting(s, turned)) for s in surfaces) >= tie.count


def _fitting(surface: Surface, size: Vec2) -> int:
    """How many things of a size fit on a surface in lines."""
    deep = int((surface.size[0] + 2 * OVERHANG) / size[0])
    return deep * int(surface.size[1] / (size[1] + APART))


def _scaled(size: Vec3, share: float) -> Vec3:
    x, y, z = (round(extent * share, 3) for extent in size)
    return (x, y, z)


def _at_size(
    situation: Situation, anchor: Placement, tie: Tie, surfaces: tuple[Surface, ...], size: Vec3
) -> Iterator[Idea]:
    shelves = len(_alike(surfaces)) if tie.count > 1 else 1
    for rank, surface in enumerate(surfaces):
        for turn in _turns(situation, anchor, surface):
            free = _free_half(size, surface, turn)
            if free is None:
                continue
            forward = max(0.0, (size[1 if turn % 180.0 else 0] - surface.size[0]) / 2)
            for (x, y), cost in _spots(situation, anchor, surface, tie, free, shelves):
                dearer = cost + 0.4 * rank + (0.6 if turn % 180.0 else 0.0)
                idea = _idea(situation, anchor, surface, (x + forward, y), turn, dearer, size)
                if tie.kind != "inside" or idea.cost < OFF:
                    yield idea


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
    return [s for s in surfaces if s.size == surfaces[0].size]


def _turns(situation: Situation, anchor: Placement, surface: Surface) -> tuple[float, ...]:
    if situation.facts.is_in("staff_side") and not _against_wall(situation, anchor):
        return (180.0,)
    if situation.asset.front == "any":
        return (0.0,)
    if situation.size[1] > surface.size[1] or situation.asset.front == "two":
        return (0.0, 90.0)
    return (0.0, 90.0, 270.0)


def _against_wall(situation: Situation, anchor: Placement) -> bool:
    back = anchor.to_room((-anchor.size[0] / 2, 0.0))
    return any(abs(wall.coordinates(back)[1]) < 0.4 for wall in situation.room.walls)


def _free_half(size: Vec3, surface: Surface, turn: float) -> Vec2 | None:
    """Half extents over which the centre may move; None when it does not fit at all."""
    depth, width = size[0], size[1]
    if turn % 180.0:
        depth, width = width, depth
    half = ((surface.size[0] - depth) / 2, (surface.size[1] - width) / 2)
    if min(half) < -OVERHANG:
        return None
    margin_x, margin_y = min(EDGE, max(0.0, half[0]) / 2), min(EDGE, max(0.0, half[1]) / 2)
    return (max(0.0, half[0] - margin_x), max(0.0, half[1] - margin_y))


def _spots(
    situation: Situation, anchor: Placement, surface: Surface, tie: Tie, free: Vec2, shelves: int
) -> Iterator[tuple[Vec2, float]]:
    if tie.kind == "in_centre":
        yield from _middle(free, anchor)
        return
    yield from _by_companion(situation, anchor, surface, free)
    yield from by_seats(situation, anchor, surface, free)
    marked = situation.facts.spots
    if tie.count > 1:
        marked = _spread(tie, surface, free, shelves)
    for rank, (u, v) in enumerate(marked):
        yield (u * free[0], v * free[1]), 0.1 * rank
    columns = max(3, min(13, round(free[1] / 0.06)))
    rows = max(3, min(7, round(free[0] / 0.06)))
    wanted = marked[0] if marked else (0.0, 0.0)
    for i in range(rows):
        for j in range(columns):
            u, v = 2 * i / (rows - 1) - 1, 2 * j / (columns - 1) - 1
            yield (u * free[0], v * free[1]), 0.3 + 0.5 * math.hypot(u - wanted[0], v - wanted[1])


def _by_companion(
    situation: Situation, anchor: Placement, surface: Surface, free: Vec2
) -> Iterator[tuple[Vec2, float]]:
    companion = situation.facts.companion
    if companion is None:
        return
    du, dv = companion.side
    for p in situation.scene.resting_on(anchor.id):
        if p.category == companion.category:
            x, y = anchor.to_local((p.position[0], p.position[1]))
            u = x - surface.position[0] + du * (p.size[0] / 2 + situation.size[0] / 2 + 0.06)
            v = y - surface.position[1] + dv * (p.size[1] / 2 + situation.size[1] / 2 + 0.06)
            if abs(u) <= free[0] + EDGE and abs(v) <= free[1] + EDGE:
                yield (u, v), -0.2


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


def _spread(tie: Tie, surface: Surface, free: Vec2, shelves: int) -> tuple[Vec2, ...]:
    """Evenly along the longer side for up to six on one of the shelves, in two staggered lines for more."""
    count, index = -(-tie.count // shelves), tie.index // shelves
    lines = 1 if count <= 6 else 2
    per_line = -(-count // lines)
    line, place = divmod(index, per_line)
    across = 0.0 if lines == 1 else (0.5 if line else -0.5)
    lengthwise = 1 if surface.size[1] >= surface.size[0] else 0
    reach = surface.size[lengthwise] / 2 / max(free[lengthwise], 1e-9)
    along = min(max((2 * (place + 0.5) / per_line - 1) * reach, -1.0), 1.0)
    return ((across, along),) if lengthwise else ((along, across),)


def _idea(
    situation: Situation, anchor: Placement, surface: Surface, spot: Vec2, turn: float, cost: float, size: Vec3
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
    return Idea((x, y, z), yaw, words, f"{anchor.id} carries it, within reach", cost, (anchor.id, *situation.seats))


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
