"""The files that a model names, with how much geometry and how many pixels they hold by their headers."""

import struct
from collections.abc import Mapping
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.sim.foreign.local_files import read_limited

LARGEST_MESH, LARGEST_OTHER = 2**30, 2**28
"""Of one mesh file, and of one texture, height field or skin [bytes]."""
MOST_TRIANGLES = 5_000_000
"""Of one mesh."""
MOST_TRIANGLES_IN_ALL = 20_000_000
LARGEST_IN_ALL = 2**31
"""Of all files that a model names [bytes]."""
MOST_PIXELS = 100_000_000
"""Of one picture, be it a file or made by the engine."""
MESH_KINDS = (".stl", ".obj", ".msh")
PNG, KTX = b"\x89PNG\r\n\x1a\n", b"\xabKTX 11\xbb\r\n\x1a\n"


def read_mesh(path: Path, where: object) -> tuple[bytes, int]:
    """The bytes of a mesh file and the number of its triangles, 0 where the file does not say.

    Args:
        path: of an existing file.
        where: the element that names it, for messages.

    Raises:
        InputError: a kind of mesh that the engine does not read, or too large.
    """
    kind = path.suffix.lower()
    if kind not in MESH_KINDS:
        raise InputError(
            f'{where}: the mesh "{path.name}" is of a kind that MuJoCo does not read: convert it to OBJ, binary STL or'
            " MSH."
        )
    data = _read(path, where, LARGEST_MESH)
    triangles = {".stl": _stl, ".obj": _obj, ".msh": _msh}[kind](data)
    if triangles > MOST_TRIANGLES:
        raise InputError(
            f'{where}: the mesh "{path.name}" has {triangles} triangles; at most {MOST_TRIANGLES} are read: simplify'
            " it."
        )
    return data, triangles


def check_amount(path: Path, triangles: int, data: Mapping[str, bytes]) -> None:
    """See that the files of one model are not too much together.

    Args:
        path: of the model, for messages.
        triangles: of all its meshes.
        data: of all its files.

    Raises:
        InputError: they are.
    """
    if sum(map(len, data.values())) > LARGEST_IN_ALL:
        raise InputError(f"{path}: its files have more than {LARGEST_IN_ALL // 2**20} MiB together.")
    if triangles > MOST_TRIANGLES_IN_ALL:
        raise InputError(f"{path}: its meshes have {triangles} triangles together; at most {MOST_TRIANGLES_IN_ALL}.")


def read_other(path: Path, where: object) -> bytes:
    """The bytes of a texture, height field or skin; raises InputError when it is too large."""
    data = _read(path, where, LARGEST_OTHER)
    width, height = _png_size(data)
    if width * height > MOST_PIXELS:
        raise InputError(f'{where}: the picture "{path.name}" has {width} x {height} pixels; at most {MOST_PIXELS}.')
    return data


def is_picture(data: bytes) -> bool:
    """Whether the engine reads a file as a texture: PNG and KTX."""
    return data.startswith((PNG, KTX))


def _read(path: Path, where: object, largest: int) -> bytes:
    data = read_limited(path, where, largest)
    if not data:
        raise InputError(f'{where}: the file "{path.name}" is empty.')
    return data


def _stl(data: bytes) -> int:
    """Binary STL: 80 bytes of text, then the number of triangles."""
    return int(struct.unpack_from("<I", data, 80)[0]) if len(data) >= 84 and data[:6] != b"solid " else 0


def _msh(data: bytes) -> int:
    """MuJoCo's own format: the numbers of vertices, normals, texture coordinates and faces; Gmsh's does not say."""
    known = len(data) >= 16 and not data.startswith(b"$MeshFormat")
    return max(0, struct.unpack_from("<4i", data)[3]) if known else 0


def _obj(data: bytes) -> int:
    """Wavefront OBJ: lines that begin with "f"; a polygon counts as one."""
    return data.count(b"\nf ") + data.startswith(b"f ")


def _png_size(data: bytes) -> tuple[int, int]:
    if len(data) < 24 or not data.startswith(PNG):
        return 0, 0
    width, height = struct.unpack(">II", data[16:24])
    return width, height
