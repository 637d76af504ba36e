"""Things of which there are to be none: "0 chairs", "chairs: 0", "chairs: none", "at most 0 chairs"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at, filler
from thinkblox.reading.english.grammar import grammar

_TELLING = ("colon", "dash", "open")
"""Marks between a thing and how many there are of it."""


def with_noughts(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, with "no" as the determiner of what is counted with a nought, which itself then tells nothing."""
    found = [_without_count(chunk) if isinstance(chunk, Noun) else chunk for chunk in chunks]
    for at, noun in enumerate(found):
        if isinstance(noun, Noun) and _is_countable(noun) and (length := _nought_after(found, at + 1)):
            found[at] = replace(noun, det="no")
            for said in range(at + 1, at + 1 + length):
                found[said] = filler(found[said])
            if _is_number_of(found, at - 2):
                found[at - 2 : at] = map(filler, found[at - 2 : at])
    return found


def _without_count(noun: Noun) -> Noun:
    """The noun, with "no" in place of a count of 0."""
    none = noun.most == 0 or (noun.count == 0 and noun.least is None and noun.most is None)
    if not none or noun.of_known or noun.kind not in ("thing", "place"):
        return noun
    return replace(noun, det="no", count=None, most=None)


def _is_countable(noun: Noun) -> bool:
    return noun.kind in ("thing", "place") and noun.det in ("", "no") and noun.count is None


def _nought_after(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks say after a noun that there is none of it; 0 where they do not."""
    link = chunk_at(chunks, at)
    told = isinstance(link, Connector) and link.sort == "mark" and link.value in _TELLING
    nought = chunks[at + told] if at + told < len(chunks) else None
    ends = chunks[at + told + 1] if at + told + 1 < len(chunks) else None
    if ends is not None and not (isinstance(ends, Connector) and ends.sort in ("mark", "joins", "fillers")):
        return 0
    return 1 + told if _is_nought(nought, told=told) else 0


def _is_nought(chunk: Chunk | None, *, told: bool) -> bool:
    if isinstance(chunk, Noun) and chunk.kind == "number":
        return chunk.count == 0 and not chunk.of_known
    return told and isinstance(chunk, Noun | Stray) and chunk.text.lower() in grammar().lists["noughts"]


def _is_number_of(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "number of" stands there."""
    if at < 0:
        return False
    number, link = chunks[at], chunks[at + 1]
    named = isinstance(number, Noun) and number.kind == "abstract" and number.value == "number"
    return named and isinstance(link, Connector) and link.value == "of"
