"""The verdict on a whole scene: every object by itself, and then everything free at once."""

import math
from collections.abc import Sequence

import mujoco
import numpy as np
from msgspec import structs

from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled, package_version
from thinkblox.sim.geometry.access import access, stands_on_floor
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.contacts import Contacts
from thinkblox.sim.verdict.requirement import Requirement
from thinkblox.sim.verdict.settle import SettledState, diverged, free_addresses, motion_between, rest
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
    state = state or rest(model, physics)
    held = hold(model, state, physics)
    walkable = access(scene, walking)
    world = World(scene, tolerances=tolerances, physics=physics, walking=walking, requirements=requirements)
    way = way and bool(walkable.unreachable)
    robot = access(scene, structs.replace(walking, width=walking.robot, large=0.0, movable=0.0))
    objects = tuple(_verdict(world, placement, way, robot) for placement in scene.placements)
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
        notes=(*_motion_notes(state, held, tolerances, physics), *_way_notes(walkable)),
    )


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
    return (moved, f"It still moved after {physics.rest_time:g} s; its keyframe is the state at that time.")


def _way_notes(walkable: Access) -> tuple[str, ...]:
    if not walkable.unreachable:
        return ()
    return (f"There is no way {walkable.width:g} m wide from the door to {', '.join(walkable.unreachable)}.",)
