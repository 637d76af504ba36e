"""What is piled up on others of its kind, and how high."""

import tomllib
from functools import lru_cache
from pathlib import Path

import msgspec

from thinkblox.value import Value


class Stacks(Value, frozen=True, kw_only=True):
    """What is known of stacks.

    Attributes:
        things: categories of which one lies on another, separated by commas.
        most: so many at most lie on each other.
        on: what is stacked with one other thing, and on which.
    """

    things: str
    most: int
    on: dict[str, str]

    def is_piled(self, category: str) -> bool:
        """Whether one of these lies on another of them."""
        return category in self.things.split(", ")


@lru_cache(maxsize=1)
def load_stacks() -> Stacks:
    """What is known of stacks."""
    text = Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    return msgspec.convert(tomllib.loads(text), Stacks)
