"""Places that follow from what an order says: free seats round a table, and the stretch of floor before a window."""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise

import numpy as np
from shapely import Point, Polygon
from shapely.ops import nearest_points

from thinkblox.brief import RelationKind
from thinkblox.editing.goals import (
    BEFORE_SEAT,
    TOUCHES,
    Abreast,
    Across,
    AtHead,
    BySmall,
    Goal,
    Laid,
    Level,
    MidOf,
    OnWall,
    Related,
    middle_height,
)
from thinkblox.scene.asset import Asset
from thinkblox.scene.bearings import bearing, place_of
from thinkblox.scene.landmarks import Landmark, corners, things, walls
from thinkblox.scene.nearby import BACK_GAP, EYE
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Opening, Wall, turn_between
from thinkblox.scene.scene import Scene
from thinkblox.scene.windows import covered_openings
from thinkblox.value import Vec2, Vec3

Pose = tuple[Vec3, float]
"""Position [m] and yaw [degrees], as of a Placement."""
DRAWN_UP = (-0.08, 0.0, 0.08, 0.2, 0.3)
"""Gaps between a seat and the table that it is drawn up to; below 0 it is pushed under the top [m]."""
ABOUT = 12.0
"""Between places that are tried about a round table [degrees]."""
STEP = 0.05
"""Between places that are tried along a side [m]."""
LINE = 100
"""So many of these steps at most."""
GRID = 0.2
"""Between places on the whole floor [m]."""
OVER, AT_BACK = 0.2, 0.3
"""How far above a thing something hangs, and how far off its wall that stands at most [m]."""
BACK = (0.02, 0.1, 0.25)
"""Gaps to the wall of what stands before a window [m]."""
BESIDE: tuple[RelationKind, ...] = ("in_front_of", "behind", "left_of", "right_of")
SHARES = (0.5, 0.35, 0.65, 0.2, 0.8)
"""Where along an opening it is tried."""
BESIDE_HUNG = (0.1, 0.05, 0.2, 0.35)
"""Gaps between things that hang side by side [m]."""


