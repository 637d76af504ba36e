"""What is told in passing of things named before: ", with the mouse beside the keyboard"."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_NO_PLACE = ("with", "of", "for")
_BESIDE = ("in_front_of", "behind", "next_to", "around", "left_of", "right_of", "at")
_UNDER_OR_OVER = ("under", "above", "behind", "in", "inside", "next_to")
_ITEMS = 3
_OTHERS = ("the other two", "the others", "the other ones")


def with_asides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is told in passing is told by itself, or of what it is told of."""
    made: list[Chunk] = []
    chunks = _bracketed(chunks)
    for at, chunk in enumerate(chunks):
        made.append(chunk)
        if isinstance(chunk, Noun) and _is_other_of_two(chunks, at):
            made[-1] = replace(chunk, det="another", count=1)
        elif isinstance(chunk, Connector) and _is_of_it_too(chunks, at):
            made.append(Noun("pronoun", "it", chunk.start, chunk.end, "it"))
        elif isinstance(chunk, Connector) and _is_before_filler(chunks, at):
            made[-1] = replace(chunk, sort="fillers", value="words")
        elif isinstance(chunk, Connector) and _is_for_what_lies_there(chunks, at):
            made[-1] = replace(chunk, value="with")
        elif isinstance(chunk, Connector) and _is_told_anew(chunks, at):
            made[-1] = replace(chunk, sort="mark", value="stop")
        elif isinstance(chunk, Noun) and chunk.kind == "pronoun" and is_link(chunks[at - 1], "prepositions"):
            beside = chunk.value == "it" and is_link(chunks[at - 1], "prepositions", *_BESIDE)
            if beside and (subject := _subject(chunks, at)) is not None:
                made[-1] = replace(subject, start=chunk.start, end=chunk.end, text=f"the {subject.word}", det="the")
            elif chunk.text.lower() in _OTHERS and is_link(chunks[at - 1], "prepositions", "between"):
                made[-1:] = _other_two(chunks, at) or [chunk]
    return made


def _is_of_it_too(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "underneath" comes in "has a lamp on it and a bin underneath", which is under the same thing."""
    if at < _ITEMS or not is_link(chunks[at], "prepositions", *_UNDER_OR_OVER):
        return False
    after = chunk_at(chunks, at + 1)
    if not (after is None or is_link(after, "mark") or is_link(after, "joins")):
        return False
    it, joint, thing = chunks[at - 3 : at]
    joined = is_link(joint, "joins", "and") and isinstance(thing, Noun) and thing.kind == "thing"
    placed = at > _ITEMS and is_link(chunks[at - 4], "prepositions")
    return joined and placed and isinstance(it, Noun) and it.kind == "pronoun" and it.value == "it"


def _is_told_anew(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether ", with the keyboard in front of the monitor" says where something known is."""
    noun, place = (*chunks[at + 1 : at + 3], None, None)[:2]
    if not at or not is_link(chunks[at], "prepositions", "with") or not is_link(chunks[at - 1], "mark", "comma"):
        return False
    if not isinstance(noun, Noun) or noun.kind != "thing" or noun.det != "the" or not isinstance(place, Connector):
        return False
    known = any(isinstance(c, Noun) and c.kind == "thing" and c.value == noun.value for c in chunks[:at])
    return known and place.sort == "prepositions" and place.value not in _NO_PLACE


def _bracketed(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with brackets for dashes around adjectives alone: "a table - round, of course - stands there"."""
    made = list(chunks)
    dashes = [at for at, chunk in enumerate(made) if is_link(chunk, "mark", "dash")]
    for one, other in pairwise(dashes):
        inner = made[one + 1 : other]
        plain = all(isinstance(c, Adjective) or is_link(c, "fillers") or is_link(c, "mark", "comma") for c in inner)
        if plain and any(isinstance(c, Adjective) for c in inner):
            for at, value in ((one, "open"), (other, "close")):
                mark = made[at]
                made[at] = replace(mark, value=value) if isinstance(mark, Connector) else mark
    return made


def _is_before_filler(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a comma only sets off words that say nothing, before a dash or bracket ends: "- round, of course -"."""
    filler, mark = (*chunks[at + 1 : at + 3], None, None)[:2]
    return (
        is_link(chunks[at], "mark", "comma") and is_link(filler, "fillers") and is_link(mark, "mark", "dash", "close")
    )


def _is_for_what_lies_there(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "a side table for a lamp" is one with a lamp on it."""
    table, thing = (*chunks[max(at - 1, 0) : at + 2 : 2], None, None)[:2]
    if not is_link(chunks[at], "prepositions", "for") or not isinstance(table, Noun) or not isinstance(thing, Noun):
        return False
    both = table.kind == thing.kind == "thing" and thing.det == "a" and thing.named
    habits = load_habits()
    return both and habits.is_in(table.value, "tables") and habits.is_in(thing.value, "small")


def _is_other_of_two(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "one slipper under the bed, the other slipper by the door" names a second one."""
    other = chunks[at]
    if not isinstance(other, Noun) or other.kind != "thing" or other.det != "other" or other.plural or other.count:
        return False
    alike = [c for c in chunks[:at] if isinstance(c, Noun) and c.kind == "thing" and c.value == other.value]
    return len(alike) == 1 and alike[0].count == 1 and alike[0].text.lower().startswith("one ")


def _sentence(chunks: Sequence[Chunk], at: int) -> int:
    """Where the sentence of a chunk begins."""
    ends = (n for n in range(at - 1, -1, -1) if is_link(chunks[n], "mark", "stop", "semicolon"))
    return next(ends, -1) + 1


def _subject(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """What "it" is in "A bar is far from the table, with five stools in front of it": what the sentence is about."""
    first = _sentence(chunks, at)
    said, verb = chunks[first], chunks[first + 1]
    led = at - first > _ITEMS and is_link(chunks[at - 3], "prepositions", "with")
    if not led or not is_link(chunks[at - 4], "mark", "comma") or not is_link(verb, "verbs", "be", "stand"):
        return None
    small = isinstance(said, Noun) and load_habits().is_in(said.value, "small")
    return said if isinstance(said, Noun) and said.kind == "thing" and not (said.many or small) else None


def _other_two(chunks: Sequence[Chunk], at: int) -> list[Chunk]:
    """The two that were listed with what is said to be between "the other two"."""
    subject, other = chunks[at - 2], chunks[at]
    if not isinstance(subject, Noun):
        return []
    listed = [c for c in chunks[: at - 2] if isinstance(c, Noun) and c.kind == "thing"][-_ITEMS:]
    others = [c for c in listed if c.value != subject.value]
    if len(listed) != _ITEMS or len(others) != _ITEMS - 1 or any(c.many for c in listed):
        return []
    one, two = (replace(c, start=other.start, end=other.end, det="the", count=None) for c in others)
    return [one, Connector("joins", "and", other.start, other.start), replace(two, start=other.end, end=other.end)]
