"""The room for "it" where nothing else was named: "a bedroom; there is a bed in it"; its parts: "the cafe's corner"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_PARTS = ("corner", "wall", "ceiling", "door", "window", "centre")


def with_room_meant(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the room in place of such a pronoun, up to the second statement that names a thing."""
    made = list(chunks)
    room: Noun | None = None
    named: Noun | None = None
    things = 0
    for at, chunk in enumerate(made):
        if is_link(chunk, "mark", "stop", "semicolon"):
            room = named or room
            if things:
                return made
        elif isinstance(chunk, Noun) and chunk.kind == "room":
            named = chunk
        elif isinstance(chunk, Noun) and chunk.kind == "thing":
            things += 1
        elif room is not None and things <= 1 and _is_in_it(made, at):
            made[at] = replace(room, start=chunk.start, end=chunk.end, det="the", text="the room", size=None)
    return made


def with_rooms_parts(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with "the corner of the bathroom" for "the bathroom's corner"."""
    made: list[Chunk] = []
    for chunk in chunks:
        room = made[-1] if made else None
        part = isinstance(chunk, Noun) and chunk.kind == "place" and not chunk.det and chunk.value in _PARTS
        if not part or not isinstance(chunk, Noun) or not isinstance(room, Noun) or room.kind != "room":
            made.append(chunk)
        elif room.end == chunk.start and (room.det or room.of_known):
            det = "a" if room.of_known else "the"
            of = Connector("prepositions", "of", chunk.end, chunk.end, "of")
            place = replace(chunk, det=det, plural=chunk.plural and not room.of_known, text=f"{det} {chunk.word}")
            made[-1:] = [place, of, replace(room, det="the", count=None, plural=False, of_known=False)]
        else:
            made.append(chunk)
    return made


def _is_in_it(chunks: Sequence[Chunk], at: int) -> bool:
    it = chunks[at]
    return (
        isinstance(it, Noun) and it.value == "it" and at > 0 and is_link(chunks[at - 1], "prepositions", "in", "inside")
    )
