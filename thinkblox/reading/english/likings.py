"""What somebody likes, which asks for nothing: "a bedroom for my daughter, who loves horses"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.said import is_link

_LIKING = ("love", "loves", "like", "likes", "adore", "adores", "enjoy", "enjoys")
_PRONOUNS = ("i", "we", "you", "he", "she", "they")


def with_likings(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what people like is not asked for, where it is named without a number or an article."""
    made = list(chunks)
    for at in range(len(made)):
        start, said = _liked_from(made, at), made[at]
        if start and isinstance(said, Connector) and said.sort == "prepositions":
            made[at] = Connector("verbs", "other", said.start, said.end, said.text)
        told = _listed(made, start) if start else 0
        if told and isinstance(said, Noun):
            start, told = at, told + start - at  # "A fan of trains".
        for liked in range(start, start + told):
            made[liked] = filler(made[liked])
    return made


def _liked_from(chunks: Sequence[Chunk], at: int) -> int:
    """Where it begins what is liked, if the chunk says that somebody likes it; else 0."""
    said, who = chunks[at], chunks[at - 1] if at else None
    after = chunk_at(chunks, at + 1)
    if isinstance(said, Noun) and said.word == "fan" and is_link(after, "prepositions", "of"):
        return at + 2
    if not isinstance(said, Connector) or not _is_somebody(who):
        return 0
    if said.text.lower() in _LIKING:
        return at + 1 + is_link(after, "prepositions", "to")
    into = after if is_link(said, "verbs", "be") else None
    return at + 2 if isinstance(into, Connector) and into.text.lower() == "into" else 0


def _is_somebody(who: Chunk | None) -> bool:
    if isinstance(who, Noun):
        return who.kind == "people"
    return isinstance(who, Connector) and (who.text.lower() in ("who", *_PRONOUNS))


def _listed(chunks: Sequence[Chunk], start: int) -> int:
    """How many chunks "horses", "dinosaurs and trains", "cars, trains and planes" are; 0 for other words."""
    end, joined = start, False
    while end < len(chunks) and _is_bare(chunks[end]) and not joined:
        after = chunks[end + 1] if end + 1 < len(chunks) else None
        more = end + 2 < len(chunks) and _is_bare(chunks[end + 2])
        if not more or not (is_link(after, "joins", "and", "or") or _is_longer(chunks, end + 1)):
            return end + 1 - start
        joined = is_link(after, "joins")
        end += 2
    return end + 1 - start if joined else end - start


def _is_longer(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a comma comes in a list that "and" ends."""
    comma = is_link(chunks[at], "mark", "comma")
    return comma and any(is_link(c, "joins", "and") for c in chunks[at + 2 : at + 3])


def _is_bare(chunk: Chunk) -> bool:
    """Whether things are named in general: "horses", "football"."""
    return isinstance(chunk, Noun) and chunk.kind in ("thing", "abstract") and not (chunk.det or chunk.count)
