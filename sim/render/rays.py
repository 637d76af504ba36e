"""Casting rays at a list of triangles, and the frame of colour, depth and ids that one cast gives."""

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.materials import MATERIALS
from thinkblox.sim.render.soup import SoupTriangles
from thinkblox.sim.render.tessellate import Floats, Ints

T = TypeVar("T")
FAR = np.float32(1e30)
"""Distance of a ray that hits nothing [m]."""


@dataclass(frozen=True)
class Hits:
    """What rays met: face numbers (n,), -1 for nothing; distances (n,) in ray lengths; barycentric (n,) each."""

    face: Ints
    distance: Floats
    u: Floats
    v: Floats


class Tracer:
    """Triangles ready to be met by rays. Glass is kept apart: light passes it."""

    def __init__(self, triangles: SoupTriangles) -> None:
        self.triangles = triangles
        self.corner_normals: Floats = triangles.normals[triangles.faces]
        self.face_normals: Floats = _face_normals(triangles)
        glass = np.array([p.material == MATERIALS.index("glass") for p in triangles.patches], bool)
        clear = glass[triangles.patch]
        self._solid_faces = np.flatnonzero(~clear).astype(np.int32)
        self._glass_faces = np.flatnonzero(clear).astype(np.int32)
        self._solid = _embree(triangles, self._solid_faces)
        self._glass = _embree(triangles, self._glass_faces)

    @property
    def has_glass(self) -> bool:
        """Whether any triangle is of glass."""
        return len(self._glass_faces) > 0

    def solid(self, origins: Floats, directions: Floats) -> Hits:
        """The nearest face that is not of glass along each ray (n, 3)."""
        return _first(self._solid, self._solid_faces, origins, directions)

    def glass(self, origins: Floats, directions: Floats) -> Hits:
        """The nearest face of glass along each ray (n, 3)."""
        return _first(self._glass, self._glass_faces, origins, directions)

    def blocked(self, origins: Floats, directions: Floats, reach: Floats | None = None) -> NDArray[np.bool_]:
        """Whether anything but glass lies along each ray (n, 3), within `reach` (n,) ray lengths when given."""
        if self._solid is None:
            return np.zeros(len(origins), bool)
        hit: NDArray[np.int32] = self._solid.run(origins, directions, dists=reach, query="OCCLUDED")
        return hit >= 0


def _face_normals(triangles: SoupTriangles) -> Floats:
    a, b, c = (triangles.vertices[triangles.faces[:, k]].astype(np.float64) for k in range(3))
    cross = np.cross(b - a, c - a)
    length = np.linalg.norm(cross, axis=1, keepdims=True)
    return np.asarray(cross / np.maximum(length, 1e-30), np.float32)


def _embree(triangles: SoupTriangles, faces: Ints) -> Any:
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    if not len(faces):
        return None
    scene = EmbreeScene()
    TriangleMesh(scene, triangles.vertices, triangles.faces[faces])
    ray = np.zeros((1, 3), np.float32)
    scene.run(ray, ray + np.float32(1), query="OCCLUDED")
    return scene


def _first(scene: Any, faces: Ints, origins: Floats, directions: Floats) -> Hits:
    if scene is None:
        none = np.zeros(len(origins), np.float32)
        return Hits(np.full(len(origins), -1, np.int32), none + FAR, none, none)
    out = scene.run(origins, directions, query="INTERSECT", output=True)
    # The last entry stands for the hit number -1, of what meets nothing.
    return Hits(np.append(faces, np.int32(-1)).take(out["primID"]), out["tfar"], out["u"], out["v"])


def in_parallel(work: Callable[[int], T], items: Iterable[int]) -> list[T]:
    """The results of `work` in order; embree and numpy let the other cores run meanwhile."""
    with ThreadPoolExecutor(min(os.cpu_count() or 1, 8)) as pool:
        return list(pool.map(work, items))
