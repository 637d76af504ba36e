"""Where the rooms of an environment come from: a scene, its file or folder, or a folder of such folders."""

import hashlib
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.mjcf import write_mjcf
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.scene import Scene, load_scene, scene_given
from thinkblox.sim.build import FREE_SUFFIX
from thinkblox.sim.environment.extra import needed
from thinkblox.value import to_json

RoomLike = str | Path | Scene
SCENE_FILE = "scene.json"
EXPORTED = (".xml", ".usd", ".usda", ".usdc", ".usdz", ".glb", ".urdf", ".sdf")
KEPT = 8
"""Most rooms that are kept open at a time."""
TIMESTEP = 0.004
"""Of the engine, unless a robot asks for a shorter one [s]."""


@dataclass(frozen=True)
class RoomSource:
    """A room by its name, and where it is read from.

    Attributes:
        name: of its folder, or "room".
    """

    name: str
    home: Path | Scene

    def load(self) -> Scene:
        """Read it; raises InputError when it cannot be read."""
        return self.home if isinstance(self.home, Scene) else load_scene(self.home)


def rooms_of(room: RoomLike | Iterable[RoomLike]) -> tuple[RoomSource, ...]:
    """The rooms that are meant, by their names where a folder holds several.

    Args:
        room: a scene, a scene.json, the folder of a room, a folder of such folders, or several of these.

    Raises:
        InputError: no room is there.
    """
    if isinstance(room, Scene):
        return (RoomSource("room", room),)
    if not isinstance(room, str | Path | Iterable):
        return (RoomSource("room", scene_given(room)),)
    if not isinstance(room, str | Path):
        return tuple(source for each in room for source in rooms_of(each))
    path = Path(room)
    if path.is_file() and path.suffix.lower() in EXPORTED:
        raise InputError(f"{path}: an environment is made of a scene.json, which stands beside what was exported of it")
    if path.is_file():
        return (RoomSource(path.parent.name or "room", path),)
    if (path / SCENE_FILE).is_file():
        return (RoomSource(path.resolve().name, path),)
    found = sorted(file.parent for file in path.glob(f"*/{SCENE_FILE}")) if path.is_dir() else []
    if not found:
        raise InputError(
            f"{path}: no room is there; name a scene.json, the folder of a room, or a folder of such folders"
        )
    return tuple(RoomSource(folder.name, folder) for folder in found)


@dataclass(frozen=True)
class OpenRoom:
    """A room as it was measured, and where everything in it rests."""

    name: str
    scene: Scene
    inventory: Inventory

    @property
    def rest(self) -> dict[str, NDArray[np.float64]]:
        """What each joint has at rest, by the joint's name in the model."""
        left, found = list(self.inventory.state.qpos), dict[str, NDArray[np.float64]]()
        for item in self.inventory.objects:
            if item.free:
                found[item.name + FREE_SUFFIX] = np.array([left.pop(0) for _ in range(7)])
            for body in item.bodies:
                if body.joint is not None:
                    found[body.name] = np.array([left.pop(0)])
        return found

    @cached_property
    def model(self) -> tuple[str, dict[str, bytes]]:
        """Its MJCF, and the meshes and textures that it names."""
        with tempfile.TemporaryDirectory(prefix="thinkblox-") as folder:
            home = Path(folder)
            write_mjcf(self.inventory, home / "scene.xml")
            files = {path.relative_to(home).as_posix(): path.read_bytes() for path in home.rglob("*") if path.is_file()}
        return files.pop("scene.xml").decode(), files


def opened(source: RoomSource) -> OpenRoom:
    """Read a room and let it come to rest; raises InputError when it cannot be read or built.

    The last few are kept: environments of the same room share what it is made of.
    """
    scene = source.load()
    content = (source.name, hashlib.sha256(to_json(scene)).digest())
    if content not in _opened:
        while len(_opened) >= KEPT:
            _opened.pop(next(iter(_opened)))
        _opened[content] = OpenRoom(source.name, scene, inventory_of(scene))
    return _opened[content]


_opened: dict[tuple[str, bytes], OpenRoom] = {}


def make_arena(room: OpenRoom, *, timestep: float = TIMESTEP) -> Any:
    """The room as a `dm_control.composer.Arena`, its elements called as in its MJCF; doorways are closed.

    Its keyframes are left out: they say nothing of a robot.
    """
    xml, files = room.model
    root = needed("dm_control.mjcf").from_xml_string(xml, assets=files)
    root.model = "room"
    for key in list(root.keyframe.all_children()):
        key.remove()
    root.option.timestep = timestep
    _close_doorways(root, room)
    return _arena_class()(root)


@cache
def _arena_class() -> Any:
    base: Any = needed("dm_control.composer").Arena

    class RoomArena(base):  # type: ignore[misc]
        """A room; what it is made of is given."""

        def _build(self, root: Any) -> None:
            self._mjcf_root = root

    return RoomArena


def _close_doorways(root: Any, room: OpenRoom) -> None:
    """Nothing that drives leaves the room: a box that is not seen behind every doorway, outside the walls."""
    thickness = room.inventory.physics.wall_thickness
    for opening in room.scene.room.openings:
        wall = room.scene.room.walls[opening.wall]
        if opening.sill > thickness:
            continue
        x, y = wall.point(opening.offset + opening.width / 2, -1.5 * thickness)
        half = np.radians(wall.yaw + 90.0) / 2
        root.worldbody.add(
            "geom",
            name=f"{opening.id}_stop",
            type="box",
            pos=(x, y, opening.sill + opening.height / 2),
            quat=(np.cos(half), 0.0, 0.0, np.sin(half)),
            size=(opening.width / 2 + thickness, thickness / 2, opening.height / 2),
            group=3,
            rgba=(0.5, 0.5, 0.5, 0.0),
        )
