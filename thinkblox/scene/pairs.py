"""The relations of one thing to one other: whether each holds, with what was measured. Metres and degrees.

Thresholds follow SceneEval (3dlg-hcvc/SceneEval) where it defines one; the others are the figures of interior-design
handbooks (Neufert, Time-Saver Standards).
"""

import math
from collections.abc import Callable
from dataclasses import replace

import shapely
from shapely import Point

from thinkblox.brief import RelationKind
from thinkblox.scene.bearings import CONTACT, angle_to, gap, gap_text, ground_gap, past_centre, shared
from thinkblox.scene.landmarks import Landmark
from thinkblox.scene.room import Room, turn_between

NEXT_TO = 0.5
"""Largest gap between things that are next to each other; SceneEval next_to."""
NEAR = 1.5
"""Largest gap between things that are near each other; SceneEval near. Also how far the four sides reach."""
ACROSS = (1.5, 4.0)
"""Gaps between things across the room from each other; SceneEval across."""
FAR = 4.0
"""A gap from which things are far from each other; SceneEval far."""
FAR_IN_SMALL, SMALL_ROOM = 2.0, 5.0
"""The same in a room whose diagonal is less than this."""
FACING, FACING_AWAY, ASIDE = 30.0, 45.0, 45.0
"""Largest angle between a front and what it faces, SceneEval face_to; between a back and what it is turned from; and by
which the nearer of two that are opposite each other looks past the other's middle."""
AGAINST_WALL = 0.3
"""Largest gap to a wall; SceneEval against_wall."""
ON_WALL = 0.01
"""Largest gap of a thing mounted on a wall or hung from the ceiling; SceneEval on_wall."""
ON_WALL_YAW = 60.0
"""So far at most the back of what hangs is turned from its wall [degrees]: its end may touch the next one."""
CORNER = 0.8
"""Largest distance of a footprint to its corner; SceneEval corner."""
SEAT_GAP = 0.4
"""Largest gap of a seat drawn up to a table; handbooks pull a chair out by 0.3 to 0.4 to sit down."""
CENTRE_SHARE = 0.25
"""Largest offset from the centre along each axis, as a share of the extent: the middle half."""
MIDDLE = 0.294
"""Largest offset from the middle of a thing; SceneEval middle_of, where its score is a half [m]."""
SCORE_OF_HALF = math.sqrt(2.0 * math.log(2.0))
"""Times the spread of SceneEval's middle of a room, which grows with the thing: where its score is a half."""
END_SHARE = 1 / 6
"""Smallest offset from the middle of what lies at one side of a top, as a share of its extent: the outer thirds."""
UNDER_SHARE = 0.2
"""Smallest share of the smaller footprint that lies under, for what is flat: a rug's under a bed that it frames."""
STOOD_ON = 1.0
"""Footprint of what would stand beside a rug, were less than half of it on that [m2]."""
UNDER_HALF, FLAT = 0.5, 0.05
"""The same for all that is higher than that [m]: a cabinet under a television."""
ABOVE_MARGIN = 0.15
"""How far beside the anchor's footprint a thing hung above may be: a sofa under a picture stands off the wall."""
NEARLY_ABOVE = 0.35
"""Beside the anchor's footprint, what is nearer than that would still be called above it [m]."""
INSIDE_SHARE = 0.5
"""Smallest share of a thing that is within the box around what it is inside of."""
SQUARE = 0.05
"""Sides that differ by no more than this share are equally long."""
ROUNDING = 1e-6

Finding = tuple[bool, str]
"""Whether it holds, and what was measured."""
Pair = Callable[[Landmark, Landmark], Finding]


def pair_for(kind: RelationKind, room: Room) -> Pair:
    """How a relation between two things is measured in a room."""
    return _far(room) if kind == "far" else _PAIRS[kind]


def denied_for(kind: RelationKind, room: Room) -> Pair:
    """The same where the relation must not hold: what comes close to holding counts as holding."""
    return _DENIED.get(kind) or pair_for(kind, room)


