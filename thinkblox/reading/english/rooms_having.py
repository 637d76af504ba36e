"""What rooms are full of or equipped with: "a classroom lined with bookshelves and filled with desks"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.said import is_link

_CENTRED = ("centred", "centered", "built", "arranged", "organised", "organized")


def with_rooms_having(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the room has all of it, rather than what it has first having the rest."""
    made: list[Chunk] = []
    of_room, at = False, 0
    chunks = _without_in_it(chunks)
    while at < len(chunks):
        last = made[-1] if made else None
        room = isinstance(last, Noun) and last.kind == "room"
        around = room and _is_around(chunks, at)
        length = 2 if around else _filling(chunks, at)
        if around:
            link = chunks[at + 1]
            made.append(Connector("prepositions", "with", link.start, link.end, "with"))
        elif not (length and of_room and is_link(last, "joins", "and")):
            made.append(chunks[at])
            length = 1
        of_room = (of_room or (room and bool(_filling(chunks, at)))) and not is_link(chunks[at], "mark", "stop")
        at += length
    return made


def _without_in_it(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks of "a bedroom with a bed in it", where the room has it: nothing else was named that could."""
    made = list(chunks)
    for at in range(len(made) - 1, 0, -1):
        within, it = (*made[at : at + 2], None)[:2]
        if not isinstance(it, Noun) or (it.kind, it.value) != ("pronoun", "it"):
            continue
        end = chunk_at(made, at + 2)
        ends = end is None or is_link(end, "mark", "stop", "semicolon", "comma")
        if not (ends and is_link(within, "prepositions", "in", "inside")):
            continue
        start = next((n + 1 for n in range(at - 1, -1, -1) if is_link(made[n], "mark", "stop", "semicolon")), 0)
        named = [chunk.kind for chunk in made[start:at] if isinstance(chunk, Noun)]
        if named == ["room", "thing"]:
            made[at : at + 2] = [filler(chunk) for chunk in made[at : at + 2]]
    return made


def _is_around(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "centred around" comes."""
    said, around = (*chunks[at : at + 2], None, None)[:2]
    return str(getattr(said, "text", "")).lower() in _CENTRED and is_link(around, "prepositions", "around")


def _filling(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "filled with", "equipped with", "lined with" have; 0 where these do not come."""
    said, link = (*chunks[at : at + 2], None, None)[:2]
    if not isinstance(said, Connector):
        return 0
    if is_link(said, "participles", "stand") and said.text.lower() == "lined":
        return 2 if is_link(link, "prepositions", "with") else 0
    full = said.sort == "inverses" and said.value in ("with", "inside", "on")
    full |= said.sort == "prepositions" and said.value == "with" and said.text.lower().endswith("ed with")
    return int(full)
