"""The room of a MuJoCo model: what is seen of it, lights, cameras, and the viewer's first look."""

import math

import mujoco

from thinkblox.exporters.cameras import AZIMUTH, ELEVATION, cameras_of, lights_of, middle_of
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.mjcf_meshes import Stock
from thinkblox.exporters.naming import Names
from thinkblox.exporters.room_parts import RoomParts
from thinkblox.scene.room import Room
from thinkblox.sim.build import GROUND, VISUAL

WALL_GROUP = 1
"""The group of what is seen of walls and ceiling, which a viewer can hide."""
_BRIGHT = 0.35
"""What all lights give together, to what faces them."""


def dress_room(spec: mujoco.MjSpec, inventory: Inventory, parts: RoomParts, stock: Stock) -> None:
    """Name the geoms of floor and walls, and add what is seen of the room, lights and cameras."""
    names = Names(wall.name for wall in inventory.walls)
    friction = {wall.name: wall.geoms[0].friction for wall in inventory.walls if wall.geoms}
    for geom in spec.worldbody.geoms:
        wall, _, number = geom.name.partition("/")
        geom.name = names.give(f"{wall}_part_{number}") if number else wall
        geom.friction = friction[wall]
    for part in parts.parts:
        seen = spec.worldbody.add_geom(spec.find_default(VISUAL), type=mujoco.mjtGeom.mjGEOM_MESH)
        seen.name = names.give(f"{part.name}_visual")
        seen.meshname, seen.material = stock.mesh(seen.name, part.mesh), stock.material(part.look)
        if part.name != GROUND:
            seen.group = WALL_GROUP
    _add_lights(spec, inventory.scene.room)
    for camera in cameras_of(inventory.scene):
        made = spec.worldbody.add_camera(name=camera.name, fovy=camera.fovy)
        made.pos, made.quat = camera.position, camera.quat_wxyz
    _set_view(spec, inventory.scene.room)


def _add_lights(spec: mujoco.MjSpec, room: Room) -> None:
    """Lights under the ceiling that shine down and to all sides; the viewer's own lamp fills the shadows.

    They are spots of half a sphere: of lights of type "point" MuJoCo 3.17 leaves the attenuation 0, and what is drawn
    then is left to the graphics library.
    """
    places = lights_of(room)
    share = _BRIGHT / len(places) ** 0.5
    for number, place in enumerate(places, 1):
        light = spec.worldbody.add_light(name=f"ceiling_light_{number}", pos=place, dir=(0.0, 0.0, -1.0))
        light.type, light.castshadow = mujoco.mjtLightType.mjLIGHT_SPOT, False
        light.cutoff, light.exponent = 90.0, 0.0
        light.diffuse, light.specular = (share,) * 3, (0.2 * share,) * 3
    spec.visual.headlight.ambient, spec.visual.headlight.diffuse = (0.55,) * 3, (0.3,) * 3
    spec.visual.headlight.specular = (0.05,) * 3
    spec.add_texture(
        name="sky", type=mujoco.mjtTexture.mjTEXTURE_SKYBOX, builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=(0.95, 0.97, 1.0), rgb2=(0.75, 0.82, 0.9), width=64, height=384,
    )  # fmt: skip


def _set_view(spec: mujoco.MjSpec, room: Room) -> None:
    """The whole room in the viewer's window, from above one corner."""
    spec.stat.center, spec.stat.extent = middle_of(room), math.hypot(*room.extent, room.height)
    view = spec.visual.global_
    view.azimuth, view.elevation = AZIMUTH, ELEVATION
    view.offwidth, view.offheight = 1920, 1080
