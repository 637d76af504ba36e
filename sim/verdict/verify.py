"""The verdict on a whole scene: every object by itself, and then everything free at once."""

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import mujoco
import numpy as np
from msgspec import structs

from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled, package_version
from thinkblox.sim.geometry.access import access, stands_on_floor
from thinkblox.sim.geometry.bounds import Neighbours, piece_boxes
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.contacts import Contacts
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.settle import SettledState, diverged, free_addresses, motion_between, rest, settle
from thinkblox.sim.verdict.world import World
from thinkblox.value import Value
from thinkblox.verdict import Access, Report, Verdict


class Hold(Value, kw_only=True, frozen=True):
    """How a settled scene stood still.

    Attributes:
        depth: deepest contact at its start [m].
        drift, tilt: largest motion of any free object [m, degrees].
        seconds: simulated [s].
        unstable: the engine gave up, and the numbers mean nothing.
    """

    depth: float
    drift: float
    tilt: float
    seconds: float
    unstable: bool


def verify(
    scene: Scene,
    *,
    tolerances: Tolerances | None = None,
    physics: Physics | None = None,
    walking: Walking | None = None,
    state: SettledState | None = None,
    way: bool = True,
    requirements: Sequence[Requirement] = (),
) -> Report:
    """Measure a whole scene.

    Args:
        scene: the room and what stands in it, at the proposed poses.
        tolerances: where the lines are drawn.
        physics: the engine's options.
        walking: what a walkable way is.
        state: the scene at rest, when `settle` has already been run with the same physics.
        requirements: what the user requires of every placement besides.
        way: whether objects that cut others off fail; the report names what is cut off in any case.
    """
    tolerances, physics, walking = tolerances or Tolerances(), physics or Physics(), walking or Walking()
    model = compiled(build_spec(scene, physics=physics))
    state = state or settle(scene, physics=physics)
    with ThreadPoolExecutor(1) as beside:
        holding = beside.submit(hold, model, state, physics)
        walkable = access(scene, walking)
        world = World(scene, tolerances=tolerances, physics=physics, walking=walking, requirements=requirements)
        way = way and bool(walkable.unreachable)
        robot = access(scene, structs.replace(walking, width=walking.robot, large=0.0, movable=0.0))
        objects = tuple(_verdict(world, placement, way, robot) for placement in scene.placements)
        held = holding.result()
    notes = _motion_notes(state, held, tolerances, physics)
    return _report(scene, objects, held, tolerances, walkable, robot, (*notes, *_way_notes(walkable)))


NEAR = 0.05
"""Whatever is nearer to what has changed is measured again, with all that hangs together with it [m]."""
OPENS_WITHIN = 1.5
"""What has doors or drawers, or may be in the way of a changed thing's, is measured again where these open less or
more than they did, being nearer than this [m]."""
HANGS = 0.02
"""Free things nearer than this to each other hang together [m]."""


def reverify(
    scene: Scene,
    before: Scene,
    report: Report | None,
    *,
    tolerances: Tolerances | None = None,
    physics: Physics | None = None,
    walking: Walking | None = None,
) -> Report:
    """Measure a scene that differs from one that was measured: what has changed, and what that can concern.

    The verdict on everything else is that of `report`, and the whole is held still as far as it concerns what has
    changed; the figures of the whole are the larger ones of the two. Without a report, every object is measured, the
    whole is held still as far, and a note says so.

    Args:
        scene: as it is now.
        before: as it was.
        report: on `before`, by the same settings.
        tolerances: where the lines are drawn.
        physics: the engine's options.
        walking: what a walkable way is.
    """
    tolerances, physics, walking = tolerances or Tolerances(), physics or Physics(), walking or Walking()
    known = {v.id: v for v in report.objects} if report is not None else {}
    walkable = access(scene, walking)
    cut_off = bool(walkable.unreachable or (report and report.walker and report.walker.unreachable))
    concerned, around = _concerned(scene, before)
    world = World(scene, tolerances=tolerances, physics=physics, walking=walking)
    anew = {p.id for p in scene.placements} if cut_off or scene.room != before.room else concerned
    anew |= {p.id for p in scene.placements if p.id not in known}
    anew |= {id for id in around - anew if world.swings(id) != known[id].swings}
    robot = access(scene, structs.replace(walking, width=walking.robot, large=0.0, movable=0.0))
    objects = tuple(
        _verdict(world, p, bool(walkable.unreachable), robot)
        if p.id in anew
        else _as_driven(known[p.id], p, scene, robot)
        for p in scene.placements
    )
    if scene.room != before.room:
        concerned |= {v.id for v in objects if v.boundary > -HANGS}
    was = Hold(depth=0.0, drift=0.0, tilt=0.0, seconds=physics.hold_time, unstable=False)
    notes: tuple[str, ...] = ()
    if report is None:
        notes = ("Only what the change concerns was held still with everything free; the rest stood as it does.",)
    elif not _still(report, tolerances):
        concerned = {p.id for p in scene.placements}
    else:
        was = structs.replace(was, depth=report.depth, drift=report.drift, tilt=report.tilt)
    held, state = _held_in_part(scene, concerned, physics)
    held = structs.replace(
        held, depth=max(was.depth, held.depth), drift=max(was.drift, held.drift), tilt=max(was.tilt, held.tilt)
    )
    moving = _motion_notes(state, held, tolerances, physics) if state is not None else ()
    return _report(scene, objects, held, tolerances, walkable, robot, (*moving, *_way_notes(walkable), *notes))