def every(findings: list[Finding]) -> Finding:
    """All must hold; the text is that of the failures, or of all."""
    failures = [f for f in findings if not f[0]]
    return not failures, "; ".join(dict.fromkeys(text for _, text in failures or findings))


def facing(subject: Landmark, anchor: Landmark) -> Finding:
    """Its front, or where one looks who uses it, points at the anchor."""
    if subject.front == "any":
        return True, f"{subject.name} faces every way"
    angle = angle_to(subject, anchor)
    return angle <= FACING + ROUNDING, f"front of {subject.name} {angle:.0f} degrees off {anchor.name}"


def _facing_away(subject: Landmark, anchor: Landmark) -> Finding:
    """Its back, or that of who uses it, points at the anchor."""
    if subject.front == "any":
        return True, f"{subject.name} has no back"
    angle = angle_to(replace(subject, gaze=subject.gaze + 180.0), anchor)
    return angle <= FACING_AWAY + ROUNDING, f"back of {subject.name} {angle:.0f} degrees off {anchor.name}"


def facing_each_other(one: Landmark, other: Landmark) -> Finding:
    """Both face the other."""
    return every([facing(one, other), facing(other, one)])


def side_taken(subject: Landmark, anchor: Landmark, *, long: bool) -> int:
    """Which of the two long (or short) sides of the anchor a thing is beside: 1, -1, or 0 for none of them."""
    x, y = anchor.to_local(subject.centre)
    hx, hy = anchor.half
    square = abs(hx - hy) <= SQUARE * max(hx, hy)
    for out, along, half, half_along, is_long in ((x, y, hx, hy, hy >= hx), (y, x, hy, hx, hx >= hy)):
        if (is_long == long or square) and abs(out) >= half - CONTACT and abs(along) <= half_along + CONTACT:
            return 1 if out > 0 else -1
    return 0


def _beside_side(*, long: bool) -> Pair:
    which = "long" if long else "short"

    def pair(subject: Landmark, anchor: Landmark) -> Finding:
        taken = side_taken(subject, anchor, long=long)
        where = f"{'at' if taken else 'not at'} a {which} side of {anchor.name}"
        text = f"gap {gap(subject, anchor):.2f} m, {subject.name} {where}"
        return bool(taken) and gap(subject, anchor) <= NEXT_TO + ROUNDING, text

    return pair


def _next_to(subject: Landmark, anchor: Landmark) -> Finding:
    beside = anchor.kind == "opening" or shared(subject, anchor) < 0.5
    close = gap(subject, anchor) <= NEXT_TO + ROUNDING
    return close and beside, f"{gap_text(subject, anchor)}{'' if beside else ', one over the other'}"


def _near(subject: Landmark, anchor: Landmark) -> Finding:
    return gap(subject, anchor) <= NEAR + ROUNDING, gap_text(subject, anchor)


def _far(room: Room) -> Pair:
    least = FAR_IN_SMALL if math.hypot(*room.extent) < SMALL_ROOM else FAR

    def pair(subject: Landmark, anchor: Landmark) -> Finding:
        return gap(subject, anchor) > least, f"{gap_text(subject, anchor)}; over {least:g} m is far in this room"

    return pair


def _on_side(x: int, y: int, reach: float) -> Pair:
    """Lies beyond one side of the anchor, in the anchor's frame, rather than past one of its corners.

    What hangs behind a desk that is drawn up to the wall hangs over its edge, no more than over a quarter of it, and
    not on another wall. What lies on the anchor is at that side of its top.
    """

    def pair(subject: Landmark, anchor: Landmark) -> Finding:
        local = anchor.to_local(subject.centre)
        if anchor.kind == "object" and _on(subject, anchor)[0]:
            along, extent = (local[0] * x, anchor.half[0] * 2) if x else (local[1] * y, anchor.half[1] * 2)
            text = f"{subject.name} {along:.2f} m from the middle of {anchor.name} to that side"
            return along >= extent * END_SHARE - ROUNDING, text
        forward, across = (local[0] * x, abs(local[1])) if x else (local[1] * y, abs(local[0]))
        half, half_across = anchor.half if x else anchor.half[::-1]
        beyond, past = forward - half, max(across - half_across, 0.0)
        over = subject.hung and not anchor.hung and (not x or _faces_from(subject, anchor, x))
        least = -half / 2 if over else -CONTACT
        aligned = beyond >= least and past <= max(beyond, 0.0) + CONTACT
        return aligned and ground_gap(subject, anchor) <= reach + ROUNDING, gap_text(subject, anchor)

    return pair


