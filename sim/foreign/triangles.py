"""The colliding geometry of a compiled model as triangles in the world's frame, for what is measured on meshes."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.subject import Thing

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
CHORD = 0.001
"""A round shape's triangles lie at most this far inside it [m]."""
MOST_SIDES = 512
"""Of the polygon that stands for a circle, however large."""
_SKIPPED = (int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD))
_CORNERS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
_BOX = np.array(
    [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
     [1, 5, 7], [1, 7, 3]], np.int32,
)  # fmt: skip


@dataclass(frozen=True)
class Triangles:
    """A triangle mesh in the world's frame, counter-clockwise seen from outside.

    Attributes:
        vertices: (n, 3) [m].
        faces: (m, 3) indices into the vertices.
    """

    vertices: Floats
    faces: Ints

    @cached_property
    def corners(self) -> Floats:
        """The three corners of every triangle [m], shape (m, 3, 3)."""
        picked: Floats = self.vertices[self.faces]
        return picked

    @cached_property
    def crosses(self) -> Floats:
        """The normal of every triangle, twice its area long [m2], shape (m, 3)."""
        a, b, c = (self.corners[:, k] for k in range(3))
        return np.asarray(np.cross(b - a, c - a), np.float64)

    @cached_property
    def areas(self) -> Floats:
        """Area of every triangle [m2], shape (m,)."""
        return np.asarray(np.linalg.norm(self.crosses, axis=1) / 2, np.float64)

    @cached_property
    def centroid(self) -> Floats:
        """Centre of the surface [m]: of the triangles, weighted by area."""
        return np.asarray(np.average(self.corners.mean(axis=1), axis=0, weights=self.areas + 1e-30), np.float64)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner of its bounding box [m]."""
        return self.vertices.min(axis=0), self.vertices.max(axis=0)

    @property
    def empty(self) -> bool:
        """Whether there is nothing to be measured."""
        return not len(self.faces)

    def sample(self, count: int, generator: np.random.Generator) -> Floats:
        """Points spread evenly over the surface [m], shape (count, 3)."""
        chosen = generator.choice(len(self.faces), size=count, p=self.areas / self.areas.sum())
        u, v = generator.random((2, count, 1))
        folded = u + v > 1.0
        u, v = np.where(folded, 1.0 - u, u), np.where(folded, 1.0 - v, v)
        a, b, c = (self.corners[chosen, k] for k in range(3))
        return np.asarray(a + u * (b - a) + v * (c - a), np.float64)


def colliding(model: mujoco.MjModel) -> NDArray[np.bool_]:
    """Which geoms can take part in a contact: by their bits, or by an explicit pair; shape (ngeom,)."""
    found = (model.geom_contype != 0) | (model.geom_conaffinity != 0)
    found[model.pair_geom1], found[model.pair_geom2] = True, True
    return np.asarray(found, np.bool_)


def triangles_of(model: mujoco.MjModel, data: mujoco.MjData, thing: Thing) -> Triangles:
    """What of a thing can be touched, at the poses in `data`; empty when nothing can."""
    mine = np.isin(model.geom_bodyid, thing.bodies) & colliding(model)
    return geom_triangles(model, data, np.flatnonzero(mine).tolist())


def geom_triangles(
    model: mujoco.MjModel, data: mujoco.MjData, geoms: Iterable[int], *, plane: float | None = None
) -> Triangles:
    """Geoms as the engine collides with them: meshes by their convex hull, an SDF by its mesh.

    Args:
        model: compiled.
        data: with the poses of the geoms.
        geoms: indices; height fields are left out.
        plane: half the side of the square that stands for an infinite plane [m]; None leaves planes out.
    """
    vertices, faces, count = [np.zeros((0, 3))], [np.zeros((0, 3), np.int32)], 0
    for geom in geoms:
        local = _local(model, geom, plane)
        if local is None:
            continue
        turned = local.vertices @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
        vertices.append(turned)
        faces.append(local.faces + np.int32(count))
        count += len(turned)
    return Triangles(np.vstack(vertices), np.vstack(faces))


def first_hits(target: Triangles, origins: Floats, direction: Floats) -> Floats:
    """Distance from each origin (n, 3) along a unit vector to the first triangle [m]; inf where there is none."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    if target.empty or not len(origins):
        return np.full(len(origins), np.inf)
    middle = origins.mean(axis=0)
    scene = EmbreeScene()
    TriangleMesh(scene, (target.vertices - middle).astype(np.float32), target.faces)
    starts = np.ascontiguousarray(origins - middle, np.float32)
    towards = np.ascontiguousarray(np.broadcast_to(direction, starts.shape), np.float32)
    out = scene.run(starts, towards, query="INTERSECT", output=True)
    return np.asarray(np.where(out["primID"] >= 0, out["tfar"], np.inf), np.float64)


