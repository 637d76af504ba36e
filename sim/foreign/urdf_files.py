"""Where the mesh files of a URDF are: ROS addresses and paths relative to the file, inside its package."""

import re
from pathlib import Path

from thinkblox.sim.foreign.local_files import is_file, is_inside, locate

_ADDRESS = re.compile(r"^(?:package|model)://([^/]+)/(.+)$")
_LEVELS = 5
"""How many folders up a package may begin."""


def package_folder(path: Path) -> Path:
    """The folder that a URDF's files may lie in: the nearest one above it with a package.xml, or else its own."""
    above = path.absolute().parents[:_LEVELS]
    return next((folder for folder in above if (folder / "package.xml").is_file()), path.absolute().parent)


def mesh_file(text: str, where: object, *, path: Path, folder: Path, meshdir: str = "") -> Path:
    """The file that a mesh's filename means.

    "package://NAME/REST" and "model://NAME/REST" are REST in the folder NAME above the URDF or in its folder, or, where
    a package was renamed, REST itself there. Anything else is relative to the URDF or to the engine's `meshdir`, or a
    file of that name there: like the engine, this bears folders that were on somebody else's disk.

    Args:
        text: the filename as written.
        where: the element that names it, for messages.
        path: of the URDF.
        folder: what other paths must not leave.
        meshdir: of a <mujoco><compiler> in the URDF.

    Raises:
        InputError: an absolute path, one that leaves the folder, or no such file.
    """
    own, address = path.absolute().parent, _ADDRESS.match(text)
    if address:
        name, rest = address.groups()
        named = next((above for above in own.parents[: _LEVELS - 1] if above.name == name), None)
        named = own if own.name == name else named
        package = named if named is not None and not named.is_relative_to(folder) else folder
        bases = [base for base in (named, own / name, folder / name, folder, own) if base is not None]
        return locate(rest, where, bases=bases, folder=package)
    last = text.replace("\\", "/").rsplit("/", 1)[-1]
    named_so = [base / file for file in (text, last) for base in (own, own / meshdir)]
    found = next((file for file in named_so if is_file(file)), None)
    inside = found is not None and ".." not in found.parts and found.is_relative_to(folder)
    inside = inside and found is not None and is_inside(found, folder)
    return found if found and inside else locate(text, where, bases=(own, own / meshdir), folder=folder)
