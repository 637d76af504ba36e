"""What stands between several belongs to none of them: "a sofa and a cabinet with a lamp between them"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link


def with_things_between(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is between "them" is listed with them, rather than had by the last of them."""
    made = list(chunks)
    for at, link in enumerate(chunks):
        if is_link(link, "prepositions", "with") and isinstance(link, Connector) and _is_of_none(chunks, at):
            made[at] = replace(link, sort="joins", value="and")
    return made


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
