"""What was named before a word of a text, by the order of the words: in which sentence, as what, and what has it."""

from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass, field
from typing import Literal

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_having, is_link, is_spatial

_PARTING = ("between", "next_to", "around")
"""How what parts or surrounds several stands to them."""
Role = Literal["head", "anchor", "member"]
"""It begins a part of the sentence; something was said to stand to it; something was said to have it."""


@dataclass
class Occurrence:
    """Where a thing was named.

    Attributes:
        noun: the phrase.
        sentence, part: in which sentence, and in which of its parts, which commas and "and" divide.
        role: as what.
        owners: what has it, the likeliest first.
        listed: it goes on with a list of what these have.
        joined: what it is joined to by "and"; `paired` where the two do not just end a list of which nothing is told.
        of: what was said to stand to it, and `link` how.
    """

    noun: Noun
    sentence: int
    part: int
    role: Role
    owners: Sequence[Noun] = ()
    listed: bool = False
    joined: Noun | None = None
    paired: bool = False
    of: Noun | None = None
    link: str = ""


@dataclass
class Survey:
    """What was named, in its order, and how far the text had come.

    Attributes:
        named: every thing that was named.
        sentence, part: where the text is; `last` part of the sentence before.
        links: where each preposition stood, and which it is, by its first token.
        topics: the first thing of each sentence.
        loose: the first tokens of things that nothing but the room has.
        spread: those of several of which something is said of each.
        having: where the last word of having stood.
        verb: the part of the sentence has a verb.
    """

    named: list[Occurrence] = field(default_factory=list)
    sentence: int = 0
    part: int = 0
    last: int = 0
    links: dict[int, tuple[int, int, str]] = field(default_factory=dict)
    topics: dict[int, Noun] = field(default_factory=dict)
    loose: set[int] = field(default_factory=set)
    spread: set[int] = field(default_factory=set)
    having: int = -1
    verb: bool = False


def survey(chunks: Iterable[Chunk], known: Container[int]) -> Survey:
    """Look over chunks; `known` are the first tokens of phrases that were taken for things."""
    surveyor = _Surveyor(known)
    for chunk in chunks:
        surveyor.take(chunk)
    return surveyor.seen


