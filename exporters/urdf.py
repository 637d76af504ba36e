"""A scene as URDF: one model for each asset, and the room with all of them in their places."""

import hashlib
import math
from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

from thinkblox.exporters.beside import write_beside
from thinkblox.exporters.frames import add, in_xml, inertia_attributes, numbers, placing, xml_text
from thinkblox.exporters.inventory import Inventory, InventoryBody, InventoryGeom, InventoryLook, InventoryObject
from thinkblox.exporters.mjcf_meshes import obj_file
from thinkblox.exporters.naming import Names, safe_name
from thinkblox.exporters.solids import SolidFiles, plain_solid
from thinkblox.scene.asset import Shape
from thinkblox.scene.blobs import FOLDER
from thinkblox.scene.textured_mesh import mesh_of
from thinkblox.sim.verdict.settle import Pose

WORLD = "world"
"""The root link, which readers hold still."""
_HOME: Pose = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
_EFFORT, _VELOCITY = "1000", "100"
"""Of joints, which URDF wants limits of: more than anybody needs [N or N m, m/s or rad/s]."""


def write_urdf(inventory: Inventory, path: Path) -> None:
    """Write the room as one URDF, and each asset's model and all meshes into `assets` beside it.

    What can move hangs on a floating joint at the pose in which it came to rest; doors and drawers are shut at 0. The
    models are for readers that take one robot a file: where each stands is the origin of its joint in the room's.
    """
    files = SolidFiles()
    room = _Robot("room", inventory.looks, files, FOLDER + "/")
    add(room.root, "link", name=WORLD)
    for wall in inventory.walls:
        if wall.geoms:
            room.fixed_link(wall.name, wall.geoms, wall.look)
    for item in inventory.objects:
        room.item(item)
        room.say(item)
    path.write_text(room.text(), encoding="utf-8")
    write_beside(path, files.files | dict(_models(inventory, files)))


def _models(inventory: Inventory, files: SolidFiles) -> Iterable[tuple[str, bytes]]:
    """The model of each asset, by its path."""
    known = set()
    for item in inventory.objects:
        if item.asset not in known:
            known.add(item.asset)
            model = _Robot(safe_name(item.asset), inventory.looks, files, "")
            model.links(item, plain=True)
            data = model.text().encode()
            yield f"{FOLDER}/{safe_name(item.asset)}_{hashlib.sha256(data).hexdigest()[:8]}.urdf", data


