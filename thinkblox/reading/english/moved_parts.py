"""Doors, drawers and lids of things, which are open as the thing is: "the doors of the wardrobe are open"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.plurals import singular
from thinkblox.reading.english.chunks import Adjective, Chunk, Noun, Stray, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

MOVED = ("door", "lid", "drawer", "flap", "hatch")
"""Parts that are open or closed as what they are of is said to be."""
_OWNED = ("'s", "\u2019s")
_BEFORE_PART = ("its", "the", "their")


def with_moved_parts(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is said of such a part is said of the thing; how else the part looks is not understood."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        whole, length = _whole_of(chunks, at)
        if not whole:
            whole, length = _with_part(chunks, at)
        made += whole or [chunks[at]]
        at += length or 1
    return made


def _whole_of(chunks: Sequence[Chunk], at: int) -> tuple[list[Chunk], int]:
    """The thing of "the doors of the wardrobe", "the wardrobe's doors" before what they are, and its chunks."""
    first, second, third = (*chunks[at : at + 3], None, None)[:3]
    if isinstance(first, Noun) and _is_part(first) and is_link(second, "prepositions", "of"):
        whole, length, counted = third, 3, first.definite or first.count is not None
    elif isinstance(first, Noun) and first.text.endswith(_OWNED) and isinstance(second, Noun) and _is_part(second):
        whole, length, counted = replace(first, plural=False), 2, True
    else:
        return [], 0
    if not isinstance(whole, Noun) or whole.kind != "thing" or not counted:
        return [], 0
    if is_link(chunk_at(chunks, at + length), "verbs", "hold"):
        return [replace(whole, start=first.start)], length
    end = at + length + _being(chunks, at + length)
    look = chunk_at(chunks, end)
    if not isinstance(look, Adjective) or (
        end == at + length and not (at and is_link(chunks[at - 1], "verbs", "leave"))
    ):
        return [], 0
    if not look.states:
        return [whole, Stray(first.start, look.end, f"{first.text} {look.text}")], end + 1 - at
    return [replace(whole, start=first.start)], length


def _being(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "is slightly" has; 0 where no such verb comes."""
    if not is_link(chunk_at(chunks, at), "verbs", "be"):
        return 0
    end = at + 1
    while end < len(chunks) and is_link(chunks[end], "fillers"):
        end += 1
    return end - at


def _with_part(chunks: Sequence[Chunk], at: int) -> tuple[list[Chunk], int]:
    """The thing of "a wardrobe with open doors", "a fridge with its door open", and its chunks."""
    whole, link = (*chunks[at : at + 2], None)[:2]
    if not isinstance(whole, Noun) or whole.kind != "thing" or not is_link(link, "prepositions", "with"):
        return [], 0
    end = at + 2
    while end < len(chunks) and _leads(chunks[end]):
        end += 1
    states = _states_of(chunks[end]) if end < len(chunks) else []
    if not states or not _ends(chunks, end + 1):
        return [], 0
    return [replace(whole, end=chunks[end].end, states=[*whole.states, *states])], end + 1 - at


def _leads(chunk: Chunk) -> bool:
    """Whether "its", "the top" comes before "drawer open"."""
    if isinstance(chunk, Stray):
        return chunk.text.lower() in _BEFORE_PART
    return isinstance(chunk, Noun) and chunk.kind == "abstract" and chunk.value in ("top", "bottom")


def _states_of(chunk: Chunk) -> list[str]:
    """What is said of the part: of "open doors", or "doors open"."""
    if isinstance(chunk, Noun):
        plain = _is_part(chunk) and not (chunk.attributes or chunk.unshown or chunk.size)
        return chunk.states if plain else []
    words = chunk.text.lower().split() if isinstance(chunk, Stray) else []
    state = " ".join(words[1:])
    moved = bool(state) and singular(words[0]) in MOVED and grammar().knows(state, "states")
    return [state] if moved else []


def _is_part(noun: Noun) -> bool:
    return noun.word in MOVED and noun.kind in ("thing", "place", "part")


def _ends(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether nothing else is listed that the thing has."""
    after = chunk_at(chunks, at)
    if is_link(after, "joins", "and"):
        return is_link(chunk_at(chunks, at + 1), "verbs")
    return after is None or is_link(after, "mark") or is_link(after, "verbs") or is_link(after, "prepositions")