def _faces_from(subject: Landmark, anchor: Landmark, x: int) -> bool:
    """Whether something on a wall is at the front (1) or the back (-1) of the anchor by the way it looks."""
    return turn_between(subject.yaw, anchor.yaw + (180.0 if x > 0 else 0.0)) <= FACING_AWAY + ROUNDING


_BEFORE, _BEHIND = _on_side(1, 0, NEAR), _on_side(-1, 0, NEAR)


def _in_front_of(subject: Landmark, anchor: Landmark) -> Finding:
    """Before its front; a desk has its visitors before it too, on the side to which one looks who works at it.

    What is in front of a window or door stands by it, and before more of it than beside.
    """
    found = _BEFORE(subject, anchor)
    if anchor.kind == "opening":
        share, away = _along(subject, anchor), ground_gap(subject, anchor)
        before = away <= NEXT_TO + ROUNDING and share >= UNDER_HALF
        return found[0] and before, f"{found[1]}, {share:.0%} along it"
    if found[0] or anchor.gaze == anchor.yaw or subject.front == "any" or not facing(subject, anchor)[0]:
        return found
    visits, text = _BEHIND(subject, anchor)
    return visits, f"{text}, looking at who works there" if visits else found[1]


def _behind(subject: Landmark, anchor: Landmark) -> Finding:
    """Beyond its back; behind a desk is what who works there has behind them too: it looks at the desk as they do."""
    found = _BEHIND(subject, anchor)
    if found[0] or anchor.gaze == anchor.yaw or subject.front == "any" or not facing(subject, anchor)[0]:
        return found
    backs, text = _BEFORE(subject, anchor)
    return backs, f"{text}, behind who works there" if backs else found[1]


def _at(subject: Landmark, anchor: Landmark) -> Finding:
    faces, text = facing(subject, anchor)
    behind = anchor.gaze != anchor.yaw and anchor.to_local(subject.centre)[0] < -anchor.half[0]
    near = gap(subject, anchor) <= SEAT_GAP
    return faces and near and not behind, f"{gap_text(subject, anchor)}; {text}"


def _on(subject: Landmark, anchor: Landmark) -> Finding:
    if anchor.kind == "wall":
        aside = ground_gap(subject, anchor)
        hangs = subject.base > CONTACT
        turned = turn_between(subject.yaw, anchor.yaw) if subject.hung and subject.front == "one" else 0.0
        text = f"{subject.name} {aside:.2f} m from {anchor.name}" + ("" if hangs else ", on the floor")
        text += "" if turned <= ON_WALL_YAW else f", its back {turned:.0f} degrees off it"
        return aside <= ON_WALL + ROUNDING and hangs and turned <= ON_WALL_YAW, text
    if anchor.kind == "ceiling":
        lower = anchor.base - subject.top
        return abs(lower) <= ON_WALL + ROUNDING, f"top of {subject.name} {lower:.2f} m below {anchor.name}"
    over = anchor.footprint.covers(Point(subject.centre))
    lift = min((subject.base - height for height in (*anchor.carries, anchor.top)), key=abs)
    if not anchor.solid:
        lift = max(subject.base - anchor.top, 0.0)
    if not over:
        text = f"{subject.name} not over {anchor.name}, {ground_gap(subject, anchor):.2f} m from it"
    elif abs(lift) < 0.0005:
        text = f"{subject.name} on a surface of {anchor.name}"
    else:
        way = "above" if lift > 0 else "below"
        text = f"{subject.name} {abs(lift) * 1000:.0f} mm {way} a surface of {anchor.name}"
    return anchor.kind in ("object", "floor") and over and abs(lift) <= CONTACT + ROUNDING, text


