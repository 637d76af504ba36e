"""How much geometry and how many pixels a model's files hold, read off their headers before anything is loaded."""

import struct
from pathlib import Path

from thinkblox.errors import InputError

LARGEST_MESH, LARGEST_OTHER = 2**30, 2**28
"""Of one mesh file, and of one texture, height field or skin [bytes]."""
MOST_TRIANGLES = 5_000_000
"""Of one mesh."""
MOST_PIXELS = 100_000_000
"""Of one picture, be it a file or made by the engine."""
MESH_KINDS = (".stl", ".obj", ".msh")
_CHUNK = 2**24


def check_mesh(path: Path, where: object) -> int:
    """The number of triangles of a mesh file, 0 where the file does not say.

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
    _check_size(path, where, LARGEST_MESH)
    triangles = {".stl": _stl, ".obj": _obj, ".msh": _msh}[kind](path)
    if triangles > MOST_TRIANGLES:
        raise InputError(
            f'{where}: the mesh "{path.name}" has {triangles} triangles; at most {MOST_TRIANGLES} are read: simplify'
            " it."
        )
    return triangles


def check_other(path: Path, where: object) -> None:
    """See that a texture, height field or skin is not too large; raises InputError when it is."""
    _check_size(path, where, LARGEST_OTHER)
    width, height = _png_size(path)
    if width * height > MOST_PIXELS:
        raise InputError(f'{where}: the picture "{path.name}" has {width} x {height} pixels; at most {MOST_PIXELS}.')


def _check_size(path: Path, where: object, largest: int) -> None:
    size = path.stat().st_size
    if size > largest:
        raise InputError(f'{where}: "{path.name}" has {size / 2**20:.0f} MiB; at most {largest // 2**20} MiB are read.')
    if size == 0:
        raise InputError(f'{where}: the file "{path.name}" is empty.')


def _stl(path: Path) -> int:
    """Binary STL: 80 bytes of text, then the number of triangles."""
    header = _head(path, 84)
    return int(struct.unpack_from("<I", header, 80)[0]) if len(header) == 84 and header[:6] != b"solid " else 0


def _msh(path: Path) -> int:
    """MuJoCo's own format: the numbers of vertices, normals, texture coordinates and faces; Gmsh's does not say."""
    header = _head(path, 16)
    known = len(header) == 16 and not header.startswith(b"$MeshFormat")
    return max(0, struct.unpack("<4i", header)[3]) if known else 0


def _obj(path: Path) -> int:
    """Wavefront OBJ: lines that begin with "f"; a polygon counts as one."""
    count, last = 0, b"\n"
    with path.open("rb") as file:
        while chunk := file.read(_CHUNK):
            block = last + chunk
            count += block.count(b"\nf ")
            last = block[-2:]
    return count


def _png_size(path: Path) -> tuple[int, int]:
    header = _head(path, 24)
    if len(header) < 24 or not header.startswith(b"\x89PNG\r\n\x1a\n"):
        return 0, 0
    width, height = struct.unpack(">II", header[16:24])
    return width, height


def _head(path: Path, count: int) -> bytes:
    with path.open("rb") as file:
        return file.read(count)
