"""SceneEval's simulation fork: penetration between objects and with the room, and static equilibrium."""

from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.criteria import above, criterion, paragraphs, result
from thinkblox.sim.suites.equilibrium import MOVED, TURNED, fixed, motions
from thinkblox.sim.suites.overlaps import DEPTH, Overlaps
from thinkblox.sim.suites.running import EARLY_END, Run
from thinkblox.suite import SuiteResult

SOURCE = (
    "N. Pfaff's fork of SceneEval, 2025 to 2026, https://github.com/nepfaff/SceneEval (metrics DrakeCollision and "
    "StaticEquilibrium, configs/metrics.yaml)"
)
SECONDS = 5.0
NOTES = paragraphs(
    """
    The source simulates in Drake, with a step of 1 ms and point contacts, on its own convex pieces; here it is
    MuJoCo, the model's own options and colliding geometry.

    The source welds what hangs on walls and ceilings; here everything that the model fixes is fixed. Things
    without colliding geometry are left out, as the source leaves carpets out.

    Its variants that weld what penetrates before they simulate are not part of this suite.
    """
)


def run(subject: Subject, *, seed: int = 0) -> SuiteResult:
    """All criteria of the fork; nothing in it is random."""
    del seed
    simulation = Run(subject, SECONDS, creep=MOVED / 100)
    overlaps = Overlaps(subject, simulation)
    moved = motions(subject, simulation, SECONDS)
    still = tuple(t.id for t in subject.things if t.free)
    if simulation.diverged:
        shifts = turns = simulation.blown(still)
    else:
        shifts = [above(m.id, m.moved, MOVED, inclusive=False) for m in moved] + fixed(subject)
        turns = [above(m.id, m.turned, TURNED, inclusive=False) for m in moved] + fixed(subject)
    broken = simulation.unfinished
    criteria = [
        criterion(
            "collision", "no object is in another by more than 1 mm", overlaps.with_each_other(), unit="m", limit=DEPTH
        ),
        criterion(
            "floor_collision", "no object is in the floor or a wall by more than 1 mm", overlaps.with_room(),
            unit="m", limit=DEPTH,
        ),
        criterion(
            "displacement", "after 5 s every free object is within 1 cm of where it began", shifts,
            unit="m", limit=MOVED, unfinished=broken,
        ),
        criterion(
            "rotation", "after 5 s every free object is within 0.1 rad of how it stood", turns,
            unit="rad", limit=TURNED, unfinished=broken,
        ),
    ]  # fmt: skip
    return result("sceneeval_sim", SOURCE, criteria, (*NOTES, EARLY_END))
