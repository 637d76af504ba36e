"""Relations between objects, as rules over the judge's own geometry.

The ranges are SceneEval's (3dlg-hcvc/SceneEval, `spatial/config.py`). SceneEval lets a score fall off beyond them and
accepts half of it, which makes 0.5 m into 0.79; here the range itself is the line. Left and right are the anchor's own,
as somebody says who sits in it.
"""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from shapely import LineString, Point, Polygon

from thinkblox.evaluation.bodies import Body, distance, share_within
from thinkblox.evaluation.relation_words import ObjectRule
from thinkblox.evaluation.resting import is_in, is_over, lies_on_or_board
from thinkblox.evaluation.ruling import Ruling
from thinkblox.evaluation.vocabulary import load_vocabulary
from thinkblox.evaluation.walls import Enclosure

NEXT_TO = 0.5
"""Largest distance between two things that are next to each other [m]."""
NEAR = 1.5
"""Largest distance between two things that are near each other [m]."""
ACROSS = (NEAR, 4.0)
"""Distances of things across from each other [m]."""
FAR, FAR_IN_SMALL = 4.0, 2.0
"""Least distance of things far from each other, and in rooms in which they cannot be that far apart [m]."""
FACING = 30.0
"""By how much a front may point past what it faces [degrees]."""
OPPOSITE = 45.0
"""By how much one of two things may point past the other that are opposite each other [degrees]."""
BESIDE = 2.5
"""How far from an anchor something may be that is in front of it, behind it, or to its left or right [m]."""
AT_TABLE = 1.0
"""How far from an anchor something may be that is at its long or short side [m]."""
MIDDLE = 0.294
"""How far from the middle of an anchor the middle of what is in it may be: where SceneEval's score is a half [m]."""
SQUARE = 0.01
"""Share by which sides must differ to be long and short."""
MAJORITY = 0.5
EXACT = 1e-6
"""What a distance may miss a range by: files are written to the micrometre [m]."""
OPEN_SIDE = 200.0
"""Widest gap between neighbours round an anchor [degrees]: three seats round a table may leave one side open."""
_FAN = 9

Rule = Callable[[Body, Body, Enclosure], Ruling]


def holds(rule: ObjectRule, anchor: Body, subjects: Sequence[Body], room: Enclosure) -> Ruling:
    """Whether the subjects stand in a relation to the anchor: all of them, or together where they surround it."""
    if rule == "surround":
        return _surround(anchor, subjects)
    found = [_RULES[rule](anchor, subject, room) for subject in subjects]
    return Ruling(all(f.holds for f in found), "; ".join(f.says for f in found))


