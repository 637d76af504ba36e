"""Groups that are no things themselves, and what is said of each of several."""

from dataclasses import replace

from thinkblox.assets.names import identifier_of
from thinkblox.assets.plurals import singular
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Chunk, Connector, Measured, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.looks import Descriptions
from thinkblox.reading.english.nodes import Listed, Node
from thinkblox.reading.english.referents import last_word
from thinkblox.reading.english.state import LOOKAHEAD

_PLACING = ("in", "on", "between", "along", "by", "near", "next_to", "around", "at", "behind", "in_front_of")
"""Prepositions by which something that is no thing has a place: "an aisle in the middle"."""

_BESIDES = ("between", "next_to", "around")
"""How what parts or surrounds several stands to them: "three beds, separated by curtains, each with a lamp"."""
_MAIN = ("tables", "desks", "counters", "worktops", "beds", "lounges", "storage", "worked_at")
"""What a station, a booth or a set can be made up around."""
_MODIFIED = 3
"""So many words of a group name a thing of its own: "four manicure stations"."""


class Groups(Descriptions):
    """Reads "each", and groups of things."""

    def _abstract(self, noun: Noun) -> None:
        if noun.det == "each" or noun.definite:
            group = self.groups.get(singular(noun.value.rpartition(" ")[2]))
            if group is not None:
                self._take_known(noun, [group])
                return
        word = noun.word
        self._lose_gap(noun)
        if word in grammar().lists["measures_of_things"] and noun.plural and self.draft.things:
            self._lose(noun.start, noun.end)
            return
        if word in grammar().lists["groups"] and (noun.count or 0) > 1:
            self._take(self._new(replace(noun, value=identifier_of(noun.value))), noun)
            return
        if word in grammar().lists["gaps"] and self._is_link(self.peek(), "prepositions", "between", "around"):
            between = self._next_noun(1)
            if between is not None and between.kind == "pronoun":
                self._go_past(between)
                return
        joined = self.separator or self._is_link(self._before(), "prepositions", "with")
        if joined and self.frontier and self._is_link(self.peek(), "prepositions", *_PLACING):
            after = self._next_noun(1)
            if after is not None and after.kind in ("place", "part", "thing"):
                self._lose(noun.start, after.end)
                self._go_past(after)
                return
        if not self.clause.members and self.separator != "and":
            self.frontier = [Node()]

    def _lose_gap(self, noun: Noun) -> None:
        """Say of aisles that nobody sees to how many there are, or how wide: that is no size of things or rooms."""
        gap = noun.word in grammar().lists["gaps"]
        if gap and ((noun.count or 0) > 1 or noun.size is not None):
            self._lose(noun.start, noun.end)
        for at in range(self.at, min(self.at + LOOKAHEAD, len(self.chunks)) if gap else 0):
            said = self.chunks[at]
            if isinstance(said, Measured):
                self._lose(said.start, said.end)
                self.chunks[at] = Connector("fillers", "words", said.start, said.end)
                return
            told = isinstance(said, Noun) or self._is_link(said, "fillers") or self._is_link(said, "verbs", "be")
            between = self._is_link(said, "prepositions", "between", "of")
            if not (told or between or self._is_link(said, "joins", "and")):
                return

    def _dissolve(self, group: Mention) -> None:
        """Let the members of a list stand for a group that is no thing itself: each member as often as the group."""
        frame = Listed(None, "list", times=group.count or 1, each=True, inherited=self.draft.bonds_of(group))
        self.draft.drop(group)
        if last_word(group) in grammar().lists["screened"] and (noun := self.named_by.get(group)) is not None:
            self._lose(noun.start, noun.end)
        self.groups = {word: thing for word, thing in self.groups.items() if thing is not group}
        self.clause = frame
        self.front = [] if frame.inherited else self.front
        self.frontier = []
        self.subject = None
        self.pending = frame
        self.each = False

    def _is_definition(self, noun: Noun) -> bool:
        """Whether "a booth is a table with two benches" says what several that are called so are."""
        verb, what = self.peek(), self._next_noun(1)
        if noun.det not in ("a", "each") or noun.count not in (None, 1) or noun.attributes or noun.every:
            return False
        if not (self._is_link(verb, "verbs", "be", "consist") or self._is_made_of()) or what is None:
            return False
        return what.kind == "thing" and what.det in ("a", "another", "") and (what.det == "a" or what.count is not None)

    def _is_made_of(self) -> bool:
        """Whether "consists of", "is made up of" comes."""
        made = self.peek(1) if self._is_link(self.peek(), "verbs", "be") else self.peek()
        return (
            isinstance(made, Connector)
            and made.sort == "inverses"
            and made.text.lower().startswith(("consist", "made"))
        )

    def _define(self, noun: Noun) -> None:
        """Let what a group is said to be stand for each of its members; without a group it is not understood."""
        group = self.referents.named(noun)
        self._spend(noun)
        if group is None or not group.many or last_word(group) != noun.word:
            verb = self.peek()
            self._lose(noun.start, verb.end if verb is not None else noun.end)
            return
        self.at += 1 if self._next_noun() is not self._next_noun(1) or self._is_link(self.peek(), "verbs") else 0
        self.referents.settle(group)
        self._dissolve(group)

    def _is_what_each_is(self) -> bool:
        """Read "six workstations. Each is a desk with two monitors"."""
        group = self.subject.thing if self.subject is not None and self.subject.each else None
        noun = self._next_noun()
        if group is None or group not in self.groups.values() or noun is None:
            return False
        if noun.kind != "thing" or noun.det != "a":
            return False
        self.predicate = False
        self.referents.settle(group)
        self._dissolve(group)
        return True

    def _is_told_of_parts(self, group: Mention) -> bool:
        """Whether what follows tells what a group is made of: something to work at or lie on, not only seats."""
        for chunk in self.chunks[self.at : self.at + LOOKAHEAD]:
            if self._is_link(chunk, "mark", "stop", "semicolon"):
                break
            if isinstance(chunk, Noun) and self.habits.is_in(chunk.value, *_MAIN):
                return True
        return len(group.text.split()) < _MODIFIED and last_word(group) not in grammar().lists["made_up"]

    def _drop_groups(self) -> None:
        """A group of which nobody says what it is is not understood."""
        for thing in self.groups.values():
            alone = len(thing.text.split()) <= 2 or thing.unshown
            if thing in self.draft.things and thing.noun not in self.habits.known() and alone:
                self.draft.drop(thing)
                noun = self.named_by[thing]
                self._lose(noun.start, noun.end)

    def _each(self, following: Chunk | None) -> None:
        if self._is_each_person() or self.crowd:
            return
        if isinstance(following, Noun) and following.kind == "thing" and following.det == "a":
            group = next((t for t in self.groups.values() if t in self.draft.things), None)
            if group is not None:
                self._dissolve(group)
                return
        nodes = [n for n in reversed(self.frontier) if any(t.many for t in n.things)]
        nodes = self._past_parting(nodes)
        begins = not self.frontier and not self.clause.members
        if not nodes and not begins and self._all_parts():
            begins = False
        elif begins or not nodes:
            found = list(self.referents.several([], "each"))
            found = [t for t in found if t.many or len(found) > 1] or self.referents.joined
            if begins and found:
                self.frontier = [Node(found, self.clause, known=True, each=True)]
                self.clause.members += found
                self.each = True
                return
        ends = isinstance(following, Connector) and following.sort in ("mark", "joins")
        if following is None or ends or self._is_each_of_list(following):
            self._trailing_each()
        else:
            self._each_of(nodes)

    def _each_of(self, nodes: list[Node]) -> None:
        """Let what follows be of each of several, of the parts of some, or of what was joined last."""
        if nodes:
            del self.frontier[self.frontier.index(nodes[0]) + 1 :]
            self.each = True
        elif parts := self._all_parts() or self.clause.last_joined() or self._known_joined():
            self.frontier = [Node(parts, self.clause, known=True, each=True)]
            self.clause.members += [part for part in parts if part not in self.clause.members]
            self.each, self.separator = True, ""
        elif alike := self._alike_of_list():
            self.frontier[-1] = Node(alike, self.frontier[-1].frame, each=True)
            self.each, self.separator = True, ""

    def _known_joined(self) -> list[Mention]:
        """Things named before that the clause begins with: "the table and the desk each have a lamp"."""
        known = bool(self.frontier) and self.frontier[-1].known and not self.predicate
        start = self._clause_start()
        listed = [c for c in self.chunks[start : self.at - 1] if not self._is_link(c, "joins", "and")]
        plain = all(isinstance(c, Noun) or self._is_link(c, "mark", "comma") for c in listed)
        return list(self.clause.members) if known and plain and len(self.clause.members) > 1 else []

    def _alike_of_list(self) -> list[Mention]:
        """Two of a kind by one thing: "a bed with a lamp on the left and a lamp on the right, each with a shade"."""
        thing = self.frontier[-1].thing if self.frontier and self.separator == "comma" else None
        by = {a for bond in self.draft.bonds_of(thing) for a in bond.anchors} if thing is not None else set()
        if thing is None or thing.many or not by:
            return []
        kin = [t for t in self.draft.things if t.noun == thing.noun and not t.many and t not in by]
        alike = [t for t in kin if any(not by.isdisjoint(bond.anchors) for bond in self.draft.bonds_of(t))]
        return alike if len(alike) > 1 else []

    def _past_parting(self, nodes: list[Node]) -> list[Node]:
        """What is parted rather than what parts it: the beds of "three beds, separated by curtains, each with"."""
        frame = nodes[0].frame if nodes else None
        parting = frame is not None and frame.kind in _BESIDES and self.separator == "comma"
        return nodes[1:] if parting and frame is not None and frame.head in nodes else nodes

    def _is_each_of_list(self, following: Chunk | None) -> bool:
        """Whether "each" ends what several have, and a place comes: "racks with 48 bottles each along the wall"."""
        said, node = self._before(), self.frontier[-1] if self.frontier else None
        counted = isinstance(said, Noun) and bool(said.count) and isinstance(following, Connector)
        head = node.frame.head if node is not None and node.frame is not None else None
        place = self._next_noun(1) if counted and self._is_link(following, "prepositions") else None
        many = head is not None and any(thing.many for thing in head.things)
        return many and place is not None and place.kind == "place"

    def _is_each_person(self) -> bool:
        """Take "each" for each of the people named just now, or alone: "an office for three, each with a desk"."""
        having = self._is_link(self.peek(), "prepositions", "with") or self._is_link(self.peek(), "verbs", "have")
        said = self._before(2) if self._is_link(self._before(), "mark", "comma") else None
        people = self.draft.people if not self.draft.things else 0
        if isinstance(said, Noun) and said.kind == "people":
            people = said.count or 0
        if not having or not people:
            return False
        self.frontier, self.subject, self.separator = [], None, ""
        self.crowd = 0
        if self._is_link(self.peek(), "prepositions"):
            self.clause = Listed(None, "list", times=people, each=True)
        else:
            self.crowd = people
        return True

    def _all_parts(self) -> list[Mention]:
        """The parts of what was parted in this sentence."""
        nodes = [node for node in reversed(self.frontier) if node.frame is not None or node is self.frontier[-1]]
        families = (self.referents.family(thing) for node in nodes for thing in node.things)
        return next((family for family in families if len(family) > 1), [])

    def _told_together(self, node: Node, frame: Listed) -> list[Mention]:
        """What is listed in one place with the things of a node: "on the desks a sheet and a pencil each"."""
        where = [(b.kind, b.anchors) for thing in node.things for b in self.draft.bonds_of(thing)]
        there = [m for m in frame.members if any((b.kind, b.anchors) in where for b in self.draft.bonds_of(m))]
        return list(dict.fromkeys([*there, *node.things])) if self.front else node.things

    def _trailing_each(self) -> None:
        """Read "two bins with five balls each", "four chairs each"."""
        node = self.frontier[-1] if self.frontier else None
        if node is None or node.frame is None:
            return
        head = node.frame.head
        before = node.frame.members[-2:-1] if head is None else []
        if before and before[0].many and node.things == node.frame.members[-1:]:
            tie = relation_kind(self.habits.tie(node.things[0].noun, before[0].noun) or "next_to")
            bind(self.draft, Bond(tie, node.things[0], (before[0],), each=True, implied=True))
        for thing in node.frame.members if head is not None else self._told_together(node, node.frame):
            loose = head is not None and head.things and not self.draft.bonds_of(thing)
            if head is not None and loose and head.things[-1].many:
                bind(self.draft, Bond("next_to", thing, (head.things[-1],), implied=True))
            for bond in self.draft.bonds_of(thing):
                if any(isinstance(a, Mention) for a in bond.anchors):
                    bond.each = True
