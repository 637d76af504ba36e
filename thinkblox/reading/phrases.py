"""What a text is cut into: noun phrases ("two small round tables"), the words that link them, sizes, unknown words."""

from dataclasses import dataclass, field
from typing import Literal

from thinkblox.reading.sizes import Size

PhraseKind = Literal[
    "object",
    "room",
    "place",
    "part",
    "people",
    "pronoun",
    "rows",
    "number",
    "adjective",
    "missing",
    "ignored",
    "gap",
    "other",
    "all",
]


@dataclass
class Phrase:
    """A noun phrase.

    Attributes:
        value: category, generic noun ("any_table"), room type, place, part or pronoun, according to `kind`.
        count: as said; None for a bare plural. `vague` when it is only a guess ("several").
        rows: number of rows it is said to stand in; 0 when nothing is said, -1 for "rows" without a number.
        bare: without an article or number ("next to sink").
        each: "each table", "every corner"; with kind "pronoun": "on each".
        whose: "its foot".
        size: a length said of it.
        room: another reading of the same words as a room ("bar").
        seats: how many people it is said to be for ("an 8-person table").
    """

    kind: PhraseKind
    value: str
    count: int | None = None
    vague: bool = False
    plural: bool = False
    definite: bool = False
    bare: bool = False
    each: bool = False
    whose: bool = False
    rows: int = 0
    attributes: list[str] = field(default_factory=list)
    styles: list[str] = field(default_factory=list)
    text: str = ""
    size: Size | None = None
    room: str = ""
    seats: int = 0


@dataclass(frozen=True)
class Connective:
    """A word between noun phrases: a relation, "with", "and", a comma, ..."""

    kind: str
    value: str = ""


@dataclass(frozen=True)
class Unknown:
    """A word that means nothing to us."""

    text: str


Item = Phrase | Connective | Unknown | Size
