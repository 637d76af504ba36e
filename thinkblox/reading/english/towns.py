"""Where in the world a room is, which is said in passing: "a cafe in Paris", "a bar in tokyo, japan"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Noun, Stray, filler
from thinkblox.reading.english.said import is_link


def with_towns(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which no thing goes by the name of the town or country that a room is in."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        room, link = (made[-2] if len(made) > 1 else None), (made[-1] if made else None)
        of_room = isinstance(room, Noun) and (room.kind == "room" or room.room) and is_link(link, "prepositions", "in")
        land = at > 1 and is_link(chunks[at - 1], "mark", "comma") and made[-2:-1] == [filler(chunks[at - 2])]
        if isinstance(chunk, Noun) and _is_name(chunk) and (of_room or land):
            if of_room and link is not None:
                made[-1] = filler(link)
            made.append(filler(chunk) if chunk.text.split()[-1][:1].isupper() or land else _untold(chunk))
        else:
            made.append(chunk)
    return made


def _untold(noun: Noun) -> Stray:
    """A word in small letters that may be the name of a town, or of what we do not know."""
    return Stray(noun.start, noun.end, noun.text)


def _is_name(noun: Noun) -> bool:
    """Whether it is a word of which no thing is known to go by that, as it is."""
    name = noun.text.split()[-1][:1].isupper()
    bare = not noun.det or (noun.det == "the" and name)
    plain = not (noun.attributes or noun.unshown) and (name or not noun.plural)
    return noun.kind == "thing" and not noun.named and bare and noun.count is None and plain