def spots(scene: Scene, asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Poses by what the goals name, the likeliest first."""
    if asset.mount != "floor":
        return
    for goal in goals:
        if not isinstance(goal, Related) or goal.negated:
            continue
        if goal.kind in ("around", "at") and goal.anchors and goal.anchors[0] in scene:
            yield from _seats(scene, asset, scene[goal.anchors[0]])
        elif goal.kind in ("under", "next_to", "near") and len(goal.anchors) == 1:
            named = goal.anchors[0]
            yield from _before_windows(
                scene, asset, [o for o in scene.room.openings if o.kind == "window" and named in (o.kind, o.id)]
            )


def likely(scene: Scene, asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Poses at what the goals name, free ones first, then the first of all, which says what is in the way."""
    for goal in goals:
        if isinstance(goal, Across) and asset.mount == "floor":
            yield from free(scene, asset, list(_on_line(scene, MidOf(goal.anchors[0]))))
        if isinstance(goal, MidOf) and asset.mount == "floor":
            yield from free(scene, asset, list(_on_line(scene, goal)))
        if not isinstance(goal, Related) or goal.negated or not goal.anchors:
            continue
        poses = list(_at(scene, asset, goal))
        yield from free(scene, asset, poses)
        yield from poses[:1]


def _on_line(scene: Scene, goal: MidOf) -> Iterator[Pose]:
    """On the line through the middle of a thing, the nearest first, turned to it, away from it and as it is."""
    mark = things(scene, goal.anchor)[0]
    way = math.radians(mark.yaw + (90.0 if goal.across else 0.0))
    for off in (sign * STEP * n for n in range(2, LINE) for sign in (1, -1)):
        x, y = mark.centre[0] + off * math.cos(way), mark.centre[1] + off * math.sin(way)
        if scene.room.polygon.contains(Point(x, y)):
            for turn in (180.0, 0.0, 90.0, 270.0):
                yield (round(x, 4), round(y, 4), 0.0), round((math.degrees(way) + turn) % 360.0, 3) % 360.0


def _at(scene: Scene, asset: Asset, goal: Related) -> Iterator[Pose]:
    name = goal.anchors[0]
    if isinstance(goal, Laid) and goal.seat in scene:
        yield from _before_seat(scene, asset, scene[name], scene[goal.seat])
        return
    if isinstance(goal, Abreast | AtHead) and name in scene:
        yield from _beside(asset, scene[name], "left_of")
        yield from _beside(asset, scene[name], "right_of")
        return
    if isinstance(goal, OnWall | BySmall):
        yield from _hanging(scene, asset, goal) if isinstance(goal, OnWall) else _by_small(asset, scene[name])
        return
    if goal.kind == "above" and asset.mount in ("ceiling", "wall") and name in scene:
        yield from _hanging_over(scene, asset, scene[name])
        return
    if name not in scene and asset.mount == "wall" and goal.kind in ("left_of", "right_of"):
        for opening in (o for o in scene.room.openings if name in (o.id, o.kind)):
            yield from _hanging_beside(scene, asset, opening, goal.kind)
    elif name not in scene:
        yield from _at_part(scene, asset, goal) if asset.mount == "floor" else ()
    elif goal.kind in ("on", "in_centre") and asset.mount == "surface":
        yield from _on_top(scene, asset, scene[name])
    elif goal.kind in (*BESIDE, "next_to"):
        yield from _on_floor_beside(scene, asset, scene[name], goal.kind)


def _on_floor_beside(scene: Scene, asset: Asset, thing: Placement, kind: str) -> Iterator[Pose]:
    """At a side of a thing, or of something small that stands on the floor beside it at any."""
    if kind != "next_to" and asset.mount == "floor":
        yield from _beside(asset, thing, kind)
    elif kind == "next_to" and asset.mount == "floor" and thing.support == "floor":
        yield from _into_room(scene, [pose for side in BESIDE for pose in _beside(asset, thing, side)])
    elif kind == "next_to" and asset.mount == "surface" and thing.support == "floor":
        for side in BESIDE:
            yield from _beside(asset, thing, side)


def _into_room(scene: Scene, poses: Iterable[Pose]) -> list[Pose]:
    """The poses, those first that look most to the middle of the room."""
    x, y = scene.room.polygon.centroid.coords[0]
    return sorted(poses, key=lambda pose: round(turn_between(pose[1], bearing(pose[0][:2], (x, y))) / 45.0))


def _by_small(asset: Asset, thing: Placement) -> Iterator[Pose]:
    """Beside something on the same top: at its right and left first, then all the way about it."""
    if asset.mount != "surface":
        return
    sides = sorted(range(0, 360, 15), key=lambda turn: (turn % 180 != 90, turn))
    for gap in (0.02, 0.06, 0.12):
        for turn in sides:
            for yaw in (0.0, 90.0):
                reach = (max(thing.size[:2]) + asset.size[0 if turn % 180 == yaw % 180 else 1]) / 2 + gap
                yield _off(thing, float(turn), reach, 0.0, yaw, thing.position[2])


def _at_part(scene: Scene, asset: Asset, goal: Related) -> Iterator[Pose]:
    """In a corner, along walls, beside a door or window."""
    if goal.kind == "in_corner":
        for corner in corners(scene.room, goal.anchors):
            yield from _in_corner(asset, corner)
    elif goal.kind == "against_wall":
        for wall in (wall for name in goal.anchors for wall in walls(scene.room, name)):
            yield from _at_wall(asset, wall)
    elif goal.kind in ("left_of", "right_of", "next_to"):
        for opening in (o for o in scene.room.openings if goal.anchors[0] in (o.id, o.kind)):
            for side in ("left_of", "right_of") if goal.kind == "next_to" else (goal.kind,):
                yield from _beside_opening(scene, asset, opening, side)


def _hanging(scene: Scene, asset: Asset, goal: OnWall) -> Iterator[Pose]:
    """At eye height on the walls that are named, the middle of each first."""
    if asset.mount != "wall":
        return
    height = round(max(0.0, min(EYE - asset.size[2] / 2, scene.room.height - asset.size[2])), 4)
    for wall in (wall for name in goal.anchors for wall in walls(scene.room, name)):
        reach = wall.length / 2 - asset.size[1] / 2
        for off in sorted(np.arange(-reach, reach + 1e-6, 2 * STEP), key=abs):
            x, y = wall.point(wall.length / 2 + float(off), BACK_GAP + asset.size[0] / 2)
            pose: Pose = (round(x, 4), round(y, 4), height), wall.yaw
            if not hides_opening(scene, asset, wall, pose):
                yield pose


def _hanging_over(scene: Scene, asset: Asset, thing: Placement) -> Iterator[Pose]:
    """From the ceiling over a thing, or on the wall that it is at, at several heights, off its doors and windows."""
    if asset.mount == "ceiling":
        yield (*thing.position[:2], scene.room.height - asset.size[2]), thing.yaw
        return
    beyond, aside = scene.room.height - asset.size[2], thing.size[1] / 2
    for wall in scene.room.walls:
        along, inward = wall.coordinates(thing.position[:2])
        if not 0.0 <= inward <= max(thing.size[:2]) / 2 + AT_BACK:
            continue
        lintels = [o.sill + o.height for o in scene.room.openings if scene.room.walls[o.wall].name == wall.name]
        low = [max(thing.top + OVER, EYE - asset.size[2] / 2), thing.top + OVER, thing.top + 0.05]
        for height in (h for h in (*low, *(top + OVER / 4 for top in lintels)) if thing.top <= h <= beyond):
            for off in sorted(np.arange(-aside - OVER, aside + OVER, STEP), key=abs):
                x, y = wall.point(along + float(off), BACK_GAP + asset.size[0] / 2)
                pose: Pose = (round(x, 4), round(y, 4), round(height, 4)), wall.yaw
                if not hides_opening(scene, asset, wall, pose):
                    yield pose


def _hanging_beside(scene: Scene, asset: Asset, opening: Opening, kind: str) -> Iterator[Pose]:
    """At eye height on the wall beside a door or window, the nearest first."""
    height = round(max(0.0, min(EYE - asset.size[2] / 2, scene.room.height - asset.size[2])), 4)
    for (x, y, _), yaw in _beside_opening(scene, asset, opening, kind):
        wall = scene.room.walls[opening.wall]
        along, _ = wall.coordinates((x, y))
        x, y = wall.point(along, BACK_GAP + asset.size[0] / 2)
        yield (round(x, 4), round(y, 4), height), yaw


def hides_opening(scene: Scene, asset: Asset, wall: Wall, pose: Pose) -> bool:
    """Whether something that hangs at a pose on a wall covers a part of a door or window."""
    position, yaw = pose
    hung = Placement(id="hung", asset=asset.id, category=asset.category, size=asset.size,
                     position=position, yaw=yaw, support=wall.name)  # fmt: skip
    return bool(covered_openings(scene.room, hung))


def _before_seat(scene: Scene, asset: Asset, table: Placement, seat: Placement) -> Iterator[Pose]:
    """On the highest top of a table, from its edge before a seat inwards, turned to who sits there."""
    tops = [s.position[2] for s in scene.asset_of(table).surfaces if not s.inner]
    for ahead in np.arange(0.2, BEFORE_SEAT, STEP):
        for left in (0.0, 0.1, -0.1, 0.15, -0.15, 0.2, -0.2):
            x, y = seat.to_room((float(ahead), left))
            height = round(table.position[2] + max(tops, default=table.size[2]), 4)
            yield (round(x, 4), round(y, 4), height), round((seat.yaw + 180.0) % 360.0, 3) % 360.0


def _on_top(scene: Scene, asset: Asset, thing: Placement) -> Iterator[Pose]:
    """On the tops of a thing, the middle first."""
    for surface in sorted(scene.asset_of(thing).surfaces, key=lambda s: (s.inner, -s.position[2])):
        reach = [max(0.0, (side - max(asset.size[:2])) / 2) for side in surface.size]
        steps = [np.arange(-r, r + 1e-6, max(STEP, r / 4)) for r in reach]
        offsets = sorted(((float(x), float(y)) for x in steps[0] for y in steps[1]), key=lambda o: math.hypot(*o))
        for dx, dy in [(0.0, 0.0), *offsets]:
            x, y = thing.to_room((surface.position[0] + dx, surface.position[1] + dy))
            yield (round(x, 4), round(y, 4), round(thing.position[2] + surface.position[2], 4)), thing.yaw


def _in_corner(asset: Asset, corner: Landmark) -> Iterator[Pose]:
    """With the back to either wall of a corner, or across it."""
    across = math.radians(corner.yaw)
    yaws = [round((corner.yaw + turn) % 360.0, 3) for turn in (-45.0, 45.0, 0.0)]
    for gap in BACK:
        for yaw in yaws:
            way = math.radians(yaw)
            out = [abs(math.cos(way)) * asset.size[k] / 2 + abs(math.sin(way)) * asset.size[1 - k] / 2 for k in (0, 1)]
            x = corner.centre[0] + math.copysign(out[0] + gap, math.cos(across))
            y = corner.centre[1] + math.copysign(out[1] + gap, math.sin(across))
            yield (round(x, 4), round(y, 4), 0.0), yaw


def _at_wall(asset: Asset, wall: Wall) -> Iterator[Pose]:
    """Side by side along a wall from its one end to the other."""
    for gap in BACK:
        for along in np.arange(asset.size[1] / 2 + 0.02, wall.length - asset.size[1] / 2, STEP):
            x, y = wall.point(float(along), gap + asset.size[0] / 2)
            yield (round(x, 4), round(y, 4), 0.0), wall.yaw


def at_wall(scene: Scene, id: str) -> bool:
    """Whether something stands with its back to a wall."""
    return scene[id].support == "floor" and measure(scene, "against_wall", id, ("wall",)).holds


def middle_off(scene: Scene, id: str, kind: str, anchors: Sequence[str]) -> float:
    """How far a thing is from the middle of the room, or of the way between two things [m]; else 0."""
    middle = _middle(scene, kind, anchors)
    return math.dist(scene[id].position[:2], middle) if middle is not None else 0.0


def _middle(scene: Scene, kind: str, anchors: Sequence[str]) -> Vec2 | None:
    if kind == "in_centre" and anchors == ("centre",):
        x, y = scene.room.polygon.centroid.coords[0]
        return (x, y)
    if kind != "between" or len(anchors) != 2:
        return None
    one, other = (next(iter(things(scene, name)), None) for name in anchors)
    if one is None or other is None:
        return None
    a, b = nearest_points(one.footprint, other.footprint)
    middle, gap = ((a.x + b.x) / 2, (a.y + b.y) / 2), math.dist((a.x, a.y), (b.x, b.y))
    if one.kind != "object" or other.kind != "object" or gap < TOUCHES:
        return middle
    across = ((a.y - b.y) / gap, (b.x - a.x) / gap)
    x, y = ((p + q) / 2 for p, q in zip(one.centre, other.centre, strict=True))
    aside = (x - middle[0]) * across[0] + (y - middle[1]) * across[1]
    return (middle[0] + aside * across[0], middle[1] + aside * across[1])


def near_offsets(reach: float) -> list[Vec2]:
    """Steps in every direction no further than `reach` [m], the shortest first."""
    steps = np.arange(-reach, reach + 1e-6, STEP)
    offsets = ((round(float(x), 3), round(float(y), 3)) for x in steps for y in steps if math.hypot(x, y) <= reach)
    return sorted(offsets, key=lambda step: (round(math.hypot(*step), 3), step))


def between(scene: Scene, asset: Asset, anchors: Sequence[str], yaw: float) -> Iterator[Pose]:
    """Poses between two things that look free from above, the nearest to the middle of the way there first.

    What hangs is between two that hang on one wall at their height.
    """
    hung = [scene[name] for name in anchors if name in scene]
    if asset.mount == "wall":
        wall = next((w for w in scene.room.walls if {p.support for p in hung} == {w.name}), None)
        if wall is not None and len(hung) == 2:
            along = sum(wall.coordinates(p.position[:2])[0] for p in hung) / 2
            height = sum(p.position[2] + p.size[2] / 2 for p in hung) / 2 - asset.size[2] / 2
            x, y = wall.point(along, BACK_GAP + asset.size[0] / 2)
            yield (round(x, 4), round(y, 4), round(max(0.0, height), 4)), wall.yaw
        return
    middle = _middle(scene, "between", anchors)
    if middle is None:
        return
    steps = np.arange(-1.0, 1.001, 2 * STEP)
    offsets = sorted(((float(x), float(y)) for x in steps for y in steps), key=lambda o: math.hypot(*o))
    turns = (0.0,) if asset.front == "any" else (0.0, 90.0, 180.0, 270.0)
    poses: list[Pose] = [
        ((round(middle[0] + dx, 4), round(middle[1] + dy, 4), 0.0), round((yaw + turn) % 360.0, 3) % 360.0)
        for dx, dy in offsets
        for turn in turns
    ]
    yield from free(scene, asset, poses)


def levelled(scene: Scene, asset: Asset, goals: Sequence[Goal], poses: Iterable[Pose]) -> Iterator[Pose]:
    """The poses as they are; as high up as is asked, and then those beside what that is as high as."""
    anchor = next((goal.anchor for goal in goals if isinstance(goal, Level)), "")
    for (x, y, z), yaw in chain(poses, _beside_hung(scene, asset, scene[anchor]) if anchor else ()):
        high = middle_height(scene[anchor]) - asset.size[2] / 2 if anchor else z
        yield (x, y, round(high, 4)), yaw


def _beside_hung(scene: Scene, asset: Asset, thing: Placement) -> Iterator[Pose]:
    """Places on the wall that something hangs on, to either side of it."""
    wall = scene.room.wall(thing.support)
    along = wall.coordinates(thing.position[:2])[0]
    for gap in BESIDE_HUNG:
        for sign in (1.0, -1.0):
            off = sign * ((thing.size[1] + asset.size[1]) / 2 + gap)
            x, y = wall.point(along + off, asset.size[0] / 2 + BACK_GAP)
            yield (round(x, 4), round(y, 4), thing.position[2]), wall.yaw


def along_walls(scene: Scene, asset: Asset, spot: Vec2, reach: float) -> Iterator[Pose]:
    """With the back to a wall, no further than `reach` from a spot [m] and free from above, the nearest first."""
    poses: list[Pose] = []
    for wall in scene.room.walls:
        for along in np.arange(asset.size[1] / 2 + 0.02, wall.length - asset.size[1] / 2, 2 * STEP):
            x, y = wall.point(float(along), BACK[0] + asset.size[0] / 2)
            if math.dist((x, y), spot) <= reach:
                poses.append(((round(x, 4), round(y, 4), 0.0), wall.yaw))
    poses.sort(key=lambda pose: math.dist(pose[0][:2], spot))
    yield from free(scene, asset, poses)


def _beside(asset: Asset, thing: Placement, kind: str) -> Iterator[Pose]:
    """At one side of a thing, turned as that is, or to it."""
    turn = {"in_front_of": 0.0, "behind": 180.0, "left_of": 90.0, "right_of": 270.0}[kind]
    deep, wide = (thing.size[0], thing.size[1]) if turn in (0.0, 180.0) else (thing.size[1], thing.size[0])
    for gap in (0.08, 0.2, 0.35, 0.02, 0.5):
        for yaw in (0.0, turn + 180.0, 90.0, 180.0, 270.0):
            flat = (yaw - turn) % 180.0 == 0.0
            away = deep / 2 + gap + asset.size[0 if flat else 1] / 2
            for share in (0.0, -0.25, 0.25, -0.5, 0.5):
                yield _off(thing, turn, away, share * wide, yaw)


def _off(thing: Placement, turn: float, away: float, along: float, yaw: float, height: float = 0.0) -> Pose:
    angle = math.radians(turn)
    x, y = thing.to_room(
        (away * math.cos(angle) - along * math.sin(angle), away * math.sin(angle) + along * math.cos(angle))
    )
    return (round(x, 4), round(y, 4), height), round((thing.yaw + yaw) % 360.0, 3) % 360.0


def _beside_opening(scene: Scene, asset: Asset, opening: Opening, kind: str) -> Iterator[Pose]:
    """With the back to the wall beside a door or window; its left is seen as one looks out of it into the room."""
    wall = scene.room.walls[opening.wall]
    for gap in (0.1, 0.25, 0.4, 0.02):
        off = gap + asset.size[1] / 2
        along = opening.offset - off if kind == "left_of" else opening.offset + opening.width + off
        x, y = wall.point(along, BACK[0] + asset.size[0] / 2)
        yield (round(x, 4), round(y, 4), 0.0), wall.yaw


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
    yield from free(scene, asset, poses)


def _seats(scene: Scene, asset: Asset, table: Placement) -> Iterator[Pose]:
    """Seats that look free from above, packed along each side from one end, those at the longer sides first; at a table
    that looks the same from all sides, others all the way about it.
    """
    half_x, half_y = table.size[0] / 2, table.size[1] / 2
    sides = sorted(((0.0, half_x, half_y), (180.0, half_x, half_y), (90.0, half_y, half_x), (270.0, half_y, half_x)),
                   key=lambda side: -side[2])  # fmt: skip
    poses: list[Pose] = []
    for gap in DRAWN_UP:
        for turn, out, along in sides:
            reach = max(0.0, along - asset.size[1] / 2 + 0.05)
            away = out + gap + asset.size[0] / 2
            poses += [_at_side(table, turn, away, float(s)) for s in np.arange(-reach, reach + 1e-6, STEP)]
    if scene.asset_of(table).front == "any":
        poses += _around(asset, table)
    yield from free(scene, asset, poses, besides=table.id)


def _around(asset: Asset, table: Placement) -> Iterator[Pose]:
    """Seats that look at the middle of a round table, all the way about it."""
    for gap in DRAWN_UP:
        for turn in np.arange(0.0, 360.0, ABOUT):
            yield _at_side(table, float(turn), max(table.size[:2]) / 2 + gap + asset.size[0] / 2, 0.0)


def _at_side(table: Placement, turn: float, away: float, along: float) -> Pose:
    """A seat that looks at a table from one side of it."""
    angle = math.radians(turn)
    local: Vec2 = (
        away * math.cos(angle) - along * math.sin(angle),
        away * math.sin(angle) + along * math.cos(angle),
    )
    x, y = table.to_room(local)
    return (round(x, 4), round(y, 4), 0.0), round((table.yaw + turn + 180.0) % 360.0, 3) % 360.0


def _before_windows(scene: Scene, asset: Asset, windows: Sequence[Opening]) -> Iterator[Pose]:
    """With the back to the wall below a window: free places first, then one that says what is in the way."""
    poses: list[Pose] = []
    for opening in windows:
        wall = scene.room.walls[opening.wall]
        for gap in BACK:
            for share in SHARES:
                x, y = wall.point(opening.offset + share * opening.width, gap + asset.size[0] / 2)
                poses.append(((round(x, 4), round(y, 4), 0.0), wall.yaw))
    yield from free(scene, asset, poses)
    yield from poses[:1]


def free(scene: Scene, asset: Asset, poses: Sequence[Pose], *, besides: str = "") -> Iterator[Pose]:
    """Those of the poses that look free from above."""
    if not poses:
        return
    rows = [((x, y), asset.size[:2], yaw, z, z + asset.size[2]) for (x, y, z), yaw in poses]
    others = tuple(p for p in scene.placements if scene.asset_of(p).collides and p.id != besides)
    rects = Rects.of(rows)
    blocked = overlap_depth(rects, Rects.of_placements(others)).max(-1, initial=0.0) if others else np.zeros(len(rows))
    for index in np.flatnonzero((blocked < 0.001) & (outside(rects, scene.room.polygon) < 0.0005)):
        yield poses[int(index)]


def by_gap(scene: Scene, placement: Placement, anchors: Sequence[str], lengths: Iterable[float]) -> Iterator[Pose]:
    """Away from the nearest of the anchors by each of the lengths [m]; towards it where they are negative."""
    mark = things(scene, placement.id)[0]
    marks = [m for name in anchors for m in things(scene, name)]
    anchor = min(marks, key=lambda m: float(mark.footprint.distance(m.footprint)))
    x, y = _nearest_way(mark, anchor)
    for length in lengths:
        yield shifted(placement, (-x * length, -y * length, 0.0)), placement.yaw


def _nearest_way(mark: Landmark, anchor: Landmark) -> Vec2:
    """Unit vector from the outline of one thing to the nearest point of another's."""
    one, other = nearest_points(mark.footprint, place_of(anchor))
    dx, dy = other.x - one.x, other.y - one.y
    if math.hypot(dx, dy) < 1e-6:
        return _way_in(mark, anchor)
    length = math.hypot(dx, dy) or 1.0
    return (dx / length, dy / length)


def _way_in(mark: Landmark, anchor: Landmark) -> Vec2:
    """Unit vector into a thing that another touches or overlaps, across the side at which that is."""
    box = place_of(anchor).minimum_rotated_rectangle
    outline = box.exterior if isinstance(box, Polygon) else box
    corners = [(float(x), float(y)) for x, y in outline.coords]
    best, depth = (1.0, 0.0), -math.inf
    for (ax, ay), (bx, by) in pairwise(corners):
        length = math.hypot(bx - ax, by - ay)
        if length < 1e-6:
            continue
        for sign in (1.0, -1.0):
            out = (sign * (by - ay) / length, -sign * (bx - ax) / length)
            reach = max(x * out[0] + y * out[1] for x, y in corners)
            beyond = mark.centre[0] * out[0] + mark.centre[1] * out[1] - reach
            if beyond > depth:
                best, depth = (-out[0], -out[1]), beyond
    return best


def shifted(placement: Placement, by: Vec3) -> Vec3:
    """Where something is that has been moved by so much [m]."""
    x, y, z = (round(a + b, 4) for a, b in zip(placement.position, by, strict=True))
    return (x, y, z)
