"""Smoothing noisy light without carrying it over edges, and bringing it from a coarse grid to single points."""

from dataclasses import dataclass
from functools import cached_property

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

    @cached_property
    def table(self) -> Floats:
        """One row for each grid point: position, normal, seen, spacing, light."""
        stack = np.concatenate([self.position, self.normal, self.seen[None], self.spacing[None], self.light])
        return np.ascontiguousarray(stack.reshape(len(stack), -1).T)


def smoothed(grid: Grid, *, radius: int, step: int = 1) -> Grid:
    """The grid with its light averaged over (2 radius + 1) squared neighbours, `step` apart, of the same surface."""
    reach = radius * step
    height = grid.seen.shape[0]
    pads = _padded(grid, reach)
    bands = in_parallel(lambda top: _band(pads, top, min(top + _ROWS, height), radius, step), range(0, height, _ROWS))
    return Grid(np.concatenate(bands, 1), grid.position, grid.normal, grid.seen, grid.spacing)


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
            weight = _alike(position, normal, tight, other) * _tap(down, radius) * _tap(across, radius)
            weights += weight
            total += other[8:] * weight
    return total / weights


def _tap(offset: int, radius: int) -> np.float32:
    """Half weight for the outermost neighbours: the width is then 2 radius, and a pattern of that period vanishes."""
    return np.float32(0.5 if abs(offset) == radius else 1.0)


def _alike(position: Floats, normal: Floats, tight: Floats, other: Floats) -> Floats:
    """Whether other points lie on the same surface: in the plane, and facing the same way; 1 down to 0."""
    off = np.abs(
        (other[0] - position[0]) * normal[0]
        + (other[1] - position[1]) * normal[1]
        + (other[2] - position[2]) * normal[2]
    )
    facing = other[3] * normal[0] + other[4] * normal[1] + other[5] * normal[2]
    flat = np.maximum(1 - off * tight, 0)
    turned = np.clip(facing * np.float32(5) - np.float32(4), 0, 1)
    weight: Floats = flat * turned * other[6]
    return weight


def sampled(
    grid: Grid, x: Floats, y: Floats, position: Floats, normal: Floats, *, least: float = 0.02
) -> tuple[Floats, NDArray[np.bool_]]:
    """Light (n, channels) for points at grid coordinates, from the four nearest grid points of the same surface.

    A point none of whose neighbours is on its surface takes their plain mean.

    Args:
        grid: the light to look up.
        x: column in the grid (n,).
        y: row in the grid (n,).
        position: the points (n, 3) [m].
        normal: their normals (n, 3).
        least: weight below which a point counts as found nowhere.

    Returns:
        the light, and whether it comes from the point's own surface.
    """
    height, width = grid.seen.shape
    x0, y0 = np.floor(x), np.floor(y)
    fx, fy = x - x0, y - y0
    total = np.zeros((len(x), len(grid.light)), np.float32)
    weights = np.zeros(len(x), np.float32)
    for down in (0, 1):
        for across in (0, 1):
            rows = np.clip(y0.astype(np.int32) + down, 0, height - 1)
            columns = np.clip(x0.astype(np.int32) + across, 0, width - 1)
            other = grid.table[rows * width + columns].T
            share = (fx if across else 1 - fx) * (fy if down else 1 - fy) + np.float32(0.02)
            weight = share * _alike(position.T, normal.T, 1 / (np.float32(1.5) * other[7] + np.float32(1e-4)), other)
            weight += share * other[6] * np.float32(1e-4)
            weights += weight
            total += (other[8:] * weight).T
    light = total / np.maximum(weights, np.float32(1e-9))[:, None]
    return np.asarray(light, np.float32), weights > least
