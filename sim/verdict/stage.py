"""A compiled scene in which one object at a time is put, and let go."""

import math
from typing import NamedTuple

import mujoco
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement, to_micrometres
from thinkblox.sim.build import compiled, yaw_quat
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.balance import at_rest, unsteady
from thinkblox.sim.verdict.contacts import Contacts, shares
from thinkblox.sim.verdict.judge import Motion
from thinkblox.sim.verdict.settle import diverged, free_addresses, motion_between, turn
from thinkblox.sim.verdict.stillness import QUIET, Quiet, stayed
from thinkblox.verdict import Pose, Push, Support

NUDGE = 1e-12
"""A speed that wakes a sleeping body and moves it nowhere [m/s]."""
STEADY, WHILE = 0.95, 1.0
"""Less than this share of a weight borne is looked at again, for so long [s]: what sways out takes most of it."""
PATIENCE = 0.25
"""What lies still must have done so for this share of the time until then: what hops is still between two hops."""
RESTING = 0.0001
"""Contacts at rest that are no deeper are not told of [m]; most things rest 0.01 to 0.05 mm deep."""
FELT, FELT_TURN = 0.0005, 0.2
"""What moved and turned less was not pushed [m, degrees]."""

Poses = dict[str, NDArray[np.float64]]
Depths = dict[tuple[str, str], float]


class Settled(NamedTuple):
    """How a settle went.

    Attributes:
        motion: of the object, and what it pushed.
        supports: what carries it at the end.
        depths: of every two things that touch deeper than RESTING at the end, where it came to rest [m].
        poses: of the other free bodies that moved at all, at the end, by name: position and quaternion wxyz.
        moved, stirred: the farthest that any point of it, and of anything else, was from its start at any look [m].
        uneasy: names of the free bodies, itself among them, that had not come to rest when the time was over.
        decided: it lies or stands for good; else the time was over.
    """

    motion: Motion
    supports: tuple[Support, ...]
    depths: Depths
    poses: Poses
    moved: float
    stirred: float
    uneasy: frozenset[str]
    decided: bool


class _Course(NamedTuple):
    """The motion of the object, and whether it can only stay where it is."""

    motion: Motion
    proven: bool = False
    uneasy: frozenset[str] = frozenset()

    @property
    def decided(self) -> bool:
        """Whether it can only stay, or has been given up."""
        return self.proven or (self.motion.rest is None and not self.motion.restless)


