"""The loop: a prompt becomes a plan, and each target of the plan a measured placement."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from msgspec import structs

from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.brief import Brief
from thinkblox.dressing import dress, undress
from thinkblox.episode import Episode, Round
from thinkblox.errors import InputError
from thinkblox.fills import FILLS, Fill
from thinkblox.headline import UNKNOWN, in_short, relation_words, shortfall
from thinkblox.judging import asset_for
from thinkblox.observe import kinds_of
from thinkblox.placing import Effort, Loop, Placing
from thinkblox.plan import Plan, Target
from thinkblox.planning import ExpertPlanner, is_open, larger, with_surfaces
from thinkblox.policies import Briefer, Planner, Policy
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.reading import GrammarBriefer
from thinkblox.reporting import report_on
from thinkblox.scene.asset import Asset
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Absence, Report

M = TypeVar("M")
GROWTH = (1.35, 1.8)
"""By how much the floor of a room grows whose size is left open, where not all that stands on it is as asked."""
_UNDRESSINGS = 3
"""How often what turns out to stand badly is taken away from a dressed room before it is left as it is."""
DRAWN_UP = ("at", "in_front_of")
"""Relations to furniture without which a thing on the floor makes no sense."""
ARRANGED = ("free",)
"""Demands that another arrangement may meet."""


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


def generate_room(
    prompt: str,
    *,
    seed: int = 0,
    room: Room | None = None,
    policy: Policy | None = None,
    briefer: Briefer | None = None,
    planner: Planner | None = None,
    source: AssetSource | None = None,
    effort: Effort | None = None,
    tolerances: Tolerances | None = None,
    requirements: Sequence[Requirement] = (),
    fill: Fill = "essentials",
    on_plan: Callable[[Plan], None] | None = None,
    on_object: Callable[[Progress], None] | None = None,
) -> Generation:
    """Furnish a room for a prompt; every placement in it has been measured in MuJoCo.

    Args:
        prompt: what the room should be, in a sentence or more.
        seed: every random choice follows from it; the same prompt and seed give the same scene.
        room: a room to furnish; made from the prompt when not given. Its surfaces are chosen where it has none.
        policy: who proposes; the embedded expert when not given.
        briefer: who understands the prompt; the grammar when not given.
        planner: who decides on the room and the order of its objects; the embedded expert when not given.
        source: where assets come from; the catalogue of procedural furniture when not given.
        effort: how hard to try.
        tolerances: what counts as valid.
        requirements: what you require of every placement besides; the loop looks for places that meet it.
        fill: what stands in the room besides what the prompt names: nothing but what has to carry that ("named"), what
            makes such a room and its mood ("essentials"), or, besides, all that lies about where people live
            ("lived-in"). What is read by a `briefer` of yours is for it to fill; "lived-in" dresses its rooms too.
        on_plan: called with what is to be placed, before anything is.
        on_object: called after each object.

    Raises:
        InputError: the prompt, the seed or the room cannot be used.
    """
    _check_arguments(prompt, seed, room)
    planner = planner or ExpertPlanner()
    _check_roles(policy=policy, briefer=briefer, planner=planner, source=source)
    if fill not in FILLS:
        raise InputError(f"fill is {fill!r}; it must be one of {', '.join(FILLS)}")
    brief = _made("briefer", (briefer or GrammarBriefer(fill)).brief(prompt), Brief)
    grows = room is None and is_open(brief)
    room = room or _made("planner", planner.room(brief, np.random.default_rng((seed, 0))), Room)
    effort = effort or Effort()
    until = time.monotonic() + effort.seconds

    def furnished(floor: Room, effort: Effort, before: Sequence[Generation] = ()) -> Generation:
        floor = with_surfaces(floor, brief, seed)
        plan = _made("planner", planner.plan(brief, floor), Plan)
        if on_plan is not None and not before:
            on_plan(plan)
        return furnish(
            plan,
            Scene(prompt=prompt, seed=seed, room=floor),
            policy=policy or ExpertPolicy(),
            source=source or ProceduralAssets(),
            effort=effort,
            judged=Judged(tolerances or Tolerances(), tuple(requirements)),
            on_object=on_object or (lambda progress: None),
            lived_in=fill == "lived-in",
            first=len(before),
            anew=_amiss(before[-1].report, before[-1].scene, before[-1].plan) if before else "",
            until=until,
        )

    if not grows or not effort.restarts:
        return furnished(room, effort)
    made = [furnished(room, replace(effort, restarts=0))]
    for factor in GROWTH:
        if not _lacks_floor(made[-1]) or time.monotonic() >= until:
            break
        wider = _made("planner", planner.room(larger(brief, room, factor), np.random.default_rng((seed, 0))), Room)
        made.append(furnished(wider, replace(effort, restarts=0), made))
        if len(made) > 2 and _of(made[-1]) >= _of(made[-2]):
            break
    best = min(made, key=_of)
    if any(_of(best)) and time.monotonic() < until:
        made.append(furnished(best.scene.room, replace(effort, restarts=effort.restarts - 1), made))
    return min(made, key=_of)


def _lacks_floor(made: Generation) -> bool:
    """Whether something that stands on the floor is absent, fails, or does not stand as asked."""
    mounts = {target.id: made.episode.kinds[target.category].mount for target in made.plan.targets}
    absent = any(a.asked and mounts.get(a.id) == "floor" for a in made.report.absent)
    failing = any(not v.valid for v in made.report.objects)
    subjects = (id for r in made.report.relations if not r.holds for id in r.subject.split(", "))
    astray = bool(_strays(made.scene, made.plan))
    return absent or failing or astray or any(mounts.get(id) == "floor" for id in subjects)


def _made(role: str, made: object, kind: type[M]) -> M:
    """What somebody else's role has made; raises InputError when it is something else."""
    if not isinstance(made, kind):
        raise InputError(f"the {role} answered with a {type(made).__name__}; it must give a {kind.__name__}")
    return made


