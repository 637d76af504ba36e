"""Questions that the writer answers: "The lamp? Behind the sofa.", and numbers told after a colon: "stools: three."."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_MOVING = ("prepositions", "participles", "mutual")
"""What says right after a question where the thing asked for is."""


def with_answers(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is asked for and told right after is one statement.

    "Lamp? Yes, one, behind the chair" becomes "one lamp behind the chair".
    """
    found: list[Chunk] = []
    at = 0
    while at < len(chunks):
        thing = chunks[at]
        found.append(thing)
        at += 1
        if isinstance(thing, Noun) and thing.kind == "thing" and _is_alone(found):
            said, at = _answered(thing, chunks, at)
            found[-1] = said
    return found


def _is_alone(found: Sequence[Chunk]) -> bool:
    """Whether the last chunk begins a sentence, fillers aside."""
    said = (c for c in islice(reversed(found), 1, None) if not (is_link(c, "fillers") or is_link(c, "joins", "and")))
    before = next(said, None)
    return before is None or is_link(before, "mark", "stop", "semicolon", "colon")


def _answered(thing: Noun, chunks: Sequence[Chunk], at: int) -> tuple[Noun, int]:
    """The thing with the number it is told to have, and where the text goes on."""
    mark = chunk_at(chunks, at)
    asked = is_link(mark, "mark") and isinstance(mark, Connector) and mark.text == "?"
    if not asked and not is_link(mark, "mark", "colon"):
        return thing, at
    end = at + 1
    while asked and end < len(chunks) and (is_link(chunks[end], "fillers") or is_link(chunks[end], "mark", "comma")):
        end += 1
    after = chunk_at(chunks, end)
    if isinstance(after, Noun) and after.kind in ("number", "pronoun") and after.count and thing.count is None:
        ends = end + 1 >= len(chunks) or is_link(chunks[end + 1], "mark", "stop", "semicolon")
        comma = end + 1 < len(chunks) and is_link(chunks[end + 1], "mark", "comma")
        placed = end + 1 + comma < len(chunks) and _places(chunks[end + 1 + comma])
        bare = not (after.attributes or after.of_known or after.ordinal or after.side)
        if bare and (ends or (asked and placed)):
            counted = replace(thing, count=after.count, plural=after.count > 1, end=after.end)
            return counted, end + 1 + (comma and placed)
    if after is not None and ((asked and _places(after)) or isinstance(after, Adjective)):
        return thing, end
    return thing, at


def _places(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and chunk.sort in _MOVING
