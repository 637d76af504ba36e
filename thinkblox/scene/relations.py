"""Whether a relation of a brief holds in a scene: geometry over footprints and heights, with what was measured.

Thresholds follow SceneEval (3dlg-hcvc/SceneEval) where it defines one; the others are the figures of interior-design
handbooks (Neufert, Time-Saver Standards). Metres and degrees.
"""

import math
from collections.abc import Callable, Sequence
from itertools import combinations, pairwise

from shapely import LineString, Point, unary_union
from shapely.geometry.base import BaseGeometry
from shapely.ops import nearest_points

from thinkblox.brief import RelationKind
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.landmarks import Landmark, corners, things
from thinkblox.scene.room import turn_between
from thinkblox.value import Vec2
from thinkblox.verdict import RelationResult

NEXT_TO = 0.5
"""Largest gap between things that are next to each other; SceneEval next_to."""
NEAR = 1.5
"""Largest gap between things that are near each other; SceneEval near. Also how far left and right reach."""
ACROSS = 4.0
"""How far in front of and behind reach; SceneEval across ends there."""
OPPOSITE = 1.5
"""Smallest gap between things across the room from each other; SceneEval across begins there."""
OPPOSITE_SHARE = 0.2
"""The same as a share of the room's smaller extent, for rooms where 1.5 m is not to be had."""
FACING = 30.0
"""Largest angle between a front and the direction to what it faces; SceneEval face_to."""
AGAINST_WALL = 0.3
"""Largest gap to a wall; SceneEval against_wall."""
ON_WALL = 0.01
"""Largest gap of a thing mounted on a wall; SceneEval on_wall."""
CORNER = 0.8
"""Largest distance of a footprint to its corner; SceneEval corner."""
CONTACT = 0.01
"""Largest gap between a thing and what carries it; SceneEval support."""
SEAT_GAP = 0.4
"""Largest gap of a seat drawn up to a table; handbooks pull a chair out by 0.3 to 0.4 to sit down."""
AROUND_GAP = 0.6
"""Largest gap of a seat that belongs to a table, pulled out to stand up; handbooks."""
AROUND_TWO = 60.0
"""Smallest angle between two that are around something: they are at different sides of it."""
CENTRE_SHARE = 0.25
"""Largest offset from the centre along each axis, as a share of the extent: the middle half."""
UNDER_SHARE = 0.2
"""Smallest share of the smaller footprint that lies under, as a rug's under a bed that it frames."""
ABOVE_MARGIN = 0.15
"""How far beside the anchor's footprint a thing hung above may be: a sofa under a picture stands off the wall."""
ROW_WIDTH = 0.2
"""How far members of a row may be out of line."""
ROW_SPACING = 0.15
"""How far spacings of a row may differ from their mirror image (an aisle in the middle is fine)."""
ROW_YAW = 10.0
"""How far members of a row may be turned against each other."""
_ROUNDING = 1e-6

_Finding = tuple[bool, str]


def measure(
    scene: Arrangement,
    kind: RelationKind,
    subject: str | Sequence[str],
    anchors: Sequence[str],
    *,
    rows: int = 0,
    each: bool = False,
) -> RelationResult:
    """Measure whether `subject` stands in a relation to `anchors`.

    Args:
        scene: where.
        kind: which relation.
        subject: one id, or the ids of all members of a request: each of them must hold.
        anchors: ids, Places, names of walls or ids of openings. Several subjects without anchors are measured against
            each other (and face each other when both do). A relation between two things holds when it holds for any
            one anchor; "between" takes them together.
        rows: for "in_rows", how many; 0 for any number.
        each: every anchor, or every corner, needs a subject of its own as well.

    Returns:
        Also for what is not in the scene: the relation does not hold then, and `measured` says what is missing.
    """
    subjects = (subject,) if isinstance(subject, str) else tuple(subject)
    against = tuple(anchors) or _DEFAULT_ANCHOR.get(kind, subjects[1:] and subjects)
    found = {name: things(scene, name) for name in (*subjects, *against)}
    absent = [name for name, parts in found.items() if not parts]
    if absent or not subjects:
        holds, text = False, f"{', '.join(absent) or 'the subject'} is not in the room"
    else:
        members = [found[name][0] for name in subjects]
        parts = [part for name in against for part in found[name]]
        if kind == "in_corner":
            parts = list(corners(scene.room, against))
        holds, text = _measure_all(scene, kind, members, parts, rows, each)
    return RelationResult(kind=kind, subject=", ".join(subjects), anchors=tuple(anchors), holds=holds, measured=text)


_DEFAULT_ANCHOR = {"against_wall": ("wall",), "in_corner": ("corner",), "in_centre": ("centre",)}


