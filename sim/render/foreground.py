"""What stands in front of a room that is opened like a dolls' house: tall pieces whose backs are turned to the eye."""

from collections.abc import Collection, Sequence

import numpy as np
from shapely import LineString

from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.surfels import see
from thinkblox.sim.render.tessellate import Floats

TALL = 1.15
"""Height from which on a piece hides what is behind it [m]."""
_NEAR = 0.3
"""Distance from a wall within which a piece stands on it [m]."""
_FINE = 2
"""So many rays across a pixel tell how much of it a piece covers."""


def in_the_way(scene: Scene, standing: Sequence[bool]) -> frozenset[str]:
    """Ids of the tall pieces that stand with their backs to a wall that is cut away, and of all that they carry."""
    cut = [wall for wall, stands in zip(scene.room.walls, standing, strict=True) if not stands]
    found: set[str] = set()
    for placement in sorted(scene.placements, key=lambda p: p.position[2]):
        if placement.support in found:
            found.add(placement.id)
        elif _hides(scene, placement):
            near = [w for w in cut if LineString([w.start, w.end]).distance(placement.footprint) < _NEAR]
            if any(_backs(scene, placement, wall.yaw) for wall in near):
                found.add(placement.id)
    return frozenset(found)


def _hides(scene: Scene, placement: Placement) -> bool:
    """Whether what stands behind a piece is not seen past it, as past a lamp or a plant."""
    asset = scene.asset_of(placement)
    return placement.size[2] > TALL and asset.mount == "floor" and asset.front != "any"


def _backs(scene: Scene, placement: Placement, yaw: float) -> bool:
    """Whether a piece near a wall whose pieces face `yaw` has its back, or its longer side, to it."""
    front = scene.asset_of(placement).front
    if front == "one":
        return turn_between(placement.yaw, yaw) < 45.0
    depth, width, _ = placement.size
    across = turn_between(placement.yaw, yaw, period=180.0) < 45.0
    return across == (width >= depth) or abs(width - depth) < 0.1


def coverage(tracer: Tracer, camera: Camera, size: int, owners: Collection[int]) -> tuple[Floats, Floats]:
    """How much of each pixel shows one of these objects, 0 to 1 (size, size), and the corners (n, 3) of theirs."""
    mine = np.array([*(patch.owner in owners for patch in tracer.triangles.patches), False])
    triangles = tracer.triangles
    corners = triangles.vertices[np.unique(triangles.faces[mine[triangles.patch]])]
    covered = np.zeros((size, size), np.float32)
    places = np.clip(camera.project(corners.astype(np.float64), size), 0, size)
    (left, top), (right, bottom) = places.min(0).astype(int), np.ceil(places.max(0)).astype(int)
    across, down = (_fine(low, high) for low, high in ((left, right), (top, bottom)))
    front = see(tracer, camera, np.tile(across, len(down)), np.repeat(down, len(across)), size).front
    fine = mine[front].reshape(bottom - top, _FINE, right - left, _FINE)
    covered[top:bottom, left:right] = fine.mean((1, 3))
    return covered, corners


def _fine(low: int, high: int) -> Floats:
    """Coordinates of rays through the pixels from one to before another."""
    return np.arange(low * _FINE, high * _FINE, dtype=np.float32) / np.float32(_FINE) + np.float32(0.5 / _FINE)
