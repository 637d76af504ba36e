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
from thinkblox.errors import InputError, UnavailableError
from thinkblox.fills import Fill
from thinkblox.headline import UNKNOWN
from thinkblox.judging import asset_for
from thinkblox.modes import Mode
from thinkblox.observe import kinds_of
from thinkblox.orders import ORDERS, Order
from thinkblox.placing import Effort, Loop, Placing
from thinkblox.plan import Plan, Target
from thinkblox.planning import is_open, larger, reordered, with_surfaces
from thinkblox.players import Players, players
from thinkblox.policies import Briefer, Planner, Policy
from thinkblox.prompts import prompts_version
from thinkblox.replaying import Replay
from thinkblox.reporting import report_on
from thinkblox.scene.asset import Asset, Mount
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.world import World
from thinkblox.value import Vec3
from thinkblox.verdict import Absence, Report

M = TypeVar("M")
GROWTH = (1.35, 1.8)
"""By how much the floor of a room grows whose size is left open, where not all that stands on it is as asked."""
_UNDRESSINGS = 3
"""How often what turns out to stand badly is taken away from a dressed room before it is left as it is."""
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
    """What is told after each object: which, whether it stands, its number of how many, and the attempt from 0."""

    target: Target
    placed: bool
    number: int
    total: int
    attempt: int


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
    policy: Policy | str | None = None,
    briefer: Briefer | str | None = None,
    planner: Planner | str | None = None,
    mode: Mode = "progressive",
    source: AssetSource | None = None,
    effort: Effort | None = None,
    tolerances: Tolerances | None = None,
    requirements: Sequence[Requirement] = (),
    fill: Fill = "essentials",
    order: Order = "plan",
    on_plan: Callable[[Plan], None] | None = None,
    on_object: Callable[[Progress], None] | None = None,
) -> Generation:
    """Furnish a room for a prompt; every placement in it has been measured in MuJoCo.

    Args:
        prompt: what the room should be, in a sentence or more.
        seed: every random choice follows from it; the same prompt and seed give the same scene.
        room: a room to furnish; made from the prompt when not given. Its surfaces are chosen where it has none.
        policy: who proposes; the embedded expert when not given. Or who that is in a word: "hf:PATH_OR_ID[+ADAPTER]",
            "openai:BASE_URL#MODEL" and "replay:TRACE" play the other two roles as well, unless those are given.
        briefer: who understands the prompt, or that in a word; the grammar when not given, as for "expert".
        planner: who decides on the room and the order of its objects, or that in a word; else the embedded expert.
        mode: whether a model is asked for one object after the other, or once for the layout of the whole room.
        source: where assets come from; the catalogue of procedural furniture when not given.
        effort: how hard to try.
        tolerances: what counts as valid.
        requirements: what you require of every placement besides; the loop looks for places that meet it.
        fill: what stands in the room besides what the prompt names: nothing but what has to carry that ("named"), what
            makes such a room and its mood ("essentials"), or, besides, all that lies about where people live
            ("lived-in"). What is read by a `briefer` of yours is for it to fill; "lived-in" dresses its rooms too.
        order: in which order objects are placed: as planned, large ones first ("size"), or by chance ("random"); none
            comes before what it depends on.
        on_plan: called with what is to be placed, before anything is.
        on_object: called after each object.

    Raises:
        InputError: the prompt, the seed or the room cannot be used, or a model that reads or plans gives nothing that
            can be used.
        BrokenOffError: a room was begun, and a model or a trace could not go on; it has what was tried until then.
    """
    _check_arguments(prompt, seed, room)
    if order not in ORDERS:
        raise InputError(f"order is {order!r}; it must be one of {', '.join(ORDERS)}")
    cast = players(policy, briefer=briefer, planner=planner, mode=mode, fill=fill, seed=seed, source=source)
    _check_roles(policy=cast.policy, briefer=cast.briefer, planner=cast.planner, source=source)
    _check_play(cast, prompt, seed, mode, fill)
    planner = cast.planner
    brief = _made("briefer", cast.briefer.brief(prompt), Brief)
    source = source or ProceduralAssets()
    grows = room is None and is_open(brief)
    room = room or _made("planner", planner.room(brief, np.random.default_rng((seed, 0))), Room)
    effort = _effort_for(cast, effort or Effort())
    until = time.monotonic() + effort.seconds

    def furnished(floor: Room, effort: Effort, first: int) -> Generation:
        plan = _made("planner", planner.plan(brief, floor), Plan)
        plan = reordered(plan, order, lambda target: _usual(target, source), seed)
        if on_plan is not None and not first:
            on_plan(plan)
        return furnish(
            plan,
            Scene(prompt=prompt, seed=seed, room=with_surfaces(floor, brief, seed)),
            policy=cast.policy,
            source=source,
            effort=effort,
            judged=Judged(tolerances or Tolerances(), tuple(requirements)),
            on_object=on_object or (lambda progress: None),
            lived_in=fill == "lived-in",
            first=first,
            until=until,
        )

    def wider(factor: float) -> Room:
        return _made("planner", planner.room(larger(brief, room, factor), np.random.default_rng((seed, 0))), Room)

    made: list[Generation] = []
    try:
        if grows and effort.restarts:
            _furnish_growing(made, furnished, room, wider, effort, until)
        else:
            made.append(furnished(room, effort, 0))
    except InputError as error:
        if not made:
            raise
        raise BrokenOffError(str(error), _best(made).episode) from error
    return _best(made)


