"""Options of a model that make things stand better than they would in a real room, in sentences with their numbers."""

import math
from collections.abc import Callable, Sequence

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.triangles import colliding
from thinkblox.sim.subject import Thing

FRICTION = 1.5
"""Rubber on dry concrete reaches about 1."""
STEP = 0.005
GRAVITY, GRAVITY_SHARE = (0.0, 0.0, -9.81), 0.02
MARGIN = 0.001
SOFT = 0.03
_FREE = int(mujoco.mjtJoint.mjJNT_FREE)
_DISABLED = {
    mujoco.mjtDisableBit.mjDSBL_CONTACT: "Contacts are disabled: nothing carries or hits anything.",
    mujoco.mjtDisableBit.mjDSBL_CONSTRAINT: "All constraints are disabled: nothing carries or hits anything.",
    mujoco.mjtDisableBit.mjDSBL_GRAVITY: "Gravity is disabled: nothing falls.",
}


class _Model:
    """A model with the names of what its geoms, bodies and joints belong to."""

    def __init__(self, model: mujoco.MjModel, things: Sequence[Thing]) -> None:
        self.model, self.things = model, things
        self._owner = {body: thing.id for thing in things for body in thing.bodies}
        self.colliding = colliding(model)
        mine = np.isin(model.jnt_bodyid, [body for thing in things for body in thing.bodies])
        free = np.flatnonzero((model.jnt_type == _FREE) & mine)
        self.free_dofs = (model.jnt_dofadr[free][:, None] + np.arange(6)).astype(np.int64).reshape(-1, 6)
        self.free_bodies = model.jnt_bodyid[free]
        self.free_joints = free

    def of_bodies(self, bodies: NDArray[np.int64]) -> str:
        """The things that some bodies belong to, without the world."""
        return listed(self._names(bodies))

    def of_geoms(self, geoms: NDArray[np.int64]) -> str:
        """The things that some geoms belong to; the world's own geoms by their names."""
        bodies = self.model.geom_bodyid[geoms]
        own = [str(self.model.geom(int(g)).name) or f"geom {g}" for g in geoms[bodies == 0]]
        return listed([*self._names(bodies[bodies != 0]), *own])

    def _names(self, bodies: NDArray[np.int64]) -> list[str]:
        names = (self._owner.get(int(b)) or str(self.model.body(int(b)).name) or f"body {b}" for b in bodies)
        return list(dict.fromkeys(names))


def unusual_options(model: mujoco.MjModel, things: Sequence[Thing]) -> tuple[str, ...]:
    """What of a model's options keeps things standing, or cannot be seen to fall; one sentence for each kind."""
    described = _Model(model, things)
    return tuple(sentence for check in _CHECKS for sentence in check(described))


def _switches(m: _Model) -> list[str]:
    return [text for bit, text in _DISABLED.items() if m.model.opt.disableflags & int(bit)]


def _step(m: _Model) -> list[str]:
    step = m.model.opt.timestep
    return [f"The time step is coarse: {step * 1000:g} ms."] if step > STEP else []


def _gravity(m: _Model) -> list[str]:
    gravity = np.asarray(m.model.opt.gravity)
    if np.linalg.norm(gravity - GRAVITY) <= GRAVITY_SHARE * 9.81:
        return []
    return [f"Gravity is ({', '.join(f'{g:g}' for g in gravity)}) m/s2 instead of (0, 0, -9.81)."]


def _damping(m: _Model) -> list[str]:
    return _on_free(m, m.model.dof_damping, "Damping", "is added to the free motion of")


def _armature(m: _Model) -> list[str]:
    return _on_free(m, m.model.dof_armature, "Armature", "adds inertia to the free motion of")


def _loss(m: _Model) -> list[str]:
    return _on_free(m, m.model.dof_frictionloss, "Dry friction", "in the joint holds the free motion of")


def _on_free(m: _Model, values: NDArray[np.float64], what: str, does: str) -> list[str]:
    most = values[m.free_dofs].max(axis=1) if len(m.free_dofs) else np.zeros(0)
    found = most > 0.0
    if not found.any():
        return []
    return [f"{what} of up to {most.max():g} {does} {m.of_bodies(m.free_bodies[found])}."]


def _springs(m: _Model) -> list[str]:
    stiff = m.model.jnt_stiffness[m.free_joints]
    if not (stiff > 0.0).any():
        return []
    return [f"A spring of up to {stiff.max():g} N/m holds {m.of_bodies(m.free_bodies[stiff > 0.0])} where it is."]


def _gravcomp(m: _Model) -> list[str]:
    share = np.asarray(m.model.body_gravcomp)
    found = np.flatnonzero(share != 0.0)
    if not len(found):
        return []
    return [f"Gravity is compensated, by up to {np.abs(share).max():.0%}, on {m.of_bodies(found)}."]


def _friction(m: _Model) -> list[str]:
    sliding, sentences = m.model.geom_friction[:, 0], []
    found = np.flatnonzero(m.colliding & (sliding > FRICTION))
    if len(found):
        sentences.append(f"Friction is up to {sliding[found].max():g} on {m.of_geoms(found)}.")
    pairs = m.model.pair_friction[:, :2].max(axis=1) if m.model.npair else np.zeros(0)
    if (pairs > FRICTION).any():
        sentences.append(
            f"Friction is up to {pairs.max():g} between {np.count_nonzero(pairs > FRICTION)} pairs of geoms."
        )
    return sentences


