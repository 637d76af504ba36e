"""What has been understood so far: things, their bonds, the room. Mutable; `read_brief` makes a Brief of it."""

from collections.abc import Collection, Iterable
from dataclasses import dataclass, field

from thinkblox.brief import RelationKind, SurfaceRequest, Word
from thinkblox.knowledge.rooms import room_type
from thinkblox.knowledge.themes import Theme
from thinkblox.reading.sizes import Size

MISSING = "missing"
"""The noun of a thing that we do not have; words can still refer to it."""


@dataclass(eq=False)
class Mention:
    """Objects of one kind that were mentioned together.

    Attributes:
        noun: a category, or a generic noun ("any_table") until its sense is chosen.
        called: what the prompt calls one of them, without its looks; empty where nobody knows.
        count: as said; None for a bare plural.
        owner: what it was said to belong to ("a desk with a chair"), if anything.
        host: the thing whose list it heads, related or not ("a sink with a mirror above it").
        seats: how many people it was said to be for.
        size: lengths said of it.
        general: only said of the whole before the parts ("a shop full of plants: ...", "ten tables: six round ...").
        least, most: how many there may be, where that is left open.
        unshown: what was said of it that we know nothing about.
        states: how it is to be found ("open").
        per: so many for each of these, whatever it is related to ("at every seat a plate").
        groups: how many groups it forms ("three islands of four desks"), and the word for them.
    """

    noun: str
    count: int | None = 1
    vague: bool = False
    plural: bool = False
    rows: int = 0
    attributes: list[str] = field(default_factory=list)
    text: str = ""
    asked: bool = True
    owner: "Mention | None" = None
    host: "Mention | None" = None
    seats: int = 0
    size: Size | None = None
    general: bool = False
    least: int | None = None
    most: int | None = None
    unshown: list[str] = field(default_factory=list)
    states: list[str] = field(default_factory=list)
    per: "list[Mention]" = field(default_factory=list)
    groups: int = 0
    group: str = ""
    called: str = ""

    @property
    def many(self) -> bool:
        """Whether it stands for more than one object."""
        return self.plural or self.count is None or self.count > 1


@dataclass(eq=False)
class Bond:
    """A relation between things, or of a thing to places of the room (strings).

    `told` says that its anchor was not named, but pointed at: "on it", "beside".
    """

    kind: RelationKind
    subject: Mention
    anchors: tuple[Mention | str, ...] = ()
    each: bool = False
    asked: bool = True
    rows: int = 0
    implied: bool = False
    distributed: bool = False
    negated: bool = False
    spread: int = 0
    told: bool = False


class _Subjects:
    """The bonds of a list by their subjects; what is appended to the list is found as well."""

    def __init__(self, bonds: list[Bond]) -> None:
        self._bonds = bonds
        self._seen = 0
        self._by_subject: dict[Mention, list[Bond]] = {}

    def is_of(self, bonds: list[Bond]) -> bool:
        """Whether it is of this very list, from which nothing was taken away."""
        return self._bonds is bonds and self._seen <= len(bonds)

    def bonds_of(self, thing: Mention) -> list[Bond]:
        """The bonds whose subject is `thing`, in their order."""
        self._catch_up()
        return list(self._by_subject.get(thing, ()))

    def leave(self, gone: Collection[Bond], bonds: list[Bond]) -> None:
        """Go on with a list from which some bonds were taken."""
        self._catch_up()
        for bond in gone:
            self._by_subject[bond.subject].remove(bond)
        self._bonds, self._seen = bonds, len(bonds)

    def _catch_up(self) -> None:
        for bond in self._bonds[self._seen :]:
            self._by_subject.setdefault(bond.subject, []).append(bond)
        self._seen = len(self._bonds)


@dataclass(eq=False)
class Gap:
    """A door or window that was asked for; count 0 when there is to be none."""

    kind: str
    count: int
    wall: str = ""


@dataclass
class Draft:
    """Everything read from a prompt.

    Attributes:
        account: what became of the words, as they were read.
        written: the text as it was written, where words were read as others.
        told: what of it was said not to be followed before it was read.
    """

    things: list[Mention] = field(default_factory=list)
    bonds: list[Bond] = field(default_factory=list)
    openings: list[Gap] = field(default_factory=list)
    room: str = ""
    people: int = 0
    apart: bool = False
    sizes: list[Size] = field(default_factory=list)
    room_attributes: list[str] = field(default_factory=list)
    tones: list[tuple[str, ...]] = field(default_factory=list)
    style: list[str] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    beyond: list[str] = field(default_factory=list)
    unknown: list[str] = field(default_factory=list)
    excluded: set[str] = field(default_factory=set)
    empty: bool = False
    speaks_of_front: bool = False
    free: list[str] = field(default_factory=list)
    rooms: list[str] = field(default_factory=list)
    surfaces: list[SurfaceRequest] = field(default_factory=list)
    account: tuple[Word, ...] = ()
    written: str = ""
    told: list[str] = field(default_factory=list)
    themes: list[Theme] = field(default_factory=list)
    dropped: set[Mention] = field(default_factory=set, repr=False, compare=False)
    _subjects: "_Subjects | None" = field(default=None, repr=False, compare=False)

    def shape_room(self, room: str, looks: list[str]) -> list[str]:
        """Take the type of room that a shape means for the room of a type; returns the other looks."""
        shapes = room_type(room).shapes
        meant = [shapes[look] for look in looks if look in shapes] if room == self.room else []
        self.room = meant[0] if meant else self.room
        return [look for look in looks if look not in shapes] if meant else looks

    def bonds_of(self, thing: Mention) -> list[Bond]:
        """The bonds whose subject is `thing`."""
        return self._known_subjects().bonds_of(thing)

    def _known_subjects(self) -> "_Subjects":
        if self._subjects is None or not self._subjects.is_of(self.bonds):
            self._subjects = _Subjects(self.bonds)
        return self._subjects

    def unsay(self, bonds: Iterable[Bond]) -> None:
        """Forget some bonds."""
        if gone := list(bonds):
            known = self._known_subjects()
            self.bonds = [bond for bond in self.bonds if bond not in gone]
            known.leave(gone, self.bonds)

    def hand_over(self, bond: Bond, subject: Mention) -> None:
        """Say of another thing what a bond says; nothing else may change the subject of a bond."""
        bond.subject = subject
        self._subjects = None

    def drop(self, thing: Mention) -> None:
        """Forget a thing and its bonds."""
        self.things = [t for t in self.things if t is not thing]
        self.dropped.add(thing)
        self.unsay(b for b in self.bonds if b.subject is thing or thing in b.anchors)
