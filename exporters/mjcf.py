"""A Scene as MJCF: the very model that was measured, dressed to be looked at, under names that every reader takes."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import msgspec
import mujoco
import numpy as np

from thinkblox.exporters.beside import write_beside
from thinkblox.exporters.credits import credits_of
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.mjcf_bodies import dress_objects
from thinkblox.exporters.mjcf_flavors import FLAVORS
from thinkblox.exporters.mjcf_meshes import Stock
from thinkblox.exporters.mjcf_room import dress_room
from thinkblox.exporters.room_parts import room_parts
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled
from thinkblox.sim.verdict.settle import add_keyframe

_EXACT = {
    "body": ("pos", "quat"),
    "geom": ("pos", "quat", "size", "mass"),
    "joint": ("pos", "axis", "range", "frictionloss", "damping"),
    "site": ("pos", "quat", "size"),
    "camera": ("pos", "quat"),
}
"""What is written with every digit; the engine writes six."""


_DROWSY = 0.005
"""What is slower falls asleep [m/s]: a lamp on a small round foot trembles by 2 mm/s in the solver for many seconds."""


def write_mjcf(inventory: Inventory, path: Path, *, flavor: str | None = None) -> None:
    """Write a scene as MJCF, with the meshes and textures that it names in `assets` beside it.

    Its reference pose is the placements' own; the keyframe "settled" holds every object where it came to rest. The
    same scene gives the same bytes. `flavor` is one of `FLAVORS`.
    """
    spec = spec_of(inventory, flavor=flavor)
    path.write_text(_text(spec, inventory), encoding="utf-8")
    write_beside(path, spec.assets)


def write_single_mjcf(inventory: Inventory, path: Path) -> None:
    """Write a scene as one MJCF file that names no other: hulls are their points, textures are plain colours."""
    path.write_text(mjcf_text(inventory), encoding="utf-8")


def mjcf_text(inventory: Inventory) -> str:
    """The text of `write_single_mjcf`."""
    return _text(spec_of(inventory, alone=True), inventory)


def spec_of(inventory: Inventory, *, alone: bool = False, flavor: str | None = None) -> mujoco.MjSpec:
    """The very model that was measured, under safe names, with looks, keyframes, views and credits.

    Args:
        inventory: of the scene.
        alone: without files: meshes lie in the spec, textures are left out; they are in the spec's assets otherwise.
        flavor: one of `FLAVORS`; None for the Menagerie's conventions.
    """
    spec = build_spec(inventory.scene, physics=inventory.physics)
    spec.option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    spec.option.sleep_tolerance = _DROWSY
    parts = room_parts(inventory)
    stock = Stock(spec, {**inventory.looks, **parts.looks}, parts.pictures, alone=alone)
    dress_room(spec, inventory, parts, stock)
    dress_objects(spec, inventory, stock)
    if flavor is not None:
        FLAVORS[flavor](spec, inventory, stock)
    add_keyframe(spec, inventory.state)
    spec.add_key(name="home", qpos=_home(inventory))
    if inventory.objects:
        spec.add_text(name="credits", data=_json(msgspec.to_builtins(credits_of(inventory.scene))))
        spec.add_text(name="objects", data=_json(_said(inventory)))
    compiled(spec)
    return spec


def _json(value: Any) -> str:
    """A value as JSON in which nothing can end the CDATA that the engine puts it into."""
    return json.dumps(value).replace(">", "\\u003e")


def _home(inventory: Inventory) -> list[float]:
    """The placements' own poses, with every door and drawer shut."""
    qpos: list[float] = []
    for item in inventory.objects:
        if item.free:
            position, quat_wxyz = item.bodies[0].proposed
            qpos += [*position, *quat_wxyz]
        qpos += [0.0 for body in item.bodies if body.joint is not None]
    return qpos


def _said(inventory: Inventory) -> dict[str, dict[str, Any]]:
    """What the model cannot say otherwise: the scene's own ids, categories and assets, and the links' own names."""
    return {
        item.name: {
            "id": item.id,
            "category": item.category,
            "asset": item.asset,
            "links": {body.name: body.link for body in item.bodies[1:]},
        }
        for item in inventory.objects
    }


def _text(spec: mujoco.MjSpec, inventory: Inventory) -> str:
    """The model's XML with every digit of what was measured."""
    tree = ElementTree.fromstring(spec.to_xml())
    for element in tree.find("worldbody").iter():  # type: ignore[union-attr]
        if element.tag in _EXACT and "name" in element.attrib:
            _make_exact(element, getattr(spec, element.tag)(element.attrib["name"]))
    for body in tree.iterfind(".//body"):
        _weigh_exactly(body.find("inertial"), spec.body(body.attrib["name"]))
    for geom in tree.iterfind("default//geom[@solref]"):
        # Newton takes one value for none.
        geom.set("solref", _numbers(inventory.physics.solref))
    for element in tree.iterfind("custom/text"):
        # The engine writes text with quotes as CDATA, which this tree does not keep, and reads no other content.
        element.set("data", element.get("data", element.text or ""))
        element.text = None
    for key in tree.iterfind("keyframe/key"):
        key.set("qpos", _numbers(spec.key(key.attrib["name"]).qpos))
    ElementTree.indent(tree, "  ")
    return ElementTree.tostring(tree, encoding="unicode") + "\n"


def _make_exact(element: ElementTree.Element, made: Any) -> None:
    for attribute in _EXACT[element.tag]:
        if attribute in element.attrib:
            values = np.atleast_1d(getattr(made, attribute))[: len(element.attrib[attribute].split())]
            # The spec has degrees, the engine writes radians.
            turns = attribute == "range" and made.type == mujoco.mjtJoint.mjJNT_HINGE
            element.set(attribute, _numbers(np.radians(values) if turns else values))


def _weigh_exactly(inertial: ElementTree.Element | None, made: mujoco.MjsBody) -> None:
    """Give a body whose mass is written every digit of it: what is tiny or flat has no other inertia that can be."""
    if inertial is not None:
        inertial.attrib.clear()
        values = {"pos": made.ipos, "quat": made.iquat, "mass": (made.mass,), "diaginertia": made.inertia}
        for attribute, found in values.items():
            inertial.set(attribute, _numbers(found))


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{float(value):.12g}" for value in values)


def to_mjspec(scene: Scene, *, doors: bool = False) -> mujoco.MjSpec:
    """A scene as an MjSpec to build on: the model that is exported, with all files in its assets.

    A robot's spec can be attached to a site or frame of it. Its keyframe "settled" is where everything rests. With
    `doors` the room's doors have leaves on hinges, and its windows panes.
    """
    return spec_of(inventory_of(scene, doors=doors))


def to_mjmodel(scene: Scene, *, doors: bool = False) -> mujoco.MjModel:
    """A scene as a compiled model: that of `to_mjspec`."""
    return compiled(to_mjspec(scene, doors=doors))
