"""SceneEval's Collision: do the triangles of two objects meet, also when one is moved 5 mm away."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.foreign.triangles import collision_model
from thinkblox.sim.suites.criteria import criterion
from thinkblox.sim.suites.meshes import MeshedThing, Meshes
from thinkblox.suite import Criterion, Finding

APART = 0.005
"""How far one object is moved before it is tested again [m]."""
MOST_CONTACTS = 100_000


def collision(meshes: Meshes) -> Criterion:
    """Every pair of objects; what only rests on another comes free of it by the second test."""
    bodies = meshes.bodies
    models = {body.id: collision_model(body.triangles) for body in bodies}
    pairs = [(a, b) for a, b in _near(bodies) if _collide(a, b, models)]
    hit = {body.id for pair in pairs for body in pair}
    found = [Finding(object=f"{a.id} + {b.id}", value=None, passed=False) for a, b in pairs]
    found += [Finding(object=body.id, value=None, passed=True) for body in bodies if body.id not in hit]
    return criterion(
        "collision", "no two objects' triangles meet after one of them is moved 5 mm away from the other",
        [*found, *meshes.soft], unit="count", limit=0.0, value=float(len(hit)) if bodies else None,
    )  # fmt: skip


def _near(bodies: tuple[MeshedThing, ...]) -> list[tuple[MeshedThing, MeshedThing]]:
    """Pairs whose bounding boxes meet, in the order of the objects."""
    if not bodies:
        return []
    low = np.array([body.triangles.bounds[0] for body in bodies])
    high = np.array([body.triangles.bounds[1] for body in bodies])
    found = []
    for i, body in enumerate(bodies):
        meets = np.all((low[i + 1 :] <= high[i]) & (high[i + 1 :] >= low[i]), axis=1)
        found += [(body, bodies[i + 1 + int(k)]) for k in np.flatnonzero(meets)]
    return found


def _collide(first: MeshedThing, second: MeshedThing, models: dict[str, Any]) -> bool:
    points = _contacts(models[first.id], models[second.id], np.zeros(3))
    if not len(points):
        return False
    away = second.triangles.centroid - points.mean(axis=0)
    length = float(np.linalg.norm(away))
    shift = away * (APART / length) if length > 0.0 else np.zeros(3)
    return bool(len(_contacts(models[first.id], models[second.id], shift, most=1)))


def _contacts(first: Any, second: Any, shift: NDArray[np.float64], *, most: int = MOST_CONTACTS) -> NDArray[np.float64]:
    """Where the triangles of two meshes meet [m], shape (n, 3), the second one moved by `shift`."""
    import fcl

    request = fcl.CollisionRequest(num_max_contacts=most, enable_contact=True)
    answer = fcl.CollisionResult()
    fixed, moved = fcl.CollisionObject(first), fcl.CollisionObject(second, fcl.Transform(np.eye(3), shift))
    if not fcl.collide(fixed, moved, request, answer):
        return np.zeros((0, 3))
    return np.array([contact.pos for contact in answer.contacts]).reshape(-1, 3)
