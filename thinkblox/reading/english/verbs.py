"""What verbs and participles say of their subjects."""

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Listed, Node
from thinkblox.reading.english.prepositions import Prepositions

_STANDS = {"face": "facing", "face_away": "facing_away", "surround": "around", "flank": "sides", "line": "along"}
"""Verbs that say how the subject stands to their object, as the prepositions of the same meaning."""


def _held(link: Connector) -> str:
    """How what is held stands to its holder; what it contains is inside of it."""
    return "inside" if link.text.lower().startswith("contain") else link.value


class Verbs(Prepositions):
    """Reads verbs."""

    def _verb(self, link: Connector) -> None:
        before = self._before()
        if (
            link.text.lower() == "stands"
            and isinstance(before, Connector)
            and self._is_link(before, "prepositions", "on")
        ):
            self._lose(before.start, link.end)
            return
        match link.value:
            case "put":
                self._put()
            case "other":
                self._do_something(link)
            case "leave":
                self.leaving = True
            case _ if link.text.lower().startswith(("there", "here", "you ", "we ")):
                if self.clause.members:
                    self._begin_again()
                self.existential = True
            case _:
                self._find_subject(link)
                told = self.subject is not None or link.value not in ("be", "stand", "hang", "serve")
                if told and not (link.value == "be" and self._is_what_each_is()):
                    self._predicate(link)

    def _do_something(self, link: Connector) -> None:
        """Go past a verb that says nothing about a room, unless it ties a thing to another that was named."""
        noun = self.peek()
        if isinstance(noun, Noun) and noun.kind == "room" and self.clause.members and self._is_parting(link):
            self._lose(link.start, noun.end)
        named = isinstance(noun, Noun) and noun.kind == "thing" and noun.definite
        if named and isinstance(noun, Noun) and self.clause.members and self.referents.named(noun) is not None:
            self._lose(link.start, noun.end)
        self.frontier, self.subject, self.pending = [], None, None
        where = self._next_noun(1) if self._is_link(noun, "prepositions", "at", "on", "in", "by") else None
        if where is not None and where.kind == "thing" and not where.definite and self._is_somebody(self._before()):
            self.at += 1

    def _is_somebody(self, who: Chunk | None) -> bool:
        """Whether it is a person, who does something where a thing is: "she eats at a small table"."""
        who = self._before(2) if self._is_link(who, "mark", "close") else who
        spoken = isinstance(who, Connector) and who.text.lower() in grammar().lists["speakers"]
        return spoken or (isinstance(who, Noun) and who.kind == "people")

    def _is_parting(self, link: Connector) -> bool:
        """Whether it says that something stands between the halves of the room."""
        return link.text.lower() in grammar().lists["parting"]

    def _put(self) -> None:
        """Read "put": what follows is asked for, or lies on what was just named."""
        self.existential |= not self.clause.members
        if self.subject is None and self.clause.members and not self.separator:
            self.subject = self._whole_subject()
            self._open_of_subject("with")

    def _find_subject(self, link: Connector) -> None:
        """Find what a verb is said of."""
        last = self._before()
        front_only = bool(self.front) and not self.clause.members
        if self.outer is not None and self._is_link(last, "mark", "comma", "close") and not front_only:
            self.subject, self.outer = self.outer, None
        elif self.relative is not None:
            self.subject, self.relative = self.relative, None
        elif self.subject is None or (self.clause.members and not self.predicate):
            self.subject = self._one_subject(link)
            self._take_all_parts(link)

    def _take_all_parts(self, link: Connector) -> None:
        """Let a plural verb after a comma be about all of those that were just told apart: "..., one red, lie ..."."""
        thing = self.subject.thing if self.subject is not None else None
        family = self.referents.family(thing) if thing is not None else []
        parted = len(family) > 1 and self._is_link(self._before(), "mark", "comma")
        plural = not link.text.lower().split()[0].endswith("s")
        if self.subject is None or not parted or not plural:
            return
        here = {t for chunk in self.chunks[self._clause_start() : self.at] for t in self.meant.get(chunk.start, ())}
        if here & set(family):
            self.subject = Node(family, self.subject.frame, known=self.subject.known)

    def _one_subject(self, link: Connector) -> Node | None:
        """What a verb is said of: of a thing alone where it is singular, though others are joined to what it has."""
        node = self._whole_subject()
        if node is None or len(node.things) < 2 or node.things[0].many:
            return node
        first, said = node.things[0], self.chunks[self._clause_start() : self.at - 1]
        having = next((n for n, chunk in enumerate(said) if self._is_link(chunk, "prepositions", "with")), None)
        if having is None:
            return node
        named = said[having - 1] if having else None
        single = link.text.lower() in ("is", "stands", "sits", "hangs", "lies") and isinstance(named, Noun)
        if not single or named is not self.named_by.get(first):
            return node
        self.clause.members = [first]
        return Node([first], node.frame, known=node.known)

    def _predicate(self, link: Connector) -> None:
        self.predicate = True
        self.verb = link.value
        if self.subject is not None:
            self.frontier = [self.subject]
        self.separator = ""
        match link.value:
            case "have" | "consist":
                self._have(link.value)
            case "hold" | "carry" if self._is_link(self.peek(), "mark"):
                self._lose(link.start, link.end)
            case "hold" | "carry":
                self.holding = _held(link)
                self._open_of_subject(self.holding)
            case verb if verb in _STANDS:
                self._stand(_STANDS[verb])
            case "share":
                self._have_shared()
            case "serve":
                self._form(link)
            case "seat":
                self._seat()
            case "hang":
                self._hang_from()

    def _form(self, link: Connector) -> None:
        """Go past what things serve as; how they are arranged ("forming a U") is not understood."""
        noun = self.peek()
        if isinstance(noun, Noun) and {noun.word, noun.text.lower().split()[-1]} & grammar().lists["formations"]:
            self._go_past(noun)
            self._spend(noun)
            self._lose(link.start, noun.end)
        else:
            self._as()

    def _seat(self) -> None:
        """Read "a table that seats ten"."""
        noun = self._next_noun()
        thing = self.subject.thing if self.subject is not None else None
        if noun is not None and noun.count and noun.kind in ("number", "people") and thing is not None:
            thing.seats = noun.count
            self._go_past(noun)

    def _have(self, kind: str) -> None:
        had = self._next_noun()
        if self.subject is None and self.crowd and had is not None and had.count == self.crowd > 1:
            self.crowd = 0  # Three children with three beds have one each.
            return
        if self.subject is None and self.crowd:
            self.pending = self.clause = Listed(None, "list", times=self.crowd, each=True)
            self.crowd = 0
            return
        if self.subject is None:
            return
        following = self.peek()
        thing = self.subject.thing
        if thing is not None and isinstance(following, Noun) and self._is_feature(following, thing):
            self._features(self.subject, following)
            return
        if isinstance(following, Noun) and following.kind == "abstract":
            self.at += 1
            return
        if thing is not None and thing in self.groups.values() and (kind == "consist" or self.subject.each):
            self._dissolve(thing)
            return
        self._open_of_subject("with")

    def _have_shared(self) -> None:
        if self.subject is None or self.subject.thing is None:
            return
        every = self.each_of
        frame = Listed(self.subject, "next_to")
        if every:
            frame.times = max(1, (self.subject.thing.count or every) // every)
            self.each_of = 0
        elif self.per_group:
            frame.times, frame.grouped, self.per_group = self.per_group, True, 0
        self.pending = frame

    def _participle(self, kind: str) -> None:
        match kind:
            case "hold" | "carry":
                if not self.frontier and (anchors := self._hold_front()) is not None:
                    self.frontier = [anchors]
                carrier = self.frontier[-1].thing if self.frontier else None
                which = self._before(0)
                said = which.text.lower() if isinstance(which, Connector) else ""
                told = said.startswith(("on which", "which", "that")) and carrier is not None
                if said.startswith("on which") and carrier is not None:
                    nearer = self._carrier_before(1, self.frontier[-1].things)
                    if nearer is not None and not self._may_carry(self.frontier[0].things[-1]):
                        self.frontier = [Node(self.meant[nearer.start], self.clause)]
                if told and carrier is not None and not self._belongs(carrier.noun, "small"):
                    self.separator = ""
                self._open(kind)
            case "inside":
                self._open("inside")
            case doing if doing in _STANDS:
                self._stand(_STANDS[doing])
            case "hang":
                self._hang_from()
