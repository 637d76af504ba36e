"""Sides of the room in few words: "the left half of the room", "and the right side has", "a door on the left"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.places import WALLS
from thinkblox.reading.english.said import is_holding, is_link

_SIDES = ("left", "right", "front", "back")
_PAIR = 2
_HAVING = ("have", "hold", "carry", "be")


def with_room_sides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which these are the walls at those sides."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        last = made[-1] if made else None
        if _is_half(chunk) and isinstance(chunk, Noun) and isinstance(last, Noun) and _is_side(last):
            made[-1] = _wall(replace(last, end=chunk.end))
        elif isinstance(chunk, Noun) and _is_side(chunk) and _has(chunks, at, made):
            made.append(_wall(chunk))
        elif isinstance(chunk, Noun) and isinstance(last, Connector) and _is_side(chunk) and _is_of_opening(chunks, at):
            made[-1:] = [replace(last, value="on"), _wall(chunk)]
        elif isinstance(chunk, Noun) and _is_side(chunk) and _is_one_of_two(chunks, at, made):
            text = f"the {chunk.value} one"
            made.append(replace(chunk, kind="number", value="", side=chunk.value, count=1, text=text))
        else:
            made.append(chunk)
    return made


def _is_side(noun: Noun) -> bool:
    return noun.kind == "part" and noun.value in _SIDES and noun.det == "the" and not noun.owner


def _is_half(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "room" and chunk.det == "half"


def _wall(side: Noun) -> Noun:
    return replace(
        side, kind="place", value=WALLS[side.value], called=f"{side.value} wall", text=f"the {side.value} wall"
    )


def _has(chunks: Sequence[Chunk], at: int, before: Sequence[Chunk]) -> bool:
    """Whether a side has something after another side of the room had, or where nothing else was named yet."""
    verb, told = (*chunks[at + 1 : at + 3], None, None)[:2]
    if is_link(verb, "verbs", "be") and not (isinstance(told, Connector) and told.sort in ("inverses", "participles")):
        return False
    begins = not before or is_link(before[-1], "mark") or is_link(before[-1], "joins", "and", "but")
    if not begins or not is_link(verb, "verbs", *_HAVING):
        return False
    named = [chunk for chunk in before if isinstance(chunk, Noun)]
    places = [noun for noun in named if noun.kind == "place" and noun.value.endswith("wall")]
    return not any(noun.kind == "thing" for noun in named) or bool(places and places[-1].value in WALLS.values())


def _is_one_of_two(chunks: Sequence[Chunk], at: int, before: Sequence[Chunk]) -> bool:
    """Whether "the left has a lamp" comes after two things were named of which there is a left one."""
    verb = chunk_at(chunks, at + 1)
    begins = not before or is_link(before[-1], "mark") or is_link(before[-1], "joins", "and", "but")
    two = (c for c in before if isinstance(c, Noun) and c.kind == "thing" and c.count == _PAIR and not c.total)
    return begins and is_holding(verb) and any(two)


def _is_of_opening(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it is where a door or window is: "the door is on the left"."""
    link = chunks[at - 1] if at else None
    led = at > 2 and is_link(chunks[at - 2], "verbs", "be")
    opening = chunks[at - 3] if led else chunks[at - 2] if at > 1 else None
    place = isinstance(opening, Noun) and opening.kind == "place" and opening.value in ("window", "door")
    whole = chunk_at(chunks, at + 1)
    return place and is_link(link, "prepositions", "on", "at", "to", "in") and not is_link(whole, "prepositions", "of")
