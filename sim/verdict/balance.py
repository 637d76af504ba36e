"""Whether what has come to rest can only stay: then there is no need to wait and see."""

import math

import mujoco
import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.sim.verdict.stillness import SLOW, SLOW_TURN

LEVEL = math.cos(math.radians(5.0))
"""Cosine of the steepest contact that counts as level."""
MARGIN = 0.005
"""How far the middle of what carries an object must be inside the polygon of its contacts [m]."""
LEANS = 0.04
"""And how far for every metre that anything above it is high: what stands so does not fall for leaning 2 degrees."""
FIRM = 10.0
"""Contacts give way by what they are deep: margin squared must exceed depth times height so many times.

A body that leans by an angle a presses the contacts at its margin m in by a m, which rights it by weight a m^2 / depth;
its weight at a height h upsets it by weight a h.
"""
CARRIED = 0.95
"""Least share of its weight that level contacts must carry."""
ASIDE = 0.02
"""Most that steep contacts may press on an object, as a share of its weight."""


def at_rest(model: mujoco.MjModel, data: mujoco.MjData, body: int) -> bool:
    """Whether a body with all that hangs on it hardly moves; it is free, or hangs on a joint of its own."""
    first = int(model.body_dofadr[body])
    speed = np.abs(data.qvel[first : first + int(model.tree_dofnum[model.body_treeid[body]])])
    return bool(speed[:3].max() < SLOW and speed[3:].max(initial=0.0) < SLOW_TURN)


def stands_squarely(model: mujoco.MjModel, data: mujoco.MjData) -> bool:
    """Whether everything that is awake is at rest, and stands level and well inside the polygon of its contacts."""
    return unsteady(model, data) is None


def unsteady(model: mujoco.MjModel, data: mujoco.MjData, *, suspect: int = 0) -> int | None:
    """A body that moves, or does not stand level and well inside the polygon of its contacts; None where all do.

    `suspect` is looked at before the others: what did not stand at one look mostly does not at the next.

    Statics: where the middle of the pressure on each level footing is inside the footing, by more the higher anything
    stands over it and the softer its contacts are, no small motion lifts any contact, and the whole stays as it is.
    What leans, lies in a hollow, stands on one foot, or has its weight near an edge, is left for the simulation.
    """
    awake = _awake(model, data)
    if float(np.abs(data.qvel).max(initial=0.0)) >= SLOW_TURN or not all(at_rest(model, data, b) for b in awake):
        return suspect
    contact = data.contact
    roots = model.body_rootid[model.geom_bodyid[contact.geom]]
    acting = np.flatnonzero((contact.efc_address >= 0) & (roots[:, 0] != roots[:, 1]))
    force, rise = data.efc_force[contact.efc_address[acting]], contact.frame[acting, 2]
    pressed = np.concatenate([roots[acting, 1], roots[acting, 0]])
    by = np.concatenate([roots[acting, 0], roots[acting, 1]])
    up, force = np.concatenate([rise, -rise]), np.concatenate([force, force])
    points = np.concatenate([contact.pos[acting]] * 2)
    depth = np.concatenate([-contact.dist[acting]] * 2)
    gravity = float(np.linalg.norm(model.opt.gravity))
    top = _tops(data.subtree_com[:, 2], pressed[up >= LEVEL], by[up >= LEVEL])
    for body in sorted(awake, key=lambda body: body != suspect):
        mine, weight = pressed == body, float(model.body_subtreemass[body]) * gravity
        margin = _margin(points[mine, :2], force[mine], up[mine], weight)
        height = top[body] - points[mine, 2].min(initial=top[body])
        if margin < _least_margin(float(height), float(depth[mine].max(initial=0.0))):
            return body
    return None


def _tops(heights: NDArray[np.float64], carried: NDArray[np.int32], by: NDArray[np.int32]) -> NDArray[np.float64]:
    """Of every body the height of the highest middle of mass among itself and all that it carries [m]."""
    tops, before = heights.copy(), None
    while before is None or not np.array_equal(tops, before):
        before = tops.copy()
        np.maximum.at(tops, by, tops[carried])
    return tops


def _least_margin(height: float, depth: float) -> float:
    """What a footing must have with something so high over it, and contacts so deep [m]."""
    return max(MARGIN, LEANS * height, math.sqrt(FIRM * depth * max(0.0, height)))


def _awake(model: mujoco.MjModel, data: mujoco.MjData) -> list[int]:
    """The free bodies that are awake."""
    awake = np.flatnonzero(data.tree_asleep < 0)
    return [int(model.dof_bodyid[model.tree_dofadr[tree]]) for tree in awake]


def _margin(points: NDArray[np.float64], force: NDArray[np.float64], up: NDArray[np.float64], weight: float) -> float:
    """How far the middle of what carries a body is inside the polygon of its contacts [m]; less than 0 for no answer.

    The contacts (n) press with some force [N] in a direction that rises by `up`.
    """
    below = (up >= LEVEL) & (force > 0.0)
    carried, aside = float(force[below].sum()), float(force[np.abs(up) < LEVEL].sum())
    if weight <= 0.0 or carried < CARRIED * weight or aside > ASIDE * weight:
        return -1.0
    polygon = shapely.convex_hull(shapely.multipoints(points[below]))
    middle = shapely.points(force[below] @ points[below] / carried)
    if not isinstance(polygon, shapely.Polygon) or not shapely.contains(polygon, middle):
        return -1.0
    return float(shapely.distance(polygon.exterior, middle))
