"""What "it", "them", "the desk", "the other one" point at."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

from thinkblox.assets import CATALOGUE, kind_of
from thinkblox.assets.palette import COLOURS, with_general
from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import stand_in
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.senses import senses_of
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.grammar import grammar

_REACH = 200
"""How many things back "the desk" can reach."""
_MEMORY = 40
"""How many things back a pronoun can reach."""
_SIDES = ("left_of", "right_of")
_STANDING = ("behind", "in_front_of", "left_of", "right_of", "next_to", "opposite", "facing")
"""Relations of furniture that are to furniture rather than to what lies on it."""
_AROUND = (*_STANDING, "near", "far", "above", "under", "")
"""Relations, and sides, of what a clause was about rather than of what was said to be there."""
FURNITURE = ("seats", "tables", "desks", "beds", "lounges", "storage", "shelves", "covers", "lamps", "counters")
"""What stands on the floor rather than on what is named after it."""
NESTED = 8
"""How deep shares of shares are multiplied out."""
_BY_HABIT = ("on", "above", "under", "at", "around", "opposite")
"""Relations of which one can tell what has them to what."""


class Referents:
    """The things of a draft in the order in which they were spoken of.

    Attributes:
        spoken: everything that was spoken of, the latest last.
        topics: what clauses were about, the latest last.
        pairs: things that were just related or joined.
        joined: the single things that "and" joined last in the clause before.
        listed: the things of which one or several are that "and" joined last in the clause before.
        two: the former and the latter, once they were spoken of as that.
        parted: what is left of several of which some were set apart.
        left: the same once the sentence has ended, until more is told of it.
        parts: what was set apart from each.
        inherited: what was said of several before some were set apart, by these.
        shared: several of which something was said of each.
        centre: what a pronoun of the clause before meant; what comes is about it rather than about what stands there.
    """

    def __init__(self, draft: Draft) -> None:
        self.draft = draft
        self.spoken: list[Mention] = []
        self.topics: list[Mention] = []
        self.pairs: list[tuple[Mention, Mention]] = []
        self.parted: Mention | None = None
        self.left: Mention | None = None
        self.joined: list[Mention] = []
        self.listed: list[Mention] = []
        self.two: list[Mention] = []
        self.parts: dict[Mention, list[Mention]] = {}
        self.inherited: dict[Mention, list[str]] = {}
        self.shared: set[Mention] = set()
        self.centre: Mention | None = None
        self.flanking: set[Mention] = set()
        self.together: dict[Mention | None, tuple[Mention, ...]] = {}
        self._whole_of: dict[Mention, Mention] = {}

    def speak(self, thing: Mention) -> None:
        """Remember that a thing was spoken of just now."""
        self.spoken.append(thing)

    def named(self, noun: Noun, besides: Sequence[Mention] = ()) -> Mention | None:
        """The latest thing that "the <noun>" can mean, `besides` some; None when nothing like it was mentioned."""
        recent = [t for t in reversed(self.draft.things[-_REACH:]) if t not in besides or t.many]
        named = _is_own_name(noun.text, noun.value) and noun.named and noun.kind == "thing"
        recent = [t for t in recent if t.asked and not (named and _is_another_kind(noun, t))]
        recent = [t for t in recent if not (_is_of_another(noun, t) or _is_one_besides(noun, t))]
        word = noun.word
        apart = grammar().lists["told_apart"]
        if word in apart:
            recent = [t for t in recent if last_word(t) in (word, "") or last_word(t) not in apart]
        looks = set(noun.attributes)
        said = [t for t in recent if looks <= with_general(t.attributes)] if looks else recent
        meant = {sense.category for sense in senses_of(noun.value)} if noun.value.startswith("any_") else ()
        basin = noun.value if noun.det == "the" and load_habits().is_in(noun.value, "built_in") else ""
        has_it = {sense.category for sense in senses_of(basin)} if basin else ()
        tests = (
            lambda t: t.noun == noun.value and last_word(t) == word,
            lambda t: t.noun in (noun.value, f"wall_{noun.value}"),
            lambda t: noun.plural and t.noun in (f"{noun.value}_kit", f"{noun.value}_set"),
            lambda t: word in (last_word(t), _head_word(t)),
            lambda t: (are_alike(t.noun, noun.value) and not _is_by_full_name(noun, t)) or t.noun in meant,
            lambda t: noun.det == "the" and not noun.unshown and stand_in(t.noun).like == noun.value,
            lambda t: any(are_alike(t.noun, category) for category in has_it),
        )
        lone = noun.det == "the" and not noun.plural and noun.count in (None, 1) and not noun.attributes
        single = [t for t in recent if not t.many and last_word(t) == word] if lone else []
        single = [t for t in single if t.noun == noun.value] or single
        if single and recent and recent[0] not in self.parts and not self.is_apart(single[0]):
            return single[0]
        several = [t for t in said if t.many and word in (last_word(t), _head_word(t))] if noun.plural else []
        if noun.det == "the" and several and not any(self.family(t)[1:] for t in said if last_word(t) == word):
            return several[0]
        shades = COLOURS.keys() & looks
        fitting = [t for t in recent if not (shades and _has_other_colour(t, shades))]
        for things in (said, fitting, recent) if noun.attributes else (recent,):
            for test in tests:
                if (found := next(filter(test, things), None)) is not None:
                    return found
        joined = (str.endswith, str.startswith) if not noun.named else (str.endswith,)
        ending = (t for t in recent if len(word) > 3 and any(test(last_word(t), word) for test in joined))
        return next((t for t in recent if t.group and t.group == word), None) or next(ending, None)

    def every(self, noun: Noun) -> list[Mention]:
        """All things that "each <noun>" or "the <nouns>" can mean."""
        first = self.named(noun)
        if first is None:
            return []
        word = noun.word
        same = [t for t in self.draft.things if t.noun == first.noun and t.asked]
        looks = [t for t in same if noun.attributes and set(noun.attributes) <= with_general(t.attributes)]
        same = looks or same
        return [t for t in same if last_word(t) in (word, last_word(first))] or [first]

    def single(
        self, subject: Mention | None, kind: str, likely: Sequence[Mention] = (), noun: str = "", *, one: bool = False
    ) -> Mention | None:
        """What "it" means as the anchor of a relation; `likely` comes before what was spoken of last.

        `one` says that it was a word for a single thing.
        """
        found = self._meant_by(subject, kind, likely, noun, one=one)
        hangs = found is not None and load_habits().is_in(found.noun, "wallpieces")
        if found is None or kind != "in_front_of" or not hangs or subject is None or is_small(subject):
            return found
        above = (a for b in self.draft.bonds_of(found) if b.kind == "above" for a in parts_of(b))
        return next((a for a in above if a is not subject), found)

    def _meant_by(
        self, subject: Mention | None, kind: str, likely: Sequence[Mention], noun: str, *, one: bool
    ) -> Mention | None:
        noun = noun or (subject.noun if subject is not None else "")
        habits = load_habits()
        names = (noun, *(t.noun for t in self._carried(subject)))
        if kind == "opposite" and any(habits.is_in(name, "screens") for name in names):
            noun = "tv_stand"
        candidates = self._candidates(subject, kind, likely, one=one)
        likely = [t for t in likely if t in candidates]
        sound = [t for t in candidates if fits(t, kind, noun)]
        usual = [t for t in sound if kind in _BY_HABIT and noun and habits.tie(noun, t.noun) == kind]
        owner = subject.owner if subject is not None else None
        if owner is not None and owner in likely and owner in sound and kind in ("on", "inside"):
            return owner
        said = [t for t in usual if t in likely] or [
            t for t in candidates[: len(likely)] if _may_be(t, likely, sound, kind, noun)
        ]
        topic = self.topics[-1] if self.topics else None
        if kind == "on" and not said and topic in sound and not habits.is_in(topic.noun, *_BARE):
            return topic
        if found := said or usual:
            return found[0]
        if kind in ("in_front_of", "behind", "facing") and habits.is_in(noun, "seats"):
            seated = [t for t in sound if habits.tie(noun, t.noun) in ("at", "around")]
            if seated:
                return seated[0]
        if kind == "under":
            sound = [t for t in sound if not habits.is_in(t.noun, "wallpieces")] or sound
        if kind != "on" and not (subject is not None and is_small(subject)):
            sound = [t for t in sound if not (is_small(t) or self._lies(t))] or sound
        return next(iter(sound or candidates), None)

    def _candidates(self, subject: Mention | None, kind: str, likely: Sequence[Mention], *, one: bool) -> list[Mention]:
        """What a pronoun can mean, the likeliest first."""
        centre = [self.centre] if self.centre is not None and kind in _AROUND else []
        found = list(dict.fromkeys([*likely, *centre, *reversed(self.topics[-3:]), *self._recent()]))
        others, kept = self.family(subject) if subject is not None else [], set(self.draft.things)
        found = [t for t in found if t not in others and t in kept]
        if subject is not None and kind in _STANDING and not is_small(subject):
            carried = self._carried(subject)
            found = [t for t in found if t not in carried and t.owner is not subject] or found
        return [t for t in found if self._may_be_one(t, subject)] or found if one else found

    def _carried(self, thing: Mention | None) -> list[Mention]:
        """What was said to lie on a thing."""
        if thing is None:
            return []
        return [b.subject for b in self.draft.bonds if b.kind == "on" and thing in b.anchors]

    def _lies(self, thing: Mention) -> bool:
        """Whether it was said to lie on another thing."""
        return any(b.kind in ("on", "inside") and parts_of(b) for b in self.draft.bonds_of(thing))

    def _may_be_one(self, thing: Mention, subject: Mention | None) -> bool:
        """Whether "it" can be said of a thing: of a single one, or of each of several that are spoken of one by one."""
        if thing in self.flanking:
            return thing in self.shared
        if not thing.many or thing in self.shared or thing.rows or thing.groups:
            return True
        return subject is not None and any(b.each and thing in b.anchors for b in self.draft.bonds_of(subject))

    def several(self, subject: Sequence[Mention], kind: str) -> tuple[Mention, ...]:
        """What "them" means: a plural thing, or two that were just related or joined."""
        for thing in self._recent():
            family = self.family(thing)
            apart = len(family) > 1 and not set(map(id, family)) & set(map(id, subject))
            if apart and (kind in ("each", "between") or not any(t.many for t in family)):
                return tuple(family)
            if thing in subject or any(thing is s.owner or thing.owner is s for s in subject):
                continue
            pair = next(
                (p for p in reversed(self.pairs) if thing in p and not set(map(id, p)) & set(map(id, subject))), None
            )
            if pair and (kind == "between" or not thing.many):
                return self._two_alike(pair, subject) if kind == "between" else self._at_both_sides(*pair)
            if thing.many and not self._is_too_low(thing, subject, kind):
                return (thing, *[p for p in self.parts.get(thing, ()) if p in self.draft.things])
        standing = [t for t in self._recent() if not is_small(t) and t not in subject]
        if kind == "between" and len(standing) > 1:
            return (standing[1], standing[0])
        return tuple(standing[:1])

    def _at_both_sides(self, subject: Mention, anchor: Mention) -> tuple[Mention, ...]:
        """What is left and right of a thing, rather than one of them and it: "one to its left and one to its right"."""
        beside = [b for b in self.draft.bonds if b.anchors == (anchor,) and b.kind in _SIDES and not b.negated]
        kinds = {b.kind for b in beside if b.subject is subject}
        others = [b.subject for b in beside if b.kind not in kinds and b.subject is not subject and not b.subject.many]
        return (others[-1], subject) if kinds and others else (subject, anchor)

    def _two_alike(self, pair: tuple[Mention, Mention], besides: Sequence[Mention]) -> tuple[Mention, ...]:
        """The two sofas of "two sofas, one here and one there, both facing the fire, a rug between them"."""
        families = (self.family(thing) for thing in pair)
        two = (f for f in families if len(f) == len(pair) and not any(t.many or t in besides for t in f))
        return tuple(next(two, pair))

    def _is_too_low(self, thing: Mention, subject: Sequence[Mention], kind: str) -> bool:
        """Whether it is small, and nothing stands so to it."""
        stands = kind in _STANDING and bool(subject) and not is_small(subject[0])
        return is_small(thing) and (kind in ("between", "around") or (stands and self._lies(thing)))

    def standing(self, besides: Sequence[Mention]) -> list[Mention]:
        """The furniture that was spoken of last, `besides` some."""
        return [t for t in self._recent() if not is_small(t) and t not in besides]

    def latest(self, number: int, besides: Sequence[Mention]) -> tuple[Mention, ...]:
        """The so many single things that were named last, in their order; nothing where one of them is several."""
        found = [t for t in self.draft.things if t.asked and t not in besides][-number:]
        return tuple(found) if len(found) == number and not any(t.many for t in found) else ()

    def last(self, subject: Sequence[Mention], *, lying: bool = False) -> Mention | None:
        """What was spoken of last, furniture before what lies on it unless that is beside something `lying` there."""
        named = [t for t in self._recent() if t not in subject]
        recent = [t for t in named if not t.many] or named
        if lying and recent:
            on_it = (b.subject for b in self.draft.bonds if b.kind == "on" and recent[0] in b.anchors)
            return recent[0] if is_small(recent[0]) else next((t for t in on_it if t in recent[1:2]), recent[0])
        return next((t for t in recent if not is_small(t)), recent[0] if recent else None)

    def both(self, subject: Sequence[Mention]) -> tuple[Mention, ...]:
        """What "both" means: two of a kind, or nothing where two others were joined since."""
        for thing in self._recent():
            alike = [t for t in self.draft.things if t.noun == thing.noun and t.asked]
            if len(alike) == 2 and not any(t.many or t in subject or is_small(t) for t in alike):
                return tuple(alike)
            family = [t for t in self.family(thing) if t not in subject]
            pair = any(thing in p and not any(is_small(t) for t in p) for p in self.pairs)
            if pair and len(family) < 2:
                return ()
            if thing not in subject and sum(self.total(t) for t in family) == 2 and not is_small(thing):
                return tuple(family)
        return ()

    def of_two(self, which: str, besides: Sequence[Mention] = ()) -> Mention | None:
        """The former or the latter of the two things that were spoken of last, `besides` some."""
        if set(self.two) <= set(self.draft.things) and self.two:
            return self.two[0] if which == "former" else self.two[1]
        recent = [t for t in dict.fromkeys(reversed(self.spoken[-_MEMORY:])) if t not in besides][:2]
        if len(recent) < 2:
            return None
        order = sorted(recent, key=self.draft.things.index) if set(recent) <= set(self.draft.things) else recent[::-1]
        if any(is_small(thing) for thing in recent):
            order = self._two_apart(besides) or self._two_joined(recent) or self._two_carried(order) or order
        self.two = order
        return order[0] if which == "former" else order[1]

    def _two_apart(self, besides: Sequence[Mention]) -> list[Mention]:
        """The two tables that were told apart last, where what lies on them was spoken of since."""
        for thing in reversed(self.spoken[-_MEMORY:]):
            family = self.family(thing)
            told = len(family) == len(("former", "latter")) and self.is_apart(thing)
            if told and not any(t in besides or is_small(t) or t.many for t in family):
                return family
        return []

    def _two_joined(self, recent: Sequence[Mention]) -> list[Mention]:
        """The vase and the bowl of "a vase and a bowl on a table"."""
        joined = [thing for thing in self.joined if thing in self.draft.things]
        two = len(joined) == len(("former", "latter")) and not set(joined).isdisjoint(recent)
        return joined if two else []

    def _two_carried(self, two: Sequence[Mention]) -> list[Mention]:
        """The vase and the bowls of "a vase and two bowls on a table", where the table was spoken of last."""
        bonds = [b for thing in two for b in self.draft.bonds_of(thing) if b.kind in ("on", "inside")]
        carrier = next((a for b in bonds for a in b.anchors if a in two), None)
        lying = [b.subject for b in self.draft.bonds if b.kind in ("on", "inside") and carrier in b.anchors]
        both = carrier is not None and len(lying) == len(two) and set(lying) <= set(self.spoken[-_MEMORY:])
        return sorted(lying, key=self.draft.things.index) if both else []

    def family(self, thing: Mention) -> list[Mention]:
        """All the parts of the several that a thing was set apart from, or that were set apart from it."""
        whole = self._whole_of.get(thing, thing)
        if whole not in self.parts or thing not in self.draft.things:
            return [thing]
        return [t for t in (*self.parts[whole], whole) if t in self.draft.things]

    def is_apart(self, thing: Mention) -> bool:
        """Whether it is some of several that were told apart."""
        return thing in self._whole_of or bool(self.parts.get(thing))

    def clan(self, thing: Mention) -> list[Mention]:
        """The same where parts were parted again: everything that was once named together."""
        while thing in self._whole_of:
            thing = self._whole_of[thing]
        found, ahead = [thing], [thing]
        while ahead:
            parts = self.parts.get(ahead.pop(), [])
            found, ahead = found + parts, ahead + parts
        return [t for t in found if t not in self.draft.dropped]

    def last_family(self) -> list[Mention]:
        """The latest things of which some were set apart from others; empty where there are none."""
        families = (self.family(t) for t in reversed(self.draft.things[-_REACH:]))
        return next((family for family in families if len(family) > 1), [])

    def part(self, whole: Mention, count: int) -> Mention:
        """Set so many of `whole` apart, with all that was said of it; the others stay `whole`."""
        self.settle(whole)
        if whole.count is None:
            whole.count = count + 1 if whole is not self.parted else count
        if count >= whole.count:
            self.parted = None
            self.speak(whole)
            return whole
        part = replace(
            whole,
            count=count,
            least=None,
            most=None,
            general=False,
            plural=count > 1,
            attributes=[*whole.attributes],
            unshown=[*whole.unshown],
            states=[*whole.states],
            per=[*whole.per],
        )
        whole.count -= count
        whole.general = False
        whole.least = None if whole.least is None else max(whole.least - count, 0)
        whole.most = None if whole.most is None else max(whole.most - count, 0)
        whole.plural = whole.count > 1
        self.draft.things.insert(self.draft.things.index(whole), part)
        self.draft.bonds += [replace(bond, subject=part) for bond in self.draft.bonds_of(whole)]
        for bond in self.draft.bonds:
            if whole in bond.anchors and bond.subject is not part:
                at = bond.anchors.index(whole)
                bond.anchors = (*bond.anchors[:at], part, *bond.anchors[at:])
        for thing in self.draft.things:
            if whole in thing.per:
                thing.per.append(part)
        self.parted = whole
        self.parts.setdefault(whole, []).append(part)
        self._whole_of[part] = whole
        self.inherited[part] = [*part.attributes]
        self.speak(part)
        return part

    def gather(self) -> None:
        """Let one that was told apart of several stand at one of the walls that these are shared out to."""
        for bond in self.draft.bonds:
            if bond.spread and bond.subject in self._whole_of and bond.subject.count == 1:
                bond.spread = 0

    def left_over(self) -> Mention | None:
        """What is left of several of which some were told of in a sentence before."""
        return self.left if self.left in self.draft.things else None

    def leave_out(self, whole: Mention, count: int) -> None:
        """Set so many of `whole` apart, of which nothing is said; the others stay `whole`."""
        self.part(whole, count)
        self.parted = None

    def total(self, thing: Mention, *, within: tuple[Mention, ...] = ()) -> int:
        """How many there are of it, shares of others multiplied out; 1 where nobody said.

        Args:
            thing: one of the draft's.
            within: what it is a share of the shares of; what is among them, or deeper than NESTED, counts once.
        """
        count, within = thing.count or 1, (*within, thing)
        for bond in self.draft.bonds_of(thing):
            anchors = parts_of(bond)
            if bond.each and anchors and thing not in anchors and len(within) <= NESTED:
                return count * sum(1 if a in within else self.total(a, within=within) for a in anchors)
        return count

    def settle(self, thing: Mention) -> None:
        """Give a thing that is so many for each of others its number."""
        each = [b for b in self.draft.bonds_of(thing) if b.each and parts_of(b) and thing not in parts_of(b)]
        if each and thing.count is not None:
            thing.count = self.total(thing)
            for bond in each:
                bond.each = False

    def _recent(self) -> list[Mention]:
        spoken = dict.fromkeys([*reversed(self.spoken[-_MEMORY:]), *reversed(self.draft.things[-_MEMORY:])])
        return [t for t in spoken if t not in self.draft.dropped]

    def plural(self) -> Iterator[Mention]:
        """Things that stand for several, the latest first."""
        return (t for t in self._recent() if t.many)


def _may_be(thing: Mention, likely: Sequence[Mention], sound: Sequence[Mention], kind: str, noun: str) -> bool:
    """Whether a likely thing is meant: the likeliest, unless it is plain that it cannot be, or one that can be it."""
    habits = load_habits()
    if kind in ("on", "inside") and habits.is_in(thing.noun, *_HANGING) and noun:
        return False
    furniture = noun != "" and habits.is_in(noun, *_FLOOR)
    if furniture and kind in (*_STANDING, "") and is_small(thing) and thing.noun in habits.known():
        return False
    if kind in ("at_foot_of", "at_long_side", "at_short_side") and thing not in sound:
        return False
    return (thing in likely[:1] and not habits.is_in(thing.noun, "lamps")) or thing in sound


def _is_of_another(noun: Noun, thing: Mention) -> bool:
    """Whether it was said to be somebody else's: her bed is not his."""
    if noun.det != "my":
        return False
    owners = grammar().lists["owners"]
    now, before = (text.partition(" ")[0].lower() for text in (noun.text, thing.text))
    return now in owners and before in owners and now != before


