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
        names = [_owner(model, geom) for geom in range(model.ngeom)]
        self.names = tuple(dict.fromkeys(names))
        self._number = {name: number for number, name in enumerate(self.names)}
        self._of_geom = np.array([self._number[name] for name in names], dtype=np.int64)
        self._model = model

    def depths(self, data: mujoco.MjData) -> dict[tuple[str, str], float]:
        """Deepest contact of every touching pair [m]; a pair is in the order of `names`; gaps are left out."""
        pairs, depth = self._pairs(data), -data.contact.dist
        found: dict[tuple[str, str], float] = {}
        for index in np.flatnonzero(depth > 0.0):
            first, second = sorted(pairs[index])
            key = (self.names[first], self.names[second])
            found[key] = max(found.get(key, 0.0), float(depth[index]))
        return found

    def depths_of(self, data: mujoco.MjData, id: str) -> dict[str, float]:
        """Deepest contact of one object with each other thing [m]."""
        return {
            (second if first == id else first): depth
            for (first, second), depth in self.depths(data).items()
            if id in (first, second) and first != second
        }

    def carriers(self, data: mujoco.MjData) -> dict[str, dict[str, float]]:
        """For each object the vertical force that each other thing holds it up with [N]; loads from above left out."""
        pairs, up = self._pairs(data), self._vertical_forces(data)
        forces: dict[str, dict[str, float]] = {}
        for (first, second), force in zip(pairs, up, strict=True):
            if first != second:
                _add(forces, self.names[second], self.names[first], force)
                _add(forces, self.names[first], self.names[second], -force)
        return {id: {by: f for by, f in others.items() if f > 0.0} for id, others in forces.items()}

    def _pairs(self, data: mujoco.MjData) -> NDArray[np.int64]:
        numbers: NDArray[np.int64] = self._of_geom[data.contact.geom[: data.ncon]]
        return numbers

    def _vertical_forces(self, data: mujoco.MjData) -> list[float]:
        """Upward force of every contact on its second geom [N]."""
        force, up = np.zeros(6), []
        for index in range(data.ncon):
            mujoco.mj_contactForce(self._model, data, index, force)
            up.append(float(data.contact.frame[index].reshape(3, 3)[:, 2] @ force[:3]))
        return up


def shares(forces: dict[str, float], weight: float) -> tuple[Support, ...]:
    """Who carries an object with which share, largest first; of all that holds it up, or of its weight if that is more.

    Args:
        forces: upward force by each carrier [N].
        weight: of the object [N].
    """
    total = max(sum(forces.values()), weight)
    found = [Support(by=by, share=round(force / total, 4)) for by, force in forces.items()]
    return tuple(sorted((s for s in found if s.share >= LEAST_SHARE), key=lambda s: (-s.share, s.by)))


def _add(forces: dict[str, dict[str, float]], id: str, by: str, force: float) -> None:
    of_id = forces.setdefault(id, {})
    of_id[by] = of_id.get(by, 0.0) + force


def _owner(model: mujoco.MjModel, geom: int) -> str:
    body = int(model.geom_bodyid[geom])
    if body:
        return str(model.body(int(model.body_rootid[body])).name)
    name = str(model.geom(geom).name)
    return GROUND if name == GROUND else name.split("/")[0]
