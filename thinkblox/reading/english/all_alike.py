"""What all of a list look like: "a table and four chairs, all white", "a sofa and a bench, both made of leather"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_ALL = ("all", "both")


def with_all_alike(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "all" before a look, after what it is said of, stands for all of these."""
    made = list(chunks)
    for at in range(len(made) - 2, 1, -1):
        word = _all(made[at])
        if not word or not _ends_list(made[:at]):
            continue
        after = at + 1
        if is_link(made[after], "prepositions", "of") and _is_them(made[after + 1 : after + 2]):
            after += 2
        if _is_look(made[after:]):
            said = made[at]
            made[at:after] = [Noun("pronoun", "all", said.start, made[after].start, "all", det=word)]
    return made


def _all(chunk: Chunk) -> str:
    """The word "all" or "both", where that stands for what was named; empty for anything else."""
    pronoun = isinstance(chunk, Noun) and chunk.kind == "pronoun"
    if not isinstance(chunk, (Noun, Connector)) or not (pronoun or is_link(chunk, "fillers")):
        return ""
    word = chunk.text.lower().partition(" ")[0]
    return word if word in _ALL else ""


def _ends_list(before: Sequence[Chunk]) -> bool:
    """Whether a comma after a thing comes before it."""
    return is_link(before[-1], "mark", "comma", "dash") and isinstance(before[-2], Noun) and before[-2].kind == "thing"


def _is_them(chunks: Sequence[Chunk]) -> bool:
    return any(isinstance(chunk, Noun) and chunk.value == "them" for chunk in chunks)


def _is_look(chunks: Sequence[Chunk]) -> bool:
    """Whether an adjective comes, or what something is made of."""
    said = [chunk for chunk in chunks[:3] if not is_link(chunk, "fillers") and not is_link(chunk, "prepositions", "of")]
    return bool(said) and isinstance(said[0], Adjective)
