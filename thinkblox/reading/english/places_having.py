"""Places that have things: "each wall has two paintings" is "on each wall are two paintings"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_holding, is_link

_AT = {"corner": "in", "window": "at", "centre": "in"}
"""How what a place has stands to it; "on" for a wall, which has things by itself where it is one."""
_OCCUPIED = (
    "home to",
    "occupied by",
    "taken up by",
    "filled with",
    "filled by",
    "dominated by",
    "covered with",
    "covered by",
    "covered in",
    "adorned with",
    "decorated with",
)
"""What is said of a place for what stands there."""


def with_places_having(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what each wall, a corner or a window has is there, and what a wall is lined with."""
    made = list(chunks)
    for at in range(len(made) - 1, -1, -1):
        place, verb = made[at], chunk_at(made, at + 1)
        begins = not at or is_link(made[at - 1], "mark", "stop", "semicolon", "colon") or _goes_on(made, at)
        if not begins or not isinstance(place, Noun) or not isinstance(verb, Connector):
            continue
        lined = _lined(made, at + 1)
        having = (_word_before(place) or _word_after(made, at)) if _has(verb) else ""
        if word := _lined_before(place) if lined else having:
            made[at : at + 1 + (lined or 1)] = [
                Connector("prepositions", word, place.start, place.start, word),
                place,
                replace(verb, sort="verbs", value="stand"),
            ]
    return made


def _lined(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "is lined with", "is occupied by", "is home to" have; 0 where these do not come."""
    be, told, link = (*chunks[at : at + 3], None, None, None)[:3]
    if not is_link(be, "verbs", "be") or not isinstance(told, Connector):
        return 0
    if told.sort in ("inverses", "prepositions") and told.text.lower() in _OCCUPIED:
        return 2
    return 3 if told.text.lower() == "lined" and is_link(link, "prepositions", "with") else 0


def _lined_before(place: Noun) -> str:
    """The preposition for what is along a wall or in a corner; empty where the place is neither."""
    walls = place.kind == "place" and place.value.split()[0].endswith("wall")
    side = place.kind == "part" and place.value in ("left", "right") and place.word == "side"
    return "along" if walls else "on" if side else _word_before(place)


def _goes_on(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a second wall that has something comes: "..., and the right wall has a mirror"."""
    wall, verb = (*chunks[at : at + 2], None, None)[:2]
    place = isinstance(wall, Noun) and wall.kind == "place" and wall.definite and wall.value.endswith("wall")
    joined = is_link(chunks[at - 1], "joins", "and", "but") or is_link(chunks[at - 1], "mark", "comma")
    return place and joined and isinstance(verb, Connector) and _has(verb)


def _word_after(chunks: Sequence[Chunk], at: int) -> str:
    """The preposition for what a wall has besides what another one has."""
    return "on" if at and _goes_on(chunks, at) else ""


def _has(verb: Connector) -> bool:
    return is_holding(verb)


def _word_before(place: Noun) -> str:
    """The preposition that tells where what the place has is; empty where the place is none of these."""
    if place.kind != "place":
        return ""
    kind = place.value.split()[0]
    return _AT.get(kind, "on" if kind.endswith("wall") and place.each else "")
