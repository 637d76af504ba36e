"""Procedural patterns: planks, grain and weave, filtered to the size of a pixel."""

from functools import lru_cache

import numpy as np

from thinkblox.sim.render.tessellate import Floats

_SIZE = 256
PLANK = 0.145
"""Width of a floor plank [m]."""
_PLANK_LENGTH = 1.9


@lru_cache(maxsize=1)
def _noise() -> Floats:
    """A seamless square of smooth noise, mean 0 and deviation 1, of many scales."""
    rng = np.random.default_rng(3)
    wave = np.hypot(*np.meshgrid(np.fft.fftfreq(_SIZE), np.fft.fftfreq(_SIZE))) * _SIZE
    power = np.where(wave > 0, 1 / (4 + wave) ** 1.3, 0.0) * np.exp(-((wave / 90) ** 2))
    field = np.fft.ifft2(np.fft.fft2(rng.normal(size=(_SIZE, _SIZE))) * power).real
    return np.asarray(field / field.std(), np.float32)


@lru_cache(maxsize=1)
def _even_noise() -> Floats:
    """The same without the larger scales: bumps two or three cells wide, and no clouds of them."""
    rng = np.random.default_rng(7)
    wave = np.hypot(*np.meshgrid(np.fft.fftfreq(_SIZE), np.fft.fftfreq(_SIZE))) * _SIZE
    field = np.fft.ifft2(np.fft.fft2(rng.normal(size=(_SIZE, _SIZE))) * np.exp(-(((wave - 70) / 26) ** 2))).real
    return np.asarray(field / field.std(), np.float32)


@lru_cache(maxsize=1)
def _dice() -> Floats:
    return np.random.default_rng(5).random(4096).astype(np.float32)


def noise(x: Floats, y: Floats) -> Floats:
    """Smooth noise, mean 0 and deviation 1, at coordinates in cells of its grid, which repeats every 256."""
    return _looked_up(_noise(), x, y)


def speckle(x: Floats, y: Floats, footprint: Floats, cell: float) -> Floats:
    """Even noise with bumps about two cells wide [m], mean 0 and deviation 1, gone where a pixel is wider than they."""
    size = np.float32(cell)
    return _looked_up(_even_noise(), x / size, y / size) * fade(footprint, 2.5 * cell)


def _looked_up(square: Floats, x: Floats, y: Floats) -> Floats:
    """What a seamless square of noise says at coordinates in its cells."""
    x0, y0 = np.floor(x), np.floor(y)
    fx, fy = x - x0, y - y0
    i, j = x0.astype(np.int64) & (_SIZE - 1), y0.astype(np.int64) & (_SIZE - 1)
    field = square.ravel()
    i1, j1 = (i + 1) & (_SIZE - 1), ((j + 1) & (_SIZE - 1)) * _SIZE
    j = j * _SIZE
    low = field.take(j + i) * (1 - fx) + field.take(j + i1) * fx
    high = field.take(j1 + i) * (1 - fx) + field.take(j1 + i1) * fx
    return np.asarray(low * (1 - fy) + high * fy, np.float32)


def fade(footprint: Floats, detail: float) -> Floats:
    """How much of a pattern with features of `detail` metres a pixel of this width [m] can show, 1 to 0."""
    return np.asarray(np.clip(np.float32(1.6) - footprint / np.float32(detail), 0, 1), np.float32)


def planks(along: Floats, across: Floats, footprint: Floats) -> tuple[Floats, Floats]:
    """Tone (a factor near 1) and warmth (near 0) of a plank floor at points given in metres."""
    row = np.floor(across / np.float32(PLANK))
    shifted = along / np.float32(_PLANK_LENGTH) + hashed(row) * np.float32(3.7)
    board = np.floor(shifted)
    key = row * np.float32(57.0) + board * np.float32(131.0)
    tint, lean = hashed(key) - np.float32(0.5), hashed(key + np.float32(911.0)) - np.float32(0.5)
    skew = hashed(key + np.float32(77.0)) * np.float32(200.0)
    grain = noise(along * np.float32(9) + skew, across * np.float32(260) + skew) * fade(footprint, 0.009)
    figure = noise(along * np.float32(4) + skew, across * np.float32(55) + skew * np.float32(1.7))
    side = joint(across / np.float32(PLANK) - row, footprint, PLANK)
    end = joint(shifted - board, footprint, _PLANK_LENGTH)
    tone = 1 + np.float32(0.13) * tint + np.float32(0.030) * grain + np.float32(0.045) * figure
    return tone * (1 - np.float32(0.50) * np.maximum(side, end)), lean * np.float32(0.06)


def joint(share: Floats, footprint: Floats, width: float, gap: float = 0.0022) -> Floats:
    """Coverage of a pixel by the gap at the ends of a board, for a place given as a share of the board."""
    distance = np.minimum(share, 1 - share) * np.float32(width)
    pixel = np.maximum(footprint, np.float32(0.001))
    covered = (np.float32(gap / 2) + pixel / 2 - distance) / pixel
    most = np.minimum(np.float32(gap) / pixel, np.float32(1))
    return np.asarray(np.clip(covered, 0, 1) * most, np.float32)


def hashed(key: Floats) -> Floats:
    """A number from 0 to 1 for each key, as by the throw of dice."""
    return _dice().take((key.astype(np.int64) * 2654435761 >> 7) & 4095)


def wood(along: Floats, across: Floats, footprint: Floats, key: Floats) -> Floats:
    """Tone of wooden parts, a factor near 1; `key` sets one part apart from the next."""
    skew = key * np.float32(37.7)
    fine = noise(along * np.float32(10) + skew, across * np.float32(300) + skew) * fade(footprint, 0.008)
    figure = noise(along * np.float32(5) + skew, across * np.float32(70) + skew)
    return 1 + np.float32(0.05) * fine + np.float32(0.06) * figure


def weave(x: Floats, y: Floats, footprint: Floats) -> Floats:
    """Tone of cloth, a factor near 1."""
    fine = noise(x * np.float32(420), y * np.float32(420)) * fade(footprint, 0.006)
    return 1 + np.float32(0.05) * fine + np.float32(0.018) * noise(x * np.float32(30), y * np.float32(30))
