"""What stands at a wall and goes beside what stands at one: it stands at a wall again where it can."""

import math
from collections.abc import Iterator, Sequence

from thinkblox.brief import RelationKind
from thinkblox.editing.acting import reach_goals
from thinkblox.editing.goals import Goal, Related
from thinkblox.editing.reaching import without
from thinkblox.editing.spots import Pose, along_walls, at_wall
from thinkblox.editing.work import Work
from thinkblox.plan import is_object
from thinkblox.scene.actions import Move
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene

_BESIDE = ("next_to", "left_of", "right_of")
_ENDS: tuple[RelationKind, ...] = ("in_front_of", "behind")


def beside_at_wall(work: Work, id: str, goals: Sequence[Goal]) -> Sequence[Goal] | None:
    """Move something beside a thing, at a wall as both stand at one; the goals it meets, None where it cannot so."""
    one = goals[0] if len(goals) == 1 else None
    if not isinstance(one, Related) or one.kind not in _BESIDE or one.negated or len(one.anchors) != 1:
        return None
    anchor = one.anchors[0]
    there = is_object(anchor) and anchor in work.scene
    if not there or not (at_wall(work.scene, id) and at_wall(work.scene, anchor)):
        return None
    walled: list[Goal] = [one, Related("against_wall", ("wall",))]
    saved = work.saved()
    if reach_goals(work, id, walled, direct=_poses(work, id, one), search=False) is not None:
        return None
    if _is_ahead(work.scene, id, one):
        work.restore(saved)
        return None
    return walled


def _is_ahead(scene: Scene, id: str, beside: Related) -> bool:
    """Whether something stands before or behind what it is to be beside."""
    return any(measure(scene, kind, id, beside.anchors).holds for kind in _ENDS)


def _poses(work: Work, id: str, beside: Related) -> Iterator[Pose]:
    """With the back to a wall, free from above and where the place is, the nearest to the thing first."""
    scene, asset = work.scene, work.asset_of(id)
    empty = without(scene, [id, *(rider.id for rider in scene.riders(id))])
    for pose in along_walls(empty, asset, scene[beside.anchors[0]].position[:2], math.inf):
        (x, y, z), yaw = pose
        after = scene.apply(Move(id=id, position=(x, y, z), yaw=yaw))
        if beside.check(scene, after, id)[0] and not _is_ahead(after, id, beside):
            yield pose
