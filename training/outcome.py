"""What became of a rollout: its text read, done and measured. Rewards are functions of this and nothing else."""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from thinkblox.assets.source import AssetSource
from thinkblox.compact import named
from thinkblox.judging import Proposal, Try, measured_all, tries_of, understand
from thinkblox.phrases import planned_constraints
from thinkblox.plan import Target, Tie, is_object
from thinkblox.scene.agreement import direction_error, residual
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.steps import Rejection, Step, parse
from thinkblox.verdict import Verdict

ANGLES = ("facing", "turned")
"""What reasoning says in degrees; all else is in metres."""
ANGLE = 90.0
"""An error of so many degrees counts as much as one of a metre, in the distance of reasoning and answer."""
_WITH_OTHERS = ("around", "in_rows")
"""Relations of several objects together, which one of them alone does not meet or miss."""
_TOWARDS = ("at", "around", "facing", "opposite")
"""Relations by which an object serves what it looks at."""

SHARES: dict[str, Callable[[Verdict], bool]] = {
    "valid": lambda verdict: verdict.valid,
    "free": lambda verdict: "collision" not in verdict.reasons,
    "inside": lambda verdict: "outside" not in verdict.reasons,
    "stable": lambda verdict: verdict.settled and verdict.rest is not None,
}
"""What is counted of rollouts that were measured: the shares of which each holds."""


class Asked(NamedTuple):
    """What a policy was asked: a scene, the object to place in it, and what that is."""

    scene: Scene
    target: Target
    asset: Asset

    @property
    def told(self) -> tuple[Tie, ...]:
        """The relations wanted of it that can be told from it alone by now."""
        ties = [tie for tie in self.target.ties if tie.anchors and tie.kind not in _WITH_OTHERS]
        return tuple(tie for tie in ties if all(a in self.scene or not is_object(a) for a in tie.anchors))

    @property
    def served(self) -> str | None:
        """What it serves, and should look at; None where it serves nothing, or has no one front."""
        if self.asset.front != "one":
            return None
        return next(
            (a for tie in self.target.ties if tie.kind in _TOWARDS for a in tie.anchors if a in self.scene), None
        )


class Rollout(NamedTuple):
    """A rollout, and what came of it.

    Attributes:
        case: what was asked.
        tried: the text, with its verdict or why it cannot be used.
        distances: how far the answer is from each thing that its reasoning says of it, in metres, or in degrees by
            `ANGLE`; None for a text that cannot be read.
        holds: for each relation wanted of the object that can be told from it alone, whether it holds; None as above.
        alignment: cosine between where one looks who uses it and the direction to what it serves: its front, or its
            back for what is worked at from its front, such as a desk; None where it serves nothing, or as above.
        after: the scene with the object in it, wherever that is; None as above.
    """

    case: Asked
    tried: Try
    distances: tuple[float, ...] | None = None
    holds: tuple[bool, ...] | None = None
    alignment: float | None = None
    after: Scene | None = None

    @property
    def parsed(self) -> bool:
        """Whether the text could be used."""
        return self.tried.rejection is None


def outcomes(
    pool: VerdictPool, asked: Sequence[tuple[Asked, Sequence[object]]], *, source: AssetSource | None = None
) -> list[list[Rollout]]:
    """What becomes of the texts that answer each case, measured by the workers of a pool.

    Answers to compact words may call the object as these do.
    """
    asked = [(case, [named(text, case.target.id) for text in texts]) for case, texts in asked]
    read = [
        [understand(case.scene, case.target, text, asset=case.asset, source=source) for text in texts]
        for case, texts in asked
    ]
    usable = [[each for each in row if isinstance(each, Proposal)] for row in read]
    verdicts = measured_all(pool, [(case.scene, row) for (case, _), row in zip(asked, usable, strict=True)])
    made = []
    for (case, texts), row, measures in zip(asked, read, verdicts, strict=True):
        tries = tries_of(texts, row, measures)
        made.append([_outcome(case, found, tried) for found, tried in zip(row, tries, strict=True)])
    return made


def outcome_of(case: Asked, tried: Try, *, source: AssetSource | None = None) -> Rollout:
    """What became of a text that was measured before, where its object was asked for."""
    if tried.rejection is not None:
        return Rollout(case, tried)
    return _outcome(case, understand(case.scene, case.target, tried.text, asset=case.asset, source=source), tried)


def _outcome(case: Asked, found: Proposal | Rejection, tried: Try) -> Rollout:
    if isinstance(found, Rejection) or found.placement is None or found.asset is None:
        return Rollout(case, tried)
    after = case.scene.with_placement(found.placement, found.asset)
    return Rollout(
        case,
        tried,
        distances=_distances(case.scene, found),
        holds=_holds(case, after),
        alignment=_alignment(case, found.placement),
        after=after,
    )


def _distances(scene: Scene, found: Proposal) -> tuple[float, ...]:
    step = parse(found.text)
    if not isinstance(step, Step) or found.placement is None:
        return ()
    said = planned_constraints(step)
    far = [(constraint.kind, residual(constraint, scene, found.placement)) for constraint in said]
    return tuple(d / ANGLE if kind in ANGLES else d for kind, d in far if d is not None)


def _holds(case: Asked, after: Scene) -> tuple[bool, ...]:
    return tuple(measure(after, tie.kind, case.target.id, tie.anchors, rows=tie.rows).holds for tie in case.told)


def _alignment(case: Asked, placement: Placement) -> float | None:
    if case.served is None:
        return None
    cosine = math.cos(math.radians(direction_error(placement, case.scene[case.served].position[:2])))
    return -cosine if case.asset.gaze == "back" else cosine
