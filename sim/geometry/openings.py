"""What stands in the way of doors and windows."""

from functools import lru_cache

import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room
from thinkblox.sim.geometry.solid import Solid, on_floor
from thinkblox.sim.settings import Walking

GRAZE = 0.001
"""An object may reach this far into a zone [m]."""
STANDING = 0.05
"""What is lower than this at its base stands on the floor [m]."""


@lru_cache(maxsize=256)
def door_zone(room: Room, door: Opening, walking: Walking) -> BaseGeometry:
    """The floor inside a door that stays free: as wide as the door, `walking.door_zone` times as deep as it sweeps."""
    return _zone(room, door, door.swept * walking.door_zone)


@lru_cache(maxsize=256)
def window_zone(room: Room, window: Opening, walking: Walking) -> BaseGeometry:
    """The floor right in front of a window."""
    return _zone(room, window, walking.window_zone)


def _zone(room: Room, opening: Opening, depth: float) -> BaseGeometry:
    wall, start, end = room.walls[opening.wall], opening.offset, opening.offset + opening.width
    corners = [wall.point(start), wall.point(end), wall.point(end, depth), wall.point(start, depth)]
    return shapely.intersection(Polygon(corners), room.polygon)


def blocked_openings(
    room: Room, placement: Placement, asset: Asset, solid: Solid, walking: Walking
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Ids of the doors whose zone the object stands in, and of the windows that it covers.

    Exempt are flat things that one walks over, what hangs above a door's height, and, before windows, whatever is
    mounted, narrow, or no higher than a little above the sill.
    """
    if not asset.collides:
        return (), ()
    doors = [o for o in room.openings if o.kind == "door" and _in_door(room, o, placement, solid, walking)]
    windows = [o for o in room.openings if o.kind == "window" and _before_window(room, o, placement, solid, walking)]
    standing = asset.mount == "floor" and placement.position[2] < STANDING
    return tuple(o.id for o in doors), tuple(o.id for o in windows) if standing else ()


def _in_door(room: Room, door: Opening, placement: Placement, solid: Solid, walking: Walking) -> bool:
    base = placement.position[2]
    low = solid.outline(above=walking.step - base, below=door.sill + door.height - base)
    zone = door_zone(room, door, walking)
    if low.is_empty or not shapely.intersects(on_floor(low, placement), zone):
        return False
    return bool(shapely.intersects(on_floor(low, placement), shapely.buffer(zone, -GRAZE)))


def _before_window(room: Room, window: Opening, placement: Placement, solid: Solid, walking: Walking) -> bool:
    high = solid.outline(above=window.sill + walking.window_excess - placement.position[2])
    if high.is_empty:
        return False
    before = shapely.intersection(on_floor(high, placement), window_zone(room, window, walking))
    if shapely.area(before) < GRAZE**2:
        return False
    covered = _span(room, window, before)
    return covered > walking.window_share * window.width and _span(room, window, on_floor(high, placement)) > (
        walking.window_width
    )


def _span(room: Room, opening: Opening, area: BaseGeometry) -> float:
    """Extent of an area along the opening's wall [m]."""
    ax, ay = room.walls[opening.wall].along
    xy = shapely.get_coordinates(area)
    along = xy[:, 0] * ax + xy[:, 1] * ay
    return float(along.max() - along.min())
