"""Statements by keys: "sofa: against the north wall, table: in front of the sofa" says one thing of each."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link


def with_keyed(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a comma before a key ends the statement before it."""
    made = list(chunks)
    for at in range(len(made) - 3):
        comma, key, colon, told = made[at : at + 4]
        keyed = isinstance(key, Noun) and key.kind == "thing" and is_link(colon, "mark", "colon")
        if keyed and isinstance(comma, Connector) and is_link(comma, "mark", "comma") and is_link(told, "prepositions"):
            made[at] = replace(comma, value="semicolon")
    return made
