"""A room, what can stand in it, and what stands where: the values, and the geometry that needs no engine."""

from thinkblox.scene.asset import Asset, Joint, Link, Mount, Shape, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, Wall, rectangle
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.scene.visuals import Look, MeshVisual

__all__ = [
    "Asset",
    "Joint",
    "Link",
    "Look",
    "MeshVisual",
    "Mount",
    "Opening",
    "Placement",
    "Room",
    "Scene",
    "Shape",
    "Surface",
    "Wall",
    "load_scene",
    "rectangle",
]