def _inside(subject: Landmark, anchor: Landmark) -> Finding:
    """It rests on an inner surface of the anchor, or at least half of it is within the box around it and above one.

    What stands in a vessel reaches over its rim, as flowers do: there half of it over the vessel is enough.
    """
    if anchor.kind != "object" or not anchor.solid:
        return False, f"{anchor.name} has no inside"
    height = max(subject.top - subject.base, ROUNDING)
    within = max(0.0, min(subject.top, anchor.top) - max(subject.base, anchor.base)) / height
    if any(abs(subject.base - floor) <= CONTACT for floor in anchor.holds):
        within = 1.0
    area = subject.footprint.area
    within *= float(subject.footprint.intersection(anchor.footprint).area / area) if area > 0.0 else 0.0
    floor = min(anchor.holds, default=anchor.base + 2 * CONTACT if not anchor.carries else math.inf)
    text = f"{within:.0%} of {subject.name} within {anchor.name}"
    if math.isinf(floor):
        return False, f"{text}, which has no open inside"
    lift = subject.base - floor
    text += "" if lift >= -CONTACT - ROUNDING else f", {-lift:.2f} m below its inner floor"
    return within >= INSIDE_SHARE - ROUNDING and lift >= -CONTACT - ROUNDING, text


def _outside(subject: Landmark, anchor: Landmark) -> Finding:
    inside = anchor.footprint.covers(Point(subject.centre))
    low = subject.base <= 2 * CONTACT
    text = f"{subject.name} {ground_gap(subject, anchor):.2f} m from {anchor.name}"
    text += ("" if low else ", not on the floor") + (", over or in it" if inside else "")
    return low and not inside and ground_gap(subject, anchor) <= NEXT_TO + ROUNDING, text


def _back_to_back(subject: Landmark, anchor: Landmark) -> Finding:
    between = float(subject.edge((-1, 0)).distance(anchor.edge((-1, 0))))
    turn = turn_between(subject.yaw, anchor.yaw + 180.0)
    away = subject.to_local(anchor.centre)[0] < 0.0 and anchor.to_local(subject.centre)[0] < 0.0
    text = f"backs of {subject.name} and {anchor.name} {between:.2f} m apart, {turn:.0f} degrees off turned away"
    backs = "any" not in (subject.front, anchor.front)
    return backs and away and turn <= FACING + ROUNDING and between < NEXT_TO, text


def _above(subject: Landmark, anchor: Landmark) -> Finding:
    rise, aside = subject.base - anchor.top, anchor.footprint.distance(Point(subject.centre))
    text = f"{subject.name} {rise:.2f} m above {anchor.name}, {aside:.2f} m aside"
    return rise >= -CONTACT and aside <= ABOVE_MARGIN and _is_in_line(subject, anchor), text


def _is_in_line(subject: Landmark, anchor: Landmark) -> bool:
    """Whether the middle of what hangs on a wall is over the width of what stands before that."""
    across = [subject.to_local(corner)[1] for corner in anchor.footprint.convex_hull.boundary.coords]
    return not subject.hung or min(across) - ROUNDING <= 0.0 <= max(across) + ROUNDING


def _nearly_above(subject: Landmark, anchor: Landmark) -> Finding:
    rise, aside = subject.base - anchor.top, anchor.footprint.distance(subject.footprint)
    text = f"{subject.name} {rise:.2f} m above {anchor.name}, {aside:.2f} m aside"
    return rise >= -CONTACT and aside <= NEARLY_ABOVE, text


def _partly_under(subject: Landmark, anchor: Landmark) -> Finding:
    share, lower = shared(subject, anchor), subject.base <= anchor.base + CONTACT
    return lower and share > 0.0, f"{share:.0%} of {subject.name} under {anchor.name}"


