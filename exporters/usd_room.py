"""The room in USD: floor, walls, ceiling, doors and windows, each labelled, with colliders where there are any."""

from pxr import Kind

from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.room_parts import RoomParts
from thinkblox.exporters.usd_looks import BINDING, Looks
from thinkblox.exporters.usd_objects import LABELS, add_label
from thinkblox.exporters.usd_prims import Prim, T
from thinkblox.exporters.usd_shapes import add_colliders, add_textured


def add_room(world: Prim, inventory: Inventory, parts: RoomParts, looks: Looks) -> None:
    """Add everything that is seen of the room and everything of it that can be touched."""
    room = world.child("Room", "Xform", kind=Kind.Tokens.component, apis=[LABELS])
    add_label(room, "room")
    made: dict[str, Prim] = {}
    labels = {wall.name: wall.label for wall in inventory.walls} | {part.name: part.label for part in parts.parts}
    for name, label in labels.items():
        made[name] = room.child(name, "Xform", apis=[LABELS])
        add_label(made[name], label)
    scopes: dict[str, Prim] = {}
    for part in parts.parts:
        if part.name not in scopes:
            scopes[part.name] = made[part.name].child("Visual", "Scope")
        add_textured(scopes[part.name], part.label, part.mesh, looks, part.look)
    for wall in inventory.walls:
        if wall.geoms:
            scope = made[wall.name].child("Collision", "Scope", apis=[BINDING])
            scope.put("purpose", T.Token, "guide", uniform=True)
            looks.bind_friction(scope, wall.geoms[0].friction[0])
            add_colliders(scope, wall.geoms)
