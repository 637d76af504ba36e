"""Shapes as USD prims: colliders one by one as they are, looks merged into one mesh for each material."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Vt

from thinkblox.exporters.hulls import hull_mesh, hull_of
from thinkblox.exporters.inventory import InventoryGeom
from thinkblox.exporters.usd_looks import BINDING, UV, Looks
from thinkblox.exporters.usd_prims import Prim, T, vectors
from thinkblox.scene.asset import Shape
from thinkblox.scene.corners import rotation
from thinkblox.scene.textured_mesh import TexturedMesh, mesh_of
from thinkblox.sim.geometry.collider import collider
from thinkblox.sim.render.tessellate import Mesh, capsule, cylinder, ellipsoid, hull
from thinkblox.value import Vec3

Floats = NDArray[np.float64]
_COLLIDER = "PhysicsCollisionAPI"
_CUBE = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_SIDES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
"""Corners of each side of the cube, counter-clockwise seen from outside: -x, x, -y, y, -z, z."""


@dataclass(frozen=True)
class Polygons:
    """Flat or curved polygons with a normal a vertex, in the frame of their prim [m]."""

    points: NDArray[Any]
    normals: NDArray[Any]
    counts: list[int]
    indices: list[int]


def add_colliders(scope: Prim, geoms: Sequence[InventoryGeom]) -> None:
    """Add one convex collider for each shape that can be touched."""
    for geom in geoms:
        if geom.collides and geom.shape is not None:
            _add_collider(scope, geom.shape)


def _add_collider(scope: Prim, shape: Shape) -> None:
    (x, y, z), name = shape.size, shape.kind
    if shape.kind in ("hull", "ellipsoid"):
        _add_hull(scope, shape)
    elif shape.kind == "box":
        prim = scope.child(name, "Cube", apis=[_COLLIDER]).put("size", T.Double, 1.0)
        prim.extent((-0.5,) * 3, (0.5,) * 3).place(shape.position, shape.quat_wxyz, shape.size)
    elif shape.kind == "sphere":
        prim = scope.child(name, "Sphere", apis=[_COLLIDER]).put("radius", T.Double, x / 2)
        prim.extent((-x / 2,) * 3, (x / 2,) * 3).place(shape.position, shape.quat_wxyz)
    else:
        prim = scope.child(name, shape.kind.capitalize(), apis=[_COLLIDER]).put("axis", T.Token, "Z", uniform=True)
        prim.put("radius", T.Double, x / 2).put("height", T.Double, z if shape.kind == "cylinder" else z - x)
        prim.extent((-x / 2, -y / 2, -z / 2), (x / 2, y / 2, z / 2)).place(shape.position, shape.quat_wxyz)


def _add_hull(scope: Prim, shape: Shape) -> None:
    solid = collider(shape if shape.kind == "hull" else hull_of(shape))
    mesh = hull_mesh(solid.points, smooth=solid.smooth)
    prim = scope.child(shape.kind, "Mesh", apis=[_COLLIDER, "PhysicsMeshCollisionAPI"])
    prim.put("physics:approximation", T.Token, "convexHull", uniform=True)
    _put_mesh(prim, mesh.points, [3] * len(mesh.faces), mesh.faces.ravel().tolist())
    prim.put("normals", T.Normal3fArray, vectors(mesh.normals.reshape(-1, 3), 4), interpolation="faceVarying")
    prim.place(shape.position, shape.quat_wxyz)


def add_visuals(parent: Prim, geoms: Sequence[InventoryGeom], looks: Looks) -> None:
    """Add one mesh for each look that the shapes have, and the meshes as they are."""
    groups: dict[str, list[Polygons]] = {}
    for geom in geoms:
        if geom.look is not None and geom.shape is not None:
            groups.setdefault(geom.look, []).append(placed(geom.shape))
    for look, parts in groups.items():
        add_mesh(parent, look, parts, looks, look)
    for geom in geoms:
        if geom.look is not None and geom.mesh is not None:
            add_textured(parent, geom.look, mesh_of(geom.mesh), looks, geom.look).place(geom.offset)


def add_textured(parent: Prim, name: str, mesh: TexturedMesh, looks: Looks, look: str) -> Prim:
    """Add one visible mesh, with the places of its vertices in a texture where they have any."""
    parts = [Polygons(mesh.vertices, mesh.normals, [3] * len(mesh.faces), mesh.faces.ravel().tolist())]
    prim = add_mesh(parent, name, parts, looks, look)
    if not mesh.uv.any():
        return prim
    places = Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(mesh.uv, np.float32))
    return prim.put(f"primvars:{UV}", T.TexCoord2fArray, places, interpolation="vertex")


def add_mesh(parent: Prim, name: str, parts: Sequence[Polygons], looks: Looks, look: str) -> Prim:
    """Add one visible mesh made of all parts."""
    prim = parent.child(name, "Mesh", apis=[BINDING])
    starts = np.cumsum([0] + [len(part.points) for part in parts]).tolist()
    indices = [index + start for part, start in zip(parts, starts, strict=False) for index in part.indices]
    points = np.vstack([part.points for part in parts])
    _put_mesh(prim, points, [count for part in parts for count in part.counts], indices)
    normals = np.vstack([part.normals for part in parts])
    prim.put("normals", T.Normal3fArray, vectors(normals, 4), interpolation="vertex")
    looks.bind(prim, look)
    return prim


def _put_mesh(prim: Prim, points: NDArray[Any], counts: list[int], indices: list[int]) -> None:
    prim.put("points", T.Point3fArray, vectors(points, 6)).put("faceVertexCounts", T.IntArray, Vt.IntArray(counts))
    prim.put("faceVertexIndices", T.IntArray, Vt.IntArray(indices))
    prim.put("subdivisionScheme", T.Token, "none", uniform=True)
    prim.extent(np.round(points.min(axis=0), 6).tolist(), np.round(points.max(axis=0), 6).tolist())


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
