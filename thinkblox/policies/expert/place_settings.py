"""Where things go on a table that people sit at: one to each seat, before whoever sits there."""

import math
from collections.abc import Iterator

from thinkblox.assets import facts_of
from thinkblox.policies.expert.situation import Situation, is_seat
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.value import Vec2

AT_TABLE = 0.6
"""A seat nearer than this to a table belongs to it [m]."""


def by_seats(situation: Situation, anchor: Placement, surface: Surface, free: Vec2) -> Iterator[tuple[Vec2, float]]:
    """A spot on the surface for each seat at the table, one's own first, with its cost."""
    inset = situation.facts.setting
    if inset is None or situation.target.count < 2:
        return
    for number, seat in enumerate(_seats_at(situation, anchor)):
        u, v = _before(anchor, surface, seat, inset, reach=max(situation.size[:2]) / 2)
        if abs(u) <= free[0] and abs(v) <= free[1]:
            yield (u, v), -0.6 + (0.0 if number == situation.target.index else 0.1)


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
    return (x + ahead_x * deep + ahead_y * inset[1], y + ahead_y * deep - ahead_x * inset[1])
