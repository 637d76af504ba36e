"""What is said once more between commas of the thing named just before: "his stool, the only seat in there, ..."."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray, filler
from thinkblox.reading.english.said import is_link

_MOST = 6
"""Most chunks of what is said once more."""


def with_apposed(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "the only seat" names nothing new, and "the one with the castle" has the castle."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        length = _only_one(chunks, at) if _is_after_thing(chunks, at) else 0
        if length:
            made += [filler(chunk) for chunk in chunks[at : at + length]]
            at += length
        elif _is_named_again(chunks, at):
            begun = len(made) - (bool(made) and is_link(made[-1], "prepositions"))
            made[begun:] = [filler(chunk) for chunk in [*made[begun:], chunks[at]]]
            at += 1
        elif (counted := _numbered(chunks, at)) is not None:
            made += [counted, filler(chunks[at + 1]), filler(chunks[at + 2])]
            at += 3
        elif (look := _look_again(chunks, at)) is not None:
            made += [Connector("verbs", "be", look.start, look.start, "is"), look]
            made.append(Connector("joins", "and", look.end, look.end, "and"))
            at += 3
        elif _is_after_thing(chunks, at) and _is_one_with(chunks, at + 1):
            at += 2
        elif _is_counted_instead(made, chunks[at : at + 2]):
            instead, number = made[-3], chunks[at + 1]
            assert isinstance(instead, Noun)
            assert isinstance(number, Noun)
            made[-3] = replace(instead, count=number.count, least=number.least, most=number.most)
            made += [filler(chunk) for chunk in chunks[at : at + 2]]
            at += 2
        else:
            made.append(chunks[at])
            at += 1
    return made


def _is_named_again(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether what is named is named with its number after a colon: "benches: two pine benches"."""
    bare, colon, counted = (*chunks[at : at + 3], None, None)[:3]
    if not isinstance(bare, Noun) or not isinstance(counted, Noun) or not is_link(colon, "mark", "colon"):
        return False
    plain = bare.kind == "thing" and bare.plural and not (bare.det or bare.count or bare.attributes or bare.unshown)
    return plain and counted.kind == "thing" and counted.value == bare.value and bool(counted.count)


def _numbered(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The thing of "television: 1, on the wall" with its number."""
    bare, colon, number, end = (*chunks[at : at + 4], None, None, None)[:4]
    if not isinstance(bare, Noun) or not isinstance(number, Noun) or not is_link(colon, "mark", "colon"):
        return None
    plain = bare.kind == "thing" and not (bare.det or bare.count or bare.plural) and number.text.isdigit()
    one = plain and number.kind == "number" and number.count == 1 and (end is None or is_link(end, "mark"))
    return replace(bare, count=number.count) if one else None


def _look_again(chunks: Sequence[Chunk], at: int) -> Adjective | None:
    """What "the second, a black one, has" says of the second."""
    which = chunks[at - 1] if at else None
    comma, one, end, verb = (*chunks[at : at + 4], None, None, None, None)[:4]
    if not isinstance(which, Noun) or which.kind != "number" or not which.ordinal or not is_link(verb, "verbs"):
        return None
    if not is_link(comma, "mark", "comma") or not is_link(end, "mark", "comma") or not isinstance(one, Noun):
        return None
    if one.kind != "number" or one.det != "a" or not one.attributes:
        return None
    return Adjective(one.start, one.end, one.text, [*one.attributes], unshown=[*one.unshown], states=[*one.states])


def _is_after_thing(chunks: Sequence[Chunk], at: int) -> bool:
    before = chunks[at - 1] if at else None
    return isinstance(before, Noun) and before.kind == "thing" and is_link(chunks[at], "mark", "comma")


def _only_one(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks ", the only seat in there," has; 0 where it does not come."""
    start = at + 2 if at + 1 < len(chunks) and isinstance(chunks[at + 1], Stray) else at + 1
    only, kind = (*chunks[start : start + 2], None, None)[:2]
    named = isinstance(kind, Noun) and kind.kind in ("thing", "number") and not kind.many and not kind.det
    if start == at + 1 or not is_link(only, "negations", "only") or not named:
        return 0
    ends = (n for n in range(start + 2, min(start + _MOST, len(chunks))) if is_link(chunks[n], "mark"))
    end = next(ends, 0)
    if not end:
        return 0
    return end + 1 - at if is_link(chunks[end], "mark", "comma") else end - at


def _is_one_with(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "the one with a castle" comes."""
    one, link = (*chunks[at : at + 2], None, None)[:2]
    return isinstance(one, Noun) and one.text.lower() == "the one" and is_link(link, "prepositions", "with")


def _is_counted_instead(made: Sequence[Chunk], said: Sequence[Chunk]) -> bool:
    """Whether a number tells how many there are in place of others: "stools instead of chairs, exactly four"."""
    thing, link, other = (None, None, None, *made[-3:])[-3:]
    several = isinstance(thing, Noun) and thing.kind == "thing" and thing.count is None and thing.plural
    number = said[1] if len(said) > 1 and is_link(said[0], "mark", "comma") else None
    told = isinstance(number, Noun) and number.kind == "number" and bool(number.count) and not number.of_known
    return several and is_link(link, "prepositions", "instead") and isinstance(other, Noun) and told