def _next_to(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    return _within(distance(anchor, subject), 0.0, NEXT_TO)


def _near(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    return _within(distance(anchor, subject), 0.0, NEAR)


def _far(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    widest = room.diagonal - 2 * max(anchor.half) - 2 * max(subject.half)
    return _within(distance(anchor, subject), FAR if widest > FAR else FAR_IN_SMALL, math.inf)


def _within(apart: float, least: float, most: float) -> Ruling:
    return Ruling(least - EXACT <= apart <= most + EXACT, f"{apart:.2f} m apart")


def _across_from(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    apart = _within(distance(anchor, subject), *ACROSS)
    off = min(_deviation(anchor, subject), _deviation(subject, anchor))
    return Ruling(apart.holds and off <= OPPOSITE, f"{apart.says}, the nearer front {off:.0f} degrees off")


def _face_to(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    """A desk faces what is before who sits at it, over its back."""
    off = _one_way(subject, anchor, -1.0) if subject.asset.gaze == "back" else _deviation(subject, anchor)
    return Ruling(off <= FACING, f"front {off:.0f} degrees off")


def _deviation(who: Body, what: Body) -> float:
    """By how much the front of one object points past another [degrees].

    As in SceneEval, straight lines from all over the object to its front count where they meet the other; besides, the
    line from its middle to the other's middle does.
    """
    if who.asset.front == "any":
        return 0.0
    turns = (1.0, -1.0) if who.asset.front == "two" else (1.0,)
    return min(_one_way(who, what, turn) for turn in turns)


def _one_way(who: Body, what: Body, turn: float) -> float:
    (fx, fy), reach = who.facing(), 1000.0
    front = (fx * turn, fy * turn)
    met: list[Point] = []
    for k in range(_FAN):
        start = who.to_room((0.0, who.half[1] * (2 * k / (_FAN - 1) - 1)))
        line = LineString([start, (start[0] + front[0] * reach, start[1] + front[1] * reach)])
        hit = line.intersection(what.footprint)
        if not hit.is_empty:
            met.append(Point(min(hit.coords, key=lambda c: math.dist(c, start))))
    goals = [what.centre]
    if met:
        goals.append((sum(p.x for p in met) / len(met), sum(p.y for p in met) / len(met)))
    return min(_angle(front, (g[0] - who.centre[0], g[1] - who.centre[1])) for g in goals)


def _angle(a: tuple[float, float], b: tuple[float, float]) -> float:
    return abs(math.degrees(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])))


def _side(name: str) -> Rule:
    """A rule for one side of the anchor: most of the subject lies in what opens like a fan from that side.

    Behind a desk is also who sits at it, whose side is the desk's front.
    """

    def rule(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
        own = anchor.to_own(subject.footprint)
        shares = {side: share_within(own, _fan(anchor, side)) for side in _SIDES}
        if name == "back" and anchor.asset.gaze == "back" and _deviation(subject, anchor) <= FACING:
            shares["back"] = max(shares["front"], shares["back"])
        best = max(shares, key=lambda side: shares[side])
        where = f"most of it {_SIDES[best]}" if shares[best] > MAJORITY else "on no side within 2.5 m"
        return Ruling(shares[name] > MAJORITY, f"{shares[name]:.0%} of it {_SIDES[name]}, {where}".replace("%", " %"))

    return rule


_SIDES = {"front": "in front", "back": "behind", "left": "to its left", "right": "to its right"}


def _fan(anchor: Body, side: str) -> Polygon:
    """What lies on a side of the anchor, in its own frame: from half-way to its edge, widening by 45 degrees outside.

    A chair that is drawn up to a desk stands partly within the desk's outline.
    """
    depth, width = anchor.half if side in ("front", "back") else anchor.half[::-1]
    near, out, broad = depth / 2, depth + BESIDE, 1.25 * width
    half = [(near, broad), (depth, broad), (out, broad + BESIDE)]
    corners = [*((a, -b) for a, b in half), *reversed(half)]
    sign = 1.0 if side in ("front", "left") else -1.0
    turned = [(a * sign, b) if side in ("front", "back") else (b, a * sign) for a, b in corners]
    return Polygon(turned)


def _long_or_short(long: bool) -> Rule:
    def rule(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
        (hx, hy), own = anchor.half, anchor.to_own(Point(subject.centre)).coords[0]
        if abs(hx - hy) <= SQUARE * max(hx, hy):
            return Ruling(False, "the sides are equal")
        beyond = (abs(own[0]) - hx, abs(own[1]) - hy)
        at_long = beyond[1] > beyond[0] if hx > hy else beyond[0] > beyond[1]
        gap = float(anchor.footprint.distance(subject.footprint))
        says = f"at a {'long' if at_long else 'short'} side, {gap:.2f} m off"
        return Ruling(at_long == long and gap <= AT_TABLE, says)

    return rule


def _on_top(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    return lies_on_or_board(subject, anchor, load_vocabulary())


def _inside_of(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    return is_in(subject, anchor, load_vocabulary())


def _outside_of(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    found = is_in(subject, anchor, load_vocabulary())
    return Ruling(not found.holds, found.says)


def _above(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    return is_over(subject, anchor)


def _under(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    return is_over(anchor, subject)


def _middle_of(anchor: Body, subject: Body, room: Enclosure) -> Ruling:
    off = math.dist(anchor.centre, subject.centre)
    return Ruling(off <= MIDDLE, f"{off:.2f} m from the middle")


def _surround(anchor: Body, subjects: Sequence[Body]) -> Ruling:
    """SceneEval's score: equal distances make one half of it, equal angles between neighbours the other.

    Alone, it takes a crowd on one side to surround; so no side may be open.
    """
    if len(subjects) < 2:
        return Ruling(False, "one thing surrounds nothing")
    x, y = anchor.centre
    away = [math.dist(anchor.centre, s.centre) for s in subjects]
    turns = sorted(math.degrees(math.atan2(s.centre[1] - y, s.centre[0] - x)) % 360.0 for s in subjects)
    gaps = [b - a for a, b in pairwise([*turns, turns[0] + 360.0])]
    usual, ideal = sorted(away)[len(away) // 2], 360.0 / len(subjects)
    even = sum((1 - min(1.0, abs(a - usual) / usual)) ** 2 if usual > 0 else 0.0 for a in away) / len(away)
    round_about = sum((1 - min(1.0, abs(gap - ideal) / ideal)) ** 2 for gap in gaps) / len(gaps)
    score = (even + round_about) / 2
    near = max(distance(anchor, s) for s in subjects) <= NEAR
    says = f"{len(subjects)} round it with a score of {score:.2f}, the widest gap {max(gaps):.0f} degrees"
    return Ruling(score > MAJORITY and near and max(gaps) <= OPEN_SIDE, says)


_RULES: dict[ObjectRule, Rule] = {
    "next_to": _next_to,
    "near": _near,
    "across_from": _across_from,
    "far": _far,
    "face_to": _face_to,
    "left_of": _side("left"),
    "right_of": _side("right"),
    "front_of": _side("front"),
    "back_of": _side("back"),
    "long_side_of": _long_or_short(long=True),
    "short_side_of": _long_or_short(long=False),
    "on_top": _on_top,
    "inside_of": _inside_of,
    "outside_of": _outside_of,
    "under": _under,
    "above": _above,
    "middle_of": _middle_of,
}