def _measure_all(
    scene: Arrangement, kind: RelationKind, members: list[Landmark], anchors: list[Landmark], rows: int, each: bool
) -> _Finding:
    if kind == "in_rows":
        return _in_rows(members, rows)
    if not anchors:
        return False, "the relation names nothing to measure against"
    if kind == "around":
        return _around_all(members, anchors)
    if kind == "between":
        return _every([_between(member, anchors) for member in members])
    pair = _across(scene) if kind == "opposite" else _PAIRS[kind]
    if kind == "facing" and anchors == members:
        pair = _facing_each_other
    findings = [_best(pair, member, anchors) for member in members]
    if each:
        findings += [_best(lambda a, m: pair(m, a), anchor, members) for anchor in anchors]
    return _every(findings)


def _best(pair: Callable[[Landmark, Landmark], _Finding], one: Landmark, others: list[Landmark]) -> _Finding:
    """The finding against the nearest of the others for which it holds, else against the nearest."""
    near_first = sorted((o for o in others if o.name != one.name), key=lambda o: one.footprint.distance(o.footprint))
    findings = [pair(one, other) for other in near_first]
    return next((f for f in findings if f[0]), findings[0] if findings else (False, "there is no other"))


def _every(findings: list[_Finding]) -> _Finding:
    """All must hold; the text is that of the failures, or of all."""
    failures = [f for f in findings if not f[0]]
    return not failures, "; ".join(dict.fromkeys(text for _, text in failures or findings))


def _next_to(subject: Landmark, anchor: Landmark) -> _Finding:
    gap = _gap(subject, anchor)
    beside = anchor.kind == "opening" or _shared(subject, anchor) < 0.5
    return gap <= NEXT_TO and beside, f"{_gap_text(subject, anchor)}{'' if beside else ', one over the other'}"


def _near(subject: Landmark, anchor: Landmark) -> _Finding:
    return _gap(subject, anchor) <= NEAR, _gap_text(subject, anchor)


def _on_side(x: int, y: int, reach: float) -> Callable[[Landmark, Landmark], _Finding]:
    """Lies beyond one side of the anchor, in the anchor's frame, rather than past one of its corners."""

    def pair(subject: Landmark, anchor: Landmark) -> _Finding:
        local = anchor.to_local(subject.centre)
        forward, across = (local[0] * x, abs(local[1])) if x else (local[1] * y, abs(local[0]))
        half, half_across = anchor.half if x else anchor.half[::-1]
        if anchor.front == "two":
            forward = abs(forward)
        beyond, past = forward - half, max(across - half_across, 0.0)
        aligned = anchor.front == "any" or (beyond >= -CONTACT and past <= max(beyond, 0.0) + CONTACT)
        return aligned and _gap(subject, anchor) <= reach, _gap_text(subject, anchor)

    return pair


def _facing(subject: Landmark, anchor: Landmark) -> _Finding:
    if subject.front == "any":
        return True, f"{subject.name} faces every way"
    angle = _angle_to(subject, anchor)
    return angle <= FACING + _ROUNDING, f"front of {subject.name} {angle:.0f} degrees off {anchor.name}"


def _facing_each_other(one: Landmark, other: Landmark) -> _Finding:
    return _every([_facing(one, other), _facing(other, one)])


def _at(subject: Landmark, anchor: Landmark) -> _Finding:
    faces, text = _facing(subject, anchor)
    behind = anchor.gaze != anchor.yaw and anchor.to_local(subject.centre)[0] < -anchor.half[0]
    near = _gap(subject, anchor) <= SEAT_GAP
    return faces and near and not behind, f"{_gap_text(subject, anchor)}; {text}"


def _on(subject: Landmark, anchor: Landmark) -> _Finding:
    if anchor.kind == "wall":
        gap = _gap(subject, anchor)
        hangs = subject.base > CONTACT
        text = f"{subject.name} {gap:.2f} m from {anchor.name}" + ("" if hangs else ", on the floor")
        return gap <= ON_WALL + _ROUNDING and hangs, text
    over = anchor.footprint.covers(Point(subject.centre))
    lift = min((subject.base - height for height in (*anchor.carries, anchor.top)), key=abs)
    if not anchor.solid:
        lift = max(subject.base - anchor.top, 0.0)
    text = f"{subject.name} {lift * 1000:.0f} mm above a surface of {anchor.name}" + ("" if over else ", not over it")
    return anchor.kind in ("object", "floor") and over and abs(lift) <= CONTACT + _ROUNDING, text


def _above(subject: Landmark, anchor: Landmark) -> _Finding:
    rise, aside = subject.base - anchor.top, anchor.footprint.distance(Point(subject.centre))
    text = f"{subject.name} {rise:.2f} m above {anchor.name}, {aside:.2f} m aside"
    return rise >= -CONTACT and aside <= ABOVE_MARGIN, text


