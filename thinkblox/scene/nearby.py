"""The search for the nearest pose that may be valid, around one that is not."""

from collections.abc import Iterator

import numpy as np

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at

REACH = 2.0
"""How far from the failed pose the search goes on the floor [m]; on a surface it covers the surface."""
RINGS, SPOKES = 16, 16


def nearest_poses(scene: Scene, asset: Asset, failed: Placement) -> Iterator[Placement]:
    """Poses by distance from the failed one that look free from above: shifted, and turned by quarter turns.

    On the floor and on surfaces the shift is horizontal; on walls it is along the wall and up or down.
    """
    tries = _shifts(scene, asset, failed)
    if not tries:
        return
    rects = Rects.of([((p.position[0], p.position[1]), p.size[:2], p.yaw, p.position[2], p.top) for p in tries])
    others = tuple(
        p for p in scene.placements if scene.asset_of(p).collides and p.id not in (failed.id, failed.support)
    )
    blocked = overlap_depth(rects, Rects.of_placements(others)).max(-1, initial=0.0)
    free = (blocked < 0.001) & (outside(rects, scene.room.polygon) < 0.0005)
    for index in np.flatnonzero(free):
        yield tries[int(index)]


def _shifts(scene: Scene, asset: Asset, failed: Placement) -> list[Placement]:
    if asset.mount == "wall":
        return _on_wall(scene, asset, failed)
    turns = (0.0,) if asset.front == "any" else (0.0, 90.0, 180.0, 270.0)
    reach = REACH if failed.support == "floor" or failed.support not in scene else max(scene[failed.support].size[:2])
    x, y, z = failed.position
    poses = []
    for radius in np.linspace(0.0, reach, RINGS + 1):
        for angle in np.linspace(0.0, 2 * np.pi, SPOKES, endpoint=False)[: 1 if radius == 0.0 else SPOKES]:
            place = (round(float(x + radius * np.cos(angle)), 3), round(float(y + radius * np.sin(angle)), 3), z)
            poses += [placed_at(scene, asset, id=failed.id, position=place, yaw=failed.yaw + turn) for turn in turns]
    return poses


def _on_wall(scene: Scene, asset: Asset, failed: Placement) -> list[Placement]:
    steps = np.linspace(-REACH, REACH, 4 * RINGS + 1)
    heights = [h for h in (0.0, 0.15, -0.15, 0.3, -0.3, 0.5, -0.5) if failed.position[2] + h >= 0.0]
    (lx, ly), (x, y, z) = failed.left, failed.position
    pairs = sorted(((abs(s) + abs(h), float(s), h) for s in steps for h in heights), key=lambda pair: pair[0])
    return [
        placed_at(
            scene, asset, id=failed.id, position=(round(x + lx * s, 3), round(y + ly * s, 3), z + h), yaw=failed.yaw
        )
        for _, s, h in pairs
        if z + h + asset.size[2] <= scene.room.height
    ]
