"""Masses of a USD stage's bodies by the rules of UsdPhysics: what is authored, else what their colliders weigh."""

from collections.abc import Iterable
from typing import Any, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray
from pxr import UsdPhysics

from thinkblox.errors import InputError
from thinkblox.sim.foreign.inertias import LEAST, SLACK, WATER, balanced, balanced_note
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.usd_frames import Frames, quat_of, rigid
from thinkblox.sim.foreign.usd_values import number_of, numbers_of, turn_of

Floats = NDArray[np.float64]
ALONE = 1.0
"""Mass of what moves, says none and has no colliders [kg], as in PhysX."""
_BALL = 0.1
"""Radius of the ball whose inertia stands for that of a body without colliders [m]."""


class Weighed(NamedTuple):
    """A collider of a body.

    Attributes:
        prim: the collider.
        geoms: what it became, one or more.
        density: of its material, in the stage's units; None where none is said.
    """

    prim: Any
    geoms: list[mujoco.MjsGeom]
    density: float | None


class _Said(NamedTuple):
    """What a body says of its mass [kg], centre in its own frame [m], principal inertia [kg m2] and its axes (w first).

    Its density is in the stage's units.
    """

    mass: float | None = None
    centre: Floats | None = None
    inertia: Floats | None = None
    axes: Floats | None = None
    density: float | None = None


class Masses:
    """What the bodies of one stage weigh.

    A body's mass is what it says, else the sum over its colliders of their mass, or their volume times the density
    that they, the body or their material say, or else that of water. Its centre and inertia are what it says, else
    those of its colliders.
    """

    def __init__(self, frames: Frames) -> None:
        self._frames = frames
        self._asked: dict[str, tuple[mujoco.MjsBody, Any, _Said]] = {}
        self._raised: list[str] = []
        self._alone: list[str] = []

    def weigh(self, body: mujoco.MjsBody, prim: Any, colliders: Iterable[Weighed]) -> None:
        """Give a body its mass, or its geoms what it follows from; `finish` must come after the last body."""
        said = _said(prim, self._frames)
        colliders = [collider for collider in colliders if collider.geoms]
        if said.mass is not None and said.inertia is not None:
            self._set(body, prim, said)
        elif not colliders:
            if said.mass is None:
                self._alone.append(str(prim.GetPath()))
            mass = ALONE if said.mass is None else said.mass
            self._set(body, prim, _Said(mass, said.centre, np.full(3, 0.4 * mass * _BALL**2)))
        else:
            for collider in colliders:
                self._fill(collider, said.density)
            if any(value is not None for value in (said.mass, said.centre, said.inertia)):
                self._asked[body.name] = (body, prim, said)

    def finish(self, spec: mujoco.MjSpec) -> None:
        """Bring what follows from colliders to what bodies say of themselves."""
        if not self._asked:
            return
        model = spec.compile()
        for name, (body, prim, said) in self._asked.items():
            found = model.body(name)
            had = float(found.mass[0])
            mass = had if said.mass is None else said.mass
            centre = np.array(found.ipos) if said.centre is None else said.centre
            inertia, axes = said.inertia, said.axes
            if inertia is None:
                inertia, axes = np.array(found.inertia) * (mass / had), np.array(found.iquat)
            self._set(body, prim, _Said(mass, centre, inertia, axes))

    def notes(self) -> tuple[str, ...]:
        """What was done to what no body can have."""
        notes = []
        if self._raised:
            notes.append(balanced_note(self._raised))
        if self._alone:
            notes.append(f"Without mass and colliders, taken as {ALONE:g} kg: {listed(self._alone)}.")
        return tuple(notes)

    def _fill(self, collider: Weighed, of_body: float | None) -> None:
        mass, density = _own(collider.prim)
        if mass is not None:
            # Of several pieces each has its share; none is known to be larger than the others.
            for geom in collider.geoms:
                geom.mass = mass * self._frames.kilogram / len(collider.geoms)
            return
        said = [value for value in (density, of_body, collider.density) if value is not None]
        for geom in collider.geoms:
            geom.density = said[0] * self._frames.kilogram / self._frames.metre**3 if said else WATER

    def _set(self, body: mujoco.MjsBody, prim: Any, said: _Said) -> None:
        """Write what a body weighs; of mass and inertia none may be missing."""
        moments = np.maximum(np.asarray(said.inertia, np.float64), LEAST)
        if 2.0 * moments.max() - moments.sum() > SLACK * moments.max():
            moments = balanced(moments)
            self._raised.append(str(prim.GetPath()))
        body.explicitinertial, body.mass, body.inertia = True, max(float(said.mass or 0.0), LEAST), moments
        body.ipos = np.zeros(3) if said.centre is None else said.centre
        body.iquat = (1.0, 0.0, 0.0, 0.0) if said.axes is None else said.axes


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


def _said(prim: Any, frames: Frames) -> _Said:
    if not prim.HasAPI(UsdPhysics.MassAPI):
        return _Said()
    mass, density = _own(prim)
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
    inertia, axes = (moments * frames.kilogram * frames.metre**2, quat_of(turn)) if moments.any() else (None, None)
    return _Said(None if mass is None else mass * frames.kilogram, place, inertia, axes, density)
