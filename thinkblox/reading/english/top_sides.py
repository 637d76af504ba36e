"""Corners and far ends that are of a thing and not of the room: "at its far left", "in the left corner of the desk"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link

_CARRIED = 4
"""How many chunks before its place a thing is that carries another."""
_SIDES = {"left_wall": "left", "right_wall": "right", "far_wall": "back", "near_wall": "front"}


def with_top_sides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a corner of the room that is said to be of a thing is a part of that thing."""
    return [
        _part(chunk)
        if isinstance(chunk, Noun) and (_is_of_thing(chunk, chunks[at + 1 : at + 3]) or _is_of_carrier(chunks, at))
        else chunk
        for at, chunk in enumerate(chunks)
    ]


def _is_of_carrier(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "on the far right" tells where on a desk something small is: "a desk with a printer on the far right"."""
    place = chunks[at]
    if not isinstance(place, Noun) or place.kind != "place" or not place.called.startswith("far ") or at < _CARRIED:
        return False
    link, small, having, carrier = (chunks[at - n] for n in range(1, _CARRIED + 1))
    things = isinstance(small, Noun) and isinstance(carrier, Noun) and small.kind == carrier.kind == "thing"
    had = is_link(having, "prepositions", "with") or is_link(having, "verbs", "have", "carry", "hold")
    placed = is_link(link, "prepositions", "on", "at") and place.called.split()[-1] in ("left", "right")
    return had and placed and things and isinstance(small, Noun) and load_habits().is_in(small.value, "small")


def _is_of_thing(place: Noun, after: Sequence[Chunk]) -> bool:
    if place.kind != "place" or not place.value.startswith("corner") or place.each or place.plural:
        return False
    whole = after[1] if len(after) > 1 and is_link(after[0], "prepositions", "of") else None
    return place.det == "my" or (isinstance(whole, Noun) and whole.kind in ("thing", "pronoun"))


def _part(place: Noun) -> Noun:
    sides = [_SIDES.get(wall, "") for wall in place.value.split()[1:]]
    if place.called.startswith("far ") and place.called.split()[-1] in ("left", "right"):
        sides = sides[1:]
    return replace(place, kind="part", value=" ".join(sides) if sides and all(sides) else "corner", material="")
