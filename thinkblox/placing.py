"""The rounds for one object: propose, judge, commit; then repair; then revise a neighbour; then what keeps the most."""

import math
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice, takewhile

import numpy as np
from msgspec import structs

from thinkblox.assets.source import AssetSource
from thinkblox.committing import commit
from thinkblox.episode import Round, RoundKind
from thinkblox.errors import InputError
from thinkblox.feedback import feedback_line
from thinkblox.judging import Proposal, Try, answers, asset_for, measured, proposed, rejected, size_range, understand
from thinkblox.observe import Kind, Observation, observe
from thinkblox.phrases import phrase
from thinkblox.plan import Plan, Target
from thinkblox.policies import Policy
from thinkblox.revising import Revision, revisions, unmet
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import first_pose, nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.saying import place_words
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World
from thinkblox.steps import Rejection, write_step
from thinkblox.verdict import Reason, Verdict

SOFT: frozenset[Reason] = frozenset({"blocks_way", "blocks_window", "blocks_opening"})
"""What a crowded room may have to give up, and the report then says."""
FALLING: frozenset[Reason] = frozenset({"drift", "drop", "tilt", "restless", "unstable"})
"""What becomes of a thing that cannot stand."""

BUDGET = 900.0
"""How long the objects of a room may take to be placed unless told otherwise [s]."""


@dataclass(frozen=True)
class Effort:
    """How hard the loop tries.

    Attributes:
        candidates: texts asked for in one round.
        rounds: how often a policy is asked for one object.
        repairs: poses measured around its best try after that.
        revisions: places measured for a neighbour that is in the way, after that.
        restarts: how often a room that is not all as asked is begun anew; the best one is kept.
        resort: whether a walkable way or a window is given up rather than an object.
        seconds: the budget: how long objects are placed [s]. What is not placed by then is absent, and says so. One
            proposal or one measurement is finished when it is over, and the report on the whole room comes after. The
            same seed gives the same room as long as the budget is not used up.

    Raises:
        InputError: a budget that is no number of seconds above 0.
    """

    candidates: int = 8
    rounds: int = 3
    repairs: int = 40
    revisions: int = 16
    restarts: int = 2
    resort: bool = True
    seconds: float = BUDGET

    def __post_init__(self) -> None:
        if not self.seconds > 0.0:
            raise InputError(f"a budget of {self.seconds} s is none; give seconds, more than 0")
        for name, least in (("candidates", 1), ("rounds", 0), ("repairs", 0), ("revisions", 0), ("restarts", 0)):
            value = getattr(self, name)
            if type(value) is not int or value < least:
                raise InputError(f"Effort.{name} is {value!r}; it must be a whole number, at least {least}")


@dataclass(frozen=True)
class Loop:
    """What every object of a room is placed with.

    Attributes:
        tells: whether the policy is told what became of its answers, as where it is asked again.
        until: the monotonic time at which the budget is over [s].
        on_round: called after each round of tries.
        falls: of assets that fell where they were put, how each does so by itself; "" of one that stands.
    """

    plan: Plan
    kinds: dict[str, Kind]
    policy: Policy
    source: AssetSource
    effort: Effort
    tells: bool = True
    until: float = math.inf
    on_round: Callable[[Round], None] = lambda done: None
    falls: dict[Asset, str] = field(default_factory=dict)

    @property
    def over(self) -> str:
        """That the budget is over, in words; empty while it is not."""
        if time.monotonic() < self.until:
            return ""
        return f"the budget of {self.effort.seconds:g} s was over before a place for it was found"


