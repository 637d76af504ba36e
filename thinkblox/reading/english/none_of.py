"""What none of several has, which is then not there: "none of the walls has a window", "none of them has a lamp"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.said import is_holding, is_link

_NONE = ("none", "no")
_LENGTH = 3


def with_none_of(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which there is none of what none of several has; where there are others, it is not understood."""
    made: list[Chunk] = []
    at = 0
    chunks = [_of_all(chunks, n) or chunk for n, chunk in enumerate(chunks)]
    while at < len(chunks):
        several, has, what = (*chunks[at : at + _LENGTH], None, None)[:_LENGTH]
        told = isinstance(several, Noun) and is_holding(has) and isinstance(what, Noun)
        if told and isinstance(several, Noun) and isinstance(what, Noun) and _have_none(chunks, at, several, what):
            others = [*chunks[:at], *chunks[at + _LENGTH :]]
            if several.det == "none" and not _is_named(several, others):
                made += [_asked(several), Connector("mark", "stop", several.end, several.end, ".")]
            made += _none(several, what, others, comma=bool(made) and is_link(made[-1], "mark", "comma"))
            at += _LENGTH + _on_it(chunks, at + _LENGTH)
        else:
            made.append(chunks[at])
            at += 1
    return made


def _of_all(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The sculptures of "three sculptures: one is bronze, two are marble, and none of them stands in a corner"."""
    none = chunks[at]
    if not isinstance(none, Noun) or (none.kind, none.text.lower()) != ("pronoun", "none of them"):
        return None
    parted = False
    for chunk in reversed(chunks[:at]):
        if is_link(chunk, "mark", "stop"):
            return None
        if isinstance(chunk, Noun) and chunk.kind == "thing":
            several = parted and (chunk.count or 0) > 1
            made = replace(chunk, start=none.start, end=none.end, det="none", count=None, attributes=[], of_known=True)
            return replace(made, text=f"none of the {chunk.word}s") if several else None
        parted |= isinstance(chunk, Noun) and chunk.kind in ("number", "pronoun") and bool(chunk.count)
    return None


def _have_none(chunks: Sequence[Chunk], at: int, several: Noun, what: Noun) -> bool:
    """Whether "none of them has a lamp" ends there, and what they are is told elsewhere."""
    end = at + _LENGTH + _on_it(chunks, at + _LENGTH)
    after = chunk_at(chunks, end)
    ends = after is None or is_link(after, "mark") or is_link(after, "joins")
    opening = what.kind == "place" and what.value in ("window", "door")
    if not ends or what.definite or not (opening or what.kind == "thing"):
        return False
    if several.kind == "place":
        return several.value.endswith("wall") and several.det in _NONE
    if opening or several.kind == "pronoun":
        return not opening and several.value == "none"
    others = [*chunks[:at], *chunks[at + _LENGTH :]]
    return several.kind == "thing" and several.det in _NONE and (several.det == "none" or _is_named(several, others))


def _asked(several: Noun) -> Noun:
    """The two chairs of "neither of the two chairs", which nobody named before."""
    text = " ".join(several.text.split()[2:])
    return replace(several, det="" if several.count else "the", of_known=False, text=text)


def _on_it(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "on it" has; 0 where it does not come."""
    on, it = (*chunks[at : at + 2], None, None)[:2]
    pointed = isinstance(it, Noun) and it.kind == "pronoun" and it.value in ("it", "them")
    return 2 if pointed and is_link(on, "prepositions", "on", "in") else 0


def _is_named(noun: Noun, others: Sequence[Chunk]) -> bool:
    return any(isinstance(c, Noun) and c.kind == noun.kind and c.value == noun.value for c in others)


def _none(several: Noun, what: Noun, others: Sequence[Chunk], *, comma: bool) -> list[Chunk]:
    """What says that there is none of something, or that this is not understood where there are others of it."""
    if what.kind == "thing" and _is_named(what, others):
        return [Stray(several.start, what.end, f"{several.text} {what.text}")]
    led = [] if not comma else [Connector("prepositions", "with", several.start, several.start, "with")]
    return [*led, replace(what, det="no", count=None)]
