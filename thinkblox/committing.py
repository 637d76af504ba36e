"""Committing an action: what has come to rest stands where it rests, so that the next is not blamed for its gap."""

from typing import NamedTuple

from msgspec import structs

from thinkblox.judging import Proposal
from thinkblox.scene.actions import Action, Add
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Verdict

GRID, TURN_GRID = 4, 2
"""Decimals to which a settled pose is rounded [m, degrees]."""


class Committed(NamedTuple):
    """A world after an action, and the placements that it gave other poses or brought."""

    world: World
    placements: tuple[Placement, ...]


def commit(world: World, proposal: Proposal, verdict: Verdict) -> Committed:
    """Do a measured action, everything it concerns at its settled pose: rounded to 0.1 mm and measured there once more.

    Where that measure does not hold, which takes a thing on a knife's edge, the poses are those that were proposed and
    measured. What merely stands beside, and was measured too, stays where it is to the last bit.
    """
    after = world.scene.apply(proposal.action)
    rested = [p for p in _rested(after, verdict) if _is_concerned(world.scene, after, proposal.action, p.id)]
    if isinstance(proposal.action, Add):
        at = next((p for p in rested if p.id == proposal.action.id), after[proposal.action.id])
        if rested and not world.check([at], proposal.action.asset)[0].valid:
            at = after[proposal.action.id]
        grown = world.with_placement(at, proposal.action.asset)
        return Committed(grown, (grown.scene[at.id],))
    changed = after.with_placements(rested)
    ids = [v.id for v in (verdict, *verdict.riders) if v.id in changed]
    grown = world.with_scene(changed)
    if rested and not all(grown.check([changed[id]], changed.asset_of(changed[id]))[0].valid for id in ids):
        changed, grown = after, world.with_scene(after)
    return Committed(grown, tuple(p for p in changed.placements if _differs(world.scene, p)))


def _rested(after: Scene, verdict: Verdict) -> list[Placement]:
    """What came to rest elsewhere than it was put, at its rounded settled pose."""
    found = []
    for v in (verdict, *verdict.riders):
        if v.settled_pose is None or not v.valid or v.id not in after:
            continue
        old = after[v.id]
        x, y, z = (round(c, GRID) + 0.0 for c in v.settled_pose.position)
        new = structs.replace(old, position=(x, y, max(z, 0.0)), yaw=round(v.settled_pose.yaw, TURN_GRID) % 360.0)
        if (new.position, new.yaw) != (old.position, old.yaw):
            found.append(new)
    return found


def _is_concerned(before: Scene, after: Scene, action: Action, id: str) -> bool:
    """Whether an action moves a thing, or what that rests on."""
    return id == action.id or _differs(before, after[id]) or action.id in before.carriers(id)


def _differs(before: Scene, placement: Placement) -> bool:
    return placement.id not in before or before[placement.id] != placement
