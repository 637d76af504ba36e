"""What floors and walls are made of, as patterns: joints, boards, chips, pile and paper, filtered to a pixel's size.

Each pattern gives a tone, by which the colour is multiplied, and the share of a second colour, for points given along
and across in metres, and the width of a pixel there [m].
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from thinkblox.layings import Laying
from thinkblox.scene.surfaces import Covering
from thinkblox.sim.render.materials import Reflectance, linear
from thinkblox.sim.render.tessellate import Floats
from thinkblox.sim.render.textures import fade, hashed, joint, noise, planks, speckle, wood
from thinkblox.sim.render.vectors import scaled

Tone = tuple[Floats, Floats]
Painter = Callable[[Floats, Floats, Floats], Tone]
_MORTAR, _GROUT, _SEAM = 0.010, 0.004, 0.0022
"""Widths of joints [m]."""


@dataclass(frozen=True)
class Make:
    """How a laying is drawn.

    Attributes:
        floor, wall: its pattern there.
        reflectance: how it answers to light.
        second: what its second colour is, where none is said: the colour, moved by this share towards white, or towards
            black below 0; what is light already goes towards black.
    """

    floor: Painter
    wall: Painter
    reflectance: Reflectance
    second: float = -0.3


def colours(covering: Covering, along: Floats, across: Floats, width: Floats, *, floor: bool) -> Floats:
    """Linear RGB (n, 3) of points on a covering."""
    make = MAKES[covering.laying]
    base = np.array(linear(covering.colour), np.float32)
    second = _second(covering)
    tone, share = (make.floor if floor else make.wall)(along, across, width)
    return scaled(base, tone * (1 - share)) + scaled(second, share)


def mean_colour(covering: Covering) -> tuple[float, float, float]:
    """Linear RGB of the whole of a covering."""
    base, second = np.array(linear(covering.colour)), _second(covering)
    mixed = base + (second - base) * _SECOND.get(covering.laying, 0.02)
    return (float(mixed[0]), float(mixed[1]), float(mixed[2]))


_SECOND: dict[Laying, float] = {
    "checker": 0.5,
    "stripes": 0.5,
    "flowers": 0.15,
    "motifs": 0.15,
    "brick": 0.12,
    "terrazzo": 0.1,
    "carpet": 0.12,
}
"""The share of the second colour in what has much of it."""


def _second(covering: Covering) -> Floats:
    if covering.second is not None:
        return np.array(linear(covering.second), np.float32)
    base, share = np.array(linear(covering.colour), np.float32), MAKES[covering.laying].second
    end = np.float32(0.9 if share > 0 else 0.02)
    if share > 0 and float(base.mean()) > 0.62:
        share, end = 0.35, np.float32(0.2)
    return np.asarray(base + (end - base) * np.float32(abs(share)), np.float32)


def _none(values: Floats) -> Floats:
    return np.zeros_like(values)


def _boards(along: Floats, across: Floats, width: Floats) -> Tone:
    tone, _ = planks(along, across, width)
    return tone, _none(tone)


def _staves(long: Floats, wide: Floats, key: Floats, length: float, side: float, width: Floats) -> Tone:
    """A stave of wood, for a place along and across it [m]; `key` tells it from the others."""
    tint = hashed(key) - np.float32(0.5)
    grain = wood(long, wide, width, np.floor(hashed(key + 31) * 997))
    seam = np.maximum(joint(long / np.float32(length), width, length, _SEAM), joint(wide / side, width, side, _SEAM))
    return grain * (1 + np.float32(0.22) * tint), seam * np.float32(0.8)


def _herringbone(x: Floats, y: Floats, width: Floats) -> Tone:
    side, many = np.float32(0.085), 6
    turned, over = (x + y) * np.float32(0.7071) / side, (y - x) * np.float32(0.7071) / side
    i, j = np.floor(turned), np.floor(over)
    fx, fy = turned - i, over - j
    place = np.mod(i - j, 2 * many)
    level = place < many
    long = np.where(level, place + fx, 2 * many - 1 - place + fy) * side
    wide = np.where(level, fy, fx) * side
    key = np.where(level, j * 57 + (i - place) * 131, i * 91 + (j - (2 * many - 1 - place)) * 17 + 5000)
    tone, seam = _staves(long, wide, key, float(many * side), float(side), width)
    # The staves of one direction take the light a little differently from those of the other.
    return tone * np.where(level, np.float32(1.04), np.float32(0.96)), seam


def _parquet(x: Floats, y: Floats, width: Floats) -> Tone:
    square = np.float32(0.36)
    i, j = np.floor(x / square), np.floor(y / square)
    fx, fy = x - i * square, y - j * square
    turned = np.mod(i + j, 2) < 1
    long, wide = np.where(turned, fx, fy), np.where(turned, fy, fx)
    stave = square / np.float32(5)
    number = np.floor(wide / stave)
    tone, seam = _staves(long, wide - number * stave, i * 57 + j * 131 + number * 7, float(square), float(stave), width)
    return tone * np.where(turned, np.float32(1.05), np.float32(0.95)), seam


def _panels(x: Floats, y: Floats, width: Floats) -> Tone:
    side = np.float32(0.14)
    number = np.floor(x / side)
    tint = hashed(number * 57 + 3) - np.float32(0.5)
    groove = joint(x / side - number, width, float(side), 0.007)
    return wood(y, x, width, number % 97) * (1 + np.float32(0.10) * tint), groove * np.float32(0.9)


def _grid(
    x: Floats, y: Floats, width: Floats, size: tuple[float, float], gap: float, *, bond: float = 0.0
) -> tuple[Floats, Floats, Floats, Floats]:
    """Column and row of the tile at each point, a number that tells it from the others, and the share of joint."""
    high = y / np.float32(size[1])
    row = np.floor(high)
    over = x / np.float32(size[0]) + np.float32(bond) * row
    column = np.floor(over)
    gaps = np.maximum(joint(over - column, width, size[0], gap), joint(high - row, width, size[1], gap))
    return column, row, column * 57 + row * 131, gaps


def _tiles(size: tuple[float, float], spread: float, *, bond: float = 0.0, gap: float = _GROUT) -> Painter:
    def paint(x: Floats, y: Floats, width: Floats) -> Tone:
        _, _, key, gaps = _grid(x, y, width, size, gap, bond=bond)
        tone = 1 + np.float32(spread) * (hashed(key) - np.float32(0.5))
        return tone * (1 + np.float32(0.012) * noise(x * 14, y * 14)), gaps

    return paint


def _checker(size: float) -> Painter:
    def paint(x: Floats, y: Floats, width: Floats) -> Tone:
        column, row, key, gaps = _grid(x, y, width, (size, size), 0.002)
        tone = 1 + np.float32(0.05) * (hashed(key) - np.float32(0.5))
        other = (np.mod(column + row, 2) < 1).astype(np.float32)
        return tone, np.where(gaps > 0, other * (1 - gaps) + np.float32(0.5) * gaps, other)

    return paint


def _slabs(size: tuple[float, float]) -> Painter:
    def paint(x: Floats, y: Floats, width: Floats) -> Tone:
        _, _, key, gaps = _grid(x, y, width, size, 0.008, bond=0.37)
        skew = hashed(key + 11) * 200
        tone = 1 + np.float32(0.20) * (hashed(key) - np.float32(0.5))
        tone += np.float32(0.05) * noise(x * 9 + skew, y * 9) + np.float32(0.03) * noise(x * 45, y * 45 + skew)
        return tone, gaps

    return paint


def _marble(size: float) -> Painter:
    def paint(x: Floats, y: Floats, width: Floats) -> Tone:
        _, _, key, gaps = _grid(x, y, width, (size, size), 0.002)
        skew = hashed(key) * 200
        bent = noise(x * 3 + skew, y * 3) * np.float32(1.6)
        vein = np.abs(noise(x * 5 + y * 3 + bent + skew, y * 6 - x * 2 + bent))
        veins = np.clip(np.float32(0.5) - vein * np.float32(3.2), 0, 1)
        tone = 1 + np.float32(0.05) * noise(x * 4 + skew, y * 4)
        return tone, np.maximum(gaps, veins)

    return paint


def _terrazzo(x: Floats, y: Floats, width: Floats) -> Tone:
    """Chips; a pixel wider than they are shows the mean of them, so that the floor lies still."""
    light, share = np.zeros_like(x), np.zeros_like(x)
    for cell, salt in ((0.055, 0.0), (0.034, 500.0)):
        i, j = np.floor(x / np.float32(cell)), np.floor(y / np.float32(cell))
        key = i * 57 + j * 131 + np.float32(salt)
        away_x = x / np.float32(cell) - i - np.float32(0.3) - np.float32(0.4) * hashed(key)
        away_y = y / np.float32(cell) - j - np.float32(0.3) - np.float32(0.4) * hashed(key + 7)
        radius = np.float32(0.12) + np.float32(0.2) * hashed(key + 13)
        edge = np.maximum(width / np.float32(cell), np.float32(0.05))
        chip = np.clip((radius - np.hypot(away_x, away_y * np.float32(1.3))) / edge + np.float32(0.5), 0, 1)
        dark, seen = hashed(key + 29) < 0.55, fade(width, 0.3 * cell)
        share = np.maximum(share, (chip * dark - _DARK_CHIPS) * seen + _DARK_CHIPS)
        light = np.maximum(light, (chip * ~dark - _LIGHT_CHIPS) * seen + _LIGHT_CHIPS)
    return 1 + np.float32(0.14) * light, share * np.float32(0.6)


_DARK_CHIPS, _LIGHT_CHIPS = np.float32(0.09), np.float32(0.07)
"""Shares of the floor that chips of either kind cover."""


def _concrete(x: Floats, y: Floats, width: Floats) -> Tone:
    tone = 1 + np.float32(0.06) * noise(x * 3, y * 3) + np.float32(0.03) * noise(x * 21, y * 21)
    _, _, _, gaps = _grid(x, y, width, (2.4, 2.4), 0.006)
    return tone, gaps * np.float32(0.6)


def _linoleum(x: Floats, y: Floats, width: Floats) -> Tone:
    """Sheets two metres wide with a welded seam, mottled in short streaks along them."""
    fine, broad = speckle(x / np.float32(3), y, width, 0.006), speckle(x / np.float32(2), y, width, 0.018)
    _, _, _, gaps = _grid(x, y, width, (60.0, 2.0), 0.006)
    return 1 + np.float32(0.03) * fine + np.float32(0.022) * broad, gaps * np.float32(0.6)


def _rubber(x: Floats, y: Floats, width: Floats) -> Tone:
    key = np.floor(x * 90) * 57 + np.floor(y * 90) * 131
    fleck = (hashed(key) > 0.93) * fade(width, 0.016)
    _, _, _, gaps = _grid(x, y, width, (1.0, 1.0), 0.006)
    return (1 + np.float32(0.06) * noise(x * 30, y * 30)) * (1 - np.float32(0.5) * gaps), fleck * np.float32(0.6)


def _carpet(x: Floats, y: Floats, width: Floats) -> Tone:
    """Cut pile of yarn in two tones."""
    pile = speckle(x, y, width, 0.0035)
    tufts = speckle(x, y, width, 0.013)
    return 1 + np.float32(0.09) * pile + np.float32(0.04) * tufts, _none(x) + np.float32(0.12)


def _carpet_tiles(x: Floats, y: Floats, width: Floats) -> Tone:
    """Squares of ribbed loops, turned by turns: they take the light by which way they lie."""
    column, row, key, gaps = _grid(x, y, width, (0.5, 0.5), 0.002)
    turned = np.mod(column + row, 2) < 1
    over = np.where(turned, x, y)
    ribs = np.sin(over * np.float32(2 * np.pi / 0.012)) * fade(width, 0.006)
    tone = np.where(turned, np.float32(1.03), np.float32(0.97)) + np.float32(0.03) * (hashed(key) - np.float32(0.5))
    tone += np.float32(0.05) * ribs + np.float32(0.05) * speckle(x, y, width, 0.0035)
    return tone + np.float32(0.022) * speckle(x, y, width, 0.013), gaps * np.float32(0.5)


def _brick(x: Floats, y: Floats, width: Floats) -> Tone:
    _, _, key, gaps = _grid(x, y, width, (0.25, 0.078), _MORTAR, bond=0.5)
    tone = 1 + np.float32(0.42) * (hashed(key) - np.float32(0.5)) + np.float32(0.06) * noise(x * 60, y * 60)
    return tone, gaps


def _paint(x: Floats, y: Floats, width: Floats) -> Tone:
    return np.ones_like(x), _none(x)


def _stripes(x: Floats, y: Floats, width: Floats) -> Tone:
    side = np.float32(0.11)
    place = np.mod(x / side, 2)
    away = (np.abs(place - 1) - np.float32(0.5)) * side
    return np.ones_like(x), np.clip(away / np.maximum(width, np.float32(1e-3)) + np.float32(0.5), 0, 1)


def _figures(petals: int, size: float, cell: float) -> Painter:
    """Figures with so many petals in staggered cells; with none, diamonds."""

    def paint(x: Floats, y: Floats, width: Floats) -> Tone:
        row = np.floor(y / np.float32(cell))
        over = x / np.float32(cell) + np.float32(0.5) * np.mod(row, 2)
        away_x = (over - np.floor(over) - np.float32(0.5)) * np.float32(cell)
        away_y = (y / np.float32(cell) - row - np.float32(0.5)) * np.float32(cell)
        if petals:
            key = np.floor(over) * 57 + row * 131
            turn = np.arctan2(away_y, away_x) + hashed(key) * np.float32(6.283)
            reach = np.float32(size) * (np.float32(0.8) + np.float32(0.2) * np.cos(turn * petals))
            inside = reach - np.hypot(away_x, away_y)
        else:
            inside = np.float32(size) - np.abs(away_x) * np.float32(1.5) - np.abs(away_y)
        share = np.clip(inside / np.maximum(width, np.float32(1e-3)) + np.float32(0.5), 0, 1)
        return np.ones_like(x), share * np.float32(0.7)

    return paint


_GLAZED = Reflectance(mirror=0.05, gloss=80.0)
_WOODEN = Reflectance(mirror=0.028, gloss=36.0)
_HONED = Reflectance(mirror=0.03, gloss=30.0)
_DULL = Reflectance()
MAKES: dict[Laying, Make] = {
    "planks": Make(_boards, _boards, _WOODEN),
    "parquet": Make(_parquet, _parquet, _WOODEN, -0.55),
    "herringbone": Make(_herringbone, _herringbone, _WOODEN, -0.55),
    "panels": Make(_panels, _panels, Reflectance(mirror=0.02, gloss=28.0), -0.6),
    "tiles": Make(_tiles((0.45, 0.45), 0.07), _tiles((0.2, 0.2), 0.08, gap=0.005), _GLAZED, 0.45),
    "subway": Make(_tiles((0.2, 0.1), 0.06, bond=0.5), _tiles((0.2, 0.1), 0.06, bond=0.5), _GLAZED, 0.45),
    "checker": Make(_checker(0.4), _checker(0.2), _GLAZED, -0.85),
    "stone": Make(_slabs((0.8, 0.5)), _slabs((0.5, 0.26)), _HONED, -0.35),
    "marble": Make(_marble(0.9), _marble(0.9), Reflectance(mirror=0.045, gloss=90.0), -0.3),
    "terrazzo": Make(_terrazzo, _terrazzo, _HONED, -0.45),
    "concrete": Make(_concrete, _concrete, Reflectance(mirror=0.02, gloss=18.0), -0.4),
    "linoleum": Make(_linoleum, _linoleum, _HONED, -0.3),
    "rubber": Make(_rubber, _rubber, Reflectance(mirror=0.012, gloss=12.0), 0.5),
    "carpet": Make(_carpet, _carpet, Reflectance(sheen=0.12), -0.2),
    "carpet_tiles": Make(_carpet_tiles, _carpet_tiles, Reflectance(sheen=0.06), -0.4),
    "brick": Make(_brick, _brick, _DULL, 0.55),
    "paint": Make(_paint, _paint, _DULL),
    "stripes": Make(_stripes, _stripes, _DULL, -0.15),
    "motifs": Make(_figures(0, 0.045, 0.17), _figures(0, 0.045, 0.17), _DULL, -0.3),
    "flowers": Make(_figures(5, 0.06, 0.2), _figures(5, 0.06, 0.2), _DULL, -0.3),
}
