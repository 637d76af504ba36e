"""What an instruction asks for, in its own words: orders, with the noun phrases and places that they name."""

from dataclasses import dataclass, field
from typing import Literal

from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where

Doing = Literal[
    "add", "put", "move", "turn", "replace", "remove", "swap", "rearrange", "resite", "make", "free", "clear", "keep"
]  # fmt: skip


@dataclass
class NounPhrase:
    """A noun phrase with where it is said to be, or to go: which of the two, only the room can tell.

    Attributes:
        id: of an object that is named by it.
        rank: 1 for "the larger one" of several, -1 for "the smaller one"; 0 where nothing is said.
        spared: which of them are excepted.
        laden: what rests on it is meant too.
    """

    noun: Noun
    places: list[Where] = field(default_factory=list)
    id: str = ""
    rank: int = 0
    spared: list["NounPhrase"] = field(default_factory=list)
    laden: bool = False

    @property
    def text(self) -> str:
        """As it was written."""
        return " ".join([self.noun.text, *(f"{w.text} {w.noun.text}" for w in self.places if w.noun is not None)])


@dataclass
class Order:
    """One thing to be done.

    Attributes:
        text: as it was written.
        things: what it is done to, or what is added.
        instead: what comes in place of a thing.
        places: where, when no thing was named before.
        closer: to which others the things go nearer (True), or from which they go away (False).
        apart: how far from what they are to be [m].
        spared: what "everything" does not hold.
        together: nearer to each other.
        facing: what they are to face.
        turn, sense: by how many degrees, and which way: 1 counter-clockwise, -1 clockwise, 0 where either will do.
        direction: where they are shifted to: "left", "north", "up", ...
        lengths: lengths that it names [m], with their axes ("" where none is said).
        change: how the room is to change: "longer", "wider", ...
        room: it is about the whole room.
        ceiling: it is about the ceiling.
        into: the zone that a region becomes, "reading_corner".
        free: places that are to stay free.
        rest: it speaks of everything else.
        away: "take it away".
    """

    doing: Doing
    text: str
    things: list[NounPhrase] = field(default_factory=list)
    instead: list[NounPhrase] = field(default_factory=list)
    places: list[Where] = field(default_factory=list)
    closer: list[tuple[bool, NounPhrase]] = field(default_factory=list)
    apart: list[tuple[float, NounPhrase]] = field(default_factory=list)
    spared: list[NounPhrase] = field(default_factory=list)
    together: bool = False
    facing: list[Noun] = field(default_factory=list)
    turn: float | None = None
    sense: int = 0
    direction: str = ""
    lengths: list[tuple[float, str]] = field(default_factory=list)
    change: str = ""
    room: bool = False
    ceiling: bool = False
    into: str = ""
    free: list[Noun] = field(default_factory=list)
    rest: bool = False
    away: bool = False


@dataclass(frozen=True)
class Instruction:
    """An instruction as it was read.

    Attributes:
        orders: in the order in which they stand.
        unknown: words that mean nothing in it.
    """

    text: str
    orders: tuple[Order, ...]
    unknown: tuple[str, ...]
