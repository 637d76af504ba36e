"""What was read and cannot be meant so, or may be meant otherwise: it is said rather than passed over."""

from collections.abc import Iterator
from itertools import pairwise

from thinkblox.assets import kind_of
from thinkblox.assets.plain import shape_of
from thinkblox.knowledge.senses import senses_of
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.antecedents import OpenReference
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.corrections import Corrections
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.parts import SIDES
from thinkblox.reading.english.referents import is_small, last_word, parts_of
from thinkblox.reading.stacks import STACKED

_FULL_HEIGHT = 1.8
"""So high, what hangs parts a room in its middle as well, as a curtain does [m]."""
_FURNITURE = ("seats", "chairs", "tables", "desks", "beds", "lounges", "storage", "shelves")
"""What stands on the floor."""
_BESIDE = ("next_to", "near", "left_of", "right_of", "in_front_of", "behind")
"""Relations that say nothing of what something lies on."""
_SHARED = ("on", "inside", "at")
"""Relations to one thing, so that fewer subjects than anchors leave open to which."""
_SOFT = ("beds", "lounges", "seats")
"""What nothing is built into."""
_PLATFORMS = ("covers",)
"""What furniture can stand on."""
_PLAIN_SIDES = 2
"""Sides of which every thing has so many, as rooms have facing walls."""


