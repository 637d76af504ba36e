"""What stands between several belongs to none of them: "a sofa and a cabinet with a lamp between them"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link


def with_things_between(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is between "them" is listed with them, rather than had by the last of them."""
    made = list(chunks)
    for at, link in enumerate(chunks):
        if is_link(link, "prepositions", "with") and isinstance(link, Connector) and _is_of_none(chunks, at):
            made[at] = replace(link, sort="joins", value="and")
    return _between_both(made)


def _between_both(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the two that are meant: "a lamp on the left, a vase on the right and a clock in between"."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        chunk, after = chunks[at], chunk_at(chunks, at + 1)
        them = isinstance(after, Noun) and (after.kind, after.value) == ("pronoun", "them")
        elided = them or after is None or is_link(after, "mark")
        two = _at_both_sides(made[:-1]) if elided and is_link(chunk, "prepositions", "between") else []
        made.append(chunk)
        at += 1
        if two:
            one, other = (replace(n, start=chunk.end, end=chunk.end, det="the", text=f"the {n.word}") for n in two)
            made += [one, Connector("joins", "and", chunk.end, chunk.end, "and"), other]
            at += them
    return made


def _at_both_sides(before: Sequence[Chunk]) -> list[Noun]:
    """The single things that were just listed at the left and at the right."""
    said = [c for c in before[-10:] if not (is_link(c, "mark", "comma") or is_link(c, "joins", "and"))][-6:]
    if len(said) < 6:
        return []
    one, at, left, other, by, right = said
    sides = isinstance(left, Noun) and isinstance(right, Noun) and {left.value, right.value} == {"left", "right"}
    placed = is_link(at, "prepositions", "on", "to", "at") and is_link(by, "prepositions", "on", "to", "at")
    two = [n for n in (one, other) if isinstance(n, Noun) and n.kind == "thing" and not n.many]
    return two if sides and placed and len(two) == 2 else []


def _is_of_none(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "with" comes after the last of single things, or after a comma, and is not said of "them"."""
    before = [*chunks[max(at - len(("a sofa", "and", "a desk")), 0) : at]]
    things = [isinstance(c, Noun) and c.kind == "thing" for c in before]
    single = not any(isinstance(c, Noun) and c.many for c in before)
    listed = things == [True, False, True] and single and is_link(before[1], "joins", "and")
    placed = len(before) > 1 and things[-2] and is_link(before[0], "prepositions")
    parted = bool(before) and is_link(before[-1], "mark", "comma") and not placed
    return (listed or parted) and _ends_between(chunks, at + 1)


def _ends_between(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether one thing comes, and then that it is between "them"."""
    said = [*chunks[at : at + len(("a lamp", "between", "them"))]]
    if len(said) < len(("a lamp", "between", "them")) or not is_link(said[1], "prepositions", "between"):
        return False
    noun, _, them = said
    is_thing = isinstance(noun, Noun) and noun.kind == "thing"
    return is_thing and isinstance(them, Noun) and (them.kind, them.value) == ("pronoun", "them")