class _Surveyor:
    """Goes through chunks one by one."""

    def __init__(self, known: Container[int]) -> None:
        self.seen = Survey()
        self._known = known
        self._head: Noun | None = None
        self._last: Noun | None = None
        self._outer: Noun | None = None
        self._relative: Noun | None = None
        self._each: Noun | None = None
        self._owners: list[Noun] = []
        self._role: Role = "head"
        self._here = self._after_told = self._between = False
        self._told = self._closing = self._parted = self._anchored = self._apart = False
        self._parts = False
        self._parting: set[int] = set()
        self._link_to = ""
        self._before: Chunk | None = None
        self._beside: Chunk | None = None

    def take(self, chunk: Chunk) -> None:
        """Go past a chunk."""
        if isinstance(chunk, Noun):
            self._noun(chunk)
        elif isinstance(chunk, Connector):
            self._link(chunk)
        self._beside, self._before = self._before, chunk

    def _link(self, link: Connector) -> None:
        self.seen.verb |= link.sort == "verbs"
        if link.sort in ("mark", "joins") and isinstance(self._before, Noun) and self._before.value == "each":
            self._each = None
        match link.sort, link.value:
            case "mark", "stop":
                self._end_sentence()
            case "joins", "and" if self._between and self._anchored:
                self._role, self._between = "anchor", False
            case ("mark", _) | ("joins", "and" | "but"):
                self._end_part(link)
            case "joins", "which":
                self._outer = self._head
                self._relative = self._last if self._follows_anchor() else None
            case "inverses", value:
                self._have(link)
                self._parts = value in _PARTING
            case _ if is_having(link):
                self._have(link)
                self._parts = False
            case "prepositions", "of":
                self._role = "anchor" if self._parted else "member"
            case "prepositions", value if value == "to" or is_spatial(link):
                self._role, self._told, self._here = "anchor", True, True
                self._link_to = value
                self._between = value == "between"
                self._head = self._last if self._apart else self._head
                self.seen.links[link.start] = (self.seen.sentence, self.seen.part, value)

    def _end_sentence(self) -> None:
        self.seen.last = self.seen.part
        self.seen.sentence, self.seen.part = self.seen.sentence + 1, 0
        self._head = self._last = self._relative = None
        self._owners, self._role = [], "head"
        self._here = self._after_told = self.seen.verb = False

    def _end_part(self, link: Connector) -> None:
        clause = is_link(link, "mark", "semicolon")
        self._after_told = self._here if is_link(link, "mark") else self._after_told
        self._here = self.seen.verb = False
        self.seen.part += 2 if clause else not is_link(self._before, "mark", "comma")
        self._role = "head"
        if clause:
            self._head = self._last = None
        elif self._outer is not None and is_link(link, "mark", "comma"):
            self._head, self._outer = self._outer, None
        ended = is_link(link, "mark") and (self._told or self._closing)
        if ended or clause or (self._told and self._anchored):
            self._owners = []
        self._closing = bool(self._owners) and is_link(link, "joins", "and")

    def _have(self, link: Connector) -> None:
        """Tell what the list that begins is of: what was named last, or what the sentence says is by a known thing."""
        self._role, self._told, self.seen.having = "member", False, link.start
        last = self._last if self._anchored else None
        named = [n.noun for n in self.seen.named if last is not None and n.noun.value == last.value]
        known = last is not None and last.definite and len(named) > 1
        apart = link.value == "with" and is_link(self._before, "mark", "comma")
        outer = link.sort == "verbs" or known or apart
        owners = [self._head, self._last] if outer else [self._last, self._head]
        if self._relative is not None and link.sort == "verbs":
            owners = [self._relative, self._head]
        if self._head is not None and self._head.start in self.seen.loose and is_link(self._before, "mark", "comma"):
            owners = []
        if self._each is not None:
            owners = [self._each]
            self.seen.spread.add(self._each.start)
        self._owners = [noun for noun in owners if noun is not None]
        self._each = None

    def _follows_anchor(self) -> bool:
        """Whether what something is at was named just before, with a comma or without."""
        before = self._beside if is_link(self._before, "mark", "comma") else self._before
        named = self.seen.named[-1] if self.seen.named else None
        return named is not None and before is named.noun and named.role == "anchor"

    def _noun(self, noun: Noun) -> None:
        self._parted = self._role == "anchor" and noun.kind in ("part", "place")
        if noun.value == "each" and noun.kind == "pronoun" and self._role == "head":
            self._each = self._each_of()
        elif noun.kind == "thing" or (self._role == "head" and noun.start in self._known):
            self._name(noun)
        self._apart = noun.kind == "thing" and self._role == "head" and bool(self._owners)
        self._anchored = noun.kind == "thing" and self._role == "anchor"
        self._role = "head"

    def _each_of(self) -> Noun | None:
        """The several of which each is told: "three beds, separated by curtains, each with a lamp" are the beds."""
        several = [n for n in reversed(self.seen.named) if n.noun.many]
        first = several[0] if several else None
        if first is not None and first.noun.start in self._parting and is_link(self._before, "mark", "comma"):
            outer = [*first.owners, *(n.noun for n in several[1:])]
            return next((noun for noun in outer if noun.many), first.noun)
        return first.noun if first is not None else None

    def _name(self, noun: Noun) -> None:
        listed = self._role == "head" and bool(self._owners)
        if self._role == "member" and self._parts:
            self._parting.add(noun.start)
        owners = self._owners if self._role == "member" or listed else []
        loose = self._role == "member" and not owners
        self._role = "head" if loose else self._role
        pair = is_link(self._before, "joins", "and") and self._last is self._beside
        joined = self._last if pair else None
        paired = pair and (bool(owners) or self._after_told)
        of = (self._head or self._last) if self._role == "anchor" else None
        seen = self.seen
        link = self._link_to if self._role == "anchor" else ""
        seen.named.append(
            Occurrence(noun, seen.sentence, seen.part, self._role, owners, listed, joined, paired, of, link)
        )
        if self._role == "head":
            self._head = self._head if listed else noun
            self._relative = self._relative if listed else None
            seen.topics.setdefault(seen.sentence, noun)
            seen.loose |= {noun.start} if loose else set()
        self._last = noun
