"""A scene as a UsdPhysics stage: what its inventory says, in USD's terms."""

import math
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import shapely
from pxr import Gf, Kind, Sdf

from thinkblox.exporters.beside import texture_files, write_beside
from thinkblox.exporters.inventory import Inventory, InventoryWall
from thinkblox.exporters.usd_looks import Looks
from thinkblox.exporters.usd_objects import LABELS, add_label, add_object
from thinkblox.exporters.usd_prims import Prim, T, vector
from thinkblox.exporters.usd_shapes import Polygons, add_colliders, add_mesh, placed
from thinkblox.scene.room import Room
from thinkblox.sim.build import GROUND, package_version
from thinkblox.sim.settings import Physics


def write_usd(inventory: Inventory, path: Path) -> None:
    """Write a scene as one ASCII stage that PhysX, Isaac, Newton, Genesis and Blender read, its textures beside it.

    Z up, metres, kilograms. Objects stand where MuJoCo let them come to rest, as in keyframe "settled" of the MJCF;
    their masses and inertias are those of the compiled model. Fixed objects are colliders without a body.
    """
    path.write_text(usd_text(inventory), encoding="utf-8")
    write_beside(path, texture_files(inventory))


def usd_text(inventory: Inventory) -> str:
    """The text of `write_usd`."""
    layer = Sdf.Layer.CreateAnonymous(".usda")
    with Sdf.ChangeBlock():
        world = _stage(layer, inventory)
        looks = Looks(world.child("Looks", "Scope"), inventory.looks)
        _add_physics(world, inventory.physics)
        _add_light(world)
        _add_room(world, inventory, looks)
        objects = world.child("Objects", "Xform", kind=Kind.Tokens.group)
        for item in inventory.objects:
            add_object(objects, item, looks)
    return str(layer.ExportToString())


def _stage(layer: Any, inventory: Inventory) -> Prim:
    layer.documentation = "A furnished room at rest. Poses are those of the settled state."
    root = layer.pseudoRoot
    for key, value in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        root.SetInfo(key, value)
    layer.customLayerData = {
        "creator": f"thinkblox {package_version()}",
        "mujoco": mujoco.__version__,
        "prompt": inventory.scene.prompt,
        "seed": str(inventory.scene.seed),
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


def _add_room(world: Prim, inventory: Inventory, looks: Looks) -> None:
    prim = world.child("Room", "Xform", kind=Kind.Tokens.component, apis=[LABELS])
    add_label(prim, "room")
    for wall in inventory.walls:
        _add_wall(prim, wall, inventory.scene.room, looks)


def _add_wall(parent: Prim, wall: InventoryWall, room: Room, looks: Looks) -> None:
    prim = parent.child(wall.name, "Xform", apis=[LABELS])
    add_label(prim, wall.label)
    boxes = [geom.shape for geom in wall.geoms if geom.shape is not None]
    # The floor's box reaches under the walls; what is seen of it is the room's own outline.
    parts = [_floor_polygons(room)] if wall.name == GROUND else [placed(box) for box in boxes]
    if parts:
        add_mesh(prim.child("Visual", "Scope"), wall.label, parts, looks, wall.look)
        add_colliders(prim, wall.geoms, looks)


def _floor_polygons(room: Room) -> Polygons:
    triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(room.polygon))
    rings = [shapely.get_coordinates(shapely.orient_polygons(triangle))[:3] for triangle in triangles]
    points = np.pad(np.vstack(rings), ((0, 0), (0, 1)))
    normals = np.tile((0.0, 0.0, 1.0), (len(points), 1))
    return Polygons(points, normals, [3] * len(triangles), list(range(len(points))))
