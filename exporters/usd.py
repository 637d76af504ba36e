"""A scene as a UsdPhysics stage: what its inventory says, in USD's terms."""

import math
import os
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import mujoco
from pxr import Gf, Kind, Sdf, Tf

from thinkblox.errors import InputError
from thinkblox.exporters.beside import texture_files, write_beside
from thinkblox.exporters.cameras import cameras_of, lights_of
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.room_parts import room_parts
from thinkblox.exporters.usd_assets import AssetLayers, Shelf
from thinkblox.exporters.usd_looks import Looks
from thinkblox.exporters.usd_objects import add_object
from thinkblox.exporters.usd_prims import Prim, T, in_binary, put_units, said, vector
from thinkblox.exporters.usd_room import add_room
from thinkblox.exporters.usd_verified import check_written
from thinkblox.scene.room import Room
from thinkblox.sim.build import package_version
from thinkblox.sim.settings import Physics

_SIMREADY = "SimReady_Metadata"
"""Where a prop's description is in its stage."""
MANY = 20
"""With more objects than these a stage is binary where its name leaves it open."""
_THEN = 946_684_800
"""When what is packed was made, as far as the package says: always, so that a scene has always the same bytes."""
_LAMP, _SHINE, _WARM = 0.1, 30000.0, (1.0, 0.98, 0.95)
"""Of the lights under the ceiling: radius [m], intensity and colour."""
_WIDE = 20.955
"""Width of the cameras' film [tenths of a unit, as USD has it]."""


def write_usd(inventory: Inventory, path: Path) -> None:
    """Write a scene as a stage that PhysX, Isaac, Newton, Genesis and Blender read, by the ending of `path`.

    ".usda" is text and ".usdc" binary, each with a layer for each asset and the textures beside it; ".usd" is binary
    from MANY objects on. ".usdz" is one file with all in it. Z up, metres, kilograms. Objects stand where MuJoCo let
    them come to rest, as in keyframe "settled" of the MJCF; their masses and inertias are those of the compiled model.
    Fixed objects are colliders without a body. What was written is read again and checked.
    """
    if path.suffix == ".usdz":
        _write_package(inventory, path)
    else:
        _write_layers(inventory, path)
    check_written(path, inventory)


def _write_layers(inventory: Inventory, path: Path) -> None:
    layers = AssetLayers(inventory)
    layer, binary = _layer(inventory, layers), path.suffix == ".usdc"
    if path.suffix == ".usd":
        binary = len(inventory.objects) > MANY
    if binary:
        path.write_bytes(in_binary(layer))
    else:
        path.write_text(layer.ExportToString(), encoding="utf-8")
    write_beside(path, layers.files)
    write_beside(path, texture_files(inventory, room_parts(inventory).pictures))


def write_prop(inventory: Inventory, path: Path, described: Mapping[str, str]) -> None:
    """Write the objects of an inventory without their room, as text, with more metadata; read again and checked."""
    layers = AssetLayers(inventory)
    layer = Sdf.Layer.CreateAnonymous(".usda")
    with Sdf.ChangeBlock():
        world = _stage(layer, inventory)
        layer.customLayerData = {**layer.customLayerData, **described, _SIMREADY: dict(described)}
        _add_physics(world, inventory.physics)
        _add_objects(world, inventory, Shelf(layer, inventory.looks, layers))
    path.write_text(layer.ExportToString(), encoding="utf-8")
    write_beside(path, layers.files | texture_files(inventory, {}))
    check_written(path, inventory)


def usd_text(inventory: Inventory) -> str:
    """A scene as one text that needs no file but the textures."""
    return str(_layer(inventory).ExportToString())


