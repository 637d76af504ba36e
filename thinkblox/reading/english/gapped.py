"""What one has and another has of another look: "two of them have a red lamp on them, the third a blue one"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from thinkblox.assets import kind_of
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.hanging import can_hang
from thinkblox.reading.english.said import is_holding, is_link

_SECOND = 2
_LATTER = "latter"
_CLAUSE = 7
"""So many chunks a clause between commas has at most, with the word before it."""
_GAP = 6
"""So many chunks come before where the second is: the first, a verb, where, "and" and the second."""
_ALSO = ("also", "just", "only")
"""What may stand where the verb is left out."""


def with_gapped(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the other has what was said of the first, and where, with a look of its own."""
    made: list[Chunk] = []
    for chunk in chunks:
        also = bool(made) and isinstance(made[-1], Connector) and made[-1].text.lower() in _ALSO
        before = made[-1 - also] if len(made) > also else None
        if (hung := _hung_too(made, chunk)) is not None:
            made.append(hung)
        if (told := _so_many(made, chunk)) is not None:
            made += told
            continue
        if (verb := _left_out(made[:-1] if also else made, before, chunk)) is not None:
            made[len(made) - also :] = [replace(verb, start=chunk.start, end=chunk.start)]
            made.append(chunk)
            continue
        said = _said(made) if isinstance(before, Noun) and _is_other(before) else None
        if said is not None and isinstance(chunk, Noun) and _is_one(chunk):
            verb, thing, link = said
            one = replace(thing, attributes=[*chunk.attributes], unshown=[*chunk.unshown], count=None, plural=False)
            text = f"{' '.join(chunk.text.split()[:-1])} {thing.word}"
            made.append(replace(verb, start=chunk.start, end=chunk.start))
            made.append(replace(one, start=chunk.start, end=chunk.end, text=text))
            if link is not None:
                made.append(replace(link, start=chunk.end, end=chunk.end))
                made.append(Noun("pronoun", "it", chunk.end, chunk.end, "it"))
        else:
            made.append(chunk)
    return made


def _hung_too(made: Sequence[Chunk], chunk: Chunk) -> Connector | None:
    """The verb that is left out of "a map hangs above the sofa and a coat rack next to the door"."""
    if not is_link(chunk, "prepositions") or len(made) < _GAP:
        return None
    first, verb, link, _, joint, other = made[-_GAP:]
    new = [n for n in (first, other) if isinstance(n, Noun) and n.kind == "thing" and not n.definite]
    hangs = isinstance(verb, Connector) and is_link(verb, "verbs", "hang") and is_link(link, "prepositions")
    if len(new) < len((first, other)) or not hangs or not isinstance(verb, Connector):
        return None
    again = is_link(joint, "joins", "and") and can_hang(kind_of(new[1].value))
    return replace(verb, start=chunk.start, end=chunk.start) if again else None


def _left_out(made: Sequence[Chunk], before: Chunk | None, chunk: Chunk) -> Connector | None:
    """The verb that is left out between "the third", "each of the other two" and the new thing that it has."""
    if not isinstance(chunk, Noun) or chunk.kind != "thing" or chunk.definite:
        return None
    if (which := _relative(made)) is not None:
        made, before = made[: which + 1], made[which]
    if not isinstance(before, Noun):
        return None
    some = before.kind == "number" and (before.det in ("the", "other") or before.of_known)
    if not (some or _is_other(before)) or not (chunk.det == "a" or chunk.count or chunk.plural):
        return None
    joint = made[-2] if len(made) > 1 else None
    if before.value == _LATTER and is_link(joint, "mark", "semicolon"):
        made = [*made[:-2], before, before]
    elif not (is_link(joint, "mark", "comma") or is_link(joint, "joins", "and")):
        return None
    return next((verb for verb, _ in _had(made[:-1])), None)


def _relative(made: Sequence[Chunk]) -> int | None:
    """Where what a clause between commas is about stands: "the latter, which is in the corner, | a lamp"."""
    if not made or not is_link(made[-1], "mark", "comma"):
        return None
    least = max(2, len(made) - _CLAUSE)
    which = next((n for n in range(len(made) - 2, least - 1, -1) if is_link(made[n], "joins", "which")), 0)
    return which - 2 if which and is_link(made[which - 1], "mark", "comma") else None


def _had(made: Sequence[Chunk]) -> Iterator[tuple[Connector, Noun]]:
    """The verbs of a sentence by which something has a thing, and these things."""
    begin = next((n + 1 for n in range(len(made) - 1, -1, -1) if is_link(made[n], "mark", "stop", "semicolon")), 0)
    for verb, thing in pairwise(made[begin:-1]):
        if isinstance(verb, Connector) and is_holding(verb) and isinstance(thing, Noun) and thing.kind == "thing":
            yield verb, thing


def _so_many(made: Sequence[Chunk], chunk: Chunk) -> list[Chunk] | None:
    """What "the second six" is after "the first holds nine boxes": the second holds six boxes."""
    if not isinstance(chunk, Noun) or chunk.kind != "number" or chunk.ordinal < _SECOND or (chunk.count or 1) < _SECOND:
        return None
    had = next(_had(made), None) if made and is_link(made[-1], "mark", "comma") else None
    if had is None or had[1].count is None or chunk.of_known or chunk.attributes:
        return None
    verb, thing = had
    which = replace(chunk, count=1, plural=False, text=chunk.text.rpartition(" ")[0])
    more = replace(
        thing, start=chunk.end, end=chunk.end, count=chunk.count, text=f"{chunk.count} {thing.text.split()[-1]}"
    )
    return [which, replace(verb, start=chunk.end, end=chunk.end), more]


def _is_other(noun: Noun) -> bool:
    """Whether "the third", "the other" comes, of which nothing is told but what it has."""
    other = noun.ordinal > 1 if noun.kind == "number" else noun.kind == "pronoun" and noun.value in ("other", _LATTER)
    return other and not (noun.attributes or noun.unshown)


def _is_one(noun: Noun) -> bool:
    told = noun.attributes or noun.unshown
    return noun.kind == "number" and noun.det == "a" and bool(told) and noun.text.lower().endswith(" one")


def _said(made: Sequence[Chunk]) -> tuple[Connector, Noun, Connector | None] | None:
    """The verb, what is had and how it is to what has it, that came before "the third" in its sentence."""
    begin = next((n + 1 for n in range(len(made) - 1, -1, -1) if is_link(made[n], "mark", "stop", "semicolon")), 0)
    joint = made[-2] if len(made) > 1 else None
    if not (is_link(joint, "mark", "comma") or is_link(joint, "joins", "and")):
        return None
    for at in range(begin, len(made) - 2):
        verb, thing = made[at : at + 2]
        if not (isinstance(verb, Connector) and isinstance(thing, Noun) and is_holding(verb)):
            continue
        if thing.kind == "thing" and thing.det == "a":
            link, pronoun = (*made[at + 2 : at + 4], None, None)[:2]
            there = is_link(link, "prepositions") and isinstance(pronoun, Noun) and pronoun.kind == "pronoun"
            return verb, thing, link if there and isinstance(link, Connector) else None
    return None
