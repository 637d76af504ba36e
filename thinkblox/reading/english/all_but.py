"""How many of several are meant: "next to all but two of the beds", "each of the four", "a chair at both desks"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link

_CARRIED = ("on", "on_top", "in", "at", "under", "above", "behind", "in_front_of")
"""How one thing is to one other, and not to two."""
_SEVERAL = 2
_EACH = ("each of them", "every one of them", "each of these")


def with_all_but(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which all but some of several are every one of them but so many, and "the rest" those left of them."""
    made = [_each_of_both(chunks, at) for at in range(len(chunks))]
    made = [_rest(made, at) or _each_of_so_many(made, at) or made[at] for at in range(len(made))]
    for at in range(len(made) - 2):
        every, but, left = made[at : at + 3]
        if not isinstance(every, Noun) or not isinstance(left, Noun) or not _is_all(every) or not _excepts(but):
            continue
        several = left if left.kind == "thing" and left.of_known else _several(made, at) if _is_number(left) else None
        if several is None or not (left.count or 0):
            continue
        words = f"every {several.word}"
        made[at] = replace(
            several, start=every.start, end=every.end, text=words, det="each", count=None, plural=False, of_known=False
        )
        made[at + 2] = Noun("number", "", left.start, left.end, left.text, count=left.count)
    return made


def _each_of_both(chunks: Sequence[Chunk], at: int) -> Chunk:
    """Each of both, where one thing is said to be at them, or they come before what is there."""
    chunk = chunks[at]
    if not isinstance(chunk, Noun) or chunk.kind != "thing" or chunk.det != "both" or not chunk.plural:
        return chunk
    before = chunks[:at]
    alike = {c.value for c in before if isinstance(c, Noun) and c.kind == chunk.kind and _goes_by(c, chunk)}
    begins = bool(before) and is_link(before[-1], "mark", "stop", "semicolon")
    if begins and not chunk.named and chunk.value not in alike and len(alike) == 1:
        return Noun("pronoun", "them", chunk.start, chunk.end, "both of them")
    if not before or not is_link(before[-1], "prepositions", *_CARRIED):
        return chunk
    said = before[-3] if len(before) > 1 and is_link(before[-2], "verbs") else before[-2] if len(before) > 1 else None
    front = said is None or is_link(said, "mark") or is_link(before[-2], "mark") or is_link(before[-2], "joins")
    single = isinstance(said, Noun) and said.kind == "thing" and said.det == "a" and not said.many
    if not (front or single):
        return chunk
    if any(isinstance(c, Noun) and c.kind == chunk.kind and _goes_by(c, chunk) for c in before):
        return replace(chunk, det="each", plural=False, text=f"each {chunk.word}")
    return replace(chunk, det="each", count=2, text=f"each of the two {chunk.text.split()[-1]}")


def _each_of_so_many(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """Each of those that were named last of which there are as many: "four benches; each of the four has a lamp"."""
    chunk = chunks[at]
    if not isinstance(chunk, Noun) or chunk.kind != "number" or chunk.det != "each" or (chunk.count or 0) < _SEVERAL:
        return None
    named = (c for c in chunks[:at][::-1] if isinstance(c, Noun) and c.kind == "thing" and c.count == chunk.count)
    several = next((noun for noun in named if not load_habits().is_in(noun.value, "small")), None)
    if several is None:
        return None
    words = f"each {several.word}"
    return Noun("thing", several.value, chunk.start, chunk.end, words, called=several.called, det="each")


def _rest(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """Those of several that are left when it was said where some are: "two against the wall, the rest by the door"."""
    chunk = chunks[at]
    if not isinstance(chunk, Noun) or chunk.kind != "abstract" or chunk.text.lower() != "the rest":
        return None
    placed = is_link(chunks[at + 1], "prepositions") if at + 1 < len(chunks) else False
    if not placed or is_link(chunks[at + 1], "prepositions", "of"):
        return None
    earlier = chunks[:at][::-1]
    last = next((n for n, c in enumerate(earlier) if is_link(c, "mark", "stop")), len(earlier))
    some = any(isinstance(c, Noun) and c.kind == "number" and c.count for c in earlier[:last])
    return replace(chunk, kind="pronoun", value="other", called="", det="other") if some else None


def _goes_by(named: Noun, both: Noun) -> bool:
    """Whether one of both may be what was named: a washing machine is one of "both machines"."""
    return named.value == both.value or named.word.split()[-1:] == both.word.split()[-1:]


def _is_all(noun: Noun) -> bool:
    return noun.kind == "pronoun" and (noun.det == "all" or noun.text.lower() in _EACH)


def _excepts(chunk: Chunk) -> bool:
    return is_link(chunk, "joins", "but") or is_link(chunk, "prepositions", "except")


def _tells(after: Sequence[Chunk]) -> bool:
    """Whether it is told what they have: "all but one of them have a lamp"."""
    return any(
        is_link(chunk, "verbs", "have", "hold", "carry") or is_link(chunk, "prepositions", "with") for chunk in after
    )


def _is_number(noun: Noun) -> bool:
    return noun.kind in ("number", "pronoun") and noun.count is not None


def _several(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """What "all of them" are, of which something is told: what was named last of which there are several."""
    if not at or not (is_link(chunks[at - 1], "prepositions") or _tells(chunks[at + 3 : at + 4])):
        return None
    named = (c for c in chunks[max(at - 2, 0) :: -1][1:] if isinstance(c, Noun) and c.kind == "thing")
    return next((noun for noun in named if (noun.count or 0) > 1), None)
