"""MolmoSpaces: does every object stay, can what is light be lifted, does everything that is hinged open."""

from dataclasses import dataclass, field

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.criteria import above, criterion, exempt, paragraphs, result
from thinkblox.sim.suites.forces import lifted, opened
from thinkblox.sim.suites.joints import Hinged, hinged
from thinkblox.sim.suites.running import EARLY_END, Run
from thinkblox.sim.suites.touching import Owners
from thinkblox.suite import Criterion, Finding, SuiteResult

SOURCE = (
    "Kim et al., MolmoSpaces: A Large-Scale Open Ecosystem for Robot Navigation and Manipulation, 2026, "
    "https://arxiv.org/abs/2602.11337; as in mlspaces_tests/scenes of https://github.com/allenai/molmospaces"
)
TIMESTEP, SETTLE, MONITOR = 0.002, 1.0, 3.0
DRIFT, JITTER, OPENING, DEPTH = 0.05, 0.1, 0.1, 0.01
STIRRED = 1e-6
"""By which a joint without limits has moved [rad or m]."""
FREEDOM = 6
NOTES = paragraphs(
    """
    Simulated in a copy with the source's step of 2 ms. The source lets what rests sleep in the engine; here nothing
    sleeps that would not in the model itself.

    The source lifts what its list of household categories calls pickupable, with at most 30 N; here that is
    every free object that 30 N can lift.

    As in the source all objects are lifted at once, and all joints pushed at once; what fails is then tried
    alone, which the source offers as its other mode, and passes if it passes there.

    20 N is a generalised force: newton metres on a hinge.

    As in the source every body with six degrees of freedom of its own is an object, be they those of a free joint or
    of six slides and hinges; only what has a free joint is lifted. A joint without limits, whose range is 0 there,
    fails as soon as it moves at all: here by more than a micrometre or microradian, since rounding alone moves it.

    The source lists engine warnings without failing a scene for them; here one fails it.
    """
)


@dataclass
class Stability:
    """What one simulation of settling and monitoring measured; distances in metres, by object or joint.

    Attributes:
        stirred: by how much joints without limits moved [rad or m].
    """

    drift: dict[str, float] = field(default_factory=dict)
    jitter: dict[str, float] = field(default_factory=dict)
    openings: dict[str, float] = field(default_factory=dict)
    stirred: dict[str, float] = field(default_factory=dict)
    depths: dict[tuple[str, str], float] = field(default_factory=dict)


def run(subject: Subject, *, seed: int = 0) -> SuiteResult:
    """All criteria of MolmoSpaces; nothing in it is random."""
    del seed
    free = tuple(thing for thing in subject.things if thing.free)
    bodies, joints = _free_bodies(subject), hinged(subject)
    stability = Run(subject, SETTLE + MONITOR, creep=DRIFT / 100, timestep=TIMESTEP)
    measured = _stand(stability, bodies, joints)
    lifting = lifted(subject, free, timestep=TIMESTEP)
    opening = opened(subject, joints, timestep=TIMESTEP)
    warnings = _together(stability.warnings, lifting.warnings, opening.warnings)
    criteria = [
        *_stability(subject, stability, measured, tuple(bodies), joints),
        criterion(
            "lift", "an upward force of its weight and a little, at most 30 N, moves it by 5 cm within 1 s",
            lifting.findings, unit="m", limit=0.05, least=True, unfinished=lifting.unfinished,
        ),
        criterion(
            "articulation", "20 N or 20 N m for at most 2 s opens it by 66.7 % of its range",
            opening.findings, unit="share", limit=0.667, least=True, unfinished=opening.unfinished,
        ),
        _warnings(warnings),
    ]  # fmt: skip
    return result("molmospaces", SOURCE, criteria, (*NOTES, EARLY_END))


def _free_bodies(subject: Subject) -> dict[str, int]:
    """Every body of a thing that has six degrees of freedom of its own, by its thing's name, or its own within one."""
    model = subject.model
    return {
        thing.id if body == thing.root else str(model.body(body).name) or f"{thing.id} body {body}": body
        for thing in subject.things
        for body in thing.bodies
        if int(model.body_dofnum[body]) == FREEDOM
    }


