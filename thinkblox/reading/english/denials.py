"""What something is not at: "the sofa faces the fire, not the television", "by the window and not the door"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at

_NO_PLACES = ("with", "without", "of", "for", "as", "instead", "from", "except")
"""Prepositions that do not say where things are."""
_FACING = {"face": "facing", "face_away": "facing_away"}


def with_denials(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the relation that is left out before what is denied is said once more."""
    made = list(chunks)
    for at in range(len(made) - 2, 1, -1):
        denied, other = made[at], made[at + 1]
        end = at - 1 if _is(made[at - 1], "mark", "comma") or _is(made[at - 1], "joins", "and", "but") else at
        if not isinstance(denied, Connector) or not isinstance(other, Noun) or end < 2:
            continue
        link, anchor = _relation(made[end - 2]), made[end - 1]
        if link is None or not isinstance(anchor, Noun) or not _is_like(anchor, other) or not _ends(made, at + 2):
            continue
        instead = _is(denied, "prepositions", "instead") and link.value in _FACING.values()
        if instead or (_is(denied, "negations", "not") and denied.text.lower() == "not"):
            no = Connector("negations", "not", denied.start, denied.end, "not")
            made[at : at + 1] = [no, replace(link, start=other.start, end=other.start)]
    return made


def _relation(chunk: Chunk) -> Connector | None:
    """The preposition by which something is somewhere, or that of a verb for it."""
    if not isinstance(chunk, Connector):
        return None
    if chunk.sort == "verbs" and chunk.value in _FACING:
        return replace(chunk, sort="prepositions", value=_FACING[chunk.value], text="facing")
    return chunk if chunk.sort == "prepositions" and chunk.value not in _NO_PLACES else None


def _is_like(anchor: Noun, other: Noun) -> bool:
    """Whether both may be where something is: "the window, not the door"."""
    placed = anchor.kind in ("thing", "place") and other.kind in ("thing", "place")
    return placed and other.det in ("the", "my") and other.count is None


def _ends(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether nothing more is said of it."""
    after = chunk_at(chunks, at)
    return after is None or (isinstance(after, Connector) and after.sort in ("mark", "joins"))


def _is(chunk: Chunk, sort: str, *values: str) -> bool:
    return isinstance(chunk, Connector) and chunk.sort == sort and chunk.value in values
