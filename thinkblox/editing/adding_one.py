"""One thing that is added: what it is made as, and where it comes to be."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain

from msgspec import structs

from thinkblox.assets import GENERAL_WORDS
from thinkblox.brief import Measures
from thinkblox.editing.acting import bears_nothing, prefer_sides
from thinkblox.editing.carrying import usual_ties
from thinkblox.editing.finding import SAME_SIZE
from thinkblox.editing.goals import LOW_HUNG, At, Goal, Hung, Laid, Related, Spot, Unhidden
from thinkblox.editing.orders import SAME
from thinkblox.editing.reaching import Reaching, ties_of
from thinkblox.editing.spots import Pose, between, levelled, likely, spots
from thinkblox.editing.wheres import Bound
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.judging import asset_for
from thinkblox.knowledge.habits import load_habits
from thinkblox.plan import Target
from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.measures import object_size
from thinkblox.reading.own_names import own_name
from thinkblox.reading.senses import choose_senses
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import BACK_GAP, EYE
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

MOST = 20
"""Most things that one order adds."""


def category_of(work: Work, noun: Noun, wheres: Sequence[Bound]) -> str:
    """The category that a noun means in this room and at that place: a "lamp" on a nightstand is a table lamp."""
    draft = Draft()
    thing = Mention(noun=noun.value, count=noun.count, plural=noun.plural, attributes=list(noun.attributes))
    draft.things.append(thing)
    draft.room = work.planned.brief.room_type if work.planned is not None else ""
    for where in wheres:
        for anchor in where.anchors:
            whole = Mention(work.scene[anchor].category) if anchor in work.scene else anchor
            draft.bonds.append(Bond(where.kind, thing, (whole,)))
    choose_senses(draft, {p.category for p in work.scene.placements})
    _, mount = work.source.usual(thing.noun)
    general = f"any_{noun.word}"
    raised = [b for b in wheres if b.kind == "on" and b.anchors and b.anchors[0] in work.scene]
    if raised and mount == "floor" and general in GENERAL_WORDS and noun.value != general:
        return category_of(work, replace(noun, value=general), wheres)
    return thing.noun


def add_one(
    work: Work,
    category: str,
    noun: Noun,
    goals: Sequence[Goal],
    *,
    asset: Asset | None = None,
    first: Sequence[Pose] = (),
) -> str:
    """Add one thing, as it is said or of an asset; its id, or an empty text where that cannot be, which is noted.

    Args:
        work: the edit.
        category: of the thing.
        noun: what is said of it.
        goals: where it is to be.
        asset: which it is to be; one as is said when not given.
        first: poses that are tried before others.
    """
    id = work.new_id(category)
    if load_habits().is_in(category, "screens"):
        others = [p.id for p in work.scene.placements if load_habits().is_in(p.category, "screens")]
        others = [name for name in others if work.asset_of(name).mount == "surface"]
        goals = [*goals, Unhidden(tuple(others))] if others else goals
    attributes, ties = tuple(noun.attributes), ties_of(goals)
    if all(tie.kind in ("facing", "opposite") for tie in ties):
        ties = (*usual_ties(work.scene, category), *ties)
    if work.source.usual(category)[1] == "wall" and _is_by_hung(work.scene, goals):
        goals = [*goals, Hung()]
    target = structs.replace(
        work.target(id, category, ties, attributes),
        size=object_size(category, noun.size),
        called=own_name(noun.called, category),
    )
    asset = asset or _asset(work, target, same=noun.degree == SAME)
    seats = [goal for goal in goals if isinstance(goal, Related) and goal.measured == "at"]
    seated = any(goal.anchors[0] in work.start for goal in seats)
    direct = chain(first, _between(work.scene, asset, goals), spots(work.scene, asset, goals) if seated else ())
    if any(isinstance(goal, Laid) for goal in goals):
        direct = chain(likely(work.scene, asset, goals), direct)
    direct = chain(_where_it_was(asset, goals), direct)
    spot = next((goal.point for goal in goals if isinstance(goal, At)), None)
    begin = _begin(work.scene, asset, spot) if spot is not None else None
    poses = levelled(work.scene, asset, goals, direct)
    reaching = Reaching(work, target, asset, goals, direct=poses, begin=begin, more=likely(work.scene, asset, goals))
    saved = work.saved()
    reached = reaching.run()
    if not reached:
        why = bears_nothing(work, goals) or reaching.why.removeprefix(f"{id}: ")
        work.failed.append(f"{_named(work, category)} was not added: {why}")
        return ""

    def reach(other: Sequence[Goal]) -> bool:
        return Reaching(work, target, asset, other, direct=spots(work.scene, asset, other), ask=False).run()

    prefer_sides(work, id, goals, saved, reach)
    work.wish(id, goals)
    placement = work.scene[id]
    says = dict.fromkeys(goal.check(work.before, work.scene, id)[1] for goal in goals)
    found = "; ".join(filter(None, says))
    x, y, _ = placement.position
    on = f" on {placement.support}" if placement.support != "floor" else ""
    work.done.append(f"{id} added at ({x:.2f}, {y:.2f}){on}{f' ({found})' if found else ''}")
    return id


def _is_by_hung(scene: Scene, goals: Sequence[Goal]) -> bool:
    """Whether all that a place names hangs on a wall, as that which comes to it does then."""
    names = [name for goal in goals if isinstance(goal, Related) and not goal.negated for name in goal.anchors]
    known = [scene[name] for name in names if name in scene]
    return bool(known) and all(scene.asset_of(p).mount == "wall" and p.position[2] >= LOW_HUNG for p in known)


def _where_it_was(asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The very place of what stood on the floor where something comes now, turned as that was."""
    for old in (goal.old for goal in goals if isinstance(goal, Spot) and goal.old is not None):
        if asset.mount in ("floor", "surface") and old.support == "floor":
            yield (*old.position[:2], 0.0), old.yaw


