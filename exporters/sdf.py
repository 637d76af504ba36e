"""A scene as a world of SDF 1.9, for Gazebo and Drake: a model for each object, with its joints and frictions."""

import math
from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

from thinkblox.exporters.beside import texture_files, write_beside
from thinkblox.exporters.cameras import lights_of
from thinkblox.exporters.frames import add, in_xml, inertia_attributes, numbers, xml_text
from thinkblox.exporters.inventory import Inventory, InventoryBody, InventoryGeom, InventoryLook, InventoryObject
from thinkblox.exporters.mjcf_meshes import obj_file
from thinkblox.exporters.solids import SolidFiles
from thinkblox.scene.asset import Shape
from thinkblox.scene.textured_mesh import mesh_of
from thinkblox.sim.geometry.collider import collider
from thinkblox.sim.verdict.settle import Pose

_DRAKE, _OURS = "http://drake.mit.edu", "urn:thinkblox"
"""Namespaces of what SDF itself has no element for."""


def write_sdf(inventory: Inventory, path: Path) -> None:
    """Write a scene as one world, with the meshes and textures that it names in `assets` beside it.

    Objects stand where they came to rest; doors and drawers are shut, which is where their joints are at 0.
    """
    made = _World(inventory)
    path.write_text(made.text(), encoding="utf-8")
    write_beside(path, made.files.files | texture_files(inventory, {}))


class _World:
    """The world being written."""

    def __init__(self, inventory: Inventory) -> None:
        self.files, self._looks = SolidFiles(), inventory.looks
        self._root = ElementTree.Element("sdf", {"version": "1.9", "xmlns:drake": _DRAKE, "xmlns:thinkblox": _OURS})
        world = add(self._root, "world", name="thinkblox")
        physics = add(world, "physics", name="default", type="ignored")
        add(physics, "max_step_size", numbers((inventory.physics.timestep,)))
        add(world, "gravity", numbers(inventory.physics.gravity))
        for number, place in enumerate(lights_of(inventory.scene.room), 1):
            light = add(world, "light", name=f"ceiling_light_{number}", type="point")
            add(light, "pose", numbers((*place, 0.0, 0.0, 0.0)))
            add(light, "diffuse", "0.6 0.6 0.6 1")
        room = add(world, "model", name="room")
        add(room, "static", "true")
        for wall in inventory.walls:
            if wall.geoms:
                self._shapes(add(room, "link", name=wall.name), wall.geoms, wall.look)
        for item in inventory.objects:
            self._model(world, item)
        self._say(inventory.objects)

    def text(self) -> str:
        """The document."""
        return xml_text(self._root)

    def _say(self, items: Iterable[InventoryObject]) -> None:
        """Keep what the scene calls objects and their links, beside the world, which readers pass over."""
        every = add(self._root, "thinkblox:objects")
        for item in items:
            said = {"model": item.name, "id": item.id, "category": item.category, "asset": item.asset}
            told = add(every, "thinkblox:object", **{key: in_xml(value) for key, value in said.items()})
            for body in item.bodies[1:]:
                add(told, "thinkblox:part", name=body.name, called=in_xml(body.link))

    def _model(self, world: ElementTree.Element, item: InventoryObject) -> None:
        model = add(world, "model", name=item.name)
        first, *joined = item.bodies
        _pose(model, first.settled)
        if not item.free and not joined:
            add(model, "static", "true")
        for body in item.bodies:
            self._link(model, body)
        if not item.free and joined:
            _join(model, f"{item.name}_mount", "fixed", "world", first.name)
        for body in joined:
            _add_joint(model, body)

    def _link(self, model: ElementTree.Element, body: InventoryBody) -> None:
        link = add(model, "link", name=body.name)
        if body.joint is not None:
            _pose(link, (body.joint.anchor, (1.0, 0.0, 0.0, 0.0)))
        inertial = add(link, "inertial")
        add(inertial, "pose", numbers((*body.centre, 0.0, 0.0, 0.0)))
        add(inertial, "mass", numbers((body.mass,)))
        inertia = add(inertial, "inertia")
        for name, value in inertia_attributes(body).items():
            add(inertia, name, value)
        self._shapes(link, body.geoms)

    def _shapes(self, link: ElementTree.Element, geoms: tuple[InventoryGeom, ...], look: str | None = None) -> None:
        for number, geom in enumerate(geoms):
            seen = geom.look or look
            if seen is not None:
                visual = add(link, "visual", name=f"visual_{number}")
                self._geometry(visual, geom, solid=False)
                _material(visual, self._looks[seen])
            if geom.collides:
                collision = add(link, "collision", name=f"collision_{number}")
                self._geometry(collision, geom, solid=True)
                friction = add(add(collision, "surface"), "friction")
                for tag in ("mu", "mu2"):
                    ode = friction.find("ode")
                    add(add(friction, "ode") if ode is None else ode, tag, numbers((geom.friction[0],)))

    def _geometry(self, parent: ElementTree.Element, geom: InventoryGeom, *, solid: bool) -> None:
        if geom.shape is not None:
            self._shape(parent, collider(geom.shape) if solid else geom.shape, solid=solid)
        elif geom.mesh is not None:
            file, data = obj_file(mesh_of(geom.mesh))
            self.files.files[file] = data
            add(parent, "pose", numbers((*geom.offset, 0.0, 0.0, 0.0)))
            add(add(add(parent, "geometry"), "mesh"), "uri", file)

    def _shape(self, parent: ElementTree.Element, shape: Shape, *, solid: bool) -> None:
        _pose(parent, (shape.position, shape.quat_wxyz))
        made, (x, y, z) = add(add(parent, "geometry"), "mesh" if shape.kind == "hull" else shape.kind), shape.size
        if shape.kind == "box":
            add(made, "size", numbers(shape.size))
        elif shape.kind == "ellipsoid":
            add(made, "radii", numbers((x / 2, y / 2, z / 2)))
        elif shape.kind == "hull":
            if solid:
                add(made, "drake:declare_convex")
            add(made, "uri", self.files.hull(shape))
        else:
            add(made, "radius", numbers((x / 2,)))
            if shape.kind != "sphere":
                add(made, "length", numbers((z if shape.kind == "cylinder" else max(z - x, 1e-6),)))