def _furnish_growing(
    made: list[Generation],
    furnished: Callable[[Room, Effort, int], Generation],
    room: Room,
    wider: Callable[[float], Room],
    effort: Effort,
    until: float,
) -> None:
    """Furnish a room whose size is left open, and wider ones while that helps; add each to `made`."""
    once = replace(effort, restarts=0)
    made.append(furnished(room, once, 0))
    for factor in GROWTH:
        if not _lacks_floor(made[-1]) or time.monotonic() >= until:
            break
        made.append(furnished(wider(factor), once, len(made)))
        if len(made) > 2 and _faults(made[-1].report) >= _faults(made[-2].report):
            break
    best = _best(made)
    if any(_faults(best.report)) and time.monotonic() < until:
        again = replace(effort, restarts=effort.restarts - 1)
        made.append(furnished(best.scene.room, again, len(made)))


def _best(made: Sequence[Generation]) -> Generation:
    return min(made, key=lambda each: _faults(each.report))


def _usual(target: Target, source: AssetSource) -> tuple[Vec3, Mount] | None:
    """Size [m] and mount of what a target is; None where the source cannot make it."""
    try:
        return source.usual(target.category)
    except InputError:
        return None


def _lacks_floor(made: Generation) -> bool:
    """Whether something that stands on the floor is absent, fails, or does not stand as asked."""
    mounts = {target.id: made.episode.kinds[target.category].mount for target in made.plan.targets}
    absent = any(a.asked and mounts.get(a.id) == "floor" for a in made.report.absent)
    failing = any(not v.valid for v in made.report.objects)
    subjects = (id for r in made.report.relations if not r.holds for id in r.subject.split(", "))
    return absent or failing or any(mounts.get(id) == "floor" for id in subjects)


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


def _check_play(cast: Players, prompt: str, seed: int, mode: Mode, fill: Fill) -> None:
    for replay in {id(r): r for r in (cast.policy, cast.briefer, cast.planner) if isinstance(r, Replay)}.values():
        replay.check(prompt, seed)
    if mode == "one-shot" and fill == "lived-in":
        raise InputError("a lived-in room is filled after it is furnished, object by object; one-shot cannot do that")


def _effort_for(cast: Players, effort: Effort) -> Effort:
    """Not more than those who play can make use of."""
    rounds = effort.rounds if cast.rounds is None else min(effort.rounds, cast.rounds)
    return replace(effort, rounds=rounds, restarts=0 if cast.once else effort.restarts)


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
    until: float,
) -> Generation:
    """Place the targets of a plan into a scene one by one; begin anew where that does not end well, while it helps.

    Attempts are numbered from `first`; every number leads to other choices. At the monotonic time `until` the budget
    is over [s]. With `lived_in` the room is dressed after that.

    Raises:
        BrokenOffError: the policy cannot go on.
    """
    makeable, refused = makeable_part(plan, scene, source)
    loop = Loop(makeable, kinds_of(makeable, source), policy, source, effort, until)
    made: list[_Attempt] = []

    def episode(best: _Attempt, plan: Plan) -> Episode:
        return Episode(
            prompt=scene.prompt,
            seed=scene.seed,
            room=scene.room,
            plan=plan,
            kinds=kinds_of(plan, source),
            assets={id: asset for attempt in made for id, asset in attempt.assets.items()},
            rounds=tuple(structs.replace(r, kept=attempt is best) for attempt in made for r in attempt.rounds),
            prompts=prompts_version(),
        )

    try:
        for number in range(first, first + 1 + effort.restarts):
            made.append(_Attempt(scene, number, judged, refused))
            made[-1].furnish(loop, judged, on_object)
            last = _faults(made[-1].report)
            if not any(last) or loop.over or (len(made) > 1 and last >= _faults(made[-2].report)):
                break
        best = min(made, key=lambda attempt: _faults(attempt.report))
        if lived_in:
            makeable = best.dress(loop, judged, on_object, len(made) - 1)
    except UnavailableError as error:
        whole = [attempt for attempt in made if attempt.finished] or made
        best = min(whole, key=lambda attempt: _faults(attempt.report) if attempt.finished else ())
        raise BrokenOffError(str(error), episode(best, makeable)) from error
    return Generation(best.world.scene, best.report, episode(best, makeable))


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


def _faults(report: Report) -> tuple[int, ...]:
    """What is not as asked and another arrangement might mend, the gravest first."""
    absent = [a for a in report.absent if a.category != UNKNOWN]
    return (
        sum(a.asked for a in absent),
        sum(not v.valid for v in report.objects) + (not report.valid),
        sum(not r.holds for r in report.relations) + sum(not d.holds for d in report.demands if d.kind in ARRANGED),
        len(absent),
    )


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
        self.finished = True

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

    def _place(self, loop: Loop, target: Target, rng: np.random.Generator) -> str:
        """Place one object; says why when it could not be placed."""
        placing = Placing(self.world, loop, target, rng)
        try:
            grown = placing.run()
        finally:
            self.assets |= placing.assets
            self.rounds += [structs.replace(r, attempt=self.number) for r in placing.rounds]
        self.world = placing.world if grown is None else grown
        return "" if grown is not None else placing.reason or "no place was found"
