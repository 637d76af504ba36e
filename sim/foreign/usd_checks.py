"""What is wrong with the physics of a USD stage: faults that OpenUSD's validators do not look for, and theirs."""

from collections.abc import Container, Iterator
from typing import Any

import numpy as np
from pxr import Usd, UsdGeom, UsdPhysics, UsdValidation

from thinkblox.errors import InputError
from thinkblox.sim.foreign.usd_frames import Frames
from thinkblox.sim.foreign.usd_joints import ends_of, freedoms_of, gaps_of
from thinkblox.sim.foreign.usd_values import number_of, numbers_of, points_of

MOST_CORNERS = 64
"""Corners of a convex hull that every engine takes whole."""
AGREE = 1e-4
"""How far the two frames of a joint may be apart across its axis [m, and rad]."""
_SCALE = 1e-5
_TRIANGLE = 1e-6
"""By which share the largest moment of inertia may exceed the sum of the others."""


def usd_faults(stage: Any) -> list[str]:
    """The faults of a stage, each in a sentence that begins with the prim's path; none of a sound one.

    Raises:
        InputError: no axis of the stage is up.
    """
    return [*_own(stage), *_of_openusd(stage)]


def _own(stage: Any) -> Iterator[str]:
    prims = list(stage.Traverse())
    frames = Frames(stage)
    yield from _scenes(prims)
    joined = {path for prim in prims if prim.IsA(UsdPhysics.Joint) for path in _ends(prim)}
    for prim in prims:
        try:
            yield from _of_prim(prim, frames, joined)
        except InputError as error:
            yield f"{error}."


def _of_prim(prim: Any, frames: Frames, joined: Container[Any]) -> Iterator[str]:
    if prim.HasAPI(UsdPhysics.ArticulationRootAPI) and _above(prim, UsdPhysics.ArticulationRootAPI) is not None:
        yield f"{prim.GetPath()}: is an articulation within another."
    if prim.HasAPI(UsdPhysics.RigidBodyAPI):
        yield from _body(prim, frames, joined)
    if prim.HasAPI(UsdPhysics.CollisionAPI):
        yield from _collider(prim)
    if prim.IsA(UsdPhysics.Joint):
        yield from _joint(prim, frames)
    if prim.IsA(UsdGeom.Mesh):
        yield from _mesh(prim)


def _of_openusd(stage: Any) -> Iterator[str]:
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    for error in UsdValidation.ValidationContext(validators).Validate(stage):
        sites = ", ".join(str(site.GetPrim().GetPath()) for site in error.GetSites() if site.IsPrim())
        yield f"{sites or 'the stage'}: {error.GetName()}: {error.GetMessage()}"


def _scenes(prims: list[Any]) -> Iterator[str]:
    scenes = [UsdPhysics.Scene(prim) for prim in prims if prim.IsA(UsdPhysics.Scene)]
    if len(scenes) != 1:
        yield f"the stage: has {len(scenes)} physics scenes; it needs exactly one."
    for scene in scenes:
        # One below 0, as it is where nothing is said, asks for that of the earth.
        if not number_of(scene.GetGravityMagnitudeAttr(), -np.inf) < np.inf:
            yield f"{scene.GetPath()}: has a magnitude of gravity that is not finite."


def _ends(prim: Any) -> list[Any]:
    """The paths of what a joint joins."""
    joint = UsdPhysics.Joint(prim)
    return [*joint.GetBody0Rel().GetTargets(), *joint.GetBody1Rel().GetTargets()]


