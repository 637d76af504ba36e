"""What people do, which asks for nothing: "the kids bump into it", "my father repairs clocks", "guests complain"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.knowledge.vocabulary import is_person, name_of
from thinkblox.reading.english.chunks import Chunk, Noun, chunk_at, filler
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_ROBOT = "robot"
_LONGEST = 12
"""Most chunks of what they do."""


def with_people_doing(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, where what people do with nothing that is new is filler, up to the end of its clause."""
    made, at = [*_with_robot(chunks)], 0
    while at < len(made):
        end = _end(made, at) if _begins(made, at) else at
        made[at:end] = [chunk if _is_room(chunk) else filler(chunk) for chunk in made[at:end]]
        at = max(end, at + 1)
    return made


def _with_robot(chunks: Sequence[Chunk]) -> Iterator[Chunk]:
    """The chunks with a robot for "the robot" that faces something, or stands somewhere, where none was named."""
    for at, chunk in enumerate(chunks):
        if isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.word == _ROBOT:
            yield from chunks[at:]
            return
        robot = isinstance(chunk, Noun) and chunk.kind == "people" and chunk.text.lower() == f"the {_ROBOT}"
        begins = not at or is_link(chunks[at - 1], "mark", "stop", "semicolon")
        if robot and isinstance(chunk, Noun) and begins and is_link(chunk_at(chunks, at + 1), "verbs", "face", "stand"):
            yield replace(chunk, kind="thing", value=_ROBOT, det="a")
            yield from chunks[at + 1 :]
            return
        yield chunk


def _begins(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a clause begins with people and with what they do, which is no verb that places anything."""
    before = chunks[at - 1] if at else None
    if before is not None and not is_link(before, "mark") and not is_link(before, "joins"):
        return False
    chunk = chunks[at]
    if not isinstance(chunk, Noun):
        return False
    if chunk.kind == "people":
        verb = chunk_at(chunks, at + 1)
        return is_link(verb, "verbs", "other") and getattr(verb, "text", "").lower() in grammar().lists["trades"]
    words = [word.lower() for word in chunk.text.split()][chunk.det in ("the", "my") :]
    strange = chunk.kind == "thing" and not (chunk.named or chunk.count) and len(words) == len(("guests", "complain"))
    return strange and is_person(words[0]) and name_of(words[1:]) is None and _agree(*words, definite=bool(chunk.det))


def _agree(person: str, verb: str, *, definite: bool) -> bool:
    """Whether a word can be the verb of people, and so no second noun: "kids bump", "my flatmate moved"."""
    if person.endswith("s") or person in ("children", "people"):
        return not verb.endswith("s")
    return definite and verb.endswith(("s", "ed"))


def _is_room(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "room"


def _end(chunks: Sequence[Chunk], at: int) -> int:
    """Where the clause ends; `at` where it names what is new, says where what they use is, or goes on for long."""
    known = getattr(chunks[at], "kind", "") == "people"
    for end in range(at + 1, min(at + _LONGEST, len(chunks) + 1)):
        chunk = chunk_at(chunks, end)
        if chunk is None or is_link(chunk, "mark"):
            return end
        new = isinstance(chunk, Noun) and chunk.kind == "thing" and (chunk.count or chunk.det in ("a", "each", "no"))
        if new or (known and is_link(chunk, "prepositions")):
            return at
        verb = chunks[end + 1] if end + 1 < len(chunks) else None
        if end > at + 1 and isinstance(chunk, Noun) and is_link(verb, "verbs", "be", "stand", "have", "face", "hang"):
            return end - is_link(chunks[end - 1], "joins")
    return at