class _Robot:
    """A URDF being written.

    Args:
        name: of the robot.
        looks: by name.
        files: takes the meshes that it names.
        folder: what is before the names of their files.
    """

    def __init__(self, name: str, looks: dict[str, InventoryLook], files: SolidFiles, folder: str) -> None:
        self.root = ElementTree.Element("robot", name=name)
        # What MuJoCo would do otherwise: look for all files beside the model, and make one body of what is fixed.
        add(add(self.root, "mujoco"), "compiler", strippath="false", fusestatic="false", balanceinertia="false")
        self._looks, self._files, self._folder = looks, files, folder
        self._materials: set[str] = set()

    def text(self) -> str:
        """The document."""
        return xml_text(self.root)

    def say(self, item: InventoryObject) -> None:
        """Keep what the scene calls an object and its links, which readers pass over."""
        said = {"name": item.name, "id": item.id, "category": item.category, "asset": item.asset}
        told = add(self.root, "thinkblox", **{key: in_xml(value) for key, value in said.items()})
        for body in item.bodies[1:]:
            add(told, "part", name=body.name, called=in_xml(body.link))

    def fixed_link(self, name: str, geoms: Iterable[InventoryGeom], look: str) -> None:
        """Add a part of the room."""
        link = add(self.root, "link", name=name)
        for geom in geoms:
            if geom.shape is not None:
                self._visual(link, geom.shape, look)
                self._collision(link, geom.shape)
        self._join(f"{name}_mount", "fixed", WORLD, name, _HOME)

    def item(self, item: InventoryObject) -> None:
        """Add an object where it came to rest."""
        self.links(item)
        first = item.bodies[0]
        kind, suffix = ("floating", "free") if item.free else ("fixed", "mount")
        self._join(f"{item.name}_{suffix}", kind, WORLD, first.name, first.settled)

    def links(self, item: InventoryObject, *, plain: bool = False) -> None:
        """Add the links of an object and what joins them; `plain` names them as the asset does."""
        names = Names()
        called = {body.name: names.give(body.link) if plain else body.name for body in item.bodies}
        for body in item.bodies:
            self._link(called[body.name], body)
        for body in item.bodies:
            if body.joint is not None and body.parent is not None:
                self._add_joint(body, called[body.name], called[body.parent])

    def _link(self, name: str, body: InventoryBody) -> None:
        link = add(self.root, "link", name=name)
        inertial = add(link, "inertial")
        add(inertial, "origin", xyz=numbers(body.centre), rpy="0 0 0")
        add(inertial, "mass", value=numbers((body.mass,)))
        add(inertial, "inertia", **inertia_attributes(body))
        for geom in body.geoms:
            if geom.look is not None and geom.shape is not None:
                self._visual(link, geom.shape, geom.look)
            elif geom.look is not None and geom.mesh is not None:
                file, data = obj_file(mesh_of(geom.mesh))
                self._files.files[file] = data
                seen = add(link, "visual")
                add(seen, "origin", xyz=numbers(geom.offset), rpy="0 0 0")
                add(add(seen, "geometry"), "mesh", filename=self._named(file))
                self._material(seen, geom.look)
        for geom in body.geoms:
            if geom.collides and geom.shape is not None:
                self._collision(link, geom.shape)
        friction = next((geom.friction[0] for geom in body.geoms if geom.collides), None)
        if friction is not None:
            # URDF knows no friction; this is Bullet's way of saying it.
            add(add(link, "contact"), "lateral_friction", value=numbers((friction,)))

    def _collision(self, link: ElementTree.Element, shape: Shape) -> None:
        self._shape(add(link, "collision"), plain_solid(shape))

    def _visual(self, link: ElementTree.Element, shape: Shape, look: str) -> None:
        seen = add(link, "visual")
        self._shape(seen, plain_solid(shape) if shape.kind in ("ellipsoid", "capsule") else shape)
        self._material(seen, look)

    def _shape(self, parent: ElementTree.Element, shape: Shape) -> None:
        add(parent, "origin", **placing((shape.position, shape.quat_wxyz)))
        geometry, (x, _, z) = add(parent, "geometry"), shape.size
        if shape.kind == "box":
            add(geometry, "box", size=numbers(shape.size))
        elif shape.kind == "sphere":
            add(geometry, "sphere", radius=numbers((x / 2,)))
        elif shape.kind == "cylinder":
            add(geometry, "cylinder", radius=numbers((x / 2,)), length=numbers((z,)))
        else:
            add(geometry, "mesh", filename=self._named(self._files.hull(shape)))

    def _named(self, file: str) -> str:
        return self._folder + file.removeprefix(f"{FOLDER}/")

    def _material(self, seen: ElementTree.Element, name: str) -> None:
        material = add(seen, "material", name=name)
        if name not in self._materials:
            look = self._looks[name]
            add(material, "color", rgba=numbers((*look.colour, look.opacity)))
            self._materials.add(name)

    def _add_joint(self, body: InventoryBody, name: str, parent: str) -> None:
        joint = body.joint
        assert joint is not None
        hinge = joint.kind == "hinge"
        made = self._join(f"{name}_joint", "revolute" if hinge else "prismatic", parent, name, (joint.anchor, _HOME[1]))
        lower, upper = (math.radians(v) if hinge else v for v in (joint.lower, joint.upper))
        add(made, "axis", xyz=numbers(joint.axis))
        add(made, "limit", lower=numbers((lower,)), upper=numbers((upper,)), effort=_EFFORT, velocity=_VELOCITY)
        add(made, "dynamics", damping=numbers((joint.damping,)), friction=numbers((joint.friction,)))

    def _join(self, name: str, kind: str, parent: str, child: str, pose: Pose) -> ElementTree.Element:
        made = add(self.root, "joint", name=name, type=kind)
        add(made, "origin", **placing(pose))
        add(made, "parent", link=parent)
        add(made, "child", link=child)
        return made
