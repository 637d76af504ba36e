"""Which objects of any model touch at a state, and how deep; also those that the engine does not collide."""

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.foreign.triangles import colliding
from thinkblox.sim.subject import Subject

Pair = tuple[str, str]


class Owners:
    """Names the geoms of a model: by the thing that they belong to, or by their own name where they are the world's."""

    def __init__(self, subject: Subject) -> None:
        self._subject, model = subject, subject.model
        self.things = {body: thing.id for thing in subject.things for body in thing.bodies}
        self.names = tuple(self._name(geom) for geom in range(model.ngeom))
        self.movable = model.body_weldid[model.geom_bodyid] != 0
        """Whether each geom can move."""

    def is_thing(self, name: str) -> bool:
        """Whether it is the id of one of the subject's things."""
        return name in self._ids

    @property
    def _ids(self) -> frozenset[str]:
        return frozenset(thing.id for thing in self._subject.things)

    def _name(self, geom: int) -> str:
        model = self._subject.model
        body = int(model.geom_bodyid[geom])
        if body in self.things:
            return self.things[body]
        named = str(model.geom(geom).name).split("/")[0] or str(model.body(body).name)
        return named or f"geom {geom}"

    def depths(self, model: mujoco.MjModel, data: mujoco.MjData, *, within: bool = False) -> dict[Pair, float]:
        """Deepest contact of every pair of names [m] by the engine, everything awake; gaps are left out.

        Args:
            model: the subject's, or a copy of it.
            data: the state; it is not changed.
            within: with contacts between two parts of one thing.
        """
        state = _awake(model, data)
        found: dict[Pair, float] = {}
        for (first, second), distance in zip(state.contact.geom, state.contact.dist, strict=True):
            pair = _ordered(self.names[first], self.names[second])
            if distance < 0.0 and (within or pair[0] != pair[1]):
                found[pair] = max(found.get(pair, 0.0), -float(distance))
        return found

    def fixed_depths(self, model: mujoco.MjModel, data: mujoco.MjData) -> dict[Pair, float]:
        """The same for pairs of things that are both fixed, which the engine does not collide with each other [m]."""
        mine = colliding(model) & ~self.movable & np.isin(model.geom_bodyid, list(self.things))
        found: dict[Pair, float] = {}
        for first, second in _near(model, data, np.flatnonzero(mine)):
            pair = _ordered(self.names[first], self.names[second])
            if pair[0] != pair[1]:
                distance = float(mujoco.mj_geomDistance(model, data, first, second, 0.0, None))
                if distance < 0.0:
                    found[pair] = max(found.get(pair, 0.0), -distance)
        return found


def _awake(model: mujoco.MjModel, data: mujoco.MjData) -> mujoco.MjData:
    """The same state with every contact in it: what sleeps has none."""
    flags = model.opt.enableflags
    model.opt.enableflags = flags & ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    state = mujoco.MjData(model)
    state.qpos[:] = data.qpos
    mujoco.mj_forward(model, state)
    model.opt.enableflags = flags
    return state


def _ordered(first: str, second: str) -> Pair:
    return (first, second) if first <= second else (second, first)


def _near(model: mujoco.MjModel, data: mujoco.MjData, geoms: NDArray[np.int64]) -> list[tuple[int, int]]:
    """Pairs of geoms whose bounding spheres overlap."""
    radius, centre = model.geom_rbound[geoms], data.geom_xpos[geoms]
    pairs: list[tuple[int, int]] = []
    for index in range(len(geoms) - 1):
        apart = np.linalg.norm(centre[index + 1 :] - centre[index], axis=1)
        close = np.flatnonzero(apart < radius[index + 1 :] + radius[index])
        pairs += [(int(geoms[index]), int(geoms[index + 1 + other])) for other in close]
    return pairs
