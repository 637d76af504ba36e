"""Parts that a sentence begins with: "the bed's headboard is against the wall", "each side of the bed has a lamp"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_holding, is_link

_TURNED = ("head", "back", "foot", "front")
_SIDES = ("side", "end", "long_side", "short_side", "left", "right", "top", "middle")
_BOTH, _WITH = ("each", "either", "both"), ("prepositions", "with")
_OTHER = {"left": "right", "right": "left", "front": "back", "back": "front"}
_PAIR = 9
"""So many chunks tell of two things at both sides of a third."""
_PLACED = ("against", "facing", "to", "near", "next_to", "by")


def with_part_subjects(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a thing stands as a part of it is said to, and what its sides have is at these."""
    made = _with_whole_told_later(_with_other_side(_with_ends(chunks)))
    for at in range(len(made) - 1, -1, -1):
        part = made[at]
        if not isinstance(part, Noun) or part.kind != "part":
            continue
        if at and not (is_link(made[at - 1], "mark") or is_link(made[at - 1], "joins", "and")):
            continue
        whole, length = _whole(made, at)
        if whole is None:
            continue
        verb, after = (*made[at + length : at + length + 2], None, None)[:2]
        if part.value in _SIDES and isinstance(verb, Connector) and is_holding(verb):
            made[at : at + length + 1] = _at_side(part, whole, verb)
        elif part.value in _TURNED and (link := _turned(verb, after)) is not None:
            made[at : at + length + (1 if verb is not None and link.start == verb.start else 2)] = [
                *_owner(part, whole),
                link,
            ]
    return made


def _with_ends(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "on each side" for where cushions are "at each end" of what one leans back in: its two sides."""
    made = list(chunks)
    for at in range(3, len(made) - 1):
        seat, has, thing, link, end = made[at - 3 : at + 2]
        both = isinstance(end, Noun) and end.kind == "part" and end.value == "end" and end.det in _BOTH
        if not both or not is_link(link, "prepositions", "at", "on"):
            continue
        leant = isinstance(seat, Noun) and load_habits().is_in(seat.value, "lounges") and is_link(has, *_WITH)
        small = isinstance(thing, Noun) and load_habits().is_in(thing.value, "small")
        if leant and small and isinstance(link, Connector) and isinstance(end, Noun):
            made[at], made[at + 1] = replace(link, value="on"), replace(end, value="side")
    return made


def _with_other_side(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with what is left out: "the left side of the desk has a lamp, the right side a phone"."""
    made: list[Chunk] = []
    whole: Noun | None = None
    verb: Connector | None = None
    for at, chunk in enumerate(chunks):
        made.append(chunk)
        if is_link(chunk, "mark", "stop", "semicolon"):
            whole = None
        elif isinstance(chunk, Noun) and chunk.kind == "part" and chunk.value in _OTHER:
            owner, length = _whole(chunks, at) if chunk.owner == "" else (None, 0)
            having = chunks[at + length] if owner is not None and at + length < len(chunks) else None
            after = chunk_at(chunks, at + 1)
            if owner is not None and isinstance(having, Connector) and is_holding(having):
                whole, verb = owner, having
            elif whole is not None and verb is not None and _is_new(after, chunks[at - 1]):
                made += [*_of(whole, chunk.end), replace(verb, start=chunk.end, end=chunk.end)]
    return made


def _is_new(after: Chunk | None, before: Chunk) -> bool:
    """Whether a part begins a clause without a verb, and what is there comes next."""
    begins = is_link(before, "mark", "comma") or is_link(before, "joins", "and")
    return begins and isinstance(after, Noun) and after.kind == "thing" and not after.definite


def _of(whole: Noun, at: int) -> list[Chunk]:
    known = replace(whole, start=at, end=at, det="the", text=f"the {whole.text.split()[-1]}")
    return [Connector("prepositions", "of", at, at, "of"), known]


def _with_whole_told_later(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with both wholes for "a lamp on the left and a plant on the right of the sofa"."""
    made = list(chunks)
    for at in range(len(made) - _PAIR, -1, -1):
        one, link, side, joint, other, again, across, of, whole = made[at : at + _PAIR]
        if not (isinstance(side, Noun) and isinstance(across, Noun) and _OTHER.get(side.value) == across.value):
            continue
        placed = is_link(link, "prepositions", "on", "at", "to") and is_link(again, "prepositions", "on", "at", "to")
        things = all(isinstance(noun, Noun) and noun.kind == "thing" for noun in (one, other, whole))
        if not (placed and things and is_link(joint, "joins", "and") and is_link(of, "prepositions", "of")):
            continue
        assert isinstance(whole, Noun)
        first = replace(whole, start=side.end, end=side.end)
        made[at + _PAIR - 1] = replace(whole, det="the", text=f"the {whole.text.split()[-1]}")
        made[at + 3 : at + 3] = [Connector("prepositions", "of", side.end, side.end, "of"), first]
    return made


def _whole(chunks: Sequence[Chunk], at: int) -> tuple[Noun | None, int]:
    """What a part is of, and how many chunks say so."""
    part, of, whole = (*chunks[at : at + 3], None, None)[:3]
    if is_link(of, "prepositions", "of") and isinstance(whole, Noun) and whole.kind == "thing":
        return whole, 3
    if isinstance(part, Noun) and part.owner:
        name = part.text.rpartition(" ")[0]
        called = name.lower().removeprefix("the ").removesuffix("'s").removesuffix("\u2019s")
        return Noun("thing", part.owner, part.start, part.end - 1, name, called, det="the"), 1
    return None, 0


def _at_side(part: Noun, whole: Noun, verb: Connector) -> list[Chunk]:
    on = Connector("prepositions", "on", part.start, part.start, "on")
    of = Connector("prepositions", "of", whole.start, whole.start, "of")
    return [on, part, of, whole, replace(verb, value="stand")]


def _owner(part: Noun, whole: Noun) -> list[Chunk]:
    own = replace(part, det="my", owner="", start=part.end - 1)
    return [whole, Connector("prepositions", "with", whole.end, whole.end, "with"), own]


def _turned(verb: Chunk | None, after: Chunk | None) -> Connector | None:
    """How a part stands, as a preposition; None where that is not told."""
    if isinstance(verb, Connector) and is_link(verb, "verbs", "face"):
        return replace(verb, sort="prepositions", value="facing")
    placed = isinstance(after, Connector) and is_link(after, "prepositions", *_PLACED)
    told = is_link(verb, "verbs", "be", "stand") and placed
    return after if told and isinstance(after, Connector) else None
