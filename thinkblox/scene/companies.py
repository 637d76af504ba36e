"""The relations that several things have together: around, between, in rows, spread over sides, walls or corners."""

import math
from itertools import combinations, pairwise

from shapely import Point, unary_union

from thinkblox.scene.bearings import bearing, gap, ground_gap, place_of
from thinkblox.scene.landmarks import Landmark
from thinkblox.scene.pairs import ROUNDING, Finding, Pair, every, facing, side_taken
from thinkblox.scene.room import turn_between
from thinkblox.value import Vec2

AROUND_GAP = 0.6
"""Largest gap of a seat that belongs to a table, pulled out to stand up; handbooks."""
AROUND_TWO = 60.0
"""Smallest angle between two that are around something: they are at different sides of it."""
ROW_WIDTH = 0.2
"""How far members of a row may be out of line."""
ROW_SPACING = 0.15
"""How far spacings of a row may differ from their mirror image (an aisle in the middle is fine)."""
ROW_YAW = 10.0
"""How far members of a row may be turned against each other."""


def around(members: list[Landmark], anchors: list[Landmark]) -> Finding:
    """Every anchor has those about it for which it is the nearest."""
    return every([_around(group, anchor) for anchor, group in _by_nearest(members, anchors)])


def at_sides(members: list[Landmark], anchors: list[Landmark], *, long: bool, pair: Pair) -> Finding:
    """Each is at a long (or short) side of the nearest anchor, and both sides have as many, give or take one."""
    return every([_at_sides(group, anchor, long, pair) for anchor, group in _by_nearest(members, anchors) if group])


def _at_sides(members: list[Landmark], anchor: Landmark, long: bool, pair: Pair) -> Finding:
    findings = [pair(member, anchor) for member in members]
    sides = [side_taken(member, anchor, long=long) for member in members]
    first, second = sides.count(1), sides.count(-1)
    which = "long" if long else "short"
    even = (abs(first - second) <= 1, f"{first} and {second} at the two {which} sides of {anchor.name}")
    return every([*findings, even])


def _by_nearest(members: list[Landmark], anchors: list[Landmark]) -> list[tuple[Landmark, list[Landmark]]]:
    groups: dict[str, list[Landmark]] = {anchor.name: [] for anchor in anchors}
    for member in members:
        groups[min(anchors, key=lambda a: gap(member, a)).name].append(member)
    return [(anchor, groups[anchor.name]) for anchor in anchors]


def over_so_many(members: list[Landmark], parts: list[Landmark], pair: Pair, number: int) -> Finding:
    """Each has the relation to one of the walls or corners, and they have it to so many different ones together."""
    findings, taken = [], set()
    for member in members:
        near_first = sorted(parts, key=lambda part: ground_gap(member, part))
        held = next((part for part in near_first if pair(member, part)[0]), None)
        findings.append(pair(member, held or near_first[0]))
        taken |= {held.name} if held else set()
    names = ", ".join(sorted(taken)) or "none"
    return every([*findings, (len(taken) == number, f"at {len(taken)} of {number} different ones: {names}")])


def on_one(members: list[Landmark], parts: list[Landmark], pair: Pair) -> Finding:
    """All have the relation to one and the same of the walls."""
    findings = [every([pair(member, part) for member in members]) for part in parts]
    return next((found for found in findings if found[0]), findings[0])


def _around(members: list[Landmark], anchor: Landmark) -> Finding:
    if not members:
        return False, f"nothing around {anchor.name}"
    bearings = sorted(math.degrees(math.atan2(y, x)) for x, y in (anchor.to_local(m.centre) for m in members))
    gaps = [b - a for a, b in pairwise(bearings)] + [bearings[0] + 360.0 - bearings[-1]]
    limit = {1: 360.0, 2: 360.0 - AROUND_TWO}.get(len(members), 180.0)
    far = max(gap(m, anchor) for m in members)
    astray = [m.name for m in members if not facing(m, anchor)[0]]
    text = f"{len(members)} around {anchor.name}, at most {far:.2f} m off, widest gap {max(gaps):.0f} degrees"
    text += f"; {', '.join(astray)} not facing it" if astray else ""
    return max(gaps) <= limit + 1.0 and far <= AROUND_GAP + ROUNDING and not astray, text


def between(subject: Landmark, anchors: list[Landmark]) -> Finding:
    """Its centre is in what the anchors span together, give or take its own half depth, and in none of them."""
    others = [a for a in anchors if a.name != subject.name]
    names = ", ".join(a.name for a in others)
    if len(others) < 2:
        return False, f"there is only {names or 'nothing'} to be between"
    centre = Point(subject.centre)
    off = unary_union([place_of(a) for a in others]).convex_hull.distance(centre)
    inside = [a.name for a in others if a.kind == "object" and a.footprint.covers(centre)]
    text = f"{subject.name} {off:.2f} m out of the space between {names}"
    text += f"; within {', '.join(inside)}" if inside else ""
    return off <= min(subject.half) and not inside, text


def in_rows(members: list[Landmark], rows: int) -> Finding:
    """Some direction, of a member's frame or to its neighbour, splits all into straight, evenly spaced lines."""
    if len(members) < 2:
        return False, "one thing makes no row"
    turned = max(turn_between(a.yaw, b.yaw, period=180.0) for a, b in combinations(members, 2))
    if turned > ROW_YAW and members[0].front != "any":
        return False, f"turned by {turned:.0f} degrees against each other"
    nearest = min(members[1:], key=lambda m: math.dist(m.centre, members[0].centre))
    turns = (members[0].yaw + 90.0, members[0].yaw, bearing(members[0].centre, nearest.centre))
    findings = [_rows_along([m.centre for m in members], math.radians(turn), rows) for turn in turns]
    return next((f for f in findings if f[0]), findings[0])


def _rows_along(centres: list[Vec2], turn: float, rows: int) -> Finding:
    cos, sin = math.cos(turn), math.sin(turn)
    placed = sorted((y * cos - x * sin, x * cos + y * sin) for x, y in centres)
    lines: list[list[tuple[float, float]]] = [[placed[0]]]
    for before, point in pairwise(placed):
        if point[0] - before[0] > ROW_WIDTH:
            lines.append([])
        lines[-1].append(point)
    width = max(line[-1][0] - line[0][0] for line in lines)
    uneven = max(_unevenness([along for _, along in line]) for line in lines)
    count = len(lines) == rows if rows else len(centres) >= 2 * len(lines)
    text = f"{len(lines)} rows of {', '.join(str(len(line)) for line in lines)}, {width:.2f} m out of line, "
    text += f"spacing uneven by {uneven:.2f} m"
    return count and width <= ROW_WIDTH + ROUNDING and uneven <= ROW_SPACING + ROUNDING, text


def _unevenness(stations: list[float]) -> float:
    spacings = [b - a for a, b in pairwise(sorted(stations))]
    return max((abs(a - b) for a, b in zip(spacings, reversed(spacings), strict=True)), default=0.0)
