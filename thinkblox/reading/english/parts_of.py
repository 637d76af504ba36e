"""Parts by which a thing is named: "in the drawer of the dresser" is in it, and so is told where that stands."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link, is_spatial


def with_wholes(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is in a part of a thing, or told after it of where that is, is told of the thing."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        part, whole = chunks[at], chunks[at + 2] if at + 2 < len(chunks) else None
        parted = isinstance(part, Noun) and part.word in grammar().lists["parts"]
        parted &= is_link(chunks[at + 1], "prepositions", "of") if whole is not None else False
        there = bool(at) and is_link(chunks[at - 1], "prepositions", "in", "on", "from")
        told = isinstance(part, Noun) and part.definite and _tells_where(chunks, at + 3)
        if parted and (there or told) and isinstance(whole, Noun) and whole.kind == "thing":
            made.append(replace(whole, start=part.start))
            at += 3
        else:
            made.append(part)
            at += 1
    return made


def _tells_where(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it is told where the thing just named stands: "opposite the bed", "which stands opposite the bed"."""
    if at < len(chunks) and is_link(chunks[at], "mark", "comma"):
        at += 1
        return at < len(chunks) and is_link(chunks[at], "joins", "which")
    link = chunks[at] if at < len(chunks) else None
    return is_link(link, "joins", "which") or (isinstance(link, Connector) and is_spatial(link))
