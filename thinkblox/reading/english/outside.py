"""What is outside the room: "a window onto the courtyard", "leading to the kitchen", "on the second floor"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, filler
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_FLOORS = ("floor", "storey", "story", "level")


def with_outside(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what one sees or gets to from the room, and on which floor it is, ask for nothing.

    Where a thing is said to stand by what is outside, that is not understood.
    """
    made: list[Chunk] = list(chunks)
    for at, noun in enumerate(made):
        link, before = made[at - 1] if at else None, made[at - 2] if at > 1 else None
        if not isinstance(noun, Noun) or not isinstance(link, Connector):
            continue
        leads = link.text.lower() in grammar().lists["leading"]
        if leads and (noun.kind == "room" or _is_outside(noun)):
            made[at - 1 : at + 1] = [filler(link), filler(noun)]
        elif (link.sort == "prepositions" or is_link(link, "verbs", "face")) and _is_outside(noun):
            seen = isinstance(before, Noun) and (before.kind == "room" or before.word in grammar().lists["looked_from"])
            if link.value == "of" and not seen:
                continue  # The painting of the sea is one.
            lost = Stray(link.start, noun.end, f"{link.text} {noun.text}")
            made[at - 1 : at + 1] = [filler(link), filler(noun)] if seen else [filler(link), lost]
        elif is_link(link, "prepositions", "under") and _is_stairs(noun) and _is_room(before):
            made[at - 1 : at + 1] = [filler(link), Stray(link.start, noun.end, f"{link.text} {noun.text}")]
        elif is_link(link, "prepositions", "on") and _is_storey(noun) and isinstance(before, Noun):
            kept = before.kind == "room"
            lost = Stray(link.start, noun.end, f"{link.text} {noun.text}")
            made[at - 1 : at + 1] = [filler(link), filler(noun) if kept else lost]
    return made


def _is_outside(noun: Noun) -> bool:
    """Whether it is the garden, or another place that is none of the room's, of which nothing more is said."""
    named = noun.kind in ("thing", "abstract") and noun.det in ("a", "the", "my") and not noun.count
    return named and noun.called in grammar().lists["outside"]


def _is_room(chunk: Chunk | None) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "room"


def _is_stairs(noun: Noun) -> bool:
    return noun.kind == "thing" and noun.word in grammar().lists["stairs"]


def _is_storey(noun: Noun) -> bool:
    words = noun.text.lower().split()
    return words[-1] in _FLOORS and (bool(noun.ordinal) or not grammar().lists["storeys"].isdisjoint(words))
