"""Whether what has come to rest can only stay: then there is no need to wait and see."""

import math

import mujoco
import numpy as np
import shapely
from numpy.typing import NDArray

SLOW = 0.002
"""Slower than this is at rest [m/s]."""
SLOW_TURN = 0.005
"""The same for turning [rad/s], and for the joints of its doors."""
LEVEL = math.cos(math.radians(5.0))
"""Cosine of the steepest contact that counts as level."""
MARGIN = 0.005
"""How far the middle of what carries an object must be inside the polygon of its contacts [m]."""
CARRIED = 0.95
"""Least share of its weight that level contacts must carry."""
ASIDE = 0.02
"""Most that steep contacts may press on an object, as a share of its weight."""


def at_rest(model: mujoco.MjModel, data: mujoco.MjData, body: int) -> bool:
    """Whether a free body and its joints hardly move."""
    first = int(model.body_dofadr[body])
    speed = np.abs(data.qvel[first : first + int(model.tree_dofnum[model.body_treeid[body]])])
    return bool(speed[:3].max() < SLOW and speed[3:].max() < SLOW_TURN)


def stands_squarely(model: mujoco.MjModel, data: mujoco.MjData) -> bool:
    """Whether everything that is awake is at rest, and stands level and well inside the polygon of its contacts.

    Statics: where the middle of the pressure on each level footing is inside the footing, no small motion lifts any
    contact, and the whole stays as it is. What leans, lies in a hollow, stands on one foot, or has its weight near an
    edge, is left for the simulation to tell.
    """
    if float(np.abs(data.qvel).max(initial=0.0)) >= SLOW:
        return False
    contact = data.contact
    roots = model.body_rootid[model.geom_bodyid[contact.geom]]
    acting = np.flatnonzero((contact.efc_address >= 0) & (roots[:, 0] != roots[:, 1]))
    force, rise = data.efc_force[contact.efc_address[acting]], contact.frame[acting, 2]
    pressed = np.concatenate([roots[acting, 1], roots[acting, 0]])
    up, force = np.concatenate([rise, -rise]), np.concatenate([force, force])
    points = np.concatenate([contact.pos[acting, :2]] * 2)
    gravity = float(np.linalg.norm(model.opt.gravity))
    for body in _awake(model, data):
        mine, weight = pressed == body, float(model.body_subtreemass[body]) * gravity
        if not _well_footed(points[mine], force[mine], up[mine], weight):
            return False
    return True


def _awake(model: mujoco.MjModel, data: mujoco.MjData) -> list[int]:
    """The free bodies that are awake."""
    awake = np.flatnonzero(data.tree_asleep < 0)
    return [int(model.dof_bodyid[model.tree_dofadr[tree]]) for tree in awake]


def _well_footed(
    points: NDArray[np.float64], force: NDArray[np.float64], up: NDArray[np.float64], weight: float
) -> bool:
    """Whether one body's contacts (n), pressed with some force [N] in a direction that rises by `up`, carry it well."""
    below = (up >= LEVEL) & (force > 0.0)
    carried, aside = float(force[below].sum()), float(force[np.abs(up) < LEVEL].sum())
    if weight <= 0.0 or carried < CARRIED * weight or aside > ASIDE * weight:
        return False
    polygon = shapely.convex_hull(shapely.multipoints(points[below]))
    middle = shapely.points(force[below] @ points[below] / carried)
    if not isinstance(polygon, shapely.Polygon) or not shapely.contains(polygon, middle):
        return False
    return bool(shapely.distance(polygon.exterior, middle) >= MARGIN)
