"""How far an object is inside or outside a room, whose walls, floor and ceiling are infinitely thick."""

import math
from functools import cached_property, lru_cache, partial
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Point
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.sim.geometry.clipping import clip_to
from thinkblox.sim.geometry.footprint import Footprint, footprint_of, in_room
from thinkblox.sim.geometry.solid import Array, Solid
from thinkblox.value import Vec2, Vec3

GRAZE = 1e-9
"""What reaches out by less than this only touches [m]: rounding of coordinates up to 100 m."""
MANY_WALLS = 24
"""From so many walls on a convex floor is treated as any other: pairs of walls are looked at below."""


def boundary_distance(room: Room, placement: Placement, solid: Solid) -> float:
    """Signed distance of an object to the boundary of its room [m].

    Positive: the length of the least translation that brings it inside; outside being solid all the way, a wall is
    never left by its far side. If it fits nowhere at this yaw, the most that any one wall, floor or ceiling by itself
    would have it moved: that grows with the distance outside, and is no more than a translation would be.

    Negative: the free distance between its footprint and the nearest wall. Floor and ceiling do not count inside: most
    things touch one of them.

    Exact to 1e-6 m for any simple floor polygon; round outlines are polygons within `footprint.SAG`.
    """
    floor, footprint = _floor(room.floor), footprint_of(solid)
    up = _climb(room, placement, solid)
    gap = floor.gap(footprint, placement)
    if gap is not None:
        return abs(up) or -gap
    move = floor.move(footprint, placement)
    across = floor.furthest(footprint, placement) if move is None else math.hypot(*move)
    return math.hypot(across, up)


def least_move_inside(room: Room, placement: Placement, solid: Solid) -> Vec3 | None:
    """The least translation that brings an object inside its room [m], all 0 if it is; None if it fits nowhere."""
    if solid.highest - solid.lowest > room.height + GRAZE:
        return None
    floor, footprint = _floor(room.floor), footprint_of(solid)
    inside = floor.gap(footprint, placement) is not None
    across = (0.0, 0.0) if inside else floor.move(footprint, placement)
    return None if across is None else (*across, _climb(room, placement, solid))


def _climb(room: Room, placement: Placement, solid: Solid) -> float:
    """How far it must be raised, or lowered if negative, to be between floor and ceiling [m]; the larger if both."""
    below = -(placement.position[2] + solid.lowest)
    above = placement.position[2] + solid.highest - room.height
    if max(below, above) <= GRAZE:
        return 0.0
    return below if below >= above else -above


