"""Everything that a picture shows as one list of triangles, with what each of them belongs to and is made of."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.corners import rotation
from thinkblox.scene.scene import Scene
from thinkblox.scene.surfaces import Covering
from thinkblox.scene.textured_mesh import TexturedMesh, mesh_of
from thinkblox.scene.visuals import Look, MeshVisual
from thinkblox.sim.render.layings import MAKES, mean_colour
from thinkblox.sim.render.materials import FINISHES, MATERIALS, Colour, Reflectance, linear, reflectance_of
from thinkblox.sim.render.tessellate import Floats, Ints, Mesh, tessellate
from thinkblox.sim.render.texture_map import TextureMap, stretch, texture_map
from thinkblox.value import Quat, Vec3

Pose = tuple[Vec3, Quat]
"""Position of an asset's origin in the room [m] and its orientation (wxyz)."""
ROOM = -1
"""The object number of floor, walls, windows and doors."""


@dataclass(frozen=True)
class CoveredPlane:
    """A floor or a wall that is covered as one, however many shapes it is drawn with.

    Attributes:
        covering: what it is covered with.
        origin: a point of it, at which its pattern begins [m].
        along, across: unit vectors of its pattern.
        floor: whether it is a floor.
    """

    covering: Covering
    origin: Vec3
    along: Vec3
    across: Vec3
    floor: bool

    @property
    def facing(self) -> NDArray[np.float32]:
        """The side of it that is covered: its unit normal."""
        return np.cross(self.along, self.across).astype(np.float32)


@dataclass(frozen=True)
class Patch:
    """What the triangles of one shape share.

    Attributes:
        colour: linear RGB.
        material: index into MATERIALS.
        owner: number of the object that it belongs to, or ROOM.
        rotation, origin: the shape's frame in the room, the rotation's columns being its axes.
        size: full extents in that frame [m].
        look: what it is made of, where it is a mesh with a look of its own; its colour and material are the nearest.
        density: how much of the look's texture a metre shows, as a share of the texture's side [1/m].
        plane: what covers it, where it is a floor or a wall of the room.
    """

    colour: Colour
    material: int
    owner: int
    rotation: NDArray[np.float64]
    origin: NDArray[np.float64]
    size: Vec3
    look: Look | None = None
    density: float = 0.0
    plane: CoveredPlane | None = None

    @property
    def reflectance(self) -> Reflectance:
        """How it answers to light."""
        if self.plane is not None:
            return MAKES[self.plane.covering.laying].reflectance
        return FINISHES[MATERIALS[self.material]] if self.look is None else reflectance_of(self.look)

    @property
    def texture(self) -> TextureMap | None:
        """What its colour is multiplied by, where it has a texture."""
        return None if self.look is None or self.look.texture is None else texture_map(self.look.texture)

    @property
    def mean_colour(self) -> Colour:
        """Linear RGB of the whole of it."""
        if self.plane is not None:
            return mean_colour(self.plane.covering)
        if self.texture is None:
            return self.colour
        red, green, blue = (own * float(seen) for own, seen in zip(self.colour, self.texture.mean, strict=True))
        return (red, green, blue)


