"""A second opinion: where what was read is not what the order of the words says, that is said.

It looks at the text again with the few facts of `said`, without knowing how the reader of clauses came to its reading:
every position has to be about what stands beside it, every list about its head, every number has to be there. Where
the two disagree nobody knows which is right, so that the words are not understood.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from thinkblox.brief import RelationKind
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Chunk, Noun, Stray, are_neighbours
from thinkblox.reading.english.referents import Referents, is_furniture, is_small, parts_of
from thinkblox.reading.english.said import SaidList, SaidPosition, is_link, parted, positions, possessions, statements

_LYING: tuple[RelationKind, ...] = ("on", "inside")
_MEANT: dict[str, tuple[RelationKind, ...]] = {
    "above": ("above", "under", "on"),
    "under": ("under", "above", "at", "around", "on", "inside"),
    "behind": ("behind", "at"),
    "in_front_of": ("in_front_of", "next_to", "near", "at", "around", "on", "facing"),
    "left_of": ("left_of",),
    "right_of": ("right_of",),
    "between": ("between", "next_to", "near"),
    "on": ("on", "inside", "in_centre", "under", "above", "at", "around", "next_to"),
    "on_top": ("on", "inside", "in_centre", "under"),
    "in": ("on", "inside", "in_centre", "at", "around", "between"),
    "opposite": ("opposite", "facing"),
    "facing": ("facing", "opposite", "in_front_of"),
    "around": ("around", "at", "next_to"),
    "far": ("far",),
    "outside": ("outside", "next_to"),
    "near": ("near", "next_to", "at"),
    "next_to": ("next_to", "near", "left_of", "right_of", "at", "on", "behind", "in_front_of", "around"),
}
"""What a preposition can have been read as; the others as anything."""
_OF_PART: dict[str, tuple[RelationKind, ...]] = {
    "left": ("left_of", "on", "inside", "next_to"),
    "right": ("right_of", "on", "inside", "next_to"),
    "front": ("in_front_of", "on", "inside"),
    "back": ("behind", "on", "inside"),
    "foot": ("at_foot_of", "next_to", "on"),
}
"""The same for a part of a thing."""
_BESIDE = ("next_to", "left_of", "right_of", "in_front_of", "behind", "opposite")
"""Relations of things that stand on the same floor, or top."""
_APART = (*_BESIDE, "near", "far", "under", "above", "facing")
"""Relations that no carrier has to what lies on it."""
_ELIDING = ("above", "under", "behind", "opposite")
"""Prepositions that say where something is without a noun after them."""
_OWNERS = ("its", "their", "his", "her")
_PAIR = 2


@dataclass(frozen=True)
class Disagreement:
    """The tokens of which two readings disagree, those of them that are in doubt, and the question that is open."""

    start: int
    end: int
    doubtful: range
    question: str


class SecondOpinion:
    """Compares a draft with what its text says on the surface.

    Args:
        draft: what was read.
        referents: what was parted from what.
        meant: what the noun phrase at each token was taken for.
    """

    def __init__(self, draft: Draft, referents: Referents, meant: Mapping[int, Sequence[Mention]]) -> None:
        self._draft = draft
        self._referents = referents
        self._meant = meant

    def disagreements(self, chunks: Sequence[Chunk]) -> Iterator[Disagreement]:
        """Everything that can hardly be meant so."""
        orders = [chunk for chunk in chunks if is_link(chunk, "corrections") or is_link(chunk, "negations", "remove")]
        corrected, moved = bool(orders), any(is_link(chunk, "corrections", "move") for chunk in orders)
        for said in statements(chunks):
            places = list(positions(said))
            for place in places:
                question = self._about(place, places)
                if question and not (moved and question == "where?"):
                    start = place.of[0].start if place.of else place.link.start
                    yield Disagreement(start, place.last, range(place.link.start, place.link.end), question)
            held = list(possessions(said))
            for having in held:
                yield from self._lists(having)
            spread = any(h.head.many for h in held) or any(_is_shared_out(chunk) for chunk in said) or _defines(said)
            placed = {place.anchor.start for place in places if place.anchor is not None and place.anchor.definite}
            for one, other in pairwise(said):
                if _is_cut_in_two(one, other) and not (one.start in placed and _is_many(other)):
                    yield Disagreement(one.start, other.end, range(one.start, other.end), "one thing?")
                if is_link(one, "prepositions") and isinstance(other, Stray) and other.text.lower() in _OWNERS:
                    yield Disagreement(one.start, other.end, range(one.start, other.end), "where?")
            apart = parted(said)
            for noun in (chunk for chunk in said if isinstance(chunk, Noun) and not corrected):
                if question := self._number(noun, spread=spread and noun.start not in apart):
                    yield Disagreement(noun.start, noun.end, range(noun.start, noun.end), question)

    # --- positions

    def _about(self, place: SaidPosition, places: Sequence[SaidPosition]) -> str:
        """What is open about a position; empty where it was read as it stands there."""
        named = place.of[0] if place.of else place.led
        subjects = self._things(named, *place.of[1:], *(place.over if self._goes_on(place) else ()))
        if named is None or named.kind != "thing" or not subjects or self._is_barred(named):
            return ""
        anchor = place.anchor
        if anchor is not None and anchor.kind == "thing":
            question = self._of_thing(place, places, subjects, anchor)
        else:
            question = "where?" if place.of and not self._has_place(place, subjects) else ""
        return question or self._of_side(place, subjects)

    def _is_barred(self, noun: Noun) -> bool:
        """Whether it names what is not to be there, so that it is nowhere."""
        return noun.value in self._draft.excluded and not self._meant.get(noun.start)

    def _of_thing(
        self, place: SaidPosition, places: Sequence[SaidPosition], subjects: Sequence[Mention], anchor: Noun
    ) -> str:
        """What is open about a position that is to a thing."""
        anchors = self._things(anchor)
        if anchors and not self._are_related(subjects, anchors, _kinds(place)):
            return "where?"
        if place.second is None and self._is_of_others(self._things(*place.of[:1], place.led), anchor):
            return "which of them?"
        return "of what?" if place.led is not None and self._is_shared_front(place, places, anchors) else ""

    def _of_side(self, place: SaidPosition, subjects: Sequence[Mention]) -> str:
        """What is open about who is meant, and about sides."""
        if _is_side_of_either(place):
            return "of what?"
        if self._is_odd_side(place):
            return "how many?"
        lost = self._is_forgotten(place) or self._is_one_sided(place, subjects)
        if lost or self._is_beside_its_carrier(subjects):
            return "where?"
        return "which of them?" if self._is_of_more(place) else ""

    def _goes_on(self, place: SaidPosition) -> bool:
        """Whether a position may be about what stood before the one before: the noun between was named earlier."""
        if not place.of or place.link.value in ("facing", "opposite") or place.carried:
            return True
        if any(load_habits().is_in(thing.noun, "covers") for thing in self._things(place.of[0])):
            return True
        start = place.of[0].start
        return any(self._first.get(thing, start) < start for thing in self._meant.get(start, ()))

    @cached_property
    def _first(self) -> dict[Mention, int]:
        """Where each thing was first named."""
        return {thing: start for start, things in sorted(self._meant.items(), reverse=True) for thing in things}

    @cached_property
    def _turned(self) -> dict[Mention, list[Bond]]:
        """The relations, by their anchors, that say of these where they are as much as of their subjects."""
        turned: dict[Mention, list[Bond]] = {}
        for bond in self._draft.bonds:
            for anchor in parts_of(bond) if bond.kind in ("right_of", "under") else ():
                turned.setdefault(anchor, []).append(bond)
        return turned

    def _has_place(self, place: SaidPosition, subjects: Sequence[Mention]) -> bool:
        """Whether any of the subjects is somewhere, as a place or a pronoun says."""
        if place.to is not None and place.to.kind == "place" and place.whole is None and place.to.det != "my":
            on_wall = all(load_habits().is_in(thing.noun, "wallpieces") for thing in subjects)
            carriers = [t for b in self._bonds(subjects) if b.kind == "on" and not b.negated for t in parts_of(b)]
            return on_wall or any(
                (b.anchors and isinstance(b.anchors[0], str)) or b.kind == "in_centre"
                for b in self._bonds([*subjects, *carriers])
            )
        if place.whole is not None or (place.to is not None and place.to.kind not in ("pronoun", "part")):
            return True
        if place.to is None and place.link.value not in _ELIDING:
            return True
        told = [bond for bond in self._bonds(subjects) if not bond.implied]
        kinds = ("right_of", "under") if place.link.value in ("on", "on_top") else ("right_of",)
        told += dict.fromkeys(b for thing in subjects for b in self._turned.get(thing, ()) if b.kind in kinds)
        part = place.to if place.to is not None and place.to.kind == "part" else None
        ends = _is_at_wall(told) or any(bond.kind == "at_short_side" for bond in told)
        tops = [bond.anchors for bond in told if bond.kind == "on"]
        ends |= any(bond.kind in ("left_of", "right_of") and bond.anchors in tops for bond in told)
        if part is not None and part.det == "other" and part.value == "end" and not ends:
            return False
        beside = (b for b in told if b.told and b.kind in _BESIDE and not is_small(b.subject))
        return bool(told) and not any(self._lies(anchor) for bond in beside for anchor in parts_of(bond))

    def _lies(self, thing: Mention) -> bool:
        """Whether it is small, or a plant, and lies on or in something."""
        low = is_small(thing) or load_habits().is_in(thing.noun, "plants")
        return low and any(b.kind in _LYING and not b.negated and parts_of(b) for b in self._draft.bonds_of(thing))

    def _is_beside_its_carrier(self, subjects: Sequence[Mention]) -> bool:
        """Whether what one of them lies on was said to stand beside it."""
        return any(
            bond.subject in other.anchors
            for bond in self._bonds(subjects)
            if bond.kind in _LYING and not bond.negated
            for carrier in parts_of(bond)
            for other in self._draft.bonds_of(carrier)
            if other.kind in _APART and not other.negated
        )

    def _is_forgotten(self, place: SaidPosition) -> bool:
        """Whether what is joined to the subject, and has to lie somewhere, is nowhere: "a fork and a mug beside it"."""
        paired = place.paired and place.link.value == "against"
        if paired and any(t and not any(map(self._is_anywhere, t)) for t in map(self._things, place.joined[:1])):
            return True
        if place.to is not None and place.to.kind == "place":
            return False
        for things in (self._things(noun) for noun in place.joined):
            if not all(is_small(thing) for thing in things):
                return False
            if things and not any(self._is_anywhere(thing) for thing in things):
                return True
        return False

    def _is_anywhere(self, thing: Mention) -> bool:
        """Whether anything is said of where a thing is, or of others by it."""
        if self._draft.bonds_of(thing) or thing.per:
            return True
        return any(thing in b.anchors and b.kind not in _LYING for b in self._draft.bonds)

    def _is_one_sided(self, place: SaidPosition, subjects: Sequence[Mention]) -> bool:
        """Whether "to the left" was not read as that, or of "to the left and right" only one side."""
        words = [str(a) for b in self._bonds(subjects) for a in (b.kind, *b.anchors) if isinstance(a, str)]
        named = place.to.value if place.to is not None and place.to.kind == "part" else ""
        sides = ("left", "right") if place.sides > 1 else (named,) if named in ("left", "right") else ()
        lying = place.sides == 1 and any(b.kind in _LYING for b in self._bonds(subjects))
        long = _is_one_of_two(place.to) and any(b.kind in ("in_front_of", "behind") for b in self._bonds(subjects))
        return not (lying or long) and not all(any(side in word for word in words) for side in sides)

    def _is_odd_side(self, place: SaidPosition) -> bool:
        """Whether not as many are at one side of something as at the other."""
        part = place.to
        if part is None or part.kind != "part" or part.det not in ("both", "either", "each") or not place.of:
            return False
        return not any(self._is_even(things) for noun in place.of if (things := self._things(noun)))

    def _is_even(self, things: Sequence[Mention]) -> bool:
        """Whether things are so many at each of two sides, or of each of several."""
        if any(bond.each for bond in self._bonds(things)):
            return True
        counted = all(thing.count is not None for thing in things)
        return counted and sum(self._referents.total(t) for t in things) % _PAIR == 0

    def _is_of_more(self, place: SaidPosition) -> bool:
        """Whether a verb of one thing was taken to be about others too: "a bar with two lamps is on the left"."""
        verb, first = place.verb, place.of[-1] if place.of else None
        if verb is None or first is None or len(place.of) < _PAIR or first.many or first.kind != "thing":
            return False
        word = verb.text.lower().split()[0]
        if word != "is" and not (word.endswith("s") and verb.value in ("stand", "hang")):
            return False
        ones = self._things(first)
        where = {(b.kind, b.anchors) for b in self._bonds(ones) if b.anchors}
        others = [t for t in self._things(*place.of[:-1]) if t not in ones]
        return any(not b.implied and not b.negated and (b.kind, b.anchors) in where for b in self._bonds(others))

    def _is_of_others(self, subjects: Sequence[Mention], anchor: Noun) -> bool:
        """Whether a relation to one of several was taken for one to others of them too: "before the third rack"."""
        exact = set(self._meant.get(anchor.start, ()))
        parted = set(self._things(anchor)) - exact
        if not parted or anchor.many or anchor.kind != "thing" or anchor.det in ("each", "all", "both"):
            return False
        return any(exact & set(bond.anchors) and parted & set(bond.anchors) for bond in self._bonds(subjects))

    def _is_shared_front(self, place: SaidPosition, places: Sequence[SaidPosition], anchors: Sequence[Mention]) -> bool:
        """Whether what a position in front is about was taken for something that has another position."""
        later = [p for p in places if p.link.start > place.last and p.of and p.of[0] is not place.led]
        later = [p for p in later if p.to is None or p.to.kind != "part" or p.to.value not in ("left", "right")]
        if any(set(self._things(p.anchor)) & set(anchors) for p in later):
            return False
        later = [p for p in later if not any(self._lies_on(t, anchors) for t in self._things(p.anchor))]
        things = [t for p in later for t in self._things(p.of[0]) if self._first.get(t, -1) >= p.of[0].start]
        doubled = (t for t in things if len(self._draft.bonds_of(t)) > 1)
        return any(not b.implied and set(b.anchors) & set(anchors) for t in doubled for b in self._draft.bonds_of(t))

    def _lies_on(self, thing: Mention, anchors: Sequence[Mention]) -> bool:
        """Whether it was said to be on or in one of these, so that what is beside it is there too."""
        lying = (b for b in self._draft.bonds_of(thing) if b.kind in _LYING and not (b.negated or b.implied))
        return any(set(b.anchors) & set(anchors) for b in lying)

    # --- lists

    def _lists(self, having: SaidList) -> Iterator[Disagreement]:
        """The members of a list that were not read as such, or not as many as each of several has."""
        heads = self._things(having.head)
        lying = [noun for noun in having.lying if all(is_small(thing) for thing in self._things(noun))]
        for noun in (*having.members, *lying):
            things = self._things(noun)
            if not heads or not things:
                continue
            question = ""
            others = [t for t in self._things(*having.members, *having.lying) if t not in things]
            apart = noun is not having.members[0] and all(is_furniture(thing) for thing in things)
            related = self._are_related(things, [*heads, *self._things(*having.outer), *others])
            if not (apart or related):
                question = "where?"
            elif self._is_of_one_alone(heads, things) or (
                having.each and self._is_shared_unevenly(having.head, heads, noun, things)
            ):
                question = "how many?"
            if question:
                link = having.link
                yield Disagreement(having.head.start, noun.end, range(link.start, link.end), question)

    def _is_shared_unevenly(self, head: Noun, heads: Sequence[Mention], noun: Noun, things: Sequence[Mention]) -> bool:
        """Whether there are not as many as there are heads, or a multiple of that."""
        if head.every or any(t.groups for t in heads) or any(t.per for t in things):
            return False
        each = sum(self._referents.total(t) for t in heads)
        return sum(self._referents.total(t) for t in things) % each > 0

    def _is_of_one_alone(self, heads: Sequence[Mention], things: Sequence[Mention]) -> bool:
        """Whether what each of several has was read as that of one: "a shelf above each sink with a cup"."""
        shared = any(b.each and not b.negated for b in self._bonds(heads))
        told = [b for b in self._bonds(things) if set(b.anchors) & set(heads)]
        return shared and bool(told) and not any(b.each for b in self._bonds(things)) and len(things) == 1

    # --- numbers

    def _number(self, noun: Noun, *, spread: bool) -> str:
        """What is open about the number of a thing; `spread` says that the statement tells of each of several."""
        if noun.kind == "place" and noun.value in ("window", "door"):
            made = sum(gap.count for gap in self._draft.openings if gap.kind == noun.value)
            return "how many?" if (noun.count or 0) > max(made, 1) else ""
        things = self._meant.get(noun.start, ())
        if noun.kind != "thing" or not things or noun.text.lower().startswith("one "):
            return ""
        exact = sum(self._referents.total(thing) for thing in things)
        if noun.ordinal and exact > 1 and not noun.plural:
            return "which of them?"
        if any(thing.per for thing in things):
            return ""
        if noun.rows > 0 and noun.plural and all(thing.count is not None for thing in things):
            return "how many?" if sum(self._referents.total(t) for t in self._things(noun)) < _PAIR * noun.rows else ""
        if _is_part_of_some(noun):
            return ""
        count = noun.count or 1
        made = sum(self._referents.total(thing) for thing in self._things(noun))
        return "how many?" if made % count or (made > count and not spread) else ""

    # --- what was read

    def _things(self, *nouns: Noun | None) -> list[Mention]:
        """What noun phrases were taken for, with all that was parted from that."""
        found = (thing for noun in nouns if noun is not None for thing in self._meant.get(noun.start, ()))
        return list(dict.fromkeys(part for thing in found for part in self._referents.clan(thing)))

    def _bonds(self, things: Sequence[Mention]) -> list[Bond]:
        return [bond for thing in things for bond in self._draft.bonds_of(thing)]

    def _are_related(self, subjects: Sequence[Mention], anchors: Sequence[Mention], kinds: Sequence[str] = ()) -> bool:
        """Whether any of these, or what each of them lies on, stands in any relation of these kinds to any of those."""
        laid = [part for b in self._bonds(subjects) if b.kind == "on" and b.each for part in parts_of(b)]
        for bond in (*self._bonds(subjects), *self._bonds(laid), *self._bonds(anchors)):
            ends = {bond.subject, *parts_of(bond), *bond.subject.per}
            if (not kinds or bond.kind in kinds) and ends & {*subjects, *laid} and ends & set(anchors):
                return True
        return False


def _kinds(place: SaidPosition) -> Sequence[str]:
    """What a position can have been read as; anything where that is empty."""
    if place.whole is not None and place.to is not None:
        return _OF_PART.get(place.to.value, ())
    return _MEANT.get(place.link.value, ())


def _is_cut_in_two(one: Chunk, other: Chunk) -> bool:
    """Whether two things are named without a word between them: "a light" and "grey sofa"."""
    named = isinstance(one, Noun) and isinstance(other, Noun) and one.kind == other.kind == "thing"
    return named and isinstance(other, Noun) and one.end == other.start and not other.det and other.count is None


def _is_many(chunk: Chunk) -> bool:
    """Whether it names several things that need no word before them."""
    return isinstance(chunk, Noun) and chunk.many


def _is_side_of_either(place: SaidPosition) -> bool:
    """Whether a side may be the room's, and several that something has there: "a bar with six stools on the left"."""
    part = place.to if place.to is not None and place.to.kind == "part" and place.whole is None else None
    if part is None or part.det != "the" or part.owner or _is_one_of_two(part):
        return False
    loose = part.value == "side" and place.link.value in ("along", "at")
    return loose or (part.value in ("left", "right") and place.held and place.of[0].many)


