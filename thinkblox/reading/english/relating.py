"""Binds things to what they are related to."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.holders import called_after
from thinkblox.reading.english.naming import Naming
from thinkblox.reading.english.nodes import Meaning
from thinkblox.reading.english.parts import SIDES
from thinkblox.reading.english.referents import is_small, last_word

_SEATED = ("at", "around", "at_long_side", "at_short_side", "next_to", "in_front_of")
"""How seats stand to their tables."""
_ALONG = 4
"""So many sit along both long sides of a table, where nobody says how many."""
_MOST_MEET = 20
"""More people than this do not all sit at one table."""


class Relating(Naming):
    """Makes bonds of meanings."""

    def _relate(self, subjects: list[Mention], meaning: Meaning, *, negated: bool = False) -> None:
        """Bind subjects to what they are related to."""
        if not negated and self._flanks_with(subjects, meaning):
            return
        if not negated and (self._flanks(subjects, meaning) or self._are_on_two_walls(subjects, meaning)):
            return
        anchors = tuple(a for a in meaning.anchors if a not in subjects) or meaning.anchors
        for subject in subjects:
            if subject in anchors and len(anchors) == 1:
                continue
            if meaning.kind in ("in_front_of", "next_to", "near") and self._lies_on(subject, anchors):
                self.laid = True
                continue
            if meaning.each:
                self.referents.shared.update(a for a in anchors if isinstance(a, Mention))
            before = subject.count
            self._multiply(subject, meaning)
            if before == 1 and ((subject.count or 1) > 1 or (meaning.each and not negated)):
                self._multiply_carried(subject)
            if meaning.each and not negated and any(isinstance(a, Mention) and a.many for a in anchors):
                self._share_held(subject, anchors)
            if self._is_laid(subject, meaning, anchors) and not negated:
                self.laid = True
                continue
            self._bind_one(subject, meaning, anchors, negated=negated)

    def _bind_one(
        self, subject: Mention, meaning: Meaning, anchors: tuple[Mention | str, ...], *, negated: bool
    ) -> None:
        kind = relation_kind(meaning.kind)
        if kind == "on" and not negated and self._is_seated_on(subject, anchors):
            return
        if kind == "against_wall" and any(isinstance(a, Mention) for a in anchors):
            kind = "next_to"
        asked = not meaning.assumed
        bond = Bond(kind, subject, anchors, each=meaning.each, asked=asked, negated=negated, spread=meaning.spread)
        if kind == "on" and not negated and not meaning.told:
            bond.each |= self._lay_under(subject, anchors)
        bond.told = meaning.pointed
        if kind == "in_centre" and isinstance(anchors[0], Mention) and self._belongs(subject.noun, "small"):
            self._share(lying := Bond("on", subject, anchors, each=meaning.each, negated=negated))
            bind(self.draft, lying)
        if negated:
            supposed = [
                b for b in self.draft.bonds_of(subject) if b.implied and b.kind == kind and b.anchors == anchors
            ]
            self.draft.bonds = [b for b in self.draft.bonds if b not in supposed] + [bond]
            return
        self._share(bond)
        self._share_in_group(bond)
        bind(self.draft, bond)
        for side in (side for side in SIDES if side in meaning.part.split()):
            bind(self.draft, Bond(relation_kind(SIDES[side]), subject, anchors, each=meaning.each))
        if kind in ("next_to", "facing", "opposite", "left_of", "right_of"):
            self.referents.pairs += [(subject, anchor) for anchor in anchors if isinstance(anchor, Mention)]

    def _are_on_two_walls(self, subjects: list[Mention], meaning: Meaning) -> bool:
        """Share several out over two walls that were named: half of them on each."""
        walls = meaning.anchors
        if meaning.kind not in ("on", "against_wall") or len(walls) != 2:
            return False
        if meaning.each and not all(isinstance(wall, str) for wall in walls):
            return False
        held = [b for s in subjects for b in self.draft.bonds_of(s) if b.each and b.anchors == walls]
        if len(held) == len(subjects):
            self.laid = True
            return True  # Each of both has its own already: "flanked by two tables with lamps on them".
        for subject in subjects:
            self.referents.settle(subject)
            if subject.count in (None, 1):
                subject.count = 2
            half = self.referents.part(subject, max(1, subject.count // 2))
            self.referents.parted = None
            for thing, wall in ((half, walls[0]), (subject, walls[1])):
                self._relate([thing], replace(meaning, anchors=(wall,)))
                self.sides[thing] = str(wall).removesuffix("_wall")
        return True

    def _flanks(self, subjects: list[Mention], meaning: Meaning) -> bool:
        """One of two things "on either side" stands at the left, the other at the right."""
        anchor = meaning.anchors[0]
        beside = meaning.kind == "next_to" or meaning.part == "both"
        if not (meaning.both and beside) or len(subjects) != 1 or len(meaning.anchors) != 1:
            return False
        if not isinstance(anchor, Mention) or anchor.many or meaning.each:
            return False
        subject = subjects[0]
        told = subject.count or 1
        flanking = meaning.times * told if meaning.times > 1 and subject not in self.counted else max(told, 2)
        if flanking != 2 or any(b.each for b in self.draft.bonds_of(subject) if not b.implied):
            return False
        self._multiply(subject, meaning)
        if self.referents.total(subject) != 2:
            return False
        for bond in self.draft.bonds_of(subject):
            bond.each &= not bond.implied
        part = self.referents.part(subject, 1)
        self.referents.parted = None
        self.referents.flanking |= {part, subject}
        for one, side in ((part, "left"), (subject, "right")):
            self.draft.unsay([b for b in self.draft.bonds_of(one) if b.implied])
            if meaning.part:
                bind(self.draft, Bond("on", one, (anchor,)))
            bind(self.draft, Bond(relation_kind(f"{side}_of"), one, (anchor,)))
            self.sides[one] = side
        for node in self.frontier:
            if node.things == [subject]:
                node.things = [part, subject]
        return True

    def _flanks_with(self, subjects: list[Mention], meaning: Meaning) -> bool:
        """Read "a bed, a nightstand with a lamp on each side" as two nightstands by the bed, each with its lamp."""
        carrier = meaning.anchors[0]
        if not (meaning.pointed and meaning.both) or len(subjects) != 1 or not isinstance(carrier, Mention):
            return False
        carried = subjects[0]
        had = any(b.implied and b.anchors == (carrier,) for b in self.draft.bonds_of(carried))
        lies = is_small(carried) or self.habits.is_in(carried.noun, "lamps")
        if not (had and lies and carrier.count == 1):
            return False
        before = self.draft.things[: self.draft.things.index(carrier)] if carrier in self.draft.things else []
        beside = [t for t in before if self.habits.tie(carrier.noun, t.noun) == "next_to"]
        if not beside:
            return False
        meaning = replace(meaning, anchors=(beside[-1],))
        if not self._flanks([carrier], meaning):
            return False
        both = tuple(b.subject for b in self.draft.bonds if b.anchors == meaning.anchors and self.sides.get(b.subject))
        self.draft.bonds = [b for b in self.draft.bonds if b.subject is not carried]
        carried.count = max(2, carried.count or 1)
        bind(self.draft, Bond("on", carried, both))
        return True

    def _is_seated_on(self, table: Mention, anchors: tuple[Mention | str, ...]) -> bool:
        """Put the chairs around a table that "seats eight people on eight chairs"."""
        if not self.habits.is_in(table.noun, "tables", "desks"):
            return False
        seats = [a for a in anchors if isinstance(a, Mention) and self.habits.is_in(a.noun, "seats", "chairs")]
        if len(seats) < len(anchors):
            return False
        for seat in seats:
            bind(self.draft, Bond("around", seat, (table,)))
        return True

    def _lies_on(self, subject: Mention, anchors: tuple[Mention | str, ...]) -> bool:
        """Whether it was said to lie on these, or for each of these: it is in front of them then."""
        said = [b for b in self.draft.bonds_of(subject) if b.kind in ("on", "inside") and not b.implied]
        carriers = [a for b in said for a in b.anchors if isinstance(a, Mention)]
        return any(a in carriers or (carriers and a in subject.per) for a in anchors)

    def _is_laid(self, subject: Mention, meaning: Meaning, anchors: tuple[Mention | str, ...]) -> bool:
        """Lay "a plate at every seat" on the table of the seats, as many as there are seats."""
        seats = [a for a in anchors if isinstance(a, Mention) and self.habits.is_in(a.noun, "seats", "chairs")]
        if len(seats) != len(anchors) or meaning.kind not in ("at", "next_to", "around", "in_front_of", "per", "on"):
            return False
        if self.habits.is_in(subject.noun, "seats", "tables", "lamps") or not meaning.each:
            return False
        if not is_small(subject) or (meaning.kind == "on" and meaning.told):
            return False
        tables = self._tables_of(seats)
        if not tables:
            tables += self._only_table()
        if not tables:
            meaning.kind = "on" if meaning.kind == "at" else meaning.kind
            return False
        self._take_from_tables(subject, tables)
        subject.per += [s for s in seats if s not in subject.per]
        bind(self.draft, Bond("on", subject, tuple(dict.fromkeys(tables))))
        return True

    def _take_from_tables(self, thing: Mention, tables: list[Mention]) -> None:
        """Forget that one is on each table where there is one for each seat: "on every table a glass per chair"."""
        for part in self.referents.family(thing):
            lying = [
                b for b in self.draft.bonds_of(part) if b.kind == "on" and b.each and set(b.anchors) <= set(tables)
            ]
            self.draft.bonds = [b for b in self.draft.bonds if b not in lying]
            if lying and part is not thing:
                self.draft.drop(part)

    def _call_after_content(self, holder: Mention, content: str) -> None:
        """Take "a rack with test tubes", "umbrellas in the stand" for the rack and the stand that are for these."""
        named = self.named_by.get(holder)
        borne = (
            b.subject.noun for b in self.draft.bonds if b.kind == "on" and b.anchors == (holder,) and not b.implied
        )
        content = next(borne, content)
        called = called_after(content, named) if named is not None and not holder.many else ""
        if called:
            holder.noun = called
            for bond in self.draft.bonds_of(holder) if is_small(holder) else ():
                bond.kind = "on" if bond.implied and bond.kind == "next_to" else bond.kind

    def _tables_of(self, seats: Sequence[Mention]) -> list[Mention]:
        """The tables, desks and counters that seats were said to be at."""
        places = [a for s in seats for b in self.draft.bonds_of(s) if b.kind in _SEATED for a in b.anchors]
        return [a for a in places if isinstance(a, Mention) and self._seated(a)]

    def _seated(self, head: Mention) -> str:
        """How seats stand to what one sits at; "" where one does not."""
        word = last_word(head)
        if self.habits.is_in(head.noun, "tables") or word == "table":
            return "around"
        sat_at = self.habits.is_in(head.noun, "desks", "counters", "worktops") or word in grammar().lists["sat_at"]
        return "at" if sat_at else ""

    def _only_table(self) -> list[Mention]:
        """The one table or desk that was named, where there is one."""
        found = [t for t in self.draft.things if self.habits.is_in(t.noun, "tables", "desks")]
        return found if len(found) == 1 else []

    def _multiply(self, subject: Mention, meaning: Meaning) -> None:
        """One "on each side" are two; one "in each corner" four."""
        alone = len(meaning.anchors) == 1 and not (isinstance(a := meaning.anchors[0], Mention) and a.many)
        bare = subject.count is None and (alone or meaning.each)
        if meaning.both and (subject.count == 1 or bare) and meaning.times == 1:
            seated = subject.plural and self.habits.is_in(subject.noun, "seats")
            several = _ALONG if seated and meaning.kind == "at_long_side" else 2
            subject.count = (self._places(meaning) if seated else 0) or several
        elif meaning.both and meaning.times == 1 and (subject.count or 0) > 1 and (subject.count or 0) % 2:
            # So many cannot be parted into two like halves: they are those of one side.
            subject.count = 2 * (subject.count or 0) if meaning.kind == "next_to" else subject.count
        if subject.count and meaning.times > 1 and subject not in self.counted:
            subject.count *= meaning.times
            self.multiplied.add(subject)
            if subject.least:
                subject.least *= meaning.times
        elif meaning.spread > 1 and (subject.count in (None, 1) or (subject.vague and subject.count < meaning.spread)):
            subject.count = meaning.spread

    def _places(self, meaning: Meaning) -> int:
        """How many sit at the one table that seats are at, as far as that is told; 0 where it is not."""
        table = meaning.anchors[0]
        if not isinstance(table, Mention) or self._seated(table) != "around":
            return 0
        return table.seats or (self.draft.people if self.draft.people <= _MOST_MEET else 0)

    def _multiply_carried(self, carrier: Mention) -> None:
        """Take "a sculpture on a pedestal in each corner" for one on each pedestal."""
        at = self.draft.things.index(carrier) if carrier in self.draft.things else 0
        before = self.draft.things[max(at - 1, 0) : at]
        for bond in self.draft.bonds:
            on = bond.kind in ("on", "inside") and bond.anchors == (carrier,) and not bond.negated
            if on and bond.subject.count == 1 and (bond.subject in self.clause.members or before == [bond.subject]):
                bond.each = True

    def _lay_under(self, subject: Mention, anchors: tuple[Mention | str, ...]) -> bool:
        """Lay the coaster of "on each table a glass on a coaster" where the glass was to be; whether each has one."""
        below = anchors[0] if len(anchors) == 1 else None
        new = isinstance(below, Mention) and below.count == 1 and is_small(below) and not self.draft.bonds_of(below)
        lying = [b for b in self.draft.bonds_of(subject) if b.kind == "on" and not (b.negated or b.implied)]
        if not isinstance(below, Mention) or not new or not lying or self.named_by[below].definite:
            return False
        each = bool(subject.per) or any(bond.each for bond in lying)
        below.per, subject.per = subject.per, []
        for bond in lying:
            self.draft.hand_over(bond, below)
        return each

    def _share_held(self, holder: Mention, besides: tuple[Mention | str, ...]) -> None:
        """Take the jars of "a table with jars beside each sofa" for those of each table."""
        for bond in self.draft.bonds:
            held = bond.implied and bond.anchors == (holder,) and bond.kind in ("on", "inside")
            if held and bond.subject not in besides and not self.draft.bonds_of(bond.subject)[1:]:
                bond.each = bond.distributed = True

    def _share_in_group(self, bond: Bond) -> None:
        """Let each of several groups have its own of what is at something else that each has."""
        frame, anchor = self.clause, bond.anchors[0] if len(bond.anchors) == 1 else None
        count = bond.subject.count or 0
        if frame.times <= 1 or bond.each or bond.kind == "between" or not isinstance(anchor, Mention):
            return
        both = anchor in frame.members and bond.subject in frame.members
        if both and anchor.count == frame.times and count and not count % frame.times:
            bond.subject.count, bond.each = count // frame.times, True

    def _lie_among(self, bond: Bond, heads: Sequence[Mention]) -> bool:
        """Whether each has its own of what it is at: "each bed has a nightstand and a lamp on the nightstand"."""
        anchor = bond.anchors[0] if len(bond.anchors) == 1 else None
        if not isinstance(anchor, Mention) or bond.kind == "between" or anchor in heads:
            return False
        return any(b.each and not b.negated and set(b.anchors) & set(heads) for b in self.draft.bonds_of(anchor))

    def _share(self, bond: Bond) -> None:
        """Keep the number that "each" gave where the relation to it is told in other words."""
        if bond.subject.per and set(bond.anchors) <= set(bond.subject.per):
            bond.each |= bond.kind != "between"
        for old in self.draft.bonds_of(bond.subject):
            if old.implied and old.each and not bond.each:
                heads = [a for a in old.anchors if isinstance(a, Mention)]
                if self._lie_among(bond, heads):
                    bond.each = True
                    continue
                if not old.distributed and bond.anchors != old.anchors:
                    continue
                if tuple(heads) != bond.anchors and not set(map(id, heads)) & set(map(id, bond.anchors)):
                    bond.subject.per += [h for h in heads if h not in bond.subject.per]
                elif set(map(id, bond.anchors)) <= set(map(id, heads)):
                    bond.anchors = tuple(heads)
                    bond.each = bond.kind != "between"
