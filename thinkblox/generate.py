"""The loop: a prompt becomes a plan, and each target of the plan a measured placement."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.placing import Effort, Placing
from thinkblox.plan import Plan, Target
from thinkblox.planning import plan_brief, plan_room
from thinkblox.policies import Policy
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.reading import read_brief
from thinkblox.reporting import UNKNOWN, report_on
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.world import World
from thinkblox.trace import Round
from thinkblox.verdict import Absence, Report


@dataclass(frozen=True)
class Generation:
    """A finished room with its plan, its report and every step that led to it, those of given-up attempts included."""

    scene: Scene
    plan: Plan
    report: Report
    trace: tuple[Round, ...]


@dataclass(frozen=True)
class Progress:
    """What is told after each object: which, whether it stands, its number of how many, and the attempt from 0."""

    target: Target
    placed: bool
    number: int
    total: int
    attempt: int


def generate_room(
    prompt: str,
    *,
    seed: int = 0,
    room: Room | None = None,
    policy: Policy | None = None,
    effort: Effort | None = None,
    tolerances: Tolerances | None = None,
    on_object: Callable[[Progress], None] | None = None,
) -> Generation:
    """Furnish a room for a prompt; every placement in it has been measured in MuJoCo.

    Args:
        prompt: what the room should be, in a sentence or more.
        seed: every random choice follows from it; the same prompt and seed give the same scene.
        room: a room to furnish; made from the prompt when not given.
        policy: who proposes; the embedded expert when not given.
        effort: how hard to try.
        tolerances: what counts as valid.
        on_object: called after each object.

    Raises:
        InputError: the prompt, the seed or the room cannot be used.
    """
    _check_arguments(prompt, seed, room)
    brief = read_brief(prompt)
    room = room or plan_room(brief, rng=np.random.default_rng((seed, 0)))
    plan = plan_brief(brief, room)
    return furnish(
        plan,
        Scene(prompt=prompt, seed=seed, room=room),
        policy=policy or ExpertPolicy(),
        effort=effort or Effort(),
        tolerances=tolerances or Tolerances(),
        on_object=on_object or (lambda progress: None),
    )


def _check_arguments(prompt: object, seed: object, room: object) -> None:
    if not isinstance(prompt, str):
        raise InputError(f"the prompt is a {type(prompt).__name__}; it must be a text")
    if prompt.encode("utf-8", "ignore").decode() != prompt:
        raise InputError("the prompt is not valid text: it holds bytes that are not UTF-8")
    if type(seed) is not int or not 0 <= seed < 2**63:
        raise InputError(f"the seed is {seed!r}; it must be a whole number from 0 to 2^63 - 1")
    if room is not None and not isinstance(room, Room):
        raise InputError(f"the room is a {type(room).__name__}; it must be a Room")


def furnish(
    plan: Plan,
    scene: Scene,
    *,
    policy: Policy,
    effort: Effort,
    tolerances: Tolerances,
    on_object: Callable[[Progress], None],
) -> Generation:
    """Place the targets of a plan into a scene one by one; begin anew where that does not end well, while it helps."""
    made: list[Generation] = []
    for attempt in range(1 + effort.restarts):
        made.append(
            _attempt(plan, scene, attempt, policy=policy, effort=effort, tolerances=tolerances, on_object=on_object)
        )
        last = _faults(made[-1].report)
        if not any(last) or (len(made) > 1 and last >= _faults(made[-2].report)):
            break
    best = min(made, key=lambda generation: _faults(generation.report))
    rounds = [structs.replace(r, kept=generation is best) for generation in made for r in generation.trace]
    return replace(best, trace=tuple(rounds))


def _faults(report: Report) -> tuple[int, ...]:
    """What is not as asked and another arrangement might mend, the gravest first."""
    absent = [a for a in report.absent if a.category != UNKNOWN]
    return (
        sum(a.asked for a in absent),
        sum(not v.valid for v in report.objects) + (not report.valid),
        sum(not r.holds for r in report.relations),
        len(absent),
    )


def _attempt(
    plan: Plan,
    scene: Scene,
    attempt: int,
    *,
    policy: Policy,
    effort: Effort,
    tolerances: Tolerances,
    on_object: Callable[[Progress], None],
) -> Generation:
    world = World(scene, tolerances=tolerances)
    trace: list[Round] = []
    absent: list[Absence] = []
    for number, target in enumerate(plan.targets, 1):
        rng = np.random.default_rng((scene.seed, attempt, number))
        placing = Placing(world, plan, target, policy, effort, rng)
        done = placing.run()
        if done is None:
            absent.append(Absence(id=target.id, category=target.category, asked=target.asked, reason=placing.reason))
        else:
            world = world.with_placement(done.placement, done.asset)
        trace += [structs.replace(r, attempt=attempt) for r in placing.rounds]
        on_object(Progress(target, done is not None, number, len(plan.targets), attempt))
    report = report_on(world.scene, plan, absent=absent, tolerances=tolerances)
    return Generation(world.scene, plan, report, tuple(trace))
