"""Seats that are named with so many desks or tables, which are theirs: "20 desks and chairs"."""

from collections.abc import Sequence

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_TABLES = ("desks", "tables")
_SEATS = ("seats", "chairs")


def with_seats_joined(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which so many desks "and chairs" are desks with chairs."""
    made = list(chunks)
    for at in range(len(made) - 2):
        desks, joint, seats = made[at : at + 3]
        if is_link(joint, "joins", "and") and _is_counted(desks) and _is_bare(seats) and _ends(made, at + 3):
            made[at + 1] = Connector("prepositions", "with", joint.start, joint.end, "with")
    return made


def _is_counted(chunk: Chunk) -> bool:
    if not isinstance(chunk, Noun) or chunk.kind != "thing" or chunk.definite:
        return False
    return (chunk.count or 0) > 1 and not chunk.each and load_habits().is_in(chunk.value, *_TABLES)


def _is_bare(chunk: Chunk) -> bool:
    if not isinstance(chunk, Noun) or chunk.kind != "thing" or chunk.det or chunk.count is not None:
        return False
    return chunk.plural and not chunk.rows and load_habits().is_in(chunk.value, *_SEATS)


def _ends(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether nothing is told of where the seats are, and what is listed next could not lie on the desks."""
    after, listed = (*chunks[at : at + 2], None, None)[:2]
    small = isinstance(listed, Noun) and load_habits().is_in(listed.value, "small")
    return after is None or is_link(after, "mark") or (is_link(after, "joins", "and") and not small)
