"""What is to have nothing on or in it: "leave the shelf empty", "the desk is clear"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nothing_else import ANYTHING
from thinkblox.reading.english.said import is_link

_EMPTY = "empty"
_BARE = "bare"
"""What walls are on which nothing hangs."""
_LAST = 3
"""Chunks of "free of clutter" after what it is said of."""
_MOST = 2
"""Most chunks before "nothing" in "a desk with nothing on it", "there is nothing on the desk"."""
_LEAVING = ("leave", "keep", "leaving", "keeping")

_FREE_OF = ("free of", "clear of", "devoid of")
_CLUTTER = ANYTHING | {"clutter", "mess"}
"""What does not lie about where it is empty."""

_REST = frozenset(("rest", "remaining"))


def with_kept_clear(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a thing that is left or is clear is said to be empty, and of its parts that is not understood."""
    made = _uncluttered(chunks)
    at = 0
    while at < len(made):
        if length := _nothing_on(made, at):
            made[at : at + length] = _emptied(made, at, length)
        elif _is_left(made, at) and isinstance(noun := made[at + 1], Noun):
            made[at : at + 3] = _said(noun, made[at], made[at + 2])
        elif _is_clear(made, at) and _holds_only(made, at):
            told = at > 0 and is_link(made[at - 1], "verbs", "be")
            sort, word = ("verbs", "hold") if told else ("prepositions", "with")
            first, last = made[at - told], made[at + 1]
            made[at - told : at + 2] = [Connector(sort, word, first.start, last.end, word)]
        elif length := _bare_walls(made, at):
            walls = next(c for c in made[at : at + length] if isinstance(c, Noun))
            nothing = Connector("negations", "nothing", walls.start, walls.start, "nothing")
            on = Connector("prepositions", "on", walls.start, walls.start, "on")
            made[at : at + length] = [nothing, on, walls]
            at += 2
        elif _is_told(made, at) and isinstance(noun := made[at], Noun):
            made[at : at + 3] = _said(noun, noun, made[at + 2])
        at += 1
    return made


