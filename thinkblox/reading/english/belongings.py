"""What belongs to the thing named just before: "a piano, its bench and a lamp", "its ladder facing the window"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets import kind_of
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_OWNED = ("its ", "their ")
_ITS_OWN = "its own "
_STANDING = ("be", "stand")


def with_belongings(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a thing has what is said to be its own, and a part that looks somewhere is the thing itself.

    Where else a part of a thing is to be is not understood.
    """
    made = _with_new(chunks)
    for at in range(len(made) - 1, 0, -1):
        own, link = made[at], made[at - 1]
        if not isinstance(own, Noun) or own.kind != "thing" or not own.text.lower().startswith(_OWNED):
            continue
        if _is_part(made, at):
            made[at : at + 3] = _part(own, made[at + 1 : at + 3])
        elif isinstance(link, Connector) and at > 1 and _is_had(made, at):
            made[at - 1] = Connector("prepositions", "with", link.start, link.end, "with")
            after = chunk_at(made, at + 1)
            if isinstance(after, Connector) and is_link(after, "joins", "and") and not _is_owned(made, at + 2):
                made[at + 1] = Connector("mark", "comma", after.start, after.end, ",")
    return made


def _with_new(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks in which another has "its own stool", which is none that was named before."""
    made: list[Chunk] = []
    named: set[str] = set()
    for chunk in chunks:
        if isinstance(chunk, Noun) and chunk.kind == "thing":
            own = chunk.det == "my" and chunk.text.lower().startswith(_ITS_OWN) and chunk.value in named
            named.add(chunk.value)
            chunk = replace(chunk, det="a") if own and is_link(made[-1], "prepositions", "with") else chunk
        made.append(chunk)
    return made


def _part(own: Noun, after: Sequence[Chunk]) -> list[Chunk]:
    link, place = (*after, None, None)[:2]
    if not is_link(link, "prepositions") or is_link(link, "prepositions", "facing") or not isinstance(place, Noun):
        return [Noun("pronoun", "it", own.start, own.end, "it"), *after]
    words = " ".join(getattr(chunk, "text", "") for chunk in (own, *after))
    return [Stray(own.start, place.end, words)]


def _is_owned(chunks: Sequence[Chunk], at: int) -> bool:
    own = chunk_at(chunks, at)
    return isinstance(own, Noun) and own.text.lower().startswith(_OWNED)


def _is_part(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a bed's ladder is named, which is no thing of its own."""
    own = chunks[at]
    before = (c for c in reversed(chunks[:at]) if isinstance(c, Noun) and c.kind == "thing")
    owner = next(before, None)
    of_bed = owner is not None and owner.word in grammar().lists["climbed"]
    return isinstance(own, Noun) and of_bed and own.word in grammar().lists["climbing"]


def _is_had(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a comma or "and" joins it to furniture, and nothing else is said of it alone."""
    owner, after = chunks[at - 2], chunk_at(chunks, at + 1)
    if not isinstance(owner, Noun) or owner.kind != "thing" or _is_owned(chunks, at - 2):
        return False
    if kind_of(owner.value).mount == "surface":
        return False
    ends = after is None or is_link(after, "mark") or is_link(after, "joins")
    comma = is_link(chunks[at - 1], "mark", "comma") and ends and not owner.definite
    return comma or (is_link(chunks[at - 1], "joins", "and") and (ends or is_link(after, "verbs", *_STANDING)))
