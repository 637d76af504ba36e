"""Things that are told apart by whose they are, or by what they hold: "buckets of roses and tulips, one each"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.plurals import singular
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link


def with_assortments(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which each kind of several is a thing of its own, and "the chair of the teacher" the teacher's."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        kinds, length = _kinds(chunks, at)
        made += kinds or [chunks[at]]
        at += length or 1
        if isinstance(owner := made[-1], Noun) and owner.kind == "people" and len(made) > len(("chair", "of")):
            made[-3:] = _owned(made[-3], made[-2], owner)
    return made


def _owned(thing: Chunk, link: Chunk, owner: Noun) -> list[Chunk]:
    """Read "the chair of the teacher" as "the teacher's chair"."""
    told = isinstance(thing, Noun) and thing.kind == "thing" and thing.det == "the" and not thing.plural
    if not told or not isinstance(thing, Noun) or not is_link(link, "prepositions", "of") or owner.det != "the":
        return [thing, link, owner]
    return [replace(thing, end=owner.end, text=f"{owner.text}'s {thing.text.partition(' ')[2]}")]


def _kinds(chunks: Sequence[Chunk], at: int) -> tuple[list[Chunk], int]:
    """One thing for each kind of contents, and how many chunks tell of them; nothing where they are not so told."""
    several = chunks[at]
    if not isinstance(several, Noun) or several.kind != "thing" or several.det or several.count is not None:
        return [], 0
    head, _, first = several.text.partition(" of ")
    end = at + 1
    if not first and (parted := _next_kind(chunks, at + 1, of=True)) is not None:
        first, end = parted.text, chunks.index(parted, end) + 1
    contents = [first]
    while (noun := _next_kind(chunks, end)) is not None:
        contents.append(noun.text)
        end = chunks.index(noun, end) + 1
    number, end = _number_of_each(chunks, end)
    if not first or len(contents) < len(("roses", "tulips")) or not number:
        return [], 0
    name = singular(head.lower()) if number == 1 else head.lower()
    found: list[Chunk] = []
    for content in contents:
        text = f"{number} {name} of {content}"
        one = replace(several, text=text, count=number, plural=number > 1, called=f"{singular(name)} of {content}")
        comma = Connector("mark", "comma", several.end, several.end, ",")
        found += [comma, one] if found else [one]
    return found, end - at


def _next_kind(chunks: Sequence[Chunk], at: int, *, of: bool = False) -> Noun | None:
    """The next of a list of bare nouns, after its comma or "and"; the first one after an "of"."""
    start = at
    joins = [("prepositions", "of")] if of else [("mark", "comma"), ("joins", "and")]
    while at < len(chunks) and any(is_link(chunks[at], *join) for join in joins):
        at += 1
    noun = chunks[at] if start < at < len(chunks) else None
    bare = isinstance(noun, Noun) and noun.kind == "thing" and not noun.det and noun.count is None
    return noun if bare and isinstance(noun, Noun) else None


def _number_of_each(chunks: Sequence[Chunk], at: int) -> tuple[int, int]:
    """The two of ", two of each", and where what tells it ends; 0 where that does not come."""
    at += at < len(chunks) and is_link(chunks[at], "mark", "comma")
    number = chunk_at(chunks, at)
    at += 2 if at + 1 < len(chunks) and is_link(chunks[at + 1], "prepositions", "of") else 1
    each = chunk_at(chunks, at)
    if not isinstance(number, Noun) or number.kind not in ("number", "pronoun") or number.of_known:
        return 0, at
    told = isinstance(each, Noun) and each.kind == "pronoun" and each.value == "each" and bool(number.count)
    return (number.count or 0, at + 1) if told else (0, at)
