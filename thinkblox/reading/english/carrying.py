"""Things told of by what stands on or at them: "the table on which the lamp stands is next to the sofa"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.said import is_link

_CARRYING = ("on", "on_top", "under", "in")
_STANDS = 4
"""So many chunks come before the verb of "the table on which the lamp stands"."""
_PAIR = 2
_WHAT_FOR = ("be", "stand", "hang", "lie", "sit")


def with_carrying(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is told by what stands on it is what the sentence goes on about: "with the lamp on it"."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        anchor = bool(made) and is_link(made[-1], "prepositions") and not is_link(made[-1], "prepositions", "with")
        if length := _told_so(chunks, at, anchor=anchor):
            goes_on = is_link(chunk_at(chunks, at + length), "verbs")
            fronted = goes_on and anchor and (len(made) < _PAIR or is_link(made[-2], "mark"))
            if fronted:
                made[-1:] = _told_before(chunks, at, made[-1])
            else:
                made += _with_it(chunks, at) if goes_on else _told_by_itself(chunks, at)
            at += length
        else:
            made.append(chunks[at])
            at += 1
    return made


def _with_it(chunks: Sequence[Chunk], at: int) -> list[Chunk]:
    """The thing with the other on it."""
    thing, link, which, other = chunks[at : at + _STANDS]
    it = Noun("pronoun", "it", which.start, which.end, "it")
    return [thing, Connector("prepositions", "with", link.start, link.start, "with"), other, link, it]


def _told_by_itself(chunks: Sequence[Chunk], at: int) -> list[Chunk]:
    """The thing, and that the other is on it told in brackets: "near the shelf (the hats are on the shelf)"."""
    thing, link, which, other, stands = chunks[at : at + _STANDS + 1]
    assert isinstance(thing, Noun)
    known = replace(thing, start=which.start, end=which.end, det="the", text=f"the {thing.word}", count=None)
    opens = Connector("mark", "open", link.start, link.start, "(")
    return [thing, opens, other, stands, link, known, Connector("mark", "close", stands.end, stands.end, ")")]


def _told_before(chunks: Sequence[Chunk], at: int, place: Chunk) -> list[Chunk]:
    """What stands on the thing, told before what is at it: "next to the table on which a printer is, is a bin"."""
    thing, link, which, other, stands = chunks[at : at + _STANDS + 1]
    assert isinstance(thing, Noun)
    known = replace(thing, start=which.start, end=which.end, det="the", text=f"the {thing.word}", count=None)
    semicolon = Connector("mark", "semicolon", link.start, link.start, ";")
    return [other, stands, link, thing, semicolon, place, known]


def _told_so(chunks: Sequence[Chunk], at: int, *, anchor: bool) -> int:
    """How many chunks a thing, "on which", another thing and "stands" are; 0 where these do not come.

    Unless something is said to be at the thing, a verb has to follow that is told of it.
    """
    said = chunks[at : at + _STANDS + 1]
    if len(said) <= _STANDS:
        return 0
    thing, link, which, other, stands = said
    things = all(isinstance(noun, Noun) and noun.kind == "thing" for noun in (thing, other))
    placed = is_link(link, "prepositions", *_CARRYING) and is_link(which, "joins", "which")
    if not things or not placed or not is_link(stands, "verbs", *_WHAT_FOR):
        return 0
    end = at + _STANDS + 1
    if is_link(stands, "verbs", "be") and _is_way(chunk_at(chunks, end)):
        end += 1
    after = chunk_at(chunks, end)
    ends = after is None or is_link(after, "mark")
    return end - at if is_link(after, "verbs") or (anchor and ends) else 0


def _is_way(chunk: Chunk | None) -> bool:
    """Whether it tells how a thing is there: "are drying", "are displayed"."""
    bare = isinstance(chunk, Noun) and chunk.kind == "abstract" and not chunk.det and chunk.count is None
    return bare or isinstance(chunk, (Stray, Adjective)) or is_link(chunk, "participles")
