"""What is said to a model and what it answers: messages of text and pictures, the same for every library and server."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np

if TYPE_CHECKING:
    from PIL.Image import Image

Speaker = Literal["system", "user", "assistant"]


@dataclass(frozen=True)
class Message:
    """What one speaker says: texts and pictures, in the order in which they are read."""

    speaker: Speaker
    parts: tuple["str | Image", ...]

    @property
    def text(self) -> str:
        """Its texts, a blank line between them."""
        return "\n\n".join(part for part in self.parts if isinstance(part, str))

    @property
    def images(self) -> tuple["Image", ...]:
        """Its pictures."""
        return tuple(part for part in self.parts if not isinstance(part, str))


Chat = tuple[Message, ...]


class ChatModel(Protocol):
    """Any model that can continue a conversation: on this machine, or behind a server."""

    def answer(self, chat: Chat, n: int, rng: np.random.Generator) -> list[str]:
        """Up to `n` answers to a conversation, sampled apart; the texts as they came.

        Raises:
            InputError: the model cannot be asked at all: says why, and what to do.
        """
        ...
