"""What is told of a thing by "where" and by "on which": "a desk, where two monitors stand".

A list before its verb ("on which a till, a bell and a vase stand") is read as one after it ("on which there are ...").
"""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.said import is_link
from thinkblox.reading.english.serial_commas import is_of_several, next_listed

_WHERE = "where"
_PAIR = 2


def with_where_told(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with "on which", "at which" in its place; after a corner or a window it is said not to be understood."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        last = made[-1] if made else None
        comma = is_link(last, "mark", "comma")
        place = (made[-2] if comma and len(made) > 1 else None) if comma else last
        told = isinstance(chunk, Connector) and chunk.sort == "joins" and chunk.text.lower() == _WHERE
        thing = told and isinstance(place, Noun) and place.kind in ("thing", "place", "part")
        there = _there(chunks, at + 1) if thing else 0
        first = chunk_at(chunks, at + 1 + there)
        placed = thing and (there or _is_placed(chunks, at + 1))
        if not isinstance(chunk, Connector) or not placed or not isinstance(first, Noun):
            made.append(chunk)
        elif isinstance(place, Noun) and place.kind == "thing":
            made.append(Connector("prepositions", _word(place, first), chunk.start, chunk.start, _WHERE))
            made.append(Connector("joins", "which", chunk.start, chunk.end, "which"))
        else:
            made += [Stray(chunk.start, chunk.end, chunk.text), chunk]
    return made


def with_lists_there(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the verb comes before such a list of more than two."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        led = is_link(chunks[at], "joins", "which") and is_link(made[-1] if made else None, "prepositions")
        end, length = _list(chunks, at + 1) if led else (0, 0)
        verb = chunk_at(chunks, end)
        told = length > _PAIR and is_of_several(verb) and is_link(verb, "verbs", "be", "stand", "hang")
        after = end + 1 + is_link(chunk_at(chunks, end + 1), "participles", "stand", "hang")
        ends = chunk_at(chunks, after) is None or is_link(chunk_at(chunks, after), "mark")
        which, link = chunks[at], made[-1] if made else None
        if not (told and ends) or not isinstance(verb, Connector) or not isinstance(link, Connector):
            made.append(which)
            at += 1
            continue
        there = replace(verb, sort="verbs", value="be", start=which.end, end=which.end, text="there are")
        if link.value == "on":
            made[-1] = Connector("participles", "carry", link.start, which.end, "on which there are")
        else:
            made += [which, there]
        made += chunks[at + 1 : end]
        made.append(replace(verb, sort="fillers", value="words"))
        at = after
    return made


def _list(chunks: Sequence[Chunk], at: int) -> tuple[int, int]:
    """Where a list of new things ends, and how many it names."""
    noun, end, length = chunk_at(chunks, at), at + 1, 1
    if not isinstance(noun, Noun) or noun.kind != "thing" or noun.definite:
        return at, 0
    while after := next_listed(chunks, end):
        end, length = after, length + 1
    return end, length


def _is_placed(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether new things come that a verb says to be there."""
    end, length = _list(chunks, at)
    return length > 0 and is_link(chunk_at(chunks, end), "verbs", "be", "stand", "hang")


def _there(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks "there is also" has before something new; 0 where that does not come."""
    end = at + is_link(chunk_at(chunks, at), "verbs", "be")
    while end > at and is_link(chunk_at(chunks, end), "fillers"):
        end += 1
    return end - at if end > at and _list(chunks, end)[1] else 0


def _word(place: Noun, first: Noun) -> str:
    """How what is said to be at a thing stands to it."""
    habits = load_habits()
    if habits.is_in(first.value, "seats", "chairs"):
        return "at"
    return "on" if habits.is_in(place.value, "surfaces", "beds", "lounges", "shelves") else "next_to"
