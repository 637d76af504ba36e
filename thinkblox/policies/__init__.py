"""Policies: whatever answers an observation with texts in the step language."""

from typing import Protocol

import numpy as np

from thinkblox.observe import Observation


class Policy(Protocol):
    """Anything that proposes where the next object goes."""

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` texts `<think>...</think><answer>...</answer>`, the best first."""
        ...
