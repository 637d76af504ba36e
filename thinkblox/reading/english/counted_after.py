"""Numbers and sizes told after what they are of: "nightstand (2)", "the rug measures 2 m by 3 m"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Measured, Noun
from thinkblox.reading.english.said import is_link

_BOUNDS = {
    **dict.fromkeys(("at most", "at the most", "at the very most", "or fewer", "or less", "maximum", "max"), "most"),
    **dict.fromkeys(("at least", "at the least", "at the very least", "minimum"), "least"),
}
"""What bounds a number that comes before it."""
_LONGEST = 3
"""Most chunks of that."""
_SHARED = 4
"""Chunks of "(2, one"."""
_WHERE = 6
"""Most chunks that a colon, a place and the mark after them have."""
_SIDES = ("each", "either", "both")


def with_counts_after(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a lone number in brackets counts the thing before it; what flanks a thing is at both sides."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        number = _number(chunks[at : at + 3])
        thing = made[-1] if made else None
        if number and isinstance(thing, Noun) and thing.kind == "thing" and thing.count is None and not thing.definite:
            made[-1] = replace(thing, count=number, plural=number > 1)
            at += 3
        elif isinstance(thing, Noun) and (shared := _shared(thing, chunks[at : at + _SHARED])):
            made[-1] = replace(thing, count=shared, plural=shared > 1)
            made.append(Connector("mark", "comma", chunks[at + 2].start, chunks[at + 2].end, ","))
            at += _SHARED - 1
        elif isinstance(thing, Noun) and (bound := _bound(thing, chunks, at)):
            most = bound[0] == "most"
            made[-1] = replace(thing, most=thing.count) if most else replace(thing, least=thing.count)
            at += bound[1]
        elif isinstance(thing, Noun) and (told := _told_number(thing, chunks[at : at + 3])):
            made[-1] = replace(thing, end=told.end, count=told.count, plural=(told.count or 0) > 1)
            at += 2
        elif isinstance(thing, Noun) and thing.kind == "thing" and _is_where(thing, chunks[at : at + _WHERE]):
            made.append(Connector("mark", "comma", chunks[at].start, chunks[at].end, ","))
            at += 1
        elif _is_both_sides(chunks, at):
            at += 2
        elif _is_measuring(chunks, at):
            made.append(Connector("verbs", "be", chunks[at].start, chunks[at].end, "is"))
            at += 1
        else:
            made.append(chunks[at])
            at += 1
    return made


def _told_number(thing: Noun, after: Sequence[Chunk]) -> Noun | None:
    """The number of "chairs: two, one here and one there", which begins a list of where they are."""
    if len(after) < _LONGEST or thing.kind != "thing" or thing.count is not None or not thing.plural or thing.det:
        return None
    colon, number, comma = after
    lone = isinstance(number, Noun) and number.kind == "number" and number.count and not number.attributes
    told = is_link(colon, "mark", "colon") and lone and is_link(comma, "mark", "comma")
    return number if told and isinstance(number, Noun) else None


def _is_where(thing: Noun, after: Sequence[Chunk]) -> bool:
    """Whether a colon comes, and after it nothing but where things are: "chairs (4): around the table".

    Of a single thing it is understood with a colon as well, but for "to the left of".
    """
    if len(after) < _LONGEST or not is_link(after[0], "mark", "colon") or not is_link(after[1], "prepositions"):
        return False
    if not thing.many and not is_link(after[1], "prepositions", "to"):
        return False
    of = len(after) > _LONGEST + 1 and is_link(after[_LONGEST], "prepositions", "of")
    end = _LONGEST + 2 * of
    return isinstance(after[end - 1], Noun) and (len(after) == end or is_link(after[end], "mark", "stop", "semicolon"))


def _bound(thing: Noun, chunks: Sequence[Chunk], at: int) -> tuple[str, int] | None:
    """Whether "at most", "at the very least", "or fewer", "maximum" bounds a number before it, and its chunks."""
    if not thing.count or thing.least is not None or thing.most is not None or thing.vague or thing.definite:
        return None
    led = is_link(chunks[at], "prepositions", "at") or is_link(chunks[at], "joins", "or")
    end, words = at, ""
    while end < len(chunks) and end - at < _LONGEST and not is_link(chunks[end], "mark"):
        words = f"{words} {getattr(chunks[end], 'text', '')}".strip().lower()
        end += 1
        if (led or end - at == 1) and words in _BOUNDS:
            return _BOUNDS[words], end - at
    return None


def _is_measuring(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a thing measures what comes."""
    thing, measures, size = chunks[at - 1 : at + 2] if 0 < at < len(chunks) - 1 else (None, None, None)
    verb = isinstance(measures, Noun) and measures.text.lower() in ("measures", "measure")
    return isinstance(thing, Noun) and thing.kind == "thing" and verb and isinstance(size, Measured)


def _number(said: Sequence[Chunk]) -> int:
    """The number of "(2)"; 0 for other words."""
    opens, number, closes = (*said[:3], None, None, None)[:3]
    alone = isinstance(number, Noun) and number.kind == "number" and not (number.attributes or number.of_known)
    if not (is_link(opens, "mark", "open") and is_link(closes, "mark", "close") and alone):
        return 0
    return number.count or 0 if isinstance(number, Noun) else 0


def _shared(thing: Noun, after: Sequence[Chunk]) -> int:
    """The number in brackets before where each of them is: "lamp (2, one on each table)"; 0 for other words."""
    new = thing.kind == "thing" and thing.count is None and not thing.definite
    if len(after) < _SHARED or not new or not is_link(after[2], "mark", "comma"):
        return 0
    one = after[-1]
    each = isinstance(one, Noun) and one.kind in ("number", "pronoun") and one.count is not None
    return _number([*after[:2], Connector("mark", "close", 0, 0, ")")]) if each else 0


def _is_both_sides(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "on both sides" comes after "frame the bed", which says so by itself."""
    if at < 2 or not is_link(chunks[at - 2], "verbs", "flank"):
        return False
    on, side = (*chunks[at : at + 2], None, None)[:2]
    sides = isinstance(side, Noun) and side.kind == "part" and side.value in ("side", "end") and side.det in _SIDES
    return sides and isinstance(on, Connector) and is_link(on, "prepositions", "on", "at")
