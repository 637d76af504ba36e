"""Opening a door or drawer with a suction cup on an arm that reaches out to the left of a base."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString
from shapely.geometry.base import BaseGeometry

from thinkblox.errors import InputError
from thinkblox.sim.environment.driving import limited
from thinkblox.sim.environment.goals import OPEN, OpenGoal
from thinkblox.sim.environment.model_index import Array, ModelIndex
from thinkblox.sim.environment.phases import PhasedScript
from thinkblox.sim.environment.task import Errand
from thinkblox.sim.environment.ways import way_to_place

CUP = 0.02
"""Radius of the cup [m]."""
FIRST, LAST = 0.19, 0.70
"""How far the cup's middle is from the base's, drawn in and reached out [m]."""
LOW, HIGH = 0.22, 1.2
"""How low and how high it comes [m]."""
SPEED = 0.15
"""Of what is drawn open [m/s]."""
ASIDE = (0.0, 0.25, -0.25, 0.5, -0.5)
"""How far from straight the arm may come to a front [rad]."""
_TRIED = 16
"""So many ways are sought."""
_BEYOND = 1.1
"""It is drawn a little farther than must be."""
_EASY = 0.08
"""Between the base and what comes towards it, where there is room [m]."""
_SOLID = np.array([0, 0, 0, 1, 0, 0], np.uint8)
"""The group of what collides."""
_CLEAR = 0.3
"""So much must be free before a point that is touched [m]."""
_BESIDE, _LEVEL = 0.022, 0.002
"""A front is flat where points so far away are level with it [m]."""


class OpeningMotion:
    """How points of a door or drawer move as it opens, from where it is now."""

    def __init__(self, index: ModelIndex, goal: OpenGoal) -> None:
        joint = index.model.joint(goal.moving.body.name)
        number, self._at = int(joint.id), int(joint.qposadr[0])
        self._data, self._slide = index.data, int(joint.type[0]) == mujoco.mjtJoint.mjJNT_SLIDE
        self._axis, self._anchor = np.array(index.data.xaxis[number]), np.array(index.data.xanchor[number])
        self._start, self.upper = self.now, float(joint.range[1])

    @property
    def now(self) -> float:
        """How far it is open [m or rad]."""
        return float(self._data.qpos[self._at])

    def point(self, point: Array, opened: float) -> Array:
        """Where a point of it is when it is so far open [m]."""
        amount = opened - self._start
        if self._slide:
            return np.asarray(point + amount * self._axis)
        return np.asarray(self._anchor + self.turned(point - self._anchor, opened))

    def turned(self, direction: Array, opened: float) -> Array:
        """A direction that goes with it."""
        if self._slide:
            return np.array(direction)
        turn, found = np.zeros(4), np.zeros(3)
        mujoco.mju_axisAngle2Quat(turn, self._axis, opened - self._start)
        mujoco.mju_rotVecQuat(found, np.asarray(direction, np.float64), turn)
        return found

    def heading(self, point: Array) -> Array:
        """The unit direction in which a point moves when it opens further; zeros on the axis."""
        away = self._axis if self._slide else np.cross(self._axis, point - self._anchor)
        length = float(np.linalg.norm(away))
        return np.asarray(away / length) if length > 1e-6 else np.zeros(3)

    def arm(self, point: Array) -> float:
        """How far a point is from the axis [m]; the same for all points of a drawer."""
        return 1.0 if self._slide else float(np.linalg.norm(np.cross(self._axis, point - self._anchor)))


@dataclass(frozen=True)
class Stance:
    """From where to open something: which way the base looks [rad], what the cup touches [m], and the way there."""

    yaw: float
    touch: Array
    out: Array
    way: NDArray[np.float64]


class Opener(PhasedScript):
    """Opens the door or drawer of an errand, step by step.

    Raises:
        InputError: it is no robot for that, or there is no place to do it from.
    """

    def __init__(self, errand: Errand, actuators: Sequence[str]) -> None:
        index, goal = errand.index, errand.goal
        if not isinstance(goal, OpenGoal) or errand.robot.name != "picker":
            raise InputError("only the task 'open' with the robot 'picker' is solved by this script")
        self._swing = OpeningMotion(index, goal)
        self._own = set(goal.parts.tolist())
        stance = next(_stances(errand, goal, self._swing), None)
        if stance is None:
            raise InputError(f"{errand.room.name}: there is no place from which the script can {goal.says()}")
        self._stance = stance
        super().__init__(index, actuators, stance.way, stance.yaw)

    def _lift(self) -> dict[str, float]:
        """To the height of what is touched, and level with it along the base's way."""
        away = self._stance.touch - self._index.tool
        along = float(away[:2] @ self._ahead)
        if abs(away[2]) < 0.004 and abs(along) < 0.004:
            self.phase = "touch"
        return {
            "lift": limited(3.0 * float(away[2]), 0.3),
            "ahead": limited(2.0 * along, 0.2),
            "turn": self._straight(),
        }

    def _touch(self) -> dict[str, float]:
        if self._touches():
            self.phase = "draw"
        return {"arm": 0.08, "suction": 1.0, "turn": self._straight()}

    def _draw(self) -> dict[str, float]:
        """Along the way of the point that is held, which is where the door or drawer is now."""
        if not self._touches():
            self.phase = "touch"
        now = self._swing.now
        held = self._swing.point(self._stance.touch, now)
        cup = held + CUP * self._swing.turned(self._stance.out, now)
        wanted = SPEED * self._swing.heading(held) + 2.0 * (cup - self._index.tool)
        along, out = float(wanted[:2] @ self._ahead), float(wanted[:2] @ self._left)
        return {
            "ahead": limited(along, 0.3),
            "arm": limited(out, 0.3),
            "lift": limited(float(wanted[2]), 0.3),
            "suction": 1.0,
            "turn": self._straight(),
        }

    @property
    def _ahead(self) -> Array:
        yaw = self._index.pose[2]
        return np.array([math.cos(yaw), math.sin(yaw)])

    @property
    def _left(self) -> Array:
        ahead = self._ahead
        return np.array([-ahead[1], ahead[0]])

    def _touches(self) -> bool:
        return self._index.robot_touches(self._own)


