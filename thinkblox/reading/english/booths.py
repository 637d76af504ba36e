"""Small rooms that may stand in a larger one: "three phone booths along the wall" of an office are things in it."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from thinkblox.assets.plurals import singular
from thinkblox.reading.english.chunks import Chunk, Connector, Measured, Noun, chunk_at

_BOOTHS: Mapping[str, str] = {
    "phone_booth": "phone_booth",
    "ticket_booth": "teller_window",
    "treehouse": "playhouse",
    "cubicles": "desk_booth",
}
"""The things that these rooms are where they stand in another room."""
_NAMES = ("room", "thing")
"""What a text may begin with as its room."""
_OF_ROOM = ("with", "for", "in", "at", "of")
"""Prepositions that follow a room of which the rest tells."""


def with_booths(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, where a booth is a thing unless the text begins with it as the room."""
    first = next((at for at, chunk in enumerate(chunks) if isinstance(chunk, Noun) and chunk.kind in _NAMES), -1)
    return [chunk if at == first and _is_room(chunks, at) else _as_thing(chunk) for at, chunk in enumerate(chunks)]


def _is_room(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether what comes after a booth tells of what is in it."""
    noun, after = chunks[at], chunk_at(chunks, at + 1)
    if not isinstance(noun, Noun) or noun.many:
        return False
    if isinstance(after, Connector) and after.sort == "prepositions":
        return after.value in _OF_ROOM
    return after is None or isinstance(after, Measured) or (isinstance(after, Connector) and after.sort == "mark")


def _as_thing(chunk: Chunk) -> Chunk:
    """A booth as a thing; other chunks as they are."""
    if not isinstance(chunk, Noun) or chunk.kind != "room" or chunk.value not in _BOOTHS:
        return chunk
    many = chunk.plural or (chunk.count is None and chunk.word != chunk.text.lower().split()[-1])
    called = singular(chunk.value.replace("_", " "))
    return replace(chunk, kind="thing", value=_BOOTHS[chunk.value], called=called, plural=many)