def _under(subject: Landmark, anchor: Landmark) -> Finding:
    if anchor.kind == "opening" and subject.base < CONTACT:
        return _below_opening(subject, anchor)
    share = shared(subject, anchor if anchor.roof is None else replace(anchor, footprint=anchor.roof))
    flat = subject.top - subject.base <= FLAT
    least = UNDER_SHARE if flat or _along(subject, anchor) >= UNDER_HALF else UNDER_HALF
    least = UNDER_HALF if flat and anchor.kind == "object" and anchor.footprint.area <= STOOD_ON else least
    lower = subject.base <= anchor.base + CONTACT and subject.top <= (
        anchor.base + CONTACT if anchor.kind == "opening" else anchor.top
    )
    text = f"{subject.name} {'lower than' if lower else 'not lower than'} {anchor.name}, {share:.0%} shared"
    if not lower and anchor.kind == "opening":
        text = f"top of {subject.name} at {subject.top:.2f} m, sill of {anchor.name} at {anchor.base:.2f} m; {text}"
    return lower and share >= least, text


def _below_opening(subject: Landmark, anchor: Landmark) -> Finding:
    """At the wall of a window, before more of it than beside it, and no higher than its lower half."""
    away, share = ground_gap(subject, anchor), _along(subject, anchor)
    middle = (anchor.base + anchor.top) / 2
    text = f"{gap_text(subject, anchor)}, {share:.0%} along it"
    text += f", top at {subject.top:.2f} m, middle of {anchor.name} at {middle:.2f} m"
    return subject.top <= middle and away <= NEXT_TO + ROUNDING and share >= UNDER_HALF, text


def _along(subject: Landmark, anchor: Landmark) -> float:
    """How much of the narrower of the two the other covers, measured across the front of the anchor."""
    across = [anchor.to_local((x, y))[1] for x, y in shapely.get_coordinates(subject.footprint).tolist()]
    both = min(max(across), anchor.half[1]) - max(min(across), -anchor.half[1])
    narrower = min(max(across) - min(across), 2 * anchor.half[1])
    return max(0.0, both) / narrower if narrower > 0.0 else 0.0


def _against_wall(subject: Landmark, anchor: Landmark) -> Finding:
    sides = ((-1, 0),) if subject.front == "one" else ((-1, 0), (1, 0), (0, -1), (0, 1))
    gaps = [subject.edge(side).centroid.distance(anchor.footprint) for side in sides]
    what = "back" if subject.front == "one" else "side"
    return min(gaps) <= AGAINST_WALL + ROUNDING, f"{what} of {subject.name} {min(gaps):.2f} m from {anchor.name}"


def _close_to_wall(subject: Landmark, anchor: Landmark) -> Finding:
    aside = ground_gap(subject, anchor)
    return aside <= AGAINST_WALL + ROUNDING, f"{subject.name} {aside:.2f} m from {anchor.name}"


def _close_by(subject: Landmark, anchor: Landmark) -> Finding:
    return ground_gap(subject, anchor) <= NEXT_TO + ROUNDING, gap_text(subject, anchor)


def _in_corner(subject: Landmark, anchor: Landmark) -> Finding:
    aside = ground_gap(subject, anchor)
    return anchor.kind == "corner" and aside <= CORNER, f"{subject.name} {aside:.2f} m from the {anchor.name}"


def _in_centre(subject: Landmark, anchor: Landmark) -> Finding:
    """In the middle half of the room, of a wall's length, or of what carries it, and about the very middle of those."""
    holds, text = _about_centre(subject, anchor)
    x, y = anchor.to_local(subject.centre)
    return holds and (anchor.kind == "wall" or math.hypot(x, y) <= _off_centre(subject, anchor) + ROUNDING), text


def _off_centre(subject: Landmark, anchor: Landmark) -> float:
    """How far from the middle of a room or a thing the middle of something may be that is there [m]."""
    if anchor.kind == "object":
        return MIDDLE
    large, side = 2 * max(subject.half), sum(anchor.half)
    return SCORE_OF_HALF * (0.5 * large + 1.0 - large / side)


