"""The rounds for one object: propose, parse, measure, commit; then repair; then what keeps the least free."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import NamedTuple
from zlib import crc32

import numpy as np

from thinkblox.assets import fit_asset, make_asset
from thinkblox.errors import InputError
from thinkblox.observe import Observation
from thinkblox.plan import Plan, Target
from thinkblox.policies import Policy
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.sim.verdict.world import World
from thinkblox.steps import Rejection, Step, parse
from thinkblox.trace import Round, Try
from thinkblox.verdict import Reason, Verdict

SOFT: frozenset[Reason] = frozenset({"blocks_way", "blocks_window", "blocks_opening"})
"""What a crowded room may have to give up, and the report then says."""
SAME_SIZE = 0.002
"""Sizes nearer than this are the same [m]."""


@dataclass(frozen=True)
class Effort:
    """How hard the loop tries.

    Attributes:
        candidates: texts asked for in one round.
        rounds: how often a policy is asked for one object.
        repairs: poses measured around its best try after that.
        restarts: how often a room that is not all as asked is begun anew; the best one is kept.
    """

    candidates: int = 8
    rounds: int = 3
    repairs: int = 40
    restarts: int = 2


class Measured(NamedTuple):
    """A candidate and its verdict."""

    placement: Placement
    asset: Asset
    verdict: Verdict


@dataclass
class Placing:
    """The work on one object: `run` returns what was committed, with every round in `rounds`."""

    world: World
    plan: Plan
    target: Target
    policy: Policy
    effort: Effort
    rng: np.random.Generator
    rounds: list[Round] = field(default_factory=list)
    failed: list[Measured] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.asset = asset_for(self.target, self.scene)

    @property
    def scene(self) -> Scene:
        """What stands already."""
        return self.world.scene

    def run(self) -> Measured | None:
        """Place the object; None when no pose was found that may stand."""
        feedback: list[str] = []
        for _ in range(self.effort.rounds):
            done = self._ask(tuple(feedback))
            if done is not None:
                return done
            feedback.append(self._failure())
        return self._repair() or self._last_resort()

    @property
    def reason(self) -> str:
        """Why it could not be placed: the failure of the try that came nearest, or of the last text."""
        return self._failure().removeprefix(f"{self.target.id}: ")

    def _ask(self, feedback: tuple[str, ...]) -> Measured | None:
        observation = Observation(self.plan, self.scene, self.target, self.asset, feedback)
        start = time.perf_counter()
        texts = list(self.policy.propose(observation, self.effort.candidates, self.rng))[: self.effort.candidates]
        proposed = time.perf_counter()
        read = [self._read(text) for text in texts]
        measured = [item if isinstance(item, Rejection) else self._measure(*item) for item in read]
        tries = [_try(text, item) for text, item in zip(texts, measured, strict=True)]
        chosen = self._choose(measured)
        self._record("policy", tries, chosen, proposed - start, time.perf_counter() - proposed)
        self.failed += [m for m in measured if isinstance(m, Measured) and not m.verdict.valid]
        return None if chosen is None else _as_measured(measured[chosen])

    def _read(self, text: object) -> tuple[Placement, Asset] | Rejection:
        if not isinstance(text, str):
            return Rejection(reason="format", message=f"the policy gave a {type(text).__name__}, not a text")
        step = parse(text)
        if isinstance(step, Rejection):
            return step
        if step.id != self.target.id:
            return Rejection(reason="id", message=f"answered for {step.id}; {self.target.id} was asked for")
        return self._placement(step)

    def _placement(self, step: Step) -> tuple[Placement, Asset] | Rejection:
        asset = self.asset
        if any(abs(a - b) > SAME_SIZE for a, b in zip(step.size, asset.size, strict=True)):
            try:
                asset = fit_asset(asset, step.size)
            except InputError as error:
                return Rejection(reason="size", message=str(error))
        return placed_at(self.scene, asset, id=step.id, position=step.position, yaw=step.yaw), asset

    def _measure(self, placement: Placement, asset: Asset) -> Measured:
        return Measured(placement, asset, self.world.check([placement], asset)[0])

    def _choose(self, measured: Sequence[Measured | Rejection]) -> int | None:
        """The valid one that keeps most of the relations asked for; among equals the policy's first."""
        valid = [i for i, m in enumerate(measured) if isinstance(m, Measured) and m.verdict.valid]
        return min(valid, key=lambda i: self._unmet(_as_measured(measured[i])), default=None)

    def _unmet(self, candidate: Measured) -> int:
        scene = self.scene.with_placement(candidate.placement, candidate.asset)
        ties = [tie for tie in self.target.ties if tie.asked and tie.kind not in ("around", "in_rows")]
        return sum(
            not measure(scene, tie.kind, self.target.id, tie.anchors, rows=tie.rows).holds
            for tie in ties
            if tie.anchors and all(anchor in scene or not anchor[-1].isdigit() for anchor in tie.anchors)
        )

    def _repair(self) -> Measured | None:
        """Search the nearest valid pose around the best failed try."""
        best = min(self.failed, key=_badness, default=None)
        if best is None or self.effort.repairs == 0:
            return None
        start = time.perf_counter()
        tries: list[Try] = []
        for pose in islice(nearest_poses(self.scene, best.asset, best.placement), self.effort.repairs):
            candidate = self._measure(pose, best.asset)
            tries.append(Try(verdict=candidate.verdict))
            if candidate.verdict.valid:
                self._record("repair", tries, len(tries) - 1, 0.0, time.perf_counter() - start)
                return candidate
            self.failed.append(candidate)
        self._record("repair", tries, None, 0.0, time.perf_counter() - start)
        return None

    def _last_resort(self) -> Measured | None:
        """Give up a walkable way or a window rather than the object."""
        for candidate in self.failed:
            if set(candidate.verdict.reasons) <= SOFT:
                self._record("last resort", [Try(verdict=candidate.verdict)], 0, 0.0, 0.0)
                return candidate
        return None

    def _failure(self) -> str:
        if self.failed:
            return str(min(self.failed, key=_badness).verdict)
        rejected = [t.rejection.message for r in self.rounds for t in r.tries if t.rejection is not None]
        return rejected[-1] if rejected else "nothing was proposed"

    def _record(self, kind: str, tries: Sequence[Try], chosen: int | None, propose: float, check: float) -> None:
        self.rounds.append(
            Round(
                id=self.target.id,
                number=len(self.rounds),
                kind=kind,  # type: ignore[arg-type]
                tries=tuple(tries),
                chosen=chosen,
                propose_seconds=round(propose, 4),
                check_seconds=round(check, 4),
            )
        )


def asset_for(target: Target, scene: Scene) -> Asset:
    """The asset for a target; one seed for a whole scene, so that its furniture is of one style."""
    seed = crc32(f"{scene.seed}/{scene.prompt}".encode())
    asset = make_asset(target.category, seed=seed, attributes=target.attributes)
    x, y, z = (wanted or usual for wanted, usual in zip(target.size, asset.size, strict=True))
    return asset if (x, y, z) == asset.size else fit_asset(asset, (x, y, z))


def _try(text: str, item: Measured | Rejection) -> Try:
    if isinstance(item, Rejection):
        return Try(text=text, rejection=item)
    return Try(text=text, verdict=item.verdict)


def _as_measured(item: Measured | Rejection) -> Measured:
    assert isinstance(item, Measured)
    return item


def _badness(candidate: Measured) -> float:
    """How far a verdict is from valid: metres of depth, outside and motion, and one for each reason."""
    v = candidate.verdict
    hard = [reason for reason in v.reasons if reason not in SOFT]
    return len(hard) + 0.1 * len(v.reasons) + v.depth + v.outside + v.drift + v.drop + v.tilt / 90.0
