"""Rotations between other people's axes and ours.

Ours: z up, x east, y north; an object's own frame has x to its front, y to its left. All matrices are 3x3, for columns.
"""

import math
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.corners import rotation

Array = NDArray[np.float64]

Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From right-handed y-up axes (glTF, USD, 3D-FRONT) to ours: x stays, z comes towards the reader, that is south."""
UNITY = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
"""From Unity's left-handed y-up axes to ours: x stays, z goes north. A reflection, as it must be."""
OWN_FROM_Y_UP = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Into an object's own frame, from right-handed y-up axes in which it faces +z (glTF, 3D-FUTURE): its left is +x."""
OWN_FROM_Z_UP = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
"""Into its own frame, from z-up axes in which it faces -y, as Blender shows what faces +z in a glTF: its left is +x."""
OWN_FROM_UNITY = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Into its own frame, from Unity's left-handed axes in which it faces +z: its right is +x."""
LEVEL = 1e-6
"""A turn that leaves the vertical this nearly upright is taken for a pure yaw [rad]."""


def about(axis: Literal["x", "y", "z"], degrees: float) -> Array:
    """The right-hand turn about an axis; with left-handed axes the same matrix is the left-hand one."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    first = {"x": 0, "y": 1, "z": 2}[axis]
    i, j = (first + 1) % 3, (first + 2) % 3
    matrix = np.eye(3)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
    return matrix


def own_from_file(file: Path) -> Array:
    """The map from a mesh file's axes into the object's own frame: glTF and OBJ are y-up, STL and PLY z-up.

    As Blender opens them, which all these projects build their scenes with: what faces +z in a glTF or OBJ, or -y in
    an STL or PLY, faces the viewer.
    """
    return OWN_FROM_Z_UP if file.suffix.lower() in (".stl", ".ply") else OWN_FROM_Y_UP


def from_quaternion(xyzw: tuple[float, float, float, float]) -> Array:
    """The rotation of a quaternion of any length but 0, its real part last."""
    x, y, z, w = np.asarray(xyzw) / np.linalg.norm(xyzw)
    return rotation((w, x, y, z))


def split_yaw(linear: Array) -> tuple[float, Array]:
    """Yaw [degrees, 0 to 360) of what a linear map makes of the front, and what is left of the map before that turn.

    The rest is exactly the identity where it is one but for rounding. A front that ends up vertical has yaw 0.
    """
    x, y, z = linear[:, 0]
    flat = math.hypot(x, y) > LEVEL * max(abs(z), 1e-12)
    yaw = math.degrees(math.atan2(y, x)) % 360.0 if flat else 0.0
    yaw = round(yaw, 9) % 360.0
    rest = about("z", -yaw) @ linear
    if np.abs(rest - np.eye(3)).max() < LEVEL:
        return yaw, np.eye(3)
    return yaw, rest
