"""What collides in a USD stage as geoms of the engine: primitives as they are, the rest as convex hulls."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray
from pxr import Usd, UsdGeom, UsdPhysics

from thinkblox.assets.decompose import FlatMeshError, convex_pieces
from thinkblox.assets.mesh_file import MAX_TRIANGLES, MeshFile
from thinkblox.errors import InputError
from thinkblox.sim.foreign.usd_frames import Matrix, rigid
from thinkblox.sim.foreign.usd_values import number_of, numbers_of, points_of, word_of

Points = NDArray[np.float64]
SIDES = 48
"""Of the polygon that stands for the circle of a cone."""
THICK = 0.01
"""How far a flat mesh reaches below its face [m]."""
_UNSET = 0.0
"""What a size is that is missing altogether: refused like any that is not above 0."""
_EVEN = 1e-4
"""By which share sizes may differ and count as the same."""
_KINDS = mujoco.mjtGeom
_ALONG = {
    "X": np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]),
    "Y": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]),
    "Z": np.eye(3),
}
"""What turns the z axis of the engine's round shapes to an axis of the stage's."""
_APPROXIMATIONS = (
    *("none", "convexHull", "convexDecomposition", "meshSimplification", "boundingCube", "boundingSphere"),
    *("sdf", "sphereFill"),
)
"""What a mesh can be for collisions, by UsdPhysics and by PhysX."""
_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])


@dataclass(frozen=True)
class ColliderGeom:
    """One geom: its kind and half sizes, or the corners of its hull, and its frame on its body (4, 4)."""

    kind: Any
    frame: Matrix
    size: tuple[float, ...] = ()
    points: Points | None = None


@dataclass
class ColliderNotes:
    """How colliders were read: paths of those that are not what the stage has them as."""

    hulled: list[str] = field(default_factory=list)
    divided: list[str] = field(default_factory=list)
    left_out: list[str] = field(default_factory=list)


def solids_of(prim: Any, frame: Matrix, moves: bool, reading: ColliderNotes) -> list[ColliderGeom]:
    """The geoms of a collider; none of what is no shape, which is said in `reading`.

    Meshes are what their approximation says: hull, box, ball, or convex pieces. Triangles are a hull on what moves,
    as in other engines, and convex pieces on what does not.

    Args:
        prim: the collider.
        frame: what brings its points to its body's frame (4, 4), scale and all.
        moves: whether its body can.
        reading: of the stage.

    Raises:
        InputError: a size that is not a finite number above 0; a mesh that is broken or too large.
    """
    for schema, make in _MAKERS.items():
        if prim.IsA(schema):
            found = [make(prim, frame)]
            break
    else:
        if prim.IsA(UsdGeom.Mesh):
            found = _mesh(prim, frame, moves, reading)
        elif prim.IsA(UsdGeom.Plane) and not moves:
            found = [
                ColliderGeom(_KINDS.mjGEOM_PLANE, rigid(frame @ _turned(UsdGeom.Plane(prim).GetAxisAttr())), (0, 0, 1))
            ]
        else:
            # What is only above shapes that collide says nothing of its own.
            if not any(below.HasAPI(UsdPhysics.CollisionAPI) for below in _below(prim)):
                reading.left_out.append(str(prim.GetPath()))
            found = []
    for solid in found:
        if not np.isfinite(solid.frame).all() or not np.isfinite(solid.size).all() or _empty(solid):
            raise InputError(f"{prim.GetPath()}: has a size or place that is not made of finite numbers above 0")
    return found


def _below(prim: Any) -> Iterable[Any]:
    return (below for below in Usd.PrimRange(prim, Usd.TraverseInstanceProxies()) if below != prim)


def _empty(solid: ColliderGeom) -> bool:
    if solid.points is not None:
        return not np.isfinite(solid.points).all() or len(solid.points) < 4
    needed = {_KINDS.mjGEOM_SPHERE: 1, _KINDS.mjGEOM_CYLINDER: 2, _KINDS.mjGEOM_BOX: 3, _KINDS.mjGEOM_ELLIPSOID: 3}
    return any(size <= 0.0 for size in solid.size[: needed.get(solid.kind, 0)])


def _box(prim: Any, frame: Matrix) -> ColliderGeom:
    side = number_of(UsdGeom.Cube(prim).GetSizeAttr(), _UNSET)
    turn, sizes = _split(frame)
    if sizes is None:
        return ColliderGeom(_KINDS.mjGEOM_MESH, turn, points=_mapped(frame, _CORNERS * side, turn))
    return ColliderGeom(_KINDS.mjGEOM_BOX, turn, tuple((side / 2 * sizes).tolist()))


def _sphere(prim: Any, frame: Matrix) -> ColliderGeom:
    radius = number_of(UsdGeom.Sphere(prim).GetRadiusAttr(), _UNSET)
    turn, sizes = _split(frame)
    if sizes is None:
        return _hull(frame, _ball(radius))
    if np.ptp(sizes) <= _EVEN * sizes.max():
        return ColliderGeom(_KINDS.mjGEOM_SPHERE, turn, (radius * float(sizes.mean()), 0.0, 0.0))
    return ColliderGeom(_KINDS.mjGEOM_ELLIPSOID, turn, tuple((radius * sizes).tolist()))


def _round(kind: Any, schema: Any) -> Callable[[Any, Matrix], ColliderGeom]:
    """A maker of cylinders or capsules; one that is not round in the world is a hull."""

    def make(prim: Any, frame: Matrix) -> ColliderGeom:
        shape = schema(prim)
        frame = frame @ _turned(shape.GetAxisAttr())
        radius, height = number_of(shape.GetRadiusAttr(), _UNSET), number_of(shape.GetHeightAttr(), _UNSET)
        turn, sizes = _split(frame)
        if sizes is None or abs(sizes[0] - sizes[1]) > _EVEN * sizes.max():
            capsule = kind == _KINDS.mjGEOM_CAPSULE
            ends = _ball(radius) if capsule else np.column_stack([_circle(radius), np.zeros(SIDES)])
            lift = np.array([0.0, 0.0, height / 2])
            return _hull(frame, np.vstack([ends + lift, ends - lift]))
        return ColliderGeom(kind, turn, (radius * float(sizes[0]), height / 2 * float(sizes[2]), 0.0))

    return make


def _cone(prim: Any, frame: Matrix) -> ColliderGeom:
    cone = UsdGeom.Cone(prim)
    half, radius = number_of(cone.GetHeightAttr(), _UNSET) / 2, number_of(cone.GetRadiusAttr(), _UNSET)
    base = np.column_stack([_circle(radius), np.full(SIDES, -half)])
    return _hull(frame @ _turned(cone.GetAxisAttr()), np.vstack([base, [[0.0, 0.0, half]]]))


_MAKERS: dict[Any, Callable[[Any, Matrix], ColliderGeom]] = {
    UsdGeom.Cube: _box,
    UsdGeom.Sphere: _sphere,
    UsdGeom.Cylinder: _round(_KINDS.mjGEOM_CYLINDER, UsdGeom.Cylinder),
    UsdGeom.Cylinder_1: _round(_KINDS.mjGEOM_CYLINDER, UsdGeom.Cylinder_1),
    UsdGeom.Capsule: _round(_KINDS.mjGEOM_CAPSULE, UsdGeom.Capsule),
    UsdGeom.Capsule_1: _round(_KINDS.mjGEOM_CAPSULE, UsdGeom.Capsule_1),
    UsdGeom.Cone: _cone,
}


def _mesh(prim: Any, frame: Matrix, moves: bool, reading: ColliderNotes) -> list[ColliderGeom]:
    mesh = _triangles(prim)
    how = word_of(UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr(), _APPROXIMATIONS, "none")
    turn = rigid(frame)
    mesh = MeshFile(_mapped(frame, mesh.vertices, turn), mesh.faces)
    name = str(prim.GetPath())
    if how == "boundingCube":
        half = np.ptp(mesh.bounds, axis=0) / 2
        return [ColliderGeom(_KINDS.mjGEOM_BOX, _moved(turn, mesh.bounds.mean(axis=0)), tuple(half.tolist()))]
    if how == "boundingSphere":
        centre = mesh.bounds.mean(axis=0)
        radius = float(np.linalg.norm(mesh.vertices - centre, axis=1).max())
        return [ColliderGeom(_KINDS.mjGEOM_SPHERE, _moved(turn, centre), (radius, 0.0, 0.0))]
    if how == "convexHull" or (how == "none" and moves):
        if how == "none":
            reading.hulled.append(name)
        return [ColliderGeom(_KINDS.mjGEOM_MESH, turn, points=_thick(mesh.vertices, turn))]
    try:
        pieces = convex_pieces(mesh)
    except FlatMeshError:
        return [ColliderGeom(_KINDS.mjGEOM_MESH, turn, points=_thick(mesh.vertices, turn))]
    if len(pieces) > 1:
        reading.divided.append(name)
    return [ColliderGeom(_KINDS.mjGEOM_MESH, turn, points=piece) for piece in pieces]


def _triangles(prim: Any) -> MeshFile:
    mesh = UsdGeom.Mesh(prim)
    points = points_of(mesh.GetPointsAttr())
    index = numbers_of(mesh.GetFaceVertexIndicesAttr(), ()).astype(np.int64)
    counts = numbers_of(mesh.GetFaceVertexCountsAttr(), ()).astype(np.int64)
    if (counts < 3).any() or counts.sum() != len(index) or (len(index) and not _within(index, len(points))):
        raise InputError(f"{prim.GetPath()}: names points that do not exist")
    if not len(index) or not np.isfinite(points).all():
        raise InputError(f"{prim.GetPath()}: is a mesh without faces, or with points that are no numbers")
    triangles = int((counts - 2).sum())
    if triangles > MAX_TRIANGLES:
        raise InputError(f"{prim.GetPath()}: has {triangles} triangles; at most {MAX_TRIANGLES} are read")
    first = np.repeat(np.cumsum(counts) - counts, counts - 2)
    step = np.arange(triangles) - np.repeat(np.cumsum(counts - 2) - (counts - 2), counts - 2) + 1
    faces = np.column_stack([index[first], index[first + step], index[first + step + 1]])
    return MeshFile(points, faces)


def _within(index: NDArray[np.int64], count: int) -> bool:
    return int(index.min()) >= 0 and int(index.max()) < count


def _thick(points: Points, turn: Matrix) -> Points:
    """Points that span a volume: those of a flat mesh go THICK behind its face, which is its upper side."""
    centred = points - points.mean(axis=0)
    _, axes = np.linalg.eigh(centred.T @ centred)
    normal = axes[:, 0]
    if np.ptp(centred @ normal) > 1e-4 * np.linalg.norm(np.ptp(points, axis=0)):
        return points
    normal = normal if (turn[:3, :3] @ normal)[2] >= 0.0 else -normal
    return np.vstack([points, points - THICK * normal])


def _split(frame: Matrix) -> tuple[Matrix, Points | None]:
    """A frame without its scale, and its scales along its axes; None where it shears."""
    turn = rigid(frame)
    scale = turn[:3, :3].T @ frame[:3, :3]
    sizes = np.abs(np.diag(scale))
    apart = np.abs(scale - np.diag(np.diag(scale))).max()
    return turn, (sizes if apart <= _EVEN * sizes.max() else None)


def _mapped(frame: Matrix, points: Points, turn: Matrix) -> Points:
    """Points of a prim in its frame without scale."""
    mapped: Points = points @ (turn[:3, :3].T @ frame[:3, :3]).T
    return mapped


def _hull(frame: Matrix, points: Points) -> ColliderGeom:
    turn = rigid(frame)
    return ColliderGeom(_KINDS.mjGEOM_MESH, turn, points=_mapped(frame, points, turn))


def _moved(frame: Matrix, by: Points) -> Matrix:
    """A frame moved along its own axes."""
    moved = frame.copy()
    moved[:3, 3] += frame[:3, :3] @ by
    return moved


def _turned(axis: Any) -> Matrix:
    matrix = np.eye(4)
    matrix[:3, :3] = _ALONG[word_of(axis, _ALONG, "Z")]
    return matrix


def _circle(radius: float) -> Points:
    angle = 2 * np.pi * np.arange(SIDES) / SIDES
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def _ball(radius: float) -> Points:
    heights = np.cos(np.linspace(0.0, np.pi, 13))[:, None]
    rings = [np.column_stack([_circle(float(np.sqrt(1 - h * h))), np.full(SIDES, h)]) for h in heights.ravel()]
    return radius * np.vstack(rings)
