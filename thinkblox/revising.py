"""Revising: an object that finds no place may have one when a neighbour makes room."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import NamedTuple

from thinkblox.judging import Proposal, Try, measured
from thinkblox.phrases import phrase
from thinkblox.plan import Due, Plan, Target, Tie, is_object
from thinkblox.scene.actions import Move
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.saying import place_words
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World
from thinkblox.steps import write_step
from thinkblox.verdict import Reason, Verdict

MENDED: frozenset[Reason] = frozenset({"collision", "blocks_opening", "blocks_way", "blocks_window"})
"""What may be mended by moving a neighbour."""
TRIED = 3
"""Failed placements for which a neighbour is looked at."""
FAR = 1.5
"""Farthest that a neighbour is moved [m]."""


class Revision(NamedTuple):
    """A neighbour's move that lets an object stand where it could not.

    Attributes:
        move: what the neighbour does, and its verdict.
        tried: the same as a try.
        again, asset: the placement that is valid then, and what it shows.
    """

    move: Proposal
    move_verdict: Verdict
    tried: Try
    again: Placement
    asset: Asset


def unmet(scene: Scene, target: Target) -> list[Tie | Due]:
    """The relations asked for of an object, and those due, that do not hold, of those that can be measured by now."""
    asked = [tie for tie in target.ties if tie.asked and _misses(scene, target.id, tie)]
    return [*asked, *(due for due in target.due if due.subject in scene and _misses(scene, due.subject, due.tie))]


def _misses(scene: Scene, id: str, tie: Tie) -> bool:
    """Whether one object can be measured by now and does not have the relation."""
    there = bool(tie.anchors) and all(anchor in scene or not is_object(anchor) for anchor in tie.anchors)
    alone = there and tie.kind not in ("around", "in_rows")
    return alone and not measure(scene, tie.kind, id, tie.anchors, rows=tie.rows).holds


def revisions(
    world: World,
    plan: Plan,
    failed: Sequence[tuple[Proposal, Verdict]],
    *,
    most: int,
    over: Callable[[], object] = lambda: False,
) -> Iterator[Revision]:
    """Moves of one neighbour each that let a failed placement stand, the least move of the best failure first.

    Args:
        world: without the object.
        plan: what was asked of the neighbours; they keep it.
        failed: what was tried for the object, best first.
        most: places measured for neighbours.
        over: whether no more are to be looked at.
    """
    left = most
    for proposal, blocker in islice(_blocked(world.scene, failed), TRIED):
        candidate, asset = proposal.placement, proposal.asset
        if candidate is None or asset is None:
            continue
        filled = world.scene.with_placement(candidate, asset)
        for place in _places(filled, plan, blocker, over):
            if left == 0 or over():
                return
            left -= 1
            found = _revision(world, filled, place, candidate, asset)
            if found is not None:
                yield found


def _blocked(scene: Scene, failed: Sequence[tuple[Proposal, Verdict]]) -> Iterator[tuple[Proposal, Placement]]:
    """Failures with the one free neighbour that each is to blame for."""
    seen: set[str] = set()
    for proposal, verdict in failed:
        others = {c.other for c in verdict.collisions} or {
            id for swing in verdict.swings if swing.opens < 1.0 for id in (swing.of, *swing.hits) if id != verdict.id
        }
        there = [id for id in others if id in scene]
        if len(there) != 1 or not set(verdict.reasons) <= MENDED or there[0] in seen:
            continue
        seen.add(there[0])
        yield proposal, scene[there[0]]


def _places(filled: Scene, plan: Plan, blocker: Placement, over: Callable[[], object]) -> Iterator[Placement]:
    """Where a neighbour might go: nearby, clear of all as seen from above, with what was asked of it kept."""
    asset = filled.asset_of(blocker)
    target = next((t for t in plan.targets if t.id == blocker.id), None)
    before = len(unmet(filled, target)) if target else 0
    for place in nearest_poses(filled, asset, blocker):
        if over() or math.dist(place.position, blocker.position) > FAR:
            return
        moved = filled.apply(Move(id=place.id, position=place.position, yaw=place.yaw))
        if target is None or len(unmet(moved, target)) <= before:
            yield place


def _revision(world: World, filled: Scene, place: Placement, candidate: Placement, asset: Asset) -> Revision | None:
    """The move as a proposal, where it is valid and the candidate is valid after it."""
    scene = world.scene
    action = Move(id=place.id, position=place.position, yaw=place.yaw)
    with_candidate = world.with_placement(candidate, asset)
    if not with_candidate.measure(action).valid:
        return None
    after = world.with_scene(scene.apply(action))
    if not after.check([candidate], asset)[0].valid:
        return None
    words = ", ".join(phrase(word) for word in place_words(scene, scene.asset_of(place), place))
    lines = (f"{candidate.id} needs the place of {place.id}.", f"So {place.id} makes room: it goes {words}.")
    text = write_step(lines, action="move", id=place.id, position=place.position, yaw=place.yaw)
    move = Proposal(text, action, place, scene.asset_of(place))
    tried = measured(world, move)
    if tried.verdict is None or not tried.verdict.valid:
        return None
    return Revision(move, tried.verdict, tried, candidate, asset)
