"""Words for things of many kinds: "both appliances" names again what was named, "white furniture: a bed, ..." looks."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.palette import COLOURS
from thinkblox.assets.plurals import singular
from thinkblox.assets.repaint import LOOKS
from thinkblox.knowledge.collectives import Collective, collective
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Adjective, Chunk, Noun, Stray, chunk_at, text_of
from thinkblox.reading.english.said import is_link

_PAIR = 2
_POINTING = ("the", "all", "both", "each")
_BETWEEN = 6
"""So many chunks come before "all" in "a stove between a fridge and a sink, all along one wall"."""
_MASSES = ("furniture", "furnishing", "seating", "storage", "tableware", "crockery", "dinnerware", "lighting")
"""Words for several things that have no plural."""


def with_collectives(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which such a noun says which of those named before it means, where these are as many as it says."""
    made: list[Chunk] = []
    chunks = _with_looks(_whole(_all_between(chunks)))
    at = 0
    while at < len(chunks):
        chunk = chunks[at]
        among = _meant_by(chunk, made) if isinstance(chunk, Noun) else []
        length = 1
        if isinstance(chunk, Noun) and among:
            value = singular(chunk.text.split()[-1].lower())
            made.append(replace(chunk, kind="thing", value=value, count=None, plural=True, room="", among=tuple(among)))
        elif isinstance(chunk, Noun) and (lost := _not_meant(chunks, at, made)):
            length = lost
            text = text_of(chunks[at : at + length])
            made.append(Stray(chunk.start, chunks[at + length - 1].end, text))
        else:
            made.append(chunk)
        at += length
    return made


def _not_meant(chunks: Sequence[Chunk], at: int, before: Sequence[Chunk]) -> int:
    """How many chunks say what "all four appliances" are where three were named, or of which colour what is unknown."""
    noun, be, look = (*chunks[at : at + 3], None, None)[:3]
    kinds = _kinds(noun) if isinstance(noun, Noun) and noun.det in _POINTING else None
    if not isinstance(noun, Noun) or kinds is None:
        return 0
    if noun.kind == "thing":
        counted = bool(noun.count) and noun.count != 1 and not noun.of_known and not noun.attributes
        return 1 if counted and len(_candidates(noun, kinds, before, latest=False)) >= _PAIR else 0
    made = isinstance(look, Adjective) and look.text.lower() == "made" and len(chunks) > at + 4
    look = chunks[at + 4] if made else look
    told = isinstance(look, Adjective) and any(a in COLOURS or a in LOOKS for a in look.attributes)
    plain = noun.kind == "abstract" and told and is_link(be, "verbs", "be")
    return (5 if made else 3) if plain else 0


