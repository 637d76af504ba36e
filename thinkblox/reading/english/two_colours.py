"""Things of two colours, and looks after a participle: "a black and white rug", "painted green", "covered in felt"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.palette import COLOURS
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_COVERED = ("covered in", "covered with", "covered by")


def with_two_colours(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "a black and white rug" is one noun of both colours, and "painted green" is no thing."""
    made: list[Chunk] = []
    for chunk in chunks:
        first = made[-2] if len(made) > 1 and is_link(made[-1], "joins", "and") else None
        whole = _both(first, chunk) if isinstance(chunk, Noun) and first is not None else None
        if whole is not None:
            made[-2:] = [whole]
        elif isinstance(chunk, Adjective) and chunk.attributes and made and _is_finish(made[-1]):
            made[-1] = replace(chunk, start=made[-1].start)
        elif isinstance(chunk, Noun) and (colour := _painted(chunk)) and made and _may_tell(made[-1]):
            made.append(Adjective(chunk.start, chunk.end, chunk.text, [colour]))
        elif isinstance(chunk, Adjective) and chunk.attributes and made and _is_cover(made[-1]):
            made[-1] = replace(chunk, start=made[-1].start)
        else:
            made.append(chunk)
    return made


def _both(first: Chunk, noun: Noun) -> Noun | None:
    """The noun with the colour before "and" too, and with its article or number; None where these are two things."""
    bare = noun.kind == "thing" and not noun.det and noun.count is None and noun.named
    own = [a for a in noun.attributes if a in COLOURS]
    if not (bare and own) or not isinstance(first, (Noun, Adjective)):
        return None
    looks = first.attributes or (first.looks if isinstance(first, Noun) else [])
    colours = [a for a in looks if a in COLOURS]
    if len(colours) != 1 or own[0] in colours or first.unshown or first.states:
        return None
    told = [*looks, *(a for a in noun.attributes if a not in looks)]
    if isinstance(first, Adjective):
        return replace(noun, start=first.start, attributes=told) if noun.plural else None
    alone = first.kind == "number" or (first.kind == "thing" and bool(first.looks) and not first.named)
    alone |= first.kind == "thing" and bool(first.looks) and not first.called
    if not alone or (first.count is None and noun.plural and first.det == "a"):
        return None
    fates = {**first.fates, **noun.fates}
    text = f"{first.text} and {noun.text}"
    return replace(noun, start=first.start, det=first.det, count=first.count, attributes=told, fates=fates, text=text)


def _is_finish(chunk: Chunk) -> bool:
    return isinstance(chunk, Stray) and chunk.text.lower() in grammar().lists["finished"]


def _may_tell(chunk: Chunk) -> bool:
    """Whether what comes after it may say how something looks: "is painted green", ", painted green"."""
    return is_link(chunk, "mark", "comma") or is_link(chunk, "verbs", "be")


def _is_cover(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and chunk.sort == "inverses" and chunk.text.lower() in _COVERED


def _painted(noun: Noun) -> str:
    """The colour of "painted green", where that is said alone."""
    words = noun.text.lower().split()
    if noun.kind != "thing" or noun.named or len(words) < 2 or words[0] not in grammar().lists["finished"]:
        return ""
    colour = "-".join(words[1:])
    return colour if colour in COLOURS else ""