def _check_arguments(prompt: object, seed: object, room: object) -> None:
    if not isinstance(prompt, str):
        raise InputError(f"the prompt is a {type(prompt).__name__}; it must be a text")
    if prompt.encode("utf-8", "ignore").decode() != prompt:
        raise InputError("the prompt is not valid text: it holds bytes that are not UTF-8")
    if type(seed) is not int or not 0 <= seed < 2**63:
        raise InputError(f"the seed is {seed!r}; it must be a whole number from 0 to 2^63 - 1")
    if room is not None and not isinstance(room, Room):
        raise InputError(f"the room is a {type(room).__name__}; it must be a Room")


_ROLES = {
    "policy": ("propose",),
    "briefer": ("brief",),
    "planner": ("room", "plan"),
    "source": ("make", "fit", "usual", "size_range"),
}


def _check_roles(**players: object) -> None:
    """Raise InputError for what cannot play its part."""
    for role, player in players.items():
        missing = [name for name in _ROLES[role] if not callable(getattr(player, name, None))]
        if player is not None and missing:
            raise InputError(
                f"the {role} is a {type(player).__name__}, which has no {' and no '.join(missing)}();"
                f" see thinkblox.policies and thinkblox.assets for what a {role} must have"
            )


def furnish(
    plan: Plan,
    scene: Scene,
    *,
    policy: Policy,
    source: AssetSource,
    effort: Effort,
    judged: Judged,
    on_object: Callable[[Progress], None],
    lived_in: bool,
    first: int,
    anew: str,
    until: float,
) -> Generation:
    """Place the targets of a plan into a scene one by one; begin anew where that does not end well, while it helps.

    Attempts are numbered from `first`, which is made because of what `anew` says; every number leads to other choices.
    At the monotonic time `until` the budget is over [s]. With `lived_in` the room is dressed after that.
    """
    makeable, refused = _makeable(plan, scene, source)
    loop = Loop(makeable, kinds_of(makeable, source), policy, source, effort, until)
    made: list[_Attempt] = []
    for number in range(first, first + 1 + effort.restarts):
        made.append(_Attempt(loop, scene, number, judged, _telling(on_object, anew), refused))
        anew = _amiss(made[-1].report, made[-1].world.scene, makeable)
        last = made[-1].faults
        if not any(last) or loop.over or (len(made) > 1 and last >= made[-2].faults):
            break
    best = min(made, key=lambda attempt: attempt.faults)
    if lived_in:
        makeable = best.dress(loop, judged, on_object, len(made) - 1)
    episode = Episode(
        prompt=scene.prompt,
        seed=scene.seed,
        room=scene.room,
        plan=makeable,
        kinds=kinds_of(makeable, source),
        assets={id: asset for attempt in made for id, asset in attempt.assets.items()},
        rounds=tuple(structs.replace(r, kept=r.kept and attempt is best) for attempt in made for r in attempt.rounds),
    )
    return Generation(best.world.scene, best.report, episode)


def _makeable(plan: Plan, scene: Scene, source: AssetSource) -> tuple[Plan, list[Absence]]:
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


def _of(made: Generation) -> tuple[int, ...]:
    return _faults(made.report, made.scene, made.plan)


def _faults(report: Report, scene: Scene, plan: Plan) -> tuple[int, ...]:
    """What is not as asked, or odd, and another arrangement might mend, the gravest first."""
    absent = [a for a in report.absent if a.category != UNKNOWN]
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


class _Attempt:
    """One go at a whole room."""

    def __init__(
        self,
        loop: Loop,
        scene: Scene,
        number: int,
        judged: Judged,
        on_object: Callable[[Progress], None],
        refused: Sequence[Absence],
    ) -> None:
        self.world = World(scene, tolerances=judged.tolerances, requirements=judged.requirements)
        self.rounds: list[Round] = []
        self.assets: dict[str, Asset] = {}
        self.number = number
        absent = self.absent = list(refused)
        total = len(loop.plan.targets)
        for count, target in enumerate(loop.plan.targets, 1):
            why = loop.over or self._place(loop, target, number, np.random.default_rng((scene.seed, number, count)))
            if why:
                absent.append(Absence(id=target.id, category=target.category, asked=target.asked, reason=why))
            on_object(Progress(target, not why, count, total, number))
        self.report = report_on(
            self.world.scene,
            loop.plan,
            absent=absent,
            tolerances=judged.tolerances,
            requirements=judged.requirements,
        )
        self.faults = _faults(self.report, self.world.scene, loop.plan)

    def dress(self, loop: Loop, judged: Judged, on_object: Callable[[Progress], None], last: int) -> Plan:
        """Add what makes it look lived in, as far as everything stays valid; returns the plan with that."""
        before, count = len(loop.plan.targets), 0

        def told(target: Target, placed: bool) -> None:
            nonlocal count
            count += 1
            on_object(Progress(target, placed, before + count, before + count, last))

        done = dress(self.world, loop, attempt=self.number, on_object=told)
        valid = self.report.valid
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

    def _place(self, loop: Loop, target: Target, number: int, rng: np.random.Generator) -> str:
        """Place one object; says why when it could not be placed."""
        placing = Placing(self.world, loop, target, rng)
        grown = placing.run()
        self.world = placing.world if grown is None else grown
        self.assets |= placing.assets
        self.rounds += [structs.replace(r, attempt=number) for r in placing.rounds]
        return "" if grown is not None else placing.reason or "no place was found"
