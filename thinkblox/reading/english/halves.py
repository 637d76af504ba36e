"""Shares of so many as were named: "a lamp on half of the eight desks" is on four of them."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link


def with_halves(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the number in place of a share of several of which the number is known."""
    made = list(chunks)
    for at, said in enumerate(made):
        share = _share(said) if isinstance(said, Noun) else None
        if not isinstance(said, Noun) or share is None:
            continue
        if said.kind == "pronoun" and not (at and is_link(made[at - 1], "prepositions")):
            continue  # Who reads clauses knows better what "half of them" are that have something.
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
    """How many were named, of which it is a share; 0 where that is not known, or where "them" may be one or another."""
    several = [c for c in before if isinstance(c, Noun) and c.kind == "thing" and c.many and c.count and c.rows >= 0]
    alike = several if said.kind == "pronoun" else [c for c in several if c.value == said.value]
    if not alike or (said.kind == "pronoun" and len({c.value for c in alike}) > 1):
        return 0
    return (alike[-1].count or 0) * max(1, alike[-1].rows) * _places_of(alike[-1], before)


def _places_of(several: Noun, before: Sequence[Chunk]) -> int:
    """At how many places there are as many: two for "eight lockers along each of two opposite walls"."""
    at = next(n for n, chunk in enumerate(before) if chunk is several)
    link, place = (*before[at + 1 : at + 3], None, None)[:2]
    each = isinstance(place, Noun) and place.kind == "place" and place.det == "each" and is_link(link, "prepositions")
    return place.count or 1 if each and isinstance(place, Noun) else 1
