"""A USD stage with UsdPhysics as an engine's spec: bodies, masses, colliders and joints as they are authored."""

import re
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from pxr import Pcp, Sdf, Tf, Usd, UsdGeom, UsdPhysics, UsdSemantics

from thinkblox.errors import InputError
from thinkblox.sim.build import COLLISION, COLLISION_GROUP, ROLL, TORSION, VISUAL, new_spec
from thinkblox.sim.foreign.mjcf_limits import MOST_BODIES, too_many
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.usd_checks import usd_faults
from thinkblox.sim.foreign.usd_frames import Frames, Matrix, owner_of, quat_of
from thinkblox.sim.foreign.usd_joints import Join, filtered_pairs, motion, tree_of
from thinkblox.sim.foreign.usd_masses import Masses, Weighed
from thinkblox.sim.foreign.usd_materials import material_of
from thinkblox.sim.foreign.usd_shapes import ColliderGeom, ColliderNotes, solids_of
from thinkblox.sim.foreign.usd_unread import check_instancers, moved_over_time
from thinkblox.sim.foreign.usd_values import number_of, numbers_of
from thinkblox.sim.settings import Physics

MAX_BYTES = 512_000_000
"""Largest file that is opened."""
_LISTED = 5
"""So many faults of a stage are told."""
EARTH = -Physics().gravity[2]
"""Gravity where a stage says none [m/s2]."""
_SAID = re.compile(r" : '(.*?)'(?= Error in |$)")
"""What is wrong, in a message of OpenUSD's that also says where in its own code."""
_NAMED = re.compile(r"@(.+?)@")
"""The first file that a message of OpenUSD's names."""
_ROOM = "room"
"""The label of what the colliders of the world itself are under."""


def usd_spec(path: Path, *, folder: Path | None = None) -> tuple[mujoco.MjSpec, tuple[str, ...]]:
    """The spec of a stage, and notes on how it was read; the keyframe "settled" is where its bodies are.

    Lengths become metres, masses kilograms, and z points up. Bodies that nothing joins to another are free; kinematic
    and disabled ones stay where they are. What collides without a body is fixed: a thing of its own where it is in a
    component other than the room, a part of the world otherwise. Options of the engine are ours, but gravity.

    Args:
        path: of the file.
        folder: what no layer may lie outside of; the file's own folder unless told otherwise.

    Raises:
        InputError: it cannot be opened; a layer or a reference is missing, or lies outside the folder; or a part of it
            makes no sense, which is told.
    """
    stage = _opened(path, (folder or path.parent).resolve())
    try:
        reading = _Stage(stage)
        return reading.spec(), (*reading.notes(), *_faults(stage))
    except InputError as error:
        raise InputError(f"{path}: {error}") from error


def _faults(stage: Any) -> tuple[str, ...]:
    """A note on what other programs may stumble over, where there is anything."""
    found = usd_faults(stage)
    if not found:
        return ()
    more = f" And {len(found) - _LISTED} more." if len(found) > _LISTED else ""
    count = f"{len(found)} fault{'' if len(found) == 1 else 's'}"
    return (f"Other programs may stumble over {count}: {' '.join(found[:_LISTED])}{more}",)


def _told(error: Exception) -> str:
    """What OpenUSD says, without where in its own code it says so."""
    said = " ".join(str(error).split())
    return "; ".join(_SAID.findall(said)[:1] or [said])[:300]


def _opened(path: Path, folder: Path) -> Any:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"{path}: is larger than {MAX_BYTES // 1_000_000} MB")
        # OpenUSD would go on with what it once read of a file that something still refers to.
        known = Sdf.Layer.Find(str(path))
        if known:
            known.Reload(force=True)
        stage = Usd.Stage.Open(str(path))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error
    except Tf.ErrorException as error:
        raise InputError(f"{path}: is no USD that can be read: {_told(error)}") from error
    for layer in stage.GetUsedLayers():
        real = layer.realPath.partition("[")[0]
        if real and not Path(real).resolve().is_relative_to(folder):
            raise InputError(f"{path}: names {layer.identifier}, which is outside the folder; it is not read")
    if missing := _missing(stage):
        raise InputError(f"{path}: cannot be read without the files that it names: {listed(missing)}")
    units = {"metres": UsdGeom.GetStageMetersPerUnit(stage), "kilograms": UsdPhysics.GetStageKilogramsPerUnit(stage)}
    for name, size in units.items():
        if not 1e-6 <= size <= 1e6:
            raise InputError(f"{path}: has {size:g} {name} a unit; between 1e-06 and 1e+06 are read")
    return stage