class Doubts(Corrections):
    """Looks for readings that cannot be right."""

    def _doubts(self) -> None:
        """Say of every number that it is not used, and of every relation that it can hardly be meant."""
        numbers = self._numbers()
        for at, noun in enumerate(self.chunks):
            if isinstance(noun, Noun) and self._is_unused_number(noun, at, numbers):
                self._lose(noun.start, noun.end)
        for bond in self.draft.bonds:
            if said := self._hardly(bond):
                self.draft.unknown.append(said)
        self.draft.unknown += [*self._grouped(), *self._untied(), *self._carried_twice(), *self._on_and_beside()]
        self.draft.unknown += self._named_again()
        for reference in self.antecedents.unclear:
            self._doubt_referent(reference)
        self._doubt_circles()
        for noun, thing in self.unsure:
            if thing in self.draft.things and (thing.count or 1) > 1 and thing not in self.referents.shared:
                self.draft.unknown.append(f"{noun.text} (which of {thing.count}?)")

    def _named_again(self) -> Iterator[str]:
        """Things of which nothing tells whether they were pointed at before: "the desk is here. A desk of oak"."""
        before: dict[tuple[str, str], list[Mention]] = {}
        for thing in self.draft.things:
            alike = before.setdefault((thing.noun, last_word(thing)), [])
            if len(alike) == 1 and self._may_be_again(thing, alike[0]):
                yield f"{thing.text} ({alike[0].text} again?)"
            if thing.asked:
                alike.append(thing)

    def _may_be_again(self, thing: Mention, pointed: Mention) -> bool:
        """Whether a thing that is told without saying where it is may be the only one that was pointed at so."""
        noun, named = self.named_by.get(thing), self.named_by.get(pointed)
        if noun is None or noun.det != "a" or thing.many or self.draft.bonds_of(thing):
            return False
        if named is None or named.det != "the" or pointed.many or noun.text.lower()[:4] == "one ":
            return False
        return not any(thing in b.anchors for b in self.draft.bonds)

    def _doubt_circles(self) -> None:
        """Say of things in a circle around nothing that nobody sees to that."""
        for thing, link in self.circles:
            if not any(bond.kind == "around" for bond in self.draft.bonds_of(thing)):
                self._lose(link.start, link.end)

    def _doubt_referent(self, said: OpenReference) -> None:
        """Say of words that they may point back to either of two things."""
        kept = said.one in self.draft.things and said.other in self.draft.things
        if kept and not self.account.is_any_lost(said.start, said.end):
            self.account.mark(said.start, said.end, "not_understood")
            text = self.account.text(said.start, said.end)
            self.draft.unknown.append(f"{text} ({said.one.text} or {said.other.text}?)")

    # --- numbers

    def _is_unused_number(self, noun: Noun, at: int, numbers: set[int]) -> bool:
        """Whether nothing of the draft is as many as a phrase says."""
        count = noun.count or 0
        if (
            count < _PLAIN_SIDES
            or noun.vague
            or noun.det == "no"
            or noun.kind not in ("thing", "number", "part", "place")
        ):
            return False
        if self.account.is_lost(noun.start, noun.end) or self._is_corrected(at):
            return False
        if noun.kind in ("part", "place") and (count == _PLAIN_SIDES or self._are_on_all_sides(count)):
            return False
        sides = (c for c in self.chunks[at + 1 : at + 5] if isinstance(c, Noun) and c.kind in ("part", "place"))
        shared = any(side.det in ("each", "either", "both") or side.many for side in sides)
        wanted = {count, 2 * count, 4 * count} if shared else {count}
        return not wanted & numbers

    def _are_on_all_sides(self, sides: int) -> bool:
        """Whether as many are at each of so many sides of a thing."""
        return any(b.kind == "around" and (b.subject.count or 1) % sides == 0 for b in self.draft.bonds)

    def _is_corrected(self, at: int) -> bool:
        """Whether a correction of a number follows soon."""
        return any(self._is_link(chunk, "corrections") for chunk in self.chunks[at + 1 : at + 4])

    def _numbers(self) -> set[int]:
        """Every number that something of the draft has: things, all of a kind together, rows, places, people."""
        draft, found = self.draft, {self.draft.people, *self.numbers}
        kinds: dict[str, int] = {}
        for thing in draft.things:
            total = self.referents.total(thing)
            family = sum(self.referents.total(t) for t in self.referents.family(thing))
            found |= {thing.count or 0, total, family, thing.groups, abs(thing.rows), thing.seats}
            found |= {thing.least or 0, thing.most or 0}
            found |= {int(a.split("-")[0]) for a in thing.attributes if a.split("-")[0].isdigit()}
            found |= {int(a.split("-")[1]) for a in thing.attributes if a.startswith("for-") and a[4:].isdigit()}
            found |= {total // 2, total // 4} if thing in self.multiplied else set()
            kinds[thing.noun] = kinds.get(thing.noun, 0) + total
            if thing.groups and thing.count:
                found.add(thing.count // thing.groups)
        for bond in draft.bonds:
            found |= {bond.rows, bond.spread}
            if bond.rows and bond.subject.count:
                found.add(bond.subject.count // bond.rows)
        return found | set(kinds.values()) | {gap.count for gap in draft.openings}

    # --- relations

    def _hardly(self, bond: Bond) -> str:
        """What is said of a relation that can hardly be meant; empty for one that can."""
        if not bond.asked or bond.negated or bond.implied:
            return ""
        anchors = parts_of(bond)
        if not anchors:
            return self._middle_of_what(bond)
        return self._on_what(bond, anchors[0]) or self._of_how_many(bond, anchors)

    def _middle_of_what(self, bond: Bond) -> str:
        """What is said of what has to lie on something and is only in the middle, or in a corner."""
        if bond.kind not in ("in_centre", "in_corner"):
            return ""
        tops = any(self.habits.is_in(t.noun, "tables", "desks", "counters", "worktops") for t in self.draft.things)
        where = "middle" if bond.kind == "in_centre" and bond.anchors == ("centre",) else ""
        places = [c for c in self.chunks if isinstance(c, Noun) and c.kind == "place"]
        of_room = {"middle" if c.value == "centre" else c.value for c in places if c.text.endswith("of the room")}
        where = "corner" if bond.kind == "in_corner" and not self._has_carrier(bond.subject) else where
        lies = tops and is_small(bond.subject) and self._is_carried(bond.subject)
        plant = self.habits.is_in(bond.subject.noun, "plants") or shape_of(kind_of(bond.subject.noun)) == "tuft"
        where = "" if where in of_room and (plant or not lies or where == "corner") else where
        hung = self.habits.is_in(bond.subject.noun, "wallpieces") and kind_of(bond.subject.noun).size[2] < _FULL_HEIGHT
        lies |= where == "middle" and hung
        return f"{bond.subject.text} in the {where} (of what?)" if where and lies else ""

    def _on_what(self, bond: Bond, anchor: Mention) -> str:
        """What is said of a thing that has to lie on something, or cannot."""
        thing, carried = bond.subject, self._is_carried(bond.subject)
        senses = (s for s in senses_of(anchor.noun) if all(c == f"room:{self.draft.room}" for c in s.conditions))
        meant = next((sense.category for sense in senses), anchor.noun)
        if self.habits.is_served_on(thing.noun, meant):
            return ""
        hung = self.habits.is_in(thing.noun, "tops", "screens")
        hovers = bond.kind == "above" and is_small(thing) and not (hung or self._has_carrier(thing))
        if carried and (hovers or (bond.kind in _BESIDE and self._lies_nowhere(thing, anchor))):
            return f"{thing.text} {bond.kind.replace('_', ' ')} {anchor.text} (on what?)"
        if bond.kind in ("on", "inside") and last_word(thing) in grammar().lists["sticking"]:
            return f"{thing.text} on {anchor.text} (stuck to it?)"
        if bond.kind == "on" and self.habits.is_in(thing.noun, "built_in") and self.habits.is_in(anchor.noun, *_SOFT):
            return f"{thing.text} {bond.kind} {anchor.text} (hardly)"
        if bond.told and bond.kind == "on" and self._stands(thing) and not self._is_floor(anchor):
            return f"{thing.text} {bond.kind} {anchor.text} (hardly)"
        return ""

    def _of_how_many(self, bond: Bond, anchors: list[Mention]) -> str:
        """What is said of a relation to one, or to several, that its kind or number does not allow."""
        thing, anchor = bond.subject, anchors[0]
        lone = len(anchors) == 1 and self.referents.total(anchor) == 1 and not anchor.per
        lone &= not anchor.text.lower().startswith("each ")
        if bond.each and lone and not anchor.many and len(self.referents.clan(anchor)) < _PLAIN_SIDES:
            return f"each {anchor.text} (only one named)"
        if bond.kind == "around" and not (bond.each or self._is_floor(thing) or self._are_many(bond)):
            return f"{thing.text} around {anchor.text} (only one)"
        if bond.kind in _SHARED and not bond.each and self._is_lone_of_several(thing, anchors):
            return f"{thing.text} {bond.kind} {anchor.text} (which of them?)"
        if bond.kind == "between" and lone and not anchor.many:
            return f"{thing.text} between {anchor.text} and what?"
        return ""

    def _is_carried(self, thing: Mention) -> bool:
        """Whether it lies on other things, and is nowhere else."""
        habits = self.habits.of(thing.noun)
        hung = any(habit.kind == "against_wall" for habit in habits) or last_word(thing) in grammar().lists["hung"]
        return bool(habits) and all(habit.kind == "on" for habit in habits) and not hung

    def _lies_nowhere(self, thing: Mention, anchor: Mention) -> bool:
        """Whether what has to lie on something is only said to be beside what carries nothing."""
        lies = is_small(thing) and not thing.per and not self._has_carrier(thing)
        above = any(b.kind == "above" for b in self.draft.bonds_of(thing))
        stands = self.habits.is_in(anchor.noun, *_FURNITURE) or last_word(anchor) in grammar().lists["sat_at"]
        return lies and not above and (stands or last_word(anchor) == "bench") and not is_small(anchor)

    def _are_many(self, bond: Bond) -> bool:
        """Whether a bond is of several, of which some may have been told apart, or one of several that are so."""
        alike = [b for b in self.draft.bonds if b.kind == bond.kind and b.anchors == bond.anchors]
        return bond.subject.many or len(self.referents.family(bond.subject)) > 1 or len(alike) > 1

    def _is_lone_of_several(self, thing: Mention, anchors: list[Mention]) -> bool:
        """Whether one thing is said to be on, in or at several, and nothing tells which."""
        single = thing.count == 1 and not thing.per and not thing.vague and self.referents.total(thing) == 1
        piled = STACKED in anchors[0].states
        return single and not piled and len(anchors) == 1 and self.referents.total(anchors[0]) > 1

    def _has_carrier(self, thing: Mention) -> bool:
        return any(b.kind in ("on", "inside", "in_centre") for b in self.draft.bonds_of(thing))

    def _stands(self, thing: Mention) -> bool:
        return self.habits.is_in(thing.noun, *_FURNITURE) and not is_small(thing)

    def _is_floor(self, thing: Mention) -> bool:
        return self.habits.is_in(thing.noun, *_PLATFORMS)

    def _untied(self) -> Iterator[str]:
        """Things that others have in a way that nothing says, and that have no other place."""
        for thing, head in self.untied:
            kept = thing in self.draft.things and head in self.draft.things and not self.draft.bonds_of(thing)
            kept = kept and not any(thing in b.anchors for b in self.draft.bonds_of(head))
            named = self.named_by.get(thing)
            if kept and (named is None or not named.definite):
                yield f"{head.text} with {thing.text} (where?)"

    def _grouped(self) -> Iterator[str]:
        """Things that are to stand in clusters or rings, which nothing sees to."""
        for thing in self.draft.things:
            rings, clusters = grammar().lists["rings"], grammar().lists["clusters"]
            if thing.group in rings or (thing.group in clusters and thing.groups > 1):
                yield f"{thing.group}s of {thing.text.rpartition(' of ')[2]}"

    def _carried_twice(self) -> Iterator[str]:
        """Single things that are to be on, or in, two others of which neither carries the other."""
        for thing in self.draft.things:
            carriers = [
                a
                for b in self.draft.bonds_of(thing)
                if b.kind in ("on", "inside") and not (b.negated or b.implied) and len(b.anchors) == 1
                for a in parts_of(b)
            ]
            for one, other in pairwise(carriers):
                if one is not other and not (self._is_over(one, other) or self._is_over(other, one)):
                    yield f"{thing.text} on {one.text} and on {other.text}"

    def _on_and_beside(self) -> Iterator[str]:
        """Things that are to be on another and beside it, or inside of it and at a side of it."""
        for thing in self.draft.things:
            bonds = [b for b in self.draft.bonds_of(thing) if not (b.negated or b.implied)]
            carriers = [a for b in bonds if b.kind in ("on", "inside") for a in parts_of(b)]
            tops = [a for b in bonds if b.kind == "on" for a in parts_of(b)]
            for bond in bonds:
                of_top = bond.kind in SIDES.values() and all(a in tops for a in parts_of(bond))
                if bond.kind in _BESIDE and not of_top and any(a in carriers for a in parts_of(bond)):
                    yield f"{thing.text} {bond.kind.replace('_', ' ')} {parts_of(bond)[0].text} (and on it?)"

    def _is_over(self, one: Mention, other: Mention) -> bool:
        return any(other in b.anchors for b in self.draft.bonds_of(one)) or one.many or other.many
