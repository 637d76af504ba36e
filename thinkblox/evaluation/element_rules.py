"""Relations of an object to a part of the room. The ranges are SceneEval's, without its tails."""

import math
from collections.abc import Sequence

from shapely import union_all
from shapely.geometry.base import BaseGeometry

from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.object_rules import ACROSS, EXACT, FAR, FAR_IN_SMALL, MAJORITY, NEAR, NEXT_TO
from thinkblox.evaluation.relation_words import Element, ElementRule
from thinkblox.evaluation.ruling import Ruling
from thinkblox.evaluation.walls import Enclosure

ON_WALL = 0.01
"""Largest gap behind what hangs on a wall [m]."""
AGAINST_WALL = 0.3
"""Largest gap between a wall and what stands against it [m]."""
CORNER = 0.8
"""Largest gap to both walls of a corner [m]."""
CEILING = 0.01
"""Largest gap over what hangs from the ceiling [m]."""
OFF_FLOOR = 0.02
"""How high over the floor something on a wall must be: what stands on the floor hangs on nothing [m]."""
CENTRAL = 0.25
"""How far from the middle of the floor something in the middle may be, as a share of the floor's extent."""
_SCORE_OF_HALF = math.sqrt(2.0 * math.log(2.0))


def holds(rule: ElementRule, body: Body, part: Element, room: Enclosure) -> Ruling:
    """Whether an object stands in a relation to a part of the room."""
    if rule == "on_wall":
        return _on_wall(body, room)
    if rule == "against_wall":
        return _against_wall(body, room)
    if rule == "corner_room":
        return _in_corner(body, room)
    if rule == "hang_ceiling":
        gap = room.height - body.high
        return Ruling(gap <= CEILING + EXACT, f"{gap:.2f} m below the ceiling")
    if rule == "middle_room":
        return _in_middle(body, room)
    if rule == "inside_room":
        inside = room.floor.intersection(body.footprint).area / body.footprint.area
        return Ruling(inside > MAJORITY, f"{inside:.0%} of it inside".replace("%", " %"))
    return _apart(rule, body, part, room)


def _on_wall(body: Body, room: Enclosure) -> Ruling:
    gap = min((w.gap(body) for w in room.walls if w.covers(body) > MAJORITY), default=math.inf)
    hangs = body.low > OFF_FLOOR
    return Ruling(
        gap <= ON_WALL + EXACT and hangs, f"{gap:.3f} m from a wall" + ("" if hangs else ", standing on the floor")
    )


def _against_wall(body: Body, room: Enclosure) -> Ruling:
    gap = min((w.gap(body) for w in room.walls if w.covers(body) > MAJORITY), default=math.inf)
    return Ruling(gap <= AGAINST_WALL + EXACT, f"{gap:.2f} m from a wall")


def _in_corner(body: Body, room: Enclosure) -> Ruling:
    gap = min((max(a.gap(body), b.gap(body)) for a, b in room.corners), default=math.inf)
    return Ruling(gap <= CORNER + EXACT, f"{gap:.2f} m from the farther wall of the nearest corner")


def _in_middle(body: Body, room: Enclosure) -> Ruling:
    """SceneEval's bound, which grows with the object, and besides within the middle half of the floor each way.

    Alone, that bound takes a bed at the wall of a small room to be in its middle.
    """
    x0, y0, x1, y1 = room.floor.bounds
    centre = room.floor.centroid
    dx, dy = body.centre[0] - centre.x, body.centre[1] - centre.y
    side, large = (x1 - x0 + y1 - y0) / 2, 2 * max(body.half)
    bound = _SCORE_OF_HALF * (0.5 * large + 1.0 - large / side)
    central = abs(dx) <= CENTRAL * (x1 - x0) and abs(dy) <= CENTRAL * (y1 - y0)
    return Ruling(central and math.hypot(dx, dy) <= bound, f"{math.hypot(dx, dy):.2f} m from the middle")


def _apart(rule: ElementRule, body: Body, part: Element, room: Enclosure) -> Ruling:
    if part == "ceiling":
        gap = max(0.0, room.height - body.high)
    elif part == "floor":
        gap = max(0.0, body.low)
    else:
        lines = _lines(part, room)
        if not lines:
            return Ruling(False, f"there is no {part}")
        gap = float(union_all(lines).distance(body.footprint))
    small = room.diagonal - 2 * max(body.half) <= FAR
    ranges = {
        "next_to": (0.0, NEXT_TO),
        "near": (0.0, NEAR),
        "across_from": ACROSS,
        "far": (FAR_IN_SMALL if small else FAR, math.inf),
    }
    least, most = ranges[rule]
    return Ruling(least - EXACT <= gap <= most + EXACT, f"{gap:.2f} m from the nearest {part}")


def _lines(part: Element, room: Enclosure) -> Sequence[BaseGeometry]:
    if part == "corner":
        return room.corner_points()
    if part in ("door", "window"):
        return room.openings(part)
    return [wall.line for wall in room.walls]