def _between(scene: Scene, asset: Asset, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Places between two things, nearest to the middle of the way first."""
    for goal in goals:
        if isinstance(goal, Related) and goal.kind == "between" and asset.mount in ("floor", "wall"):
            yield from between(scene, asset, goal.anchors, 0.0)


def _named(work: Work, category: str) -> str:
    """What could not be added: "a plant", or "another plant" where one is there."""
    name = category.replace("_", " ")
    if any(p.category == category for p in work.scene.placements):
        return f"another {name}"
    return f"{'an' if name[:1] in 'aeiou' else 'a'} {name}"


def _begin(scene: Scene, asset: Asset, spot: Vec2) -> Pose:
    """Where the search for a place at a spot begins: what hangs begins at the wall that is nearest, at eye height."""
    if asset.mount != "wall":
        return (*spot, 0.0), 0.0
    wall = min(scene.room.walls, key=lambda wall: abs(wall.coordinates(spot)[1]))
    x, y = wall.point(wall.coordinates(spot)[0], asset.size[0] / 2 + BACK_GAP)
    return (x, y, max(0.0, EYE - asset.size[2] / 2)), wall.yaw


def _asset(work: Work, target: Target, *, same: bool = False) -> Asset:
    """What is added: another one like those that are there, unless something else is said of it."""
    alike = [p for p in work.scene.placements if p.category == target.category]
    if same and not alike:
        raise InputError(f"there is no {target.category.replace('_', ' ')} yet that another could be as large as")
    if same:
        made = asset_for(target, work.scene, work.source) if target.attributes else work.scene.asset_of(alike[-1])
        return made if made.size == alike[-1].size else work.source.fit(made, alike[-1].size)
    if alike and not target.attributes and target.size == (None, None, None):
        asset = work.scene.asset_of(alike[-1])
        return asset.called(target.called) if target.called else asset
    return of_size(asset_for(target, work.scene, work.source), target.size)


def of_size(made: Asset, size: Measures) -> Asset:
    """An asset that is to have a size, as far as one is said.

    Raises:
        InputError: it is not made so.
    """
    if any(wanted is not None and abs(wanted - side) > SAME_SIZE for wanted, side in zip(size, made.size, strict=True)):
        says = " by ".join(f"{wanted:.2f} m" for wanted in size if wanted is not None)
        is_now = " by ".join(f"{side:.2f}" for side in made.size)
        raise InputError(f"no {made.description} is made of {says}; the nearest is {is_now} m")
    return made
