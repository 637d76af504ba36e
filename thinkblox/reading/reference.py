"""What "it", "them", "each" and "the table" refer to."""

from collections.abc import Iterator

from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.things import are_alike
from thinkblox.reading.draft import Draft, Mention
from thinkblox.reading.phrases import Phrase

_REACH = 200
"""How many things back "the desk" can reach."""
_MEMORY = 40
"""How many things back a pronoun can reach."""
_BY_HABIT = ("on", "above", "under", "at", "around", "opposite")
"""Relations of which one can tell what has them to what."""
_CLOSE = ("on", "at", "around")
_SIDES = ("left_of", "right_of")
_ON_THE_FLOOR = ("next_to", "near", "in_front_of", "behind", "left_of", "right_of", "opposite")


class References:
    """Finds the things that pronouns and definite phrases point back to."""

    def __init__(self, draft: Draft) -> None:
        self.draft = draft
        self.pairs: list[tuple[Mention, Mention]] = []
        self.mentions: list[Mention] = []
        self.topic: Mention | None = None

    def named(self, phrase: Phrase, besides: Mention | None = None) -> Mention | None:
        """The latest thing that "the <noun>" can mean, `besides` one; None when nothing like it was mentioned."""
        word = _last_word(phrase.text)
        recent = [t for t in reversed(self.draft.things[-_REACH:]) if t is not besides or t.many]
        very = (t for t in recent if t.noun == phrase.value and _last_word(t.text) == word)
        same = (t for t in recent if t.noun == phrase.value)
        like = (t for t in recent if are_alike(t.noun, phrase.value))
        called = (t for t in recent if _last_word(t.text) == word)
        return next(very, None) or next(same, None) or next(like, None) or next(called, None)

    def called(self, phrase: Phrase) -> Mention | None:
        """The latest thing whose last word a phrase repeats: "the machines" after "two washing machines"."""
        word = _last_word(phrase.text).removesuffix("s")
        return next((t for t in reversed(self.draft.things) if _last_word(t.text).removesuffix("s") == word), None)

    def mention(self, thing: Mention) -> None:
        """Remember that a thing was spoken of just now."""
        self.mentions.append(thing)

    def single(self, subject: Mention | None, kind: str, noun: str = "") -> Mention | None:
        """What "it" means as the anchor of a relation of this kind of a subject or `noun`; None when there is nothing.

        First what such a thing usually has that relation to, then what "it" meant before in the same sentence.
        """
        noun = noun or (subject.noun if subject is not None else "")
        host = subject.host if subject is not None else None
        if noun in load_habits().group("screens") and kind == "opposite":
            noun = "tv_stand"
        if (
            host is not None
            and not (host.many and subject is not host)
            and (_fits(host, kind) or host is getattr(subject, "owner", None))
        ):
            return host
        candidates = self._recent(subject)
        usually, topic = load_habits().tie, self.topic
        for wanted in (
            lambda t: kind in _BY_HABIT and usually(noun, t.noun) == kind,
            lambda t: _fits(t, kind) and t is topic,
            lambda t: not t.many and _fits(t, kind) and not _is_small(t),
            lambda t: not _is_small(t) and _fits(t, kind),
            lambda t: True,
        ):
            if (found := next(filter(wanted, candidates), None)) is not None:
                return found
        return None

    def beside(self, subject: Mention | None, kind: str, noun: str = "") -> Mention | None:
        """As `single`, but what is carried stands for what carries it: a fridge at the end of the cabinets."""
        found = self.topic = self.single(subject, kind, noun)
        if found is None or kind not in _ON_THE_FLOOR:
            return found
        carried = any(bond.kind in _CLOSE and found.owner in bond.anchors for bond in self.draft.bonds_of(found))
        if found.owner is not None and carried and found.owner is not subject:
            found = found.owner
        if kind in _SIDES:
            return self._flanked(found, _SIDES) or found
        slight = kind == "next_to" and load_habits().is_in(found.noun, "lamps", "plants")
        return self._flanked(found, ("next_to",)) or found if slight else found

    def _flanked(self, thing: Mention, kinds: tuple[str, ...]) -> Mention | None:
        """What a thing stands at the side of: "a bed, to its left a nightstand, to its right a wardrobe"."""
        bonds = (b for b in self.draft.bonds_of(thing) if b.kind in kinds)
        return next((a for b in bonds for a in b.anchors if isinstance(a, Mention)), None)

    def several(self, subject: Mention | None, kind: str) -> tuple[Mention, ...]:
        """What "them" means: a plural thing, or two that were just related or joined."""
        for thing in self._before(subject):
            pair = next((p for p in reversed(self.pairs) if thing in p and subject not in p), None)
            if pair and (kind == "between" or not thing.many):
                return pair
            if thing.many and not (_is_small(thing) and kind in ("between", "around")):
                return (thing,)
        standing = [t for t in self._before(subject) if not _is_small(t)]
        if kind == "between" and len(standing) > 1:
            return (standing[1], standing[0])
        found = self.single(subject, kind)
        return (found,) if found is not None else ()

    def shared(self, subject: Mention | None) -> tuple[Mention, ...]:
        """What "each" shares out over: the plural thing that the subject belongs to, or the latest."""
        if subject is not None and subject.host is not None and subject.host.many:
            return (subject.host,)
        return self.several(subject, "each")

    def _recent(self, subject: Mention | None) -> list[Mention]:
        """Things but the subject, the one spoken of last first."""
        spoken = dict.fromkeys([*reversed(self.mentions[-_MEMORY:]), *reversed(self.draft.things[-_MEMORY:])])
        return [t for t in spoken if t is not subject and t in self.draft.things[-_MEMORY:]]

    def _before(self, subject: Mention | None) -> Iterator[Mention]:
        return (
            t
            for t in self._recent(subject)
            if (subject is None or t.owner is not subject) and t is not getattr(subject, "owner", None)
        )


def _last_word(text: str) -> str:
    return text.rpartition(" ")[2].casefold()


def _is_small(thing: Mention) -> bool:
    return load_habits().is_in(thing.noun, "small")


def _fits(thing: Mention, kind: str) -> bool:
    habits = load_habits()
    match kind:
        case "on":
            return habits.is_in(thing.noun, "surfaces", "beds", "lounges", "tops", "seats", "covers")
        case "at_foot_of":
            return habits.is_in(thing.noun, "beds")
    return True
