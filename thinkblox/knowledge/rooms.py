"""Types of rooms: how large they are, what they usually hold, and what people do there."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from thinkblox.assets import CATALOGUE, revision
from thinkblox.errors import InputError
from thinkblox.value import Value

MIN_SIDE, MAX_SIDE = 0.8, 50.0
"""Sides of a room that can be asked for [m]."""
Positive = Annotated[float, Meta(gt=0.0)]


@dataclass(frozen=True, slots=True)
class Usual:
    """One thing that a type of room usually holds; relations are a kind, an anchor, and whether it holds for each."""

    count: int
    category: str
    relations: tuple[tuple[str, str, bool], ...]


class Panes(Value, frozen=True, kw_only=True):
    """The windows of a type of room.

    Attributes:
        width, sill: of each [m].
        top: how far it ends below the ceiling [m].
        count: how many there are where the prompt does not say; None for as many as houses have.
    """

    width: Positive
    sill: Positive
    top: Positive = 0.4
    count: Annotated[int, Meta(ge=1, le=12)] | None = None


class Entrance(Value, frozen=True, kw_only=True):
    """What a type of room is entered by, where that is wider than a door of a house; it opens outwards.

    Attributes:
        width, height: of it [m].
    """

    width: Positive
    height: Positive


class RoomType(Value, frozen=True, kw_only=True):
    """A typical room.

    Attributes:
        area: of its floor [m2].
        height: [m].
        contents: what it usually holds, what it is for first: "<count> <category> : <relation> <anchor> [each], ...".
        essentials: what everybody expects there, also where the prompt names other things; in the same form.
        besides: what everybody expects there, too, though it is not what the room is for; in the same form.
        instead: what takes less floor and does as well where a thing of the contents finds none.
        seats_at: the table that people sit around there; empty where they do not meet around one.
        place: what each of its people has one of; empty where nobody has a place of their own.
        sleeps: people sleep in it.
        narrow_beds: those who sleep there have single beds.
        public: people eat, meet or read together: a large table suits it.
        like: a wider type that it is one of; words mean in it what they mean there.
        windowless: it has no window unless the prompt asks for one.
        panes: its windows, where they are unlike those of houses.
        entered_at_end: its door is in the middle of a short wall.
        entrance: its door, where that is no door for people: the gate of a garage.
        run: how what is built in one line along a wall stands, where the type is called by it: round a corner,
            along three sides, or along two walls across from each other.
        across: the least and the greatest length of its shorter side, where the type is called by that [m].
        shapes: the type that is meant by a shape, where that is not said of the floor: an L-shaped kitchen.
    """

    area: Positive
    height: Positive = 2.6
    contents: tuple[str, ...]
    essentials: tuple[str, ...] = ()
    besides: tuple[str, ...] = ()
    instead: dict[str, str] = {}
    seats_at: str = ""
    place: str = ""
    sleeps: bool = False
    narrow_beds: bool = False
    public: bool = False
    like: str = ""
    windowless: bool = False
    panes: Panes | None = None
    entered_at_end: bool = False
    entrance: Entrance | None = None
    run: Literal["", "corner", "sides", "facing"] = ""
    across: tuple[Positive, Positive] | None = None
    shapes: dict[str, str] = {}

    @property
    def usual(self) -> tuple[Usual, ...]:
        """Its contents, read."""
        return read_usual(self.contents)

    @property
    def expected(self) -> tuple[Usual, ...]:
        """Its essentials and what is there besides, read."""
        return read_usual((*self.essentials, *self.besides))

    @property
    def core(self) -> frozenset[str]:
        """The categories of its essentials: what it is for."""
        return frozenset(usual.category for usual in read_usual(self.essentials))


UNKNOWN_ROOM = "room"
"""The type to take when nothing is said."""


def room_types() -> dict[str, RoomType]:
    """Every type of room we know, by name, with what the categories say of their usual rooms."""
    return _room_types(revision())


def room_type(name: str) -> RoomType:
    """A type of room; the one to take when nothing is said, where the name is empty or not known."""
    return room_types().get(name, room_types()[UNKNOWN_ROOM])


def kinds_of_room(name: str) -> frozenset[str]:
    """The type called `name` and the wider one that it is one of."""
    return frozenset(filter(None, (name, room_type(name).like if name else "")))


@lru_cache(maxsize=1)
def _room_types(revision: int) -> dict[str, RoomType]:
    text = Path(__file__).with_name("rooms.toml").read_text(encoding="utf-8")
    types = msgspec.convert(tomllib.loads(text), dict[str, RoomType])
    _check_rooms(types)
    _check_likes(types)
    added = _added()
    return {
        name: msgspec.structs.replace(kind, contents=(*kind.contents, *added[name])) if name in added else kind
        for name, kind in types.items()
    }


def _check_rooms(types: Mapping[str, RoomType]) -> None:
    for name, category in CATALOGUE.items():
        if unknown := category.rooms.keys() - types.keys():
            raise InputError(
                f"category {name!r}: no type of room {min(unknown)!r}; there are {', '.join(sorted(types))}"
            )


def _check_likes(types: Mapping[str, RoomType]) -> None:
    for name, kind in types.items():
        if kind.like and kind.like not in types:
            raise InputError(f"room {name!r}: it is like {kind.like!r}, which is no type of room")


def _added() -> dict[str, list[str]]:
    """For each room, lines for what names it as one of its rooms: "2 : on desk" becomes "2 lamp : on desk"."""
    lines: dict[str, list[str]] = {}
    for name, category in CATALOGUE.items():
        for room, said in category.rooms.items():
            count, _, how = said.rpartition(":")
            lines.setdefault(room, []).append(f"{count.strip() or 1} {name} : {how.strip()}")
    return lines


@lru_cache(maxsize=256)
def read_usual(contents: tuple[str, ...]) -> tuple[Usual, ...]:
    """Read lines such as "2 table_lamp : on nightstand each"."""
    return tuple(_usual(line) for line in contents)


def _usual(line: str) -> Usual:
    what, _, how = line.partition(" : ")
    count, _, category = what.rpartition(" ")
    relations = []
    for relation in filter(None, how.split(", ")):
        kind, anchor, *each = [*relation.split(), ""]
        relations.append((kind, anchor, "each" in each))
    return Usual(int(count or 1), category, tuple(relations))
