"""Mesh files of strangers, read with limits: glTF, OBJ, STL and PLY as one triangle soup in its own axes and units.

Nothing outside the file's folder is opened, nothing is executed or unpickled, and how much there is to read is found
out from the file's header before any of it is built.
"""

import json
import re
import struct
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
import trimesh
from numpy.typing import NDArray

from thinkblox.errors import InputError

SUFFIXES = (".glb", ".gltf", ".obj", ".stl", ".ply")
"""Kinds of file that are read."""
MAX_BYTES = 512_000_000
"""Largest mesh file that is read."""
MAX_TRIANGLES = 2_000_000
"""Most triangles of a mesh that is read, instances counted."""
_FACE = re.compile(rb"^\s*f\s", re.MULTILINE)
_PLY_FACES = re.compile(rb"^element face (\d{1,18})\s*$", re.MULTILINE)


@dataclass(frozen=True)
class MeshFile:
    """A mesh: corners (n, 3) and the indices of the corners of each triangle (m, 3)."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Its lowest and highest corner (2, 3)."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])


def read_triangles(path: Path) -> MeshFile:
    """Read a mesh file.

    Raises:
        InputError: it cannot be read, is of another kind, is too large or holds more than MAX_TRIANGLES, refers to a
            file outside its folder, is broken or empty, or has a corner that is not a finite number.
    """
    if path.suffix.lower() not in SUFFIXES:
        raise InputError(
            f"{path}: {path.suffix or 'a file without suffix'} is not read; meshes are {', '.join(SUFFIXES)}"
        )
    data = _contents(path)
    counted = _declared_triangles(path, data)
    if counted > MAX_TRIANGLES:
        raise InputError(f"{path}: has {counted} triangles; at most {MAX_TRIANGLES} are read: simplify the mesh")
    return _checked(path, _loaded(path, data))


def _contents(path: Path) -> bytes:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"{path}: is larger than {MAX_BYTES // 1_000_000} MB; simplify the mesh")
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error


def _declared_triangles(path: Path, data: bytes) -> int:
    """How many triangles the file says that it holds, without building any; 0 where it does not say."""
    kind = path.suffix.lower()
    if kind == ".obj":
        return len(_FACE.findall(data))
    if kind == ".stl":
        declared = int(struct.unpack_from("<I", data, 80)[0]) if len(data) >= 84 else 0
        return declared if len(data) == 84 + 50 * declared else data.count(b"facet normal")
    if kind == ".ply":
        found = _PLY_FACES.search(data[:65536])
        return int(found[1]) if found else 0
    return _gltf_triangles(_gltf_header(path, data))


def _gltf_header(path: Path, data: bytes) -> dict[str, Any]:
    try:
        if path.suffix.lower() == ".glb":
            length, kind = struct.unpack_from("<II", data, 12)
            if data[:4] != b"glTF" or kind != 0x4E4F534A:
                raise ValueError("it does not begin as binary glTF does")
            data = data[20 : 20 + length]
        header = json.loads(data)
    except (ValueError, struct.error, RecursionError) as error:
        raise InputError(f"{path}: is not glTF: {error}") from error
    if not isinstance(header, dict):
        raise InputError(f"{path}: is not glTF: its JSON is no object")
    return header


def _gltf_triangles(header: dict[str, Any]) -> int:
    """Triangles of all meshes, each counted as often as a node shows it."""
    try:
        counts = [accessor["count"] for accessor in header.get("accessors", [])]
        shown = [node["mesh"] for node in header.get("nodes", []) if "mesh" in node]
        total = 0
        for index, mesh in enumerate(header.get("meshes", [])):
            corners = sum(counts[p.get("indices", p["attributes"]["POSITION"])] for p in mesh["primitives"])
            total += int(corners) // 3 * shown.count(index)
    except (KeyError, IndexError, TypeError, AttributeError):
        return 0
    return total


class _Beside(trimesh.resolvers.Resolver):
    """Opens what a mesh file refers to, from its own folder and nowhere else."""

    def __init__(self, path: Path) -> None:
        self._path, self._folder = path, path.parent.resolve()

    def get(self, name: str) -> bytes:
        file = (self._folder / unquote(name)).resolve()
        if not file.is_relative_to(self._folder):
            raise InputError(f"{self._path}: refers to {name!r}, which is outside its folder; it is not opened")
        return _contents(file)

    def keys(self) -> list[str]:
        return []

    def namespaced(self, namespace: str) -> "_Beside":
        return self

    def write(self, name: str, data: bytes | str) -> None:
        raise InputError(f"{self._path}: reading a mesh writes nothing")


def _loaded(path: Path, data: bytes) -> MeshFile:
    beside, kind = _Beside(path), path.suffix.lower()[1:]
    try:
        scene = trimesh.load_scene(BytesIO(data), file_type=kind, resolver=beside, process=False, skip_materials=True)
        names = [scene.graph[node][1] for node in scene.graph.nodes_geometry]
        total = sum(len(scene.geometry[name].faces) for name in names if hasattr(scene.geometry[name], "faces"))
        if total > MAX_TRIANGLES:
            raise InputError(f"{path}: has {total} triangles; at most {MAX_TRIANGLES} are read: simplify the mesh")
        meshes = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh) and len(part.faces)]
    except InputError:
        raise
    except Exception as error:  # A broken file makes the loaders raise nearly anything.
        raise InputError(f"{path}: is broken: {type(error).__name__}: {' '.join(str(error).split())[:200]}") from error
    if not meshes:
        raise InputError(f"{path}: holds no triangles")
    starts = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    return MeshFile(
        np.vstack([np.asarray(mesh.vertices, dtype=np.float64) for mesh in meshes]),
        np.vstack([np.asarray(m.faces, dtype=np.int64) + start for m, start in zip(meshes, starts, strict=False)]),
    )


def _checked(path: Path, mesh: MeshFile) -> MeshFile:
    if mesh.faces.min() < 0 or mesh.faces.max() >= len(mesh.vertices):
        raise InputError(f"{path}: is broken: a triangle names a corner that does not exist")
    used, faces = np.unique(mesh.faces, return_inverse=True)
    corners = mesh.vertices[used]
    if not np.isfinite(corners).all():
        raise InputError(f"{path}: has a corner that is not a finite number")
    return MeshFile(corners, faces.reshape(-1, 3))
