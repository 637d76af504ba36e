"""A compiled, sleeping scene in which one object at a time is put, and let go."""

import math
from collections import deque
from typing import NamedTuple

import mujoco
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement, to_micrometres
from thinkblox.sim.build import compiled, yaw_quat
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.balance import SLOW_TURN, at_rest, stands_squarely
from thinkblox.sim.verdict.contacts import Contacts, shares
from thinkblox.sim.verdict.judge import Motion
from thinkblox.sim.verdict.settle import asleep, diverged, free_addresses, motion_between
from thinkblox.verdict import Pose, Push, Support

NUDGE = 1e-12
"""A speed that wakes a sleeping body and moves it nowhere [m/s]."""
QUIET = 1.0
"""How long everything must have been slow to count as at rest when it never sleeps [s]."""
TREMBLE, TREMBLE_TURN = 0.0005, 0.002
"""And how little it may have moved and turned in that time [m, rad]."""
STEADY, INSTANTS = 0.95, 20
"""Less than this share of a weight borne is looked at again, over so many instants."""
FELT = 0.0005
"""What moved less was not pushed [m]."""


class Settled(NamedTuple):
    """How a settle went.

    Attributes:
        motion: of the object, and what it pushed.
        supports: what carries it at the end.
        moved, stirred: the farthest that any point of it, and of anything else, was from its start at any look [m].
        seconds: how long it took [s].
    """

    motion: Motion
    supports: tuple[Support, ...]
    moved: float
    stirred: float
    seconds: float


class Stage:
    """One model and its state; every settle starts from the model's reference pose, with everything asleep."""

    def __init__(self, spec: mujoco.MjSpec, physics: Physics) -> None:
        self._physics = physics
        self._model = compiled(spec)
        self._data = mujoco.MjData(self._model)
        self._contacts = Contacts(self._model)
        addresses = free_addresses(self._model)
        self._ids = list(addresses)
        self._poses = np.array(list(addresses.values()), dtype=np.intp)[:, None] + np.arange(7)
        self._radii = _radii(self._model, self._data, self._ids)

    @quiet_engine()
    def settle(self, id: str, placement: Placement) -> Settled:
        """Put the free body called `id` where a placement says, and let it come to rest.

        It is kept awake for `physics.least_settle_time`, for what topples may begin slowly, unless everything that is
        awake stands squarely before. It ends when all is at rest, when the body is lost or toppled, and when the time
        is over: what moves then is restless.
        """
        mine, tolerance = self._ids.index(id), self._model.opt.sleep_tolerance
        self._put(mine, placement)
        track = _Track(self._data, self._poses, self._radii)
        try:
            motion = self._run(int(self._model.body(id).id), mine, track)
        finally:
            self._model.opt.sleep_tolerance = tolerance
        stirred = np.delete(track.farthest, mine).max(initial=0.0)
        moved, seconds = float(track.farthest[mine]), float(self._data.time)
        if motion.unstable:
            return Settled(motion, (), moved, float(stirred), seconds)
        motion = structs.replace(motion, pushed=self._pushed(mine, track))
        return Settled(motion, self._supports(id, steady=motion.rest is not None), moved, float(stirred), seconds)

    def _put(self, number: int, placement: Placement) -> None:
        mujoco.mj_resetData(self._model, self._data)
        self._data.qpos[self._poses[number]] = (*placement.position, *yaw_quat(placement.yaw))
        mujoco.mj_forward(self._model, self._data)

    def _run(self, body: int, mine: int, track: "_Track") -> Motion:
        model, data, physics = self._model, self._data, self._physics
        interval = physics.timestep * physics.chunk
        tolerance, moving, quiet = model.opt.sleep_tolerance, 0.0, _Quiet(interval)
        for look in range(1, math.ceil(physics.settle_time / interval - 1e-9) + 1):
            model.opt.sleep_tolerance = 0.0 if (look - 1) * interval < physics.least_settle_time else tolerance
            mujoco.mj_step(model, data, nstep=physics.chunk)
            now = track.look()
            motion = motion_between(track.start[mine], now[mine], unstable=diverged(data))
            if motion.unstable or max(motion.drift, motion.drop) > physics.lost or motion.tilt > physics.toppled:
                return motion
            if not at_rest(model, data, body):
                moving = look * interval
            elif stands_squarely(model, data) or asleep(data):
                return _rested(motion, moving + interval, now[mine])
            quiet.look(data, now)
        rested = moving < look * interval and quiet.lasted
        return _rested(motion, moving + interval, now[mine]) if rested else structs.replace(motion, restless=True)

    def _pushed(self, mine: int, track: "_Track") -> tuple[Push, ...]:
        shift = np.linalg.norm(track.look()[:, :3] - track.start[:, :3], axis=1)
        found = [
            Push(other=id, distance=round(float(far), 6))
            for number, (id, far) in enumerate(zip(self._ids, shift, strict=True))
            if number != mine and far > FELT
        ]
        return tuple(sorted(found, key=lambda push: (-push.distance, push.other)))

    def _supports(self, id: str, *, steady: bool) -> tuple[Support, ...]:
        """What carries an object now, with which share of its weight; woken, for what sleeps has no contacts."""
        body = self._model.body(id)
        self._data.qvel[int(body.dofadr[0])] = NUDGE
        mujoco.mj_forward(self._model, self._data)
        weight = float(body.subtreemass[0]) * -self._physics.gravity[2]
        forces = self._contacts.carriers_of(self._data, id)
        if steady and sum(forces.values()) < STEADY * weight:
            forces = self._mean_forces(id)
        return shares(forces, weight)

    def _mean_forces(self, id: str) -> dict[str, float]:
        """What carries an object, over some instants: what stands lightly is borne by turns."""
        total: dict[str, float] = {}
        for _ in range(INSTANTS):
            mujoco.mj_step(self._model, self._data, nstep=2)
            for by, force in self._contacts.carriers_of(self._data, id).items():
                total[by] = total.get(by, 0.0) + force / INSTANTS
        return total


