"""The formats that a scene can be written in; a user's own is registered like ours.

from thinkblox.exporters import ExportFormat, register

register(ExportFormat(name="list", suffix=".txt", write=write_list, says="the names of all objects"))
thinkblox.save_scene(scene, "out/room", formats=("mjcf", "list"))  # writes scene.xml and scene.txt
"""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.errors import InputError
from thinkblox.given import names_given

if TYPE_CHECKING:
    from thinkblox.exporters.inventory import Inventory

DEFAULT = ("mjcf", "usd")
"""What is written unless told otherwise."""
_NAME = re.compile(r"[a-z][a-z0-9_-]{0,39}")
_SUFFIX = re.compile(r"(\.[a-z0-9]{1,20}){1,3}")


@dataclass(frozen=True)
class ExportFormat:
    """A way of writing a scene.

    Attributes:
        name: by which it is asked for: small letters, digits, "_" and "-".
        suffix: how its file ends, with the dot; the file is called "scene" otherwise.
        write: writes an inventory to a path; what else it writes goes into the same folder, named relative to it.
        says: what it writes, in a few words.

    Raises:
        InputError: a name or a suffix that cannot be one, or a writer that cannot be called.
    """

    name: str
    suffix: str
    write: "Callable[[Inventory, Path], None]"
    says: str

    def __post_init__(self) -> None:
        if not _NAME.fullmatch(self.name):
            raise InputError(f"{self.name!r} cannot name a format; use small letters, digits, '_' and '-'")
        if not _SUFFIX.fullmatch(self.suffix) or self.suffix == ".json":
            raise InputError(f"{self.suffix!r} cannot end a format's file; use a dot, small letters and digits")

        if not callable(self.write):
            raise InputError(f"the format {self.name!r} cannot be written by {self.write!r}; give a function")

    @property
    def file(self) -> str:
        """The name of its file."""
        return f"scene{self.suffix}"


def _write_mjcf(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.mjcf import write_mjcf

    write_mjcf(inventory, path)


def _write_single_mjcf(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.mjcf import write_single_mjcf

    write_single_mjcf(inventory, path)


def _write_robosuite(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.mjcf import write_mjcf

    write_mjcf(inventory, path, flavor="robosuite")


def _write_mjx(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.mjcf import write_mjcf

    write_mjcf(inventory, path, flavor="mjx")


def _write_usd(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.usd import write_usd

    write_usd(inventory, path)


def _write_glb(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.glb import write_glb

    write_glb(inventory, path)


def _write_urdf(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.urdf import write_urdf

    write_urdf(inventory, path)


def _write_sdf(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.sdf import write_sdf

    write_sdf(inventory, path)


def _write_simready(inventory: "Inventory", path: Path) -> None:
    from thinkblox.exporters.simready import write_simready

    write_simready(inventory, path)


_FORMATS = {
    "mjcf": ExportFormat(
        "mjcf", ".xml", _write_mjcf, "MuJoCo's model of the room, with the keyframes 'settled' and 'home'"
    ),
    "mjcf-single": ExportFormat(
        "mjcf-single", ".single.xml", _write_single_mjcf, "the same in one file: hulls as points, textures as colours"
    ),
    "mjcf-robosuite": ExportFormat(
        "mjcf-robosuite", ".robosuite.xml", _write_robosuite, "the same with robosuite's groups and sites"
    ),
    "mjcf-mjx": ExportFormat("mjcf-mjx", ".mjx.xml", _write_mjx, "the same of pairs that MJX can collide"),
    "usd": ExportFormat("usd", ".usda", _write_usd, "the same bodies, masses, colliders and joints as UsdPhysics"),
    "usdc": ExportFormat("usdc", ".usdc", _write_usd, "the same stage in USD's binary format"),
    "usdz": ExportFormat("usdz", ".usdz", _write_usd, "the same stage with all that it needs in one file"),
    "simready": ExportFormat(
        "simready", ".simready.json", _write_simready, "which assets are packages of SimReady's profile Robotics-Prop"
    ),
    "glb": ExportFormat("glb", ".glb", _write_glb, "what is seen as glTF: nodes for objects and links, materials"),
    "urdf": ExportFormat("urdf", ".urdf", _write_urdf, "the room as URDF, and one URDF for each object in models"),
    "sdf": ExportFormat("sdf", ".sdf", _write_sdf, "the room as a world of SDF, for Gazebo and Drake"),
}


def register(format: ExportFormat, *, replace: bool = False) -> None:
    """Add a format; from then on it can be asked for by its name.

    Raises:
        InputError: the name is taken, unless `replace`.
    """
    if format.name in _FORMATS and not replace:
        raise InputError(f"there is a format {format.name!r} already; choose another name, or replace=True")
    _FORMATS[format.name] = format


def formats() -> tuple[ExportFormat, ...]:
    """All formats, ours first."""
    return tuple(_FORMATS.values())


def format_for(path: Path) -> ExportFormat:
    """The format whose file ends as a path does, the longest such ending.

    Raises:
        InputError: no format's file ends so.
    """
    name = path.name.lower()
    found = [known for known in _FORMATS.values() if name.endswith(known.suffix)]
    if not found:
        if name.endswith(".usd"):
            return ExportFormat("usd", ".usd", _write_usd, _FORMATS["usd"].says)
        endings = ", ".join(dict.fromkeys((*(known.suffix for known in _FORMATS.values()), ".usd")))
        raise InputError(f"{path}: no format's file ends so; the endings are {endings}")
    return max(found, key=lambda known: len(known.suffix))


def flavored(names: Iterable[str], flavor: str | None) -> tuple[str, ...]:
    """The names with each format that has such a flavor in its place: "mjcf" as "mjcf-mjx".

    Raises:
        InputError: none of them has it.
    """
    names = tuple(names)
    if flavor is None:
        return names
    found = tuple(f"{name}-{flavor}" if f"{name}-{flavor}" in _FORMATS else name for name in names)
    if found == names:
        raise InputError(f"none of {', '.join(names)} has a flavor {flavor!r}; mjcf has robosuite and mjx")
    return found


def formats_named(names: Sequence[str]) -> tuple[ExportFormat, ...]:
    """The formats of some names, each once.

    Raises:
        InputError: a name that no format has, or two formats that would write the same file.
    """
    chosen: dict[str, ExportFormat] = {}
    for name in dict.fromkeys(names_given(names, "formats")):
        if name == "gltf":
            raise InputError("glTF is written in one file: ask for 'glb'")
        if name not in _FORMATS:
            raise InputError(f"no format {name!r}; there are {', '.join(_FORMATS)}")
        known = _FORMATS[name]
        if known.file in chosen:
            raise InputError(f"formats {chosen[known.file].name!r} and {name!r} both write {known.file}; ask for one")
        chosen[known.file] = known
    return tuple(chosen.values())
