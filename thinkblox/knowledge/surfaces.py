"""How rooms are finished: palettes, what each type of room is floored and walled with, and the words for it."""

import tomllib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import msgspec

from thinkblox.knowledge.rooms import room_type
from thinkblox.layings import Colour, Laying
from thinkblox.value import Value

Part = Literal["floor", "walls"]
Choice = Laying | Literal["none"]


class Palette(Value, frozen=True, kw_only=True):
    """Colours that go together, each as "#rrggbb"."""

    wall: str
    accent: str
    wood: str
    hard: str
    soft: str
    trim: str
    door: str
    curtain: str


class Dress(Value, frozen=True, kw_only=True, rename={"companion": "with"}):
    """What a laying is coloured like.

    Attributes:
        of: member of the palette; empty where it has colours of its own.
        companion: member of the palette for its second colour.
        blend: how far that colour is moved towards the first, as a share.
        colours, seconds: its own.
    """

    of: str = ""
    companion: str = ""
    blend: float = 0.0
    colours: tuple[str, ...] = ()
    seconds: tuple[str, ...] = ()


class UsualFinish(Value, frozen=True, kw_only=True):
    """What a type of room is finished with, or what a style changes of that: choices in turn; empty for no change."""

    floor: tuple[Laying, ...] = ()
    walls: tuple[Laying, ...] = ()
    accent: tuple[Choice, ...] = ()
    dado: tuple[Choice, ...] = ()
    curtains: bool = False
    palettes: tuple[str, ...] = ()


class Finishes(Value, frozen=True, kw_only=True):
    """All that is known of the finish of rooms."""

    palettes: dict[str, Palette]
    layings: dict[Laying, Dress]
    rooms: dict[str, UsualFinish]
    styles: dict[str, UsualFinish]
    finished_like: dict[str, tuple[str, ...]] = {}
    rough: dict[str, str] = {}

    def is_rough(self, room: str) -> bool:
        """Whether floor and walls of such a room are what its work needs, whatever its style."""
        rough = self.rough.get("rooms", "").split(", ")
        finished = [usual for usual, names in self.finished_like.items() if room in names]
        return any(name in rough for name in (room, *finished, room_type(room).like))

    def of(self, room: str) -> UsualFinish | None:
        """What a type of room is usually finished with: as such, or as what it is like; None for a type not known."""
        likened = {name: usual for usual, names in self.finished_like.items() for name in names}
        for name in (room, likened.get(room, ""), room_type(room).like):
            if name in self.rooms:
                return self.rooms[name]
        return None


@dataclass(frozen=True)
class SurfaceWords:
    """What single words say of a floor or of walls: a laying, a colour, a shade of a colour, or nothing to be drawn."""

    floor: dict[str, Laying]
    walls: dict[str, Laying]
    colours: dict[str, Colour]
    woods: frozenset[str]
    shades: dict[str, float]
    fillers: frozenset[str]

    def layings(self, part: Part) -> dict[str, Laying]:
        """The words for what a part is made of."""
        return self.floor if part == "floor" else self.walls


@lru_cache(maxsize=1)
def finishes() -> Finishes:
    """The tables of surfaces.toml."""
    return msgspec.convert(_table("surfaces.toml"), Finishes)


@lru_cache(maxsize=1)
def surface_words() -> SurfaceWords:
    """The tables of surface_words.toml."""
    table = _table("surface_words.toml")
    woods = frozenset(table["woods"])
    made: dict[str, dict[str, Laying]] = {}
    for part, wooden in (("floor", "planks"), ("walls", "panels")):
        words = {word: laying for laying, listed in table[part].items() for word in _split(listed)}
        made[part] = msgspec.convert(words | dict.fromkeys(woods, wooden), dict[str, Laying])
    colours = {name: colour_from(code) for name, code in (table["colours"] | table["woods"]).items()}
    shades = {word: float(share) for word, share in table["shades"].items()}
    fillers = frozenset(_split(table["fillers"]["words"]))
    return SurfaceWords(made["floor"], made["walls"], colours, woods, shades, fillers)


def colour_from(code: str) -> Colour:
    """The sRGB colour of "#rrggbb"."""
    red, green, blue = (round(int(code[at : at + 2], 16) / 255, 4) for at in (1, 3, 5))
    return (red, green, blue)


def blended(colour: Colour, other: Colour, share: float) -> Colour:
    """A colour moved towards another by a share."""
    red, green, blue = (round(a + (b - a) * share, 4) for a, b in zip(colour, other, strict=True))
    return (red, green, blue)


def shaded(colour: Colour, share: float) -> Colour:
    """A colour moved towards white, or towards black where the share is below 0."""
    end = 1.0 if share > 0 else 0.0
    return blended(colour, (end, end, end), abs(share))


def _split(words: str) -> list[str]:
    return [word.strip() for word in words.split(",")]


def _table(name: str) -> dict[str, Any]:
    return tomllib.loads(Path(__file__).with_name(name).read_text(encoding="utf-8"))
