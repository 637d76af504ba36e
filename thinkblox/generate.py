"""The loop: a prompt becomes a plan, and each target of the plan a measured placement."""

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Protocol, TypeVar

import numpy as np

from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.brief import Brief
from thinkblox.episode import Round
from thinkblox.errors import InputError
from thinkblox.fills import Fill
from thinkblox.furnishing import BrokenOffError, Furnished, Generation, Judged, Progress, furnish, spare_on_run
from thinkblox.given import seed_given
from thinkblox.modes import Mode
from thinkblox.observe import Sight
from thinkblox.orders import ORDERS, Order
from thinkblox.placing import Effort
from thinkblox.plan import Plan, Target
from thinkblox.planning import (
    fitted,
    is_essential,
    is_open,
    larger,
    relieved,
    reordered,
    varied,
    with_forms,
    with_looks,
    with_run,
    with_sizes,
    with_surfaces,
)
from thinkblox.players import Players, players
from thinkblox.policies import Briefer, Planner, Policy
from thinkblox.reading import GrammarBriefer
from thinkblox.replaying import Replay
from thinkblox.scene.asset import Mount
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.value import Vec3

M = TypeVar("M")


class Furnisher(Protocol):
    """Furnishes a room, after the attempts before, for a brief of less than was asked where one is given."""

    def __call__(
        self, floor: Room, effort: Effort, before: Sequence[Furnished], less: Brief | None = None
    ) -> Furnished:
        """The furnished room."""
        ...


