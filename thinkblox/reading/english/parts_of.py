"""Parts by which a thing is named: "in the drawer of the dresser" is in it, and so is told where that stands."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.parts import SIDES
from thinkblox.reading.english.said import is_link, is_spatial

_AT_WALL = ("head", "back")
"""Ends of a thing that stand against a wall where it does."""


def with_wholes(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is in a part of a thing, or told after it of where that is, is told of the thing."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        part, whole = chunks[at], chunk_at(chunks, at + 2)
        if not isinstance(part, Noun):
            made.append(part)
            at += 1
            continue
        parted = part.word in grammar().lists["parts"] and part.value not in SIDES
        parted &= is_link(chunks[at + 1], "prepositions", "of") if whole is not None else False
        there = bool(at) and is_link(chunks[at - 1], "prepositions", "in", "on", "from")
        told = part.definite and _tells_where(chunks, at + 3)
        if _is_end_at_wall(chunks, at):
            made.append(_whole_of(part))
            at += 1
        elif part.kind == "part" and part.of_known and part.count == 1:
            made.append(replace(part, of_known=False, plural=False))  # "At one of its long sides" is at one long side.
            at += 1
        elif parted and (there or told) and isinstance(whole, Noun) and whole.kind == "thing":
            made.append(replace(whole, start=part.start))
            at += 3
        else:
            made.append(part)
            at += 1
    return made


def _tells_where(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it is told where the thing just named stands: "opposite the bed", "which stands opposite the bed"."""
    if at < len(chunks) and is_link(chunks[at], "mark", "comma"):
        at += 1
        return at < len(chunks) and is_link(chunks[at], "joins", "which")
    link = chunk_at(chunks, at)
    return is_link(link, "joins", "which") or (isinstance(link, Connector) and is_spatial(link))


def _is_end_at_wall(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a part tells at which wall the thing stands: "with the bed's head against the north wall"."""
    part = chunks[at]
    be = at + 1 < len(chunks) and is_link(chunks[at + 1], "verbs", "be", "stand")
    link, place = (*chunks[at + 1 + be : at + 3 + be], None, None)[:2]
    own = isinstance(part, Noun) and part.kind == "part" and part.value in _AT_WALL
    wall = isinstance(place, Noun) and place.kind == "place" and place.value.endswith("wall")
    return own and wall and is_link(link, "prepositions", "against", "at", "to")


def _whole_of(part: Noun) -> Noun:
    if not part.owner:
        return Noun("pronoun", "it", part.start, part.end, "it")
    text = f"the {part.owner.replace('_', ' ')}"
    return Noun("thing", part.owner, part.start, part.end, text, called=text.removeprefix("the "), det="the")
