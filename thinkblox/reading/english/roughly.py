"""Numbers and looks that are told in a loose way: "a plant or two", "nothing fancy", "any of the desks"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray
from thinkblox.reading.english.said import is_link

_PLAIN = frozenset("fancy fussy flashy special elaborate extravagant luxurious showy posh grand elegant".split())
"""What is denied of a room that is to be like any other."""
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
            made += [
                Connector("fillers", "words", c.start, c.end, getattr(c, "text", "")) for c in chunks[at:][:length]
            ]
            at += length
        elif _is_any_of(chunks, at):
            at += 2
        else:
            made.append(chunks[at])
            at += 1
    return made


def _is_or_more(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "a plant or two" comes."""
    one, number = chunks[at], chunks[at + 2] if at + 2 < len(chunks) else None
    if not isinstance(one, Noun) or not isinstance(number, Noun) or not is_link(chunks[at + 1], "joins", "or"):
        return False
    single = one.kind == "thing" and one.det == "a" and one.count in (None, 1) and not one.plural
    plain = number.kind == "number" and not (number.attributes or number.unshown or number.of_known or number.det)
    after = chunks[at + 3] if at + 3 < len(chunks) else None
    return single and plain and (number.count or 0) > 1 and not isinstance(after, Noun | Adjective)


def _or_more(one: Chunk, number: Chunk) -> Noun:
    if not isinstance(one, Noun) or not isinstance(number, Noun):
        raise TypeError
    most = number.count
    return replace(one, end=number.end, det="", count=1, least=1, most=most, plural=True)


def _denied_looks(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "nothing fancy", "not too fancy" have; 0 where they do not come."""
    if not is_link(chunks[at], "negations", "nothing", "not"):
        return 0
    length = 1
    while at + length < len(chunks) and is_link(chunks[at + length], "fillers"):
        length += 1
    said = chunks[at + length] if at + length < len(chunks) else None
    return length + 1 if isinstance(said, Adjective) and said.text.lower() in _PLAIN else 0


def _is_any_of(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "any of the desks" comes, which says no more of where something is not than "the desks"."""
    said = chunks[at]
    if not isinstance(said, Stray) or said.text.lower() not in _ANY or at + 2 >= len(chunks):
        return False
    noun = chunks[at + 2]
    return is_link(chunks[at + 1], "prepositions", "of") and isinstance(noun, Noun) and noun.definite


def _filler(chunk: Chunk) -> Connector:
    return Connector("fillers", "words", chunk.start, chunk.end, getattr(chunk, "text", ""))
