"""What is seen of a room, as in its pictures: floor, walls, ceiling, doors and windows as meshes with textures.

Each is drawn from its room's side only, so that viewers that leave out back faces look into the room from outside.
"""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.exporters.inventory import Inventory, InventoryLook
from thinkblox.exporters.looks import covering_look, finish_look
from thinkblox.png import png_of
from thinkblox.scene.room import Room
from thinkblox.scene.surfaces import Covering, Surfaces
from thinkblox.scene.textured_mesh import TexturedMesh
from thinkblox.sim.render.curtains import Drape, curtains_at
from thinkblox.sim.render.interior import Shell, add_room
from thinkblox.sim.render.layings import colours
from thinkblox.sim.render.materials import MATERIALS
from thinkblox.sim.render.soup import CoveredPlane, Patch, Soup
from thinkblox.sim.render.tessellate import Mesh

CEILING = (0.95, 0.945, 0.935)
_PIXEL, _PIXELS = 0.006, 400_000
"""Smallest pixel of a texture [m], and about how many it has at most."""
_TOUCHING = 1e-3
_SIDE = 0.3
"""How far to the side of a window what belongs to it reaches [m]."""


@dataclass(frozen=True)
class RoomPart:
    """Something of the room that is only looked at, in the room's frame.

    Attributes:
        name: what it is called: "floor", a wall, "ceiling", an opening, or a wall's trim; several may share it.
        label: what it is: "floor", "wall", "ceiling", "door", "window" or "trim".
        look: name of its look.
        mesh: all of it.
        pieces: how many of the mesh's vertices are of each box that it is made of, one after another.
    """

    name: str
    label: str
    look: str
    mesh: TexturedMesh
    pieces: tuple[int, ...]


@dataclass(frozen=True)
class RoomParts:
    """All of it, with the looks and the textures (PNG, by hash) that it needs."""

    parts: tuple[RoomPart, ...]
    looks: Mapping[str, InventoryLook]
    pictures: Mapping[str, bytes]


def room_parts(inventory: Inventory) -> RoomParts:
    """What is seen of a room besides its objects."""
    scene = inventory.scene
    return _room_parts(scene.room, scene.surfaces, tuple(sorted(curtains_at(scene).items())), not inventory.doors)


@lru_cache(maxsize=4)
def _room_parts(room: Room, surfaces: Surfaces, curtains: tuple[tuple[str, Drape], ...], filled: bool) -> RoomParts:
    soup = Soup()
    shell = Shell(standing=(True,) * len(room.walls), curtains=dict(curtains), filled=filled)
    add_room(soup, room, surfaces, shell)
    return _Drawn(room, soup).parts()


