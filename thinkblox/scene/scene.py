"""A room and what stands in it, as a value: every change gives a new scene."""

from collections.abc import Iterable, Sequence
from importlib import import_module
from pathlib import Path

from msgspec import Struct, structs

from thinkblox.errors import InputError
from thinkblox.scene.actions import Action, check_pose, outcome
from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.asset import Asset
from thinkblox.scene.asset_files import read_asset_files
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.support import Supported, supported
from thinkblox.scene.surfaces import Surfaces, plain_surfaces
from thinkblox.value import Vec3, from_json, read_json_and_text

SCENE_VERSION = 1
MAX_PLACEMENTS = 2000
"""Most objects in a scene."""
NAMED = 40
"""Most objects that a message names."""
MAX_MADE_OF = {"links": 10_000, "shapes": 40_000, "joints": 2_000}
"""Most links, shapes and joints that all objects of a scene have together."""


class Scene(Arrangement, frozen=True, kw_only=True, dict=True):
    """A room, the assets it uses and their placements, in the order in which they were placed.

    What each placement rests on is derived when the scene is made, whatever the placement said.

    Raises:
        InputError: a version this release does not read, too many placements, two of one id or one called as a part of
            the room is, or one whose asset is missing; or they have too many parts together.
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
        taken = {"world", "floor", "ceiling"} | {w.name for w in self.room.walls} | {o.id for o in self.room.openings}
        seen: set[str] = set()
        for placement in self.placements:
            if placement.id in taken:
                raise InputError(f"a placement is called {placement.id!r}, which is the name of a part of the room")
            if placement.id in seen:
                raise InputError(f"two placements are called {placement.id!r}; ids must differ")
            seen.add(placement.id)
            if placement.asset not in self.assets:
                raise InputError(f"placement {placement.id!r}: the scene holds no asset {placement.asset!r}")
        _check_amount(self.placements, self.assets)
        structs.force_setattr(self, "placements", supported(self, self.room, self.assets))

    @property
    def surfaces(self) -> Surfaces:
        """What the room is finished with: as it says, or plainly, by the seed."""
        return self.room.surfaces or plain_surfaces(self.seed)

    def asset_of(self, placement: Placement) -> Asset:
        """The asset that a placement shows."""
        return self.assets[placement.asset]

    def apply(self, action: Action) -> "Scene":
        """Return the scene after an action; what it does not concern stays bit-identical.

        What rests on a moved thing rides along; `thinkblox.scene.actions.outcome` says what did, and what was left.

        Raises:
            InputError: an id that the scene does not have, which lists those that it has, or an action that cannot be
                done, such as adding an id that exists.
        """
        return outcome(self, action).scene

    def with_placement(self, placement: Placement, asset: Known) -> "Scene":
        """Return this scene and one object more, or that object replaced in its place in the order."""
        if not isinstance(asset, Asset):
            raise InputError(f"{placement.id}: a scene holds whole assets; this is a {type(asset).__name__}")
        kept = [placement if p.id == placement.id else p for p in self.placements]
        if placement.id not in self:
            kept.append(placement)
        before = self.assets.get(asset.id, asset)
        same = before is asset or before == asset
        others = [p.id for p in self.placements if p.asset == asset.id and p.id != placement.id]
        if not same and others:
            raise InputError(
                f"{placement.id}: its asset is called {asset.id!r}, as is another one that {others[0]} shows;"
                " ids of assets must differ with their content, as those of ThinkBLOX, which end in a hash of it"
            )
        return self._with(kept, {**self.assets, asset.id: asset}, [placement.id] if same else None)

    def with_placements(self, placements: Iterable[Placement]) -> "Scene":
        """Return this scene with some of its objects at other poses; raises KeyError for an unknown id."""
        new = {placement.id: placement for placement in placements}
        for id in new:
            self[id]
        return self._with([new.get(p.id, p) for p in self.placements], self.assets, list(new))

    def without(self, id: str) -> "Scene":
        """Return this scene without one object; what rested on it stays. Raises KeyError for an unknown id."""
        gone = self[id]
        return self._with([p for p in self.placements if p is not gone], self.assets, [id])

    def moved(self, id: str, *, position: Vec3 | None = None, yaw: float | None = None) -> "Scene":
        """Return this scene with one object alone at another pose; what rests on it stays where it is.

        Raises:
            KeyError: an unknown id.
            InputError: a coordinate that is not a finite number.
        """
        old = self[id]
        place, turn = check_pose(id, old.position if position is None else position, yaw)
        new = structs.replace(old, position=place, yaw=old.yaw if turn is None else turn)
        return self.with_placements([new])

    def export(self, path: str | Path, *, doors: bool = False, overwrite: bool = False) -> Path:
        """Write it as one file in the format that its ending tells: "room.xml", "room.usdz", "room.glb" and so on.

        With `doors` its doors have leaves on hinges, and its windows panes.

        Raises:
            InputError: as of `thinkblox.exporters.exporting.export_file`.
        """
        # Imports flow towards scenes; what writes them is found when it is asked for.
        export = import_module("thinkblox.exporters.exporting").export_file
        written: Path = export(self, path, doors=doors, overwrite=overwrite)
        return written

    def _with(
        self, placements: Sequence[Placement], assets: dict[str, Asset], changed: Sequence[str] | None
    ) -> "Scene":
        used = {p.asset for p in placements}
        kept = {k: a for k, a in assets.items() if k in used}
        known = None if changed is None else Supported.of(placements, self.room, kept, changed)
        return structs.replace(self, placements=tuple(placements) if known is None else known, assets=kept)


def _check_amount(placements: Iterable[Placement], assets: dict[str, Asset]) -> None:
    made_of = {id: asset.made_of for id, asset in assets.items()}
    together = [sum(amounts) for amounts in zip(*(made_of[p.asset] for p in placements), strict=True)]
    for (part, most), amount in zip(MAX_MADE_OF.items(), together, strict=False):
        if amount > most:
            raise InputError(f"the objects of the scene have {amount} {part} together; at most {most} are read")


def load_scene(path: str | Path) -> Scene:
    """Read a scene from a scene.json or from the output folder that holds one, and find the blobs that it names.

    Raises:
        InputError: it cannot be read; or a placement rests on what is not there, which names what is; or a mesh or
            texture of an asset is missing or altered, which names both.
    """
    file = Path(path)
    file = file / "scene.json" if file.is_dir() else file
    scene, text = read_json_and_text(file, Scene)
    _check_supports(scene, from_json(text, _Written).placements, str(file))
    read_asset_files(scene.assets.values(), file.parent)
    return scene


def scene_given(scene: object) -> Scene:
    """What a caller gives for a scene; raises InputError, with what to give, when it is something else."""
    if isinstance(scene, Scene):
        return scene
    what = type(scene).__name__
    if isinstance(getattr(scene, "scene", None), Scene):
        raise InputError(f"a {what} is given for a Scene; give its .scene")
    hint = (
        "load_scene reads one from a file or folder" if isinstance(scene, str | Path) else "give one, as of load_scene"
    )
    raise InputError(f"a {what} is given for a Scene; {hint}")


class _WrittenPlacement(Struct):
    id: str
    support: str = ""


class _Written(Struct):
    """What a file says of supports, which a scene derives."""

    placements: tuple[_WrittenPlacement, ...] = ()


def _check_supports(scene: Scene, written: Iterable[_WrittenPlacement], where: str) -> None:
    """Refuse a support that names nothing: the file is not whole. Another one than the right one is put right."""
    parts = ["floor", "ceiling", *(wall.name for wall in scene.room.walls)]
    known = {"", *parts, *(placement.id for placement in scene.placements)}
    for placement in written:
        if placement.support not in known:
            ids = [other.id for other in scene.placements if other.id != placement.id]
            more = f" and {len(ids) - NAMED} more" if len(ids) > NAMED else ""
            raise InputError(
                f"{where}: placement {placement.id!r} rests on {placement.support!r}, which is not there;"
                f" there are {', '.join([*parts, *ids[:NAMED]])}{more}"
            )
