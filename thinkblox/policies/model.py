"""A policy that asks a model."""

import numpy as np

from thinkblox.chat import ChatModel
from thinkblox.observe import Observation, Sight

SIGHT = "sight.json"
"""In the folder of a model of our training: what it was shown, and is to be shown again."""


class ModelPolicy:
    """Lets a model place objects: it is shown each observation, and its answers are the proposals."""

    def __init__(self, model: ChatModel, *, sight: Sight | None = None) -> None:
        self._model = model
        self._sight = sight or Sight()

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` texts `<think>...</think><answer>...</answer>`."""
        return self._model.answer(observation.chat(self._sight), n, rng)
