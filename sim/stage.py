"""A compiled, sleeping scene in which one object at a time is put, woken, touched and let go."""

import mujoco

from thinkblox.scene import Placement
from thinkblox.sim.build import compiled, yaw_quat
from thinkblox.sim.contacts import Contacts, shares
from thinkblox.sim.judge import Motion, Static, judge_motion, verdict
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics, Tolerances
from thinkblox.sim.settle import free_addresses, settle_body
from thinkblox.verdict import Reason, Support, Verdict

NUDGE = 1e-12
"""A speed that wakes a sleeping body and moves it nowhere [m/s]."""


class Stage:
    """One model and its state; every measurement starts from the model's reference pose, with everything asleep."""

    def __init__(self, spec: mujoco.MjSpec, physics: Physics) -> None:
        self._physics = physics
        self._model = compiled(spec)
        self._data = mujoco.MjData(self._model)
        self._contacts = Contacts(self._model)
        self._addresses = free_addresses(self._model)

    @quiet_engine()
    def put(self, id: str, placement: Placement) -> None:
        """Reset, and put the free body called `id` where a placement says."""
        address = self._addresses[id]
        mujoco.mj_resetData(self._model, self._data)
        self._data.qpos[address : address + 7] = (*placement.position, *yaw_quat(placement.yaw))
        mujoco.mj_forward(self._model, self._data)

    @quiet_engine()
    def wake(self, id: str) -> None:
        """Reset, and wake the free body called `id` where it is."""
        mujoco.mj_resetData(self._model, self._data)
        self._nudge(id)

    def touching(self, id: str) -> dict[str, float]:
        """Deepest contact of an object with each other thing [m]."""
        return self._contacts.depths_of(self._data, id)

    def settle(self, id: str) -> Motion:
        """Let the free body called `id` come to rest from where it is."""
        return settle_body(self._model, self._data, self._addresses[id], self._physics)

    def supports(self, id: str) -> tuple[Support, ...]:
        """What carries an object now, with which share of its weight."""
        self._nudge(id)
        weight = float(self._model.body(id).subtreemass[0]) * -self._physics.gravity[2]
        return shares(self._contacts.carriers_of(self._data, id), weight)

    def _nudge(self, id: str) -> None:
        """Wake a body where it is: while everything sleeps its contacts are left out of the state."""
        self._data.qvel[int(self._model.body(id).dofadr[0])] = NUDGE
        mujoco.mj_forward(self._model, self._data)


def settled_verdict(
    stage: Stage,
    id: str,
    placement: Placement,
    static: Static,
    tolerances: Tolerances,
    *,
    cut_off: tuple[str, ...] = (),
) -> Verdict:
    """The verdict on a free object that stands on the stage as `id`: settle it unless its pose is gated."""
    if static.gated:
        return verdict(placement, static, cut_off=cut_off)
    motion = stage.settle(id)
    moved = judge_motion(motion, tolerances)
    supports = () if motion.unstable else stage.supports(id)
    carried = sum(support.share for support in supports)
    loose: frozenset[Reason] = frozenset({"unsupported"} if carried < tolerances.carried and not moved else ())
    return verdict(placement, static, motion=motion, supports=supports, more=moved | loose, cut_off=cut_off)
