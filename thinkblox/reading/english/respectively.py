"""Things told of one by one: "a lamp and a vase on the desk and the bed respectively" is a lamp on the desk, ..."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.plurals import singular
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray
from thinkblox.reading.english.places import WALLS
from thinkblox.reading.english.said import is_link

_WORDS = ("respectively", "in that order")
_MIDDLE = ("verbs", "participles", "prepositions", "fillers")
"""What stands between the things and what is told of each."""
_SIDES = ("left", "right")

_Item = list[Chunk]


def with_respective(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what is told of several respectively is told of each; where it does not fit they are as said."""
    made = list(chunks)
    for at in range(len(made) - 1, -1, -1):
        word = made[at]
        if isinstance(word, Stray) and word.text.lower() in _WORDS and (told := _told_of_each(made[:at], word)):
            made[: at + 1] = told
    return made


def _told_of_each(before: list[Chunk], word: Stray) -> list[Chunk]:
    """What comes before the word, one by one; empty where there are not as many things as are told of."""
    end = len(before) - int(bool(before) and is_link(before[-1], "mark", "comma"))
    start, told = _list_before(before, end)
    middle = start
    while middle and isinstance(link := before[middle - 1], Connector) and link.sort in _MIDDLE:
        middle -= 1
    first, named = _list_before(before, middle)
    told = [part for item in told for part in _apart(item)]
    named = [part for item in named for part in _apart(item)]
    if len(told) < 2 or len(told) != len(named) or middle == start:
        return []
    between = before[middle:start]
    clause = any(is_link(link, "verbs") for link in between)
    found = before[:first]
    for at, (one, what) in enumerate(zip(named, told, strict=True)):
        if at:
            found.append(_joint(word.start, clause=clause))
        own = isinstance(what[0], Connector)
        found += [*one, *(c for c in between if not (own and is_link(c, "prepositions"))), *what]
    return found


def _joint(at: int, *, clause: bool) -> Connector:
    return Connector("mark", "semicolon", at, at, ";") if clause else Connector("joins", "and", at, at, "and")


def _list_before(chunks: Sequence[Chunk], end: int) -> tuple[int, list[_Item]]:
    """Where the list that ends before `end` begins, and its items, each with the preposition that it has of its own."""
    items: list[_Item] = []
    at = end
    while at and isinstance(item := chunks[at - 1], (Noun, Adjective)):
        start = at - 1
        joined = start >= 2 and is_link(chunks[start - 1], "prepositions") and _is_joint(chunks[start - 2])
        items.insert(0, [chunks[start - 1], item] if joined else [item])
        at = start - int(joined)
        side = chunks[at - 1] if at else None
        if not items[1:] and is_link(side, "participles") and str(getattr(side, "text", "")).lower() in _SIDES:
            items[0] = [_of_side(item, str(getattr(side, "text", "")).lower())]
            at -= 1
        if not at or not _is_joint(chunks[at - 1]):
            return at, _named_alike(items)
        at -= 2 if at > 1 and is_link(chunks[at - 2], "mark", "comma") else 1
    return at, _named_alike(items)


def _is_joint(chunk: Chunk) -> bool:
    return is_link(chunk, "joins", "and") or is_link(chunk, "mark", "comma")


def _of_side(item: Chunk, side: str) -> Chunk:
    """The left one of several that a noun names."""
    if not isinstance(item, Noun):
        return item
    return replace(item, det="the", side=side, plural=False, text=f"the {side} {singular(item.word)}")


def _named_alike(items: list[_Item]) -> list[_Item]:
    """The items with the noun of the last where it is left out: "the north and the east wall"."""
    last = items[-1][-1] if items else None
    return [[*item[:-1], _with_noun(item[-1], last)] for item in items] if isinstance(last, Noun) else items


def _with_noun(item: Chunk, last: Noun) -> Chunk:
    if not isinstance(item, Noun) or item is last or item.kind not in ("part", "abstract"):
        return item
    if last.kind == "place" and last.value.endswith("wall") and item.value in WALLS:
        return replace(last, value=WALLS[item.value], start=item.start, end=item.end, text=f"the {item.value} wall")
    if last.kind == "thing" and last.side and item.value in _SIDES:
        side = _of_side(last, item.value)
        return replace(side, start=item.start, end=item.end) if isinstance(side, Noun) else item
    return item


def _apart(item: _Item) -> list[_Item]:
    """The two walls of "the north and south walls" as one item each."""
    noun = item[-1]
    walls = noun.value.split() if isinstance(noun, Noun) and noun.kind == "place" else []
    if not isinstance(noun, Noun) or len(walls) < 2 or noun.value.startswith("corner"):
        return [item]
    words = {value: word for word, value in WALLS.items()}
    return [
        [*item[:-1], replace(noun, value=w, plural=False, called=f"{words[w]} wall", text=f"the {words[w]} wall")]
        for w in walls
    ]