def collision_model(triangles: Triangles) -> Any:
    """The mesh for the fcl library's yes-or-no questions: a bounding volume hierarchy of its triangles."""
    import fcl

    model = fcl.BVHModel()
    model.beginModel(len(triangles.vertices), len(triangles.faces))
    model.addSubModel(triangles.vertices, triangles.faces)
    model.endModel()
    return model


def _local(model: mujoco.MjModel, geom: int, plane: float | None) -> Triangles | None:
    """One geom in its own frame; None when it has no triangles."""
    kind, size = int(model.geom_type[geom]), np.asarray(model.geom_size[geom], np.float64)
    if kind in _SKIPPED:
        return _square(plane) if plane is not None and kind == _SKIPPED[0] else None
    if kind in (int(mujoco.mjtGeom.mjGEOM_MESH), int(mujoco.mjtGeom.mjGEOM_SDF)):
        return _mesh(model, int(model.geom_dataid[geom]), exact=kind == int(mujoco.mjtGeom.mjGEOM_SDF))
    if kind == int(mujoco.mjtGeom.mjGEOM_BOX):
        return Triangles(_CORNERS * size, _BOX)
    if kind == int(mujoco.mjtGeom.mjGEOM_CYLINDER):
        return _revolved([(size[0], -size[1]), (size[0], size[1])], sides(size[0]))
    if kind == int(mujoco.mjtGeom.mjGEOM_CAPSULE):
        return _ball((size[0], size[0], size[0]), straight=float(size[1]))
    if kind == int(mujoco.mjtGeom.mjGEOM_SPHERE):
        return _ball((size[0], size[0], size[0]))
    return _ball((size[0], size[1], size[2]))


def sides(radius: float, chord: float = CHORD) -> int:
    """Sides, a multiple of 4, of a polygon in a circle that stays within `chord` [m] of it."""
    turn = 2.0 * math.acos(1.0 - min(chord / max(radius, 1e-9), 0.3))
    return min(4 * max(2, math.ceil(math.pi / 2 / turn)), MOST_SIDES)


def _ball(radii: tuple[float, float, float], straight: float = 0.0) -> Triangles:
    """An ellipsoid, or a capsule whose cylinder is 2 `straight` long [m]."""
    around = sides(max(radii), CHORD / 2)
    rings = around // 4
    levels = [math.pi / 2 * (k / rings - 1) for k in range(1, rings + 1)]
    low = [(math.cos(t), math.sin(t)) for t in levels]
    high = [(r, -z) for r, z in reversed(low)]
    unit = _revolved([*low, *(high if straight else high[1:])], around, poles=(-1.0, 1.0))
    scaled = unit.vertices * radii
    if straight:
        scaled[: rings * around, 2] -= straight
        scaled[rings * around : 2 * rings * around, 2] += straight
        scaled[-2:, 2] += (-straight, straight)
    return Triangles(scaled, unit.faces)


def _revolved(profile: list[tuple[float, float]], around: int, poles: tuple[float, float] | None = None) -> Triangles:
    """(radius, height) points [m], listed upwards, turned about z and closed at both ends."""
    turn = 2.0 * np.pi * np.arange(around) / around
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    rings = [np.column_stack([radius * circle, np.full(around, height)]) for radius, height in profile]
    bottom, top = poles or (profile[0][1], profile[-1][1])
    vertices = np.vstack([*rings, [[0.0, 0.0, bottom], [0.0, 0.0, top]]])
    i, j = np.arange(around), (np.arange(around) + 1) % around
    last, count = (len(profile) - 1) * around, len(vertices)
    faces = [np.column_stack([np.full(around, count - 2), j, i])]
    for k in range(len(profile) - 1):
        a, b = k * around, (k + 1) * around
        faces += [np.column_stack([i + a, j + a, j + b]), np.column_stack([i + a, j + b, i + b])]
    faces.append(np.column_stack([np.full(around, count - 1), i + last, j + last]))
    return Triangles(vertices, np.vstack(faces).astype(np.int32))


def _square(half: float) -> Triangles:
    corners = np.array([[-half, -half, 0.0], [half, -half, 0.0], [half, half, 0.0], [-half, half, 0.0]])
    return Triangles(corners, np.array([[0, 1, 2], [0, 2, 3]], np.int32))


def _mesh(model: mujoco.MjModel, mesh: int, *, exact: bool) -> Triangles | None:
    """A mesh's convex hull, or its own faces when it is collided with exactly or is flat."""
    from manifold3d import Manifold

    start, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    points = np.asarray(model.mesh_vert[start : start + count], np.float64)
    if not exact:
        hull = Manifold.hull_points(points).to_mesh()
        if len(hull.tri_verts):
            return Triangles(np.asarray(hull.vert_properties[:, :3], np.float64), np.asarray(hull.tri_verts, np.int32))
    first, number = int(model.mesh_faceadr[mesh]), int(model.mesh_facenum[mesh])
    return Triangles(points, np.asarray(model.mesh_face[first : first + number], np.int32)) if number else None
