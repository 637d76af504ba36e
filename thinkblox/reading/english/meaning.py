"""What a preposition and its noun mean: which relation, to what."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets import kind_of
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import room_type
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.across import ACROSS
from thinkblox.reading.english.antecedents import Antecedents
from thinkblox.reading.english.chunks import Noun, are_neighbours
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Meaning, Where
from thinkblox.reading.english.parts import SIDES, relation_at
from thinkblox.reading.english.places import corner, opening, wall
from thinkblox.reading.english.referents import Referents, fits, is_small, last_word
from thinkblox.reading.english.rewording import SHARES

_OPENINGS = ("window", "door")
_NAMED = {
    "in": "inside",
    "by": "next_to",
    "along": "next_to",
    "against": "next_to",
    "to": "next_to",
    "from": "on",
    "on_top": "on",
}
ROOM_SIDES = {"left": "left_wall", "right": "right_wall", "back": "far_wall", "front": "near_wall"}
"""The walls at the sides of a room."""
_CARRYING = ("top", "middle", "inside", "in_shelf")
"""Parts that carry or hold things."""
_WHOLE_BY = {"head": "at_foot_of", "foot": "at_foot_of", "long_side": "at_long_side", "short_side": "at_long_side"}
"""The relation that tells which thing has such a part."""


_FAR_PARTS = ("head", "foot", "end", "side", "short_side", "long_side", "front", "back")
"""Parts of things across from which something else may stand."""
_TOPS = ("tables", "desks", "counters", "worktops")
"""What has a top on which things lie in the middle."""
_SIDES, _ALL_SIDES = 2, 4
"""More sides than these are all around a thing."""
_SEVERAL = 3
"""Of so many alike "between them" does not mean between the two of them."""
_CORNERS = ("corner", "back left", "back right", "front left", "front right")
"""Corners of a top."""
_ROUNDED = {"round", "oval", "square"}
"""Shapes of tables that have no two long sides."""
_HOLLOW = frozenset("tent booth cage playpen pen tub bathtub shower cubicle ring playhouse house cabin sauna".split())
"""What one can be inside of, so that "outside" is outside of it rather than of the room."""
_NUMBERS = {"three": 3, "four": 4}
"""How many "all three" are."""
_APART = ("on", "inside")
"""Relations that one thing has to one other only, so that "a lamp on both tables" is one on each."""
_TOWARDS = ("facing", "opposite", "next_to", "in_front_of", "behind", "left_of", "right_of", "far", "between")
"""Relations to other things rather than to places: "facing the others"."""

_FEW = 3
"""More desks or seats than this have a front before them."""
_LOOKING = ("desks", "seats", "worked_at")


class Meanings:
    """Finds what prepositional phrases mean; names things that they name for the first time."""

    def __init__(self, referents: Referents, antecedents: Antecedents, name: "Namer") -> None:
        self.referents = referents
        self.antecedents = antecedents
        self._words = (0, 0)
        self.name = name
        self.place: Meaning | None = None
        self.anchor: tuple[str, Mention] | None = None
        self.sided: tuple[str, Mention] | None = None
        self.ended: Mention | None = None
        self.beside = ("", "")
        self.room_side = ""
        self._sides_told = 0
        self.guessed = False

    def forget_sides(self) -> None:
        """End a sentence: of what the left side was told is known for one sentence more."""
        self._sides_told = self._sides_told + 1 if self.sided is not None else 0
        if self._sides_told > 1:
            self.sided, self._sides_told = None, 0
        self.ended, self.beside, self.room_side = None, ("", ""), ""

    def is_other_end(self, part: Noun) -> bool:
        """Whether it is the other end of what the sentence told of one end of."""
        return part.value == "end" and part.det == "other" and self.ended is not None

    def of(self, where: Where, subjects: list[Mention], likely: list[Mention], noun: str = "") -> Meaning | None:
        """The relation that `where` gives to `subjects`; None when it says nothing about them.

        Args:
            where: the phrase.
            subjects: what it is said of; empty where that comes later.
            likely: what a pronoun would mean first.
            noun: the noun of the subject to come.
        """
        if where.text:
            end = where.noun.end if where.noun is not None else where.start + len(where.text.split())
            self._words = (where.start, end)
        if where.word == "sides":
            meaning = self._of(replace(where, word="next_to"), subjects, likely, noun)
            meaning = replace(meaning, both=True) if meaning is not None else None
        else:
            meaning = self._of(where, subjects, likely, noun)
        if meaning is None or not meaning.anchors:
            return None
        if meaning.kind == "above" and self._is_draped(where, subjects, noun, meaning):
            meaning.kind = "on"
        meaning.loose |= (
            meaning.kind == "on"
            and where.text.lower().startswith("inside")
            and not all(isinstance(a, Mention) and load_habits().is_in(a.noun, "own_bed") for a in meaning.anchors)
        )
        said = where.whole or where.noun
        meaning.loose |= said is not None and _is_one_of_levels(said)
        meaning.pointed = said is None or said.kind in ("pronoun", "part", "number")
        return meaning

    def _is_draped(self, where: Where, subjects: list[Mention], noun: str, meaning: Meaning) -> bool:
        """Whether a cloth lies over furniture rather than hanging above it: "a chair with a blanket over it"."""
        names = [subject.noun for subject in subjects] or [noun]
        if where.text.lower().partition(" ")[0] != "over":
            return False
        cloths = all(name.rpartition("_")[2] in grammar().lists["drapes"] for name in names)
        things = [anchor for anchor in meaning.anchors if isinstance(anchor, Mention)]
        hung = any(
            a == "wall" for subject in subjects for b in self.referents.draft.bonds_of(subject) for a in b.anchors
        )
        return cloths and not hung and bool(things) and not any(is_small(thing) for thing in things)

    def _of(self, where: Where, subjects: list[Mention], likely: list[Mention], noun: str) -> Meaning | None:
        said = where.noun
        if where.word == "halfway":
            return Meaning("in_centre", (said.value if said is not None else "centre",))
        if said is None:
            return self._elided(where.word, subjects, likely, noun)
        match said.kind:
            case "part":
                return self._part(where, said, subjects, likely, noun)
            case "place" if said.value in _OPENINGS and said.text.lower().split()[0] == "its":
                found = self._single("on", subjects, likely, noun, one=True)
                return Meaning("on", (found,), told=True) if found is not None else None
            case "place":
                self.anchor = None
                self.place = self._place(where, said, subjects, likely, noun)
                return replace(self.place) if self.place is not None else None
            case "pronoun":
                return self._pronoun(where, said, subjects, likely, noun)
            case "number":
                return self._number(where, said, subjects, noun)
            case "thing":
                return self._thing(where, said, subjects)
        return None

    # --- no anchor, or a pronoun

    def _elided(self, word: str, subjects: list[Mention], likely: list[Mention], noun: str) -> Meaning | None:
        """Read "a mirror above", "with a mug inside"."""
        kind = _NAMED.get(word, word)
        if kind not in (
            "above",
            "under",
            "behind",
            "inside",
            "opposite",
            "next_to",
            "near",
            "between",
            "around",
            "outside",
        ):
            return None
        if kind == "between":
            last = next((t for t in likely if t not in subjects), None)
            two = self._two_sides([last]) if last is not None else ()
            two = two or self._across_from(last)
            two = two or ((last,) if last is not None and self.referents.total(last) == _SIDES else ())
            return Meaning(kind, two or self._several(kind, subjects, noun), told=True)
        found = self._single(kind, subjects, likely, noun)
        if found is not None and found.many and kind == "under":
            found = self._over_rug(subjects) or found
        if found is None or (kind == "outside" and not _HOLLOW & {*found.noun.split("_")}):
            return None
        return self._fitting(Meaning(kind, (found,), told=True), subjects, noun)

    def _over_rug(self, subjects: list[Mention]) -> Mention | None:
        """The table that was named just before one rug: "two sofas with a table between them and a rug underneath"."""
        things = self.referents.draft.things
        rug = subjects[-1] if subjects else None
        if rug is None or rug.many or rug not in things or not load_habits().is_in(rug.noun, "covers"):
            return None
        before = things[things.index(rug) - 1] if things.index(rug) else None
        single = before is not None and not before.many and load_habits().is_in(before.noun, "tables", "low_tables")
        return before if single else None

    def _across_from(self, last: Mention | None) -> tuple[Mention, ...]:
        """The armchairs and the sofa of "two armchairs facing the sofa, and a table in between"."""
        bonds = self.referents.draft.bonds_of(last) if last is not None else []
        faced = [b.anchors[0] for b in bonds if b.kind in ("facing", "opposite") and len(b.anchors) == 1 and b.asked]
        other = next((a for a in faced if isinstance(a, Mention) and a is not last and not is_small(a)), None)
        return (last, other) if last is not None and other is not None else ()

    def _single(
        self, kind: str, subjects: list[Mention], likely: list[Mention], noun: str, *, one: bool = False
    ) -> Mention | None:
        subject = subjects[-1] if subjects else None
        found = self.referents.single(subject, kind, [t for t in likely if t not in subjects], noun, one=one)
        if found is None:
            return None
        name = subject.noun if subject is not None else noun
        chosen = self.antecedents.choose(self._words, kind, subjects, name, found, one=one)
        slides = is_small_name(name) and name in load_habits().known()
        seats = kind == "around" and load_habits().is_in(name, "seats", "chairs", "lounges")
        return self._carrier_of(chosen) if seats or (kind == "under" and not slides) else chosen

    def _carrier_of(self, thing: Mention) -> Mention:
        """What a small thing lies on, as nothing but that can have something standing under it."""
        lying = (b for b in self.referents.draft.bonds_of(thing) if b.kind == "on" and not b.negated)
        carriers = [a for b in lying for a in b.anchors if isinstance(a, Mention)] if is_small(thing) else []
        return carriers[0] if carriers else thing

    def _several(self, kind: str, subjects: list[Mention], noun: str) -> tuple[Mention, ...]:
        found = self.referents.several(subjects, kind)
        name = subjects[-1].noun if subjects else noun
        return self.antecedents.choose_several(self._words, kind, subjects, name, found) if found else ()

    def _pronoun(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        kind = self._kind(where.word)
        of_many = said.value == "all" and len(self.referents.standing(subjects)) > 1
        if where.word in ("of", "for", "as", "with", "to", "from") or said.text.lower() == "everything" or of_many:
            return None
        own = self.referents.together.get(subjects[-1].host) if said.value == "it" and subjects else None
        if own and kind not in ("between", "around"):
            return Meaning(kind, own, each=True, told=True)
        if said.value in ("it", "one", "none", "half"):
            if kind == "between":
                return Meaning(kind, self._several(kind, subjects, noun), told=True)
            if said.value == "one":
                return self._one_of(kind, subjects, noun)
            small = is_small(subjects[-1]) if subjects else noun != "" and is_small_name(noun)
            those = said.text.lower() in ("that", "all this", "all that")
            last = self.referents.last(subjects, lying=small and kind in _TOWARDS) if those else None
            found = last or self._single(kind, subjects, likely, noun, one=said.value == "it")
            told = self._each_of_two(kind, found) if found is not None else None
            return self._fitting(told, subjects, noun, where.word) if told is not None else None
        if said.value in ("former", "latter"):
            found = self.referents.of_two(said.value, subjects)
            return self._fitting(Meaning(kind, (found,), told=True), subjects, noun) if found is not None else None
        if said.value == "other":
            rest = self._other(kind, subjects)
            return replace(rest, each=rest.each or said.shared) if rest is not None else None
        return self._them(where, said, subjects, likely, noun)

    def _each_of_two(self, kind: str, found: Mention) -> Meaning:
        """What "it" means of which something is said of each: "a nightstand on each side, each with a lamp on it"."""
        two = self.referents.family(found) if found in self.referents.flanking else []
        shared = len(two) > 1 and all(thing in self.referents.shared for thing in two)
        shared &= not self.antecedents.is_named_alone(found)
        return Meaning(kind, tuple(two) if shared else (found,), each=shared, told=True)

    def _them(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        """What "them", "all three" and "each of them" mean."""
        kind = self._kind(where.word)
        if (number := _NUMBERS.get(said.text.lower().split()[-1])) and said.value == "them":
            three = self.referents.latest(number, subjects)
            return self._fitting(Meaning(kind, three, told=True), subjects, noun) if three else None
        two = self.referents.both(subjects) if said.text.lower().startswith("both") else ()
        two = two or (self._two_sides(likely) if kind == "between" and said.value == "them" else ())
        plural = [t for t in likely if t.many]
        if said.value == "each" and said.attributes:
            plural = [t for t in self.referents.plural() if set(said.attributes) <= set(t.attributes)] or plural
        if said.value == "each" and kind == "at" and subjects and is_seat(subjects[-1]):
            every = [t for t in (*likely, *self.referents.plural()) if t.many]
            plural = [t for t in every if _is_sat_at(t)] or [t for t in every if not is_small(t)] or plural
        anchors = two or (
            tuple(plural[:1])
            if plural and (kind != "between" or likely[:1] == plural[:1])
            else self.referents.several(subjects, kind)
        )
        if anchors and not two and (said.value == "them" or (said.value == "each" and len(plural) > 1)):
            name = subjects[-1].noun if subjects else noun
            anchors = self.antecedents.choose_several(self._words, kind, subjects, name, anchors)
        if said.value == "each" and kind == "next_to" and not (subjects and is_small(subjects[-1])):
            large = [t for t in self.referents.plural() if not is_small(t) and t not in subjects]
            anchors = tuple(large[:1]) if large and all(map(is_small, anchors)) else anchors
        if said.value == "each" and not anchors:
            anchors = tuple(likely[:1])
        whole = said.value == "each" and not said.attributes and len(anchors) == 1
        whole &= not (said.text.lower().endswith(("those", "these")) and self._was_parted_last(anchors))
        if whole and len(family := self.referents.family(anchors[0])) > 1:
            anchors = tuple(t for t in family if t not in subjects) or anchors
        meaning = Meaning(kind, anchors, each=said.value == "each", told=True)
        return self._fitting(meaning, subjects, noun, where.word) if anchors else self._openings(where, said)

    def _openings(self, where: Where, said: Noun) -> Meaning | None:
        """Read "three windows and a desk under each of them", where no other thing is several."""
        gap = next((gap for gap in reversed(self.referents.draft.openings) if gap.count > 1), None)
        if gap is None or said.value not in ("each", "them"):
            return None
        return opening(where.word, gap.kind, gap.count if said.value == "each" else 0)

    def _was_parted_last(self, anchors: tuple[Mention, ...]) -> bool:
        """Whether some of several were told apart just now, and nothing of the others since."""
        if not anchors:
            return False
        family = self.referents.family(anchors[0])
        last = next((t for t in reversed(self.referents.spoken) if t in family), None)
        return last is anchors[0] and self.referents.is_apart(last) and self.referents.parted in (*family, None)

    def _two_sides(self, likely: list[Mention]) -> tuple[Mention, ...]:
        """The washers and dryers of "washers along one wall, dryers along the other, a table between them"."""
        last = likely[0] if likely else None
        things = self.referents.draft.things
        if last is not None and (listed := self._listed_with(last)) is not None:
            return (listed, last)
        before = self._beside_room(things[: things.index(last)]) if last in things[1:] else None
        few = last is not None and last.many and (last.count or _SEVERAL) < _SEVERAL
        if last is None or before is None or not before.asked:
            return ()
        if few and before not in self.referents.family(last):
            return ()
        where, across = self.referents.draft.bonds_of(last), self.referents.draft.bonds_of(before)
        walls = any(b.kind == c.kind and b.anchors != c.anchors for b in where for c in across if _at_place(b, c))
        opposite = any(b.kind in ("opposite", "facing") and before in b.anchors for b in where)
        return (before, last) if walls or opposite else ()

    def _listed_with(self, last: Mention) -> Mention | None:
        """The one named just before another of which the same is told: "across from it are a drum kit and a piano"."""
        things = self.referents.draft.things
        before = things[things.index(last) - 1] if last in things[1:] else None
        if before is None or before.many or last.many:
            return None
        told, also = ({(b.kind, b.anchors) for b in self.referents.draft.bonds_of(t)} for t in (last, before))
        return before if told and told == also and any(kind == "opposite" for kind, _ in told) else None

    def _beside_room(self, things: list[Mention]) -> Mention | None:
        """The last of some things that is not merely another's, as the ladders of beds are."""
        bonds = ((thing, self.referents.draft.bonds_of(thing)) for thing in reversed(things))
        return next((t for t, own in bonds if not own or any(_at_place(bond) for bond in own)), None)

    def _one_of(self, kind: str, subjects: list[Mention], noun: str) -> Meaning | None:
        name = subjects[-1].noun if subjects else noun
        several = [t for t in self.referents.plural() if t not in subjects]
        usual = [t for t in several if name and load_habits().tie(name, t.noun) == kind]
        fit = [t for t in several if fits(t, kind, name) and not (kind == "on" and is_seat(t))]
        apart = [t for t in self.referents.spoken[::-1] if len(self.referents.family(t)) > 1 and t not in subjects]
        told = [t for t in apart if name and load_habits().tie(name, t.noun) == kind]
        if told and not usual and told[0] in self.referents.draft.things:
            family = self.referents.family(told[0])
            self.referents.parted = family[-1]
            return self._fitting(Meaning(kind, (family[0],), told=True), subjects)
        latest = [t for t in fit[:1] if t is several[0] and load_habits().is_in(t.noun, *_STANDING_ALONE)]
        whole = self.referents.parted or next(iter(latest or usual or fit or several), None)
        if whole is None:
            return None
        return self._fitting(Meaning(kind, (self.referents.part(whole, 1),), told=True), subjects)

    def _other(self, kind: str, subjects: list[Mention]) -> Meaning | None:
        whole = self.referents.parted or self.referents.left_over()
        if whole is None and self.anchor is not None and kind == self.anchor[0] and not self.anchor[1].many:
            other = self._other_of_two(self.anchor[1]) or self.name.another(self.anchor[1])
            return self._fitting(Meaning(kind, (other,), told=True), subjects)
        across = self.place is not None and str(self.place.anchors[0]).endswith("_wall") and kind in ("on", "next_to")
        if whole is None and kind in _TOWARDS and not across:
            kin = [t for t in self.referents.draft.things if subjects and t.noun == subjects[-1].noun]
            kin = [t for t in kin if t not in subjects]
            return Meaning(kind, tuple(kin[:1]), told=True) if len(kin) == 1 else None
        if whole is None and self.place is not None:
            wall = str(self.place.anchors[0])
            anchors = (ACROSS.get(wall, "opposite_wall"),) if wall.endswith("_wall") else self.place.anchors
            return Meaning(self.place.kind, anchors)
        self.referents.parted = None
        return self._fitting(Meaning(kind, (whole,), told=True), subjects) if whole is not None else None

    def _other_of_two(self, thing: Mention) -> Mention | None:
        """The blue one of "a red chair and a blue one", where the red one was just spoken of."""
        kin = [t for t in self.referents.draft.things if t.noun == thing.noun and t.asked]
        others = [t for t in kin if t is not thing]
        return others[0] if len(others) == 1 and not others[0].many else None

    def _number(self, where: Where, said: Noun, subjects: list[Mention], noun: str) -> Meaning | None:
        """Read "on the left one", "on the third", "on two of them"."""
        if not self._lies_on_one_of(where, subjects) and (wall := self._other_wall(where, said)) is not None:
            return wall
        kind, name = self._kind(where.word), subjects[-1].noun if subjects else noun
        others = [t for t in self.referents.draft.things if kind in _APART and t.many and not fits(t, kind, name)]
        found = self.name.some_of(said, besides=[*subjects, *others]) or self.name.some_of(said, besides=subjects)
        if found is None:
            return None
        if said.det == "a" and not found.many:
            found.attributes += [look for look in said.attributes if look not in found.attributes]
        self.anchor, self.place = (kind, found), None
        meaning = self._fitting(Meaning(kind, (found,), told=True), subjects, noun)
        single = bool(subjects) and subjects[-1].count == 1
        carried = single and meaning.kind in ("on", "inside", "at")
        fronted = not subjects and said.det == "other" and said.shared
        meaning.each = (carried or fronted) and found.many and found.count is not None
        return meaning

    def _lies_on_one_of(self, where: Where, subjects: list[Mention]) -> bool:
        """Whether something lies by nature on one of several things named before, as a lamp does on a nightstand."""
        if not subjects or self._kind(where.word) != "on":
            return False
        several = (t for t in (*self.referents.plural(), *self.referents.flanking) if t not in subjects)
        return any(load_habits().tie(subjects[-1].noun, thing.noun) == "on" for thing in several)

    def _other_wall(self, where: Where, said: Noun) -> Meaning | None:
        """Read "along the right one" after "along the left wall"."""
        before = self.place.anchors[0] if self.place is not None else ""
        named = isinstance(before, str) and before.endswith("_wall") and said.text.lower().endswith(" one")
        if named and "opposite" in said.text.lower():
            return wall(where.word, Noun("place", "wall", said.start, said.end, said.text), "wall", 0, each=False)
        if not named or said.side not in ("left", "right"):
            return None
        return wall(
            where.word, Noun("place", "wall", said.start, said.end, said.text), ROOM_SIDES[said.side], 0, each=False
        )

    # --- parts of things

    def _part(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        if (apart := self._of_several(where, said, subjects)) is not None:
            return apart
        meaning = self._whole(where, said, subjects, likely, noun)
        if meaning is None or not meaning.anchors:
            return None
        whole = meaning.anchors[0]
        if isinstance(whole, str):
            return replace(meaning, kind="facing") if where.word == "facing" else meaning
        if said.value in ("left", "right"):
            self.sided = (said.value, whole)
        if where.word == "above":
            return replace(meaning, kind="above", loose=said.value not in ("head", "middle", "top"))
        return self._at_part(where, said, subjects, noun, meaning, whole)

    def _at_part(
        self, where: Where, said: Noun, subjects: list[Mention], noun: str, meaning: Meaning, whole: Mention
    ) -> Meaning | None:
        """How what is at a part of a thing stands to it."""
        loose, self.guessed = self.guessed, False
        both = _are_both(said)
        kind = relation_at(said.value, subjects[-1].noun if subjects else noun, whole)
        four = kind == "around" and said.value == "side" and not said.count and "square" in whole.attributes
        times = (_ALL_SIDES if four else _SIDES) if said.det == "each" or where.word == "per" else 1
        self.ended = whole if said.value == "end" else self.ended
        kind = self._long_side(kind, said, whole, subjects, noun)
        loose |= kind == "on" and said.value in ("end", *_CORNERS)
        if kind == "around" and both and subjects and _line_two_sides(subjects[-1], said, whole):
            kind = "at_long_side"
        sides = said.count or (_ALL_SIDES if said.det == "all" and said.plural else 0)
        if said.value == "side" and sides > _SIDES and not (is_small(whole) or meaning.each):
            return self._around_all(sides, meaning, subjects)
        if kind == "around" and said.value == "side" and (_is_one(said) or (said.det == "other" and not said.plural)):
            kind = _at_one_side(said, whole)
            loose |= kind == "at"
        far = where.word == "opposite" and said.value in _FAR_PARTS and said.det == "the" and not said.plural
        if said.value == "in_shelf" or far:
            kind = "opposite" if far else kind
            return Meaning(kind, meaning.anchors, each=meaning.each, told=meaning.told, loose=True)
        kind = where.word if _is_at_end(where, said) else kind
        lying = is_small(subjects[-1]) if subjects else is_small_name(noun)
        if where.word == "on" and kind == "next_to" and lying and any(w in said.text.lower() for w in ("edge", "rim")):
            return Meaning("on", meaning.anchors, each=meaning.each, told=meaning.told, loose=True)
        part = self._side_of_top(where, said, kind, subjects[-1].noun if subjects else noun, whole)
        kind, loose = ("on", not part) if part is not None else (kind, loose)
        return Meaning(
            kind,
            meaning.anchors,
            each=meaning.each,
            both=both,
            times=times,
            told=meaning.told,
            loose=loose,
            part=part or "",
        )

    def _side_of_top(self, where: Where, said: Noun, kind: str, name: str, whole: Mention) -> str | None:
        """At which side of a top something lies, "" where it cannot be told; None for what does not lie there."""
        at_end = kind == "on" and said.value == "end" and (_are_both(said) or _is_one(said))
        if not at_end and not self._lies_at_side(where, said, name, whole):
            return None
        part = "both" if _are_both(said) else "left" if _is_one(said) else said.value
        return part if part == "both" or set(part.split()) <= set(SIDES) else ""

    def _long_side(self, kind: str, side: Noun, whole: Mention, subjects: list[Mention], noun: str) -> str:
        """How seats on "one side" and "the other" of a table stand to it: these are its long ones."""
        habits, name = load_habits(), subjects[-1].noun if subjects else noun
        seated = habits.is_in(name, "seats", "chairs") and habits.is_in(whole.noun, *_TOPS)
        if not seated or not side.text.lower().startswith(("one ", "the other", "the opposite")):
            return kind
        return {"left_of": "in_front_of", "right_of": "behind"}.get(kind, kind)

    def _around_all(self, sides: int, meaning: Meaning, subjects: list[Mention]) -> Meaning:
        """Read "benches on all four sides of the fountain": one at each at least, or so many at each."""
        for subject in subjects:
            count = subject.count or 1
            subject.count = sides * count if count < sides else count
        return Meaning("around", meaning.anchors, told=meaning.told)

    def _of_several(self, where: Where, said: Noun, subjects: list[Mention]) -> Meaning | None:
        """Read "on the other side" after "on its right", and "in the middle of them"."""
        if said.value == "side" and said.det == "other" and where.whole is None and self.sided is not None:
            side = {"left": "right", "right": "left"}[self.sided[0]]
            return Meaning(f"{side}_of", (self.sided[1],), told=True)
        if said.value == "side" and said.det == "other" and where.whole is not None and where.whole.kind == "thing":
            return self._beyond_other(where.whole, subjects)
        if self.is_other_end(said) and where.whole is None and self.ended is not None:
            name = subjects[-1].noun if subjects else ""
            kind = relation_at("end", name, self.ended)
            return Meaning(kind, (self.ended,), told=True, part="right" if kind == "on" else "")
        if said.value == "end" and said.det == "other" and (where.whole is None or where.whole.kind == "room"):
            wall = self.place.anchors[0] if self.place is not None and self.anchor is None else ""
            if isinstance(wall, str) and wall.endswith("wall"):
                return Meaning("against_wall", (ACROSS.get(wall, "opposite_wall"),))
        them = where.whole is not None and where.whole.kind == "pronoun" and where.whole.value == "them"
        if said.value == "middle" and them:
            return Meaning("between", self._several("between", subjects, ""), told=True)
        return None

    def _beyond_other(self, whole: Noun, subjects: list[Mention]) -> Meaning | None:
        """Read "on the other side of the oven" after something was said to be next to it: one is left, one right."""
        found, told = self.name.anchors(whole, subjects)
        anchor = found[0] if found and told else None
        beside = (b for b in reversed(self.referents.draft.bonds) if b.kind == "next_to" and b.anchors == (anchor,))
        first = next((b for b in beside if b.subject not in subjects and not b.implied and not b.each), None)
        if anchor is None or first is None or first.subject.many:
            return None
        first.kind = "left_of"
        return Meaning("right_of", (anchor,), told=True)

    def _lies_at_side(self, where: Where, said: Noun, name: str, whole: Mention) -> bool:
        """Whether "the left end of the desk" is a place on its top, for what usually lies there."""
        habits, words = load_habits(), said.text.lower().split()
        ends = words[-1] in ("end", "edge", "corner") or "far" in words or said.value in _CORNERS
        if said.value not in (*SIDES, "side", "end", *_CORNERS) or said.det == "other":
            return False
        if not ends and (where.word != "on" or (said.det == "my" and words[-1] not in ("side", *SHARES))):
            return False
        lies = name != "" and habits.is_in(name, "small") and not any(h.kind != "on" for h in habits.of(name))
        if lies and where.word == "on" and habits.is_in(whole.noun, "surfaces", "beds", "lounges"):
            return True
        lies |= name.startswith("any_") and habits.is_in(name, "lamps")
        lies |= where.word in ("on", "in") and ends and habits.is_in(name, "plants", "lamps")
        lies |= where.word == "on" and habits.tie(name, whole.noun) == "on"
        return lies and where.word in ("on", "at", "in") and habits.is_in(whole.noun, *_TOPS)

    def _whole(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        """What the part is a part of: a thing, or else the room."""
        if where.whole is not None:
            return self._told_whole(where.whole, said, subjects, likely, noun)
        if said.det == "my" and {self.beside[0], said.value} == {"left", "right"}:
            return Meaning(f"{said.value}_of", (self.beside[1],), told=True)
        return self._untold_whole(where, said, subjects, likely, noun)

    def _only_table(self, said: Noun, subjects: list[Mention]) -> Mention | None:
        """The one table that was named, of which seats are "at each end"."""
        habits = load_habits()
        seated = bool(subjects) and habits.is_in(subjects[-1].noun, "seats", "chairs")
        if not seated or said.value != "end" or said.det not in ("each", "either", "both"):
            return None
        tables = [t for t in self.referents.draft.things if habits.is_in(t.noun, "tables")]
        return tables[0] if len(tables) == 1 else None

    def _untold_whole(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        """What a part is of where that is not said: of what has it, of what was spoken of, or of the room."""
        if said.owner:
            found = self.referents.named(Noun("thing", said.owner, 0, 0, said.owner))
            return Meaning("on", (found,), told=True) if found else None
        if (table := self._only_table(said, subjects)) is not None and not likely:
            return Meaning("on", (table,), told=True)
        theirs = said.det == "my" and "their" in said.text.lower()
        if theirs and self.sided is not None and self.sided[1].many and self.sided[1] not in subjects:
            return Meaning("on", (self.sided[1],), told=True)
        plural = self.referents.several(subjects, "on") if said.det == "my" and "their" in said.text.lower() else ()
        if plural:
            sides = said.value in ("left", "right", "front", "back")
            return Meaning("on", plural[:1], each=plural[0].many and not sides, told=True)
        if (other := self._other_side(where, said, subjects)) is not None:
            return Meaning("on", (other,), told=True)
        if self._is_part_of_room(where, said, subjects, likely, noun):
            return self._of_room(said, subjects)
        alone = bool(subjects) and is_small(subjects[-1]) and not subjects[-1].many
        if said.value == "middle" and (owner := self._top_of_owner(subjects, likely)) is not None:
            return self._middle_of_top([owner])
        if said.value == "middle" and said.det == "the" and alone and likely and not self._is_top(likely[0]):
            return Meaning("on", self._middle_of_top(likely).anchors, told=True)
        carried = said.value in _CARRYING
        kind = "on" if carried else _WHOLE_BY.get(said.value, "")
        its = said.det == "my" and "their" not in said.text.lower()
        found = self._single(kind, subjects, likely, noun, one=its)
        guess = said.det == "the" and said.value in ("left", "right") and found not in likely
        self.guessed = guess and self._has_rivals((*subjects, found))
        if found is None:
            return self._of_room(said, subjects)
        return self._on_carrier(found, likely, carried=carried)

    def _on_carrier(self, found: Mention, likely: list[Mention], *, carried: bool) -> Meaning:
        """What is on top of a thing, or at a side of it; on each of two that flank something, of which all is told."""
        if carried and (two := self._each_of_two("on", found)).each:
            return two
        each = found.many and found.count is not None and carried and found in likely
        return Meaning("on", (found,), each=each, told=True)

    def _has_rivals(self, besides: Sequence[Mention | None]) -> bool:
        """Whether furniture of several kinds was named besides some."""
        rivals = (t for t in self.referents.draft.things if t not in besides and not is_small(t))
        return len({t.noun for t in rivals}) > 1

    def _other_side(self, where: Where, said: Noun, subjects: list[Mention]) -> Mention | None:
        """Read "one to the left of the stool, the other to the right": of what the other side was told."""
        again = said.det == "my" and (bool(subjects) or self._sides_told > 0) and not where.paired
        if self.sided is None or again or {self.sided[0], said.value} != {"left", "right"}:
            return None
        return self.sided[1] if self.sided[1] not in subjects else None

    def _told_whole(
        self, whole: Noun, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        """Read "the foot of the bed", "each side of the window", "the back of the room"."""
        if whole.rows or whole.word == "row":
            return None
        if whole.kind == "place" and whole.value in _OPENINGS and said.value in ("left", "right") and said.det == "the":
            self.sided, self.beside = None, (said.value, whole.value)
            return Meaning(f"{said.value}_of", (whole.value,))
        if whole.kind == "place" and whole.value in _OPENINGS:
            return Meaning("next_to", (whole.value,), both=said.det in ("each", "either", "both"))
        if said.value == "middle" and whole.kind == "place" and whole.value.endswith("wall"):
            return Meaning("in_centre", (whole.value,))
        if whole.kind in ("place", "room", "abstract", "people"):
            return self._of_room(said, subjects)
        found = self.of(Where("on" if said.value in _CARRYING else "next_to", whole), subjects, likely, noun)
        rows = found is not None and any(isinstance(a, Mention) and a.rows for a in found.anchors)
        return None if rows and whole.value == "each" else found

    def _is_part_of_room(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> bool:
        """Whether "the middle", "the left" without a thing are of the room."""
        if said.value in ("front", "back") and where.word in ("at", "in", "to", "along") and said.det == "the":
            return True
        before = self.place.anchors[0] if self.place is not None else ""
        walls = {ROOM_SIDES.get(said.value, ""), before} == {"left_wall", "right_wall"}
        if said.det == "the" and ({said.value, self.room_side} == {"left", "right"} or walls):
            return True
        alone = bool(subjects) and is_small(subjects[-1]) and not subjects[-1].many
        alone |= self._top_of_owner(subjects, likely) is not None
        if said.value == "middle" and said.det != "my" and not (alone and likely and self._has_top(likely)):
            return True
        if said.value == "side" and said.det in ("each", "either", "both") and self._is_beside_something(subjects):
            return False
        if said.value == "end" and said.count == 1 and subjects and not self._sits_or_lies(subjects[-1]):
            return True
        if likely or said.det == "my" or said.value not in ("middle", "side", "left", "right", "front", "back", "end"):
            return False
        here = bool(subjects) and where.word in ("on", "at") and said.value in ROOM_SIDES
        return here or not self.referents.topics or not (subjects or noun)

    def _sits_or_lies(self, thing: Mention) -> bool:
        """Whether it may be at the end of a thing rather than of the room."""
        return is_small(thing) or load_habits().is_in(thing.noun, "seats", "tables", "lamps", "plants")

    def _is_beside_something(self, subjects: list[Mention]) -> bool:
        """Whether something was named that others can flank."""
        return any(t not in subjects and not is_small(t) for t in self.referents.draft.things)

    def _of_room(self, said: Noun, subjects: list[Mention]) -> Meaning | None:
        if said.value == "middle":
            return Meaning("in_centre", ("centre",))
        if said.value == "end":
            self.anchor, self.place = None, Meaning("against_wall", ("short_wall",))
            return replace(self.place)
        self.room_side = said.value
        wall = ROOM_SIDES.get(said.value)
        if wall is None or (said.value == "front" and not subjects and not self._has_front()):
            return None
        self.referents.draft.speaks_of_front |= said.value == "front"
        hangs = self.place is not None and self.place.kind == "on" and str(self.place.anchors[0]).endswith("_wall")
        return Meaning("on" if hangs and self._may_hang(subjects) else "against_wall", (wall,))

    def _has_front(self) -> bool:
        """Whether the room has a front by itself: many sit there, or there usually is a board."""
        draft, is_in = self.referents.draft, load_habits().is_in
        board = any(is_in(usual.category, "boards") for usual in room_type(draft.room).usual)
        return board or any(t.count is not None and t.count > _FEW and is_in(t.noun, *_LOOKING) for t in draft.things)

    def _may_hang(self, subjects: list[Mention]) -> bool:
        """Whether things do not stand on the floor, or others of their kind were said to hang."""
        hung = {b.subject.noun for b in self.referents.draft.bonds if b.kind == "on"}
        return all(t.noun in hung or kind_of(t.noun).mount != "floor" for t in subjects)

    # --- places

    def _place(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        name, *walls = said.value.split()
        word = where.word
        if name == "centre" and word in ("facing", "facing_away", "far"):
            return Meaning(word, ("centre",), loose=word == "far")
        if name == "centre":
            return self._centre(where, said, subjects, likely, noun)
        each = said.each
        self.referents.draft.speaks_of_front |= name == "near_wall" and "front of" in said.text.lower()
        several = said.count if said.count and said.count > 1 else 0
        if name == "corner":
            return corner(word, said, walls, several)
        if name in _OPENINGS:
            return opening(word, name, self._gaps(said)) if said.det != "other" else None
        if name == "ceiling":
            stands = word == "under" and any(load_habits().is_in(t.noun, *_OPEN_TOPS) for t in subjects)
            hangs = word in ("on", "from", "under", "at", "to", "near") and not stands
            return Meaning("on", ("ceiling",)) if hangs else None
        if name == "floor":
            return Meaning("on", ("floor",)) if word in ("on", "in", "from") else None
        name = "short_wall" if name == "wall" and each and "end" in said.text.lower().split() else name
        meaning = wall(word, said, name, several, each=each)
        if meaning is not None and walls:
            meaning.anchors = (name, *walls)
        return meaning

    def _gaps(self, said: Noun) -> int:
        """How many windows or doors "under each window" and "by both windows" are; 0 where one is meant."""
        if not said.each and said.det not in ("both", "all"):
            return 0
        named = sum(gap.count for gap in self.referents.draft.openings if gap.kind == said.value)
        return named if named > 1 else _SIDES

    def _centre(
        self, where: Where, said: Noun, subjects: list[Mention], likely: list[Mention], noun: str
    ) -> Meaning | None:
        """In the middle of the room, of a wall, of a thing, or of its top."""
        whole = where.whole
        if said.text.lower().endswith(" of it"):
            whole = Noun("pronoun", "it", 0, 0, "it")
        if whole is not None and whole.kind == "place" and whole.value.endswith("wall"):
            return Meaning("in_centre", (whole.value,))
        if whole is not None and whole.kind in ("thing", "pronoun"):
            meaning = self.of(Where("on", whole), subjects, likely, noun)
            if meaning is not None and isinstance(meaning.anchors[0], Mention) and where.word in ("above", "under"):
                return Meaning(where.word, meaning.anchors, each=meaning.each, told=meaning.told, loose=True)
            if meaning is not None and isinstance(meaning.anchors[0], Mention):
                return Meaning("in_centre", meaning.anchors, each=meaning.each, told=meaning.told)
        small = bool(subjects) and is_small(subjects[-1]) and not subjects[-1].many
        small |= self._top_of_owner(subjects, likely) is not None
        named = bool(likely) and self._has_top(likely)
        if small and named and where.whole is None and said.text.lower().endswith(("middle", "centre", "center")):
            return self._middle_of_top(likely)
        return Meaning("in_centre", ("centre",))

    def _is_top(self, thing: Mention) -> bool:
        return load_habits().is_in(thing.noun, *_TOPS)

    def _has_top(self, likely: list[Mention]) -> bool:
        """Whether anything was named in the middle of which something can lie."""
        carrying = (*_TOPS, "surfaces", "storage", "shelves", "covers")
        soft = any(load_habits().is_in(t.noun, "beds", "lounges") for t in likely)
        return soft or any(load_habits().is_in(t.noun, *carrying) for t in (*likely, *self.referents.draft.things))

    def _middle_of_top(self, likely: list[Mention]) -> Meaning:
        """In the middle of what has a top: the likeliest, or what was named last."""
        named = (*likely, *reversed(self.referents.draft.things))
        top = next((t for t in named if load_habits().is_in(t.noun, *_TOPS)), likely[0])
        several = top.many and top.count is not None
        return Meaning("in_centre", (top,), each=several, told=True, pointed=True)

    # --- things

    def _thing(self, where: Where, said: Noun, subjects: list[Mention]) -> Meaning | None:
        if where.word in ("of", "as", "from"):
            return None
        if said.det == "no":
            return None
        anchors, told = self.name.anchors(said, subjects, denied=where.negated)
        if not anchors:
            return None
        kind = self._kind(where.word)
        if where.word == "between" and where.second is not None:
            if where.second.kind == "place":
                opening = where.second.value.split()[0]
                return Meaning("next_to" if opening in _OPENINGS else "near", anchors, told=told)
            second, _ = self.name.anchors(where.second, subjects)
            anchors = (*anchors, *second)
        each = said.each or where.word == "per" or (kind == "between" and said.plural and are_neighbours(said))
        each |= kind in _APART and said.det in ("all", "both") and said.plural and bool(subjects)
        each |= kind in _APART and said.of_known and (said.count or 0) > 1 and bool(subjects)
        each &= kind not in _APART or said.each or all(s.count in (None, 1) for s in subjects)
        if kind in ("left_of", "right_of"):
            self.sided = (kind.removesuffix("_of"), anchors[0])
        if where.text.lower() == "across" and subjects and load_habits().is_in(subjects[-1].noun, "covers", "small"):
            return None
        self.anchor, self.place = (kind, anchors[0]), None
        meaning = Meaning(kind, anchors, each=each, told=told)
        return self._fitting(meaning, subjects, word=where.word)

    def _top_of_owner(self, subjects: list[Mention], likely: list[Mention]) -> Mention | None:
        """What the subject belongs to, where that is likely meant and carries things on top."""
        owner = subjects[-1].owner if subjects else None
        return owner if owner is not None and owner in likely and self._is_top(owner) else None

    def _kind(self, word: str) -> str:
        return _NAMED.get(word, word)

    def of_each(self, meaning: Meaning, subjects: list[Mention]) -> Meaning:
        """What "per desk", or "on four of the desks", told before its subjects, means for them."""
        meant = self._fitting(replace(meaning), subjects)
        some = meant.anchors[0] if len(meant.anchors) == 1 else None
        if isinstance(some, Mention) and some.many and some.count is not None and self.referents.is_apart(some):
            meant.each |= bool(subjects) and subjects[-1].count == 1 and meant.kind in ("on", "inside", "at")
        return meant

    def _fitting(self, meaning: Meaning, subjects: list[Mention], noun: str = "", word: str = "") -> Meaning:
        """The relation that a general word like "at", "in" or "per" stands for between these two."""
        anchor = meaning.anchors[0]
        if isinstance(anchor, str):
            return meaning
        habits = load_habits()
        name = subjects[-1].noun if subjects else noun
        usual = habits.tie(name, anchor.noun) if name else None
        if meaning.kind == "at":
            seated = (
                "around" if habits.is_in(anchor.noun, "tables") else "at" if habits.is_in(name, "seats") else "next_to"
            )
            lies = usual == "on" and is_small_name(name)
            meaning.kind = usual if usual and (usual in ("at", "around") or lies) else seated if name else "at"
        elif meaning.kind in ("per", "for") and name:
            lying = "at" if habits.is_in(anchor.noun, "seats", "chairs") else "on"
            small = bool(subjects) and is_small(subjects[-1])
            meaning.assumed = not usual and not small and meaning.kind == "per"
            meaning.kind = usual or (lying if small else "next_to")
        elif meaning.kind == "inside" and name and habits.is_in(anchor.noun, *_OPEN_TOPS):
            meaning.loose |= habits.is_in(anchor.noun, "counters") and not habits.is_in(name, "built_in", "fitted")
            meaning.kind = "on"
        elif word == "on" and habits.is_in(anchor.noun, "shelves") and is_small_name(name) and _is_open(anchor):
            meaning.kind = "inside"
        return meaning


_STANDING_ALONE = ("tables", "desks", "counters", "worktops", "storage", "tops", "cases")
"""What stands on the floor and carries what is said to be on "one of them"."""


class Namer:
    """Names the things of noun phrases; the reader of clauses does it."""

    def anchors(self, noun: Noun, besides: list[Mention], *, denied: bool = False) -> tuple[tuple[Mention, ...], bool]:
        """The things that a noun phrase after a preposition means, and whether they were known."""
        raise NotImplementedError

    def another(self, thing: Mention) -> Mention:
        """One more of a kind: "a printer on one cabinet, a fax on another"."""
        raise NotImplementedError

    def some_of(self, noun: Noun, besides: list[Mention]) -> Mention | None:
        """The part of some known things that a number means."""
        raise NotImplementedError


def _is_one_of_levels(said: Noun) -> bool:
    """Whether it is one of several that are above each other in one thing: "the lower bunk"."""
    words = said.text.lower().split()
    return said.word in grammar().lists["levels_of"] and not grammar().lists["ranks"].isdisjoint(words)


def _at_place(*bonds: Bond) -> bool:
    """Whether all of these are to parts of the room."""
    return all(isinstance(anchor, str) and not bond.negated for bond in bonds for anchor in bond.anchors)


def is_seat(thing: Mention) -> bool:
    """Whether one sits on it."""
    return load_habits().is_in(thing.noun, "seats")


def _is_sat_at(thing: Mention) -> bool:
    return load_habits().is_in(thing.noun, *_TOPS) or last_word(thing) in grammar().lists["sat_at"]


def _line_two_sides(seats: Mention, sides: Noun, table: Mention) -> bool:
    """Whether several seats at each of two sides of a table mean its long sides."""
    several = (seats.count or 0) > (1 if sides.det == "each" else 3)
    return several and sides.value == "side" and not _ROUNDED & set(table.attributes)


def _at_one_side(side: Noun, table: Mention) -> str:
    """How seats on "one side" of a table, or on "the other", stand to it: at a long side, if there is one."""
    if not load_habits().is_in(table.noun, *_TOPS) or _ROUNDED & {*table.attributes}:
        return "at"
    return "in_front_of" if _is_one(side) else "behind"


def _is_at_end(where: Where, said: Noun) -> bool:
    """Whether it is "above the headboard", "under the foot"."""
    return where.word in ("above", "under", "behind") and said.value in ("head", "foot", "middle")


def _are_both(side: Noun) -> bool:
    """Whether it is "each side" or "both ends"."""
    return side.det in ("each", "either", "both") or side.count == 2 or (side.plural and side.value != "top")


def _is_one(side: Noun) -> bool:
    """Whether it is "one side"."""
    return side.count == 1 or side.text.lower().startswith("one ")


def _is_open(shelves: Mention) -> bool:
    """Whether "on" them means on their shelves, rather than on top."""
    return not load_habits().is_in(shelves.noun, "takes_books")


def is_small_name(name: str) -> bool:
    """Whether a noun means what lies or stands on other things."""
    return load_habits().is_in(name, "small")


_OPEN_TOPS = ("tables", "desks", "counters", "worktops", "beds", "lounges", "seats", "covers")
