"""Does everything stay: how far each free object has moved and turned after some seconds of gravity."""

import math
from dataclasses import dataclass

import numpy as np

from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.criteria import exempt
from thinkblox.sim.suites.running import Run
from thinkblox.sim.verdict.settle import turn
from thinkblox.suite import Finding

MOVED, TURNED = 0.01, 0.1
"""What stays within both is stable [m, rad]."""


@dataclass(frozen=True)
class Displacement:
    """How far one object has come from where it began [m], and turned [rad]."""

    id: str
    moved: float
    turned: float

    @property
    def stable(self) -> bool:
        """Whether it is where it was, by the source's thresholds."""
        return self.moved <= MOVED and self.turned <= TURNED


def motions(subject: Subject, run: Run, seconds: float) -> tuple[Displacement, ...]:
    """Simulate, and compare every free object with its start; empty when the simulation broke down."""
    roots = [(thing.id, thing.root) for thing in subject.things if thing.free]
    start, facing = run.data.xpos.copy(), run.data.xquat.copy()
    run.pass_time(seconds)
    if run.diverged:
        return ()
    end, faced = run.data.xpos, run.data.xquat
    return tuple(
        Displacement(
            id=id,
            moved=float(np.linalg.norm(end[root] - start[root])),
            turned=math.radians(turn(facing[root], faced[root])),
        )
        for id, root in roots
    )


def fixed(subject: Subject) -> list[Finding]:
    """Findings of the things that cannot move."""
    return [exempt(thing.id, "fixed to the world") for thing in subject.things if not thing.free]
