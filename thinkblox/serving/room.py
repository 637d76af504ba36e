"""A room that an agent furnishes: a plan, a world and the trace, driven by its answers instead of by a loop."""

import math
import time
from dataclasses import dataclass, replace

import numpy as np
from msgspec import structs

from thinkblox.assets.source import AssetSource
from thinkblox.brief import Brief, Measures
from thinkblox.checking import DEMANDS
from thinkblox.committing import commit
from thinkblox.episode import Episode, Round
from thinkblox.errors import InputError
from thinkblox.feedback import feedback_line
from thinkblox.furnishing import makeable_part
from thinkblox.judging import Proposal, Try, asset_for, measured, rejected, understand
from thinkblox.observe import Observation, kinds_of
from thinkblox.placing import Effort, Loop, Placing
from thinkblox.plan import Due, Plan, Target, Tie
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.prompts import prompts_version
from thinkblox.reading.counts import MAX_OBJECTS
from thinkblox.reporting import report_on
from thinkblox.revising import unmet
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.verify import verify
from thinkblox.sim.verdict.world import World
from thinkblox.steps import Rejection, Step, parse
from thinkblox.value import Vec3
from thinkblox.verdict import Absence, Report

MOST_ROUNDS = 5000
"""Most answers about one room that are measured."""
_SEARCH = Effort(restarts=0, seconds=120.0)
"""How hard the expert tries where an agent asks it to place an object."""


@dataclass(frozen=True)
class AnswerOutcome:
    """What came of an answer.

    Attributes:
        id: the object that it is about.
        tried: what was understood and measured.
        line: that in a line, with what would help where it was not valid.
        committed: what stands elsewhere now, or is new.
        unmet: of an object that was placed, the relations asked for that do not hold.
    """

    id: str
    tried: Try
    line: str
    committed: tuple[Placement, ...] = ()
    unmet: tuple[Tie | Due, ...] = ()

    @property
    def done(self) -> bool:
        """Whether the room is another one now."""
        return self.tried.valid


