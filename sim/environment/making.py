"""A room, or a different one each episode, as a dm_control environment."""

import math
from collections.abc import Iterable
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np

from thinkblox.errors import InputError
from thinkblox.given import seed_given
from thinkblox.sim.environment.errands import MOUNTS, Mount, TaskName
from thinkblox.sim.environment.extra import needed
from thinkblox.sim.environment.pictures import Pictures
from thinkblox.sim.environment.robot import load_robot
from thinkblox.sim.environment.room_source import RoomLike, RoomSource, opened, rooms_of
from thinkblox.sim.environment.rotation import rotating
from thinkblox.sim.environment.task import CONTROL, make_task

ROBOTS: dict[str, str] = {"drive": "base", "reach": "picker", "open": "picker", "carry": "picker"}
"""Who does what, unless told otherwise."""
SECONDS: dict[str, float] = {"drive": 60.0, "reach": 60.0, "open": 90.0, "carry": 120.0}
"""How long an episode takes at most [s]."""


def make_environment(
    room: RoomLike | Iterable[RoomLike],
    task: TaskName = "drive",
    target: str | None = None,
    *,
    destination: str | None = None,
    robot: str | Path | None = None,
    tool: str | None = None,
    mount: Mount = "any",
    pictures: Pictures | None = None,
    time_limit: float | None = None,
    control_timestep: float = CONTROL,
    seed: int | None = None,
) -> Any:
    """A robot in a room with something to do, as a `dm_env.Environment`.

    One room is a `dm_control.composer.Environment`. Of several, every episode has the next one, in an order that is
    shuffled anew when all have had their turn; `current` is the composer environment of the room that it is in.

    Args:
        room: a scene, a scene.json, the folder of a room, a folder of such folders, or several of these.
        task: "reach" or "drive" to an object, "open" a door or drawer, "carry" a small object to a surface.
        target: id of an object ("desk_1"), its category ("desk"), or, to be opened, a thing or one part of it
            ("wardrobe_1", "wardrobe_1/door_left"); any that fits, another one each episode, when None.
        destination: where it is carried to: a thing, one surface of it ("desk_1/top"), or a category.
        robot: "base", "picker", "jaco" or the path of an MJCF file; by default one that can do it.
        tool: name of the site that a robot of one's own works with.
        mount: what an arm is mounted on.
        pictures: what its cameras see, as observations.
        time_limit: of an episode [s].
        control_timestep: time between two actions [s].
        seed: of where the robot begins, with which target, and in which order rooms come.

    Raises:
        InputError: a room, object, robot or extra that is not there, or no place for the robot.
    """
    sources = rooms_of(room)
    if not sources:
        raise InputError("no room is given")
    if task not in SECONDS:
        raise InputError(f"no task {task!r}; there are {', '.join(SECONDS)}")
    if destination is not None and task != "carry":
        raise InputError(f"only 'carry' has a destination, not {task!r}; say where to by its target")
    if mount not in MOUNTS:
        raise InputError(f"no mount {mount!r}; there are {', '.join(MOUNTS)}")
    limit = SECONDS[task] if time_limit is None else _seconds(time_limit, "time_limit")
    _seconds(control_timestep, "control_timestep")
    random_state = _random_state(seed)

    def make(source: RoomSource) -> Any:
        composer = needed("dm_control.composer")
        made = make_task(
            opened(source), load_robot(robot or ROBOTS[task], tool=tool), task, target, destination,
            mount=mount, pictures=pictures, control_timestep=control_timestep,
        )  # fmt: skip
        return composer.Environment(
            made,
            time_limit=limit,
            random_state=random_state,
            recompile_mjcf_every_episode=False,
            strip_singleton_obs_buffer_dim=True,
        )

    return make(sources[0]) if len(sources) == 1 else rotating(sources, make, random_state)


def _seconds(value: object, name: str) -> float:
    if isinstance(value, bool) or not isinstance(value, Real) or not 0.0 < float(value) < math.inf:
        raise InputError(f"{name} is {value!r}; it must be a time above 0 [s]")
    return float(value)


def _random_state(seed: object) -> np.random.RandomState:
    if seed is None:
        return np.random.RandomState()
    whole = seed_given(seed)
    # The engine of random numbers takes 32 bits at a time.
    return np.random.RandomState(whole if whole < 2**32 else [whole % 2**32, whole >> 32])
