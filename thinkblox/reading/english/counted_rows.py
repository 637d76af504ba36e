"""Rows or walls of which is told afterwards how many each has: "four rows of desks, five desks per row"."""

import re
from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Measured, Noun, Stray
from thinkblox.reading.english.said import is_link

_A_ROW = -1
"""How many rows "per row" and "in each row" name."""
_PER = ("per", "in", "to", "on")
_OF = ("of", "in")
_FACING = ("left_wall", "right_wall")
_BOTH = 2
_REACH = 9
"""So many chunks tell at most how many each row has, and how many rows there are."""
_BY_NUMBER = re.compile(r"[a-z0-9]+ ?(?:by|x) ?[a-z0-9]+")
"""Two numbers without a unit."""
_ROW = re.compile(r"(?:in|of|from) the (?:first|second|third|fourth|fifth|last|front|back|middle|rear) (?:row|column)")
"""What says in which row something is."""


_THOSE = ("those", "the ones", "all those", "all of those")
"""What stands for what was said to stand in rows."""


def with_counted_rows(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what stands in rows is counted: twenty desks in four rows."""
    chunks = _each_with(
        _on_walls(_joined_walls(_of_one_row(_one_of_each(_told_rows(_of_columns(_by_number(chunks)))))))
    )
    found: list[Chunk] = []
    at = 0
    while at < len(chunks):
        chunk = chunks[at]
        told = _told_after(chunks, at) if isinstance(chunk, Noun) and chunk.rows > 0 and chunk.count is None else None
        if told is not None and isinstance(chunk, Noun):
            each, end, length = told
            before = found[-2] if len(found) > 1 and is_link(found[-1], "prepositions", "in") else None
            if chunk.kind == "number" and isinstance(before, Noun) and before.count is None:
                found[-2] = replace(before, count=chunk.rows * each)
                chunk = replace(chunk, end=end)
            elif chunk.kind == "thing":
                chunk = replace(chunk, count=chunk.rows * each, end=end)
            at += length if chunk.end == end else 0
        found.append(_in_rows(chunk, found) if isinstance(chunk, Noun) and chunk.rows > 1 else chunk)
        at += 1
    return found


def _by_number(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with four rows of three for "rows of mats, four by three", which measures nothing."""
    made = list(chunks)
    for at in range(len(made) - 3, -1, -1):
        things, mark, size = made[at : at + 3]
        if not isinstance(things, Noun) or things.rows != _A_ROW or not isinstance(size, Measured):
            continue
        lengths = [length.metres for length in size.size.lengths]
        plain = not things.count and is_link(mark, "mark") and _BY_NUMBER.fullmatch(size.size.text.lower())
        if plain and len(lengths) == _BOTH and all(length.is_integer() for length in lengths):
            rows, each = map(int, lengths)
            made[at : at + 3] = [replace(things, rows=rows, count=rows * each, end=size.end)]
    return made


def _one_of_each(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "the first desk of each row" is so many desks; which of them is said not to be understood."""
    made = list(chunks)
    lines: dict[str, int] = {}
    for at in range(len(made)):
        one, link, row = (*made[at : at + 3], None, None, None)[:3]
        if isinstance(one, Noun) and one.rows > 1:
            lines |= {"column" if "columns" in one.text.lower().split() else "row": one.rows}
        each = isinstance(row, Noun) and row.det == "each" and row.word in lines
        place = isinstance(one, Noun) and one.kind == "thing" and one.det == "the" and bool(one.ordinal or one.side)
        of = isinstance(link, Connector) and is_link(link, "prepositions", *_OF)
        if of and each and place and isinstance(one, Noun) and isinstance(row, Noun) and link is not None:
            count, text = lines[row.word], f"{lines[row.word]} of the {one.word}s"
            some = replace(one, count=count, text=text, of_known=True, plural=True, ordinal=0, side="")
            made[at : at + 3] = [some, Stray(link.start, row.end, f"of {row.text}")]
    return made


def _of_one_row(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "every desk in the first row" is so many desks as a row has; which row is not understood."""
    made: list[Chunk] = []
    each: dict[str, int] = {}
    lined: Noun | None = None
    at = 0
    while at < len(chunks):
        chunk = chunks[at]
        rows = _in_rows_of(chunks, at) if isinstance(chunk, Noun) else None
        if rows is not None:
            lined, number = rows
            each[lined.value] = number
        elif isinstance(chunk, Noun) and lined is not None and chunk.text.lower() in _THOSE:
            chunk = replace(lined, start=chunk.start, end=chunk.end, det="the", text=f"the {lined.word}s", rows=0)
        after, row = (*chunks[at + 1 : at + 3], None, None)[:2]
        lost = isinstance(after, Stray) and _ROW.fullmatch(after.text.lower()) is not None
        of = isinstance(row, Noun) and row.rows == 1 and row.ordinal != 0 and is_link(after, "prepositions", *_OF)
        several = isinstance(chunk, Noun) and (chunk.det == "each" or (chunk.det == "the" and chunk.plural))
        chunk = chunk if lost or of else chunks[at]
        if (lost or of) and several and isinstance(chunk, Noun) and chunk.value in each:
            count = each[chunk.value]
            if made and is_link(made[-1], "joins", "and"):
                made[-1] = Connector("mark", "semicolon", made[-1].start, made[-1].end, ";")
            text = f"{count} of the {chunk.word}s"
            made.append(replace(chunk, det="the", count=count, text=text, of_known=True, plural=count > 1, every=0))
            at += 1
            if of and after is not None and row is not None:
                made.append(Stray(after.start, row.end, f"of {getattr(row, 'text', '')}"))
                at += 2
        else:
            made.append(chunk)
            at += 1
    return made


def _in_rows_of(chunks: Sequence[Chunk], at: int) -> tuple[Noun, int] | None:
    """What stands in rows, and how many of it in each: "four rows of five desks", "twenty desks in four rows"."""
    rows = chunks[at]
    if not isinstance(rows, Noun) or rows.rows <= 1:
        return None
    before = chunks[at - 2] if at > 1 and is_link(chunks[at - 1], "prepositions", "in") else None
    things = rows if rows.kind == "thing" else before
    if not isinstance(things, Noun) or things.kind != "thing" or not things.count or things.count % rows.rows:
        return None
    return things, things.count // rows.rows


def _told_rows(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "rows of chairs - four rows of five -" are as many as is told between the marks."""
    made = list(chunks)
    for at in range(len(made) - 3, -1, -1):
        things, mark, told, end = made[at], made[at + 1], made[at + 2], made[at + 3 : at + 4]
        if not isinstance(things, Noun) or not isinstance(told, Noun) or things.rows != _A_ROW or things.count:
            continue
        if told.kind == "number" and told.rows > 0 and told.count and is_link(mark, "mark", "dash", "open", "comma"):
            closed = bool(end) and is_link(end[0], "mark", "dash", "close", "comma")
            made[at : at + 3 + closed] = [replace(things, rows=told.rows, count=told.count, end=told.end)]
    return made


def _each_with(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "three rows, each with four desks", or "each row has four, and there are three" are so many."""
    made = list(chunks)
    for at in range(len(made) - 3, -1, -1):
        first = made[at]
        if not isinstance(first, Noun) or not first.rows or first.count:
            continue
        rest = [c for c in made[at + 1 : at + _REACH] if not is_link(c, "joins", "and")]
        rest = rest[1:] if is_link(rest[0], "mark") else rest
        padded: list[Chunk | None] = [*rest, None, None, None, None]
        each, having, things, after = *padded[:3], padded[3:]
        told: Noun | None = None
        if first.rows > 1 and isinstance(each, Noun) and each.value == "each" and _has(having):
            told = _in_each(things, first.rows, first)
        elif first.rows == _A_ROW and first.det == "each" and _has(each) and isinstance(having, Noun):
            if _counted_before(made, at, having, things):
                continue
            told, things, after = _rows_later(having, things, after)
        if told is not None and _ends(after[0]):
            end = next((n for n in range(at, len(made)) if made[n] is after[0]), len(made))
            made[at:end] = [replace(told, start=first.start)]
    return made


def _ends(chunk: Chunk | None) -> bool:
    return chunk is None or is_link(chunk, "mark", "stop", "semicolon")


def _counted_before(made: list[Chunk], at: int, things: Noun, after: Chunk | None) -> bool:
    """Count the rows of desks that were named before "each row has four desks", which then is told."""
    for back in range(at - 1, -1, -1):
        rows = made[back]
        if not isinstance(rows, Noun) or rows.rows <= 1:
            continue
        told = _in_each(things, rows.rows, rows) if rows.kind == "thing" and not rows.count and _ends(after) else None
        if told is not None:
            made[back] = replace(rows, count=told.count, plural=True)
            start, end = made[at].start, things.end
            made[at : at + 3] = [Connector("fillers", "words", start, end, "so many in each row")]
        return told is not None
    return False


def _has(chunk: Chunk | None) -> bool:
    return is_link(chunk, "prepositions", "with", "of") or is_link(chunk, "verbs", "have", "hold", "consist")


def _in_each(things: Chunk | None, rows: int, named: Noun) -> Noun | None:
    """So many rows of what each has; None where that is not what the rows are of."""
    if not isinstance(things, Noun) or things.kind != "thing" or not things.count or things.definite or things.rows:
        return None
    alike = named.kind == "number" or named.value == things.value
    return replace(things, count=rows * things.count, rows=rows, plural=True) if alike else None


def _rows_later(
    things: Noun, mark: Chunk | None, after: list[Chunk | None]
) -> tuple[Noun | None, Chunk | None, list[Chunk | None]]:
    """What each row has, where "there are three rows" comes next, and what comes then."""
    be, rows, *rest = [mark, *after, None, None] if is_link(mark, "verbs", "be") else [*after, None, None]
    counted = is_link(be, "verbs", "be") and isinstance(rows, Noun) and rows.kind == "number" and rows.rows > 1
    told = _in_each(things, rows.rows, rows) if counted and isinstance(rows, Noun) else None
    return told, rows, rest


def _joined_walls(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "the left and the right wall" are two walls, as "the left and right walls" are."""
    made = list(chunks)
    for at in range(len(made) - 3, 0, -1):
        if at + _BOTH >= len(made):
            continue  # What comes after was made one.
        one, joint, wall, after = made[at], made[at + 1], made[at + 2], made[at + 3 : at + 4]
        if not isinstance(one, Noun) or not isinstance(wall, Noun) or not is_link(joint, "joins", "and"):
            continue
        named = one.kind == "part" or (_is_wall(one) and (not after or is_link(after[0], "mark")))
        two = {f"{one.value.removesuffix('_wall')}_wall", wall.value} == {*_FACING} and one.det == wall.det == "the"
        led = is_link(made[at - 1], "prepositions", "on", "along", "against", "at") or is_link(made[at - 1], "verbs")
        if named and two and led and wall.kind == "place":
            text = "the left and right walls"
            made[at : at + 3] = [replace(wall, value=" ".join(_FACING), start=one.start, text=text, plural=True)]
    return made


def _on_walls(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what stands at several walls is counted: six racks at three walls, two "per wall"."""
    made = list(chunks)
    for at in range(len(made) - 1, 1, -1):
        stands = is_link(made[at - 2], "participles", "stand", "hang")
        verb = at > _BOTH and (stands or is_link(made[at - 2], "verbs", "be", "stand", "hang"))
        first = at - 2 - verb
        things, walls = made[first], made[at]
        if not isinstance(things, Noun) or things.kind != "thing" or not isinstance(walls, Noun) or not _is_wall(walls):
            continue
        both = walls.det in ("both", "each", "either") or walls.value == " ".join(_FACING)
        several = walls.count or (_BOTH if both else 0)
        total = several * _at_each_wall(made[at + 1 : at + 5], things)
        if total and things.count in (None, total):
            made[first] = replace(things, count=total, plural=True)
            made[at + 1 : at + 5] = []
    return made


def _at_each_wall(said: Sequence[Chunk], things: Noun) -> int:
    """The two of ", two racks per wall"; 0 where that does not come."""
    mark, number, link, wall = (*said, None, None, None, None)[:4]
    if not isinstance(number, Noun) or not isinstance(wall, Noun):
        return 0
    if not (_is_wall(wall) or (wall.value == "each" and is_link(link, "prepositions", "on", "at", "along"))):
        return 0
    alike = number.kind == "number" or (number.kind == "thing" and number.word == things.word)
    plain = not (number.attributes or number.unshown or number.det or number.of_known)
    each = wall.det == "each" or is_link(link, "prepositions", "per")
    apart = is_link(mark, "mark", "comma", "colon", "dash", "open")
    return number.count or 0 if apart and alike and plain and each else 0


def _is_wall(noun: Noun) -> bool:
    return noun.kind == "place" and noun.value.endswith("wall")


def _of_columns(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a grid is so many rows of as many as it has columns: "four rows and six columns"."""
    found: list[Chunk] = []
    for chunk in chunks:
        link = found[-1] if len(found) > 1 and isinstance(chunk, Noun) else None
        crossing = is_link(link, "joins", "and") or is_link(link, "prepositions", "by")
        rows = found[-2] if crossing else None
        if not (isinstance(chunk, Noun) and isinstance(rows, Noun) and rows.kind == "number" and rows.rows > 1):
            found.append(chunk)
            continue
        words, first = chunk.text.lower().split(), rows.text.lower().split()[-1]
        number = chunk.rows if chunk.kind == "number" else chunk.count if chunk.value == "column" else None
        crossed = {words[-1], first} == {"rows", "columns"} and number and rows.count is None
        if not crossed or number is None:
            found.append(chunk)
            continue
        lines = rows.rows if first == "rows" else number
        text = rows.text if first == "rows" else chunk.text
        found[-2:] = [replace(rows, rows=lines, count=rows.rows * number, text=text, end=chunk.end, plural=True)]
    return found


def _in_rows(chunk: Noun, before: Sequence[Chunk]) -> Noun:
    """What stands in columns as what stands in rows: twelve in three columns are four rows of three."""
    said = chunk.text.lower().split()
    if "columns" not in said or "rows" in said:
        return chunk
    whole = before[-2] if len(before) > 1 and chunk.kind == "number" else chunk
    count = whole.count if isinstance(whole, Noun) else None
    return replace(chunk, rows=count // chunk.rows) if count and not count % chunk.rows else chunk


def _told_after(chunks: Sequence[Chunk], at: int) -> tuple[int, int, int] | None:
    """How many each row has, where that ends [token], and how many chunks say it; None where nothing does."""
    rows, rest = chunks[at], chunks[at + 1 : at + 5]
    parted = bool(rest) and (
        is_link(rest[0], "mark", "comma", "colon", "dash") or is_link(rest[0], "prepositions", "with")
    )
    said = rest[int(parted) :][:3]
    if len(said) < 3 or not isinstance(rows, Noun):
        return None
    number, link, row = said
    if not (isinstance(number, Noun) and isinstance(row, Noun) and is_link(link, "prepositions", *_PER)):
        return None
    alike = number.kind == "number" or (number.kind == "thing" and rows.kind in ("number", number.kind))
    alike &= rows.kind == "number" or number.kind == "number" or number.value == rows.value
    plain = not (number.attributes or number.unshown or number.size or number.rows)
    each = isinstance(link, Connector) and (link.value == "per" or row.det in ("each", "every", "a"))
    if row.rows != _A_ROW or not (alike and plain and each and number.count):
        return None
    return number.count, row.end, len(said) + int(parted)
