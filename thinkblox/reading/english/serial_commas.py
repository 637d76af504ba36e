"""Commas where lists have one too many and clauses one too few.

"A book, a vase, and a lamp are on it" is read as it is without the second comma, and "the crib is in the corner and a
mobile hangs above it" as it is with one.
"""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_SAYING_WHERE = ("be", "stand", "hang", "face")
"""Verbs after something new with which a clause begins, and not the last of what is listed."""
_POINTING = ("the", "each")


def with_serial_commas(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks without such commas; one before what has a verb of its own stays, as a new clause begins there."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        joint = chunk_at(chunks, at + 1)
        if is_link(chunks[at], "mark", "comma") and is_link(joint, "joins", "and") and _is_in_list(chunks, at):
            assert isinstance(joint, Connector)
            made.append(replace(joint, start=chunks[at].start))
            at += 2
        else:
            made.append(chunks[at])
            at += 1
    return made


def with_clause_commas(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with a comma before an "and" after which a clause of its own begins, where one was told already."""
    made: list[Chunk] = []
    told = False
    for at, chunk in enumerate(chunks):
        if is_link(chunk, "mark", "stop", "semicolon", "colon") or is_link(chunk, "joins", "which"):
            told = False
        elif is_link(chunk, "verbs"):
            told = True
        elif told and is_link(chunk, "joins", "and") and _begins_clause(chunks, at + 1):
            if not is_link(chunks[at - 1], "mark"):
                made.append(Connector("mark", "comma", chunk.start, chunk.start, ","))
            told = False
        made.append(chunk)
    return made


def is_of_several(verb: Chunk | None) -> bool:
    """Whether it is a verb of several: "are", "stand", "have"."""
    return isinstance(verb, Connector) and verb.sort == "verbs" and not verb.text.lower().split()[0].endswith("s")


def next_listed(chunks: Sequence[Chunk], at: int) -> int:
    """Where the next new thing of a list ends that a comma or "and" joins to what ends at `at`; 0 where none comes."""
    begin = at + is_link(chunk_at(chunks, at), "mark", "comma")
    begin += is_link(chunk_at(chunks, begin), "joins", "and")
    noun = chunk_at(chunks, begin)
    new = begin > at and isinstance(noun, Noun) and noun.kind == "thing" and not noun.definite
    return begin + 1 if new else 0


def _begins_clause(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether things with a verb that agrees with them come, or a place with a verb and what is there."""
    if (end := _place_end(chunks, at)) > at:
        there = chunk_at(chunks, end + 1)
        return (
            is_link(chunk_at(chunks, end), "verbs", *_SAYING_WHERE) and isinstance(there, Noun) and not there.definite
        )
    noun = chunk_at(chunks, at)
    if not isinstance(noun, Noun) or noun.kind != "thing":
        return False
    end, several = at + 1, noun.many and noun.det != "each"
    while _lists_nothing(chunks, at - 1) and (after := next_listed(chunks, end)):
        end, several = after, True
    verb = chunk_at(chunks, _place_end(chunks, end))
    if not isinstance(verb, Connector) or verb.sort != "verbs" or is_of_several(verb) != several:
        return False
    return verb.value in _SAYING_WHERE or noun.det in _POINTING


def _place_end(chunks: Sequence[Chunk], at: int) -> int:
    """Where words end that tell where something is, or what it has: "on a tripod", "on top of it"."""
    while is_link(chunk_at(chunks, at), "prepositions") and isinstance(chunk_at(chunks, at + 1), Noun):
        at += 2
    return at


def _lists_nothing(chunks: Sequence[Chunk], joint: int) -> bool:
    """Whether what is told before the "and" at `joint` ends with a comma, or with where something is."""
    led = chunks[joint - 2] if joint > 1 else None
    where = is_link(led, "prepositions") and not is_link(led, "prepositions", "with", "of", "as", "for")
    return where or is_link(chunks[joint - 1], "mark")


def _is_in_list(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether two things that a comma parts stand before the comma at `at`, and the last of the list after "and"."""
    last, verb = (*chunks[at + 2 : at + 4], None, None)[:2]
    if at < len(("a book", ",", "a vase")) or not is_link(chunks[at - 2], "mark", "comma"):
        return False
    if not all(map(_is_thing, (chunks[at - 3], chunks[at - 1], last))):
        return False
    if not isinstance(verb, Connector) or verb.sort != "verbs":
        return True
    return is_of_several(verb) and (not _is_many(last) or _begins_statement(chunks, at - 3))


def _is_thing(chunk: Chunk | None) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "thing"


def _is_many(chunk: Chunk | None) -> bool:
    return isinstance(chunk, Noun) and chunk.many


def _begins_statement(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether the list that the thing at `at` belongs to is what a statement begins with."""
    while at > 1 and is_link(chunks[at - 1], "mark", "comma") and _is_thing(chunks[at - 2]):
        at -= 2
    return not at or is_link(chunks[at - 1], "mark", "stop", "semicolon", "colon")
