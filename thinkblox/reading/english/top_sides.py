"""Corners and far ends that are of a thing and not of the room: "at its far left", "the far end of the table"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray, chunk_at, text_of
from thinkblox.reading.english.said import is_link

_CARRIED = 4
"""How many chunks before its place a thing is that carries another."""
_CORNERED = 5
"""So many chunks tell what a thing has in each of its corners."""
_NEAR = ("on", "near", "along", "at", "by", "next_to", "against")
_EDGES = ("edge", "rim", "end")
_SIDES = {"left_wall": "left", "right_wall": "right", "far_wall": "back", "near_wall": "front"}


def with_top_sides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a corner or an end of the room that is said to be of a thing is a part of that thing."""
    found: list[Chunk] = []
    chunks = _at_own_corners(chunks)
    for at, chunk in enumerate(chunks):
        owner = found[-1] if found else None
        if isinstance(chunk, Noun) and _is_end(chunk) and isinstance(owner, Noun) and _owns(owner, chunk):
            found[-1] = replace(_end(chunk), start=owner.start, det=owner.det, owner=owner.value)
        elif isinstance(chunk, Noun) and _is_corner(chunk) and _is_told_of(chunks, at):
            found.append(_corner(chunk))
        elif isinstance(chunk, Noun) and _is_end(chunk) and _is_told_of(chunks, at):
            found.append(_end(chunk))
        elif isinstance(chunk, Connector) and _is_at_edge(chunks, at):
            found.append(replace(chunk, value="on", text="at"))
        elif isinstance(chunk, Noun) and (top := _top_of_edge(chunks, at)) is not None:
            whole = replace(top, start=chunk.end, end=chunk.end, det="the", text=f"the {top.word}", count=None)
            link = found[-1]
            if isinstance(link, Connector) and link.value in _NEAR:
                found[-1] = replace(link, value="on", text="at")
            found += [chunk, Connector("prepositions", "of", chunk.end, chunk.end, "of"), whole]
        else:
            found.append(chunk)
    return found


