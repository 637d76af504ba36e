"""The three roles that a model or the embedded expert can play: understanding a prompt, planning, and placing."""

from typing import Protocol

import numpy as np

from thinkblox.brief import Brief
from thinkblox.observe import Observation
from thinkblox.plan import Plan
from thinkblox.scene.room import Room


class Briefer(Protocol):
    """Anything that understands a prompt."""

    def brief(self, prompt: str) -> Brief:
        """What the prompt asks for."""
        ...


class Planner(Protocol):
    """Anything that decides what room it is to be, what belongs into it and in which order."""

    def room(self, brief: Brief, rng: np.random.Generator) -> Room:
        """A room for a brief; asked for where the user gives none."""
        ...

    def plan(self, brief: Brief, room: Room) -> Plan:
        """The objects in the order in which they are placed, and what depends on what."""
        ...


class Policy(Protocol):
    """Anything that proposes where the next object goes."""

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` texts `<think>...</think><answer>...</answer>`, the best first."""
        ...
