"""Holodeck (Yang et al. 2024), https://github.com/allenai/Holodeck: ai2holodeck/generation.

The house of AI2-THOR's procedural schema with Holodeck's own keys added::

    {"query": "...", "wall_height": 2.7,
     "rooms": [{"id": "bedroom", "floorPolygon": [{"x": 0, "y": 0, "z": 0}, ...]}],
     "walls": [{"id": "wall|bedroom|west|0", "roomId": "bedroom", "segment": [[x, z], [x, z]], "height": 2.7}],
     "doors": [{"id": "...", "wall0": "...", "wall1": "...", "holePolygon": [{"x": along, "y": up, "z": 0}, {...}]}],
     "windows": [the same],
     "objects": [{"id": "bed-0 (bedroom)", "object_name": "bed-0", "assetId": "...", "roomId": "bedroom",
                  "position": {"x": .., "y": .., "z": ..}, "rotation": {"x": 0, "y": 90, "z": 0},
                  "vertices": [[x, z], ...]}],
     "floor_objects": [...], "wall_objects": [...], "small_objects": [...], "ceiling_objects": [...]}

Unity's axes: metres, y up, left-handed. A position is of the middle of the bounding box. Rotations are degrees about z,
then x, then y, each clockwise as seen against its axis; at 0 the front faces +z. Floors run clockwise. A hole's x runs
along wall0 from the start of its segment, or against wall1's.

Sizes are not in the file. They come from the mesh, `<assets>/<assetId>/<assetId>.glb` as SceneEval's
prepare_objathor.py writes it, else from objathor's `<assets>/annotations.json` (x across, y up, z along the front).
Failing both, for things on the floor, from `vertices` (centimetres, with 10 cm added to each side by the generator) and
twice the height of the middle. objathor's own .pkl.gz files are never opened: a pickle runs code.
"""

import math
from collections.abc import Container, Mapping
from typing import Annotated, Any, Literal

from msgspec import Meta

from thinkblox.importing.document import Degrees, Document, Extent, Foreign, Metres
from thinkblox.importing.draft import Hole, Item, LayoutDraft, RoomOutline
from thinkblox.importing.frames import OWN_FROM_UNITY, UNITY, Array, about
from thinkblox.importing.library import AssetRecord, Library, Point
from thinkblox.scene.asset import Mount
from thinkblox.value import Vec2, Vec3

BUFFER = 0.10
"""Added by floor_objects.py to each side of an object on the floor before it is placed [m]."""
Plan = Annotated[list[Annotated[float, Meta(ge=-1e5, le=1e5)]], Meta(min_length=2, max_length=2)]


class _Turn(Foreign, frozen=True, kw_only=True):
    x: Degrees = 0.0
    y: Degrees = 0.0
    z: Degrees = 0.0


class _Room(Foreign, frozen=True, kw_only=True):
    id: str
    floorPolygon: list[Point]  # noqa: N815 (the key's own name)


class _Wall(Foreign, frozen=True, kw_only=True):
    id: str
    roomId: str  # noqa: N815
    segment: Annotated[list[tuple[Metres, Metres]], Meta(min_length=2, max_length=2)]
    height: Extent | None = None


class _Hole(Foreign, frozen=True, kw_only=True):
    id: str
    wall0: str | None = None
    wall1: str | None = None
    holePolygon: Annotated[list[Point], Meta(max_length=1000)] = []  # noqa: N815


class _Object(Foreign, frozen=True, kw_only=True):
    id: str
    position: Point
    rotation: _Turn = _Turn()
    assetId: str = ""  # noqa: N815
    object_name: str = ""
    roomId: str | None = None  # noqa: N815
    vertices: list[Plan] = []


class _Ref(Foreign, frozen=True, kw_only=True):
    id: str


class _House(Foreign, frozen=True, kw_only=True):
    rooms: Annotated[list[_Room], Meta(min_length=1)]
    objects: list[_Object]
    walls: list[_Wall] = []
    doors: list[_Hole] = []
    windows: list[_Hole] = []
    query: str = ""
    wall_height: Extent | None = None
    floor_objects: list[_Ref] = []
    wall_objects: list[_Ref] = []
    small_objects: list[_Ref] = []
    ceiling_objects: list[_Ref] = []


def is_holodeck(raw: Any) -> bool:
    """Whether a JSON value is a house of Holodeck's."""
    if not isinstance(raw, dict) or not isinstance(raw.get("rooms"), list) or "objects" not in raw:
        return False
    return any(isinstance(room, dict) and "floorPolygon" in room for room in raw["rooms"])


def read_holodeck(document: Document, library: Library, *, room: str | None = None) -> LayoutDraft:
    """Read one room of a house; raises InputError naming the file and JSON path of whatever is wrong.

    `room` is its id; it may be None where there is only one.
    """
    house = document.typed(_House)
    index = _chosen(document, house, room)
    chosen = house.rooms[index]
    mounts = _mounts(house)
    inside = [(i, o) for i, o in enumerate(house.objects) if o.roomId in (None, chosen.id) or len(house.rooms) == 1]
    sizes = _Sizes(document, library, mounts)
    items = tuple(sizes.item(i, thing) for i, thing in inside)
    left = len(house.objects) - len(inside)
    other = (f"{left} objects of other rooms were left out.",) if left else ()
    return LayoutDraft(
        outline=RoomOutline(
            corners=tuple((corner.x, corner.z) for corner in chosen.floorPolygon),
            level=min((corner.y for corner in chosen.floorPolygon), default=0.0),
            height=house.wall_height or max((w.height for w in house.walls if w.height), default=None),
            holes=_holes(house, chosen.id),
            at=f"$.rooms[{index}].floorPolygon",
        ),
        items=items,
        prompt=house.query,
        notes=(*other, *_lost_holes(house), *sizes.notes()),
    )


