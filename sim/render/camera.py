"""Cameras: where they stand, which ray a pixel looks along, and how to frame something tightly."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.tessellate import Floats
from thinkblox.sim.render.vectors import length, repeated, scaled

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class Camera:
    """A square picture of the room.

    Attributes:
        position: the eye; for an orthographic camera, the centre of the picture's plane [m].
        right, up, forward: its axes, unit length.
        reach: half the picture's width: the tangent of half the field of view, or metres when orthographic.
        perspective: whether rays spread from the eye, or run side by side.
    """

    position: Vector
    right: Vector
    up: Vector
    forward: Vector
    reach: float
    perspective: bool = True

    def rays(self, x: Floats, y: Floats, size: int) -> tuple[Floats, Floats]:
        """Origins and unit directions (n, 3) through points of a picture `size` pixels wide; y runs downwards."""
        u = (x * np.float32(2 / size) - np.float32(1)) * np.float32(self.reach)
        v = (np.float32(1) - y * np.float32(2 / size)) * np.float32(self.reach)
        shift = scaled(self.right.astype(np.float32), u)
        shift += scaled(self.up.astype(np.float32), v)
        forward, eye = self.forward.astype(np.float32), self.position.astype(np.float32)
        if not self.perspective:
            return repeated(eye, len(x)) + shift, repeated(forward, len(x))
        shift += repeated(forward, len(x))
        far = length(shift)
        for axis in range(3):
            shift[:, axis] /= far
        return repeated(eye, len(x)), shift

    def project(self, points: NDArray[np.float64], size: int) -> NDArray[np.float64]:
        """Pixel coordinates (n, 2) of points (n, 3) of the room."""
        offset = np.asarray(points, np.float64) - self.position
        depth = (offset @ self.forward if self.perspective else np.ones(len(offset))) * self.reach
        return np.stack([1 + offset @ self.right / depth, 1 - offset @ self.up / depth], 1) * size / 2


def look(azimuth: float, elevation: float) -> tuple[Vector, Vector, Vector]:
    """Right, up and forward of a camera that stands at this azimuth and elevation [degrees] and looks at the centre."""
    a, e = math.radians(azimuth), math.radians(elevation)
    forward = -np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([-math.sin(a), math.cos(a), 0.0])
    return right, np.cross(right, forward), forward


def framed(points: Vector, *, azimuth: float, elevation: float, field: float = 36.0, margin: float = 0.06) -> Camera:
    """The nearest perspective camera that sees all points (n, 3), centred, with a share of the width left free.

    Args:
        points: what must be seen [m].
        azimuth: direction in which the camera stands, seen from the points [degrees].
        elevation: how far it stands above them [degrees].
        field: field of view [degrees].
        margin: share of the picture left free on each side.
    """
    right, up, forward = look(azimuth, elevation)
    reach = math.tan(math.radians(field) / 2)
    slope = reach * (1 - 2 * margin)
    depth = points @ forward
    bounds = [((points @ axis - slope * depth).max(), (points @ axis + slope * depth).min()) for axis in (right, up)]
    nearest = min((high - low) / (2 * slope) for low, high in bounds)
    centre = [(low + high) / 2 for low, high in bounds]
    position = centre[0] * right + centre[1] * up + nearest * forward
    return Camera(position, right, up, forward, reach)


def plan_camera(points: Vector, *, margin: float = 0.08, height: float = 50.0) -> Camera:
    """An orthographic camera that looks straight down, north up, at all points (n, 2 or 3)."""
    low, high = points[:, :2].min(0), points[:, :2].max(0)
    reach = float((high - low).max()) / 2 / (1 - 2 * margin)
    position = np.array([*((low + high) / 2), height])
    axes = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]])
    return Camera(position, axes[0], axes[1], axes[2], reach, perspective=False)
