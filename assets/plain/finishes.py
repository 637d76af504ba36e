"""The finishes that the table of plain things speaks of, by one word: "steel", "bread", "red", "red.metal"."""

from collections.abc import Mapping
from functools import lru_cache
from typing import get_args

from thinkblox.assets import palette
from thinkblox.assets.part import Finish
from thinkblox.errors import InputError
from thinkblox.scene.asset import Material
from thinkblox.value import Vec3

_MATERIALS: tuple[str, ...] = get_args(Material)
_NAMED: Mapping[str, Finish] = {
    "oak": palette.OAK,
    "walnut": palette.WALNUT,
    "pine": palette.PINE,
    "beech": palette.BEECH,
    "bamboo": palette.BAMBOO,
    "cork": Finish((0.72, 0.54, 0.36), "wood"),
    "wicker": palette.WICKER,
    "straw": Finish((0.86, 0.74, 0.46), "fabric"),
    "steel": palette.STEEL,
    "chrome": palette.CHROME,
    "iron": palette.IRON,
    "brass": palette.BRASS,
    "gold": Finish((0.80, 0.64, 0.30), "metal"),
    "copper": palette.METALS["copper"],
    "mirror": palette.MIRROR,
    "clear": palette.GLASS,
    "water": palette.WATER,
    "amber": palette.AMBER_GLASS,
    "porcelain": palette.PORCELAIN,
    "clay": palette.CLAY,
    "stone": palette.CONCRETE,
    "marble": palette.MARBLE,
    "slate": palette.SLATE,
    "soil": palette.SOIL,
    "sand": Finish((0.84, 0.75, 0.58), "stone"),
    "paper": palette.PAPER,
    "kraft": palette.KRAFT,
    "linen": palette.LINEN,
    "felt": palette.FELT,
    "leather": palette.COGNAC,
    "leaf": palette.LEAVES[1],
    "glow": palette.GLOW,
    "screen": palette.SCREEN,
    "dark": palette.DARK_PLASTIC,
    "black": palette.BLACK_PLASTIC,
    "lime": Finish((0.66, 0.75, 0.38), "plastic"),
    "peach": Finish((0.93, 0.66, 0.45), "plastic"),
    "pear": Finish((0.78, 0.78, 0.40), "plastic"),
    "egg": Finish((0.93, 0.82, 0.70), "ceramic"),
    "bread": Finish((0.80, 0.58, 0.33), "fabric"),
    "choc": Finish((0.33, 0.20, 0.13), "fabric"),
    "cheese": Finish((0.94, 0.78, 0.38), "plastic"),
    "meat": Finish((0.62, 0.26, 0.22), "fabric"),
    "sauce": Finish((0.78, 0.30, 0.18), "fabric"),
    "rubber": Finish((0.12, 0.12, 0.12), "fabric"),
}


@lru_cache(maxsize=512)
def finish_called(word: str) -> Finish:
    """The finish that a word of the table means: a named one, or a colour, plastic unless ".metal" or the like follows.

    Raises:
        InputError: no such finish, colour or material.
    """
    colour, dot, material = word.partition(".")
    if material and material not in _MATERIALS:
        raise InputError(f"finish {word!r}: no material {material!r}; there are {', '.join(_MATERIALS)}")
    if colour not in _NAMED and colour not in palette.COLOURS:
        known = ", ".join(sorted([*_NAMED, *palette.COLOURS]))
        raise InputError(f"finish {word!r}: no colour or finish {colour!r}; there are {known}")
    base = _NAMED[colour] if colour in _NAMED else Finish(_colour(colour), "plastic")
    return Finish(base.colour, _material(material)) if dot else base


def _colour(name: str) -> Vec3:
    return palette.COLOURS[name]


def _material(name: str) -> Material:
    return next(material for material in get_args(Material) if material == name)
