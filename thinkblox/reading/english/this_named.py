"""What "this" and "that" begin a sentence with: the thing that was named last before."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_POINTING = ("this", "that")
_PLACED = ("stand", "hang", "lie", "hold", "carry")
"""Verbs of which a thing is the subject, rather than the room or what was said."""


def with_this_named(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the name of what "this stands on a chest", "that carries a suitcase" are about."""
    made: list[Chunk] = []
    last: Noun | None = None
    for at, chunk in enumerate(chunks):
        begins = not made or is_link(made[-1], "mark", "stop", "semicolon")
        if begins and last is not None and not last.many:
            named = replace(last, start=chunk.start, det="the", count=None, attributes=[], unshown=[], states=[])
            if _points(chunk, chunk_at(chunks, at + 1), chunk_at(chunks, at + 2)):
                made.append(replace(named, end=chunk.end))
                continue
            if isinstance(chunk, Connector) and is_link(chunk, "participles", "hold", "carry"):
                said = chunk.text.lower().split()
                if said[0] in _POINTING:
                    verb = Connector("verbs", chunk.value, chunk.start + 1, chunk.end, " ".join(said[1:]))
                    made += [replace(named, end=chunk.start + 1), verb]
                    continue
        last = chunk if isinstance(chunk, Noun) and chunk.kind == "thing" else last
        made.append(chunk)
    return made


def _points(this: Chunk, verb: Chunk | None, link: Chunk | None) -> bool:
    """Whether it is a pronoun of what stands, holds or is somewhere."""
    if not isinstance(this, Noun) or this.kind != "pronoun" or this.text.lower() not in _POINTING:
        return False
    return is_link(verb, "verbs", *_PLACED) or (is_link(verb, "verbs", "be") and is_link(link, "prepositions"))
