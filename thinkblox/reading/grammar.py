"""Items to a draft: a small grammar of English-like clauses, read in one pass with a few words of memory.

Four things are remembered: `current`, the thing mentioned last; `frame`, an open list of what a thing has ("a desk with
a lamp, a laptop and ..."); `waiting`, a relation whose anchor comes next ("next to ..."); and `front`, a relation whose
subject comes next ("on the desk stands ...").
"""

from dataclasses import dataclass, field
from itertools import pairwise

from thinkblox.brief import RelationKind
from thinkblox.reading.attach import bind, place_bond, relation_kind, subjects_of
from thinkblox.reading.draft import Bond, Draft, Gap, Thing
from thinkblox.reading.habits import load_habits
from thinkblox.reading.phrases import Item, Link, Phrase, Unknown
from thinkblox.reading.reference import References, are_alike
from thinkblox.reading.sizes import Size

_LISTED = ("on", "at", "around")
_TAKES_BOOKS = ("bookcase", "any_shelf", "wall_shelf", "shelving_unit")


@dataclass
class _Frame:
    """An open list of what `head` has; `kind` is "with" where the words do not say how."""

    head: Thing
    kind: str
    each: bool = False
    closing: bool = False
    members: list[Thing] = field(default_factory=list)


@dataclass
class _Waiting:
    """A relation whose anchor has not been read yet."""

    kind: str
    subject: Thing | None
    fronted: bool = False


@dataclass
class _Front:
    """A relation, anchor and all, whose subject has not been read yet."""

    kind: str
    anchors: tuple[Thing | str, ...]
    each: bool


