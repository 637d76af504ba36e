"""What a robot is told besides pictures, as arrays."""

import math
from collections.abc import Callable

import numpy as np

from thinkblox.sim.environment.goals import RobotGoal
from thinkblox.sim.environment.model_index import Array, ModelIndex

Tell = Callable[[ModelIndex, RobotGoal], Array]


def _pose(index: ModelIndex) -> Array:
    """X and y [m], and cosine and sine of where it looks."""
    x, y, yaw = index.pose
    return np.array([x, y, math.cos(yaw), math.sin(yaw)])


def _joint_positions(index: ModelIndex) -> Array:
    """Of joints with limits as they are [rad, m], of the others the cosine and the sine."""
    found: list[float] = []
    for joint in index.joints:
        value = float(index.data.qpos[index.model.jnt_qposadr[joint]])
        found += [value] if index.model.jnt_limited[joint] else [math.cos(value), math.sin(value)]
    return np.array(found)


def _joint_velocities(index: ModelIndex) -> Array:
    return np.array([float(index.data.qvel[index.model.jnt_dofadr[joint]]) for joint in index.joints])


ALWAYS: dict[str, Tell] = {
    "robot_pose": lambda index, _: _pose(index),
    "robot_velocity": lambda index, _: index.velocity,
    "joint_positions": lambda index, _: _joint_positions(index),
    "joint_velocities": lambda index, _: _joint_velocities(index),
    "tool_position": lambda index, _: index.tool,
    "tool_from_robot": lambda index, _: index.from_robot(index.tool),
    "target_position": lambda _, goal: goal.point(),
    "target_quat": lambda _, goal: goal.quat(),
    "target_from_robot": lambda index, goal: index.from_robot(goal.point()),
}
"""In every task: the robot's own state, and the pose of its target."""
BESIDES: dict[str, dict[str, Tell]] = {
    "open": {"opening": lambda _, goal: goal.second()[:1]},
    "carry": {
        "destination_position": lambda _, goal: goal.second(),
        "destination_from_robot": lambda index, goal: index.from_robot(goal.second()),
    },
}
"""In one task more: how far it is open, as a share of its range; where it is to be brought."""


def told_of(task: str) -> dict[str, Tell]:
    """All that is told in a task, by name."""
    return {**ALWAYS, **BESIDES.get(task, {})}
