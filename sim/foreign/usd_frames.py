"""Where the prims of a USD stage are, in metres with z up, whatever the stage is in."""

from collections.abc import Container
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray
from pxr import Tf, UsdGeom, UsdPhysics

from thinkblox.errors import InputError
from thinkblox.sim.foreign.usd_values import numbers_of, turn_of

Matrix = NDArray[np.float64]
FURTHEST = 1e9
"""How far away, and how much larger than its own space, anything may be [m]."""
_UPRIGHT = {
    "X": np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]]),
    "Y": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
    "Z": np.eye(3),
}
"""What turns an axis of the stage upwards."""


class Frames:
    """The prims of one stage in the world of the engine.

    Attributes:
        metre: metres of one unit of length of the stage.
        kilogram: kilograms of one unit of mass.
        upright: (3, 3), turns directions of the stage into ours.

    Raises:
        InputError: no axis of the stage is up.
    """

    def __init__(self, stage: Any) -> None:
        self.metre = float(UsdGeom.GetStageMetersPerUnit(stage))
        self.kilogram = float(UsdPhysics.GetStageKilogramsPerUnit(stage))
        up = str(UsdGeom.GetStageUpAxis(stage))
        if up not in _UPRIGHT:
            raise InputError(f"the stage: has {up[:40]!r} up; one of {', '.join(_UPRIGHT)} points upwards")
        self.upright = _UPRIGHT[up]
        self._cache = UsdGeom.XformCache()
        self._ours = np.eye(4)
        self._ours[:3, :3] = self.metre * self.upright

    def world(self, prim: Any) -> Matrix:
        """What brings points of a prim's own space to the world (4, 4), scale and all.

        Raises:
            InputError: its transforms are not made of finite numbers.
        """
        try:
            matrix: Matrix = self._ours @ np.array(self._cache.GetLocalToWorldTransform(prim)).T
        except Tf.ErrorException as error:
            raise InputError(f"{prim.GetPath()}: has a transform that cannot be read") from error
        if not np.isfinite(matrix).all() or np.abs(matrix).max() > FURTHEST:
            raise InputError(f"{prim.GetPath()}: is at a place, or has a scale, that is not made of finite numbers")
        return matrix

    def pose(self, prim: Any) -> Matrix:
        """The frame of a prim without its scale (4, 4): the nearest rotation, and where its origin is [m]."""
        return rigid(self.world(prim))

    def joint(self, joint: Any, end: int, prim: Any) -> Matrix:
        """The frame of a joint on one of its ends (4, 4); of an end without a prim, on the world.

        Raises:
            InputError: it is not made of finite numbers.
        """
        local = _local_frame(joint, end)
        return rigid((self._ours if prim is None else self.world(prim)) @ local)


def rigid(matrix: Matrix) -> Matrix:
    """A matrix with the nearest rotation in place of its linear part (4, 4); a mirrored one counts as turned."""
    left, _, right = np.linalg.svd(matrix[:3, :3])
    if np.linalg.det(left @ right) < 0.0:
        left[:, 2] *= -1.0
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = left @ right, matrix[:3, 3]
    return result


def quat_of(matrix: Matrix) -> Matrix:
    """The rotation of a matrix (3, 3) or (4, 4) as a quaternion, w first."""
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(matrix[:3, :3]).ravel())
    return quat


def owner_of(prim: Any, among: Container[Any]) -> Any:
    """The path of a prim, or of the nearest above it, that is among some; None where there is none."""
    while prim and not prim.IsPseudoRoot():
        if prim.GetPath() in among:
            return prim.GetPath()
        prim = prim.GetParent()
    return None


def _local_frame(joint: Any, end: int) -> Matrix:
    matrix = np.eye(4)
    matrix[:3, :3] = turn_of((joint.GetLocalRot0Attr(), joint.GetLocalRot1Attr())[end])
    matrix[:3, 3] = numbers_of((joint.GetLocalPos0Attr(), joint.GetLocalPos1Attr())[end], (0.0, 0.0, 0.0))
    if not np.isfinite(matrix).all() or np.abs(matrix).max() > FURTHEST:
        raise InputError(f"{joint.GetPath()}: has a frame that is not made of finite numbers")
    return matrix
