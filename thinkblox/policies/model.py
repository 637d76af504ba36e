"""A policy that asks a model."""

import numpy as np

from thinkblox.chat import ChatModel
from thinkblox.compact import named
from thinkblox.observe import Observation, Sight


class ModelPolicy:
    """Lets a model place objects: it is shown each observation, and its answers are the proposals.

    Args:
        model: is asked.
        sight: what it is shown; what it was trained on, its `sight`, when not given.
    """

    def __init__(self, model: ChatModel, *, sight: Sight | None = None) -> None:
        self._model = model
        self._sight = sight or getattr(model, "sight", None) or Sight()

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` texts `<think>...</think><answer>...</answer>`."""
        texts = self._model.answer(observation.chat(self._sight), n, rng)
        if self._sight.words == "compact":
            return [str(named(text, observation.target.id)) for text in texts]
        return texts
