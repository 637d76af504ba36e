"""Some of several: numbers, ordinals, sides, "every second"."""

from collections.abc import Mapping, Sequence

from thinkblox.assets.palette import with_general
from thinkblox.reading.adjectives import degree_of
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.boundaries import Boundaries
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.meaning import ROOM_SIDES
from thinkblox.reading.english.referents import last_word

_PAIR = 2
_SIDE_WALLS: Mapping[tuple[Mention | str, ...], str] = {("left_wall",): "left", ("right_wall",): "right"}
"""Walls, and on which side what stands there is."""


class Several(Boundaries):
    """Sets some of several things apart."""

    def _whole(self, besides: Sequence[Mention]) -> Mention | None:
        """The several things that a number now parts."""
        parted = self.referents.parted
        if parted is not None and (last := self._named_just_before()) is not None:
            parted = parted if last in self.referents.family(parted) else last
        if parted is not None and parted not in besides:
            if not self._is_at_others_of(parted):
                return parted
            besides = [*besides, *self.referents.family(parted)]
        if self.whole is not None and self.whole in self.draft.things:
            return self.whole
        near = [n.things[-1] for n in reversed(self.frontier) if n.things]
        near += [t for t in self.referents.topics[-1:] if not self.frontier and not self.clause.members]
        near += self.clause.members[::-1]
        many = [t for t in near if (t.many or self.referents.total(t) > 1) and t not in besides]
        alike = [t for t in self.referents.plural() if t not in besides and t.noun in {n.noun for n in near[:1]}]
        found = (
            next(iter(many), None)
            or next(iter(alike), None)
            or next((t for t in self.referents.plural() if t not in besides), None)
        )
        left = [t for t in reversed(self.referents.last_family()) if t not in besides and t in self.draft.things]
        return found or next(iter(left), None)

    def _named_just_before(self) -> Mention | None:
        """The several that are told to stand one to the other: "three shelves, one above the other"."""
        other = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        if other is None or other.value != "other":
            return None
        noun = self._before(2) if self._is_link(self._before(), "mark", "comma") else None
        things = self.meant.get(noun.start, []) if isinstance(noun, Noun) and noun.kind == "thing" else []
        return things[0] if len(things) == 1 and things[0].many else None

    def _is_at_others_of(self, thing: Mention) -> bool:
        """Whether a number is told to be at others of these: "six on the left bench, two on the right bench"."""
        noun = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        named = noun is not None and noun.kind == "thing" and last_word(thing).endswith(noun.word)
        named |= noun is not None and noun.kind == "number" and noun.side != "" and not noun.of_known
        return named and any(thing in self.referents.family(a) for t in self.clause.members for a in self._anchors(t))

    def _anchors(self, thing: Mention) -> list[Mention]:
        """What a thing was said to be somewhere to."""
        return [a for b in self.draft.bonds_of(thing) for a in b.anchors if isinstance(a, Mention)]

    def _left_over(self) -> Mention | None:
        """What "the other" means that begins a sentence after one in which some of several were told of."""
        begins = not (self.clause.members or self.frontier or self.referents.parted)
        return (self.referents.left_over() or self._other_of_two()) if begins else None

    def _other_of_two(self) -> Mention | None:
        """What stands at the wall across from what the clause before was about, where these are all of their kind."""
        said = next((t for t in reversed(self.referents.spoken) if t in self.draft.things), None)
        topics = [t for t in (*self.referents.topics[-1:], said) if t in self.draft.things and t is not None]
        walled = [b.subject for b in self.draft.bonds if b.anchors[:1] in _SIDE_WALLS and not b.negated]
        topic = next((t for t in topics if t in walled), None)
        alike = [t for t in self.draft.things if topic is not None and t.asked and t.noun == topic.noun]
        others = [t for t in alike if t is not topic]
        return others[0] if len(alike) == _PAIR and others[0] in walled else None

    def _one_left(self, noun: Noun, besides: Sequence[Mention]) -> Mention | None:
        """What a number parts; "the one by the door" is of those of which another was called so before."""
        if (noun.det == "other" or noun.ordinal > 1) and (rest := self._left_over()) is not None:
            return rest
        if (rest := self._left_for(noun)) is not None and rest not in besides:
            return rest
        left = self.singled if noun.text.lower() == "the one" else None
        kept = left is not None and left in self.draft.things and left not in besides and not self.referents.parted
        counted = self._counted_before(noun, besides) if not kept else None
        return counted or (left if kept else self._whole(besides))

    def _left_for(self, noun: Noun) -> Mention | None:
        """What a number parts right after some of several were told of: "three cushions. Two are red. One is blue"."""
        plain = not (noun.of_known or noun.det or noun.ordinal or noun.side or noun.degree)
        plain &= noun.text.lower() == "one" if noun.kind == "pronoun" else noun.kind == "number"
        told = self._is_link(self.peek(), "verbs") or bool(noun.attributes or noun.unshown or noun.states)
        rest = self._left_over() if plain and told else None
        if rest is None or not self.referents.topics or (noun.count or 1) > (rest.count or 1):
            return None
        before = self.referents.topics[-1]
        return rest if before is not rest and before in self.referents.family(rest) else None

    def _of_owners(self, noun: Noun) -> Mention | None:
        """The benches of "each bench has two stools and a burner, and half of them carry a microscope"."""
        head = self.frontier[0].thing if len(self.frontier) > 1 else None
        filled = self._is_link(self.peek(), "fillers")
        having = self._is_link(self.peek(int(filled)), "verbs", "have", "carry", "hold")
        some = noun.value == "half" or (noun.of_known and noun.text.lower().endswith((" them", " which")))
        return head if some and having and head is not None and head.many else None

    def _counted_before(self, noun: Noun, besides: Sequence[Mention]) -> Mention | None:
        """What was counted up to the one before: after "the first", "the second" is another of the same."""
        if noun.kind != "number" or noun.ordinal < _PAIR or noun.of_known or noun.attributes:
            return None
        series = (known[noun.ordinal - 1] for known in reversed(self.ordinals.values()) if noun.ordinal - 1 in known)
        return next((t for t in series if t in self.draft.things and t not in besides), None)

    def _others(self, whole: Mention) -> list[Mention]:
        """All that are left of several of which the first, the second, ... were told."""
        told = [t for known in self.ordinals.values() for t in known.values()]
        family = self.referents.clan(whole)
        rest = [t for t in family if t not in told]
        return rest if rest and len(rest) < len(family) and any(t in told for t in family) else [whole]

    def some_of(self, noun: Noun, besides: list[Mention]) -> Mention | None:
        """The part of some known things that a number, "the left one" or "the other" means."""
        self._spend(noun)
        whole = self.referents.named(noun, besides) if noun.kind == "thing" else self._one_left(noun, besides)
        those = self._told_before(noun, whole, besides) if noun.kind == "number" else None
        if those is not None:
            return those
        sided = noun.side in ("left", "right") and not noun.ordinal and not noun.of_known
        if sided and not (whole is not None and any(t in self.sides for t in self.referents.family(whole))):
            there = self._parted_by_side(noun, whole, besides) or self._told_at_side(noun, whole, besides)
            if there is not None:
                return there
        if whole is None:
            return self._of_look(noun, besides)
        parts = self.referents.parts.get(whole, [])
        if noun.ordinal:
            return self._ordinal(noun, whole)
        told = [t for t in [*parts, whole] if noun.side and noun.side == self.sides.get(t)]
        if told:
            return told[0]
        if noun.degree and (found := self._of_degree(noun, [*parts, whole])) is not None:
            return found
        if noun.det == "other":
            self.referents.parted = None
            return whole
        self.referents.settle(whole)
        count = self._how_many(noun, whole)
        whole = self._large_enough(noun, whole, count)
        part = self.referents.part(whole, count)
        self.singled = whole if noun.text.lower() == "the one" and part is not whole else self.singled
        if noun.side:
            self._set_side(part, whole, noun.side)
        part.unshown += [noun.degree] if noun.degree and noun.degree not in part.unshown else []
        return part

    def _large_enough(self, noun: Noun, whole: Mention, count: int) -> Mention:
        """The four of "seven desks, four here and three there" that "four of the desks" can only mean."""
        if noun.kind != "thing" or not noun.of_known or count <= self.referents.total(whole):
            return whole
        parts = self.referents.parts.get(whole, [])
        return next((t for t in parts if self.referents.total(t) >= count), whole)

    def _parted_by_side(self, noun: Noun, whole: Mention | None, besides: Sequence[Mention]) -> Mention | None:
        """Which of several that were told apart by their sides "the left one" is."""
        told = [t for t in self.sides if self.sides[t] == noun.side and t in self.draft.things and t not in besides]
        alone = noun.kind == "number" and told and (whole is None or whole not in self.sides)
        return told[-1] if alone and not self._are_newer(whole, told[-1]) else None

    def _told_at_side(self, noun: Noun, whole: Mention | None, besides: Sequence[Mention]) -> Mention | None:
        """What was said to be on that side of something: "the left nightstand"; "the left one" of one on each side."""
        at: dict[str, list[Mention]] = {"left": [], "right": []}
        for bond in self.draft.bonds:
            side = bond.kind.removesuffix("_of")
            side = _SIDE_WALLS.get(bond.anchors[:1], side)
            if side in at and not bond.negated and bond.subject.asked and bond.subject not in besides:
                at[side].append(bond.subject)
        here = [t for t in at.get(noun.side, ()) if (t.count or 1) == (noun.count or 1)]
        here = [t for t in here if whole is None or not self._are_newer(whole, t)]
        if noun.kind == "thing":
            return next((t for t in reversed(here) if t.noun == noun.value), None)
        there = {t.noun for side, things in at.items() if side != noun.side for t in things}
        return next((t for t in reversed(here) if t.noun in there), None)

    def _of_look(self, noun: Noun, besides: Sequence[Mention]) -> Mention | None:
        """The red chair that "the red one" means where a red and a blue chair were named."""
        looks = set(noun.attributes) if noun.kind == "number" and noun.det in ("the", "my") else set()
        like = [t for t in self.draft.things if t.asked and t not in besides and looks <= with_general(t.attributes)]
        return like[0] if looks and len(like) == 1 and not like[0].many else None

    def _are_newer(self, two: Mention | None, told: Mention) -> bool:
        """Whether two were named since others were told to be at two sides: "the left one" is one of them."""
        if two is None or not two.many or self.referents.total(two) != _PAIR:
            return False
        spoken = self.referents.spoken[::-1]
        return two in spoken and (told not in spoken or spoken.index(two) < spoken.index(told))

    def _told_before(self, noun: Noun, whole: Mention | None, besides: list[Mention]) -> Mention | None:
        """Those that were told apart last, or that were told to look as they are called here."""
        return self._those(noun, besides) or self._by_looks(noun, whole) or self._looking_so(noun, whole, besides)

    def _by_looks(self, noun: Noun, whole: Mention | None) -> Mention | None:
        """The one of several that was told to look so: "the red one"."""
        if whole is None or noun.det != "the" or not noun.attributes:
            return None
        alike = [t for t in self.referents.clan(whole) if set(noun.attributes) <= with_general(t.attributes)]
        fitting = (t for t in alike if noun.plural or not t.many)
        return next(fitting, None) if len(alike) < len(self.referents.clan(whole)) else None

    def _looking_so(self, noun: Noun, whole: Mention | None, besides: Sequence[Mention]) -> Mention | None:
        """The only things that were told to look so, where those named last do not: "on the round ones a vase"."""
        if noun.det != "the" or not noun.attributes or not noun.text.lower().endswith((" one", " ones")):
            return None
        looks = set(noun.attributes)
        if whole is not None and looks <= set(whole.attributes):
            return None
        alike = [t for t in self.draft.things if t.asked and t not in besides and looks <= set(t.attributes)]
        only = alike[0] if len(alike) == 1 else None
        if only is None or only.many != noun.plural:
            return None
        kin = any(t is not only and t.noun == only.noun for t in self.draft.things)
        return only if kin or self.referents.is_apart(only) else None

    def _those(self, noun: Noun, besides: list[Mention]) -> Mention | None:
        """The ones of "two of them have cushions; between those two ...", that were told apart last."""
        if noun.text.lower().split()[0] not in ("those", "these") or noun.ordinal or not noun.count:
            return None
        told = (t for t in reversed(self.referents.spoken) if t in self.counted and t in self.draft.things)
        return next((t for t in told if self.referents.total(t) == noun.count and t not in besides), None)

    def _of_degree(self, noun: Noun, family: list[Mention]) -> Mention | None:
        """The one of several that such a degree told already, or the one that is left."""
        told = [t for t in family if noun.degree in t.unshown or any(degree_of(word) for word in t.unshown)]
        found = next((t for t in told if noun.degree in t.unshown), None)
        rest = [t for t in family if t not in told]
        if found is None and told and len(rest) == 1 and not rest[0].many:
            found = rest[0]
            found.unshown.append(noun.degree)
        return found

    def _ordinal(self, noun: Noun, whole: Mention) -> Mention | None:
        """The first, second, ... of several; None for one past the last."""
        family = self.referents.family(whole)
        if noun.ordinal < 0 and self.referents.parted is whole and whole.count == 1:
            return whole
        if noun.ordinal > sum(self.referents.total(t) for t in family) > 1:
            return None
        taken = [t for known in self.ordinals.values() for t in known.values()]
        whole = next((t for t in family if t.many and t not in taken), whole)
        order = self.ordinals.setdefault(family[0] if len(family) > 1 else whole, {})
        for known in self.ordinals.values():
            if noun.ordinal in known and known[noun.ordinal] in family:
                return known[noun.ordinal]
        if (noun.count or 1) > 1 and noun.ordinal == 1 and not order:
            part = self.referents.part(whole, noun.count or 1)
            order.update(dict.fromkeys(range(1, (noun.count or 1) + 1), part))
            return part
        if (counted := self._counted_to(noun.ordinal, family)) is not None:
            order[noun.ordinal] = counted
            return counted
        free = [t for t in family if t not in taken and not t.many]
        part = self.referents.part(whole, 1) if whole.many else (free[-1] if free else whole)
        order[noun.ordinal] = part
        return part

    def _counted_to(self, ordinal: int, family: list[Mention]) -> Mention | None:
        """The ninth of "nine chairs: four here, four there and the ninth by the door": the one past those told of."""
        parts = [t for known in self.referents.parts.values() for t in known]
        told = [t for t in family if t in self.counted or t in parts]
        rest = [t for t in family if t not in told]
        if not told or len(rest) != 1 or self.ordinals.get(family[0]):
            return None
        past = ordinal - sum(self.referents.total(t) for t in told)
        return rest[0] if past == 1 == rest[0].count else None

    def _how_many(self, noun: Noun, whole: Mention) -> int:
        total = whole.count or 2
        if noun.fraction[1]:
            total += sum(p.count or 0 for p in self.referents.parts.get(whole, ()))
            return max(1, total * noun.fraction[0] // noun.fraction[1])
        if noun.every:
            return max(1, total // noun.every)
        if noun.det == "half":
            total += sum(p.count or 0 for p in self.referents.parts.get(whole, ()))
            return max(1, total // 2)
        if noun.det in ("each", "all", "none", "both") and noun.count is None:
            return total
        return noun.count or (total if noun.plural and not noun.side else 1)

    def _set_side(self, part: Mention, whole: Mention, side: str) -> None:
        """The left one of two that flank something stands at its left."""
        other = {"left": "right", "right": "left"}.get(side, "")
        self._set_walls(part, whole, side)
        self.sides[part] = side
        if part is whole:
            return
        if not other or (whole.count or 1) > (part.count or 1):
            return
        self.sides[whole] = other
        self._put_at_usual(part, whole)
        for thing, where in ((part, side), (whole, other)):
            for bond in self.draft.bonds_of(thing):
                if bond.kind == "next_to" and bond.anchors and isinstance(bond.anchors[0], Mention):
                    bond.kind = relation_kind(f"{where}_of")

    def _put_at_usual(self, *two: Mention) -> None:
        """Say of two things, of which nothing says where they are, that they are beside what such things flank."""
        tie = self.habits.tie
        flanked = [t for t in self.draft.things if t.asked and tie(two[0].noun, t.noun) == "next_to" and t not in two]
        if any(self.draft.bonds_of(thing) for thing in two) or len(flanked) != 1 or flanked[0].many:
            return
        for thing in two:
            bind(self.draft, Bond("next_to", thing, (flanked[0],)))

    def _set_walls(self, part: Mention, whole: Mention, side: str) -> None:
        """Of what stands on several walls the left ones stand on the left wall, the others on those that remain."""
        wall, across = ROOM_SIDES.get(side), {"left": "right_wall", "right": "left_wall"}.get(side)
        first = len(self.referents.parts.get(whole, ())) < 2
        spread = [b for b in self.draft.bonds_of(whole) if b.spread > 1 and b.anchors[0] in ("wall", "long_wall")]
        told = [b for b in self.draft.bonds_of(part) if b.spread > 1 or (part is whole and b.anchors == ("wall",))]
        if wall is None:
            return
        for bond in spread if part is not whole else ():
            bond.spread = bond.spread - 1 if bond.spread > 2 else 0
            bond.anchors = (across,) if first and across and not bond.spread else bond.anchors
        for bond in told:
            bond.anchors, bond.spread = (wall,), 0

    def _seats(self) -> list[Mention]:
        """The seats that were named."""
        raise NotImplementedError

    def _named_or_seats(self, noun: Noun) -> Mention | None:
        """What was named so; for "place", "seat" also the seats that were named by another word."""
        whole = self.referents.named(noun)
        if whole is None and noun.word in grammar().lists["seats"]:
            whole = next(iter(self._seats()), None)
        return whole

    def _every(self, noun: Noun) -> list[Mention]:
        """Read "every second chair", "every two loungers": so many of them, or groups of so many."""
        whole = self._named_or_seats(noun)
        if whole is None or not whole.count:
            return []
        self.referents.settle(whole)
        if noun.counted:
            self.each_of = noun.every
            return [whole]
        found: list[Mention] = []
        passed = 0
        for thing in self.referents.family(whole):
            count = (passed + (thing.count or 1)) // noun.every - passed // noun.every
            passed += thing.count or 1
            found += [self.referents.part(thing, count)] if count else []
        return found or [self.referents.part(whole, 1)]