@dataclass
class Placing:
    """The work on one object: `run` returns the world with it in, every round is in `rounds`."""

    world: World
    loop: Loop
    target: Target
    rng: np.random.Generator
    rounds: list[Round] = field(default_factory=list)
    failed: list[tuple[Proposal, Verdict]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.asset = asset_for(self.target, self.scene, self.loop.source)
        self.assets = {self.asset.id: self.asset}
        self.sizes = size_range(self.asset, self.loop.source)

    @property
    def scene(self) -> Scene:
        """What stands already."""
        return self.world.scene

    @property
    def observation(self) -> Observation:
        """What whoever proposes is shown: the scene, and what was measured of the answers before."""
        before = next((done.tries for done in reversed(self.rounds) if done.kind == "policy"), ())
        return observe(
            self.scene,
            self.loop.plan,
            self.target,
            self.asset,
            kinds=self.loop.kinds,
            sizes=self.sizes,
            round=len(self.rounds),
            feedback=tuple(t.feedback for t in before if t.feedback),
        )

    def answer(self, texts: Iterable[object], *, seconds: float = 0.0) -> World | None:
        """A round: measure what was answered to the observation, and commit the best of what is valid.

        Args:
            texts: the answers; a `Try` stands for one that never came.
            seconds: how long they took.

        Returns:
            The world with the object in it; None when none was valid.
        """
        read = [text if isinstance(text, Try) else self._understood(text) for text in texts]
        return self._try("policy", read, propose_seconds=seconds, tell=self.loop.tells)

    def run(self) -> World | None:
        """Place the object; None when no pose was found that may stand.

        Raises:
            UnavailableError: the policy cannot go on, for this or any other object.
        """
        for _ in range(self.loop.effort.rounds):
            if self.loop.over:
                break
            start = time.perf_counter()
            texts = answers(self.loop.policy, self.observation, self.loop.effort.candidates, self.rng)
            grown = self.answer(texts, seconds=time.perf_counter() - start)
            if grown is not None:
                return grown
            if self._fall():
                return None
        return self._repair() or (None if self.loop.over else self._revise()) or self._last_resort()

    @property
    def reason(self) -> str:
        """Why it could not be placed: the failure of the try that came nearest, or of the last text."""
        if self.loop.over:
            return self.loop.over
        if falls := self._fall():
            return falls
        if self.failed:
            return str(min(self.failed, key=_badness)[1]).removeprefix(f"{self.target.id}: ")
        said = [t.rejection.message for r in self.rounds for t in r.tries if t.rejection is not None]
        return said[-1] if said else "nothing was proposed"

    def _fall(self) -> str:
        """How what was tried falls by itself; empty where any of it stands, or fell nowhere yet.

        Each asset is measured so once, and only after a whole round was of no use: a wall may hold what leans on it.
        """
        if not any(FALLING.intersection(verdict.reasons) for _, verdict in self.failed):
            return ""
        assets = dict.fromkeys(proposal.asset for proposal, _ in self.failed)
        says = [self._falls(asset) for asset in takewhile(self._falls, assets)]
        return says[0] if len(says) == len(assets) else ""

    def _falls(self, asset: Asset | None) -> str:
        if asset is None or not asset.free:
            return ""
        if asset not in self.loop.falls:
            alone = self.world.by_itself(asset)
            says = str(alone).partition(": ")[2]
            fell = FALLING.intersection(alone.reasons)
            self.loop.falls[asset] = f"it cannot stand: by itself on an empty level floor it {says}" if fell else ""
        return self.loop.falls[asset]

    def _understood(self, text: object) -> Proposal | Try:
        found = understand(self.scene, self.target, text, asset=self.asset, source=self.loop.source)
        return rejected(text, found) if isinstance(found, Rejection) else found

    def _try(
        self,
        kind: RoundKind,
        read: Iterable[Proposal | Try],
        *,
        propose_seconds: float = 0.0,
        tell: bool = False,
        first: bool = False,
    ) -> World | None:
        """Measure a round of proposals and commit the best valid one, or with `first` the first one."""
        start = time.perf_counter()
        small = self.asset.mount == "surface"  # the first that is as asked is taken: of many small things, many tries
        tries: list[Try] = []
        valid: list[tuple[int, Proposal, Verdict]] = []
        for item in read:
            if tries and self.loop.over:
                break
            if tries and isinstance(item, Proposal) and item.asset is not None and self.loop.falls.get(item.asset):
                continue
            done = item if isinstance(item, Try) else measured(self.world, item)
            tries.append(done)
            if isinstance(item, Try) or done.verdict is None:
                continue
            if done.valid:
                valid.append((len(tries) - 1, item, done.verdict))
                if first or (small and self._unmet(item) == 0):
                    break
            else:
                self.failed.append((item, done.verdict))
        if not valid:
            told = [self._told(t) for t in tries] if tell else tries
            self._record(kind, told, propose_seconds=propose_seconds, check_seconds=time.perf_counter() - start)
            return None
        chosen, proposal, verdict = min(valid, key=lambda item: self._unmet(item[1]))
        grown, placements = commit(self.world, proposal, verdict)
        self._keep(proposal)
        self._record(
            kind,
            tries,
            chosen=chosen,
            committed=placements,
            propose_seconds=propose_seconds,
            check_seconds=time.perf_counter() - start,
        )
        return grown

    def _told(self, tried: Try) -> Try:
        asset = next((p.asset for p, _ in self.failed if p.placement == tried.placement), None) or self.asset
        return structs.replace(tried, feedback=feedback_line(self.scene, self.target.id, tried, asset))

    def _unmet(self, proposal: Proposal) -> int:
        """How many of the relations asked for would not hold."""
        return len(unmet(self.scene.apply(proposal.action), self.target))

    def _repair(self) -> World | None:
        """Search the nearest valid pose around the best failed try, or around a place where such things may be."""
        if self.loop.effort.repairs == 0 or self.loop.over:
            return None
        best, _ = min(self.failed, key=_badness, default=(None, None))
        asset = best.asset if best and best.asset else self.asset
        start = best.placement if best else None
        start = start or first_pose(self.scene, asset, self.target.id)
        why = f"{self.reason[0].upper()}{self.reason[1:]}"
        poses = islice(nearest_poses(self.scene, asset, start), self.loop.effort.repairs)
        return self._try("repair", self._said(asset, poses, why, start), first=True)

    def _said(self, asset: Asset, poses: Iterable[Placement], why: str, start: Placement) -> Iterator[Proposal]:
        for pose in poses:
            away = math.dist(pose.position, start.position)
            words = ", ".join(phrase(word) for word in place_words(self.scene, asset, pose))
            lines = (f"Before: {why}.", f"{away:.2f} m from there it may be free.", f"So it goes {words}.")
            text = write_step(lines, id=pose.id, position=pose.position, yaw=pose.yaw, size=pose.size)
            yield proposed(self.scene, asset, text, id=pose.id, position=pose.position, yaw=pose.yaw)

    def _revise(self) -> World | None:
        """Move one neighbour that is in the way, by the least that lets both stand and keeps what was asked of it."""
        if not self.loop.effort.revisions:
            return None
        failed = sorted(self.failed, key=_badness)
        start = time.perf_counter()
        loop = self.loop
        for revision in revisions(
            self.world, loop.plan, failed, most=loop.effort.revisions, over=lambda: self.loop.over
        ):
            seconds = time.perf_counter() - start
            return self._revised(revision, seconds)
        return None

    def _revised(self, revision: Revision, seconds: float) -> World | None:
        grown, placements = commit(self.world, revision.move, revision.move_verdict)
        self._record(
            "revision",
            [revision.tried],
            id=revision.move.action.id,
            chosen=0,
            committed=placements,
            check_seconds=seconds,
        )
        self.world = grown
        again = structs.replace(revision.again, id=self.target.id)
        why = f"{revision.move.action.id} was in the way and has moved"
        return self._try("revision", self._said(revision.asset, [again], why, again), first=True)

    def _last_resort(self) -> World | None:
        """Give up a walkable way or a window rather than the object: the least bad of all that was measured."""
        if not self.loop.effort.resort:
            return None
        soft = [(p, v) for p, v in self.failed if set(v.reasons) <= SOFT and p.placement is not None]
        if not soft:
            return None
        proposal, verdict = min(soft, key=_badness)
        grown, placements = commit(self.world, proposal, verdict)
        tried = Try(text=proposal.text, placement=proposal.placement, verdict=verdict)
        self._keep(proposal)
        self._record("last resort", [tried], chosen=0, committed=placements)
        return grown

    def _keep(self, proposal: Proposal) -> None:
        if proposal.asset is not None:
            self.assets[proposal.asset.id] = proposal.asset

    def _record(
        self,
        kind: RoundKind,
        tries: Sequence[Try],
        *,
        id: str = "",
        chosen: int | None = None,
        committed: tuple[Placement, ...] = (),
        propose_seconds: float = 0.0,
        check_seconds: float = 0.0,
    ) -> None:
        self.rounds.append(
            Round(
                id=id or self.target.id,
                number=len(self.rounds),
                kind=kind,
                asset=self.asset.id,
                sizes=self.sizes,
                tries=tuple(tries),
                chosen=chosen,
                committed=committed,
                propose_seconds=round(propose_seconds, 4),
                check_seconds=round(check_seconds, 4),
            )
        )
        self.loop.on_round(self.rounds[-1])


def _badness(failure: tuple[Proposal, Verdict]) -> float:
    """How far a verdict is from valid: metres of depth, outside and motion, and one for each reason."""
    v = failure[1]
    hard = [reason for reason in v.reasons if reason not in SOFT]
    return len(hard) + 0.1 * len(v.reasons) + v.depth + v.outside + v.drift + v.drop + v.tilt / 90.0
