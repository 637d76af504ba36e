"""One bounded simulation of a subject, in a copy of its model, that ends early once all is still."""

import copy
from collections.abc import Iterator

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.stillness import INTERVAL, LEAST, Stillness
from thinkblox.sim.verdict.settle import WARNINGS
from thinkblox.suite import Finding

MOST_WORK = 2e10
"""Of one simulation, in steps times (dofs + constraint rows) to the power 1.5: some minutes of one core."""
SLOW = 0.0005
"""Speed below which the engine puts to sleep what may sleep [m/s]."""
EARLY_END = (
    "A simulation ends early, after half a second at least, when nothing gains speed and nothing would, at the rate of "
    "the last quarter of a second, come further in the time that is left than a hundredth of the limit."
)
_KINDS = {int(kind): kind.name.removeprefix("mjWARN_") for kind in mujoco.mjtWarning.__members__.values()}
_FATAL = [int(kind) for kind in WARNINGS]


class Run:
    """A simulation from the subject's start, or from another state, in a copy of the model with its own options.

    Attributes:
        model: the copy.
        data: its state.
        seconds: how long it has been simulated [s].
        stopped: "" while it runs or has run its time; "still", "diverged" or "work" when that ended it early.
    """

    def __init__(
        self,
        subject: Subject,
        seconds: float,
        *,
        creep: float,
        sleep: bool = False,
        timestep: float | None = None,
        qpos: NDArray[np.float64] | None = None,
    ) -> None:
        """Begin.

        Args:
            subject: what is simulated.
            seconds: in all.
            creep: what would come less far than this in the time that is left is still [m].
            sleep: the engine may put to sleep, after LEAST, what is slower than SLOW, so that it costs less.
            timestep: instead of the model's own [s].
            qpos: instead of the subject's start.
        """
        self.subject, self.model, self._end = subject, copy.copy(subject.model), seconds
        if timestep is not None:
            self.model.opt.timestep = timestep
        self._sleep = sleep and int(self.model.opt.integrator) != int(mujoco.mjtIntegrator.mjINT_RK4)
        if self._sleep:
            self.model.opt.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        self.data = mujoco.MjData(self.model)
        self.data.qpos[:] = subject.start if qpos is None else qpos
        mujoco.mj_forward(self.model, self.data)
        self.seconds, self.stopped, self._work, self._next_look = 0.0, "", 0.0, INTERVAL
        self._stillness = Stillness(self.model, creep)

    def steps(self, seconds: float) -> Iterator[None]:
        """Simulate on, pausing after every step; ends early when `stopped` says why."""
        for _ in range(round(seconds / self.model.opt.timestep)):
            if self.stopped:
                return
            if self._sleep:
                self.model.opt.sleep_tolerance = 0.0 if self.seconds < LEAST else SLOW
            mujoco.mj_step(self.model, self.data)
            self._look()
            yield

    def pass_time(self, seconds: float) -> None:
        """Simulate on without pauses."""
        for _ in self.steps(seconds):
            pass

    def _look(self) -> None:
        self.seconds += self.model.opt.timestep
        self._work += float(self.model.nv + self.data.nefc) ** 1.5
        if self.data.warning.number[_FATAL].any():
            self.stopped = "diverged"
        elif self._work > MOST_WORK:
            self.stopped = "work"
        elif self.seconds >= self._next_look:
            self._next_look += INTERVAL
            still = self._stillness.look(self.data, self._end - self.seconds)
            if not np.isfinite(self.data.qpos).all():
                self.stopped = "diverged"
            elif still and self.seconds >= LEAST:
                self.stopped = "still"

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
