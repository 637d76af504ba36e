"""SceneEval's sceneState (Tam et al. 2026), https://github.com/3dlg-hcvc/SceneEval: scene_state_template.json, scenes/.

The scene state of the SmartScenes toolkit::

    {"format": "sceneState",
     "scene": {"up": [0, 0, 1], "unit": 1.0,
               "arch": {"scaleToMeters": 1.0, "elements": [
                   {"type": "Floor", "id": "..", "roomId": "bedroom", "points": [[x, y, z], ...]},
                   {"type": "Wall", "id": "..", "roomId": "bedroom", "height": 2.8, "points": [[x, y, z], [x, y, z]],
                    "holes": [{"type": "Door", "id": "..", "box": {"min": [along, up], "max": [along, up]}}]}]},
               "object": [{"index": 0, "id": "1", "modelId": "objaverse.ca19...",
                           "transform": {"rows": 4, "cols": 4, "data": [16 numbers, column by column]}}]}}

Metres, z up. A transform maps the mesh file's own axes (glTF: y up, front +z) straight to the room's: trimesh_scene.py
applies it to the file as it is. A hole's x runs along the wall from the first of its points.

A mesh is found by modelId less its prefix, where SceneEval keeps the collections: `<id>/<id>.glb`, `<id>/raw_model.obj`
(3D-FUTURE), `glb/<i>/<id>.glb` (HSSD). The file holds no sizes: without its mesh an object is the box of its record in
the collection's annotations, or of a table of sizes, standing on the mesh's origin as those assets do. The `up` and
`front` columns of HSSD's fpmodels.csv are not read.
"""

from typing import Annotated, Any, Literal

import numpy as np
from msgspec import Meta

from thinkblox.importing.document import Document, Foreign, Metres
from thinkblox.importing.draft import Hole, Item, LayoutDraft, RoomOutline
from thinkblox.importing.frames import OWN_FROM_Y_UP, own_from_file
from thinkblox.importing.library import AssetRecord, Library
from thinkblox.importing.sizes import size_in
from thinkblox.value import Vec2, Vec3

Number = Annotated[float, Meta(ge=-1e6, le=1e6)]
Factor = Annotated[float, Meta(gt=0.0, le=1e4)]
Point = tuple[Metres, Metres, Metres]


class _Transform(Foreign, frozen=True, kw_only=True):
    data: Annotated[list[Number], Meta(min_length=16, max_length=16)]


class _Object(Foreign, frozen=True, kw_only=True):
    modelId: str  # noqa: N815 (the key's own name)
    transform: _Transform
    id: str | int | None = None
    index: int | None = None


class _Box(Foreign, frozen=True, kw_only=True):
    min: tuple[Metres, Metres]
    max: tuple[Metres, Metres]


class _Hole(Foreign, frozen=True, kw_only=True):
    type: str = "Door"
    id: str | int | None = None
    box: _Box | None = None


class _Element(Foreign, frozen=True, kw_only=True):
    type: str
    points: list[Point] = []
    id: str | int | None = None
    roomId: str | int | list[str | int] | None = None  # noqa: N815
    height: Metres | None = None
    holes: list[_Hole] = []


class _Arch(Foreign, frozen=True, kw_only=True):
    elements: list[_Element]
    scaleToMeters: Factor = 1.0  # noqa: N815


class _Scene(Foreign, frozen=True, kw_only=True):
    arch: _Arch
    object: list[_Object]
    unit: Factor = 1.0
    up: tuple[Number, Number, Number] = (0.0, 0.0, 1.0)
    id: str | None = None


class _State(Foreign, frozen=True, kw_only=True):
    scene: _Scene


def is_sceneeval(raw: Any) -> bool:
    """Whether a JSON value is a scene state."""
    return isinstance(raw, dict) and raw.get("format") == "sceneState"


def read_sceneeval(document: Document, library: Library, *, room: str | None = None) -> LayoutDraft:
    """Read one room of a scene state; raises InputError naming the file and JSON path of whatever is wrong.

    `room` is the floor's roomId; it may be None where there is only one floor.
    """
    scene = document.typed(_State).scene
    if not np.allclose(scene.up, (0.0, 0.0, 1.0)):
        document.fail("$.scene.up", f"up is {list(scene.up)}; SceneEval's scene states have [0, 0, 1]")
    index, floor = _floor(document, scene, room)
    scale = scene.arch.scaleToMeters
    walls = [(i, e) for i, e in enumerate(scene.arch.elements) if e.type == "Wall" and (room is None or _of(e, floor))]
    outline = RoomOutline(
        corners=tuple((x * scale, y * scale) for x, y, _ in floor.points),
        level=min((z * scale for _, _, z in floor.points), default=0.0),
        height=max((wall.height * scale for _, wall in walls if wall.height), default=None),
        holes=tuple(hole for i, wall in walls for hole in _holes(document, i, wall, scale)),
        at=f"$.scene.arch.elements[{index}].points",
    )
    items = tuple(_item(document, i, thing, scene.unit, library) for i, thing in enumerate(scene.object))
    _check_meshes(document, items)
    return LayoutDraft(outline=outline, items=items)


