"""What the shelves of shops and stores are full of: cartons, tins and bottles that are part of the shelf."""

from msgspec import structs

from thinkblox.assets.palette import SPINES
from thinkblox.assets.part import Build, Part
from thinkblox.assets.shapes import around, box, disc
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Surface

_LOWEST = 0.1
"""Nothing is kept on a shelf with less room above it [m]."""
_GAP = 0.015
"""Between two goods of a row, and before its ends [m]."""
_SHARE = (0.66, 0.88)
"""Share of a shelf that goods take."""
_TALL = (0.17, 0.33)
"""How high goods are [m]."""
_REACHED = 0.2
"""How far the middle of goods is behind the front edge of a deep shelf, so that they are seen and reached [m]."""
_TINS = 0.4
"""Share of goods that are round."""


def is_filled(spec: Spec) -> bool:
    """Whether shelves are to be full."""
    return spec.has("filled", "full")


def put_goods(build: Build, spec: Spec) -> None:
    """Fill most of every shelf with rows of goods, a few alike side by side; what is left free of it carries things."""
    build.surfaces = [_stocked(build, spec, surface) for surface in build.surfaces]


def _stocked(build: Build, spec: Spec, shelf: Surface) -> Surface:
    """The free end of a shelf after goods have been put on the rest."""
    if shelf.headroom is None or shelf.headroom < _LOWEST:
        return shelf
    (deep, wide), (x, y, z) = shelf.size, shelf.position
    low, high = y - wide / 2, y + wide / 2
    build.body += _row(spec, shelf, shelf.headroom, end := low + wide * spec.between(*_SHARE))
    return structs.replace(shelf, position=(x, (end + high) / 2, z), size=(deep, high - end))


def _row(spec: Spec, shelf: Surface, headroom: float, end: float) -> list[Part]:
    (deep, wide), (x, y, z) = shelf.size, shelf.position
    x, at = max(x, x + deep / 2 - _REACHED), y - wide / 2 + _GAP
    parts: list[Part] = []
    while True:
        tall = min(0.85 * headroom, spec.between(*_TALL))
        is_tin, finish = spec.rng.random() < _TINS, spec.choice(SPINES)
        width = min(spec.between(0.5, 1.0) * tall * (0.55 if is_tin else 1.0), deep - 2 * _GAP, 0.35 * wide)
        for _ in range(int(spec.rng.integers(1, 4))):
            if at + width > end:
                return parts
            if is_tin:
                parts.append(disc(finish, (x, at + width / 2), width / 2, (z, z + tall)))
            else:
                across = around(x, min(deep - 2 * _GAP, 2 * _REACHED - 2 * _GAP, 1.4 * width))
                parts.append(box(finish, across, (at, at + width), (z, z + tall)))
            at += width + _GAP
