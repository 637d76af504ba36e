"""One of two at the sides of something: "a nightstand on the left of the bed and one on the right"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at

_SIDES = ("left", "right")
_NEAR = 6
"""Chunks among which the part of a thing and its whole are: "stands on the left of the door"."""
_ONE, _OTHER = ("one", "the one"), ("another", "another one", "the other", "the other one")


def with_others(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "one on the right" and "the right one" name what was told to be on the left."""
    made = _with_wholes_told_last(_sided(chunks))
    thing: Noun | None = None
    whole: Noun | None = None
    told: set[str] = set()
    at = 0
    while at < len(made):
        said, part = made[at], _side_after(made, at)
        if isinstance(said, Noun) and part is not None and thing is not None and whole is not None:
            _tell_whole(made, at, part, whole)
        if isinstance(said, Noun) and said.kind == "thing" and part is not None:
            told = told if thing is not None and said.value == thing.value else set()
            thing = None if said.many else said
            whole = _whole_of(made[at : at + _NEAR], part)
            told.add(part.value)
        elif isinstance(said, Noun) and thing is not None:
            part = _side_after(made, at)
            found = _once_more(thing, said, part, told)
            length = _length(made, at) if found is not None and found.side and part is not None else 1
            made[at : at + length] = [found or said]
            if found is not None:
                _put_verb(made, at, at + 1 if found.side else at + 3)
        at += 1
    return made


