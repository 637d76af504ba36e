"""What of a model is not furniture: robots, which stand still and can be bumped into, and what is left out."""

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

import mujoco
import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.subject import Thing

HELD = 1e9
"""Inertia that is added to what is held where it is [kg or kg m2]: it moves by micrometres."""
FAR = 1e6
"""No contact is so deep [m]."""
_LISTED = 12


@dataclass(frozen=True)
class SetAside:
    """The things of a model that are judged, its robots, and notes on what was set aside."""

    things: tuple[Thing, ...]
    robots: tuple[Thing, ...]
    notes: tuple[str, ...]


def set_aside(
    path: Path, model: mujoco.MjModel, things: tuple[Thing, ...], *, exclude: Sequence[str], robots: Sequence[str]
) -> SetAside:
    """Sort the things of a model into what is judged, robots, and what is left out, and hold still what is not judged.

    Args:
        path: of its file, for messages.
        model: compiled; it is changed.
        things: all of them.
        exclude: names or patterns of what is left out.
        robots: names or patterns of robots.

    Raises:
        InputError: nothing has such a name; lists what there is.
    """
    out = {thing.id for name in exclude for thing in _named(path, things, name)}
    held = {thing.id for name in robots for thing in _named(path, things, name)} - out
    gone = [thing for thing in things if thing.id in out]
    still = tuple(thing for thing in things if thing.id in held)
    _let_through(model, gone)
    _hold(model, [*gone, *still])
    notes = []
    if gone:
        notes.append(f"Left out as asked: {listed([thing.id for thing in gone])}.")
    if still:
        notes.append(f"Held where it starts, as a robot: {listed([thing.id for thing in still])}.")
    return SetAside(tuple(t for t in things if t.id not in out | held), still, tuple(notes))


def _named(path: Path, things: tuple[Thing, ...], name: str) -> list[Thing]:
    found = [thing for thing in things if thing.id == name] or [t for t in things if fnmatchcase(t.id, name)]
    if not found:
        there = listed([thing.id for thing in things], shown=_LISTED)
        raise InputError(f'{path}: nothing in the model is called "{name}"; there are {there}.')
    return found


def _let_through(model: mujoco.MjModel, things: Sequence[Thing]) -> None:
    """Let nothing touch these."""
    geoms = np.isin(model.geom_bodyid, [body for thing in things for body in thing.bodies])
    model.geom_contype[geoms] = model.geom_conaffinity[geoms] = 0
    model.pair_margin[geoms[model.pair_geom1] | geoms[model.pair_geom2]] = -FAR


def _hold(model: mujoco.MjModel, things: Sequence[Thing]) -> None:
    """Make these too heavy to be moved; nothing is heavier on what carries it."""
    dofs = np.isin(model.dof_bodyid, [body for thing in things for body in thing.bodies])
    if not dofs.any():
        return
    model.dof_armature[dofs] = HELD
    mujoco.mj_setConst(model, mujoco.MjData(model))
