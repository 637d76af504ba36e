"""Things of which it is said what they are doing: "fireplace going, boots drying"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.vocabulary import name_of
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.grammar import grammar


def with_doings(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what a thing is doing is a state of it rather than a part of its name."""
    return [_doing(chunk) if isinstance(chunk, Noun) else chunk for chunk in chunks]


def _doing(noun: Noun) -> Noun:
    words = noun.text.split()
    strange = noun.kind == "abstract" or (noun.kind == "thing" and not noun.named)
    if len(words) < 2 or not strange or words[-1].lower() not in grammar().lists["doings"]:
        return noun
    name = name_of([word.lower() for word in words[:-1]])
    if name is None or name.length != len(words) - 1:
        return noun
    return replace(
        noun,
        kind="thing",
        value=name.category,
        text=" ".join(words[:-1]),
        plural=name.plural and noun.count != 1,
        states=[*noun.states, words[-1].lower()],
        named=True,
    )
