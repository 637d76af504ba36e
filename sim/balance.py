"""Whether something that has come to rest can only stay: then there is no need to wait and see."""

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
"""How far the centre of mass must be inside the polygon of its contacts [m]."""
CARRIED = 0.95
"""Least share of its weight that level contacts with the room must carry."""


def at_rest(model: mujoco.MjModel, data: mujoco.MjData, body: int) -> bool:
    """Whether a free body and its joints hardly move."""
    first = int(model.body_dofadr[body])
    speed = np.abs(data.qvel[first : first + int(model.tree_dofnum[model.body_treeid[body]])])
    return bool(speed[:3].max() < SLOW and speed[3:].max() < SLOW_TURN)


def stands_squarely(model: mujoco.MjModel, data: mujoco.MjData, body: int) -> bool:
    """Whether a free body at rest is carried by immovable, level ground on all sides of its centre of mass.

    Statics: with the centre of mass above the polygon of its contacts, a small motion only raises it. What stands on
    something that can move, leans, or stands with its centre of mass near an edge is left for the simulation to tell.
    """
    contact = data.contact
    roots = model.body_rootid[model.geom_bodyid[contact.geom]]
    mine = roots == body
    touching = np.flatnonzero(mine.any(axis=1) & (contact.efc_address >= 0))
    if not len(touching):
        return False
    other = np.where(mine[touching, 0], roots[touching, 1], roots[touching, 0])
    force = data.efc_force[contact.efc_address[touching]]
    pressing = force > 0.0
    if np.any(model.body_weldid[other[pressing]] != 0):
        return False
    level = pressing & (np.abs(contact.frame[touching, 2]) >= LEVEL)
    weight = float(model.body_subtreemass[body]) * float(np.linalg.norm(model.opt.gravity))
    if weight <= 0.0 or float(force[level].sum()) < CARRIED * weight:
        return False
    return _inside(data.subtree_com[body, :2], contact.pos[touching[level], :2])


def _inside(centre: NDArray[np.float64], points: NDArray[np.float64]) -> bool:
    polygon = shapely.convex_hull(shapely.multipoints(points))
    middle = shapely.points(centre)
    if not isinstance(polygon, shapely.Polygon) or not shapely.contains(polygon, middle):
        return False
    return bool(shapely.distance(polygon.exterior, middle) >= MARGIN)
