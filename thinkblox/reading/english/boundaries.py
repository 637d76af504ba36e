"""Where clauses begin and end: marks, conjunctions, brackets."""

from dataclasses import replace

from thinkblox.assets import kind_of
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Listed, Node
from thinkblox.reading.english.referents import FURNITURE, is_small
from thinkblox.reading.english.state import LOOKAHEAD, State


def _is_plain_thing(noun: str) -> bool:
    """Whether nobody made its kind, and it is no furniture."""
    return kind_of(noun).plain and not load_habits().is_in(noun, *FURNITURE)


class Boundaries(State):
    """Ends clauses and parts the members of lists."""

    def _mark(self, link: Connector) -> None:
        match link.value:
            case "colon" if self._is_told_after():
                self.separator = ""
            case "dash" if self.dashed or self._is_aside():
                self._mark(replace(link, value="close" if self.dashed else "open"))
                self.dashed = not self.dashed
            case "stop" | "semicolon" | "colon" | "dash":
                self.dashed = False
                self._end(link.value)
            case "open":
                self.bracket = (list(self.frontier), self.clause, self.subject, self.predicate)
                self._separate("comma")
            case "close" if self.bracket is not None:
                self._close_bracket()
            case "comma" if self.held and not self._lists_on():
                self._release()
            case "comma" | "close" | "and":
                self._separate("and" if link.value == "and" else "comma")

    def _is_aside(self) -> bool:
        """Whether a dash begins what another ends in the same sentence: "two lamps - one of them red - by the door"."""
        noun = self._next_noun()
        if noun is None or noun.kind not in ("number", "pronoun") or not self.frontier:
            return False
        for chunk in self.chunks[self.at : self.at + LOOKAHEAD]:
            if self._is_link(chunk, "mark"):
                return self._is_link(chunk, "mark", "dash")
        return False

    def _is_told_after(self) -> bool:
        """Whether a colon only parts a thing from where it is: "The lathe: under the window."."""
        thing = self.frontier[-1].thing if len(self.frontier) == 1 else None
        following = self._next_noun(1)
        alone = thing is not None and self.clause.members == [thing] and not self.predicate and not thing.many
        if not alone or following is None or not self._is_link(self.peek(), "prepositions"):
            return False
        return following.kind in ("place", "thing", "pronoun") and self._ends_after(following)

    def _ends_after(self, noun: Noun) -> bool:
        """Whether a mark follows a noun that comes."""
        at = self.chunks.index(noun, self.at)
        return at + 1 >= len(self.chunks) or self._is_link(self.chunks[at + 1], "mark")

    def _lists_on(self) -> bool:
        """Whether more of what such a clause lists comes, with an "and": "on which a till, a bell and a vase stand"."""
        at = self.at
        while isinstance(noun := chunk_at(self.chunks, at), Noun) and noun.kind == "thing" and not noun.definite:
            if self._is_link(chunk_at(self.chunks, at + 1), "joins", "and"):
                return isinstance(chunk_at(self.chunks, at + 2), Noun)
            if not self._is_link(chunk_at(self.chunks, at + 1), "mark", "comma"):
                return False
            at += 2
        return False

    def _release(self) -> None:
        """Go on after a clause about what was named in front: "over the hearth, which is ..., hangs a head"."""
        front, self.held = self.held, []
        self.frontier, self.clause, self.subject, self.predicate = [], Listed(), None, False
        self.front, self.separator, self.pending = front, "", None

    def _close_bracket(self) -> None:
        """Go on with what was spoken of before the brackets; all its parts together."""
        if self.bracket is None:
            return
        frontier, clause, subject, predicate = self.bracket
        self.bracket = None
        kept = set(map(id, self.draft.things))
        for node in frontier:
            family = [t for thing in node.things for t in self.referents.family(thing)]
            node.things = [t for t in dict.fromkeys(family) if id(t) in kept]
        clause.members = [t for m in clause.members for t in self.referents.family(m) if id(t) in kept]
        self.frontier = [node for node in frontier if node.things]
        self.clause, self.subject, self.predicate = clause, subject, predicate
        self.referents.parted = None
        self.separator = ""

    def _end(self, kind: str) -> None:
        """End a clause; after a colon or dash, what follows may tell the parts of what came last."""
        things = self.clause.members
        front = self.front if kind == "colon" and not things else []
        sequence = self.sequence if kind == "colon" and not things else None
        self.front = [] if front else self.front
        last = self.frontier[-1].thing if self.frontier else None
        self.whole = last if kind in ("colon", "dash") and last is not None and last.many else None
        if kind == "colon" and last is not None and last.many and not self.predicate:
            last.general = True
        self.said = self.verb if kind == "semicolon" else ""
        self.verb = ""
        if kind == "stop":
            left = self.referents.parted or self.referents.left
            self.referents.left = None if any(left in known.values() for known in self.ordinals.values()) else left
            self.referents.parted = None
            self.meanings.forget_sides()
            self.fresh.clear()
        if self.subject is not None and self.subject.thing is not None:
            self.referents.topics.append(self.subject.thing)
        elif things and not self.excluding:
            listed = len(things) > 1 and not self.existential and not things[-1].many
            self.referents.topics.append(things[-1] if listed else things[0])
        if kind in ("stop", "semicolon"):
            kept = self.referents.centre if kind == "semicolon" else None
            self.referents.centre, self.spoken_of = self.spoken_of or kept, None
        its = [f for f in self.front if f.used and f.where.noun is not None and f.where.noun.kind == "pronoun"]
        side = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        if kind == "semicolon" and its and side is not None and side.kind == "part" and side.det == "my":
            self.referents.topics += [a for a in its[-1].anchors[:1] if isinstance(a, Mention)]
        holder = self._holder() if kind == "colon" else None
        self._begin()
        self.front, self.sequence = front, sequence
        self.opening = None
        if holder is not None:
            holder.frame = self.clause
            self.clause.members.append(holder.things[-1])
            self.frontier = [holder]
            lamp = isinstance(first := self._next_noun(), Noun) and self.habits.is_in(first.value, "lamps")
            self.pending = Listed(holder, "with" if lamp else "hold")

    def _holder(self) -> Node | None:
        """The piece of furniture before a colon that has what is listed after it: "A desk: a laptop and a mug."."""
        node = self.frontier[0] if self.frontier and all(front.used for front in self.front) else None
        thing, listed = node.thing if node is not None else None, self._next_noun()
        if thing is None or self.clause.members != [thing] or listed is None or listed.kind != "thing":
            return None
        carries = self.habits.is_in(thing.noun, "surfaces", "storage")
        carries |= self.habits.tie(listed.value, thing.noun) in ("on", "inside")
        lies = self._belongs(listed.value, "small") or self.habits.is_in(listed.value, "lamps")
        lies |= listed.named and (kind_of(listed.value).mount == "surface" or _is_plain_thing(listed.value))
        return Node([thing]) if carries and lies and not (listed.definite or is_small(thing)) else None

    def _begin_again(self) -> None:
        topic = self.clause.members[:1]
        self.referents.topics += topic
        self._begin()

    def _join(self, link: Connector) -> None:
        match link.value:
            case "and" | "or":
                if link.value == "or" and (self._is_choice_of_places() or self._is_choice()):
                    self._lose_choice(link)
                    return
                before = self._before()
                barred = isinstance(before, Noun) and before.kind == "thing" and before.det == "no"
                keep = (self.excluding or barred) and link.value == "or"
                self._separate(link.value)
                self.excluding |= keep
                if link.text.lower() in grammar().lists["together"] and self.predicate:
                    self.together = self.subject
            case "but" if self._all_but() or self._all_but_one(link):
                pass
            case "but":
                negated = self.negating
                self._separate("comma")
                if negated and self.subject is not None:
                    self.predicate = True
            case "stop":
                self._end("stop")
            case "which":
                named = self._told_before_which() or next((n for n in reversed(self.frontier) if n.things), None)
                self.relative = self._denied_carrier(named) or named or self._hold_front()
                self.separator = ""

    def _told_before_which(self) -> Node | None:
        """The bed of "to the left of a bed that stands against the wall", where it is to it that something stands."""
        comma = self._is_link(self._before(), "mark", "comma")
        noun, link, verb = self._before(1 + comma), self._before(2 + comma), self.peek()
        told = self._is_link(verb, "verbs", "be", "stand", "face") and self._is_link(link, "prepositions")
        part = self._before(3 + comma) if self._is_link(link, "prepositions", "of") else None
        whole = isinstance(part, Noun) and part.kind == "part"
        if not told or not isinstance(noun, Noun) or self._is_link(link, "prepositions", "with", "for", "as"):
            return None
        if self._is_link(link, "prepositions", "of") and not whole:
            return None
        things = self.meant.get(noun.start, []) if noun.kind == "thing" and noun.many != _is_singular(verb) else []
        return Node(list(things), self.clause, known=True) if things else None

    def _denied_carrier(self, named: Node | None) -> Node | None:
        """The bookcase of "three books, none of them in the bookcase, which is against the wall"."""
        before, verb = self._before(2), self.peek()
        things = self.meant.get(before.start, []) if isinstance(before, Noun) and not before.many else []
        single = isinstance(verb, Connector) and verb.text.lower().split()[0] in (
            "is",
            "stands",
            "hangs",
            "sits",
            "has",
        )
        many = named is not None and any(thing.many for thing in named.things)
        denied = any(b.negated and things[-1] in b.anchors for b in self.draft.bonds) if things else False
        return Node(things, None, known=True) if single and many and denied else None

    def _hold_front(self) -> Node | None:
        """What a clause in between is about: "behind the counter, on which there is a jar, stands a shelf"."""
        if not self.front or self.clause.members or self.front[-1].used:
            return None
        anchors = [a for a in self.front[-1].anchors if isinstance(a, Mention)]
        self.held, self.front = self.front, []
        return Node(anchors, None, known=True) if anchors else None

    def _all_but(self) -> bool:
        """Read "every chair but one": what follows is said of the others."""
        said, noun = self._before(), self._next_noun()
        thing = self.frontier[-1].thing if self.frontier else None
        several = isinstance(said, Noun) and (said.det in ("each", "all") or said.value in ("each", "all"))
        if not several or thing is None or noun is None or (isinstance(said, Noun) and said.kind == "place"):
            return False
        if noun.kind != "number" and noun.value != "one":
            return False
        if not noun.count or (thing.count or 0) <= noun.count:
            return False
        led = self._is_link(self._before(2), "prepositions")
        self._go_past(noun)
        before = self.draft.bonds[-1] if self.draft.bonds and led else None
        self.referents.leave_out(thing, noun.count)
        self._look_so(thing, noun)
        if before is not None and before.each and thing in before.anchors:
            left_out = set(map(id, self.referents.parts.get(thing, ())))
            before.anchors = tuple(a for a in before.anchors if id(a) not in left_out)
        if noun.side or noun.ordinal:
            self._lose(noun.start, noun.end)
        told = noun.text.lower() == "the one" and self._is_link(self.peek(), "prepositions")
        if told:
            self.frontier = [Node([self.referents.parts[thing][-1]], self.clause, known=True)]
            return True
        self.frontier[-1].things = [thing]
        self.each = True
        return True

    def _look_so(self, rest: Mention, left_out: Noun) -> None:
        """Let the others look as is said of them: "all but three are yellow"."""
        if not {"are", "is"}.isdisjoint(left_out.text.lower().split()):
            rest.attributes += [look for look in left_out.attributes if look not in rest.attributes]

    def _all_but_one(self, link: Connector) -> bool:
        """Whether "every easel but the middle one" leaves out one that is not counted out; that is not understood."""
        said, noun = self._before(), self._next_noun()
        several = isinstance(said, Noun) and (said.det in ("each", "all", "both") or said.value in ("each", "all"))
        if not several or noun is None or noun is not self.peek() or noun.kind not in ("number", "pronoun", "thing"):
            return False
        after = self.peek(1)
        if after is not None and not self._is_link(after, "mark") and not self._is_link(after, "prepositions"):
            return False
        self._go_past(noun)
        self._spend(noun)
        self._lose_rest(link.start, noun.end)
        return True

    def _lose_rest(self, start: int, end: int) -> None:
        """Go past "except the one nearest the door", which is not understood."""
        while (chunk := self.peek()) is not None and not self._is_link(chunk, "mark"):
            self.at += 1
            end = chunk.end
        self._lose(start, end)

    def _is_choice(self) -> bool:
        """Whether "a sofa or a bed" asks for one of two: no list goes on, and nothing is denied."""
        before, noun = self._before(), self._next_noun()
        if self.excluding or self.negating or self.draft.empty or not isinstance(before, Noun) or before.det == "no":
            return False
        if before.kind != "thing" or noun is None or noun.kind != "thing":
            return False
        anchor = self._is_link(self._before(2), "prepositions")
        return not noun.definite or (before.definite and (anchor or self.referents.named(noun) is None))

    def _is_choice_of_places(self) -> bool:
        """Whether "by the window or at the foot of the bed" leaves open where something is."""
        denied = self.excluding or self.negating or self.draft.empty
        return not denied and self._is_link(self.peek(), "prepositions") and isinstance(self._before(), Noun)

    def _lose_choice(self, link: Connector) -> None:
        """Keep the first of two to choose from; the other, with all that is said of it, is not understood."""
        end, relative = link.end, False
        while (chunk := self.peek()) is not None and not self._is_link(chunk, "mark"):
            if self._is_link(chunk, "joins", "and", "but", "stop") or (
                self._is_link(chunk, "verbs") and not relative and isinstance(self._before(0), Noun)
            ):
                break
            relative |= self._is_link(chunk, "joins", "which")
            end = chunk.end
            self.at += 1
        self._lose(link.start, end)

    def _separate(self, kind: str) -> None:
        self.negating = False
        if self.separator in ("comma", "comma_and") and kind == "and":
            kind = "comma_and"
        elif self.separator in ("and", "comma_and") and kind == "comma":
            kind = self.separator
        if kind in ("and", "comma") and self.excluding and self._next_is_excluded(bare=kind == "comma"):
            return
        self.excluding = False
        self.separator = kind
        self.relative = None
        if self.pending is not None and (self.pending.members or kind != "comma"):
            self.pending = None

    def _next_is_excluded(self, *, bare: bool) -> bool:
        """Whether "without a television and a rug" goes on: a noun without a verb or relation of its own."""
        noun = self._next_noun()
        if noun is None or noun.kind != "thing" or (bare and (noun.det or noun.count is not None)):
            return False
        after = self.peek(1)
        if bare and self._is_instead():
            return False
        return not isinstance(after, Connector) or after.sort == "mark" or after.value in ("or", "and")

    def _is_instead(self) -> bool:
        """Whether what is barred was to be replaced: "a rail instead of a wardrobe, a kettle"."""
        return self._is_link(self._before(2), "prepositions", "instead")


def _is_singular(verb: Chunk | None) -> bool:
    """Whether a verb is one of a single thing: "is", "stands"."""
    return isinstance(verb, Connector) and verb.text.lower().removeprefix("that ").split()[0].endswith("s")
