"""LayoutVLM (Sun et al. 2025), https://github.com/sunfanyunn/LayoutVLM: main.py, src/layoutvlm, utils.

What it writes, layout.json, is poses only, in metres and degrees::

    {"bed-0": {"position": [x, y, z], "rotation": [0, 0, degrees], "scale": 1.0?}, ...}

What they are poses of stands in the scene file it was given::

    {"task_description": "...", "boundary": {"floor_vertices": [[x, y, 0], ...], "wall_height": 2.5},
     "assets": {"bed-0": {"category": "bed", "path": ".../uid.glb", "onFloor": true, "onWall": ..., "onCeiling": ...,
                          "onObject": ..., "assetMetadata": {"boundingBox": {"x": 2.0, "y": 1.6, "z": 0.9}}}}}

Three ways to give both: one document whose `assets` carry `position` and `rotation`; one document with the poses under
the key `layout`; or layout.json with the scene file beside it in the same folder. In the benchmark's own scene files
the assets are `{"<uid>-0": {}}`; their records are then taken from `<assets>/<uid>/data.json` and named as main.py
does. Without these records a table of sizes says what the poses are poses of.

z up, right-handed, origin where the boundary has it. A pose is of the middle of the asset's bounding box; one of two
numbers stands on the floor. At rotation 0 the front faces +x, counter-clockwise from there (blender_render.py turns
what faces -y after import to +x). boundingBox.x is along the front: main.py swaps the x and y of data.json.
"""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any

from msgspec import UNSET, Meta, UnsetType

from thinkblox.importing.document import Degrees, Document, Extent, F, Foreign, Metres, beside, plain
from thinkblox.importing.draft import Item, LayoutDraft, RoomOutline
from thinkblox.importing.frames import about
from thinkblox.importing.library import AssetRecord, Library
from thinkblox.scene.asset import Mount
from thinkblox.value import Vec3

Numbers = Annotated[list[Metres], Meta(min_length=2, max_length=3)]
Scale = Annotated[float, Meta(gt=0.0, le=1000.0)]


class _Pose(Foreign, frozen=True, kw_only=True):
    position: Numbers
    rotation: list[Degrees] | Degrees = 0.0
    scale: Scale | list[Scale] = 1.0


class _Boundary(Foreign, frozen=True, kw_only=True):
    floor_vertices: list[Numbers]
    wall_height: Extent | None = None


class _Box(Foreign, frozen=True, kw_only=True):
    x: Extent
    y: Extent
    z: Extent


class _Metadata(Foreign, frozen=True, kw_only=True):
    boundingBox: _Box | UnsetType = UNSET  # noqa: N815 (the key's own name)


class _Asset(Foreign, frozen=True, kw_only=True):
    category: str = ""
    description: str | None = None
    path: str = ""
    onFloor: bool = False  # noqa: N815
    onWall: bool = False  # noqa: N815
    onCeiling: bool = False  # noqa: N815
    onObject: bool = False  # noqa: N815
    assetMetadata: _Metadata = _Metadata()  # noqa: N815
    position: Numbers | None = None


class _Scene(Foreign, frozen=True, kw_only=True):
    boundary: _Boundary
    assets: dict[str, Any]
    layout: dict[str, Any] = {}
    task_description: str = ""


@dataclass(frozen=True)
class _Both:
    """The scene, its assets and poses, and the documents and JSON path they come from."""

    scene: _Scene
    assets: Mapping[str, _Asset]
    poses: Mapping[str, _Pose]
    scene_file: Document
    pose_file: Document
    pose_at: str
    notes: tuple[str, ...] = ()


def is_layoutvlm(raw: Any) -> bool:
    """Whether a JSON value is a scene or a layout of LayoutVLM's."""
    if not isinstance(raw, dict):
        return False
    return _is_scene(raw) or _is_poses(raw)


def _is_scene(raw: Mapping[str, Any]) -> bool:
    return isinstance(raw.get("boundary"), dict) and "floor_vertices" in raw["boundary"]


def _is_poses(raw: Mapping[str, Any]) -> bool:
    return bool(raw) and all(
        isinstance(pose, dict) and {"position", "rotation"} <= pose.keys() for pose in raw.values()
    )


def read_layoutvlm(document: Document, library: Library) -> LayoutDraft:
    """Read a layout; raises InputError naming the file and JSON path of whatever is wrong."""
    both = _with_records(_together(document), library)
    items = tuple(_item(both, name, pose, library) for name, pose in both.poses.items())
    boundary = both.scene.boundary
    return LayoutDraft(
        outline=RoomOutline(
            corners=tuple((corner[0], corner[1]) for corner in boundary.floor_vertices),
            level=_level(boundary),
            height=boundary.wall_height,
            at="$.boundary.floor_vertices",
        ),
        items=items,
        prompt=both.scene.task_description,
        notes=both.notes,
        unplaced=tuple(name for name in both.assets if name not in both.poses),
    )


def _level(boundary: _Boundary) -> float:
    heights = [corner[2] for corner in boundary.floor_vertices if len(corner) == 3]
    return min(heights, default=0.0)


def _together(document: Document) -> _Both:
    if not isinstance(document.raw, dict):
        document.fail("$", "a layout of LayoutVLM is an object")
    if _is_poses(document.raw):
        poses = _each(document, _Pose, document.raw, "$")
        other = _scene_beside(document)
        note = f"The room and the assets were read from {other.path.name}, beside the layout."
        scene = other.typed(_Scene)
        return _Both(scene, _each(other, _Asset, scene.assets, "$.assets"), poses, other, document, "$", (note,))
    scene = document.typed(_Scene)
    assets = _each(document, _Asset, scene.assets, "$.assets")
    if scene.layout:
        poses = _each(document, _Pose, scene.layout, "$.layout")
        return _Both(scene, assets, poses, document, document, "$.layout")
    placed = {name: raw for name, raw in scene.assets.items() if assets[name].position is not None}
    return _Both(scene, assets, _each(document, _Pose, placed, "$.assets"), document, document, "$.assets")


