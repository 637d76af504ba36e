"""What was read and cannot be meant so, or may be meant otherwise: it is said rather than passed over."""

from collections.abc import Iterator
from itertools import pairwise

from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.corrections import Corrections
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.referents import is_small, last_word, parts_of

_FURNITURE = ("seats", "chairs", "tables", "desks", "beds", "lounges", "storage", "shelves")
"""What stands on the floor."""
_BESIDE = ("next_to", "near", "left_of", "right_of", "in_front_of", "behind")
"""Relations that say nothing of what something lies on."""
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
        self.draft.unknown += [*self._untied(), *self._carried_twice(), *self._on_and_beside()]
        for noun, thing in self.unsure:
            if thing in self.draft.things and (thing.count or 1) > 1 and thing not in self.referents.shared:
                self.draft.unknown.append(f"{noun.text} (which of {thing.count}?)")

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
        if noun.kind in ("part", "place") and count == _PLAIN_SIDES:
            return False
        sides = (c for c in self.chunks[at + 1 : at + 5] if isinstance(c, Noun) and c.kind in ("part", "place"))
        shared = any(side.det in ("each", "either", "both") or side.many for side in sides)
        wanted = {count, 2 * count, 4 * count} if shared else {count}
        return not wanted & numbers

    def _is_corrected(self, at: int) -> bool:
        """Whether a correction of a number follows soon."""
        return any(self._is_link(chunk, "corrections") for chunk in self.chunks[at + 1 : at + 4])

    def _numbers(self) -> set[int]:
        """Every number that something of the draft has: things, all of a kind together, rows, places, people."""
        draft, found = self.draft, {self.draft.people}
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
        anchors = parts_of(bond)
        if not bond.asked or bond.negated or bond.implied:
            return ""
        carried = self._is_carried(bond.subject)
        tops = any(self.habits.is_in(t.noun, "tables", "desks", "counters", "worktops") for t in self.draft.things)
        if bond.kind == "in_centre" and bond.anchors == ("centre",) and is_small(bond.subject) and carried and tops:
            return f"{bond.subject.text} in the middle (of what?)"
        if not anchors:
            return ""
        if bond.kind in _BESIDE and carried and self._lies_nowhere(bond.subject, anchors[0]):
            return f"{bond.subject.text} {bond.kind.replace('_', ' ')} {anchors[0].text} (on what?)"
        lone = len(anchors) == 1 and self.referents.total(anchors[0]) == 1 and not anchors[0].per
        if bond.each and lone and not anchors[0].many:
            return f"each {anchors[0].text} (only one named)"
        if bond.kind == "between" and len(anchors) == 1 and not anchors[0].many:
            return f"{bond.subject.text} between {anchors[0].text} and what?"
        if bond.told and bond.kind == "on" and self._stands(bond.subject) and not self._is_floor(anchors[0]):
            return f"{bond.subject.text} {bond.kind} {anchors[0].text} (hardly)"
        return ""

    def _is_carried(self, thing: Mention) -> bool:
        """Whether it lies on other things, and is nowhere else."""
        habits = self.habits.of(thing.noun)
        hung = any(habit.kind == "against_wall" for habit in habits) or last_word(thing) in grammar().lists["hung"]
        return bool(habits) and all(habit.kind == "on" for habit in habits) and not hung

    def _lies_nowhere(self, thing: Mention, anchor: Mention) -> bool:
        """Whether what has to lie on something is only said to be beside what carries nothing."""
        lies = is_small(thing) and not thing.per
        on = any(b.kind in ("on", "inside", "in_centre", "above") for b in self.draft.bonds_of(thing))
        return lies and not on and self.habits.is_in(anchor.noun, *_FURNITURE) and not is_small(anchor)

    def _stands(self, thing: Mention) -> bool:
        return self.habits.is_in(thing.noun, *_FURNITURE) and not is_small(thing)

    def _is_floor(self, thing: Mention) -> bool:
        return self.habits.is_in(thing.noun, *_PLATFORMS)

    def _untied(self) -> Iterator[str]:
        """Things that others have in a way that nothing says, and that have no other place."""
        for thing, head in self.untied:
            kept = thing in self.draft.things and head in self.draft.things and not self.draft.bonds_of(thing)
            kept = kept and not any(thing in b.anchors for b in self.draft.bonds_of(head))
            if kept and not self.named_by[thing].definite:
                yield f"{head.text} with {thing.text} (where?)"

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
        """Things that are to be on another and at a side of it, which then means a part of its top."""
        for thing in self.draft.things:
            bonds = [b for b in self.draft.bonds_of(thing) if not (b.negated or b.implied)]
            carriers = [a for b in bonds if b.kind in ("on", "inside") for a in parts_of(b)]
            for bond in bonds:
                if bond.kind in _BESIDE and any(a in carriers for a in parts_of(bond)):
                    yield f"{thing.text} {bond.kind.replace('_', ' ')} {parts_of(bond)[0].text} (and on it?)"

    def _is_over(self, one: Mention, other: Mention) -> bool:
        return any(other in b.anchors for b in self.draft.bonds_of(one)) or one.many or other.many
