"""Orange the colour, and not the fruit: "three chairs, orange and made of plastic", "one cup orange and one blue"."""

from collections.abc import Sequence

from thinkblox.assets.palette import COLOURS
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_TOLD = ("verbs", "prepositions", "participles", "inverses")
"""What goes on about a thing after a look between commas."""


def with_colours_meant(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a bare word that names a thing and a colour is the colour, where it tells of what was named."""
    made = list(chunks)
    for at, chunk in enumerate(made):
        if not isinstance(chunk, Noun) or not _may_be_colour(chunk):
            continue
        near = (*made[at + 2 : at + 3], *made[max(0, at - 2) : at - 1])
        if chunk.count is None and _is_between(made, at):
            made[at] = Adjective(chunk.start, chunk.end, chunk.text, [chunk.material])
        elif chunk.count is not None and any(map(_is_coloured, near)):
            told = [chunk.material]
            made[at] = Noun("number", "", chunk.start, chunk.end, chunk.text, count=chunk.count, attributes=told)
    return made


def _may_be_colour(noun: Noun) -> bool:
    bare = noun.kind == "thing" and not (noun.det or noun.plural or noun.attributes)
    return bare and noun.material in COLOURS and noun.called == noun.material


def _is_between(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it comes after a thing and a comma, and what follows goes on about that: ", orange, by the window"."""
    if at < len(("thing", ",")):
        return False
    (thing, comma), after, more = chunks[at - 2 : at], chunk_at(chunks, at + 1), chunk_at(chunks, at + 2)
    named = isinstance(thing, Noun) and thing.kind == "thing" and (bool(thing.det) or thing.count is not None)
    if not named or not is_link(comma, "mark", "comma"):
        return False
    if is_link(after, "joins", "and"):
        return isinstance(more, Adjective) or is_link(more, "fillers")
    goes_on = isinstance(more, Adjective) or (isinstance(more, Connector) and more.sort in _TOLD)
    return after is None or is_link(after, "mark", "stop") or (is_link(after, "mark", "comma") and goes_on)


def _is_coloured(chunk: Chunk) -> bool:
    """Whether it is so many of a colour: "one red"."""
    several = isinstance(chunk, Noun) and chunk.kind in ("number", "pronoun") and chunk.count is not None
    return several and isinstance(chunk, Noun) and not COLOURS.keys().isdisjoint(chunk.attributes)
