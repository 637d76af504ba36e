"""The room for "it" where nothing else was named: "a bedroom; there is a bed in it"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link


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


def _is_in_it(chunks: Sequence[Chunk], at: int) -> bool:
    it = chunks[at]
    return (
        isinstance(it, Noun) and it.value == "it" and at > 0 and is_link(chunks[at - 1], "prepositions", "in", "inside")
    )