def _each(document: Document, kind: type[F], raw: Mapping[str, Any], at: str) -> dict[str, F]:
    """Every value of an object as a typed value: so an error names its key."""
    return {key: document.part(kind, value, f"{at}.{plain(key)}") for key, value in raw.items()}


def _scene_beside(document: Document) -> Document:
    found = beside(document, lambda raw: isinstance(raw, dict) and _is_scene(raw))
    if len(found) != 1:
        names = ", ".join(other.path.name for other in found) or "none"
        document.fail(
            "$",
            "these are poses alone; LayoutVLM's scene file, with `boundary` and `assets`, must be the only one beside"
            f" it, and there is {names}",
        )
    return found[0]


def _with_records(both: _Both, library: Library) -> _Both:
    """The same with the assets' records and names, where the scene file only has their uids."""
    if not both.assets or any(asset != _Asset() for asset in both.assets.values()):
        return both
    copies = Counter(key.rpartition("-")[0] for key in both.assets)
    records = {uid: library.record(uid) for uid in copies}
    missing = [uid for uid, record in records.items() if record is None]
    if missing and library.sizes:
        return replace(both, assets={name: _Asset() for name in both.poses or both.assets})
    if missing:
        both.scene_file.fail(
            "$.assets",
            f"only uids, and {len(missing)} of them, as {missing[0]!r}, have no data.json; name the folder of assets"
            " (--assets), or a table of sizes (--sizes)",
        )
    return replace(both, assets=_named({uid: record for uid, record in records.items() if record is not None}, copies))


def _named(records: Mapping[str, AssetRecord], copies: Mapping[str, int]) -> dict[str, _Asset]:
    """The assets under the names that main.py gives them: it adds the letter again for every copy."""
    names = {uid: _variable(record) for uid, record in records.items()}
    kinds, seen, found = Counter(names.values()), Counter[str](), {}
    for uid, record in records.items():
        name = names[uid]
        letter = chr(ord("A") + seen[name]) if kinds[name] > 1 else ""
        seen[name] += 1
        for copy in range(copies[uid]):
            variable = name + f"_{letter}" * (copy + 1) if letter else name
            found[f"{variable}-{copy}"] = _asset(uid, record)
    return found


def _variable(record: AssetRecord) -> str:
    return "".join("_" if c in "- '/," else c for c in record.kind).lower()


def _asset(uid: str, record: AssetRecord) -> _Asset:
    told, size = record.annotations, record.box
    return _Asset(
        category=record.kind,
        path=f"{uid}/{uid}.glb",
        onFloor=bool(told and told.onFloor),
        onWall=bool(told and told.onWall),
        onCeiling=bool(told and told.onCeiling),
        onObject=bool(told and told.onObject),
        assetMetadata=_Metadata(boundingBox=_Box(x=size[1], y=size[0], z=size[2])) if size else _Metadata(),
    )


def _item(both: _Both, name: str, pose: _Pose, library: Library) -> Item:
    at = f"{both.pose_at}.{plain(name)}"
    if name not in both.assets:
        known = ", ".join(sorted(both.assets)[:6]) or "none"
        both.pose_file.fail(at, f"a pose of {name!r}, which the scene's assets do not hold; they hold {known}")
    asset = both.assets[name]
    box = asset.assetMetadata.boundingBox
    scale = _triple(both.pose_file, f"{at}.scale", pose.scale)
    size: Vec3 | None = None if isinstance(box, UnsetType) else (box.x * scale[1], box.y * scale[0], box.z * scale[2])
    x, y, *up = pose.position
    turns = [0.0, 0.0, pose.rotation] if isinstance(pose.rotation, float | int) else pose.rotation
    if len(turns) not in (1, 3):
        both.pose_file.fail(f"{at}.rotation", f"{len(turns)} angles; there must be one, or three about x, y and z")
    rx, ry, rz = (0.0, 0.0, turns[0]) if len(turns) == 1 else turns
    return Item(
        name=name,
        kind=asset.category or name.rpartition("-")[0] or name,
        at=at,
        position=(x, y, up[0] if up else _level(both.scene.boundary)),
        linear=about("z", rz) @ about("y", ry) @ about("x", rx),
        anchor="centre" if up else "base",
        size=size,
        mesh=library.named(asset.path, document=both.scene_file, at=f"$.assets.{name}.path") if asset.path else None,
        sought=asset.path,
        scale=(scale[1], scale[0], scale[2]),
        mount=_mount(asset),
    )


def _triple(document: Document, at: str, scale: float | list[float]) -> Vec3:
    values = scale if isinstance(scale, list) else [scale] * 3
    if len(values) != 3:
        document.fail(at, f"{len(values)} factors; there must be one, or three along x, y and z")
    return (values[0], values[1], values[2])


def _mount(asset: _Asset) -> Mount | None:
    """Where the asset goes, if its record allows for one place only."""
    places: dict[Mount, bool] = {
        "floor": asset.onFloor, "wall": asset.onWall, "ceiling": asset.onCeiling, "surface": asset.onObject,
    }  # fmt: skip
    allowed = [place for place, holds in places.items() if holds]
    return allowed[0] if len(allowed) == 1 else None
