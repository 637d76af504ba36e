"""What rooms of a type may hold besides what all of them do, and what they have one or another of."""

import tomllib
from collections.abc import Collection
from functools import lru_cache
from pathlib import Path

import msgspec

from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import Usual, read_usual, room_type, room_types
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.value import Value

Option = tuple[Usual, ...]
"""Things that come together, what they are for first."""


class RoomNeed(Value, frozen=True, kw_only=True):
    """What a type of room has in one form or another.

    Attributes:
        one_of: the forms, in the notation of `RoomChoices.may`.
        unless: categories, and groups of them after an "@", that will do as well, separated by commas.
        despite: categories that will not do, though they are like what will, separated by commas.
        given: categories without which it is not needed, separated by commas; empty where it always is.
        always: it is needed however much a prompt names.
    """

    one_of: tuple[str, ...]
    unless: str = ""
    despite: str = ""
    given: str = ""
    always: bool = False

    @property
    def options(self) -> tuple[Option, ...]:
        """The forms, read."""
        return tuple(_option(line) for line in self.one_of)

    def arises(self, categories: Collection[str]) -> bool:
        """Whether a room with these things needs it, if it is not there."""
        return not self.given or not set(self.given.split(", ")).isdisjoint(categories)

    def is_met_by(self, category: str) -> bool:
        """Whether a room with such a thing lacks nothing of it."""
        if category in self.despite.split(", "):
            return False
        names = [name for name in self.unless.split(", ") if name]
        groups = [name.removeprefix("@") for name in names if name.startswith("@")]
        others = [name for name in names if not name.startswith("@")]
        firsts = [option[0].category for option in self.options]
        alike = any(do_alike(category, name) for name in firsts)
        return alike or load_habits().is_in(category, *groups) or any(counts_as(category, name) for name in others)


class RoomChoices(Value, frozen=True, kw_only=True):
    """What a type of room has one or another of, and what it may hold besides: "<line> + <line>" of rooms.toml."""

    needs: tuple[RoomNeed, ...] = ()
    may: tuple[str, ...] = ()

    @property
    def options(self) -> tuple[Option, ...]:
        """What it may hold besides, read."""
        return tuple(_option(line) for line in self.may)


class Varieties(Value, frozen=True, kw_only=True):
    """All that is known of it.

    Attributes:
        sparse: words about rooms that are to hold little, separated by commas.
        filled: categories that come full of books, separated by commas.
        fewer: categories of which a room may have one less, separated by commas.
        alike: categories of which one stands for all, separated by commas.
        shows: categories that are of no use with nothing on them, separated by commas.
        rounded: categories that may be round where nobody says of which form they are, separated by commas.
        rooms: choices by type of room.
    """

    sparse: str
    filled: str
    fewer: str
    alike: tuple[str, ...]
    shows: str
    rounded: str
    rooms: dict[str, RoomChoices]

    def of(self, room: str) -> RoomChoices | None:
        """The choices of a type of room, or of the wider one that it is one of; None where there are none."""
        return self.rooms.get(room) or self.rooms.get(room_type(room).like)

    def stands_for(self, one: str, other: str) -> bool:
        """Whether who has one of two different things wants no other: a bathtub and a shower."""
        return one != other and any({one, other} <= {*listed.split(", ")} for listed in self.alike)


def do_alike(one: str, other: str) -> bool:
    """Whether one thing does for another: called alike, and usually in a like place; no kitchen table for a low one."""
    habits = load_habits()
    return are_alike(one, other) and (one == other or habits.of(one)[:1] == habits.of(other)[:1])


@lru_cache(maxsize=1)
def varieties() -> Varieties:
    """The table."""
    text = Path(__file__).with_name("variety.toml").read_text(encoding="utf-8")
    read = msgspec.convert(tomllib.loads(text), Varieties)
    if unknown := read.rooms.keys() - room_types().keys():
        raise InputError(f"variety: no type of room {min(unknown)!r}")
    return read


def _option(line: str) -> Option:
    return read_usual(tuple(line.split(" + ")))
