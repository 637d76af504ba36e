"""A Scene as one MJCF file: the very model that was measured, with its looks and the keyframe "settled"."""

import json
import math
from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

import msgspec
import mujoco
import numpy as np

from thinkblox.exporters.beside import write_beside
from thinkblox.exporters.credits import credits_of
from thinkblox.exporters.inventory import Inventory
from thinkblox.scene.room import Room
from thinkblox.sim.build import build_spec, compiled
from thinkblox.sim.verdict.settle import add_keyframe

AZIMUTH, ELEVATION = 125.0, -40.0
"""Where the viewer looks to at first [degrees]."""
_DISTANCE = 0.75
"""Distance of the named camera from the room's middle, in extents."""


def write_mjcf(inventory: Inventory, path: Path) -> None:
    """Write a scene as one MJCF file, with the meshes and textures that it names beside it, if there are any.

    Its reference pose is the placements' own; the keyframe "settled" holds every object where it came to rest. The
    same scene gives the same bytes.
    """
    spec = _spec(inventory)
    path.write_text(_with_exact_poses(spec, inventory), encoding="utf-8")
    write_beside(path, spec.assets)


def mjcf_text(inventory: Inventory) -> str:
    """The text of `write_mjcf`."""
    return _with_exact_poses(_spec(inventory), inventory)


def _spec(inventory: Inventory) -> mujoco.MjSpec:
    """The very model that was measured, with looks, keyframe, view and credits."""
    spec = build_spec(inventory.scene, visuals=True, physics=inventory.physics)
    add_keyframe(spec, inventory.state)
    if inventory.objects:
        spec.add_text(name="credits", data=json.dumps(msgspec.to_builtins(credits_of(inventory.scene))))
    _set_view(spec, inventory.scene.room)
    compiled(spec)
    return spec


def _with_exact_poses(spec: mujoco.MjSpec, inventory: Inventory) -> str:
    """The model's XML with every digit of its poses, of which the engine writes six."""
    poses = {item.id: item.bodies[0].proposed for item in inventory.objects}
    tree = ElementTree.fromstring(spec.to_xml())
    for element in tree.iterfind("worldbody/body"):
        position, quat_wxyz = poses[element.attrib["name"]]
        element.set("pos", _numbers(position))
        element.set("quat", _numbers(quat_wxyz))
    for element in tree.iterfind("custom/text"):
        # The engine writes text with quotes as CDATA, which this tree does not keep, and reads no other content.
        element.set("data", element.get("data", element.text or ""))
        element.text = None
    for key in tree.iterfind("keyframe/key"):
        key.set("qpos", _numbers(inventory.state.qpos))
    ElementTree.indent(tree, "  ")
    return ElementTree.tostring(tree, encoding="unicode") + "\n"


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{float(value):.12g}" for value in values)


def _set_view(spec: mujoco.MjSpec, room: Room) -> None:
    """The whole room in the viewer's window, from above one corner, and the same as a camera "overview"."""
    width, depth = room.extent
    extent = math.hypot(width, depth, room.height)
    centre = (width / 2, depth / 2, room.height / 3)
    spec.stat.center, spec.stat.extent = centre, extent
    view = spec.visual.global_
    view.azimuth, view.elevation = AZIMUTH, ELEVATION
    turn, tilt = math.radians(AZIMUTH), math.radians(ELEVATION)
    ahead = np.array([math.cos(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), math.sin(tilt)])
    right = np.array([math.sin(turn), -math.cos(turn), 0.0])
    camera = spec.worldbody.add_camera(name="overview", fovy=view.fovy)
    camera.pos = np.array(centre) - 2 * _DISTANCE * extent * ahead
    mujoco.mju_mat2Quat(camera.quat, np.column_stack([right, np.cross(right, ahead), -ahead]).ravel())
