"""A scene as binary glTF 2.0: a node for each object and link, y up as the format has it, each asset's meshes once."""

import json
import math
import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.exporters.beside import texture_files
from thinkblox.exporters.cameras import cameras_of
from thinkblox.exporters.inventory import Inventory, InventoryBody, InventoryLook, InventoryObject
from thinkblox.exporters.naming import Names
from thinkblox.exporters.polygons import placed
from thinkblox.exporters.room_parts import RoomParts, room_parts
from thinkblox.scene.blobs import blob_name
from thinkblox.scene.textured_mesh import TexturedMesh, mesh_of
from thinkblox.sim.render.materials import linear
from thinkblox.sim.verdict.settle import Pose
from thinkblox.version import package_version

_UPRIGHT = [-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]
"""The turn, xyzw, that lays z on y."""
_ARRAY, _INDICES = 34962, 34963
_FLOAT, _UINT = 5126, 5125
_JSON, _BIN = 0x4E4F534A, 0x004E4942


def write_glb(inventory: Inventory, path: Path) -> None:
    """Write what is seen of a scene, at rest, as one file. Masses and what glTF cannot say are in the nodes' extras."""
    path.write_bytes(glb_bytes(inventory))


def glb_bytes(inventory: Inventory) -> bytes:
    """The bytes of `write_glb`."""
    parts = room_parts(inventory)
    book = _Book({**inventory.looks, **parts.looks}, texture_files(inventory, parts.pictures))
    names = Names(body.name for item in inventory.objects for body in item.bodies)
    objects = [_object(book, item) for item in inventory.objects]
    children = [_room(book, parts, names), *objects, *_cameras(book, inventory, names)]
    root = book.node(names.give("thinkblox"), rotation=_UPRIGHT, children=children)
    return book.bytes(root, {"prompt": inventory.scene.prompt, "mujoco": mujoco.__version__})


def _room(book: "_Book", parts: RoomParts, names: Names) -> int:
    named: dict[str, list[int]] = {}
    labels: dict[str, str] = {}
    for part in parts.parts:
        named.setdefault(part.name, []).append(book.primitive(part.mesh, part.look))
        labels[part.name] = part.label
    children = [
        book.node(names.give(name), mesh=book.mesh(name, primitives), extras={"label": labels[name]})
        for name, primitives in named.items()
    ]
    return book.node(names.give("room"), children=children)


def _object(book: "_Book", item: InventoryObject) -> int:
    first, *joined = item.bodies
    children = [_body(book, item, body, body.in_object, {"link": body.link, "label": body.label}) for body in joined]
    said = {"id": item.id, "category": item.category, "asset": item.asset, "free": item.free}
    said |= {"licence": item.licence, "author": item.author}
    return _body(book, item, first, first.settled, said, children)


def _body(
    book: "_Book",
    item: InventoryObject,
    body: InventoryBody,
    pose: Pose,
    said: dict[str, Any],
    children: list[int] | None = None,
) -> int:
    (w, *xyz), extras = pose[1], {**said, "mass": body.mass}
    if body.joint is not None:
        joint = body.joint
        extras["joint"] = {
            "kind": joint.kind, "axis": joint.axis, "lower": joint.lower, "upper": joint.upper,
            "friction": joint.friction, "damping": joint.damping,
        }  # fmt: skip
    mesh = book.shared_mesh((item.asset, body.link), body)
    more = {} if mesh is None else {"mesh": mesh}
    return book.node(
        body.name, translation=list(pose[0]), rotation=[*xyz, w], children=children or [], extras=extras, **more
    )


def _cameras(book: "_Book", inventory: Inventory, names: Names) -> list[int]:
    found = []
    for camera in cameras_of(inventory.scene):
        w, *xyz = camera.quat_wxyz
        number = book.camera(camera.name, math.radians(camera.fovy))
        name = names.give(camera.name)
        found.append(book.node(name, translation=list(camera.position), rotation=[*xyz, w], camera=number))
    return found


