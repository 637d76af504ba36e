"""What an earlier or a later word counts: "in the other two", "each child has a bed. There are three children"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_IN = ("in", "on", "at", "along", "against")
_ENDS = ("stop", "semicolon")


def with_told_later(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "the other two" are two corners or walls more, and people are counted before they have things."""
    made = list(chunks)
    for at, chunk in enumerate(made):
        place = _place_before(made, at) if isinstance(chunk, Noun) and chunk.value == "other" and chunk.count else None
        if place is not None and isinstance(chunk, Noun):
            text = f"{chunk.count} {place.text.split()[-1]}"
            made[at] = replace(place, start=chunk.start, end=chunk.end, det="", count=chunk.count, text=text)
        elif isinstance(chunk, Noun) and _is_share(made, at):
            made[at] = replace(chunk, of_known=True)
    return _counted_first(made)


def _is_share(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "exactly one sock" is one of more that the sentence counted before."""
    share = chunks[at]
    if not isinstance(share, Noun) or share.kind != "thing" or not share.text.lower().startswith("exactly "):
        return False
    for chunk in reversed(chunks[:at]):
        if is_link(chunk, "mark", *_ENDS):
            return False
        if isinstance(chunk, Noun) and chunk.value == share.value and chunk.kind == "thing":
            return (chunk.count or 0) > (share.count or 0) > 0 and not share.of_known
    return False


def _place_before(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The two corners that the sentence named before "in the other two"."""
    if not at or not is_link(chunks[at - 1], "prepositions", *_IN):
        return None
    for chunk in reversed(chunks[: at - 1]):
        if is_link(chunk, "mark", *_ENDS):
            return None
        if isinstance(chunk, Noun) and chunk.kind == "place" and (chunk.count or 0) > 1:
            return chunk if chunk.value in ("corner", "wall") else None
    return None


def _counted_first(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with "there are three children" before what each child has."""
    for at, chunk in enumerate(chunks):
        if not isinstance(chunk, Noun) or chunk.kind != "people" or not chunk.each or chunk.count:
            continue
        for later in range(at + 1, len(chunks) - 1):
            be, people, end = chunks[later], chunks[later + 1], chunks[later + 2 : later + 3]
            counted = isinstance(people, Noun) and people.kind == "people" and (people.count or 0) > 1
            alone = is_link(chunks[later - 1], "mark", *_ENDS) and (not end or is_link(end[0], "mark", *_ENDS))
            if counted and alone and is_link(be, "verbs", "be"):
                stop = Connector("mark", "stop", chunk.start, chunk.start, ".")
                start = _begin(chunks, at)
                rest = [*chunks[start:later], *chunks[later + 2 + len(end) :]]
                return [*chunks[:start], be, people, stop, *rest]
        return chunks
    return chunks


def _begin(chunks: Sequence[Chunk], at: int) -> int:
    ends = (n for n in range(at - 1, -1, -1) if is_link(chunks[n], "mark", *_ENDS))
    return next(ends, -1) + 1
