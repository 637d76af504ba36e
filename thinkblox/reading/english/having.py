"""Opens lists of what things have: "with", "surrounded by", "holds"."""

from dataclasses import replace

from thinkblox.assets.repaint import TOPPED
from thinkblox.assets.sizing import COUNTED_PARTS
from thinkblox.knowledge.vocabulary import name_of
from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.groups import Groups
from thinkblox.reading.english.nodes import Listed, Node
from thinkblox.reading.english.referents import last_word

_PAIR = 2
_LAID = ("laid with", "set with")
"""How a place at a table is said to have what lies before it: "every seat laid with a plate"."""
_BESIDE = ("next_to", "near", "by", "in_front_of", "behind", "under")
"""Prepositions of what stands by itself."""
_AGAINST = ("prepositions", "against", "along", "by")
_MADE_OF = ("consist", "made up", "composed", "compris")
"""How words begin that tell what something is made up of."""


class Having(Groups):
    """Begins lists."""

    def _open(self, kind: str) -> None:
        """Begin a list of what something has: "with", "surrounded by", "carrying"."""
        self.negating = False
        self._turn_wall_round(kind)
        noun = self._next_noun()
        node = next((n for n in reversed(self.frontier) if n.things), None)
        if noun is not None and node is not None and kind == "with" and self._is_feature(noun, node.things[-1]):
            self._features(node, noun)
            return
        if noun is not None and self._is_no_list(noun, kind):
            return
        if kind in ("inside", "on") and isinstance(said := self.peek(), Adjective):
            self.chunks[self.at] = Noun("thing", said.text.lower(), said.start, said.end, said.text, named=False)
        self._go_back_to_framed(node if kind == "with" else None)
        if kind == "with" and noun is not None and self._is_among(noun):
            return
        head = self._head_for(noun, kind)
        if head is None or (kind == "with" and noun is not None and self._is_of_room_again(noun, head)):
            return
        if kind == "inside" and noun is not None and self._is_described(noun, head):
            head.things[-1].attributes.append("filled")
            self._spend(noun)
            self._go_past(noun)
            return
        if noun is not None and noun.kind == "part" and noun.det == "my" and kind == "with":
            self._go_past(noun)
            self.frontier = self.frontier[: self.frontier.index(head) + 1] if head in self.frontier else [head]
            self._turn_by_part(noun)
            return
        thing = head.thing
        told = self._before(0)
        made = isinstance(told, Connector) and told.text.lower().startswith(_MADE_OF)
        self._set_places(head, told)
        made |= thing is not None and last_word(thing) in grammar().lists["made_up"]
        group = thing is not None and (thing in self.groups.values() or (made and thing.many))
        group &= self.each or head.each
        held = kind == "with" or (thing is not None and last_word(thing) in grammar().lists["screened"])
        if held and thing is not None and group and self._is_told_of_parts(thing):
            self._dissolve(thing)
            return
        several = head.frame is not None and head.frame.times > 1
        several |= thing in self.multiplied or (thing is not None and bool(thing.per))
        several |= thing is not None and self.referents.total(thing) > (thing.count or 1)
        several |= self._goes_on_with_each(head) or (thing is not None and self._is_at_each(thing))
        if thing is not None and noun is not None and noun.kind == "thing":
            self._call_after_content(thing, noun.value)
        self._pend(Listed(head, kind, each=self.each or head.each or several), head)

    def _is_full_of_matter(self, noun: Noun, kind: str) -> bool:
        """Say of "a cart full of groceries" that nobody knows what these are, though shops are called so."""
        if noun.kind != "room" or noun.det or noun.count is not None:
            return False
        if kind not in ("inside", "on", "hold") and not (kind == "with" and noun.plural):
            return False
        self._go_past(noun)
        self._lose(noun.start, noun.end)
        return True

    def _set_places(self, head: Node, told: Chunk | None) -> None:
        """Take seats that are laid for places at their table."""
        laid = isinstance(told, Connector) and told.text.lower() in _LAID
        if laid and all(self.habits.is_in(t.noun, "seats", "chairs") for t in head.things):
            self.places = head.things

    def _is_no_list(self, noun: Noun, kind: str) -> bool:
        """Take what something has that is no thing: light, or the window of "the wall with the window"."""
        if kind != "with" or noun.kind == "room":
            return self._is_full_of_matter(noun, kind)
        if noun.kind == "abstract":
            self._hold_matter(noun)
            return True
        return self._is_of_wall(noun)

    def _is_of_wall(self, noun: Noun) -> bool:
        """Say of "the wall with the window" that we do not know which that is."""
        wall = self._before()
        told = isinstance(wall, Noun) and wall.kind == "place" and wall.definite and "wall" in wall.value
        opening = noun.kind == "place" and noun.value in ("window", "door") and noun.definite
        if not told or not opening or not isinstance(wall, Noun):
            return False
        self._go_past(noun)
        self._lose(wall.start, noun.end)
        return True

    def _is_at_each(self, thing: Mention) -> bool:
        """Whether there is one for each of several: "a shelf above each sink"."""
        said = (b for b in self.draft.bonds_of(thing) if b.each and not b.negated)
        return any(isinstance(a, Mention) and a.many for bond in said for a in bond.anchors)

    def _turn_wall_round(self, kind: str) -> None:
        """Read "a wall full of clocks" as clocks on a wall."""
        wall, what = self._before(), self.peek()
        full = kind in ("inside", "on") and isinstance(wall, Noun) and wall.kind == "place" and "wall" in wall.value
        holder = self.frontier[-1].thing if self.frontier and self._is_link(self._before(2), *_AGAINST) else None
        holds = holder is not None and self.habits.is_in(holder.noun, "storage", "shelves")
        full &= not (holds and isinstance(wall, Noun) and wall.det == "the")
        if full and isinstance(wall, Noun) and isinstance(what, Noun) and what.kind == "thing" and not self.predicate:
            self.chunks[self.at + 1 : self.at + 1] = [Connector("prepositions", "on", wall.start, wall.start), wall]
            self.frontier, self.subject, self.separator = [], None, self.separator or "comma"

    def _turn_by_part(self, part: Noun) -> None:
        """Go on with "against the wall" after "its back"; a side that we turn to nothing is not understood."""
        link, what = self.peek(), self._next_noun(1)
        if not isinstance(link, Connector) or link.sort != "prepositions" or what is None:
            return
        wall = what.kind == "place" and ("wall" in what.value or "corner" in what.value)
        if part.value in ("head", "back") and (link.value == "against" or (link.value in ("to", "facing") and wall)):
            if link.value == "facing":
                self.chunks[self.at] = replace(link, value="against")
        elif part.value == "back" and link.value in ("facing", "to", "near", "on"):
            self.chunks[self.at] = replace(link, value="facing_away")
        elif part.value == "front" and link.value in ("facing", "to"):
            self.chunks[self.at] = replace(link, value="facing")
        elif link.value in ("against", "facing", "to"):
            self._go_past(what)
            if what.kind == "thing":
                self.anchors(what, [])
            self._spend(what)
            self._lose(part.start, what.end)

    def _goes_on_with_each(self, head: Node) -> bool:
        """Whether the list before was of each: "tables, each covered with a cloth and set with two plates"."""
        if self.separator not in ("and", "comma", "comma_and"):
            return False
        return any(n.frame is not None and n.frame.head is head and n.frame.each for n in self.frontier)

    def _hold_matter(self, noun: Noun) -> None:
        """Say of shelves "with supplies" that they are filled; of what, as "with paint", is not understood."""
        node = next((n for n in reversed(self.frontier) if n.things), None)
        head = node.things[-1] if node is not None else None
        if head is None or not self._contains(head):
            return
        if noun.word in grammar().lists["goods"]:
            head.attributes += ["filled"] if "filled" not in head.attributes else []
        elif noun.word in grammar().lists["matter"]:
            self._lose(noun.start, noun.end)

    def _is_among(self, noun: Noun) -> bool:
        """Take "with the sink in the middle" for where something just named is; among others that is not understood."""
        known = self.referents.named(noun) if noun.kind == "thing" and noun.det == "the" else None
        if known is None or known not in self.clause.members or not self._is_link(self.peek(1), "prepositions"):
            return False
        place = self._next_noun(2)
        alone = not self._is_link(self.peek(3), "prepositions")
        if alone and place is not None and place.value in ("middle", "centre"):
            self._spend(noun)
            self._go_past(place)
            self._lose(noun.start, place.end)
        elif self.predicate:
            self._begin_again()
        return True

    def _is_of_room_again(self, noun: Noun, head: Node) -> bool:
        """Whether the room has it: "a sunroom full of plants, with two armchairs"."""
        if self.separator != "comma" or self.each or noun.kind != "thing" or head.frame is None or head.each:
            return False
        if head.frame.head is not None or self.predicate:
            return False
        index = self.chunks.index(noun, self.at) + 1
        index += self._is_link(self.peek(index - self.at), "participles")
        place = self._next_noun(index + 1 - self.at)
        if self._is_link(self.peek(index - self.at), "prepositions") and place is not None and place.kind == "place":
            return place.value != "centre"
        usual = self.habits.tie(noun.value, head.things[-1].noun)
        return self.of_room and not usual and not self._belongs(noun.value, "small")

    def _pend(self, frame: Listed, head: Node) -> None:
        """Let what comes next begin a list of what `head` has."""
        if frame.each:
            self.referents.shared.update(head.things)
        self.each = False
        if head in self.frontier:
            del self.frontier[self.frontier.index(head) + 1 :]
        else:
            self.frontier.append(head)
        self.pending = frame
        self.separator = ""

    def _is_described(self, noun: Noun, head: Node) -> bool:
        """Whether "a bookcase full of books" only describes it, where "shelves filled with jars" asks for jars."""
        thing = head.things[-1]
        if noun.kind != "thing" or noun.count is not None:
            return noun.kind in ("abstract", "people")
        return self.habits.is_in(noun.value, "fills_shelves") and self.habits.is_in(thing.noun, "takes_books")

    def _is_feature(self, noun: Noun, thing: Mention) -> bool:
        """Whether it is a part that furniture comes with: "a cabinet with three drawers", "a vanity with two sinks"."""
        own = noun.kind == "part" and noun.det == "my"
        part = noun.word in grammar().lists["features"]
        part = part or self._is_bowl_of(noun, thing) or self._is_seat_of(noun, thing)
        called = name_of(noun.text.lower().split()) if part and noun.named else None
        named = called is not None and called.length > 1
        return part and not (self.each or own or named or self._is_apart(noun))

    def _is_apart(self, noun: Noun) -> bool:
        """Whether what comes is no part: "two cages with a wheel in each", "a chair with a footrest in front of it"."""
        link = self.peek(1) if noun is self.peek() else None
        other = self._next_noun(2) if self._is_link(link, "prepositions") else None
        if other is None or other.kind != "pronoun":
            return False
        bowl = noun.word in grammar().lists["bowls"] and self._is_link(link, "prepositions", "on", "on_top")
        return other.value == "each" or bowl or self._is_link(link, "prepositions", *_BESIDE)

    def _is_bowl_of(self, noun: Noun, thing: Mention) -> bool:
        """Whether it is the sink of a vanity: what one washes at has one of its own."""
        basin = self.habits.is_in(thing.noun, "basins") or last_word(thing) in grammar().lists["basins"]
        return basin and noun.kind == "thing" and not noun.definite and noun.word in grammar().lists["bowls"]

    def _is_seat_of(self, noun: Noun, thing: Mention) -> bool:
        """Whether it is the seat of a chair, the shade of a lamp."""
        whole = {"seat": ("seats", "chairs"), "shade": ("lamps",)}.get(noun.word, ())
        return bool(whole) and self.habits.is_in(thing.noun, *whole) and not noun.definite

    def _features(self, node: Node, noun: Noun) -> None:
        """Take "two doors and three drawers" for parts of a thing; what is listed after them it may have as well."""
        thing = node.things[-1]
        self.frontier = [*self.frontier, Node([], Listed(node, "with", each=node.each))]
        while True:
            self._feature(thing, noun)
            self._go_past(noun)
            more = self._next_noun(1) if self._is_link(self.peek(), "joins", "and") else None
            if more is None or not self._is_feature(more, thing) or (more.count is None and not more.plural):
                return
            noun = more

    def _is_listed_feature(self, noun: Noun) -> bool:
        """Take the drawers of "a vanity with a mirror, two sinks and three drawers" for its own."""
        frame = self.frontier[-1].frame if self.frontier and self.separator else None
        head = frame.head.thing if frame is not None and frame.kind == "with" and frame.head is not None else None
        if head is None or self.pending is not None or noun.definite or self._is_link(self.peek(), "prepositions"):
            return False
        if not self._is_feature(noun, head) or not (noun.count or noun.plural):
            return False
        self._feature(head, noun)
        return True

    def _feature(self, thing: Mention, noun: Noun) -> None:
        """Note a part that a thing is to have: drawers and doors can be made in any number."""
        self._spend(noun)
        plain, bowl = not (noun.attributes or noun.unshown or noun.size), self._is_bowl_of(noun, thing)
        noun.kind = "abstract"
        tops = [f"{look}-topped" for look in noun.attributes] if noun.word == "top" else []
        if tops and TOPPED.keys() >= {*tops} and not (noun.unshown or noun.size):
            thing.attributes += tops
        elif bowl and plain and noun.count in (None, 1, _PAIR):
            thing.attributes += ["double"] if noun.count == _PAIR and "double" not in thing.attributes else []
        elif noun.count and noun.word in COUNTED_PARTS and plain:
            thing.attributes.append(f"{noun.count}-{noun.word}s")
        else:
            thing.unshown.append(f"with {noun.text}")

    def _go_back_to_framed(self, node: Node | None) -> None:
        """Let "with" be said of each that something surrounds: "five mirrors, each framed by bulbs with a chair"."""
        frame = node.frame if node is not None else None
        if frame is not None and frame.head is not None and frame.each and frame.kind in ("next_to", "around"):
            del self.frontier[self.frontier.index(frame.head) + 1 :]
            self.each = True

    def _head_for(self, noun: Noun | None, kind: str) -> Node | None:
        nodes = [node for node in reversed(self.frontier) if node.things]
        if not nodes:
            return self.subject if self.subject is not None and self.subject.things else None
        if self.each:
            return next((n for n in nodes if len(n.things) > 1 or any(t.many for t in n.things)), nodes[0])
        told = self._before(0)
        if isinstance(told, Connector) and told.text.lower().startswith(("which ", "that ")) and not self.separator:
            return nodes[0]
        single = not nodes[0].things[-1].many or len(nodes) == 1
        if self.separator == "comma" and noun is not None and single and self._lies_on_it(noun):
            return nodes[0]
        covers = kind in ("hold", "carry") and self.habits.is_in(nodes[-1].things[-1].noun, "covers")
        last = self._before()
        named = isinstance(last, Noun) and last.kind == "thing" and not last.definite
        if self.separator in ("comma", "comma_and", "and") and len(nodes) > 1 and not (covers or named):
            outer = [n for n in nodes if n.frame is not None]
            return outer[-1] if outer else nodes[-1]
        if kind in ("hold", "carry"):
            nodes = [n for n in nodes if not self.habits.is_in(n.things[-1].noun, "covers")] or nodes
        if noun is not None and noun.kind == "thing":
            for node in nodes[:3]:
                if node.frame is None and node.known and len(nodes) > 1:
                    continue
                return node
        return nodes[0]

    def _lies_on_it(self, noun: Noun) -> bool:
        """Whether "on top" comes after a noun: "a monitor, with a camera on top, and a keyboard"."""
        at = self.chunks.index(noun, self.at) + 1 - self.at
        part = self.peek(at + 1)
        top = self._is_link(self.peek(at), "prepositions", "on") and isinstance(part, Noun) and part.kind == "part"
        return noun.kind == "thing" and (top or self._is_link(self.peek(at), "prepositions", "on_top"))

    def _open_of_subject(self, kind: str) -> None:
        if self.subject is None:
            return
        self.pending = Listed(self.subject, kind, each=self.each or self.subject.each)
        if self.pending.each:
            self.referents.shared.update(self.subject.things)
        if self.per_group:
            self.pending.each, self.pending.times, self.per_group = False, self.per_group, 0
            self.pending.grouped = True
        self.each = False

    def _as_had_before(self, noun: Noun, index: int) -> Noun:
        """Take "a yellow one" for another of what one has: "one has a pink blanket, the other a yellow one"."""
        kin = [t for node in self.frontier[:1] for thing in node.things for t in self.referents.family(thing)]
        had = (b.subject for b in reversed(self.draft.bonds) if b.implied and any(a in kin for a in b.anchors))
        last = next(had, None)
        if last is None or noun.det != "a" or noun.word != "one" or not (noun.attributes or noun.unshown):
            return noun
        text = f"{noun.text.rpartition(' ')[0]} {last_word(last)}"
        self.chunks[index] = named = replace(noun, kind="thing", value=last.noun, text=text)
        return named

    def _again(self, verb: str) -> None:
        """Let the verb before stand for one left out: "one holds a bust, another a horse"."""
        comma = self._is_link(self.peek(), "mark", "comma")
        after = self.peek(1) if comma else self.peek()
        if isinstance(after, Noun) and after.kind == "number":
            after = self._as_had_before(after, self.at + comma)
        if verb in ("hold", "carry", "have") and isinstance(after, Noun) and after.kind == "thing":
            self.at += comma
            self.subject = self.frontier[0]
            self._open_of_subject("with" if verb == "have" else self.holding if verb == "hold" else verb)
            self.verb = verb