def _has_other_colour(thing: Mention, shades: Collection[str]) -> bool:
    """Whether a thing was told to have a colour that is none of these."""
    return any(with_general({look}).isdisjoint(shades) for look in thing.attributes if look in COLOURS)


def _is_another_kind(noun: Noun, thing: Mention) -> bool:
    """Whether a thing was called by a name of its own that differs: a dining table is not "the coffee table"."""
    return noun.value != thing.noun and _is_own_name(thing.text, thing.noun)


def _is_by_full_name(noun: Noun, thing: Mention) -> bool:
    """Whether "the projector screen" is named in full, so that no monitor is meant though both are screens."""
    full = noun.det == "the" and " " in noun.called and noun.value in CATALOGUE and noun.word != last_word(thing)
    return full and not (counts_as(thing.noun, noun.value) or counts_as(noun.value, thing.noun))


def _is_one_besides(noun: Noun, thing: Mention) -> bool:
    """Whether "the armchair" is none of six chairs, and "my own" or "the teacher's desk" none of several."""
    if not thing.many:
        return False
    if noun.det == "my" and not noun.plural and noun.text.lower().split()[1:2] == ["own"]:
        return True
    lone = noun.det == "the" and not (noun.plural or noun.ordinal or noun.side or noun.degree or noun.of_known)
    if lone and noun.count in (None, 1) and (owner := _person(noun.text)) and owner != _person(thing.text):
        return True
    own = noun.named and noun.value in CATALOGUE and noun.count in (None, 1) and last_word(thing) != noun.word
    return lone and own and noun.value != thing.noun and not counts_as(thing.noun, noun.value)


