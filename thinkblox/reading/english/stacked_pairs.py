"""What is stacked two by two: "a stacked washer and dryer" is a dryer on a washer."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link
from thinkblox.reading.stacks import STACKED

_LOWER = {"dryer": "washing_machine", "washing_machine": "dryer"}
"""What each is stacked with."""


def with_stacked_pairs(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a dryer is said to be on the washer with which it is stacked."""
    found = list(chunks)
    for at in range(len(found) - 2):
        one, link, other = found[at : at + 3]
        joined = is_link(link, "joins", "and") or is_link(link, "mark", "comma")
        if not joined or not isinstance(one, Noun) or not isinstance(other, Noun):
            continue
        if _LOWER.get(one.value) != other.value or one.many or other.many:
            continue
        before, after = found[at - 1] if at else None, found[at + 3 : at + 6]
        apart = bool(after) and is_link(after[0], "mark", "comma")
        if before is not None and _is_stacked(before):
            said, first, last = before, at - 1, at + 3
        elif STACKED in one.states:
            said, first, last = link, at, at + 3
        elif len(after) > apart and _is_stacked(after[apart]):
            said, first = after[apart], at
            last = at + 4 + apart + _each_other(after[apart + 1 :])
        else:
            continue
        upper, lower = (one, other) if one.value == "dryer" else (other, one)
        lower = replace(lower, states=[state for state in lower.states if state != STACKED])
        on = Connector("prepositions", "on", said.start, said.end, "on")
        return [*found[:first], upper, on, lower, *with_stacked_pairs(found[last:])]
    return found


def _is_stacked(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and STACKED in chunk.text.lower().split()


def _each_other(after: Sequence[Chunk]) -> int:
    """How many chunks say "on top of each other"."""
    said = len(after) > 1 and is_link(after[0], "prepositions", "on", "on_top")
    other = after[1] if said else None
    return 2 if isinstance(other, Noun) and other.text.lower() in ("each other", "one another") else 0