RELIEFS = 3
"""How often something that is only assumed is left out of a room of a given size where what matters more is absent."""
GROWTH = (1.35, 1.8)
"""By how much the floor of a room grows whose size is left open, where not all that stands on it is as asked."""
ROOMIER, EASY, BLOCKED = 1.2, 0.9, 0.5
"""The same where all is, but in a cramped room: one that scores below this in what follows; and below which score of
its ways one cannot get through it."""
_EASE = ("clearance", "circulation")


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
    sight: Sight | None = None,
    on_plan: Callable[[Plan], None] | None = None,
    on_object: Callable[[Progress], None] | None = None,
    on_round: Callable[[Round], None] | None = None,
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
        sight: what a model that places objects is shown; what it was trained on, or all, when not given.
        on_plan: called with what is to be placed, before anything is.
        on_object: called after each object.
        on_round: called after each round of tries for an object, with what came of them.

    Raises:
        InputError: the prompt, the seed or the room cannot be used, or a model that reads or plans gives nothing that
            can be used.
        BrokenOffError: a room was begun, and a model or a trace could not go on; it has what was tried until then.
    """
    _check_arguments(prompt, room)
    seed = seed_given(seed)
    if order not in ORDERS:
        raise InputError(f"order is {order!r}; it must be one of {', '.join(ORDERS)}")
    cast = players(
        policy, briefer=briefer, planner=planner, mode=mode, fill=fill, seed=seed, source=source, sight=sight
    )
    _check_roles(policy=cast.policy, briefer=cast.briefer, planner=cast.planner, source=source)
    _check_play(cast, prompt, seed, mode, fill)
    planner = cast.planner
    brief = _made("briefer", cast.briefer.brief(prompt), Brief)
    assumes = isinstance(cast.briefer, GrammarBriefer) and fill != "named"
    if assumes:
        brief = fitted(with_sizes(with_looks(with_forms(varied(brief, seed, fill), seed)), seed))
    source = source or ProceduralAssets()
    grows = room is None and is_open(brief)
    room = room or _made("planner", planner.room(brief, np.random.default_rng((seed, 0))), Room)
    effort = _effort_for(cast, effort or Effort())
    until = time.monotonic() + effort.seconds

    def furnished(floor: Room, effort: Effort, before: Sequence[Furnished], less: Brief | None = None) -> Furnished:
        floor = with_surfaces(floor, brief, seed)
        meant = with_run(less or brief, floor, seed) if assumes else less or brief
        plan = _made("planner", planner.plan(meant, floor), Plan)
        plan = reordered(plan, order, lambda target: _usual(target, source), seed)
        if on_plan is not None and not before:
            on_plan(plan)
        return furnish(
            plan,
            Scene(prompt=prompt, seed=seed, room=floor),
            policy=cast.policy,
            source=source,
            effort=effort,
            judged=Judged(tolerances or Tolerances(), tuple(requirements)),
            on_object=on_object or (lambda progress: None),
            on_round=on_round or (lambda done: None),
            first=len(before),
            anew=before[-1].amiss if before else "",
            until=until,
        )

    def wider(factor: float) -> Room:
        return _made("planner", planner.room(larger(brief, room, factor), np.random.default_rng((seed, 0))), Room)

    made: list[Furnished] = []
    try:
        if grows and effort.restarts:
            _furnish_growing(made, furnished, room, wider, effort, until)
        else:
            made.append(furnished(room, effort, ()))
            _furnish_relieved(made, furnished, room, brief if assumes else None, effort, until)
        best = _best(made)
        if fill == "lived-in":
            best.dress()
    except InputError as error:
        if not made:
            raise
        raise BrokenOffError(str(error), _best(made).episode()) from error
    return best.generation()


def _furnish_growing(
    made: list[Furnished],
    furnished: Furnisher,
    room: Room,
    wider: Callable[[float], Room],
    effort: Effort,
    until: float,
) -> None:
    """Furnish a room whose size is left open, and wider ones while that helps; add each to `made`."""
    once = replace(effort, restarts=0)
    made.append(furnished(room, once, ()))
    for factor in GROWTH:
        if not _lacks_floor(made[-1]) or time.monotonic() >= until:
            break
        made.append(furnished(wider(factor), once, made))
        if len(made) > 2 and made[-1].faults >= made[-2].faults:
            break
    if len(made) == 1 and _is_cramped(made[0]) and time.monotonic() < until:
        made.append(furnished(wider(ROOMIER), once, made))
    best = _best(made)
    if any(best.faults) and time.monotonic() < until:
        again = replace(effort, restarts=effort.restarts - 1)
        made.append(furnished(best.scene.room, again, made))


def _furnish_relieved(
    made: list[Furnished],
    furnished: Furnisher,
    room: Room,
    brief: Brief | None,
    effort: Effort,
    until: float,
) -> None:
    """Furnish a room of a given size again with less that is only assumed, while what matters more is absent.

    So it is while one cannot get through it.
    """
    once = replace(effort, restarts=0)

    def wants_less(last: Furnished) -> bool:
        return _lacks_essentials(last) or _is_blocked(last)

    while brief is not None and wants_less(made[-1]) and len(made) <= RELIEFS and time.monotonic() < until:
        brief = relieved(brief)
        if brief is not None:
            made.append(furnished(room, once, made, brief))


def _best(made: Sequence[Furnished]) -> Furnished:
    return min(made, key=lambda each: (each.faults, each.strewn, _is_blocked(each), _is_cramped(each)))


def _usual(target: Target, source: AssetSource) -> tuple[Vec3, Mount] | None:
    """Size [m] and mount of what a target is; None where the source cannot make it."""
    try:
        return source.usual(target.category)
    except InputError:
        return None


def _lacks_floor(made: Furnished) -> bool:
    """Whether something that stands on the floor is absent, fails, or does not stand as asked, or in its rows."""
    mounts = {target.id: made.loop.kinds[target.category].mount for target in made.loop.plan.targets}
    unseated = any(not demand.holds and demand.subject == "seat" for demand in made.report.demands)
    absent = any((a.asked or unseated) and mounts.get(a.id) == "floor" for a in made.report.absent)
    failing = any(not v.valid for v in made.report.objects)
    subjects = (id for r in made.report.relations if not r.holds for id in r.subject.split(", "))
    return absent or failing or any(mounts.get(id) == "floor" for id in subjects) or made.strewn


def _is_cramped(made: Furnished) -> bool:
    """Whether ways through it are narrow, or floor that people need is taken, by the guidelines of interior layout."""
    parts = (made.report.score.part(name).score for name in _EASE) if made.report.score is not None else ()
    return any(score is not None and score < EASY for score in parts)


def _is_blocked(made: Furnished) -> bool:
    """Whether much of what stands in it cannot be reached, by the guidelines of interior layout."""
    reached = made.report.score.part("circulation").score if made.report.score is not None else None
    return reached is not None and reached < BLOCKED


def _lacks_essentials(made: Furnished) -> bool:
    """Whether something that is asked for, or that every such room has, is absent, or anything fails."""
    room, spare = made.loop.plan.brief.room_type, spare_on_run(made.loop.plan)
    absent = any(a.asked or (is_essential(a.category, room) and a.id not in spare) for a in made.report.absent)
    return absent or not made.report.valid or any(not v.valid for v in made.report.objects)


def _made(role: str, made: object, kind: type[M]) -> M:
    """What somebody else's role has made; raises InputError when it is something else."""
    if not isinstance(made, kind):
        raise InputError(f"the {role} answered with a {type(made).__name__}; it must give a {kind.__name__}")
    return made


def _check_arguments(prompt: object, room: object) -> None:
    if not isinstance(prompt, str):
        raise InputError(f"the prompt is a {type(prompt).__name__}; it must be a text")
    if prompt.encode("utf-8", "ignore").decode() != prompt:
        raise InputError("the prompt is not valid text: it holds bytes that are not UTF-8")
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
