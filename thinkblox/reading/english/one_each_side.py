"""Two things at two sides of a third: "left and right of the sofa are a lamp and a plant", "one left and one right"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_TOLD = 6
"""So many chunks tell both things and what they are at the sides of."""


def with_one_each_side(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the first of the two is at the side that is named first, and the second at the other."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        said = chunks[at : at + _TOLD]
        after = chunks[at + _TOLD] if at + _TOLD < len(chunks) else None
        ends = after is None or is_link(after, "mark")
        apart = _told_apart(said) if len(said) == _TOLD and ends and _begins(made) else []
        elided = _elided(said)
        made += apart or elided or chunks[at : at + 1]
        at += _TOLD if apart else _TOLD - 1 if elided else 1
    return made


def _elided(said: Sequence[Chunk]) -> list[Chunk]:
    """Both of "one left and one right of the desk" with what they are beside; empty for anything else."""
    if len(said) < _TOLD - 1:
        return []
    one, joint, other, link, anchor = said[: _TOLD - 1]
    if not isinstance(one, Noun) or one.kind != "part" or one.count != 1 or one.value not in ("left", "right"):
        return []
    too = isinstance(other, Noun) and other.value == "one" and is_link(link, "prepositions", "left_of", "right_of")
    if not (too and is_link(joint, "joins", "and") and isinstance(anchor, Noun)):
        return []
    kind, first = f"{one.value}_of", replace(one, kind="pronoun", value="one", end=one.start + 1, text="one")
    known, again = replace(anchor, start=one.end, end=one.end), anchor
    if anchor.kind == "thing" and anchor.det == "a":
        again = replace(anchor, det="the")
    return [
        first,
        Connector("prepositions", kind, first.end, one.end, f"{one.value} of"),
        known,
        joint,
        other,
        link,
        again,
    ]


def _begins(made: Sequence[Chunk]) -> bool:
    return not made or is_link(made[-1], "mark") or is_link(made[-1], "joins")


def _told_apart(said: Sequence[Chunk]) -> list[Chunk]:
    """Both told one by one, whether the sides or the things come first; empty where there are not two."""
    if is_link(said[0], "prepositions", "sides"):
        (sides, of, verb), (one, joint, other) = said[:3], said[3:]
    else:
        (one, joint, other), (verb, sides, of) = said[:3], said[3:]
    two = [noun for noun in (one, other) if isinstance(noun, Noun) and noun.kind == "thing" and noun.det == "a"]
    joined = is_link(joint, "joins", "and") and is_link(verb, "verbs") and isinstance(verb, Connector)
    if len(two) != 2 or not joined or not isinstance(of, Noun) or not is_link(sides, "prepositions", "sides"):
        return []
    assert isinstance(verb, Connector)
    assert isinstance(sides, Connector)
    first, second = ("right_of", "left_of") if "right and" in sides.text.lower() else ("left_of", "right_of")
    stop = Connector("mark", "semicolon", two[1].start, two[1].start, ";")
    return [two[0], verb, replace(sides, value=first), of, stop, two[1], verb, replace(sides, value=second), of]
