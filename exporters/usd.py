"""A Scene as a UsdPhysics stage, with masses and settled poses taken from the compiled MuJoCo model."""

import math
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import shapely
from pxr import Gf, Kind, Sdf

from thinkblox.exporters.usd_joints import add_joint, fix_to_room
from thinkblox.exporters.usd_looks import Looks
from thinkblox.exporters.usd_prims import Prim, T, quaternion, vector
from thinkblox.exporters.usd_shapes import Polygons, add_colliders, add_mesh, add_visuals, box_polygons
from thinkblox.scene.asset import Asset, Joint, Link, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled, package_version, yaw_quat
from thinkblox.sim.geometry.solid import rotation
from thinkblox.sim.geometry.walls import wall_slabs
from thinkblox.sim.render.materials import Palette, palette
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import SettledState, settle
from thinkblox.value import Quat, Vec3

_LABELS = "SemanticsLabelsAPI:class"
_FLOOR_THICKNESS = 0.1


def write_usd(scene: Scene, path: Path, *, settled: SettledState | None = None, physics: Physics | None = None) -> None:
    """Write a scene as one ASCII stage that PhysX, Isaac, Newton, Genesis and Blender read.

    Z up, metres, kilograms. Objects stand where MuJoCo let them come to rest, as in keyframe "settled" of the MJCF;
    their masses and inertias are those of the compiled model. Fixed objects are colliders without a body.

    Args:
        scene: what to write.
        path: of the file, "scene.usda".
        settled: the state at rest, where it is known already; worked out otherwise.
        physics: settings that the masses, poses and the room's friction follow.
    """
    Path(path).write_text(usd_text(scene, settled=settled, physics=physics), encoding="utf-8")


def usd_text(scene: Scene, *, settled: SettledState | None = None, physics: Physics | None = None) -> str:
    """The text of `write_usd`."""
    physics = physics or Physics()
    model = compiled(build_spec(scene, physics=physics))
    data = mujoco.MjData(model)
    data.qpos[:] = (settled or settle(scene, physics=physics)).qpos
    mujoco.mj_kinematics(model, data)
    layer = Sdf.Layer.CreateAnonymous(".usda")
    with Sdf.ChangeBlock():
        world = _stage(layer, scene)
        looks = Looks(world.child("Looks", "Scope"))
        _add_physics(world, physics)
        _add_light(world)
        _add_room(world, scene, physics, looks)
        objects = world.child("Objects", "Xform", kind=Kind.Tokens.group)
        for placement in scene.placements:
            _Object(placement, scene.asset_of(placement), model, data, looks).add(objects)
    return str(layer.ExportToString())


def _stage(layer: Any, scene: Scene) -> Prim:
    layer.documentation = "A furnished room at rest. Poses are those of the settled state."
    root = layer.pseudoRoot
    for key, value in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        root.SetInfo(key, value)
    creator = f"thinkblox {package_version()}"
    layer.customLayerData = {
        "creator": creator,
        "mujoco": mujoco.__version__,
        "prompt": scene.prompt,
        "seed": str(scene.seed),
    }
    layer.defaultPrim = "World"
    world = Prim(Sdf.PrimSpec(layer, "World", Sdf.SpecifierDef, "Xform"))
    world.spec.kind = Kind.Tokens.assembly
    return world


def _add_physics(world: Prim, physics: Physics) -> None:
    magnitude = math.hypot(*physics.gravity)
    direction = [part / magnitude for part in physics.gravity]
    prim = world.child("PhysicsScene", "PhysicsScene").put("physics:gravityDirection", T.Vector3f, vector(direction))
    prim.put("physics:gravityMagnitude", T.Float, magnitude)


def _add_light(world: Prim) -> None:
    prim = world.child("Light", "DomeLight").put("inputs:intensity", T.Float, 500.0)
    prim.put("inputs:color", T.Color3f, Gf.Vec3f(1.0, 0.98, 0.95))


def _add_room(world: Prim, scene: Scene, physics: Physics, looks: Looks) -> None:
    prim = world.child("Room", "Xform", kind=Kind.Tokens.component, apis=[_LABELS])
    _label(prim, "room")
    colours = palette(scene.seed)
    _add_floor(prim, scene.room, physics, looks, colours)
    names: dict[str, list[Any]] = {wall.name: [] for wall in scene.room.walls}
    for slab in wall_slabs(scene.room, physics.wall_thickness):
        names[slab.name.partition("/")[0]].append(slab)
    for name, slabs in names.items():
        wall = prim.child(name, "Xform", apis=[_LABELS])
        _label(wall, "wall")
        boxes = [_box(slab.size, slab.position, yaw_quat(slab.yaw)) for slab in slabs]
        if boxes:
            parts = [box_polygons(b.size, b.position, rotation(b.quat_wxyz)) for b in boxes]
            add_mesh(wall.child("Visual", "Scope"), "wall", parts, looks, "wall", colours.wall)
            add_colliders(wall, boxes, looks, physics.ground_friction)


def _box(size: Vec3, position: Vec3, quat_wxyz: Quat = (1.0, 0.0, 0.0, 0.0)) -> Shape:
    return Shape(kind="box", size=size, position=position, quat_wxyz=quat_wxyz)


