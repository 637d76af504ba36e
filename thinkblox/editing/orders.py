"""What an instruction asks for, in its own words: orders, with the noun phrases and places that they name."""

from dataclasses import dataclass, field
from typing import Literal

from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where

Doing = Literal[
    "add", "ensure", "put", "move", "turn", "replace", "remove", "swap", "rearrange", "resite", "make", "free", "clear",
    "keep", "only", "gap", "spread"
]  # fmt: skip


INSTEAD = "instead of"
"""The words of a place at which something is not to be: it may also be what makes room there."""
BEARS, BORE = "that carries", "that carried"
"""The words of a place by which a thing is told by what rests on it, or rested on it before."""
HERE = "that is "
"""Before the words of a place at which a thing is, and not to which it goes."""
AWAY_SIDE = "on the side away from"
"""The words of a place at that side of a thing which is farthest from another."""
SAME = "same"
"""The degree of a new thing that is as large as what it comes in place of."""


@dataclass
class NounPhrase:
    """A noun phrase with where it is said to be, or to go: which of the two, only the room can tell.

    Attributes:
        id: of an object that is named by it.
        rank: 1 for "the larger one" of several, -1 for "the smaller one"; 0 where nothing is said.
        along: what they are compared by: "height", "length"; empty for how large they are.
        share: which part of them is meant, whichever: 0.5 for "half of the chairs"; 0 where none is said.
        spared: which of them are excepted.
        left: how many are excepted, whichever ("all but two of them").
        laden: what rests on it is meant too.
        member: which of a row it is, from the left; -1 the last, 0 where nothing is said.
    """

    noun: Noun
    places: list[Where] = field(default_factory=list)
    id: str = ""
    rank: int = 0
    along: str = ""
    share: float = 0.0
    left: int = 0
    spared: list["NounPhrase"] = field(default_factory=list)
    laden: bool = False
    member: int = 0

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
        bound: "ge" where such a length is the least, "le" where it is the most.
        company: what goes along with them.
        mutual: how they are to stand to each other.
        level: as high as what they are to hang; "it" where that is what they hang by.
        across: what is to be between two that are turned to each other.
        spared: what "everything" does not hold.
        besides: at which of several places nothing is put.
        together: nearer to each other.
        scatter: further from each other.
        split: how many of its things are the first of two groups.
        facing: what they are to face.
        backs: what their backs are to be to.
        turn, sense: by how many degrees, and which way: 1 counter-clockwise, -1 clockwise, 0 where either will do.
        direction: where they are shifted to: "left", "north", "up", ...
        lengths: lengths that it names [m], with their axes ("" where none is said).
        by: the length is by how much something changes, not what it comes to.
        slight: it is to be a little.
        seated: seats are pushed "in" to their table, or pulled "out".
        looks: what a thing is to look like: colours, materials, shapes.
        ruled_out: what a thing is not to look like, and how its size is not to change.
        change: how the room is to change: "longer", "wider", ...
        times: by how many times; 0 where that is not said.
        room: it is about the whole room.
        ceiling: it is about the ceiling.
        into: the zone that a region becomes, "reading_corner".
        free: places that are to stay free.
        rest: it speaks of everything else.
        away: "take it away".
        there: where something was that the order before has taken away.
        eached: what comes along comes with each of what comes instead.
        space: it speaks of the space at its places.
        total: it says how many there are to be ("only two chairs").
        centred: at the middle of where they go.
        leaves: they leave the part of the room that they are in.
        abreast: beside each other, turned the same way.
        touching: they are to have no gap between them.
        in_line: they stand in one line.
        bears: what is to be on it then.
        purpose: what it is for, which is known but changes nothing.
        lost: words that mean nothing in it.
    """

    doing: Doing
    text: str
    things: list[NounPhrase] = field(default_factory=list)
    instead: list[NounPhrase] = field(default_factory=list)
    places: list[Where] = field(default_factory=list)
    closer: list[tuple[bool, NounPhrase]] = field(default_factory=list)
    apart: list[tuple[float, NounPhrase]] = field(default_factory=list)
    spared: list[NounPhrase] = field(default_factory=list)
    besides: list[NounPhrase] = field(default_factory=list)
    bound: str = ""
    company: list[NounPhrase] = field(default_factory=list)
    mutual: str = ""
    level: list[Noun] = field(default_factory=list)
    across: list[Noun] = field(default_factory=list)
    together: bool = False
    scatter: bool = False
    facing: list[Noun] = field(default_factory=list)
    backs: list[Noun] = field(default_factory=list)
    turn: float | None = None
    sense: int = 0
    direction: str = ""
    lengths: list[tuple[float, str]] = field(default_factory=list)
    by: bool = False
    slight: bool = False
    seated: str = ""
    looks: list[str] = field(default_factory=list)
    ruled_out: list[str] = field(default_factory=list)
    change: str = ""
    times: float = 0.0
    room: bool = False
    ceiling: bool = False
    into: str = ""
    free: list[Noun] = field(default_factory=list)
    rest: bool = False
    away: bool = False
    eached: bool = False
    space: bool = False
    total: bool = False
    there: bool = False
    split: int = 0
    centred: bool = False
    leaves: bool = False
    abreast: bool = False
    touching: bool = False
    in_line: bool = False
    bears: list[NounPhrase] = field(default_factory=list)
    purpose: list[Noun] = field(default_factory=list)
    lost: list[str] = field(default_factory=list)


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
