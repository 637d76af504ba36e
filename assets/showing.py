"""Whether an asset shows what was said of it: its colour, what it is made of, its shape and size, or any other word."""

from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from math import dist, log, pi, prod, tan

import numpy as np
from shapely import MultiPoint, Polygon, get_coordinates
from shapely.geometry.base import BaseGeometry

from thinkblox.assets.catalogue import CATALOGUE, revision
from thinkblox.assets.make import make_asset, seed_of
from thinkblox.assets.palette import COLOURS, METALS, STONES, WICKER, WOODS
from thinkblox.assets.repaint import (
    DARKEST,
    MATERIALS,
    SAME_COLOUR,
    SHARE,
    TOPPED,
    brightness,
    dyed,
    is_dyed,
    share,
    shows_colour,
    shows_finish,
    shows_top,
)
from thinkblox.assets.shapes import polygon
from thinkblox.assets.sizing import COUNTED_PARTS, POLYGONS, counted, is_degree, people
from thinkblox.assets.stand_ins import facts_of, kind_of
from thinkblox.assets.states import shows_state
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.corners import corners_of
from thinkblox.value import Vec3

KINDS = {**WOODS, **METALS, **STONES}
"""Kinds of woods, metals and stones."""
_PLACE, _KNEES = 0.5, 0.65
"""Width that one person takes at a table or on a bench, and how much of a long side the knees at the ends take [m]."""
_FOR_TWO = 1.25
"""How many times as long as usual a desk or basin for two is at least."""
_FULL_HEIGHT = 2.1
"""From this height on a thing reaches from the floor to about the ceiling of a low room [m]."""
_LONG = 1.7
"""How many times as long as wide is what is called long."""
_SAME_SIZE = 0.01
"""Extents that a word changes by less do not tell whether it was heeded [m]."""
_ROUND_SHARE, _ROUND, _CIRCLE = 0.7, 0.08, 0.86
"""Least share of the plan that a round part covers, how far its sides may differ, and what of its box it may fill."""
_OVAL = (0.72, 0.88)
"""What an oval fills of the box round it; a squarish one fills more than an ellipse."""
_FLATTER, _FINER, _BENDS = 0.02, 0.005, 10
"""What of the length of an outline a corner stands out by at least, and one of the corners that stand for a bend, with
how many of these an oval has at least."""
_SAME_FILL = 0.03
"""How far the share that an outline fills of its box may be off that of a regular one."""


def realised(asset: Asset, attribute: str) -> bool:
    """Whether an asset is as a word says; for a word that no rule is about, whether the word changed the asset.

    A thing that is plainly so by nature (a wooden table) shows it without having been told to.
    """
    word = attribute.lower().replace("_", "-").replace(" ", "-")
    rule = _RULES.get(word)
    if wanted := people((word,)):
        return _seats(asset) >= wanted
    for part, kind in zip(COUNTED_PARTS, ("slide", "hinge"), strict=True):
        if wanted := counted((word,), part):
            return sum(link.joint is not None and link.joint.kind == kind for link in asset.links) == wanted
    if word in COLOURS:
        pair = dyed(asset.attributes)
        if pair is not None and pair[0] == word:
            return shows_colour(asset.links, COLOURS[word]) and is_dyed(asset.links, *pair)
        return shows_colour(asset.links, COLOURS[word])
    if word in TOPPED:
        return shows_top(asset.links, word)
    if word in MATERIALS or word in KINDS:
        return shows_finish(asset.links, word)
    if rule is not None:
        return rule(asset)
    return _heeded(asset, attribute) or shows_state(asset, word)


def is_look(attribute: str) -> bool:
    """Whether a word says of which colour or material a thing is."""
    word = attribute.lower().replace("_", "-").replace(" ", "-")
    return word in COLOURS or word in MATERIALS or word in KINDS


def _shapes(asset: Asset) -> list[Shape]:
    return [shape for link in asset.links for shape in link.shapes]


def _is_round(asset: Asset) -> bool:
    """Some part of it is a disc, a drum or a ball nearly as wide as the whole, seen from above or from its front."""
    if any(surface.round and _is_even(*surface.size) for surface in asset.surfaces):
        return True
    upright = asset.mount == "wall" or asset.size[0] <= asset.size[2]
    plans = ((0, 1), (1, 2)) if upright else ((0, 1),)
    return any(_covers(shape, a, b, asset.size) for shape in _shapes(asset) for a, b in plans)


def _is_long(asset: Asset) -> bool:
    """It is by far longer than wide, or, hung on a wall, than high."""
    x, y, z = asset.size
    short, long = sorted((y, z) if asset.mount == "wall" else (x, y))
    return long >= _LONG * short


def _is_even(a: float, b: float) -> bool:
    return abs(a - b) <= _ROUND * max(a, b)


def _covers(shape: Shape, a: int, b: int, size: Vec3) -> bool:
    whole = max(size[a], size[b])
    if shape.kind in ("cylinder", "sphere"):
        return shape.size[0] >= _ROUND_SHARE * whole
    wide, deep = shape.size[a], shape.size[b]
    if not _is_even(wide, deep) or max(wide, deep) < _ROUND_SHARE * whole:
        return False
    if shape.kind != "hull":
        return shape.kind == "ellipsoid"
    outline = MultiPoint([(point[a], point[b]) for point in shape.points]).convex_hull
    return bool(outline.area <= _CIRCLE * wide * deep)


def _is_square(asset: Asset) -> bool:
    a, b = asset.size[1], asset.size[2] if asset.mount == "wall" else asset.size[0]
    return abs(a - b) <= 0.05 * max(a, b) and not _is_round(asset)


