"""What is told of a thing before it is named: "surrounded by six chairs, the table stands in the centre"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link

_MOST = 8
"""Most chunks of what is told first."""


def with_fronted(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the thing comes first, and what surrounds or fills it between commas after it."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        begins = not made or is_link(made[-1], "mark", "stop", "semicolon")
        comma = _comma(chunks, at) if begins and is_link(chunks[at], "inverses") else 0
        if comma:
            made += [chunks[comma + 1], chunks[comma], *chunks[at:comma], chunks[comma]]
            at = comma + 2
        else:
            made.append(chunks[at])
            at += 1
    return made


def _comma(chunks: Sequence[Chunk], at: int) -> int:
    """Where the comma is before the single thing of which it is told, which a verb follows; 0 where it is not so."""
    for end in range(at + 2, min(at + _MOST, len(chunks) - 2)):
        if is_link(chunks[end], "mark", "stop", "semicolon"):
            return 0
        thing, verb = chunks[end + 1 : end + 3]
        single = isinstance(thing, Noun) and thing.kind == "thing" and thing.det in ("a", "the") and not thing.many
        if is_link(chunks[end], "mark", "comma") and single and is_link(verb, "verbs"):
            return end
    return 0
