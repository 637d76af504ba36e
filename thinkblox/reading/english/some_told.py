"""Some of what was named, of which something is told: "four chairs, the two chairs by the window are blue"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_PLACED = 3
"""So many chunks say at most where they are, before what is told of them."""


def with_some_told(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which fewer than were named are some of those; a comma before them ends what it follows."""
    made: list[Chunk] = []
    named: dict[str, set[int]] = {}
    for at, chunk in enumerate(chunks):
        count = chunk.count if isinstance(chunk, Noun) and chunk.kind == "thing" else None
        if isinstance(chunk, Noun) and count:
            some = chunk.of_known or _is_fewer(chunk, named.get(chunk.value, set()))
            if some and _is_told_of(chunks[at + 1 : at + 2 + _PLACED]):
                before = made[-1] if made else None
                chunk = chunk if chunk.of_known else replace(chunk, det="", of_known=True)
                if isinstance(before, Connector) and is_link(before, "mark", "comma"):
                    made[-1] = replace(before, value="semicolon")
            if not some:
                named.setdefault(chunk.value, set()).add(count)
        made.append(chunk)
    return made


def _is_fewer(noun: Noun, counts: set[int]) -> bool:
    """Whether it points at fewer than the so many that were named once."""
    return noun.det in ("the", "these", "those") and len(counts) == 1 and 1 < (noun.count or 0) < min(counts)


def _is_told_of(after: Sequence[Chunk]) -> bool:
    """Whether something is said of them, past where they are: "by the window are"."""
    placed = len(after) > 2 and is_link(after[0], "prepositions") and isinstance(after[1], Noun)
    return is_link(after[2 if placed else 0] if after else None, "verbs", "be")
