"""What lies spread over something lies on it: "a blanket draped over the sofa", "toys scattered about the room"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_OVER = ("over", "across", "all over", "all across", "throughout")
_ABOUT = (*_OVER, "about", "around", "all around")
"""How far what is spread reaches over a thing, and about a room."""
_TRAYS = ("tray", "caddy", "board", "plank")
"""What lies with both ends on something."""
_STATES = ("folded",)
"""What says in what state something is as well as that it is somewhere."""
_LINING = ("line", "lines", "lining")
_ADORN = ("adorn", "grac", "decorat")
"""How verbs begin that say of things that they are there for their looks."""
_PARTS = ("arm", "armrest", "back", "edge", "side", "rim", "end", "foot", "corner", "top")
"""Parts of furniture that something hangs over."""


def with_laid(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is draped or strewn over something is on it, and about the room on its floor."""
    made = _on_floor(chunks)
    at = 1
    while at < len(made) - 1:
        link, where = made[at], made[at + 1]
        over = isinstance(link, Connector) and link.sort == "prepositions" and link.text.lower() in _ABOUT
        if over and isinstance(link, Connector) and isinstance(where, Noun):
            made[at:] = _laid(made[:at], link, where, made[at + 2 :])
        at += 1
    return _with_states(made)


def _with_states(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks in which "an ironing board folded against the wall" tells, besides where it is, that it is folded."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        thing = next((c for c in reversed(made[-2:]) if not is_link(c, "mark", "comma")), None)
        told = isinstance(chunk, Connector) and chunk.sort == "participles" and chunk.text.lower() in _STATES
        if told and isinstance(chunk, Connector) and isinstance(thing, Noun):
            made.append(Adjective(chunk.start, chunk.end, chunk.text, states=[chunk.text.lower()]))
            made += [] if is_link(chunk_at(chunks, at + 1), "mark") else [replace(chunk, start=chunk.end)]
        else:
            made.append(chunk)
    return made


def _on_floor(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "lies on the floor" for "adorns the floor"; what covers all of it is not to be had."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        floor = chunk_at(chunks, at + 1)
        adorned = isinstance(chunk, Connector) and chunk.value == "line" and chunk.text.lower().startswith(_ADORN)
        if adorned and isinstance(chunk, Connector) and isinstance(floor, Noun) and floor.value == "floor":
            made += [replace(chunk, value="stand"), Connector("prepositions", "on", floor.start, floor.start, "on")]
        elif isinstance(chunk, Connector) and isinstance(floor, Noun) and _lines_room(chunk, floor):
            made += [replace(chunk, value="stand"), Connector("prepositions", "along", floor.start, floor.start, "on")]
            made.append(Noun("place", "wall", floor.start, floor.start, "the walls", "walls", "the", plural=True))
            made.append(Connector("prepositions", "of", floor.start, floor.start, "of"))
        else:
            made.append(chunk)
    return made


def _lines_room(verb: Connector, room: Noun) -> bool:
    """Whether things line a room, as they do its walls."""
    return verb.value == "line" and verb.text.lower() in _LINING and room.kind == "room"


def _laid(before: list[Chunk], link: Connector, where: Noun, after: list[Chunk]) -> list[Chunk]:
    text, spread = link.text.lower(), _is_laid(before[-1])
    on = replace(link, value="on", text="on")
    if where.kind == "room" and spread and text in _ABOUT:
        return [on, replace(where, kind="place", value="floor"), *after]
    if text not in _OVER or (where.kind == "place" and where.value != "floor"):
        return [link, where, *after]
    if not spread and not (text == "over" and _is_soft(before)) and not (text == "across" and _is_tray(before)):
        return [link, where, *after]
    if where.word not in _PARTS:
        return [on, where, *after]
    following = after[0] if after else None
    if isinstance(following, Connector) and following.value == "of":
        return [on, *after[1:]]
    return [on, replace(where, kind="pronoun", value="it", det="", text="it"), *after]


def _is_laid(chunk: Chunk) -> bool:
    if not isinstance(chunk, Connector) or chunk.sort not in ("participles", "verbs"):
        return False
    return not grammar().lists["laid"].isdisjoint(chunk.text.lower().split())


def _is_tray(before: list[Chunk]) -> bool:
    """Whether it lies with its ends on what it reaches across: "a bath tray across the tub"."""
    said = before[-1]
    return isinstance(said, Noun) and said.kind == "thing" and said.word in _TRAYS


def _is_soft(before: list[Chunk]) -> bool:
    """Whether it hangs down over what it is on: "a coat over the chair", "a towel hangs over the rail"."""
    links = ("verbs", "participles")
    said = next((c for c in reversed(before) if not (isinstance(c, Connector) and c.sort in links)), None)
    return isinstance(said, Noun) and said.kind == "thing" and said.word in grammar().lists["drapes"]
