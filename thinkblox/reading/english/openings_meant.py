"""What "it" is beside a window or door: "a window with a bench under it", "a sink and a window above it"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets import facts_of
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_OPENINGS = ("window", "door")
_BY = ("under", "above", "in_front_of", "next_to", "near", "by", "left_of", "right_of", "opposite", "facing")
_WALLS = ("on", "in", "at")
"""Prepositions that say in which wall an opening is."""


def with_openings_meant(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "it" is the window or door named just before, or what a window was said to be above."""
    made = list(chunks)
    for at in range(len(made) - 1, 1, -1):
        it, link = made[at], made[at - 1]
        if not isinstance(it, Noun) or not isinstance(link, Connector):
            continue
        pointed = it.kind == "pronoun" and it.text.lower() == "it" and is_link(link, "prepositions", *_BY)
        beside = it.kind == "part" and it.value in ("left", "right") and it.text.lower().endswith(" of it")
        if not pointed and not (beside and is_link(link, "prepositions", "to", "on")):
            continue
        meant = _meant(made, at - 1, link.value if pointed else f"{it.value}_of")
        if meant is not None:
            start = it.start if pointed else it.end
            text = f"the {meant.text.split()[-1]}"
            opening = Noun(meant.kind, meant.value, start, it.end, text, det="the", named=meant.named)
            of = Connector("prepositions", "of", start, start, "of")
            made[at : at + 1] = [opening] if pointed else [replace(it, det="the"), of, opening]
    return made


def _meant(chunks: Sequence[Chunk], link: int, where: str) -> Noun | None:
    """What "it" stands for after a link; None where neither it nor what is there is an opening."""
    link -= is_link(chunks[link - 1], "verbs", "be", "stand", "hang")
    before = chunks[link - 1]
    subject = before if isinstance(before, Noun) else None
    starts = is_link(before, "mark", "stop", "semicolon", "comma")
    if subject is None and not starts:
        return None
    named = _last_noun(chunks, link - 1)
    if named is None or named.plural or (named.count or 1) > 1:
        return None
    if _is_opening(named):
        if _tells_where(chunks, named) and not _is_hung_there(chunks, named, subject):
            return None
        flat = where == "under" and subject is not None and facts_of(subject.value).is_in("covers")
        return named if not flat and (named.value == "window" or where != "under") else None
    told = subject is not None and _is_opening(subject) and subject.det == "a" and named.kind == "thing"
    return named if told else None


def _last_noun(chunks: Sequence[Chunk], end: int) -> Noun | None:
    """The noun before a place in the text, past the wall that it is said to be in."""
    at = end - 1 if isinstance(chunks[end], Noun) else end
    while at >= 0:
        chunk = chunks[at]
        if isinstance(chunk, Noun):
            in_wall = chunk.kind == "place" and "wall" in chunk.value and at > 0
            if not (in_wall and is_link(chunks[at - 1], "prepositions", *_WALLS)):
                return chunk
        at -= 1
    return None


def _tells_where(chunks: Sequence[Chunk], opening: Noun) -> bool:
    """Whether the opening only says where a thing is: "a tub under the window, with a stool next to it"."""
    at = next(n for n, chunk in enumerate(chunks) if chunk is opening)
    if not at or not is_link(chunks[at - 1], "prepositions") or is_link(chunks[at - 1], "prepositions", "with"):
        return False
    before = next((chunk for chunk in reversed(chunks[: at - 1]) if isinstance(chunk, Noun)), None)
    return before is not None and before.kind == "thing"


def _is_hung_there(chunks: Sequence[Chunk], opening: Noun, subject: Noun | None) -> bool:
    """Whether things hang at the opening, and what stands is told next: "a clock above the door, a bin by it"."""
    at = next(n for n, chunk in enumerate(chunks) if chunk is opening)
    hung = next((chunk for chunk in reversed(chunks[: at - 1]) if isinstance(chunk, Noun)), None)
    above = is_link(chunks[at - 1], "prepositions", "above", "on", "over") and hung is not None
    if not above or subject is None or hung is None or subject.kind != "thing":
        return False
    apart = facts_of(hung.value).is_in("wallpieces") and not facts_of(subject.value).is_in("wallpieces")
    return apart or hung.many


def _is_opening(noun: Noun) -> bool:
    return noun.kind == "place" and noun.value in _OPENINGS
