"""What stands along a wall or a window with its long or its short side, whichever of its sides that is."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Apart, Goal, Related, Turned
from thinkblox.editing.spots import STEP, Pose, free
from thinkblox.editing.wheres import bound
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.asset import Asset
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene

BY_WALL = 0.1
"""How far from the wall it stands at most [m]."""
GAP = 0.02
"""How far it is put from it [m]."""
ALIKE = 0.05
"""By how much one side is longer than the other of what has a long side [m]."""


def lengthwise(work: Work, finder: Finder, id: str, where: Where) -> Iterator[Goal]:
    """What a thing of which a side is along a wall is to meet: its back there, or turned across.

    Raises:
        InputError: all of its sides are as long, or it could be several walls.
    """
    deep, wide, _ = work.scene[id].size
    if where.noun is not None and where.noun.kind == "place" and where.noun.value == "window":
        yield from _before_window(work, id, where, wide > deep)
        return
    names = bound(Where("against", where.noun, text="against"), work.scene[id].category, finder).anchors
    walls = [wall for wall in work.scene.room.walls if wall.name in names]
    if abs(deep - wide) < ALIKE:
        raise InputError(f"{id} is as wide as it is deep ({wide:.2f} by {deep:.2f} m): it has no long side")
    if not walls and names == ("wall",):
        here = work.scene[id].position[:2]
        walls = [min(work.scene.room.walls, key=lambda wall: abs(wall.coordinates(here)[1]))]
    if len(walls) != 1:
        raise InputError(f"'{where.noun.text if where.noun else 'the wall'}': which wall? Say 'the north wall'")
    if (wide > deep) == (where.text == "long_side"):
        yield Related("against_wall", (walls[0].name,))
        return
    yield Turned(((walls[0].yaw + 90.0) % 360.0, (walls[0].yaw - 90.0) % 360.0))
    yield Apart((walls[0].name,), BY_WALL, "le")


def _before_window(work: Work, id: str, where: Where, wider: bool) -> Iterator[Goal]:
    """Before the nearest window, with the side that is said along its wall.

    Raises:
        InputError: all sides are as long, or there is no window.
    """
    deep, wide, _ = work.scene[id].size
    here = work.scene[id].position[:2]
    windows = [o for o in work.scene.room.openings if o.kind == "window"]
    if abs(deep - wide) < ALIKE:
        raise InputError(f"{id} is as wide as it is deep ({wide:.2f} by {deep:.2f} m): it has no long side")
    if not windows:
        raise InputError("the room has no window")
    window = min(windows, key=lambda o: math.dist(things(work.scene, o.id)[0].centre, here))
    yaw = work.scene.room.walls[window.wall].yaw
    along = wider == (where.text == "long_side")
    turns = (0.0, 180.0) if along else (90.0, 270.0)
    yield Related("in_front_of", (window.id,))
    yield Turned(tuple((yaw + turn) % 360.0 for turn in turns))


def beside_wall(scene: Scene, asset: Asset, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Free places along a wall with a side to it, the nearest first, where that is what the goals ask for."""
    yaws = next((goal.yaws for goal in goals if isinstance(goal, Turned) and len(goal.yaws) == 2), ())
    near = next((goal.anchors for goal in goals if isinstance(goal, Apart) and goal.bound == "le"), ())
    walls = [wall for wall in scene.room.walls if wall.name in near]
    if not yaws or not walls or asset.mount != "floor":
        return
    wall = walls[0]
    along, _ = wall.coordinates(before.position[:2])
    reach = wall.length - asset.size[0] / 2
    spots = sorted(np.arange(asset.size[0] / 2, reach, STEP), key=lambda at: abs(float(at) - along))
    poses: list[Pose] = []
    for at in spots:
        x, y = wall.point(float(at), GAP + asset.size[1] / 2)
        poses += [((round(x, 4), round(y, 4), 0.0), yaw) for yaw in yaws]
    yield from free(scene.without(before.id), asset, poses)