def _under(subject: Landmark, anchor: Landmark) -> _Finding:
    share = _shared(subject, anchor)
    lower = subject.base <= anchor.base + CONTACT and subject.top <= (
        anchor.base + CONTACT if anchor.kind == "opening" else anchor.top
    )
    text = f"{subject.name} {'lower than' if lower else 'not lower than'} {anchor.name}, {share:.0%} shared"
    return lower and share >= UNDER_SHARE, text


def _against_wall(subject: Landmark, anchor: Landmark) -> _Finding:
    sides = ((-1, 0),) if subject.front == "one" else ((-1, 0), (1, 0), (0, -1), (0, 1))
    gaps = [subject.edge(side).centroid.distance(anchor.footprint) for side in sides]
    what = "back" if subject.front == "one" else "side"
    return min(gaps) <= AGAINST_WALL + _ROUNDING, f"{what} of {subject.name} {min(gaps):.2f} m from {anchor.name}"


def _in_corner(subject: Landmark, anchor: Landmark) -> _Finding:
    gap = _gap(subject, anchor)
    return anchor.kind == "corner" and gap <= CORNER, f"{subject.name} {gap:.2f} m from the {anchor.name}"


def _in_centre(subject: Landmark, anchor: Landmark) -> _Finding:
    x, y = (abs(offset) for offset in anchor.to_local(subject.centre))
    inside = x <= anchor.half[0] * 2 * CENTRE_SHARE and y <= anchor.half[1] * 2 * CENTRE_SHARE
    return inside, f"{subject.name} {x:.2f} m and {y:.2f} m from the middle of {anchor.name}"


def _across(scene: Arrangement) -> Callable[[Landmark, Landmark], _Finding]:
    """Opposite, in a room of this size: in front of the anchor, fronts against each other, well apart."""
    in_front = _on_side(1, 0, math.inf)
    apart = min(OPPOSITE, OPPOSITE_SHARE * min(scene.room.extent))

    def pair(subject: Landmark, anchor: Landmark) -> _Finding:
        ahead, _ = in_front(subject, anchor)
        turn = turn_between(subject.gaze, anchor.gaze + 180.0)
        if "any" in (subject.front, anchor.front):
            turn = 0.0 if subject.front == "any" else _angle_to(subject, anchor)
        elif "two" in (subject.front, anchor.front):
            turn = min(turn, 180.0 - turn)
        gap = math.dist(subject.centre, anchor.centre) if anchor.kind == "opening" else _gap(subject, anchor)
        text = f"{subject.name} {gap:.2f} m from {anchor.name}, {turn:.0f} degrees off facing it"
        return ahead and gap >= apart and turn <= FACING + _ROUNDING, text

    return pair


def _around_all(members: list[Landmark], anchors: list[Landmark]) -> _Finding:
    """Every anchor has those about it for which it is the nearest."""
    groups: dict[str, list[Landmark]] = {anchor.name: [] for anchor in anchors}
    for member in members:
        groups[min(anchors, key=lambda a: _gap(member, a)).name].append(member)
    return _every([_around(groups[anchor.name], anchor) for anchor in anchors])


def _around(members: list[Landmark], anchor: Landmark) -> _Finding:
    if not members:
        return False, f"nothing around {anchor.name}"
    bearings = sorted(math.degrees(math.atan2(y, x)) for x, y in (anchor.to_local(m.centre) for m in members))
    gaps = [b - a for a, b in pairwise(bearings)] + [bearings[0] + 360.0 - bearings[-1]]
    limit = {1: 360.0, 2: 360.0 - AROUND_TWO}.get(len(members), 180.0)
    far = max(_gap(m, anchor) for m in members)
    astray = [m.name for m in members if not _facing(m, anchor)[0]]
    text = f"{len(members)} around {anchor.name}, at most {far:.2f} m off, widest gap {max(gaps):.0f} degrees"
    text += f"; {', '.join(astray)} not facing it" if astray else ""
    return max(gaps) <= limit + 1.0 and far <= AROUND_GAP + _ROUNDING and not astray, text


def _between(subject: Landmark, anchors: list[Landmark]) -> _Finding:
    """Its centre is in what the anchors span together, give or take its own half depth, and in none of them."""
    others = [a for a in anchors if a.name != subject.name]
    names = ", ".join(a.name for a in others)
    if len(others) < 2:
        return False, f"there is only {names or 'nothing'} to be between"
    centre = Point(subject.centre)
    off = unary_union([a.edge((1, 0)) if a.kind == "opening" else a.footprint for a in others]).convex_hull.distance(
        centre
    )
    inside = [a.name for a in others if a.kind == "object" and a.footprint.covers(centre)]
    text = f"{subject.name} {off:.2f} m out of the space between {names}"
    text += f"; within {', '.join(inside)}" if inside else ""
    return off <= min(subject.half) and not inside, text


