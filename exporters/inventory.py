"""What a scene is made of, for no engine in particular: objects, bodies, geoms, joints and looks.

Metres, kilograms, seconds, z up; quaternions wxyz; hinges in degrees, as in the scene. It is taken once from the model
that was measured, by `thinkblox.exporters.stocktaking`, and every writer reads it.
"""

from dataclasses import dataclass
from typing import Literal

from thinkblox.scene.asset import Shape
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import Pose, SettledState
from thinkblox.value import Quat, Vec3


@dataclass(frozen=True)
class InventoryLook:
    """A surface.

    Attributes:
        name: what has the same name looks the same; letters, digits and underscores.
        colour: sRGB, 0 to 1; multiplies the texture where there is one, in linear light.
        roughness, metallic, opacity: 0 to 1.
        glow: emitted light as a multiple of the colour.
        texture: blob of a PNG picture, sRGB.
    """

    name: str
    colour: Vec3
    roughness: float
    metallic: float = 0.0
    opacity: float = 1.0
    glow: float = 0.0
    texture: str | None = None


@dataclass(frozen=True)
class InventoryGeom:
    """A convex shape, or a mesh to be looked at, in the frame of its body.

    Attributes:
        shape: as it is seen, with its pose in the body's frame; None for a mesh. What collides of it is its `collider`.
        mesh: blob of a `TexturedMesh` in the body's frame; None for a shape.
        look: name of what is seen; None for what is not seen.
        collides: whether it can be touched; a mesh cannot.
        mass: its share of the body's [kg].
        friction: sliding coefficient, torsional and rolling friction [m]; zeros where it does not collide.
        offset: where the mesh's origin is in the body's frame [m].
    """

    shape: Shape | None = None
    mesh: str | None = None
    look: str | None = None
    collides: bool = False
    mass: float = 0.0
    friction: Vec3 = (0.0, 0.0, 0.0)
    offset: Vec3 = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class InventoryJoint:
    """How a body moves against its parent: on an axis through its origin; where it is at 0 their frames are parallel.

    Attributes:
        axis: unit vector in the body's frame.
        anchor: the body's origin in the parent's frame [m].
        lower, upper: range [degrees, or m for a slide].
        friction: what it takes to move it [N m, or N].
        damping: [N m s/rad, or N s/m].
    """

    kind: Literal["hinge", "slide"]
    axis: Vec3
    anchor: Vec3
    lower: float
    upper: float
    friction: float
    damping: float


@dataclass(frozen=True)
class InventoryBody:
    """A rigid part of an object; the frame of what is joined to another has its origin on the joint's axis.

    Attributes:
        name: unique in the scene, and the same in every format: the object's, or "<object>_<link>".
        source: its name in the model that was measured: the object's id, or "<id>/<link>".
        link: its name within the asset.
        label: what it is, for segmentation: the object's category, or "door", "drawer".
        parent: name of the body that its joint joins it to; None for the object's first.
        joint: None for the object's first body.
        proposed: where the placement puts it, in the room.
        settled: where it came to rest, in the room.
        in_object: where it came to rest, in the frame of the object's first body.
        mass: [kg].
        centre: of mass, in the body's frame [m].
        inertia: about the centre, along its principal axes [kg m2].
        axes: orientation of the principal axes in the body's frame.
        geoms: in the order of the asset's shapes, meshes last.
    """

    name: str
    source: str
    link: str
    label: str
    parent: str | None
    joint: InventoryJoint | None
    proposed: Pose
    settled: Pose
    in_object: Pose
    mass: float
    centre: Vec3
    inertia: Vec3
    axes: Quat
    geoms: tuple[InventoryGeom, ...]


@dataclass(frozen=True)
class InventoryObject:
    """One placement.

    Attributes:
        id: of the placement.
        name: its safe form, unique in the scene and the same in every format.
        asset: id of its asset, whose `licence` and `author` come with it.
        free: whether it can move; it is fixed to the room otherwise, but for its joints.
        bodies: its first body, then those that are joined to it; no two of them collide with each other.
    """

    id: str
    name: str
    category: str
    asset: str
    licence: str
    author: str
    free: bool
    bodies: tuple[InventoryBody, ...]


@dataclass(frozen=True)
class InventoryWall:
    """The floor or a wall, in the room's frame.

    Attributes:
        name: "floor", or the wall's; the names of no two objects, bodies or walls differ in case alone.
        label: "floor" or "wall".
        look: name of its look.
        geoms: boxes that collide: one, or those round its openings.
    """

    name: str
    label: str
    look: str
    geoms: tuple[InventoryGeom, ...]


@dataclass(frozen=True)
class Inventory:
    """A whole scene at rest.

    Attributes:
        scene: what it was taken of.
        physics: the engine's options with which it came to rest.
        walls: the floor, then the walls in the room's order.
        objects: in the order of the placements.
        looks: by name.
        state: the measured model at rest, for keyframes and pictures.
        doors: whether the last objects are the doors and windows of the room, of which the scene then has placements.
    """

    scene: Scene
    physics: Physics
    walls: tuple[InventoryWall, ...]
    objects: tuple[InventoryObject, ...]
    looks: dict[str, InventoryLook]
    state: SettledState
    doors: bool = False
