"""Who touches whom in any model, how deep, who carries whom, and which contacts the engine is told not to see."""

import itertools

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.build import GROUND
from thinkblox.sim.foreign.triangles import colliding
from thinkblox.sim.subject import Subject

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Pair = tuple[int, int]
MOST_PAIRS = 50_000
"""Of geoms whose distance is worked out one by one."""
LEVEL = 0.98
"""Least cosine of the angle between a floor's normal and the vertical."""
_FLAT = (int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD))


class ModelContacts:
    """The contacts of a subject, between owners: its things, by their index, its robots, and the world's own geoms.

    Attributes:
        names: of the owners; geoms of the world by the part of their name before "/", as walls are cut to pieces so.
        of_geom: owner of every geom.
        cut: whether so many boxes overlap that some distances were not worked out.
    """

    def __init__(self, subject: Subject) -> None:
        self._model, self._count = subject.model, len(subject.things)
        known = (*subject.things, *subject.robots)
        thing_of = {body: number for number, thing in enumerate(known) for body in thing.bodies}
        world: dict[str, int] = {}
        owners = []
        for geom, body in enumerate(subject.model.geom_bodyid.tolist()):
            name = _world_name(subject.model, geom)
            owners.append(thing_of[body] if body in thing_of else len(known) + world.setdefault(name, len(world)))
        self.of_geom: Ints = np.array(owners, dtype=np.int64)
        self.names = (*(thing.id for thing in known), *world)
        self._of_flex = _flex_owners(subject.model, thing_of)
        self.touchable = colliding(subject.model)
        self.cut = False
        self._fixed = subject.model.body_weldid[subject.model.geom_bodyid] == 0

    def is_thing(self, owner: int) -> bool:
        """Whether an owner is a thing, and not a part of the world."""
        return owner < self._count

    def depths(self, data: mujoco.MjData) -> dict[Pair, float]:
        """Deepest contact of every pair of owners, and of every owner with itself [m]; gaps are left out."""
        found: dict[Pair, float] = {}
        depth = -np.asarray(data.contact.dist)
        for index in np.flatnonzero(depth > 0.0):
            first, second = sorted(self._owners(data, int(index)))
            found[first, second] = max(found.get((first, second), 0.0), float(depth[index]))
        return found

    def carried(self, data: mujoco.MjData, up: Floats) -> dict[int, dict[int, float]]:
        """For every thing the force along `up` that each other owner holds it up with [N]."""
        found: dict[int, dict[int, float]] = {}
        force = np.zeros(6)
        for index in range(data.ncon):
            first, second = self._owners(data, index)
            if first == second:
                continue
            mujoco.mj_contactForce(self._model, data, index, force)
            on_second = float(up @ (data.contact.frame[index].reshape(3, 3).T @ force[:3]))
            for owner, other, push in ((second, first, on_second), (first, second, -on_second)):
                found.setdefault(owner, {}).setdefault(other, 0.0)
                found[owner][other] += push
        return {owner: {other: push for other, push in by.items() if push > 0.0} for owner, by in found.items()}

    def fixed_depths(self, data: mujoco.MjData, owners: set[int]) -> dict[Pair, float]:
        """How deep fixed things are in one another, which the engine does not collide [m]."""
        geoms = np.flatnonzero(self.touchable & self._fixed & np.isin(self.of_geom, list(owners)))
        return self._measured(data, self._near(data, geoms))

    def masked(self) -> tuple[int, list[Pair]]:
        """How many pairs of owners could touch but are told never to, and which, as far as there is room for them.

        By contype and conaffinity, by excludes between all their bodies, or because contacts are disabled. Pairs that
        cannot move towards each other are left out.
        """
        kinds = self._kinds()
        classes, of_owner, sizes = np.unique(kinds, axis=0, return_inverse=True, return_counts=True)
        blind = _blind(classes)
        pairs_of = np.triu(np.outer(sizes, sizes), 1) + np.diag(sizes * (sizes - 1) // 2)
        count, found = int((pairs_of * blind).sum()), self._excluded()
        for first, second in np.argwhere(np.triu(blind)):
            mine, theirs = np.flatnonzero(of_owner == first), np.flatnonzero(of_owner == second)
            every = ((int(a), int(b)) for a in mine for b in theirs if a < b or first != second)
            found |= {(min(pair), max(pair)) for pair in itertools.islice(every, MOST_PAIRS)}
        paired = {
            self._pair(int(a), int(b)) for a, b in zip(self._model.pair_geom1, self._model.pair_geom2, strict=True)
        }
        left = sorted(found - paired)
        return len(left) if count <= MOST_PAIRS else count, left

    def _kinds(self) -> Ints:
        """Contype and conaffinity of all geoms of each owner together, and whether it is solid and can move."""
        model = self._model
        on = not model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        bits = [self._bits(values * on) for values in (model.geom_contype, model.geom_conaffinity)]
        return np.column_stack([*bits, self._bits(self.touchable), self._bits(self.touchable & ~self._fixed)])

    def overlaps(self, data: mujoco.MjData, pairs: list[Pair]) -> dict[Pair, float]:
        """How deep pairs of owners are in one another, whatever the engine sees [m]; only those that are."""
        wanted = set(pairs)
        near = self._near(data, np.flatnonzero(self.touchable & np.isin(self.of_geom, np.array(pairs).ravel())))
        return self._measured(data, [(a, b) for a, b in near if self._pair(a, b) in wanted])

    def bounds(self, data: mujoco.MjData) -> tuple[Floats, Floats]:
        """Lowest and highest corner of every geom's bounding box [m], shape (ngeom, 3) each; infinite for planes."""
        turn = data.geom_xmat.reshape(-1, 3, 3)
        box = self._model.geom_aabb
        middle = data.geom_xpos + np.einsum("gij,gj->gi", turn, box[:, :3])
        half = np.einsum("gij,gj->gi", np.abs(turn), box[:, 3:])
        half[np.isin(self._model.geom_type, _FLAT)] = np.inf
        return middle - half, middle + half

    def _owners(self, data: mujoco.MjData, contact: int) -> Pair:
        geoms, flexes = data.contact.geom[contact], data.contact.flex[contact]
        first, second = (
            int(self.of_geom[geom]) if geom >= 0 else self._of_flex[int(flex)]
            for geom, flex in zip(geoms, flexes, strict=True)
        )
        return first, second

    def _pair(self, first: int, second: int) -> Pair:
        a, b = sorted((int(self.of_geom[first]), int(self.of_geom[second])))
        return a, b

    def _bits(self, values: NDArray[np.int32] | NDArray[np.bool_]) -> Ints:
        """The bits of all geoms of every owner together."""
        found = np.zeros(len(self.names), dtype=np.int64)
        np.bitwise_or.at(found, self.of_geom, values.astype(np.int64))
        return found

    def _excluded(self) -> set[Pair]:
        model, solid = self._model, np.flatnonzero(self.touchable)
        bodies: dict[int, set[int]] = {}
        for geom in solid.tolist():
            bodies.setdefault(int(self.of_geom[geom]), set()).add(int(model.geom_bodyid[geom]))
        owner_of = {body: owner for owner, held in bodies.items() for body in held if body}
        excluded = {(int(s) >> 16, int(s) & 0xFFFF) for s in model.exclude_signature}
        pairs = {(owner_of[a], owner_of[b]) for a, b in excluded if a in owner_of and b in owner_of}
        return {
            (min(a, b), max(a, b))
            for a, b in pairs
            if a != b
            and all((p, q) in excluded or (q, p) in excluded for p, q in itertools.product(bodies[a], bodies[b]))
        }

    def _near(self, data: mujoco.MjData, geoms: Ints) -> list[Pair]:
        """Pairs of geoms of different owners whose bounding boxes overlap."""
        low, high = self.bounds(data)
        order = geoms[np.argsort(low[geoms, 0], kind="stable")]
        found: list[Pair] = []
        for index, geom in enumerate(order.tolist()):
            rest = order[index + 1 :]
            rest = rest[: np.searchsorted(low[rest, 0], high[geom, 0], side="right")]
            close = (low[rest] <= high[geom]).all(axis=1) & (high[rest] >= low[geom]).all(axis=1)
            found += [(geom, int(other)) for other in rest[close] if self.of_geom[other] != self.of_geom[geom]]
            if len(found) > MOST_PAIRS:
                self.cut = True
                break
        return found[:MOST_PAIRS]

    def _measured(self, data: mujoco.MjData, geoms: list[Pair]) -> dict[Pair, float]:
        found: dict[Pair, float] = {}
        for first, second in geoms:
            if any(int(self._model.geom_type[geom]) in _FLAT for geom in (first, second)):
                continue
            distance = float(mujoco.mj_geomDistance(self._model, data, first, second, 0.0, None))
            if distance < 0.0:
                pair = self._pair(first, second)
                found[pair] = max(found.get(pair, 0.0), -distance)
        return found


def _blind(classes: Ints) -> NDArray[np.bool_]:
    """Which kinds of owners never meet, though both are solid and one moves; shape (kinds, kinds)."""
    contype, conaffinity, solid, moves = (classes[:, k] for k in range(4))
    meets = (contype[:, None] & conaffinity) | (conaffinity[:, None] & contype)
    return np.asarray((meets == 0) & (solid[:, None] & solid > 0) & (moves[:, None] | moves > 0))


def _world_name(model: mujoco.MjModel, geom: int) -> str:
    """The name of a geom of the world, or what it is: "floor" for a level plane, else such as "box_7"."""
    name = str(model.geom(geom).name).split("/")[0]
    kind = mujoco.mjtGeom(int(model.geom_type[geom])).name.removeprefix("mjGEOM_").lower()
    _, x, y, _ = model.geom_quat[geom]
    level = kind == "plane" and 1.0 - 2.0 * (x * x + y * y) > LEVEL
    return name or (GROUND if level else f"{kind}_{geom}")


def _flex_owners(model: mujoco.MjModel, thing_of: dict[int, int]) -> list[int]:
    starts = model.flex_vertadr.tolist()
    return [thing_of.get(int(model.flex_vertbodyid[start]), 0) for start in starts]
