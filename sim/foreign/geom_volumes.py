"""Geoms of a compiled model as solids: what they share, what they fill, and where they are lowest."""

import math

import mujoco
import numpy as np
from manifold3d import Manifold, OpType
from numpy.typing import NDArray

from thinkblox.sim.foreign.triangles import colliding

Array = NDArray[np.float64]
SIDES = 48
"""Of the polygon that stands for a circle; what it cuts off is given back by widening it."""
_TYPE = mujoco.mjtGeom
_PLANE, _BOX, _MESH, _SDF, _HFIELD = (
    int(kind)
    for kind in (_TYPE.mjGEOM_PLANE, _TYPE.mjGEOM_BOX, _TYPE.mjGEOM_MESH, _TYPE.mjGEOM_SDF, _TYPE.mjGEOM_HFIELD)
)
_SPHERE, _CAPSULE, _CYLINDER = (
    int(kind) for kind in (_TYPE.mjGEOM_SPHERE, _TYPE.mjGEOM_CAPSULE, _TYPE.mjGEOM_CYLINDER)
)


class Volumes:
    """What the owners of a model's geoms fill at one state, each worked out when it is first asked for.

    Meshes are their convex hulls, as the engine collides them; geoms that cannot collide are nothing, and height
    fields are left out.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, owner_of_geom: NDArray[np.int64]) -> None:
        self._model, self._data = model, data
        self._owners = np.where(colliding(model), owner_of_geom, -1)
        self._solids: dict[int, Manifold] = {}

    def overlap(self, first: int, second: int) -> float:
        """Share of the first owner's volume that is inside the second, 0 to 1."""
        mine = self.solid(first)
        volume = float(mine.volume())
        if volume <= 0.0:
            return 0.0
        shared = float((mine ^ self.solid(second)).volume()) + sum(
            self._below(mine, geom) for geom in self._geoms(second) if int(self._model.geom_type[geom]) == _PLANE
        )
        return min(1.0, max(0.0, shared) / volume)

    def solid(self, owner: int) -> Manifold:
        """The union of an owner's geoms, planes left out, in the world's frame."""
        if owner not in self._solids:
            parts = [part for geom in self._geoms(owner) if (part := self._placed(geom)) is not None]
            self._solids[owner] = Manifold.batch_boolean(parts, OpType.Add) if parts else Manifold()
        return self._solids[owner]

    def _geoms(self, owner: int) -> list[int]:
        geoms: list[int] = np.flatnonzero(self._owners == owner).tolist()
        return geoms

    def _placed(self, geom: int) -> Manifold | None:
        local = _local(self._model, geom)
        if local is None:
            return None
        turn, position = self._data.geom_xmat[geom].reshape(3, 3), self._data.geom_xpos[geom]
        return local.transform(np.column_stack([turn, position]))

    def _below(self, solid: Manifold, plane: int) -> float:
        normal = self._data.geom_xmat[plane].reshape(3, 3)[:, 2]
        offset = float(normal @ self._data.geom_xpos[plane])
        return float(solid.trim_by_plane(tuple(-normal), -offset).volume())


def lowest_point(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> float:
    """Height of a geom's lowest point [m]; -inf of a plane or height field."""
    up = data.geom_xmat[geom].reshape(3, 3)[2]
    middle, size, kind = float(data.geom_xpos[geom, 2]), model.geom_size[geom], int(model.geom_type[geom])
    if kind in (_PLANE, _HFIELD):
        return -math.inf
    if kind in (_MESH, _SDF):
        return middle + float((_mesh_points(model, geom) @ up).min())
    if kind == _BOX:
        return middle - float(np.abs(up) @ size)
    if kind == _SPHERE:
        return middle - float(size[0])
    if kind == _CAPSULE:
        return middle - float(size[0] + abs(up[2]) * size[1])
    if kind == _CYLINDER:
        return middle - float(abs(up[2]) * size[1] + math.sqrt(max(0.0, 1.0 - up[2] ** 2)) * size[0])
    return middle - float(np.linalg.norm(up * size))


def _mesh_points(model: mujoco.MjModel, geom: int) -> Array:
    mesh = int(model.geom_dataid[geom])
    start, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    return np.asarray(model.mesh_vert[start : start + count], np.float64)


def _local(model: mujoco.MjModel, geom: int) -> Manifold | None:
    """A geom in its own frame with its true volume; None for planes and height fields."""
    kind, size = int(model.geom_type[geom]), [float(x) for x in model.geom_size[geom]]
    if kind in (_PLANE, _HFIELD):
        return None
    if kind in (_MESH, _SDF):
        return Manifold.hull_points(_mesh_points(model, geom))
    if kind == _BOX:
        return Manifold.cube([2 * x for x in size], True)
    if kind == _CYLINDER:
        widened = size[0] / math.sqrt(math.sin(2 * math.pi / SIDES) * SIDES / (2 * math.pi))
        return Manifold.cylinder(2 * size[1], widened, widened, SIDES, True)
    ball = Manifold.sphere(1.0, SIDES)
    widened = (4 * math.pi / 3 / ball.volume()) ** (1 / 3)
    if kind == _CAPSULE:
        end = ball.scale([size[0] * widened] * 3)
        return Manifold.batch_hull([end.translate((0.0, 0.0, size[1])), end.translate((0.0, 0.0, -size[1]))])
    radii = [size[0]] * 3 if kind == _SPHERE else size
    return ball.scale([radius * widened for radius in radii])