def _floor(document: Document, scene: _Scene, room: str | None) -> tuple[int, _Element]:
    floors = [(i, e) for i, e in enumerate(scene.arch.elements) if e.type == "Floor"]
    chosen = [(i, e) for i, e in floors if room is None or str(e.roomId) == room]
    if not floors:
        document.fail("$.scene.arch.elements", "there is no element of type 'Floor'")
    if len(chosen) != 1:
        names = ", ".join(str(e.roomId) for _, e in floors[:20])
        document.fail(
            "$.scene.arch.elements", f"{len(floors)} floors: say which room to read (--room); they are {names}"
        )
    return chosen[0]


def _of(wall: _Element, floor: _Element) -> bool:
    rooms = wall.roomId if isinstance(wall.roomId, list) else [wall.roomId]
    return floor.roomId in rooms


def _holes(document: Document, index: int, wall: _Element, scale: float) -> list[Hole]:
    at = f"$.scene.arch.elements[{index}]"
    if len(wall.points) != 2:
        document.fail(f"{at}.points", f"{len(wall.points)} points; a wall has two")
    start, end = ((x * scale, y * scale) for x, y, _ in wall.points)
    found = []
    for number, hole in enumerate(wall.holes):
        if hole.box is not None:
            kind: Literal["door", "window"] = "window" if hole.type.lower() == "window" else "door"
            low, high = hole.box.min, hole.box.max
            ends = (_along(start, end, low[0] * scale), _along(start, end, high[0] * scale))
            name = str(hole.id) if hole.id is not None else f"{kind}_{wall.id}_{number}"
            place = f"{at}.holes[{number}]"
            found.append(Hole(name=name, kind=kind, ends=ends, low=low[1] * scale, high=high[1] * scale, at=place))
    return found


def _along(start: Vec2, end: Vec2, distance: float) -> Vec2:
    share = distance / (float(np.hypot(end[0] - start[0], end[1] - start[1])) or 1.0)
    return (start[0] + (end[0] - start[0]) * share, start[1] + (end[1] - start[1]) * share)


def _item(document: Document, index: int, thing: _Object, unit: float, library: Library) -> Item:
    at = f"$.scene.object[{index}]"
    matrix = np.asarray(thing.transform.data, dtype=np.float64).reshape(4, 4).T
    if not np.allclose(matrix[3], (0.0, 0.0, 0.0, 1.0), atol=1e-6):
        document.fail(f"{at}.transform.data", "the last row is not [0, 0, 0, 1]: the 16 numbers go column by column")
    model = thing.modelId.partition(".")[2] or thing.modelId
    mesh = library.asset(model)
    file_to_room = matrix[:3, :3] * unit
    if abs(np.linalg.det(file_to_room)) < 1e-12:
        document.fail(f"{at}.transform.data", "the transform flattens the object")
    record = library.record(model)
    x, y, z = (float(v) * unit for v in matrix[:3, 3])
    number = thing.id if thing.id is not None else thing.index if thing.index is not None else index
    return Item(
        name=f"{(record.kind if record else '') or 'object'}_{number}",
        kind=(record.kind if record else "") or "object",
        at=at,
        position=(x, y, z),
        linear=file_to_room @ (own_from_file(mesh) if mesh else OWN_FROM_Y_UP).T,
        anchor="origin" if mesh else "base",
        size=None if mesh else size_in(library.sizes, model) or _recorded(thing.modelId, record),
        mesh=mesh,
        sought=thing.modelId,
    )


def _recorded(model: str, record: AssetRecord | None) -> Vec3 | None:
    """The size that a record gives: LayoutVLM's is z-up, with y along the front; objathor's y-up, with z along it."""
    if record is None or record.box is None:
        return None
    x, y, z = record.box
    return (y, x, z) if model.startswith("layoutvlm") else (z, x, y)


def _check_meshes(document: Document, items: tuple[Item, ...]) -> None:
    missing = [item for item in items if item.mesh is None and item.size is None]
    if missing:
        names = ", ".join(item.sought for item in missing[:5]) + (" and more" if len(missing) > 5 else "")
        document.fail(
            missing[0].at,
            f"{len(missing)} of {len(items)} meshes were not found ({names}); a scene state holds no sizes, so they"
            " cannot be replaced by boxes: name the folder of assets that has <id>/<id>.glb or annotations"
            " (--assets), or a table of sizes (--sizes)",
        )
