"""Shapes as USD prims: colliders one by one as they are, looks merged into one mesh for each material."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Vt

from thinkblox.exporters.hulls import hull_mesh, hull_of
from thinkblox.exporters.inventory import InventoryGeom
from thinkblox.exporters.polygons import Polygons, placed
from thinkblox.exporters.usd_looks import BINDING, UV, Looks
from thinkblox.exporters.usd_prims import Prim, T, vectors
from thinkblox.scene.asset import Shape
from thinkblox.scene.textured_mesh import TexturedMesh, mesh_of
from thinkblox.sim.geometry.collider import collider
from thinkblox.value import Vec3

_COLLIDER = "PhysicsCollisionAPI"
_NO_AREA = 1e-11
"""Twice the area of a face that is left out [m2]."""


def add_colliders(scope: Prim, geoms: Sequence[InventoryGeom], friction: Looks) -> None:
    """Add one convex collider for each shape that can be touched, bound to its physics material.

    Each is bound by itself: OpenUSD's own reader of physics passes over what is bound to the scope above.
    """
    for geom in geoms:
        if geom.collides and geom.shape is not None:
            friction.bind_friction(_add_collider(scope, geom.shape), geom.friction[0])


def _add_collider(scope: Prim, shape: Shape) -> Prim:
    (x, y, z), name = shape.size, shape.kind
    apis = [_COLLIDER, BINDING]
    if shape.kind in ("hull", "ellipsoid"):
        return _add_hull(scope, shape)
    if shape.kind == "box":
        prim = scope.child(name, "Cube", apis=apis).put("size", T.Double, 1.0)
        return prim.extent((-0.5,) * 3, (0.5,) * 3).place(shape.position, shape.quat_wxyz, shape.size)
    if shape.kind == "sphere":
        prim = scope.child(name, "Sphere", apis=apis).put("radius", T.Double, x / 2)
        return prim.extent((-x / 2,) * 3, (x / 2,) * 3).place(shape.position, shape.quat_wxyz)
    prim = scope.child(name, shape.kind.capitalize(), apis=apis).put("axis", T.Token, "Z", uniform=True)
    prim.put("radius", T.Double, x / 2).put("height", T.Double, z if shape.kind == "cylinder" else z - x)
    return prim.extent((-x / 2, -y / 2, -z / 2), (x / 2, y / 2, z / 2)).place(shape.position, shape.quat_wxyz)


def _add_hull(scope: Prim, shape: Shape) -> Prim:
    solid = collider(shape if shape.kind == "hull" else hull_of(shape))
    mesh = hull_mesh(solid.points, smooth=solid.smooth)
    prim = scope.child(shape.kind, "Mesh", apis=[_COLLIDER, "PhysicsMeshCollisionAPI", BINDING])
    prim.put("physics:approximation", T.Token, "convexHull", uniform=True)
    _put_mesh(prim, mesh.points, [3] * len(mesh.faces), mesh.faces.ravel().tolist())
    prim.put("normals", T.Normal3fArray, vectors(mesh.normals.reshape(-1, 3), 4), interpolation="faceVarying")
    return prim.place(shape.position, shape.quat_wxyz)


def add_visuals(parent: Prim, geoms: Sequence[InventoryGeom], looks: Looks) -> None:
    """Add one mesh for each look that the shapes have, and the meshes as they are."""
    groups: dict[str, list[Polygons]] = {}
    for geom in geoms:
        if geom.look is not None and geom.shape is not None:
            groups.setdefault(geom.look, []).append(placed(geom.shape))
    for look, parts in groups.items():
        for together in _apart(parts):
            _add_mesh(parent, look, together, looks, look)
    for geom in geoms:
        if geom.look is not None and geom.mesh is not None:
            add_textured(parent, geom.look, mesh_of(geom.mesh), looks, geom.look, offset=geom.offset)


def add_textured(
    parent: Prim,
    name: str,
    mesh: TexturedMesh,
    looks: Looks,
    look: str,
    *,
    pieces: Sequence[int] = (),
    offset: Vec3 = (0.0, 0.0, 0.0),
) -> None:
    """Add what is seen of a mesh, with the places of its vertices in a texture where they have any.

    `pieces` are how many vertices each closed piece of it has, where there are several, and `offset` is where its
    origin is [m].
    """
    uv = mesh.uv if mesh.uv.any() else None
    ends = np.cumsum(pieces or (len(mesh.vertices),))
    of = np.searchsorted(ends, mesh.faces[:, 0], side="right")
    parts = []
    for number, (first, end) in enumerate(pairwise([0, *ends.tolist()])):
        faces = mesh.faces[of == number] - first
        if len(faces):
            seen = None if uv is None else uv[first:end]
            points, normals = mesh.vertices[first:end], mesh.normals[first:end]
            parts.append(Polygons(points, normals, [3] * len(faces), faces.ravel().tolist(), seen))
    for together in _apart(parts):
        _add_mesh(parent, name, together, looks, look).place(offset)


def _apart(parts: Sequence[Polygons]) -> list[list[Polygons]]:
    """Parts sorted so that those that are together share no point: what touches is no surface with an inside."""
    groups: list[tuple[list[Polygons], set[bytes]]] = []
    for part in parts:
        points = {row.tobytes() for row in _rounded(part.points)}
        group = next((group for group in groups if not group[1] & points), None)
        if group is None:
            groups.append(([part], points))
        else:
            group[0].append(part)
            group[1].update(points)
    return [group for group, _ in groups]


def _rounded(points: NDArray[Any]) -> NDArray[Any]:
    """Points by which two are the same [m]."""
    return np.round(np.asarray(points, np.float64), 6) + 0.0


def _add_mesh(parent: Prim, name: str, parts: Sequence[Polygons], looks: Looks, look: str) -> Prim:
    """Add one visible mesh made of all parts: each point once, with a normal a corner, and no face without an area."""
    prim = parent.child(name, "Mesh", apis=[BINDING])
    starts = np.cumsum([0] + [len(part.points) for part in parts])
    corners = np.concatenate([np.asarray(part.indices) + start for part, start in zip(parts, starts, strict=False)])
    points, same = np.unique(_rounded(np.vstack([part.points for part in parts])), axis=0, return_inverse=True)
    counts = np.concatenate([np.asarray(part.counts) for part in parts])
    kept = np.repeat(_with_area(points, same.reshape(-1)[corners], counts), counts)
    counts, corners = counts[_first_of(kept, counts)], corners[kept]
    used, index = np.unique(same.reshape(-1)[corners], return_inverse=True)
    _put_mesh(prim, points[used], counts.tolist(), index.reshape(-1).tolist())
    normals = np.vstack([part.normals for part in parts])[corners]
    prim.put("normals", T.Normal3fArray, vectors(normals, 4), interpolation="faceVarying")
    places = [part.uv for part in parts if part.uv is not None]
    if places:
        _put_uv(prim, np.vstack(places).astype(np.float32)[corners])
    looks.bind(prim, look)
    return prim


def _with_area(points: NDArray[Any], corners: NDArray[Any], counts: NDArray[Any]) -> NDArray[np.bool_]:
    """Which faces have an area, by their first three corners, and a fourth where there is one."""
    first = np.cumsum(counts) - counts
    a, b, c, last = (points[corners[first + step]] for step in (0, 1, 2, counts - 1))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) + np.linalg.norm(np.cross(c - a, last - a), axis=1)
    kept: NDArray[np.bool_] = area > _NO_AREA
    return kept


def _first_of(kept: NDArray[np.bool_], counts: NDArray[Any]) -> NDArray[np.bool_]:
    """Of corners that are kept face by face, the faces."""
    found: NDArray[np.bool_] = kept[np.cumsum(counts) - counts]
    return found


def _put_uv(prim: Prim, places: NDArray[np.float32]) -> None:
    values, index = np.unique(places, axis=0, return_inverse=True)
    array = Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(values))
    prim.put(f"primvars:{UV}", T.TexCoord2fArray, array, interpolation="faceVarying")
    prim.put(f"primvars:{UV}:indices", T.IntArray, Vt.IntArray(index.reshape(-1).tolist()))


def _put_mesh(prim: Prim, points: NDArray[Any], counts: list[int], indices: list[int]) -> None:
    stored = np.round(np.asarray(points, np.float64), 6).astype(np.float32)
    prim.put("points", T.Point3fArray, vectors(points, 6)).put("faceVertexCounts", T.IntArray, Vt.IntArray(counts))
    prim.put("faceVertexIndices", T.IntArray, Vt.IntArray(indices))
    prim.put("subdivisionScheme", T.Token, "none", uniform=True)
    prim.extent(stored.min(axis=0).tolist(), stored.max(axis=0).tolist())
