"""Some of what was named, of which something is told: "four chairs, the two chairs by the window are blue"."""

import re
from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_OF_THEM = re.compile(r"[a-z]+ of (?:them|which) ", re.IGNORECASE)
_EVERY = re.compile(r"every ", re.IGNORECASE)
_BACK = 4
"""So many chunks come before "one of which": several, where, of what, and a comma."""
_ASIDE = 7
"""So many chunks an aside about some has at most, with what it is about before it and the comma after it."""
_PLACED = 3
"""So many chunks say at most where they are, before what is told of them."""


def with_some_told(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which fewer than were named are some of those; a comma before them ends what it follows."""
    made: list[Chunk] = []
    named: dict[str, set[int]] = {}
    parted = [part for chunk in _without_each(chunks) for part in _parted(chunk)]
    for at, given in enumerate(parted):
        chunk = _every_other(made, _of_which(made, given))
        count = chunk.count if isinstance(chunk, Noun) and chunk.kind == "thing" else None
        if isinstance(chunk, Noun) and count:
            if not chunk.of_known and _is_one_of(chunk, made, parted[at + 1 : at + _PLACED]):
                made.append(Noun("number", "", chunk.start, chunk.end, "one", count=1))
                continue
            some = chunk.of_known or _is_fewer(chunk, named.get(chunk.value, set()))
            if some and _is_told_of(parted[at + 1 : at + 2 + _PLACED]):
                before = made[-1] if made else None
                chunk = chunk if chunk.of_known else replace(chunk, det="", of_known=True)
                if isinstance(before, Connector) and is_link(before, "mark", "comma"):
                    made[-1] = replace(before, value="semicolon")
            if not some:
                named.setdefault(chunk.value, set()).add(count)
        if (whole := _told_on(made, chunk)) is not None:
            made += whole
        made.append(chunk)
        if _are_bare(chunk, chunk_at(parted, at + 1)):
            made.append(Connector("verbs", "be", chunk.end, chunk.end, "are"))
    return made


def _without_each(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "the rest with a coat" for "the rest with a coat on each", which are each of the rest."""
    made: list[Chunk] = []
    for chunk in chunks:
        rest, has, what, on = (*(None,) * 4, *made[-4:])[-4:]
        each = isinstance(chunk, Noun) and chunk.kind == "pronoun" and chunk.value == "each"
        held = is_link(has, "prepositions", "with") and isinstance(what, Noun) and what.det == "a"
        if each and held and is_link(on, "prepositions") and isinstance(rest, Noun) and rest.value == "rest":
            made.pop()
        else:
            made.append(chunk)
    return made


def _parted(chunk: Chunk) -> list[Chunk]:
    """The two of them, and the armchairs that these are, of "two of them armchairs"."""
    told = _OF_THEM.match(chunk.text) if isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.of_known else None
    if told is None or not isinstance(chunk, Noun):
        return [chunk]
    some = Noun("number", "", chunk.start, chunk.start, told[0].strip(), count=chunk.count, of_known=True)
    named = replace(chunk, text=chunk.text[told.end() :], count=None, of_known=False)
    return [some, named]


def _are_bare(some: Chunk, others: Chunk | None) -> bool:
    """Whether some are said to be others without a verb: "five chairs, two of them armchairs"."""
    if not isinstance(some, Noun) or not isinstance(others, Noun) or some.kind not in ("pronoun", "number"):
        return False
    known = some.of_known and some.text.lower().endswith((" of them", " of which"))
    return known and others.kind == "thing" and others.det in ("", "a") and others.count in (None, 1)


def _of_which(made: Sequence[Chunk], chunk: Chunk) -> Chunk:
    """The ones of "the second has three lamps on it, one of which is green", which are lamps."""
    if len(made) < _BACK or not isinstance(chunk, Noun) or not chunk.of_known or not chunk.text.endswith(" of which"):
        return chunk
    several, link, it, comma = made[-_BACK:]
    there = is_link(link, "prepositions") and isinstance(it, Noun) and it.kind == "pronoun" and it.value == "it"
    if not (there and is_link(comma, "mark", "comma") and isinstance(several, Noun) and several.kind == "thing"):
        return chunk
    some = (several.count or 0) > (chunk.count or 0)
    return (
        replace(
            several,
            start=chunk.start,
            end=chunk.end,
            text=chunk.text,
            count=chunk.count,
            of_known=True,
            plural=chunk.plural,
            attributes=[],
        )
        if some
        else chunk
    )


def _told_on(made: list[Chunk], chunk: Chunk) -> list[Chunk] | None:
    """What goes on with all of several after what was told of some: "four chairs, one of which is red, | stand"."""
    verb = isinstance(chunk, Connector) and chunk.sort == "verbs"
    if not verb or not made or not is_link(made[-1], "mark", "comma"):
        return None
    said = [c for c in made[-_ASIDE:-1] if not is_link(c, "verbs", "be")][-4:]
    if len(said) < 4 or not isinstance(said[3], Adjective) or not is_link(said[1], "mark", "comma"):
        return None
    several, some = said[0], said[2]
    if not isinstance(several, Noun) or not isinstance(some, Noun) or not several.count or several.kind != "thing":
        return None
    if not some.of_known or not some.text.lower().endswith((" of which", " of them")) or several.count < 2:
        return None
    comma = made.pop()
    return [
        Connector("mark", "semicolon", comma.start, comma.end, ";"),
        replace(several, start=chunk.start, end=chunk.start, det="all", attributes=[], unshown=[], states=[]),
    ]


def _every_other(made: Sequence[Chunk], chunk: Chunk) -> Chunk:
    """The armchair of "four armchairs, a lamp behind every other one"."""
    if not isinstance(chunk, Noun) or chunk.kind != "number" or not chunk.every or not _EVERY.match(chunk.text):
        return chunk
    several = (c for c in reversed(made) if isinstance(c, Noun) and c.kind == "thing" and (c.count or 0) > 1)
    named = next(several, None)
    return chunk if named is None else replace(chunk, kind="thing", value=named.value, called=named.called, count=None)


def _is_fewer(noun: Noun, counts: set[int]) -> bool:
    """Whether it points at fewer than the so many that were named once."""
    return noun.det in ("the", "these", "those") and len(counts) == 1 and 1 < (noun.count or 0) < min(counts)


def _is_one_of(noun: Noun, made: Sequence[Chunk], after: Sequence[Chunk]) -> bool:
    """Whether it is one of two that the sentence named: "two candles, one candle left of the vase, one right of it"."""
    after_comma = bool(made) and is_link(made[-1], "mark", "comma", "colon")
    if any(isinstance(chunk, Noun) and chunk.det == "each" for chunk in after):
        return False
    if noun.count != 1 or not noun.text.lower().startswith("one ") or noun.attributes or not after_comma:
        return False
    for chunk in reversed(made):
        if is_link(chunk, "mark", "stop"):
            return False
        if isinstance(chunk, Noun) and chunk.value == noun.value and chunk.kind == "thing":
            return (chunk.count or 0) > 1
    return False


def _is_told_of(after: Sequence[Chunk]) -> bool:
    """Whether something is said of them, past where they are: "by the window are"."""
    placed = len(after) > 2 and is_link(after[0], "prepositions") and isinstance(after[1], Noun)
    return is_link(after[2 if placed else 0] if after else None, "verbs", "be")
