"""The work on one room: attempts at placing all that is planned, the best of which is kept."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.assets.source import AssetSource
from thinkblox.dressing import bare_shelves, dress, dresses_nothing, undress
from thinkblox.episode import Episode, Round
from thinkblox.errors import InputError, UnavailableError
from thinkblox.headline import UNKNOWN, in_short, relation_words, shortfall
from thinkblox.judging import asset_for
from thinkblox.observe import kinds_of
from thinkblox.placing import Effort, Loop, Placing
from thinkblox.plan import Plan, Target, Tie
from thinkblox.planning.tightness import is_essential
from thinkblox.policies import Policy
from thinkblox.prompts import prompts_version
from thinkblox.reporting import report_on
from thinkblox.scene.asset import Asset
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Absence, Report

_UNDRESSINGS = 3
"""How often what turns out to stand badly is taken away from a dressed room before it is left as it is."""
ARRANGED = ("free",)
"""Demands that another arrangement may meet."""
BELONGING = ("next_to", "at_foot_of", "at", "around", "in_front_of", "behind", "on", "above")
"""Relations without which what is only assumed is better left out."""
SEVERAL = ("around", "on")
"""Relations of several, of which one more or less does not matter to what a room is for."""
ROWS = 6
"""From so many on what is to stand in rows looks strewn about where it does not."""
DRAWN_UP = ("at", "in_front_of")
"""Relations to furniture without which a thing on the floor makes no sense."""


@dataclass(frozen=True)
class Generation:
    """A finished room with its report, and the episode that led to it, given-up attempts included."""

    scene: Scene
    report: Report
    episode: Episode

    @property
    def plan(self) -> Plan:
        """What was to be placed, in which order."""
        return self.episode.plan

    @property
    def trace(self) -> tuple[Round, ...]:
        """Every round of tries."""
        return self.episode.rounds

    @property
    def attempt(self) -> int:
        """Which attempt was kept, from 0."""
        return next((entry.attempt for entry in self.trace if entry.kept), 0)


class BrokenOffError(InputError):
    """A room was begun, and whoever plays a role could not go on: says who, why, and what to do.

    Attributes:
        episode: what was tried until then; of an attempt before that, if there was one, the best is kept.
    """

    def __init__(self, why: str, episode: Episode) -> None:
        super().__init__(why)
        self.episode = episode


@dataclass(frozen=True)
class Progress:
    """What is told after each object.

    Attributes:
        target: which.
        placed: whether it stands.
        number, total: its number of how many.
        attempt: from 0.
        anew: what was not as asked in the attempt before, in a few words; empty in the first.
    """

    target: Target
    placed: bool
    number: int
    total: int
    attempt: int
    anew: str = ""


@dataclass(frozen=True)
class Judged:
    """By what placements are judged: where the lines are drawn, and what the user requires besides."""

    tolerances: Tolerances
    requirements: tuple[Requirement, ...] = ()


def furnish(
    plan: Plan,
    scene: Scene,
    *,
    policy: Policy,
    source: AssetSource,
    effort: Effort,
    judged: Judged,
    on_object: Callable[[Progress], None],
    on_round: Callable[[Round], None],
    first: int,
    anew: str,
    until: float,
) -> "Furnished":
    """Place the targets of a plan into a scene one by one; begin anew where that does not end well, while it helps.

    Attempts are numbered from `first`, which is made because of what `anew` says; every number leads to other choices.
    At the monotonic time `until` the budget is over [s].

    Raises:
        BrokenOffError: the policy cannot go on.
    """
    makeable, refused = makeable_part(plan, scene, source)
    loop = Loop(makeable, kinds_of(makeable, source), policy, source, effort, until=until, on_round=on_round)
    made: list[_Attempt] = []
    try:
        for number in range(first, first + 1 + effort.restarts):
            made.append(_Attempt(scene, number, judged, refused))
            made[-1].furnish(loop, judged, _telling(on_object, anew))
            last = made[-1].faults
            if not any(last) or loop.over or (len(made) > 1 and last >= made[-2].faults):
                break
            anew = _amiss(made[-1].report, made[-1].world.scene, makeable)
    except UnavailableError as error:
        raise BrokenOffError(str(error), Furnished(scene, loop, judged, on_object, made).episode()) from error
    return Furnished(scene, loop, judged, on_object, made)


@dataclass
class Furnished:
    """The attempts at one room; the best of them is the room."""

    scene: Scene
    loop: Loop
    judged: Judged
    on_object: Callable[[Progress], None]
    attempts: list["_Attempt"]

    def __post_init__(self) -> None:
        self.plan = self.loop.plan
        finished = [attempt for attempt in self.attempts if attempt.finished]
        self.best = min(finished, key=lambda attempt: attempt.faults) if finished else self.attempts[0]

    @property
    def faults(self) -> tuple[int, ...]:
        """What is not as asked, or odd, and another arrangement might mend: counts, the gravest first."""
        return self.best.faults

    @property
    def strewn(self) -> bool:
        """Whether many that were to stand in rows, though nobody asked that, stand anyhow for want of floor.

        So do beds that nobody asked to stand amid the room.
        """
        return bool(_broken_rows(self.best.world.scene, self.loop.plan))

    @property
    def amiss(self) -> str:
        """The same in a line."""
        return _amiss(self.best.report, self.best.world.scene, self.loop.plan)

    @property
    def report(self) -> Report:
        """On the best attempt."""
        return self.best.report

    def dress(self) -> None:
        """Make the best attempt look lived in."""
        self.plan = self.best.dress(self.loop, self.judged, self.on_object, len(self.attempts) - 1)

    def episode(self) -> Episode:
        """All that led to the best attempt."""
        return Episode(
            prompt=self.scene.prompt,
            seed=self.scene.seed,
            room=self.scene.room,
            plan=self.plan,
            kinds=kinds_of(self.plan, self.loop.source),
            assets={id: asset for attempt in self.attempts for id, asset in attempt.assets.items()},
            rounds=tuple(
                structs.replace(r, kept=r.kept and attempt is self.best)
                for attempt in self.attempts
                for r in attempt.rounds
            ),
            prompts=prompts_version(),
        )

    def generation(self) -> Generation:
        """The best attempt, with all that led to it."""
        return Generation(self.best.world.scene, self.best.report, self.episode())


class _Attempt:
    """One go at a whole room."""

    def __init__(self, scene: Scene, number: int, judged: Judged, refused: Sequence[Absence]) -> None:
        self.world = World(scene, tolerances=judged.tolerances, requirements=judged.requirements)
        self.rounds: list[Round] = []
        self.assets: dict[str, Asset] = {}
        self.number = number
        self.absent = list(refused)
        self.finished = False

    def furnish(self, loop: Loop, judged: Judged, on_object: Callable[[Progress], None]) -> None:
        """Place one object after the other; raises UnavailableError when the policy cannot go on."""
        seed, total, absent = self.world.scene.seed, len(loop.plan.targets), self.absent
        for count, target in enumerate(loop.plan.targets, 1):
            why = loop.over or self._place(loop, target, np.random.default_rng((seed, self.number, count)))
            if why:
                absent.append(Absence(id=target.id, category=target.category, asked=target.asked, reason=why))
            on_object(Progress(target, not why, count, total, self.number))
        self.report = report_on(
            self.world.scene,
            loop.plan,
            absent=absent,
            tolerances=judged.tolerances,
            requirements=judged.requirements,
        )
        self.faults = _faults(self.report, self.world.scene, loop.plan)
        self.finished = True

    def dress(self, loop: Loop, judged: Judged, on_object: Callable[[Progress], None], last: int) -> Plan:
        """Add what makes it look lived in, as far as everything stays valid; returns the plan with that."""
        before, count = len(loop.plan.targets), 0

        def told(target: Target, placed: bool, planned: int) -> None:
            nonlocal count
            count += 1
            on_object(Progress(target, placed, before + count, before + planned, last))

        done = dress(self.world, loop, attempt=self.number, on_object=told)
        valid = self.report.valid
        if bare := bare_shelves(done):
            why = "nothing came to stand on it"
            undress(done, bare, tolerances=judged.tolerances, requirements=judged.requirements, why=why)
        added = {target.id for target in done.loop.plan.targets[before:]}
        for _ in range(_UNDRESSINGS):
            self.report = report_on(
                done.world.scene,
                done.loop.plan,
                absent=[*self.absent, *done.absent],
                tolerances=judged.tolerances,
                requirements=judged.requirements,
            )
            faulty = [v.id for v in self.report.objects if not v.valid and v.id in added]
            if self.report.valid or not faulty or not valid:
                break
            undress(done, faulty, tolerances=judged.tolerances, requirements=judged.requirements)
        self.world = done.world
        self.rounds += done.rounds
        self.assets |= done.assets
        return done.loop.plan

    def _place(self, loop: Loop, target: Target, rng: np.random.Generator) -> str:
        """Place one object; says why when it could not be placed."""
        placing, away = Placing(self.world, loop, target, rng), ""
        try:
            grown = placing.run()
            away = "" if grown is None else _misplaced(grown.scene, loop.plan, target)
        finally:
            self.assets |= placing.assets
            rounds = (structs.replace(r, attempt=self.number) for r in placing.rounds)
            self.rounds += [structs.replace(r, kept=False) if away else r for r in rounds]
        if away:
            return away
        self.world = placing.world if grown is None else grown
        return "" if grown is not None else placing.reason or "no place was found"


def _misplaced(scene: Scene, plan: Plan, target: Target) -> str:
    """Why what nobody asked for is better left out than where it has come to stand; empty where it is well.

    What every such room has, and what something else is to stand by, stays wherever it is; not so one of several at a
    table or on it, nor what hangs over a run, which may be over any unit of that.
    """
    if not target.asked and dresses_nothing(scene, target):
        return "there was no room left for it at a window"
    tie = next((tie for tie in target.ties if tie.kind in BELONGING), None)
    needed = any(target.id in other.depends_on for other in plan.targets)
    if target.asked or tie is None or needed:
        return ""
    over = _is_of_run(plan, tie)
    spare = (over and tie.kind == "above") or (tie.kind in SEVERAL and tie.index > 0)
    if is_essential(target.category, plan.brief.room_type) and not spare:
        return ""
    if over and any(measure(scene, tie.kind, target.id, (id,)).holds for id in _alike(plan, tie) if id in scene):
        return ""
    if not all(anchor in scene and scene.asset_of(scene[anchor]).collides for anchor in tie.anchors):
        return ""
    well = not _is_second_at_side(scene, plan, target, tie) and not _is_at_foot(scene, target, tie)
    if well and measure(scene, tie.kind, target.id, tie.anchors).holds:
        return ""
    return f"there was no room left for it {tie.kind.replace('_', ' ')} {', '.join(tie.anchors)}"


def spare_on_run(plan: Plan) -> set[str]:
    """Ids of what is only assumed on or over a run, as far as that has room."""
    return {t.id for t in plan.targets if not t.asked and any(_is_of_run(plan, tie) for tie in t.ties[:1])}


def _is_of_run(plan: Plan, tie: Tie) -> bool:
    """Whether it is on or over a part of what is built in one line, or over what is let into that: any part will do."""
    kinds = [facts_of(t.category) for t in plan.targets if t.id in tie.anchors]
    parts = all(kind.is_in("built_in", "built_in_line") for kind in kinds)
    return tie.kind in ("above", "on") and bool(kinds) and parts


def _alike(plan: Plan, tie: Tie) -> list[str]:
    """The anchors of a tie and the others of their requests."""
    requests = {t.request for t in plan.targets if t.id in tie.anchors}
    return [t.id for t in plan.targets if t.request in requests]


def _is_second_at_side(scene: Scene, plan: Plan, target: Target, tie: Tie) -> bool:
    """Whether both of a pair stand at one side of what they are to flank: two nightstands by a bed in a corner."""
    if tie.kind != "next_to" or tie.count != 2:
        return False
    anchor, own = scene[tie.anchors[0]], scene[target.id]
    alike = (
        t.id for t in plan.targets if t.request == target.request and t.id != target.id and tie.anchors == _next(t)
    )
    sides = [anchor.to_local((p.position[0], p.position[1]))[1] for p in (scene[id] for id in alike if id in scene)]
    return any(side * anchor.to_local((own.position[0], own.position[1]))[1] > 0.0 for side in sides)


def _is_at_foot(scene: Scene, target: Target, tie: Tie) -> bool:
    """Whether what belongs beside the head of a bed has come to stand beside its foot."""
    bed, own = scene[tie.anchors[0]], scene[target.id]
    if tie.kind != "next_to" or not facts_of(bed.category).is_in("beds"):
        return False
    return bed.to_local((own.position[0], own.position[1]))[0] > 0.0


def _next(target: Target) -> tuple[str, ...]:
    return next((tie.anchors for tie in target.ties if tie.kind == "next_to"), ())


def makeable_part(plan: Plan, scene: Scene, source: AssetSource) -> tuple[Plan, list[Absence]]:
    """The plan without what the source cannot make, and that with the reasons."""
    kept: list[Target] = []
    refused: list[Absence] = []
    for target in plan.targets:
        try:
            source.usual(target.category)
            asset_for(target, scene, source)
            kept.append(target)
        except InputError as error:
            refused.append(Absence(id=target.id, category=target.category, asked=target.asked, reason=str(error)))
    return (structs.replace(plan, targets=tuple(kept)) if refused else plan), refused


def _faults(report: Report, scene: Scene, plan: Plan) -> tuple[int, ...]:
    """What is not as asked, or odd, and another arrangement might mend, the gravest first.

    What is assumed to be on or over a run is there as far as it has room.
    """
    spare = spare_on_run(plan)
    absent = [a for a in report.absent if a.category != UNKNOWN and a.id not in spare]
    return (
        sum(a.asked for a in absent),
        sum(not v.valid for v in report.objects) + (not report.valid),
        sum(not r.holds for r in report.relations) + sum(not d.holds for d in report.demands if d.kind in ARRANGED),
        len(absent) + len(_strays(scene, plan)),
    )


def _strays(scene: Scene, plan: Plan) -> list[str]:
    """What is assumed to belong to something on the floor and stands elsewhere: a chair far from its desk."""
    found = []
    for target in plan.targets:
        ties = [] if target.asked or target.id not in scene else [t for t in target.ties if t.kind in DRAWN_UP]
        ties = [tie for tie in ties[:1] if all(anchor in scene for anchor in tie.anchors)]
        found += [target.id for t in ties if not measure(scene, t.kind, target.id, t.anchors).holds]
    return found


def _broken_rows(scene: Scene, plan: Plan) -> list[str]:
    """The first of each of several that were to stand in rows, where nobody asked that, and stand anyhow."""
    requests: dict[str, list[str]] = {}
    for target in plan.targets:
        if target.id in scene and any(tie.kind == "in_rows" and not tie.asked for tie in target.ties):
            requests.setdefault(target.request, []).append(target.id)
    several = (ids for ids in requests.values() if len(ids) >= ROWS)
    broken = [ids[0] for ids in several if not measure(scene, "in_rows", ids, ()).holds]
    return [*broken, *(ids[0] for ids in requests.values() if _float(scene, ids))]


def _float(scene: Scene, ids: Sequence[str]) -> bool:
    """Whether these are beds of which none has a wall at its head."""
    beds = facts_of(scene[ids[0]].category).is_in("beds")
    return beds and not any(measure(scene, "against_wall", id, ("wall",)).holds for id in ids)


def _amiss(report: Report, scene: Scene, plan: Plan) -> str:
    """What `_faults` counts, in a line."""
    phrases = [f"not placed: {a.id}" for a in report.absent if a.category != UNKNOWN and a.asked]
    phrases += [f"not valid: {verdict.id}" for verdict in report.objects if not verdict.valid]
    phrases += [f"not so: {r.subject} {relation_words(r)}" for r in report.relations if not r.holds]
    phrases += [shortfall(d) for d in report.demands if not d.holds and d.kind in ARRANGED]
    phrases += [f"not placed: {a.id}" for a in report.absent if a.category != UNKNOWN and not a.asked]
    phrases += [f"astray: {id}" for id in _strays(scene, plan)]
    return in_short(phrases) if phrases else "" if report.valid else "not all passed"


def _telling(on_object: Callable[[Progress], None], anew: str) -> Callable[[Progress], None]:
    return lambda progress: on_object(replace(progress, anew=anew))
