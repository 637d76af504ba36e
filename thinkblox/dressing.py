"""A furnished room becomes a lived-in one: what is added is placed and measured as everything else, or left out."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.episode import Round
from thinkblox.errors import InputError
from thinkblox.judging import asset_for
from thinkblox.observe import kinds_of
from thinkblox.placing import Loop, Placing
from thinkblox.plan import Target
from thinkblox.planning.dressing import LEAST, Dresser, Stage
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, overlap_depth
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.scene.windows import hangs_at_window
from thinkblox.scene.zones import beside
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Absence

_CANDIDATES = 4
"""Poses proposed for one of the many things that nobody asked for; where none will do, it is left out."""
_FULL = 4
"""After so many in a row that found no place on a thing it is taken for full."""
STAGES: tuple[Stage, ...] = ("furniture", "things", "things", "spare", "things", "things")
"""What is added, one after the other; the later ones only as long as there is too little."""
_BY_WALL = 0.4
"""What is no further from a wall is not amid the room [m]."""
_FLUSH = 0.06
"""What stands in one run is no further apart, and its fronts no further out of line [m]."""
_BEFORE, _REACHES_IN = 0.6, 0.03
"""Free floor before storage, and how far something may reach into it [m]."""
_SALT = 1_000_003
"""Keeps these random choices apart from those of the furniture."""


@dataclass
class Dressed:
    """The room with what was added, and how that came about."""

    world: World
    loop: Loop
    rounds: list[Round] = field(default_factory=list)
    assets: dict[str, Asset] = field(default_factory=dict)
    absent: list[Absence] = field(default_factory=list)


def dress(world: World, loop: Loop, *, attempt: int, on_object: Callable[[Target, bool, int], None]) -> Dressed:
    """Add what makes a room look lived in: furniture and pictures first, then what lies on everything that carries.

    Where not enough finds room, other things are tried, and shelves are hung for more.

    Args:
        world: the furnished room.
        loop: what it was furnished with.
        attempt: which attempt at the room it is.
        on_object: called with each target, whether it was placed, and how many are to be added as far as is known: what
            lies about is planned when the furniture stands.
    """
    effort = replace(
        loop.effort, candidates=min(_CANDIDATES, loop.effort.candidates), rounds=1, repairs=0, revisions=0, resort=False
    )
    seed = world.scene.seed
    dresser = Dresser(loop.plan, np.random.default_rng((seed, _SALT)))
    done = Dressed(world, replace(loop, effort=effort, tells=False))
    planned = 0
    crowded: Counter[str] = Counter()
    for number, stage in enumerate(STAGES):
        if number > 1 and len(done.world.scene.placements) >= LEAST:
            break
        full = [id for id, failures in crowded.items() if failures >= _FULL]
        targets = dresser.add(stage, done.world.scene, full)
        done.loop = replace(done.loop, plan=dresser.plan)
        makeable = _makeable(done, targets)
        planned += len(makeable)
        for target in makeable:
            on = next((tie.anchors[0] for tie in target.ties if tie.kind == "on"), "")
            why = done.loop.over or (_no_room(on) if crowded[on] >= _FULL else _place(done, target, attempt))
            if on:
                crowded[on] = crowded[on] + 1 if why else 0
            if why:
                done.absent.append(_absence(target, why))
            on_object(target, not why, planned)
    return done


def bare_shelves(done: Dressed) -> tuple[str, ...]:
    """Ids of the shelves that were hung and have nothing on them."""
    scene = done.world.scene
    shelves = (p for id in sorted({r.id for r in done.rounds}) if id in scene for p in [scene[id]])
    hung = (p for p in shelves if facts_of(p.category).is_in("shelves") and scene.asset_of(p).mount == "wall")
    return tuple(p.id for p in hung if not scene.resting_on(p.id))


def undress(
    done: Dressed,
    ids: Sequence[str],
    *,
    tolerances: Tolerances,
    requirements: Sequence[Requirement] = (),
    why: str = "it did not stand still once everything was there",
) -> None:
    """Take away some of what was added, and note why."""
    scene = done.world.scene
    for id in ids:
        scene = scene.without(id)
    done.world = World(scene, tolerances=tolerances, requirements=requirements)
    done.rounds = [structs.replace(r, kept=r.kept and r.id not in ids) for r in done.rounds]
    targets = (target for target in done.loop.plan.targets if target.id in ids)
    done.absent += [_absence(target, why) for target in targets]


def _makeable(done: Dressed, targets: Sequence[Target]) -> list[Target]:
    """The targets that the source can make; the others are noted as absent."""
    kept = []
    for target in targets:
        try:
            done.loop.source.usual(target.category)
            asset_for(target, done.world.scene, done.loop.source)
            kept.append(target)
        except InputError as error:
            done.absent.append(_absence(target, str(error)))
    gone = {target.id for target in targets} - {target.id for target in kept}
    plan = structs.replace(
        done.loop.plan, targets=tuple(target for target in done.loop.plan.targets if target.id not in gone)
    )
    done.loop = replace(done.loop, plan=plan, kinds=kinds_of(plan, done.loop.source))
    return kept


def _place(done: Dressed, target: Target, attempt: int) -> str:
    """Place one object; says why where it could not be placed."""
    number = done.loop.plan.targets.index(target)
    placing = Placing(done.world, done.loop, target, np.random.default_rng((done.world.scene.seed, _SALT, number)))
    grown = placing.run()
    astray = "" if grown is None else _astray(grown.scene, target)
    if grown is not None and not astray and not grown.stands_firmly(target.id):
        astray = "it does not lie firmly, and all about it would be measured for long"
    done.world = done.world if grown is None or astray else grown
    done.assets |= placing.assets
    done.rounds += [structs.replace(r, attempt=attempt, kept=astray == "") for r in placing.rounds]
    if astray:
        return astray
    return "" if grown is not None else placing.reason or "no place was found"


def _astray(scene: Scene, target: Target) -> str:
    """Why something that nobody asked for is better left out than where it has come to stand; empty where it is well.

    What belongs to a wall does not stand amid the room because the walls are full.
    """
    if dresses_nothing(scene, target):
        return "there was no room left for it at a window"
    for tie in target.ties:
        if tie.kind == "on":
            if scene[target.id].support != tie.anchors[0]:
                return _no_room(tie.anchors[0])
        elif tie.kind == "against_wall" and not measure(scene, tie.kind, target.id, tie.anchors).holds:
            return "there was no room left for it at a wall"
        elif tie.kind == "in_corner" and _amid(scene, target.id):
            return "there was no room left for it in a corner or at a wall"
        elif tie.kind == "next_to" and not _joins(scene, target.id):
            return "there was no room left for it in the run"
    return "it would stand before storage" if _bars_storage(scene, target.id) else ""


def _joins(scene: Scene, id: str) -> bool:
    """Whether it stands flush with another of its run, if it is built in one."""
    own = scene[id]
    if not facts_of(own.category).is_in("built_in_line"):
        return True
    run = (p for p in scene.placements if p.id != id and facts_of(p.category).runs_with(facts_of(own.category)))
    return any(
        turn_between(p.yaw, own.yaw) < 1.0
        and abs(p.to_local(own.position[:2])[0]) < _FLUSH
        and p.footprint.distance(own.footprint) < _FLUSH
        for p in run
    )


def _bars_storage(scene: Scene, id: str) -> bool:
    """Whether it stands so near before what things are taken from, or has something so near before it."""
    own = scene[id]
    if not _stands(scene, own):
        return False
    others = [p for p in scene.placements if p.id != id and _stands(scene, p)]
    behind = [p for p in others if _is_taken_from(scene, p)]
    pairs = [(p, own) for p in behind] + ([(own, p) for p in others] if _is_taken_from(scene, own) else [])
    return any(_is_before(storage, thing) for storage, thing in pairs)


def _stands(scene: Scene, placement: Placement) -> bool:
    """Whether it takes up floor, and is not drawn aside as a seat is."""
    asset = scene.asset_of(placement)
    solid = asset.collides and asset.mount == "floor" and placement.support == "floor"
    return solid and not facts_of(placement.category).is_in("seats")


def _is_taken_from(scene: Scene, placement: Placement) -> bool:
    stored = facts_of(placement.category).is_in("storage", "shelves")
    return stored and scene.asset_of(placement).front == "one"


def _is_before(storage: Placement, thing: Placement) -> bool:
    before = beside(Rects.of_placements((storage,)), "front", _BEFORE)
    return bool(overlap_depth(Rects.of_placements((thing,)), before).max() > _REACHES_IN)


def _no_room(carrier: str) -> str:
    """Why something does not lie on a thing that is full."""
    return f"there was no room left for it on {carrier}"


def dresses_nothing(scene: Scene, target: Target) -> bool:
    """Whether curtains hang where there is no window."""
    by_window = any(tie.kind == "near" and tie.anchors == ("window",) for tie in target.ties)
    drapes = facts_of(target.category).hanging.windows != "no"
    return by_window and drapes and not hangs_at_window(scene, target.id)


def _amid(scene: Scene, id: str) -> bool:
    """Whether it stands on the floor away from every wall."""
    placement = scene[id]
    return placement.support == "floor" and bool(scene.room.polygon.exterior.distance(placement.footprint) > _BY_WALL)


def _absence(target: Target, why: str) -> Absence:
    return Absence(id=target.id, category=target.category, asked=False, reason=why)
