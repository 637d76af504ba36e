"""What the judge reads of a finished room: records of its own, so that no code of the scene stands behind them."""

from pathlib import Path

import msgspec

from thinkblox.errors import InputError
from thinkblox.value import read_json

Vec2 = tuple[float, float]
Vec3 = tuple[float, float, float]


class ShapeRecord(msgspec.Struct, frozen=True):
    """A convex part of an asset, in the asset's frame [m]; `size` is its extent along its own axes."""

    kind: str
    size: Vec3
    position: Vec3
    quat_wxyz: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    points: tuple[Vec3, ...] = ()
    colour: Vec3 = (0.7, 0.7, 0.7)
    material: str = "wood"


class LookRecord(msgspec.Struct, frozen=True):
    """What a mesh looks like: an sRGB colour, 0 to 1, and perhaps a texture."""

    base_colour: Vec3 = (1.0, 1.0, 1.0)
    texture: str | None = None


class MeshRecord(msgspec.Struct, frozen=True):
    """A mesh that is seen instead of the shapes of its link."""

    look: LookRecord = LookRecord()


class JointRecord(msgspec.Struct, frozen=True):
    """How a link moves: "hinge" or "slide"."""

    kind: str


class LinkRecord(msgspec.Struct, frozen=True):
    """A rigid part."""

    shapes: tuple[ShapeRecord, ...]
    joint: JointRecord | None = None
    visuals: tuple[MeshRecord, ...] = ()


class SeenAsset(msgspec.Struct, frozen=True):
    """What a placement shows."""

    category: str
    size: Vec3
    links: tuple[LinkRecord, ...]
    description: str = ""
    mount: str = "floor"
    front: str = "one"
    gaze: str = "front"
    attributes: tuple[str, ...] = ()


class PlacementRecord(msgspec.Struct, frozen=True):
    """An asset at a pose: the centre of the footprint at the base [m], and a yaw [degrees], 0 facing +x."""

    id: str
    category: str
    asset: str
    position: Vec3
    yaw: float
    size: Vec3


class OpeningRecord(msgspec.Struct, frozen=True):
    """A door or window: `offset` along wall `wall` from its start, wall i starting at floor[i] [m]."""

    id: str
    kind: str
    wall: int
    offset: float
    width: float
    height: float
    sill: float = 0.0


class RoomRecord(msgspec.Struct, frozen=True):
    """Corners of the floor, counter-clockwise, and the height [m]."""

    floor: tuple[Vec2, ...]
    height: float = 2.6
    openings: tuple[OpeningRecord, ...] = ()


class SceneRecord(msgspec.Struct, frozen=True):
    """A furnished room."""

    room: RoomRecord
    placements: tuple[PlacementRecord, ...] = ()
    assets: dict[str, SeenAsset] = {}
    prompt: str = ""


class ReportRecord(msgspec.Struct, frozen=True):
    """What the room's own report says of the whole."""

    valid: bool
    complete: bool = False


def read_scene(folder: Path) -> SceneRecord:
    """The scene.json of an output folder; raises InputError."""
    scene = read_json(folder / "scene.json", SceneRecord)
    for placement in scene.placements:
        if placement.asset not in scene.assets:
            raise InputError(f"{folder / 'scene.json'}: {placement.id} shows {placement.asset!r}, which is not there")
    for opening in scene.room.openings:
        if not 0 <= opening.wall < len(scene.room.floor):
            raise InputError(f"{folder / 'scene.json'}: {opening.id} is in wall {opening.wall}, which is not there")
    return scene


def read_report(folder: Path) -> ReportRecord | None:
    """The report.json of an output folder, None where it has none; raises InputError."""
    file = folder / "report.json"
    return read_json(file, ReportRecord) if file.exists() else None
