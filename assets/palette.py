"""Colours of real furniture, and styles that belong together: one seed gives one style to every category."""

import tomllib
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from importlib.resources import files

from thinkblox.assets.part import Finish
from thinkblox.value import Vec3


def wood(colour: Vec3) -> Finish:
    """Return wood, or painted wood, of a colour."""
    return Finish(colour, "wood")


OAK = wood((0.76, 0.60, 0.42))
WALNUT = wood((0.43, 0.29, 0.20))
BEECH = wood((0.85, 0.71, 0.54))
ASH = wood((0.80, 0.70, 0.56))
TEAK = wood((0.56, 0.40, 0.28))
EBONY = wood((0.16, 0.13, 0.12))
BUTCHER_BLOCK = wood((0.72, 0.60, 0.44))
PINE = wood((0.87, 0.74, 0.54))
WHITE_PAINT = wood((0.93, 0.92, 0.89))
CREAM_PAINT = wood((0.91, 0.87, 0.79))
SAGE_PAINT = wood((0.62, 0.67, 0.57))
CHARCOAL_PAINT = wood((0.22, 0.23, 0.25))

LINEN = Finish((0.84, 0.79, 0.71), "fabric")
WHITE_COTTON = Finish((0.94, 0.93, 0.91), "fabric")
STONE_WOOL = Finish((0.66, 0.64, 0.61), "fabric")
GREY_WOOL = Finish((0.47, 0.49, 0.51), "fabric")
CHARCOAL_WOOL = Finish((0.25, 0.26, 0.28), "fabric")
SAGE_WOOL = Finish((0.55, 0.61, 0.50), "fabric")
TERRACOTTA_WOOL = Finish((0.64, 0.41, 0.32), "fabric")
MUSTARD_WOOL = Finish((0.73, 0.57, 0.29), "fabric")
NAVY_WOOL = Finish((0.20, 0.27, 0.38), "fabric")
DUSTY_BLUE_WOOL = Finish((0.51, 0.60, 0.68), "fabric")
BLUSH_WOOL = Finish((0.78, 0.65, 0.60), "fabric")
OLIVE_WOOL = Finish((0.42, 0.43, 0.28), "fabric")
COGNAC = Finish((0.58, 0.34, 0.19), "leather")

BRASS = Finish((0.74, 0.61, 0.40), "metal")
STEEL = Finish((0.74, 0.75, 0.77), "metal")
CHROME = Finish((0.85, 0.86, 0.88), "metal")
IRON = Finish((0.13, 0.13, 0.14), "metal")
GREY_METAL = Finish((0.52, 0.54, 0.56), "metal")
WHITE_METAL = Finish((0.92, 0.92, 0.91), "metal")

WHITE_PLASTIC = Finish((0.93, 0.93, 0.92), "plastic")
GREY_PLASTIC = Finish((0.62, 0.63, 0.65), "plastic")
DARK_PLASTIC = Finish((0.17, 0.17, 0.19), "plastic")
BLACK_PLASTIC = Finish((0.06, 0.06, 0.07), "plastic")
YELLOW_PLASTIC = Finish((0.93, 0.74, 0.28), "plastic")

