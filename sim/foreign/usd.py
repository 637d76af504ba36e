"""A USD stage with UsdPhysics as an engine's spec: bodies, masses, colliders and joints as they are authored."""

import math
import re
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray
from pxr import Tf, Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdShade

from thinkblox.errors import InputError
from thinkblox.sim.build import COLLISION, COLLISION_GROUP, ROLL, TORSION, VISUAL, new_spec
from thinkblox.sim.foreign.mjcf_limits import MOST_BODIES, too_many
from thinkblox.sim.foreign.usd_checks import local_frame, usd_faults
from thinkblox.sim.settings import Physics

Matrix = NDArray[np.float64]
MAX_BYTES = 512_000_000
"""Largest file that is opened."""
_LISTED = 8
"""So many faults are told in a message."""
_UNITS = "USD is read with z up, in metres and kilograms"
_SAID = re.compile(r" : '(.*?)'(?= Error in |$)")
"""What is wrong, in a message of OpenUSD's that also says where in its own code."""
_ROOM = "room"
"""The label of what the colliders of the world itself are under."""


def usd_spec(path: Path, *, folder: Path | None = None) -> mujoco.MjSpec:
    """The spec of a stage; the keyframe "settled" is where its bodies are.

    Bodies that nothing joins to another are free. What collides without a body is fixed: a thing of its own where it
    is in a component other than the room, a part of the world otherwise. Options of the engine are ours, but gravity.

    Args:
        path: of the file.
        folder: what no layer may lie outside of; the file's own folder unless told otherwise.

    Raises:
        InputError: it cannot be opened; a layer lies outside the folder; other units; or it has faults, which are told.
    """
    stage = _opened(path, (folder or path.parent).resolve())
    faults = usd_faults(stage)
    if faults:
        more = f" and {len(faults) - _LISTED} more" if len(faults) > _LISTED else ""
        count = "1 fault" if len(faults) == 1 else f"{len(faults)} faults"
        raise InputError(f"{path}: the stage has {count}: {' '.join(faults[:_LISTED])}{more}")
    return _Reading(path, stage).spec()


def _told(error: Exception) -> str:
    """What OpenUSD says, without where in its own code it says so."""
    said = " ".join(str(error).split())
    return "; ".join(_SAID.findall(said)[:1] or [said])[:300]


def _opened(path: Path, folder: Path) -> Any:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"{path}: is larger than {MAX_BYTES // 1_000_000} MB")
        stage = Usd.Stage.Open(str(path))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error
    except Tf.ErrorException as error:
        raise InputError(f"{path}: is no USD that can be read: {_told(error)}") from error
    for layer in stage.GetUsedLayers():
        real = layer.realPath.partition("[")[0]
        if real and not Path(real).resolve().is_relative_to(folder):
            raise InputError(f"{path}: names {layer.identifier}, which is outside the folder; it is not read")
    if UsdGeom.GetStageUpAxis(stage) != "Z" or UsdGeom.GetStageMetersPerUnit(stage) != 1.0:
        has = f"{UsdGeom.GetStageUpAxis(stage)} up and {UsdGeom.GetStageMetersPerUnit(stage):g} metres a unit"
        raise InputError(f"{path}: {_UNITS}; this stage has {has}")
    if UsdPhysics.GetStageKilogramsPerUnit(stage) != 1.0:
        weight = UsdPhysics.GetStageKilogramsPerUnit(stage)
        raise InputError(f"{path}: {_UNITS}; this stage has {weight:g} kilograms a unit")
    return stage


