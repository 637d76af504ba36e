"""A cache of keys and values that grows in place: a token more does not copy those of all tokens before it."""

from functools import cache as once
from typing import Any

PIECE = 256
"""For how many tokens more a layer makes room at a time."""


def growing_cache() -> Any:
    """An empty cache for a model of transformers."""
    from transformers import Cache

    return Cache(layer_class_to_replicate=_layer_class())


def shortened(cache: Any, tokens: int) -> Any:
    """A growing cache with its first tokens alone; the room of the others is used again."""
    for layer in cache.layers:
        layer.keys, layer.values = layer.keys[:, :, :tokens], layer.values[:, :, :tokens]
    return cache


@once
def _layer_class() -> Any:
    """The class of its layers; transformers is asked for only where a model is."""
    import torch
    from transformers.cache_utils import DynamicLayer

    class GrowingLayer(DynamicLayer):  # type: ignore[misc]
        def lazy_initialization(self, key_states: Any, value_states: Any) -> None:
            super().lazy_initialization(key_states, value_states)
            self._room = [self._roomy(states, states[:, :, :0]) for states in (key_states, value_states)]
            self.keys, self.values = (room[:, :, :0] for room in self._room)

        def update(self, key_states: Any, value_states: Any, *_: Any, **__: Any) -> tuple[Any, Any]:
            if not self.is_initialized:
                self.lazy_initialization(key_states, value_states)
            old, new = self.keys.shape[2], self.keys.shape[2] + key_states.shape[2]
            if new > self._room[0].shape[2]:
                kept = (self.keys, self.values)
                self._room = [self._roomy(s, k) for s, k in zip((key_states, value_states), kept, strict=True)]
            for room, states in zip(self._room, (key_states, value_states), strict=True):
                room[:, :, old:new] = states
            self.keys, self.values = (room[:, :, :new] for room in self._room)
            return self.keys, self.values

        @staticmethod
        def _roomy(states: Any, kept: Any) -> Any:
            """Room for what is kept, for some states more, and for a piece beyond them."""
            length = kept.shape[2] + states.shape[2] + PIECE
            room = torch.empty((*states.shape[:2], length, states.shape[3]), dtype=states.dtype, device=states.device)
            room[:, :, : kept.shape[2]] = kept
            return room

    return GrowingLayer
