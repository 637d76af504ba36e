"""What place settings are made up of: "six place settings, each with a plate and a fork" are six of each."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.said import is_link

_SETTING = "place_setting"


def with_place_settings(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which so many of each thing stand for so many place settings of which is told what they have."""
    made = list(chunks)
    for at in range(len(made) - 1, -1, -1):
        setting = made[at]
        if not isinstance(setting, Noun) or setting.value != _SETTING:
            continue
        after = made[at + 1 :]
        people = after[1] if is_link(after[0] if after else None, "prepositions", "for") else None
        if not setting.count and isinstance(people, Noun) and people.count:
            setting, after = replace(setting, count=people.count), after[2:]
        if setting.count:
            made[at:] = _told(setting, after) or made[at:]
    return made


def _told(setting: Noun, after: list[Chunk]) -> list[Chunk]:
    """What each setting has, so often as there are settings, and what comes then; nothing where that is not told."""
    place = after[:2] if is_link(after[0] if after else None, "prepositions", "on", "at") else []
    start = len(place) + _having(after[len(place) :])
    listed = _list(after[start:])
    if start == len(place) or not listed or (place and not isinstance(place[-1], Noun)):
        return []
    end = start + len(listed)
    end += any(isinstance(chunk, Noun) and chunk.value == "each" for chunk in after[end : end + 1])
    times = setting.count or 1
    things = [
        replace(c, count=times * (c.count or 1), plural=True, det="") if isinstance(c, Noun) else c for c in listed
    ]
    first = things[0]
    assert isinstance(first, Noun)
    return [replace(first, start=setting.start), *things[1:], *place, *after[end:]]


def _having(after: Sequence[Chunk]) -> int:
    """How many chunks lead to what each of several has: "with", ", each with", ":"; 0 where nothing does."""
    said = [*after[:4], None, None]
    comma = int(is_link(said[0], "mark", "comma", "colon", "dash", "open"))
    pronoun = said[comma]
    each = int(isinstance(pronoun, Noun) and pronoun.value == "each")
    led = is_link(said[comma + each], "prepositions", "with", "of") or is_link(said[comma + each], "verbs", "have")
    led |= is_link(said[comma + each], "inverses", "with")
    return comma + each + 1 if led else int(is_link(said[0], "mark", "colon") and not each)


def _list(after: Sequence[Chunk]) -> list[Chunk]:
    """The things that are listed first; empty where none is."""
    found: list[Chunk] = []
    for chunk in after:
        counted = isinstance(chunk, Noun) and chunk.kind == "thing" and (chunk.det == "a" or chunk.count is not None)
        if not counted and not (found and (is_link(chunk, "mark", "comma") or is_link(chunk, "joins", "and"))):
            break
        found.append(chunk)
    while found and isinstance(found[-1], Connector):
        found.pop()
    return found
