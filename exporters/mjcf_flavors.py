"""Ways of writing a room for those who read MJCF with conventions of their own."""

from collections.abc import Callable

import mujoco

from thinkblox.exporters.hulls import drum_of, hull_of
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.mjcf_meshes import Stock
from thinkblox.scene.asset import Shape
from thinkblox.sim.build import COLLISION, VISUAL
from thinkblox.sim.geometry.collider import collider

Flavor = Callable[[mujoco.MjSpec, Inventory, Stock], None]
_SOLID, _SEEN = 0, 1
"""Robosuite's groups of what collides and what is seen."""


def for_robosuite(spec: mujoco.MjSpec, inventory: Inventory, stock: Stock) -> None:
    """Collision in group 0, looks in group 1, and the three sites by which an object is put down.

    They are "<object>_bottom_site", "<object>_top_site" and "<object>_horizontal_radius_site".
    """
    spec.find_default(COLLISION).geom.group = _SOLID
    spec.find_default(VISUAL).geom.group = _SEEN
    for geom in spec.geoms:
        geom.group = _SOLID if geom.contype else _SEEN
    scene = inventory.scene
    for item, placement in zip(inventory.objects, scene.placements, strict=True):
        x, y, z = scene.asset_of(placement).size
        places = {"bottom": (0.0, 0.0, 0.0), "top": (0.0, 0.0, z), "horizontal_radius": (x / 2, y / 2, 0.0)}
        for name, place in places.items():
            spec.body(item.name).add_site(name=f"{item.name}_{name}_site", pos=place, size=(0.005,) * 3, group=_SOLID)


def for_mjx(spec: mujoco.MjSpec, inventory: Inventory, stock: Stock) -> None:
    """Only what MJX can collide: cylinders and ellipsoids are hulls. Masses and inertias stay those that were measured.

    Nothing sleeps: MJX knows no sleep.
    """
    spec.option.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    for item in inventory.objects:
        for body in item.bodies:
            made = spec.body(body.name)
            made.explicitinertial, made.mass = True, body.mass
            made.ipos, made.iquat, made.inertia = body.centre, body.axes, body.inertia
            shapes = [geom.shape for geom in body.geoms if geom.collides and geom.shape is not None]
            for geom, shape in zip((geom for geom in made.geoms if geom.contype), shapes, strict=True):
                if shape.kind in ("cylinder", "ellipsoid"):
                    geom.type, geom.meshname = mujoco.mjtGeom.mjGEOM_MESH, stock.hull(_hull(shape))


def _hull(shape: Shape) -> Shape:
    """The hull that stands for a cylinder or an ellipsoid."""
    return collider(hull_of(shape)) if shape.kind == "ellipsoid" else drum_of(shape)


FLAVORS: dict[str, Flavor] = {"robosuite": for_robosuite, "mjx": for_mjx}
"""By name."""
