"""What the grammar remembers while it reads: the thing mentioned last, open lists, relations that wait for a noun."""

from dataclasses import dataclass, field

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Bond, Draft, Gap, Mention
from thinkblox.reading.phrases import Connective, Item, Phrase
from thinkblox.reading.reference import References


@dataclass
class OpenList:
    """An open list of what `head` has; `kind` is "with" where the words do not say how."""

    head: Mention
    kind: str
    each: bool = False
    closing: bool = False
    members: list[Mention] = field(default_factory=list)


@dataclass
class Waiting:
    """A relation whose anchor has not been read yet; `shared` in "four chairs each facing a mirror"."""

    kind: str
    subject: Mention | None
    fronted: bool = False
    shared: bool = False


@dataclass
class Front:
    """A relation, anchor and all, whose subject has not been read yet."""

    kind: str
    anchors: tuple[Mention | str, ...]
    each: bool


class Memory:
    """The state of reading one prompt.

    Attributes:
        items, at: what is read, and where we are.
        current: the thing mentioned last, which a relation that follows is about.
        opening: the door or window mentioned last.
        frame: an open list of what a thing has ("a desk with a lamp, a laptop and ...").
        waiting: a relation whose anchor comes next ("next to ...").
        front: a relation whose subject comes next ("on the desk stands ...").
        run: things that were listed side by side.
        everyone: what "all" of a list means, until its relation has been read.
        parted: several alike of which "one" was put somewhere and "the other" still has to be.
        begun: how many things there were before this sentence.
        joined: "and" stood before the thing mentioned last.
        sided: "on the left" was said of the room.
        chain: the first thing since the last comma or "and".
        fresh: nothing has been mentioned in this sentence.
        separator: what stood just before ("comma", "and", "having", "stop"); empty after a phrase.
        negating, only, general: "no ...", "nothing but ...", "full of ..." was said of what comes next.
        strays: unknown words that have not been dealt with.
    """

    def __init__(self, items: list[Item]) -> None:
        self.items = items
        self.at = 0
        self.draft = Draft()
        self.references = References(self.draft)
        self.habits = load_habits()
        self.current: Mention | None = None
        self.opening: Gap | None = None
        self.frame: OpenList | None = None
        self.waiting: Waiting | None = None
        self.front: Front | None = None
        self.run: list[Mention] = []
        self.everyone: list[Mention] = []
        self.parted: Mention | None = None
        self.sided = False
        self.joined = False
        self.begun = 0
        self.chain: Mention | None = None
        self.fresh = True
        self.separator = "stop"
        self.negating = False
        self.only = False
        self.general = False
        self.strays: list[str] = []

    def next_item(self, ahead: int = 1) -> Item | None:
        """Return the item so many further on; None past the end."""
        index = self.at + ahead
        return self.items[index] if index < len(self.items) else None

    def next_is(self, kind: str) -> bool:
        """Whether a link of this kind comes next."""
        following = self.next_item()
        return isinstance(following, Connective) and following.kind == kind

    def object_of(self) -> bool:
        """Whether "of <object>" comes next: "in the middle of the table"."""
        second = self.next_item(2)
        return self.next_is("of") and isinstance(second, Phrase) and second.kind == "object"

    def mention(self, thing: Mention) -> None:
        """Make a thing the one that is spoken of."""
        self.current = thing
        self.references.mention(thing)
        self.opening = None
        self.fresh = False
        self.chain = self.chain or thing

    def new_thing(self, phrase: Phrase) -> Mention:
        """Add the thing that a phrase asks for."""
        rows = phrase.rows
        count = phrase.count if phrase.count is not None else (None if phrase.plural else 1)
        if rows > 0 and count is not None:
            count *= rows
        thing = Mention(phrase.value, count, phrase.vague, phrase.plural, rows, phrase.attributes, phrase.text)
        thing.seats = phrase.seats
        self.draft.things.append(thing)
        if rows:
            self.draft.bonds.append(Bond("in_rows", thing, rows=max(rows, 0)))
        thing.size = phrase.size
        thing.general, self.general = self.general, False
        if self.only:
            self.draft.empty, self.only = True, False
        return thing

    def antecedent(self, subject: Mention | None, kind: str, noun: str = "") -> tuple[Mention | str, ...]:
        """Return what a pronoun, or no anchor at all, points back to; `noun` stands for a subject to come."""
        if kind == "between":
            return self.references.several(subject, kind)
        found = self.references.beside(subject, kind, noun)
        return (found,) if found is not None else ()
