"""The primitive shapes of an asset as triangles with shading normals."""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.asset import Shape
from thinkblox.value import Vec3

Floats = NDArray[np.float32]
Ints = NDArray[np.int32]

CREASE = math.radians(50.0)
"""Faces of a smooth hull that meet at less than this angle share their normals [rad]."""
_SOFT = ("fabric", "leather")
_AXES = ((1, 2), (2, 0), (0, 1))


@dataclass(frozen=True)
class Mesh:
    """Triangles, counter-clockwise seen from outside, with one shading normal a vertex.

    Attributes:
        vertices: (n, 3) [m]; a corner between hard faces is listed once for each of them.
        normals: (n, 3), unit length.
        faces: (m, 3) indices into the vertices.
        uv: (n, 2) places in the texture, v upwards; None for what has none.
    """

    vertices: Floats
    normals: Floats
    faces: Ints
    uv: Floats | None = None


def tessellate(shape: Shape) -> Mesh:
    """Triangles of one shape in the shape's own frame; box edges and cylinder rims get a small round."""
    size = shape.size
    if shape.kind == "box":
        return rounded_box(size, edge_radius(size, soft=shape.material in _SOFT))
    if shape.kind == "cylinder":
        return cylinder(size)
    if shape.kind == "capsule":
        return capsule(size)
    if shape.kind == "hull":
        return hull(shape.points, smooth=shape.smooth)
    return ellipsoid(size)


def edge_radius(size: Vec3, *, soft: bool) -> float:
    """Radius of a box's rounded edges [m]: a hard edge catches a little light, a cushion is plump."""
    return min(0.035, 0.3 * min(size)) if soft else min(0.0025, 0.12 * min(size))


def rounded_box(size: Vec3, radius: float) -> Mesh:
    """A box of full extents `size` with edges rounded by `radius`, flat in its faces."""
    signs, normals, faces = _rounded_cube(3 if radius > 0.008 else 1)
    half = np.asarray(size, np.float32) / 2
    return Mesh(signs * (half - np.float32(radius)) + normals * np.float32(radius), normals, faces)


@lru_cache(maxsize=8)
def _rounded_cube(steps: int) -> tuple[Floats, Floats, Ints]:
    """Corner signs, normals and faces of a rounded cube with `steps` facets in each eighth of a turn."""
    arc = [math.tan(math.pi / 4 * i / steps) for i in range(steps, -1, -1)]
    slopes = np.array([-a for a in arc] + arc[::-1])
    sides = np.array([-1.0] * (steps + 1) + [1.0] * (steps + 1))
    count = len(slopes)
    grid = _grid_faces(count, count)
    signs: list[NDArray[np.float64]] = []
    normals: list[NDArray[np.float64]] = []
    faces: list[Ints] = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            u, v = _AXES[axis]
            sign, normal = np.zeros((2, count, count, 3))
            sign[..., axis] = normal[..., axis] = side
            sign[..., u], sign[..., v] = sides[:, None], sides[None, :]
            normal[..., u], normal[..., v] = slopes[:, None], slopes[None, :]
            faces.append((grid if side > 0 else grid[:, ::-1]) + len(faces) * count * count)
            signs.append(sign.reshape(-1, 3))
            normals.append(normal.reshape(-1, 3))
    normal = np.concatenate(normals)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return np.concatenate(signs).astype(np.float32), normal.astype(np.float32), np.concatenate(faces).astype(np.int32)


def _grid_faces(rows: int, columns: int) -> Ints:
    """Two triangles for each cell of a grid of rows x columns vertices."""
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (i * columns + j).ravel()
    b, c, d = a + columns, a + columns + 1, a + 1
    return np.stack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)], 1).reshape(-1, 3).astype(np.int32)


def cylinder(size: Vec3) -> Mesh:
    """A cylinder along z of full extents `size`, elliptic where x and y differ, with slightly rounded rims."""
    half = size[2] / 2
    rim = min(0.004, 0.12 * min(size))
    radius = max(size[0], size[1]) / 2
    inner = 1.0 - rim / radius
    profile = [(inner, -half, -1.0), (1.0, rim - half, 0.0), (1.0, half - rim, 0.0), (inner, half, 1.0)]
    return _revolve(profile, size, _segments(radius))


