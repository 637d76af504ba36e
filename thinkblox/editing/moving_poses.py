"""Where a thing that is moved may stand, by what is asked of it: what is nearest to where it was first."""

import math
from collections.abc import Iterator, Sequence
from itertools import chain

from msgspec import structs

from thinkblox.editing.goals import (
    Across,
    Apart,
    BackTo,
    Goal,
    IntoRoom,
    MidOf,
    Midway,
    Nearing,
    OnSide,
    Related,
)
from thinkblox.editing.reaching import without
from thinkblox.editing.spots import (
    BACK,
    Pose,
    along_walls,
    at_wall,
    between,
    by_gap,
    shifted,
    spots,
    whole_floor,
)
from thinkblox.editing.stepping import SLIGHT_STEPS, STEPS
from thinkblox.editing.turning import turns
from thinkblox.editing.work import Work
from thinkblox.scene.asset import Asset
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene

SHARES = (0.5, 0.65, 0.35, 0.8, 0.2, 0.95)
"""Which share of a gap is closed where nobody says it."""
FAR_OFF, NEARER = 1.5, 0.7
"""From how far off what stands at a wall comes closer along walls [m], and to which share of the way at most."""
SLIGHT_SHARES = (0.25, 0.15, 0.35)
"""The same for "a bit"."""


def half_poses(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Along the walls of that half, the nearest to the middle of its wall first, and then on its whole floor."""
    wall = next(work.scene.room.wall(goal.wall) for goal in goals if isinstance(goal, OnSide))
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    middle = wall.point(wall.length / 2, 0.0)
    asset, before = work.asset_of(id), work.scene[id]
    x, y = work.scene.room.polygon.centroid.coords[0]
    _, half = wall.coordinates((x, y))
    poses = chain(
        along_walls(empty, asset, middle, math.inf) if at_wall(work.scene, id) else (),
        whole_floor(empty, asset, structs.replace(before, position=(*middle, before.position[2]))),
    )
    yield from (pose for pose in poses if wall.coordinates(pose[0][:2])[1] < half)


def spots_for(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Places that the goals name, seen without the object and what rests on it."""
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    before = work.scene[id]
    if any(isinstance(goal, Related) and goal.kind == "in_centre" and goal.anchors == ("centre",) for goal in goals):
        x, y = work.scene.room.polygon.centroid.coords[0]
        yield from whole_floor(empty, work.asset_of(id), structs.replace(before, position=(x, y, before.position[2])))
    if any(isinstance(g, Related) and g.kind == "against_wall" and g.anchors == ("wall",) for g in goals):
        yield from _straight_back(empty, work.asset_of(id), before)
        yield from along_walls(empty, work.asset_of(id), before.position[:2], math.inf)
    for goal in goals:
        if isinstance(goal, Related) and goal.kind == "between" and work.asset_of(id).mount in ("floor", "wall"):
            yield from between(empty, work.asset_of(id), goal.anchors, before.yaw)
    yield from spots(empty, work.asset_of(id), goals)


def _straight_back(scene: Scene, asset: Asset, before: Placement) -> Iterator[Pose]:
    """At the wall behind its back, turned as it is."""
    for wall in scene.room.walls if asset.front == "one" else ():
        if turn_between(wall.yaw, before.yaw) < 1.0:
            x, y = wall.point(wall.coordinates(before.position[:2])[0], BACK[0] + asset.size[0] / 2)
            yield (round(x, 4), round(y, 4), before.position[2]), wall.yaw


def midway(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, moved along the line between two things to the middle of it."""
    for goal in (g for g in goals if isinstance(g, Midway)):
        off, way = goal.off(scene, before.position[:2])
        yield shifted(before, (-off * way[0], -off * way[1], 0.0)), before.yaw


def onto_line(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, moved aside onto the line through the middle of a thing."""
    for goal in [MidOf(g.anchors[0]) if isinstance(g, Across) else g for g in goals]:
        if not isinstance(goal, MidOf):
            continue
        mark = things(scene, goal.anchor)[0]
        ahead, left = mark.to_local(before.position[:2])
        off, way = (ahead, mark.yaw) if goal.across else (left, mark.yaw + 90.0)
        x, y = math.cos(math.radians(way)), math.sin(math.radians(way))
        yield shifted(before, (-off * x, -off * y, 0.0)), before.yaw


def in_line(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, where only the front is to point elsewhere."""
    if goals and all(
        isinstance(goal, IntoRoom | BackTo) or (isinstance(goal, Related) and goal.kind == "facing") for goal in goals
    ):
        yield from turns(scene, before, goals)


def so_far_off(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Before, behind and beside a thing, at the distance that is wanted and turned to it."""
    for goal in (g for g in goals if isinstance(g, Apart)):
        for anchor in (scene[name] for name in goal.anchors if name in scene):
            for turn in (0.0, 180.0, 90.0, 270.0):
                way = math.radians(anchor.yaw + turn)
                deep = anchor.size[0] if turn in (0.0, 180.0) else anchor.size[1]
                reach = (deep + before.size[0]) / 2 + goal.away
                x, y = anchor.position[0] + reach * math.cos(way), anchor.position[1] + reach * math.sin(way)
                yaw = (anchor.yaw + turn + 180.0) % 360.0
                yield (round(x, 4), round(y, 4), before.position[2]), yaw


def by_so_much(scene: Scene, placement: Placement, gap: Nearing) -> Iterator[Pose]:
    """Nearer to something, or further from it: by what is said, or by several shares of the way."""
    now = gap.of(scene, placement.id)
    if gap.by is not None:
        lengths: tuple[float, ...] = (gap.by,)
    elif gap.nearer:
        shares = SLIGHT_SHARES if gap.slight else SHARES
        lengths = tuple(share * now for share in shares) if now > 0.005 else ()
    else:
        lengths = SLIGHT_STEPS if gap.slight else STEPS
    yield from by_gap(scene, placement, gap.anchors, [-length if gap.nearer else length for length in lengths])


def along_wall_to(work: Work, id: str, gap: Nearing) -> Iterator[Pose]:
    """About half of the way to what is far off, for what stands at a wall: at a wall again."""
    before, asset = work.scene[id], work.asset_of(id)
    marks = [mark for name in gap.anchors for mark in things(work.scene, name)]
    plain = gap.nearer and gap.by is None and not gap.slight and len(marks) == 1
    if not plain or not at_wall(work.scene, id) or gap.of(work.scene, id) < FAR_OFF:
        return
    now, there = math.dist(before.position[:2], marks[0].centre), marks[0].centre
    poses = along_walls(without(work.scene, [id, *(r.id for r in work.scene.riders(id))]), asset, there, NEARER * now)
    yield from sorted(poses, key=lambda pose: abs(math.dist(pose[0][:2], there) - now / 2))


def moved_aside(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, moved to the distance that is wanted."""
    for goal in (g for g in goals if isinstance(g, Apart)):
        if any(things(scene, name) for name in goal.anchors):
            yield from by_gap(scene, before, goal.anchors, [goal.away - goal.of(scene, before.id)])
