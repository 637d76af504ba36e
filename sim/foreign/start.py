"""Where a model of anyone's starts: its keyframe, or where its bodies stand."""

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.foreign.names import listed

SETTLED, HOME = "settled", "home"
"""The keyframe that our own exports start from, and that of where their bodies stood when they were written."""
SAME = 1e-6
"""What differs by less is where the keyframe has it, rounding apart [m, rad or of a quaternion]."""
ELSEWHERE, TURNED = 0.01, np.radians(2.0)
"""By how much a keyframe may have something elsewhere than its body stands before it is told [m], [rad]."""
_WIDTH = {int(mujoco.mjtJoint.mjJNT_FREE): 7, int(mujoco.mjtJoint.mjJNT_BALL): 4}
_FREE = int(mujoco.mjtJoint.mjJNT_FREE)
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Start:
    """Where a model starts.

    Attributes:
        qpos: of its joints.
        keyframe: that says so, None where it is the reference pose.
        notes: what a reader should know of it, in sentences.
    """

    qpos: Floats
    keyframe: int | None
    notes: tuple[str, ...] = ()


def start_of(model: mujoco.MjModel) -> Start:
    """The keyframe "settled", or else the only one, or else the reference pose.

    In our own exports the keyframe "home" has everything where its body stands. Where a body stands elsewhere it was
    moved in the file since, and starts from there: a keyframe of where it was says nothing of it.
    """
    names = [str(model.key(key).name) for key in range(model.nkey)]
    if SETTLED in names:
        key = names.index(SETTLED)
    elif model.nkey == 1:
        key = 0
    else:
        return Start(np.array(model.qpos0), None)
    qpos = np.array(model.key_qpos[key])
    if SETTLED not in names or HOME not in names:
        return Start(qpos, key, _elsewhere(model, qpos, names[key]))
    home, moved = model.key_qpos[names.index(HOME)], []
    for joint in range(model.njnt):
        part = _part(model, joint)
        if not _same(model, joint, model.qpos0[part], home[part]):
            qpos[part] = model.qpos0[part]
            moved.append(_name(model, joint))
    if not moved:
        return Start(qpos, key)
    note = f"Moved since the keyframe {HOME!r} was written, and measured where the bodies now stand: {listed(moved)}."
    return Start(qpos, key, (note,))


def _elsewhere(model: mujoco.MjModel, qpos: Floats, name: str) -> tuple[str, ...]:
    """What a keyframe has elsewhere than the bodies stand, in a sentence."""
    away = []
    for joint in map(int, np.flatnonzero(model.jnt_type == _FREE)):
        there, here = qpos[_part(model, joint)], model.qpos0[_part(model, joint)]
        turned = 2 * np.arccos(min(1.0, abs(float(there[3:] @ here[3:])) / max(float(np.linalg.norm(there[3:])), 1e-9)))
        if np.linalg.norm(there[:3] - here[:3]) > ELSEWHERE or turned > TURNED:
            away.append(_name(model, joint))
    called = f"the keyframe {name!r}" if name else "the only keyframe"
    return (f"Measured from {called}, which has elsewhere than the bodies stand: {listed(away)}.",) if away else ()


def _part(model: mujoco.MjModel, joint: int) -> slice:
    start = int(model.jnt_qposadr[joint])
    return slice(start, start + _WIDTH.get(int(model.jnt_type[joint]), 1))


def _same(model: mujoco.MjModel, joint: int, one: Floats, other: Floats) -> bool:
    """Whether two values of a joint are the same pose; a quaternion and its negative are."""
    turn = one[3:] if int(model.jnt_type[joint]) == _FREE else one
    flip = -1.0 if len(turn) == 4 and float(turn @ other[len(one) - len(turn) :]) < 0 else 1.0
    signs = np.where(np.arange(len(one)) >= len(one) - len(turn), flip, 1.0)
    return bool(np.all(np.abs(one - signs * other) <= SAME))


def _name(model: mujoco.MjModel, joint: int) -> str:
    body = int(model.jnt_bodyid[joint])
    return str(model.body(body).name) or f"body_{body}"
