"""What a lived-in room holds besides its furniture, by type of room and by what carries it."""

import tomllib
from functools import lru_cache
from pathlib import Path
from typing import Any

import msgspec

from thinkblox.errors import InputError
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, Usual, kinds_of_room, read_usual, room_types
from thinkblox.value import Value


class Tops(Value, frozen=True, kw_only=True):
    """What is put on some things.

    Attributes:
        on: the categories that carry it, separated by commas.
        rooms: the types of room where it is so, or wider ones, separated by commas; empty for all.
        most: how many things lie on one of them at most; 0 for as many as have room.
        things: up to how many of what: "<count> <category>".
    """

    on: str
    rooms: str = ""
    most: int = 0
    things: tuple[str, ...]

    def fits(self, category: str, kinds: frozenset[str]) -> bool:
        """Whether it is put on such a thing in a room of these types."""
        return category in self.on.split(", ") and (not self.rooms or not kinds.isdisjoint(self.rooms.split(", ")))


class Dressing(Value, frozen=True, kw_only=True):
    """All that is known of it.

    Attributes:
        varied: categories that come in several colours, separated by commas.
        colours: these, separated by commas.
        spare: what is put up besides where a room has too little to put things on, in the same notation.
        kits: what comes first onto a top with a thing that is on it and of no use without it, separated by commas.
        rooms: what else stands and hangs in a type of room, in the notation of `RoomType.contents`.
        tops: what is put on what, the first that fits.
    """

    varied: str
    colours: str
    spare: tuple[str, ...]
    kits: dict[str, str]
    rooms: dict[str, tuple[str, ...]]
    tops: tuple[Tops, ...]

    def furniture(self, room: str) -> tuple[Usual, ...]:
        """What else stands and hangs in a type of room."""
        kinds = (room, *sorted(kinds_of_room(room) - {room}), UNKNOWN_ROOM)
        return read_usual(next(self.rooms[kind] for kind in kinds if kind in self.rooms))

    def on(self, category: str, room: str) -> tuple[Usual, ...]:
        """What is put on a thing in a type of room; nothing on most things."""
        tops = self._tops(category, room)
        return read_usual(tops.things) if tops is not None else ()

    def most_on(self, category: str, room: str) -> int:
        """How many things lie on one such thing at most in a type of room; 0 for as many as have room."""
        tops = self._tops(category, room)
        return tops.most if tops is not None else 0

    def _tops(self, category: str, room: str) -> Tops | None:
        """The first entry that fits the very type of room, or else a wider one."""
        own = (tops for tops in self.tops if tops.rooms and tops.fits(category, frozenset((room,))))
        kinds = kinds_of_room(room)
        return next(own, None) or next((tops for tops in self.tops if tops.fits(category, kinds)), None)


@lru_cache(maxsize=1)
def dressing() -> Dressing:
    """The table."""
    text = Path(__file__).with_name("dressing.toml").read_text(encoding="utf-8")
    read = msgspec.convert(_without_groups(tomllib.loads(text)), Dressing)
    named = {room for tops in read.tops for room in tops.rooms.split(", ") if room} | read.rooms.keys()
    if unknown := named - room_types().keys():
        raise InputError(f"dressing: no type of room {min(unknown)!r}")
    return read


def _without_groups(table: dict[str, Any]) -> dict[str, Any]:
    """A table with every group of rooms in it spelled out."""
    groups = table.pop("groups")

    def spelled(names: str) -> str:
        return ", ".join(groups.get(name, name) for name in names.split(", "))

    for tops in table["tops"]:
        tops["rooms"] = spelled(tops.get("rooms", ""))
    own = {name: things for name, things in table["rooms"].items() if name not in groups}
    alike = {room: things for name, things in table["rooms"].items() for room in spelled(name).split(", ")}
    return table | {"rooms": alike | own}
