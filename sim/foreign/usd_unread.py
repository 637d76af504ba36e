"""What a stage may say in ways that are not read: many copies by one prim, and motion over time."""

from collections.abc import Iterable, Sequence
from typing import Any

from pxr import Usd, UsdGeom, UsdPhysics

from thinkblox.errors import InputError


def check_instancers(prims: Iterable[Any]) -> None:
    """Raise InputError for a point instancer of what has physics: it would be there once, and no copy."""
    for prim in prims:
        if not prim.IsA(UsdGeom.PointInstancer):
            continue
        stage = prim.GetStage()
        models = [stage.GetPrimAtPath(path) for path in UsdGeom.PointInstancer(prim).GetPrototypesRel().GetTargets()]
        if physical := next((found for model in models if model for found in _with_physics(model)), None):
            raise InputError(
                f"{prim.GetPath()}: makes copies of {physical.GetPath()}, which has physics; point instancers of bodies"
                " and colliders are not read: give each copy a prim of its own that refers to it"
            )


def moved_over_time(prims: Sequence[Any]) -> list[str]:
    """Paths of what has a pose that is given by time, and physics itself or below it."""
    physical = [prim.GetPath() for prim in prims if _has_physics(prim)]
    return [
        str(prim.GetPath())
        for prim in prims
        if prim.IsA(UsdGeom.Xformable)
        and any(op.GetNumTimeSamples() for op in UsdGeom.Xformable(prim).GetOrderedXformOps())
        and any(path.HasPrefix(prim.GetPath()) for path in physical)
    ]


def _with_physics(model: Any) -> Iterable[Any]:
    inside = Usd.PrimRange(model, Usd.TraverseInstanceProxies(Usd.PrimAllPrimsPredicate))
    return (prim for prim in inside if _has_physics(prim))


def _has_physics(prim: Any) -> bool:
    return bool(prim.HasAPI(UsdPhysics.RigidBodyAPI) or prim.HasAPI(UsdPhysics.CollisionAPI))