def _is_rectangular(asset: Asset) -> bool:
    a, b = asset.size[1], asset.size[2] if asset.mount == "wall" else asset.size[0]
    cut = _is_oval(asset) or any(_has_corners(count)(asset) for count in POLYGONS.values())
    return abs(a - b) > 0.05 * max(a, b) and asset.front != "any" and not cut


def _outline(asset: Asset) -> BaseGeometry:
    """The hull of all of it, seen from above, or from the front where it hangs on a wall [m]."""
    axes = (1, 2) if asset.mount == "wall" else (0, 1)
    return MultiPoint(np.vstack([corners_of(shape) for shape in _shapes(asset)])[:, axes]).convex_hull


def _corners(outline: BaseGeometry, flatter: float) -> int:
    """How many corners are left of a hull where those are passed over that stand out by little of its length."""
    x0, y0, x1, y1 = outline.bounds
    return len(get_coordinates(outline.simplify(flatter * max(x1 - x0, y1 - y0)))) - 1


def _is_oval(asset: Asset) -> bool:
    """Its outline leaves the corners of the box round it free, as an ellipse does, and is longer than wide."""
    outline = _outline(asset)
    x0, y0, x1, y1 = outline.bounds
    short, long = sorted((x1 - x0, y1 - y0))
    filled = outline.area / (short * long)
    bends = _corners(outline, _FINER) >= _BENDS
    return bool(bends and long - short > 0.05 * long and _OVAL[0] <= filled <= _OVAL[1])


def _has_corners(count: int) -> Callable[[Asset], bool]:
    """Whether the outline of a thing has so many corners, and fills as much of its box as if they were alike."""
    usual = Polygon(polygon(1.0, 1.0, count)).area

    def rule(asset: Asset) -> bool:
        outline = _outline(asset)
        x0, y0, x1, y1 = outline.bounds
        filled = outline.area / ((x1 - x0) * (y1 - y0))
        return bool(_corners(outline, _FLATTER) == count and abs(filled - usual) <= _SAME_FILL)

    return rule


def _is_single(asset: Asset) -> bool:
    """It is made for one, or is a desk or a basin that is usually for one, and no longer than usual."""
    usual = kind_of(asset.category)
    alone = usual.is_in("desks", "basins", "built_in") and asset.size[1] < _FOR_TWO * usual.size[1]
    return alone or _heeded(asset, "single")


def _seats(asset: Asset) -> int:
    """How many have room at a table, or side by side on what one sits on or at from one side."""
    short, long = sorted(asset.size[:2])
    if asset.front == "one" or facts_of(asset.category).is_in("seating"):
        return int(asset.size[1] / _PLACE)
    if _is_even(long, short) and _is_round(asset):
        return int(pi * long / _PLACE)
    if corners := next((count for count in POLYGONS.values() if _has_corners(count)(asset)), 0):
        return corners * int(short * tan(pi / corners) / _PLACE)
    along = max(1, int((long - _KNEES) / _PLACE))
    return 2 * along + 2


def _is_wicker(asset: Asset) -> bool:
    return share(asset.links, lambda shape: dist(shape.colour, WICKER.colour) <= 0.5 * SAME_COLOUR) >= SHARE


_RULES: dict[str, Callable[[Asset], bool]] = {
    "round": _is_round,
    "circular": _is_round,
    "square": _is_square,
    "rectangular": _is_rectangular,
    "oval": _is_oval,
    **{word: _has_corners(count) for word, count in POLYGONS.items()},
    "long": _is_long,
    "single": _is_single,
    "dark": lambda asset: brightness(asset.links) < DARKEST,
    "light": lambda asset: brightness(asset.links) > 0.55,
    "wicker": _is_wicker,
    "wall-mounted": lambda asset: asset.mount == "wall",
    "hanging": lambda asset: asset.mount in ("ceiling", "wall"),
    "standing": lambda asset: asset.mount == "floor",
    "full-height": lambda asset: asset.size[2] >= _FULL_HEIGHT,
    "propped": lambda asset: asset.mount == "surface",
}


def _heeded(asset: Asset, attribute: str) -> bool:
    """Whether the same asset would be another without the word, and is of about the size that the word makes it."""
    if asset.category not in CATALOGUE:
        return attribute in asset.attributes
    seed = seed_of(asset)
    if seed is None or attribute not in asset.attributes:
        return False
    changed, told, untold = _change(asset.category, seed, asset.attributes, attribute, revision())
    sized = [(a, b, size) for a, b, size in zip(told, untold, asset.size, strict=True) if abs(a - b) > _SAME_SIZE]
    if sized and is_degree(attribute):
        sized = [_together(sized)]
    return changed and (not sized or any(abs(log(size / a)) < abs(log(size / b)) for a, b, size in sized))


def _together(extents: Sequence[Vec3]) -> Vec3:
    """The products of several extents, each as told, as untold and as it is."""
    told, untold, now = (prod(lengths) for lengths in zip(*extents, strict=True))
    return told, untold, now


@lru_cache(maxsize=256)
def _change(category: str, seed: int, attributes: tuple[str, ...], word: str, revision: int) -> tuple[bool, Vec3, Vec3]:
    """Whether a word makes another asset of one, and the extents of that with and without it [m]."""
    told = make_asset(category, seed=seed, attributes=attributes)
    untold = make_asset(category, seed=seed, attributes=_without(attributes, word))
    return (told.size, told.links) != (untold.size, untold.links), told.size, untold.size


def _without(words: Iterable[str], word: str) -> tuple[str, ...]:
    return tuple(w for w in words if w != word)
