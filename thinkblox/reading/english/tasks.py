"""What a robot is to do with things that are there: "clear the table", "the robot must put the mug on the shelf".

Where things are to be in the end is not where they are when the room is made: that is not asked of it.
"""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_MOST = 3
"""Most chunks that the words for one task are cut into."""
_GOAL = "goal"
"""What stands before the names of things that a goal speaks of."""


def with_tasks(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the words for what is done with a thing ask for nothing."""
    made = list(chunks)
    for at in range(len(made)):
        length = _task(made, at) if _begins(made, at) else 0
        if length:
            first, last = made[at], made[at + length - 1]
            made[at : at + length] = [Connector("fillers", "doing", first.start, last.end, _text(made[at:][:length]))]
    return made


def is_tasked(chunks: Sequence[Chunk], noun: Noun) -> bool:
    """Whether a phrase names what something is done with."""
    before = [c for c in chunks if c.end == noun.start]
    return any(is_link(c, "fillers", _GOAL) or (is_link(c, "fillers", "doing") and _is_known([c])) for c in before)


def with_goals(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a goal only names what is to be moved and what it is moved to."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        length, who = _goal(chunks, at), chunks[at]
        new = length and isinstance(who, Noun) and who.kind == "thing" and who.det == "a"
        made += [chunk if new and chunk is who else _filler(chunk, "words") for chunk in chunks[at : at + length]]
        at += length
        while length and at < len(chunks) and not is_link(chunks[at], "mark", "stop", "semicolon"):
            made += _aim(chunks, at)
            at += 1
        if not length:
            made.append(chunks[at])
            at += 1
    return made


def _goal(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks say that a goal comes, up to its verb: "the robot must", "task:"; 0 where none does."""
    who = chunks[at]
    if not isinstance(who, Noun) or (at and is_link(chunks[at - 1], "prepositions")):
        return 0
    robot, goal = who.word in grammar().lists["robots"], who.word in grammar().lists["goals"]
    end = at + 1
    while end < len(chunks) and end - at <= _MOST and (robot or goal) and not _moves(chunks[end]):
        if not _leads(chunks[end], goal=goal):
            return 0
        end += 1
    return end - at if at + 1 < end < len(chunks) and _moves(chunks[end]) else 0


def _moves(chunk: Chunk) -> bool:
    """Whether it is a word for putting things somewhere else."""
    return _words(chunk).partition(" ")[0] in grammar().lists["moving"]


def _leads(chunk: Chunk, *, goal: bool) -> bool:
    """Whether a chunk stands between who does something, or the word for a goal, and what is to be done."""
    if is_link(chunk, "verbs", "be", "have") or is_link(chunk, "fillers") or is_link(chunk, "prepositions", "to"):
        return True
    return (goal and is_link(chunk, "mark", "colon")) or _words(chunk) in grammar().lists["modals"]


def _aim(chunks: Sequence[Chunk], at: int) -> list[Chunk]:
    """What a chunk of a goal is read as."""
    chunk = chunks[at]
    if isinstance(chunk, Noun) and chunk.kind == "thing" and _words(chunk) not in grammar().lists["moving"]:
        before = chunks[at - 1]
        chunk = replace(chunk, det="the") if not chunk.det and chunk.plural and chunk.count is None else chunk
        taken = is_link(before, "prepositions", "from")
        stop = Connector("mark", "stop", chunk.start, chunk.start)
        return [chunk] if taken else [stop, Connector("fillers", _GOAL, chunk.start, chunk.start), chunk]
    if is_link(chunk, "prepositions", "from") and isinstance(chunk, Connector):
        return [replace(chunk, value="on")]
    taken = isinstance(chunk, Noun) and chunk.kind == "place" and is_link(chunks[at - 1], "prepositions", "from")
    return [chunk] if taken or isinstance(chunk, Adjective) else [_filler(chunk, "words")]


def _filler(chunk: Chunk, value: str) -> Connector:
    return Connector("fillers", value, chunk.start, chunk.end, _words(chunk))


def _words(chunk: Chunk) -> str:
    return str(getattr(chunk, "text", "")).lower()


def _task(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks name what is done with the thing that comes after them; 0 where they do not."""
    for length in range(_MOST, 0, -1):
        after = chunks[at + length] if at + length < len(chunks) else None
        known = isinstance(after, Noun) and after.kind == "thing" and after.det in ("the", "all")
        if known and _is_known(chunks[at : at + length]):
            return length
    return 0


def _is_known(chunks: Sequence[Chunk]) -> bool:
    return _text(chunks).lower() in grammar().lists["tasks"]


def _text(chunks: Sequence[Chunk]) -> str:
    plain = [c.text for c in chunks if isinstance(c, Adjective | Connector | Noun)]
    return " ".join(plain) if len(plain) == len(chunks) else ""


def _begins(chunks: Sequence[Chunk], at: int) -> bool:
    before = chunks[at - 1] if at else None
    polite = is_link(before, "fillers") or is_link(before, "verbs", "put")
    return before is None or polite or is_link(before, "mark", "stop", "semicolon", "colon")
