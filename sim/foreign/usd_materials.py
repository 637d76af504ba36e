"""Physics materials of a USD stage: how what collides rubs, and how dense it is."""

from typing import Any, NamedTuple

import numpy as np
from pxr import UsdPhysics, UsdShade

from thinkblox.sim.foreign.usd_values import number_of

FRICTION = 0.5
"""Of what has no physics material, as in PhysX."""


class PhysicsMaterial(NamedTuple):
    """What a collider is made of.

    Attributes:
        friction: sliding.
        density: in the stage's units; None where none is said.
    """

    friction: float
    density: float | None


def material_of(prim: Any) -> PhysicsMaterial:
    """The physics material that a collider is bound to, or the usual one."""
    found, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
    if not found or not found.GetPrim().HasAPI(UsdPhysics.MaterialAPI):
        return PhysicsMaterial(FRICTION, None)
    material = UsdPhysics.MaterialAPI(found.GetPrim())
    density = number_of(material.GetDensityAttr(), 0.0)
    friction = number_of(material.GetDynamicFrictionAttr(), 0.0)
    return PhysicsMaterial(friction, density if 0.0 < density < np.inf else None)