def _missing(stage: Any) -> list[str]:
    """The layers and references that a stage is made of and that are not there."""
    kinds = (Pcp.ErrorType_InvalidAssetPath, Pcp.ErrorType_InvalidSublayerPath)
    said = (str(error) for error in stage.GetCompositionErrors() if error.errorType in kinds)
    named = ((text, _NAMED.search(text)) for text in said)
    return sorted({text if file is None else file[1] for text, file in named})


class _Stage:
    """A stage being turned into a spec."""

    def __init__(self, stage: Any) -> None:
        self._stage, self._frames = stage, Frames(stage)
        self._prims = prims = list(stage.Traverse(Usd.TraverseInstanceProxies()))
        check_instancers(prims)
        self._bodies = {prim.GetPath(): prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
        if len(self._bodies) > MOST_BODIES:
            raise InputError(too_many("the stage", len(self._bodies)))
        self._colliders = [prim for prim in prims if _collides(prim)]
        self._held = [key for key, prim in self._bodies.items() if not _moves(prim)]
        self._tree = tree_of(prims, self._bodies, self._held, self._frames)
        self._fixed = {prim.GetPath(): prim for prim in prims if self._is_fixed_thing(prim)}
        self._names = _short_names([*self._bodies, *self._fixed])
        self._scenes = [UsdPhysics.Scene(prim) for prim in prims if prim.IsA(UsdPhysics.Scene)]
        self._driven = [str(prim.GetPath()) for prim in prims if _is_driven(prim)]
        self._spec = new_spec(Physics(gravity=self._gravity()))
        self._made: dict[Any, mujoco.MjsBody] = {}
        self._qpos: list[float] = []
        self._parts: dict[str, int] = {}
        self._shapes, self._masses = ColliderNotes(), Masses(self._frames)
        self._bounds = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default", "render"])
        self._slack: list[str] = []

    def spec(self) -> mujoco.MjSpec:
        """The whole spec."""
        below: dict[Any, list[Any]] = {}
        for key, join in self._tree.joins.items():
            below.setdefault(None if join is None else join.parent, []).append(key)
        order = {key: number for number, key in enumerate(self._bodies)}
        waiting = sorted(below.get(None, ()), key=order.__getitem__, reverse=True)
        while waiting:
            key = waiting.pop()
            self._add_body(key, self._tree.joins[key])
            waiting += below.get(key, ())[::-1]
        for prim in self._fixed.values():
            self._add_fixed(prim)
        weighing: dict[Any, list[Weighed]] = {key: [] for key in self._bodies}
        for prim in self._colliders:
            owner, material = owner_of(prim, self._made), material_of(prim)
            geoms = self._add_geoms(prim, owner, material.friction)
            if owner in weighing:
                weighing[owner].append(Weighed(prim, geoms, material.density))
        for key, colliders in weighing.items():
            self._masses.weigh(self._made[key], self._bodies[key], colliders)
        for first, second in sorted(filtered_pairs(self._prims, self._bodies, self._tree), key=str):
            self._spec.add_exclude(bodyname1=self._names[first], bodyname2=self._names[second])
        for join in self._tree.loops:
            self._close(join)
        self._masses.finish(self._spec)
        self._spec.add_key(name="settled", qpos=self._qpos)
        return self._spec

    def notes(self) -> tuple[str, ...]:
        """What a reader should know of how the stage was read."""
        notes = [*self._masses.notes()]
        if len(self._scenes) != 1:
            which = "the first counts" if self._scenes else f"gravity is {EARTH:g} m/s2"
            notes.append(f"The stage has {len(self._scenes)} physics scenes: {which}.")
        for what, paths in (
            ("Moving triangles, taken as their convex hulls as in other engines", self._shapes.hulled),
            ("Divided into convex pieces", self._shapes.divided),
            ("Not a shape that is read, so that nothing touches it", self._shapes.left_out),
            ("Loops that are not held", self._slack),
            ("Drives that are not run", self._driven),
            ("Moved over time, but measured where it stands without a time", moved_over_time(self._prims)),
        ):
            if paths:
                notes.append(f"{what}: {listed(paths)}.")
        return tuple(notes)

    def _gravity(self) -> tuple[float, float, float]:
        direction, magnitude = np.zeros(3), -1.0
        for scene in self._scenes[:1]:
            direction = self._frames.upright @ numbers_of(scene.GetGravityDirectionAttr(), (0.0, 0.0, 0.0))
            magnitude = number_of(scene.GetGravityMagnitudeAttr(), -np.inf)
        if np.isinf(direction).any() or magnitude == np.inf:
            raise InputError(f"{self._scenes[0].GetPath()}: has a gravity that is not made of finite numbers")
        # Of a direction of length 0 and a magnitude below 0 UsdPhysics says: down, and as on earth.
        length = float(np.linalg.norm(direction))
        down = direction / length if length > 0.0 else np.array([0.0, 0.0, -1.0])
        pull = down * (magnitude * self._frames.metre if magnitude >= 0.0 else EARTH)
        return float(pull[0]), float(pull[1]), float(pull[2])

    def _is_fixed_thing(self, prim: Any) -> bool:
        """Whether a prim is a component that no body is in or above."""
        if Usd.ModelAPI(prim).GetKind() != "component" or _is_room(prim) or not prim.IsA(UsdGeom.Imageable):
            return False
        return not any(key.HasPrefix(prim.GetPath()) or prim.GetPath().HasPrefix(key) for key in self._bodies)

    def _add_body(self, key: Any, join: Join | None) -> None:
        prim = self._bodies[key]
        pose = self._frames.pose(prim)
        name = self._names[key]
        if join is None or (join.parent is None and not join.freedoms and not join.ball):
            body = self._spec.worldbody.add_body(name=name)
            if join is None and key not in self._held:
                body.add_freejoint(name=f"{name}_free")
                self._qpos += [*pose[:3, 3].tolist(), *quat_of(pose).tolist()]
        else:
            above = self._spec.worldbody if join.parent is None else self._made[join.parent]
            body = above.add_body(name=name)
            at = np.eye(4) if join.parent is None else self._frames.pose(self._bodies[join.parent])
            self._add_joints(body, join, at, pose)
            pose = join.at_parent @ np.linalg.inv(join.at_child)
        body.pos, body.quat = pose[:3, 3], quat_of(pose)
        body.gravcomp = 1.0 if _flag(prim, "physxRigidBody:disableGravity") else 0.0
        self._made[key] = body

    def _add_joints(self, body: mujoco.MjsBody, join: Join, parent: Matrix, child: Matrix) -> None:
        frame = join.at_child
        if join.ball:
            body.add_joint(name=body.name, type=mujoco.mjtJoint.mjJNT_BALL, pos=frame[:3, 3])
            turned = np.linalg.inv(join.at_parent) @ np.linalg.inv(parent) @ child
            self._qpos += quat_of(frame @ turned).tolist()
            return
        sign = -1.0 if join.backwards else 1.0
        for freedom, value in zip(join.freedoms, motion(join, parent, child), strict=True):
            several = len(join.freedoms) > 1
            made = body.add_joint(
                name=f"{body.name}_{'xyz'[freedom.axis]}{int(freedom.turns)}" if several else body.name
            )
            made.type = mujoco.mjtJoint.mjJNT_HINGE if freedom.turns else mujoco.mjtJoint.mjJNT_SLIDE
            made.pos, made.axis = frame[:3, 3], sign * frame[:3, freedom.axis]
            if freedom.limits is not None:
                made.limited, made.range = True, freedom.limits
            made.frictionloss = number_of(join.prim.GetAttribute("newton:friction"), 0.0)
            damping = number_of(join.prim.GetAttribute("newton:damping"), 0.0)
            made.damping[0] = float(np.degrees(damping)) if freedom.turns else damping
            self._qpos.append(float(value))

    def _close(self, join: Join) -> None:
        """Hold together what a tree of bodies leaves apart."""
        if join.freedoms and not (len(join.freedoms) == 1 and join.freedoms[0].turns):
            self._slack.append(str(join.prim.GetPath()))
            return
        # A joint of a loop has a child; where its parent is the world, the constraint is on the child alone.
        first, second = (join.parent, join.child) if join.parent is not None else (join.child, None)
        frame = join.at_parent if join.parent is not None else join.at_child
        made = self._spec.add_equality(objtype=mujoco.mjtObj.mjOBJ_BODY, name1=self._names[first])
        made.type = mujoco.mjtEq.mjEQ_CONNECT if join.freedoms or join.ball else mujoco.mjtEq.mjEQ_WELD
        if second is not None:
            made.name2 = self._names[second]
        if made.type == mujoco.mjtEq.mjEQ_CONNECT:
            made.data[:3] = frame[:3, 3]

    def _add_fixed(self, prim: Any) -> None:
        """A thing that cannot move; one that nothing can touch has a box for its looks."""
        pose = self._frames.pose(prim)
        body = self._spec.worldbody.add_body(name=self._names[prim.GetPath()], pos=pose[:3, 3], quat=quat_of(pose))
        self._made[prim.GetPath()] = body
        if not any(collider.GetPath().HasPrefix(prim.GetPath()) for collider in self._colliders):
            box = self._bounds.ComputeUntransformedBound(prim)
            size, middle = np.array(box.GetRange().GetSize()), np.array(box.GetRange().GetMidpoint())
            if np.isfinite(size).all() and (size > 0.0).any():
                linear = pose[:3, :3].T @ self._frames.world(prim)[:3, :3]
                seen = body.add_geom(self._spec.find_default(VISUAL), type=mujoco.mjtGeom.mjGEOM_BOX)
                seen.pos, seen.size = linear @ middle, np.maximum(np.abs(linear) @ size / 2, 1e-4)

    def _add_geoms(self, prim: Any, owner: Any, friction: float) -> list[mujoco.MjsGeom]:
        """What a collider is in the engine, on the body or fixed thing that owns it; None is the world."""
        frame = self._frames.world(prim)
        if owner is not None:
            frame = np.linalg.inv(self._frames.pose(self._stage.GetPrimAtPath(owner))) @ frame
        moves = owner in self._bodies and owner not in self._held
        body = self._spec.worldbody if owner is None else self._made[owner]
        return [
            self._add_geom(body, solid, friction, name=self._part_name(prim) if owner is None else "")
            for solid in solids_of(prim, frame, moves, self._shapes)
        ]

    def _add_geom(self, body: mujoco.MjsBody, solid: ColliderGeom, friction: float, *, name: str) -> mujoco.MjsGeom:
        geom = body.add_geom(self._spec.find_default(COLLISION), group=COLLISION_GROUP)
        if name:
            geom.name = name
        geom.pos, geom.quat = solid.frame[:3, 3], quat_of(solid.frame)
        geom.friction = (friction, TORSION, ROLL)
        geom.type = solid.kind
        geom.condim = 6 if solid.kind in (mujoco.mjtGeom.mjGEOM_SPHERE, mujoco.mjtGeom.mjGEOM_CAPSULE) else 3
        if solid.points is None:
            geom.size = solid.size
        else:
            mesh = self._spec.add_mesh(name=f"mesh_{len(self._spec.meshes)}")
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
            mesh.uservert = solid.points.ravel()
            geom.meshname = mesh.name
        return geom

    def _part_name(self, prim: Any) -> str:
        """What a part of the world is called: as the first prim above it with a label, with a number if need be."""
        above = prim
        while above and not UsdSemantics.LabelsAPI.GetAll(above):
            above = above.GetParent()
        name = str((above or prim).GetName() or prim.GetName())
        self._parts[name] = self._parts.get(name, 0) + 1
        return name if self._parts[name] == 1 else f"{name}_part_{self._parts[name]}"


def _short_names(paths: list[Any]) -> dict[Any, str]:
    """A name for each path: its end, as much of it as tells it from the others."""
    names: dict[Any, str] = {}
    taken: dict[str, list[Any]] = {}
    for path in paths:
        taken.setdefault(path.name, []).append(path)
    for name, same in taken.items():
        for path in same:
            names[path] = name if len(same) == 1 else str(path).lstrip("/")
    return names


def _collides(prim: Any) -> bool:
    if not prim.HasAPI(UsdPhysics.CollisionAPI):
        return False
    return UsdPhysics.CollisionAPI(prim).GetCollisionEnabledAttr().Get() is not False


def _moves(prim: Any) -> bool:
    body = UsdPhysics.RigidBodyAPI(prim)
    return body.GetRigidBodyEnabledAttr().Get() is not False and body.GetKinematicEnabledAttr().Get() is not True


def _is_driven(prim: Any) -> bool:
    return any(
        prim.HasAPI(UsdPhysics.DriveAPI, name) and UsdPhysics.DriveAPI(prim, name).GetStiffnessAttr().Get()
        for name in ("angular", "linear")
    )


def _is_room(prim: Any) -> bool:
    if not UsdSemantics.LabelsAPI.GetAll(prim):
        return False
    return _ROOM in (UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get() or ())


def _flag(prim: Any, name: str) -> bool:
    attribute = prim.GetAttribute(name)
    return bool(attribute) and attribute.Get() is True
