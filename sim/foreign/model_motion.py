"""What the things of any model do when it is let go: where they go, when they rest, and whether the engine gave up."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.subject import Subject
from thinkblox.sim.verdict.settle import WARNINGS

Floats = NDArray[np.float64]
LOOK = 0.05
"""Time between two looks at the poses [s]."""
STILL, STILL_TURN = 0.0002, 0.05
"""What stays so near to its last pose has come to rest [m, degrees]."""
RESTED = 0.2
"""How long it must have stayed there [s]."""
MOST_WORK = 2e10
"""Of a simulation, in steps times (degrees of freedom + constraints + 1) to the power 1.5: some minutes of one core."""
MOST_STEPS = 200_000
BEARING, MOST_BEARING = 0.1, 1000
"""How long what slept bears on what carries it before that is measured [s, steps]."""
_STATE = int(mujoco.mjtState.mjSTATE_INTEGRATION)


@dataclass(frozen=True)
class Motions:
    """What became of every thing of a subject, in their order.

    Attributes:
        moves: whether its root can move at all; the numbers are 0 where it cannot.
        drift: the furthest its middle was from where it began, across gravity [m].
        drop: the furthest it was below where it began [m].
        tilt: the most it was turned [degrees].
        rest: when it came to rest [s]; NaN when it did not.
        seconds: simulated [s].
        broken: why that was less than was asked for, as a sentence, or "".
        unstable: the engine's warnings after which its numbers mean nothing, as sentences.
        data: the state at the end, everything awake.
    """

    moves: NDArray[np.bool_]
    drift: Floats
    drop: Floats
    tilt: Floats
    rest: Floats
    seconds: float
    broken: str
    unstable: tuple[str, ...]
    data: mujoco.MjData


@contextmanager
def awake(model: mujoco.MjModel) -> Iterator[None]:
    """Within it nothing sleeps, so that every contact is found; the model's own option comes back afterwards."""
    flags = model.opt.enableflags
    model.opt.enableflags = flags & ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    try:
        yield
    finally:
        model.opt.enableflags = flags


def upwards(model: mujoco.MjModel) -> Floats | None:
    """The direction against gravity; None where there is none."""
    gravity = np.asarray(model.opt.gravity, dtype=np.float64)
    strength = float(np.linalg.norm(gravity))
    if strength == 0.0 or model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_GRAVITY):
        return None
    return -gravity / strength


@quiet_engine()
def let_go(subject: Subject, seconds: float) -> Motions:
    """Simulate a subject from its start with its own options, everything at once."""
    model, data = subject.model, subject.data()
    roots = [thing.root for thing in subject.things]
    step = float(model.opt.timestep)
    chunk, left = max(1, round(LOOK / step)), max(1, round(seconds / step))
    places, turns, times, work, unstable = [data.xipos[roots]], [data.xquat[roots]], [0.0], 0.0, warned(data)
    few_enough = left <= MOST_STEPS
    while few_enough and left > 0 and work <= MOST_WORK and not unstable:
        steps = min(chunk, left)
        mujoco.mj_step(model, data, nstep=steps)
        left, work = left - steps, work + steps * float(model.nv + data.nefc + 1) ** 1.5
        unstable = warned(data)
        if not unstable:
            places.append(data.xipos[roots])
            turns.append(data.xquat[roots])
            times.append(times[-1] + steps * step)
    broken = "" if unstable or left <= 0 else _too_much(seconds, step, few_enough)
    path = np.nan_to_num(np.array(places), posinf=0.0, neginf=0.0)
    moved = _moved(path, upwards(model))
    turned = _turned(np.array(turns))
    return Motions(
        moves=np.asarray(model.body_weldid[roots] != 0),
        drift=moved[0].max(axis=0),
        drop=moved[1].max(axis=0),
        tilt=turned.max(axis=0),
        rest=_rest(path, np.array(turns), np.array(times)),
        seconds=times[-1],
        broken=broken,
        unstable=unstable,
        data=_everything_awake(model, data),
    )


def _too_much(seconds: float, step: float, few_enough: bool) -> str:
    if few_enough:
        return f"The model is too large to be simulated for {seconds:g} s."
    return f"With a time step of {step:g} s there are more than {MOST_STEPS} steps in {seconds:g} s, which is too many."


def warned(data: mujoco.MjData) -> tuple[str, ...]:
    """The engine's warnings after which its numbers mean nothing, as sentences, with the time."""
    names = {int(kind): kind.name.removeprefix("mjWARN_") for kind in WARNINGS}
    found = [
        f"MuJoCo warned {name} ({_MEANING[name]}) by {data.time:.3g} s."
        for kind, name in names.items()
        if data.warning[kind].number
    ]
    if not (np.isfinite(data.qpos).all() and np.isfinite(data.xipos).all()):
        found.append(f"A coordinate was no finite number by {data.time:.3g} s.")
    return tuple(found)


_MEANING = {
    "BADQPOS": "a position blew up",
    "BADQVEL": "a velocity blew up",
    "BADQACC": "an acceleration blew up",
    "CONTACTFULL": "the buffer of contacts overflowed and contacts were lost: give the model a larger <size memory>",
    "CNSTRFULL": "the buffer of constraints overflowed and contacts were lost: give the model a larger <size memory>",
}


def _everything_awake(model: mujoco.MjModel, data: mujoco.MjData) -> mujoco.MjData:
    """The same state, of which what slept has had a moment to bear on what carries it: just touching is no force."""
    slept = model.opt.enableflags & int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    with awake(model):
        state = np.empty(mujoco.mj_stateSize(model, _STATE))
        mujoco.mj_getState(model, data, state, _STATE)
        fresh = mujoco.MjData(model)
        mujoco.mj_setState(model, fresh, state, _STATE)
        if slept:
            mujoco.mj_step(model, fresh, nstep=min(MOST_BEARING, max(1, round(BEARING / model.opt.timestep))))
        mujoco.mj_forward(model, fresh)
    return fresh


def _moved(places: Floats, up: Floats | None) -> tuple[Floats, Floats]:
    """Distance across gravity and depth below the first place, shape (looks, things) each [m]."""
    along = np.array([0.0, 0.0, 1.0]) if up is None else up
    steps = places - places[0]
    height = steps @ along
    across = np.linalg.norm(steps - height[..., None] * along, axis=-1)
    return across, np.maximum(0.0, -height)


def _turned(turns: Floats, reference: int = 0) -> Floats:
    """Angle to the orientation of one look, shape (looks, things) [degrees]."""
    other = turns[reference]
    dot = np.abs((turns * other).sum(axis=-1))
    apart = np.minimum(np.linalg.norm(turns - other, axis=-1), np.linalg.norm(turns + other, axis=-1))
    return np.asarray(np.degrees(4.0 * np.arctan2(apart / 2, np.sqrt((1.0 + np.minimum(dot, 1.0)) / 2))))


def _rest(places: Floats, turns: Floats, times: Floats) -> Floats:
    """When each thing came to stay near its last pose [s]; NaN when that was not long enough ago."""
    away = np.linalg.norm(places - places[-1], axis=-1) > STILL
    away |= _turned(turns, -1) > STILL_TURN
    first = np.where(away.any(axis=0), len(times) - np.argmax(away[::-1], axis=0), 0)
    since = times[np.minimum(first, len(times) - 1)]
    return np.where(times[-1] - since >= RESTED, since, np.nan)
