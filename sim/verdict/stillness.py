"""What counts as being at rest, by where things were at the looks so far."""

import math
from collections import deque

import numpy as np
from numpy.typing import NDArray

SLOW = 0.002
"""Slower than this is at rest [m/s]."""
SLOW_TURN = 0.005
"""The same for turning [rad/s], and for the joints of its doors."""
CALM = 0.25
"""What does not hop comes between two looks no further than by this share of that speed: 97 of 100 things at rest."""
QUIET = 1.0
"""How long everything must have stayed where it is to count as at rest when the time is over [s]."""
TREMBLE, TREMBLE_TURN = 0.001, 0.01
"""How far it may have been from itself meanwhile [m, rad]: contacts tremble."""
TREND, TREND_TURN = 0.0003, 0.002
"""How far the middle of the second half of that time may be from that of the first [m, rad]: what topples goes on."""
DYING = 0.9
"""What ranges over less than this share of what it did in the while before sways out, and is not going anywhere."""


def stayed(before: NDArray[np.float64], now: NDArray[np.float64], interval: float) -> bool:
    """Whether poses (n, 7) did not change to speak of in an interval [s].

    Contacts that jump and come to rest again and again are at rest at nearly every instant, and yet walk.
    """
    return bool(_within(now - before, CALM * SLOW * interval, CALM * SLOW_TURN * interval).all())


class Quiet:
    """Which bodies have stayed where they are for a while, though they may tremble there, or still sway a little."""

    def __init__(self, interval: float) -> None:
        self._looks = math.ceil(QUIET / interval)
        self._poses: deque[NDArray[np.float64]] = deque(maxlen=2 * self._looks + 1)

    def look(self, poses: NDArray[np.float64]) -> None:
        """Take one look more; `poses` are those of the free bodies (n, 7)."""
        self._poses.append(poses)

    @property
    def lasted(self) -> NDArray[np.bool_]:
        """Of each body (n) whether it did not move or turn to speak of at all looks of the last while.

        What creeps or topples goes on; what sways goes on as well, by less each time.
        """
        if len(self._poses) <= self._looks:
            return np.zeros(len(self._poses[0]) if self._poses else 0, dtype=np.bool_)
        looks = np.array(self._poses)
        last, half = looks[-self._looks - 1 :], (self._looks + 1) // 2
        reach, trend = np.ptp(last, axis=0), last[half:].mean(axis=0) - last[:half].mean(axis=0)
        if len(looks) > 2 * self._looks:
            trend[reach < DYING * np.ptp(looks[: self._looks + 1], axis=0)] = 0.0
        return _within(reach, TREMBLE, TREMBLE_TURN) & _within(trend, TREND, TREND_TURN)


def _within(difference: NDArray[np.float64], far: float, turned: float) -> NDArray[np.bool_]:
    """Which differences of poses (n, 7) are small [m, rad]; a quaternion differs by half of what is turned."""
    shift, turn = np.abs(difference[:, :3]), 2.0 * np.abs(difference[:, 3:])
    return np.asarray((shift < far).all(axis=1) & (turn < turned).all(axis=1))
