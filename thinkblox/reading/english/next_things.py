"""What comes next in an order: "a table with four chairs, then a sideboard on the right" has it in no list."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link


def with_next_things(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what a thing has ends before ", then" and "and then" of a thing that has its own place."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        length = _then(chunks, at)
        if length:
            first, last = chunks[at], chunks[at + length - 1]
            made.append(Connector("mark", "semicolon", first.start, last.end, ";"))
        else:
            made.append(chunks[at])
        at += length or 1
    return made


def _then(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks ", then", ", and then" and "and then" have before a new thing; 0 where these do not come."""
    end = at
    while end < len(chunks) and (is_link(chunks[end], "mark", "comma") or is_link(chunks[end], "joins", "and")):
        end += 1
    if end == at:
        return 0
    said = " ".join(str(getattr(chunk, "text", "")).lower() for chunk in chunks[at : end + 1]).split()
    if "then" not in said:
        return 0
    end += "then" not in " ".join(str(getattr(c, "text", "")).lower() for c in chunks[at:end]).split()
    after, link = (*chunks[end : end + 2], None, None)[:2]
    new = isinstance(after, Noun) and after.kind == "thing" and not after.definite
    placed = is_link(link, "prepositions") and not is_link(link, "prepositions", "with", "of", "for")
    return end - at if new and placed and _is_list(chunks[:at]) else 0


def _is_list(before: Sequence[Chunk]) -> bool:
    """Whether the sentence so far says what something has."""
    stops = (n for n in range(len(before) - 1, -1, -1) if is_link(before[n], "mark", "stop", "semicolon", "colon"))
    return any(is_link(chunk, "prepositions", "with") for chunk in before[next(stops, -1) + 1 :])
