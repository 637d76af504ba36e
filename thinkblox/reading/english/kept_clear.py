"""What is to have nothing on or in it: "leave the shelf empty", "the desk is clear"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_EMPTY = "empty"
_BARE = "bare"
"""What walls are on which nothing hangs."""
_LEAVING = ("leave", "keep", "leaving", "keeping")

_REST = frozenset(("rest", "remaining"))


def with_kept_clear(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a thing that is left or is clear is said to be empty, and of its parts that is not understood."""
    made = list(chunks)
    at = 0
    while at < len(made):
        if _is_left(made, at) and isinstance(noun := made[at + 1], Noun):
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
    said = chunks[at] if at < len(chunks) else None
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
