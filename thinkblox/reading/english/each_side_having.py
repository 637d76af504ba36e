"""What each of two has that stand at both sides: "on either side of the bed is a nightstand with a lamp on it"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_SIDES = ("side", "end")
_EVERY = ("each", "either", "both")
_HOLDING = ("have", "hold", "carry")


def with_each_side_having(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which each of the two is said to have it, after they are said to stand there."""
    made: list[Chunk] = []
    begun = 0
    for at, chunk in enumerate((*chunks, Connector("mark", "stop", 0, 0, "."))):
        if is_link(chunk, "mark", "stop", "semicolon"):
            made += _each_having(chunks[begun:at])
            made += chunks[at : at + 1]
            begun = at + 1
    return made


def _each_having(said: Sequence[Chunk]) -> Sequence[Chunk]:
    """A sentence, with what is had last and of each; as it is where nothing is told so."""
    side = next((n for n, chunk in enumerate(said) if n and _is_every_side(chunk)), 0)
    if not side or not is_link(said[side - 1], "prepositions"):
        return said
    if is_link(said[side - 2], "joins", "and") and side > 1:
        return [*said[: side - 1], *_each_having(said[side - 1 :])]
    verb = next((n for n, chunk in enumerate(said) if is_link(chunk, "verbs", "be", "stand")), 0)
    if side == 1 and verb > side:
        thing, rest, tail = verb + 1, said[verb + 2 :], said[:0]
    elif verb == side - 2:
        thing, rest, tail = 0, said[1:verb], said[verb:]
    else:
        return said
    noun = said[thing] if thing < len(said) else None
    if not isinstance(noun, Noun) or noun.kind != "thing" or noun.det != "a" or noun.many or not _has(rest):
        return said
    end = next((n for n, chunk in enumerate(tail) if is_link(chunk, "mark")), len(tail))
    start = rest[0].start
    each = (Connector("mark", "comma", start, start, ","), Noun("pronoun", "each", start, start, "each", det="each"))
    return [*said[: thing + 1], *tail[:end], *each, *rest, *tail[end:]]


def _is_every_side(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "part" and chunk.value in _SIDES and chunk.det in _EVERY


def _has(said: Sequence[Chunk]) -> bool:
    """Whether it begins with what tells that a thing has something: "with", "holding"."""
    return bool(said) and (is_link(said[0], "prepositions", "with") or is_link(said[0], "participles", *_HOLDING))
