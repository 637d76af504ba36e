"""Ways that things face or reach: "faces north" is the north wall, "from the sofa to the TV" is between them."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.places import WALLS
from thinkblox.reading.english.said import is_link

_COMPASS = ("north", "south", "east", "west")
_REACHING = ("run", "runs", "running", "stretch", "stretches", "stretching", "extend", "extends", "extending")


def with_ways(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which such ways are to walls and things; hours of a clock are no clocks, but not understood."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        chunk = chunks[at]
        before = made[-1] if made else None
        if isinstance(chunk, Noun) and _is_compass(before, chunk):
            wall = WALLS[chunk.value]
            made.append(replace(chunk, kind="place", value=wall, called=f"{chunk.value} wall", det="the"))
        elif isinstance(chunk, Noun) and chunk.count and chunk.text.lower().endswith(_HOURS):
            start = before.start if is_link(before, "prepositions") and isinstance(before, Connector) else chunk.start
            made = made[: len(made) - (start != chunk.start)]
            made.append(Stray(start, chunk.end, chunk.text))
        elif isinstance(chunk, Connector) and _reaches(before, chunks[at : at + 4]):
            made += [replace(chunk, value="between"), chunks[at + 1]]
            made.append(Connector("joins", "and", chunks[at + 2].start, chunks[at + 2].end, "and"))
            at += 2
        elif isinstance(chunk, Connector) and _hangs_from_window(chunks, at):
            made.append(replace(chunk, value="at"))
        else:
            made.append(_seating(chunk, chunks[at + 1 : at + 2]))
        at += 1
    return made


_HOURS = ("o clock", "o'clock", "o\u2019clock", "oclock", "o clock position", "o'clock position")


def _is_compass(before: Chunk | None, noun: Noun) -> bool:
    faces = is_link(before, "verbs", "face", "face_away") or is_link(before, "prepositions", "facing", "facing_away")
    return faces and noun.kind == "abstract" and noun.value in _COMPASS


def _reaches(before: Chunk | None, said: Sequence[Chunk]) -> bool:
    """Whether "stretches from the sofa to the TV" comes."""
    reaching = isinstance(before, Connector) and before.text.lower() in _REACHING
    start, one, to, other = (*said, None, None, None, None)[:4]
    things = [c for c in (one, other) if isinstance(c, Noun) and c.kind == "thing" and c.definite and not c.many]
    return reaching and is_link(start, "prepositions", "from") and is_link(to, "prepositions", "to") and len(things) > 1


def _hangs_from_window(chunks: Sequence[Chunk], at: int) -> bool:
    window = chunk_at(chunks, at + 1)
    hung = at > 0 and (is_link(chunks[at - 1], "verbs", "hang") or is_link(chunks[at - 1], "participles", "hang"))
    place = isinstance(window, Noun) and window.kind == "place" and window.value == "window"
    return hung and place and is_link(chunks[at], "prepositions", "from")


def _seating(verb: Chunk, after: Sequence[Chunk]) -> Chunk:
    """What "accommodates" says where people or their number follow: it seats them; a thing it has."""
    people = bool(after) and isinstance(after[0], Noun) and after[0].kind in ("people", "number") and after[0].count
    accommodates = isinstance(verb, Connector) and verb.sort == "verbs" and "accommodate" in verb.text.lower()
    return replace(verb, value="seat") if people and accommodates and isinstance(verb, Connector) else verb
