"""Two places told of what comes: "on the desk to the left of the monitor is a lamp"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_MOST = 7
"""Most chunks of both places."""
_UPON = ("on", "on_top", "in", "inside")


def with_two_places(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with commas around the second place, where that is to something small, as the first is not."""
    chunks = _across_the_same(_listed_beside(chunks))
    made: list[Chunk] = []
    last: Noun | None = None
    at = 0
    while at < len(chunks):
        chunk = chunks[at]
        begins = _begins(made)
        if begins and _is_between_commas(chunks, at):
            made[-1:] = [_semicolon(joint) for joint in made[-1:]]
        verb = _verb(chunks, at, last) if begins else 0
        if verb:
            place = [part for said in chunks[at + 2 : verb] for part in _named(said, last)]
            made[-1:] = [_semicolon(joint) for joint in made[-1:]]
            made += [*chunks[at : at + 2], _comma(chunks[at + 2]), *place, _comma(chunks[verb])]
            at = verb
            continue
        last = chunk if isinstance(chunk, Noun) and chunk.kind == "thing" else last
        made.append(chunk)
        at += 1
    return made


def _listed_beside(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the lamp for the "it" of "a lamp and, to the right of it, three trays"."""
    made = list(chunks)
    for at in range(len(made) - 3, 2, -1):
        it, comma, other = made[at : at + 3]
        if not isinstance(it, Noun) or not _is_pointed(it) or not is_link(comma, "mark", "comma"):
            continue
        begin = next((n for n in range(at - 1, max(at - _MOST, 0), -1) if is_link(made[n], "joins", "and")), 0)
        place = begin + 1 + is_link(chunk_at(made, begin + 1), "mark", "comma")
        thing = made[begin - 1]
        placed = bool(begin) and place < at and is_link(made[place], *_PLACES)
        listed = isinstance(other, Noun) and other.kind == "thing" and not other.definite
        if placed and listed and isinstance(thing, Noun) and thing.kind == "thing" and not thing.many:
            made[begin + 1 : at + 1] = [_comma(made[place]), *made[place:at], *_named(it, thing)]
    return made


def _across_the_same(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the stove for the "its" of "a fridge to the left of the stove and a sink to its right"."""
    made: list[Chunk] = []
    side: tuple[str, Noun] | None = None
    for chunk in chunks:
        part, of = made[-2:] if len(made) > 1 else (None, None)
        if is_link(chunk, "mark", "stop", "semicolon"):
            side = None
        elif (
            isinstance(chunk, Noun)
            and chunk.kind == "thing"
            and isinstance(part, Noun)
            and is_link(of, "prepositions", "of")
        ):
            side = (part.value, chunk) if part.value in ("left", "right") and not chunk.many else None
        its = isinstance(chunk, Noun) and chunk.kind == "part" and chunk.det == "my"
        if its and isinstance(chunk, Noun) and side is not None and {chunk.value, side[0]} == {"left", "right"}:
            made += _named(chunk, side[1])
            side = None
        else:
            made.append(chunk)
    return made


def _is_between_commas(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a place, another one between commas and a verb come: "on the desk, behind the monitor, is a lamp"."""
    link, first, comma, place = (*chunks[at : at + 4], None, None, None, None)[:4]
    if not is_link(link, "prepositions", *_UPON) or not isinstance(first, Noun) or first.kind != "thing":
        return False
    if not is_link(comma, "mark", "comma") or not is_link(place, *_PLACES):
        return False
    ends = (n for n in range(at + 4, min(at + _MOST, len(chunks) - 1)) if is_link(chunks[n], "mark"))
    end = next(ends, 0)
    return bool(end) and is_link(chunks[end], "mark", "comma") and is_link(chunks[end + 1], "verbs")


def _named(said: Chunk, last: Noun | None) -> list[Chunk]:
    """What is said, with the name of what was named last in place of "it" and "its"."""
    if not isinstance(said, Noun) or last is None or not _is_pointed(said):
        return [said]
    name = replace(last, start=said.end, end=said.end, det="the", text=f"the {last.word}", count=None)
    if said.kind == "pronoun":
        return [replace(name, start=said.start)]
    return [replace(said, det="the"), Connector("prepositions", "of", said.end, said.end, "of"), name]


def _is_pointed(noun: Noun) -> bool:
    """Whether it is "it", or a side of it."""
    return (noun.kind == "pronoun" and noun.value == "it") or (noun.kind == "part" and noun.det == "my")


def _begins(made: Sequence[Chunk]) -> bool:
    """Whether a clause begins."""
    last = made[-1] if made else None
    return last is None or is_link(last, "mark", "stop", "semicolon", "comma") or is_link(last, "joins", "and")


def _verb(chunks: Sequence[Chunk], at: int, last: Noun | None) -> int:
    """Where the verb stands after two places, the second to what is small, `last` for "it"; 0 where it is not so."""
    link, first = (*chunks[at : at + 2], None, None)[:2]
    if not is_link(link, "prepositions", *_UPON) or not isinstance(first, Noun) or first.kind != "thing":
        return 0
    if (
        first.det != "the"
        or _is_small(first)
        or not is_link(chunks[at + 2] if at + 2 < len(chunks) else None, *_PLACES)
    ):
        return 0
    ends = (n for n in range(at + 3, min(at + _MOST, len(chunks))) if is_link(chunks[n], "verbs"))
    verb = next(ends, 0)
    said = chunks[at + 2 : verb]
    after = chunks[verb + 1] if verb and verb + 1 < len(chunks) else None
    if not verb or not isinstance(after, Noun) or after.definite or any(is_link(c, "mark") for c in said):
        return 0
    anchor = next((c for c in reversed(said) if isinstance(c, Noun)), None)
    anchor = last if anchor is not None and _is_pointed(anchor) else anchor
    return verb if anchor is not None and anchor.kind == "thing" and _is_small(anchor) else 0


_PLACES = (
    "prepositions",
    *("to", "sides", "next_to", "near", "by", "behind", "in_front_of", "left_of", "right_of", "between", "under", "on"),
)
"""Where something is to another."""


def _is_small(noun: Noun) -> bool:
    return load_habits().is_in(noun.value, "small")


def _comma(before: Chunk) -> Connector:
    return Connector("mark", "comma", before.start, before.start, ",")


def _semicolon(joint: Chunk) -> Chunk:
    """The end of the clause before, for what joins another to it."""
    joins = is_link(joint, "mark", "comma") or is_link(joint, "joins")
    return Connector("mark", "semicolon", joint.start, joint.end, ";") if joins else joint
