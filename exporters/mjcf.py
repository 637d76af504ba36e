"""A Scene as one MJCF file: the very model that was measured, with its looks and the keyframe "settled"."""

import math
from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np

from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import SettledState, add_keyframe, settle

AZIMUTH, ELEVATION = 125.0, -40.0
"""Where the viewer looks to at first [degrees]."""
_DISTANCE = 0.75
"""Distance of the named camera from the room's middle, in extents."""


def write_mjcf(
    scene: Scene, path: Path, *, settled: SettledState | None = None, physics: Physics | None = None
) -> None:
    """Write a scene as one MJCF file that needs no others; the same scene gives the same bytes.

    Its reference pose is the placements' own; the keyframe "settled" holds every object where it came to rest.

    Args:
        scene: what to write.
        path: of the file, "scene.xml".
        settled: the state at rest, where it is known already; worked out otherwise.
        physics: the engine's options.
    """
    Path(path).write_text(mjcf_text(scene, settled=settled, physics=physics), encoding="utf-8")


def mjcf_text(scene: Scene, *, settled: SettledState | None = None, physics: Physics | None = None) -> str:
    """The text of `write_mjcf`."""
    physics = physics or Physics()
    spec = build_spec(scene, visuals=True, physics=physics)
    settled = settled or settle(scene, physics=physics)
    add_keyframe(spec, settled)
    _set_view(spec, scene.room)
    compiled(spec)
    return _with_exact_poses(spec, settled)


def _with_exact_poses(spec: mujoco.MjSpec, settled: SettledState) -> str:
    """The model's XML with every digit of its poses, of which the engine writes six."""
    tree = ElementTree.fromstring(spec.to_xml())
    for element in tree.iterfind("worldbody/body"):
        body = spec.body(element.attrib["name"])
        element.set("pos", _numbers(body.pos))
        element.set("quat", _numbers(body.quat))
    for key in tree.iterfind("keyframe/key"):
        key.set("qpos", _numbers(settled.qpos))
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
