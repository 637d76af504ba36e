"""What a driver is given: an exported room, and what the engine that measured it makes of the same."""

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from msgspec import structs

from thinkblox.exporters.exporting import export_scene
from thinkblox.exporters.inventory import Inventory, InventoryObject
from thinkblox.exporters.naming import safe_name
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.exporters.usd import write_usd
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import add_placement, new_spec
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import settle
from thinkblox.value import Vec3

SECONDS = 2.0
"""How long a room is let alone [s]."""
TIMES = (0.4, 0.8)
"""When doors and drawers are looked at [s]."""
TILTED = (2.0, 0.0, -9.6)
"""Gravity that draws doors and drawers open, in the frame of what they are part of [m/s2]."""

_OBJECTS, _WIDE = "/World/Objects", 8.0
"""Where things are in USD, and the sides of the room [m] in which one is alone."""


def write_case(scene: Scene, folder: Path, dropped: Mapping[str, Vec3] | None = None) -> dict[str, Any]:
    """Export a room into a folder with `case.json`; returns that.

    Things stand where they came to rest, but for those that are `dropped`, from where they are by id [m]; the room's
    doors and windows are things too. `swinging` are the assets with doors and drawers, each alone and held still, and
    `swings` how far these are open at the times in MuJoCo [rad, m], and `slipping` the same with nothing that rubs in
    their joints. `stage` is the room in USD, where each thing has `prims`, and that of what swings is it alone.
    """
    inventory = inventory_of(scene, doors=True)
    export_scene(scene, folder, formats=("mjcf", "urdf", "sdf"), doors=True, overwrite=True)
    things = [_thing(item, folder) for item in inventory.objects]
    for thing in things:
        thing["position"] = (dropped or {}).get(thing["id"], thing["rests"])
    write_usd(_dropped(inventory, dropped or {}), folder / "room.usdc")
    walls = [
        {"position": g.shape.position, "quat": g.shape.quat_wxyz, "size": g.shape.size, "friction": g.friction[0]}
        for wall in inventory.walls
        for g in wall.geoms
        if g.shape is not None
    ]
    swinging = {thing["asset"]: thing for thing in things if thing["joints"]}
    for number, thing in enumerate(swinging.values()):
        thing |= _alone(inventory.scene, inventory.scene[thing["id"]], folder / f"swinging_{number}")
    case = {
        "folder": str(folder),
        "stage": str(folder / "room.usdc"),
        "timestep": inventory.physics.timestep,
        "gravity": inventory.physics.gravity,
        "tilted": TILTED,
        "seconds": SECONDS,
        "times": TIMES,
        "things": things,
        "boxes": walls,
        "swinging": list(swinging.values()),
        "swings": _swings(inventory.scene, list(swinging.values())),
        "slipping": _swings(inventory.scene, list(swinging.values()), rubbing=False),
    }
    (folder / "case.json").write_text(json.dumps(case))
    return case


def _thing(item: InventoryObject, folder: Path) -> dict[str, Any]:
    first = item.bodies[0]
    called = re.compile(re.escape(safe_name(item.asset)) + r"_[0-9a-f]{8}\.urdf")
    models = [file for file in (folder / "assets").iterdir() if called.fullmatch(file.name)]
    friction = next((geom.friction[0] for body in item.bodies for geom in body.geoms if geom.collides), 0.0)
    return {
        "name": item.name,
        "id": item.id,
        "asset": item.asset,
        "model": str(models[0]),
        "prims": _prims(item),
        "free": item.free,
        "collides": any(geom.collides for body in item.bodies for geom in body.geoms),
        "rests": first.settled[0],
        "quat": first.settled[1],
        "mass": sum(body.mass for body in item.bodies),
        "friction": friction,
        # As a model has them, whose links have plain names.
        "joints": {f"{safe_name(body.link)}_joint": body.source for body in item.bodies[1:]},
    }


def _dropped(inventory: Inventory, dropped: Mapping[str, Vec3]) -> Inventory:
    """An inventory in which some things are elsewhere [m]."""

    def put(item: InventoryObject) -> InventoryObject:
        if item.id not in dropped:
            return item
        first, *rest = item.bodies
        return replace(item, bodies=(replace(first, settled=(dropped[item.id], first.settled[1])), *rest))

    return replace(inventory, objects=tuple(put(item) for item in inventory.objects))


def _alone(scene: Scene, placement: Placement, folder: Path) -> dict[str, Any]:
    """One thing as MJCF and as a stage, held where it is and under tilted gravity, and what its joints are there.

    Of each joint there are its prim, and the bodies of the MJCF that it joins, and whether it slides.
    """
    asset = structs.replace(scene.asset_of(placement), mount="wall")
    alone = Scene(room=rectangle(_WIDE, _WIDE, height=_WIDE))
    alone = alone.with_placement(structs.replace(placement, position=(_WIDE / 2, _WIDE / 2, 0.0), yaw=0.0), asset)
    inventory = inventory_of(alone, settled=settle(alone), physics=Physics(gravity=TILTED))
    stage = folder.with_suffix(".usdc")
    write_usd(inventory, stage)
    export_scene(alone, folder, formats=("mjcf",))
    (item,) = inventory.objects
    joints = {f"{safe_name(body.link)}_joint": body for body in item.bodies[1:]}
    return {
        "stage": str(stage),
        "joint_prims": {joint: f"{_OBJECTS}/{item.name}/Joints/{body.name}" for joint, body in joints.items()},
        "mjcf": str(folder),
        "links": {
            joint: [body.parent, body.name, body.joint is not None and body.joint.kind == "slide"]
            for joint, body in joints.items()
        },
    }


def _prims(item: InventoryObject) -> list[str]:
    """The prims of its bodies in USD, the first before the others."""
    whole = f"{_OBJECTS}/{item.name}"
    return [f"{whole}/{body.name}" for body in item.bodies] if len(item.bodies) > 1 else [whole]


def _swings(
    scene: Scene, swinging: Sequence[dict[str, Any]], *, rubbing: bool = True
) -> dict[str, dict[str, list[float]]]:
    found = {}
    for thing in swinging:
        physics = Physics(gravity=TILTED)
        spec, placement = new_spec(physics), scene[thing["id"]]
        add_placement(spec, _at_origin(placement), scene.asset_of(placement), free=False)
        model = spec.compile()
        if not rubbing:
            model.dof_frictionloss[:] = 0.0
        data, seen = mujoco.MjData(model), dict[str, list[float]]()
        for time in TIMES:
            while data.time < time - 1e-9:
                mujoco.mj_step(model, data)
            for joint, source in thing["joints"].items():
                seen.setdefault(joint, []).append(float(data.qpos[model.joint(source).qposadr[0]]))
        found[thing["asset"]] = seen
    return found


def _at_origin(placement: Placement) -> Placement:
    return structs.replace(placement, position=(0.0, 0.0, 0.0), yaw=0.0)


def moved(case: dict[str, Any], poses: dict[str, Any]) -> tuple[float, float, str]:
    """The farthest that a free thing went [mm] and turned [degrees], and which went farthest."""
    worst, turned, which = 0.0, 0.0, ""
    for thing in case["things"]:
        if not thing["free"] or thing["name"] not in poses:
            continue
        position, quat = (np.asarray(each) for each in poses[thing["name"]])
        away = float(np.linalg.norm(position - thing["rests"])) * 1000.0
        same = min(abs(float(quat @ thing["quat"])) / float(np.linalg.norm(quat)), 1.0)
        turned = max(turned, float(np.degrees(2.0 * np.arccos(same))))
        if away > worst:
            worst, which = away, thing["name"]
    return worst, turned, which