def _stand(run: Run, free: dict[str, int], joints: tuple[Hinged, ...]) -> Stability:
    """Settle for a second, then watch for three."""
    found = Stability()
    bodies, places = list(free.values()), [joint.qpos for joint in joints]
    before = run.data.qpos[places].copy()
    run.pass_time(SETTLE)
    if run.diverged:
        return found
    found.depths = Owners(run.subject).depths(run.model, run.data, within=True)
    mujoco.mj_kinematics(run.model, run.data)
    start, path = run.data.xpos[bodies].copy(), np.zeros(len(bodies))
    last = start
    for _ in run.steps(MONITOR):
        now = run.data.xpos[bodies]
        path += np.linalg.norm(now - last, axis=1)
        last = now
    drift = np.linalg.norm(last - start, axis=1)
    found.drift = dict(zip(free, drift.tolist(), strict=True))
    found.jitter = dict(zip(free, path.tolist(), strict=True))
    moved = run.data.qpos[places] - before
    found.openings = _openings(moved, joints)
    found.stirred = {j.id: abs(float(m)) for j, m in zip(joints, moved, strict=True) if j.range <= 0.0}
    return found


def _openings(moved: NDArray[np.float64], joints: tuple[Hinged, ...]) -> dict[str, float]:
    return {j.id: abs(float(m)) / j.range for j, m in zip(joints, moved, strict=True) if j.range > 0.0}


def _stability(
    subject: Subject, run: Run, found: Stability, still: tuple[str, ...], joints: tuple[Hinged, ...]
) -> list[Criterion]:
    broken = run.unfinished
    fixed = [exempt(t.id, "fixed to the world") for t in subject.things if t.id not in still]

    def watched(values: dict[str, float], limit: float) -> list[Finding]:
        return run.blown(still) if run.diverged else [above(id, v, limit) for id, v in values.items()] + fixed

    def swung() -> list[Finding]:
        if run.diverged:
            return run.blown(tuple(j.id for j in joints))
        endless = [_endless(id, moved) for id, moved in found.stirred.items()]
        return [above(id, v, OPENING) for id, v in found.openings.items()] + endless

    return [
        criterion(
            "body_drift", "moves less than 5 cm in 3 s, after 1 s of settling", watched(found.drift, DRIFT),
            unit="m", limit=DRIFT, unfinished=broken,
        ),
        criterion(
            "body_jitter", "its path in these 3 s is shorter than 10 cm", watched(found.jitter, JITTER),
            unit="m", limit=JITTER, unfinished=broken,
        ),
        criterion(
            "joint_drift", "no joint moves by 10 % of its range in these 4 s", swung(),
            unit="share", limit=OPENING, unfinished=broken,
        ),
        _penetration(run, found.depths, still),
    ]  # fmt: skip


def _endless(id: str, moved: float) -> Finding:
    """Of a joint without limits; a range of 0 is what the source divides by."""
    if moved <= STIRRED:
        return exempt(id, "its range has no end, and it did not move")
    return Finding(object=id, value=None, passed=False, note=f"its range has no end, and it moved by {moved:.3g}")


def _penetration(run: Run, depths: dict[tuple[str, str], float], still: tuple[str, ...]) -> Criterion:
    found = run.blown(still)
    if not run.diverged:
        found = [above(_pair(*pair), depth, DEPTH, inclusive=False) for pair, depth in depths.items()]
        touching = {name for pair in depths for name in pair}
        found += [above(t.id, 0.0, DEPTH) for t in run.subject.things if t.id not in touching]
    return criterion(
        "penetration", "after 1 s of settling no contact is deeper than 1 cm", found,
        unit="m", limit=DEPTH, unfinished=run.unfinished if run.diverged else "",
    )  # fmt: skip


def _pair(first: str, second: str) -> str:
    return f"{first} + {second}"


def _together(*counts: dict[str, int]) -> dict[str, int]:
    """Warnings of several simulations, added up."""
    return {name: sum(c.get(name, 0) for c in counts) for name in sorted({n for c in counts for n in c})}


def _warnings(counts: dict[str, int]) -> Criterion:
    total = sum(counts.values())
    note = ", ".join(f"{name} {count} times" for name, count in counts.items())
    return criterion(
        "solver_warnings", "the engine warns of nothing in any of these simulations",
        [Finding(object="scene", value=float(total), passed=not total, note=note)], unit="count", limit=0.0,
    )  # fmt: skip