def _body(prim: Any, frames: Frames, joined: Container[Any]) -> Iterator[str]:
    path = prim.GetPath()
    if _above(prim, UsdPhysics.RigidBodyAPI) is not None:
        yield f"{path}: is a body within a body."
    scale = np.linalg.norm(frames.world(prim)[:3, :3], axis=0) / frames.metre
    if np.abs(scale - 1.0).max() > _SCALE:
        yield f"{path}: is a body with a scale, which its mass and inertia do not follow."
    # What hangs on a joint need not be touched to be somewhere.
    inside = Usd.PrimRange(prim, Usd.TraverseInstanceProxies())
    if path not in joined and not any(child.HasAPI(UsdPhysics.CollisionAPI) for child in inside):
        yield f"{path}: is a body that nothing can touch."
    mass = UsdPhysics.MassAPI(prim) if prim.HasAPI(UsdPhysics.MassAPI) else None
    if mass is None or not 0.0 < number_of(mass.GetMassAttr(), 0.0) < np.inf:
        yield f"{path}: is a body without a mass above 0."
        return
    inertia = np.sort(numbers_of(mass.GetDiagonalInertiaAttr(), (0.0, 0.0, 0.0)))
    if not inertia.any():
        return  # it is left to the engine, from the colliders
    if not (np.isfinite(inertia).all() and inertia[0] > 0.0):
        yield f"{path}: has an inertia that is not above 0."
    elif inertia[2] > (inertia[0] + inertia[1]) * (1.0 + _TRIANGLE):
        yield f"{path}: has an inertia that no body can have: {inertia[2]:g} is more than the two others together."


def _collider(prim: Any) -> Iterator[str]:
    if not prim.IsA(UsdGeom.Mesh):
        return
    body = prim if prim.HasAPI(UsdPhysics.RigidBodyAPI) else _above(prim, UsdPhysics.RigidBodyAPI)
    approximation = UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get() or "none"
    if body is not None and approximation in ("none", "meshSimplification"):
        yield f"{prim.GetPath()}: is a mesh of a moving body that collides as triangles ({approximation})."
    points = UsdGeom.Mesh(prim).GetPointsAttr().Get() or ()
    if approximation == "convexHull" and len(points) > MOST_CORNERS:
        yield f"{prim.GetPath()}: is a hull of {len(points)} corners; engines cut off what is beyond {MOST_CORNERS}."


def _mesh(prim: Any) -> Iterator[str]:
    mesh, path = UsdGeom.Mesh(prim), prim.GetPath()
    points = points_of(mesh.GetPointsAttr())
    index = numbers_of(mesh.GetFaceVertexIndicesAttr(), ())
    counts = numbers_of(mesh.GetFaceVertexCountsAttr(), ())
    if counts.sum() != len(index) or (len(index) and (index.min() < 0 or index.max() >= len(points))):
        yield f"{path}: names points that do not exist."
        return
    extent = numbers_of(mesh.GetExtentAttr(), ())
    if len(points) and extent.shape == (2, 3):
        slack = 1e-5 * max(1.0, float(np.abs(points).max()))
        if (points.min(axis=0) < extent[0] - slack).any() or (points.max(axis=0) > extent[1] + slack).any():
            yield f"{path}: reaches out of its extent."


def _joint(prim: Any, frames: Frames) -> Iterator[str]:
    joint, path = UsdPhysics.Joint(prim), prim.GetPath()
    named, ends = _ends(prim), ends_of(joint)
    if not named or sum(end is not None for end in ends) < len(named):
        yield f"{path}: joins what does not exist."
        return
    freedoms = freedoms_of(prim, frames)
    if freedoms is None:
        return
    shift, bent = gaps_of(prim, [frames.joint(joint, *end) for end in enumerate(ends)], freedoms)
    if shift > AGREE:
        yield f"{path}: has its two frames {shift:.4g} m apart."
    if bent > AGREE:
        yield f"{path}: has its two frames turned against each other by {bent:.4g} rad."


def _above(prim: Any, api: Any) -> Any:
    """The nearest prim above that has an API; None where there is none."""
    parent = prim.GetParent()
    while parent and not parent.IsPseudoRoot():
        if parent.HasAPI(api):
            return parent
        parent = parent.GetParent()
    return None
