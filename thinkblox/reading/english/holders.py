"""Racks and stands that are for what they hold: the test tube rack of "a rack holding four test tubes"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.vocabulary import name_of
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link


def with_holders(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which one of several things that are listed is called after what it holds."""
    made = list(chunks)
    for at in range(1, len(made) - 2):
        holder, content = made[at], made[at + 2]
        if not isinstance(holder, Noun) or not isinstance(content, Noun) or not is_link(made[at - 1], "mark", "comma"):
            continue
        holds = is_link(made[at + 1], "participles", "hold") or is_link(made[at + 1], "prepositions", "with")
        single = holder.kind == "thing" and not holder.many
        if holds and single and (called := called_after(content.value, holder)):
            made[at] = replace(holder, value=called)
    return made


def called_after(content: str, holder: Noun) -> str:
    """What a general holder of such contents is called; empty where it has no name of its own."""
    words = holder.text.lower().split()
    if not words or words[-1] not in grammar().lists["holders"]:
        return ""
    known, found = name_of(words), name_of([*content.split("_"), words[-1]])
    general = known is None or known.length == 1
    return (found.name or found.category) if general and found is not None and found.length > 1 else ""
