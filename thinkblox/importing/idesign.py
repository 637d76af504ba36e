"""I-Design (Çelen et al. 2024), https://github.com/atcelen/IDesign: IDesign.py, utils.py, place_in_blender.py;
MetaSpatial (Pan and Liu 2025), https://github.com/PzySeere/MetaSpatial, keeps its scene graphs in the same form.

scene_graph.json, a list of the objects followed by six parts of the room::

    [{"new_object_id": "bed_1", "style": "...", "material": "...", "is_on_the_floor": true, "facing": "east_wall",
      "size_in_meters": {"length": 1.6, "width": 2.0, "height": 0.9}, "rotation": {"z_angle": 90.0},
      "position": {"x": 1.0, "y": 2.0, "z": 0.45},
      "placement": {"room_layout_elements": [{"layout_element_id": "west_wall", "preposition": "on"}],
                    "objects_in_room": [{"object_id": "desk_1", "preposition": "on", "is_adjacent": true}]}}, ...,
     {"new_object_id": "south_wall", "itemType": "wall", "position": {...}, "size_in_meters": {"length": 4.0, ..}}, ...]

Metres, z up, origin at the south-west corner of the floor. A position is of the middle of the box. z_angle is a compass
bearing: 0 faces the north wall (+y), 90 the east (+x), 180 the south, 270 the west; clockwise. `length` is across and
`width` along the front: at 0, length lies along x.

Meshes are `Assets/<new_object_id>.glb` (`assets/` in MetaSpatial), stretched to the size. place_in_blender.py adds
half a turn since imported meshes face -y; its angle turns clockwise because bpy.ops.transform.rotate turns the other
way (https://github.com/Fast-64/fast64/pull/191). An object without a position was not placed.

An answer of MetaSpatial's model is positions only, `[{"new_object_id": "bed_1", "x": 1, "y": 2, "z": 0.45}, ...]`. The
scene graph that it was asked about (scene_graph-backtracked.json) must lie beside it, and what the answer leaves out
was not placed. A graph without walls needs the size of its room.
"""

from collections.abc import Sequence
from typing import Annotated, Any

from msgspec import Meta, structs

from thinkblox.importing.document import Degrees, Document, Extent, Foreign, Metres, beside, plain
from thinkblox.importing.draft import Item, LayoutDraft, RoomOutline
from thinkblox.importing.frames import about
from thinkblox.importing.library import Library
from thinkblox.scene.asset import Mount
from thinkblox.value import Vec2

ROOM_PARTS = ("south_wall", "north_wall", "east_wall", "west_wall", "middle of the room", "ceiling")


class _Size(Foreign, frozen=True, kw_only=True):
    length: Extent
    width: Extent
    height: Extent


class _Span(Foreign, frozen=True, kw_only=True):
    length: Annotated[float, Meta(ge=0.0, le=1000.0)]
    height: Annotated[float, Meta(ge=0.0, le=1000.0)]


class _Point(Foreign, frozen=True, kw_only=True):
    x: Metres
    y: Metres
    z: Metres


class _Turn(Foreign, frozen=True, kw_only=True):
    z_angle: Degrees


class _Element(Foreign, frozen=True, kw_only=True):
    layout_element_id: str = ""
    preposition: str = ""


class _Relation(Foreign, frozen=True, kw_only=True):
    object_id: str = ""
    preposition: str = ""


class _Placement(Foreign, frozen=True, kw_only=True):
    room_layout_elements: list[_Element] = []
    objects_in_room: list[_Relation] = []


class _Object(Foreign, frozen=True, kw_only=True):
    new_object_id: str
    size_in_meters: _Size
    rotation: _Turn | None = None
    position: _Point | None = None
    is_on_the_floor: bool | None = None
    placement: _Placement = _Placement()


class _Answer(_Point, frozen=True, kw_only=True):
    new_object_id: str


class _Wall(Foreign, frozen=True, kw_only=True):
    size_in_meters: _Span


class _Named(Foreign, frozen=True, kw_only=True):
    new_object_id: str


class _Graph(Foreign, frozen=True, kw_only=True):
    objects_in_room: list[dict[str, Any]]


def is_idesign(raw: Any) -> bool:
    """Whether a JSON value is a scene graph of I-Design's or MetaSpatial's, or an answer of the latter's."""
    return _is_graph(raw) or _is_answer(raw)


def _is_graph(raw: Any) -> bool:
    if isinstance(raw, dict):
        raw = raw.get("objects_in_room")
    return isinstance(raw, list) and any(
        isinstance(each, dict) and {"new_object_id", "size_in_meters"} <= each.keys() for each in raw
    )


def _is_answer(raw: Any) -> bool:
    keys = {"new_object_id", "x", "y", "z"}
    return isinstance(raw, list) and bool(raw) and all(isinstance(each, dict) and keys <= each.keys() for each in raw)


