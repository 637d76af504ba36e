"""MolmoSpaces' two tests by force: lifting what is light, and opening what is hinged."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.subject import Subject, Thing
from thinkblox.sim.suites.criteria import exempt, number
from thinkblox.sim.suites.joints import Hinged
from thinkblox.sim.suites.running import Run
from thinkblox.suite import Finding

LIFT_TIME, LIFT_DISTANCE = 1.0, 0.05
LEAST_FORCE, MOST_FORCE = 0.1, 30.0
EXTRA_GRAVITY, EXTRA_FORCE = 0.3, 0.5
"""What is pulled with beyond the weight: mass times this [m/s2], and this [N]."""
PUSH, PUSH_TIME, OPEN = 20.0, 2.0, 0.667
MOST_RETRIES = 200
"""So many of those that failed together are tried alone."""


Attempt = Callable[[Sequence[int]], tuple[list[float], Run]]
"""Tries the objects of these numbers in one simulation: what each reached, and the simulation."""


@dataclass(frozen=True)
class Tested:
    """Findings of a test by force, the engine's warnings during it, and why it was broken off, or ""."""

    findings: tuple[Finding, ...]
    warnings: dict[str, int]
    unfinished: str


def lifted(subject: Subject, free: Sequence[Thing], *, timestep: float) -> Tested:
    """Pull every free thing upwards that MOST_FORCE can lift, until it has moved by LIFT_DISTANCE."""
    needed = {t.id: float(_pull(subject, [t.root])[0]) for t in free}
    light = [t for t in free if needed[t.id] <= MOST_FORCE]
    heavy = [exempt(t.id, f"takes {needed[t.id]:.0f} N: not a thing to pick up") for t in free if t not in light]
    fixed = [exempt(t.id, "fixed to the world") for t in subject.things if not t.free]

    def attempt(chosen: Sequence[int]) -> tuple[list[float], Run]:
        return _lift(subject, [light[k] for k in chosen], timestep)

    distances, runs = _with_retries(len(light), attempt, LIFT_DISTANCE)
    found = [_reached(t.id, d, LIFT_DISTANCE) for t, d in zip(light, distances, strict=True)]
    return _tested([*found, *heavy, *fixed], runs, tuple(t.id for t in light))


def opened(subject: Subject, joints: Sequence[Hinged], *, timestep: float) -> Tested:
    """Push every joint that has limits towards its far end, until it is OPEN."""
    ending = [j for j in joints if j.range > 0.0]
    endless = [exempt(j.id, "its range has no end") for j in joints if j.range <= 0.0]

    def attempt(chosen: Sequence[int]) -> tuple[list[float], Run]:
        return _open(subject, [ending[k] for k in chosen], timestep)

    shares, runs = _with_retries(len(ending), attempt, OPEN)
    found = [_reached(j.id, s, OPEN) for j, s in zip(ending, shares, strict=True)]
    return _tested([*found, *endless], runs, tuple(j.id for j in ending))


def _with_retries(count: int, attempt: Attempt, enough: float) -> tuple[list[float], list[Run]]:
    """Try all at once, then each alone that did not reach what is enough."""
    if not count:
        return [], []
    values, run = attempt(range(count))
    runs = [run]
    failed = [k for k, value in enumerate(values) if not value >= enough]
    if count > 1 and not run.diverged:
        for k in failed[:MOST_RETRIES]:
            (alone,), run = attempt([k])
            values[k] = max(values[k], alone)
            runs.append(run)
    return values, runs


def _lift(subject: Subject, things: Sequence[Thing], timestep: float) -> tuple[list[float], Run]:
    """Distance that each thing moved at most [m], all of them pulled in one simulation."""
    run = Run(subject, LIFT_TIME, creep=LIFT_DISTANCE / 100, timestep=timestep)
    bodies = np.array([t.root for t in things])
    first = run.model.body_dofadr[bodies]
    start, far = run.data.xpos[bodies].copy(), np.zeros(len(bodies))
    done = np.zeros(len(bodies), bool)
    run.data.xfrc_applied[bodies, 2] = np.clip(_pull(subject, bodies), LEAST_FORCE, MOST_FORCE)
    for _ in run.steps(LIFT_TIME):
        far = np.maximum(far, np.linalg.norm(run.data.xpos[bodies] - start, axis=1))
        for k in np.flatnonzero((far >= LIFT_DISTANCE) & ~done):
            done[k] = True
            run.data.xfrc_applied[bodies[k], 2] = 0.0
            run.data.qvel[first[k] : first[k] + 6] = 0.0
        if done.all():
            break
    return far.tolist(), run


def _pull(subject: Subject, bodies: Sequence[int] | NDArray[np.int64]) -> NDArray[np.float64]:
    """The force that the source lifts bodies with [N], before it is limited."""
    model = subject.model
    gravity = abs(float(model.opt.gravity[2]))
    return np.asarray(model.body_subtreemass[bodies] * (gravity + EXTRA_GRAVITY) + EXTRA_FORCE, np.float64)


def _open(subject: Subject, joints: Sequence[Hinged], timestep: float) -> tuple[list[float], Run]:
    """Share of its range that each joint opened at most, all of them pushed in one simulation."""
    run = Run(subject, PUSH_TIME, creep=LIFT_DISTANCE / 100, timestep=timestep)
    places, dofs = np.array([j.qpos for j in joints]), np.array([j.dof for j in joints])
    ranges = np.array([j.range for j in joints])
    start = run.data.qpos[places].copy()
    towards = np.where(np.abs(start - [j.lower for j in joints]) < np.abs(start - [j.upper for j in joints]), 1.0, -1.0)
    share, done = np.zeros(len(joints)), np.zeros(len(joints), bool)
    run.data.qfrc_applied[dofs] = PUSH * towards
    for _ in run.steps(PUSH_TIME):
        share = np.maximum(share, np.abs(run.data.qpos[places] - start) / ranges)
        for k in np.flatnonzero((share >= OPEN) & ~done):
            done[k] = True
            run.data.qfrc_applied[dofs[k]], run.data.qvel[dofs[k]] = 0.0, 0.0
        if done.all():
            break
    return share.tolist(), run


def _reached(object: str, value: float, enough: float) -> Finding:
    return Finding(object=object, value=number(value), passed=bool(value >= enough))


def _tested(findings: list[Finding], runs: list[Run], objects: tuple[str, ...]) -> Tested:
    counts: dict[str, int] = {}
    for run in runs:
        for name, count in run.warnings.items():
            counts[name] = counts.get(name, 0) + count
    broken = next((run for run in runs if run.diverged), None)
    if broken is not None:
        known = [f for f in findings if f.object not in objects]
        return Tested((*broken.blown(objects), *known), counts, broken.unfinished)
    return Tested(tuple(findings), counts, next((run.unfinished for run in runs if run.unfinished), ""))