def _margin(m: _Model) -> list[str]:
    reach = np.maximum(m.model.geom_margin, m.model.geom_gap)
    found = np.flatnonzero(m.colliding & (reach > MARGIN))
    if not len(found):
        return []
    return [f"Contacts reach out by a margin or gap of up to {reach[found].max() * 1000:g} mm at {m.of_geoms(found)}."]


def _override(m: _Model) -> list[str]:
    if not m.model.opt.enableflags & int(mujoco.mjtEnableBit.mjENBL_OVERRIDE):
        return []
    margin, soft = m.model.opt.o_margin, time_constant(np.asarray(m.model.opt.o_solref), 0.95)
    friction = m.model.opt.o_friction[0]
    values = f"margin {margin * 1000:g} mm, time constant {soft * 1000:.3g} ms, friction {friction:g}"
    return [f"One setting overrides every contact: {values}."]


def _soft(m: _Model) -> list[str]:
    times = np.array(
        [time_constant(s, float(i[1])) for s, i in zip(m.model.geom_solref, m.model.geom_solimp, strict=True)]
    )
    found = np.flatnonzero(m.colliding & (times > SOFT)) if len(times) else times
    if not len(found):
        return []
    return [f"Contacts are very soft, with time constants up to {times[found].max():.3g} s, at {m.of_geoms(found)}."]


def time_constant(solref: NDArray[np.float64], impedance: float) -> float:
    """Time constant of a contact [s] by its solref, also where that is (-stiffness, -damping).

    Source: MuJoCo documentation, Modeling, "Solver parameters".
    """
    first, second = float(solref[0]), float(solref[1])
    if first > 0.0:
        return first
    return 2.0 / (max(impedance, 1e-6) * -second) if second < 0.0 else math.inf


def _no_collision(m: _Model) -> list[str]:
    touchable = np.zeros(m.model.nbody, dtype=bool)
    touchable[m.model.geom_bodyid[m.colliding]] = True
    for flex in range(m.model.nflex):
        start, count = int(m.model.flex_vertadr[flex]), int(m.model.flex_vertnum[flex])
        touchable[m.model.flex_vertbodyid[start : start + count]] = True
    found = [thing.id for thing in m.things if not touchable[list(thing.bodies)].any()]
    return [f"No collision geometry, so nothing is measured of its contacts: {listed(found)}."] if found else []


def _noslip(m: _Model) -> list[str]:
    count = int(m.model.opt.noslip_iterations)
    return [f"The solver suppresses slip with {count} extra iterations (noslip)."] if count > 0 else []


def _fluid(m: _Model) -> list[str]:
    density, viscosity = float(m.model.opt.density), float(m.model.opt.viscosity)
    if density <= 0.0 and viscosity <= 0.0:
        return []
    return [f"Everything moves through a fluid of {density:g} kg/m3 and viscosity {viscosity:g} Pa s, which slows it."]


def _welds(m: _Model) -> list[str]:
    kinds = (int(mujoco.mjtEq.mjEQ_WELD), int(mujoco.mjtEq.mjEQ_CONNECT))
    held = []
    for eq in np.flatnonzero(np.isin(m.model.eq_type, kinds) & m.model.eq_active0.astype(bool)):
        first, second = equality_bodies(m.model, int(eq))
        fixed = [m.model.body_weldid[body] == 0 for body in (first, second)]
        if any(fixed) and not all(fixed):
            held.append(second if fixed[0] else first)
    bodies = np.array(sorted(set(held)), dtype=np.int64)
    return [f"An equality constraint holds {m.of_bodies(bodies)} to the world."] if held else []


def equality_bodies(model: mujoco.MjModel, eq: int) -> tuple[int, int]:
    """The two bodies of a weld or connect, be it between bodies or sites."""
    first, second = int(model.eq_obj1id[eq]), int(model.eq_obj2id[eq])
    if int(model.eq_objtype[eq]) == int(mujoco.mjtObj.mjOBJ_SITE):
        return int(model.site_bodyid[first]), int(model.site_bodyid[second])
    return first, max(second, 0)


def _sleep(m: _Model) -> list[str]:
    if not m.model.opt.enableflags & int(mujoco.mjtEnableBit.mjENBL_SLEEP):
        return []
    asleep = np.flatnonzero(m.model.tree_sleep_policy == int(mujoco.mjtSleepPolicy.mjSLEEP_INIT))
    if len(asleep):
        bodies = m.model.tree_bodyadr[asleep]
        return [f"The engine starts with {m.of_bodies(bodies)} asleep, and what sleeps does not fall."]
    return ["The engine may put things to sleep, and what sleeps does not creep."]


def _actuators(m: _Model) -> list[str]:
    kinds = mujoco.mjtTrn
    joints = (int(kinds.mjTRN_JOINT), int(kinds.mjTRN_JOINTINPARENT))
    of = {int(kinds.mjTRN_BODY): None, int(kinds.mjTRN_SITE): m.model.site_bodyid}
    bodies = []
    for kind, target in zip(m.model.actuator_trntype.tolist(), m.model.actuator_trnid[:, 0].tolist(), strict=True):
        if kind in joints:
            bodies.append(int(m.model.jnt_bodyid[target]))
        elif kind in of and target >= 0:
            sites = of[kind]
            bodies.append(target if sites is None else int(sites[target]))
    moved = np.array(sorted(set(bodies)), dtype=np.int64)
    return [f"{len(bodies)} actuators act on {m.of_bodies(moved)}."] if bodies else []


_CHECKS: tuple[Callable[[_Model], list[str]], ...] = (
    _switches, _gravity, _step, _no_collision, _damping, _armature, _loss, _springs, _gravcomp, _friction, _margin,
    _soft, _override, _noslip, _fluid, _welds, _sleep, _actuators,
)  # fmt: skip
