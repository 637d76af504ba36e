"""Places told in few words, as in notes: "bed north wall, desk SW corner", "chair: corner", "a desk for the corner"."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_SIDED = re.compile(r"(?:(?:an?|one|two|three|\d) )?(windows?|doors?) (north|south|east|west|left|right)")
_WALLS = {"north": "north_wall", "south": "south_wall", "east": "east_wall", "west": "west_wall"} | {
    side: f"{side}_wall" for side in ("left", "right")
}


def with_bare_places(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, with the word that is left out between a thing, a window or a door and its wall or corner."""
    found: list[Chunk] = []
    for chunk in chunks:
        if isinstance(chunk, Noun) and found and _is_bare(chunk) and _is_placed(found[-1]):
            word = "in" if chunk.value.startswith("corner") else "along"
            found.append(Connector("prepositions", word, chunk.start, chunk.start, word))
        found += _opening(chunk)
    for at in range(len(found) - 1, 1, -1):
        thing, link, place = found[at - 2 : at + 1]
        if not isinstance(place, Noun) or not (word := _led_by(place)) or not _is_placed(thing):
            continue
        ends = at + 1 == len(found) or is_link(found[at + 1], "mark")
        if is_link(link, "mark", "colon") and ends:
            found.insert(at, Connector("prepositions", word, place.start, place.start, word))
        elif is_link(link, "prepositions", "for"):
            word = "on" if place.value == "wall" else word
            found[at - 1] = Connector("prepositions", word, link.start, link.end, "for")
    return found


def _led_by(place: Noun) -> str:
    """The preposition of a corner, a wall or the middle of the room; empty for other places."""
    if place.kind != "place":
        return ""
    first = place.value.split()[0]
    return "in" if first in ("corner", "centre") else "against" if first.endswith("wall") else ""


def _is_bare(place: Noun) -> bool:
    """Whether it is a wall or a corner that is told by nothing else."""
    of_room = place.value.startswith("corner ") or (place.value.endswith("_wall") and place.value.count("_") == 1)
    return place.kind == "place" and of_room and not place.det and place.count is None


def _is_placed(thing: Chunk) -> bool:
    return isinstance(thing, Noun) and thing.kind in ("thing", "pronoun", "number")


def _opening(chunk: Chunk) -> Iterator[Chunk]:
    """Read "window south" as a window in the south wall."""
    told = None
    if isinstance(chunk, Noun) and chunk.kind in ("abstract", "thing"):
        told = _SIDED.fullmatch(chunk.text.lower())
    if told is None or not isinstance(chunk, Noun):
        yield chunk
        return
    name, middle = told[1], chunk.end - 1
    text, plural = chunk.text.rpartition(" ")[0], name.endswith("s")
    yield replace(chunk, kind="place", value=name.rstrip("s"), text=text, end=middle, plural=plural)
    yield Connector("prepositions", "on", middle, middle, "on")
    yield Noun("place", _WALLS[told[2]], middle, chunk.end, f"the {told[2]} wall", det="the")
