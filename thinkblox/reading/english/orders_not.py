"""What is ordered not to be: "but don't put it by the fire", "a changing table, no"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_ORDERED = ("put", "place", "set", "stand", "hang", "move", "leave", "lay")


def with_orders_not(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which such an order is a statement by itself, and "no" comes before what it is said of."""
    made = list(chunks)
    for at in range(len(made) - 1, 0, -1):
        denied, before = made[at], made[at - 1]
        if not isinstance(denied, Connector) or not is_link(denied, "negations", "not"):
            continue
        verb = chunk_at(made, at + 1)
        if isinstance(verb, Connector) and verb.sort in ("verbs", "participles") and verb.text.lower() in _ORDERED:
            denied = replace(denied, end=verb.end, text=f"{denied.text} {verb.text}")
            made[at : at + 2] = [denied]
        ordered = denied.text.lower().rpartition(" ")[2] in _ORDERED
        if ordered and isinstance(before, Connector) and (is_link(before, "joins") or is_link(before, "mark", "comma")):
            made[at - 1] = Connector("mark", "stop", before.start, before.end, before.text)
        elif at > 1 and _is_answer(made, at):
            thing = made[at - 2]
            if isinstance(thing, Noun):
                first = replace(denied, start=thing.start, end=thing.start)
                made[at - 2 : at + 1] = [first, replace(thing, det="", count=None, text=thing.called)]
    return made


def _is_answer(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "no" is all that is said of a thing: "a rocking chair, yes; a changing table, no."."""
    thing, comma, no = chunks[at - 2 : at + 1]
    begins = at < _BEGUN or is_link(chunks[at - 3], "mark", "stop", "semicolon") or is_link(chunks[at - 3], "joins")
    ends = at + 1 >= len(chunks) or is_link(chunks[at + 1], "mark")
    alone = isinstance(no, Connector) and no.text.lower() == "no"
    named = isinstance(thing, Noun) and thing.kind == "thing" and thing.det == "a"
    return begins and ends and alone and named and is_link(comma, "mark", "comma")


_BEGUN = 3
"""Before so many chunks a sentence has begun."""
