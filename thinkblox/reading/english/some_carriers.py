"""Some of those that have something, and have more: "on each desk is a lamp, on two of them also a monitor"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_WHERE = ("on", "on_top", "in", "inside", "under", "above", "behind", "next_to")


def with_some_carriers(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which so many of them are those that something lies on, and a clause of its own tells what."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        joint = made[-2] if len(made) > 1 else None
        begins = is_link(joint, "mark", "comma", "semicolon", "stop") and is_link(made[-1], "prepositions", *_WHERE)
        carriers = _carriers(made[:-2]) if begins and _is_some(chunk) and _tells(chunks, at + 1) else None
        if carriers is not None and isinstance(chunk, Noun) and joint is not None:
            made[-2] = Connector("mark", "semicolon", joint.start, joint.end, ";")
            text = f"{chunk.count} of the {carriers.word}s"
            chunk = replace(
                carriers, start=chunk.start, end=chunk.end, text=text, det="the", of_known=True, plural=True,
                count=chunk.count, total=chunk.total, rows=0,
            )  # fmt: skip
        made.append(chunk)
    return made


def _is_some(chunk: Chunk) -> bool:
    """Whether it is "two of them" or "three of the four"."""
    return isinstance(chunk, Noun) and chunk.kind in ("number", "pronoun") and chunk.of_known and chunk.many


def _tells(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether something new is told, with or without a verb."""
    while _is_passed(chunk_at(chunks, at)):
        at += 1
    new = chunk_at(chunks, at)
    return isinstance(new, Noun) and new.kind == "thing" and not new.definite


def _is_passed(chunk: Chunk | None) -> bool:
    """Whether it is a filler, "also", or the verb before what is told."""
    also = isinstance(chunk, Connector) and chunk.text.lower() == "also"
    return also or is_link(chunk, "fillers") or is_link(chunk, "verbs", "be", "stand")


def _carriers(before: Sequence[Chunk]) -> Noun | None:
    """What was named last that is several and no small thing."""
    named = (c for c in reversed(before) if isinstance(c, Noun) and c.kind == "thing")
    large = (noun for noun in named if not load_habits().is_in(noun.value, "small"))
    return next((noun for noun in large if noun.each or (noun.count or 0) > 1), None)
