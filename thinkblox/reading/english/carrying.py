"""Things told of by what stands on or at them: "the table on which the lamp stands is next to the sofa"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_CARRYING = ("on", "on_top", "under", "in")
_LENGTH = 6


def with_carrying(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is told by what stands on it is what the sentence goes on about: "with the lamp on it"."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        if _is_told_so(chunks[at : at + _LENGTH]):
            thing, link, which, other = chunks[at : at + _LENGTH - 2]
            it = Noun("pronoun", "it", which.start, which.end, "it")
            made += [thing, Connector("prepositions", "with", link.start, link.start, "with"), other, link, it]
            at += _LENGTH - 1
        else:
            made.append(chunks[at])
            at += 1
    return made


def _is_told_so(said: Sequence[Chunk]) -> bool:
    """Whether a thing, "on which", another thing and "stands" come, and a verb after that."""
    if len(said) < _LENGTH:
        return False
    thing, link, which, other, stands, verb = said
    things = all(isinstance(noun, Noun) and noun.kind == "thing" for noun in (thing, other))
    placed = is_link(link, "prepositions", *_CARRYING) and is_link(which, "joins", "which")
    return things and placed and is_link(stands, "verbs", "stand", "be", "hang") and is_link(verb, "verbs")
