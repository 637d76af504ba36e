"""Numbers that stand for some of several."""

from dataclasses import replace

from thinkblox.assets.palette import COLOURS
from thinkblox.reading.attach import bind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun
from thinkblox.reading.english.nodes import Listed, Node
from thinkblox.reading.english.referents import parts_of
from thinkblox.reading.english.verbs import Verbs

_SIDES = ("in_front_of", "behind", "left_of", "right_of", "under", "above", "opposite")
"""Relations that one thing can have to another one at a time."""

_SIDES_OF_TABLE = 4
_RECENT = 20
"""So many relations back, at most, something was said to be on each of several."""

_SOME = 2
_STANDING_VERBS = ("be", "stand", "hang", "lie")
_AT = ("in", "on", "on_top", "around", "under")
_EXCLUSIVE = ("on", "on_top", "around", "at", "inside", "in_corner", "in_centre")
"""Where things are that are nowhere else: by these they are told of where more of them are."""


class Numbers(Verbs):
    """Reads numbers without a noun."""

    def _number(self, noun: Noun) -> None:
        """A number that stands for some of several: "two by the window", "three of them chrome"."""
        if noun.rows and not noun.of_known:
            self._arrange(noun)
            return
        if self._is_told_besides(noun):
            return
        if self.barred is not None and noun.text.lower().endswith(("one", "ones")) and not noun.of_known:
            self._instead(self.barred, noun)
            return
        link = self.peek()
        bounded = noun.least is not None or noun.most is not None
        if bounded and not noun.of_known and not self._is_link(link, "prepositions"):
            self._bound_next(noun)
            return
        each = self._next_noun(1) if self._is_link(link, "prepositions") else None
        if self.bracket is not None and each is not None and each.kind == "pronoun" and each.value == "each":
            self.at += 2
            return
        if (
            self._shares_out(noun)
            or self._goes_back(noun)
            or self._are_people_at_each(noun)
            or self._are_all_parts(noun)
        ):
            return
        whole = self._of_owners(noun) or self._one_left(noun, [])
        if whole is not None:
            aside = self._list_of(whole)
            self._some(whole, noun)
            self.aside = aside or self.aside
        elif noun.count and not self.draft.things:
            self.draft.people = noun.count
        elif noun.det == "each" or not self.draft.people:
            self._lose(noun.start, noun.end)

    def _are_all_parts(self, noun: Noun) -> bool:
        """Speak of each of those that were told apart: "all seven have a lamp" after "four here and three there"."""
        if noun.det != "all" or not noun.count or noun.of_known or noun.attributes or noun.unshown:
            return False
        family = self.referents.last_family()
        if sum(self.referents.total(t) for t in family) != noun.count:
            return False
        self._resume(family, noun)
        self.frontier[0].each = True
        return True

    def _is_told_besides(self, noun: Noun) -> bool:
        """Whether it is no part of those that were named, but more of them, their look, or one of each kind."""
        return (
            self._are_more_elsewhere(noun)
            or self._again_with(noun)
            or self._adds(noun)
            or self._is_look_of_last(noun)
            or self._is_of_each_kind(noun)
        )

    def _are_more_elsewhere(self, noun: Noun) -> bool:
        """Read "six bicycles hang on the wall and four stand in the middle" as ten: they cannot be at both places."""
        plain = noun.count and not (noun.det or noun.of_known or noun.ordinal or noun.attributes or noun.unshown)
        joined = self._is_link(self._before(), "joins", "and") or self._is_link(self._before(), "mark", "comma")
        told = self._is_link(self.peek(), "verbs", *_STANDING_VERBS) and self._is_link(
            self.peek(1), "prepositions", *_AT
        )
        thing = self.subject.thing if self.subject is not None and self.predicate else None
        if not (plain and joined and told) or thing is None or not thing.count or thing.count < _SOME:
            return False
        before, there = self.draft.bonds_of(thing), self._next_noun(2)
        placed = [b for b in before if b.asked and not (b.negated or b.implied or b.each)]
        fixed = len(placed) == 1 and placed[0].kind in _EXCLUSIVE and len(self.referents.family(thing)) == 1
        wall = there is not None and there.value.endswith("wall")
        if not fixed or there is None or wall or (there.kind == "thing" and not there.definite and there.det != "a"):
            return False
        if any(there.value == (a.noun if isinstance(a, Mention) else a) for a in placed[0].anchors):
            return False
        more = self._copy_of(thing)
        more.count, more.plural = noun.count, (noun.count or 1) > 1
        self._speak_of_part(more, noun)
        return True

    def _are_people_at_each(self, noun: Noun) -> bool:
        """Say of "six students sit at three desks, two at each" that nobody sees to who sits where."""
        said = self.chunks[self._clause_start() : self.at - 1]
        people = next((c for c in said if isinstance(c, Noun)), None)
        each = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        if people is None or people.kind != "people" or not people.count or each is None or noun.of_known:
            return False
        if not (each.each or each.value == "each") or people.count % (noun.count or 1):
            return False
        self._go_past(each)
        self._lose(noun.start, each.end)
        return True

    def _goes_back(self, noun: Noun) -> bool:
        """Go back to the only thing that looks so: "a red chair and a blue chair; the red one ..."."""
        like = self._of_look(noun, []) if noun.word == "one" and not noun.of_known else None
        if like is not None:
            self._spend(noun)
            self._resume([like], noun)
        return like is not None

    def _is_besides(self, noun: Noun) -> bool:
        """Read "and two more in front of it", "another one is by the door": so many besides those that were named.

        Not where several are parted: of five, "three others" are the rest.
        """
        parted = self.referents.parted is not None or (self.whole is not None and self.whole in self.draft.things)
        if noun.det != "another" or noun.of_known or parted:
            return False
        named = self._latest_told()
        if named is None:
            return False
        more = self._copy_of(named)
        more.count, more.plural = noun.count, (noun.count or 1) > 1
        look = self.peek(1) if self._is_link(self.peek(), "verbs", "be") else self.peek()
        if isinstance(look, Adjective) and not COLOURS.keys().isdisjoint(look.attributes):
            more.attributes = [word for word in more.attributes if word not in COLOURS]
        told = self._is_told_next() or self._is_link(self.peek(), "verbs")
        if self.separator and self.clause.members and not told:
            self._take(more, noun)
        else:
            self._speak_of_part(more, noun)
        return True

    def _latest_told(self) -> Mention | None:
        """Of what there is one more: what was named last, and is not what the one more stands by itself."""
        near = [n.thing for n in reversed(self.frontier) if n.frame is not None and n.thing is not None]
        near += self.clause.members[::-1]
        topic = self.referents.topics[-1:]
        link = self.peek() if self._is_told_next() else None
        if topic and isinstance(link, Connector):
            anchor = self._next_noun(1)
            by_it = anchor is not None and anchor.kind == "pronoun"
            its = [b for b in self.draft.bonds[::-1] if topic[0] in b.anchors and not b.implied]
            near += [b.subject for b in its if by_it or b.kind == link.value]
        return next((t for t in [*near, *topic, *self.referents.spoken[::-1]] if t in self.draft.things), None)

    def _is_of_each_kind(self, noun: Noun) -> bool:
        """Read "bowls, vases and plates, ten of each": so many of each kind that nobody counted."""
        each = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "of") else None
        if each is None or each.value != "each" or each.text.lower() != "each" or not noun.count or noun.of_known:
            return False
        said = [c for c in self.chunks[self._clause_start() : self.at] if isinstance(c, Noun)]
        bare = [(t, c.plural or not c.det) for c in said for t in self.meant.get(c.start, ()) if t.count is None]
        kinds = [thing for thing, counts in bare if counts or thing.plural]
        for thing in kinds:
            thing.count, thing.plural = noun.count, noun.count > 1
        if kinds:
            self._go_past(each)
        return bool(kinds)

    def _speak_of_rows(self, noun: Noun) -> bool:
        """Let what is told of "each row" hold so many times as there are rows."""
        rows = next((thing for thing in reversed(self.draft.things) if thing.rows > 1), None)
        if rows is None or not self._is_link(self.peek(), "verbs"):
            return False
        self._spend(noun)
        self.frontier = [Node([rows], self.clause, known=True, each=True)]
        self.clause.members, self.per_group = [rows], rows.rows
        return True

    def _name_by_share(self, noun: Noun, each: Noun) -> bool:
        """Ask for the three chairs of "three microphones, one per chair"."""
        whole = self._whole([])
        share = noun.count or 0
        if whole is None or not whole.count or whole.count % share:
            return False
        self._go_past(each)
        several = replace(each, det="", count=whole.count // share, plural=True)
        self.numbers.add(share)
        self.clause.members.append(self._new(several))
        self.meant[each.start] = self.clause.members[-1:]
        return True

    def _is_look_of_last(self, noun: Noun) -> bool:
        """Take "the stove, a black cast-iron one", "mine is a black one" for what the stove is like."""
        thing = self.frontier[-1].thing if self.frontier else None
        of_subject = self.subject is not None and self._is_link(self._before(), "verbs", "be") and not self.existential
        thing = self.subject.thing if of_subject and self.subject is not None else thing
        told = self._is_link(self._before(), "mark", "colon") and not self.frontier
        thing = self.referents.spoken[-1] if told and self.referents.spoken else thing
        plain = noun.det == "a" and noun.word == "one" and not (noun.of_known or noun.ordinal or noun.side)
        if (
            thing is None
            or thing.many
            or not plain
            or (self.referents.parted is not None and not of_subject)
            or not (self.separator == "comma" or told or of_subject)
            or not (noun.attributes or noun.unshown or len(noun.text.split()) > len(("a", "one")))
        ):
            return False
        self._spend(noun)
        self._look(thing, noun)
        if told:
            self._resume([thing], noun)
        return True

    def _shares_out(self, noun: Noun) -> bool:
        """Read "twelve computers on six desks, two on each": how many of those just placed each of the others has."""
        link, each = self.peek(), self._next_noun(1)
        told = noun.of_known or noun.ordinal or noun.side or noun.attributes or noun.unshown
        if told or not noun.count or each is None or not self._is_link(link, "prepositions"):
            return False
        if not (each.each or each.value == "each" or self._is_link(link, "prepositions", "per")):
            return False
        if each.kind == "thing" and self.referents.named(each) is None and self._is_link(link, "prepositions", "per"):
            return self._name_by_share(noun, each)
        named = set(self.referents.every(each)) if each.kind == "thing" else set()
        for bond in self.draft.bonds[::-1][:_RECENT]:
            holders = [a for a in bond.anchors if isinstance(a, Mention) and (each.kind != "thing" or a in named)]
            subject, many = bond.subject, sum(self.referents.total(a) for a in holders)
            shared = bool(holders) and len(holders) == len(bond.anchors) and many > 1
            if shared and not (bond.each or bond.implied or bond.negated) and subject.count == noun.count * many:
                self.numbers.add(subject.count)
                subject.count, bond.each = noun.count, True
                self.meant[noun.start] = [subject]
                self._spend(each)
                self._go_past(each)
                self.frontier = [Node([subject], self.clause, known=True)]
                return True
        many = sum(self.referents.total(t) for t in named)
        for thing in self.clause.members[::-1] if many > 1 else ():
            if thing.count == noun.count * many and not self.draft.bonds_of(thing) and thing not in named:
                self.numbers.add(thing.count)
                thing.count = noun.count
                self.meant[noun.start] = [thing]
                self.frontier, self.subject = [Node([thing], self.clause, known=True)], None
                return True
            if self._is_link(link, "prepositions", "per") and thing.count == noun.count * many and thing not in named:
                self._spend(each)
                self._go_past(each)
                return True
        return False

    def _adds(self, noun: Noun) -> bool:
        """Read numbers that ask for more of the same: "as many on the right", "three of roses", "and a red one"."""
        if noun.share:
            self._as_many(noun)
            return True
        if self._is_besides(noun):
            return True
        looks = Adjective(noun.start, noun.end, noun.text, [*noun.attributes], [], [*noun.unshown])
        one = noun.det == "a" and noun.text.lower().endswith(" one")
        if self._more_of(noun) or (one and self._is_another_like(looks)):
            return True
        if self._is_one_more(noun):
            self._add_one(noun)
            return True
        return False

    def _again_with(self, noun: Noun) -> bool:
        """Read "four round tables with three chairs and two square ones with four": four of the same."""
        head = self.pending.head.thing if self.pending is not None and self.pending.head is not None else None
        if head is None or not noun.count or noun.of_known or noun.ordinal or noun.side or noun.det:
            return False
        family = [t for t in self.referents.family(head) if t is not head]
        had = [b for b in self.draft.bonds if b.implied and any(a in family for a in b.anchors)]
        if self.pending is None or not had:
            return False
        self.pending.each |= had[-1].each
        more = self._copy_of(had[-1].subject)
        more.count, more.plural = noun.count, noun.count > 1
        self._take(more, noun)
        return True

    def _as_many(self, noun: Noun) -> None:
        """Read "six lockers on the left and as many on the right": as many more."""
        last = next((t for t in reversed(self.clause.members) if t in self.draft.things and t.count), None)
        if last is None or not self.separator or not self._is_link(self.peek(), "prepositions"):
            self._lose(noun.start, noun.end)
            return
        more = self._copy_of(last)
        more.count = max(1, int(self.referents.total(last) * noun.share))
        more.plural = more.count > 1
        self._take(more, noun)

    def _more_of(self, noun: Noun) -> bool:
        """Read "five buckets of tulips, three of roses and one with sunflowers": three more, filled with others."""
        last = self.draft.things[-1] if self.draft.things else None
        what = self._next_noun(1)
        if last is None or " of " not in last.text or what is None or what.kind != "thing" or what.definite:
            return False
        filled = self._is_link(self.peek(), "prepositions", "of")
        filled |= self.adding and self._is_link(self.peek(), "prepositions", "with")
        if not filled or noun.of_known or noun.ordinal or not self.separator:
            return False
        self.adding = True
        self._go_past(what)
        self._spend(what)
        more = self._copy_of(last)
        more.count, more.plural = noun.count or 1, (noun.count or 1) > 1
        more.text = f"{last.text.partition(' of ')[0]} of {what.text}"
        self._take(more, noun)
        return True

    def _is_one_more(self, noun: Noun) -> bool:
        """Whether "four small parcels and a large one" lists one more of the same kind."""
        looks = noun.attributes or noun.unshown
        last = self.frontier[-1].thing if self.frontier else None
        rest = self.referents.parted
        if rest is not None and rest.count == 1 and last is not None and rest in self.referents.family(last):
            return False  # Of "three chairs, two blue ones and a red one" it is the third.
        ends = noun.det == "a" and noun.text.lower().endswith(" one")
        return bool(ends and looks and self.separator == "and" and last is not None and last.many)

    def _add_one(self, noun: Noun) -> None:
        last, frame = self.frontier[-1].things[-1], self.frontier[-1].frame
        more = self._copy_of(last)
        more.attributes, more.unshown, more.plural = [*noun.attributes], [*noun.unshown], False
        if frame is not None:
            self._member(more, frame)
            self._push(Node([last, more], frame))
        self._apply_front([more])

    def _instead(self, barred: Noun, noun: Noun) -> None:
        """Read "There are no plants on the desks; two tall ones stand near the window"."""
        self.barred = None
        self.draft.excluded.discard(barred.value)
        kind = replace(noun, kind="thing", value=barred.value, text=barred.word, named=barred.named)
        self._take(self._new(kind), kind)

    def _bound_next(self, noun: Noun) -> None:
        """Give "at least two and at most four stools" both bounds; a bound of nothing is not understood."""
        if self._is_other_bound(noun):
            return
        after = self._next_noun(1) if self._is_link(self.peek(), "joins", "and", "but") else None
        if after is None or after.kind != "thing" or (after.least is None and after.most is None):
            thing = self.frontier[-1].thing if self.frontier and self.separator == "comma" else None
            if thing is None or thing.count is not None or not noun.count:
                self._lose(noun.start, noun.end)
            else:
                thing.count, thing.least, thing.most = noun.count, noun.least, noun.most
            return
        after.least = noun.least if after.least is None else after.least
        after.most = noun.most if after.most is None else after.most
        self.at += 1

    def _is_other_bound(self, noun: Noun) -> bool:
        """Read "no more than five plants but at least three": both bounds of the plants."""
        thing = self.frontier[-1].thing if self.frontier else None
        joined = self._is_link(self._before(), "joins", "and", "but") or self._is_link(self._before(), "mark", "comma")
        last = not isinstance(self._next_noun(1), Noun) or self._is_link(self.peek(), "mark")
        if thing is None or not joined or not last or noun.count is None:
            return False
        least = thing.least if noun.least is None else noun.least
        most = thing.most if noun.most is None else noun.most
        told = (thing.least is None) != (thing.most is None)
        if not told or least is None or most is None or least > most:
            return False
        thing.least, thing.most, thing.count = least, most, min(max(thing.count or least, least), most)
        return True

    def _some(self, whole: Mention, noun: Noun) -> None:
        """Speak of so many, of the other, of the third of `whole`."""
        if self._is_total(noun, whole):
            return
        if noun.det == "none":
            self._resume([whole], noun)
            self.negating = True
        elif noun.det == "other":
            self._look(whole, noun)
            self.referents.parted = None
            self._resume(self._others(whole), noun)
        elif noun.ordinal > 2 and noun.det == "a" and self.whole is whole:
            self.referents.settle(whole)
            self._part_of(whole, max(1, (whole.count or 0) // noun.ordinal), noun)
        elif noun.side or noun.ordinal or (noun.degree and noun.det == "the" and noun.count == 1):
            self._the_one(noun)
        else:
            self._part_of(whole, self._how_many(noun, whole), noun)

    def _the_one(self, noun: Noun) -> None:
        """Speak of "the left one", "the second"; a verb left out is that of the one before."""
        part = self.some_of(noun, []) or self._one_past(noun)
        if part is None:
            self._lose(noun.start, noun.end)
            return
        self._look(part, noun)
        self._resume([part], noun)
        self._again(self.verb)
        if self.said in ("hold", "carry", "have") and self._is_link(self.peek(), "mark", "comma"):
            self.at += 1
            self.subject = self.frontier[0]
            self._open_of_subject("with" if self.said == "have" else self.said)

    def _one_past(self, noun: Noun) -> Mention | None:
        """Read "a rack holds five cues; the sixth lies on the table": one more of the same."""
        whole = self._whole([])
        family = self.referents.family(whole) if whole is not None else []
        if whole is None or noun.ordinal != sum(self.referents.total(t) for t in family) + 1:
            return None
        return self._copy_of(whole)

    def _is_total(self, noun: Noun, whole: Mention) -> bool:
        """Whether a number only sums up: "as many mats as there are machines, five"."""
        after = self.peek()
        plain = not (noun.attributes or noun.unshown or noun.states or noun.of_known or noun.side or noun.ordinal)
        if not plain or isinstance(after, (Adjective, Noun)):
            return False
        ends = after is None or self._is_link(after, "mark") or self._is_link(after, "fillers")
        if ends and noun.count and self.separator and self.frontier:
            thing = self.frontier[-1].thing
            if thing is not None and (thing.count is None or thing.vague):
                thing.count, thing.vague = noun.count, False
            return True
        return False

    def _arrange(self, noun: Noun) -> None:
        """Read "(six shelving units stand) in two rows of three"; "the last row" is not understood."""
        if noun.each and self._speak_of_rows(noun):
            return
        if noun.ordinal or noun.det in ("the", "my"):
            self._lose(noun.start, noun.end)
            self.frontier, self.subject = [Node()], None
            return
        thing = self._whole([])
        if thing is not None:
            bind(self.draft, Bond("in_rows", thing, rows=max(noun.rows, 0)))

    def _except(self, whole: Mention, count: int) -> None:
        """Read "every chair has a dictionary on it apart from one": what was said of all is not said of these."""
        part = self.referents.part(whole, count)
        for bond in self.draft.bonds:
            if part in bond.anchors and whole in bond.anchors:
                bond.anchors = tuple(anchor for anchor in bond.anchors if anchor is not part)
        self._speak_of_part(part, None)

    def _unlook(self, part: Mention, said: Chunk | None) -> None:
        """Take back what was said of all but these: "the chairs are black except one"."""
        if not isinstance(said, Adjective):
            return
        part.attributes = [look for look in part.attributes if look not in said.attributes]
        part.unshown = [look for look in part.unshown if look not in said.unshown]
        part.states = [state for state in part.states if state not in said.states]
        self.referents.inherited[part] = [*part.attributes]

    def _part_of(self, whole: Mention, count: int, noun: Noun | None = None) -> None:
        """Set so many of `whole` apart and speak of them."""
        if self._leaves_out(whole, count) or self._sit_all_around(whole, count, noun):
            return
        if noun is not None and self._is_look_of_some(whole, count, noun):
            self._speak_of_part(self._part_of_each(whole, count), noun)
        else:
            self._part_of_all(whole, count, noun)

    def _part_of_all(self, whole: Mention, count: int, noun: Noun | None) -> None:
        times = self._times_next()
        if noun is not None and (noun.attributes or noun.unshown) and self.referents.total(whole) > (whole.count or 1):
            self.referents.settle(whole)
        told_anew = times > 1 and count * times == whole.count and not self._is_at_other_sides(whole)
        walls = [b for b in self.draft.bonds_of(whole) if b.spread > 1 or b.anchors == ("long_wall",)]
        if told_anew and walls and (sides := self._next_noun(1)) is not None and sides.kind == "part":
            self._go_past(sides)
        if not told_anew and self._is_more(whole, noun):
            part = self._copy(whole, count * times)
            self._speak_of_part(part, noun)
            return
        same = whole.count is not None and count * times == whole.count and whole is not self.summed
        if same and whole is not self.referents.parted:
            self._resume([whole], noun or Noun("number", "", -1, -1))
            if noun is not None:
                self._look(whole, noun)
            self.counted.add(whole)
            return
        self.referents.settle(whole)
        if times > 1 and whole.count is not None and count * times > whole.count and whole is not self.referents.parted:
            whole.count = count * times
        total = count * times
        if whole.count is None and whole is not self.referents.parted:
            whole.count = total
            whole.vague = False
            self.summed = whole
            self.summed_looks = ([*whole.attributes], [*whole.unshown], [*whole.states])
            part = whole
        elif self.summed is whole and whole.count is not None and not self._is_parted(whole):
            part = self._copy(whole, total)
            part.attributes, part.unshown, part.states = ([*looks] for looks in self.summed_looks)
        else:
            part = self.referents.part(whole, min(total, whole.count or total))
        self._speak_of_part(part, noun)

    def _is_look_of_some(self, whole: Mention, count: int, noun: Noun) -> bool:
        """Whether a look is told of some of what each has: "each with two cushions, one red and one blue"."""
        each = any(b.each and parts_of(b) and whole not in parts_of(b) for b in self.draft.bonds_of(whole))
        which = noun.text.lower().endswith(" of which")
        looks = which or (bool(noun.attributes) and not (noun.definite or self.predicate))
        fewer = count < (whole.count or 1) or (count == whole.count and whole is self.referents.parted)
        return each and looks and fewer and (which or bool(self.separator))

    def _part_of_each(self, whole: Mention, count: int) -> Mention:
        """Set so many apart of what each of several has, so that each has as many of these."""
        shared = [bond for bond in self.draft.bonds_of(whole) if bond.each]
        for bond in shared:
            bond.each = False
        part = self.referents.part(whole, count)
        for bond in (*self.draft.bonds_of(part), *self.draft.bonds_of(whole)):
            bond.each |= any((bond.kind, bond.anchors) == (told.kind, told.anchors) for told in shared)
        return part

    def _leaves_out(self, whole: Mention, count: int) -> bool:
        """Set apart those of which what was said of all is not true, where that is what is told."""
        if not self.excepting or (whole.count or 0) <= count:
            return False
        self.excepting, said = False, self._before(2)
        self._except(whole, count)
        self._unlook(self.frontier[-1].things[-1], said)
        return True

    def _sit_all_around(self, whole: Mention, count: int, noun: Noun | None) -> bool:
        """Read "four chairs, one on each side of the table", which has four, as chairs around it."""
        side, of = self._next_noun(1), self.peek(2)
        each = side is not None and side.kind == "part" and side.value == "side" and side.det == "each"
        seats = self.habits.is_in(whole.noun, "seats", "chairs") and whole.count == _SIDES_OF_TABLE * count
        placed = {b.kind for b in self.draft.bonds_of(whole)}
        if not each or not seats or not self._is_link(self.peek(), "prepositions", "on", "at"):
            return False
        if side is None or "side" not in side.text.lower().split() or not placed <= {"around", "at"}:
            return False
        told = self._is_link(of, "prepositions", "of")
        if not (placed or told):
            return False
        self.numbers.add(count)
        link = self.chunks[self.at]
        around = [Connector("prepositions", "around", link.start, side.end, "around")] if told else []
        self.chunks[self.at : self.at + 2 + told] = around
        self._resume([whole], noun or Noun("number", "", -1, -1))
        return True

    def _is_at_other_sides(self, whole: Mention) -> bool:
        """Whether those at the ends of a table are told of after those at its long sides, or the other way round."""
        part = self._next_noun(1)
        ends = part is not None and part.value in ("end", "short_side", "head")
        placed = {bond.kind for bond in self.draft.bonds_of(whole)}
        return part is not None and ("at_long_side" if ends else "at_short_side") in placed

    def _is_parted(self, whole: Mention) -> bool:
        """Whether some of these, rather than of others, were told apart last."""
        return self.referents.parted in (whole, *self.referents.family(whole))

    def _is_more(self, whole: Mention, noun: Noun | None) -> bool:
        """Whether a number adds to what was placed: "two chairs on each side and one at each end"."""
        link = self.peek()
        placed = [b.kind for b in self.draft.bonds_of(whole) if not b.implied and b.kind in _SIDES]
        elsewhere = isinstance(link, Connector) and link.value in _SIDES and placed and link.value not in placed
        walled = any(b.anchors and str(b.anchors[0]).endswith("_wall") for b in self.draft.bonds_of(whole))
        beyond = self.separator == "comma" and (whole in self.multiplied or bool(elsewhere) or walled)
        if (self.separator != "and" and not beyond) or whole is self.referents.parted or whole is self.whole:
            return False
        if noun is not None and (noun.of_known or noun.attributes or noun.unshown):
            return False
        return any(not bond.implied for bond in self.draft.bonds_of(whole)) and self._is_link(
            self.peek(), "prepositions"
        )

    def _speak_of_part(self, part: Mention, noun: Noun | None) -> None:
        if noun is not None:
            self.meant[noun.start] = [part]
            self._look(part, noun)
            part.least = part.least if noun.least is None else noun.least
        self.counted.add(part)
        frame = Listed(None, "list")
        self.frontier = [Node([part], frame, known=True)]
        frame.members.append(part)
        self.clause = frame
        self.subject = None
        self.predicate = False

    def _list_of(self, part: Mention) -> tuple[Node, Listed] | None:
        """The list of what each of several has that a thing, or what it was parted from, belongs to."""
        family = self.referents.family(part)
        for node in reversed(self.frontier):
            head = node.frame.head if node.frame is not None else None
            if head is not None and node.frame is not None and any(t in node.frame.members for t in family):
                return (head, node.frame) if node.frame.each else None
        return None

    def _copy(self, whole: Mention, count: int) -> Mention:
        part = replace(
            whole, count=count, attributes=[*whole.attributes], unshown=[*whole.unshown], states=[*whole.states]
        )
        part.per = [*whole.per]
        anchors = [a for b in self.draft.bonds_of(whole) for a in b.anchors if isinstance(a, Mention)]
        part.host = part.host or next(iter(anchors), None)
        self.draft.things.append(part)
        self.draft.bonds += [replace(b, subject=part) for b in self.draft.bonds_of(whole) if b.implied]
        self.referents.speak(part)
        return part

    def _times_next(self) -> int:
        """How many sides are named next, where a number is that of each: "three on each long side"."""
        link = self.peek()
        noun = self._next_noun(1) if self._is_link(link, "prepositions") else None
        if noun is not None and noun.kind == "part" and self._is_link(link, "prepositions", "per"):
            self._go_past(noun)
            return 2
        if noun is None or noun.kind not in ("part", "place") or noun.det not in ("each", "either", "both"):
            return 1
        if noun.kind == "part":
            return 2
        if noun.count:
            return noun.count
        return 4 if noun.value in ("wall", "corner") and "side" not in noun.text.lower() else 2
