"""Coming to where something else stood or hung: "put the chair where the plant was", "and a plant there"."""

import math
from collections.abc import Iterator, Sequence

from msgspec import structs

from thinkblox.editing.goals import At, Goal, Spot
from thinkblox.editing.reaching import without
from thinkblox.editing.spots import Pose, along_walls, at_wall, whole_floor
from thinkblox.editing.work import Work
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import BACK_GAP
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene

THERE = 0.75
"""How far from where something was another may stand that comes there [m]."""
ABOUT = 0.3
"""How far from a spot something may stand that is left where it is [m]."""
SAME_PLACE = 0.1
"""The same where the spot is that of another thing [m]."""


def at_spot(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Where another thing stood, as that was turned, and the free places about it: at a wall where it was at one."""
    asset = work.asset_of(id)
    for goal in goals:
        if type(goal) is At and goal.reach >= THERE and asset.mount == "floor":
            yield from along_walls(_without(work, id), asset, goal.point, THERE)
            yield from whole_floor(
                _without(work, id), asset, structs.replace(work.scene[id], position=(*goal.point, 0.0))
            )
    for old in (goal.old for goal in goals if isinstance(goal, Spot) and goal.old is not None):
        if asset.mount == "wall" and old.support.endswith("_wall"):
            yield _hung(work.scene, asset, old)
        yield (*old.position[:2], old.position[2] if asset.mount != "floor" else 0.0), old.yaw
        if asset.mount == "floor" and at_wall(work.start, old.id):
            yield from along_walls(_without(work, id), asset, old.position[:2], THERE)
        start = structs.replace(work.scene[id], position=old.position, yaw=old.yaw)
        yield from whole_floor(_without(work, id), asset, start)


def there_where(work: Work, id: str, old: Placement) -> At:
    """At the place of what is gone; right where that hung, for what hangs too."""
    hangs = work.asset_of(id).mount == "wall" and old.support.endswith("_wall")
    return Spot(old.position[:2], THERE, old=old) if hangs else At(old.position[:2], THERE)


def is_there(work: Work, goal: At, id: str) -> bool:
    """Whether something need not be moved to be at a spot: it is about there, or right where another thing was."""
    near = ABOUT if not isinstance(goal, Spot) else SAME_PLACE
    away = math.dist(work.scene[id].position[:2], goal.point)
    return max(away, goal.higher(work.scene[id]) if isinstance(goal, Spot) else 0.0) <= near


def _hung(scene: Scene, asset: Asset, old: Placement) -> Pose:
    """On the same wall, with its middle where that of the other was."""
    wall = scene.room.wall(old.support)
    x, y = wall.point(wall.coordinates(old.position[:2])[0], asset.size[0] / 2 + BACK_GAP)
    return (round(x, 4), round(y, 4), round(old.position[2] + (old.size[2] - asset.size[2]) / 2, 4)), wall.yaw


def _without(work: Work, id: str) -> Scene:
    """The room without an object and what rests on it."""
    return without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
