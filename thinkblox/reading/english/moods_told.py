"""How a room feels, told by itself: "Earthy, hushed, a little imperfect."."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Adjective, Chunk, Noun
from thinkblox.reading.english.said import is_link

_ENDINGS = ("y", "ed", "ish", "ic", "ous", "ful", "less", "ive", "al", "ible", "able", "esque", "like", "ern", "ing")
"""What adjectives end with."""
_SOMEWHAT = ("a little ", "a bit ", "a touch ", "somewhat ", "slightly ")


def with_moods_told(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the words of a statement that only tells how the room feels are of its style."""
    made: list[Chunk] = []
    begin = 0
    for at in range(len(chunks) + 1):
        if at < len(chunks) and not is_link(chunks[at], "mark", "stop", "semicolon"):
            continue
        said = chunks[begin:at]
        made += [_of_style(chunk) for chunk in said] if _tells_mood(said) else said
        made += chunks[at : at + 1]
        begin = at + 1
    return made


def _tells_mood(said: Sequence[Chunk]) -> bool:
    """Whether nothing but adjectives come, of which one at least is plainly one."""
    words = [
        c
        for c in said
        if not (is_link(c, "mark", "comma") or is_link(c, "joins", "and", "but") or is_link(c, "fillers"))
    ]
    if not any(isinstance(chunk, Noun) for chunk in words) or not all(_may_be_mood(chunk) for chunk in words):
        return False
    return any(isinstance(c, Adjective) or c.word.endswith(_ENDINGS) for c in words if isinstance(c, (Adjective, Noun)))


def _may_be_mood(chunk: Chunk) -> bool:
    """Whether it is an adjective, or a word of which nothing is known and that is not counted."""
    if isinstance(chunk, Adjective):
        return not (chunk.states or chunk.unshown)
    if not isinstance(chunk, Noun) or chunk.named or chunk.kind != "thing" or chunk.plural or chunk.count is not None:
        return False
    alone = not (chunk.det or chunk.attributes or chunk.unshown or chunk.states)
    return alone or chunk.text.lower().startswith(_SOMEWHAT)


def _of_style(chunk: Chunk) -> Chunk:
    if not isinstance(chunk, Noun):
        return chunk
    return Adjective(chunk.start, chunk.end, chunk.text, styles=[chunk.word])
