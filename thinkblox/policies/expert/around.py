"""Ideas for seats at tables: drawn up to a desk, or evenly around a table."""

import math
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.plan import Tie
from thinkblox.policies.expert.beside import beside_at
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.situation import Situation, is_lounge, is_seat
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth
from thinkblox.value import Vec2

PLACE_WIDTH = 0.6
"""Edge of a table that one person needs [m]; Neufert, Architects' Data."""
LEG = 0.03
"""What the legs of a table take of an edge at each end [m]: chairs that only just touch them take long to measure."""
BETWEEN = 0.1
"""Free width between those in a circle [m]."""
SQUEEZED = 0.5
"""The least of it, at a counter [m]."""
USUAL_TUCKS = (0.15, 0.05, -0.05)
"""How far a seat goes under the table, the best first, unless its category says otherwise [m]."""
ROUND_TUCKS = (0.05, -0.05)
"""The same at a round table: its legs stand between the seats."""
UNTUCKED = (0.0, -0.05, -0.1)
"""The same for what nobody sits on."""
APART = (0.25, 0.5)
"""How far off a thing those keep who find no room right at it and do not sit there [m]."""
LEG_ROOM = (-0.4, -0.35, -0.45)
"""The same for who leans back before a low table: that far off it."""
SIDES: dict[str, float] = {"front": 0.0, "left": 90.0, "back": 180.0, "right": 270.0}
"""Outward direction of each side in the table's own frame [degrees]."""
OTHERWISE = 1.0
"""Cost of sitting at other sides than at the tables alike."""
SPOILT = 2.0
"""Cost of seating people so that one of them finds no place."""
WHERE_ONE_COOKS = 3.0
"""Cost of sitting at another side of an island than its back."""
ABOUT = 0.55
"""A seat farther off a table is not at it [m]."""
SAME_SEAT = 0.15
"""A placed seat nearer than this to a place, seen along the edge, has taken it [m]."""


class Place(NamedTuple):
    """Where one person sits: the middle of their edge of the table and the way out from it, in the table's frame."""

    edge: Vec2
    outward: float

    def seat(self, depth: float, tuck: float) -> Vec2:
        """Centre of a seat of that depth, `tuck` under the table [m]."""
        out = depth / 2 - tuck
        angle = math.radians(self.outward)
        return (self.edge[0] + out * math.cos(angle), self.edge[1] + out * math.sin(angle))


