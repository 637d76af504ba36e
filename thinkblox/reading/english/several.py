"""Some of several: numbers, ordinals, sides, "every second"."""

from collections.abc import Sequence

from thinkblox.reading.attach import relation_kind
from thinkblox.reading.draft import Mention
from thinkblox.reading.english.boundaries import Boundaries
from thinkblox.reading.english.chunks import Noun


class Several(Boundaries):
    """Sets some of several things apart."""

    def _whole(self, besides: Sequence[Mention]) -> Mention | None:
        """The several things that a number now parts."""
        if self.referents.parted is not None and self.referents.parted not in besides:
            return self.referents.parted
        if self.whole is not None and self.whole in self.draft.things:
            return self.whole
        near = [n.things[-1] for n in reversed(self.frontier) if n.things]
        near += self.clause.members[::-1]
        many = [t for t in near if t.many and t not in besides]
        found = next(iter(many), None) or next((t for t in self.referents.plural() if t not in besides), None)
        return found or next((t for t in reversed(self.referents.last_family()) if t not in besides), None)

    def some_of(self, noun: Noun, besides: list[Mention]) -> Mention | None:
        """The part of some known things that a number, "the left one" or "the other" means."""
        whole = self.referents.named(noun, besides) if noun.kind == "thing" else self._whole(besides)
        if whole is None:
            return None
        parts = self.referents.parts.get(whole, [])
        if noun.ordinal:
            return self._ordinal(noun, whole)
        told = [t for t in [*parts, whole] if noun.side and noun.side == self.sides.get(t)]
        if told:
            return told[0]
        if noun.det == "other":
            self.referents.parted = None
            return whole
        self.referents.settle(whole)
        count = self._how_many(noun, whole)
        part = self.referents.part(whole, count)
        if noun.side:
            self._set_side(part, whole, noun.side)
        return part

    def _ordinal(self, noun: Noun, whole: Mention) -> Mention:
        """The first, second, ... of several."""
        family = self.referents.family(whole)
        whole = next((t for t in family if t.many), whole)
        order = self.ordinals.setdefault(family[0] if len(family) > 1 else whole, {})
        for known in self.ordinals.values():
            if noun.ordinal in known and known[noun.ordinal] in family:
                return known[noun.ordinal]
        taken = [t for known in self.ordinals.values() for t in known.values()]
        free = [t for t in family if t not in taken and not t.many]
        part = self.referents.part(whole, 1) if whole.many else (free[-1] if free else whole)
        order[noun.ordinal] = part
        return part

    def _how_many(self, noun: Noun, whole: Mention) -> int:
        total = whole.count or 2
        if noun.det == "half":
            total += sum(p.count or 0 for p in self.referents.parts.get(whole, ()))
            return max(1, total // 2)
        if noun.det in ("each", "all", "none", "both") and noun.count is None:
            return total
        return noun.count or (total if noun.plural and not noun.side else 1)

    def _set_side(self, part: Mention, whole: Mention, side: str) -> None:
        """The left one of two that flank something stands at its left."""
        other = {"left": "right", "right": "left"}.get(side, "")
        self.sides[part] = side
        if part is whole:
            return
        self.sides[whole] = other
        if not other:
            return
        for thing, where in ((part, side), (whole, other)):
            for bond in self.draft.bonds_of(thing):
                if bond.kind == "next_to" and bond.anchors and isinstance(bond.anchors[0], Mention):
                    bond.kind = relation_kind(f"{where}_of")

    def _every(self, noun: Noun) -> list[Mention]:
        """Read "every second chair", "every two loungers": so many of them, or groups of so many."""
        whole = self.referents.named(noun)
        if whole is None or not whole.count:
            return []
        self.referents.settle(whole)
        if noun.counted:
            self.each_of = noun.every
            return [whole]
        return [self.referents.part(whole, max(1, whole.count // noun.every))]
