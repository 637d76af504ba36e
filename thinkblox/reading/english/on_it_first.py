"""Where something is, told before it in a list for each: "each with a bench and, on it, two menus and a candle"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link

_PLACES = ("on", "on_top", "under", "in", "inside", "next_to", "in_front_of", "behind", "above")


def with_on_it_last(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which that comes after the things, and "a second one" is another one."""
    made = [_another(chunk) for chunk in chunks]
    for at in range(len(made) - 3, 0, -1):
        if not is_link(made[at], "joins", "and") or not _is_for_each(made[:at]):
            continue
        start = at + 1 + is_link(made[at + 1], "mark", "comma")
        place, it = (*made[start : start + 2], None, None)[:2]
        pointed = isinstance(it, Noun) and (it.kind, it.value) == ("pronoun", "it")
        if not (pointed and is_link(place, "prepositions", *_PLACES)):
            continue
        first = start + 2 + (start + 2 < len(made) and is_link(made[start + 2], "mark", "comma"))
        end = first
        while end < len(made) and _is_listed(made[end]):
            end += 1
        ends = end >= len(made) or is_link(made[end], "mark", "stop", "semicolon")
        if ends and end > first and place is not None and it is not None:
            made[at + 1 : end] = [*made[first:end], place, it]
    return made


def _another(chunk: Chunk) -> Chunk:
    """The chunk with another one in place of "a second one"."""
    plain = isinstance(chunk, Noun) and not (chunk.attributes or chunk.unshown)
    if isinstance(chunk, Noun) and plain and chunk.kind == "number" and chunk.ordinal > 1 and chunk.det == "a":
        return replace(chunk, kind="pronoun", value="other", det="another", text="another", ordinal=0)
    return chunk


def _is_for_each(chunks: Sequence[Chunk]) -> bool:
    """Whether the sentence tells what each has."""
    for chunk in reversed(chunks):
        if is_link(chunk, "mark", "stop", "semicolon"):
            return False
        if isinstance(chunk, Noun) and chunk.det == "each":
            return True
    return False


def _is_listed(chunk: Chunk) -> bool:
    things = isinstance(chunk, Noun) and chunk.kind == "thing" and not chunk.definite
    return things or is_link(chunk, "mark", "comma") or is_link(chunk, "joins", "and")