class _Drawn:
    """The triangles of a room, sorted by what they belong to and what they look like."""

    def __init__(self, room: Room, soup: Soup) -> None:
        self._room, self._soup = room, soup
        self._looks: dict[str, InventoryLook] = {}
        self._pictures: dict[str, bytes] = {}
        self._meshes: dict[tuple[str, str, str], list[Mesh]] = {}

    def parts(self) -> RoomParts:
        """All parts, one for each name and look."""
        areas = self._areas()
        for mesh, patch in zip(self._soup.meshes, self._soup.patches, strict=True):
            material = MATERIALS[patch.material]
            if material not in ("cut", "ground"):
                seen = mesh if material == "floor" else self._inner(mesh, patch, material)
                if len(seen.faces):
                    self._add(seen, patch, material, areas)
        self._put("ceiling", "ceiling", covering_look(Covering(laying="paint", colour=CEILING)), _ceiling(self._room))
        parts = tuple(RoomPart(*key, *_joined(meshes)) for key, meshes in self._meshes.items())
        return RoomParts(parts, self._looks, self._pictures)

    def _areas(self) -> dict[tuple[Covering, bool], tuple[NDArray[Any], NDArray[Any]]]:
        """For each covering the part of its pattern that is seen anywhere, from low to high [m]."""
        found: dict[tuple[Covering, bool], list[NDArray[Any]]] = {}
        for mesh, patch in zip(self._soup.meshes, self._soup.patches, strict=True):
            if patch.plane is not None:
                places = _on(patch.plane, mesh.vertices)
                found.setdefault((patch.plane.covering, patch.plane.floor), []).append(places)
        return {
            key: (np.min([p.min(axis=0) for p in places], axis=0), np.max([p.max(axis=0) for p in places], axis=0))
            for key, places in found.items()
        }

    def _add(
        self,
        mesh: Mesh,
        patch: Patch,
        material: str,
        areas: Mapping[tuple[Covering, bool], tuple[NDArray[Any], NDArray[Any]]],
    ) -> None:
        name, label = self._owner(patch, material)
        if patch.plane is None:
            self._put(name, label, finish_look(material, _srgb(patch.colour)), mesh)
        elif patch.plane.covering.laying == "paint":
            self._put(name, label, covering_look(patch.plane.covering), mesh)
        else:
            low, high = areas[patch.plane.covering, patch.plane.floor]
            look = self._painted(patch.plane.covering, patch.plane.floor, low, high)
            uv = (_on(patch.plane, mesh.vertices) - low) / (high - low)
            self._put(name, label, look, replace(mesh, uv=uv.astype(np.float32)))

    def _put(self, name: str, label: str, look: InventoryLook, mesh: Mesh) -> None:
        self._looks.setdefault(look.name, look)
        self._meshes.setdefault((name, label, look.name), []).append(mesh)

    def _painted(self, covering: Covering, floor: bool, low: NDArray[Any], high: NDArray[Any]) -> InventoryLook:
        plain = covering_look(covering)
        content = hashlib.sha256(repr((covering, floor, low.tolist(), high.tolist())).encode()).hexdigest()
        name = f"{plain.name}_{content[:8]}"
        if name not in self._looks:
            picture = _picture(covering, floor, low, high)
            texture = hashlib.sha256(picture).hexdigest()
            self._pictures[texture] = picture
            self._looks[name] = replace(plain, name=name, colour=(1.0, 1.0, 1.0), texture=texture)
        return self._looks[name]

    def _owner(self, patch: Patch, material: str) -> tuple[str, str]:
        if material == "floor":
            return "floor", "floor"
        wall, along = self._wall(patch)
        if material == "wall":
            return self._room.walls[wall].name, "wall"
        low, high = patch.origin[2] - patch.size[2] / 2, patch.origin[2] + patch.size[2] / 2
        for opening in self._room.openings:
            reach = _SIDE if opening.kind == "window" else 0.08
            beside = opening.offset - reach < along < opening.offset + opening.width + reach
            level = high > opening.sill - 0.1 and low < opening.sill + opening.height + 0.2
            if opening.wall == wall and beside and level:
                return opening.id, opening.kind
        return f"{self._room.walls[wall].name}_trim", "trim"

    def _wall(self, patch: Patch) -> tuple[int, float]:
        """The number of the wall that a patch is a part of, and how far from the wall's start its middle is [m]."""
        places = [wall.coordinates((patch.origin[0], patch.origin[1])) for wall in self._room.walls]
        away = [
            abs(inward)
            + max(-along, along - wall.length, 0.0)
            + (100.0 if np.dot(patch.rotation[:2, 1], wall.inward) < 0.999 else 0.0)
            for wall, (along, inward) in zip(self._room.walls, places, strict=True)
        ]
        number = int(np.argmin(away))
        return number, places[number][0]

    def _inner(self, mesh: Mesh, patch: Patch, material: str) -> Mesh:
        """What of a box at a wall is seen from the room: not its back, not what is over or under it, no wall's ends."""
        wall = self._room.walls[self._wall(patch)[0]]
        kept = _facing_in(mesh, patch, self._room.height)
        if material == "wall":
            along = (mesh.vertices[mesh.faces][..., :2].astype(np.float64) - wall.start) @ wall.along
            ends = np.minimum(np.abs(along), np.abs(along - wall.length)).min(axis=1) < _TOUCHING
            kept &= ~(ends & (np.abs(_normals(mesh) @ patch.rotation[:, 0]) > 0.3))
        return _only(mesh, kept)


def _facing_in(mesh: Mesh, patch: Patch, height: float) -> NDArray[np.bool_]:
    corners, facing = mesh.vertices[mesh.faces], _normals(mesh)
    outside = np.all(corners[..., 2] > height - _TOUCHING, axis=1) | np.all(corners[..., 2] < -_TOUCHING, axis=1)
    kept: NDArray[np.bool_] = facing.any(axis=1) & (facing @ patch.rotation[:, 1] > -0.5) & ~outside
    return kept


