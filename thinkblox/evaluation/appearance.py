"""Of what colours and materials an object is seen to be, by the share of its surface."""

from collections.abc import Callable
from typing import NamedTuple

from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.colours import in_box, looks, looks_table
from thinkblox.evaluation.room_file import ShapeRecord, Vec3

MAIN = 0.3
"""The share of the surface that makes a colour one of the object's main ones."""
MATERIAL = 0.2
"""The share of the surface that has to be of a material, unless the table says less."""

_DISPLAY = "screen"
"""The material of what shows pictures."""


class ColourPatch(NamedTuple):
    """A part of the surface."""

    area: float
    colour: Vec3
    material: str


def patches(body: Body) -> tuple[ColourPatch, ...]:
    """The surface of an object in one-coloured parts; a mesh that is seen instead of a part lends it its colour."""
    found: list[ColourPatch] = []
    for link in body.asset.links:
        seen = [mesh.look.base_colour for mesh in link.visuals if mesh.look.texture is None]
        for number, shape in enumerate(link.shapes):
            colour = seen[number % len(seen)] if seen else shape.colour
            found.append(ColourPatch(_area(shape), colour, shape.material))
    return tuple(found)


def has_colour(body: Body, word: str) -> tuple[bool, float]:
    """Whether a colour is one of the object's main ones, and its share of the surface.

    A display has the colour of its casing: a white monitor is not black for being switched off.
    """
    cased = any(patch.material != _DISPLAY for patch in patches(body))
    share = _share(body, lambda patch: looks(word, patch.colour), without=_DISPLAY if cased else "")
    return share >= MAIN, share


def is_material_word(word: str) -> bool:
    """Whether it says a material, such as "oak" or "leather"."""
    return _material(word) in looks_table()["materials"]


def has_material(body: Body, word: str) -> tuple[bool, float]:
    """Whether enough of an object is of a material, and its share of the surface; raises KeyError for no such word."""
    entry = looks_table()["materials"][_material(word)]
    share = _share(body, lambda patch: patch.material in entry["of"] and in_box(entry, patch.colour))
    return share >= entry.get("least", MATERIAL), share


def _material(word: str) -> str:
    word = word.lower().replace("-", " ")
    name: str = looks_table()["material_names"].get(word, word)
    return name


def _share(body: Body, chosen: Callable[[ColourPatch], bool], without: str = "") -> float:
    parts = [patch for patch in patches(body) if patch.material != without]
    whole = sum(patch.area for patch in parts)
    return sum(patch.area for patch in parts if chosen(patch)) / whole if whole > 0 else 0.0


def _area(shape: ShapeRecord) -> float:
    """Surface of the box round a shape [m2]: all parts are compared by the same measure."""
    x, y, z = shape.size
    return 2 * (x * y + y * z + z * x)
