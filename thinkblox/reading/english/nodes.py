"""What the reader of clauses keeps in mind: the things spoken of last, open lists, relations that wait for a thing."""

from dataclasses import dataclass, field

from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Noun


@dataclass(eq=False)
class Listed:
    """An open list: of what `head` has, or, without a head, of what the clause names.

    Attributes:
        kind: how the members stand to the head; "with" where the words do not say, "list" without a head.
        each: said of every single head.
        times: so many of each member, for groups that are no things themselves ("six workstations, each a desk").
        closing: an "and" was read, so that the next member is the last.
        told: the relation of a member to the head was said in words ("next to it").
        grouped: said of every group of the head ("every island has a plant").
        contents: it says what its head is filled with ("a basket of towels"), so that what follows is about the head.
        members: what it lists.
        inherited: what was said of the group that its first member stands for.
        joined: which member came last after an "and"; -1 for none.
        begun: with which member the innermost list in it begins: the third of "a, b, and c, d and e".
    """

    head: "Node | None" = None
    kind: str = "list"
    each: bool = False
    times: int = 1
    closing: bool = False
    told: bool = False
    grouped: bool = False
    contents: bool = False
    members: list[Mention] = field(default_factory=list)
    inherited: list[Bond] = field(default_factory=list)
    joined: int = -1
    begun: int = 0

    def last_joined(self) -> list[Mention]:
        """The single things that "and" joined last: "a bench and a sofa"; empty where one of them is several."""
        last = self.last_listed()
        return last if not any(thing.many for thing in last) else []

    def last_listed(self) -> list[Mention]:
        """The things that "and" joined last, single ones and several: "a sofa and two armchairs"."""
        last = self.members[self.begun : self.joined + 1] if self.joined == len(self.members) - 1 else []
        return last if len(last) > 1 else []


@dataclass(eq=False)
class Node:
    """Things, or a place, that what follows can be about.

    Attributes:
        things: one, or the several of a subject.
        frame: the list it belongs to; None for an anchor.
        known: it was named before, or as if it had been ("the fridge").
        told: it was named before.
        each: "each desk".
    """

    things: list[Mention] = field(default_factory=list)
    frame: Listed | None = None
    known: bool = False
    told: bool = False
    each: bool = False

    @property
    def thing(self) -> Mention | None:
        """The last of its things."""
        return self.things[-1] if self.things else None


@dataclass
class Where:
    """A preposition and what it is to.

    Attributes:
        word: the preposition, as the grammar calls it.
        noun: what follows; None for "above", "on top".
        whole: of what the noun is a part ("the foot of the bed"), if that is said.
        second: the other of "between A and B".
        negated: it is not so.
        start, text: its first token, and how it was written.
        paired: what it is said of is joined to what was named before.
    """

    word: str
    noun: Noun | None
    whole: Noun | None = None
    second: Noun | None = None
    negated: bool = False
    start: int = 0
    text: str = ""
    paired: bool = False


@dataclass
class Meaning:
    """A relation and its anchors: things, or one place (and, for a corner, its walls).

    Attributes:
        both: at both of two sides, so that a number is that of one side where `each` side was said.
        times: how many sides, walls or corners were named with "each".
        told: the anchor was a pronoun, or what was mentioned before.
        pointed: the anchor was not named: "on it", "beside".
        loose: it was said more closely where, and that is not kept: "in the last third of the desk".
        part: at which side of a top: "left", "right", "front", "back", or "both" for one at each end.
        assumed: only a number was said: "a locker for every desk" is one for each, wherever that is.
    """

    kind: str
    anchors: tuple[Mention | str, ...]
    each: bool = False
    both: bool = False
    times: int = 1
    spread: int = 0
    told: bool = False
    pointed: bool = False
    loose: bool = False
    part: str = ""
    assumed: bool = False


@dataclass(eq=False)
class Awaited:
    """A relation whose subject comes later: "on the desk stands a lamp"; `used` once that came."""

    where: Where
    meaning: Meaning
    used: bool = False

    @property
    def kind(self) -> str:
        """The relation."""
        return self.meaning.kind

    @property
    def is_known(self) -> bool:
        """Whether it is to a place, or to what was named before; a new thing is at least asked for."""
        return self.meaning.told or isinstance(self.anchors[0], str)

    @property
    def anchors(self) -> tuple[Mention | str, ...]:
        """What it is to."""
        return self.meaning.anchors
