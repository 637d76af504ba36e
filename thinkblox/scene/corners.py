"""The corners of shapes: points whose hull is the shape, or a prism round it; and how a shape is turned."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from thinkblox.scene.asset import Shape

_ROUND = 24
"""Corners that stand for a circle."""


def corners_of(shape: "Shape") -> NDArray[np.float64]:
    """Points of the asset's frame whose hull is the shape, or for round ones the prism round it, in rows [m]."""
    if shape.kind == "hull":
        local = np.array(shape.points)
    else:
        x, y, z = (extent / 2 for extent in shape.size)
        turns = [2 * np.pi * k / _ROUND for k in range(_ROUND)]
        ring = [(x * np.cos(t), y * np.sin(t)) for t in turns]
        ring = [(-x, -y), (x, -y), (x, y), (-x, y)] if shape.kind == "box" else ring
        local = np.array([(a, b, c) for a, b in ring for c in (-z, z)])
    turned: NDArray[np.float64] = local @ rotation(shape.quat_wxyz).T + np.array(shape.position)
    return turned


def rotation(quat_wxyz: Sequence[float] | NDArray[np.float64]) -> NDArray[np.float64]:
    """The 3x3 matrix of a unit quaternion."""
    w, x, y, z = quat_wxyz
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
