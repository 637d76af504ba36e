"""A stage that was written, read again: it has no faults, and its bodies are where and what the measured ones are."""

from pathlib import Path

import numpy as np
from pxr import Usd, UsdGeom, UsdPhysics

from thinkblox.errors import ThinkBloxError
from thinkblox.exporters.inventory import Inventory
from thinkblox.scene.corners import rotation
from thinkblox.sim.foreign.usd_checks import usd_faults

_NEAR = 1e-6
"""How far a body may be from where it was measured, in each number of its matrix [m]."""
_MASS = 1e-6
"""By which share a mass may differ from what was measured."""


def check_written(path: Path, inventory: Inventory) -> None:
    """Raise ThinkBloxError when a stage that was just written is not what it should be, by a fault of ours."""
    stage = Usd.Stage.Open(str(path))
    faults = usd_faults(stage) + _differences(stage, inventory)
    if faults:
        raise ThinkBloxError(f"{path.name}: the stage that was written is faulty: {' '.join(faults[:5])}")


def _differences(stage: Usd.Stage, inventory: Inventory) -> list[str]:
    """What of the bodies is not as in the inventory."""
    cache, found = UsdGeom.XformCache(), list[str]()
    for item in inventory.objects:
        for body in item.bodies:
            path = f"/World/Objects/{item.name}" + (f"/{body.name}" if len(item.bodies) > 1 else "")
            prim = stage.GetPrimAtPath(path)
            if not prim:
                found.append(f"{path}: is missing.")
                continue
            matrix = np.array(cache.GetLocalToWorldTransform(prim))
            away = np.abs(np.vstack([matrix[:3, :3].T - rotation(body.settled[1]), matrix[3, :3] - body.settled[0]]))
            if away.max() > _NEAR:
                found.append(f"{path}: is {away.max():g} away from where it was measured.")
            if prim.HasAPI(UsdPhysics.MassAPI):
                mass = float(UsdPhysics.MassAPI(prim).GetMassAttr().Get())
                if abs(mass - body.mass) > _MASS * body.mass:
                    found.append(f"{path}: weighs {mass:g} kg and was measured with {body.mass:g} kg.")
    return found
