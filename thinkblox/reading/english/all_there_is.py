"""Whatever says that nothing is there but what is named: "the only furniture is a table", "the room is empty"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.nothing_else import ANYTHING
from thinkblox.reading.english.said import is_link

_EMPTY = frozenset(("empty", "bare"))
_WITHIN = ("of", "in")
"""Prepositions of "the only piece of furniture in the room"."""


def with_all_there_is(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which that is said by "only" before what is there, or by "nothing" for what else is."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        length = _only_furniture(chunks, at)
        if length and is_link(chunk_at(chunks, at + length), "verbs", "be"):
            made.append(_said(chunks[at : at + length + 1], "only"))
            at += length + 1
        elif length and made and is_link(made[-1], "verbs", "be"):
            made[-1:] = [_said([made[-1], *chunks[at : at + length]], "nothing")]
            at += length
        elif length := _empty_room(chunks, at):
            made.append(_said(chunks[at : at + length], "nothing"))
            at += length
        else:
            made.append(chunks[at])
            at += 1
    return made


def _said(whole: Sequence[Chunk], value: str) -> Connector:
    return Connector("negations", value, whole[0].start, whole[-1].end, "only" if value == "only" else "nothing else")


def _only_furniture(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "the only piece of furniture in the room" has; 0 where it does not come."""
    first = chunks[at]
    end = at + (isinstance(first, Stray) and first.text.lower() == "the")
    if not is_link(chunk_at(chunks, end), "negations", "only"):
        return 0
    end += 1
    first_named = end
    while end < len(chunks) and _is_of_furniture(chunks[end], named=end > first_named):
        end += 1
    return end - at if end > first_named else 0


def _is_of_furniture(chunk: Chunk, *, named: bool) -> bool:
    if isinstance(chunk, Noun):
        room = named and chunk.kind == "room" and chunk.definite
        return room or (not chunk.definite and not ANYTHING.isdisjoint(chunk.text.lower().split()))
    return named and is_link(chunk, "prepositions", *_WITHIN)


def _empty_room(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "the room is empty" has; 0 where it does not come."""
    room, be = (*chunks[at : at + 2], None, None)[:2]
    if not isinstance(room, Noun) or room.kind != "room" or not room.definite or not is_link(be, "verbs", "be"):
        return 0
    end = at + 2
    while end < len(chunks) and is_link(chunks[end], "fillers"):
        end += 1
    said = chunk_at(chunks, end)
    return end + 1 - at if isinstance(said, Adjective) and not _EMPTY.isdisjoint(said.states) else 0