def _pose(parent: ElementTree.Element, pose: Pose) -> None:
    position, (w, x, y, z) = pose
    add(parent, "pose", numbers((*position, x, y, z, w)), rotation_format="quat_xyzw")


def _material(visual: ElementTree.Element, look: InventoryLook) -> None:
    material, colour = add(visual, "material"), numbers((*look.colour, look.opacity))
    add(material, "ambient", colour)
    add(material, "diffuse", colour)
    if look.texture is not None:
        add(add(add(material, "pbr"), "metal"), "albedo_map", f"assets/{look.texture}.png")


def _join(model: ElementTree.Element, name: str, kind: str, parent: str, child: str) -> ElementTree.Element:
    joint = add(model, "joint", name=name, type=kind)
    add(joint, "parent", parent)
    add(joint, "child", child)
    return joint


def _add_joint(model: ElementTree.Element, body: InventoryBody) -> None:
    joint = body.joint
    assert joint is not None
    assert body.parent is not None
    hinge = joint.kind == "hinge"
    made = _join(model, f"{body.name}_joint", "revolute" if hinge else "prismatic", body.parent, body.name)
    axis = add(made, "axis")
    add(axis, "xyz", numbers(joint.axis))
    limit, dynamics = add(axis, "limit"), add(axis, "dynamics")
    for tag, value in (("lower", joint.lower), ("upper", joint.upper)):
        add(limit, tag, numbers((math.radians(value) if hinge else value,)))
    add(dynamics, "damping", numbers((joint.damping,)))
    add(dynamics, "friction", numbers((joint.friction,)))
