"""How two landmarks lie to each other: gap, side, angle, and what they share. Metres and degrees."""

import math

from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import nearest_points

from thinkblox.scene.landmarks import Landmark
from thinkblox.scene.room import turn_between
from thinkblox.value import Vec2

CONTACT = 0.01
"""Largest gap between a thing and what carries it; SceneEval support."""


def ground_gap(subject: Landmark, anchor: Landmark) -> float:
    """Horizontal distance between footprints; to a door or window from its place in the wall."""
    return float(subject.footprint.distance(place_of(anchor)))


def gap(subject: Landmark, anchor: Landmark) -> float:
    """Distance between the boxes around two things, heights included; of walls and the floor it is horizontal.

    A door or window reaches down to the floor, where what is lower than its sill stands at it as well.
    """
    aside = ground_gap(subject, anchor)
    if anchor.kind not in ("object", "opening"):
        return aside
    base = anchor.base if anchor.kind == "object" else 0.0
    return math.hypot(aside, max(0.0, base - subject.top, subject.base - anchor.top))


def place_of(anchor: Landmark) -> BaseGeometry:
    """What distances are measured to: a footprint, or the stretch of wall that a door or window takes."""
    return anchor.edge((1, 0)) if anchor.kind == "opening" else anchor.footprint


def gap_text(subject: Landmark, anchor: Landmark) -> str:
    """The gap and the side in words."""
    return f"gap {gap(subject, anchor):.2f} m, {subject.name} {side_words(subject, anchor)} {anchor.name}"


def side_words(subject: Landmark, anchor: Landmark) -> str:
    """Where the subject is, in the anchor's frame, as words that the anchor's name can follow."""
    if anchor.front == "any" or anchor.kind not in ("object", "opening", "wall"):
        return "beside"
    x, y = anchor.to_local(subject.centre)
    if abs(x) - anchor.half[0] >= abs(y) - anchor.half[1]:
        return "in front of" if x > 0 else "behind"
    return "to the left of" if y > 0 else "to the right of"


def shared(subject: Landmark, anchor: Landmark) -> float:
    """Intersection of the footprints as a share of the smaller."""
    smaller = min(subject.footprint.area, anchor.footprint.area)
    return float(subject.footprint.intersection(anchor.footprint).area / smaller) if smaller > 0.0 else 0.0


def angle_to(subject: Landmark, anchor: Landmark) -> float:
    """Angle between where the subject looks and the middle of the anchor; 0 when it looks straight at any part of it.

    Besides its middle that of what lies straight before the subject counts; of a place of the room its nearest point.
    """
    target = place_of(anchor)
    yaws = (subject.gaze, subject.gaze + 180.0) if subject.front == "two" else (subject.gaze,)
    return min(_angle_of(subject, yaw, anchor, target) for yaw in yaws)


def _angle_of(subject: Landmark, yaw: float, anchor: Landmark, target: BaseGeometry) -> float:
    start, ahead = Point(subject.centre), (math.cos(math.radians(yaw)), math.sin(math.radians(yaw)))
    reach = 1.0 + float(start.hausdorff_distance(target))
    end = (start.x + ahead[0] * reach, start.y + ahead[1] * reach)
    if not target.covers(start) and LineString([(start.x, start.y), end]).intersects(target):
        return 0.0
    spots = [anchor.centre]
    before = target.intersection(_swept(subject, ahead, reach))
    if not before.is_empty and not target.covers(start):
        spots.append((before.centroid.x, before.centroid.y))
    if anchor.kind != "object":
        nearest = nearest_points(start, target)[1]
        spots.append((nearest.x, nearest.y))
    bearings = [bearing(subject.centre, spot) for spot in spots if math.dist(spot, subject.centre) > CONTACT]
    return min((turn_between(yaw, bearing) for bearing in bearings), default=0.0)


def _swept(subject: Landmark, ahead: Vec2, reach: float) -> Polygon:
    """What lies straight before a thing as wide as it is."""
    (x, y), half = subject.centre, subject.half[1]
    left = (-ahead[1] * half, ahead[0] * half)
    near = ((x + left[0], y + left[1]), (x - left[0], y - left[1]))
    return Polygon([*near, *((px + ahead[0] * reach, py + ahead[1] * reach) for px, py in reversed(near))])


def bearing(start: Vec2, end: Vec2) -> float:
    """Direction from one point to another."""
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))


def past_centre(subject: Landmark, anchor: Landmark) -> float:
    """By how much the subject looks past the middle of the anchor [degrees]; 0 for what looks every way."""
    if subject.front == "any":
        return 0.0
    off = turn_between(subject.gaze, bearing(subject.centre, anchor.centre))
    return min(off, 180.0 - off) if subject.front == "two" else off