def _stances(errand: Errand, goal: OpenGoal, swing: OpeningMotion) -> Iterator[Stance]:
    """Where the base can stand so that the arm reaches the front, and follows it as it opens."""
    floor, start = errand.places.floor, errand.index.pose[:2]
    points, tried = _touchable(errand.index, goal, swing), 0
    for aside in ASIDE:
        for touch, out in points:
            for middle, yaw in _middles(floor, touch, _turned(-out[:2], aside), swing):
                found = way_to_place(floor, start, middle)
                if found is not None:
                    yield Stance(yaw, touch, out, found)
                tried += 1
                if tried >= _TRIED:
                    return


def _middles(
    floor: BaseGeometry, touch: Array, left: Array, swing: OpeningMotion
) -> Iterator[tuple[NDArray[np.float64], float]]:
    """Where the base's middle can be for an arm that reaches out in a direction (2,), and which way it looks then."""
    ahead = np.array([left[1], -left[0]])
    opened = np.linspace(0.0, OPEN * _BEYOND * swing.upper, 12)
    moves = np.array([(swing.point(touch, each) - touch)[:2] for each in opened])
    back, along = -moves @ left, moves @ ahead
    nearest = FIRST + CUP + max(float(back.max()), 0.0) + 0.01
    farthest = LAST + min(float(back.min()), 0.0)
    for away in sorted(np.arange(nearest, farthest, 0.03), key=lambda away: abs(away - nearest - _EASY)):
        middle = touch[:2] - left * away
        ends = [middle + shift * ahead for shift in (along.min(), along.max() + 1e-6)]
        if shapely.covers(floor, LineString(ends)):
            yield middle, math.atan2(ahead[1], ahead[0])


def _turned(direction: Array, angle: float) -> Array:
    """A unit vector (2,) in a direction that is turned to the left [rad]."""
    x, y = direction / np.linalg.norm(direction)
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * x - s * y, s * x + c * y])


def _touchable(index: ModelIndex, goal: OpenGoal, swing: OpeningMotion) -> list[tuple[Array, Array]]:
    """Points of a flat front that the cup can come to [m], with the direction out of it, the best first."""
    low, high = index.box(goal.parts)
    middle = (low + high) / 2
    out = swing.heading(middle)
    if abs(out[2]) > 0.3:
        return []
    across = np.array([-out[1], out[0], 0.0]) / np.hypot(out[0], out[1])
    reach = (high - low) / 2
    wide, front = float(np.abs(across) @ reach), middle + float(np.abs(out) @ reach) * out
    found: list[tuple[float, Array]] = []
    for u in np.linspace(-wide, wide, 25):
        for z in np.arange(max(low[2] + 0.03, LOW), min(high[2] - 0.02, HIGH), 0.04):
            point = _flat_at(index, set(goal.parts.tolist()), np.array([*(front + u * across)[:2], z]), out, across)
            if point is not None:
                found.append((swing.arm(point) - 0.05 * abs(z - 0.7) - 0.1 * (swing.arm(point) == 1.0) * abs(u), point))
    found.sort(key=lambda each: -each[0])
    return [(point, out) for _, point in found]


def _flat_at(index: ModelIndex, own: set[int], before: Array, out: Array, across: Array) -> Array | None:
    """Where a line against the way out, from clear of a point before it, meets a flat part of what opens; or None."""
    up = np.cross(out, across)
    start = before + _CLEAR * out
    shifts = [np.zeros(3), *(sign * _BESIDE * way for way in (across, up) for sign in (-1.0, 1.0))]
    depths = [index.first_hit(start + shift, -out, own, _SOLID) for shift in shifts]
    if any(depth is None for depth in depths) or max(depths) - min(depths) > _LEVEL:  # type: ignore
        return None
    return np.asarray(start - depths[0] * out)  # type: ignore
