"""What things are like: adjectives, sizes, and how several stand to each other."""

from dataclasses import replace
from itertools import pairwise

from thinkblox.assets import kind_of
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun, Stray
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Listed, Node, Where
from thinkblox.reading.english.referents import is_small
from thinkblox.reading.english.rooms import Rooms
from thinkblox.reading.sizes import Size

_OFFSETS = ("in_front_of", "behind", "above", "left_of", "right_of", "to", "outside", "between")
"""Prepositions before which a length says how far off something is."""
_BESIDE, _NEAR = 0.5, 1.5
"""How far things beside, and near, each other are at most [m]."""
_MUCH_DEEPER = 1.5
"""So many times as deep as things of its kind ever are a thing is not: no wardrobe is 3 m by 3 m."""
_LEAST_SIDE = 1.5
"""A room is no narrower than this [m]."""
_OF_JOINED = ("next_to", "facing")
"""How the ones of two joined kinds may stand to the others: "two washers and two dryers side by side"."""
_LONGEST_FILE = 6
"""Most things that are put one behind the other."""
_ROOMY = 3.0
"""Two sides that are both longer than this are a room's, whatever they stand beside [m]."""


class Descriptions(Rooms):
    """Reads what is said of single things."""

    def _adjective(self, said: Adjective) -> None:
        """Read "the sofa is red", "three of them chrome", "leave the middle free"."""
        self.draft.style += said.styles if not self.predicate else []
        if self._is_another_like(said) or self._says_how_high(said):
            return
        if self.leaving or (self.predicate and self.subject is not None and self.subject.thing is None):
            return
        node = self.frontier[-1] if self.frontier else None
        if node is None or not node.things:
            if not self.draft.things:
                looks = self._looks_of(said, denied=self.negating)
                looks = self.draft.shape_room(self.draft.room, looks)
                self.draft.room_attributes += looks
                self.draft.tones.append(tuple(looks))
            elif before := self._things_before():
                for thing in before:
                    thing.attributes += self._looks_of(said, denied=self.negating)
                    thing.unshown += said.unshown
                self.frontier = [Node(before, self.clause, known=True)]
            elif said.attributes:
                self.account.mark(said.start, said.end, "style")
            return
        looks = self._looks_of(said, denied=self.negating)
        told = self._named_right_before() or ((self.subject or node) if self.predicate else node).things
        for thing in told:
            thing.attributes += looks
            thing.unshown += said.unshown if not self.negating else []
            thing.states += said.states if not self.negating else []

    def _named_right_before(self) -> list[Mention]:
        """What how it looks comes right after: "stands on a table made of oak", "faces an armchair in green"."""
        at = self.at - 2
        while at > 1 and (
            isinstance(said := self.chunks[at], Adjective)
            or self._is_link(said, "fillers")
            or self._is_link(said, "prepositions", "of", "in")
        ):
            at -= 1
        noun = self.chunks[at] if at > 1 else None
        if not isinstance(noun, Noun) or noun.kind != "thing":
            return []
        return [t for t in self.meant.get(noun.start, ()) if t in self.draft.things]

    def _things_before(self) -> list[Mention]:
        """What was named before a colon or commas and other adjectives: "one sofa: blue, long"."""
        for chunk in self.chunks[self.at - 2 :: -1]:
            looks = isinstance(chunk, Adjective) or self._is_link(chunk, "mark", "comma", "colon")
            if not looks and not self._is_link(chunk, "fillers"):
                named = isinstance(chunk, Noun) and chunk.kind == "thing"
                return [t for t in self.meant.get(chunk.start, ()) if t in self.draft.things] if named else []
        return []

    def _says_how_high(self, said: Adjective) -> bool:
        """Say of "mounted high on the wall" that we do not see to it."""
        hung = self._is_link(self._before(), "participles") or self._is_link(self._before(), "verbs", "hang", "stand")
        placed = hung and self._is_link(self.peek(), "prepositions")
        if placed and said.text.lower() == "high":
            self._lose(said.start, said.end)
        return placed and said.text.lower() in ("high", "low")

    def _is_another_like(self, said: Adjective) -> bool:
        """Read "a blue quilt on one and a yellow on the other", the second without its noun."""
        noun = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        nodes = [n for n in reversed(self.frontier) if n.frame is not None and n.things]
        placed = (n for n in nodes if any(not b.implied for b in self.draft.bonds_of(n.things[-1])))
        node = next(placed, None) if not self.predicate else None
        last = node.things[-1] if node is not None else None
        if (
            noun is None
            or last is None
            or node is None
            or node.frame is None
            or not self.separator
            or not (said.attributes or said.unshown)
        ):
            return False
        if noun.kind not in ("number", "pronoun") or noun.value in ("it", "them") or last.many:
            return False
        more = self._copy_of(last)
        more.attributes, more.unshown = [*said.attributes], [*said.unshown]
        self._push(Node([more], node.frame))
        node.frame.members.append(more)
        self.separator = ""
        return True

    def _look(self, thing: Mention, noun: Noun) -> None:
        thing.attributes += noun.attributes
        thing.unshown += noun.unshown
        thing.states += noun.states

    def _mutual(self, link: Connector) -> None:
        """Read "facing each other", "side by side", "in a row": of one plural thing, or of two that were joined."""
        nodes = [n for n in reversed(self.frontier) if n.things]
        if not nodes:
            self._lose(link.start, link.end)
            return
        several = [n for n in nodes if any(t.many for t in n.things)]
        node = next(iter((*self._having_them(several, link.value), *several)), None)
        kind = link.value
        things = node.things if node is not None else list(self.clause.members)
        if node is nodes[0] and node.frame is not None and kind in _OF_JOINED and not self.predicate:
            things = self._joined_several(node, node.frame)
        if self.predicate and self.subject is not None and not self._is_of_held(nodes[0]):
            things = self.subject.things
        if self.negating:
            self._not_mutual(link, things)
            return
        if kind in ("in_rows", "in_row"):
            self._row(kind, list(things), nodes[0])
        elif len(things) > 1:
            one, other = things[-2:]
            for each, to in ((other, one), (one, other)) if kind == "facing" else ((other, one),):
                bind(self.draft, Bond(relation_kind(kind), each, (to,)))
            if nodes[0].frame is not None and nodes[0].things == things[-1:]:
                nodes[0].things = things[-2:]
        elif things and things[-1].many:
            self._mutual_within(link, things[-1])
        self._faced_across(link, things[-2:] if len(things) > 1 else things)

    def _having_them(self, several: list[Node], kind: str) -> list[Node]:
        """What has one of the last each, or faces what they lie on: "two desks with computers next to each other"."""
        if not several or not all(map(is_small, several[0].things)):
            return []
        single = [thing for thing in several[0].things if thing.count in (None, 1)]
        bonds = [bond for thing in single for bond in self.draft.bonds_of(thing) if bond.each]
        owners = [thing for bond in bonds for thing in bond.anchors]
        return [n for n in several[1:] if kind == "facing" or any(thing in owners for thing in n.things)]

    def _is_of_held(self, last: Node) -> bool:
        """Whether it is of what a thing has, right after which it comes: "a table has two chairs that face away"."""
        before = self._before()
        right_after = isinstance(before, Noun) or self._is_link(before, "joins", "which")
        held = last.frame is not None and last.frame.head is not None
        return right_after and held and any(thing.many for thing in last.things)

    def _faced_across(self, link: Connector, things: list[Mention]) -> None:
        """Put between those who face each other what they do so across: "two sofas facing each other over a table"."""
        if link.value != "facing":
            return
        ahead = self.peek()
        over = (
            isinstance(ahead, Connector) and ahead.sort == "prepositions" and ahead.text.lower() in ("across", "over")
        )
        said = link.text.lower().endswith("across")
        noun = self._next_noun(1 if over and not said else 0) if over or said else None
        if noun is None or noun.kind not in ("thing", "pronoun") or not things:
            return
        self._go_past(noun)
        if noun.kind == "pronoun":
            meant = self.meanings.of(Where("next_to", noun, start=noun.start, text=noun.text), things, [])
            anchors, known = tuple(a for a in meant.anchors if isinstance(a, Mention)) if meant else (), True
        else:
            anchors, known = self.anchors(noun, things)
        for thing in anchors:
            bind(self.draft, Bond("between", thing, tuple(things)))
        self.frontier.append(Node(list(anchors), None, known=known))

    def _joined_several(self, node: Node, frame: Listed) -> list[Mention]:
        """The washers and dryers of "two washers and two dryers side by side"."""
        two = frame.members[-2:]
        alike = frame.head is None and len(two) == 2 and node.things == two[1:] and two[0].many
        told = any(not b.implied for b in self.draft.bonds_of(two[0]))
        if not alike or told or not self._is_joined_before(self.at - 1):
            return node.things
        node.things = list(two)
        self.referents.pairs.append((two[0], two[1]))
        return node.things

    def _is_joined_before(self, at: int) -> bool:
        """Whether the noun before the chunk at `at` came right after "and", and that after another noun."""
        at -= 1
        while at > 0 and not isinstance(self.chunks[at], Noun):
            at -= 1
        joint, first = self.chunks[at - 1 : at], self.chunks[at - 2 : at - 1]
        joined = bool(joint) and isinstance(joint[0], Connector) and joint[0].text.lower() in ("and", "&", "+")
        return joined and bool(first) and isinstance(first[0], Noun)

    def _row(self, kind: str, things: list[Mention], node: Node) -> None:
        """Read "in a row": of several alike, or of single things, which then stand side by side."""
        if kind == "in_row" and len(things) > 1 and not any(t.many for t in things):
            for one, other in pairwise(things):
                bind(self.draft, Bond("next_to", other, (one,)))
            node.things = things
            return
        for thing in things[-1:]:
            bind(self.draft, Bond("in_rows", thing, rows=1 if kind == "in_row" else 0))

    def _mutual_within(self, link: Connector, thing: Mention) -> None:
        """Read how the members of one plural thing stand to each other; what we do not know of them is said."""
        kind = relation_kind(link.value)
        if kind in ("facing", "next_to", "back_to_back"):
            bind(self.draft, Bond(kind, thing, (thing,)))
        elif link.value == "around":
            self.circles.append((thing, link))
        elif kind == "behind" and 1 < (thing.count or 0) <= _LONGEST_FILE:
            self._file(thing)
        else:
            self._lose(link.start, link.end)

    def _file(self, whole: Mention) -> None:
        """Put several one behind the other."""
        parts = [self.referents.part(whole, 1) for _ in range((whole.count or 1) - 1)]
        for one, other in pairwise([*parts, whole]):
            bind(self.draft, Bond("behind", other, (one,)))
        for node in (*self.frontier, self.subject):
            if node is not None and node.things == [whole]:
                node.things = [*parts, whole]
        self.referents.parted = None

    def _not_mutual(self, link: Connector, things: list[Mention]) -> None:
        """Read "not facing each other"; what cannot be denied is not understood."""
        self.negating = False
        if link.value not in ("facing", "next_to") or not things or (len(things) < 2 and not things[-1].many):
            before = self._before()
            said_before = isinstance(before, Connector) and before.sort == "negations"
            self._lose(before.start if before is not None and said_before else link.start, link.end)
            return
        pairs = pairwise(things) if len(things) > 1 else [(things[0], things[0])]
        for one, other in pairs:
            self.draft.bonds.append(Bond(relation_kind(link.value), other, (one,), negated=True))

    def _measured(self, measured: Measured) -> None:
        """Read a size: of the thing just before or after it, or of the room."""
        size, before = measured.size, self._before()
        if (
            isinstance(before, Connector)
            and before.sort in ("mark", "fillers")
            and before.value in ("open", "comma", "colon")
            and self.at >= 3
        ):
            before = self.chunks[self.at - 3]
        if self._is_link(before, "prepositions", "of") and self.at >= 3:
            before = self.chunks[self.at - 3]
        following = self.peek()
        single = len(size.lengths) == 1 and size.area is None
        roomy = not single and size.area is None and min(length.metres for length in size.lengths) > _ROOMY
        size = self._squared(size, before, following)
        single &= size is measured.size
        thing = self.frontier[-1].thing if self.frontier else self._labelled(before)
        ceiling = "ceiling" in size.text.lower() or (isinstance(following, Noun) and following.value == "ceiling")
        own = thing is not None and self._is_own(before)
        told = self.predicate and thing is not None and self._is_link(before, "verbs", "be")
        roomy |= self._outgrows(measured, thing)
        told |= own
        if (roomy and not self.draft.sizes and not told) or (ceiling and size.along("height")):
            self.draft.sizes.append(size)
        elif self._keeps_off(measured, following, told=told):
            pass
        elif isinstance(following, Noun) and following.kind == "thing" and not following.size:
            following.size = size
        elif (isinstance(before, Noun) and before.kind == "room") or not self.draft.things or thing is None or ceiling:
            self.draft.sizes.append(size)
        elif told or (isinstance(before, Noun) and before.kind == "thing") or (single and size.area is None):
            if thing.size is not None and thing.size != size:
                self._lose(measured.start, measured.end)
            thing.size = thing.size or size
        else:
            self.draft.sizes.append(size)

    def _squared(self, size: Size, before: Chunk | None, following: Chunk | None) -> Size:
        """Both sides of what is "5 m square"; goes past that word where it is said of a room."""
        if len(size.lengths) > 1 or size.area is not None or not isinstance(following, Adjective):
            return size
        if following.attributes != ["square"]:
            return size
        if isinstance(before, Noun) and before.kind == "room":
            self.account.mark(following.start, following.end, "constraint")
            self.at += 1
        return replace(size, lengths=size.lengths * 2)

    def _labelled(self, before: Chunk | None) -> Mention | None:
        """The thing that a size follows after a colon: "Sofa: 2 m wide"."""
        labelled = (
            isinstance(before, Noun) and before.kind == "thing" and self._is_link(self._before(), "mark", "colon")
        )
        return self.draft.things[-1] if labelled and self.draft.things else None

    def _is_own(self, before: Chunk | None) -> bool:
        """Whether a size is said to be that of the thing before: "a table with dimensions of 2 m by 1.2 m"."""
        if not isinstance(before, Noun) or not grammar().lists["measures_of_things"] & {before.word}:
            return self._labelled(before) is not None or (
                isinstance(before, Noun) and before.kind == "thing" and self._is_link(self._before(), "prepositions")
            )
        at = self.chunks.index(before)
        return at > 0 and self._is_link(self.chunks[at - 1], "prepositions", "with") and self.separator != "comma"

    def _outgrows(self, measured: Measured, thing: Mention | None) -> bool:
        """Whether a size after a comma can be none of the thing before: "with a washing machine, 2 m by 2.5 m"."""
        lengths = [length.metres for length in measured.size.lengths]
        comma = self._is_link(self._before(), "mark", "comma")
        if thing is None or not comma or len(lengths) < 2 or min(lengths) < _LEAST_SIDE:
            return False
        depth, width, _ = kind_of(thing.noun).largest_shut
        return min(lengths) > max(depth, width) or min(lengths) > _MUCH_DEEPER * min(depth, width)

    def _keeps_off(self, measured: Measured, following: Chunk | None, *, told: bool) -> bool:
        """Whether a length says how far off something is: "2 m from it", "1 m apart", "nothing closer than 1 m"."""
        led = self._is_link(self._before(), "prepositions", "at") and not self._is_link(following, "prepositions")
        led |= self._is_link(self._before(), "prepositions", "at") and measured.size.along("height") is not None
        led |= isinstance(self._before(), Stray)
        gap = isinstance(following, Noun) and following.kind == "abstract"
        led |= gap and isinstance(following, Noun) and following.word in grammar().lists["gaps"]
        if led and len(measured.size.lengths) == 1 and measured.size.area is None:
            self._lose(measured.start, measured.end)
            return True
        if not isinstance(following, Connector):
            return False
        if self._is_link(following, "prepositions", "from", "far", "away"):
            self._lose(measured.start, following.end)
            self._stand_off(following, measured.size)
            return True
        apart = following.text.lower() in ("apart", "away", "off")
        side = self._next_noun(1) if self._is_link(following, "prepositions", "to", "on") else None
        beside = side is not None and side.kind == "part"
        off = apart or beside or (not told and self._is_link(following, "prepositions", *_OFFSETS))
        if (
            not off
            or any(length.axis for length in measured.size.lengths)
            or len(measured.size.lengths) != 1
            or measured.size.area is not None
        ):
            return False
        self._lose(measured.start, measured.end)
        return True

    def _stand_off(self, following: Connector, size: Size) -> None:
        """Take "3 m from" for the relation that it comes nearest to; how far exactly is not kept."""
        if len(size.lengths) == 1 and size.area is None and following.value in ("from", "far"):
            metres = size.lengths[0].metres
            beside = metres <= _BESIDE and following.value == "from"
            word = "next_to" if beside else "near" if metres <= _NEAR else "far"
            self.chunks[self.at] = replace(following, value=word)
