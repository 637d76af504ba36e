"""Making the room longer, wider, higher or smaller: a wall moves, and everything stays where it is."""

from msgspec import structs

from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import Order
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at

_AT_SIDE = 1e-6
USUALLY, SLIGHTLY = 0.5, 0.25
"""By how much a side of the room moves where nobody says it [m]."""
_SENSES = {"longer": 1, "wider": 1, "deeper": 1, "larger": 1, "higher": 1,
           "shorter": -1, "narrower": -1, "smaller": -1, "lower": -1}  # fmt: skip


def resize(work: Work, finder: Finder, order: Order) -> None:
    """Change the size of the room. Of the two walls that could move it is the east or north one: nothing else moves.

    Doors and windows stay where they are in their walls. What hangs on a wall that moves, goes with it.
    """
    east, north, up = _changes(work.scene.room, order, long_east=_is_long_east(work.start.room))
    if not (east or north or up):
        work.done.append("the room has that size already")
        return
    before = work.scene
    try:
        room = resized(before.room, east, north, up)
    except InputError as error:
        work.failed.append(f"the room was not resized: {error}")
        return
    moved = [p for p in before.placements if _goes_along(before, p, east, north, up)]
    shifted = {p.id: _shifted(before, p, east, north, up) for p in moved}
    shifted |= {r.id: _carried(r, p, shifted[p.id]) for p in moved for r in before.riders(p.id)}
    old = structs.replace(before, room=room, placements=tuple(shifted.get(p.id, p) for p in before.placements))
    world = work.world.with_scene(old)
    was = work.world
    failing = [
        verdict
        for p in old.placements
        if not (verdict := world.check([p], old.asset_of(p))[0]).valid
        and was.check([before[p.id]], before.asset_of(before[p.id]))[0].valid
    ]
    words = _words(before.room, room)
    if failing:
        says = "; ".join(str(v) for v in failing[:5])
        work.failed.append(f"the room was not made {words}: {says}")
        return
    work.world = world
    walls = [w for w, d in (("east", east), ("north", north)) if d]
    work.done.append(f"the room is now {words}" + (f"; its {' and '.join(walls)} side has moved" if walls else ""))
    for p in moved:
        work.done.append(f"{p.id} hangs on {p.support}, which has moved, and went with it")
    leaning = _were_at(before, east, north, {p.id for p in moved})
    if leaning:
        work.notes.append(f"The wall has moved away from {', '.join(leaning)}, which stay where they are.")


def _words(old: Room, new: Room) -> str:
    (a, b), (c, d) = old.extent, new.extent
    return f"{c:g} m by {d:g} m by {new.height:g} m (it was {a:g} m by {b:g} m by {old.height:g} m)"


def _is_long_east(room: Room) -> bool:
    """Whether the length of a room is that from west to east."""
    return room.extent[0] >= room.extent[1]


def _changes(room: Room, order: Order, *, long_east: bool) -> tuple[float, float, float]:
    """By how much the room grows to the east, to the north and up [m]; its length is that which it had at first."""
    if order.times:
        raise InputError(f"'{order.text}': say by how many metres, such as 'one metre longer'")
    if not order.lengths and (not order.change or order.change.endswith("=")):
        raise InputError(f"'{order.text}' does not say by how much; say a length, such as 'one metre longer'")
    lengths = [metres for metres, _ in order.lengths] or [SLIGHTLY if order.slight else USUALLY]
    if order.direction:
        return _to_one_side(order, lengths[0])
    across, along = room.extent
    absolute = order.change.endswith("=") or not order.change
    change = order.change.removesuffix("=")
    if len(lengths) >= 2 and absolute:
        wanted = sorted(lengths[:2], reverse=long_east) if not order.change else lengths[:2]
        height = lengths[2] - room.height if len(lengths) > 2 else 0.0
        return wanted[0] - across, wanted[1] - along, height
    axis = order.lengths[0][1] if order.lengths else ""
    if not change and axis:
        change = {"length": "longer", "width": "wider", "depth": "deeper", "height": "higher"}.get(axis, "")
    if not change:
        raise InputError(f"'{order.text}' does not say which way; say longer, wider or higher")
    by = lengths[0]
    if order.ceiling or change in ("higher", "lower"):
        return 0.0, 0.0, (by - room.height if absolute else _SENSES[change] * by)
    to_east = long_east if change in ("longer", "shorter", "larger", "smaller") else not long_east
    extent = across if to_east else along
    grows = by - extent if absolute else _SENSES[change] * by
    both = change in ("larger", "smaller")
    if both and not absolute:
        return grows, grows, 0.0
    return (grows, 0.0, 0.0) if to_east else (0.0, grows, 0.0)


