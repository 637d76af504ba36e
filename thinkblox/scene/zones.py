"""Floor by the sides of boxes, and how much of it is taken."""

import numpy as np

from thinkblox.scene.rectangles import Array, Rects

_AXES: dict[str, tuple[int, int]] = {"front": (0, 1), "back": (0, -1), "left": (1, 1), "right": (1, -1)}
"""The axis of a box, and the way along it, that leads out of each side."""


def beside(rects: Rects, side: str, depth: float, *, width: float | None = None) -> Rects:
    """The floor by one side of each box: `depth` out, as wide as it or `width` [m]."""
    axis, sign = _AXES[side]
    out = rects.axes[:, axis] * sign
    centre = rects.centre + out * (rects.half[:, axis, None] + depth / 2)
    half = rects.half.copy()
    half[:, axis] = depth / 2
    if width is not None:
        half[:, 1 - axis] = width / 2
    return Rects(centre, half, rects.yaw, np.full(len(rects), 0.05), np.full(len(rects), 1.6))


def joined(parts: list[Rects]) -> Rects:
    """Several sets of boxes as one."""
    if not parts:
        return Rects.of([])
    return Rects(
        np.concatenate([p.centre for p in parts]),
        np.concatenate([p.half for p in parts]),
        np.concatenate([p.yaw for p in parts]),
        np.concatenate([p.bottom for p in parts]),
        np.concatenate([p.top for p in parts]),
    )


def fewest(missing: list[Array], number: int) -> Array:
    """Sum of the `number` smallest of several costs, box by box."""
    return np.asarray(np.sort(missing, axis=0)[:number].sum(axis=0))
