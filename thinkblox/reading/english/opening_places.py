"""Doors and windows that are told of by things: "the window is next to the bed" has the bed next to the window."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, text_of
from thinkblox.reading.english.said import is_link, names_opening

_TURNED = {
    "next_to": "next_to",
    "near": "near",
    "by": "by",
    "at": "by",
    "opposite": "opposite",
    "behind": "in_front_of",
    "above": "under",
    "in_front_of": "facing",
    "left_of": "right_of",
    "right_of": "left_of",
}
"""How a thing stands to an opening that stands so to it."""
_LEADING, _TO = ("leads", "lead", "leading", "opens", "opening", "open"), ("to", "in", "on")
_AWAY = 4
"""Chunks of "to the left of the bed"."""


def with_opening_places(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the things are told of by the openings, which stay where they are."""
    made = _with_both_sides(_walls_last(_lost(chunks)))
    at = -1
    while (at := at + 1) < len(made) - 3:
        opening, verb = made[at : at + 2]
        begins = not at or is_link(made[at - 1], "mark") or is_link(made[at - 1], "joins", "and", "but")
        if _is_there(made, at) and _is_opening(opening) and isinstance(opening, Noun) and opening.det == "a":
            sided, length = _where(made, at + 1)
            if sided in ("left_of", "right_of") and length > 1:
                verb, begins = Connector("verbs", "be", opening.end, opening.end, "is"), True
                made.insert(at + 1, verb)
        if not (begins and _is_opening(opening) and is_link(verb, "verbs", "be", "stand")):
            continue
        word, length = _where(made, at + 2)
        end = at + 2 + length
        thing = made[end] if word and end < len(made) else None
        over = end + 1 >= len(made) or is_link(made[end + 1], "mark") or is_link(made[end + 1], "joins")
        if isinstance(thing, Noun) and thing.kind == "thing" and not thing.many and over:
            link = Connector("prepositions", _TURNED[word], made[at + 2].start, made[at + 2].end)
            made[at : end + 1] = [*_asked(opening), thing, verb, link, _the(opening)]
    return made


def _walls_last(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks in which windows and doors come before their wall: "on the right wall are two windows"."""
    made = list(chunks)
    at = -1
    while (at := at + 1) < len(made) - 2:
        link, wall, verb = made[at : at + 3]
        begins = not at or is_link(made[at - 1], "mark") or is_link(made[at - 1], "joins", "and")
        walls = isinstance(wall, Noun) and wall.kind == "place" and wall.value.endswith("wall")
        if not (begins and walls and is_link(link, "prepositions", "on", "in", "along")):
            continue
        length = 2 + is_link(verb, "verbs", "be", "stand")
        opening = made[at + length] if at + length < len(made) else None
        if names_opening(opening) and (opening.det == "a" or opening.count):
            made[at : at + length + 1] = [opening, link, wall]
    return made


def _is_there(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "there is" comes before."""
    told = chunks[at - 1] if at else None
    return isinstance(told, Connector) and is_link(told, "verbs", "be") and told.text.lower().startswith("there")


def _with_both_sides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with what "to the right" is of, where the left of a window was told of before."""
    made = list(chunks)
    sided: tuple[str, Noun] | None = None
    at = -1
    while (at := at + 1) < len(made) - 1:
        link, part = made[at : at + 2]
        if is_link(link, "mark", "stop") and not is_link(part, "prepositions", "to", "on"):
            sided = None
        if not (is_link(link, "prepositions", "to", "on") and isinstance(part, Noun) and part.kind == "part"):
            continue
        of, opening = (*made[at + 2 : at + 4], None, None)[:2]
        if is_link(of, "prepositions", "of"):
            sided = (part.value, opening) if names_opening(opening) else None
        elif sided is not None and {part.value, sided[0]} == {"left", "right"}:
            again = replace(sided[1], start=part.end, end=part.end, det="the", count=None)
            made[at + 2 : at + 2] = [Connector("prepositions", "of", part.end, part.end, "of"), again]
    return made


def _asked(opening: Chunk) -> list[Chunk]:
    """What asks for an opening that is new."""
    new = isinstance(opening, Noun) and opening.det == "a"
    return [opening, Connector("mark", "semicolon", opening.end, opening.end, ";")] if new else []


def _the(opening: Chunk) -> Chunk:
    return replace(opening, det="the") if isinstance(opening, Noun) else opening


def _lost(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks in which it is not understood where a door leads, and between which things a window is."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        said, link, whither = (*chunks[at : at + 3], None, None)[:3]
        led = bool(made) and _is_opening(made[-1]) and isinstance(link, Connector) and isinstance(whither, Noun)
        leads = str(getattr(said, "text", "")).lower() in _LEADING and is_link(link, "prepositions", *_TO)
        between = is_link(said, "verbs", "be", "stand") and is_link(link, "prepositions", "between")
        if led and (leads or between) and isinstance(link, Connector) and isinstance(whither, Noun):
            last = whither if leads else link
            told = [c for c in (said, link, whither if leads else None) if c is not None]
            made.append(Stray(told[0].start, last.end, text_of(told)))
            at += len(told)
        else:
            made.append(chunks[at])
            at += 1
    return made


def _is_opening(chunk: Chunk) -> bool:
    return names_opening(chunk) and chunk.det in ("a", "the") and not chunk.many


def _where(chunks: Sequence[Chunk], at: int) -> tuple[str, int]:
    """How an opening stands to a thing that is named next, and how many chunks say so; empty where it is not told."""
    link, part, of = (*chunks[at : at + _AWAY - 1], None, None, None)[: _AWAY - 1]
    if not isinstance(link, Connector) or link.sort != "prepositions":
        return "", 0
    if isinstance(part, Noun) and part.kind == "part" and part.value in ("left", "right"):
        sided = is_link(of, "prepositions", "of") and link.value in ("to", "on", "at")
        return (f"{part.value}_of", _AWAY - 1) if sided else ("", 0)
    return (link.value, 1) if link.value in _TURNED else ("", 0)