class _Book:
    """A glTF document being written: its JSON, and its one buffer.

    Args:
        looks: by name.
        pictures: PNG by path.
    """

    def __init__(self, looks: Mapping[str, InventoryLook], pictures: Mapping[str, bytes]) -> None:
        self._looks, self._pictures = looks, pictures
        self._lists: dict[str, list[Any]] = {}
        self._data = bytearray()
        self._known: dict[Any, int] = {}

    def _add(self, kind: str, value: Any) -> int:
        every = self._lists.setdefault(kind, [])
        every.append(value)
        return len(every) - 1

    def node(self, name: str, **values: Any) -> int:
        """Add a node; what is empty is left out, and a rotation is within the range that its numbers may have."""
        if "rotation" in values:
            values["rotation"] = [min(max(part, -1.0), 1.0) for part in values["rotation"]]
        return self._add("nodes", {"name": name, **{key: value for key, value in values.items() if value != []}})

    def camera(self, name: str, yfov: float) -> int:
        """Add a camera."""
        return self._add("cameras", {"name": name, "type": "perspective", "perspective": {"yfov": yfov, "znear": 0.02}})

    def mesh(self, name: str, primitives: list[Any]) -> int:
        """Add a mesh."""
        return self._add("meshes", {"name": name, "primitives": primitives})

    def shared_mesh(self, key: tuple[str, str], body: InventoryBody) -> int | None:
        """The mesh of a link of an asset, made when first asked for; None for one that is not seen."""
        if key not in self._known:
            primitives = self._primitives(body)
            if not primitives:
                return None
            self._known[key] = self.mesh("_".join(key), primitives)
        return self._known[key]

    def _primitives(self, body: InventoryBody) -> list[Any]:
        groups: dict[str, list[tuple[NDArray[Any], NDArray[Any], NDArray[Any]]]] = {}
        found = []
        for geom in body.geoms:
            if geom.look is not None and geom.shape is not None:
                seen = placed(geom.shape)
                groups.setdefault(geom.look, []).append((seen.points, seen.normals, seen.triangles))
            elif geom.look is not None and geom.mesh is not None:
                found.append(self.primitive(mesh_of(geom.mesh), geom.look, offset=geom.offset))
        for look, parts in groups.items():
            starts = np.cumsum([0] + [len(points) for points, _, _ in parts])
            points, normals = (np.concatenate([part[n] for part in parts]) for n in (0, 1))
            faces = np.concatenate([part[2] + start for part, start in zip(parts, starts, strict=False)])
            found.append(self._primitive(points, normals, None, faces, look))
        return found

    def primitive(self, mesh: TexturedMesh, look: str, *, offset: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Any:
        """Triangles of one look."""
        uv = mesh.uv if self._looks[look].texture is not None else None
        return self._primitive(mesh.vertices + np.asarray(offset), mesh.normals, uv, mesh.faces, look)

    def _primitive(
        self, points: NDArray[Any], normals: NDArray[Any], uv: NDArray[Any] | None, faces: NDArray[Any], look: str
    ) -> Any:
        length = np.linalg.norm(normals, axis=1, keepdims=True)
        attributes = {
            "POSITION": self._array(points, bounds=True),
            "NORMAL": self._array(normals / np.maximum(length, 1e-12)),
        }
        if uv is not None:
            # Of a picture in glTF v counts from the top.
            attributes["TEXCOORD_0"] = self._array(np.column_stack([uv[:, 0], 1.0 - uv[:, 1]]))
        indices = np.ascontiguousarray(faces, "<u4").ravel()
        view = self._view(indices.tobytes(), target=_INDICES)
        count = {"bufferView": view, "componentType": _UINT, "count": len(indices), "type": "SCALAR"}
        return {"attributes": attributes, "indices": self._add("accessors", count), "material": self._material(look)}

    def _array(self, values: NDArray[Any], *, bounds: bool = False) -> int:
        array = np.ascontiguousarray(values, "<f4")
        accessor: dict[str, Any] = {
            "bufferView": self._view(array.tobytes(), target=_ARRAY),
            "componentType": _FLOAT,
            "count": len(array),
            "type": f"VEC{array.shape[1]}",
        }
        if bounds:
            accessor |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
        return self._add("accessors", accessor)

    def _view(self, data: bytes, *, target: int | None = None) -> int:
        start = len(self._data)
        self._data += data + b"\0" * (-len(data) % 4)
        view = {"buffer": 0, "byteOffset": start, "byteLength": len(data)}
        return self._add("bufferViews", view if target is None else {**view, "target": target})

    def _material(self, name: str) -> int:
        if name not in self._known:
            self._known[name] = self._add("materials", self._made(self._looks[name]))
        return self._known[name]

    def _made(self, look: InventoryLook) -> dict[str, Any]:
        base = [round(channel, 5) for channel in linear(look.colour)]
        shading: dict[str, Any] = {
            "baseColorFactor": [*base, look.opacity],
            "metallicFactor": look.metallic,
            "roughnessFactor": look.roughness,
        }
        if look.texture is not None:
            shading["baseColorTexture"] = {"index": self._texture(look.texture)}
        made: dict[str, Any] = {"name": look.name, "pbrMetallicRoughness": shading}
        if look.opacity < 1.0:
            made["alphaMode"] = "BLEND"
        if look.glow:
            made["emissiveFactor"] = [min(channel * look.glow, 1.0) for channel in base]
        return made

    def _texture(self, id: str) -> int:
        view = self._view(self._pictures[blob_name(id, "png")])
        image = self._add("images", {"bufferView": view, "mimeType": "image/png"})
        if "samplers" not in self._lists:
            self._add("samplers", {"wrapS": 10497, "wrapT": 10497})
        return self._add("textures", {"source": image, "sampler": 0})

    def bytes(self, root: int, extras: dict[str, Any]) -> bytes:
        """The whole file, whose one scene is the node `root`."""
        document = {
            "asset": {"version": "2.0", "generator": f"thinkblox {package_version()}", "extras": extras},
            "scene": 0,
            "scenes": [{"name": "room", "nodes": [root]}],
            **self._lists,
            "buffers": [{"byteLength": len(self._data)}],
        }
        text = json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), _JSON) + text + struct.pack("<II", len(self._data), _BIN) + self._data
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
