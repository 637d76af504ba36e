"""Triangles with UV to be looked at, as bytes: a header and four little-endian arrays, nothing else."""

import struct
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thinkblox.errors import InputError
from thinkblox.scene.blobs import BLOBS

MAX_CORNERS = MAX_FACES = 2_000_000
"""Most vertices and triangles of one mesh."""
REACH = 100.0
"""Farthest that a mesh may reach from its asset's origin along any axis [m]."""
_MAGIC = b"TBMESH01"
_HEADER = struct.Struct("<8sII")


@dataclass(frozen=True)
class TexturedMesh:
    """Triangles, counter-clockwise seen from outside, in the asset's frame.

    Attributes:
        vertices: (n, 3) [m]; a corner where normals or UV part is listed once for each of them.
        normals: (n, 3), unit length.
        uv: (n, 2), u to the right and v up in the texture, which repeats; (0, 0) is its lower left corner.
        faces: (m, 3) indices into the vertices.

    Raises:
        InputError: arrays of other shapes, numbers that are not finite, normals that are no directions, a face that
            names a vertex that does not exist, or too much of anything.
    """

    vertices: NDArray[np.float32]
    normals: NDArray[np.float32]
    uv: NDArray[np.float32]
    faces: NDArray[np.int32]

    def __post_init__(self) -> None:
        count = len(self.vertices)
        if not 4 <= count <= MAX_CORNERS or not 1 <= len(self.faces) <= MAX_FACES:
            raise InputError(f"a mesh of {count} vertices and {len(self.faces)} triangles cannot be used")
        for name, array, shape in (
            ("vertices", self.vertices, (count, 3)),
            ("normals", self.normals, (count, 3)),
            ("uv", self.uv, (count, 2)),
            ("faces", self.faces, (len(self.faces), 3)),
        ):
            if array.shape != shape:
                raise InputError(f"the {name} of a mesh have the shape {array.shape}; they must have {shape}")
            if not np.isfinite(array).all():
                raise InputError(f"the {name} of a mesh hold what is not a finite number")
        self._check_values()

    def _check_values(self) -> None:
        if self.faces.min() < 0 or self.faces.max() >= len(self.vertices):
            raise InputError("a triangle of a mesh names a vertex that does not exist")
        if np.abs(self.vertices).max() > REACH:
            raise InputError(f"a mesh reaches further than {REACH:g} m from its origin; lengths are in metres")
        if np.abs(np.linalg.norm(self.normals, axis=1) - 1.0).max() > 1e-2:
            raise InputError("a mesh has normals that are not of unit length")

    def to_bytes(self) -> bytes:
        """The mesh as bytes; equal meshes give equal bytes."""
        floats = (np.ascontiguousarray(a, "<f4").tobytes() for a in (self.vertices, self.normals, self.uv))
        header = _HEADER.pack(_MAGIC, len(self.vertices), len(self.faces))
        return b"".join([header, *floats, np.ascontiguousarray(self.faces, "<i4").tobytes()])

    @classmethod
    def of(cls, *, vertices: ArrayLike, normals: ArrayLike, uv: ArrayLike, faces: ArrayLike) -> "TexturedMesh":
        """A mesh of any arrays or lists."""
        return cls(
            np.asarray(vertices, np.float32),
            np.asarray(normals, np.float32),
            np.asarray(uv, np.float32),
            np.asarray(faces, np.int32),
        )

    @classmethod
    def from_bytes(cls, data: bytes) -> "TexturedMesh":
        """The inverse of `to_bytes`; raises InputError for anything else."""
        if len(data) < _HEADER.size or not data.startswith(_MAGIC):
            raise InputError("is no mesh: it does not begin as one")
        _, corners, count = _HEADER.unpack_from(data)
        if len(data) != _HEADER.size + 4 * (8 * corners + 3 * count):
            raise InputError(f"is no mesh: {corners} vertices and {count} triangles do not take {len(data)} bytes")
        rows, at = [], _HEADER.size
        for kind, number, width in (("<f4", corners, 3), ("<f4", corners, 3), ("<f4", corners, 2), ("<i4", count, 3)):
            rows.append(_array(data, kind, at, number, width))
            at += 4 * number * width
        vertices, normals, uv, faces = rows
        return cls.of(vertices=vertices, normals=normals, uv=uv, faces=faces)


def _array(data: bytes, kind: str, at: int, rows: int, columns: int) -> NDArray[Any]:
    return np.frombuffer(data, kind, rows * columns, at).reshape(rows, columns)


def put_mesh(mesh: TexturedMesh) -> str:
    """Keep a mesh as a blob; returns its name."""
    return BLOBS.put(mesh.to_bytes())


@lru_cache(maxsize=32)
def mesh_of(id: str) -> TexturedMesh:
    """The mesh in a blob; raises InputError when there is no such blob, or it holds none."""
    try:
        return TexturedMesh.from_bytes(BLOBS.get(id))
    except InputError as error:
        raise InputError(f"mesh {id[:12]}: {error}") from error
