"""The looks of shapes and meshes in the terms that engines share."""

import hashlib

import msgspec

from thinkblox.exporters.inventory import InventoryLook
from thinkblox.scene.surfaces import Covering
from thinkblox.scene.visuals import Look
from thinkblox.sim.render.layings import MAKES
from thinkblox.sim.render.materials import FINISHES, Reflectance
from thinkblox.value import Vec3

OPACITY = {"glass": 0.3}


def finish_look(material: str, colour: Vec3) -> InventoryLook:
    """The look of a shape of some material and colour, called by them, such as "wood_b98a5c"."""
    return _reflecting(material, colour, FINISHES[material])


def covering_look(covering: Covering) -> InventoryLook:
    """The look of a floor or a wall, called by its laying and colour, such as "brick_a5644e"."""
    return _reflecting(covering.laying, covering.colour, MAKES[covering.laying].reflectance)


def _reflecting(material: str, colour: Vec3, finish: Reflectance) -> InventoryLook:
    return InventoryLook(
        name=f"{material}_" + "".join(f"{round(channel * 255):02x}" for channel in colour),
        colour=colour,
        # The roughness whose highlight is as wide as that of the finish's Blinn-Phong exponent.
        roughness=round((2.0 / (finish.gloss + 2.0)) ** 0.25, 3),
        metallic=1.0 if finish.tinted else 0.0,
        opacity=OPACITY.get(material, 1.0),
        glow=finish.glow,
    )


def look_of(look: Look) -> InventoryLook:
    """The look of a mesh, called by the hash of its content."""
    return InventoryLook(
        name="look_" + hashlib.sha256(msgspec.json.encode(look)).hexdigest()[:16],
        colour=look.base_colour,
        roughness=look.roughness,
        metallic=look.metallic,
        texture=look.texture,
    )
