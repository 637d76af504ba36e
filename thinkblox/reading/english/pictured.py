"""Rooms that are told of by what shows them: "a photo of a kitchen", "the scene shows a bedroom"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_PLACING = ("on", "above", "over", "by", "next_to", "against", "behind", "in_front_of", "opposite", "between", "at")
"""Where pictures hang, which are then things in a room."""
_NEW = ("a", "")
_MADE = ("design", "layout", "plan", "model", "setup", "scene", "environment", "interior")
"""What is made for a room."""


def with_pictured(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the room that is shown is the room, as long as nothing was named before it."""
    made: list[Chunk] = []
    at = 2 if _is_test(chunks) else 0
    made += map(filler, chunks[:at])
    while at < len(chunks) and not (made and _names_thing(made[-1])):
        length = _picture(chunks, at)
        if not length:
            made.append(chunks[at])
        at += length or 1
    return [*made, *chunks[at:]]


def _is_test(chunks: Sequence[Chunk]) -> bool:
    """Whether the text begins with what is tested in a room: "Laundry pick-up test in a bedroom"."""
    what, test, link, room = (*chunks[:4], None, None, None, None)[:4]
    named = isinstance(what, Noun) and what.kind == "room" and not what.det and what.end == getattr(test, "start", -1)
    tested = isinstance(test, Noun) and test.kind == "abstract" and test.word in grammar().lists["tests"]
    return named and tested and is_link(link, "prepositions", "in") and isinstance(room, Noun) and room.kind == "room"


def _names_thing(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) and chunk.kind in ("thing", "room")


def _picture(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks come before the room of "a photo of a kitchen", "the scene shows one"; 0 where it does not."""
    picture, link = (*chunks[at : at + 2], None, None)[:2]
    told = isinstance(picture, Noun) and not picture.many and bool(picture.text)
    if not told or not isinstance(picture, Noun) or picture.word not in grammar().lists["depictions"]:
        return 0
    if is_link(link, "verbs", "be") and is_link(chunk_at(chunks, at + 2), "prepositions", "of"):
        return 3 if _is_room(chunk_at(chunks, at + 3)) else 0
    shows = is_link(link, "mark", "colon") or str(getattr(link, "text", "")).lower() in grammar().lists["showing_verbs"]
    of = is_link(link, "prepositions", "of") or (picture.word in _MADE and is_link(link, "prepositions", "for"))
    shows |= of and not _hangs(chunk_at(chunks, at + 3))
    return 2 if shows and _is_room(chunk_at(chunks, at + 2)) else 0


def _is_room(chunk: Chunk | None) -> bool:
    """Whether a new room of a kind that is told comes."""
    room = isinstance(chunk, Noun) and chunk.kind == "room" and chunk.value != "room"
    return room and isinstance(chunk, Noun) and chunk.det in _NEW and not chunk.many


def _hangs(after: Chunk | None) -> bool:
    """Whether it is told next where the picture itself is."""
    placed = isinstance(after, Connector) and after.sort == "prepositions" and after.value in _PLACING
    return placed or is_link(after, "verbs", "be", "stand", "hang") or is_link(after, "participles")
