"""Places that have things: "each wall has two paintings" is "on each wall are two paintings"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_AT = {"corner": "in", "window": "at"}
"""How what a place has stands to it; "on" for a wall, which has things by itself where it is one."""


def with_places_having(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what each wall, a corner or a window has is there."""
    made = list(chunks)
    for at in range(len(made) - 1, -1, -1):
        place, verb = made[at], made[at + 1] if at + 1 < len(made) else None
        begins = not at or is_link(made[at - 1], "mark", "stop", "semicolon", "colon")
        if not begins or not isinstance(place, Noun) or not isinstance(verb, Connector) or not _has(verb):
            continue
        if word := _word_before(place):
            made[at : at + 2] = [
                Connector("prepositions", word, place.start, place.start, word),
                place,
                replace(verb, value="stand"),
            ]
    return made


def _has(verb: Connector) -> bool:
    return is_link(verb, "verbs", "have", "hold", "carry")


def _word_before(place: Noun) -> str:
    """The preposition that tells where what the place has is; empty where the place is none of these."""
    if place.kind != "place":
        return ""
    kind = place.value.split()[0]
    return _AT.get(kind, "on" if kind.endswith("wall") and place.each else "")
