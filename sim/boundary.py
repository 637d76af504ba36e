"""How far an object reaches out of the room: past a wall, through the floor or above the ceiling."""

import shapely
from shapely.geometry.base import BaseGeometry

from thinkblox.room import Room
from thinkblox.scene import Placement
from thinkblox.sim.solid import Solid, on_floor

FINENESS = 0.02
"""Spacing of the points at which the part outside is measured [m]."""


def distance_outside(room: Room, placement: Placement, solid: Solid) -> float:
    """Largest distance that any part reaches out of the room [m]; 0 when it is all inside.

    In plan this is the greatest distance from the floor polygon of what lies outside it, or how deep a corner that
    points into the room is inside the object.
    """
    base = placement.position[2]
    above = base + solid.highest - room.height
    below = -(base + solid.lowest)
    return max(0.0, above, below, _past_walls(room, on_floor(solid.outline(), placement)))


def _past_walls(room: Room, footprint: BaseGeometry) -> float:
    floor = room.polygon
    shapely.prepare(floor)
    if floor.covers(footprint):
        return 0.0
    past = shapely.difference(footprint, floor)
    if past.is_empty:
        return 0.0
    points = shapely.points(shapely.get_coordinates(shapely.segmentize(past, FINENESS)))
    furthest = float(shapely.distance(points, floor).max())
    corners = shapely.points(room.floor)
    inside = corners[shapely.contains_properly(footprint, corners)]
    sunk = shapely.distance(inside, shapely.boundary(footprint)).max() if len(inside) else 0.0
    return furthest if _is_convex(room) else max(furthest, float(sunk))


def _is_convex(room: Room) -> bool:
    floor = room.polygon
    return bool(shapely.area(shapely.convex_hull(floor)) - shapely.area(floor) < 1e-9)