def _to_one_side(order: Order, by: float) -> tuple[float, float, float]:
    """By how much the room grows to the side that is named.

    Raises:
        InputError: that side cannot move, or what is asked for is no length by which it moves.
    """
    change = order.change or "longer"
    if order.direction not in ("east", "north"):
        raise InputError(
            f"'{order.text}': only the east and the north side of a room move; the others stay where they are"
        )
    if change.endswith("=") or change in ("higher", "lower"):
        raise InputError(f"'{order.text}' does not say by how much that side moves; say 'by 1 m'")
    return (_SENSES[change] * by, 0.0, 0.0) if order.direction == "east" else (0.0, _SENSES[change] * by, 0.0)


def resized(room: Room, east: float, north: float, up: float = 0.0) -> Room:
    """A room whose easternmost and northernmost walls have moved out [m]; every opening stays in its place.

    Raises:
        InputError: a wall that is too short for its openings then, or a room that is too small or too large.
    """
    most_x, most_y = room.extent
    floor = tuple(
        (
            round(x + (east if x >= most_x - _AT_SIDE else 0.0), 6),
            round(y + (north if y >= most_y - _AT_SIDE else 0.0), 6),
        )
        for x, y in room.floor
    )
    openings = []
    for opening in room.openings:
        start, moved = room.floor[opening.wall], floor[opening.wall]
        ax, ay = room.walls[opening.wall].along
        shift = (moved[0] - start[0]) * ax + (moved[1] - start[1]) * ay
        offset = round(opening.offset - shift, 6) + 0.0
        if offset < 0.0:
            raise InputError(f"a wall would end {-offset:.2f} m before the far edge of {opening.id}")
        openings.append(structs.replace(opening, offset=offset) if abs(shift) > _AT_SIDE else opening)
    return structs.replace(room, floor=floor, height=round(room.height + up, 6), openings=tuple(openings))


def _goes_along(scene: Scene, placement: Placement, east: float, north: float, up: float) -> bool:
    mount = scene.asset_of(placement).mount
    if mount == "ceiling":
        return up != 0.0
    if mount != "wall" or placement.support == "floor":
        return False
    wall = next((w for w in scene.room.walls if w.name == placement.support), None)
    return wall is not None and (_moves(scene.room, wall.start, wall.end, east, north) != (0.0, 0.0))


def _moves(
    room: Room, start: tuple[float, float], end: tuple[float, float], east: float, north: float
) -> tuple[float, float]:
    """How a wall moves across itself [m]."""
    most_x, most_y = room.extent
    x = east if min(start[0], end[0]) >= most_x - _AT_SIDE else 0.0
    y = north if min(start[1], end[1]) >= most_y - _AT_SIDE else 0.0
    return x, y


def _shifted(scene: Scene, placement: Placement, east: float, north: float, up: float) -> Placement:
    x, y, z = placement.position
    asset = scene.asset_of(placement)
    if asset.mount == "ceiling":
        return structs.replace(placement, position=(x, y, round(z + up, 6)))
    wall = scene.room.wall(placement.support)
    dx, dy = _moves(scene.room, wall.start, wall.end, east, north)
    return placed_at(scene, asset, id=placement.id, position=(round(x + dx, 6), round(y + dy, 6), z), yaw=placement.yaw)


def _carried(rider: Placement, before: Placement, after: Placement) -> Placement:
    """What rests on a thing, moved as that is."""
    x, y, z = (own + new - old for own, new, old in zip(rider.position, after.position, before.position, strict=True))
    return structs.replace(rider, position=(round(x, 6), round(y, 6), round(z, 6)))


def _were_at(scene: Scene, east: float, north: float, besides: set[str]) -> list[str]:
    """What stood with its back to a wall that has moved."""
    found = []
    for wall in scene.room.walls:
        if _moves(scene.room, wall.start, wall.end, east, north) == (0.0, 0.0):
            continue
        for p in scene.placements:
            near = min(wall.coordinates(corner)[1] for corner in p.corners) < 0.15
            if near and p.id not in besides and p.support == "floor" and scene.asset_of(p).collides:
                found.append(p.id)
    return list(dict.fromkeys(found))
