"""Which fixed things of a foreign model are its building, rather than its furniture."""

import re

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.subject import Thing

Floats = NDArray[np.float64]
WORDS = frozenset(
    "floor wall ceiling ground room roof column pillar beam baseboard skirting stair stairs door doorway window"
    " windowsill terrain building house rug carpet mat".split()
)
WALL_HEIGHT, WALL_THICKNESS = 2.0, 0.25
"""What is at least so high and at most so thick is a wall [m]."""
SLAB = 2.5
"""What covers a square of this side is a floor, a ceiling or a shell [m]."""
_OPEN = (int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD))


def is_structure(model: mujoco.MjModel, thing: Thing, low: Floats, high: Floats) -> bool:
    """Whether a thing is a part of the building.

    It cannot move, and one of these holds: a word of its name says so ("Wall_3", "kitchen floor"), it has a plane or a
    height field, it is high and thin, or it covers a large square of the floor.

    Args:
        model: compiled.
        thing: of the model.
        low: lowest corner of the bounding box of every geom of the model [m], shape (ngeom, 3).
        high: highest corner of the same.
    """
    bodies = list(thing.bodies)
    if model.body_jntnum[bodies].any():
        return False
    words = re.findall(r"[a-z]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", thing.id).lower())
    if any(word in WORDS or word.removesuffix("s") in WORDS for word in words):
        return True
    geoms = np.flatnonzero(np.isin(model.geom_bodyid, bodies))
    if not len(geoms):
        return False
    if np.isin(model.geom_type[geoms], _OPEN).any():
        return True
    across, up = np.split(high[geoms].max(axis=0) - low[geoms].min(axis=0), [2])
    return bool((up[0] >= WALL_HEIGHT and across.min() <= WALL_THICKNESS) or across.min() >= SLAB)
