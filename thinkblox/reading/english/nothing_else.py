"""Whatever says that what was named is all: "no other furniture", "not a single other piece of furniture"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_OTHER = frozenset({"other", "further", "more", "additional", "extra"})
ANYTHING = frozenset(
    {"furniture", "furnishings", "furnishing", "piece", "pieces", "item", "items", "object", "objects"}
)
ANYTHING |= {"thing", "things", "stuff"}
_IDLE = frozenset({"no", "not", "a", "an", "any", "single", "one"})
_ALL = frozenset({"furniture", "furnishings"})
"""What a room that has none of it does not hold, whether others are spoken of or not."""
_LONGEST = 3
"""Most chunks that say it, without what denies it."""


def with_nothing_else(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which that is said as "nothing else"."""
    found: list[Chunk] = []
    at = 0
    while at < len(chunks):
        without = is_link(chunks[at], "prepositions", "without")
        length = _length(chunks[at + int(without) : at + int(without) + _LONGEST], denied=without)
        if length:
            whole = chunks[at : at + int(without) + length]
            found.append(Connector("negations", "nothing", whole[0].start, whole[-1].end, "nothing else"))
            at += len(whole)
        else:
            found.append(chunks[at])
            at += 1
    return found


def _length(chunks: Sequence[Chunk], *, denied: bool) -> int:
    """How many chunks say "no other furniture"; 0 where they say something else."""
    noun = chunks[0] if chunks else None
    if not isinstance(noun, Noun) or not (denied or noun.det == "no") or noun.attributes:
        return 0
    words = set(noun.text.lower().split())
    whole = chunks[2] if len(chunks) > 2 and is_link(chunks[1], "prepositions", "of") else None
    length = 3 if isinstance(whole, Noun) and whole.text.lower() in ANYTHING else 1
    named = words | ({whole.text.lower()} if length > 1 and isinstance(whole, Noun) else set())
    if not words <= _OTHER | ANYTHING | _IDLE or named.isdisjoint(ANYTHING):
        return 0
    return length if not named.isdisjoint(_OTHER) or not named.isdisjoint(_ALL) else 0