def _is_one_of_two(part: Noun | None) -> bool:
    """Whether it is "one side" or "the other", which were taken for two that are across from each other."""
    return part is not None and part.text.lower().startswith(("one ", "the other", "the opposite"))


def _is_at_wall(bonds: Sequence[Bond]) -> bool:
    return any(isinstance(anchor, str) and anchor.endswith("wall") for bond in bonds for anchor in bond.anchors)


def _is_part_of_some(noun: Noun) -> bool:
    """Whether a phrase points back, or leaves its number open."""
    pointed = noun.det not in ("a", "", "my") or noun.of_known or noun.every or noun.total or noun.fraction[1]
    loose = noun.vague or noun.rows or noun.groups or noun.share or (noun.count is None and noun.plural)
    return bool(pointed or loose)


def _is_shared_out(chunk: Chunk) -> bool:
    """Whether a word tells of each of several, so that a number may be multiplied."""
    if isinstance(chunk, Noun):
        several = chunk.kind == "people" or (chunk.kind in ("place", "part") and chunk.many)
        several |= chunk.of_known and (chunk.count or 0) > 1
        several |= chunk.value == "other" and chunk.shared
        each = chunk.det in ("each", "either", "both", "all") or chunk.value in ("each", "all", "them")
        return several or each or chunk.every > 0 or chunk.kind == "number" or are_neighbours(chunk)
    return is_link(chunk, "prepositions", "per", "sides") or is_link(chunk, "mutual")


def _defines(said: Sequence[Chunk]) -> bool:
    """Whether it says what several that were named are: "a booth is a desk with two stools"."""
    first, verb, second = (*said[:3], None, None, None)[:3]
    told = isinstance(first, Noun) and isinstance(second, Noun) and first.det == "a" and second.det == "a"
    return told and (is_link(verb, "verbs", "be", "consist") or is_link(verb, "inverses", "with"))