class Stage:
    """One model and its state; every settle starts from the model's reference pose, with what it has asleep."""

    def __init__(self, spec: mujoco.MjSpec, physics: Physics) -> None:
        self._physics = physics
        self._model = compiled(spec)
        self._data = mujoco.MjData(self._model)
        self._contacts = Contacts(self._model)
        addresses = free_addresses(self._model)
        self._ids = list(addresses)
        self._poses = np.array(list(addresses.values()), dtype=np.intp)[:, None] + np.arange(7)
        self._radii = _radii(self._model, self._data, self._ids)
        little = math.sin(math.radians(physics.toppled) / 8)
        self._little = np.array([physics.lost / 2] * 3 + [little] * 4)

    @quiet_engine()
    def settle(self, id: str, placement: Placement, *, seconds: float) -> Settled:
        """Put the free body called `id` where a placement says, and let it come to rest, for so long at most.

        It ends when everything that is awake stands squarely, so that it can only stay, when the body is lost or
        toppled, and when the time is over: what moves then is restless. Nothing falls asleep meanwhile, for what
        topples may begin slowly.
        """
        mine, tolerance = self._ids.index(id), self._model.opt.sleep_tolerance
        self._put(mine, placement)
        track = _Track(self._data, self._poses, self._radii)
        self._model.opt.sleep_tolerance = 0.0
        try:
            course = self._run(int(self._model.body(id).id), mine, track, seconds)
            now, farthest = track.look(), track.farthest()
            supports, depths = self._reading(id, course) if not course.motion.unstable else ((), {})
        finally:
            self._model.opt.sleep_tolerance = tolerance
        others = [int(n) for n in np.flatnonzero((now != track.start).any(axis=1)) if n != mine]
        poses, start = ({self._ids[n]: each[n] for n in others} for each in (now, track.start))
        motion = structs.replace(course.motion, pushed=() if course.motion.unstable else pushes(start, poses))
        stirred = float(np.delete(farthest, mine).max(initial=0.0))
        return Settled(motion, supports, depths, poses, float(farthest[mine]), stirred, course.uneasy, course.decided)

    def _put(self, number: int, placement: Placement) -> None:
        mujoco.mj_resetData(self._model, self._data)
        self._data.qpos[self._poses[number]] = (*placement.position, *yaw_quat(placement.yaw))
        mujoco.mj_forward(self._model, self._data)

    def _run(self, body: int, mine: int, track: "_Track", seconds: float) -> _Course:
        model, data, physics = self._model, self._data, self._physics
        interval = physics.timestep * physics.chunk
        moving, stirred, quiet, now, suspect = 0.0, 0, Quiet(interval), track.start, body
        for look in range(1, math.ceil(seconds / interval - 1e-9) + 1):
            mujoco.mj_step(model, data, nstep=physics.chunk)
            before, now = now, track.look()
            unstable = diverged(data)
            if unstable or not (np.abs(now[mine] - track.start[mine]) < self._little).all():
                motion = motion_between(track.start[mine], now[mine], unstable=unstable)
                if motion.unstable or max(motion.drift, motion.drop) > physics.lost or motion.tilt > physics.toppled:
                    return _Course(motion)
            if not at_rest(model, data, body):
                moving, stirred = look * interval, look
            elif not stayed(before, now, interval):
                stirred = look
            elif look - stirred >= PATIENCE * stirred:
                found = unsteady(model, data, suspect=suspect)
                if found is None:
                    motion = motion_between(track.start[mine], now[mine])
                    return _Course(_rested(motion, moving + interval, now[mine]), proven=True)
                suspect = found
            quiet.look(now)
        motion = motion_between(track.start[mine], now[mine])
        uneasy = frozenset(self._ids[n] for n in np.flatnonzero(~quiet.lasted).tolist())
        if self._ids[mine] not in uneasy:
            motion = _rested(motion, min(moving, seconds - QUIET) + interval, now[mine])
        return _Course(structs.replace(motion, restless=bool(uneasy)), uneasy=uneasy)

    def _reading(self, id: str, course: _Course) -> tuple[tuple[Support, ...], Depths]:
        """What carries an object now, with which share of its weight, and how deep things touch.

        What can only stay is read at once, and what stands lightly, sways or is borne by turns, over a while.
        """
        body, rested = self._model.body(id), course.motion.rest is not None
        self._data.qvel[int(body.dofadr[0])] = NUDGE
        mujoco.mj_forward(self._model, self._data)
        weight = float(body.subtreemass[0]) * -self._physics.gravity[2]
        forces, depths = self._contacts.carriers_of(self._data, id), self._contacts.depths(self._data, deeper=RESTING)
        if rested and not (course.proven and sum(forces.values()) >= STEADY * weight):
            forces, depths = self._mean_forces(id)
        return shares(forces, weight), depths if rested else {}

    def _mean_forces(self, id: str) -> tuple[dict[str, float], Depths]:
        """What carries an object and how deep things touch, on average over a while."""
        total: dict[str, float] = {}
        deep: Depths = {}
        steps = max(1, self._physics.chunk // 2)
        instants = math.ceil(WHILE / (steps * self._physics.timestep))
        for _ in range(instants):
            mujoco.mj_step(self._model, self._data, nstep=steps)
            for by, force in self._contacts.carriers_of(self._data, id).items():
                total[by] = total.get(by, 0.0) + force / instants
            for pair, depth in self._contacts.depths(self._data, deeper=RESTING).items():
                deep[pair] = deep.get(pair, 0.0) + depth / instants
        return total, deep


def pushes(before: Poses, after: Poses) -> tuple[Push, ...]:
    """How far bodies are from where they were, or would have been, furthest first; what was not felt is left out."""
    found = []
    for other, pose in after.items():
        far, turned = float(np.linalg.norm(pose[:3] - before[other][:3])), turn(before[other][3:], pose[3:])
        if far > FELT or turned > FELT_TURN:
            found.append(Push(other=other, distance=round(far, 6), tilt=round(turned, 4)))
    return tuple(sorted(found, key=lambda push: (-push.distance, push.other)))


def _rested(motion: Motion, when: float, pose: NDArray[np.float64]) -> Motion:
    x, y, z, qw, qx, qy, qz = pose.tolist()
    yaw = math.degrees(math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz)))
    found = Pose(position=to_micrometres((x, y, z)), yaw=round(yaw % 360.0, 4) % 360.0)
    return structs.replace(motion, rest=round(when, 6), pose=found)


class _Track:
    """Where free bodies (n) were at the looks so far, (n, 7) each, the first of which is their start."""

    def __init__(self, data: mujoco.MjData, poses: NDArray[np.intp], radii: NDArray[np.float64]) -> None:
        self._qpos, self._poses, self._radii = data.qpos, poses, radii
        self.start: NDArray[np.float64] = self._qpos[poses]
        self._seen = [self.start]

    def look(self) -> NDArray[np.float64]:
        """The poses now."""
        now: NDArray[np.float64] = self._qpos[self._poses]
        self._seen.append(now)
        return now

    def farthest(self) -> NDArray[np.float64]:
        """How far from its start any point of a body was seen at most (n) [m]."""
        seen = np.array(self._seen)
        moved = seen[:, :, :3] - self.start[:, :3]
        shift = np.sqrt((moved * moved).sum(axis=2))
        aligned = np.abs((seen[:, :, 3:] * self.start[:, 3:]).sum(axis=2)).clip(0.0, 1.0)
        far = shift + 2.0 * np.sqrt(1.0 - aligned**2) * self._radii
        farthest: NDArray[np.float64] = np.where(np.isfinite(far), far, np.inf).max(axis=0)
        return farthest


def _radii(model: mujoco.MjModel, data: mujoco.MjData, ids: list[str]) -> NDArray[np.float64]:
    """Of each free body the distance from its origin that nothing of it exceeds [m]."""
    mujoco.mj_kinematics(model, data)
    root = model.body_rootid[model.geom_bodyid]
    reach = np.linalg.norm(data.geom_xpos - data.xpos[root], axis=1) + model.geom_rbound
    radii = np.zeros(model.nbody)
    np.maximum.at(radii, root, reach)
    found: NDArray[np.float64] = radii[[int(model.body(id).id) for id in ids]]
    return found
