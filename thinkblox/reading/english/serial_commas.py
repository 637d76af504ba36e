"""Commas before the "and" of a list: "a book, a vase, and a lamp are on it" is read as it is without the second one."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link


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


def is_of_several(verb: Chunk | None) -> bool:
    """Whether it is a verb of several: "are", "stand", "have"."""
    return isinstance(verb, Connector) and verb.sort == "verbs" and not verb.text.lower().split()[0].endswith("s")


def _is_thing(chunk: Chunk | None) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "thing"


def _is_many(chunk: Chunk | None) -> bool:
    return isinstance(chunk, Noun) and chunk.many


def _begins_statement(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether the list that the thing at `at` belongs to is what a statement begins with."""
    while at > 1 and is_link(chunks[at - 1], "mark", "comma") and _is_thing(chunks[at - 2]):
        at -= 2
    return not at or is_link(chunks[at - 1], "mark", "stop", "semicolon")
