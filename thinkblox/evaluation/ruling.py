"""What a rule says of one group of objects."""

from typing import NamedTuple


class Ruling(NamedTuple):
    """Whether a relation holds, and what was measured."""

    holds: bool
    says: str