def _add_floor(parent: Prim, room: Room, physics: Physics, looks: Looks, colours: Palette) -> None:
    floor = parent.child("floor", "Xform", apis=[_LABELS])
    _label(floor, "floor")
    add_mesh(floor.child("Visual", "Scope"), "floor", [_floor_polygons(room)], looks, "floor", colours.floor)
    width, depth = (extent + 2 * physics.wall_thickness for extent in room.extent)
    centre = (room.extent[0] / 2, room.extent[1] / 2, -_FLOOR_THICKNESS / 2)
    add_colliders(floor, [_box((width, depth, _FLOOR_THICKNESS), centre)], looks, physics.ground_friction)


def _floor_polygons(room: Room) -> Polygons:
    triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(room.polygon))
    rings = [shapely.get_coordinates(shapely.orient_polygons(triangle))[:3] for triangle in triangles]
    points = np.pad(np.vstack(rings), ((0, 0), (0, 1)))
    normals = np.tile((0.0, 0.0, 1.0), (len(points), 1))
    return Polygons(points, normals, [3] * len(triangles), list(range(len(points))))


def _label(prim: Prim, label: str) -> None:
    prim.put("semantics:labels:class", T.TokenArray, [label])


class _Object:
    """One placement on its way into the stage."""

    def __init__(self, placement: Placement, asset: Asset, model: Any, data: Any, looks: Looks) -> None:
        self._id, self._category, self._asset = placement.id, placement.category, asset
        self._model, self._data, self._looks = model, data, looks
        self._moving = [(link, link.joint) for link in asset.links[1:] if link.joint is not None]

    def add(self, parent: Prim) -> None:
        """An articulation with its links side by side, or one body, or for what is fixed colliders and looks only."""
        body = self._model.body(self._id).id
        position, turn = self._data.xpos[body].tolist(), self._data.xquat[body].tolist()
        rigid = self._asset.free and not self._moving
        apis = [_LABELS, *(_BODY if rigid else ()), *(["PhysicsArticulationRootAPI"] if self._moving else [])]
        prim = parent.child(self._id, "Xform", apis=apis, kind=Kind.Tokens.component).place(position, turn)
        _label(prim, self._category)
        if self._moving:
            self._add_links(prim, position, turn)
        else:
            self._fill(prim, self._base_shapes(), body if rigid else None)

    def _add_links(self, prim: Prim, position: Any, turn: Any) -> None:
        base = self._add_link(prim, self._asset.links[0].name, self._base_shapes(), self._id)
        links: list[tuple[Link, Joint, Prim]] = []
        for link, joint in self._moving:
            child = self._add_link(prim, link.name, link.shapes, f"{self._id}/{link.name}")
            child.link("physics:filteredPairs", [other.path for _, _, other in links])
            links.append((link, joint, child))
        joints = prim.child("Joints", "Scope")
        if not self._asset.free:
            fix_to_room(joints, base.path, position, turn)
        for link, joint, child in links:
            add_joint(joints, link.name, joint, base.path, child.path)

    def _add_link(self, parent: Prim, name: str, shapes: tuple[Shape, ...], body_name: str) -> Prim:
        body = self._model.body(body_name).id
        apis = [_LABELS, *_BODY, *(["PhysicsFilteredPairsAPI"] if body_name != self._id else [])]
        prim = parent.child(name, "Xform", apis=apis).place(*self._relative(body))
        _label(prim, name)
        self._fill(prim, shapes, body)
        return prim

    def _relative(self, body: int) -> tuple[Any, Any]:
        """Pose of a body in the frame of the object."""
        root, data = self._model.body(self._id).id, self._data
        back, position, turn = np.zeros(4), np.zeros(3), np.zeros(4)
        mujoco.mju_negQuat(back, data.xquat[root])
        mujoco.mju_rotVecQuat(position, data.xpos[body] - data.xpos[root], back)
        mujoco.mju_mulQuat(turn, back, data.xquat[body])
        return position.tolist(), turn.tolist()

    def _base_shapes(self) -> tuple[Shape, ...]:
        """Shapes of the body and of links that do not move against it."""
        first, *rest = self._asset.links
        return first.shapes + tuple(shape for link in rest if link.joint is None for shape in link.shapes)

    def _fill(self, prim: Prim, shapes: tuple[Shape, ...], body: int | None) -> None:
        if body is not None:
            _put_mass(prim, self._model, body)
        add_visuals(prim, shapes, self._looks)
        add_colliders(prim, shapes, self._looks, self._asset.friction)


_BODY = ("PhysicsRigidBodyAPI", "PhysicsMassAPI")


def _put_mass(prim: Prim, model: Any, body: int) -> None:
    prim.put("physics:mass", T.Float, float(model.body_mass[body]))
    prim.put("physics:centerOfMass", T.Point3f, vector(model.body_ipos[body]))
    prim.put("physics:diagonalInertia", T.Float3, vector(model.body_inertia[body]))
    prim.put("physics:principalAxes", T.Quatf, quaternion(model.body_iquat[body]))