def read_idesign(document: Document, library: Library, *, room_size: Sequence[float] | None = None) -> LayoutDraft:
    """Read a scene graph, or an answer with its graph beside it.

    Args:
        document: the file.
        library: finds the meshes.
        room_size: (east, north) or (east, north, up) of the room where the graph has no walls [m].

    Raises:
        InputError: names the file and JSON path of whatever is wrong.
    """
    answer = document.typed(list[_Answer]) if _is_answer(document.raw) else None
    graph = document if answer is None else _graph_beside(document)
    entries, base = _entries(graph)
    parts: dict[str, int] = {}
    objects: list[tuple[str, _Object]] = []
    for index, entry in enumerate(entries):
        at = f"{base}[{index}]"
        name = graph.part(_Named, entry, at).new_object_id
        if name not in ROOM_PARTS:
            objects.append((at, graph.part(_Object, entry, at)))
        elif name in parts:
            graph.fail(at, f"a second {name!r}; ids must differ")
        else:
            parts[name] = index
    outline = _outline(graph, entries, parts, base, room_size)
    objects = objects if answer is None else _answered(document, objects, answer)
    placed = [(at, each) for at, each in objects if each.position is not None]
    note = f"The room and the objects were read from {graph.path.name}, beside the positions."
    return LayoutDraft(
        outline=outline,
        items=tuple(_item(graph, at, each, library) for at, each in placed),
        notes=() if answer is None else (note,),
        unplaced=tuple(each.new_object_id for _, each in objects if each.position is None),
    )


def _entries(graph: Document) -> tuple[list[dict[str, Any]], str]:
    if isinstance(graph.raw, dict):
        return graph.typed(_Graph).objects_in_room, "$.objects_in_room"
    return graph.typed(list[dict[str, Any]]), "$"


def _graph_beside(document: Document) -> Document:
    found = beside(document, _is_graph)
    if len(found) != 1:
        names = ", ".join(other.path.name for other in found) or "none"
        document.fail(
            "$", f"these are positions alone; their scene graph must be the only one beside them, and there is {names}"
        )
    return found[0]


def _answered(
    document: Document, objects: list[tuple[str, _Object]], answer: list[_Answer]
) -> list[tuple[str, _Object]]:
    """The objects where the answer has them, and without a position where it does not name them."""
    known = {each.new_object_id for _, each in objects}
    places: dict[str, _Answer] = {}
    for index, place in enumerate(answer):
        if place.new_object_id not in known or place.new_object_id in places:
            what = "a second position of" if place.new_object_id in places else "the scene graph holds no"
            document.fail(f"$[{index}]", f"{what} {plain(place.new_object_id)!r}")
        places[place.new_object_id] = place
    return [(at, structs.replace(each, position=places.get(each.new_object_id))) for at, each in objects]


def _outline(
    document: Document,
    entries: list[dict[str, Any]],
    parts: dict[str, int],
    base: str,
    room_size: Sequence[float] | None,
) -> RoomOutline:
    missing = [name for name in ("south_wall", "west_wall") if name not in parts]
    if missing and room_size is None:
        document.fail(
            base,
            f"no {' and no '.join(missing)}: the room's size is read off its walls; save the graph after backtracking,"
            " or give the room's size (--room-size)",
        )
    if missing:
        x, y, *up = room_size or ()
        return RoomOutline(corners=_rectangle(x, y), height=up[0] if up else None, at=base)
    south, west = (
        document.part(_Wall, entries[parts[name]], f"{base}[{parts[name]}]").size_in_meters
        for name in ("south_wall", "west_wall")
    )
    at = f"{base}[{parts['south_wall']}].size_in_meters"
    return RoomOutline(corners=_rectangle(south.length, west.length), height=south.height, at=at)


def _rectangle(x: float, y: float) -> tuple[Vec2, ...]:
    return ((0.0, 0.0), (x, 0.0), (x, y), (0.0, y))


def _item(document: Document, at: str, thing: _Object, library: Library) -> Item:
    if thing.rotation is None:
        document.fail(at, "Object missing required field `rotation`")
    size, point = thing.size_in_meters, thing.position or _Point(x=0.0, y=0.0, z=0.0)
    return Item(
        name=thing.new_object_id,
        kind=thing.new_object_id,
        at=at,
        position=(point.x, point.y, point.z),
        linear=about("z", 90.0 - thing.rotation.z_angle),
        size=(size.width, size.length, size.height),
        mesh=library.asset(thing.new_object_id),
        sought=f"{thing.new_object_id}.glb",
        fitted=True,
        mount=_mount(thing),
    )


def _mount(thing: _Object) -> Mount | None:
    if thing.is_on_the_floor:
        return "floor"
    if any(each.preposition == "on" for each in thing.placement.objects_in_room):
        return "surface"
    on = {each.layout_element_id for each in thing.placement.room_layout_elements if each.preposition == "on"}
    if "ceiling" in on:
        return "ceiling"
    return "wall" if any(name.endswith("_wall") for name in on) else None
