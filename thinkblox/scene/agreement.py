"""Does an answer agree with its reasoning? How far a pose is from what was said about it."""

import math
from collections.abc import Callable

from thinkblox.phrases import Constraint, Kind
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room, Wall, turn_between
from thinkblox.value import Vec2

AGAINST = 0.1
"""How far from a wall still counts as against it [m]."""


def residual(constraint: Constraint, scene: Arrangement, placement: Placement) -> float | None:
    """How far a pose is from what was said: metres, or degrees for "facing" and "turned"; 0 when it agrees.

    None when it cannot be told, because the text names an object or a wall that the scene does not have.
    """
    walls = {wall.name for wall in scene.room.walls} | {"floor"}
    if any(anchor not in scene and anchor not in walls for anchor in constraint.anchors):
        return None
    return _RESIDUALS[constraint.kind](constraint, scene, placement)


def wall_gap(wall: Wall, placement: Placement) -> float:
    """Distance from the wall's line to the nearest corner of the footprint [m]; negative outside."""
    return min(wall.coordinates(corner)[1] for corner in placement.corners)


def side_gap(anchor: Placement, placement: Placement, side: str) -> float:
    """Free distance between the footprints along the anchor's axis towards `side` [m]; negative when they overlap."""
    local = [anchor.to_local(corner) for corner in placement.corners]
    axis, sign = (
        (0, 1.0) if side == "front" else (0, -1.0) if side == "back" else (1, 1.0) if side == "left" else (1, -1.0)
    )
    return min(sign * corner[axis] for corner in local) - anchor.size[axis] / 2


def direction_error(placement: Placement, target: Vec2) -> float:
    """Angle between the front and the direction to a point [degrees]."""
    dx, dy = target[0] - placement.position[0], target[1] - placement.position[1]
    return 0.0 if math.hypot(dx, dy) < 1e-9 else turn_between(placement.yaw, math.degrees(math.atan2(dy, dx)))


def _beside(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return abs(side_gap(scene[c.anchors[0]], p, c.side) - c.values[0])


def _against(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return max(0.0, abs(wall_gap(scene.room.wall(c.anchors[0]), p)) - AGAINST)


def _from_wall(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return abs(wall_gap(scene.room.wall(c.anchors[0]), p) - c.values[0])


def _corner(c: Constraint, scene: Arrangement, p: Placement) -> float:
    point = corner_point(scene.room, *c.anchors)
    return max(0.0, math.dist(point, p.position[:2]) - math.hypot(p.size[0], p.size[1]) / 2 - 0.4)


def corner_point(room: Room, first: str, second: str) -> Vec2:
    """Where two walls meet, or the midpoint of their nearest ends when they do not [m]."""
    a, b = room.wall(first), room.wall(second)
    pairs = [(p, q) for p in (a.start, a.end) for q in (b.start, b.end)]
    p, q = min(pairs, key=lambda pair: math.dist(*pair))
    return ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)


def _on(c: Constraint, scene: Arrangement, p: Placement) -> float:
    anchor = scene[c.anchors[0]]
    heights = [anchor.position[2] + surface.position[2] for surface in scene.asset_of(anchor).surfaces] or [anchor.top]
    across = [
        max(0.0, abs(x) - half / 2) for x, half in zip(anchor.to_local(p.position[:2]), anchor.size, strict=False)
    ]
    return math.hypot(*across, min(abs(p.position[2] - height) for height in heights))


def _centre_distance(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return math.dist(scene[c.anchors[0]].position[:2], p.position[:2])


def _under(c: Constraint, scene: Arrangement, p: Placement) -> float:
    anchor = scene[c.anchors[0]]
    return 0.0 if anchor.footprint.intersects(p.footprint) else anchor.footprint.distance(p.footprint)


def _offset(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return math.dist(scene[c.anchors[0]].to_local(p.position[:2]), c.values)


def _between(c: Constraint, scene: Arrangement, p: Placement) -> float:
    a, b = (scene[anchor].position[:2] for anchor in c.anchors)
    length = math.dist(a, b)
    if length < 1e-9:
        return math.dist(a, p.position[:2])
    along = sum((q - s) * (e - s) for q, s, e in zip(p.position, a, b, strict=False)) / length
    return max(0.0, -along, along - length)


def _facing(c: Constraint, scene: Arrangement, p: Placement) -> float:
    anchor = c.anchors[0]
    if anchor in scene:
        return direction_error(p, scene[anchor].position[:2])
    inward = scene.room.wall(anchor).inward
    return turn_between(p.yaw, math.degrees(math.atan2(-inward[1], -inward[0])))


def _turned(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return turn_between(p.yaw, c.values[0])


def _above(c: Constraint, scene: Arrangement, p: Placement) -> float:
    base = 0.0 if c.anchors[0] == "floor" else scene[c.anchors[0]].top
    return abs(p.position[2] - base - c.values[0])


def _at(c: Constraint, scene: Arrangement, p: Placement) -> float:
    return math.dist(c.values, p.position[:2])


_RESIDUALS: dict[Kind, Callable[[Constraint, Arrangement, Placement], float]] = {
    "beside": _beside,
    "against": _against,
    "from_wall": _from_wall,
    "corner": _corner,
    "on": _on,
    "under": _under,
    "centred": _centre_distance,
    "offset": _offset,
    "between": _between,
    "facing": _facing,
    "turned": _turned,
    "above": _above,
    "at": _at,
}
