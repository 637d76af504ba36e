"""What a prompt demands, row by row, in the grammar of SceneEval's annotations."""

from typing import Literal

import msgspec

Quantifier = Literal["eq", "ge", "gt", "le", "lt"]
QUANTIFIERS: tuple[Quantifier, ...] = ("eq", "ge", "gt", "le", "lt")
MAX_COUNT = 1000
"""Largest number of a row."""


class Row(msgspec.Struct, frozen=True):
    """How many of something there must be.

    Attributes:
        quantifier: "eq" exactly, "ge" at least, "gt" more than, "le" at most, "lt" fewer than `number`.
    """

    quantifier: Quantifier
    number: int

    def met_by(self, found: int) -> bool:
        """Whether so many are as many as there must be."""
        outcomes = {
            "eq": found == self.number,
            "ge": found >= self.number,
            "gt": found > self.number,
            "le": found <= self.number,
            "lt": found < self.number,
        }
        return outcomes[self.quantifier]

    @property
    def least(self) -> int:
        """The fewest that meet it."""
        return {"eq": self.number, "ge": self.number, "gt": self.number + 1}.get(self.quantifier, 0)

    @property
    def most(self) -> int | None:
        """The most that meet it; None where there is no such limit."""
        return {"eq": self.number, "le": self.number, "lt": self.number - 1}.get(self.quantifier)

    @property
    def amount(self) -> str:
        """The quantity in words, such as "ge 2"."""
        return f"{self.quantifier} {self.number}"


class Count(Row, frozen=True):
    """So many objects of a category."""

    category: str

    def __str__(self) -> str:
        return f"{self.amount} {self.category}"


class Attribute(Row, frozen=True):
    """So many objects of a category that have all of some attributes."""

    category: str
    attributes: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.amount} {self.category}: {', '.join(self.attributes)}"


class ObjectRelation(Row, frozen=True):
    """So many groups of an anchor and its subjects that stand in a relation.

    Attributes:
        relation: as it is written, such as "next_to".
        anchor: category of the anchor.
        subjects: categories of the other objects, each as often as it takes part in one group.
    """

    relation: str
    anchor: str
    subjects: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.amount} {self.relation}: {', '.join(self.subjects)} -> {self.anchor}"


class ElementRelation(Row, frozen=True):
    """So many objects of a category that stand in a relation to a part of the room.

    Attributes:
        element: "wall", "door", "window", "floor", "ceiling", "corner" or "room".
    """

    relation: str
    category: str
    element: str

    def __str__(self) -> str:
        return f"{self.amount} {self.relation}: {self.category} -> {self.element}"


class RoomDemand(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the prompt says of the room.

    Attributes:
        kind: such as "guest bedroom"; not visible in a room, so only the reading is judged by it.
        size: lengths of two sides of the floor [m].
        shape: "rectangle", "square" or "L".
    """

    kind: str = ""
    size: tuple[float, float] | None = None
    shape: str | None = None


class Annotation(msgspec.Struct, frozen=True):
    """A prompt and all that it demands.

    Attributes:
        style: the group that its results are counted with; SceneEval's difficulty.
        absent: categories that must not be there.
    """

    id: str
    style: str
    prompt: str
    counts: tuple[Count, ...] = ()
    attributes: tuple[Attribute, ...] = ()
    object_relations: tuple[ObjectRelation, ...] = ()
    element_relations: tuple[ElementRelation, ...] = ()
    absent: tuple[str, ...] = ()
    room: RoomDemand = RoomDemand()

    @property
    def categories(self) -> tuple[str, ...]:
        """Every category that a row speaks of, each once, the counted ones first."""
        found = [row.category for row in self.counts]
        found += [row.category for row in self.attributes]
        for relation in self.object_relations:
            found += [relation.anchor, *relation.subjects]
        found += [row.category for row in self.element_relations]
        return tuple(dict.fromkeys(found))
