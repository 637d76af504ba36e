"""A script with an arm on a base: it drives to its place, turns as it is to stand, and then goes on by phases."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.environment.driving import Driver, limited, turn_to
from thinkblox.sim.environment.model_index import ModelIndex


class PhasedScript:
    """Goes through phases, each a method `_PHASE` that gives speeds by actuator; the third is "lift".

    Args:
        index: of the model.
        actuators: their names.
        corners: of the way to its place (n, 2) [m].
        yaw: which way the base looks there [rad].
    """

    def __init__(self, index: ModelIndex, actuators: Sequence[str], corners: NDArray[np.float64], yaw: float) -> None:
        self._index, self._actuators, self._yaw = index, list(actuators), yaw
        self._driver = Driver(index, actuators, corners)
        self.phase = "way"

    def action(self) -> NDArray[np.float64]:
        """What all actuators are given."""
        speeds = getattr(self, f"_{self.phase}")()
        return np.array([speeds.get(name, 0.0) for name in self._actuators])

    def _way(self) -> dict[str, float]:
        ahead, turn = self._driver.speeds()
        if self._driver.arrived:
            self.phase = "turn"
        return {"ahead": ahead, "turn": turn}

    def _turn(self) -> dict[str, float]:
        if abs(self._aside) < 0.01:
            self.phase = "lift"
        return {"turn": self._straight()}

    @property
    def _aside(self) -> float:
        return turn_to(self._index.pose[2], self._yaw)

    def _straight(self) -> float:
        return limited(3.0 * self._aside, 0.8)
