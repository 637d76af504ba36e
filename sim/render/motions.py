"""Where things end up, for pictures: what an object does when it is let go, and what a door sweeps when it opens."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.render.model_soup import geom_mesh, seen_geoms
from thinkblox.sim.subject import Subject, Thing

Array = NDArray[np.float64]
SECONDS = 1.0
"""How long what is let go is watched [s]."""
MOST_STEPS = 1000
MOST = 24
"""So many objects at most are let go for one picture."""
FAR = 1.0
"""Whatever moved further has left the picture [m]."""
STAGES = 8
"""Poses between shut and open of which a swept volume is made."""


@dataclass(frozen=True)
class RigidMotion:
    """A rigid motion of the room's points: x becomes turn @ x + shift."""

    turn: Array
    shift: Array


@quiet_engine()
def rests(subject: Subject, ids: Sequence[str]) -> dict[str, RigidMotion]:
    """How each free object moves when it alone is let go from the start while all others are held where they are."""
    things = {thing.id: thing for thing in subject.things if thing.free}
    found = {}
    for id in [id for id in ids if id in things][:MOST]:
        motion = _let_go(subject, things[id])
        if motion is not None:
            found[id] = motion
    return found


def _let_go(subject: Subject, thing: Thing) -> RigidMotion | None:
    model, data = subject.model, subject.data()
    positions, speeds = _addresses(model, thing)
    held, still = np.ones(model.nq, bool), np.ones(model.nv, bool)
    held[positions], still[speeds] = False, False
    start = _pose(data, thing.root)
    for _ in range(min(int(SECONDS / model.opt.timestep), MOST_STEPS)):
        mujoco.mj_step(model, data)
        data.qpos[held], data.qvel[still] = subject.start[held], 0.0
        if not np.isfinite(data.qpos).all() or np.linalg.norm(data.xpos[thing.root] - start[1]) > FAR:
            break
    mujoco.mj_kinematics(model, data)
    turn, place = _pose(data, thing.root)
    if not (np.isfinite(turn).all() and np.isfinite(place).all()):
        return None
    turned = turn @ start[0].T
    return RigidMotion(turned, place - turned @ start[1])


def _pose(data: mujoco.MjData, body: int) -> tuple[Array, Array]:
    return np.array(data.xmat[body]).reshape(3, 3), np.array(data.xpos[body])


def _addresses(model: mujoco.MjModel, thing: Thing) -> tuple[list[int], list[int]]:
    """Where the positions and the speeds of an object and its parts are."""
    widths = {int(mujoco.mjtJoint.mjJNT_FREE): (7, 6), int(mujoco.mjtJoint.mjJNT_BALL): (4, 3)}
    positions: list[int] = []
    speeds: list[int] = []
    for joint in range(model.njnt):
        if int(model.jnt_bodyid[joint]) in thing.bodies:
            wide, fast = widths.get(int(model.jnt_type[joint]), (1, 1))
            positions += range(int(model.jnt_qposadr[joint]), int(model.jnt_qposadr[joint]) + wide)
            speeds += range(int(model.jnt_dofadr[joint]), int(model.jnt_dofadr[joint]) + fast)
    return positions, speeds


def sweep(subject: Subject, of: str, link: str) -> tuple[Array, ...]:
    """Points (n, 3) of each part of what a door or drawer goes through from shut to open; none for an unknown joint."""
    model = subject.model
    names = (f"{of}/{link}", link)
    joint = next((j for name in names if (j := mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name)) >= 0), -1)
    if joint < 0 or not model.jnt_limited[joint]:
        return ()
    data, address = subject.data(), int(model.jnt_qposadr[joint])
    geoms = [g for body in _subtree(model, int(model.jnt_bodyid[joint])) for g in _geoms(model, body)]
    meshes = {geom: geom_mesh(model, geom) for geom in seen_geoms(model, geoms)}
    low, high = (float(limit) for limit in model.jnt_range[joint])
    stages: list[list[Array]] = []
    for value in np.linspace(low, high, STAGES):
        data.qpos[address] = value
        mujoco.mj_kinematics(model, data)
        stages.append([
            mesh.vertices @ np.array(data.geom_xmat[geom]).reshape(3, 3).T + data.geom_xpos[geom]
            for geom, mesh in meshes.items() if mesh is not None
        ])  # fmt: skip
    return tuple(
        np.concatenate([now, then])
        for first, second in pairwise(stages)
        for now, then in zip(first, second, strict=True)
    )


def _subtree(model: mujoco.MjModel, root: int) -> list[int]:
    bodies = [root]
    for body in range(root + 1, model.nbody):
        if int(model.body_parentid[body]) in bodies:
            bodies.append(body)
    return bodies


def _geoms(model: mujoco.MjModel, body: int) -> range:
    first = int(model.body_geomadr[body])
    return range(first, first + int(model.body_geomnum[body])) if first >= 0 else range(0)
