"""Things said to be centred on others: "a bowl centred on the table" lies in the middle of its top."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_REACH = 3
"""So many chunks before a preposition, at most, "centred" stands."""


def with_centres(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is centred on a thing is in its middle."""
    found: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        told = chunk_at(chunks, at + 1)
        if isinstance(chunk, Connector) and _is_on_top(chunk, told) and _is_centred(found):
            middle = Noun("part", "middle", chunk.start, chunk.start, "the middle", det="the")
            of = Connector("prepositions", "of", chunk.start, chunk.start, "of")
            found += [replace(chunk, value="in"), middle, of]
        else:
            found.append(chunk)
    return found


def _is_on_top(link: Connector, told: Chunk | None) -> bool:
    """Whether something lies on what comes, which is no rug."""
    if not is_link(link, "prepositions", "on", "on_top") or not isinstance(told, Noun):
        return False
    if told.kind == "pronoun":
        return told.value == "it"
    return told.kind == "thing" and not load_habits().is_in(told.value, "covers")


def _is_centred(before: Sequence[Chunk]) -> bool:
    """Whether "centred" is among the words before: "placed centrally on"."""
    for chunk in reversed(before[-_REACH:]):
        if isinstance(chunk, Connector) and grammar().lists["centred"] & set(chunk.text.lower().split()):
            return True
        if not (is_link(chunk, "participles", "stand") or is_link(chunk, "fillers")):
            return False
    return False
