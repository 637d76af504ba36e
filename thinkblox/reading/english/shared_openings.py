"""Windows and doors that are shared out: "three windows, two on the left wall and one on the right wall"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link, names_opening

_GROUP = 3
"""Chunks of "two on the left wall"."""


def with_shared_openings(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which so many windows are in each wall, "one" is one more of them, and one on each side is two."""
    made = list(chunks)
    at = -1
    while (at := at + 1) < len(made):
        opening = made[at]
        if not names_opening(opening):
            continue
        if groups := _shared_out(made, at, opening):
            end, shares = groups
            made[at:end] = shares
        elif (more := _one_more(made, at)) is not None:
            one = made[more]
            made[more] = replace(opening, start=one.start, end=one.end, det="a", count=1, plural=False, text="one")
        elif _is_on_both_sides(made, at, opening):
            link = Connector("prepositions", "next_to", made[at + 1].start, made[at + 3].end, "on each side of")
            made[at : at + 4] = [replace(opening, count=2, plural=True, det=""), link]
    return made


def _shared_out(chunks: Sequence[Chunk], at: int, opening: Noun) -> tuple[int, list[Chunk]] | None:
    """Where the list of walls ends that has all of several windows, and the windows of each; None for anything else."""
    start, left = at + 2, opening.count or 0
    if left < 2 or not is_link(chunk_at(chunks, at + 1), "mark", "comma", "colon", "dash"):
        return None
    made: list[Chunk] = []
    while left > 0:
        some, link, wall = (*chunks[start : start + _GROUP], None, None, None)[:_GROUP]
        walls = isinstance(wall, Noun) and wall.kind == "place" and wall.value.endswith("wall")
        if not isinstance(some, Noun) or some.kind not in ("number", "pronoun") or not some.count or not walls:
            return None
        if not is_link(link, "prepositions", "on", "in", "along") or link is None or wall is None:
            return None
        begins = some.start if made else opening.start
        named = replace(opening, start=begins, end=some.end, count=some.count, plural=some.count > 1, text=some.text)
        made += [named, link, wall]
        left, start = left - some.count, start + _GROUP
        while left and (is_link(chunk_at(chunks, start), "joins", "and") or is_link(chunk_at(chunks, start), "mark")):
            made.append(chunks[start])
            start += 1
    return (start, made) if not left else None


def _one_more(chunks: Sequence[Chunk], at: int) -> int | None:
    """Where "one" is after "two windows are on the left wall and"; None where it is not."""
    verb, link, wall, joined, one, goes_on = (*chunks[at + 1 : at + 7], *[None] * 6)[:6]
    placed = is_link(verb, "verbs", "be") and is_link(link, "prepositions") and isinstance(wall, Noun)
    told = placed and is_link(joined, "joins", "and") and isinstance(one, Noun) and one.kind in ("number", "pronoun")
    single = told and isinstance(one, Noun) and one.count == 1 and not one.attributes
    return at + 5 if single and (is_link(goes_on, "verbs", "be") or is_link(goes_on, "prepositions")) else None


def _is_on_both_sides(chunks: Sequence[Chunk], at: int, opening: Noun) -> bool:
    """Whether "(a window) on either side of" comes before a thing."""
    link, side, of, thing = (*chunks[at + 1 : at + 5], *[None] * 4)[:4]
    sided = isinstance(side, Noun) and (side.kind, side.value) == ("part", "side") and side.det in ("each", "either")
    named = isinstance(thing, Noun) and thing.kind == "thing" and is_link(of, "prepositions", "of")
    return opening.det == "a" and sided and named and is_link(link, "prepositions", "on", "to")
