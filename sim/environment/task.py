"""A robot's task in a room, as dm_control's composer has it."""

from collections import OrderedDict
from collections.abc import Callable
from functools import cache
from itertools import islice
from typing import Any

import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.environment.errands import TASKS, TRIES, GoalMaker, Mount, TaskName, goals_for, has_start, starts
from thinkblox.sim.environment.extra import needed
from thinkblox.sim.environment.goals import RobotGoal
from thinkblox.sim.environment.model_index import ModelIndex
from thinkblox.sim.environment.pictures import Pictures, Picturing
from thinkblox.sim.environment.places import FreePlaces
from thinkblox.sim.environment.robot import Robot
from thinkblox.sim.environment.room_source import OpenRoom, make_arena
from thinkblox.sim.environment.told import told_of

CONTROL = 0.04
"""Time between two actions [s]."""


class Errand:
    """What is to be done in a room by a robot, episode after episode; it knows nothing of dm_control.

    Attributes:
        room, robot, places: where, who, and where that can be.
        name: of the task.
        index: of the compiled model.
        goal: of this episode.
        pictures, picturing: what cameras see.
    """

    index: ModelIndex
    goal: RobotGoal
    picturing: Picturing

    def __init__(
        self,
        room: OpenRoom,
        robot: Robot,
        name: TaskName,
        goals: list[tuple[str, GoalMaker]],
        *,
        places: FreePlaces,
        mount: Mount,
        pictures: Pictures,
    ) -> None:
        self.room, self.robot, self.name, self.places, self.pictures = room, robot, name, places, pictures
        self._goals, self._mount = goals, mount
        self._before = 0.0

    def compiled(self, physics: Any) -> None:
        """Find everything in the model that has been compiled; raises InputError for an unknown camera."""
        self.index = ModelIndex(physics, self.room, self.robot)
        self.picturing = Picturing(physics, self.index, self.pictures)
        for camera in self.pictures.cameras:
            self.picturing.camera(camera)
        self._made = [(id, make(self.index)) for id, make in self._goals]
        self.goal = self._made[0][1]

    def begin(self, rng: np.random.RandomState) -> None:
        """Put everything where it rests, choose a goal, and put the robot somewhere; raises InputError for no place."""
        id, self.goal = self._made[rng.randint(len(self._made))]
        self.index.set_rest()
        self.index.set_home()
        for place in islice(starts(self.places, self.name, id, self._mount, rng), TRIES):
            self.index.put_robot(place)
            if self.index.robot_is_clear() and not self.goal.reached():
                return
        said = f"the robot {self.robot.name!r} to {self.goal.says()} from"
        raise InputError(f"{self.room.name}: no free place was found for {said}")

    def tellers(self) -> dict[str, Callable[[Any], Any]]:
        """What is told, by name, of the physics."""
        numbers = {name: self._telling(tell) for name, tell in told_of(self.name).items()}
        seen = {
            f"{camera}_{kind}": self._seeing(camera, kind)
            for camera in self.pictures.cameras
            for kind in self.pictures.kinds
        }
        return {**numbers, **seen}

    def _telling(self, tell: Callable[[ModelIndex, RobotGoal], Any]) -> Callable[[Any], Any]:
        return lambda _: tell(self.index, self.goal)

    def _seeing(self, camera: str, kind: Any) -> Callable[[Any], Any]:
        return lambda _: self.picturing.draw(camera, kind)

    def note(self) -> None:
        """Remember how near the goal is before an action."""
        self._before = self.goal.nearness()

    def reward(self) -> float:
        """By how much the goal has come nearer with the action, and 1 when it is reached."""
        return float(self.goal.nearness() - self._before + self.goal.reached())


@cache
def _task_class() -> Any:
    base: Any = needed("dm_control.composer").Task

    class RoomTask(base):  # type: ignore[misc]
        """One of four tasks; `errand` has what is to be done, where and by whom, and `goal` that of this episode."""

        def __init__(self, errand: Errand, control_timestep: float) -> None:
            self.errand = errand
            self._arena = make_arena(errand.room, timestep=errand.robot.timestep)
            frame = self._arena.attach(errand.robot.entity)
            if errand.robot.mobile:
                frame.add("freejoint")
            self.control_timestep = control_timestep

        root_entity = property(lambda self: self._arena)
        goal = property(lambda self: self.errand.goal)
        task_observables = property(lambda self: _observables(self.errand))

        def after_compile(self, physics: Any, random_state: Any) -> None:
            self.errand.compiled(physics)

        def initialize_episode(self, physics: Any, random_state: Any) -> None:
            self.errand.begin(random_state)

        def before_step(self, physics: Any, action: Any, random_state: Any) -> None:
            self.errand.note()
            super().before_step(physics, action, random_state)

        def get_reward(self, physics: Any) -> float:
            return self.errand.reward()

        def should_terminate_episode(self, physics: Any) -> bool:
            return self.goal.reached()  # type: ignore[no-any-return]

        def get_discount(self, physics: Any) -> float:
            # Nothing comes after a goal that is reached.
            return 1.0 - self.goal.reached()  # type: ignore[no-any-return]

    return RoomTask


def _observables(errand: Errand) -> "OrderedDict[str, Any]":
    make = needed("dm_control.composer.observation.observable").Generic
    made = OrderedDict((name, make(tell)) for name, tell in errand.tellers().items())
    for each in made.values():
        each.enabled = True
    return made


def make_task(
    room: OpenRoom,
    robot: Robot,
    task: TaskName,
    target: str | None,
    destination: str | None,
    *,
    mount: Mount = "any",
    pictures: Pictures | None = None,
    control_timestep: float = CONTROL,
) -> Any:
    """A `dm_control.composer.Task` of a robot in a room.

    Raises:
        InputError: a task, object, door or surface that there is not, a robot that cannot do it, or no place to begin.
    """
    if task not in TASKS:
        raise InputError(f"no task {task!r}; there are {', '.join(TASKS)}")
    if robot.tool is None and task != "drive":
        raise InputError(
            f"the robot {robot.name!r} has no tool to {task} with; take 'picker', 'jaco' or one of your own, of which"
            " tool= names a site"
        )
    if not robot.mobile and task == "drive":
        raise InputError(
            f"the robot {robot.name!r} is mounted and cannot drive; take 'base', 'picker' or one of your own"
        )
    places = FreePlaces(room, robot)
    if places.floor.is_empty and robot.mobile:
        raise InputError(f"{room.name}: no free floor for the robot {robot.name!r}, {2 * robot.radius:.2f} m wide")
    goals = goals_for(room, task, target, destination)
    able = [(id, make) for id, make in goals if has_start(places, task, id, mount)]
    if not able:
        said = ", ".join(dict.fromkeys(id for id, _ in goals[:5]))
        raise InputError(
            f"{room.name}: no free place for the robot {robot.name!r} to {task} {said} from: it needs a circle of"
            f" {2 * robot.radius:.2f} m that hangs together with one near there"
        )
    errand = Errand(room, robot, task, able, places=places, mount=mount, pictures=pictures or Pictures())
    return _task_class()(errand, control_timestep)