def _write_package(inventory: Inventory, path: Path) -> None:
    """One flat binary layer with its textures, packed: viewers show nothing of payloads in a package."""
    with TemporaryDirectory() as folder:
        stage = Path(folder) / "scene.usdc"
        stage.write_bytes(in_binary(_layer(inventory)))
        write_beside(stage, texture_files(inventory, room_parts(inventory).pictures))
        for file in Path(folder).rglob("*"):
            os.utime(file, (_THEN, _THEN))
        packed = Path(folder) / "scene.usdz"
        if not _packed(stage, packed):
            raise InputError(f"{path}: USD cannot pack the scene, in {folder}")
        path.write_bytes(packed.read_bytes())


def _packed(stage: Path, packed: Path) -> bool:
    from pxr import UsdUtils  # which brings shaders along, and is for packages alone

    try:
        return bool(UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(stage)), str(packed)))
    except Tf.ErrorException:
        return False


def _layer(inventory: Inventory, layers: AssetLayers | None = None) -> Any:
    layer = Sdf.Layer.CreateAnonymous(".usda")
    with Sdf.ChangeBlock():
        world, parts = _stage(layer, inventory), room_parts(inventory)
        looks = Looks(world.child("Looks", "Scope"), {**inventory.looks, **parts.looks})
        _add_physics(world, inventory.physics)
        _add_lights(world, inventory.scene.room)
        _add_cameras(world, inventory)
        add_room(world, inventory, parts, looks, layers)
        _add_objects(world, inventory, Shelf(layer, inventory.looks, layers))
    return layer


def _add_objects(world: Prim, inventory: Inventory, shelf: Shelf) -> None:
    objects = world.child("Objects", "Xform", kind=Kind.Tokens.group)
    for item in inventory.objects:
        add_object(objects, item, shelf)


def _stage(layer: Any, inventory: Inventory) -> Prim:
    layer.documentation = "A furnished room at rest. Poses are those of the settled state."
    put_units(layer)
    layer.customLayerData = said(
        {
            "creator": f"thinkblox {package_version()}",
            "mujoco": mujoco.__version__,
            "prompt": inventory.scene.prompt,
            "seed": str(inventory.scene.seed),
        }
    )
    layer.defaultPrim = "World"
    world = Prim(Sdf.PrimSpec(layer, "World", Sdf.SpecifierDef, "Xform"))
    world.spec.kind = Kind.Tokens.assembly
    return world


def _add_physics(world: Prim, physics: Physics) -> None:
    magnitude = math.hypot(*physics.gravity)
    direction = [part / magnitude for part in physics.gravity]
    prim = world.child("PhysicsScene", "PhysicsScene").put("physics:gravityDirection", T.Vector3f, vector(direction))
    prim.put("physics:gravityMagnitude", T.Float, magnitude)


def _add_lights(world: Prim, room: Room) -> None:
    """Balls of light under the ceiling, and a faint sky for who hides it."""
    scope = world.child("Lights", "Scope")
    for number, place in enumerate(lights_of(room), 1):
        prim = scope.child(f"ceiling_light_{number}", "SphereLight").put("inputs:radius", T.Float, _LAMP)
        prim.put("inputs:intensity", T.Float, _SHINE).put("inputs:color", T.Color3f, Gf.Vec3f(*_WARM))
        prim.extent((-_LAMP,) * 3, (_LAMP,) * 3).place(place)
    prim = scope.child("sky", "DomeLight").put("inputs:intensity", T.Float, 500.0)
    prim.put("inputs:color", T.Color3f, Gf.Vec3f(*_WARM))


def _add_cameras(world: Prim, inventory: Inventory) -> None:
    scope = world.child("Cameras", "Scope")
    for camera in cameras_of(inventory.scene):
        prim = scope.child(camera.name, "Camera").place(camera.position, camera.quat_wxyz)
        high = _WIDE * 3 / 4
        prim.put("horizontalAperture", T.Float, _WIDE).put("verticalAperture", T.Float, high)
        prim.put("focalLength", T.Float, high / 2 / math.tan(math.radians(camera.fovy) / 2))
        prim.put("clippingRange", T.Float2, Gf.Vec2f(0.02, 1000.0))
