"""Moods, occasions and people: what everybody expects where a prompt names them, though it names no thing."""

import re
import tomllib
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import msgspec

from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import Usual, kinds_of_room, read_usual, room_types
from thinkblox.value import Value

_SPOTS = ("place", "somewhere", "corner", "area", "spot", "nook", "space", "room", "zone")
"""Where something is done: "a place to eat"."""
_ONLY_PLURAL = ("blues",)
"""Words that mean something else without the ending of a plural."""


class Theme(Value, frozen=True, kw_only=True):
    """What goes with some words.

    Attributes:
        words: phrases that tell it, separated by commas; plurals need not be listed.
        things: what is expected: "<count> <category> : <relation> <anchor> [each], ..."; without a relation it stands
            where such a thing usually does.
        by_room: the same for a type of room, or for a wider one that it is one of, instead.
        without: categories that nobody expects there any more, separated by commas.
        room: the type of room where none is named; empty for any. One that a part of a room is by itself.
        refines: types of room, and which they turn out to be.
        done: what is done in a part of the room, "eat/eating, dine/dining": "a place to eat" and "an area for dining"
            tell it too.
        unless: for a part of the room, what makes one of it: categories, or groups of them after an "@". Such a part
            is wanted in full, however much else is named, where nothing of that is there.
    """

    words: str
    things: tuple[str, ...] = ()
    by_room: dict[str, tuple[str, ...]] = {}
    without: str = ""
    room: str = ""
    refines: dict[str, str] = {}
    done: str = ""
    unless: str = ""

    @property
    def phrases(self) -> tuple[str, ...]:
        """Everything that tells it."""
        pairs = [act.partition("/") for act in filter(None, self.done.split(", "))]
        said = [
            f"{where} {how}" for act, _, doing in pairs for where in _SPOTS for how in (f"to {act}", f"for {doing}")
        ]
        return (*self.words.split(", "), *said)

    def is_served_by(self, category: str) -> bool:
        """Whether a thing makes the part of the room that it tells."""
        makers = self.unless.split(", ")
        return category in makers or load_habits().is_in(category, *(m[1:] for m in makers if m.startswith("@")))

    def expected(self, room: str) -> tuple[Usual, ...]:
        """What is expected in a type of room."""
        kinds = (room, *(kinds_of_room(room) - {room}))
        return read_usual(next((self.by_room[kind] for kind in kinds if kind in self.by_room), self.things))

    @property
    def unlikely(self) -> frozenset[str]:
        """The categories that nobody expects there."""
        return frozenset(filter(None, self.without.split(", ")))


class Found(NamedTuple):
    """A theme, and the words that told it, from the `start`-th to before the `end`-th."""

    theme: Theme
    start: int
    end: int


def themes_in(words: Sequence[str]) -> list[Found]:
    """The themes that a text tells, the longest phrase first where several begin with a word; each word tells one."""
    plain = [_plain(word) for word in words]
    phrases, first, longest = _phrases()
    found: list[Found] = []
    at = 0
    while at < len(plain):
        ends = range(min(len(plain), at + longest), at, -1) if plain[at] in first else ()
        hit = next((Found(phrases[key], at, end) for end in ends if (key := tuple(plain[at:end])) in phrases), None)
        found += [hit] if hit else []
        at = hit.end if hit else at + 1
    return found


def themes() -> dict[str, Theme]:
    """Every theme that we know, by name."""
    return _themes()


@lru_cache(maxsize=1)
def _themes() -> dict[str, Theme]:
    text = Path(__file__).with_name("themes.toml").read_text(encoding="utf-8")
    read = msgspec.convert(tomllib.loads(text), dict[str, Theme])
    for name, theme in read.items():
        rooms = {*theme.by_room, *theme.refines, *theme.refines.values(), *filter(None, (theme.room,))}
        if unknown := rooms - room_types().keys():
            raise InputError(f"theme {name!r}: no type of room {min(unknown)!r}")
    return read


@lru_cache(maxsize=1)
def _phrases() -> tuple[dict[tuple[str, ...], Theme], frozenset[str], int]:
    """The theme of every phrase, the first words of these, and how many words the longest has."""
    phrases = {tuple(map(_plain, phrase.split())): theme for theme in _themes().values() for phrase in theme.phrases}
    return phrases, frozenset(phrase[0] for phrase in phrases), max(map(len, phrases))


@lru_cache(maxsize=4096)
def _plain(word: str) -> str:
    """A word without case, marks, an ending "'s" or that of a plural."""
    bare = re.sub(r"['\u2019]s?$", "", word.lower()).replace("'", "")
    plural = len(bare) > 3 and not bare.endswith("ss") and bare not in _ONLY_PLURAL
    return bare.removesuffix("s") if plural else bare
