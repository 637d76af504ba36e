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
from thinkblox.sim.verdict.stillness import stayed

DEEPER = 0.0001
"""By how much more than without the candidate things must touch to be pressed by it [m]."""


class LeftAlone(NamedTuple):
    """What becomes of a part of a room in which nothing is put.

    Attributes:
        poses: of its free bodies at the end, by name: position and quaternion wxyz.
        depths: deepest contact of every two things that touch at the end [m].
    """

    poses: Poses
    depths: Depths


@quiet_engine()
def left_alone(spec: mujoco.MjSpec, physics: Physics) -> LeftAlone:
    """Let everything go until it stands squarely, or until the time of a settle is over."""
    model = compiled(spec)
    data = mujoco.MjData(model)
    addresses, interval = free_addresses(model), physics.timestep * physics.chunk
    places = np.array(list(addresses.values()), dtype=np.intp)[:, None] + np.arange(7)
    now = data.qpos[places]
    for _ in range(math.ceil(physics.settle_time / interval - 1e-9)):
        mujoco.mj_step(model, data, nstep=physics.chunk)
        before, now = now, data.qpos[places]
        if diverged(data) or (stayed(before, now, interval) and stands_squarely(model, data)):
            break
    return LeftAlone(dict(zip(addresses, now, strict=True)), Contacts(model).depths(data))


def blamed(settled: Settled, alone: LeftAlone) -> Settled:
    """A settle in which only that counts as pushed and pressed what would not be so without the candidate."""
    depths = {pair: depth for pair, depth in settled.depths.items() if depth > alone.depths.get(pair, 0.0) + DEEPER}
    motion = structs.replace(settled.motion, pushed=pushes(alone.poses, settled.poses))
    return settled._replace(motion=motion, depths=depths)
