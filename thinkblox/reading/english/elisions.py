"""Nouns that are left out before one of the same: "a green and a black chair", "two small and one large vase"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.plurals import singular
from thinkblox.knowledge.vocabulary import name_of
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at

_ORDINALS = {"second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6, "last": -1}
_DETERMINED = ("a", "the", "another")
_CORNERS = 4
_PAST = 2
"""So many chunks further the noun is that a phrase borrows."""


def with_nouns(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, where what has only a number or an article and an adjective borrows the noun that comes."""
    whole = _with_named_ordinals(_with_ordinals(chunks))
    for at in range(len(whole) - _PAST - 1, -1, -1):
        said, link, other = whole[at : at + _PAST + 1]
        if not (isinstance(said, Noun) and _lacks_noun(said) and isinstance(other, Noun) and _lends(other)):
            continue
        joined = isinstance(link, Connector) and (link.value == "comma" or (link.sort, link.value) == ("joins", "and"))
        if joined and not _is_told_apart(whole[:at], other):
            whole[at] = _borrowed(said, other)
    return _with_sides([part for at, chunk in enumerate(whole) for part in _parted(whole, at) or [chunk]])


def _with_ordinals(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "the first bench and the second bench" for "the first and second bench"."""
    whole = list(chunks)
    for at in range(len(whole) - _PAST - 1, -1, -1):
        said, link, other = whole[at : at + _PAST + 1]
        first = isinstance(said, Noun) and said.kind == "number" and said.ordinal > 0 and said.det == "the"
        joined = isinstance(link, Connector) and (link.sort, link.value) == ("joins", "and")
        if not (first and joined and isinstance(said, Noun) and isinstance(other, Noun)) or other.kind != "thing":
            continue
        word, _, rest = other.text.lower().partition(" ")
        name = name_of(rest.split()) if word in _ORDINALS and not other.det else None
        if name is None:
            continue
        second = replace(
            other, value=name.category, called="", det="the", count=1, ordinal=_ORDINALS[word], plural=False, named=True
        )
        singled = singular(rest)
        whole[at] = replace(second, start=said.start, end=said.end, ordinal=said.ordinal, text=f"{said.text} {singled}")
        whole[at + _PAST] = replace(second, text=f"the {word} {singled}")
    return whole


def _with_named_ordinals(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the noun of "the first shelf" for "the second" and "the third" of the same sentence."""
    whole = list(chunks)
    first: Noun | None = None
    for at, chunk in enumerate(whole):
        if isinstance(chunk, Connector) and (chunk.sort, chunk.value) == ("mark", "stop"):
            first = None
        if not isinstance(chunk, Noun) or chunk.det != "the" or chunk.count not in (None, 1):
            continue
        if chunk.kind == "thing" and chunk.ordinal:
            first = chunk
        elif first is not None and _is_bare_ordinal(chunk) and not _is_link_of(whole[at - 1]):
            several = any(isinstance(c, Noun) and c.value == first.value and c.many for c in whole[:at])
            name = replace(first, start=chunk.start, end=chunk.end, text=f"{chunk.text} {first.word}")
            told = replace(name, ordinal=chunk.ordinal)
            whole[at] = told if several else replace(name, ordinal=0, det="another", text=f"another {first.word}")
    return whole


def _is_bare_ordinal(noun: Noun) -> bool:
    """Whether it is "the second", of which nothing else is told."""
    return noun.kind == "number" and noun.ordinal > 1 and not (noun.attributes or noun.of_known or noun.rows)


def _is_link_of(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and (chunk.sort, chunk.value) == ("prepositions", "of")


def _with_sides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, where "on one side ... on the other side" are the left and the right side."""
    whole, first = list(chunks), -1
    for at, chunk in enumerate(whole):
        if not isinstance(chunk, Noun) or not at or not _is_on(whole[at - 1]):
            continue
        before = whole[at - 2] if at > 1 else None
        if chunk.text.lower().startswith("one side") and chunk.kind in ("part", "place"):
            counted = isinstance(before, Noun) and before.kind in ("number", "pronoun")
            first = -1 if counted else at
        elif first >= 0 and chunk.kind == "part" and chunk.value == "side" and chunk.det == "other":
            one, alone = whole[first], not _is_of(whole, at)
            if isinstance(one, Noun) and one.kind == "place" and alone:
                whole[at] = replace(chunk, kind="pronoun", value="other", text="the other")
            elif isinstance(one, Noun) and one.kind == "part":
                whole[first] = replace(one, value="left", det="the", count=None)
                whole[at] = replace(chunk, value="right", det="the", count=None)
            first = -1
    return whole


def _is_on(chunk: Chunk) -> bool:
    return isinstance(chunk, Connector) and chunk.sort == "prepositions" and chunk.value in ("on", "at", "to")


def _is_of(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "of" comes after a noun."""
    after = chunk_at(chunks, at + 1)
    return isinstance(after, Connector) and after.value == "of"


def _parted(chunks: Sequence[Chunk], at: int) -> list[Chunk]:
    """What a phrase with "the other" is where that is a side, and a noun may follow: "on the other | two chairs"."""
    if (side := _other_side(chunks, at)) is not None:
        return [side]
    said, link = chunks[at], chunks[at - 1] if at else None
    if not isinstance(said, Noun) or said.kind != "thing" or said.det != "other" or not said.count or said.of_known:
        return []
    words = said.text.split()
    alone = replace(
        said, kind="pronoun", value="other", end=said.start + 2, text="the other", count=None, attributes=[], unshown=[]
    )
    side = _other_side([*chunks[:at], alone], at) if words[:2] == ["the", "other"] and _is_on(link or said) else None
    if side is None or any(isinstance(c, Noun) and c.value == said.value for c in chunks[:at]):
        return []
    return [side, replace(said, start=said.start + 2, det="", text=" ".join(words[2:]))]


def with_counts(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, where a number between commas counts the bare plural before it: "towels, at least ten, on a shelf".

    Nouns named "their own" are as many as what they are said of: "two printers on their own desks".
    """
    whole: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        around = [chunks[n] if 0 <= n < len(chunks) else None for n in (at - 1, at + 1)]
        whole.append(chunk)
        if isinstance(chunk, Noun) and (corners := _shared_out(chunk, whole[-_PAST - 3 : -1])):
            whole[-1] = replace(chunk, count=corners, plural=True)
        elif isinstance(chunk, Noun) and _is_their_own(chunk) and (own := _owned(chunk, whole[:-1])) is not None:
            whole[-1] = own
        elif isinstance(chunk, Noun) and all(isinstance(c, Connector) and c.value == "comma" for c in around):
            noun = whole[-3] if len(whole) > _PAST else None
            if isinstance(noun, Noun) and _is_uncounted(noun) and _is_bare_number(chunk):
                whole[-3:] = [
                    replace(noun, end=chunk.end, count=chunk.count, least=chunk.least, most=chunk.most, plural=True)
                ]
    return whole


def _is_uncounted(noun: Noun) -> bool:
    """Whether it names several without saying how many."""
    plural = noun.plural or noun.word != noun.text.rpartition(" ")[2].lower()
    return noun.kind == "thing" and plural and noun.count is None and not noun.det and not (noun.rows or noun.groups)


def _is_bare_number(said: Noun) -> bool:
    """Whether it is a number and nothing else."""
    plain = not (said.of_known or said.ordinal or said.side or said.rows or said.share or said.every or said.det)
    return said.kind == "number" and bool(said.count) and plain and not (said.attributes or said.unshown)


def _shared_out(place: Noun, before: Sequence[Chunk]) -> int:
    """In how many corners or on how many walls "two kilns, one in each corner" are; 0 where nothing is so said."""
    led = before[-_PAST - 2 :]
    if place.kind != "place" or place.value not in ("corner", "wall") or place.det != "each" or place.count:
        return 0
    if len(led) != _PAST + 2 or not isinstance(led[0], Noun) or not isinstance(led[2], Noun):
        return 0
    whole, one = led[0], led[2]
    told = whole.kind == "thing" and one.kind in ("pronoun", "number") and one.text.lower() == "one"
    return (whole.count or 0) if told and 1 < (whole.count or 0) < _CORNERS else 0


def _is_their_own(noun: Noun) -> bool:
    """Whether it is "their own desks"."""
    several = noun.kind == "thing" and noun.count is None and noun.plural
    return several and noun.text.lower().startswith("their own ")


def _owned(noun: Noun, before: Sequence[Chunk]) -> Noun | None:
    """The noun with the number of what has it."""
    for chunk in reversed(before):
        if isinstance(chunk, Connector) and chunk.value in ("stop", "semicolon"):
            return None
        if isinstance(chunk, Noun) and chunk.kind == "thing":
            return replace(noun, det="", count=chunk.count) if (chunk.count or 0) > 1 else None
    return None


def _other_side(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The side that "two on one side, one on the other" leaves out the second time."""
    other, link = chunks[at], chunks[at - 1] if at else None
    if not isinstance(other, Noun) or other.kind != "pronoun" or other.text.lower() != "the other":
        return None
    for before in range(at - 2, 0, -1):
        said, led = chunks[before], chunks[before - 1]
        if isinstance(said, Connector) and said.value == "stop":
            return None
        if isinstance(said, Noun) and said.kind == "part" and _are_one_link(led, link):
            side = replace(said, start=other.start, end=other.end, text=other.text, det="other", count=1, plural=False)
            return side if said.text.lower().startswith("one ") else None
    return None


def _are_one_link(one: Chunk, other: Chunk | None) -> bool:
    """Whether both are the same preposition."""
    if not isinstance(one, Connector) or not isinstance(other, Connector):
        return False
    return one.sort == other.sort == "prepositions" and one.value == other.value


def _lacks_noun(said: Noun) -> bool:
    """Whether it is "a green", or "two small" that are not of some that are known."""
    if said.kind == "thing":
        return bool(said.looks)
    plain = not (said.of_known or said.ordinal or said.side or said.rows or said.share or said.every)
    counted = said.kind == "number" and said.count is not None and plain and not said.least
    return counted and bool(said.attributes or said.unshown or said.states) and said.word not in ("one", "ones")


def _lends(other: Noun) -> bool:
    """Whether it is a thing of which a look is told as well."""
    told = other.attributes or other.unshown or other.states
    return other.kind == "thing" and bool(told) and (other.det in _DETERMINED or other.count is not None)


def _is_told_apart(before: Sequence[Chunk], other: Noun) -> bool:
    """Whether several of the kind were named in the same sentence, of which these are told: "chairs, one red ..."."""
    for chunk in reversed(before):
        if isinstance(chunk, Connector) and chunk.value == "stop":
            return False
        if isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.many and chunk.value == other.value:
            return True
    return False


def _borrowed(said: Noun, other: Noun) -> Noun:
    """The phrase with the noun of the other; what is told of the other is not told of it."""
    words = other.text.split()
    told = [*other.attributes, *other.unshown, *other.states]
    head = words[1 + len(told) :] or words[-1:]
    looks = said.looks or said.attributes
    head = head if (said.count or 1) > 1 else [*head[:-1], singular(head[-1])]
    text = f"{said.text} {' '.join(head)}"
    return replace(
        other,
        start=said.start,
        end=said.end,
        text=text,
        det=said.det,
        count=said.count,
        plural=(said.count or 1) > 1,
        attributes=[*looks],
        unshown=[*said.unshown],
        states=[*said.states],
        vague=said.vague,
        size=None,
        looks=[*looks, *said.unshown],
        fates={**said.fates},
    )