def _at_own_corners(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with four bottles for "a table with a bottle in each corner"; where these are is not understood."""
    made = list(chunks)
    for at in range(len(made) - _CORNERED, -1, -1):
        whole, having, small, link, corner = made[at : at + _CORNERED]
        if not isinstance(corner, Noun) or corner.value != "corner":
            continue
        of, room = (*made[at + _CORNERED : at + _CORNERED + 2], None, None)[:2]
        had = is_link(having, "prepositions", "with") or is_link(having, "verbs", "have")
        one = isinstance(whole, Noun) and whole.kind == "thing" and not (whole.many or whole.each)
        each = corner.kind == "place" and corner.each
        if not (had and one and each) or not isinstance(small, Noun) or small.kind != "thing" or small.many:
            continue
        told = is_link(of, "prepositions", "of")
        if "room" in corner.text.lower().split():
            continue
        if not is_link(link, "prepositions", "in", "at", "on") or (told and not _is_same(room, whole)):
            continue
        end = at + _CORNERED + 2 * told
        text = text_of(made[at + 3 : end])
        made[at + 2 : end] = [replace(small, det="", count=4, plural=True), Stray(link.start, made[end - 1].end, text)]
    return made


def _is_same(noun: Chunk | None, whole: Chunk) -> bool:
    return isinstance(noun, Noun) and isinstance(whole, Noun) and (noun.value == whole.value or noun.value == "it")


def _is_at_edge(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether something small is "near the left edge of the table", which is on it."""
    edge, of, top = (*chunks[at + 1 : at + _CARRIED], None, None, None)[:3]
    if not is_link(chunks[at], "prepositions", *_NEAR) or not isinstance(edge, Noun) or not isinstance(top, Noun):
        return False
    surface = top.kind == "thing" and load_habits().is_in(top.value, "surfaces")
    if edge.kind != "part" or edge.word not in _EDGES or not is_link(of, "prepositions", "of") or not surface:
        return False
    before = (c for c in reversed(chunks[:at]) if not _is_of_verb(c))
    after = (c for c in chunks[at + _CARRIED :] if not _is_of_verb(c))
    named = next(before, None)
    named = named if isinstance(named, Noun) else next(after, None)
    small = isinstance(named, Noun) and named.kind == "thing" and load_habits().is_in(named.value, "small", "lamps")
    return small and not (at and is_link(chunks[at - 1], "prepositions"))


def _top_of_edge(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """What a sentence named that has the edge at which something small is: a room has none."""
    edge, small = chunks[at], chunks[at - 2] if at > 1 else None
    if not isinstance(edge, Noun) or edge.kind != "part" or edge.word not in ("edge", "rim") or edge.det != "the":
        return None
    told = is_link(chunk_at(chunks, at + 1), "prepositions", "of")
    if told or not is_link(chunks[at - 1], "prepositions") or not isinstance(small, Noun) or small.kind != "thing":
        return None
    ended = next((n for n in range(at - 1, -1, -1) if is_link(chunks[n], "mark", "stop", "semicolon")), -1)
    tops = [c for c in chunks[ended + 1 : at - 2] if isinstance(c, Noun) and c.kind == "thing"]
    carried = load_habits().is_in(small.value, "small", "lamps")
    return next((c for c in reversed(tops) if carried and load_habits().is_in(c.value, "surfaces")), None)


def _is_of_verb(chunk: Chunk) -> bool:
    return is_link(chunk, "verbs", "be", "stand") or is_link(chunk, "participles") or is_link(chunk, "fillers")


def _is_corner(place: Noun) -> bool:
    return place.kind == "place" and place.value.startswith("corner") and not (place.each or place.plural)


def _is_end(place: Noun) -> bool:
    """Whether it is "the far end", which is of the room unless it is said to be of something else."""
    return place.kind == "place" and place.value in _SIDES and place.called.split()[-1] in ("end", "side")


def _is_told_of(chunks: Sequence[Chunk], at: int) -> bool:
    place = chunks[at]
    told = isinstance(place, Noun) and _is_of_thing(place, chunks[at + 1 : at + 3])
    return told or _is_of_carrier(chunks, at) or _is_corner_of_top(chunks, at)


def _is_corner_of_top(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether what is "on the left corner" is on a table or desk that was named before: in those of a room it would be.

    "A desk with a lamp on the left corner", "a table with a vase on one corner and a book on the other".
    """
    place, link, small = chunks[at], chunks[at - 1] if at else None, chunks[at - 2] if at > 1 else None
    if not isinstance(place, Noun) or not _is_corner(place) or not is_link(link, "prepositions", "on"):
        return False
    ended = next((n for n in range(at - 1, -1, -1) if is_link(chunks[n], "mark", "stop", "semicolon")), -1)
    before = (c for c in chunks[ended + 1 : at - 2] if isinstance(c, Noun) and c.kind == "thing")
    carried = isinstance(small, Noun) and small.kind == "thing" and load_habits().is_in(small.value, "small", "lamps")
    return carried and any(load_habits().is_in(c.value, "surfaces") for c in before)


def _is_of_carrier(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "on the far right" tells where on a desk something small is: "a desk with a printer on the far right"."""
    place = chunks[at]
    if not isinstance(place, Noun) or place.kind != "place" or not place.called.startswith("far ") or at < _CARRIED:
        return False
    link, small, having, carrier = (chunks[at - n] for n in range(1, _CARRIED + 1))
    things = isinstance(small, Noun) and isinstance(carrier, Noun) and small.kind == carrier.kind == "thing"
    had = is_link(having, "prepositions", "with") or is_link(having, "verbs", "have", "carry", "hold")
    placed = is_link(link, "prepositions", "on", "at") and place.called.split()[-1] in ("left", "right")
    return had and placed and things and isinstance(small, Noun) and load_habits().is_in(small.value, "small")


def _is_of_thing(place: Noun, after: Sequence[Chunk]) -> bool:
    whole = after[1] if len(after) > 1 and is_link(after[0], "prepositions", "of") else None
    return place.det == "my" or (isinstance(whole, Noun) and whole.kind in ("thing", "pronoun"))


def _owns(owner: Noun, place: Noun) -> bool:
    """Whether a place is of the thing right before it: "the table's | far end"."""
    return owner.kind == "thing" and owner.end == place.start and owner.text.endswith(("'s", "'"))


def _corner(place: Noun) -> Noun:
    sides = [_SIDES.get(wall, "") for wall in place.value.split()[1:]]
    if place.called.startswith("far ") and place.called.split()[-1] in ("left", "right"):
        sides = sides[1:]
    return replace(place, kind="part", value=" ".join(sides) if sides and all(sides) else "corner", material="")


def _end(place: Noun) -> Noun:
    """One of the ends of something, or its side; which of them is the far one nobody can tell."""
    last = place.called.split()[-1]
    value = _SIDES[place.value] if place.value in ("left_wall", "right_wall") else last
    return replace(place, kind="part", value=value, count=1 if value == "end" else None, material="")
