"""Numbers and looks that are told in a loose way: "a plant or two", "nothing fancy", "any of the desks"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun, Stray, chunk_at, filler
from thinkblox.reading.english.said import is_link

_PLAIN = frozenset("fancy fussy flashy special elaborate extravagant luxurious showy posh grand elegant".split())
"""What is denied of a room that is to be like any other."""
_SIZES = {"large", "small", "tall", "low", "wide", "narrow", "long"}
_OWN = ("hers", "his", "mine", "ours", "theirs", "yours")
_ANY = ("any", "either")


def with_rough(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which such words are said the usual way, or ask for nothing."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        if _is_or_more(chunks, at):
            made.append(_or_more(chunks[at], chunks[at + 2]))
            at += 3
        elif length := _denied_looks(chunks, at):
            made += _denied(chunks[at : at + length])
            at += length
        elif _is_own_in_brackets(chunks, at):
            made += map(filler, chunks[at : at + 2])
            at += 2
        elif length := _told_far(chunks, at):
            made.append(Stray(chunks[at].start, chunks[at + length - 1].end, "at a distance"))
            at += length
        elif _is_each_again(chunks, at):
            made.append(Stray(chunks[at].start, chunks[at + 1].end, getattr(chunks[at], "text", "")))
            at += 2
        elif _is_any_of(chunks, at):
            at += 2
        else:
            made.append(chunks[at])
            at += 1
    return made


def _is_or_more(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "a plant or two" comes."""
    one, number = chunks[at], chunk_at(chunks, at + 2)
    if not isinstance(one, Noun) or not isinstance(number, Noun) or not is_link(chunks[at + 1], "joins", "or"):
        return False
    single = one.kind == "thing" and one.det == "a" and one.count in (None, 1) and not one.plural
    plain = number.kind == "number" and not (number.attributes or number.unshown or number.of_known or number.det)
    after = chunk_at(chunks, at + 3)
    return single and plain and (number.count or 0) > 1 and not isinstance(after, Noun | Adjective)


def _or_more(one: Chunk, number: Chunk) -> Noun:
    if not isinstance(one, Noun) or not isinstance(number, Noun):
        raise TypeError
    most = number.count
    return replace(one, end=number.end, det="", count=1, least=1, most=most, plural=True)


def _denied_looks(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "nothing modern", "not too fancy" have; 0 where they do not come."""
    if not is_link(chunks[at], "negations", "nothing", "not"):
        return 0
    length = 1
    while at + length < len(chunks) and is_link(chunks[at + length], "fillers"):
        length += 1
    said, after = (*chunks[at + length : at + length + 2], None, None)[:2]
    if not isinstance(said, Adjective) or isinstance(after, Noun):
        return 0
    plain = said.text.lower() in _PLAIN
    return length + 1 if plain or (is_link(chunks[at], "negations", "nothing") and not said.states) else 0


def _denied(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Nothing of what no room needs; what is not to be large, as it is denied elsewhere; else it is not understood."""
    no, said = chunks[0], chunks[-1]
    if not isinstance(said, Adjective) or said.text.lower() in _PLAIN:
        return [filler(chunk) for chunk in chunks]
    if {*said.attributes} <= _SIZES and said.attributes:
        return [Connector("negations", "not", no.start, no.end, "not"), *chunks[1:]]
    return [Stray(no.start, said.end, f"nothing {said.text}")]


def _is_any_of(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "any of the desks" comes, which says no more of where something is not than "the desks"."""
    said = chunks[at]
    if not isinstance(said, Stray) or said.text.lower() not in _ANY or at + 2 >= len(chunks):
        return False
    noun = chunks[at + 2]
    return is_link(chunks[at + 1], "prepositions", "of") and isinstance(noun, Noun) and noun.definite


def _is_own_in_brackets(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "(hers is yellow)" comes, which tells of what was named before the bracket."""
    own = chunks[at]
    if not isinstance(own, Noun) or own.text.lower() not in _OWN or not at or at + 2 >= len(chunks):
        return False
    told = is_link(chunks[at + 1], "verbs", "be") and isinstance(chunks[at + 2], Adjective)
    return told and is_link(chunks[at - 1], "mark", "open")


def _told_far(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "at a distance of 3 m" has; 0 where it does not come."""
    if not is_link(chunks[at], "prepositions") or at + 3 >= len(chunks):
        return 0
    distance, of, length = chunks[at + 1 : at + 4]
    told = isinstance(distance, Noun) and distance.word == "distance" and is_link(of, "prepositions", "of")
    return 4 if told and isinstance(length, Measured) else 0


def _is_each_again(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "one crate each" comes after "crates of apples and pears", of which it says what each is for."""
    noun, each = chunks[at], chunk_at(chunks, at + 1)
    if not isinstance(noun, Noun) or not isinstance(each, Noun) or each.value != "each" or noun.kind != "thing":
        return False
    if noun.count != 1 or not at or not is_link(chunks[at - 1], "mark", "comma", "dash", "open"):
        return False
    ends = next((n for n in range(at - 1, -1, -1) if is_link(chunks[n], "mark", "stop", "semicolon")), -1)
    said = (c for c in chunks[ends + 1 : at] if isinstance(c, Noun) and c.kind == "thing")
    return any(c.value == noun.value and c.plural for c in said)
