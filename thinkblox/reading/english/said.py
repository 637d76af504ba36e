"""What the words of a text say by their order alone: where things are, what they have, and in which statement.

This is the ground of the second opinion: it knows which words stand beside which, and nothing of what the reader of
clauses made of them.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import TypeGuard

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun

_SPATIAL = frozenset(
    "on on_top above under next_to near by against along around between behind in_front_of opposite facing at in far "
    "outside left_of right_of".split()
)
"""Prepositions that say where something is."""
_ENDS = ("stop", "semicolon")
"""Marks that end a statement."""
_DOING = ("be", "stand", "hang")
"""Verbs and participles between a thing and where it is."""
_HAVING = {
    "prepositions": ("with",),
    "verbs": ("have", "hold", "carry"),
    "participles": ("hold", "carry", "inside"),
    "inverses": ("on", "inside", "with"),
}
"""Words between a thing and what it has."""
_REACH = 12
"""So many nouns back, at most, a position can be about."""
_SIDES = (["left"], ["right"])
_ASIDE = ("but", "stop")
"""Conjunctions that begin a statement of its own."""


@dataclass
class SaidPosition:
    """A preposition, what it is to, and what stands around it.

    Attributes:
        link: the preposition.
        to: the noun that follows; None for "a mirror above".
        whole: of what that noun is a part ("the left side of the bed").
        second: the other of "between A and B".
        of: what it can be about by its place, the nearest first; empty where it stands in front.
        held: whether the nearest is said to belong to what comes next.
        carried: whether it stands after what something lies on ("a lamp on a table next to the bed").
        paired: whether the clause is nothing but two things and where they are.
        joined: what the nearest is joined to by "and", or, where the position is to a named thing, what has it.
        over: nouns before that to which the nearest was said to stand ("a chair next to the bed facing ...").
        led: what comes first after it, where it stands in front.
        verb: the verb between the nouns before and the preposition.
        sides: how many sides it names ("to the left and right").
        end: the index of its last chunk.
    """

    link: Connector
    to: Noun | None = None
    whole: Noun | None = None
    second: Noun | None = None
    of: list[Noun] = field(default_factory=list)
    held: bool = False
    carried: bool = False
    paired: bool = False
    joined: list[Noun] = field(default_factory=list)
    over: list[Noun] = field(default_factory=list)
    led: Noun | None = None
    verb: Connector | None = None
    sides: int = 1
    end: int = 0

    @property
    def anchor(self) -> Noun | None:
        """What it is to, as a whole."""
        return self.whole or self.to

    @property
    def last(self) -> int:
        """The token after it."""
        nouns = [noun for noun in (self.to, self.whole, self.second) if noun is not None]
        return max([self.link.end, *(noun.end for noun in nouns)])


@dataclass
class SaidList:
    """What something is said to have: "a desk with a lamp and two mugs".

    Attributes:
        head: what has it.
        link: the word for that.
        outer: nouns before the head that may have it as well ("a bench by the bed with a blanket").
        members: what surely belongs to it.
        lying: what belongs to it if it has to lie on something, and may be a new thing of the room otherwise.
        each: "each" stands between the two, or before the head.
    """

    head: Noun
    link: Connector
    outer: list[Noun] = field(default_factory=list)
    members: list[Noun] = field(default_factory=list)
    lying: list[Noun] = field(default_factory=list)
    each: bool = False


def statements(chunks: Sequence[Chunk]) -> Iterator[list[Chunk]]:
    """The chunks of each statement, without words that only fill it."""
    said: list[Chunk] = []
    for chunk in chunks:
        if isinstance(chunk, Connector) and chunk.sort == "mark" and chunk.value in _ENDS:
            if said:
                yield said
            said = []
        elif not (isinstance(chunk, (Adjective, Measured)) or is_link(chunk, "fillers")):
            said.append(chunk)
    if said:
        yield said


def positions(said: Sequence[Chunk]) -> Iterator[SaidPosition]:
    """Where things are said to be in one statement."""
    at = 0
    while at < len(said):
        link = said[at]
        at += 1
        led = at < len(said) and is_link(said[at], "joins", "which")
        if isinstance(link, Connector) and not led and (is_spatial(link) or _leads_to_part(said, at - 1)):
            found = _position(said, at - 1, link)
            yield found
            at = found.end + 1


def parted(said: Sequence[Chunk]) -> set[int]:
    """The tokens at which several begin that are told apart right after: "eight chairs, four along each wall"."""
    found: set[int] = set()
    for at, noun in enumerate(said[:-2]):
        if isinstance(noun, Noun) and (noun.each or noun.value == "each"):
            break
        told = isinstance(noun, Noun) and noun.kind == "thing" and (noun.count or 0) > 1
        number = _noun(said, at + 2, "number")
        if told and is_link(said[at + 1], "mark") and number is not None and number.count:
            found.add(noun.start)
    return found


def possessions(said: Sequence[Chunk]) -> Iterator[SaidList]:
    """What things are said to have in one statement."""
    for at, link in enumerate(said):
        if isinstance(link, Connector) and is_having(link) and (found := _having(said, at, link)) is not None:
            yield found


def is_link(chunk: Chunk | None, sort: str, *values: str) -> bool:
    """Whether a chunk is such a word between noun phrases."""
    return isinstance(chunk, Connector) and chunk.sort == sort and (not values or chunk.value in values)


def part_start(chunks: Sequence[Chunk], at: int) -> int:
    """Where the part of a sentence begins that a chunk is in: after the mark or joining word before it."""
    while at and not is_link(chunks[at - 1], "mark") and not is_link(chunks[at - 1], "joins"):
        at -= 1
    return at


def names_opening(chunk: Chunk | None) -> TypeGuard[Noun]:
    """Whether a phrase names windows or doors."""
    return isinstance(chunk, Noun) and chunk.kind == "place" and chunk.value in ("window", "door")


def is_holding(chunk: Chunk | None) -> bool:
    """Whether it is a verb by which something has, holds or carries what comes."""
    return is_link(chunk, "verbs", *_HAVING["verbs"])


def is_spatial(link: Connector) -> bool:
    """Whether it is a preposition that says where something is."""
    return link.sort == "prepositions" and link.value in _SPATIAL


def is_having(chunk: Chunk) -> bool:
    """Whether it says that what stands before it has what comes."""
    return isinstance(chunk, Connector) and chunk.value in _HAVING.get(chunk.sort, ())


def _leads_to_part(said: Sequence[Chunk], at: int) -> bool:
    """Whether "to the left" comes."""
    return is_link(said[at], "prepositions", "to") and _noun(said, at + 1, "part") is not None


def _noun(said: Sequence[Chunk], at: int, *kinds: str) -> Noun | None:
    chunk = said[at] if 0 <= at < len(said) else None
    return chunk if isinstance(chunk, Noun) and (not kinds or chunk.kind in kinds) else None


def _link(said: Sequence[Chunk], at: int, sort: str, *values: str) -> bool:
    return 0 <= at < len(said) and is_link(said[at], sort, *values)


# --- positions


def _position(said: Sequence[Chunk], at: int, link: Connector) -> SaidPosition:
    found = SaidPosition(link, _noun(said, at + 1), end=at)
    if found.to is not None:
        found.end = at + 1
        if found.to.kind == "part" and _link(said, at + 2, "joins", "and") and at + 3 < len(said):
            other = said[at + 3]
            found.sides += isinstance(other, (Noun, Connector)) and other.text.lower().split()[-1:] in _SIDES
        part = found.to.kind in ("part", "place", "abstract")
        if part and _link(said, at + 2, "prepositions", "of") and (whole := _noun(said, at + 3)) is not None:
            found.whole, found.end = whole, at + 3
        if link.value == "between" and _link(said, found.end + 1, "joins", "and"):
            found.second = _noun(said, found.end + 2)
            found.end += 2 if found.second is not None else 0
    before = at - 1 - _goes_on(said, at, found.end)
    while _link(said, before, "verbs", *_DOING) or _link(said, before, "participles", "stand", "hang"):
        verb = said[before]
        if isinstance(verb, Connector) and verb.sort == "verbs":
            found.verb = found.verb or verb
        before -= 1
    last = before
    if found.anchor is not None and found.anchor.kind == "thing" and _is_told_apart(said, before):
        before -= 4
    if _noun(said, before) is not None:
        found.of = [*islice(_nearest(said, before, verb=found.verb is not None, loose=_is_loose(found)), _REACH)]
        found.held = before > 1 and is_having(said[before - 1]) and _noun(said, before - 2, "thing") is not None
        found.paired = _link(said, before - 1, "joins", "and") and (before < 3 or is_link(said[before - 3], "mark"))
        found.carried = before > 0 and is_link(said[before - 1], "prepositions", "on", "on_top")
        found.joined = [*islice(_joined(said, before, named=found.to is not None and found.to.kind == "thing"), _REACH)]
        found.over = [*islice(_further(said, last), _REACH)]
    elif before < 0 or is_link(said[before], "joins", "and", *_ASIDE):
        found.led = _led(said, found.end + 1)
    return found


def _goes_on(said: Sequence[Chunk], at: int, end: int) -> bool:
    """Whether "and facing it" ends, which is about what was named before."""
    return (
        _link(said, at, "prepositions", "facing") and _link(said, at - 1, "joins", "and") and not _noun(said, end + 1)
    )


def _is_told_apart(said: Sequence[Chunk], at: int) -> bool:
    """Whether what comes is about what has a thing that was placed just now: "a shelf with a toy on it by ..."."""
    pointed = at > 3 and _noun(said, at, "part", "pronoun") is not None
    link = said[at - 1] if pointed else None
    return isinstance(link, Connector) and is_spatial(link) and is_having(said[at - 3])


def _is_loose(place: SaidPosition) -> bool:
    """Whether it need not be about what stands next to it: "a desk between the beds under a window", "beside it"."""
    telling = place.link.text.lower().startswith(("nearest", "closest"))
    return place.whole is None and not telling and (place.to is None or place.to.kind in ("pronoun", "part", "place"))


def _nearest(said: Sequence[Chunk], at: int, *, verb: bool, loose: bool) -> Iterator[Noun]:
    """What words after the noun at `at` can be about: it, what has it, what it is joined to; the subject of a verb."""
    while (noun := _noun(said, at)) is not None:
        if _link(said, at - 1, "prepositions", "of") and _noun(said, at - 2) is not None:
            at -= 2
            continue
        yield noun
        at -= 1
        if _link(said, at, "joins", "and"):
            at -= 1
            if at > 0 and isinstance(before := said[at - 1], Connector) and is_spatial(before):
                return
        elif at >= 0 and (is_having(said[at]) or ((verb or loose) and _is_within(said[at]))):
            at -= 1
            at -= _noun(said, at, "pronoun") is not None and _link(said, at - 1, "mark", "comma")
        at -= not verb and _link(said, at, "mark", "comma")


def _joined(said: Sequence[Chunk], at: int, *, named: bool) -> Iterator[Noun]:
    """What the noun at `at` is joined to without a comma."""
    while at > 1 and (_link(said, at - 1, "joins", "and") or (named and is_having(said[at - 1]))):
        at -= 2
        before = said[at - 1] if at > 0 else None
        if (noun := _noun(said, at)) is None or (isinstance(before, Connector) and is_spatial(before)):
            return
        yield noun


def _is_within(chunk: Chunk) -> bool:
    """Whether a word links two nouns before the verb of one clause."""
    return isinstance(chunk, Connector) and chunk.sort in ("prepositions", "participles", "inverses")


def _led(said: Sequence[Chunk], at: int) -> Noun | None:
    """The first noun after a position that stands in front."""
    while _link(said, at, "mark", "comma") or _link(said, at, "verbs", *_DOING) or _link(said, at, "participles"):
        at += 1
    return _noun(said, at, "thing")


# --- lists


def _having(said: Sequence[Chunk], at: int, link: Connector) -> SaidList | None:
    """What has what a word of having introduces, and what that is."""
    before, each = at - 1, False
    if (word := _noun(said, before, "pronoun")) is not None and word.value == "each":
        each, before = True, before - 1
        before -= _link(said, before, "mark", "comma")
        before = next((n for n in range(before, -1, -1) if (told := _noun(said, n, "thing")) and told.many), before)
    while _noun(said, before, "pronoun", "place") is not None and isinstance(to := said[before - 1], Connector):
        if before < 2 or not is_spatial(to):
            return None
        before -= 2
    head = _noun(said, before, "thing")
    if head is None:
        return None
    each |= head.each
    members, lying = _members(said, at + 1)
    if each or link.sort == "verbs":
        members, lying = [*members, *lying], []
    return SaidList(head, link, [*islice(_further(said, before), _REACH)], members, lying, each=each)


def _further(said: Sequence[Chunk], at: int) -> Iterator[Noun]:
    """The nouns of the clause before the one at `at`, the nearest first."""
    while (at := at - 1) >= 0:
        chunk = said[at]
        if isinstance(chunk, Noun):
            yield chunk
        elif is_link(chunk, "mark") or is_link(chunk, "joins", *_ASIDE):
            return


def _members(said: Sequence[Chunk], at: int) -> tuple[list[Noun], list[Noun]]:
    """What belongs to a list that begins at `at`: what surely does, and what does if it has to lie on something."""
    listed: list[Noun] = []
    commas = False
    while (noun := _noun(said, at, "thing")) is not None:
        at += 1
        if _link(said, at, "prepositions", "of") and _noun(said, at + 1) is not None:
            at += 2
        ends = _ends(said, at)
        if not ends:
            break
        listed.append(noun)
        comma = _link(said, at, "mark", "comma")
        joined = _link(said, at + comma, "joins", "and")
        if joined and not comma:
            last = _noun(said, at + 1, "thing")
            if last is None or not _ends(said, at + 2):
                break
            return (listed[:1], [*listed[1:], last]) if commas else ([*listed, last], [])
        if not comma or joined:
            break
        commas, at = True, at + 1
    return listed[:1], []


def _ends(said: Sequence[Chunk], at: int) -> bool:
    return at >= len(said) or is_link(said[at], "mark") or is_link(said[at], "joins")
