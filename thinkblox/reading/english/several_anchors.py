"""Things at several others that are listed: "two lamps stand on the desk and the sideboard"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at, text_of
from thinkblox.reading.english.said import is_link

_AT_ONE = ("on", "on_top", "in", "inside", "under", "above", "over", "at")
"""What one thing is to one other only."""
_BESIDE = ("next_to", "near", "by", "facing", "facing_away", "opposite", "far")
"""What one thing may be to several."""
_OTHERS = ("in_front_of", "behind", "left_of", "right_of")
_PLACED = ("be", "stand", "hang", "lie", "sit")


def with_several_anchors(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which so many are at each of those listed, or one is beside each; the rest is not understood."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        link, anchors, end = chunks[at], *_listed(chunks, at + 1)
        if (
            len(anchors) < 2
            or not isinstance(link, Connector)
            or not is_link(link, "prepositions", *_AT_ONE, *_BESIDE, *_OTHERS)
        ):
            made.append(chunks[at])
            at += 1
            continue
        fronted = not made or is_link(made[-1], "mark", "stop", "semicolon")
        verb = chunk_at(chunks, end)
        subject = chunk_at(chunks, end + 1) if fronted and is_link(verb, "verbs", *_PLACED) else None
        if isinstance(subject, Noun) and subject.kind == "thing" and (told := _told(subject, link, anchors, made)):
            made += told
            at = end + 2
            continue
        told = _of_subject(made, link, anchors) if _ends(verb) and not fronted else []
        made = told or [*made, link]
        at = end if told else at + 1
    return made


def _listed(chunks: Sequence[Chunk], at: int) -> tuple[list[Noun], int]:
    """The things known that are listed from a chunk on, and where the list ends; empty where it is no list of these."""
    found: list[Noun] = []
    link = chunk_at(chunks, at - 1)
    while isinstance(noun := chunk_at(chunks, at), Noun) and noun.kind == "thing" and noun.definite and not noun.many:
        found.append(noun)
        at += 1
        joint = chunk_at(chunks, at)
        if is_link(joint, "joins", "and") and not (isinstance(joint, Connector) and joint.text.lower() == "also"):
            at += 1
            again = chunk_at(chunks, at)
            at += isinstance(again, Connector) and isinstance(link, Connector) and _is_same(again, link)
            last = chunk_at(chunks, at)
            if isinstance(last, Noun) and last.kind == "thing" and last.definite and not last.many:
                return [*found, last], at + 1
            return [], at
        if not is_link(joint, "mark", "comma"):
            return [], at
        at += 1
    return [], at


def _is_same(one: Connector, other: Connector) -> bool:
    return (one.sort, one.value) == (other.sort, other.value)


def _ends(chunk: Chunk | None) -> bool:
    return chunk is None or is_link(chunk, "mark") or is_link(chunk, "fillers")


def _of_subject(made: Sequence[Chunk], link: Connector, anchors: Sequence[Noun]) -> list[Chunk]:
    """What was said so far, with what is told of the noun before the preposition, with or without a verb between."""
    back = 1 + is_link(made[-1], "verbs", *_PLACED)
    subject = made[-back] if len(made) >= back else None
    if isinstance(subject, Noun) and subject.kind in ("thing", "number"):
        if link.value in _BESIDE and not subject.many and not subject.each:
            return [*made, *_beside(link, anchors)]
        if told := _told(subject, link, anchors, made[: len(made) - back]):
            return [*made[: len(made) - back], *told]
    lost = anchors[1:]
    stray = Stray(lost[0].start, lost[-1].end, f"and {text_of(lost)}")
    return [*made, link, anchors[0], stray]


def _beside(link: Connector, anchors: Sequence[Noun]) -> list[Chunk]:
    """The one beside the first, and beside the next."""
    found: list[Chunk] = [link, anchors[0]]
    for anchor in anchors[1:]:
        joint = Connector("joins", "and", anchor.start, anchor.start, "and")
        found += [joint, replace(link, start=anchor.start, end=anchor.start), anchor]
    return found


def _told(subject: Noun, link: Connector, anchors: Sequence[Noun], before: Sequence[Chunk]) -> list[Chunk]:
    """The things, and how many of them are at each; empty where these are not as many for each."""
    count = subject.count if subject.count is not None or not subject.definite else _counted(before, subject)
    single = not subject.plural and (count or 1) == 1 and not subject.definite
    number = len(anchors) if single or count is None else count
    if link.value not in _AT_ONE or number % len(anchors) or subject.each or (subject.definite and count is None):
        return []
    counted = None if subject.definite and subject.kind == "thing" else number
    whole = replace(subject, count=counted, plural=True)
    found: list[Chunk] = [whole, Connector("mark", "comma", link.start, link.start, ",")]
    each, start = number // len(anchors), link.start
    for at, anchor in enumerate(anchors):
        if at:
            found.append(Connector("joins", "and", start, start, "and"))
        some = Noun("number", "", start, start, str(each), count=each, plural=each > 1)
        found += [some, replace(link, start=start, end=start), anchor]
        start = anchor.end
    return found


def _counted(before: Sequence[Chunk], subject: Noun) -> int | None:
    """How many of them were named before."""
    named = (c for c in reversed(before) if isinstance(c, Noun) and c.value == subject.value and c.count is not None)
    return next((noun.count for noun in named), None)
