"""Where the reasoning alone would put the object: its phrases solved for a pose, without a look at the answer."""

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from thinkblox.phrases import SIDES, Constraint, planned_constraints
from thinkblox.scene.room import Wall
from thinkblox.scene.scene import Scene
from thinkblox.steps import Step
from thinkblox.value import Vec2, Vec3

_TOUCH = 0.02
"""The gap that "against a wall" most often means [m]."""
_VAGUE, _FAINT = 0.1, 0.01
"""Weights of phrases that leave some room, and of those that leave much."""
_AXES: dict[str, tuple[int, float]] = {"front": (0, 1.0), "back": (0, -1.0), "left": (1, 1.0), "right": (1, -1.0)}
assert set(_AXES) == set(SIDES)

Reach = Callable[[Vec2], float]
Equation = tuple[Vec2, float, float]
"""Coefficients of x and y, what they come to [m], and how much it weighs."""


def repredicted(scene: Scene, step: Step) -> tuple[Vec3, float] | None:
    """The position and yaw that a step's reasoning leads to, by least squares; None where it leaves either open.

    Of the answer nothing is used but the size. The height is that of what carries it, the nearest to the answer where
    there are several.
    """
    said = [c for c in planned_constraints(step) if all(_is_there(scene, anchor) for anchor in c.anchors)]
    yaw = next((c.values[0] for c in said if c.kind == "turned"), None)
    if yaw is None or step.size is None:
        return None
    half = _half_along(step.size, yaw)
    rows = [row for c in said for row in _equations(scene, c, half)]
    if not rows:
        return None
    weights = np.array([weight for *_, weight in rows])
    table = np.array([coefficients for coefficients, *_ in rows]) * weights[:, None]
    if np.linalg.matrix_rank(table, tol=1e-4) < 2:
        return None
    place, *_ = np.linalg.lstsq(table, np.array([value for _, value, _ in rows]) * weights, rcond=None)
    return (float(place[0]), float(place[1]), _height(scene, said, step)), yaw


def _is_there(scene: Scene, anchor: str) -> bool:
    return anchor in scene or anchor == "floor" or any(wall.name == anchor for wall in scene.room.walls)


def _half_along(size: Vec3, yaw: float) -> Reach:
    """A function from a direction to how far a footprint of this size and yaw reaches along it [m]."""
    front = (math.cos(math.radians(yaw)), math.sin(math.radians(yaw)))

    def half(direction: Vec2) -> float:
        ahead = abs(front[0] * direction[0] + front[1] * direction[1])
        aside = abs(-front[1] * direction[0] + front[0] * direction[1])
        return ahead * size[0] / 2 + aside * size[1] / 2

    return half


def _equations(scene: Scene, c: Constraint, half: Reach) -> Iterator[Equation]:
    match c.kind:
        case "at":
            yield from _point((c.values[0], c.values[1]), 1.0)
        case "from_wall" | "against" | "corner":
            gap, weight = {"from_wall": (sum(c.values), 1.0), "against": (_TOUCH, _VAGUE)}.get(c.kind, (_TOUCH, _FAINT))
            yield from (_off_wall(scene.room.wall(name), gap, half, weight) for name in c.anchors)
        case "beside":
            anchor = scene[c.anchors[0]]
            axis, sign = _AXES[c.side]
            along = _direction(anchor.yaw + 90.0 * axis, sign)
            away = c.values[0] + anchor.size[axis] / 2 + half(along)
            yield along, _dot(along, anchor.position[:2]) + away, 1.0
        case "offset":
            yield from _point(scene[c.anchors[0]].to_room((c.values[0], c.values[1])), 1.0)
        case "between":
            a, b = (scene[anchor].position for anchor in c.anchors)
            yield from _point(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), _VAGUE)
        case "centred" | "on" | "under":
            yield from _point(scene[c.anchors[0]].position[:2], 1.0 if c.kind == "centred" else _FAINT)


def _point(place: Vec2, weight: float) -> Iterator[Equation]:
    yield (1.0, 0.0), place[0], weight
    yield (0.0, 1.0), place[1], weight


def _off_wall(wall: Wall, gap: float, half: Reach, weight: float) -> Equation:
    inward = wall.inward
    return inward, _dot(inward, wall.start) + gap + half(inward), weight


def _direction(yaw: float, sign: float) -> Vec2:
    return (sign * math.cos(math.radians(yaw)), sign * math.sin(math.radians(yaw)))


def _dot(a: Vec2, b: Sequence[float]) -> float:
    return a[0] * b[0] + a[1] * b[1]


def _height(scene: Scene, said: Sequence[Constraint], step: Step) -> float:
    asked = step.position[2] if step.position else 0.0
    for c in said:
        if c.kind == "above":
            return c.values[0] + (0.0 if c.anchors[0] == "floor" else scene[c.anchors[0]].top)
    for c in said:
        if c.kind in ("on", "centred", "offset") and c.anchors[0] in scene and asked > 0.0:
            carrier = scene[c.anchors[0]]
            heights = [carrier.position[2] + s.position[2] for s in scene.asset_of(carrier).surfaces] or [carrier.top]
            return min(heights, key=lambda height: abs(height - asked))
    return 0.0
