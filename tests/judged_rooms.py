"""Rooms made by hand for the tests of the judge."""

from thinkblox.evaluation.annotations import Annotation
from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.room_file import (
    LinkRecord,
    OpeningRecord,
    PlacementRecord,
    RoomRecord,
    SceneRecord,
    SeenAsset,
    ShapeRecord,
)
from thinkblox.evaluation.rows import attribute, count, element_relation, object_relation
from thinkblox.evaluation.walls import Enclosure

DOOR = OpeningRecord(id="door_1", kind="door", wall=0, offset=0.2, width=0.9, height=2.1)
WINDOW = OpeningRecord(id="window_1", kind="window", wall=2, offset=2.0, width=1.5, height=1.2, sill=0.9)
ROOM = RoomRecord(floor=((0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0)), height=2.6, openings=(DOOR, WINDOW))
WALLS = Enclosure(ROOM)


def part(size, position, **look):
    return ShapeRecord("box", tuple(size), tuple(position), **look)


def thing(name, at, size=(0.5, 0.5, 0.5), *, yaw=0.0, parts=None, **asset):
    """An object called `name`, with the middle of its base at `at`; one box of its size unless it has parts."""
    category, _, number = name.rpartition("_") if name[-1].isdigit() else (name, "", "1")
    shapes = tuple(parts) if parts is not None else (part(size, (0.0, 0.0, size[2] / 2)),)
    record = SeenAsset(category=category, size=size, links=(LinkRecord(shapes),), description=category, **asset)
    spot = (*at, 0.0) if len(at) == 2 else tuple(at)
    return Body(PlacementRecord(f"{category}_{number}", category, name, spot, yaw, tuple(size)), record)


def table(name, at, size=(0.8, 1.6, 0.75), **more):
    """A top on four legs."""
    x, y, z = size
    legs = [
        part((0.06, 0.06, z - 0.04), (sx * (x / 2 - 0.03), sy * (y / 2 - 0.03), (z - 0.04) / 2))
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return thing(name, at, size, parts=[part((x, y, 0.04), (0.0, 0.0, z - 0.02)), *legs], **more)


def shelf(name, at, size=(0.4, 1.0, 1.8), boards=4, **more):
    """Boards between two sides, the lowest and the highest at its ends."""
    x, y, z = size
    sides = [part((x, 0.02, z), (0.0, s * (y / 2 - 0.01), z / 2)) for s in (-1, 1)]
    rest = [part((x, y, 0.02), (0.0, 0.0, 0.01 + k * (z - 0.02) / (boards - 1))) for k in range(boards)]
    return thing(name, at, size, parts=[*sides, *rest], **more)


def scene(*bodies, room=ROOM):
    return SceneRecord(
        room=room,
        placements=tuple(b.placement for b in bodies),
        assets={b.placement.asset: b.asset for b in bodies},
    )


def demands(*, counts=(), attributes=(), objects=(), elements=(), absent=(), **more):
    return Annotation(
        id="p1",
        style="plain",
        prompt="a room",
        counts=tuple(map(count, counts)),
        attributes=tuple(map(attribute, attributes)),
        object_relations=tuple(map(object_relation, objects)),
        element_relations=tuple(map(element_relation, elements)),
        absent=tuple(absent),
        **more,
    )
