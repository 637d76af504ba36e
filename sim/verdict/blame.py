"""What a candidate is to blame for: what is otherwise than it would be without the candidate."""

import math
from typing import NamedTuple

import mujoco
import numpy as np
from msgspec import structs

from thinkblox.sim.build import compiled
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.balance import stands_squarely
from thinkblox.sim.verdict.contacts import Contacts
from thinkblox.sim.verdict.settle import diverged, free_addresses
from thinkblox.sim.verdict.stage import Depths, Poses, Settled, pushes
from thinkblox.sim.verdict.stillness import Quiet, stayed

DEEPER = 0.0001
"""By how much more than without the candidate things must touch to be pressed by it [m]."""
STAYS, STAYS_TILT = 0.02, 5.0
"""Whatever moves or tilts further than this by itself does not stay where it is put [m, degrees]."""


class LeftAlone(NamedTuple):
    """What becomes of a part of a room in which nothing is put.

    Attributes:
        poses: of its free bodies at the end, by name: position and quaternion wxyz.
        depths: deepest contact of every two things that touch at the end [m].
        uneasy: names of those that had not come to rest when the time was over.
        unsteady: names of those that do not stay where they are put.
    """

    poses: Poses
    depths: Depths
    uneasy: frozenset[str]
    unsteady: frozenset[str] = frozenset()


@quiet_engine()
def left_alone(spec: mujoco.MjSpec, physics: Physics) -> LeftAlone:
    """Let everything go until it stands squarely, or until the time of a settle is over."""
    model = compiled(spec)
    data = mujoco.MjData(model)
    addresses, interval = free_addresses(model), physics.timestep * physics.chunk
    places = np.array(list(addresses.values()), dtype=np.intp)[:, None] + np.arange(7)
    now, quiet, uneasy = data.qpos[places], Quiet(interval), frozenset[str]()
    first = dict(zip(addresses, now, strict=True))
    for _ in range(math.ceil(physics.settle_time / interval - 1e-9)):
        mujoco.mj_step(model, data, nstep=physics.chunk)
        before, now = now, data.qpos[places]
        if diverged(data) or (stayed(before, now, interval) and stands_squarely(model, data)):
            break
        quiet.look(now)
    else:
        uneasy = frozenset(id for id, lasted in zip(addresses, quiet.lasted.tolist(), strict=True) if not lasted)
    poses = dict(zip(addresses, now, strict=True))
    moved = frozenset(push.other for push in pushes(first, poses) if push.distance > STAYS or push.tilt > STAYS_TILT)
    return LeftAlone(poses, Contacts(model).depths(data), uneasy, moved)


def blamed(settled: Settled, alone: LeftAlone) -> Settled:
    """A settle in which only that counts as pushed, pressed and restless what would not be so without the candidate.

    What falls anyway is not pushed by what it falls onto.
    """
    depths = {pair: depth for pair, depth in settled.depths.items() if depth > alone.depths.get(pair, 0.0) + DEEPER}
    motion = structs.replace(
        settled.motion,
        pushed=tuple(p for p in pushes(alone.poses, settled.poses) if p.other not in alone.unsteady),
        restless=not settled.uneasy <= alone.uneasy,
    )
    return settled._replace(motion=motion, depths=depths)