def _about_centre(subject: Landmark, anchor: Landmark) -> Finding:
    """In the middle half, be it away from the very middle."""
    x, y = (abs(offset) for offset in anchor.to_local(subject.centre))
    reach_x, reach_y = (AGAINST_WALL if half == 0.0 else half * 2 * CENTRE_SHARE for half in anchor.half)
    if anchor.kind == "wall":
        x = ground_gap(subject, anchor)
    text = f"{subject.name} {x:.2f} m and {y:.2f} m from the middle of {anchor.name}"
    middle = x <= reach_x + ROUNDING and y <= reach_y + ROUNDING
    if anchor.kind != "object":
        return middle, text
    carried, how = _on(subject, anchor)
    return middle and carried, text if carried else f"{text}; {how}"


def _opposite(subject: Landmark, anchor: Landmark) -> Finding:
    """In front of the anchor, well apart, and one looks at the other; what hangs on facing walls, however far."""
    ahead, _ = _on_side(1, 0, math.inf)(subject, anchor)
    turn = turn_between(subject.gaze, anchor.gaze + 180.0)
    if anchor.kind == "opening" and subject.gaze != subject.yaw:
        turn = min(angle_to(subject, anchor), 180.0 - angle_to(subject, anchor))
    elif "any" in (subject.front, anchor.front):
        turn = 0.0 if subject.front == "any" else angle_to(subject, anchor)
    elif "two" in (subject.front, anchor.front):
        turn = min(turn, 180.0 - turn)
    apart, aside = ground_gap(subject, anchor), 0.0
    if anchor.kind == "object" and not (subject.hung and anchor.hung):
        aside = min(past_centre(subject, anchor), past_centre(anchor, subject))
    if anchor.kind == "object" and turn >= 180.0 - FACING:
        turn = min(turn, angle_to(subject, anchor), angle_to(anchor, subject))  # One of them has its back to the other.
    text = f"{subject.name} {apart:.2f} m from {anchor.name}, {max(turn, aside):.0f} degrees off facing it"
    least, most = ACROSS
    if subject.hung and anchor.hung:
        most = math.inf
    facing_it = turn <= FACING + ROUNDING and aside <= ASIDE + ROUNDING
    return ahead and least - ROUNDING <= apart <= most + ROUNDING and facing_it, text


def _over_against(subject: Landmark, anchor: Landmark) -> Finding:
    """What would still be called opposite, however far: before the anchor, and one turned to the other."""
    ahead, _ = _on_side(1, 0, math.inf)(subject, anchor)
    angle = min(angle_to(subject, anchor), angle_to(anchor, subject))
    text = f"{subject.name} {ground_gap(subject, anchor):.2f} m from {anchor.name}, {angle:.0f} degrees off facing it"
    return ahead and angle <= FACING + ROUNDING, text


_PAIRS: dict[RelationKind, Pair] = {
    "on": _on,
    "inside": _inside,
    "outside": _outside,
    "above": _above,
    "under": _under,
    "next_to": _next_to,
    "near": _near,
    "left_of": _on_side(0, 1, NEAR),
    "right_of": _on_side(0, -1, NEAR),
    "in_front_of": _in_front_of,
    "behind": _behind,
    "at_foot_of": _on_side(1, 0, NEXT_TO),
    "at_long_side": _beside_side(long=True),
    "at_short_side": _beside_side(long=False),
    "back_to_back": _back_to_back,
    "at": _at,
    "facing": facing,
    "facing_away": _facing_away,
    "opposite": _opposite,
    "against_wall": _against_wall,
    "in_corner": _in_corner,
    "in_centre": _in_centre,
}
_DENIED: dict[RelationKind, Pair] = {
    "against_wall": _close_to_wall,
    "next_to": _close_by,
    "opposite": _over_against,
    "above": _nearly_above,
    "under": _partly_under,
    "in_centre": _about_centre,
}
