"""What is there for each of several people: "an office for three people with a desk and a chair for each"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_PAIR = 2


def with_lists_per_person(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the people come first, "each with a desk and a chair"."""
    made: list[Chunk] = []
    people: Noun | None = None
    at = 0
    while at < len(chunks):
        chunk = chunks[at]
        if is_link(chunk, "prepositions", "per"):
            named, length = _people(chunks, at)
            several = named if named is not None and (named.count or 0) > 1 else people
            start = _list_before(made)
            listed = sum(isinstance(chunk, Noun) for chunk in made[start:])
            shared = named is not None and listed > _PAIR  # "A sofa, a TV and a chair for each person": only the chair.
            if several is not None and length and listed and not shared:
                led = start > 0 and is_link(made[start - 1], "prepositions", "with")
                begun = start - led
                known = bool(begun) and made[begun - 1] is several
                made[begun:] = [*([] if known else _for(several, made[start])), *_each(made[start]), *made[start:]]
                at = _past(chunks, at + length, made)
                continue
        if isinstance(chunk, Noun) and chunk.kind == "people" and (chunk.count or 0) > 1:
            people = chunk
        made.append(chunk)
        at += 1
    return made


def _people(chunks: Sequence[Chunk], at: int) -> tuple[Noun | None, int]:
    """The people named after "for each (of)", if any, and how many chunks that has; 0 where things are named there."""
    length = 1 + is_link(chunk_at(chunks, at + 1), "prepositions", "of")
    named = chunk_at(chunks, at + length)
    if isinstance(named, Noun):
        return (named, length + 1) if named.kind == "people" else (None, 0)
    ends = named is None or is_link(named, "mark") or is_link(named, "joins", "and")
    return None, length if ends and length == 1 else 0


def _past(chunks: Sequence[Chunk], at: int, made: list[Chunk]) -> int:
    """Go past "and" before what is not for each, which begins another statement."""
    start = at
    while is_link(chunk_at(chunks, at), "mark", "comma") or is_link(chunk_at(chunks, at), "joins", "and"):
        at += 1
    if at > start:
        made.append(Connector("mark", "semicolon", chunks[start].start, chunks[start].end, ";"))
    return at


def _list_before(made: Sequence[Chunk]) -> int:
    """Where the list of new things begins with which the chunks end; their number where they end with another."""
    start, at = len(made), len(made)
    while at:
        thing = made[at - 1]
        if not isinstance(thing, Noun) or thing.kind != "thing" or thing.definite:
            break
        start = at = at - 1
        while at and (is_link(made[at - 1], "joins", "and") or is_link(made[at - 1], "mark", "comma")):
            at -= 1
        if at == start:
            break
    return start


def _for(people: Noun, before: Chunk) -> list[Chunk]:
    start = before.start
    return [Connector("prepositions", "for", start, start, "for"), replace(people, start=start, end=start)]


def _each(before: Chunk) -> list[Chunk]:
    start = before.start
    return [
        Connector("mark", "comma", start, start, ","),
        Noun("pronoun", "each", start, start, "each", det="each"),
        Connector("prepositions", "with", start, start, "with"),
    ]
