"""Takes things into lists: of what the clause names, or of what a thing has."""

from dataclasses import replace

from thinkblox.assets import kind_of
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Adjective, Connector, Noun
from thinkblox.reading.english.nodes import Awaited, Listed, Meaning, Node
from thinkblox.reading.english.referents import FURNITURE, is_furniture
from thinkblox.reading.english.ties import Ties

_FOR_ALL = (
    "on", "inside", "above", "against_wall", "next_to", "near", "behind", "in_front_of", "in_corner", "at", "per",
    "around", "opposite", "left_of", "right_of", "facing",
)  # fmt: skip
"""Relations that, told first, hold of all that is then listed: "opposite the piano, a sofa and a lamp"."""
_PAIR = 2
_FOR_JOINED = ("under", "between", "at_foot_of", "far", "at_long_side", "at_short_side")
"""The same of what is joined to it without a comma before the "and": "between the beds are a nightstand and a lamp"."""
_BESIDE = ("left_of", "right_of", "between", "behind", "in_front_of", "next_to", "near", "to", "on")
_TO_THE_LEFT_OF_IT = 4
"""Chunks of "to the left of the mixer"."""


class Memberships(Ties):
    """Adds things to lists."""

    def _take(self, thing: Mention, noun: Noun) -> None:
        """Take a new thing into the list it belongs to."""
        self.meant[noun.start] = [thing]
        pending, self.pending = self.pending, None
        frame = pending
        if frame is None:
            frame = self._frame_for(thing, noun) if self.separator and self.frontier else self.clause
        if self.together is not None and not self._is_told_next():
            self._place_with(thing, self.together)
        before = frame.members[-1:]
        self._lay_on_each(thing, self.frontier[-1].thing if self.frontier else None)
        self._member(thing, frame)
        self.draft.bonds += [replace(bond, subject=thing) for bond in frame.inherited]
        frame.inherited = []
        having = self._is_link(self.peek(), "verbs", "have", "hold", "carry")
        each = noun.each or (having and noun.plural and noun.det in ("all", "both"))
        flanking = self.referents.family(thing) if thing in self.referents.flanking else [thing]
        if len(flanking) > 1 and self._is_link(self.peek(), "prepositions", "with"):
            self.referents.shared.update(flanking)
        self._push(Node(flanking, frame, each=each or len(flanking) > 1))
        if before and self._comes_then(before[0]):
            bind(self.draft, Bond("next_to", thing, (before[0],)))
        if before and before[0] is not thing:
            self._come_after(thing, before[0])
        if frame.head is None:
            self.subject, self.predicate = None, False
            self._apply_front([thing])

    def _come_after(self, thing: Mention, before: Mention) -> None:
        """Put a thing after the one before it in the order that was told."""
        if self.sequence is not None:
            bind(self.draft, Bond(relation_kind(self.sequence.value), thing, (before,)))
            self.ordered.append((self.sequence, self.draft.bonds[-1]))

    def _comes_then(self, before: Mention) -> bool:
        """Whether "a fridge in the corner, then a stove" says that one stands beside the other."""
        said = self._before()
        then = isinstance(said, Connector) and said.text.lower() in ("then", "and then")
        return then and any(not bond.implied for bond in self.draft.bonds_of(before))

    def _place_with(self, thing: Mention, subject: Node) -> None:
        """Put a thing where the subject of the clause was just said to be."""
        said = [b for one in subject.things for b in self.draft.bonds_of(one) if not b.implied and not b.negated]
        for bond in said[-1:]:
            bind(self.draft, Bond(bond.kind, thing, bond.anchors))

    def _take_known(self, noun: Noun, known: list[Mention]) -> None:
        """Speak again of things named before: as the subject, or as what a list names."""
        self.meant[noun.start] = known
        self.places = list(known) if noun.value == "seat" and not noun.named else []
        for thing in known:
            self.referents.speak(thing)
            thing.attributes += [a for a in noun.attributes if a not in thing.attributes]
            thing.unshown += [a for a in noun.unshown if a not in thing.unshown]
            thing.states += [a for a in noun.states if a not in thing.states]
        frame = self._frame_for(known[0], noun) if self.separator and self.frontier else None
        each = noun.each or (noun.det == "other" and noun.shared)
        node = Node(list(known), frame or self.clause, known=True, each=each or noun.det == "both")
        pending, self.pending = self.pending, None
        if pending is not None and pending.head is not None:
            self._member(known[0], pending)
            node.frame = pending
            self._push(node)
            return
        if frame is not None and frame.head is not None:
            self._push(node)
            return
        self.clause.members += [t for t in known if t not in self.clause.members]
        self.frontier = [node]
        self._apply_front(known)
        self.each |= each
        word = noun.word
        self.per_group = known[0].groups if noun.each and known[0].group == word else 0

    def _push(self, node: Node) -> None:
        head = node.frame.head if node.frame is not None else None
        if head is not None and head in self.frontier:
            del self.frontier[self.frontier.index(head) + 1 :]
        elif head is None:
            self.frontier = []
        self.frontier.append(node)

    def _member(self, thing: Mention, frame: Listed) -> None:
        """Take a thing into a list: relate it to the head."""
        first = not frame.members
        if thing not in frame.members:
            self.numbers.add(thing.count or 0)
            thing.count = (thing.count or 1) * frame.times if frame.times > 1 else thing.count
            self._begin_inner_list(frame)
            frame.members.append(thing)
        head = frame.head.thing if frame.head is not None else None
        if frame.head is None or head is None or thing is head:
            self._seat_at_own(thing, frame)
            return
        thing.owner = thing.owner or head
        thing.host = head
        if frame.each and len(frame.head.things) > 1:
            self.referents.together[head] = tuple(frame.head.things)
        tie = self._tie(thing, frame, first=first)
        if tie is None and (frame.each or frame.grouped or frame.kind != "with"):
            tie = "next_to"
        if tie is None:
            thing.owner = None
            if first or not is_furniture(thing):
                self.untied.append((thing, head))
            return
        if "shared" in thing.attributes and tie == "next_to" and head.many:
            tie = "between"
        self._tie_to(frame, frame.head, thing, tie)

    def _lay_on_each(self, thing: Mention, before: Mention | None) -> None:
        """Put a lamp on each of the nightstands of "a bed with nightstands and lamps"."""
        bare = thing.plural and thing.count is None and self.separator == "and" and not self._is_told_next()
        if before is None or not bare or not before.many or not self.habits.is_in(thing.noun, "lamps"):
            return
        if self.habits.tie(thing.noun, before.noun) == "on":
            thing.count, thing.owner = 1, before
            bind(self.draft, Bond("on", thing, (before,), each=True, implied=True))

    def _begin_inner_list(self, frame: Listed) -> None:
        """Note where a list in a list begins: what follows an "and" and goes on after a comma is one by itself."""
        number = len(frame.members)
        if self.separator in ("and", "comma_and"):
            frame.joined = number
        elif self.separator == "comma" and number and frame.joined == number - 1:
            frame.begun = number - 1

    def _seat_at_own(self, thing: Mention, frame: Listed) -> None:
        """Put the chair of "three people, each with a desk and a chair" at the desk of the same person."""
        if not frame.each or frame.times < 2 or not thing.count or thing.count % frame.times:
            return
        seated = self._seated(thing) if thing.count == frame.times else ""
        for other in frame.members if seated else ():
            if self.habits.is_in(other.noun, "seats", "chairs") and not (other.count or 1) % frame.times:
                other.count, other.owner = (other.count or frame.times) // frame.times, thing
                bind(self.draft, Bond(relation_kind(seated), other, (thing,), each=True, implied=True))
        for other in frame.members:
            tie = self.habits.tie(thing.noun, other.noun) if other is not thing else None
            if tie in ("at", "around") and other.count == frame.times:
                thing.count //= frame.times
                thing.owner = other
                bind(self.draft, Bond(relation_kind(tie), thing, (other,), each=True, implied=True))
                return

    def _tie_to(self, frame: Listed, node: Node, thing: Mention, tie: str) -> None:
        """Bind a member to the head of its list."""
        head = node.things[-1]
        if tie == "sides" and self._stands_at_side(frame, head, thing):
            return
        anchors = tuple(node.things)
        if any(a.noun != head.noun for a in anchors) and not frame.each:
            anchors = (head,)
        if head in self.places and self._is_laid(thing, Meaning("at", anchors, each=True), anchors):
            return
        each = tie != "between" and not frame.grouped and (frame.each or self._shares(thing, head, tie, frame))
        if frame.kind in ("around", "next_to", "sides") and thing.count == 1:
            each = False
        implied = frame.kind == "with" or self._is_told_next()
        several = frame.each and not self.referents.flanking.issuperset(node.things)
        bond = Bond(relation_kind(tie), thing, anchors, each=each, implied=implied, distributed=several)
        bind(self.draft, bond)

    def _stands_at_side(self, frame: Listed, head: Mention, thing: Mention) -> bool:
        """Put what something is flanked by at its left and its right: two of a kind, or one and then another."""
        if head.many or frame.each:
            return False
        if thing.many or thing.plural:
            return self._flanks([thing], Meaning("next_to", (head,), both=True))
        before = [b for m in frame.members[:-1] if m is not thing for b in self.draft.bonds_of(m)]
        if len(frame.members) != _PAIR or [(b.kind, b.anchors) for b in before] != [("next_to", (head,))]:
            return False
        before[0].kind = "left_of"
        bind(self.draft, Bond("right_of", thing, (head,)))
        return True

    def _apply_front(self, things: list[Mention]) -> None:
        """Give things the relation that stood before them ("on the desk a lamp and a vase")."""
        for front in list(self.front):
            if all(self._is_bound_by(front, thing) for thing in things):
                continue
            listed = len(self.clause.members) > len(things)
            thing = things[-1]
            beside = listed and self._is_beside_own(front)
            off = front.kind == "on" and self._stands_apart(thing) and not beside
            wall = front.anchors and isinstance(front.anchors[0], str)
            top = (
                not wall and isinstance(front.anchors[0], Mention) and self._belongs(front.anchors[0].noun, "surfaces")
            )
            apart = self.habits.is_in(thing.noun, "tables", "desks", "beds", "lounges")
            apart |= self.habits.is_in(thing.noun, "seats", "chairs") and self._is_told_next()
            if listed and off and top and apart:
                self.front.remove(front)
                continue
            if listed and (off and not wall) and not self.clause.closing:
                self.front.remove(front)
                continue
            if listed and self._is_told_where() and not front.meaning.each and not beside:
                continue
            joined = front.kind in _FOR_JOINED and self.separator in ("and", "comma")
            if listed and front.kind not in _FOR_ALL and not joined:
                continue
            meaning = self.meanings.of_each(front.meaning, things)
            if (front.meaning.loose or meaning.loose) and not front.used:
                self._lose_where(front.where)
            front.used = True
            self._relate(things, meaning, negated=front.where.negated)

    def _is_told_where(self) -> bool:
        """Whether its own words say where a thing is: "a bike by the door", "tires stacked in the corner"."""
        lies = self._is_link(self.peek(), "participles", "stand", "hang") or isinstance(self.peek(), Adjective)
        return self._is_told_next() or (lies and self._is_link(self.peek(1), "prepositions"))

    def _is_beside_own(self, front: Awaited) -> bool:
        """Whether it stands beside what lies there too: "on it are a mixer and a mug to the left of the mixer"."""
        ahead = self.chunks[self.at : self.at + _TO_THE_LEFT_OF_IT]
        beside = [c for c in ahead if isinstance(c, Noun) and c.kind == "thing"][:1]
        links = self._is_link(self.peek(), "prepositions", *_BESIDE)
        if not links or not beside or beside[0].det != "the" or front.kind not in ("on", "inside", "in"):
            return False
        other = self.referents.named(beside[0])
        return other is not None and self._is_bound_by(front, other)

    def _stands_apart(self, thing: Mention) -> bool:
        """Whether it is furniture, or else stands on the floor or hangs, rather than lying with what is listed."""
        if self.habits.is_in(thing.noun, "small", "fitted"):
            return False
        kind = kind_of(thing.noun)
        return self.habits.is_in(thing.noun, *FURNITURE) or not (kind.plain or kind.mount == "surface")

    def _is_bound_by(self, front: Awaited, thing: Mention) -> bool:
        """Whether what stands in front was said of a thing before: of the bouquets of "half of the bouquets"."""
        kinds = ("on", "inside") if front.kind in ("on", "inside", "in") else (front.kind,)
        bonds = self.draft.bonds_of(thing)
        return any(b.anchors == front.anchors and b.kind in kinds and not b.implied for b in bonds)

    def _resume(self, things: list[Mention], noun: Noun) -> None:
        """Go back to things named before."""
        if not things:
            return
        self.meant[noun.start] = things
        separated = self.separator
        if separated and self.clause.members:
            self._begin()
        self.subject, self.predicate = None, False
        self.clause.members += [t for t in things if t not in self.clause.members]
        self.frontier = [Node(list(things), self.clause, known=True, each=noun.value == "each")]
        self._apply_front(things)

    def _repeat(self) -> bool:
        """Read "a rack on the left and another on the right": one more of what was named last."""
        node = next((n for n in reversed(self.frontier) if n.frame is not None), None)
        thing = node.thing if node is not None else None
        if node is None or node.frame is None or thing is None or thing.many:
            return False
        copy = self._copy_of(thing)
        self._member(copy, node.frame)
        self._push(Node([copy], node.frame))
        return True