GLASS = Finish((0.83, 0.90, 0.90), "glass")
AMBER_GLASS = Finish((0.42, 0.25, 0.12), "ceramic")
GREEN_GLASS = Finish((0.22, 0.34, 0.24), "ceramic")
PALE_GLASS = Finish((0.66, 0.74, 0.70), "ceramic")
BLACK_GLASS = Finish((0.05, 0.05, 0.06), "screen")
MIRROR = Finish((0.80, 0.85, 0.88), "metal")
WATER = Finish((0.55, 0.74, 0.80), "glass")
PORCELAIN = Finish((0.95, 0.95, 0.93), "ceramic")
STONEWARE = Finish((0.80, 0.76, 0.69), "ceramic")
CLAY = Finish((0.66, 0.42, 0.33), "ceramic")
TEAL_GLAZE = Finish((0.30, 0.48, 0.49), "ceramic")
INK_GLAZE = Finish((0.20, 0.26, 0.34), "ceramic")
OCHRE_GLAZE = Finish((0.80, 0.60, 0.34), "ceramic")
MARBLE = Finish((0.90, 0.89, 0.87), "stone")
SLATE = Finish((0.24, 0.28, 0.28), "stone")
CONCRETE = Finish((0.63, 0.62, 0.60), "stone")
SOIL = Finish((0.20, 0.14, 0.10), "stone")
PAPER = Finish((0.95, 0.94, 0.90), "paper")
KRAFT = Finish((0.76, 0.64, 0.48), "paper")
GLOW = Finish((1.0, 0.93, 0.80), "light")
SHADE = Finish((0.96, 0.91, 0.81), "light")
SCREEN = Finish((0.10, 0.14, 0.20), "screen")
FELT = Finish((0.13, 0.42, 0.30), "fabric")
WICKER = Finish((0.73, 0.57, 0.38), "wood")

LEAVES = tuple(
    Finish(c, "leaf") for c in ((0.22, 0.40, 0.20), (0.28, 0.47, 0.24), (0.34, 0.49, 0.30), (0.19, 0.35, 0.24))
)
PETALS = tuple(
    Finish(c, "leaf")
    for c in ((0.89, 0.45, 0.50), (0.95, 0.80, 0.42), (0.92, 0.90, 0.88), (0.72, 0.55, 0.78), (0.90, 0.58, 0.38))
)
GLAZES = (STONEWARE, PORCELAIN, CLAY, TEAL_GLAZE, INK_GLAZE, OCHRE_GLAZE)
SPINES = tuple(
    Finish(c, "paper")
    for c in (
        (0.62, 0.25, 0.20),
        (0.22, 0.32, 0.44),
        (0.84, 0.79, 0.68),
        (0.35, 0.44, 0.36),
        (0.79, 0.60, 0.31),
        (0.27, 0.25, 0.26),
        (0.90, 0.88, 0.84),
        (0.55, 0.40, 0.32),
        (0.46, 0.56, 0.60),
    )
)
BRIGHT: tuple[Vec3, ...] = (
    (0.80, 0.32, 0.26),
    (0.28, 0.48, 0.66),
    (0.92, 0.74, 0.30),
    (0.42, 0.60, 0.42),
    (0.88, 0.56, 0.34),
)
"""Colours of toys."""

COLOURS: dict[str, Vec3] = {
    "red": (0.70, 0.20, 0.17),
    "orange": (0.86, 0.47, 0.20),
    "yellow": (0.90, 0.73, 0.28),
    "green": (0.36, 0.52, 0.36),
    "blue": (0.27, 0.42, 0.60),
    "navy": (0.17, 0.23, 0.36),
    "purple": (0.45, 0.34, 0.54),
    "pink": (0.88, 0.63, 0.66),
    "brown": (0.42, 0.29, 0.20),
    "beige": (0.84, 0.78, 0.68),
    "cream": (0.92, 0.88, 0.80),
    "white": (0.94, 0.93, 0.91),
    "grey": (0.56, 0.57, 0.58),
    "gray": (0.56, 0.57, 0.58),
    "black": (0.09, 0.09, 0.10),
    "turquoise": (0.35, 0.62, 0.62),
}


def _shades() -> Iterator[tuple[str, str, Vec3]]:
    """Every shade, the general word for it, and its colour."""
    table = tomllib.loads(files("thinkblox.assets").joinpath("shades.toml").read_text("utf-8"))
    for general, shades in table.items():
        for name, code in shades.items():
            red, green, blue = (int(code[at : at + 2], 16) / 255 for at in (1, 3, 5))
            yield name, general, (round(red, 3), round(green, 3), round(blue, 3))


