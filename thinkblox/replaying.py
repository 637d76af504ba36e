"""A trace played back: the same brief, plan and texts again, in the same order for every object."""

from pathlib import Path

import numpy as np
from msgspec import structs

from thinkblox.brief import Brief
from thinkblox.episode import Episode, read_episode
from thinkblox.errors import UnavailableError
from thinkblox.observe import Observation
from thinkblox.plan import Plan
from thinkblox.scene.room import Room


class Replay:
    """Plays all three roles from an episode: of its attempts, the one that was kept.

    Attributes:
        episode: what is played back.
    """

    def __init__(self, trace: str | Path | Episode) -> None:
        """Take or read an episode.

        Raises:
            InputError: the file is no trace.
        """
        self.episode = trace if isinstance(trace, Episode) else read_episode(trace)
        self._name = "the trace" if isinstance(trace, Episode) else str(trace)
        self._texts: dict[str, list[tuple[str, ...]]] = {}
        for done in self.episode.rounds:
            if done.kept and done.kind == "policy":
                said = tuple(t.text for t in done.tries if t.text)
                self._texts.setdefault(done.id, []).append(said)

    def __repr__(self) -> str:
        return f"Replay({self._name!r})"

    def check(self, prompt: str, seed: int) -> None:
        """Raise UnavailableError where another room is asked for than the trace has."""
        self._check_prompt(prompt)
        if seed != self.episode.seed:
            raise UnavailableError(f"{self._name}: was made with seed {self.episode.seed}, not {seed}; give that one")

    def brief(self, prompt: str) -> Brief:
        """What was understood; raises UnavailableError for another prompt."""
        self._check_prompt(prompt)
        return self.episode.plan.brief

    def room(self, brief: Brief, rng: np.random.Generator) -> Room:
        """The room as it was."""
        return self.episode.room

    def plan(self, brief: Brief, room: Room) -> Plan:
        """The objects in the order in which they were placed; what nobody asked for and was left out is left out.

        Raises:
            UnavailableError: the room is another one, things in it were moved, exchanged or taken away of somebody's
                own accord, or the trace ends before all that was asked for was tried.
        """
        if _shape(room) != _shape(self.episode.room):
            raise UnavailableError(f"{self._name}: was made in another room; leave the room out, and it is the same")
        if self.episode.stood or any(done.kept and done.kind == "edit" for done in self.episode.rounds):
            raise UnavailableError(f"{self._name}: its room was changed after things stood in it, which no plan tells")
        there = self.episode.scene
        targets = tuple(t for t in self.episode.plan.targets if t.asked or t.id in there)
        if missing := next((t.id for t in targets if t.id not in self._texts), ""):
            raise UnavailableError(f"{self._name}: ends before {missing}, and cannot be played back to its end")
        return structs.replace(self.episode.plan, targets=targets)

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """The texts that were proposed for this object the last time; raises UnavailableError where there are none."""
        self._check_prompt(observation.prompt)
        id = observation.target.id
        if id not in self._texts:
            had = ", ".join(self._texts) or "nothing"
            raise UnavailableError(f"{self._name}: has no {id}; it has {had}")
        rounds = self._texts[id]
        return list(rounds[observation.round]) if observation.round < len(rounds) else []

    def _check_prompt(self, prompt: str) -> None:
        if prompt != self.episode.prompt:
            raise UnavailableError(f"{self._name}: was made for another prompt, {self.episode.prompt[:200]!r}")


def _shape(room: Room) -> tuple[object, ...]:
    return room.floor, room.height, room.openings
