"""What no suite can measure: a scene without objects, one that is not made of numbers, one that is too large."""

import mujoco
import numpy as np

from thinkblox.sim.subject import Subject
from thinkblox.suite import Criterion, Finding

MOST_BODIES = 10_000
"""Larger models are refused."""


def unusable(subject: Subject) -> Criterion | None:
    """Why nothing can be measured, as a criterion that is not met; None when all is well."""
    model = subject.model
    if not subject.things:
        return _refusal("objects", "there is at least one object", 1.0, 0.0, "the scene has no objects")
    if model.nbody > MOST_BODIES:
        note = f"{model.nbody} bodies are too many to be simulated here; at most {MOST_BODIES} are"
        return _refusal("size", f"at most {MOST_BODIES} bodies", MOST_BODIES, float(model.nbody), note)
    wrong = _not_numbers(subject)
    if wrong:
        note = "the start of the simulation holds a number that is not finite"
        found = tuple(Finding(object=id, value=None, passed=False, note=note) for id in wrong)
        says = "every coordinate at the start is a finite number"
        return _refusal("finite_start", says, None, None, note, found)
    return None


def _refusal(
    name: str, says: str, limit: float | None, value: float | None, note: str, findings: tuple[Finding, ...] = ()
) -> Criterion:
    unit = "" if limit is None else "count"
    found = findings or (Finding(object="scene", value=value, passed=False, note=note),)
    return Criterion(name=name, says=says, unit=unit, limit=limit, value=value, passed=False, findings=found, note=note)


def _not_numbers(subject: Subject) -> list[str]:
    if np.all(np.isfinite(subject.start)):
        return []
    model, data = subject.model, mujoco.MjData(subject.model)
    data.qpos[:] = subject.start
    mujoco.mj_kinematics(model, data)
    finite = np.isfinite(data.xpos).all(axis=1) & np.isfinite(data.xquat).all(axis=1)
    return [t.id for t in subject.things if not finite[list(t.bodies)].all()] or ["scene"]
