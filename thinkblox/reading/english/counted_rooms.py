"""Rooms that are called after what is in them: "a four-bed ward", "a six-desk office"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import stand_in
from thinkblox.knowledge.vocabulary import name_of
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_MOST = 60
"""More than so many is no number of pieces of furniture."""


def with_furniture(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which such a room has what its name counts: "a ward with four beds"."""
    found: list[Chunk] = []
    owed: Noun | None = None
    for at, chunk in enumerate(chunks):
        found.append(chunk)
        if owed is not None:
            found += [owed, Connector("joins", "and", chunk.start, chunk.start)]
            owed = None
        elif isinstance(chunk, Noun) and (counted := next(_counted(chunk), None)) is not None:
            said, thing = counted
            chunk.unshown.remove(said)
            named = [c.value for c in chunks[at + 1 :] if isinstance(c, Noun) and c.kind == "thing"]
            if thing.called in grammar().lists["parked"] and thing.value in named:
                continue  # A two-car garage has room for two, and as many as are named.
            if any(stand_in(name).like == thing.value != name for name in named):
                continue
            if at + 1 < len(chunks) and is_link(chunks[at + 1], "prepositions", "with"):
                owed = thing
            else:
                found += [Connector("prepositions", "with", chunk.start, chunk.start), thing]
    return found


def _counted(room: Noun) -> Iterator[tuple[str, Noun]]:
    """The words of the name of a "four-bed ward" that say so, and the four beds."""
    for said in room.unshown if room.kind in ("room", "abstract", "place") else ():
        count, what = parts_counted(said)
        name = name_of([what]) if what else None
        if name is not None and 0 < count <= _MOST:
            text = said.replace("-", " ", 1)
            noun = replace(room, kind="thing", value=name.category, text=text, called=singular(what))
            yield (
                said,
                replace(noun, det="", count=count, plural=count > 1, unshown=[], attributes=[], styles=[], size=None),
            )


def parts_counted(said: str) -> tuple[int, str]:
    """How many of what a word counts: (2, "bedroom") for "two-bedroom"; 0 where it does not begin with a number."""
    number, _, what = said.partition("-")
    return (int(number) if number.isdecimal() else _number(number)), what


def _number(word: str) -> int:
    said = (value for sort, value in grammar().phrases.get((word,), ()) if sort == "count")
    return int(next(said, 0))
