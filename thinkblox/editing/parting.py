"""Room made for what is to stand between two things: the two are moved apart by what it lacks."""

import math
from collections.abc import Callable, Iterator, Sequence

from shapely.ops import nearest_points

from thinkblox.editing.acting import moved_words
from thinkblox.editing.goals import EXACT, Amid, Goal
from thinkblox.editing.scattering import moved_to
from thinkblox.editing.work import Work
from thinkblox.scene.landmarks import things
from thinkblox.value import Vec2

SPARE = 0.04
"""How much wider than what comes between them the gap is made [m]."""
MOST_APART = 1.0
"""How far two things are moved apart for that at most [m]."""


def with_room_between(work: Work, id: str, goals: Sequence[Goal], do: Callable[[], bool]) -> bool:
    """Do what brings a thing between two others again after these were moved apart; whether it could be done.

    Nothing is moved where there is room enough, or where the thing does not come to stand there even so.

    Args:
        work: the edit.
        id: of what is to stand there.
        goals: one of which may be to be between two things.
        do: brings it there.
    """
    amid = next((goal for goal in goals if isinstance(goal, Amid)), None)
    if amid is None or id not in work.scene or work.asset_of(id).mount != "floor":
        return False
    before, saved = work.scene, work.saved()
    for spots in _apart(work, id, amid):
        if not moved_to(work, list(spots), spots, off=EXACT) and do():
            moved = [moved_words(before[name], work.scene[name]) for name in spots]
            work.done += [f"{words}, to make room for {id}" for words in moved]
            return True
        work.restore(saved)
    return False


def _apart(work: Work, id: str, amid: Amid) -> Iterator[dict[str, Vec2]]:
    """Where the two would stand: one of them moved by all that is lacking, or each by half of it."""
    one, other = amid.anchors
    scene = work.scene
    free = [n for n in amid.anchors if n in scene and scene[n].support == "floor" and n not in work.kept]
    if len(free) < 2 or not all(scene.asset_of(scene[n]).collides for n in free):
        return
    (a, b) = nearest_points(*(things(scene, name)[0].footprint for name in amid.anchors))
    gap = math.dist((a.x, a.y), (b.x, b.y))
    lacking = min(scene[id].size[:2]) + SPARE - gap
    if gap <= 0.0 or not 0.0 < lacking <= MOST_APART:
        return
    way = ((b.x - a.x) / gap, (b.y - a.y) / gap)
    smaller, larger = sorted(amid.anchors, key=lambda n: scene[n].size[0] * scene[n].size[1])
    for steps in ({smaller: lacking}, {one: lacking / 2, other: lacking / 2}, {larger: lacking}):
        yield {
            name: _off(scene[name].position[:2], way, -step if name == one else step) for name, step in steps.items()
        }


def _off(spot: Vec2, way: Vec2, step: float) -> Vec2:
    return (spot[0] + way[0] * step, spot[1] + way[1] * step)