@dataclass
class Soup:
    """A growing list of triangles; `patches[patch]` says what a triangle belongs to."""

    patches: list[Patch] = field(default_factory=list)
    meshes: list[Mesh] = field(default_factory=list)

    def add(self, mesh: Mesh, patch: Patch) -> None:
        """Add a mesh given in the patch's frame."""
        turn = patch.rotation.astype(np.float32)
        vertices = mesh.vertices @ turn.T + patch.origin.astype(np.float32)
        self.meshes.append(Mesh(vertices, mesh.normals @ turn.T, mesh.faces, mesh.uv))
        self.patches.append(patch)

    def add_asset(self, asset: Asset, pose: Pose, owner: int, parts: Mapping[str, Pose] | None = None) -> None:
        """Add what is seen of an asset at a pose; `parts` are the poses of links that moved against it, by name."""
        for link in asset.links:
            position, quat_wxyz = (parts or {}).get(link.name, pose)
            turn, origin = quat_matrix(quat_wxyz), np.asarray(position, np.float64)
            for visual in link.visuals:
                mesh = mesh_of(visual.mesh)
                patch = _mesh_patch(visual, mesh, turn, origin, owner)
                self.add(Mesh(mesh.vertices, mesh.normals, mesh.faces, mesh.uv), patch)
            for shape in () if link.visuals else link.shapes:
                self.add(tessellate(shape), _patch(shape, turn, origin, owner))

    def triangles(self) -> "SoupTriangles":
        """The arrays of everything added so far."""
        counts = [len(mesh.vertices) for mesh in self.meshes]
        starts = np.concatenate([[0], np.cumsum(counts)])[: len(counts)]
        faces = [mesh.faces + int(start) for mesh, start in zip(self.meshes, starts, strict=True)]
        index = np.repeat(np.arange(len(self.meshes)), [len(mesh.faces) for mesh in self.meshes])
        return SoupTriangles(
            np.concatenate([mesh.vertices for mesh in self.meshes]).astype(np.float32),
            np.concatenate([mesh.normals for mesh in self.meshes]).astype(np.float32),
            np.concatenate(faces).astype(np.int32),
            index.astype(np.int32),
            tuple(self.patches),
            self._uv(),
        )

    def _uv(self) -> Floats | None:
        if all(mesh.uv is None for mesh in self.meshes):
            return None
        none = (np.zeros((len(mesh.vertices), 2), np.float32) if mesh.uv is None else mesh.uv for mesh in self.meshes)
        return np.concatenate(list(none)).astype(np.float32)


@dataclass(frozen=True)
class SoupTriangles:
    """Vertices (n, 3), normals (n, 3), faces (m, 3), the patch of each face (m,), and UV (n, 2) where any has it."""

    vertices: Floats
    normals: Floats
    faces: Ints
    patch: Ints
    patches: tuple[Patch, ...]
    uv: Floats | None = None


def _patch(shape: Shape, turn: NDArray[np.float64], origin: NDArray[np.float64], owner: int) -> Patch:
    return Patch(
        linear(shape.colour),
        MATERIALS.index(shape.material),
        owner,
        turn @ quat_matrix(shape.quat_wxyz),
        turn @ np.asarray(shape.position, np.float64) + origin,
        shape.size,
    )


def _mesh_patch(
    visual: MeshVisual, mesh: TexturedMesh, turn: NDArray[np.float64], origin: NDArray[np.float64], owner: int
) -> Patch:
    length, width, height = (max(float(extent), 1e-4) for extent in np.ptp(mesh.vertices, axis=0))
    return Patch(
        linear(visual.look.base_colour),
        MATERIALS.index("metal" if visual.look.metallic > 0.5 else "plastic"),
        owner,
        turn,
        origin,
        (length, width, height),
        visual.look,
        stretch(mesh),
    )


def pose_of(position: Vec3, yaw: float) -> Pose:
    """The pose of something upright, turned by `yaw` [degrees] about z."""
    half = np.radians(yaw) / 2
    return position, (float(np.cos(half)), 0.0, 0.0, float(np.sin(half)))


def add_objects(
    soup: Soup, scene: Scene, poses: Mapping[str, Pose] | None = None, *, hidden: Collection[str] = ()
) -> None:
    """Add the scene's objects but those `hidden`; an object's number is its place in the scene's order.

    Args:
        soup: what they are added to.
        scene: where they are.
        poses: poses that go before those in the scene, by placement id, and by "<id>/<link>" for doors and drawers.
        hidden: ids that are left out.
    """
    given = poses or {}
    for number, placement in enumerate(scene.placements):
        if placement.id not in hidden:
            asset = scene.asset_of(placement)
            named = {link.name: given.get(f"{placement.id}/{link.name}") for link in asset.links}
            parts = {name: pose for name, pose in named.items() if pose is not None}
            pose = given.get(placement.id) or pose_of(placement.position, placement.yaw)
            soup.add_asset(asset, pose, number, parts)


def quat_matrix(quat_wxyz: Quat) -> NDArray[np.float64]:
    """The rotation matrix of a quaternion, which need not have unit length."""
    return rotation(np.asarray(quat_wxyz, np.float64) / np.linalg.norm(quat_wxyz))