def _rested(motion: Motion, when: float, pose: NDArray[np.float64]) -> Motion:
    x, y, z, qw, qx, qy, qz = pose.tolist()
    yaw = math.degrees(math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz)))
    found = Pose(position=to_micrometres((x, y, z)), yaw=round(yaw % 360.0, 4) % 360.0)
    return structs.replace(motion, rest=round(when, 6), pose=found)


class _Quiet:
    """Whether everything has been still for a while, though the engine does not call it asleep: it trembles."""

    def __init__(self, interval: float) -> None:
        self._looks = math.ceil(QUIET / interval)
        self._poses: deque[NDArray[np.float64]] = deque(maxlen=self._looks + 1)

    def look(self, data: mujoco.MjData, poses: NDArray[np.float64]) -> None:
        """Take one look more; `poses` are those of the free bodies (n, 7)."""
        if float(np.abs(data.qvel).max(initial=0.0)) >= SLOW_TURN:
            self._poses.clear()
        self._poses.append(poses)

    @property
    def lasted(self) -> bool:
        """Whether nothing moved or turned to speak of between the looks of the last while."""
        if len(self._poses) <= self._looks:
            return False
        first, last = self._poses[0], self._poses[-1]
        shift = np.linalg.norm(last[:, :3] - first[:, :3], axis=1).max(initial=0.0)
        aligned = np.abs((last[:, 3:] * first[:, 3:]).sum(axis=1)).clip(0.0, 1.0)
        turned = 2.0 * np.arccos(aligned).max(initial=0.0)
        return bool(shift < TREMBLE and turned < TREMBLE_TURN)


class _Track:
    """How far free bodies have come from their start: of each the farthest that any point of it was seen [m]."""

    def __init__(self, data: mujoco.MjData, poses: NDArray[np.intp], radii: NDArray[np.float64]) -> None:
        self._data, self._poses, self._radii = data, poses, radii
        self.start: NDArray[np.float64] = data.qpos[poses]
        self.farthest = np.zeros(len(poses))

    def look(self) -> NDArray[np.float64]:
        """The poses now, (n, 7)."""
        now: NDArray[np.float64] = self._data.qpos[self._poses]
        shift = np.linalg.norm(now[:, :3] - self.start[:, :3], axis=1)
        aligned = np.abs((now[:, 3:] * self.start[:, 3:]).sum(axis=1)).clip(0.0, 1.0)
        farthest = shift + 2.0 * np.sqrt(1.0 - aligned**2) * self._radii
        self.farthest = np.fmax(self.farthest, np.where(np.isfinite(farthest), farthest, np.inf))
        return now


def _radii(model: mujoco.MjModel, data: mujoco.MjData, ids: list[str]) -> NDArray[np.float64]:
    """Of each free body the distance from its origin that nothing of it exceeds [m]."""
    mujoco.mj_kinematics(model, data)
    root = model.body_rootid[model.geom_bodyid]
    reach = np.linalg.norm(data.geom_xpos - data.xpos[root], axis=1) + model.geom_rbound
    radii = np.zeros(model.nbody)
    np.maximum.at(radii, root, reach)
    found: NDArray[np.float64] = radii[[int(model.body(id).id) for id in ids]]
    return found
