"""What a picture's rays see: places, normals and patches, with glass in front of them."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.materials import MATERIALS
from thinkblox.sim.render.rays import FAR, Tracer, in_parallel
from thinkblox.sim.render.soup import SoupTriangles
from thinkblox.sim.render.tessellate import Floats, Ints
from thinkblox.sim.render.vectors import dot, length, scaled

BAND = 1 << 15
"""Rays that are handled at a time, so that their arrays stay in the cache."""


@dataclass(frozen=True)
class Surfels:
    """Seen points, one for each ray.

    Attributes:
        patch: number of the patch, -1 where the ray leaves the scene (n,).
        position, normal, facing: point [m], shading normal and the triangle's normal, both towards the eye (n, 3).
        view: unit direction of the ray (n, 3).
        distance: along the ray [m], FAR where it leaves the scene (n,).
        clear: share of the light that passes the glass in front (n, 3), None without glass.
        front: number of the first patch, glass included (n,).
        uv: places in textures (n, 2), None where nothing in the scene has any.
    """

    patch: Ints
    position: Floats
    normal: Floats
    facing: Floats
    view: Floats
    distance: Floats
    front: Ints
    clear: Floats | None = None
    shine: Floats | None = None
    uv: Floats | None = None

    def __getitem__(self, pick: NDArray[np.int64] | NDArray[np.bool_] | slice) -> "Surfels":
        """Some of the points."""
        if isinstance(pick, slice) or pick.dtype == bool:
            return Surfels(**{name: values[pick] for name, values in _columns(self)})
        return Surfels(**{name: values.take(pick, 0) for name, values in _columns(self)})


def see(tracer: Tracer, camera: Camera, x: Floats, y: Floats, size: int) -> Surfels:
    """What rays through pixel coordinates (n,) of a picture `size` wide meet, worked on by all cores."""
    whole = see_part(tracer, camera, x[:BAND], y[:BAND], size)
    if len(x) <= BAND:
        return whole
    columns = {name: np.empty((len(x), *first.shape[1:]), first.dtype) for name, first in _columns(whole)}

    def fill(at: int) -> None:
        band = slice(at, at + BAND)
        for name, values in _columns(see_part(tracer, camera, x[band], y[band], size)):
            columns[name][band] = values

    in_parallel(fill, range(0, len(x), BAND))
    return Surfels(**columns)


def _columns(points: Surfels) -> list[tuple[str, NDArray[Any]]]:
    named = [(name, getattr(points, name)) for name in Surfels.__dataclass_fields__]
    return [(name, values) for name, values in named if values is not None]


def see_part(tracer: Tracer, camera: Camera, x: Floats, y: Floats, size: int) -> Surfels:
    """The same on one core."""
    origins, directions = camera.rays(x, y, size)
    hits = tracer.solid(origins, directions)
    missed = hits.face < 0
    face = np.maximum(hits.face, 0).astype(np.int64)
    distance = np.where(missed, FAR, hits.distance)
    normal, facing = _normals(tracer, face, hits.u, hits.v, directions)
    patch = np.where(missed, np.int32(-1), tracer.triangles.patch.take(face))
    position = origins + scaled(directions, np.where(missed, np.float32(0), hits.distance))
    front, clear, shine = patch, None, None
    if tracer.has_glass:
        front, clear, shine = _through_glass(tracer, origins, directions, distance, patch)
    uv = _uv(tracer.triangles, face, hits.u, hits.v)
    return Surfels(patch, position, normal, facing, directions, distance, front, clear, shine, uv)


def _uv(triangles: SoupTriangles, face: NDArray[np.int64], u: Floats, v: Floats) -> Floats | None:
    if triangles.uv is None:
        return None
    corners = triangles.uv.take(triangles.faces.take(face, 0), 0)
    found: Floats = corners[:, 0] * (1 - u - v)[:, None] + corners[:, 1] * u[:, None] + corners[:, 2] * v[:, None]
    return found


def _normals(
    tracer: Tracer, face: Ints | NDArray[np.int64], u: Floats, v: Floats, view: Floats
) -> tuple[Floats, Floats]:
    corners = tracer.corner_normals.take(face, 0)
    facing = tracer.face_normals.take(face, 0)
    facing = scaled(facing, np.where(dot(facing, view) > 0, np.float32(-1), np.float32(1)))
    w, normal = 1 - u - v, np.empty_like(facing)
    for axis in range(3):
        normal[:, axis] = corners[:, 0, axis] * w + corners[:, 1, axis] * u + corners[:, 2, axis] * v
    side = np.where(dot(normal, facing) < 0, np.float32(-1), np.float32(1))
    shrink = np.asarray(side / np.maximum(length(normal), np.float32(1e-20)), np.float32)
    return scaled(normal, shrink), facing


def _through_glass(
    tracer: Tracer, origins: Floats, directions: Floats, distance: Floats, patch: Ints
) -> tuple[Ints, Floats, Floats]:
    """The first patch with glass counted, what the glass lets through, and the shine it adds (two layers)."""
    clear = np.ones((len(origins), 3), np.float32)
    shine = np.zeros(len(origins), np.float32)
    front = patch.copy()
    colours = np.array([p.colour for p in tracer.triangles.patches], np.float32)
    start = np.zeros(len(origins), np.float32)
    todo = np.arange(len(origins))
    for layer in range(2):
        from_here = origins if layer == 0 else origins[todo] + directions[todo] * start[todo, None]
        hits = tracer.glass(from_here, directions if layer == 0 else directions[todo])
        start[todo] += np.where(hits.face < 0, FAR, hits.distance) + np.float32(1e-4)
        seen = start[todo] < distance[todo]
        todo, face = todo[seen], hits.face[seen]
        number = tracer.triangles.patch[face]
        normal, _ = _normals(tracer, face, hits.u[seen], hits.v[seen], directions[todo])
        cosine = np.abs(dot(normal, directions[todo]))
        edge = np.float32(0.05) + np.float32(0.95) * (1 - cosine) ** 5
        clear[todo] *= scaled(np.float32(0.62) + np.float32(0.36) * colours[number], 1 - edge)
        shine[todo] += edge * (1 + normal[:, 2]) * np.float32(0.45) * (1.0 if layer == 0 else 0.5)
        front[todo] = np.where(front[todo] == patch[todo], number, front[todo]) if layer == 0 else front[todo]
    return front, clear, shine


def is_material(triangles: SoupTriangles, name: str) -> NDArray[np.bool_]:
    """For each patch, whether it is made of a material."""
    return np.array([p.material == MATERIALS.index(name) for p in triangles.patches], bool)
