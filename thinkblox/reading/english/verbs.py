"""What verbs and participles say of their subjects."""

from thinkblox.reading.english.chunks import Link, Noun
from thinkblox.reading.english.nodes import Frame
from thinkblox.reading.english.prepositions import Prepositions


class Verbs(Prepositions):
    """Reads verbs."""

    def _verb(self, link: Link) -> None:
        text = link.text.lower()
        if link.value == "put":
            self.existential |= not self.clause.members
            if not self.clause.members and not self.front:
                return
            if self.subject is None and self.clause.members and not self.separator:
                self.subject = self._whole_subject()
                self._open_of_subject("with")
            return
        if link.value == "other":
            self.frontier, self.subject, self.pending = [], None, None
            return
        if link.value == "leave":
            self.leaving = True
            return
        if text.startswith(("there", "here", "you ", "we ")):
            if self.clause.members:
                self._begin_again()
            self.existential = True
            return
        last = self.chunks[self.at - 2] if self.at >= 2 else None
        if self.outer is not None and self._is_link(last, "mark", "comma", "close") and not self.front_only():
            self.subject, self.outer = self.outer, None
        elif self.relative is not None:
            self.subject = self.relative
            self.relative = None
        elif self.subject is None or (self.clause.members and not self.predicate):
            self.subject = self._whole_subject()
        if self.subject is None and link.value in ("be", "stand", "hang", "serve"):
            return
        self._predicate(link)

    def front_only(self) -> bool:
        """Whether only a relation, and nothing that it is about, has been read."""
        return bool(self.front) and not self.clause.members

    def _predicate(self, link: Link) -> None:
        self.predicate = True
        self.verb = link.value
        if self.subject is not None:
            self.frontier = [self.subject]
        self.separator = ""
        match link.value:
            case "have" | "consist":
                self._have(link.value)
            case "hold" | "carry":
                self._open_of_subject(link.value)
            case "face":
                self._where(self._read_where(Link("prepositions", "facing", 0, 0)))
            case "surround":
                self._where(self._read_where(Link("prepositions", "around", 0, 0)))
            case "flank":
                self._flank()
            case "line":
                self._where(self._read_where(Link("prepositions", "along", 0, 0)))
            case "share":
                self._have_shared()
            case "serve":
                self._as()
            case "seat":
                self._seat()
            case "hang":
                if (
                    self._is_link(self.peek(), "prepositions", "from")
                    and (n := self._next_noun(1))
                    and n.kind == "thing"
                ):
                    self.at += 1
                    self._where(self._read_where(Link("prepositions", "next_to", 0, 0)))

    def _seat(self) -> None:
        """Read "a table that seats ten"."""
        noun = self._next_noun()
        thing = self.subject.thing if self.subject is not None else None
        if noun is not None and noun.count and noun.kind in ("number", "people") and thing is not None:
            thing.seats = noun.count
            self.at = self.chunks.index(noun, self.at) + 1

    def _have(self, kind: str) -> None:
        if self.subject is None and self.crowd:
            self.pending = self.clause = Frame(None, "list", times=self.crowd, each=True)
            self.crowd = 0
            return
        if self.subject is None:
            return
        following = self.peek()
        if isinstance(following, Noun) and following.kind == "abstract":
            self.at += 1
            return
        thing = self.subject.thing
        if thing is not None and thing in self.groups.values() and (kind == "consist" or self.subject.each):
            self._dissolve(thing)
            return
        self._open_of_subject("with")

    def _have_shared(self) -> None:
        if self.subject is None or self.subject.thing is None:
            return
        every = self.each_of
        frame = Frame(self.subject, "next_to")
        if every:
            frame.times = max(1, (self.subject.thing.count or every) // every)
            self.each_of = 0
        self.pending = frame

    def _flank(self) -> None:
        where = self._read_where(Link("prepositions", "next_to", 0, 0))
        self._where(where)

    def _participle(self, kind: str) -> None:
        match kind:
            case "hold" | "carry":
                self._open(kind)
            case "surround":
                self._where(self._read_where(Link("prepositions", "around", 0, 0)))
            case "flank":
                self._flank()
            case "line":
                self._where(self._read_where(Link("prepositions", "along", 0, 0)))
            case "hang":
                if (
                    self._is_link(self.peek(), "prepositions", "from")
                    and (n := self._next_noun(1))
                    and n.kind == "thing"
                ):
                    self.at += 1
                    self._where(self._read_where(Link("prepositions", "next_to", 0, 0)))