def _in_rows(members: list[Landmark], rows: int) -> _Finding:
    """Some direction, of a member's frame or to its neighbour, splits all into straight, evenly spaced lines."""
    if len(members) < 2:
        return False, "one thing makes no row"
    turned = max(turn_between(a.yaw, b.yaw, period=180.0) for a, b in combinations(members, 2))
    if turned > ROW_YAW and members[0].front != "any":
        return False, f"turned by {turned:.0f} degrees against each other"
    nearest = min(members[1:], key=lambda m: math.dist(m.centre, members[0].centre))
    turns = (members[0].yaw + 90.0, members[0].yaw, _bearing(members[0].centre, nearest.centre))
    findings = [_rows_along([m.centre for m in members], math.radians(turn), rows) for turn in turns]
    return next((f for f in findings if f[0]), findings[0])


def _rows_along(centres: list[Vec2], turn: float, rows: int) -> _Finding:
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
    return count and width <= ROW_WIDTH + _ROUNDING and uneven <= ROW_SPACING + _ROUNDING, text


def _unevenness(stations: list[float]) -> float:
    spacings = [b - a for a, b in pairwise(sorted(stations))]
    return max((abs(a - b) for a, b in zip(spacings, reversed(spacings), strict=True)), default=0.0)


_PAIRS: dict[RelationKind, Callable[[Landmark, Landmark], _Finding]] = {
    "on": _on,
    "above": _above,
    "under": _under,
    "next_to": _next_to,
    "near": _near,
    "left_of": _on_side(0, 1, NEAR),
    "right_of": _on_side(0, -1, NEAR),
    "in_front_of": _on_side(1, 0, ACROSS),
    "behind": _on_side(-1, 0, ACROSS),
    "at_foot_of": _on_side(1, 0, NEXT_TO),
    "at": _at,
    "facing": _facing,
    "against_wall": _against_wall,
    "in_corner": _in_corner,
    "in_centre": _in_centre,
}


def _gap(subject: Landmark, anchor: Landmark) -> float:
    return float(subject.footprint.distance(anchor.footprint))


def _gap_text(subject: Landmark, anchor: Landmark) -> str:
    return f"gap {_gap(subject, anchor):.2f} m, {subject.name} {_side(subject, anchor)} {anchor.name}"


def _side(subject: Landmark, anchor: Landmark) -> str:
    """Where the subject is, in the anchor's frame, as words that the anchor's name can follow."""
    if anchor.front == "any" or anchor.kind not in ("object", "opening", "wall"):
        return "beside"
    x, y = anchor.to_local(subject.centre)
    if abs(x) - anchor.half[0] >= abs(y) - anchor.half[1]:
        return "in front of" if x > 0 else "behind"
    return "to the left of" if y > 0 else "to the right of"


def _shared(subject: Landmark, anchor: Landmark) -> float:
    """Intersection of the footprints as a share of the smaller."""
    smaller = min(subject.footprint.area, anchor.footprint.area)
    return float(subject.footprint.intersection(anchor.footprint).area / smaller) if smaller > 0.0 else 0.0


def _angle_to(subject: Landmark, anchor: Landmark) -> float:
    """Angle between where the subject looks and the anchor's nearest point or centre; 0 when it looks straight at it.

    What hangs on a wall is faced too by what is turned squarely to it, as every desk of a class faces the board.
    """
    target = anchor.edge((1, 0)) if anchor.kind == "opening" else anchor.footprint
    yaws = (subject.gaze, subject.gaze + 180.0) if subject.front == "two" else (subject.gaze,)
    return min(_angle_of(subject, yaw, anchor, target) for yaw in yaws)


def _angle_of(subject: Landmark, yaw: float, anchor: Landmark, target: BaseGeometry) -> float:
    start, ahead = Point(subject.centre), (math.cos(math.radians(yaw)), math.sin(math.radians(yaw)))
    reach = 1.0 + float(start.hausdorff_distance(target))
    end = (start.x + ahead[0] * reach, start.y + ahead[1] * reach)
    if not target.covers(start) and LineString([(start.x, start.y), end]).intersects(target):
        return 0.0
    nearest = nearest_points(start, target)[1]
    spots = [anchor.centre, (nearest.x, nearest.y)]
    bearings = [_bearing(subject.centre, spot) for spot in spots if math.dist(spot, subject.centre) > CONTACT]
    if anchor.hung and anchor.to_local(subject.centre)[0] > 0.0:
        bearings.append(anchor.yaw + 180.0)
    return min((turn_between(yaw, bearing) for bearing in bearings), default=0.0)


def _bearing(start: Vec2, end: Vec2) -> float:
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))
