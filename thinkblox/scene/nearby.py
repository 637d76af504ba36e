"""The search for the nearest pose that may be valid, around one that is not."""

import math
from collections.abc import Iterator, Sequence

import numpy as np
from msgspec import structs
from shapely import Polygon

from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth, same_height
from thinkblox.scene.support import placed_at
from thinkblox.value import Vec2, Vec3

REACH = 2.0
"""How far from the failed pose the search goes on the floor [m]; on a surface it covers the surface."""
RINGS, SPOKES = 16, 16
_AT_ONCE = 160
"""Places that are looked at together."""
EYE, BACK_GAP = 1.5, 0.002
"""Height of the middle of what hangs, and its gap to the wall, where nothing says more [m]."""


def nearest_poses(scene: Arrangement, asset: Known, failed: Placement) -> Iterator[Placement]:
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


def nearest_shift(scene: Arrangement, asset: Known, failed: Placement, *, clear_of: Sequence[str] = ()) -> Vec3 | None:
    """The least shift [m] to where it seems free and carried, seen as a box from above; None when 10 m do not do.

    Args:
        scene: in which it failed; an object of its id is looked past.
        asset: what it shows.
        failed: where it failed; it is not turned.
        clear_of: ids of openings whose floor stays free.
    """
    (x, y, z), up = failed.position, _lift(scene, asset, failed)
    steps = _OFFSETS if asset.mount != "wall" else _along(failed)
    tops = (z + up, z + up + failed.size[2])
    rects = Rects.of([((x + dx, y + dy), failed.size[:2], failed.yaw, *tops) for dx, dy in steps])
    riders = {p.id for p in scene.riders(failed.id)} if failed.id in scene else set()
    others = tuple(
        p for p in scene.placements if scene.asset_of(p).collides and p.id != failed.id and p.id not in riders
    )
    boxes = Rects.of_placements(others if asset.collides else ())
    boxes = boxes.take(np.flatnonzero(same_height(rects.take([0]), boxes)[0]))
    zones = [zone.footprint for id in clear_of for zone in things(scene, id) if zone.kind == "opening"]
    for index in _free(rects, boxes, scene.room.polygon):
        dx, dy = steps[index]
        moved = structs.replace(failed, position=(x + dx, y + dy, max(0.0, z + up)))
        if not any(moved.footprint.intersection(zone).area > 1e-6 for zone in zones):
            return (dx, dy, up)
    return None


def _free(rects: Rects, others: Rects, room: Polygon) -> Iterator[int]:
    """Which boxes are in the room and in none of the others, in their order; most often one of the first is."""
    for start in range(0, len(rects), _AT_ONCE):
        part = rects.take(np.arange(start, min(start + _AT_ONCE, len(rects))))
        blocked = overlap_depth(part, others).max(-1, initial=0.0)
        for index in np.flatnonzero((blocked < 0.001) & (outside(part, room) < 0.0005)):
            yield start + int(index)


def _lift(scene: Arrangement, asset: Known, failed: Placement) -> float:
    """How far up it goes to lie on what is nearest below or above its middle [m]."""
    z = failed.position[2]
    if asset.mount == "ceiling":
        return scene.room.height - failed.size[2] - z
    if asset.mount == "wall":
        return max(0.0, -z) - max(0.0, z + failed.size[2] - scene.room.height)
    heights = [0.0]
    for other in scene.placements:
        ahead, aside = other.to_local((failed.position[0], failed.position[1]))
        under = abs(ahead) <= other.size[0] / 2 and abs(aside) <= other.size[1] / 2
        if other.id != failed.id and under and asset.mount == "surface":
            heights += [other.position[2] + surface.position[2] for surface in scene.asset_of(other).surfaces]
    return min((height - z for height in heights), key=abs)


def _along(failed: Placement) -> list[Vec2]:
    (lx, ly), reach = failed.left, sorted({round(math.hypot(*step), 3) for step in _OFFSETS})
    return [(0.0, 0.0), *((sign * s * lx, sign * s * ly) for s in reach[1:] for sign in (1.0, -1.0))]


def _rings() -> list[Vec2]:
    """Offsets in all directions, the nearest first [m]: to the centimetre at first, then coarser."""
    radii = [n / 100 for n in range(1, 31)] + [0.3 + n / 20 for n in range(1, 35)]
    radii += [2.0 + n / 4 for n in range(1, 33)]
    turns = [2 * math.pi * n / SPOKES for n in range(SPOKES)]
    return [(0.0, 0.0), *((round(r * math.cos(t), 4), round(r * math.sin(t), 4)) for r in radii for t in turns)]


_OFFSETS = _rings()


def _shifts(scene: Arrangement, asset: Known, failed: Placement) -> list[Placement]:
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


def _on_wall(scene: Arrangement, asset: Known, failed: Placement) -> list[Placement]:
    steps = np.linspace(-REACH, REACH, 4 * RINGS + 1)
    heights = [h for h in (0.0, 0.15, -0.15, 0.3, -0.3, 0.5, -0.5) if failed.position[2] + h >= 0.0]
    (lx, ly), (x, y, z) = failed.left, failed.position
    pairs = sorted(((abs(s) + abs(h), float(s), h) for s in steps for h in heights), key=lambda pair: pair[0])
    faced = next((w for w in scene.room.walls if w.name == failed.support and w.is_faced(failed.yaw)), None)
    yaw = failed.yaw if faced is None else faced.yaw
    return [
        placed_at(scene, asset, id=failed.id, position=(round(x + lx * s, 3), round(y + ly * s, 3), z + h), yaw=yaw)
        for _, s, h in pairs
        if z + h + asset.size[2] <= scene.room.height
    ]


def first_pose(scene: Arrangement, asset: Known, id: str) -> Placement:
    """A place to begin a search from: the middle of the floor, of the longest wall or of the largest surface."""
    x, y = scene.room.polygon.representative_point().coords[0]
    position, yaw = (round(x, 3), round(y, 3), 0.0), 0.0
    if asset.mount == "wall":
        wall = max(scene.room.walls, key=lambda wall: wall.length)
        x, y = wall.point(wall.length / 2, asset.size[0] / 2 + BACK_GAP)
        position, yaw = (round(x, 4), round(y, 4), max(0.0, EYE - asset.size[2] / 2)), wall.yaw
    elif asset.mount == "ceiling":
        position = (*position[:2], round(scene.room.height - asset.size[2], 4))
    elif asset.mount == "surface":
        tops = [(p, s) for p in scene.placements for s in scene.asset_of(p).surfaces if not s.within]
        if tops:
            carrier, surface = max(tops, key=lambda top: top[1].size[0] * top[1].size[1])
            x, y = carrier.to_room((surface.position[0], surface.position[1]))
            position = (round(x, 3), round(y, 3), round(carrier.position[2] + surface.position[2], 4))
    return placed_at(scene, asset, id=id, position=position, yaw=yaw)
