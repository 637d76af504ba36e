"""Driving a base with two wheels along a way."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.sim.environment.model_index import ModelIndex

FAST, TURNING = 0.5, 1.3
"""The most that is asked of a base [m/s, rad/s]."""
PASSED = 0.06
"""A corner of the way that is so near is passed [m]."""
ARRIVED = 0.015
"""So is its end [m]."""
_ASIDE = 0.25
"""A base turns on the spot until it looks where it is to go but for so much [rad]."""


class Driver:
    """Follows a way; `arrived` says that its end is reached.

    Args:
        index: of the model.
        actuators: their names, among which are "ahead" and "turn".
        way: corners (n, 2) [m].

    Raises:
        InputError: the robot has no such actuators.
    """

    def __init__(self, index: ModelIndex, actuators: Sequence[str], way: NDArray[np.float64]) -> None:
        missing = [name for name in ("ahead", "turn") if name not in actuators]
        if missing:
            raise InputError(f"the robot {index.robot.name!r} has no actuator {missing[0]!r}; 'base' and 'picker' have")
        self._index, self._actuators, self._left = index, list(actuators), [tuple(point) for point in way[1:]]
        self.end = tuple(way[-1])

    @property
    def arrived(self) -> bool:
        """Whether it is at the end of the way."""
        return not self._left

    def action(self) -> NDArray[np.float64]:
        """What all actuators are given; nothing but these two is moved."""
        ahead, turn = self.speeds()
        action = np.zeros(len(self._actuators))
        action[self._actuators.index("ahead")] = ahead
        action[self._actuators.index("turn")] = turn
        return action

    def speeds(self) -> tuple[float, float]:
        """How fast to go ahead [m/s] and to turn to the left [rad/s]."""
        x, y, yaw = self._index.pose
        while self._left and math.hypot(self._left[0][0] - x, self._left[0][1] - y) < self._near:
            self._left.pop(0)
        if not self._left:
            return 0.0, 0.0
        away = (self._left[0][0] - x, self._left[0][1] - y)
        aside = turn_to(yaw, math.atan2(away[1], away[0]))
        if abs(aside) > _ASIDE:
            return 0.0, limited(3.0 * aside, TURNING)
        return limited(1.5 * math.hypot(*away) + 0.03, FAST) * math.cos(aside) ** 2, limited(3.0 * aside, TURNING)

    @property
    def _near(self) -> float:
        return ARRIVED if len(self._left) == 1 else PASSED


def turn_to(yaw: float, wanted: float) -> float:
    """The turn from one direction to another, -pi to pi [rad]."""
    return (wanted - yaw + math.pi) % (2.0 * math.pi) - math.pi


def limited(value: float, most: float) -> float:
    """A value whose size is at most so much."""
    return max(-most, min(most, value))
