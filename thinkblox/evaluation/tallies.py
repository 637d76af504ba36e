"""Judged rows: one for every demand, with what was found."""

from typing import Literal

import msgspec

Kind = Literal["count", "attribute", "object relation", "architecture", "absent", "room"]


class JudgedRow(msgspec.Struct, frozen=True, kw_only=True):
    """One demand and whether it is met.

    Attributes:
        kind: what sort of demand it is.
        about: what it is counted with in the tables besides, such as the relation's name; empty for none.
        demand: the row in words.
        met: None where it cannot be judged: a state or style that neither geometry, colour nor material shows.
        says: what was found, in words.
        asked, found: of a count: the fewest objects that were demanded, and how many of them are there; else 0.
        extra: of a count: how many objects there are beyond the most that were demanded.
    """

    kind: Kind
    demand: str
    met: bool | None
    says: str
    about: str = ""
    asked: int = 0
    found: int = 0
    extra: int = 0
