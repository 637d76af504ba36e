"""Things that are named with others and have places of their own: "a bed in one corner with a desk in another one"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_PLACING = ("in", "on", "at", "by", "against", "along", "next_to", "near", "under", "in_front_of")


def with_own_places(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "with" only joins what stands at a place of the room to what stands at another place of it."""
    made = list(chunks)
    for at in range(3, len(made) - 3):
        link = made[at]
        if isinstance(link, Connector) and is_link(link, "prepositions", "with") and _are_apart(made, at):
            made[at] = Connector("joins", "and", link.start, link.end, link.text)
    return _parted(made)


def _are_apart(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a thing is at one place before the word, and another thing at another place after it."""
    before = at - 1 if is_link(chunks[at - 1], "mark", "comma") else at
    thing = chunks[before - 3]
    if before > 3 and (is_link(thing, "verbs", "be", "stand", "hang") or is_link(thing, "participles", "stand")):
        seats = before > 5 and is_link(chunks[before - 5], "prepositions", "for")
        thing = chunks[before - 6] if seats else chunks[before - 4]
    other, place = chunks[at + 1], chunks[before - 1]
    named = isinstance(thing, Noun) and thing.kind == "thing" and isinstance(other, Noun) and other.kind == "thing"
    own = _place(chunks, at + 2)
    new = isinstance(other, Noun) and not other.definite and not other.each
    if not named or not new or own is None or not isinstance(place, Noun):
        return False
    first = _place(chunks, before - 2)
    return first is not None and first is place and first.value != own.value and own.det != "each"


def _place(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The place of the room that "in the corner" is; None for other words."""
    link, place = (*chunks[at : at + 2], None, None)[:2]
    if not is_link(link, "prepositions", *_PLACING) or not isinstance(place, Noun):
        return None
    if place.kind != "place" and (place.kind, place.value) != ("part", "middle"):
        return None
    return None if place.value in ("floor", "ceiling") else place


def _parted(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "a sofa and a chair with a table between them" for those two "separated by a table"."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        link, between = chunks[at], chunk_at(chunks, at + 1)
        if isinstance(link, Connector) and _parts_two(chunks, at) and isinstance(between, Noun):
            while made and (is_link(made[-1], "mark", "comma") or is_link(made[-1], "verbs", "be")):
                made.pop()
            them = Noun("pronoun", "them", between.end, between.end, "them")
            made += [Connector("prepositions", "with", link.start, link.end, "with"), between]
            made += [Connector("prepositions", "between", between.end, between.end, "between"), them]
            at += 2
        else:
            made.append(link)
            at += 1
    return made


def _parts_two(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "separated by a table" comes after two single things that "and" joined."""
    if not is_link(chunks[at], "inverses", "between"):
        return False
    end = at
    while end and (is_link(chunks[end - 1], "mark", "comma") or is_link(chunks[end - 1], "verbs", "be")):
        end -= 1
    one, joint, other = (*chunks[max(0, end - 3) : end], None, None, None)[:3]
    things = [noun for noun in (one, other) if isinstance(noun, Noun) and noun.kind == "thing" and not noun.many]
    return len(things) > 1 and is_link(joint, "joins", "and")