def _report(
    scene: Scene,
    objects: tuple[Verdict, ...],
    held: Hold,
    tolerances: Tolerances,
    walkable: Access,
    robot: Access,
    notes: tuple[str, ...],
) -> Report:
    valid = all(v.valid for v in objects) and _stands_still(held, tolerances)
    return Report(
        valid=valid,
        complete=valid,
        prompt=scene.prompt,
        seed=scene.seed,
        versions={"thinkblox": package_version(), "mujoco": mujoco.__version__},
        objects=objects,
        depth=held.depth,
        drift=held.drift,
        tilt=held.tilt,
        simulated=held.seconds,
        walker=walkable,
        robot=robot,
        notes=notes,
    )


def _concerned(scene: Scene, before: Scene) -> tuple[set[str], set[str]]:
    """What has changed, what is near to it or was, and what hangs together with that; and what doors concern around."""
    old, new = ({p.id: (p, s.asset_of(p)) for p in s.placements} for s in (before, scene))
    differs = [id for id in (*old, *new) if old.get(id) != new.get(id)]
    changed = dict.fromkeys(differs)
    there = Neighbours(scene)
    found, opens = {id for id in changed if id in new}, set[str]()
    for id in changed:
        for placement, asset in (entry for entry in (old.get(id), new.get(id)) if entry is not None):
            if not asset.collides:
                continue
            boxes = piece_boxes(solid_of(asset), placement)
            found |= there.meetings(boxes, NEAR).keys()
            around = there.meetings(boxes, OPENS_WITHIN).keys()
            opens |= {o for o in around if asset.made_of[2] or new[o][1].made_of[2]}
    solid = {id for id in found if new[id][1].collides}
    found |= there.hanging_together(solid, HANGS)
    return found, opens - found


def _as_driven(known: Verdict, placement: Placement, scene: Scene, robot: Access) -> Verdict:
    """A verdict as it was, with what a robot can reach now."""
    if not stands_on_floor(placement, scene.asset_of(placement)):
        return known
    return structs.replace(known, reachable=placement.id not in robot.unreachable)


def _still(report: Report, tolerances: Tolerances) -> bool:
    held = Hold(depth=report.depth, drift=report.drift, tilt=report.tilt, seconds=0.0, unstable=False)
    return _stands_still(held, tolerances)


def _held_in_part(scene: Scene, ids: set[str], physics: Physics) -> tuple[Hold, SettledState | None]:
    """Hold a part of a scene still, with nothing else in the room."""
    still = Hold(depth=0.0, drift=0.0, tilt=0.0, seconds=physics.hold_time, unstable=False)
    if not any(scene.asset_of(scene[id]).free for id in ids):
        return still, None
    model = compiled(build_spec(scene, physics=physics, only=frozenset(ids)))
    state = rest(model, physics)
    return hold(model, state, physics), state


def _verdict(world: World, placement: Placement, way: bool, robot: Access) -> Verdict:
    asset = world.scene.asset_of(placement)
    verdict = world.check([placement], asset, way=way)[0]
    driven_to = stands_on_floor(placement, asset)
    return structs.replace(verdict, reachable=placement.id not in robot.unreachable) if driven_to else verdict


@quiet_engine()
def hold(model: mujoco.MjModel, state: SettledState, physics: Physics) -> Hold:
    """Run a compiled scene from its settled state for `physics.hold_time`, everything awake and free."""
    data = mujoco.MjData(model)
    data.qpos[:] = state.qpos
    mujoco.mj_forward(model, data)
    depth = max(Contacts(model).depths(data).values(), default=0.0)
    addresses, start, drift, tilt = free_addresses(model), data.qpos.copy(), 0.0, 0.0
    for _ in range(math.ceil(physics.hold_time / (physics.timestep * physics.chunk))):
        mujoco.mj_step(model, data, nstep=physics.chunk)
        for address in addresses.values():
            pose = slice(address, address + 7)
            motion = motion_between(start[pose], data.qpos[pose])
            travelled = float(np.linalg.norm(data.qpos[pose][:3] - start[pose][:3]))
            drift, tilt = max(drift, travelled), max(tilt, motion.tilt)
    return Hold(
        depth=round(depth, 6),
        drift=round(drift, 6),
        tilt=tilt,
        seconds=physics.hold_time,
        unstable=diverged(data),
    )


def _stands_still(held: Hold, tolerances: Tolerances) -> bool:
    return (
        not held.unstable
        and held.depth <= tolerances.penetration
        and held.drift <= tolerances.hold_drift
        and held.tilt <= tolerances.hold_tilt
    )


def _motion_notes(state: SettledState, held: Hold, tolerances: Tolerances, physics: Physics) -> tuple[str, ...]:
    if held.unstable:
        return ("The simulation of the settled scene failed.",)
    if _stands_still(held, tolerances):
        return ()
    moved = (
        f"The settled scene does not stand still: in {held.seconds:g} s something moved {held.drift * 1000:.1f} mm"
        f" and turned {held.tilt:.1f} degrees, with a contact {held.depth * 1000:.2f} mm deep."
    )
    if state.rested:
        return (moved,)
    return (
        moved,
        f"It still moved after {physics.rest_time:g} s; what is said of it once settled is the state at that time.",
    )


def _way_notes(walkable: Access) -> tuple[str, ...]:
    if not walkable.unreachable:
        return ()
    return (f"There is no way {walkable.width:g} m wide from the door to {', '.join(walkable.unreachable)}.",)
