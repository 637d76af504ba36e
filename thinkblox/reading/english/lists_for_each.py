"""What each of several has, listed in brackets or after a comma: "eight desks (on each: a monitor and a lamp)"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_LYING = ("small", "screens", "lamps")
_MOST_TOLD = 80
"""Most chunks in brackets."""
_PAIR = 2


def with_lists_for_each(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with "with a monitor and a lamp on each" for such lists."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        several = made[-1] if made else None
        many = isinstance(several, Noun) and several.kind == "thing" and several.many
        close = _closed(chunks, at) if many else 0
        told = _told(chunks[at + 1 : close], several) if close and isinstance(several, Noun) else []
        if told:
            made += [chunks[at], _with(chunks[at]), *told]
            at = close
        elif many and is_link(chunks[at], "mark", "comma") and (end := _small_list(chunks, at + 1)):
            made += [_with(chunks[at]), *chunks[at + 1 : end]]
            at = end
        else:
            made.append(chunks[at])
            at += 1
    return made


def _closed(chunks: Sequence[Chunk], at: int) -> int:
    """Where brackets or dashes end that begin at a chunk; 0 where none begin or end."""
    mark = next((m for m in ("open", "dash") if is_link(chunks[at], "mark", m)), "")
    ends = {"open": "close", "dash": "dash"}.get(mark, "")
    within = range(at + 1, min(len(chunks), at + _MOST_TOLD))
    return next((n for n in within if is_link(chunks[n], "mark", ends)), 0) if ends else 0


def _with(before: Chunk) -> Connector:
    return Connector("prepositions", "with", before.end, before.end, "with")


def _told(said: Sequence[Chunk], several: Noun) -> list[Chunk]:
    """What brackets hold, each list before where it is; empty where they hold anything else."""
    parts: list[list[Chunk]] = [[]]
    for at, chunk in enumerate(said):
        begins = is_link(said[at + 1], "prepositions") and _is_each(said[at + 2]) if at + _PAIR < len(said) else False
        ends = is_link(chunk, "mark", "comma") and (begins or _is_done(parts[-1]))
        if ends or is_link(chunk, "mark", "semicolon"):
            parts.append([])
        else:
            parts[-1].append(chunk)
    lists = [_turned(part, several) for part in parts]
    if not all(lists):
        return []
    made = [*lists[0]]
    for part in lists[1:]:
        made += [Connector("joins", "and", part[0].start, part[0].start, "and"), *part]
    return made


def _is_done(part: Sequence[Chunk]) -> bool:
    """Whether a list ended with "on each"."""
    return len(part) > _PAIR and _is_each(part[-1]) and is_link(part[-2], "prepositions")


def _turned(part: list[Chunk], several: Noun) -> list[Chunk]:
    """A list with "on each" at its end, where that stands before it; empty where it is no such list."""
    each, start = (part[1], 2) if len(part) > _PAIR and is_link(part[0], "prepositions") else (None, 0)
    if each is not None and (_is_each(each) or _is_one_of(each, several)):
        start += is_link(part[start], "mark", "colon", "comma")
        link = part[0]
        if isinstance(link, Connector) and link.value == "per":
            link = replace(link, value="on" if load_habits().is_in(several.value, "surfaces") else "at")
        listed = part[start:]
        named = Noun("pronoun", "each", each.start, each.end, "each", det="each")
        return [*listed, link, named] if _is_list(listed) else []
    return part if _is_done(part) and _is_list(part[:-2]) else []


def _small_list(chunks: Sequence[Chunk], start: int) -> int:
    """Where "two monitors, a keyboard and a lamp on each" ends: things that lie there, the last after "and"."""
    end = next((n for n in range(start, len(chunks)) if is_link(chunks[n], "prepositions")), 0)
    listed = chunks[start:end]
    if not end or end + 1 >= len(chunks) or not _is_each(chunks[end + 1]) or not _is_list(listed):
        return 0
    things = [c for c in listed if isinstance(c, Noun)]
    lie = all(load_habits().is_in(thing.value, *_LYING) for thing in things)
    joined = len(listed) > _PAIR and is_link(listed[-2], "joins", "and")
    return end + 2 if lie and joined and len(things) > _PAIR and is_link(chunks[end], "prepositions", "on") else 0


def _is_list(chunks: Sequence[Chunk]) -> bool:
    """Whether things are listed and nothing else is said."""
    between = all(is_link(c, "mark", "comma") or is_link(c, "joins", "and") for c in chunks if not isinstance(c, Noun))
    things = [c for c in chunks if isinstance(c, Noun)]
    return between and bool(things) and all(c.kind == "thing" and not c.definite for c in things)


def _is_each(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) and chunk.kind == "pronoun" and chunk.value == "each"


def _is_one_of(chunk: Chunk, several: Noun) -> bool:
    """Whether one of them is named once more: "per table", "on each table"."""
    return isinstance(chunk, Noun) and chunk.value == several.value and (chunk.each or not chunk.det)
