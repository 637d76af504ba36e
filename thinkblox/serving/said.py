"""What a tool answers: words, the same as data, and pictures with their captions."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from PIL.Image import Image


@dataclass(frozen=True)
class Said:
    """An answer, told without any protocol.

    Attributes:
        parts: texts and pictures, in the order in which they are read.
        data: what the texts say as plain values; None where they are the whole.
    """

    parts: tuple["str | Image", ...]
    data: dict[str, Any] | None = field(default=None)

    @property
    def text(self) -> str:
        """Its texts, a line each."""
        return "\n".join(part for part in self.parts if isinstance(part, str))
