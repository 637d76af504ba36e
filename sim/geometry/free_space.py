"""Where an object can be shifted to in a plane: the places at which it is in the room and clear of everything else.

A convex piece b of the object meets a convex obstacle a exactly when the object's shift is inside the Minkowski sum of
a and -b (T. Lozano-Perez, Spatial planning: a configuration space approach, IEEE Trans. Computers, 1983). What is left
of the room is where the object can be; its point nearest to where the object is, is the least shift that frees it.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Asset
from thinkblox.scene.derived import kept_by_content
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room, Wall
from thinkblox.sim.geometry.openings import GRAZE, door_zone, window_zone
from thinkblox.sim.geometry.solid import pose, shape_points
from thinkblox.sim.settings import Walking

Array = NDArray[np.float64]
SKIN = 0.0002
"""Pieces that share less than this of the third direction pass over each other [m]."""
LEVEL = 0.001
"""A top this near to an object's base carries it [m]."""
INSET = 0.002
"""How far within the edge of what carries it an object's middle stays [m]."""


@dataclass(frozen=True)
class Plane:
    """A plane in which things are shifted, with coordinates (u, v, w): u and v in it, w across it.

    Attributes:
        origin: where the coordinates are 0, in the room [m].
        axes: unit vectors of u, v and w as rows, in the room.
        outline: the part of the plane that belongs to the room.
        upright: whether w is up, so that tops at one w carry things.
    """

    origin: Array
    axes: Array
    outline: Polygon
    upright: bool

    def coordinates(self, points: Array) -> Array:
        """(u, v, w) of points (n, 3) of the room [m]."""
        return np.asarray((points - self.origin) @ self.axes.T)

    def point(self, coordinates: Array) -> Array:
        """The point of the room at (u, v, w): the inverse of `coordinates`."""
        return np.asarray(self.origin + coordinates @ self.axes)


def floor_plane(room: Room) -> Plane:
    """The plane of what stands on the floor or on things, and of what hangs from the ceiling."""
    return Plane(np.zeros(3), np.eye(3), room.polygon, upright=True)


def wall_plane(room: Room, wall: Wall) -> Plane:
    """The plane of what hangs on a wall: u along it, v up, w into the room."""
    (ax, ay), (nx, ny) = wall.along, wall.inward
    axes = np.array([[ax, ay, 0.0], [0.0, 0.0, 1.0], [nx, ny, 0.0]])
    return Plane(np.array([*wall.start, 0.0]), axes, shapely.box(0.0, 0.0, wall.length, room.height), upright=False)


@dataclass(frozen=True)
class FlatPiece:
    """A convex piece as a plane sees it: corners (n, 2) in it, and its extent across it [m]."""

    corners: Array
    low: float
    high: float


def pieces_of(plane: Plane, placement: Placement, asset: Asset) -> tuple[FlatPiece, ...]:
    """The pieces of a placed asset: its colliding shapes, or all of them where none collides."""
    matrix = pose(placement)
    found = []
    for points in _shapes(asset):
        flat = plane.coordinates(points @ matrix[:, :3].T + matrix[:, 3])
        corners = shapely.get_coordinates(MultiPoint(flat[:, :2]).convex_hull)
        found.append(FlatPiece(corners, float(flat[:, 2].min()), float(flat[:, 2].max())))
    return tuple(found)


@kept_by_content
def _shapes(asset: Asset) -> tuple[Array, ...]:
    every = [shape for link in asset.links for shape in link.shapes]
    return tuple(shape_points(shape) for shape in ([s for s in every if s.collide] or every))


def free_space(
    plane: Plane, at: Array, mine: Sequence[FlatPiece], obstacles: Sequence[FlatPiece], zones: Sequence[FlatPiece] = ()
) -> BaseGeometry:
    """Where, in (u, v), a thing can be whose pieces are `mine` when it is at `at`, shifted within the plane.

    Args:
        plane: in which it moves.
        at: (u, v) of its origin now.
        mine: its pieces, and those of what moves with it.
        obstacles: pieces of the things that it must not overlap.
        zones: pieces that must stay free besides.
    """
    own = [FlatPiece(piece.corners - at, piece.low, piece.high) for piece in mine]
    pairs = [(a, b) for a in (*obstacles, *zones) for b in own if _level(a, b)]
    taken = _beyond(plane.outline, own) + [_sum(a.corners, -b.corners) for a, b in pairs]
    return shapely.difference(plane.outline, shapely.union_all(taken))


def _level(a: FlatPiece, b: FlatPiece) -> bool:
    return min(a.high, b.high) - max(a.low, b.low) > SKIN


def _beyond(outline: Polygon, mine: Sequence[FlatPiece]) -> list[BaseGeometry]:
    """Shifts at which some piece crosses an edge of the room; of the hull of all pieces where the room is convex."""
    convex = shapely.area(shapely.convex_hull(outline)) - shapely.area(outline) < 1e-9
    whole = np.vstack([piece.corners for piece in mine])
    hulls = [whole] if convex else [piece.corners for piece in mine]
    corners = shapely.get_coordinates(outline)
    edges = [corners[i : i + 2] for i in range(len(corners) - 1)]
    return [_sum(edge, -hull) for edge in edges for hull in hulls]


def _sum(a: Array, b: Array) -> BaseGeometry:
    """Minkowski sum of the convex hulls of two lists of corners."""
    return MultiPoint((a[:, None] + b[None]).reshape(-1, 2)).convex_hull


def carried_within(space: BaseGeometry, obstacles: Iterable[FlatPiece], base: float) -> BaseGeometry:
    """The part of a free space in which the object's origin is over a top at the height of its base [m]."""
    tops = [MultiPoint(p.corners).convex_hull for p in obstacles if abs(p.high - base) < LEVEL]
    return shapely.intersection(space, shapely.buffer(shapely.union_all(tops), -INSET))


def zone_pieces(room: Room, walking: Walking, *, windows: bool) -> tuple[FlatPiece, ...]:
    """The zones inside doors, and before windows if these count, as pieces that must stay free."""
    found = []
    for opening in room.openings:
        if opening.kind == "door":
            zone, low, high = door_zone(room, opening, walking), walking.step, opening.sill + opening.height
        elif windows:
            zone, low, high = window_zone(room, opening, walking), opening.sill + walking.window_excess, math.inf
        else:
            continue
        inner = shapely.get_coordinates(shapely.buffer(zone, -GRAZE / 2))
        if len(inner):
            found.append(FlatPiece(inner, low, high))
    return tuple(found)
