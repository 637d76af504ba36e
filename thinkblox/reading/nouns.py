"""What each kind of noun phrase does: name a thing, a room, a door, a number of people, or anchor a relation."""

from thinkblox.reading.attach import bind
from thinkblox.reading.draft import MISSING, Bond, Gap, Mention
from thinkblox.reading.memory import Front, Waiting
from thinkblox.reading.parts import Parts
from thinkblox.reading.phrases import Connective, Phrase
from thinkblox.reading.sizes import Size

_OF = (Connective("of"), Connective("which"), Connective("comma", "("), Connective("comma", ""))
"""What can stand between a thing and its size."""
_ROOMY = 3.0
"""Two sides that are both longer than this are a room's, whatever they stand beside [m]."""


class Nouns(Parts):
    """Reads noun phrases into the draft."""

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
            self.mention(known)
            return
        if self._is_capacity(phrase):
            return
        thing = self.new_thing(phrase)
        if self.front is not None:
            self.take_front(thing)
        elif self.frame is not None:
            self.take_member(thing)
        if self.frame is None and len(self.run) and self.separator == "and":
            self.references.pairs.append((self.run[-1], thing))
        self.run.append(thing)
        self.joined = self.separator == "and"
        self.mention(thing)

    def _is_capacity(self, phrase: Phrase) -> bool:
        """Whether "(3 seats)" only says how large the sofa before it is."""
        sofa = self.current
        bracket = self.items[self.at - 1] == Connective("comma", "(")
        if not bracket or sofa is None or phrase.text.split()[-1] not in ("seats", "seat") or not phrase.count:
            return False
        sofa.attributes.append(f"{phrase.count}-seat")
        return True

    def _is_new(self, phrase: Phrase) -> bool:
        """Whether a count does not fit, so that it is another thing: "the two small chairs" after "a chair"."""
        known = self.references.named(phrase)
        return bool(known and phrase.count and known.count and phrase.count > known.count)

    def _pronoun(self, phrase: Phrase) -> None:
        """A pronoun that is no anchor: "four chairs each" shares out; "it has ..." goes back to what was mentioned."""
        following = self.next_item()
        having = isinstance(following, Connective) and following.kind == "having"
        if phrase.value == "each" and not having:
            members = self.frame.members if self.frame else [self.current] if self.current else []
            for bond in (b for thing in members for b in self.draft.bonds_of(thing) if b.anchors):
                bond.each = True
            self.frame = None
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
        self.draft.room_attributes += self.draft.shape_room(phrase.value, phrase.attributes)
        self.draft.empty |= "empty" in phrase.attributes
        if phrase.size:
            self.draft.sizes.append(phrase.size)
        if not phrase.definite and not self.draft.things:
            self.current = None

    def _size(self, size: Size) -> None:
        """Read a size: of the object just before or after it, or of the room."""
        before = [item for item in self.items[max(0, self.at - 2) : self.at] if item not in _OF]
        of_thing = bool(before) and isinstance(before[-1], Phrase) and before[-1].kind == "object"
        following = self.next_item()
        ceiling = isinstance(following, Phrase) and following.value == "ceiling"
        single = len(size.lengths) == 1 and size.area is None
        roomy = not single and min(length.metres for length in size.lengths) > _ROOMY
        if roomy and not self.draft.sizes:
            self.draft.sizes.append(size)
        elif isinstance(following, Connective) and following.kind == "relation":
            self.draft.unknown.append(size.text)
        elif isinstance(following, Phrase) and following.kind == "object" and not following.size:
            following.size = size
        elif self.current is not None and not ceiling and (of_thing or (single and size.area is None)):
            self.current.size = self.current.size or size
        elif single and not size.lengths[0].axis and self.draft.things:
            self.draft.unknown.append(size.text)
        else:
            self.draft.sizes.append(size)

    def _all(self, phrase: Phrase) -> None:
        """Let "all" be everything in the list just read."""
        owner = self.current.owner if self.current is not None else None
        self.everyone = [t for t in self.run if t.owner is None] or ([owner] if owner is not None else [])

    def _number(self, phrase: Phrase) -> None:
        if not self._ones(phrase):
            self._people(phrase)

    def _people(self, phrase: Phrase) -> None:
        """Read "for six (people)", "seats eight": of the table just mentioned, or of the room."""
        if not phrase.count:
            return
        if self.current is not None and self.habits.is_in(self.current.noun, "tables", "desks"):
            self.current.seats = phrase.count
        elif not self.draft.things:
            self.draft.people = phrase.count

    def _adjective(self, phrase: Phrase) -> None:
        if phrase.count and self._parted_by_looks(phrase):
            return
        if self.current is None or phrase.attributes == ["L-shaped"]:
            self.draft.room_attributes += phrase.attributes
        else:
            self.current.attributes += phrase.attributes

    def _missing(self, phrase: Phrase) -> None:
        self.draft.missing.append(phrase.text)
        thing = Mention(MISSING, text=phrase.text)
        self.joined = self.separator == "and"
        self.run.append(thing)
        self.mention(thing)

    def _gap(self, phrase: Phrase) -> None:
        """Aisles and gaps are no objects; what is said of them next is not about the thing before."""
        self.current = None

    def _rows(self, phrase: Phrase) -> None:
        if self.current is not None:
            bind(self.draft, Bond("in_rows", self.current, rows=max(phrase.rows, 0)))

    def _anchor(self, phrase: Phrase) -> None:
        """The noun phrase after a preposition."""
        waiting, self.waiting = self.waiting, None
        if waiting is None:
            return
        if phrase.kind == "missing" and phrase.definite and (known := self.references.called(phrase)):
            phrase.kind, phrase.value = "object", known.noun
        one = phrase.kind == "number" and phrase.count == 1 and waiting.kind != "for" and waiting.subject is not None
        if one or phrase.kind == "other":
            self._one_of(waiting, phrase)
        elif phrase.kind in ("rows", "people", "number", "room", "missing", "adjective"):
            if (phrase.kind, waiting.kind) not in (("missing", "for"), ("rows", "between")):
                getattr(self, "_people" if phrase.kind == "number" else f"_{phrase.kind}")(phrase)
        else:
            self._bind_to(phrase, waiting)

    def _bind_to(self, phrase: Phrase, waiting: Waiting) -> None:
        """Relate what waits to the thing or place that a phrase names, or keep the place for what follows."""
        kind, anchors = self.resolve(phrase, waiting)
        if not anchors:
            return
        each = phrase.each
        if waiting.fronted and self._fronts(phrase):
            self.front = Front(kind, anchors, each)
            return
        if isinstance(anchors[0], str):
            self.attach_place(kind, anchors[0], waiting.subject, each=each, places=phrase.count or 1)
            return
        self.attach(kind, anchors, subject=waiting.subject, pronoun=phrase.kind == "pronoun", each=each)
        if phrase.kind == "object" and isinstance(anchors[0], Mention):
            self.current = anchors[0]
            self.references.mention(anchors[0])
            self.run = []

    def _fronts(self, phrase: Phrase) -> bool:
        return phrase.kind in ("object", "place", "pronoun", "part")
