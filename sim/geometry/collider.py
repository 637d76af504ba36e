"""What of a shape collides: hulls with no more corners than every engine takes."""

from functools import lru_cache

import numpy as np
from manifold3d import Manifold
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.scene.asset import Shape
from thinkblox.scene.derived import kept
from thinkblox.value import Vec3

Array = NDArray[np.float64]
MOST_CORNERS = 64
"""Corners of a hull that collides; PhysX cuts off what is beyond."""
_ROUND = 12
"""Ways in which the outermost corners of its flat foot and top are kept."""
_FLAT = 1e-6
"""What is within this of the outermost point lies in one flat side with it [m]."""


def collider(shape: Shape) -> Shape:
    """The shape as it collides: a hull of more than MOST_CORNERS corners has that many of them, others are themselves.

    The corners that are left lie on the hull's own surface, and the hull keeps its extents and its flat sides.
    """
    if shape.kind != "hull" or not shape.collide or len(shape.points) <= MOST_CORNERS:
        return shape
    return _smaller(shape)


@kept
def _smaller(shape: Shape) -> Shape:
    return structs.replace(shape, points=_fewer(shape.points))


@lru_cache(maxsize=4096)
def _fewer(points: tuple[Vec3, ...]) -> tuple[Vec3, ...]:
    """The corners whose hull is nearest to that of all: one after the other, the one furthest outside what is there."""
    given = np.asarray(points, dtype=np.float64)
    chosen = _outermost(given)
    while len(chosen) < MOST_CORNERS:
        outside = _outside(given, given[chosen])
        furthest = int(outside.argmax())
        if outside[furthest] < _FLAT or furthest in chosen:
            break
        chosen.append(furthest)
    return tuple(points[index] for index in sorted(chosen))


def _outermost(points: Array) -> list[int]:
    """Of each side towards one of the six axes, the outermost towards ways that are spread all round."""
    turns = np.arange(_ROUND) * (2 * np.pi / _ROUND)
    ways = np.column_stack([np.cos(turns), np.sin(turns)])
    chosen: dict[int, None] = {}
    for axis in range(3):
        for sign in (-1.0, 1.0):
            reach = sign * points[:, axis]
            side = np.flatnonzero(reach > reach.max() - _FLAT)
            flat = np.delete(points[side], axis, axis=1)
            chosen.update(dict.fromkeys(side[(flat @ (ways if axis == 2 else ways[::3]).T).argmax(axis=0)].tolist()))
    return list(chosen)


def _outside(points: Array, corners: Array) -> Array:
    """How far each point is outside the hull of some corners [m]; less than 0 within."""
    hull = Manifold.hull_points(corners).to_mesh()
    triangles = np.asarray(hull.vert_properties, dtype=np.float64)[:, :3][np.asarray(hull.tri_verts)]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    away: Array = (points @ normals.T - np.einsum("ij,ij->i", normals, triangles[:, 0])).max(axis=1)
    return away
