"""One more of what was named singly: "one lamp is on the desk and one is on the floor", "a second one hangs there"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Noun, chunk_at
from thinkblox.reading.english.said import is_link, part_start

_ANOTHER = "another"
_ONE_MORE = ("another", "another one", "a second one", "a second", "a matching one")
_FIRST = 1


def with_one_more(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "one" and "a second one" are another of the single thing that was named.

    Where its place comes first, as that of the other did, it is called by its name: "left of the bed is a nightstand,
    and right of it is another".
    """
    made: list[Chunk] = []
    single: Noun | None = None
    for at, chunk in enumerate(chunks):
        if isinstance(chunk, Noun) and chunk.text.lower() in _ONE_MORE and (first := _placed_first(chunks, at)):
            named = f"{_ANOTHER} {first.called}"
            made.append(replace(first, start=chunk.start, end=chunk.end, det=_ANOTHER, count=1, text=named, fates={}))
            continue
        verb = chunk_at(chunks, at + 1)
        if isinstance(chunk, Noun) and single is not None and _is_more(chunk, single) and _is_placing(verb):
            made.append(Noun("pronoun", "other", chunk.start, chunk.end, _ANOTHER))
            continue
        if isinstance(chunk, Noun) and chunk.kind == "thing":
            single = _single(chunk, chunks[:at], single)
        made.append(chunk)
    return made


def _placed_first(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The single thing named after its place, if the place of another comes first as well."""
    if not _comes_last(chunks, at):
        return None
    for before in range(at - 1, 0, -1):
        thing = chunks[before]
        if isinstance(thing, Noun) and thing.kind == "thing" and _comes_last(chunks, before):
            return thing if not (thing.many or thing.definite) else None
        if is_link(thing, "mark", "stop") and not is_link(chunks[at - 1], "verbs"):
            return None
    return None


def _comes_last(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a part of a sentence ends there that began with a place: "and to the right of it is another"."""
    begun = part_start(chunks, at)
    ends = at + 1 == len(chunks) or is_link(chunks[at + 1], "mark") or is_link(chunks[at + 1], "joins", "and")
    verbs = [n for n in range(begun, at) if is_link(chunks[n], "verbs")]
    placed = not verbs or (verbs == [at - 1] and is_link(chunks[at - 1], "verbs", "be", "stand", "hang"))
    return ends and placed and begun + 1 < at and is_link(chunks[begun], "prepositions")


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
