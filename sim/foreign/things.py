"""Which bodies of any model are its objects, and what they are called."""

import mujoco
import numpy as np

from thinkblox.sim.subject import Thing

_FLEX = int(mujoco.mjtObj.mjOBJ_FLEX)


def things_of(model: mujoco.MjModel) -> tuple[Thing, ...]:
    """The objects of a model, in the order of their bodies, with names made up where there are none.

    The many bodies of a soft one (a flex) are one thing, called after it.
    """
    within: dict[int, list[int]] = {}
    root_of, soft = [0] * model.nbody, _soft_roots(model)
    for body in range(1, model.nbody):
        above = soft.get(body, root_of[int(model.body_parentid[body])])
        if above or model.body_jntnum[body] or model.body_geomnum[body]:
            root_of[body] = above or body
            within.setdefault(root_of[body], []).append(body)
    names = _unique_names(model, list(within), soft)
    return tuple(_thing(model, root, bodies, names[root]) for root, bodies in within.items())


def _soft_roots(model: mujoco.MjModel) -> dict[int, int]:
    """For every body that is nothing but a vertex of a flex, the first such body of that flex."""
    found: dict[int, int] = {}
    for flex in range(model.nflex):
        start, count = int(model.flex_vertadr[flex]), int(model.flex_vertnum[flex])
        bodies = np.unique(model.flex_vertbodyid[start : start + count])
        bodies = bodies[(model.body_parentid[bodies] == 0) & (model.body_geomnum[bodies] == 0) & (bodies > 0)]
        found |= {int(body): int(bodies[0]) for body in bodies}
    return found


def _unique_names(model: mujoco.MjModel, roots: list[int], soft: dict[int, int]) -> dict[int, str]:
    taken = {str(model.body(body).name) for body in range(model.nbody)}
    flexes = {
        soft[body]: mujoco.mj_id2name(model, _FLEX, flex) or "" for flex, body in _flex_bodies(model) if body in soft
    }
    names: dict[int, str] = {}
    for root in roots:
        name = flexes.get(root) or str(model.body(root).name) or f"body_{root}"
        while name != model.body(root).name and name in taken:
            name += "_"
        taken.add(name)
        names[root] = name
    return names


def _flex_bodies(model: mujoco.MjModel) -> list[tuple[int, int]]:
    return [(flex, int(model.flex_vertbodyid[model.flex_vertadr[flex]])) for flex in range(model.nflex)]


def _thing(model: mujoco.MjModel, root: int, bodies: list[int], name: str) -> Thing:
    joint = int(model.body_jntadr[root])
    free = joint >= 0 and int(model.jnt_type[joint]) == int(mujoco.mjtJoint.mjJNT_FREE)
    return Thing(id=name, root=root, bodies=tuple(bodies), free=free)
