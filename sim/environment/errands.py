"""What can be done in a room, by name, and from where."""

from collections.abc import Callable, Iterator
from itertools import islice
from typing import Any, Literal

import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.environment.asking_for import LIGHT, SMALL, check_fit, meant, moving, small_things, surfaces, things
from thinkblox.sim.environment.goals import AT_HAND, CarryGoal, DriveGoal, OpenGoal, ReachGoal, RobotGoal
from thinkblox.sim.environment.model_index import ModelIndex
from thinkblox.sim.environment.places import FreePlaces, RobotPlace
from thinkblox.sim.environment.room_source import OpenRoom

TaskName = Literal["reach", "drive", "open", "carry"]
TASKS: tuple[TaskName, ...] = ("reach", "drive", "open", "carry")
Mount = Literal["any", "floor", "furniture"]
MOUNTS: tuple[Mount, ...] = ("any", "floor", "furniture")
SMALL_ONES = f"small objects, of at most {LIGHT:g} kg and {SMALL * 100:g} cm,"
ARM = 0.75
"""How far from a robot's middle its arm works, seen from above [m]."""
START = 1.5
"""From where a robot drives to something, where there is room [m]."""
TRIES = 300
"""Places that are tried for a robot."""

GoalMaker = Callable[[ModelIndex], RobotGoal]


def goals_for(
    room: OpenRoom, task: TaskName, target: str | None, destination: str | None
) -> list[tuple[str, GoalMaker]]:
    """Every goal that is meant, with the id of the object that the robot must come to.

    Raises:
        InputError: the room has nothing of that name, or nothing for such a task.
    """
    if task == "open":
        parts = moving(room)
        check_fit(target, room, {part.item.id for part in parts.values()}, "has no doors or drawers")
        names = meant(
            target, list(parts), [p.item.category for p in parts.values()], what="doors or drawers", room=room.name
        )
        return [(parts[name].item.id, _opening(parts[name])) for name in names]
    known, what = (small_things(room), SMALL_ONES) if task == "carry" else (things(room), "objects")
    unfit = f"is more than {LIGHT:g} kg or {SMALL * 100:g} cm, or fixed" if task == "carry" else "cannot be touched"
    check_fit(target, room, set(known), unfit)
    names = meant(target, list(known), [item.category for item in known.values()], what=what, room=room.name)
    if task != "carry":
        kind = ReachGoal if task == "reach" else DriveGoal
        return [(name, _at(kind, name)) for name in names]
    tops = surfaces(room)
    kinds = [top.item.category for top in tops.values()]
    check_fit(destination, room, {top.item.id for top in tops.values()}, "has no surface that is open to above")
    chosen = meant(destination, list(tops), kinds, what="surfaces", room=room.name)
    pairs = [(name, top) for name in names for top in chosen if room.scene[name].support != tops[top].item.id]
    if not pairs:
        raise InputError(f"{room.name}: {', '.join(names[:5])} stand on {destination or 'the only surface'} already")
    return [(name, _carrying(name, tops[top])) for name, top in pairs]


def _at(kind: type[ReachGoal] | type[DriveGoal], id: str) -> GoalMaker:
    return lambda index: kind(index, id)


def _opening(part: Any) -> GoalMaker:
    return lambda index: OpenGoal(index, part)


def _carrying(id: str, top: Any) -> GoalMaker:
    return lambda index: CarryGoal(index, id, top)


def starts(
    places: FreePlaces, task: TaskName, id: str, mount: Mount, rng: np.random.RandomState
) -> Iterator[RobotPlace]:
    """Places to begin a task from, in any order; none where there are none."""
    goal = places.outline(id)
    if not places.robot.mobile:
        if mount != "floor":
            yield from islice(places.on_furniture(goal, ARM, rng), TRIES // 2)
        if mount != "furniture":
            yield from places.beside(goal, ARM, rng)
        return
    floor = places.floor_before(goal, AT_HAND - 0.05 if task == "drive" else ARM)
    if task != "drive":
        yield from places.floor_places(floor, rng)
        return
    for away in (START, AT_HAND + 0.1):
        yield from places.floor_places(floor.difference(goal.buffer(away)), rng)


def has_start(places: FreePlaces, task: TaskName, id: str, mount: Mount) -> bool:
    """Whether there is any place to begin from."""
    return next(starts(places, task, id, mount, np.random.RandomState(0)), None) is not None
