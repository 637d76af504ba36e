"""What is to be done with things that are there: "clear the table"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.goals import GOAL
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_MOST = 3
"""Most chunks that the words for one task are cut into."""


def with_tasks(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the words for what is done with a thing ask for nothing."""
    made = list(chunks)
    for at in range(len(made)):
        length = _task(made, at) if _begins(made, at) else 0
        if length:
            first, last = made[at], made[at + length - 1]
            made[at : at + length] = [Connector("fillers", "doing", first.start, last.end, _text(made[at:][:length]))]
    return made


def is_tasked(chunks: Sequence[Chunk], noun: Noun) -> bool:
    """Whether a phrase names what something is done with."""
    before = [c for c in chunks if c.end == noun.start]
    return any(is_link(c, "fillers", GOAL) or (is_link(c, "fillers", "doing") and _is_known([c])) for c in before)


def _task(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks name what is done with the thing that comes after them; 0 where they do not."""
    for length in range(_MOST, 0, -1):
        after = chunk_at(chunks, at + length)
        known = isinstance(after, Noun) and after.kind == "thing" and after.det in ("the", "all")
        if known and _is_known(chunks[at : at + length]):
            return length
    return 0


def _is_known(chunks: Sequence[Chunk]) -> bool:
    return _text(chunks).lower() in grammar().lists["tasks"]


def _text(chunks: Sequence[Chunk]) -> str:
    plain = [c.text for c in chunks if isinstance(c, Adjective | Connector | Noun)]
    return " ".join(plain) if len(plain) == len(chunks) else ""


def _begins(chunks: Sequence[Chunk], at: int) -> bool:
    before = chunks[at - 1] if at else None
    polite = is_link(before, "fillers") or is_link(before, "verbs", "put")
    return before is None or polite or is_link(before, "mark", "stop", "semicolon", "colon")
