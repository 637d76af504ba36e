"""A room and what stands in it, as a value: every change gives a new scene."""

import math
from pathlib import Path

from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset
from thinkblox.scene.asset_files import read_asset_files
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.value import Value, Vec3, read_json

SCENE_VERSION = 1
MAX_PLACEMENTS = 2000
"""Most objects in a scene that is read."""


class Scene(Value, frozen=True, kw_only=True):
    """A room, the assets it uses and their placements, in the order in which they were placed.

    Raises:
        InputError: a version this release does not read, too many placements, two of one id or one called as a part of
            the room is, or one whose asset is missing.
    """

    version: int = SCENE_VERSION
    prompt: str = ""
    seed: int = 0
    room: Room
    placements: tuple[Placement, ...] = ()
    assets: dict[str, Asset] = {}

    def __post_init__(self) -> None:
        if self.version != SCENE_VERSION:
            raise InputError(f"scene version {self.version} is not known; this release reads version {SCENE_VERSION}")
        if len(self.placements) > MAX_PLACEMENTS:
            raise InputError(f"the scene has {len(self.placements)} placements; at most {MAX_PLACEMENTS} are read")
        taken = {"floor", "ceiling"} | {w.name for w in self.room.walls} | {o.id for o in self.room.openings}
        seen: set[str] = set()
        for placement in self.placements:
            if placement.id in taken:
                raise InputError(f"a placement is called {placement.id!r}, which is the name of a part of the room")
            if placement.id in seen:
                raise InputError(f"two placements are called {placement.id!r}; ids must differ")
            seen.add(placement.id)
            if placement.asset not in self.assets:
                raise InputError(f"placement {placement.id!r}: the scene holds no asset {placement.asset!r}")

    def __contains__(self, id: str) -> bool:
        return any(p.id == id for p in self.placements)

    def __getitem__(self, id: str) -> Placement:
        """The placement called `id`; raises KeyError that lists the ids that exist."""
        for placement in self.placements:
            if placement.id == id:
                return placement
        raise KeyError(f"no object {id!r}; there are {', '.join(p.id for p in self.placements) or 'none'}")

    def asset_of(self, placement: Placement) -> Asset:
        """The asset that a placement shows."""
        return self.assets[placement.asset]

    def resting_on(self, id: str) -> tuple[Placement, ...]:
        """The placements directly supported by `id`."""
        return tuple(p for p in self.placements if p.support == id)

    def with_placement(self, placement: Placement, asset: Asset) -> "Scene":
        """Return this scene and one object more, or that object replaced in its place in the order."""
        kept = [placement if p.id == placement.id else p for p in self.placements]
        if placement.id not in self:
            kept.append(placement)
        return self._with(kept, {**self.assets, asset.id: asset})

    def without(self, id: str) -> "Scene":
        """Return this scene without one object; what rested on it stays. Raises KeyError for an unknown id."""
        gone = self[id]
        return self._with([p for p in self.placements if p is not gone], self.assets)

    def moved(self, id: str, *, position: Vec3 | None = None, yaw: float | None = None) -> "Scene":
        """Return this scene with one object at another pose.

        Raises:
            KeyError: an unknown id.
            InputError: a coordinate that is not a finite number.
        """
        old = self[id]
        if not all(math.isfinite(value) for value in (*(position or ()), yaw or 0.0)):
            raise InputError(f"{id} cannot be moved to {position} and turned to {yaw}: that is not a pose")
        new = structs.replace(
            old, position=old.position if position is None else position, yaw=old.yaw if yaw is None else yaw
        )
        return self._with([new if p is old else p for p in self.placements], self.assets)

    def _with(self, placements: list[Placement], assets: dict[str, Asset]) -> "Scene":
        used = {p.asset for p in placements}
        return structs.replace(
            self, placements=tuple(placements), assets={k: a for k, a in assets.items() if k in used}
        )


def load_scene(path: str | Path) -> Scene:
    """Read a scene from a scene.json or from the output folder that holds one, and find the blobs that it names.

    Raises:
        InputError: it cannot be read; or a mesh or texture of an asset is missing or altered, which names both.
    """
    file = Path(path)
    file = file / "scene.json" if file.is_dir() else file
    scene = read_json(file, Scene)
    read_asset_files(scene.assets.values(), file.parent)
    return scene
