"""Convex hulls as triangles over their own corners, for files that every engine reads."""

from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256

import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.scene.asset import Shape
from thinkblox.scene.blobs import FOLDER
from thinkblox.sim.render.tessellate import Mesh, capsule, ellipsoid, hull
from thinkblox.value import Vec3

_SIDES = 20
"""Of the prism that stands for a cylinder; MJX warns of faces of more corners."""


@dataclass(frozen=True)
class HullMesh:
    """A convex hull.

    Attributes:
        points: (n, 3), its corners [m], in the order in which they were given.
        faces: (m, 3), counter-clockwise seen from outside.
        normals: (m, 3, 3), of each corner of each face.
    """

    points: NDArray[np.float64]
    faces: NDArray[np.int64]
    normals: NDArray[np.float64]


@lru_cache(maxsize=1024)
def hull_mesh(points: tuple[Vec3, ...], *, smooth: bool) -> HullMesh:
    """The convex hull of points, without those that are no corners; `smooth` is how it is shaded."""
    given, drawn = np.asarray(points, np.float64), hull(points, smooth=smooth)
    corners, same = np.unique(drawn.vertices.astype(np.float64), axis=0, return_inverse=True)
    # What made the triangles may have rounded their corners: they are the points next to these.
    nearest = np.argmin(((corners[:, None] - given[None]) ** 2).sum(axis=2), axis=1)
    used, index = np.unique(nearest[same.reshape(-1)], return_inverse=True)
    faces = index.reshape(-1)[drawn.faces]
    kept = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    return HullMesh(given[used], faces[kept], drawn.normals[drawn.faces][kept].astype(np.float64))


def hull_of(shape: Shape) -> Shape:
    """The hull that stands for a round shape, in its frame: a ball's, stretched to its extents."""
    return _hull_round(shape, ellipsoid(shape.size))


def rod_of(shape: Shape) -> Shape:
    """The hull that stands for a capsule, in its frame."""
    return _hull_round(shape, capsule(shape.size))


def drum_of(shape: Shape) -> Shape:
    """The prism that stands for a cylinder, in its frame; as wide, so that it touches where the cylinder does."""
    x, y, z = (extent / 2 for extent in shape.size)
    turns = [2 * np.pi * k / _SIDES for k in range(_SIDES)]
    points = tuple((float(x * np.cos(t)), float(y * np.sin(t)), h) for t in turns for h in (-z, z))
    return structs.replace(shape, kind="hull", points=points, smooth=True)


def _hull_round(shape: Shape, mesh: Mesh) -> Shape:
    points = np.unique(np.round(mesh.vertices.astype(np.float64), 6), axis=0)
    return structs.replace(shape, kind="hull", points=tuple((x, y, z) for x, y, z in points.tolist()), smooth=True)


@lru_cache(maxsize=1024)
def hull_obj(points: tuple[Vec3, ...], *, smooth: bool) -> tuple[str, bytes]:
    """The path, relative to the model that names it, and the bytes of the OBJ file of a hull."""
    mesh = hull_mesh(points, smooth=smooth)
    normals, index = np.unique(np.round(mesh.normals.reshape(-1, 3), 4) + 0.0, axis=0, return_inverse=True)
    rows = ["v " + " ".join(f"{value:.9g}" for value in point) for point in mesh.points.tolist()]
    rows += ["vn " + " ".join(f"{value:.9g}" for value in normal) for normal in normals.tolist()]
    for face, bent in zip((mesh.faces + 1).tolist(), (index.reshape(-1, 3) + 1).tolist(), strict=True):
        rows.append("f " + " ".join(f"{corner}//{normal}" for corner, normal in zip(face, bent, strict=True)))
    data = ("\n".join(rows) + "\n").encode()
    return f"{FOLDER}/{sha256(data).hexdigest()}.obj", data
