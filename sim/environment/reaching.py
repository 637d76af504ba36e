"""Bringing the tool to an object with an arm that reaches out to the left of a base."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Point
from shapely.geometry.base import BaseGeometry

from thinkblox.errors import InputError
from thinkblox.sim.environment.driving import limited
from thinkblox.sim.environment.goals import TOUCHING, ReachGoal
from thinkblox.sim.environment.model_index import Array, ModelIndex
from thinkblox.sim.environment.opening import CUP, FIRST, HIGH, LAST, LOW
from thinkblox.sim.environment.phases import PhasedScript
from thinkblox.sim.environment.task import Errand
from thinkblox.sim.environment.ways import way_to_place

NEAR = TOUCHING - 0.015
"""How near the tool is to come [m]."""
BEAM = 0.035
"""So much round the middle of the arm must be free [m]."""
ASIDE = (0.0, 0.3, -0.3, 0.6, -0.6)
"""How far from straight at the object the arm may point [rad]."""
_HEIGHTS = np.arange(LOW, HIGH, 0.05)
_PLACES, _WAYS = 60, 8
"""So many places are looked at, and so many ways sought."""
_BEGINS = 0.1
"""How far from the base's middle the arm comes out [m]."""
_GRID = 0.08
_SOLID = np.array([0, 0, 0, 1, 0, 0], np.uint8)


@dataclass(frozen=True)
class Reach:
    """How to reach something: where the base's middle is [m], which way it looks [rad], and where its tool ends [m]."""

    middle: Array
    yaw: float
    tool: Array


class Reacher(PhasedScript):
    """Reaches the object of an errand, step by step.

    Raises:
        InputError: it is no robot for that, or there is no place to do it from.
    """

    def __init__(self, errand: Errand, actuators: Sequence[str]) -> None:
        if not isinstance(errand.goal, ReachGoal) or errand.robot.name != "picker":
            raise InputError("only the task 'reach' with the robot 'picker' is solved by this script")
        found = next(_ways(errand, errand.goal.id), None)
        if found is None:
            raise InputError(f"{errand.room.name}: there is no place from which the script can {errand.goal.says()}")
        self._reach, corners = found
        super().__init__(errand.index, actuators, corners, self._reach.yaw)

    def _lift(self) -> dict[str, float]:
        away = float(self._reach.tool[2] - self._index.tool[2])
        if abs(away) < 0.004:
            self.phase = "reach_out"
        return {"lift": limited(3.0 * away, 0.3), "turn": self._straight()}

    def _reach_out(self) -> dict[str, float]:
        yaw = self._index.pose[2]
        left = np.array([-math.sin(yaw), math.cos(yaw)])
        away = float((self._reach.tool - self._index.tool)[:2] @ left)
        return {"arm": limited(2.0 * away, 0.15), "turn": self._straight()}


def _ways(errand: Errand, id: str) -> Iterator[tuple[Reach, NDArray[np.float64]]]:
    """How an object can be reached, each with a way there, the nearest places first."""
    floor, start = errand.places.floor, errand.index.pose[:2]
    for reach in islice(reaches(errand, id), _WAYS):
        found = way_to_place(floor, start, reach.middle)
        if found is not None:
            yield reach, found


def reaches(errand: Errand, id: str) -> Iterator[Reach]:
    """From where the tool can come to an object, the places nearest to the robot first."""
    index, floor, goal = errand.index, errand.places.floor, errand.places.outline(id)
    for middle in places_near(floor, goal, LAST, index.pose[:2]):
        near = shapely.get_coordinates(shapely.shortest_line(Point(middle), goal))[-1]
        straight = math.atan2(near[1] - middle[1], near[0] - middle[0])
        for aside in ASIDE:
            yield from _from(index, id, middle, straight + aside)


def places_near(
    floor: BaseGeometry, goal: BaseGeometry, within: float, start: tuple[float, float]
) -> NDArray[np.float64]:
    """Places (n, 2) on a floor that are so near a goal [m], those nearest to a start first."""
    area = shapely.intersection(floor, shapely.buffer(goal, within))
    if area.is_empty:
        return np.zeros((0, 2))
    x0, y0, x1, y1 = area.bounds
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(x0, x1 + _GRID, _GRID), np.arange(y0, y1 + _GRID, _GRID)))
    points = np.column_stack([x, y])[shapely.contains_xy(area, x, y)]
    points = points[np.argsort(np.hypot(*(points - start).T))]
    return np.asarray(points[:: max(len(points) // _PLACES, 1)])


def _from(index: ModelIndex, id: str, middle: Array, angle: float) -> Iterator[Reach]:
    """The first height at which the arm comes to an object from a place in a direction [rad], from the middle ones."""
    along = np.array([math.cos(angle), math.sin(angle), 0.0])
    for height in sorted(_HEIGHTS, key=lambda height: abs(height - 0.6)):
        foot = np.array([*middle, height])
        farthest = min(arm_free(index, middle, angle, height) - CUP - 0.005, LAST)
        for away in np.arange(farthest, FIRST + 0.01, -0.04):
            tool = foot + away * along
            if index.distance(id, tool) <= NEAR:
                yield Reach(middle, angle - math.pi / 2, tool)
                return


def arm_free(index: ModelIndex, middle: Array, angle: float, height: float) -> float:
    """How far from the base's middle the arm can go in a direction [rad] before any part of it meets something [m]."""
    along, up = np.array([math.cos(angle), math.sin(angle), 0.0]), np.array([0.0, 0.0, 1.0])
    across, start = np.array([-along[1], along[0], 0.0]), np.array([*middle, height]) + _BEGINS * along
    shifts = [np.zeros(3), *(sign * BEAM * way for way in (across, up) for sign in (-1.0, 1.0))]
    return _BEGINS + min(index.free_way(start + shift, along, _SOLID) for shift in shifts)
