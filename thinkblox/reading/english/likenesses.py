"""Models that are named by what they are of: "a model of an eye" is an eye model."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.names import identifier_of
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.said import is_link

_LIKENESSES = ("model", "scale_model", "replica")


def with_likenesses(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a model of something is a thing of that name."""
    made: list[Chunk] = []
    for chunk in chunks:
        model, of = made[-2:] if len(made) > 1 else (None, None)
        if is_link(of, "prepositions", "of") and isinstance(model, Noun) and isinstance(chunk, Noun):
            shown = chunk.kind in ("thing", "abstract") and chunk.det in ("a", "the") and not chunk.many
            if model.kind == "thing" and model.value in _LIKENESSES and shown:
                name = f"{chunk.word} {model.value.replace('_', ' ')}"
                text = f"{model.text} of {chunk.text}"
                made[-2:] = [
                    replace(model, value=identifier_of(name), called=name, end=chunk.end, text=text, named=True)
                ]
                continue
        made.append(chunk)
    return made
