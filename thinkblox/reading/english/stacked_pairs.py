"""What is stacked two by two: "a stacked washer and dryer" is a dryer on a washer."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.stacks import load_stacks
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link
from thinkblox.reading.stacks import STACKED

_PAIR = 3
"""Chunks of two that are joined."""


def with_stacked_pairs(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the upper of two that are stacked, a dryer, is said to be on the lower one, a washer."""
    found: list[Chunk] = []
    at = 0
    while at < len(chunks):
        pair = _pair(chunks[at : at + 3])
        said, length = _stacked_by(chunks, at) if pair else (None, 0)
        if not pair or said is None:
            found.append(chunks[at])
            at += 1
            continue
        if found and said is found[-1]:
            found.pop()
        upper, lower = (replace(each, states=[s for s in each.states if s != STACKED]) for each in pair)
        found += [upper, Connector("prepositions", "on", said.start, said.end, "on"), lower]
        at += length
    return found


def _pair(three: Sequence[Chunk]) -> tuple[Noun, Noun] | None:
    """The upper and the lower of two that can be stacked, where these are joined."""
    one, link, other = (*three, None, None, None)[:_PAIR]
    if not isinstance(one, Noun) or not isinstance(other, Noun) or one.many or other.many:
        return None
    if not (is_link(link, "joins", "and") or is_link(link, "mark", "comma")):
        return None
    below = load_stacks().on
    pairs = ((one, other), (other, one))
    return next(((upper, lower) for upper, lower in pairs if below.get(upper.value) == lower.value), None)


def _stacked_by(chunks: Sequence[Chunk], at: int) -> tuple[Chunk | None, int]:
    """Which chunk says that the two from `at` on are stacked, None for none; and how many, from there, say it all."""
    one, after = chunks[at], chunks[at + _PAIR : at + 2 * _PAIR]
    if at and _is_stacked(chunks[at - 1]):
        return chunks[at - 1], _PAIR
    if isinstance(one, Noun) and STACKED in one.states:
        return chunks[at + 1], _PAIR
    apart = bool(after) and is_link(after[0], "mark", "comma")
    if len(after) > apart and _is_stacked(after[apart]):
        return after[apart], _PAIR + apart + 1 + _each_other(after[apart + 1 :])
    return None, 0


def _is_stacked(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and STACKED in chunk.text.lower().split()


def _each_other(after: Sequence[Chunk]) -> int:
    """How many chunks say "on top of each other"."""
    said = len(after) > 1 and is_link(after[0], "prepositions", "on", "on_top")
    other = after[1] if said else None
    return 2 if isinstance(other, Noun) and other.text.lower() in ("each other", "one another") else 0
