"""Where things go on a table that people sit at: one to each seat, before whoever sits there."""

import math
from collections import Counter
from collections.abc import Iterator

from thinkblox.assets import facts_of
from thinkblox.policies.expert.situation import Situation, is_seat
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.value import Vec2

AT_TABLE = 0.6
"""A seat nearer than this to a table belongs to it [m]."""
SERVED = 0.5
"""Cost of a place before a seat that has one of them already."""
BESIDE_PLATE: tuple[Vec2, ...] = ((0.32, -0.16), (0.06, -0.24), (0.06, 0.24), (0.38, 0.0))
"""Where a thing lies that is no part of a setting, but comes once to each seat: from the edge, and to the right [m]."""


def by_seats(situation: Situation, anchor: Placement, surface: Surface, free: Vec2) -> Iterator[tuple[Vec2, float]]:
    """A spot on the surface for each seat at the table, one's own first, with its cost."""
    if situation.target.count < 2:
        return
    seats = _laid_for(situation, _seats_at(situation, anchor))
    served = {min(seats, key=lambda seat: _apart(seat, p)).id for p in situation.siblings if seats}
    for rank, inset in enumerate(_insets(situation, anchor, len(seats))):
        for number, seat in enumerate(seats):
            dear = SERVED * (seat.id in served) + 0.02 * rank
            u, v = _before(anchor, surface, seat, inset, reach=max(situation.size[:2]) / 2)
            if abs(u) <= free[0] and abs(v) <= free[1]:
                yield (u, v), -0.6 + dear + (0.0 if number == situation.target.index else 0.1)


def _apart(one: Placement, other: Placement) -> float:
    return math.dist(one.position[:2], other.position[:2])


def _laid_for(situation: Situation, seats: list[Placement]) -> list[Placement]:
    """The seats of the kind of which there are as many as of the target: the chairs, not the high chair."""
    kinds = Counter(seat.category for seat in seats)
    meant = next((kind for kind, number in kinds.items() if number == situation.target.count), None)
    return [seat for seat in seats if meant in (None, seat.category)]


def _insets(situation: Situation, anchor: Placement, seats: int) -> tuple[Vec2, ...]:
    """Where in a place setting the target may lie, the best first; nowhere where it is no part of any."""
    if situation.facts.setting is not None:
        return (situation.facts.setting,)
    on = (t for t in situation.observation.plan.targets if any(anchor.id in tie.anchors for tie in t.ties))
    laid = any(t.count == seats and facts_of(t.category).setting is not None for t in on)
    return BESIDE_PLATE if situation.target.count == seats and laid else ()


def axis_of_seat(situation: Situation, anchor: Placement, surface: Surface) -> float:
    """How far to the left of a surface's middle the one who works at it sits [m]; 0 for nobody, or several."""
    if not facts_of(anchor.category).is_in("worked_at"):
        return 0.0
    asides = [anchor.to_local(seat.position[:2])[1] for seat in _seats_at(situation, anchor)]
    asides = [aside for aside in asides if abs(aside) < anchor.size[1] / 2]
    return asides[0] - surface.position[1] if len(asides) == 1 else 0.0


def _seats_at(situation: Situation, anchor: Placement) -> list[Placement]:
    """Seats near the table that look at it."""
    return [
        p
        for p in situation.solid
        if is_seat(p.category) and p.footprint.distance(anchor.footprint) < AT_TABLE and _looks_at(p, anchor)
    ]


def _looks_at(seat: Placement, anchor: Placement) -> bool:
    dx, dy = anchor.position[0] - seat.position[0], anchor.position[1] - seat.position[1]
    angle = math.radians(seat.yaw)
    return dx * math.cos(angle) + dy * math.sin(angle) > 0.0


def _before(anchor: Placement, surface: Surface, seat: Placement, inset: Vec2, *, reach: float) -> Vec2:
    """A point of the surface straight before a seat, from the surface's middle."""
    x, y = anchor.to_local((seat.position[0], seat.position[1]))
    x, y = x - surface.position[0], y - surface.position[1]
    a, b = surface.size[0] / 2, surface.size[1] / 2
    if surface.round:
        share = 1.0 / max(1.0, math.hypot(x / a, y / b))
        x, y = x * share, y * share
    else:
        x, y = min(max(x, -a), a), min(max(y, -b), b)
    angle = math.radians(seat.yaw - anchor.yaw)
    (ahead_x, ahead_y), deep = (math.cos(angle), math.sin(angle)), inset[0] + reach
    if surface.round:  # Beside who sits there, the edge of a disc is nearer to its middle.
        deep += min(a, b) - math.sqrt(max(0.0, min(a, b) ** 2 - inset[1] ** 2))
    return (x + ahead_x * deep + ahead_y * inset[1], y + ahead_y * deep - ahead_x * inset[1])
