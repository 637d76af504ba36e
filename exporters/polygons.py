"""Shapes as they are seen: polygons with normals, in the frame that a shape's pose is given in."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.asset import Shape
from thinkblox.scene.corners import rotation
from thinkblox.sim.render.tessellate import Mesh, capsule, cylinder, ellipsoid, hull
from thinkblox.value import Vec3

Floats = NDArray[np.float64]
_CUBE = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_SIDES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
"""Corners of each side of the cube, counter-clockwise seen from outside: -x, x, -y, y, -z, z."""


@dataclass(frozen=True)
class Polygons:
    """Flat or curved polygons with a normal a vertex, in the frame of their prim [m], and places in a texture."""

    points: NDArray[Any]
    normals: NDArray[Any]
    counts: list[int]
    indices: list[int]
    uv: NDArray[Any] | None = None

    @property
    def triangles(self) -> NDArray[np.int64]:
        """The polygons, three or four corners each, as triangles (m, 3)."""
        index = np.asarray(self.indices)
        if 4 not in self.counts:
            return index.reshape(-1, 3)
        return index.reshape(-1, 4)[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)


def _box_polygons(size: Vec3, centre: Vec3, turn: Floats) -> Polygons:
    """Six quadrilaterals; `turn` is the 3x3 matrix of the box's orientation."""
    corners = (_CUBE * size) @ turn.T + centre
    outward = np.vstack([sign * turn[:, axis] for axis in range(3) for sign in (-1.0, 1.0)])
    return Polygons(corners[np.ravel(_SIDES)], np.repeat(outward, 4, axis=0), [4] * 6, list(range(24)))


def placed(shape: Shape) -> Polygons:
    """A shape in the frame that its pose is given in; boxes are made of quadrilaterals."""
    turn = rotation(shape.quat_wxyz)
    if shape.kind == "box":
        return _box_polygons(shape.size, shape.position, turn)
    mesh = _rounded(shape)
    points = mesh.vertices.astype(np.float64) @ turn.T + shape.position
    return Polygons(points, mesh.normals @ turn.T, [3] * len(mesh.faces), mesh.faces.ravel().tolist())


def _rounded(shape: Shape) -> Mesh:
    if shape.kind == "hull":
        return hull(shape.points, smooth=shape.smooth)
    return {"cylinder": cylinder, "capsule": capsule}.get(shape.kind, ellipsoid)(shape.size)
