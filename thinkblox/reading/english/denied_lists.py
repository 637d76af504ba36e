"""Lists that are denied as a whole, and what is told of the last thing denied: "without a sofa, a TV or plants"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.said import is_link

_ARTICLES = ("", "a", "any")
_LISTED = ("", "a", "any", "the", "no")
_DENYING = ("exclude", "gone", "not")
_CLAUSE = 4
"""So many chunks before a thing, at most, a verb that is denied stands."""


def with_denied_lists(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which all of a list that ends in "or" is denied, and "which" goes on with the last thing that was."""
    chunks = _denied_one_by_one(chunks)
    made = list(chunks)
    for at, chunk in enumerate(chunks):
        none = isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.det == "no"
        if is_link(chunk, "prepositions", "without") or none:
            for item in _items(chunks, at + 1 if not none else at):
                noun = chunks[item]
                if isinstance(noun, Noun) and item != at:
                    made[item] = replace(noun, det="no" if none else "", count=None if noun.det == "a" else noun.count)
    return _told_of_denied(made)


def _denied_one_by_one(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "no sofa, no TV" for "don't include a sofa, a TV" and "not needed: a sofa, a TV"."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        without = is_link(chunks[at], "prepositions", "without")
        denied = without or is_link(chunks[at], "negations", *_DENYING)
        colon = denied and is_link(chunk_at(chunks, at + 1), "mark", "colon")
        said = colon or without or (denied and is_link(chunks[at], "negations", "exclude"))
        listed, end = _listed(chunks, at + 1 + colon) if said else ([], at)
        many = len(listed) > 1 and not without
        if not listed or not (colon or many):
            made.append(chunks[at])
            at += 1
            continue
        made += [filler(chunk) for chunk in chunks[at : at + 1 + colon]]
        for noun in listed:
            made += [replace(noun, det="no", count=None), Connector("mark", "comma", noun.end, noun.end, ",")]
        made.pop()
        at = end
    return made


def _listed(chunks: Sequence[Chunk], at: int) -> tuple[list[Noun], int]:
    """The things that are listed up to the end of a statement, and where that is; none where anything else is said."""
    found: list[Noun] = []
    while isinstance(noun := chunk_at(chunks, at), Noun) and noun.kind == "thing" and noun.det in _LISTED:
        if noun.count is not None and noun.det not in _ARTICLES[1:]:
            return [], at
        found.append(noun)
        at += 1
        if (after := chunk_at(chunks, at)) is None or is_link(after, "mark", "stop", "semicolon", "close", "dash"):
            return found, at
        goes_on = chunk_at(chunks, at + 1)
        if (
            is_link(after, "mark", "comma")
            and isinstance(goes_on, Connector)
            and not is_link(goes_on, "joins", "and", "or")
        ):
            return found, at
        at += is_link(after, "mark", "comma")
        at += is_link(chunk_at(chunks, at), "joins", "and", "or")
    return [], at


def _items(chunks: Sequence[Chunk], at: int) -> list[int]:
    """Where the things of a list are that ends in "or"; none where it does not."""
    found: list[int] = []
    while at < len(chunks):
        noun = chunks[at]
        if not isinstance(noun, Noun) or noun.kind != "thing" or (found and noun.det not in _ARTICLES):
            return []
        found.append(at)
        before = chunks[at - 1] if at else None
        if len(found) > 1 and is_link(before, "joins", "or"):
            return found
        link, joined = (*chunks[at + 1 : at + 3], None, None)[:2]
        if is_link(link, "mark", "comma"):
            at += 3 if is_link(joined, "joins", "or") else 2
        elif is_link(link, "joins", "or"):
            at += 2
        else:
            return []
    return []


def _told_of_denied(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with a sentence of its own for "which stands in the middle" after "not on the bench,"."""
    for at in range(len(chunks) - 4, 0, -1):
        link, comma, which, verb = chunks[at - 1], *chunks[at + 1 : at + 4]
        noun = chunks[at]
        if not isinstance(noun, Noun) or noun.kind != "thing" or noun.det != "the" or not isinstance(comma, Connector):
            continue
        denied = any(is_link(c, "negations", "not") for c in chunks[max(0, at - _CLAUSE) : at])
        placed = isinstance(link, Connector) and link.sort == "prepositions"
        told = is_link(comma, "mark", "comma") and is_link(which, "joins", "which") and is_link(verb, "verbs")
        if denied and placed and told:
            stop = Connector("mark", "stop", comma.start, comma.end, comma.text)
            chunks[at + 1 : at + 3] = [stop, replace(noun, start=noun.end, end=noun.end)]
    return chunks
