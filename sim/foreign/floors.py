"""A floor for models that have none under what would fall for ever."""

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.build import GROUND
from thinkblox.sim.foreign.geom_volumes import lowest_point
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.triangles import colliding
from thinkblox.sim.subject import Thing

Floats = NDArray[np.float64]
MARGIN, DEPTH = 5.0, 0.5
"""How far the floor reaches beyond what stands on it, and how thick it is [m]."""
_OPEN = (int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD))


@dataclass(frozen=True)
class NeededFloor:
    """A floor that a model lacks.

    Attributes:
        height: of its top, the lowest point of all that can be touched [m].
        note: that it was put there and why, in a sentence.
    """

    height: float
    note: str


def needed_floor(model: mujoco.MjModel, data: mujoco.MjData, things: tuple[Thing, ...]) -> NeededFloor | None:
    """The floor that a model needs, None where it needs none.

    It is where a free thing has nothing under it that reaches lower than itself does; planes and height fields are
    taken to be under everything.

    Args:
        model: compiled.
        data: at its start.
        things: of the model.
    """
    geoms = np.flatnonzero(colliding(model))
    free = [thing for thing in things if thing.free]
    if not free or not len(geoms) or np.isin(model.geom_type[geoms], _OPEN).any():
        return None
    low, high, bodies = *_bounds(model, data, geoms), model.geom_bodyid[geoms]
    over_nothing = [thing for thing in free if _over_nothing(np.isin(bodies, thing.bodies), low, high)]
    if not over_nothing:
        return None
    height, falling = float(low[:, 2].min()), listed([thing.id for thing in over_nothing])
    movable = [body for thing in free for body in thing.bodies]
    if _are_over(~np.isin(bodies, movable), [np.isin(bodies, thing.bodies) for thing in over_nothing], low, high):
        lacks = f"Nothing fixed reaches lower than {falling}"
    else:
        lacks = "The model has no floor" if len(over_nothing) == len(free) else f"Nothing is under {falling}"
    return NeededFloor(height, f"{lacks}: a floor was put under the model's lowest point, at z = {height:.3f} m.")


def _over_nothing(mine: NDArray[np.bool_], low: Floats, high: Floats) -> bool:
    """Whether no geom that is not among these reaches lower than they do, within the rectangle round them."""
    if not mine.any():
        return False
    bottom = low[mine, 2].min()
    return not bool((~mine & _within(mine, low, high) & (low[:, 2] < bottom)).any())


def _are_over(fixed: NDArray[np.bool_], falling: list[NDArray[np.bool_]], low: Floats, high: Floats) -> bool:
    """Whether something fixed is within the rectangles round all of these, which then reach through it."""
    return all((fixed & _within(mine, low, high)).any() for mine in falling)


def _within(mine: NDArray[np.bool_], low: Floats, high: Floats) -> NDArray[np.bool_]:
    """Which geoms are within the rectangle round these."""
    (x0, y0, _), (x1, y1, _) = low[mine].min(axis=0), high[mine].max(axis=0)
    inside: NDArray[np.bool_] = (low[:, 0] <= x1) & (high[:, 0] >= x0) & (low[:, 1] <= y1) & (high[:, 1] >= y0)
    return inside


def _bounds(model: mujoco.MjModel, data: mujoco.MjData, geoms: NDArray[np.int64]) -> tuple[Floats, Floats]:
    """Corners of boxes round geoms [m], shape (n, 3) each: their spheres, and their own lowest points."""
    middle, reach = data.geom_xpos[geoms], model.geom_rbound[geoms, None]
    low, high = middle - reach, middle + reach
    low[:, 2] = [lowest_point(model, data, int(geom)) for geom in geoms]
    return low, high


def add_floor(spec: mujoco.MjSpec, model: mujoco.MjModel, data: mujoco.MjData, height: float) -> None:
    """Put a floor into a spec, its top at a height [m], under all that its compiled model can touch.

    It is a box, as in our own rooms: the engine's plane throws upright cylinders up. Whatever the model's defaults
    say of geoms, everything that can be touched meets it.
    """
    touchable = np.flatnonzero(colliding(model))
    reach = float((np.abs(data.geom_xpos[touchable, :2]) + model.geom_rbound[touchable, None]).max()) + MARGIN
    taken = {str(model.geom(geom).name) for geom in range(model.ngeom)}
    name = GROUND
    while name in taken:
        name += "_"
    floor = spec.worldbody.add_geom(name=name, type=mujoco.mjtGeom.mjGEOM_BOX)
    floor.size, floor.pos = (reach, reach, DEPTH / 2), (0.0, 0.0, height - DEPTH / 2)
    floor.contype = int(np.bitwise_or.reduce(model.geom_conaffinity[touchable])) or 1
    floor.conaffinity = int(np.bitwise_or.reduce(model.geom_contype[touchable])) or 1
    floor.condim, floor.margin, floor.gap, floor.group = 3, 0.0, 0.0, 0
    floor.friction = (1.0, 0.005, 0.0001)
