"""Looking into a room that came as a model: which of its fixed parts would hide what is inside."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.tessellate import Mesh

Array = NDArray[np.float64]
TALL = 1.2
"""A fixed part of a room that is no higher than this hides little [m]."""
OVERHEAD = 1.7
"""What begins above this and covers much of the room is its ceiling [m]."""
LONG = 0.35
"""Share of the room's side from which on a tall fixed part is a wall."""
LOW, THIN = 0.3, 0.25
"""So is any part that is higher than the first and thinner than the second, as under a window [m]."""
FLOOR = 0.2
"""Share of the room from which on a part holds its floor too."""
RIM = 0.1
"""What is left of walls that are of one piece with their floor [m]."""
BESIDE = 2.0
"""Walls are looked for within this distance from the objects [m]."""


@dataclass(frozen=True)
class Bounds:
    """A box along the axes: its lower and upper corner [m]."""

    low: Array
    high: Array

    @property
    def size(self) -> Array:
        """Its extents [m]."""
        return np.asarray(self.high - self.low)

    @property
    def corners(self) -> Array:
        """Its corners (8, 3)."""
        pairs = np.stack([self.low, self.high])
        return np.array([[pairs[i, 0], pairs[j, 1], pairs[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])


def bounds_of(objects: Sequence[Array], fixed: Sequence[Array]) -> Bounds:
    """The room that objects and fixed parts seem to stand in; a ground that goes on and on is no part of it.

    Args:
        objects: points (n, 3) of each object.
        fixed: points (n, 3) of each part of the world.
    """
    finite = [points for points in (*objects, *fixed) if np.isfinite(points).all()]
    if not finite:
        return Bounds(np.array([-1.0, -1.0, 0.0]), np.array([1.0, 1.0, 1.0]))
    inner = np.concatenate([p for p in objects if np.isfinite(p).all()] or finite)
    low, high = np.percentile(inner, 1, axis=0) - BESIDE, np.percentile(inner, 99, axis=0) + BESIDE
    walls = [p for p in fixed if np.ptp(p[:, 2]) > TALL and bool(((p >= low - 1) & (p <= high + 1)).all())]
    near = inner[((inner >= low) & (inner <= high)).all(1)]
    points = np.concatenate([near, *walls])
    floor = min(float(points[:, 2].min()), 0.0) if points[:, 2].min() < 1.0 else float(points[:, 2].min())
    corner = np.array([*points[:, :2].min(0), floor])
    return Bounds(corner, np.maximum(points.max(0), corner + 0.2))


def opened(mesh: Mesh, bounds: Bounds, azimuth: float | None, cut: float) -> Mesh | None:
    """What is drawn of a fixed part: no ceiling, walls cut at a height from above, near walls not at all.

    Args:
        mesh: in the frame of the room.
        bounds: of the room.
        azimuth: where the camera stands [degrees], or None for one that looks straight down.
        cut: where walls are cut for that [m].
    """
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    floor, across = float(bounds.low[2]), np.minimum(high, bounds.high)[:2] - np.maximum(low, bounds.low)[:2]
    covers = float(np.prod(np.maximum(across, 0.0)) / max(np.prod(bounds.size[:2]), 1e-9))
    if low[2] - floor > OVERHEAD and covers > FLOOR:
        return None
    tall, long = high[2] - floor, float(((high - low)[:2] / np.maximum(bounds.size[:2], 1e-6)).max())
    if not (tall > TALL and long > LONG) and not (tall > LOW and float((high - low)[:2].min()) < THIN):
        return mesh
    if azimuth is None:
        vertices = mesh.vertices.copy()
        vertices[:, 2] = np.minimum(vertices[:, 2], floor + cut)
        return Mesh(vertices, mesh.normals, mesh.faces)
    return _without_near_side(mesh, bounds, azimuth, keep=RIM if covers > FLOOR else -np.inf)


def _without_near_side(mesh: Mesh, bounds: Bounds, azimuth: float, *, keep: float) -> Mesh | None:
    """The mesh without the faces that stand on the sides of the room that the camera looks over.

    Faces that reach no higher than `keep` above the floor stay: they may be the floor's own.
    """
    corners = mesh.vertices[mesh.faces]
    middle = corners.mean(1)
    towards = np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    edge = np.where(towards > 0, bounds.high[:2], bounds.low[:2])
    margin = 0.12 * bounds.size[:2]
    near = (((middle[:, :2] - edge) * np.sign(towards)) > -margin).any(1)
    upper = corners[:, :, 2].max(1) > bounds.low[2] + keep
    kept = mesh.faces[~(near & upper)]
    return Mesh(mesh.vertices, mesh.normals, kept) if len(kept) else None
