"""A different room each episode."""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.environment.extra import needed
from thinkblox.sim.environment.room_source import KEPT, RoomSource


class Rotation:
    """Rooms in an order that is shuffled anew when all have had their turn; a few of them are kept open.

    Attributes:
        skipped: the rooms in which the task cannot be done, with the reason.
    """

    def __init__(
        self, sources: Sequence[RoomSource], make: Callable[[RoomSource], Any], rng: np.random.RandomState
    ) -> None:
        self._sources, self._make, self._rng = dict(enumerate(sources)), make, rng
        self._open: dict[int, Any] = {}
        self._left: list[int] = []
        self._peeked: Any = None
        self.skipped: dict[str, str] = {}

    def first(self) -> Any:
        """The environment of the room that comes next, whose turn it still is then."""
        self._peeked = self._next()
        return self._peeked

    def next(self) -> Any:
        """The environment of the next room; raises InputError when the task can be done in none."""
        found, self._peeked = self._peeked, None
        return found or self._next()

    def _next(self) -> Any:
        while True:
            number = self._draw()
            try:
                found = self._open.pop(number) if number in self._open else self._make(self._sources[number])
            except InputError as error:
                self.skipped[self._sources.pop(number).name] = str(error)
                continue
            self._open[number] = found
            while len(self._open) > KEPT:
                self._open.pop(next(iter(self._open))).close()
            return found

    def _draw(self) -> int:
        self._left = [number for number in self._left if number in self._sources]
        if not self._left:
            self._left = self._rng.permutation(list(self._sources)).tolist()
        if not self._left:
            reasons = "; ".join(dict.fromkeys(self.skipped.values()))
            raise InputError(f"the task can be done in none of the rooms: {reasons}")
        return self._left.pop()

    def begin_anew(self) -> None:
        """Forget whose turn it is, when what draws them has been seeded."""
        self._left, self._peeked = [], None

    def close(self) -> None:
        """Let all rooms go."""
        while self._open:
            self._open.popitem()[1].close()


def rotating(sources: Sequence[RoomSource], make: Callable[[RoomSource], Any], rng: np.random.RandomState) -> Any:
    """A `dm_env.Environment` that has another room each episode; raises InputError when none will do."""
    return _rotating_class()(Rotation(sources, make, rng), rng)


@cache
def _rotating_class() -> Any:
    base: Any = needed("dm_env").Environment

    class RotatingRooms(base):  # type: ignore[misc]
        """One room after the other: `current` is the environment of the room that it is in."""

        def __init__(self, rotation: Rotation, random_state: np.random.RandomState) -> None:
            self.rotation, self.random_state = rotation, random_state
            self.current, self._again = rotation.first(), True

        skipped = property(lambda self: self.rotation.skipped)
        task = property(lambda self: self.current.task)
        physics = property(lambda self: self.current.physics)

        def reset(self) -> Any:
            self.current, self._again = self.rotation.next(), False
            return self.current.reset()

        def step(self, action: Any) -> Any:
            if self._again:
                return self.reset()
            told = self.current.step(action)
            self._again = told.last()
            return told

        def control_timestep(self) -> Any:
            return self.current.control_timestep()

        def action_spec(self) -> Any:
            return self.current.action_spec()

        def observation_spec(self) -> Any:
            return self.current.observation_spec()

        def close(self) -> None:
            self.rotation.close()

    return RotatingRooms