SHADES = {name: general for name, general, _ in _shades()}
"""The general word for each shade: "red" for "burgundy"."""
COLOURS.update({name: colour for name, _, colour in _shades()})
MAHOGANY = Finish((0.38, 0.19, 0.14), "wood")
EBONY = Finish((0.14, 0.11, 0.10), "wood")
CEDAR = Finish((0.62, 0.40, 0.28), "wood")
CHERRY = Finish((0.55, 0.30, 0.20), "wood")
BAMBOO = Finish((0.84, 0.72, 0.50), "wood")
BIRCH = Finish((0.88, 0.79, 0.64), "wood")
WOODS = {
    "oak": OAK,
    "walnut": WALNUT,
    "beech": BEECH,
    "ash": ASH,
    "teak": TEAK,
    "pine": PINE,
    "mahogany": MAHOGANY,
    "ebony": EBONY,
    "cedar": CEDAR,
    "cherry": CHERRY,
    "bamboo": BAMBOO,
    "birch": BIRCH,
    "wooden": OAK,
}
METALS = {
    "steel": STEEL,
    "chrome": CHROME,
    "brass": BRASS,
    "copper": Finish((0.72, 0.45, 0.32), "metal"),
    "bronze": Finish((0.48, 0.36, 0.22), "metal"),
    "iron": IRON,
}
STONES = {
    "brick": Finish((0.63, 0.34, 0.26), "stone"),
    "marble": MARBLE,
    "granite": Finish((0.42, 0.41, 0.41), "stone"),
    "slate": SLATE,
    "concrete": CONCRETE,
    "terrazzo": Finish((0.86, 0.82, 0.77), "stone"),
}


@dataclass(frozen=True)
class Style:
    """Finishes that belong together.

    Attributes:
        wood: of tables and frames.
        paint: of cabinets and wardrobes.
        fabric: of large upholstery.
        accent: of small textiles.
        metal: of handles, legs and lamps.
        glaze: of pots and vases.
        worktop: of all the units of a kitchen.
    """

    name: str
    wood: Finish
    paint: Finish
    fabric: Finish
    accent: Finish
    metal: Finish
    glaze: Finish
    worktop: Finish


STYLES = (
    Style("nordic", OAK, WHITE_PAINT, STONE_WOOL, SAGE_WOOL, IRON, STONEWARE, BUTCHER_BLOCK),
    Style("midcentury", WALNUT, WALNUT, OLIVE_WOOL, MUSTARD_WOOL, BRASS, OCHRE_GLAZE, MARBLE),
    Style("coastal", ASH, CREAM_PAINT, LINEN, DUSTY_BLUE_WOOL, STEEL, TEAL_GLAZE, SLATE),
    Style("warm", TEAK, CREAM_PAINT, LINEN, TERRACOTTA_WOOL, BRASS, CLAY, BUTCHER_BLOCK),
    Style("studio", BEECH, SAGE_PAINT, GREY_WOOL, BLUSH_WOOL, IRON, PORCELAIN, MARBLE),
    Style("classic", WALNUT, CREAM_PAINT, NAVY_WOOL, LINEN, BRASS, INK_GLAZE, MARBLE),
)


def style_of(seed: int) -> Style:
    """Return the style of a seed: assets made with one seed match."""
    return STYLES[seed % len(STYLES)]


def colour_of(words: Collection[str]) -> Vec3 | None:
    """Return the colour that one of `words` names."""
    return next((COLOURS[w] for w in sorted(words) if w in COLOURS), None)


def with_general(words: Collection[str]) -> frozenset[str]:
    """The words and, for every shade among them, the general word for its colour."""
    return frozenset(words).union(SHADES[word] for word in words if word in SHADES)


def without_general(words: Iterable[str]) -> list[str]:
    """Each word once, and of a shade and the general word for its colour only the shade."""
    said = list(dict.fromkeys(words))
    general = {SHADES.get(word) for word in said}
    return [word for word in said if word not in general]


def wood_of(words: Collection[str]) -> Finish | None:
    """Return the wood that one of `words` names."""
    return next((WOODS[w] for w in sorted(words) if w in WOODS), None)