class _Floor:
    """A floor polygon, ready to be measured against; m walls."""

    def __init__(self, corners: tuple[Vec2, ...]) -> None:
        self._corners = np.asarray(corners)
        self._ahead = np.roll(self._corners, -1, axis=0)
        along = self._ahead - self._corners
        along = along / np.hypot(along[:, 0], along[:, 1])[:, None]
        self._inward = np.column_stack([-along[:, 1], along[:, 0]])
        self._offset = np.einsum("ij,ij->i", self._inward, self._corners)
        self._polygon = shapely.Polygon(corners)
        following = np.roll(along, -1, axis=0)
        turns = along[:, 0] * following[:, 1] - along[:, 1] * following[:, 0]
        self._convex = bool(turns.min() > -GRAZE)

    def gap(self, footprint: Footprint, placement: Placement) -> float | None:
        """Distance of a footprint to the nearest wall [m]; None if it reaches past one."""
        corners = in_room(footprint.corners, placement)
        if self._convex:
            nearest = float(self._clearances(corners).min())
            return max(0.0, nearest) if nearest >= -GRAZE else None
        outline = shapely.polygons(corners) if footprint.convex else _moved(footprint.area, placement)
        if not shapely.covers(self._widened, outline):
            return None
        return float(shapely.distance(self._ring, outline))

    def move(self, footprint: Footprint, placement: Placement) -> Vec2 | None:
        """The least translation that brings a footprint inside [m]; None if there is none."""
        if self._convex and len(self._corners) < MANY_WALLS:
            return _into_half_planes(self._inward, -self._clearances(in_room(footprint.corners, placement)))
        box = _bounds(footprint.corners)
        around = self._among_pieces([in_room(box, placement)], math.inf)
        if around is not None and len(footprint.pieces) == 1 and _area(box) - _area(footprint.corners) < GRAZE:
            return around
        reach = math.inf if around is None else math.hypot(*around) + GRAZE
        return self._among_pieces([in_room(piece, placement) for piece in _convex_parts(footprint)], reach)

    def furthest(self, footprint: Footprint, placement: Placement) -> float:
        """The most that any one wall, or the way back to the floor, would have a part of a footprint moved [m]."""
        pieces = [in_room(piece, placement) for piece in footprint.pieces]
        outside = max(float(shapely.distance(self._polygon, shapely.points(piece)).max()) for piece in pieces)
        here, sunk = Point(0.0, 0.0), 0.0
        for blocked in (self._blocked(piece) for piece in pieces):
            crossing = blocked[shapely.contains(blocked, here)]
            sunk = max(sunk, float(shapely.distance(shapely.boundary(crossing), here).max(initial=0.0)))
        return max(outside, sunk)

    def _clearances(self, corners: Array) -> Array:
        """How far the nearest of some points is on the inner side of each wall's line, shape (m,) [m]."""
        clearances: Array = (corners @ self._inward.T).min(axis=0) - self._offset
        return clearances

    def _among_pieces(self, pieces: list[Array], reach: float) -> Vec2 | None:
        """The least translation, none longer than `reach`, after which no piece crosses a wall and all middles are in.

        Every piece is convex, so a wall runs through it at the translations in the convex hull of wall minus piece.
        """
        pieces = [_middle(piece) + (piece - _middle(piece)) * (1.0 - GRAZE) for piece in pieces]
        free = shapely.intersection_all([shapely.transform(self._polygon, partial(_less, _middle(p))) for p in pieces])
        blocked = np.concatenate([self._blocked(piece, reach) for piece in pieces])
        if reach < math.inf:
            free, blocked = _clipped(free, reach), _clipped(blocked, reach)
        free = shapely.difference(free, shapely.union_all(blocked))
        if free.is_empty:
            return None
        x, y = shapely.get_coordinates(shapely.shortest_line(Point(0.0, 0.0), free))[-1]
        return (float(x), float(y))

    def _blocked(self, piece: Array, reach: float = math.inf) -> NDArray[Any]:
        """For each wall the translations, a convex polygon, at which it runs through a piece; those within `reach`."""
        low = np.minimum(self._corners, self._ahead) - piece.max(axis=0)
        high = np.maximum(self._corners, self._ahead) - piece.min(axis=0)
        near = (low <= reach).all(axis=1) & (high >= -reach).all(axis=1)
        ends = self._corners[near, None] - piece, self._ahead[near, None] - piece
        walls_less_piece: Any = shapely.linestrings(np.concatenate(ends, axis=1))
        return np.asarray(shapely.convex_hull(walls_less_piece))

    @cached_property
    def _widened(self) -> BaseGeometry:
        polygon = shapely.buffer(self._polygon, GRAZE, join_style="mitre")
        shapely.prepare(polygon)
        return polygon

    @cached_property
    def _ring(self) -> BaseGeometry:
        ring = shapely.boundary(self._polygon)
        shapely.prepare(ring)
        return ring


@lru_cache(maxsize=64)
def _floor(corners: tuple[Vec2, ...]) -> _Floor:
    return _Floor(corners)


def _moved(local: BaseGeometry, placement: Placement) -> BaseGeometry:
    return shapely.transform(local, lambda points: in_room(points, placement))


def _convex_parts(footprint: Footprint) -> tuple[Array, ...]:
    return (footprint.corners,) if footprint.convex else footprint.pieces


def _middle(piece: Array) -> Array:
    middle: Array = piece.mean(axis=0)
    return middle


def _less(middle: Array, points: Array) -> Array:
    less: Array = points - middle
    return less


def _bounds(corners: Array) -> Array:
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    return np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])


def _clipped(geometry: Any, reach: float) -> Any:
    """One geometry or an array of them within a square about the origin."""
    return clip_to(geometry, -reach, -reach, reach, reach)


def _area(corners: Array) -> float:
    return float(shapely.area(shapely.polygons(corners)))


def _into_half_planes(normals: Array, least: Array) -> Vec2 | None:
    """The shortest t with normals @ t >= least, normals of length 1, shape (m, 2); None if there is none.

    It is at 0, on one line, or where two lines cross: all are tried.
    """
    first, second = np.triu_indices(len(normals), k=1)
    cross = normals[first, 0] * normals[second, 1] - normals[first, 1] * normals[second, 0]
    meet = np.abs(cross) > 1e-12
    a, b, u, v = normals[first][meet], normals[second][meet], least[first][meet], least[second][meet]
    crossings = np.column_stack([u * b[:, 1] - v * a[:, 1], v * a[:, 0] - u * b[:, 0]]) / cross[meet][:, None]
    tries = np.vstack([np.zeros((1, 2)), normals * least[:, None], crossings])
    allowed = tries[((tries @ normals.T - least) >= -2 * GRAZE).all(axis=1)]
    if not len(allowed):
        return None
    x, y = allowed[np.argmin(np.hypot(allowed[:, 0], allowed[:, 1]))]
    return (float(x), float(y))
