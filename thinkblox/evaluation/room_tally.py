"""What was measured of one room that a policy furnished with its own first answers."""

from collections.abc import Iterator

from msgspec import structs

from thinkblox.episode import Decision
from thinkblox.furnishing import Generation
from thinkblox.judging import Try, rejected
from thinkblox.steps import Rejection
from thinkblox.training.episodes import case_of
from thinkblox.training.outcome import Rollout, outcome_of
from thinkblox.training.rewards import REWARDS
from thinkblox.value import Value
from thinkblox.verdict import Verdict

FALLS = {"unsupported", "drop"}
MOVES = {"drift", "drop", "tilt", "restless", "pushes", "unstable"}
"""Reasons against a verdict by which something is not supported, and not stable."""


class StepTally(Value, frozen=True, kw_only=True):
    """One object and the first answer for it.

    Attributes:
        parsed: the answer can be used; what is measured is None where it cannot.
        reasons: what spoke against it.
        outside: how far it reaches out of the room [m].
        free: in nothing.
        supported: carried where it is put, or fixed where it is to be.
        stable: comes to rest, and moves neither itself nor others.
        relations: share of the relations wanted of it that hold; None where none can be told.
        orientation: cosine between where it looks and the direction to what it serves; None where it serves nothing.
    """

    id: str
    category: str
    parsed: bool
    valid: bool = False
    reasons: tuple[str, ...] = ()
    outside: float | None = None
    free: bool = False
    supported: bool = False
    stable: bool = False
    relations: float | None = None
    orientation: float | None = None


class RoomTally(Value, frozen=True, kw_only=True):
    """One prompt, furnished once.

    Attributes:
        prompt: its number, from 1.
        run: from 1.
        kind: type of the room.
        steps: every object that was asked for.
        planned, placed: objects of the plan, and those that stand.
        valid: whether the finished room passed.
        complete: whether all is as asked.
        told, held: relations that the prompt names, and those that hold in the finished room.
        seconds: for the room; `answering` of those in the policy [s].
        read, written: tokens of a model on this machine.
        position, rotation: ratings by a judge of pictures, 0 to 100; None where none was given.
        refused: why there is no room.
    """

    prompt: int
    run: int
    kind: str = ""
    steps: tuple[StepTally, ...] = ()
    planned: int = 0
    placed: int = 0
    valid: bool = False
    complete: bool = False
    told: int = 0
    held: int = 0
    seconds: float = 0.0
    answering: float = 0.0
    read: int | None = None
    written: int | None = None
    position: float | None = None
    rotation: float | None = None
    refused: str = ""

    @property
    def whole(self) -> bool:
        """Whether every object of the plan was asked for, and has an answer that can be used."""
        return not self.refused and len(self.steps) == self.planned and all(step.parsed for step in self.steps)

    @property
    def free(self) -> bool:
        """CF: whether every object has an answer, and none is in another."""
        return self.whole and all(step.free for step in self.steps)

    def inside(self, tolerance: float) -> bool:
        """IB: whether every object has an answer, and none reaches further out of the room than `tolerance` [m]."""
        return self.whole and all(step.outside is not None and step.outside <= tolerance for step in self.steps)


def tally_of(made: Generation, *, prompt: int, run: int) -> RoomTally:
    """What the verdicts and the report on a room say."""
    plan, report = made.plan, made.report
    return RoomTally(
        prompt=prompt,
        run=run,
        kind=plan.brief.room_type,
        steps=tuple(_steps(made)),
        planned=len(plan.targets),
        placed=len(made.scene.placements),
        valid=report.valid,
        complete=report.complete,
        told=len(report.relations),
        held=sum(relation.holds for relation in report.relations),
        answering=round(sum(entry.propose_seconds for entry in made.trace), 4),
    )


def _steps(made: Generation) -> Iterator[StepTally]:
    for decision in made.episode.decisions():
        yield step_of(_outcome(made, decision))


def _outcome(made: Generation, decision: Decision) -> Rollout:
    nothing = rejected("", Rejection(reason="policy", message="nothing was proposed"))
    tried: Try = next(iter(decision.round.tries), nothing)
    return outcome_of(case_of(made.episode, decision), tried)


def step_of(outcome: Rollout) -> StepTally:
    """What became of one answer; rewards by rules are those of training."""
    target, verdict = outcome.case.target, outcome.tried.verdict
    scores = {name: REWARDS[name](outcome=[outcome])[0] for name in ("rules", "align")}
    said = StepTally(
        id=target.id,
        category=target.category,
        parsed=outcome.parsed,
        relations=scores["rules"],
        orientation=scores["align"],
    )
    return said if verdict is None else _measured(said, verdict, fixed=not outcome.case.asset.free)


def _measured(step: StepTally, verdict: Verdict, *, fixed: bool) -> StepTally:
    reasons = set(verdict.reasons)
    known = "error" not in reasons
    rests = known and (verdict.settled or fixed)
    return structs.replace(
        step,
        valid=verdict.valid,
        reasons=verdict.reasons,
        outside=verdict.outside if known else None,
        free=known and "collision" not in reasons,
        supported=rests and not FALLS & reasons,
        stable=rests and not (MOVES | FALLS) & reasons,
    )
