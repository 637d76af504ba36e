"""Numbers told by those of other things, and looks by those of others: "twice as many chairs as tables", "are too"."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_JOINED = ("and", "comma")
_TOO = ("too", "as well", "also")


def with_as_many(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the number where what it is told by is counted later, and with the look that others have too."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        noun, link, other = (*chunks[at : at + 3], None, None)[:3]
        number = 0
        if isinstance(noun, Noun) and noun.share and is_link(link, "prepositions", "as") and isinstance(other, Noun):
            number = int(noun.share * _number_later(other, chunks[at + 3 :]))
        per = _number_per(noun, other, chunks[at + 3 :]) if is_link(link, "prepositions", "per") else 0
        if per and isinstance(noun, Noun):
            made.append(replace(noun, count=per, plural=per > 1))
            at += 2
        elif isinstance(other, Noun) and _is_all_but(noun, link, other):
            made.append(replace(other, count=other.total - (other.count or 0), det=""))
            at += 2
        elif number and isinstance(noun, Noun):
            made.append(replace(noun, share=0.0, count=number, plural=number > 1))
            at += 2
        elif isinstance(noun, Noun) and noun.share and (number := _number_before(noun, chunks[at + 1 :], made)):
            made.append(replace(noun, share=0.0, count=number, plural=number > 1))
        elif noun is not None:
            made.append(_look_again(chunks, at, made) or noun)
        at += 1
    return made


def _number_before(noun: Noun, after: Sequence[Chunk], made: Sequence[Chunk]) -> int:
    """How many "six plates and twice as many glasses" are; 0 where they are not joined to what they are told by."""
    if noun.kind != "thing" or len(made) < len(_JOINED):
        return 0
    rest = takewhile(lambda chunk: not is_link(chunk, "mark", "stop", "semicolon"), after)
    if any(is_link(chunk, "prepositions", "as") for chunk in rest):
        return 0
    counted, joint = made[-2:]
    joined = is_link(joint, "joins", _JOINED[0]) or is_link(joint, "mark", _JOINED[1])
    told = isinstance(counted, Noun) and counted.kind == "thing" and joined and not noun.of_known
    return int(noun.share * (counted.count or 0)) if told and isinstance(counted, Noun) else 0


def _number_per(noun: Chunk | None, other: Chunk | None, after: Sequence[Chunk]) -> int:
    """How many "one table per four chairs" are, where it is told later how many the chairs are; 0 for other words."""
    if not (isinstance(noun, Noun) and isinstance(other, Noun)):
        return 0
    several = noun.kind == "thing" and other.kind == "thing" and (other.count or 0) > 1
    total = _number_later(replace(other, count=None), after) if several else 0
    return total * (noun.count or 1) // (other.count or 1) if total else 0


def _is_all_but(noun: Chunk | None, but: Chunk | None, other: Noun) -> bool:
    """Whether "all but one of the six chairs" comes, which tells how many there are."""
    every = isinstance(noun, Noun) and noun.kind == "pronoun" and noun.value == "all"
    barred = is_link(but, "joins", "but") or is_link(but, "prepositions", "except")
    return every and barred and other.kind == "thing" and other.of_known and other.total > (other.count or 0) > 0


def _number_later(noun: Noun, after: Sequence[Chunk]) -> int:
    """How many of a kind are told of only after "as many as" it; 0 where that is not told."""
    if noun.kind != "thing" or noun.count is not None or noun.det:
        return 0
    alike = (c for c in after if isinstance(c, Noun) and c.kind == "thing" and c.value == noun.value and c.count)
    return next((c.count or 0 for c in alike if not c.of_known), 0)


def _look_again(chunks: Sequence[Chunk], at: int, before: Sequence[Chunk]) -> Adjective | None:
    """The look of "the sofa is grey, the armchairs are too" in place of "too"; None where none was told just before."""
    too, end = chunks[at], chunk_at(chunks, at + 1)
    said = isinstance(too, Connector) and too.sort == "fillers" and too.text.lower() in _TOO
    ends = end is None or is_link(end, "mark", "stop", "semicolon")
    if not (said and ends) or not before or not is_link(before[-1], "verbs", "be"):
        return None
    found = [
        n for n, c in enumerate(before) if isinstance(c, Adjective) and n and is_link(before[n - 1], "verbs", "be")
    ]
    last = before[found[-1]] if found else None
    named = sum(isinstance(c, Noun) for c in before[found[-1] :]) if found else 0
    told = isinstance(last, Adjective) and named == 1
    return replace(last, start=too.start, end=too.end) if told and isinstance(last, Adjective) else None