def _whole(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with one noun for "all three | seats" and "both storage | pieces"."""
    made: list[Chunk] = []
    for noun in chunks:
        first = made[-1] if made else None
        bare = isinstance(noun, Noun) and not noun.det and noun.count is None and _kinds(noun) is not None
        if bare and isinstance(noun, Noun) and isinstance(first, Noun) and first.end == noun.start and _counts(first):
            text = f"{first.text} {noun.text}"
            made[-1] = replace(noun, start=first.start, det=first.det, count=first.count, text=text)
        else:
            made.append(noun)
    return made


def _all_between(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with all three of "a stove between a fridge and a sink, all of them along one wall"."""
    made = list(chunks)
    for at in range(len(made) - _BETWEEN):
        one, link, two, joint, three, comma, every = made[at : at + _BETWEEN + 1]
        things = [c for c in (one, two, three) if isinstance(c, Noun) and c.kind == "thing" and not c.many]
        said = (
            is_link(link, "prepositions", "between")
            and is_link(joint, "joins", "and")
            and is_link(comma, "mark", "comma")
        )
        if not said or len(things) < len((one, two, three)) or not isinstance(every, Noun) or every.value != "all":
            continue
        among = tuple(noun.start for noun in things)
        made[at + _BETWEEN] = replace(every, kind="thing", det="the", count=None, plural=True, among=among)
    return made


def _counts(first: Noun) -> bool:
    """Whether it is "all three", or a room by whose name things are called that belong there."""
    return (first.kind == "pronoun" and first.value == "them" and bool(first.count)) or (
        first.kind == "room" and first.det in _POINTING[1:]
    )


def _with_looks(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the looks of "white furniture: a bed and a wardrobe" told of each that it lists."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        said, link = chunks[at], chunk_at(chunks, at + 1)
        looked = isinstance(said, Noun) and bool(said.attributes) and not said.det and said.count is None
        kinds = _kinds(said) if isinstance(said, Noun) and looked and _lists(link) else None
        end = _list_end(chunks, at + 2, kinds) if kinds is not None else 0
        if end and isinstance(said, Noun):
            made += [_looking(chunk, said) if isinstance(chunk, Noun) else chunk for chunk in chunks[at + 2 : end]]
            at = end
        else:
            made.append(said)
            at += 1
    return made


_LISTING = ("such as", "including", "like", "namely")


def _lists(link: Chunk | None) -> bool:
    """Whether what a word means is listed after it: "white furniture: a bed", "seating such as a sofa"."""
    said = is_link(link, "prepositions", "as", "with") and str(getattr(link, "text", "")).lower() in _LISTING
    return said or is_link(link, "mark", "colon")


def _list_end(chunks: Sequence[Chunk], start: int, kinds: Collective) -> int:
    """Where a list ends that names only what can be meant; 0 where it does not."""
    at = start
    while at < len(chunks):
        noun = chunks[at]
        if not isinstance(noun, Noun) or noun.kind != "thing" or noun.definite or not kinds.means(noun.value):
            return 0
        at += 1
        joint = at
        while at < len(chunks) and (is_link(chunks[at], "mark", "comma") or is_link(chunks[at], "joins", "and")):
            at += 1
        if at == joint:
            return at
    return 0


def _looking(noun: Noun, said: Noun) -> Noun:
    """A thing of the list with the looks that are told of all; a colour of its own stays its only one."""
    own = not COLOURS.keys().isdisjoint(noun.attributes)
    told = [a for a in said.attributes if not (own and a in COLOURS) and a not in noun.attributes]
    fates = noun.fates if said.end > noun.start else {**noun.fates, said.start: "requested"}
    return replace(noun, attributes=[*noun.attributes, *told], fates=fates)


def _kinds(noun: Noun) -> Collective | None:
    """What a noun can mean, where it is such a word."""
    words = [singular(word) for word in noun.text.lower().split()[-2:]]
    return collective(" ".join(words)) or collective(" ".join(words[-1:]))


def _meant_by(noun: Noun, before: Sequence[Chunk]) -> list[int]:
    """The tokens at which what a noun means was named; empty where it is no such word, or fits nothing before it."""
    if noun.kind not in ("thing", "abstract") or noun.det not in _POINTING or noun.of_known:
        return []
    kinds = _kinds(noun)
    if kinds is None or noun.attributes or noun.side or noun.ordinal or noun.degree:
        return []
    several = noun.det == "each" or noun.text.lower().endswith("s") or noun.word in _MASSES
    earlier = _sentences_before(before) if before and is_link(before[-1], "prepositions") else []
    return (_those(noun, kinds, earlier) or _those(noun, kinds, before)) if several else []


def _sentences_before(chunks: Sequence[Chunk]) -> Sequence[Chunk]:
    """The sentences before the one that has begun, whose own things stand to what the noun means."""
    stops = (at for at in range(len(chunks) - 1, -1, -1) if is_link(chunks[at], "mark", "stop"))
    return chunks[: next(stops, 0)]


def _those(noun: Noun, kinds: Collective, before: Sequence[Chunk]) -> list[int]:
    """Where the things were named that a word means: so many as it says, the latest first, or all that it can mean."""
    wanted = noun.count or (_PAIR if noun.det == "both" else 0)
    anything = not (kinds.groups or kinds.things or kinds.but)
    found = _candidates(noun, kinds, before, latest=anything and not wanted)
    small = [thing for thing in found if load_habits().is_in(thing.value, "small")] if anything else []
    if not wanted:
        found = small or found
        return [thing.start for thing in reversed(found)] if len(found) >= _PAIR else []
    latest = _candidates(noun, kinds, before, latest=True)
    for tried in (small, *(found[:end] for end in range(1, len(found) + 1))):
        if sum(map(_number, tried)) == wanted and len(tried) > 1:
            return [thing.start for thing in reversed(tried)]
    return [thing.start for thing in reversed(latest)] if len(latest) == wanted else []


def _candidates(noun: Noun, kinds: Collective, before: Sequence[Chunk], *, latest: bool) -> list[Noun]:
    """What was named that a word can mean, the last first; of the `latest` sentence that named any, or of all.

    Nothing where the word itself was what something was named by.
    """
    found: list[Noun] = []
    for thing in reversed(before):
        if is_link(thing, "mark", "stop") and found and latest:
            break
        if not isinstance(thing, Noun) or thing.kind != "thing" or thing.det == "no":
            continue
        if thing.word == noun.word and not (thing.among or kinds.names(thing.value)):
            return []
        if not (thing.among or thing.definite or thing.of_known) and kinds.means(thing.value):
            found.append(thing)
    return found


def _number(noun: Noun) -> int:
    return noun.count if noun.count is not None else _PAIR if noun.plural else 1