def _person(text: str) -> str:
    """Whose a thing is said to be, where that is a word for somebody: "the teacher's desk"."""
    words = (word.strip("'\u2019").partition("'")[0].partition("\u2019")[0] for word in text.lower().split())
    return next((word for word in words if grammar().knows(word, "people")), "")


def _is_own_name(text: str, value: str) -> bool:
    """Whether words are the name of one category, as "a coffee table" is and "a table" is not."""
    words = value.split("_")
    said = text.lower().split()[-2:]
    return len(said) == len(words) == 2 and words == [said[0], singular(said[1])]


def is_small(thing: Mention) -> bool:
    """Whether it lies or stands on other things."""
    return load_habits().is_in(thing.noun, "small")


def is_furniture(thing: Mention) -> bool:
    """Whether it stands on the floor by itself, so that what is listed before it need not have it."""
    return not is_small(thing) and load_habits().is_in(thing.noun, *FURNITURE, "cases")


def is_loose_lamp(thing: Mention) -> bool:
    """Whether it is a lamp of a kind that nobody made, which stands where other things do: a magnifying lamp."""
    return load_habits().is_in(thing.noun, "lamps") and kind_of(thing.noun).plain


def fits(thing: Mention, kind: str, noun: str = "") -> bool:
    """Whether a thing can be the anchor of such a relation of a `noun`."""
    habits = load_habits()
    match kind:
        case "on" | "inside":
            carries = habits.is_in(thing.noun, "surfaces", "beds", "lounges", "tops", "seats", "covers", "storage")
            return (
                carries or (noun != "" and habits.tie(noun, thing.noun) == "on") or not habits.is_in(thing.noun, *_BARE)
            )
        case "at_foot_of":
            return habits.is_in(thing.noun, "beds")
        case "in_front_of" | "behind" if noun and habits.is_in(noun, *_FLOOR):
            return not habits.is_in(thing.noun, "wallpieces")
        case "above" | "under":
            return not is_small(thing)
        case "at_long_side" | "at_short_side":
            return habits.is_in(thing.noun, "tables", "desks", "counters", "worktops")
    return True


_FLOOR = ("seats", "tables", "desks", "storage", "shelves", "beds", "lounges", "covers")
"""What stands or lies on the floor."""
_HANGING = ("lamps", "ceiling", "screens")
_BARE = ("lamps", "wallpieces", "ceiling", "plants", "small", "screens")


def parts_of(bond: Bond) -> list[Mention]:
    """The things that a bond is to."""
    return [anchor for anchor in bond.anchors if isinstance(anchor, Mention)]


def _head_word(thing: Mention) -> str:
    """The "rack" of "a rack of dumbbells"."""
    return singular(thing.text.partition(" of ")[0].rpartition(" ")[2].casefold())


def last_word(thing: Mention) -> str:
    """The singular of the last word that a thing was named by."""
    return _singular_of_last(thing.text)


@lru_cache(maxsize=4096)
def _singular_of_last(text: str) -> str:
    return singular(text.rpartition(" ")[2].casefold())