class AgentRoom:
    """One room; every answer changes it or is told why not, and is kept in its trace.

    Attributes:
        world: the room as it is.
        planned: whether a prompt was read for it, so that its report can say whether it is as asked.
        left_out: the objects that the agent skipped, with its reasons.
        keeps: what has to live as long as the room.
    """

    def __init__(
        self,
        scene: Scene,
        plan: Plan | None,
        source: AssetSource,
        *,
        episode: Episode | None = None,
        reading: Report | None = None,
    ) -> None:
        """Begin with a scene that may have things in it.

        Args:
            scene: the room as it is.
            plan: what is to be placed; None for a room of which nothing is known but what stands there.
            source: where assets come from.
            episode: how the scene came about, if that is known.
            reading: what was said of the file that the scene was read from, by the ids of the scene.
        """
        unread = Brief(prompt=scene.prompt)
        plan, self._refused = makeable_part(plan or Plan(brief=unread), scene, source)
        self.planned = plan.brief != unread
        self._loop = Loop(plan, kinds_of(plan, source), ExpertPolicy(), source, _SEARCH)
        self._before = episode
        self._stood = () if episode else tuple(scene.placements)
        self._assets: dict[str, Asset] = dict(scene.assets)
        self._rounds: list[Round] = []
        self._placings: dict[str, Placing] = {}
        self._asked = 0.0
        self._report: tuple[object, Report] | None = None
        self.world = World(scene)
        self.left_out: dict[str, str] = {}
        self.keeps: object = None
        self._reading = reading or Report(valid=True)

    @property
    def scene(self) -> Scene:
        """What stands there."""
        return self.world.scene

    @property
    def plan(self) -> Plan:
        """What is to be placed."""
        return self._loop.plan

    @property
    def target(self) -> Target | None:
        """The next object to place; None when all are placed or left out."""
        return next((t for t in self.plan.targets if t.id not in self.scene and t.id not in self.left_out), None)

    @property
    def to_place(self) -> int:
        """How many objects are still to be placed."""
        return sum(t.id not in self.scene and t.id not in self.left_out for t in self.plan.targets)

    def observation(self) -> Observation:
        """What is the case, and what is to be placed next; raises InputError when nothing is."""
        self._asked = time.perf_counter()
        return self._placing().observation

    def size_of(self, id: str) -> Vec3:
        """The size that is proposed for the next object, or that something has which stands there [m].

        Raises:
            InputError: it is neither of these.
        """
        if id in self.scene:
            return self.scene[id].size
        placing = self._placing()
        if id != placing.target.id:
            raise InputError(f"{id[:80]} is not what is to be placed next, which is {placing.target.id}")
        return placing.asset.size

    def answer(self, text: str) -> AnswerOutcome:
        """Do what a text in the language of all policies says, if that may stand.

        An addition is about the next object; every other action about anything that stands there.

        Raises:
            InputError: nothing is to be placed, the room has had all its answers, or the engine cannot build an asset.
        """
        if len(self._rounds) >= MOST_ROUNDS:
            raise InputError(f"this room has had {MOST_ROUNDS} answers, which is the most; save it and open it again")
        step = parse(text)
        if isinstance(step, Step) and (step.action != "add" or step.id in self.scene):
            return self._changed(text, step)
        if isinstance(step, Rejection) and self.target is None:
            return AnswerOutcome("", rejected(text, step), f"not used: {step.message}")
        placing, seconds = self._placing(), self._thought()
        grown = placing.answer([text], seconds=seconds)
        return self._placed(placing, grown)

    def ask_expert(self) -> AnswerOutcome:
        """Let the embedded expert place the next object, with all its tries, repairs and revisions."""
        placing = self._placing()
        loop = replace(self._loop, until=time.monotonic() + self._loop.effort.seconds)
        placing.loop, before = loop, len(placing.rounds)
        grown = placing.run()
        outcome = self._placed(placing, grown, since=before)
        placing.loop = self._loop
        return outcome if outcome.done else replace(outcome, line=f"{outcome.id}: {placing.reason or 'no place found'}")

    def want(self, category: str, attributes: tuple[str, ...], size: Measures) -> Target:
        """Plan one object more, after those that are still to be placed; raises InputError where it cannot be made."""
        if len(self.plan.targets) >= MAX_OBJECTS:
            raise InputError(f"a room is given at most {MAX_OBJECTS} things")
        name = category.strip().lower().replace(" ", "_").replace("-", "_")
        taken = {*(t.id for t in self.plan.targets), *(p.id for p in self.scene.placements)}
        number = next(n for n in range(1, len(taken) + 2) if f"{name}_{n}" not in taken)
        target = Target(
            id=f"{name}_{number}", category=name, request=f"{name}_{number}", attributes=attributes, size=size
        )
        self._loop.source.usual(name)
        asset_for(target, self.scene, self._loop.source)
        plan = structs.replace(self.plan, targets=(*self.plan.targets, target))
        self._loop = replace(self._loop, plan=plan, kinds=kinds_of(plan, self._loop.source))
        for placing in self._placings.values():
            placing.loop = self._loop
        return target

    def skip(self, id: str, why: str) -> None:
        """Leave an object of the plan out; raises InputError for one that is not to be placed."""
        pending = [t.id for t in self.plan.targets if t.id not in self.scene and t.id not in self.left_out]
        if id not in pending:
            raise InputError(f"{id} is not to be placed; to be placed are {', '.join(pending) or 'no objects'}")
        self.left_out[id] = why

    def report(self) -> Report:
        """The room as a whole: verified, and held against its prompt where one was read."""
        key = (self.scene, tuple(self.left_out.items()), self.plan)
        if self._report is None or self._report[0] != key:
            self._report = (key, self._verified())
        return self._report[1]

    def episode(self) -> Episode:
        """How the room came about."""
        before = self._before
        attempt = next((done.attempt for done in before.rounds if done.kept), 0) if before else 0
        rounds = tuple(structs.replace(done, attempt=attempt) for done in self._rounds)
        scene, plan = self.scene, self.plan
        return Episode(
            prompt=scene.prompt,
            seed=scene.seed,
            room=scene.room,
            plan=plan,
            kinds=self._loop.kinds,
            assets={**(before.assets if before else {}), **self._assets},
            rounds=(*(before.rounds if before else ()), *rounds),
            prompts=prompts_version(),
            stood=before.stood if before else self._stood,
        )

    def _verified(self) -> Report:
        absent = [
            *self._refused,
            *(
                Absence(id=t.id, category=t.category, asked=t.asked, reason=self.left_out.get(t.id, "not placed yet"))
                for t in self.plan.targets
                if t.id not in self.scene
            ),
        ]
        if self.planned:
            return report_on(self.scene, self.plan, absent=absent, tolerances=Tolerances())
        report, read = verify(self.scene), self._reading
        absent += read.absent
        return structs.replace(
            report,
            complete=report.complete and not absent,
            absent=tuple(absent),
            notes=(DEMANDS, *report.notes),
            source=read.source,
            substituted=tuple(id for id in read.substituted if id in self.scene),
        )

    def _placing(self) -> Placing:
        target = self.target
        if target is None:
            raise InputError(
                "nothing is to be placed: all objects of the plan stand or are left out. Change what stands there, want"
                " one more object, verify the room, or save it"
            )
        if target.id not in self._placings:
            self._placings[target.id] = Placing(self.world, self._loop, target, self._rng())
        placing = self._placings[target.id]
        placing.world = self.world
        return placing

    def _rng(self) -> np.random.Generator:
        return np.random.default_rng((self.scene.seed, 0, len(self._placings) + 1))

    def _thought(self) -> float:
        """How long ago the agent was shown what it answers to [s]; 0 where it was not."""
        asked, self._asked = self._asked, 0.0
        return time.perf_counter() - asked if asked else 0.0

    def _placed(self, placing: Placing, grown: World | None, since: int | None = None) -> AnswerOutcome:
        done = placing.rounds[-1 if since is None else since :]
        self._rounds += done
        self._assets |= placing.assets
        id, last = placing.target.id, done[-1]
        tried = last.tries[-1 if last.chosen is None else last.chosen]
        committed = tuple(p for each in done for p in each.committed)
        self.world = placing.world if grown is None else grown
        if grown is None:
            return AnswerOutcome(id, tried, tried.feedback or f"{id}: {placing.reason}", committed)
        return AnswerOutcome(id, tried, str(tried.verdict), committed, tuple(unmet(self.scene, placing.target)))

    def _changed(self, text: str, step: Step) -> AnswerOutcome:
        """Do something with what stands there."""
        start = time.perf_counter()
        found = understand(self.scene, _any_target(step.id), text, source=self._loop.source)
        tried = rejected(text, found) if isinstance(found, Rejection) else measured(self.world, found)
        there = self.scene.asset_of(self.scene[step.id]) if step.id in self.scene else None
        if there is None:
            return AnswerOutcome(
                step.id, tried, f"{step.id}: not used: {tried.rejection.message if tried.rejection else ''}"
            )
        tried = structs.replace(tried, feedback=self._line(step.id, tried, found, there))
        committed: tuple[Placement, ...] = ()
        removed: tuple[str, ...] = ()
        if isinstance(found, Proposal) and tried.verdict is not None and tried.valid:
            before = self.scene
            self.world, committed = commit(self.world, found, tried.verdict)
            removed = tuple(p.id for p in before.placements if p.id not in self.scene)
            self._assets |= self.scene.assets
        self._rounds.append(
            Round(
                id=step.id,
                number=sum(done.id == step.id and done.kind == "edit" for done in self._rounds),
                kind="edit",
                asset=there.id,
                tries=(tried,),
                chosen=0 if tried.valid else None,
                committed=committed,
                removed=removed,
                propose_seconds=round(self._thought(), 4),
                check_seconds=round(time.perf_counter() - start, 4),
            )
        )
        return AnswerOutcome(step.id, tried, tried.feedback, committed)

    def _line(self, id: str, tried: Try, found: Proposal | Rejection, there: Asset) -> str:
        asset = found.asset if isinstance(found, Proposal) and found.asset is not None else there
        line = feedback_line(self.scene, id, tried, asset)
        return line or (str(tried.verdict) if tried.verdict is not None else "")


def _any_target(id: str) -> Target:
    """The target of a change of what stands there, of which nothing matters but the id."""
    return Target(id=id, category=id.rpartition("_")[0], request=id)


def pose_words(placement: Placement) -> str:
    """Where something stands: "at (1.20, 0.50, 0.00), turned to 90 degrees, on floor"."""
    x, y, z = (part if math.isfinite(part) else 0.0 for part in placement.position)
    return f"at ({x:.2f}, {y:.2f}, {z:.2f}), turned to {placement.yaw:g} degrees, on {placement.support}"
