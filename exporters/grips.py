"""Where a hand takes hold: of doors and drawers, and of what is small enough to be picked up."""

import math

import numpy as np
from numpy.typing import NDArray

from thinkblox.exporters.inventory import InventoryBody
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.corners import corners_of
from thinkblox.value import Quat, Vec3

WIDEST = 0.08
"""What a common gripper opens to [m]."""
_SMALL = 0.5
"""How large a part of a door or drawer can be to be its handle, as a share of its largest."""


def handle_of(body: InventoryBody) -> Vec3 | None:
    """Where one pulls a door or drawer, in its body's frame [m]; None for what has no joint or cannot be touched.

    It is the middle of the part that stands out furthest the way it opens, such as a bar or a knob; where there is no
    such part, of a door the middle of the edge opposite the hinge, of a drawer the middle of its front.
    """
    shapes = [geom.shape for geom in body.geoms if geom.collides and geom.shape is not None]
    if body.joint is None or not shapes:
        return None
    opens = _opening(body, shapes)
    largest = max(_volume(shape) for shape in shapes)
    small = [shape for shape in shapes if _volume(shape) < _SMALL * largest]
    reach = {id(shape): float((corners_of(shape) @ opens).max()) for shape in shapes}
    furthest = max(reach.values())
    bars = [shape for shape in small if reach[id(shape)] > furthest - 1e-3]
    if bars:
        corners = np.vstack([corners_of(shape) for shape in bars])
        return _vec3((corners.min(axis=0) + corners.max(axis=0)) / 2)
    corners = np.vstack([corners_of(shape) for shape in shapes])
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    edge = middle + opens * (furthest - middle @ opens)
    if body.joint.kind == "hinge":
        axis = np.asarray(body.joint.axis)
        away = middle - axis * (axis @ middle) - opens * (opens @ middle)
        along = away / max(float(np.linalg.norm(away)), 1e-12)
        edge = edge + along * (float((corners @ along).max()) - middle @ along)
    return _vec3(np.clip(edge, corners.min(axis=0), corners.max(axis=0)))


def _opening(body: InventoryBody, shapes: list[Shape]) -> NDArray[np.float64]:
    """The unit vector along which the body's middle begins to move as it opens, in its frame."""
    assert body.joint is not None
    axis, sign = np.asarray(body.joint.axis), 1.0 if body.joint.upper > -body.joint.lower else -1.0
    if body.joint.kind == "slide":
        return sign * axis
    corners = np.vstack([corners_of(shape) for shape in shapes])
    way = np.cross(axis, (corners.min(axis=0) + corners.max(axis=0)) / 2)
    unit: NDArray[np.float64] = sign * way / max(float(np.linalg.norm(way)), 1e-12)
    return unit


def grasp_of(asset: Asset) -> tuple[Vec3, Quat] | None:
    """Where and how a gripper takes a small thing from above, in its frame; None for what is too wide or cannot move.

    The pose has z up and y across the narrower way, along which the fingers close.
    """
    x, y, z = asset.size
    if not asset.free or min(x, y) > WIDEST:
        return None
    half = math.pi / 4
    turn: Quat = (1.0, 0.0, 0.0, 0.0) if y <= x else (math.cos(half), 0.0, 0.0, math.sin(half))
    return (0.0, 0.0, z / 2), turn


def _volume(shape: Shape) -> float:
    return float(np.prod(shape.size))


def _vec3(values: NDArray[np.float64]) -> Vec3:
    x, y, z = values.tolist()
    return (x, y, z)