def capsule(size: Vec3) -> Mesh:
    """A capsule along z of full extents `size`, its caps included."""
    radius = max(size[0], size[1]) / 2
    straight = max(size[2] / 2 - radius, 0.0)
    rings = max(_segments(radius) // 4, 3)
    angles = [math.pi / 2 * (i / rings - 1) for i in range(rings + 1)]
    low = [(math.cos(a), radius * math.sin(a) - straight, math.sin(a)) for a in angles]
    return _revolve(low + [(r, -z, -n) for r, z, n in reversed(low)], size, _segments(radius))


def ellipsoid(size: Vec3) -> Mesh:
    """An ellipsoid or sphere of full extents `size`."""
    around = _segments(max(size) / 2)
    angles = [math.pi * (i / (around // 2) - 0.5) for i in range(around // 2 + 1)]
    unit = _revolve([(math.cos(a), math.sin(a), math.sin(a)) for a in angles], (2.0, 2.0, 2.0), around)
    half: Floats = np.array(size, np.float32) / np.float32(2)
    return Mesh(unit.vertices * half, _unit(unit.vertices / half), unit.faces)


def _segments(radius: float) -> int:
    """How many sides stand for a circle: about a millimetre of sagitta, a multiple of 4."""
    return 4 * int(min(max(math.ceil(math.pi / 4 / math.acos(1.0 - min(0.0006 / radius, 0.05))), 4), 20))


def _revolve(profile: list[tuple[float, float, float]], size: Vec3, around: int) -> Mesh:
    """Turn (radius share, height [m], z of the normal) points, listed upwards, about z; flat caps close the ends."""
    turn = 2.0 * np.pi * np.arange(around) / around
    share, height, up = (np.array(column) for column in zip(*profile, strict=True))
    circle = np.stack([np.cos(turn), np.sin(turn)], 1)
    half = np.array(size[:2]) / 2
    flat = share[:, None, None] * circle * half
    vertices = np.concatenate([flat, np.broadcast_to(height[:, None, None], (*flat.shape[:2], 1))], 2)
    level = np.sqrt(np.maximum(1.0 - up**2, 0.0))
    outward = circle / half
    outward = level[:, None, None] * (outward / np.linalg.norm(outward, axis=1, keepdims=True))
    normals = np.concatenate([outward, np.broadcast_to(up[:, None, None], vertices[..., :1].shape)], 2)
    faces = _tube_faces(len(profile), around)
    poles = np.array([[0.0, 0.0, height[0]], [0.0, 0.0, height[-1]]])
    caps = np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]])
    return Mesh(
        np.concatenate([vertices.reshape(-1, 3), poles]).astype(np.float32),
        _unit(np.concatenate([normals.reshape(-1, 3), caps])),
        faces,
    )


@lru_cache(maxsize=64)
def _tube_faces(rings: int, around: int) -> Ints:
    ring, turn = np.meshgrid(np.arange(rings - 1), np.arange(around), indexing="ij")
    a = (ring * around + turn).ravel()
    b = (ring * around + (turn + 1) % around).ravel()
    c, d = b + around, a + around
    low, high = rings * around, rings * around + 1
    i = np.arange(around)
    j, top = (i + 1) % around, (rings - 1) * around
    caps = [np.stack([j, i, 0 * i + low], 1), np.stack([top + i, top + j, 0 * i + high], 1)]
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1), *caps]).astype(np.int32)


@lru_cache(maxsize=512)
def hull(points: tuple[Vec3, ...], *, smooth: bool) -> Mesh:
    """The convex hull of points; flat faces, or curved shading across edges below the crease angle."""
    from manifold3d import Manifold

    solid: Any = Manifold.hull_points(np.asarray(points, np.float64)).to_mesh()
    vertices = np.asarray(solid.vert_properties, np.float64)[:, :3]
    faces = np.asarray(solid.tri_verts, np.int64)
    corners = vertices[faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = cross / np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-20)
    normals = _creased(faces, corners, flat) if smooth else np.repeat(flat, 3, axis=0)
    index = np.arange(3 * len(faces), dtype=np.int32).reshape(-1, 3)
    return Mesh(corners.reshape(-1, 3).astype(np.float32), _unit(normals), index)


def _creased(faces: NDArray[np.int64], corners: NDArray[np.float64], flat: NDArray[np.float64]) -> NDArray[np.float64]:
    """Corner normals: the neighbours within the crease angle, weighted by the angle they take up at the corner."""
    weight = np.zeros((int(faces.max()) + 1, len(faces)))
    for k in range(3):
        a, b = corners[:, (k + 1) % 3] - corners[:, k], corners[:, (k + 2) % 3] - corners[:, k]
        cosine = (a * b).sum(1) / np.maximum(np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1), 1e-20)
        weight[faces[:, k], np.arange(len(faces))] = np.arccos(np.clip(cosine, -1.0, 1.0))
    near = np.repeat(flat @ flat.T > math.cos(CREASE), 3, axis=0)
    total: NDArray[np.float64] = (weight[faces.ravel()] * near) @ flat
    return total


def _unit(vectors: NDArray[Any]) -> Floats:
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.asarray(vectors / np.maximum(length, 1e-20), np.float32)
