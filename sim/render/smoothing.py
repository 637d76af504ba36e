"""Smoothing noisy light without carrying it over edges, and bringing it from a coarse grid to single points."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.rays import in_parallel
from thinkblox.sim.render.tessellate import Floats

_ROWS = 32


@dataclass(frozen=True)
class Grid:
    """Light on a regular grid of seen points.

    Attributes:
        light: (channels, height, width).
        position, normal: (3, height, width) [m] and unit length.
        seen: 1 where there is a surface, else 0 (height, width).
        spacing: distance of two neighbours on a surface that faces the eye [m] (height, width).
    """

    light: Floats
    position: Floats
    normal: Floats
    seen: Floats
    spacing: Floats


@dataclass(frozen=True)
class Rows:
    """The same with one row for each grid point, in reading order: light (n, channels), position and normal (n, 3),
    seen and spacing (n,); `width` points make a line of the grid.
    """

    light: Floats
    position: Floats
    normal: Floats
    seen: Floats
    spacing: Floats
    width: int


def smoothed(grid: Grid, *, radius: int, step: int = 1) -> Grid:
    """The grid with its light averaged over (2 radius + 1) squared neighbours, `step` apart, of the same surface."""
    reach = radius * step
    height = grid.seen.shape[0]
    pads = _padded(grid, reach)
    bands = in_parallel(lambda top: _band(pads, top, min(top + _ROWS, height), radius, step), range(0, height, _ROWS))
    return Grid(np.concatenate(bands, 1), grid.position, grid.normal, grid.seen, grid.spacing)


@dataclass(frozen=True)
class Lattice:
    """Light on a coarse grid, ready to be spread over the pixels between its points, which are `step` pixels apart.

    Its planes are those of a grid, with one line more at the lower and right ends; `tight` [1/m] says how far from the
    plane of a point its light still counts.
    """

    planes: Floats
    tight: Floats
    step: int


def lattice_of(grid: Grid, step: int) -> Lattice:
    """A grid whose points are `step` pixels apart."""
    stack = np.concatenate([grid.position, grid.normal, grid.seen[None], grid.light])
    spacing = np.pad(grid.spacing, ((0, 1), (0, 1)), mode="edge")
    planes = np.pad(stack, ((0, 0), (0, 1), (0, 1)), mode="edge")
    return Lattice(planes, np.reciprocal(np.float32(1.5) * spacing + np.float32(1e-4)), step)


def spread(lattice: Lattice, top: int, position: Floats, normal: Floats) -> tuple[Floats, Floats]:
    """Light for whole lines of pixels, each from the four nearest points of the grid on the same surface.

    A pixel none of whose neighbours is on its surface takes their plain mean.

    Args:
        lattice: the light.
        top: the first line of pixels, a multiple of the lattice's step.
        position: what the pixels show (lines, width, 3) [m].
        normal: the normals there (lines, width, 3).

    Returns:
        the light (lines, width, channels), and how far it is the pixels' own, 0 and up (lines, width).
    """
    step, (lines, width) = lattice.step, position.shape[:2]
    light = np.empty((lines, width, len(lattice.planes) - 7), np.float32)
    weights = np.empty((lines, width), np.float32)
    for row in range(min(step, lines)):
        for column in range(min(step, width)):
            mine = (slice(row, None, step), slice(column, None, step))
            here, facing = (np.ascontiguousarray(v[mine].transpose(2, 0, 1)) for v in (position, normal))
            found, total = _between(lattice, top // step, (row / step, column / step), here, facing)
            light[mine], weights[mine] = found.transpose(1, 2, 0), total
    return light, weights


def _between(
    lattice: Lattice, top: int, at: tuple[float, float], position: Floats, normal: Floats
) -> tuple[Floats, Floats]:
    """Light (channels, h, w) and weights of the pixels that lie `at` the same place between four points of the grid."""
    (fy, fx), (height, width) = at, position.shape[1:]
    total = np.zeros((len(lattice.planes) - 7, height, width), np.float32)
    weights = np.zeros((height, width), np.float32)
    for down in (0, 1):
        for across in (0, 1):
            there = (slice(top + down, top + down + height), slice(across, across + width))
            planes, tight = lattice.planes[:, *there], lattice.tight[there]
            share = np.float32((fx if across else 1 - fx) * (fy if down else 1 - fy) + 0.02)
            weight = _alike(position, normal, tight, planes[:3], planes[3:6])
            weight += np.float32(1e-4)
            weight *= planes[6] * share
            weights += weight
            for channel, light in zip(total, planes[7:], strict=True):
                channel += light * weight
    total /= np.maximum(weights, np.float32(1e-9))
    return total, weights


def _padded(grid: Grid, reach: int) -> Floats:
    """Light, position, normal, seen, spacing stacked, with a border of unseen points."""
    stack = np.concatenate([grid.position, grid.normal, grid.seen[None], grid.spacing[None], grid.light])
    return np.pad(stack, ((0, 0), (reach, reach), (reach, reach)))


def _band(pads: Floats, top: int, bottom: int, radius: int, step: int) -> Floats:
    reach = radius * step
    width = pads.shape[2] - 2 * reach
    centre = pads[:, top + reach : bottom + reach, reach : reach + width]
    position, normal = centre[:3], centre[3:6]
    tight = 1 / (np.float32(0.9 * reach) * centre[7] + np.float32(1e-4))
    total = np.zeros_like(centre[8:])
    weights = np.full(centre.shape[1:], 1e-6, np.float32)
    total += centre[8:] * np.float32(1e-6)
    for down in range(-radius, radius + 1):
        for across in range(-radius, radius + 1):
            rows, columns = reach + down * step, reach + across * step
            other = pads[:, top + rows : bottom + rows, columns : columns + width]
            weight = (
                other[6]
                * _alike(position, normal, tight, other[:3], other[3:6])
                * _tap(down, radius)
                * _tap(across, radius)
            )
            weights += weight
            total += other[8:] * weight
    return total / weights


def _tap(offset: int, radius: int) -> np.float32:
    """Half weight for the outermost neighbours: the width is then 2 radius, and a pattern of that period vanishes."""
    return np.float32(0.5 if abs(offset) == radius else 1.0)


def _alike(position: Floats, normal: Floats, tight: Floats, there: Floats, facing: Floats) -> Floats:
    """Whether other points lie on the same surface: in the plane, and facing the same way; 1 down to 0."""
    off = np.abs(
        (there[0] - position[0]) * normal[0]
        + (there[1] - position[1]) * normal[1]
        + (there[2] - position[2]) * normal[2]
    )
    cosine = facing[0] * normal[0] + facing[1] * normal[1] + facing[2] * normal[2]
    flat = np.maximum(1 - off * tight, 0)
    weight: Floats = flat * np.clip(cosine * np.float32(5) - np.float32(4), 0, 1)
    return weight


def sampled(
    rows: Rows, x: Floats, y: Floats, position: Floats, normal: Floats, *, least: float = 0.02
) -> tuple[Floats, NDArray[np.bool_]]:
    """Light (n, channels) for points at grid coordinates, from the four nearest grid points of the same surface.

    A point none of whose neighbours is on its surface takes their plain mean.

    Args:
        rows: the light to look up.
        x: column in the grid (n,).
        y: row in the grid (n,).
        position: the points (n, 3) [m].
        normal: their normals (n, 3).
        least: weight below which a point counts as found nowhere.

    Returns:
        the light, and whether it comes from the point's own surface.
    """
    x0, y0 = np.floor(x), np.floor(y)
    fx, fy = x - x0, y - y0
    last = len(rows.seen) // rows.width - 1
    total = np.zeros((len(x), rows.light.shape[1]), np.float32)
    weights = np.zeros(len(x), np.float32)
    for down in (0, 1):
        line = np.clip(y0.astype(np.int32) + down, 0, last) * rows.width
        for across in (0, 1):
            index = line + np.clip(x0.astype(np.int32) + across, 0, rows.width - 1)
            tight = np.reciprocal(np.float32(1.5) * rows.spacing.take(index) + np.float32(1e-4))
            share = (fx if across else 1 - fx) * (fy if down else 1 - fy) + np.float32(0.02)
            alike = _alike(position.T, normal.T, tight, rows.position.take(index, 0).T, rows.normal.take(index, 0).T)
            weight = share * rows.seen.take(index) * (alike + np.float32(1e-4))
            weights += weight
            total += rows.light.take(index, 0) * weight[:, None]
    light = total / np.maximum(weights, np.float32(1e-9))[:, None]
    return np.asarray(light, np.float32), weights > least
