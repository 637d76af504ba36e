"""Many upright boxes at once, turned about z: how far apart they are, and whether they are inside a room."""

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement
from thinkblox.value import Vec2

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Rects:
    """n upright boxes: centres (n, 2), half extents (n, 2), yaw (n,) [radians], bottoms and tops (n,) [m]."""

    centre: Array
    half: Array
    yaw: Array
    bottom: Array
    top: Array

    @staticmethod
    def of(rows: list[tuple[Vec2, Vec2, float, float, float]]) -> "Rects":
        """From (centre, full size, yaw in degrees, bottom, top) each."""
        table = np.array([[*c, *s, y, b, t] for c, s, y, b, t in rows], dtype=float).reshape(-1, 7)
        return Rects(table[:, :2], table[:, 2:4] / 2, np.radians(table[:, 4]), table[:, 5], table[:, 6])

    @staticmethod
    def of_placements(placements: tuple[Placement, ...]) -> "Rects":
        """The bounding boxes of placements."""
        return Rects.of(
            [((p.position[0], p.position[1]), (p.size[0], p.size[1]), p.yaw, p.position[2], p.top) for p in placements]
        )

    def __len__(self) -> int:
        return len(self.yaw)

    def take(self, index: Array | NDArray[np.int64] | list[int]) -> "Rects":
        """Return some of them."""
        return Rects(self.centre[index], self.half[index], self.yaw[index], self.bottom[index], self.top[index])

    @property
    def axes(self) -> Array:
        """Unit vectors along each box's own x and y, (n, 2, 2)."""
        c, s = np.cos(self.yaw), np.sin(self.yaw)
        return np.stack([np.stack([c, s], -1), np.stack([-s, c], -1)], 1)

    @property
    def corners(self) -> Array:
        """Corners of the footprints, counter-clockwise, (n, 4, 2) [m]."""
        signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float)
        local = signs[None] * self.half[:, None]
        return self.centre[:, None] + local @ self.axes


def separation(a: Rects, b: Rects) -> Array:
    """Signed horizontal distance of every pair, (len(a), len(b)) [m], by the separating-axis theorem.

    Positive: a lower bound of the free distance, exact for boxes that face each other. Negative: the depth of overlap.
    """
    if not len(a) or not len(b):
        return np.zeros((len(a), len(b)))
    x, y = (b.centre[None, :, axis] - a.centre[:, axis, None] for axis in (0, 1))
    (ca, sa), (cb, sb) = (np.cos(a.yaw)[:, None], np.sin(a.yaw)[:, None]), (np.cos(b.yaw)[None], np.sin(b.yaw)[None])
    same, across = np.abs(ca * cb + sa * sb), np.abs(sa * cb - ca * sb)
    (ax, ay), (bx, by) = (a.half[:, axis, None] for axis in (0, 1)), (b.half[None, :, axis] for axis in (0, 1))
    gaps = np.abs(x * ca + y * sa) - ax - (same * bx + across * by)
    np.maximum(gaps, np.abs(y * ca - x * sa) - ay - (across * bx + same * by), out=gaps)
    np.maximum(gaps, np.abs(x * cb + y * sb) - bx - (same * ax + across * ay), out=gaps)
    np.maximum(gaps, np.abs(y * cb - x * sb) - by - (across * ax + same * ay), out=gaps)
    return np.asarray(gaps)


def same_height(a: Rects, b: Rects, *, slack: float = 0.002) -> NDArray[np.bool_]:
    """Which pairs overlap in height by more than `slack`, (len(a), len(b))."""
    low = np.maximum(a.bottom[:, None], b.bottom[None])
    high = np.minimum(a.top[:, None], b.top[None])
    return np.asarray(high - low > slack)


def overlap_depth(a: Rects, b: Rects) -> Array:
    """Horizontal depth of overlap of every pair that shares a height, else 0, (len(a), len(b)) [m]."""
    return np.where(same_height(a, b), np.maximum(0.0, -separation(a, b)), 0.0)


def outside(rects: Rects, room: shapely.Polygon) -> Array:
    """Share of each footprint that lies outside the room, (n,)."""
    shapely.prepare(room)
    share = np.zeros(len(rects))
    near = np.flatnonzero(_may_reach_out(rects, room))
    polygons = np.asarray(shapely.polygons(rects.take(near).corners), dtype=object)
    over = ~shapely.covers(room, polygons)
    reaching = polygons[over]
    inside = shapely.area(shapely.intersection(reaching, room))
    share[near[over]] = np.maximum(0.0, 1.0 - inside / np.maximum(shapely.area(reaching), 1e-9))
    return share


def _may_reach_out(rects: Rects, room: shapely.Polygon) -> NDArray[np.bool_]:
    """Which boxes are not plainly inside: for a room that is a rectangle along the axes, this is the answer."""
    corners = rects.corners.reshape(-1, 2)
    if room.equals(shapely.box(*room.bounds)):
        x0, y0, x1, y1 = room.bounds
        inside = (corners >= (x0, y0)) & (corners <= (x1, y1))
        return np.asarray(~inside.all(-1).reshape(-1, 4).all(-1))
    return np.ones(len(rects), dtype=bool)