def at_desk(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Drawn up to the working side of a desk (its front), or to any side of a table without a front.

    At an island one sits at its back, where the worktop stands out over the knees, rather than where one cooks.
    """
    if not tie.asked and (angle := _in_angle(situation, anchor)) is not None:  # Asked for, it is to face the middle.
        yield from seats(situation, anchor, angle, cost=0.0)
        return
    sides, dear = tuple(SIDES), 0.3
    if facts_of(anchor.category).is_in("sat_around") and facts_of(anchor.category).is_in("worktops"):
        sides, dear = ("back", "left", "right", "front"), WHERE_ONE_COOKS
    elif situation.scene.asset_of(anchor).front == "one":
        sides = ("front",)
    for rank, side in enumerate(sides):
        if tie.count > 1:
            places = _company_at(anchor, side, tie)
        else:
            width = _width(anchor, side)
            places = [_place(anchor, side, shift * width) for shift in (0.0, 0.15, -0.15)]
        for order, place in enumerate(places):
            yield from seats(situation, anchor, place, cost=dear * rank + 0.2 * order)


def _in_angle(situation: Situation, anchor: Placement) -> Place | None:
    """The place in the angle of a desk with a wing, before the longer top; None at a desk of one top."""
    tops = [s for s in situation.scene.asset_of(anchor).surfaces if s.headroom is None and not s.within]
    if len(tops) != 2 or situation.scene.asset_of(anchor).front != "one":
        return None
    main, wing = sorted(tops, key=lambda top: -top.size[1])
    edge = main.position[0] + main.size[0] / 2
    if wing.position[0] < edge or wing.size[1] + situation.size[1] > main.size[1]:
        return None
    side = 1.0 if wing.position[1] > main.position[1] else -1.0
    return Place((edge, main.position[1] - side * wing.size[1] / 2), 0.0)


def _company_at(anchor: Placement, side: str, tie: Tie) -> list[Place]:
    """The place of one of several along a side, or a little aside; who finds no room there sits at the ends."""
    fit = max(1, int(_width(anchor, side) / SQUEEZED))
    if tie.index < fit:
        middle = _width(anchor, side) * ((tie.index + 0.5) / min(tie.count, fit) - 0.5)
        return [_place(anchor, side, middle + shift) for shift in (0.0, 0.15, -0.15, 0.3, -0.3)]
    return [place for end in ("left", "right") for place in side_places(anchor, end, 1)]


def around(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Every arrangement of the whole company about the anchor; from each, the places that are still free."""
    pattern = _pattern_elsewhere(situation, anchor, tie)
    for order, places in enumerate(_companies(situation, anchor, tie.count)):
        other = OTHERWISE * (bool(pattern) and pattern != Counter(place.outward for place in places))
        free, strays, tucks = free_places(situation, anchor, places)
        spoilt = _spoilt(situation, anchor, free)
        for place in free:
            cost = 0.4 * order + other + 2.0 * strays + SPOILT * sum(spoilt) - _from_middle(place)
            yield from seats(situation, anchor, place, cost=cost, tucks=tucks)


def _pattern_elsewhere(situation: Situation, anchor: Placement, tie: Tie) -> Counter[float]:
    """At how many sides of an alike table as many sit already; empty where there is none."""
    targets = situation.observation.plan.targets
    for table in situation.alike(anchor.id):
        seats = situation.placed(
            tuple(t.id for t in targets for k in t.ties if k.kind == "around" and table.id in k.anchors)
        )
        if len(seats) == tie.count and abs(table.size[0] - anchor.size[0]) < SAME_SEAT:
            return Counter(90.0 * (round((p.yaw - table.yaw - 180.0) / 90.0) % 4) for p in seats)
    return Counter()


def _from_middle(place: Place) -> float:
    """How far along its edge a place is: the outer ones come first, for the legs of the table are there [m]."""
    angle = math.radians(place.outward)
    return abs(-place.edge[0] * math.sin(angle) + place.edge[1] * math.cos(angle))


def seats(
    situation: Situation, anchor: Placement, place: Place, *, cost: float, tucks: tuple[float, ...] = ()
) -> Iterator[Idea]:
    """At one place, drawn up as far as those that stand there, or more or less."""
    usual = _tucks(situation, anchor)
    for step, tuck in enumerate(sorted(usual, key=lambda t: min((round(abs(t - k), 2) for k in tucks), default=0.0))):
        yield beside_at(
            situation,
            anchor,
            place.seat(situation.size[0], tuck),
            yaw=round(anchor.yaw + place.outward + 180.0, 2),
            words=(),
            why=f"a person sits there at {anchor.id}, with a place of their own",
            cost=cost + 0.2 * step,
            ignore=(anchor.id,),
        )


def _tucks(situation: Situation, anchor: Placement) -> tuple[float, ...]:
    """How far the target goes under the anchor, the best first [m]; negative where it keeps away from it."""
    if not is_seat(situation.target.category):
        return UNTUCKED
    if is_lounge(situation.target.category) and facts_of(anchor.category).is_in("lounged_at"):
        return LEG_ROOM
    surfaces = situation.scene.asset_of(anchor).surfaces
    return situation.facts.tucks or (ROUND_TUCKS if surfaces and surfaces[0].round else USUAL_TUCKS)


def free_places(
    situation: Situation, anchor: Placement, places: list[Place]
) -> tuple[list[Place], int, tuple[float, ...]]:
    """The places nobody has taken yet, how many seats at this table fit none of them, and how far seats go under it."""
    free, strays, tucks = list(places), 0, []
    for p in situation.siblings:
        x, y = anchor.to_local((p.position[0], p.position[1]))
        off = max(abs(x) - anchor.size[0] / 2, abs(y) - anchor.size[1] / 2)
        if off > situation.size[0] / 2 + ABOUT:
            continue
        taken = min(free, key=lambda place: _off(place, x, y), default=None)
        if taken is not None and _off(taken, x, y) < SAME_SEAT:
            free.remove(taken)
            tucks.append(round(situation.size[0] / 2 - _out(taken, x, y), 3))
        else:
            strays += 1
    return free, strays, tuple(tucks)


def _out(place: Place, x: float, y: float) -> float:
    """Distance of a point from a place's edge, straight out [m]."""
    angle = math.radians(place.outward)
    return (x - place.edge[0]) * math.cos(angle) + (y - place.edge[1]) * math.sin(angle)


def _off(place: Place, x: float, y: float) -> float:
    """Distance of a seat from a place's middle, along the edge; much when it is on another side [m]."""
    angle = math.radians(place.outward)
    dx, dy = x - place.edge[0], y - place.edge[1]
    out = dx * math.cos(angle) + dy * math.sin(angle)
    return abs(-dx * math.sin(angle) + dy * math.cos(angle)) + (0.0 if -0.2 < out < 0.8 else 1.0)


def _spoilt(situation: Situation, anchor: Placement, places: list[Place]) -> list[bool]:
    """Which places cannot be used, because something stands there or the room ends."""
    size = situation.size
    tuck = _tucks(situation, anchor)[0]
    rects = Rects.of(
        [
            (anchor.to_room(p.seat(size[0], tuck)), (size[0], size[1]), anchor.yaw + p.outward, 0.0, size[2])
            for p in places
        ]
    )
    others = [i for i, p in enumerate(situation.solid) if p.id != anchor.id]
    taken = overlap_depth(rects, situation.solids.take(others)).max(-1, initial=0.0)
    swung = overlap_depth(rects, situation.door_zones).max(-1, initial=0.0)
    return list((taken > 0.001) | (swung > 0.001) | (outside(rects, situation.room.polygon) > 0.0005))


def _companies(situation: Situation, anchor: Placement, count: int) -> list[list[Place]]:
    surfaces = situation.scene.asset_of(anchor).surfaces
    tucked = max(_tucks(situation, anchor)) if is_seat(situation.target.category) else 0.0
    wide = _circles(anchor, count, situation.size[1], tucked)
    if surfaces and surfaces[0].round:
        return [*wide, *(_ring(anchor, count, phase / 8) for phase in (0, 4, 2, 6))]
    crowded = count > 1 and situation.size[1] > max(anchor.size[:2])
    if wide and (crowded or not is_seat(situation.target.category)):
        return wide
    place = max(PLACE_WIDTH, situation.size[1] + 0.05)
    if not is_seat(situation.target.category):
        anchor = _wide_enough(anchor, count, place)
    return _rectangles(anchor, count, place=place)


def _wide_enough(anchor: Placement, count: int, place: float) -> Placement:
    """A thing with so much about it that all have room along its sides; as it is where that is no help."""
    for off in (0.0, *APART):
        depth, width = (side + 2 * off for side in anchor.size[:2])
        if 2 * sum(int((side + 0.05 - 2 * LEG) / place) for side in (depth, width)) >= count:
            return structs.replace(anchor, size=(depth, width, anchor.size[2]))
    return anchor


def _circles(anchor: Placement, count: int, width: float, tucked: float) -> list[list[Place]]:
    """Circles about what is too small for the company to sit at its edge: as wide as they need side by side."""
    if count < 3:
        return []
    needed = (width + BETWEEN) / 2 / math.tan(math.pi / count)
    if needed <= max(anchor.size[:2]) / 2:
        return []
    needed += tucked
    turns = [[360.0 * (k + phase) / count % 360.0 for k in range(count)] for phase in (0.0, 0.5)]
    return [
        [Place((needed * math.cos(math.radians(t)), needed * math.sin(math.radians(t))), round(t, 2)) for t in each]
        for each in turns
    ]


def _ring(anchor: Placement, count: int, phase: float) -> list[Place]:
    """`count` places evenly along an ellipse, the first of them `phase` of a place along from its front."""
    a, b = anchor.size[0] / 2, anchor.size[1] / 2
    angles = np.linspace(0.0, 2 * np.pi, 721)
    x, y = a * np.cos(angles), b * np.sin(angles)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    wanted = (np.arange(count) + phase) / count * along[-1]
    turns = np.interp(wanted, along, angles)
    return [Place((a * math.cos(t), b * math.sin(t)), _outward(a, b, t)) for t in turns]


def _outward(a: float, b: float, t: float) -> float:
    """Midway between square to an ellipse's edge and away from its centre: how people turn at an oval table."""
    square = math.atan2(math.sin(t) / b, math.cos(t) / a)
    away = math.atan2(b * math.sin(t), a * math.cos(t))
    turn = math.remainder(away - square, 2 * math.pi)
    return round(math.degrees(square + turn / 2) % 360.0, 1)


def _rectangles(anchor: Placement, count: int, *, place: float) -> list[list[Place]]:
    """Ways to seat `count` people about a rectangle, the best first: pairs on the long sides, then heads.

    The last two leave one long side free, for a table that stands at a wall.
    """
    depth, width = anchor.size[0], anchor.size[1]
    sides = ("front", "back", "left", "right") if width >= depth else ("left", "right", "front", "back")
    ranked: list[tuple[float, list[Place]]] = []
    for heads in range(min(count, 2 * max(1, round(min(depth, width) / place))) + 1):
        counts = dict(zip(sides, _halves(count - heads) + _halves(heads), strict=True))
        crowd = sum(max(0.0, n * place - 0.05 - _width(anchor, side)) for side, n in counts.items())
        odd = (count - heads) % 2 + heads % 2
        even = abs(heads - count / 2) * 0.3 if max(depth, width) < 1.2 * min(depth, width) else heads * 0.1
        places = [spot for side, n in counts.items() for spot in side_places(anchor, side, n)]
        ranked.append((3.0 * crowd + 0.2 * odd + even, places))
    ways = [places for _, places in sorted(ranked, key=lambda r: r[0])][:4]
    along = min(count, int((_width(anchor, sides[0]) + 0.05) / place))
    if 2 <= along < count <= along + 2:
        ends = [spot for side in sides[2:][: count - along] for spot in side_places(anchor, side, 1)]
        ways += [[*side_places(anchor, side, along), *ends] for side in sides[:2]]
    return ways


def _halves(count: int) -> tuple[int, int]:
    return (count + 1) // 2, count // 2


def _width(anchor: Placement, side: str) -> float:
    return anchor.size[1] if side in ("front", "back") else anchor.size[0]


def side_places(anchor: Placement, side: str, count: int) -> list[Place]:
    """The middles of `count` equal stretches of one side between its legs."""
    width = _width(anchor, side) - 2 * LEG
    return [_place(anchor, side, width * ((i + 0.5) / count - 0.5)) for i in range(count)]


def _place(anchor: Placement, side: str, shift: float) -> Place:
    """A point of one side, `shift` from its middle [m]."""
    angle = math.radians(SIDES[side])
    half = (anchor.size[0] if side in ("front", "back") else anchor.size[1]) / 2
    c, s = round(math.cos(angle)), round(math.sin(angle))
    return Place((c * half - s * shift, s * half + c * shift), SIDES[side])