class Walker:
    """Reads the items of one prompt into a draft."""

    def __init__(self, items: list[Item]) -> None:
        self.items = items
        self.at = 0
        self.draft = Draft()
        self.references = References(self.draft)
        self.habits = load_habits()
        self.current: Thing | None = None
        self.opening: Gap | None = None
        self.frame: _Frame | None = None
        self.waiting: _Waiting | None = None
        self.front: _Front | None = None
        self.run: list[Thing] = []
        self.chain: Thing | None = None
        self.fresh = True
        self.separator = "stop"
        self.negating = False
        self.only = False
        self.general = False
        self.deaf = False
        self.strays: list[str] = []

    def walk(self) -> Draft:
        """Read everything."""
        for self.at, item in enumerate(self.items):
            if isinstance(item, Unknown):
                self.strays.append(item.text)
                continue
            self._strays(item)
            if isinstance(item, Link):
                self._link(item)
            elif isinstance(item, Size):
                self._size(item)
            else:
                self._phrase(item)
        self._strays(Link("stop"))
        self._elided()
        return self.draft

    def _next(self, ahead: int = 1) -> Item | None:
        index = self.at + ahead
        return self.items[index] if index < len(self.items) else None

    def _strays(self, item: Item) -> None:
        """Unknown words that fill a place in a list are things we do not have; others are only listed."""
        if not self.strays:
            return
        ends = isinstance(item, Link) and item.kind in ("comma", "stop", "and", "relation", "having", "or", "colon")
        listed = bool(self.separator) and not (self.separator == "stop" and not self.draft.things)
        words, self.strays = self.strays, []
        if ends and listed and len(words) <= 3 and not self.negating:
            self.draft.missing.append(" ".join(words))
        else:
            self.draft.unknown += words
        self.separator = ""

    # Links ------------------------------------------------------------------------------------------------------------

    def _link(self, link: Link) -> None:
        match link.kind:
            case "comma" | "stop" | "colon" | "and" | "or" | "but":
                self._separate(link.kind)
            case "no":
                self._elided()
                self.negating = True
            case "nothing":
                self.draft.empty = True
            case "only":
                self.only = True
            case "relation":
                self._relation(link.value)
            case "having":
                self._having(link.value)
            case "adverb":
                self._adverb(link.value)
            case "mutual":
                self._mutual(self.waiting.kind if self.waiting else "facing")
                self.waiting = None

    def _separate(self, kind: str) -> None:
        self._elided()
        if kind in ("stop", "colon"):
            self.frame = self.front = None
            self.run, self.fresh, self.deaf = [], True, False
            self.current = None if kind == "colon" else self.current
        elif kind == "and" and self.frame is not None:
            self.frame.closing = True
        elif kind == "comma" and self.frame is not None and self.frame.closing and not self._and_follows():
            self.frame = None
        if kind != "or" and not (kind == "and" and self.negating and self._next_is("or")):
            self.negating = False
        self.chain = None
        self.separator = kind if self.separator != "stop" or kind != "comma" else "stop"

    def _and_follows(self) -> bool:
        return self._next_is("and")

    def _next_is(self, kind: str) -> bool:
        following = self._next()
        return isinstance(following, Link) and following.kind == kind

    def _relation(self, kind: str) -> None:
        self._elided()
        fronted = self.fresh or (bool(self.separator) and self._leads())
        self.waiting = _Waiting(kind, None if fronted else self.current, fronted)
        self.separator = ""

    def _leads(self) -> bool:
        """Whether a noun phrase comes right after the anchor: "..., by the window a desk"."""
        anchor, following = self._next(), self._next(2)
        if not isinstance(anchor, Phrase) or not isinstance(following, Phrase):
            return False
        return following.kind == "object" and not following.definite

    def _having(self, kind: str) -> None:
        self._elided()
        self.separator = "having"
        if kind == "full":
            self._full()
            return
        if self.deaf:
            return
        head = self.current
        each = self._previous_is_each()
        if each and head is not None:
            head = next(iter(self.references.several(None, "each")), head) if not head.many else head
        self.front = None
        self.chain = None
        self.run = []
        self.frame = _Frame(head, kind, each=each) if head is not None else None

    def _previous_is_each(self) -> bool:
        previous = self.items[self.at - 1] if self.at else None
        return isinstance(previous, Phrase) and previous.each

    def _full(self) -> None:
        """ "a bookcase full of books" describes the bookcase; "shelves filled with jars" asks for jars."""
        contents = self._next()
        head = self.current
        if head is None:
            self.general = True
            return
        books = isinstance(contents, Phrase) and contents.value in ("book", "magazine") and head.noun in _TAKES_BOOKS
        if not isinstance(contents, Phrase) or books or not self.habits.is_in(head.noun, "surfaces"):
            head.attributes.append("filled")
            self.waiting = _Waiting("of", head)
        else:
            self.frame = _Frame(head, "carry")

    def _adverb(self, value: str) -> None:
        self._elided()
        if value.startswith("mutual_"):
            self._mutual(value.removeprefix("mutual_"))
        elif value == "per" and self.separator == "having" and self.frame is not None:
            self.frame.each = True
        elif value == "per":
            self.waiting = _Waiting("per", self.current)
        elif value == "in_centre" and self._object_of():
            self.waiting = _Waiting("on", self.current)
        elif value == "in_centre":
            self._attach("in", ("centre",), subject=self.current)
        elif value != "with":
            following = self._next()
            fronted = isinstance(following, Phrase) and following.kind == "object" and bool(self.separator)
            anchors = self._antecedent(None if fronted else self.current, value)
            if fronted:
                self.front = _Front(value, anchors, each=False)
            else:
                self._attach(value, anchors, subject=self.current, pronoun=True)

    def _object_of(self) -> bool:
        """Whether "of <object>" comes next: "in the middle of the table"."""
        second = self._next(2)
        return self._next_is("of") and isinstance(second, Phrase) and second.kind == "object"

    def _mutual(self, kind: str) -> None:
        """ "facing each other", "side by side", "in a row": of one plural thing, or of two that were joined."""
        current = self.current
        if current is None:
            return
        if kind in ("in_rows", "in_row"):
            bind(self.draft, Bond("in_rows", current, rows=1 if kind == "in_row" else 0))
        elif current.many or len(self.run) < 2:
            bind(self.draft, Bond(relation_kind(kind), current, (current,)))
        else:
            for one, other in pairwise(self.run[-2:]):
                bind(self.draft, Bond(relation_kind(kind), other, (one,)))

    def _elided(self) -> None:
        """A relation without an anchor points back: "a whiteboard opposite"."""
        waiting, self.waiting = self.waiting, None
        if waiting is None or waiting.kind in ("of", "for", "in", "at", "on", "per", "along"):
            return
        subject = waiting.subject
        if subject is not None:
            self._attach(waiting.kind, self._antecedent(subject, waiting.kind), subject=subject, pronoun=True)

    def _antecedent(self, subject: Thing | None, kind: str) -> tuple[Thing | str, ...]:
        if kind == "between":
            return self.references.several(subject, kind)
        found = self.references.beside(subject, kind)
        return (found,) if found is not None else ()

    # Phrases ----------------------------------------------------------------------------------------------------------

    def _phrase(self, phrase: Phrase) -> None:
        self.draft.style += [] if self.negating else phrase.styles
        if phrase.kind == "object" and phrase.room and not self.draft.room and not self.draft.things:
            phrase.kind, phrase.value = "room", phrase.room
        if self._is_excluded(phrase):
            return
        if self.waiting is not None and self.waiting.kind == "of":
            self.waiting = None
            return
        handler = getattr(self, f"_{phrase.kind}", None)
        if self.waiting is not None:
            self._anchor(phrase)
        elif handler is not None:
            handler(phrase)
        if phrase.kind not in ("ignored", "adjective"):
            self.separator = ""

    def _is_excluded(self, phrase: Phrase) -> bool:
        none = phrase.count == 0
        if not (self.negating or none) or phrase.kind not in ("object", "place", "missing", "room"):
            return False
        if phrase.kind == "object":
            self.draft.excluded.add(phrase.value)
        elif phrase.value in ("window", "door"):
            self.draft.openings.append(Gap(phrase.value, 0))
        self.waiting = None
        return True

    def _object(self, phrase: Phrase) -> None:
        """An object that is no anchor: a member of a list, the subject of what stood in front, or a new thing."""
        if (phrase.definite or phrase.each) and (known := self.references.named(phrase)) and not self._is_new(phrase):
            self.frame = None
            self._mentioned(known)
            return
        thing = self._new(phrase)
        if self.front is not None:
            self._take_front(thing)
        elif self.frame is not None:
            self._take_member(thing)
        if self.frame is None and len(self.run) and self.separator == "and":
            self.references.pairs.append((self.run[-1], thing))
        self.run.append(thing)
        self._mentioned(thing)

    def _is_new(self, phrase: Phrase) -> bool:
        """ "the two small chairs" after "a chair": a count that does not fit makes it another thing."""
        known = self.references.named(phrase)
        return bool(known and phrase.count and known.count and phrase.count > known.count)

    def _mentioned(self, thing: Thing) -> None:
        self.current = thing
        self.references.mention(thing)
        self.opening = None
        self.fresh = False
        self.chain = self.chain or thing

    def _new(self, phrase: Phrase) -> Thing:
        rows = phrase.rows
        count = phrase.count if phrase.count is not None else (None if phrase.plural else 1)
        if rows > 0 and count is not None:
            count *= rows
        thing = Thing(phrase.value, count, phrase.vague, phrase.plural, rows, phrase.attributes, phrase.text)
        self.draft.things.append(thing)
        if rows:
            self.draft.bonds.append(Bond("in_rows", thing, rows=max(rows, 0)))
        if phrase.size:
            self.draft.unknown.append(phrase.size.text)
        thing.general, self.general = self.general, False
        if self.only:
            self.draft.empty, self.only = True, False
        return thing

    def _take_front(self, thing: Thing) -> None:
        front = self.front
        if front is None:
            return
        listed = self.separator in ("and", "comma") and self.run
        if listed and front.kind == "on" and not self.habits.is_in(thing.noun, "small", "fitted"):
            self.front = None
            return
        self._attach(front.kind, front.anchors, subject=thing, pronoun=True, each=front.each)
        if front.kind not in ("on", "above"):
            self.front = None

    def _take_member(self, thing: Thing) -> None:
        frame = self.frame
        if frame is None:
            return
        tie = self._tie(thing, frame)
        first = not frame.members
        thing.host = frame.head if first or tie is not None else None
        if tie is None or (not first and self.separator == "comma" and tie not in _LISTED):
            self.frame = frame if first and self.separator == "having" and tie is None and frame.each else None
            return
        thing.owner = frame.head
        frame.members.append(thing)
        each = frame.each or _shares(thing, frame.head, tie)
        bind(self.draft, Bond(tie, thing, (frame.head,), each=each, implied=frame.kind == "with"))

    def _tie(self, thing: Thing, frame: _Frame) -> RelationKind | None:
        """How a listed thing belongs to the head; None when it does not, which ends the list."""
        usual = self.habits.tie(thing.noun, frame.head.noun)
        small = self.habits.is_in(thing.noun, "small")
        match frame.kind:
            case "carry":
                fits = small or self.habits.is_in(thing.noun, "fitted")
                return "on" if fits or not frame.members or usual == "on" else None
            case "with":
                carries = self.habits.is_in(frame.head.noun, "surfaces")
                return usual or ("on" if small and carries else "next_to" if frame.each else None)
        return relation_kind(frame.kind) if not frame.members or self.separator == "and" else None

    def _pronoun(self, phrase: Phrase) -> None:
        """A pronoun that is no anchor: "four chairs each" shares out; "it has ..." goes back to what was mentioned."""
        following = self._next()
        having = isinstance(following, Link) and following.kind == "having"
        if phrase.value == "each" and not having:
            members = self.frame.members if self.frame else [self.current] if self.current else []
            for bond in (b for thing in members for b in self.draft.bonds_of(thing) if b.anchors):
                bond.each = True
        elif phrase.value in ("it", "them") and self.fresh:
            found = self.references.single(None, "") if phrase.value == "it" else None
            self.current = found or (self.references.several(None, "") or (None,))[0]
            self.fresh = False

    def _place(self, phrase: Phrase) -> None:
        """A door or window that is asked for; other places say nothing by themselves."""
        if phrase.value in ("window", "door") and not phrase.definite:
            self.opening = Gap(phrase.value, phrase.count or (2 if phrase.plural else 1))
            self.draft.openings.append(self.opening)
            self.current, self.frame, self.fresh = None, None, False

    def _room(self, phrase: Phrase) -> None:
        if not self.draft.room or self.draft.room == "room":
            self.draft.room = phrase.value
        self.draft.room_attributes += phrase.attributes
        self.draft.empty |= "empty" in phrase.attributes
        if phrase.size:
            self.draft.sizes.append(phrase.size)
        if not phrase.definite and not self.draft.things:
            self.current = None

    def _size(self, size: Size) -> None:
        before = [item for item in self.items[max(0, self.at - 2) : self.at] if item != Link("of")]
        of_thing = bool(before) and isinstance(before[-1], Phrase) and before[-1].kind == "object"
        following = self._next()
        ceiling = isinstance(following, Phrase) and following.value == "ceiling"
        single = len(size.lengths) == 1 and size.area is None and not size.lengths[0].axis
        if of_thing or (single and not ceiling and self.draft.things):
            self.draft.unknown.append(size.text)
        else:
            self.draft.sizes.append(size)

    def _people(self, phrase: Phrase) -> None:
        self._number(phrase)

    def _number(self, phrase: Phrase) -> None:
        """ "for six (people)", "seats eight": of the table just mentioned, or of the room."""
        if not phrase.count:
            return
        if self.current is not None and self.habits.is_in(self.current.noun, "tables", "desks"):
            self.current.seats = phrase.count
        elif not self.draft.things:
            self.draft.people = phrase.count

    def _adjective(self, phrase: Phrase) -> None:
        if self.current is None or phrase.attributes == ["L-shaped"]:
            self.draft.room_attributes += phrase.attributes
        else:
            self.current.attributes += phrase.attributes

    def _missing(self, phrase: Phrase) -> None:
        self.draft.missing.append(phrase.text)
        self.current, self.fresh = None, False

    def _gap(self, phrase: Phrase) -> None:
        """Aisles and gaps are no objects; what is said of them next is not about the thing before."""
        self.current = None

    def _rows(self, phrase: Phrase) -> None:
        if self.current is not None:
            bind(self.draft, Bond("in_rows", self.current, rows=max(phrase.rows, 0)))

    # Anchors ----------------------------------------------------------------------------------------------------------

    def _anchor(self, phrase: Phrase) -> None:
        """The noun phrase after a preposition."""
        waiting, self.waiting = self.waiting, None
        if waiting is None:
            return
        if phrase.kind in ("rows", "people", "number", "room", "missing", "adjective"):
            getattr(self, f"_{phrase.kind}")(phrase)
            return
        kind, anchors = self._resolve(phrase, waiting)
        if not anchors:
            return
        each = phrase.each
        if waiting.fronted and self._fronts(phrase):
            self.front = _Front(kind, anchors, each)
            return
        self._attach(kind, anchors, subject=waiting.subject, pronoun=phrase.kind == "pronoun", each=each)
        if phrase.kind == "object" and isinstance(anchors[0], Thing):
            self.current = anchors[0]
            self.references.mention(anchors[0])
            self.run = []

    def _fronts(self, phrase: Phrase) -> bool:
        return phrase.kind in ("object", "place", "pronoun", "part")

    def _resolve(self, phrase: Phrase, waiting: _Waiting) -> tuple[str, tuple[Thing | str, ...]]:
        kind, subject = waiting.kind, waiting.subject
        match phrase.kind:
            case "pronoun" if phrase.value == "it":
                return kind, self._antecedent(subject, kind)
            case "pronoun" if phrase.value == "each":
                return kind, self.references.shared(subject)
            case "pronoun":
                return kind, self.references.several(subject, kind)
            case "place" if (thing := self._whole(phrase)) is not None:
                return ("on" if phrase.value == "centre" else "next_to"), (thing,)
            case "place":
                return kind, (phrase.value,)
            case "part":
                return self._part_of(phrase, kind), self._antecedent(
                    subject, "at_foot_of" if phrase.value == "foot" else ""
                )
            case "object":
                return kind, self._named(phrase, kind)
        return kind, ()

    def _whole(self, phrase: Phrase) -> Thing | None:
        """The object of "the middle of the table"; None where it is the room's."""
        second = self._next(2)
        if not self._object_of() or not isinstance(second, Phrase):
            return None
        self.items[self.at + 2] = Phrase("ignored", "")
        return self.references.named(second) or self._new(second)

    def _part_of(self, phrase: Phrase, kind: str) -> str:
        return {"foot": "at_foot_of", "side": "next_to", "head": "next_to", "top": "on"}[phrase.value]

    def _named(self, phrase: Phrase, kind: str) -> tuple[Thing | str, ...]:
        """The thing an anchor phrase names, and a second one after "between ... and"."""
        known = self.references.named(phrase) if phrase.definite or phrase.each or phrase.whose else None
        thing = known or self._new(phrase)
        second = self._next(2)
        if kind == "between" and not thing.many and self._next_is("and") and isinstance(second, Phrase):
            if second.kind == "object":
                other = self.references.named(second) if second.definite else None
                other = other or self._new(second)
                self.items[self.at + 2] = Phrase("ignored", "")
                return (thing, other)
        return (thing,)

    def _attach(
        self,
        kind: str,
        anchors: tuple[Thing | str, ...],
        *,
        subject: Thing | None,
        pronoun: bool = False,
        each: bool = False,
    ) -> None:
        """Bind what the words relate; a place of the room may belong to a door or window just mentioned."""
        if not anchors:
            return
        if isinstance(anchors[0], str):
            self._attach_place(kind, anchors[0], subject, each=each)
            return
        if subject is None or (kind == "per" and not isinstance(anchors[0], Thing)):
            return
        if kind in ("per", "for"):
            tie = self.habits.tie(subject.noun, anchors[0].noun) or "next_to"
            bind(self.draft, Bond(tie, subject, anchors, each=kind == "per" or each))
            return
        if kind == "in" and not self.habits.is_in(anchors[0].noun, "surfaces"):
            kind = "on"
        relation = relation_kind(kind)
        if relation == "between" and self.chain is not None and not pronoun:
            subject = self.chain
        elif relation == "between" and self.chain is not None and subject not in (None, self.chain):
            subject = self.chain
        for one in subjects_of(subject, kind, anchors, self.run, pronoun=pronoun and relation != "between"):
            bind(self.draft, Bond(relation, one, anchors, each=each))
            if len(anchors) == 1 and relation in ("next_to", "facing", "opposite", "left_of", "right_of", "near"):
                self.references.pairs.append((one, anchors[0]))

    def _attach_place(self, kind: str, place: str, subject: Thing | None, *, each: bool) -> None:
        if self.opening is not None and place.endswith("_wall") and subject is None:
            self.opening.wall = place
            return
        meant = place_bond(kind, place)
        if subject is None or meant is None:
            return
        for one in subjects_of(subject, meant[0], (place,), self.run, pronoun=False):
            bind(self.draft, Bond(meant[0], one, (meant[1],), each=each))


def _shares(thing: Thing, head: Thing, tie: str) -> bool:
    """Whether "two desks with a chair" means a chair at each."""
    if head.count is None or head.count < 2 or thing.vague:
        return False
    if thing.count is None:
        return tie in ("on", "at", "around")
    return thing.count == 1 or (
        tie == "around" and thing.count < 2 * head.count and not are_alike(thing.noun, head.noun)
    )
