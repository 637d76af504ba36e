"""The room in USD: floor, walls, ceiling, doors and windows, each labelled, with colliders where there are any."""

from collections.abc import Callable, Mapping
from typing import Any

from pxr import Kind, Sdf

from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.room_parts import RoomParts
from thinkblox.exporters.usd_assets import AssetLayers
from thinkblox.exporters.usd_looks import Looks
from thinkblox.exporters.usd_objects import LABELS, add_label
from thinkblox.exporters.usd_prims import Prim, T, put_units
from thinkblox.exporters.usd_shapes import add_colliders, add_textured

_ROOM = "Room"
"""The default prim of the room's layer."""


def add_room(
    world: Prim, inventory: Inventory, parts: RoomParts, looks: Looks, layers: AssetLayers | None = None
) -> None:
    """Add everything that is seen of the room and everything of it that can be touched.

    What is seen is in a layer of its own where there are layers.
    """
    room = world.child("Room", "Xform", kind=Kind.Tokens.component, apis=[LABELS])
    add_label(room, "room")
    made: dict[str, Prim] = {}
    labels = {wall.name: wall.label for wall in inventory.walls} | {part.name: part.label for part in parts.parts}
    file = None if layers is None else layers.add(_seen_layer(inventory, parts))
    seen = {part.name for part in parts.parts}
    for name, label in labels.items():
        made[name] = room.child(name, "Xform", apis=[LABELS])
        add_label(made[name], label)
        if name in seen and file is not None:
            path = Sdf.Path(f"/{_ROOM}").AppendChild(made[name].spec.name).AppendChild("Visual")
            made[name].child("Visual", "Scope").load(f"./{file}", path)
    if file is None:
        _add_seen(made, parts, lambda scope: looks)
    for wall in inventory.walls:
        if wall.geoms:
            scope = made[wall.name].child("Collision", "Scope").put("purpose", T.Token, "guide", uniform=True)
            add_colliders(scope, wall.geoms, looks)


def _add_seen(made: Mapping[str, Prim], parts: RoomParts, looks: Callable[[Prim], Looks]) -> None:
    """Give each part its scope "Visual"; `looks` are the materials for one."""
    scopes: dict[str, tuple[Prim, Looks]] = {}
    for part in parts.parts:
        if part.name not in scopes:
            scope = made[part.name].child("Visual", "Scope")
            scopes[part.name] = (scope, looks(scope))
        scope, materials = scopes[part.name]
        add_textured(scope, part.label, part.mesh, materials, part.look, pieces=part.pieces)


def _seen_layer(inventory: Inventory, parts: RoomParts) -> Any:
    """What is seen of the room, part by part, each with its materials."""
    layer, every = Sdf.Layer.CreateAnonymous(".usdc"), {**inventory.looks, **parts.looks}
    with Sdf.ChangeBlock():
        put_units(layer)
        layer.defaultPrim = _ROOM
        root = Prim(Sdf.PrimSpec(layer, _ROOM, Sdf.SpecifierDef, "Xform"))
        root.spec.kind = Kind.Tokens.component
        names = dict.fromkeys([*(wall.name for wall in inventory.walls), *(part.name for part in parts.parts)])
        made = {name: root.child(name, "Xform") for name in names}
        _add_seen(made, parts, lambda scope: Looks(scope.child("Looks", "Scope"), every, "."))
    return layer
