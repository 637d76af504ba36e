"""Where marks go in a picture so that none hides another, and as little as can be of what is small."""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.tessellate import Ints

Box = tuple[int, int, int, int]
"""left, top, right, bottom [pixels]; the last two are just outside."""
_REACH = (0.07, 0.16, 0.34, 1.0)
"""How far from its object a mark is looked for, in widths of the picture: no farther than need be."""
_SMALL = 90.0
"""Objects of fewer pixels are not covered lightly [pixels]."""
_COVERING = 0.5
"""What covering a small thing whole costs against the distance, for each pixel."""
_STRIDE = 2


@lru_cache(32)
def font(size: int) -> Any:
    """The face that marks are written with."""
    from PIL import ImageFont

    return ImageFont.load_default(size)


@lru_cache(4096)
def text_extent(text: str, size: int) -> tuple[int, int]:
    """Width and height of a text on its chip [pixels]."""
    left, _, right, _ = font(size).getbbox(text)
    return int(np.ceil(right - left)) + 3, size + 1


class Spots:
    """The pixels of a picture that marks have taken, and what the others are worth."""

    def __init__(self, ids: Ints) -> None:
        """Nothing is taken yet; `ids` (size, size) are the numbers of objects, less than 0 for the room."""
        self.taken: NDArray[np.bool_] = np.zeros(ids.shape, bool)
        areas = np.bincount(ids[ids >= 0].ravel(), minlength=1)
        worth = np.append(np.minimum(_SMALL / np.maximum(areas, 1), 1.0), 0.0).astype(np.float32)
        self._worth = _summed(worth[np.where(ids >= 0, ids, -1)])

    def take(self, box: Box) -> None:
        """Take a box for good."""
        left, top, right, bottom = box
        self.taken[max(top, 0) : max(bottom, 0), max(left, 0) : max(right, 0)] = True

    def nearest(self, at: tuple[float, float], extent: tuple[int, int], *, away: float = 0.0) -> Box | None:
        """The free box of some width and height that is nearest to a point, and takes it; None where none is free.

        Args:
            at: the point [pixels].
            extent: width and height of the box [pixels].
            away: how near to the point a box is as good as at it [pixels].
        """
        size, (width, height) = len(self.taken), extent
        for reach in _REACH:
            span = reach * size
            left, top = (max(int(a - span - e / 2), 1) for a, e in zip(at, extent, strict=True))
            right, bottom = (min(int(a + span + e / 2) + 1, size - 1) for a, e in zip(at, extent, strict=True))
            if right - left < width or bottom - top < height:
                continue
            table = _summed(self.taken[top:bottom, left:right])
            x = np.arange(0, right - left - width + 1, _STRIDE)
            y = np.arange(0, bottom - top - height + 1, _STRIDE)
            free = _within(table, x, y, extent) == 0
            if not free.any():
                continue
            off_x, off_y = x + left + width / 2 - at[0], y + top + height / 2 - at[1]
            cost = np.maximum(np.hypot(off_x[None], off_y[:, None]) - away, 0.0)
            cost = cost + _COVERING * _within(self._worth, x + left, y + top, extent)
            row, column = divmod(int(np.argmin(np.where(free, cost, np.inf))), len(x))
            box = (left + int(x[column]), top + int(y[row]), left + int(x[column]) + width, top + int(y[row]) + height)
            self.take(box)
            return box
        return None


def _summed(values: NDArray[Any]) -> NDArray[Any]:
    """The summed-area table of an array, with a row and a column of zeros before it."""
    kind = np.int32 if values.dtype == bool else np.float64
    table = np.zeros((values.shape[0] + 1, values.shape[1] + 1), kind)
    np.cumsum(np.cumsum(values, 0, dtype=kind), 1, out=table[1:, 1:])
    return table


def _within(table: NDArray[Any], x: NDArray[np.int64], y: NDArray[np.int64], extent: tuple[int, int]) -> NDArray[Any]:
    """Sums over boxes of an extent from every pair of left edges and upper edges (len(y), len(x))."""
    width, height = extent
    low, high = table[y], table[y + height]
    found: NDArray[Any] = high[:, x + width] - high[:, x] - low[:, x + width] + low[:, x]
    return found
