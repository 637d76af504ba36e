"""One bounded simulation of a subject, in a copy of its model, that ends early once nothing can move any more."""

import copy
from collections.abc import Iterator

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.settle import WARNINGS
from thinkblox.sim.subject import Subject
from thinkblox.suite import Finding

MOST_WORK = 2e10
"""Of one simulation, in steps times (dofs + constraint rows) to the power 1.5: some minutes of one core."""
AWAKE = 0.5
"""How long nothing may fall asleep [s]: what topples may begin slowly."""
_KINDS = {int(kind): kind.name.removeprefix("mjWARN_") for kind in mujoco.mjtWarning.__members__.values()}
_FATAL = [int(kind) for kind in WARNINGS]


class Run:
    """A simulation from the subject's start, or from another state.

    The model is a copy with its own options, except for `timestep` where it is given, and except that the engine may
    put to sleep what rests, which is how the end is known: what sleeps moves again only when something wakes it.

    Attributes:
        model: the copy.
        data: its state.
        seconds: how long it has been simulated [s].
        stopped: "" while it runs or has run its time, "asleep", "diverged" or "work" when that ended it early.
    """

    def __init__(
        self,
        subject: Subject,
        *,
        timestep: float | None = None,
        awake: float = AWAKE,
        qpos: NDArray[np.float64] | None = None,
    ) -> None:
        self.subject, self.model, self._awake = subject, copy.copy(subject.model), awake
        self._tolerance = self.model.opt.sleep_tolerance
        if timestep is not None:
            self.model.opt.timestep = timestep
        if int(self.model.opt.integrator) != int(mujoco.mjtIntegrator.mjINT_RK4):
            self.model.opt.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        self.data = mujoco.MjData(self.model)
        self.data.qpos[:] = subject.start if qpos is None else qpos
        mujoco.mj_forward(self.model, self.data)
        self.seconds, self.stopped, self._work = 0.0, "", 0.0

    def steps(self, seconds: float, *, chunk: int = 1) -> Iterator[None]:
        """Simulate on, pausing after every `chunk` steps; ends early when `stopped` says why."""
        count = round(seconds / self.model.opt.timestep)
        while count > 0 and not self.stopped:
            number = min(chunk, count)
            self._step(number)
            count -= number
            self._look()
            yield

    def pass_time(self, seconds: float) -> None:
        """Simulate on without pauses."""
        for _ in self.steps(seconds, chunk=25):
            pass

    def _step(self, number: int) -> None:
        self.model.opt.sleep_tolerance = 0.0 if self.seconds < self._awake else self._tolerance
        mujoco.mj_step(self.model, self.data, nstep=number)
        self.seconds += number * self.model.opt.timestep
        self._work += number * float(self.model.nv + self.data.nefc) ** 1.5

    def _look(self) -> None:
        if self.data.warning.number[_FATAL].any() or not np.isfinite(self.data.qpos).all():
            self.stopped = "diverged"
        elif self._work > MOST_WORK:
            self.stopped = "work"
        elif self.seconds >= self._awake and self.model.ntree and bool(np.all(self.data.tree_asleep >= 0)):
            self.stopped = "asleep"

    @property
    def diverged(self) -> bool:
        """Whether the engine's numbers mean nothing any more."""
        return self.stopped == "diverged"

    @property
    def unfinished(self) -> str:
        """Why it ended before anything was known, or ""."""
        if self.diverged:
            what = ", ".join(self.warnings) or "a coordinate that is not finite"
            return f"the simulation broke down after {self.seconds:.3f} s: {what}"
        if self.stopped == "work":
            return f"broken off after {self.seconds:.3f} s: the model is too large to be simulated for longer"
        return ""

    @property
    def warnings(self) -> dict[str, int]:
        """How often the engine warned of what, by the names of its warnings."""
        return {_KINDS[k]: int(n) for k, n in enumerate(self.data.warning.number) if n and k in _KINDS}

    @property
    def culprits(self) -> tuple[str, ...]:
        """The things whose numbers blew up, as far as the engine says; "scene" when it does not."""
        owners = {body: thing.id for thing in self.subject.things for body in thing.bodies}
        found = [owners.get(body, "scene") for body in self._bad_bodies()]
        return tuple(dict.fromkeys(found)) or ("scene",)

    def _bad_bodies(self) -> list[int]:
        warning, kinds, model = self.data.warning, mujoco.mjtWarning, self.model
        bodies = []
        for kind in (kinds.mjWARN_BADQPOS, kinds.mjWARN_BADQVEL, kinds.mjWARN_BADQACC):
            place = int(warning.lastinfo[int(kind)])
            if not warning.number[int(kind)]:
                continue
            if kind == kinds.mjWARN_BADQPOS:
                joint = int(np.searchsorted(model.jnt_qposadr, place, side="right")) - 1
                bodies.append(int(model.jnt_bodyid[joint]))
            else:
                bodies.append(int(model.dof_bodyid[place]))
        return bodies

    def blown(self, objects: tuple[str, ...]) -> list[Finding]:
        """Findings of a simulation that diverged: what blew up fails, the others are not known."""
        note = self.unfinished
        found = [Finding(object=id, value=None, passed=False, note=note) for id in self.culprits]
        rest = "not measured: the simulation broke down"
        return found + [
            Finding(object=id, value=None, passed=None, note=rest) for id in objects if id not in self.culprits
        ]
