"""Masses of a USD stage's bodies by the rules of UsdPhysics: what is authored, else what their colliders weigh."""

from collections.abc import Iterable
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray
from pxr import UsdPhysics, UsdShade

from thinkblox.errors import InputError
from thinkblox.sim.foreign.inertias import LEAST, SLACK, WATER
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.usd_frames import Frames, rigid
from thinkblox.sim.foreign.usd_values import number_of, numbers_of, turn_of

Floats = NDArray[np.float64]
ALONE = 1.0
"""Mass of what moves, says none and has no colliders [kg], as in PhysX."""
_BALL = 0.1
"""Radius of the ball whose inertia stands for that of a body without colliders [m]."""


class Masses:
    """What the bodies of one stage weigh.

    A body's mass is what it says, else the sum over its colliders of their mass, or their volume times the density
    that they, the body or their material say, or else that of water. Its centre and inertia are what it says, else
    those of its colliders.
    """

    def __init__(self, frames: Frames) -> None:
        self._frames = frames
        self._asked: dict[str, tuple[Any, Any]] = {}
        self._raised: list[str] = []
        self._alone: list[str] = []

    def weigh(self, body: mujoco.MjsBody, prim: Any, colliders: Iterable[tuple[Any, list[mujoco.MjsGeom]]]) -> None:
        """Give a body its mass, or its geoms what it follows from; `finish` must come after the last body."""
        said = _said(prim, self._frames)
        mass, _, inertia, _ = said
        pairs = [(collider, geoms) for collider, geoms in colliders if geoms]
        if mass is not None and inertia is not None:
            self._set(body, prim, said, np.zeros(3))
        elif not pairs:
            mass = ALONE if mass is None else mass
            if mass == ALONE:
                self._alone.append(str(prim.GetPath()))
            self._set(body, prim, (mass, said[1], np.full(3, 0.4 * mass * _BALL**2), None), np.zeros(3))
        else:
            for collider, geoms in pairs:
                self._fill(prim, collider, geoms)
            if any(value is not None for value in said):
                self._asked[body.name] = (body, prim)

    def finish(self, spec: mujoco.MjSpec) -> None:
        """Bring what follows from colliders to what bodies say of themselves."""
        if not self._asked:
            return
        model = spec.compile()
        for name, (body, prim) in self._asked.items():
            found = model.body(name)
            mass, centre, inertia, axes = _said(prim, self._frames)
            had = float(found.mass[0])
            total = had if mass is None else mass
            if inertia is None:
                inertia, axes = np.array(found.inertia) * (total / had), np.array(found.iquat)
            self._set(body, prim, (total, centre, inertia, axes), np.array(found.ipos))

    def notes(self) -> tuple[str, ...]:
        """What was done to what no body can have."""
        notes = []
        if self._raised:
            notes.append(
                f"No body has the inertia of {listed(self._raised)}: the two smaller moments were raised until"
                " A + B >= C."
            )
        if self._alone:
            notes.append(f"Without mass and colliders, taken as {ALONE:g} kg: {listed(self._alone)}.")
        return tuple(notes)

    def _fill(self, prim: Any, collider: Any, geoms: list[mujoco.MjsGeom]) -> None:
        mass, density = _own(collider)
        if mass is not None:
            # Of several pieces each has its share; none is known to be larger than the others.
            for geom in geoms:
                geom.mass = mass * self._frames.kilogram / len(geoms)
            return
        for value in (density, _own(prim)[1], _of_material(collider)):
            if value is not None:
                density = value * self._frames.kilogram / self._frames.metre**3
                break
        for geom in geoms:
            geom.density = WATER if density is None else density

    def _set(self, body: mujoco.MjsBody, prim: Any, said: tuple[Any, Any, Any, Any], centre: Floats) -> None:
        mass, own, inertia, axes = said
        moments = np.maximum(np.asarray(inertia, np.float64), LEAST)
        order = np.argsort(moments)
        lack = moments[order[2]] - moments[order[0]] - moments[order[1]]
        if lack > 1e-6 * moments[order[2]]:
            moments[order[:2]] += lack * (0.5 + SLACK)
            self._raised.append(str(prim.GetPath()))
        body.explicitinertial, body.mass, body.inertia = True, max(float(mass), LEAST), moments
        body.ipos = centre if own is None else own
        body.iquat = (1.0, 0.0, 0.0, 0.0) if axes is None else axes


def _own(prim: Any) -> tuple[float | None, float | None]:
    """Mass and density that a prim says, in the stage's units; 0 says nothing."""
    if not prim.HasAPI(UsdPhysics.MassAPI):
        return None, None
    api = UsdPhysics.MassAPI(prim)
    values = []
    for what, attribute in (("mass", api.GetMassAttr()), ("density", api.GetDensityAttr())):
        value = number_of(attribute, 0.0)
        if not 0.0 <= value < np.inf:
            raise InputError(f"{prim.GetPath()}: has a {what} of {value:g}; it must be 0 or more")
        values.append(value or None)
    return values[0], values[1]


def _said(prim: Any, frames: Frames) -> tuple[float | None, Floats | None, Floats | None, Floats | None]:
    """Mass [kg], centre in the body's frame [m], principal inertia [kg m2] and its axes (w first) that a body says."""
    mass, _ = _own(prim)
    if not prim.HasAPI(UsdPhysics.MassAPI):
        return None, None, None, None
    api, world = UsdPhysics.MassAPI(prim), frames.world(prim)
    centre = numbers_of(api.GetCenterOfMassAttr(), (-np.inf, -np.inf, -np.inf))
    moments = numbers_of(api.GetDiagonalInertiaAttr(), (0.0, 0.0, 0.0))
    turn = turn_of(api.GetPrincipalAxesAttr())
    if np.isinf(moments).any() or (moments < 0.0).any() or np.isposinf(centre).any():
        raise InputError(f"{prim.GetPath()}: has a centre of mass or an inertia that no body has")
    place = None
    # UsdPhysics' own value of a centre that nobody said.
    if not np.isneginf(centre).all():
        place = rigid(world)[:3, :3].T @ world[:3, :3] @ centre
    inertia = None
    if moments.any():
        inertia = moments * frames.kilogram * frames.metre**2
    axes = None
    if inertia is not None:
        axes = np.zeros(4)
        mujoco.mju_mat2Quat(axes, np.ascontiguousarray(turn).ravel())
    return None if mass is None else mass * frames.kilogram, place, inertia, axes


def _material(prim: Any) -> Any:
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
    if not material or not material.GetPrim().HasAPI(UsdPhysics.MaterialAPI):
        return None
    return UsdPhysics.MaterialAPI(material.GetPrim())


def _of_material(prim: Any) -> float | None:
    material = _material(prim)
    density = 0.0 if material is None else number_of(material.GetDensityAttr(), 0.0)
    return density if 0.0 < density < np.inf else None


def friction_of(prim: Any, usual: float) -> float:
    """Sliding friction of a collider by its physics material; the usual one where it has none."""
    material = _material(prim)
    if material is None:
        return usual
    return number_of(material.GetDynamicFrictionAttr(), 0.0)
