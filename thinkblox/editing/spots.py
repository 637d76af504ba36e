"""Places that follow from what an order says: free seats round a table, and the stretch of floor before a window."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from thinkblox.editing.goals import Goal, Related
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2, Vec3

Pose = tuple[Vec3, float]
"""Position [m] and yaw [degrees], as of a Placement."""
DRAWN_UP = (-0.08, 0.0, 0.08, 0.2, 0.3)
"""Gaps between a seat and the table that it is drawn up to; below 0 it is pushed under the top [m]."""
STEP = 0.05
"""Between places that are tried along a side [m]."""
GRID = 0.2
"""Between places on the whole floor [m]."""
BACK = (0.02, 0.1, 0.25)
"""Gaps to the wall of what stands before a window [m]."""
SHARES = (0.5, 0.35, 0.65, 0.2, 0.8)
"""Where along an opening it is tried."""


def spots(scene: Scene, asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Poses by what the goals name, the likeliest first."""
    if asset.mount != "floor":
        return
    for goal in goals:
        if not isinstance(goal, Related) or goal.negated:
            continue
        if goal.kind in ("around", "at") and goal.anchors and goal.anchors[0] in scene:
            yield from _seats(scene, asset, scene[goal.anchors[0]])
        elif goal.anchors == ("window",) and goal.kind in ("under", "next_to", "near"):
            yield from _before_windows(scene, asset)


def whole_floor(scene: Scene, asset: Asset, start: Placement) -> Iterator[Pose]:
    """The whole floor by distance from a pose, turned as that is and by quarter turns, where it looks free."""
    x0, y0, x1, y1 = scene.room.polygon.bounds
    turns = (0.0,) if asset.front == "any" else (0.0, 90.0, 180.0, 270.0)
    points = [
        (round(float(x), 3), round(float(y), 3)) for x in np.arange(x0, x1, GRID) for y in np.arange(y0, y1, GRID)
    ]
    points.sort(key=lambda point: math.dist(point, start.position[:2]))
    poses: list[Pose] = [
        ((x, y, 0.0), round((start.yaw + turn) % 360.0, 3) % 360.0) for x, y in points for turn in turns
    ]
    yield from _free(scene, asset, poses)


def _seats(scene: Scene, asset: Asset, table: Placement) -> Iterator[Pose]:
    """Seats that look free from above, packed along each side from one end, those at the longer sides first."""
    half_x, half_y = table.size[0] / 2, table.size[1] / 2
    sides = sorted(((0.0, half_x, half_y), (180.0, half_x, half_y), (90.0, half_y, half_x), (270.0, half_y, half_x)),
                   key=lambda side: -side[2])  # fmt: skip
    poses: list[Pose] = []
    for gap in DRAWN_UP:
        for turn, out, along in sides:
            reach = max(0.0, along - asset.size[1] / 2 + 0.05)
            away = out + gap + asset.size[0] / 2
            poses += [_at_side(table, turn, away, float(s)) for s in np.arange(-reach, reach + 1e-6, STEP)]
    yield from _free(scene, asset, poses, besides=table.id)


def _at_side(table: Placement, turn: float, away: float, along: float) -> Pose:
    """A seat that looks at a table from one side of it."""
    angle = math.radians(turn)
    local: Vec2 = (
        away * math.cos(angle) - along * math.sin(angle),
        away * math.sin(angle) + along * math.cos(angle),
    )
    x, y = table.to_room(local)
    return (round(x, 4), round(y, 4), 0.0), round((table.yaw + turn + 180.0) % 360.0, 3) % 360.0


def _before_windows(scene: Scene, asset: Asset) -> Iterator[Pose]:
    """With the back to the wall below a window: free places first, then one that says what is in the way."""
    poses: list[Pose] = []
    for opening in scene.room.openings:
        if opening.kind != "window":
            continue
        wall = scene.room.walls[opening.wall]
        for gap in BACK:
            for share in SHARES:
                x, y = wall.point(opening.offset + share * opening.width, gap + asset.size[0] / 2)
                poses.append(((round(x, 4), round(y, 4), 0.0), wall.yaw))
    yield from _free(scene, asset, poses)
    yield from poses[:1]


def _free(scene: Scene, asset: Asset, poses: Sequence[Pose], *, besides: str = "") -> Iterator[Pose]:
    """Those of the poses that look free from above."""
    if not poses:
        return
    rows = [((x, y), asset.size[:2], yaw, z, z + asset.size[2]) for (x, y, z), yaw in poses]
    others = tuple(p for p in scene.placements if scene.asset_of(p).collides and p.id != besides)
    rects = Rects.of(rows)
    blocked = overlap_depth(rects, Rects.of_placements(others)).max(-1, initial=0.0) if others else np.zeros(len(rows))
    for index in np.flatnonzero((blocked < 0.001) & (outside(rects, scene.room.polygon) < 0.0005)):
        yield poses[int(index)]