def _sided(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "the left one" for "the one on the left", "the two on the left"."""
    made = list(chunks)
    for at in range(len(made) - 2, -1, -1):
        said = made[at]
        if not isinstance(said, Noun) or said.kind not in ("number", "pronoun") or said.det != "the" or not said.count:
            continue
        part = _side_after(made, at)
        some = any(isinstance(c, Noun) and c.kind == "thing" and c.many for c in made[:at])
        on = made[at + 1]
        if not some or part is None or not _is(on, "prepositions") or part.det == "my":
            continue
        of = chunk_at(made, at + 3)
        if isinstance(of, Connector) and of.value == "of":
            continue
        text = f"the {part.value} one" if said.count == 1 else f"the {part.value} ones"
        sided = replace(said, kind="number", value="", end=part.end, side=part.value, text=text)
        made[at : at + 3] = [sided]
        _put_verb(made, at, at + 1)
    return made


def _with_wholes_told_last(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "on the left of the bed" for "a lamp on the left and a plant on the right of the bed"."""
    made = list(chunks)
    for at in range(len(made) - _NEAR, 0, -1):
        part, link, named = made[at : at + 3]
        if (
            not _is_side(part)
            or not isinstance(part, Noun)
            or part.det != "the"
            or not _is(made[at - 1], "prepositions")
        ):
            continue
        other = next((c for c in made[at + 1 : at + _NEAR] if isinstance(c, Noun) and _is_side(c)), None)
        told = isinstance(named, Noun) and named.kind in ("thing", "number", "pronoun")
        if other is None or other.value == part.value or not told or not (_is(link, "joins") or _is_comma(link)):
            continue
        place = next(n for n, chunk in enumerate(made) if chunk is other)
        whole = _whole_of(made[place : place + 3], other)
        if whole is not None and whole.kind == "thing":
            again = replace(whole, start=part.end, end=part.end, det="the")
            made[at + 1 : at + 1] = [Connector("prepositions", "of", part.end, part.end, "of"), again]
    return made


def _is_side(part: Chunk) -> bool:
    return isinstance(part, Noun) and part.kind == "part" and part.value in _SIDES


def _is_comma(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and chunk.sort == "mark" and chunk.value == "comma"


def _whole_of(chunks: Sequence[Chunk], part: Noun) -> Noun | None:
    """The door of "on the left of the door"."""
    at = next((n for n, chunk in enumerate(chunks) if chunk is part), len(chunks))
    of, whole = (*chunks[at + 1 : at + 3], None, None)[:2]
    named = isinstance(of, Connector) and of.value == "of" and isinstance(whole, Noun)
    return whole if named and isinstance(whole, Noun) and whole.kind in ("thing", "place") else None


def _tell_whole(chunks: list[Chunk], at: int, part: Noun, whole: Noun) -> None:
    """Say "the right of the door" for "its right", where one more is told to be there."""
    once_more = isinstance(said := chunks[at], Noun) and said.text.lower() in (*_ONE, *_OTHER)
    own = part.det == "my" or part.text.lower().endswith(" of it")
    place = next((n for n, chunk in enumerate(chunks) if chunk is part), 0)
    if once_more and own and place:
        again = replace(whole, start=part.end, end=part.end, det="the")
        of = Connector("prepositions", "of", part.end, part.end, "of")
        chunks[place : place + 1] = [replace(part, det="the"), of, again]


def _put_verb(chunks: list[Chunk], at: int, after: int) -> None:
    """Say once more what is left out in "the left one has a lamp, the right one a book"."""
    after += int(after < len(chunks) and (_is(chunks[after], "fillers") or _is_only(chunks[after])))
    noun, comma = chunks[after] if after < len(chunks) else None, chunks[at - 1]
    verb = next((c for c in reversed(chunks[:at]) if _is(c, "verbs") or _is_end(c)), None)
    listed = isinstance(comma, Connector) and comma.value in ("comma", "and", "semicolon", "but")
    bare = listed and isinstance(noun, Noun) and noun.kind == "thing"
    if bare and noun is not None and isinstance(verb, Connector) and verb.value in ("have", "hold", "carry"):
        chunks.insert(after, replace(verb, start=noun.start, end=noun.start))


def _once_more(thing: Noun, said: Noun, part: Noun | None, told: set[str]) -> Noun | None:
    """The thing in place of "one", by its side where that is taken, else another; None for other words."""
    text = said.text.lower()
    if part is not None and text in _OTHER:
        told.add(part.value)
        return None
    if part is not None and text in _ONE:
        if part.value in told:
            return _named(thing, said, "the", part.value) if text == "the one" and len(told) > 1 else None
        told.add(part.value)
        return _named(thing, said, "another")
    if said.kind != "number" or said.side not in told or text != f"the {said.side} one":
        return None
    return _named(thing, said, "the", said.side)


def _side_after(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """Left or right, where that comes after a thing: "on the left", "stands to the right"."""
    place = at + 2 if at + 1 < len(chunks) and _is(chunks[at + 1], "verbs", "participles") else at + 1
    if place + 1 >= len(chunks) or not _is(chunks[place], "prepositions"):
        return None
    link, part = chunks[place : place + 2]
    if isinstance(link, Connector) and link.value in ("left_of", "right_of"):
        return Noun("part", link.value.removesuffix("_of"), link.start, link.end, link.text)
    return part if isinstance(part, Noun) and part.kind == "part" and part.value in _SIDES else None


def _length(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "the one on the right", "the one on the right of the bed" are."""
    of = chunks[at + 3] if at + 4 < len(chunks) else None
    return 5 if isinstance(of, Connector) and of.value == "of" and isinstance(chunks[at + 4], Noun) else 3


def _is(chunk: Chunk, *sorts: str) -> bool:
    return isinstance(chunk, Connector) and chunk.sort in sorts


def _is_only(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and chunk.sort == "negations" and chunk.value == "only"


def _is_end(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and chunk.value == "stop"


def _named(thing: Noun, said: Noun, det: str, side: str = "") -> Noun:
    """The thing, named once more where a word stood for it."""
    return replace(
        thing,
        det=det,
        count=1 if det == "another" else None,
        start=said.start,
        end=said.end,
        side=side,
        text=f"{det} {thing.word}",
        attributes=[*said.attributes],
        unshown=[*said.unshown],
        states=[*said.states],
        of_known=False,
    )