def _chosen(document: Document, house: _House, room: str | None) -> int:
    ids = [each.id for each in house.rooms]
    if room is None and len(ids) == 1:
        return 0
    if room is None or room not in ids:
        document.fail(
            "$.rooms", f"a house of {len(ids)} rooms: say which to read (--room); they are {', '.join(ids[:20])}"
        )
    return ids.index(room)


def _mounts(house: _House) -> Mapping[str, Mount]:
    groups: dict[Mount, list[_Ref]] = {
        "floor": house.floor_objects,
        "wall": house.wall_objects,
        "surface": house.small_objects,
        "ceiling": house.ceiling_objects,
    }
    return {ref.id: mount for mount, refs in groups.items() for ref in refs}


class _Sizes:
    """Makes items of objects, and remembers which sizes had to be worked out from footprints."""

    def __init__(self, document: Document, library: Library, mounts: Mapping[str, Mount]) -> None:
        self._document, self._library, self._mounts = document, library, mounts
        self._guessed: list[str] = []

    def notes(self) -> tuple[str, ...]:
        """What a reader should know of the sizes."""
        if not self._guessed:
            return ()
        named = ", ".join(self._guessed[:5]) + (" and others" if len(self._guessed) > 5 else "")
        how = f"come from their footprints less {BUFFER:g} m and their height above the floor"
        return (f"The sizes of {named} {how}, for want of the annotations of their assets.",)

    def item(self, index: int, thing: _Object) -> Item:
        """One object as an item."""
        mesh = self._library.asset(thing.assetId)
        record = self._library.record(thing.assetId)
        box = record.box if record else None
        size: Vec3 | None = (box[2], box[0], box[1]) if box else None
        if mesh is None and size is None:
            size = self._from_footprint(thing)
        p = thing.position
        return Item(
            name=thing.id,
            kind=_kind(thing, record),
            at=f"$.objects[{index}]",
            position=(p.x, p.z, p.y),
            linear=_linear(thing.rotation),
            size=size,
            mesh=mesh,
            called=thing.object_name,
            sought=thing.assetId,
            mount=self._mounts.get(thing.id),
        )

    def _from_footprint(self, thing: _Object) -> Vec3 | None:
        """The size of something on the floor by its footprint and its middle; None where that cannot be known."""
        turn = thing.rotation
        on_floor = self._mounts.get(thing.id, "floor") == "floor" and thing.position.y > 0.0
        if not thing.vertices or not on_floor or turn.x or turn.z or turn.y % 90.0:
            return None
        east, north = (max(v[k] for v in thing.vertices) - min(v[k] for v in thing.vertices) for k in (0, 1))
        front, across = (east, north) if turn.y % 180.0 else (north, east)
        if min(front, across) / 100.0 <= BUFFER:
            return None
        self._guessed.append(thing.id)
        return (front / 100.0 - BUFFER, across / 100.0 - BUFFER, 2.0 * thing.position.y)


def _kind(thing: _Object, record: AssetRecord | None) -> str:
    return thing.object_name.rpartition("-")[0] or thing.object_name or (record.kind if record else "") or thing.id


def _linear(turn: _Turn) -> Array:
    unity = about("y", turn.y) @ about("x", turn.x) @ about("z", turn.z)
    linear: Array = UNITY @ unity @ OWN_FROM_UNITY.T
    return linear


def _holes(house: _House, room: str) -> tuple[Hole, ...]:
    walls = {wall.id: wall for wall in house.walls}
    kinds: tuple[tuple[Literal["door", "window"], list[_Hole], str], ...] = (
        ("door", house.doors, "doors"),
        ("window", house.windows, "windows"),
    )
    found = []
    for kind, holes, key in kinds:
        for index, hole in enumerate(holes):
            made = _hole(hole, walls, room, kind, f"$.{key}[{index}]")
            if made:
                found.append(made)
    return tuple(found)


def _lost_holes(house: _House) -> tuple[str, ...]:
    """Notes on doors and windows of which nobody can say in which wall they are, or how large."""
    walls = {wall.id for wall in house.walls}
    return tuple(
        f"The {kind} {hole.id} is left out, as the layout has {why}."
        for kind, holes in (("door", house.doors), ("window", house.windows))
        for hole in holes
        if (why := _lacks(hole, walls))
    )


def _lacks(hole: _Hole, walls: Container[str]) -> str:
    named = [id for id in (hole.wall0, hole.wall1) if id]
    if not any(id in walls for id in named):
        return f"no wall {' or '.join(named)}" if named else "no wall for it"
    return "no two corners of it" if len(hole.holePolygon) < 2 else ""


def _hole(hole: _Hole, walls: Mapping[str, _Wall], room: str, kind: Literal["door", "window"], at: str) -> Hole | None:
    """A hole as it lies in wall0, which its x is measured along; None if neither of its walls is this room's."""
    sides = [walls[id] for id in (hole.wall0, hole.wall1) if id is not None and id in walls]
    if not any(side.roomId == room for side in sides) or len(hole.holePolygon) < 2:
        return None
    wall = sides[0]
    along, up = [p.x for p in hole.holePolygon], [p.y for p in hole.holePolygon]
    start, end = wall.segment if wall.id == hole.wall0 else wall.segment[::-1]
    ends = (_along(start, end, min(along)), _along(start, end, max(along)))
    return Hole(name=hole.id, kind=kind, ends=ends, low=min(up), high=max(up), at=at)


def _along(start: Vec2, end: Vec2, distance: float) -> Vec2:
    share = distance / (math.dist(start, end) or 1.0)
    return (start[0] + (end[0] - start[0]) * share, start[1] + (end[1] - start[1]) * share)
