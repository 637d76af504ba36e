"""Policies that show what an environment is, and that its tasks can be solved: a random one, and others by script."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.sim.environment.carrying import Carrier
from thinkblox.sim.environment.driving import Driver
from thinkblox.sim.environment.goals import AT_HAND
from thinkblox.sim.environment.opening import Opener
from thinkblox.sim.environment.reaching import Reacher
from thinkblox.sim.environment.task import Errand
from thinkblox.sim.environment.ways import way

EnvPolicy = Callable[[Any], NDArray[np.float64]]
"""From what is told by an environment (a `dm_env.TimeStep`) to an action."""
INSIDE = 0.06
"""How far within reach of its target a robot is driven [m]."""


@dataclass(frozen=True)
class Ran:
    """What came of an episode.

    Attributes:
        reached: whether the goal was.
        steps: actions.
        total: sum of the rewards.
        seconds: simulated.
    """

    reached: bool
    steps: int
    total: float
    seconds: float


def run_episode(environment: Any, policy: EnvPolicy, *, steps: int | None = None) -> Ran:
    """Run one episode of a dm_env environment to its end, or for so many steps."""
    told, total, count = environment.reset(), 0.0, 0
    while not told.last() and (steps is None or count < steps):
        told = environment.step(policy(told))
        total += float(told.reward)
        count += 1
    reached = bool(told.last() and told.discount == 0.0)
    return Ran(reached, count, total, count * float(environment.control_timestep()))


class RandomPolicy:
    """Any action, each as likely as the others."""

    def __init__(self, environment: Any, *, seed: int = 0) -> None:
        self._spec, self._rng = environment.action_spec(), np.random.default_rng(seed)

    def __call__(self, told: Any) -> NDArray[np.float64]:
        """An action between its limits; where there are none, between -1 and 1."""
        low, high = (np.asarray(limit, np.float64) for limit in (self._spec.minimum, self._spec.maximum))
        bounded = np.isfinite(low) & np.isfinite(high)
        share = self._rng.uniform(size=self._spec.shape)
        return np.asarray(np.where(bounded, low + share * (high - low), 2.0 * share - 1.0))


class ScriptedDrive:
    """Solves `drive` with "base" or "picker": a shortest way over the free floor, which it knows, corner by corner."""

    def __init__(self, environment: Any) -> None:
        self._environment = environment
        self._driver: Driver | None = None

    def __call__(self, told: Any) -> NDArray[np.float64]:
        """The next action; raises InputError at the beginning of an episode when there is no way."""
        errand: Errand = self._environment.task.errand
        if told.first() or self._driver is None:
            self._driver = Driver(errand.index, _names(self._environment), self._way(errand))
        return self._driver.action()

    def _way(self, errand: Errand) -> NDArray[np.float64]:
        places, (x, y, _) = errand.places, errand.index.pose
        goal = shapely.intersection(places.floor, places.outline(errand.goal.id).buffer(AT_HAND - INSIDE))
        found = way(places.floor, (x, y), goal)
        if found is None:
            raise InputError(f"{errand.room.name}: there is no way to {errand.goal.id}")
        return found


class _Script:
    """Solves a task by a script that is begun anew with every episode."""

    _begun: type[Opener | Reacher | Carrier]

    def __init__(self, environment: Any) -> None:
        self._environment = environment
        self._solver: Opener | Reacher | Carrier | None = None

    def __call__(self, told: Any) -> NDArray[np.float64]:
        """The next action; raises InputError at the beginning of an episode when the script cannot do it."""
        if told.first() or self._solver is None:
            self._solver = self._begun(self._environment.task.errand, _names(self._environment))
        return self._solver.action()


class ScriptedOpen(_Script):
    """Solves `open` with "picker": drives before a door or drawer, holds its front by suction, and draws it open."""

    _begun = Opener


class ScriptedReach(_Script):
    """Solves `reach` with "picker": drives to where its arm comes past everything to the object, and reaches out."""

    _begun = Reacher


class ScriptedCarry(_Script):
    """Solves `carry` with "picker" for things with a flat top: takes them by that, and carries them over everything."""

    _begun = Carrier


def _names(environment: Any) -> list[str]:
    """The actuators by their own names, in the order of an action."""
    return [name.rpartition("/")[2] for name in environment.action_spec().name.split("\t")]
