"""SceneEval's Support: what is within a centimetre of an object on the side that holds it."""

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.sim.foreign.triangles import Triangles, first_hits
from thinkblox.sim.suites.criteria import criterion, exempt
from thinkblox.sim.suites.meshes import MeshedThing, Meshes
from thinkblox.suite import Criterion, Finding

NEAR, RAISED = 0.01, 0.005
"""A surface is a support within the first, of an object that was moved away from it by the second [m]."""
PER_AREA, FEWEST, MOST = 256, 32, 100_000
"""Points on each face: so many on a square metre of the largest, at least so many, and in all at most so many."""
FACING = 0.9
"""Cosine of the angle between a face that can carry and the direction."""
Floats = NDArray[np.float64]
DOWN, UP = np.array([0.0, 0.0, -1.0]), np.array([0.0, 0.0, 1.0])


def support(meshes: Meshes, generator: np.random.Generator) -> Criterion:
    """Every object, by what holds it."""
    found = [_finding(body, meshes, generator) for body in meshes.bodies]
    return criterion(
        "support",
        "4 points of what carries it are within 1 cm below, and the centre of its surface is above their hull; of what "
        "hangs, 1 point towards the wall or ceiling",
        [*found, *meshes.soft], unit="count", limit=4.0, least=True,
    )  # fmt: skip


def _finding(body: MeshedThing, meshes: Meshes, generator: np.random.Generator) -> Finding:
    direction = _direction(body)
    origins = _origins(body.triangles, direction, generator) - RAISED * direction
    points = _contacts(origins, direction, body, meshes)
    value = float(len(points))
    if body.support in ("wall", "ceiling"):
        passed = len(points) > 0
        note = "" if passed else f"nothing within 1 cm towards its {body.support}"
        return Finding(object=body.id, value=value, passed=passed, note=note)
    note = _falls(points, body.triangles.centroid)
    if note and body.support == "unknown":
        return exempt(body.id, f"fixed to the world, by what is not known; {note}", value)
    return Finding(object=body.id, value=value, passed=not note, note=note)


def _direction(body: MeshedThing) -> Floats:
    if body.support == "ceiling":
        return UP
    if body.support == "wall":
        front = body.axes[0]
        return np.array([-front[0], -front[1], 0.0])
    return DOWN


def _origins(mesh: Triangles, direction: Floats, generator: np.random.Generator) -> Floats:
    """Corners and points of faces that are furthest along a direction [m], shape (n, 3)."""
    along = mesh.vertices @ direction
    close = along >= along.max() - NEAR
    facing = np.abs(mesh.crosses @ direction) > FACING * 2.0 * mesh.areas
    faces = np.flatnonzero(close[mesh.faces].all(axis=1) & facing & (mesh.areas > 0.0))
    lowest: Floats = mesh.vertices[close]
    if not len(faces):
        return lowest
    each = max(FEWEST, int(mesh.areas[faces].max() * PER_AREA))
    each = max(1, min(each, MOST // len(faces)))
    u, v = generator.random((2, len(faces), each, 1))
    folded = u + v > 1.0
    u, v = np.where(folded, 1.0 - u, u), np.where(folded, 1.0 - v, v)
    a, b, c = (mesh.corners[faces, None, k] for k in range(3))
    return np.vstack([lowest, (a + u * (b - a) + v * (c - a)).reshape(-1, 3)])


def _contacts(origins: Floats, direction: Floats, body: MeshedThing, meshes: Meshes) -> Floats:
    """Where rays first meet each other thing and each part of the world, within NEAR [m], shape (n, 3)."""
    others = [other.triangles for other in meshes.bodies if other is not body]
    ends = np.vstack([origins, origins + NEAR * direction])
    low, high = ends.min(axis=0) - 1e-6, ends.max(axis=0) + 1e-6
    found = [np.zeros((0, 3))]
    for target in (*others, *meshes.world):
        near, far = target.bounds
        if np.all(near <= high) and np.all(far >= low):
            distances = first_hits(target, origins, direction)
            hit = distances < NEAR
            found.append(origins[hit] + distances[hit, None] * direction)
    if direction[2] > 0.0 and meshes.room is not None:
        found.append(_ceiling(origins, meshes))
    return np.vstack(found)


def _ceiling(origins: Floats, meshes: Meshes) -> Floats:
    """Where rays upwards meet the ceiling of the room, which no model holds."""
    assert meshes.room is not None
    height = meshes.room.height
    gap = height - origins[:, 2]
    met = (gap >= 0.0) & (gap < NEAR) & shapely.intersects_xy(meshes.room.polygon, origins[:, 0], origins[:, 1])
    return np.column_stack([origins[met, :2], np.full(int(met.sum()), height)])


def _falls(points: Floats, centre: Floats) -> str:
    """Why an object over these points is not carried, or ""."""
    if len(points) < 4 or len(np.unique(points, axis=0)) < 3:
        return f"{len(points)} points within 1 cm below it; 4 are needed"
    hull = shapely.convex_hull(shapely.multipoints(points[:, :2]))
    if shapely.dwithin(hull, shapely.points(centre[0], centre[1]), 1e-6):
        return ""
    away = float(shapely.distance(hull, shapely.points(centre[0], centre[1])))
    return f"the centre of its surface is {away * 1000:.0f} mm beside what carries it"
