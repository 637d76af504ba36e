"""A grid of metres on the floor of a room, with their numbers along its walls."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.room import Room
from thinkblox.sim.render.layers import Viewpoint
from thinkblox.sim.render.spots import Box, text_extent
from thinkblox.value import Vec2, Vec3

_STEPS = (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0)
_APART = 2.1
"""Least distance of two numbers, in widths of one."""


@dataclass(frozen=True)
class MetreGrid:
    """The grid of one view, the same whatever stands in the room.

    Attributes:
        lines: pixels that lines run through (size, size); they are drawn where the floor is seen.
        numbers: each text, its box and its colour: those along x in one, those along y in another.
        step: metres between two lines.
    """

    lines: NDArray[np.bool_]
    numbers: tuple[tuple[str, Box, tuple[int, int, int]], ...]
    step: float


_ALONG_X, _ALONG_Y = (166, 44, 28), (24, 84, 150)


@lru_cache(64)
def metre_grid(room: Room, view: Viewpoint, size: int, font: int) -> MetreGrid:
    """The grid of a room in a view; lines are as far apart as leaves room for their numbers."""
    from PIL import Image, ImageDraw

    width, depth = room.extent
    eye = view.camera.position
    near_x = 0.0 if view.azimuth is None or eye[0] < width / 2 else width
    near_y = 0.0 if view.azimuth is None or eye[1] < depth / 2 else depth
    apart = _APART * text_extent("x10", font)[0]
    step = next((s for s in _STEPS if _spacing(room, view, (near_x, near_y), s) * size > apart), _STEPS[-1])
    sheet = Image.new("L", (size, size))
    draw = ImageDraw.Draw(sheet)
    numbers: list[tuple[str, Box, tuple[int, int, int]]] = []
    for axis, (length, colour) in enumerate(((width, _ALONG_X), (depth, _ALONG_Y))):
        for number in range(int(length / step + 1e-6) + 1):
            at = number * step
            start, end = ((at, 0.0), (at, depth)) if axis == 0 else ((0.0, at), (width, at))
            if 0.0 < at < length:
                draw.line([_pixel(view, (*start, 0.0), size), _pixel(view, (*end, 0.0), size)], fill=255)
            edge = (at, near_y) if axis == 0 else (near_x, at)
            inner = (at, depth / 2) if axis == 0 else (width / 2, at)
            text = f"{'xy'[axis]}{at:g}"
            numbers.append((text, _beside(view, edge, inner, text_extent(text, font), size), colour))
    return MetreGrid(np.asarray(sheet) > 0, tuple(numbers), step)


def _spacing(room: Room, view: Viewpoint, near: Vec2, step: float) -> float:
    """The least distance of two neighbouring numbers, in widths of the picture."""
    width, depth = room.extent
    found = []
    for start, way in (((0.0, near[1]), (1.0, 0.0)), ((near[0], 0.0), (0.0, 1.0))):
        for at in (0.0, max(width * way[0] + depth * way[1] - step, 0.0)):
            ends = [(start[0] + way[0] * (at + more), start[1] + way[1] * (at + more), 0.0) for more in (0.0, step)]
            a, b = view.camera.project(np.array(ends), 1)
            found.append(float(np.hypot(*(a - b))))
    return min(found)


def _beside(view: Viewpoint, edge: Vec2, inner: Vec2, extent: tuple[int, int], size: int) -> Box:
    """The box of a text just outside the room, beside a point of its edge."""
    (x, y), (ix, iy) = _pixel(view, (*edge, -0.1), size), _pixel(view, (*inner, -0.1), size)
    away = np.array([x - ix, y - iy])
    away /= max(float(np.hypot(*away)), 1e-9)
    reach = min((extent[0] / 2 + 3) / max(abs(away[0]), 1e-6), (extent[1] / 2 + 3) / max(abs(away[1]), 1e-6))
    rim = 0.016 * size
    cx, cy = x + away[0] * (reach + rim), y + away[1] * (reach + rim)
    left = int(np.clip(round(cx - extent[0] / 2), 0, size - extent[0]))
    top = int(np.clip(round(cy - extent[1] / 2), 0, size - extent[1]))
    return left, top, left + extent[0], top + extent[1]


def _pixel(view: Viewpoint, point: Vec3, size: int) -> tuple[float, float]:
    x, y = view.camera.project(np.array([point]), size)[0]
    return float(x), float(y)
