"""Things told apart though nobody said how many there are: "the left nightstand has ..., the right one ..."."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.assets.palette import COLOURS
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.adjectives import LOOKS_BY_DEGREE, degree_of
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.said import is_holding, is_link

_SIDES = ("left", "right")
_SIZES = ("large", "small")
_SHELVED = ("shelves", "storage", "cases", "tops")
_PAIR = 2


def with_told_apart(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which the first of several that are told apart says of how many, and each of another colour is new."""
    made = _ones(_shelves(chunks))
    for group in _groups(made):
        marks = {_mark(noun) for _, noun in group}
        if len(marks) < _PAIR:
            continue
        at, first = group[0]
        if first.ordinal:
            made[at] = replace(first, total=max(noun.ordinal for _, noun in group))
        elif first.side:
            made[at] = replace(first, total=_PAIR)
        else:
            for place, noun in _firsts(group):
                made[place] = _new(noun)
    return made


def _ones(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "one red and the other blue" for "two lamps, one lamp red and the other blue"."""
    made, several = list(chunks), ""
    for at, chunk in enumerate(chunks):
        if not isinstance(chunk, Noun) or chunk.kind != "thing":
            continue
        look, link, other = (*chunks[at + 1 : at + 4], None, None, None)[:3]
        one = chunk.value == several and chunk.count == 1 and not (chunk.det or chunk.attributes)
        told = isinstance(look, Adjective) and bool(look.attributes) and is_link(link, "joins", "and")
        if one and told and isinstance(look, Adjective) and isinstance(other, Noun) and other.det == "other":
            text = f"{chunk.text.split()[0]} {look.text}"
            made[at] = replace(chunk, kind="number", value="", text=text, called="", attributes=[*look.attributes])
            made[at + 1] = filler(look)
        several = chunk.value if chunk.plural else several
    return made


def _shelves(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with what "the upper shelf holds" on that of what was named, or on a shelf of its own."""
    made: list[Chunk] = []
    seen: set[str] = set()
    named = False
    for at, chunk in enumerate(chunks):
        verb = chunk_at(chunks, at + 1)
        named |= isinstance(chunk, Noun) and chunk.kind == "thing" and load_habits().is_in(chunk.value, *_SHELVED)
        last = made[-1] if made else None
        if isinstance(chunk, Noun) and _is_shelf(chunk) and _holds(verb):
            on = Connector("prepositions", "on", chunk.start, chunk.start, "on")
            made += [on, chunk] if named else [_shelf(chunk, seen)]
        elif named and isinstance(chunk, Connector) and _holds(chunk) and isinstance(last, Noun) and _is_shelf(last):
            made.append(replace(chunk, value="stand"))
        else:
            made.append(chunk)
    return made


def _is_shelf(noun: Noun) -> bool:
    return noun.kind == "part" and noun.value == "in_shelf" and noun.word == "shelf"


def _holds(verb: Chunk | None) -> bool:
    return is_holding(verb)


def _shelf(noun: Noun, seen: set[str]) -> Noun:
    """The shelf as a thing, new where it was not seen; which of several it is we do not show."""
    text = noun.text.lower()
    which = [text.split()[-2]] if text not in seen and len(text.split()) > 1 else []
    seen.add(text)
    return replace(noun, kind="thing", value="any_shelf", det="a" if which else "the", unshown=which)


def _new(noun: Noun) -> Noun:
    """The noun as of something new: "a large table" for "the larger table"."""
    looks = [*LOOKS_BY_DEGREE.get(degree_of(noun.degree), ())][:1] if noun.degree else []
    unshown = [word for word in noun.unshown if word != noun.degree]
    return replace(noun, det="a", degree="", attributes=[*noun.attributes, *looks], unshown=unshown)


def _groups(chunks: Sequence[Chunk]) -> Iterator[list[tuple[int, Noun]]]:
    """The nouns of one kind of which each tells one from others in the same way, and no other noun tells of them."""
    named: dict[str, list[tuple[int, Noun]]] = {}
    for at, chunk in enumerate(chunks):
        if isinstance(chunk, Noun) and chunk.kind == "thing":
            named.setdefault(chunk.value, []).append((at, chunk))
        elif isinstance(chunk, Noun) and chunk.kind == "number" and chunk.det == "the" and chunk.side:
            _add_one(named, at, chunk)
    for nouns in named.values():
        kinds = {_kind(noun) for _, noun in nouns}
        if len(kinds) == 1 and kinds != {""}:
            yield nouns


def _add_one(named: dict[str, list[tuple[int, Noun]]], at: int, one: Noun) -> None:
    """Count "the right one" among what was told to be on a side last."""
    sided = [nouns for nouns in named.values() if nouns[-1][1].side]
    if sided:
        max(sided, key=lambda nouns: nouns[-1][0]).append((at, one))


def _kind(noun: Noun) -> str:
    """In which way a noun tells one thing from others; empty where it does not."""
    single = noun.det == "the" and noun.count in (None, 1) and not noun.plural and not noun.total and not noun.of_known
    if not single or noun.owner or noun.among:
        return ""
    if noun.ordinal:
        return "ordinal" if noun.ordinal > 0 else ""
    if noun.side:
        return "side" if noun.side in _SIDES else ""
    if not _mark(noun):
        return ""
    return "size" if noun.degree or _mark(noun) in _SIZES else "colour"


def _mark(noun: Noun) -> str:
    if noun.ordinal or noun.side:
        return f"{noun.ordinal}{noun.side}"
    if noun.degree:
        return next(iter(LOOKS_BY_DEGREE.get(degree_of(noun.degree), ())), "")
    for told in (COLOURS, _SIZES):
        looks = [look for look in noun.attributes if look in told]
        if looks:
            return looks[0] if len(looks) == 1 else ""
    return ""


def _firsts(group: Sequence[tuple[int, Noun]]) -> Iterator[tuple[int, Noun]]:
    """The first noun of each colour."""
    seen: set[str] = set()
    for at, noun in group:
        if _mark(noun) not in seen:
            seen.add(_mark(noun))
            yield at, noun
