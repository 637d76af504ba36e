"""Objects of a measured MuJoCo model, dressed as in the Menagerie: what is touched in group 3, what is seen in 2."""

import mujoco
import numpy as np

from thinkblox.exporters.grips import grasp_of, handle_of
from thinkblox.exporters.inventory import Inventory, InventoryBody, InventoryGeom, InventoryObject
from thinkblox.exporters.mjcf_meshes import Stock
from thinkblox.exporters.naming import Names
from thinkblox.scene.asset import Asset, Shape
from thinkblox.sim.build import COLLISION_GROUP, FREE_SUFFIX, GEOM_TYPES, VISUAL, half_size
from thinkblox.sim.geometry.collider import collider

SITE_GROUP = 4
"""The group of the sites on surfaces that carry things, and of those where a hand takes hold."""


def dress_objects(spec: mujoco.MjSpec, inventory: Inventory, stock: Stock) -> None:
    """Give the bodies of all objects their safe names, hinges as origins, and what is seen of them."""
    names = {body.source: body.name for item in inventory.objects for body in item.bodies}
    sites = Names()
    for item, placement in zip(inventory.objects, inventory.scene.placements, strict=True):
        for body in item.bodies:
            _dress(spec, body, stock)
        _add_sites(spec, item, inventory.scene.asset_of(placement), sites)
    for exclude in spec.excludes:
        exclude.bodyname1, exclude.bodyname2 = names[exclude.bodyname1], names[exclude.bodyname2]
        exclude.name = f"{exclude.bodyname1}_and_{exclude.bodyname2}"


def _dress(spec: mujoco.MjSpec, body: InventoryBody, stock: Stock) -> None:
    made = spec.body(body.source)
    made.name = body.name
    for joint in made.joints:
        joint.name = body.name if body.joint is not None else body.name + FREE_SUFFIX
        if body.joint is not None:
            joint.pos, made.pos = np.zeros(3), body.joint.anchor
    solid = iter(list(made.geoms))
    counts = {"collision": 0, "visual": 0}
    for geom in body.geoms:
        there = next(solid) if geom.shape is not None and (geom.collides or geom.mass) else None
        for found in _parts(spec, made, geom, there, stock):
            kind = "visual" if found.classname.name == VISUAL else "collision"
            found.name = f"{body.name}_{kind}_{counts[kind]}"
            counts[kind] += 1


def _parts(
    spec: mujoco.MjSpec, made: mujoco.MjsBody, geom: InventoryGeom, there: mujoco.MjsGeom | None, stock: Stock
) -> list[mujoco.MjsGeom]:
    """The geoms that stand for one: the one that was measured, and the one that is seen, or one that is both."""
    if geom.mesh is not None and geom.look is not None:
        seen = _seen(spec, made, geom.look, stock)
        seen.type, seen.meshname, seen.pos = mujoco.mjtGeom.mjGEOM_MESH, stock.blob(geom.mesh), geom.offset
        return [seen]
    if geom.shape is None:
        return []
    if there is not None:
        there.pos = geom.shape.position
        if geom.shape.kind == "hull":
            there.meshname = stock.hull(collider(geom.shape))
    if geom.look is None:
        if there is not None:
            there.group = COLLISION_GROUP
        return [] if there is None else [there]
    if there is not None and not geom.collides:
        there.material = stock.material(geom.look)
        return [there]
    seen = _seen(spec, made, geom.look, stock)
    _shape(seen, geom.shape, stock)
    return [seen] if there is None else [there, seen]


def _seen(spec: mujoco.MjSpec, made: mujoco.MjsBody, look: str, stock: Stock) -> mujoco.MjsGeom:
    geom = made.add_geom(spec.find_default(VISUAL))
    geom.material = stock.material(look)
    return geom


def _shape(geom: mujoco.MjsGeom, shape: Shape, stock: Stock) -> None:
    geom.type, geom.pos, geom.quat = GEOM_TYPES[shape.kind], shape.position, shape.quat_wxyz
    if shape.kind == "hull":
        geom.meshname = stock.hull(shape)
    else:
        geom.size = half_size(shape)


def _add_sites(spec: mujoco.MjSpec, item: InventoryObject, asset: Asset, names: Names) -> None:
    """A flat site on every surface that carries things, as large as it is, and points where a hand takes hold."""
    body = spec.body(item.name)
    for surface in asset.surfaces:
        kind = mujoco.mjtGeom.mjGEOM_ELLIPSOID if surface.round else mujoco.mjtGeom.mjGEOM_BOX
        site = body.add_site(name=names.give(f"{item.name}_{surface.name}"), type=kind, group=SITE_GROUP)
        site.pos, site.size = surface.position, (surface.size[0] / 2, surface.size[1] / 2, 0.0005)
    for part in item.bodies:
        handle = handle_of(part)
        if handle is not None:
            spec.body(part.name).add_site(name=names.give(f"{part.name}_handle"), pos=handle, group=SITE_GROUP)
    grasp = grasp_of(asset)
    if grasp is not None:
        site = body.add_site(name=names.give(f"{item.name}_grasp"), group=SITE_GROUP)
        site.pos, site.quat = grasp
