"""The last word of a name for the thing: "a glass shower cabin and a mat in front of the cabin"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Noun


def with_short_names(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the thing for "the cabin", which would be a room or nothing by itself, where its name ends so."""
    made = list(chunks)
    names: dict[str, Noun] = {}
    for at, noun in enumerate(made):
        if not isinstance(noun, Noun):
            continue
        if noun.kind == "thing" and " " in noun.called:
            names[noun.called.rpartition(" ")[2]] = noun
        elif noun.kind in ("room", "abstract", "people") and noun.det == "the" and noun.called in names:
            long = names[noun.called]
            made[at] = replace(noun, kind="thing", value=long.value, called=long.called, room="")
    return made
