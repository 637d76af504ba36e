"""Shares of so many as were named: "a lamp on half of the eight desks" is on four of them."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Noun


def with_halves(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the number in place of a share of several of which the number is known."""
    made = list(chunks)
    for at, said in enumerate(made):
        share = _share(said) if isinstance(said, Noun) else None
        if not isinstance(said, Noun) or share is None:
            continue
        total = said.count if said.det == "half" and said.count else _number_of(said, made[:at])
        if not total or total * share[0] % share[1]:
            continue
        count = total * share[0] // share[1]
        whole = total if said.det == "half" and said.count else 0
        told = replace(said, det="", count=count, of_known=True, fraction=(0, 0), total=whole, plural=count > 1)
        made[at] = replace(told, kind="number", value="") if said.kind == "pronoun" else told
    return made


def _share(said: Noun) -> tuple[int, int] | None:
    """What part of several it is: 1 and 2 for half of them."""
    if said.kind == "pronoun" and said.value == "half" and said.text.lower().startswith("half of"):
        return 1, 2
    if said.kind != "thing" or not said.of_known or said.share:
        return None
    return (1, 2) if said.det == "half" else said.fraction if said.fraction[1] and said.fraction[0] else None


def _number_of(said: Noun, before: Sequence[Chunk]) -> int:
    """How many of a kind were named last, of which it is a share; 0 where that is not known."""
    alike = (
        c
        for c in reversed(before)
        if isinstance(c, Noun) and c.kind == "thing" and c.many and (said.kind == "pronoun" or c.value == said.value)
    )
    named = next(alike, None)
    return (named.count or 0) * max(1, named.rows) if named is not None and named.rows >= 0 else 0
