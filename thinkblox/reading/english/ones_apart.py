"""What one of several has besides what each has: "each with a lamp, and a phone on the right one"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link, is_spatial


def with_ones_apart(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a statement of its own tells what is on one of several, and "only" before a thing is left out."""
    made: list[Chunk] = []
    at, each = 0, False
    while at < len(chunks):
        chunk = chunks[at]
        each = not is_link(chunk, "mark", "stop", "semicolon") and (each or _is_each(chunk))
        length = _joining(chunks, at) if each else 0
        if length and _is_on_one(chunks, at + length):
            made.append(Connector("mark", "semicolon", chunk.start, chunks[at + length - 1].end, ";"))
            at += length
        elif _is_only_of_others(chunks, at):
            at += 1
        else:
            made.append(chunk)
            at += 1
    return made


def _is_each(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "pronoun" and chunk.value == "each"


def _joining(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks ",", "and" and ", and" are; 0 where they do not come."""
    comma = is_link(chunks[at], "mark", "comma")
    joined = at + comma < len(chunks) and is_link(chunks[at + comma], "joins", "and")
    return comma + joined


def _is_on_one(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a new thing comes, and then that it is on or by the left one, or the last one."""
    thing = chunk_at(chunks, at)
    at += 2 if at + 1 < len(chunks) and is_link(chunks[at + 1], "negations", "only") else 1
    link, one = (*chunks[at : at + 2], None, None)[:2]
    new = isinstance(thing, Noun) and thing.kind == "thing" and not thing.definite
    placed = isinstance(link, Connector) and is_spatial(link)
    told = isinstance(one, Noun) and one.kind == "number" and one.det == "the" and one.count == 1
    return new and placed and told


def _is_only_of_others(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "the others only a lamp" leaves a verb out, so that "only" keeps nothing else away."""
    if not at or not is_link(chunks[at], "negations", "only"):
        return False
    others, thing = chunks[at - 1], chunk_at(chunks, at + 1)
    told = isinstance(others, Noun) and others.kind == "pronoun" and others.value == "other"
    return told and isinstance(thing, Noun) and thing.kind == "thing" and not thing.definite
