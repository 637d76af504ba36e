"""When a simulation may end early: nothing moves, and at the rate at which it does nothing will have come far."""

from collections import deque

import mujoco
import numpy as np
from numpy.typing import NDArray

INTERVAL, LOOKS = 0.05, 5
"""Poses are compared with those of the last so many looks, so far apart [s]."""
LEAST = 0.5
"""Nothing is believed to be still before this [s]: what topples begins slowly."""
ARM = 0.1
"""Rotation is seen at points so far from a body's origin [m]."""
GROWTH, NOISE = 1.5, 1e-8
"""What gains speed by more than this from one window to the next, beyond rounding [m], is not still."""


class Stillness:
    """Watches the bodies of a model that can move; its own slow drift is told from a tremble that leads nowhere."""

    def __init__(self, model: mujoco.MjModel, creep: float) -> None:
        """Watch; no point of a body may come further than `creep` [m] in the time left, at its present rate."""
        self._creep = creep
        self._moving = np.flatnonzero(model.body_weldid != 0)
        self._poses: deque[NDArray[np.float64]] = deque(maxlen=LOOKS + 1)
        self._ranges: deque[float] = deque(maxlen=LOOKS + 1)

    def look(self, data: mujoco.MjData, remaining: float) -> bool:
        """Look once every INTERVAL; whether all is still for the time that remains [s]."""
        now = self._points(data)
        self._poses.append(now)
        extent = max((_largest(now - pose) for pose in self._poses), default=0.0)
        self._ranges.append(extent)
        if len(self._ranges) <= LOOKS:
            return False
        steady = extent <= GROWTH * self._ranges[0] + NOISE
        return steady and extent * remaining / (INTERVAL * LOOKS) < self._creep

    def _points(self, data: mujoco.MjData) -> NDArray[np.float64]:
        """Three points of every moving body [m]."""
        origin, turned = data.xpos[self._moving], data.xmat[self._moving].reshape(-1, 3, 3)
        return np.concatenate([origin, origin + ARM * turned[:, :, 0], origin + ARM * turned[:, :, 1]])


def _largest(shift: NDArray[np.float64]) -> float:
    return float(np.sqrt(np.max(np.einsum("ij,ij->i", shift, shift), initial=0.0)))
