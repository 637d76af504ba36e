"""Where on a surface something more could stand."""

from typing import NamedTuple

import numpy as np

from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.asset import Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, separation
from thinkblox.value import Vec3

LEAST = 0.03
"""Spots with less free round them are none [m]."""
GRID = 9
"""Points looked at along each side of a surface."""
SAME_HEIGHT = 0.03
"""What stands nearer than this to the height of a surface stands on it [m]."""


class FreeSpot(NamedTuple):
    """A place on a surface.

    Attributes:
        position: in the room [m].
        clear: radius of the circle round it that is on the surface and free of what stands there [m].
    """

    position: Vec3
    clear: float


def free_spots(scene: Arrangement, carrier: Placement, surface: Surface, *, count: int = 3) -> tuple[FreeSpot, ...]:
    """The widest free places on a surface of a placed thing, none within another; the widest first."""
    z = carrier.position[2] + surface.position[2]
    points = _grid(surface)
    clear = _to_edge(surface, points)
    placed = [carrier.to_room((float(x), float(y))) for x, y in points]
    standing = tuple(p for p in scene.resting_on(carrier.id) if abs(p.position[2] - z) < SAME_HEIGHT)
    if standing:
        dots = Rects.of([(at, (1e-6, 1e-6), 0.0, z, z + 0.01) for at in placed])
        clear = np.minimum(clear, separation(dots, Rects.of_placements(standing)).min(-1))
    found: list[FreeSpot] = []
    for index in np.argsort(-clear, kind="stable"):
        (x, y), radius = placed[int(index)], float(clear[index])
        apart = all(np.hypot(x - s.position[0], y - s.position[1]) >= s.clear + radius for s in found)
        if radius >= LEAST and apart and len(found) < count:
            found.append(FreeSpot((round(x, 3), round(y, 3), round(z, 4)), round(radius, 3)))
    return tuple(found)


def _grid(surface: Surface) -> np.ndarray:
    """Points over a surface in the asset's frame [m], (n, 2)."""
    steps = np.linspace(-0.5, 0.5, GRID + 2)[1:-1]
    x, y = np.meshgrid(steps * surface.size[0], steps * surface.size[1], indexing="ij")
    return np.stack([x.ravel() + surface.position[0], y.ravel() + surface.position[1]], -1)


def _to_edge(surface: Surface, points: np.ndarray) -> np.ndarray:
    """Distance of points to the edge of a surface [m], less than 0 outside; a lower bound for an ellipse."""
    half = np.array(surface.size) / 2
    offset = np.abs(points - np.array(surface.position[:2]))
    if surface.round:
        return np.asarray((1.0 - np.linalg.norm(offset / half, axis=-1)) * half.min())
    return np.asarray((half - offset).min(-1))