class _Reading:
    """A stage being turned into a spec."""

    def __init__(self, path: Path, stage: Any) -> None:
        self._path, self._stage, self._cache = path, stage, UsdGeom.XformCache()
        prims = list(stage.Traverse())
        self._bodies = {prim.GetPath(): prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
        if len(self._bodies) > MOST_BODIES:
            raise InputError(too_many(str(path), len(self._bodies)))
        self._colliders = [prim for prim in prims if prim.HasAPI(UsdPhysics.CollisionAPI)]
        self._components = [
            prim for prim in prims if Usd.ModelAPI(prim).GetKind() == "component" and not _is_room(prim)
        ]
        self._joints = {
            targets[0]: UsdPhysics.Joint(prim)
            for prim in prims
            if prim.IsA(UsdPhysics.Joint) and (targets := UsdPhysics.Joint(prim).GetBody1Rel().GetTargets())
        }
        (scene,) = (UsdPhysics.Scene(prim) for prim in prims if prim.IsA(UsdPhysics.Scene))
        direction = np.array(scene.GetGravityDirectionAttr().Get() or (0.0, 0.0, -1.0), np.float64)
        pull = direction * float(scene.GetGravityMagnitudeAttr().Get())
        self._spec = new_spec(Physics(gravity=(float(pull[0]), float(pull[1]), float(pull[2]))))
        self._made: dict[Any, mujoco.MjsBody] = {}
        self._qpos: list[float] = []
        self._parts: dict[str, int] = {}

    def spec(self) -> mujoco.MjSpec:
        """The whole spec."""
        seen: list[Any] = []
        for prim in [*self._components, *(p for p in self._bodies.values() if not self._in_component(p))]:
            inside = [path for path in self._bodies if path.HasPrefix(prim.GetPath()) and path not in seen]
            seen += inside
            roots = [path for path in inside if self._parent(path) is None]
            for path in roots:
                self._add_tree(path, inside)
            if not inside and prim.GetPath() not in self._bodies:
                self._add_fixed(prim)
        for prim in self._colliders:
            owner = self._owner(prim)
            self._add_geom(self._made.get(owner, self._spec.worldbody), prim, owner)
        self._exclude()
        self._spec.add_key(name="settled", qpos=self._qpos)
        return self._spec

    def _in_component(self, prim: Any) -> bool:
        return any(prim.GetPath().HasPrefix(component.GetPath()) for component in self._components)

    def _parent(self, path: Any) -> Any:
        """What a body is joined to; None for one that hangs on nothing but the world."""
        joint = self._joints.get(path)
        targets = [] if joint is None else joint.GetBody0Rel().GetTargets()
        return targets[0] if targets else None

    def _world(self, prim: Any) -> Matrix:
        matrix: Matrix = np.array(self._cache.GetLocalToWorldTransform(prim)).T
        return matrix

    def _add_tree(self, path: Any, inside: list[Any]) -> None:
        prim = self._bodies[path]
        parent = self._parent(path)
        joint = self._joints.get(path)
        if parent is None:
            pose = self._world(prim)
            body = self._spec.worldbody.add_body(name=prim.GetName())
            if joint is None:
                body.add_freejoint(name=f"{prim.GetName()}_free")
                self._qpos += [*pose[:3, 3].tolist(), *_quat(pose).tolist()]
        else:
            pose = local_frame(joint, 0) @ np.linalg.inv(local_frame(joint, 1))
            body = self._made[parent].add_body(name=prim.GetName())
            self._add_joint(body, joint)
        body.pos, body.quat = pose[:3, 3], _quat(pose)
        _weigh(body, prim)
        self._made[path] = body
        for child in inside:
            if self._parent(child) == path:
                self._add_tree(child, inside)

    def _add_joint(self, body: mujoco.MjsBody, joint: Any) -> None:
        prim = joint.GetPrim()
        hinge = prim.IsA(UsdPhysics.RevoluteJoint)
        if not hinge and not prim.IsA(UsdPhysics.PrismaticJoint):
            if prim.IsA(UsdPhysics.FixedJoint):
                return
            raise InputError(f"{self._path}: {prim.GetPath()} is a {prim.GetTypeName()}; hinges and slides are read")
        kind = (UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint)(prim)
        frame, axis = local_frame(joint, 1), "XYZ".index(str(kind.GetAxisAttr().Get() or "X"))
        made = body.add_joint(name=body.name)
        made.type = mujoco.mjtJoint.mjJNT_HINGE if hinge else mujoco.mjtJoint.mjJNT_SLIDE
        made.pos, made.axis = frame[:3, 3], frame[:3, axis]
        limits = [kind.GetLowerLimitAttr().Get(), kind.GetUpperLimitAttr().Get()]
        if all(limit is not None and math.isfinite(limit) for limit in limits):
            made.limited, made.range = True, limits
        made.frictionloss = _number(prim, "newton:friction")
        made.damping[0] = _number(prim, "newton:damping") * (math.degrees(1.0) if hinge else 1.0)
        self._qpos.append(self._value(joint, axis, hinge=hinge))

    def _value(self, joint: Any, axis: int, *, hinge: bool) -> float:
        """Where a joint is [rad or m]."""
        ends = (joint.GetBody0Rel().GetTargets()[0], joint.GetBody1Rel().GetTargets()[0])
        here, there = (
            self._world(self._stage.GetPrimAtPath(path)) @ local_frame(joint, end) for end, path in enumerate(ends)
        )
        away = np.linalg.inv(here) @ there
        if not hinge:
            return float(away[axis, 3])
        i, j = (axis + 1) % 3, (axis + 2) % 3
        return math.atan2(float(away[j, i]), float(away[i, i]))

    def _add_fixed(self, prim: Any) -> None:
        """A thing that cannot move; one that nothing can touch has a box for its looks."""
        pose = self._world(prim)
        body = self._spec.worldbody.add_body(name=prim.GetName(), pos=pose[:3, 3], quat=_quat(pose))
        self._made[prim.GetPath()] = body
        if not any(collider.GetPath().HasPrefix(prim.GetPath()) for collider in self._colliders):
            box = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default", "render"]).ComputeUntransformedBound(prim)
            size, middle = np.array(box.GetRange().GetSize()), np.array(box.GetRange().GetMidpoint())
            if np.isfinite(size).all() and (size > 0.0).any():
                seen = body.add_geom(self._spec.find_default(VISUAL), type=mujoco.mjtGeom.mjGEOM_BOX)
                seen.pos, seen.size = middle, np.maximum(size / 2, 1e-4)

    def _owner(self, prim: Any) -> Any:
        """The path of the body or fixed thing that a collider belongs to; None for the world's."""
        above = prim
        while above and not above.IsPseudoRoot():
            if above.GetPath() in self._made:
                return above.GetPath()
            above = above.GetParent()
        return None

    def _add_geom(self, body: mujoco.MjsBody, prim: Any, owner: Any) -> None:
        frame = self._world(prim)
        if owner is not None:
            frame = np.linalg.inv(self._world(self._stage.GetPrimAtPath(owner))) @ frame
        scale = np.linalg.norm(frame[:3, :3], axis=0)
        frame[:3, :3] /= scale
        geom = body.add_geom(self._spec.find_default(COLLISION), group=COLLISION_GROUP)
        if owner is None:
            geom.name = self._part_name(prim)
        geom.pos, geom.quat = frame[:3, 3], _quat(frame)
        friction = _friction(prim)
        geom.friction = (friction, TORSION, ROLL)
        geom.condim = 6 if prim.IsA(UsdGeom.Sphere) or prim.IsA(UsdGeom.Capsule) else 3
        self._shape(geom, prim, scale)

    def _part_name(self, prim: Any) -> str:
        """What a part of the world is called: as the first prim above it with a label, with a number if need be."""
        above = prim
        while above and not UsdSemantics.LabelsAPI.GetAll(above):
            above = above.GetParent()
        name = str((above or prim).GetName() or prim.GetName())
        self._parts[name] = self._parts.get(name, 0) + 1
        return name if self._parts[name] == 1 else f"{name}_part_{self._parts[name]}"

    def _shape(self, geom: mujoco.MjsGeom, prim: Any, scale: Matrix) -> None:
        kinds = mujoco.mjtGeom
        if prim.IsA(UsdGeom.Cube):
            geom.type, geom.size = kinds.mjGEOM_BOX, float(UsdGeom.Cube(prim).GetSizeAttr().Get()) / 2 * scale
        elif prim.IsA(UsdGeom.Sphere):
            radius = float(UsdGeom.Sphere(prim).GetRadiusAttr().Get()) * float(scale[0])
            geom.type, geom.size = kinds.mjGEOM_SPHERE, (radius, 0.0, 0.0)
        elif prim.IsA(UsdGeom.Cylinder) or prim.IsA(UsdGeom.Capsule):
            round_kind = UsdGeom.Cylinder(prim) if prim.IsA(UsdGeom.Cylinder) else UsdGeom.Capsule(prim)
            if str(round_kind.GetAxisAttr().Get()) != "Z":
                raise InputError(f"{self._path}: {prim.GetPath()}: round shapes are read along z")
            geom.type = kinds.mjGEOM_CYLINDER if prim.IsA(UsdGeom.Cylinder) else kinds.mjGEOM_CAPSULE
            half = float(round_kind.GetHeightAttr().Get()) / 2 * float(scale[2])
            geom.size = (float(round_kind.GetRadiusAttr().Get()) * float(scale[0]), half, 0.0)
        elif prim.IsA(UsdGeom.Mesh):
            mesh = self._spec.add_mesh(name=f"mesh_{len(self._spec.meshes)}")
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
            mesh.uservert = (np.array(UsdGeom.Mesh(prim).GetPointsAttr().Get(), np.float64) * scale).ravel()
            geom.type, geom.meshname = kinds.mjGEOM_MESH, mesh.name
        else:
            raise InputError(
                f"{self._path}: {prim.GetPath()} collides and is a {prim.GetTypeName()}, which is not read"
            )

    def _exclude(self) -> None:
        """What the links of one articulation do not do with each other."""
        pairs: set[tuple[str, str]] = set()
        for path, prim in self._bodies.items():
            others = list(UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel().GetTargets())
            joint, parent = self._joints.get(path), self._parent(path)
            if joint is not None and parent is not None and not joint.GetCollisionEnabledAttr().Get():
                others.append(parent)
            for other in others:
                first, second = sorted((self._made[path].name, self._made[other].name))
                pairs.add((first, second))
        for first, second in sorted(pairs):
            self._spec.add_exclude(bodyname1=first, bodyname2=second)


def _is_room(prim: Any) -> bool:
    if not UsdSemantics.LabelsAPI.GetAll(prim):
        return False
    return _ROOM in (UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get() or ())


def _weigh(body: mujoco.MjsBody, prim: Any) -> None:
    mass = UsdPhysics.MassAPI(prim)
    body.explicitinertial, body.mass = True, float(mass.GetMassAttr().Get())
    body.ipos, body.inertia = mass.GetCenterOfMassAttr().Get(), mass.GetDiagonalInertiaAttr().Get()
    axes = mass.GetPrincipalAxesAttr().Get()
    body.iquat = (axes.GetReal(), *axes.GetImaginary())


def _friction(prim: Any) -> float:
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
    if not material:
        return 0.5
    return float(UsdPhysics.MaterialAPI(material.GetPrim()).GetDynamicFrictionAttr().Get() or 0.0)


def _number(prim: Any, name: str) -> float:
    attribute = prim.GetAttribute(name)
    return float(attribute.Get()) if attribute and attribute.HasAuthoredValue() else 0.0


def _quat(matrix: Matrix) -> Matrix:
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(matrix[:3, :3]).ravel())
    return quat
