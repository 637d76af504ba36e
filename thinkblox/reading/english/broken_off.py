"""What somebody begins to say and says otherwise: "it leans... no, stands there", "a stove... skip that"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk
from thinkblox.reading.english.said import is_link

_DOTS = 2
"""Full stops in a row that break off rather than end."""


def with_broken_off(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks without the verb that is put right, and without the dots before what is taken back."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        dots = _stops(chunks, at)
        after = chunks[at + dots] if at + dots < len(chunks) else None
        if is_link(chunks[at], "verbs") and (length := _put_right(chunks, at + 1)):
            at += 1 + length
        elif dots >= _DOTS and is_link(after, "negations", "gone"):
            at += dots
        else:
            made.append(chunks[at])
            at += 1
    return made


def _stops(chunks: Sequence[Chunk], at: int) -> int:
    """How many full stops come one after another."""
    end = at
    while end < len(chunks) and is_link(chunks[end], "mark", "stop"):
        end += 1
    return end - at


def _put_right(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "... no," has before another verb; 0 where it does not come."""
    start = at + _stops(chunks, at)
    no, comma, verb = (*chunks[start : start + 3], None, None, None)[:3]
    plain = is_link(no, "negations", "not") and getattr(no, "text", "").lower() == "no"
    return start + 2 - at if plain and is_link(comma, "mark", "comma") and is_link(verb, "verbs") else 0
