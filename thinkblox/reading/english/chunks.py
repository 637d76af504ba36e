"""What an English text is cut into: noun phrases, and the words between them."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from thinkblox.assets.plurals import singular
from thinkblox.brief import Fate, SurfaceRequest
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.sizes import Size

NounKind = Literal["thing", "place", "room", "people", "pronoun", "part", "abstract", "number"]


@dataclass(eq=False)
class Noun:
    """A noun phrase, or a number that stands for one ("two by the window").

    Attributes:
        kind: what its head is.
        value: category or name, place, type of room, part or pronoun, according to `kind`.
        start, end: tokens that it covers.
        text: as it was written.
        called: what it calls one of them, without what it tells of its looks ("treatment table"); empty without a head.
        det: its determiner, a key of the grammar's; empty where it has none.
        count: as said; None for a bare noun. `vague` when it is only a guess ("several").
        least, most: where a number of them is left open.
        of_known: so many of some that are known already ("two of the towels", "half of them").
        every: "every second chair" is 2 and `counted` False; "every two loungers" 2 and True.
        ordinal: 1 for the first, -1 for the last; 0 where nothing is said.
        side: "left", "right" or "middle", where that tells it from others of its kind.
        rows, groups: how many rows or groups it is said to form, -1 for "rows" without a number.
        walled: each row takes up a wall: "a wall of bookcases".
        group: the word for the groups ("island").
        unshown: modifiers that we know nothing about.
        seats: how many people it is for.
        room: another reading of the same words as a room ("bar").
        owner: the thing of which it is a part ("the bed's foot").
        named: the head is in the catalogue or another list of ours.
        material: what the same words say as an adjective ("glass").
        within: it names a part of the thing ("the oven handle").
        degree: "larger", "oldest", where that tells it from others of its kind.
        fates: what becomes of words of the phrase that ask for nothing, by token.
        looks: what is told of a thing of which the name is left out, or comes later ("a green and a black chair").
        total: of how many a number is said to be a part ("five of the eight chairs"); 0 where nothing is said.
        fraction: "three out of every four" is (3, 4).
        share: "half as many" is 0.5; 0 where it is not said of something else's number.
        id: of the object of a room that is named by it.
        among: the tokens at which the things were named that it means together ("both appliances").
    """

    kind: NounKind
    value: str
    start: int
    end: int
    text: str = ""
    called: str = ""
    det: str = ""
    count: int | None = None
    vague: bool = False
    least: int | None = None
    most: int | None = None
    plural: bool = False
    of_known: bool = False
    every: int = 0
    counted: bool = False
    ordinal: int = 0
    side: str = ""
    rows: int = 0
    walled: bool = False
    groups: int = 0
    group: str = ""
    attributes: list[str] = field(default_factory=list)
    styles: list[str] = field(default_factory=list)
    unshown: list[str] = field(default_factory=list)
    states: list[str] = field(default_factory=list)
    size: Size | None = None
    seats: int = 0
    room: str = ""
    owner: str = ""
    named: bool = True
    share: float = 0.0
    total: int = 0
    fraction: tuple[int, int] = (0, 0)
    material: str = ""
    within: bool = False
    id: str = ""
    among: tuple[int, ...] = ()
    degree: str = ""
    looks: list[str] = field(default_factory=list)
    fates: dict[int, Fate] = field(default_factory=dict)

    @property
    def definite(self) -> bool:
        """Whether it points at something known."""
        return self.det in ("the", "my", "both", "all", "other", "half", "none") or self.of_known

    @property
    def each(self) -> bool:
        """Whether what is said of it is said of every single one."""
        return self.det in ("each", "either")

    @property
    def shared(self) -> bool:
        """Whether what is said of several that are left is said of every single one: "each of the others"."""
        return self.text.lower().startswith(("each of ", "every one of ", "all "))

    @property
    def word(self) -> str:
        """The singular of its last word."""
        return singular(self.text.rpartition(" ")[2].lower())

    @property
    def many(self) -> bool:
        """Whether it speaks of several."""
        return self.plural if self.count is None else self.count > 1


@dataclass
class Connector:
    """Words between noun phrases: a preposition, verb, conjunction, mark, ..., as a section and key of the grammar."""

    sort: str
    value: str
    start: int
    end: int
    text: str = ""


@dataclass
class Adjective:
    """An adjective without a noun: "the sofa is red", "three of them chrome"."""

    start: int
    end: int
    text: str
    attributes: list[str] = field(default_factory=list)
    styles: list[str] = field(default_factory=list)
    unshown: list[str] = field(default_factory=list)
    states: list[str] = field(default_factory=list)


@dataclass
class Measured:
    """A size that stands for itself."""

    size: Size
    start: int
    end: int


@dataclass
class Stray:
    """A word that means nothing to us."""

    start: int
    end: int
    text: str


@dataclass
class SaidSurface:
    """What floor or walls are to be like."""

    start: int
    end: int
    request: SurfaceRequest


Chunk = Noun | Connector | Adjective | Measured | Stray | SaidSurface


def filler(chunk: Chunk) -> Connector:
    """A chunk as words that only fill the sentence and ask for nothing."""
    return Connector("fillers", "words", chunk.start, chunk.end, text_of([chunk]))


def chunk_at(chunks: Sequence[Chunk], at: int) -> Chunk | None:
    """The chunk at a place, or None past the end."""
    return chunks[at] if at < len(chunks) else None


def text_of(chunks: Sequence[Chunk]) -> str:
    """The words of chunks as they were written; a size has none."""
    return " ".join(str(getattr(chunk, "text", "")) for chunk in chunks)


def are_neighbours(several: Noun) -> bool:
    """Whether any two of several are meant between which none of them stands."""
    return not grammar().lists["neighbours"].isdisjoint(several.text.lower().split())
