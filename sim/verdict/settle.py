"""Letting go: how far things move until they rest, and the state in which they rest."""

import math

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.derived import kept
from thinkblox.scene.scene import Scene, scene_given
from thinkblox.sim.build import FREE_SUFFIX, build_spec, compiled
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.judge import Motion
from thinkblox.value import Quat, Value, Vec3

WARNINGS = (
    mujoco.mjtWarning.mjWARN_BADQPOS,
    mujoco.mjtWarning.mjWARN_BADQVEL,
    mujoco.mjtWarning.mjWARN_BADQACC,
    mujoco.mjtWarning.mjWARN_CONTACTFULL,
    mujoco.mjtWarning.mjWARN_CNSTRFULL,
)
"""After any of these the engine's numbers mean nothing."""

Pose = tuple[Vec3, Quat]


class SettledState(Value, kw_only=True, frozen=True):
    """A scene at rest.

    Attributes:
        qpos: of the model that `build_spec(scene)` makes, for its keyframe "settled".
        poses: position [m] and quaternion wxyz of every body that can move, by name ("lamp_1", "wardrobe_1/door").
        seconds: how long it took to rest [s]; `rested` is False when something was not asleep by the end
            of the longest settle, be it by a tremor of 0.1 mm/s.
    """

    qpos: tuple[float, ...]
    poses: dict[str, Pose]
    seconds: float
    rested: bool


def diverged(data: mujoco.MjData) -> bool:
    """Whether the engine warned of numbers that blew up or of a buffer that overflowed."""
    numbers = data.warning.number
    return bool(numbers.any()) and any(numbers[int(kind)] for kind in WARNINGS)


def motion_between(start: NDArray[np.float64], end: NDArray[np.float64], *, unstable: bool = False) -> Motion:
    """Motion of one free body between two of its seven-number poses (position, quaternion wxyz)."""
    if unstable or not np.isfinite(end).all():
        return Motion(unstable=True)
    x, y, z = (end[:3] - start[:3]).tolist()
    return Motion(
        drift=round(math.hypot(x, y), 6),
        drop=round(max(0.0, -z), 6),
        tilt=round(turn(start[3:7], end[3:7]), 4),
    )


def turn(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    """Angle between two orientations wxyz [degrees]."""
    difference = np.zeros(3)
    mujoco.mju_subQuat(difference, first, second)
    return math.degrees(math.sqrt(difference.dot(difference)))


def settle(scene: Scene, *, physics: Physics | None = None) -> SettledState:
    """Let a whole scene come to rest, everything free, from the poses that it proposes; done once for a scene."""
    return _settled(scene_given(scene), physics or Physics())


@kept
def _settled(scene: Scene, physics: Physics) -> SettledState:
    return rest(compiled(build_spec(scene, physics=physics)), physics)


@quiet_engine()
def rest(model: mujoco.MjModel, physics: Physics) -> SettledState:
    """Let a compiled scene come to rest from its reference pose; sleep is used to know when, and then taken back."""
    model.opt.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    data = mujoco.MjData(model)
    steps = 0
    while steps * physics.timestep < physics.rest_time and not diverged(data) and not asleep(data):
        mujoco.mj_step(model, data, nstep=physics.chunk)
        steps += physics.chunk
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    rested = asleep(data) and not diverged(data)
    poses = {name: _pose(data, name) for name in _moving(model)}
    return SettledState(
        qpos=tuple(map(float, data.qpos)), poses=poses, seconds=round(steps * physics.timestep, 6), rested=rested
    )


def add_keyframe(spec: mujoco.MjSpec, state: SettledState) -> None:
    """Add the keyframe "settled" with every velocity 0."""
    spec.add_key(name="settled", qpos=state.qpos)


def free_addresses(model: mujoco.MjModel) -> dict[str, int]:
    """Where in qpos the pose of each free object begins, by placement id."""
    free = np.flatnonzero(model.jnt_type == int(mujoco.mjtJoint.mjJNT_FREE))
    return {str(model.joint(int(j)).name).removesuffix(FREE_SUFFIX): int(model.jnt_qposadr[j]) for j in free}


def asleep(data: mujoco.MjData) -> bool:
    """Whether everything that can move sleeps."""
    return bool(np.all(data.tree_asleep >= 0))


def _moving(model: mujoco.MjModel) -> list[str]:
    return [str(model.body(int(body)).name) for body in dict.fromkeys(model.jnt_bodyid.tolist())]


def _pose(data: mujoco.MjData, name: str) -> Pose:
    body = data.body(name)
    x, y, z = map(float, body.xpos)
    qw, qx, qy, qz = map(float, body.xquat)
    return (x, y, z), (qw, qx, qy, qz)