def _normals(mesh: Mesh) -> NDArray[np.float64]:
    """The unit normal of each face; zeros where it has no area."""
    corners = mesh.vertices[mesh.faces].astype(np.float64)
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(facing, axis=1)[:, None]
    normals: NDArray[np.float64] = np.where(length > 1e-12, facing / np.maximum(length, 1e-20), 0.0)
    return normals


def _only(mesh: Mesh, kept: NDArray[np.bool_]) -> Mesh:
    faces = mesh.faces[kept]
    used, index = np.unique(faces, return_inverse=True)
    return Mesh(mesh.vertices[used], mesh.normals[used], index.reshape(-1, 3).astype(np.int32))


def _on(plane: CoveredPlane, points: NDArray[Any]) -> NDArray[np.float64]:
    """Where points are on a plane, along and across its pattern [m], shape (n, 2)."""
    away = points.astype(np.float64) - plane.origin
    return np.stack([away @ plane.along, away @ plane.across], axis=1)


def _picture(covering: Covering, floor: bool, low: NDArray[Any], high: NDArray[Any]) -> bytes:
    """A stretch of a covering as PNG, its upper row the farthest across."""
    from PIL import Image

    size = high - low
    pixel = max(_PIXEL, float(np.sqrt(size[0] * size[1] / _PIXELS)))
    columns, rows = (max(int(np.ceil(extent / pixel)), 2) for extent in size)
    along = (low[0] + (np.arange(columns) + 0.5) * size[0] / columns).astype(np.float32)
    across = (high[1] - (np.arange(rows) + 0.5) * size[1] / rows).astype(np.float32)
    x, y = (axis.ravel() for axis in np.meshgrid(along, across))
    painted = colours(covering, x, y, np.full(len(x), pixel, np.float32), floor=floor)
    seen = np.round(_encoded(np.clip(painted, 0.0, 1.0)) * 255).astype(np.uint8).reshape(rows, columns, 3)
    return png_of(Image.fromarray(seen))


def _encoded(light: NDArray[Any]) -> NDArray[Any]:
    """What sRGB has for linear light."""
    curved = 1.055 * np.maximum(light, 1e-9) ** (1 / 2.4) - 0.055
    return np.where(light <= 0.0031308, light * 12.92, curved)


def _srgb(colour: tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = (round(float(channel), 4) for channel in _encoded(np.asarray(colour, np.float64)))
    return (red, green, blue)


def _ceiling(room: Room) -> Mesh:
    corners = np.concatenate(list(_triangles(room)))
    vertices = np.pad(corners, ((0, 0), (0, 1)), constant_values=room.height).astype(np.float32)
    faces = np.arange(len(vertices), dtype=np.int32).reshape(-1, 3)[:, ::-1]
    return Mesh(
        vertices, np.tile(np.array([0.0, 0.0, -1.0], np.float32), (len(vertices), 1)), np.ascontiguousarray(faces)
    )


def _triangles(room: Room) -> Iterator[NDArray[np.float64]]:
    for triangle in shapely.constrained_delaunay_triangles(room.polygon).geoms:
        yield shapely.get_coordinates(shapely.orient_polygons(triangle))[:3]


def _halved(mesh: Mesh) -> Mesh:
    """One triangle as two: engines take no mesh of three corners."""
    a, b, c = mesh.faces[0].tolist()
    middle = [(values[a] + values[b]) / 2 for values in (mesh.vertices, mesh.normals)]
    uv = None if mesh.uv is None else np.vstack([mesh.uv, (mesh.uv[a] + mesh.uv[b]) / 2])
    faces = np.array([(a, 3, c), (3, b, c)], np.int32)
    return Mesh(np.vstack([mesh.vertices, middle[0]]), np.vstack([mesh.normals, middle[1]]), faces, uv)


def _joined(meshes: list[Mesh]) -> tuple[TexturedMesh, tuple[int, ...]]:
    if sum(len(mesh.vertices) for mesh in meshes) == 3:
        meshes = [_halved(meshes[0])]
    starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
    joined = TexturedMesh.of(
        vertices=np.concatenate([mesh.vertices for mesh in meshes]),
        normals=np.concatenate([mesh.normals for mesh in meshes]),
        uv=np.concatenate([np.zeros((len(mesh.vertices), 2)) if mesh.uv is None else mesh.uv for mesh in meshes]),
        faces=np.concatenate([mesh.faces + int(start) for mesh, start in zip(meshes, starts, strict=True)]),
    )
    return joined, tuple(len(mesh.vertices) for mesh in meshes)
