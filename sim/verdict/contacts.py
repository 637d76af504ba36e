"""Which objects touch in a simulated state, how deep, and who carries whom."""

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.build import GROUND
from thinkblox.verdict import Support

LEAST_SHARE = 0.005
"""Shares of a weight below this are not listed."""


class Contacts:
    """Names every contact of a model by the objects that touch: placement ids, "floor" and the walls' names."""

    def __init__(self, model: mujoco.MjModel) -> None:
        of_body = [str(model.body(int(root)).name) for root in model.body_rootid]
        world = {geom: _part_of_room(model, geom) for geom in np.flatnonzero(model.geom_bodyid == 0).tolist()}
        names = [world.get(geom) or of_body[body] for geom, body in enumerate(model.geom_bodyid.tolist())]
        self.names = tuple(dict.fromkeys(names))
        self._number = {name: number for number, name in enumerate(self.names)}
        self._of_geom = np.array([self._number[name] for name in names], dtype=np.int64)
        self._model = model

    def depths(self, data: mujoco.MjData, *, deeper: float = 0.0) -> dict[tuple[str, str], float]:
        """Deepest contact of every pair that touches deeper than that [m]; a pair is in the order of `names`."""
        pairs, depth = self._pairs(data), -data.contact.dist
        found: dict[tuple[str, str], float] = {}
        for index in np.flatnonzero(depth > deeper):
            first, second = sorted(pairs[index])
            key = (self.names[first], self.names[second])
            found[key] = max(found.get(key, 0.0), float(depth[index]))
        return found

    def carriers_of(self, data: mujoco.MjData, id: str) -> dict[str, float]:
        """Upward force that each other thing holds an object up with [N]; loads from above are left out."""
        pairs = self._pairs(data)
        mine = pairs == self._number.get(id, -1)
        found = np.flatnonzero(mine[:, 0] != mine[:, 1])
        force = np.zeros((len(found), 6))
        for index, each in zip(found.tolist(), force, strict=True):
            mujoco.mj_contactForce(self._model, data, index, each)
        on_second = (data.contact.frame[found, 2::3] * force[:, :3]).sum(axis=1)
        second = mine[found, 1]
        others, ups = np.where(second, pairs[found, 0], pairs[found, 1]), np.where(second, on_second, -on_second)
        forces: dict[str, float] = {}
        for other, up in zip(others.tolist(), ups.tolist(), strict=True):
            forces[self.names[other]] = forces.get(self.names[other], 0.0) + up
        return {other: up for other, up in forces.items() if up > 0.0}

    def _pairs(self, data: mujoco.MjData) -> NDArray[np.int64]:
        numbers: NDArray[np.int64] = self._of_geom[data.contact.geom[: data.ncon]]
        return numbers


def shares(forces: dict[str, float], weight: float) -> tuple[Support, ...]:
    """Who carries an object with which share, largest first; of all that holds it up, or of its weight if that is more.

    Args:
        forces: upward force by each carrier [N].
        weight: of the object [N].
    """
    total = max(sum(forces.values()), weight)
    found = [Support(by=by, share=round(force / total, 4)) for by, force in forces.items()]
    return tuple(sorted((s for s in found if s.share >= LEAST_SHARE), key=lambda s: (-s.share, s.by)))


def _part_of_room(model: mujoco.MjModel, geom: int) -> str:
    name = str(model.geom(geom).name)
    return GROUND if name == GROUND else name.split("/")[0]
