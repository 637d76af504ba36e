"""IL3D (Zhou et al. 2025), https://github.com/WenxuZhou/IL3D: llm_design.py, sft_dataset.py, utils/syth2json.py.

A layout of the data set, data/layout/<uuid>.json::

    {"dataset": "3D-FRONT",
     "meshes": [{"type": "floor", "xyz": [[x, 0, z], ...], "faces": [[0, 1, 2], [1, 3, 2]]}],
     "objects": [{"object_name": "..", "category": "bed", "assetId": "..", "object_path": "3D-FRONT/Beds/<id>.usdz",
                  "roomId": "Bedroom", "position": [x, y, z], "rotation": [..], "scale": [..], "bbox": [..]}]}

or what its generator writes, scene.json, with the objects grouped by label and the mesh's path under `path`::

    {"meshes": {"xyz": [...]},
     "objects": {"Beds": [{"object_name": "..", "path": "..", "position": .., "rotation": ..}]}}

y up, metres, right-handed, for the poses go unchanged into a y-up USD stage (its prompt calls +z north; in that stage,
seen from above with x to the right, +z points down the page). A position is of the mesh's origin, at the floor contact.
A rotation is three angles in degrees, about x, then y, then z (USD's rotateXYZ), or a quaternion x, y, z, w. `bbox` is
the extent along x, z and y before `scale`, and sft_dataset.py multiplies the two number by number. At rotation 0 the
front faces +z (`frontview` 0, as in 3D-FUTURE).

The corners of a floor are in no order; its faces say how they hang together. Its meshes are .usdz, which is not read: a
mesh of the same name with another suffix is taken where there is one, else a box of the given size.
"""

from collections.abc import Iterator
from typing import Annotated, Any

import shapely
from msgspec import Meta
from shapely.geometry.polygon import orient

from thinkblox.importing.document import Degrees, Document, Extent, Foreign, Metres, plain
from thinkblox.importing.draft import Item, LayoutDraft, RoomOutline
from thinkblox.importing.frames import OWN_FROM_Y_UP, Y_UP, Array, about, from_quaternion
from thinkblox.importing.library import Library
from thinkblox.value import Vec2, Vec3

Point = tuple[Metres, Metres, Metres]
Factor = Annotated[float, Meta(gt=0.0, le=1000.0)]
Index = Annotated[int, Meta(ge=0)]


class _Floor(Foreign, frozen=True, kw_only=True):
    xyz: Annotated[list[Point], Meta(max_length=10_000)]
    faces: Annotated[list[tuple[Index, Index, Index]], Meta(max_length=10_000)] = []
    type: str = "floor"


class _Object(Foreign, frozen=True, kw_only=True):
    position: Point
    rotation: Annotated[list[Degrees], Meta(min_length=3, max_length=4)]
    object_name: str = ""
    bbox: tuple[Extent, Extent, Extent] | None = None
    scale: tuple[Factor, Factor, Factor] = (1.0, 1.0, 1.0)
    category: str | None = None
    object_path: str = ""
    path: str = ""


class _Layout(Foreign, frozen=True, kw_only=True):
    meshes: list[_Floor] | _Floor
    objects: list[_Object] | dict[str, Any]


def is_il3d(raw: Any) -> bool:
    """Whether a JSON value is a layout of IL3D's."""
    if not isinstance(raw, dict) or "objects" not in raw:
        return False
    meshes = raw.get("meshes")
    first = meshes[0] if isinstance(meshes, list) and meshes else meshes
    return isinstance(first, dict) and "xyz" in first


def read_il3d(document: Document, library: Library) -> LayoutDraft:
    """Read a layout; raises InputError naming the file and JSON path of whatever is wrong."""
    layout = document.typed(_Layout)
    at, floor = _floor(document, layout)
    corners = _corners(document, floor, at)
    items, seen, doubled = [], set[str](), []
    for index, (where, label, thing) in enumerate(_objects(document, layout)):
        name = thing.object_name or f"{label}_{index}"
        if name in seen:
            name, told = f"{name}_{index}", name
            doubled.append(f"The layout has more than one {told}: that of number {index} is called {name}.")
        seen.add(name)
        items.append(_item(document, where, name, label, thing, library))
    return LayoutDraft(
        outline=RoomOutline(corners=corners, level=min(y for _, y, _ in floor.xyz), at=at),
        items=tuple(items),
        notes=("The layout has neither a room height, nor doors, nor windows.", *doubled),
    )


def _floor(document: Document, layout: _Layout) -> tuple[str, _Floor]:
    if isinstance(layout.meshes, _Floor):
        return "$.meshes.xyz", layout.meshes
    floors = [(i, mesh) for i, mesh in enumerate(layout.meshes) if mesh.type == "floor"]
    if not floors:
        document.fail("$.meshes", "there is no mesh of type 'floor'")
    return f"$.meshes[{floors[0][0]}].xyz", floors[0][1]


def _corners(document: Document, floor: _Floor, at: str) -> tuple[Vec2, ...]:
    """The outline of the floor, y being against z."""
    points = [(x, -z) for x, _, z in floor.xyz]
    if len(points) < 3:
        document.fail(at, f"a floor of {len(points)} corners; it needs at least 3")
    if any(max(face) >= len(points) for face in floor.faces):
        document.fail(at, "a face names a corner that does not exist")
    if floor.faces:
        shape = shapely.union_all([shapely.Polygon([points[i] for i in face]).buffer(0) for face in floor.faces])
    else:
        shape = shapely.convex_hull(shapely.MultiPoint(points)) if len(points) == 4 else shapely.Polygon(points)
    if not isinstance(shape, shapely.Polygon) or shape.is_empty or shape.area < 1e-6:
        document.fail(at, "the floor is not one piece with an area")
    ring: list[Vec2] = [(float(x), float(y)) for x, y in orient(shapely.normalize(shape)).exterior.coords[:-1]]
    return tuple(ring)


def _objects(document: Document, layout: _Layout) -> Iterator[tuple[str, str, _Object]]:
    if isinstance(layout.objects, dict):
        for label, things in layout.objects.items():
            at = f"$.objects.{plain(label)}"
            for index, thing in enumerate(document.part(list[_Object], things, at)):
                yield f"{at}[{index}]", thing.category or label, thing
        return
    for index, thing in enumerate(layout.objects):
        yield f"$.objects[{index}]", thing.category or "object", thing


def _item(document: Document, at: str, name: str, kind: str, thing: _Object, library: Library) -> Item:
    path = thing.object_path or thing.path
    sx, sy, sz = thing.scale
    size: Vec3 | None = None
    if thing.bbox is not None:
        (bx, bz, by), (fx, fz, fy) = thing.bbox, thing.scale
        size = (bz * fz, bx * fx, by * fy)
    mesh = library.named(path, document=document, at=at) if path else None
    x, y, z = thing.position
    return Item(
        name=name,
        kind=kind,
        at=at,
        position=(x, -z, y),
        linear=Y_UP @ _rotation(document, at, thing.rotation) @ OWN_FROM_Y_UP.T,
        anchor="origin" if mesh else "base",
        size=size,
        mesh=mesh,
        sought=path,
        scale=(sz, sx, sy),
    )


def _rotation(document: Document, at: str, numbers: list[float]) -> Array:
    if len(numbers) == 3:
        return about("z", numbers[2]) @ about("y", numbers[1]) @ about("x", numbers[0])
    x, y, z, w = numbers
    if x * x + y * y + z * z + w * w < 1e-12:
        document.fail(f"{at}.rotation", "a quaternion of length 0 is no rotation")
    return from_quaternion((x, y, z, w))
