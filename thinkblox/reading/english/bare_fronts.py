"""What is "in front" of what has it: "a desk with a chair in front and a bookcase behind"; no side of the room."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link


def with_bare_fronts(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what a thing has "in front" is in front of it."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        chunk, front = chunks[at], chunk_at(chunks, at + 1)
        if is_link(chunk, "prepositions", "in") and _is_bare(front) and _is_had(chunks[:at]):
            assert isinstance(front, Noun)
            made.append(Connector("prepositions", "in_front_of", chunk.start, front.start, "in front of"))
            made.append(Noun("pronoun", "it", front.start, front.end, "it"))
            at += 1
        else:
            made.append(chunk)
        at += 1
    return made


def _is_bare(front: Chunk | None) -> bool:
    return isinstance(front, Noun) and front.kind == "part" and front.text.lower() == "front"


def _is_had(before: Sequence[Chunk]) -> bool:
    """Whether a sentence so far says of the one thing that it begins with what it has, and ends with a thing."""
    stops = (n for n in range(len(before) - 1, -1, -1) if is_link(before[n], "mark", "stop", "semicolon", "colon"))
    said = before[next(stops, -1) + 1 :]
    head = next((chunk for chunk in said if isinstance(chunk, Noun) and chunk.kind == "thing"), None)
    has = any(is_link(c, "prepositions", "with") or is_link(c, "verbs", "have") for c in said[1:-1])
    listed = bool(said) and isinstance(said[-1], Noun) and said[-1].kind == "thing" and not said[-1].definite
    return has and listed and head is not None and not head.many and head is not said[-1]
