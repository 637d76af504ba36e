"""One more of what was named singly: "one lamp is on the desk and one is on the floor", "a second one hangs there"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_ANOTHER = "another"
_FIRST = 1


def with_one_more(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "one" and "a second one" are another of the single thing that was named."""
    made: list[Chunk] = []
    single: Noun | None = None
    for at, chunk in enumerate(chunks):
        verb = chunk_at(chunks, at + 1)
        if isinstance(chunk, Noun) and single is not None and _is_more(chunk, single) and _is_placing(verb):
            made.append(Noun("pronoun", "other", chunk.start, chunk.end, _ANOTHER))
            continue
        if isinstance(chunk, Noun) and chunk.kind == "thing":
            single = _single(chunk, chunks[:at], single)
        made.append(chunk)
    return made


def _single(noun: Noun, before: Sequence[Chunk], single: Noun | None) -> Noun | None:
    """What "one more" is of: the thing that a sentence or clause begins with, named singly and for the first time."""
    begins = not before or is_link(before[-1], "mark", "stop", "semicolon") or is_link(before[-1], "verbs", "be")
    if not begins:
        return None if noun.many else single
    new = noun.count == 1 or noun.det == "a"
    known = any(isinstance(c, Noun) and c.kind == "thing" and c.value == noun.value for c in before)
    return noun if new and not known and not noun.many else None


def _is_more(noun: Noun, single: Noun) -> bool:
    """Whether it is "one" after "one lamp", or "a second (one)"."""
    if noun.attributes or noun.of_known:
        return False
    if noun.kind == "pronoun" and noun.value == "one":
        return noun.text.lower() == "one" and single.text.lower().startswith("one ")
    return noun.kind == "number" and noun.det == "a" and noun.ordinal > _FIRST and noun.count == 1


def _is_placing(verb: Chunk | None) -> bool:
    return is_link(verb, "verbs", "be", "stand", "hang")
