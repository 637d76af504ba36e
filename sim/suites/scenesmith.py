"""SceneSmith: the collision rate and the stability that it reports of its own scenes, as bars."""

import msgspec

from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.criteria import criterion, number, paragraphs, result
from thinkblox.sim.suites.equilibrium import MOVED, Displacement, fixed, motions
from thinkblox.sim.suites.overlaps import Overlaps
from thinkblox.sim.suites.running import EARLY_END, Run
from thinkblox.suite import Criterion, Finding, SuiteResult

SOURCE = (
    "Pfaff et al., SceneSmith: Agentic Generation of Simulation-Ready Indoor Scenes, 2026, "
    "https://arxiv.org/abs/2602.09153; thresholds from https://github.com/nepfaff/scenesmith and "
    "https://github.com/nepfaff/SceneEval"
)
SECONDS = 15.0
COLLIDING, STABLE = 0.02, 0.96
NOTES = paragraphs(
    """
    The bars are what the paper reports of its scenes: under 2 % of the objects in collision and 96 % stable,
    averages over many rooms that are asked of a single one here.

    Collision is a contact between objects deeper than 1 mm at the start. Stable is what ends within 1 cm and
    0.1 rad of its start: the thresholds of the evaluation fork.

    Simulated for 15 s, as the generator lets its own scenes settle; its evaluation simulates 5 s.

    The source simulates in Drake with a step of 1 ms; here it is MuJoCo with the model's own options.
    """
)


def run(subject: Subject, *, seed: int = 0) -> SuiteResult:
    """Both criteria of SceneSmith; nothing in it is random."""
    del seed
    simulation = Run(subject, SECONDS, creep=MOVED / 100)
    criteria = [_collisions(Overlaps(subject, simulation)), _stability(subject, simulation)]
    return result("scenesmith", SOURCE, criteria, (*NOTES, EARLY_END))


def _collisions(overlaps: Overlaps) -> Criterion:
    count, total = len(overlaps.colliding), len(overlaps.ids)
    share = count / total if total else None
    found = overlaps.with_each_other()
    return _bar(
        "collision_rate", "under 2 % of the objects are in another by more than 1 mm", found, share, COLLIDING,
        met=share is not None and share < COLLIDING, note=f"{count} of {total} objects; findings in m",
    )  # fmt: skip


def _stability(subject: Subject, simulation: Run) -> Criterion:
    moved = motions(subject, simulation, SECONDS)
    stable = sum(m.stable for m in moved)
    share = stable / len(moved) if moved else None
    if simulation.diverged:
        found = simulation.blown(tuple(t.id for t in subject.things if t.free))
    else:
        found = [_finding(m) for m in moved] + fixed(subject)
    note = f"{stable} of {len(moved)} free objects; findings in m"
    return _bar(
        "stability", "96 % of the free objects stay within 1 cm and 0.1 rad for 15 s", found, share, STABLE,
        met=share is not None and share >= STABLE, note=note, unfinished=simulation.unfinished,
    )  # fmt: skip


def _finding(motion: Displacement) -> Finding:
    note = f"turned by {motion.turned:.3f} rad"
    return Finding(object=motion.id, value=number(motion.moved), passed=motion.stable, note=note)


def _bar(
    name: str,
    says: str,
    found: list[Finding],
    share: float | None,
    limit: float,
    *,
    met: bool,
    note: str,
    unfinished: str = "",
) -> Criterion:
    """A criterion on a share of the objects: some of them may fail; one that was broken off is not known to be met."""
    made = criterion(name, says, found, unit="share", limit=limit, note=note, unfinished=unfinished)
    applies = made.passed is not None or bool(unfinished)
    passed = (None if unfinished else True) if met else False
    value = None if share is None else number(share)
    return msgspec.structs.replace(made, value=value, passed=passed if applies else None)