def _uncluttered(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, with "empty" for what says of a thing that nothing lies about there: "free of clutter"."""
    made: list[Chunk] = []
    for chunk in chunks:
        made.append(chunk)
        thing, link, clutter = (None, None, None, *made[-_LAST:])[-_LAST:]
        said = thing if not is_link(thing, "verbs", "be") else made[-4] if len(made) > _MOST + 1 else None
        free = isinstance(link, Connector) and link.value in ("without", "far") and link.text.lower() in _FREE_OF
        cluttered = isinstance(clutter, Noun) and not _CLUTTER.isdisjoint(clutter.text.lower().split())
        if free and cluttered and isinstance(said, Noun) and (said.kind == "thing" or _is_shelf(said)):
            assert link is not None
            made[-2:] = [Adjective(link.start, chunk.end, _EMPTY, states=[_EMPTY])]
    return made


def _nothing_on(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks say that a thing has nothing on it, which is not "nothing but a vase"; 0 where none do."""
    end = at
    while end - at < _MOST and end < len(chunks) and not _is_nothing(chunks[end]):
        end += 1
    where, ends = (*chunks[end + 1 : end + 3], None, None)[:2], end + 3
    after = chunks[ends] if ends < len(chunks) else None
    none = end < len(chunks) and _is_nothing(chunks[end])
    on = none and is_link(where[0], "prepositions", "on", "on_top", "in")
    if not on or not isinstance(noun := where[1], Noun) or not _ends(after):
        return 0
    lead, its = chunks[at:end], noun.value in ("it", "them") or (noun.kind == "part" and noun.value == "top")
    if len(lead) == _MOST and its and isinstance(lead[0], Noun) and lead[0].kind in ("thing", "number"):
        having = is_link(lead[1], "prepositions", "with") or is_link(lead[1], "verbs", "have")
        return ends - at if having or is_link(lead[1], "mark", "comma") else 0
    begins = not at or is_link(chunks[at - 1], "mark", "stop", "semicolon")
    there = not lead or (len(lead) == 1 and is_link(lead[0], "verbs", "be"))
    return ends - at if begins and there and (_is_whole(noun) or noun.value == "it") else 0


def _is_nothing(chunk: Chunk) -> bool:
    """Whether it is "nothing", rather than "nothing else", or "no objects"."""
    if isinstance(chunk, Noun) and chunk.det == "no" and chunk.kind in ("abstract", "thing"):
        return chunk.word in ("object", "item", "thing", "stuff") and not chunk.attributes
    return isinstance(chunk, Connector) and chunk.sort == "negations" and chunk.text.lower() == "nothing"


def _ends(after: Chunk | None) -> bool:
    """Whether no exception comes, and nothing that tells where."""
    return after is None or is_link(after, "mark") or is_link(after, "joins", "and")


def _emptied(chunks: Sequence[Chunk], at: int, length: int) -> list[Chunk]:
    """What is said to have nothing on it, said to be empty."""
    first, last = chunks[at], chunks[at + length - 1]
    assert isinstance(last, Noun)
    if isinstance(first, Noun) and first is not last and not _is_nothing(first):
        rest = Connector("fillers", "words", first.end, last.end, "nothing on it")
        return [replace(first, states=[*first.states, _EMPTY]), rest]
    be = Connector("verbs", "be", last.end, last.end, "is")
    return [replace(last, start=first.start), be, Adjective(last.end, last.end, _EMPTY, states=[_EMPTY])]


def _is_left(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "leave the shelf empty" comes."""
    link = chunks[at]
    leaves = isinstance(link, Connector) and link.sort == "verbs" and link.text.lower() in _LEAVING
    return leaves and _is_clear(chunks, at + 2) and _is_whole(chunks[at + 1])


def _bare_walls(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "keep the walls bare", "the walls are bare", "bare walls" have; 0 where they do not come."""
    link = chunks[at]
    keeps = isinstance(link, Connector) and link.sort == "verbs" and link.text.lower() in _LEAVING
    walls, said = (*chunks[at + keeps : at + keeps + 2], None, None)[:2]
    if not isinstance(walls, Noun) or walls.kind != "place" or walls.value != "wall":
        return 0
    if walls.text.lower().split()[0] == _BARE and walls.plural:
        return 1
    told = not keeps and is_link(said, "verbs", "be")
    bare = chunks[at + 2] if told and at + 2 < len(chunks) else said
    return 2 + (keeps or told) if (keeps or told) and isinstance(bare, Adjective) and bare.text.lower() == _BARE else 0


def _is_told(chunks: Sequence[Chunk], at: int) -> bool:
    if not _is_clear(chunks, at + 2) or not is_link(chunks[at + 1], "verbs", "be") or not _is_whole(chunks[at]):
        return False
    return not at or not is_link(chunks[at - 1], "prepositions", "joins")


def _holds_only(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "empty except for a vase" is told of a thing, which then holds that."""
    but, thing = (*chunks[at + 1 : at + 3], None, None)[:2]
    excepted = is_link(but, "prepositions", "except") or is_link(but, "joins", "but")
    before = next((c for c in reversed(chunks[:at]) if isinstance(c, Noun)), None)
    held = isinstance(thing, Noun) and thing.kind == "thing" and not thing.definite
    return excepted and held and before is not None and before.kind in ("thing", "number", "pronoun", "part")


def _is_clear(chunks: Sequence[Chunk], at: int) -> bool:
    said = chunk_at(chunks, at)
    return isinstance(said, Adjective) and said.text.lower() in grammar().lists["uncluttered"]


def _is_whole(chunk: Chunk) -> bool:
    if not isinstance(chunk, Noun):
        return False
    rest = not _REST.isdisjoint(chunk.text.lower().split())
    return chunk.definite and not rest and (chunk.kind in ("thing", "number") or _is_shelf(chunk))


def _is_shelf(noun: Noun) -> bool:
    return noun.kind == "part" and noun.value == "in_shelf"


def _said(noun: Noun, first: Chunk, last: Chunk) -> list[Chunk]:
    if _is_shelf(noun):
        return [Stray(first.start, last.end, f"{noun.text} {getattr(last, 'text', '')}".strip())]
    said = last
    if isinstance(last, Adjective) and last.text.lower() != "open":
        said = replace(last, attributes=[], states=[_EMPTY])
    return [noun, Connector("verbs", "be", noun.end, noun.end, "is"), said]
