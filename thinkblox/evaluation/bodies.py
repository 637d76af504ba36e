"""An object as the judge sees it: upright prisms, one over the outline of each of its convex parts."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from thinkblox.evaluation.room_file import PlacementRecord, SeenAsset, ShapeRecord, Vec2

_ROUND = 24
"""Corners that stand for a circle."""
_THINNEST = 1e-4
"""What a part is widened by, so that a sheet has an area [m]."""


@dataclass(frozen=True)
class Prism:
    """A part of an object: an outline seen from above, from one height to another [m]."""

    outline: Polygon
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Body:
    """An object in the room. Its own frame: x to its front, y to its left, from the middle of its footprint [m]."""

    placement: PlacementRecord
    asset: SeenAsset

    @property
    def id(self) -> str:
        """As in the scene."""
        return self.placement.id

    @property
    def low(self) -> float:
        """Height of its base [m]."""
        return self.placement.position[2]

    @property
    def high(self) -> float:
        """Height of its top [m]."""
        return self.low + self.placement.size[2]

    @property
    def middle(self) -> float:
        """Height half-way up [m]."""
        return (self.low + self.high) / 2

    @property
    def centre(self) -> Vec2:
        """Middle of its footprint [m]."""
        return self.placement.position[:2]

    @property
    def half(self) -> Vec2:
        """Half its extent to the front and across [m]."""
        return (self.placement.size[0] / 2, self.placement.size[1] / 2)

    @cached_property
    def footprint(self) -> Polygon:
        """Its bounding rectangle, turned with it."""
        x, y = (max(half, _THINNEST) for half in self.half)
        return Polygon([self.to_room(corner) for corner in ((-x, -y), (x, -y), (x, y), (-x, y))])

    @cached_property
    def parts(self) -> tuple[Prism, ...]:
        """A prism round each convex part."""
        return tuple(self._prism(shape) for link in self.asset.links for shape in link.shapes)

    @cached_property
    def outlines(self) -> NDArray[np.object_]:
        """The outlines of its parts."""
        return np.array([part.outline for part in self.parts], dtype=object)

    @cached_property
    def heights(self) -> NDArray[np.float64]:
        """The low and high ends of its parts, in rows [m]."""
        return np.array([(part.low, part.high) for part in self.parts])

    def facing(self) -> Vec2:
        """Unit vector to its front."""
        yaw = math.radians(self.placement.yaw)
        return (math.cos(yaw), math.sin(yaw))

    def to_room(self, local: Vec2) -> Vec2:
        """A point of its own frame in the room's [m]."""
        (fx, fy), (x, y) = self.facing(), self.centre
        return (x + fx * local[0] - fy * local[1], y + fy * local[0] + fx * local[1])

    def to_own(self, outline: BaseGeometry) -> BaseGeometry:
        """An outline of the room in its own frame."""
        (fx, fy), (x, y) = self.facing(), self.centre

        def turn(points: NDArray[np.float64]) -> NDArray[np.float64]:
            dx, dy = points[:, 0] - x, points[:, 1] - y
            return np.stack([dx * fx + dy * fy, dy * fx - dx * fy], axis=1)

        turned: BaseGeometry = shapely.transform(outline, turn)
        return turned

    def _prism(self, shape: ShapeRecord) -> Prism:
        corners = corners_of(shape)
        outline = MultiPoint([self.to_room((x, y)) for x, y in corners[:, :2]]).convex_hull
        solid = outline if isinstance(outline, Polygon) and outline.area > 0 else outline.buffer(_THINNEST)
        return Prism(solid, self.low + float(corners[:, 2].min()), self.low + float(corners[:, 2].max()))


def corners_of(shape: ShapeRecord) -> NDArray[np.float64]:
    """Points of the asset's frame whose hull holds the shape [m]; round ones are taken as what encloses them."""
    local = np.array(shape.points) if shape.kind == "hull" else _standing(shape)
    turned: NDArray[np.float64] = local @ _rotation(shape.quat_wxyz).T + np.array(shape.position)
    return turned


def _standing(shape: ShapeRecord) -> NDArray[np.float64]:
    x, y, z = (extent / 2 for extent in shape.size)
    if shape.kind == "box":
        ring = [(-x, -y), (x, -y), (x, y), (-x, y)]
    else:
        turns = [2 * math.pi * k / _ROUND for k in range(_ROUND)]
        ring = [(x * math.cos(t), y * math.sin(t)) for t in turns]
    return np.array([(a, b, c) for a, b in ring for c in (-z, z)])


def _rotation(quat_wxyz: tuple[float, float, float, float]) -> NDArray[np.float64]:
    w, x, y, z = quat_wxyz
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def distance(a: Body, b: Body) -> float:
    """Distance between the surfaces of two objects, 0 where they touch [m]."""
    if not a.parts or not b.parts:
        return float(a.footprint.distance(b.footprint))
    plan = shapely.distance(a.outlines[:, None], b.outlines[None, :])
    below = a.heights[:, None, 0] - b.heights[None, :, 1]
    above = b.heights[None, :, 0] - a.heights[:, None, 1]
    return float(np.hypot(plan, np.maximum(0.0, np.maximum(below, above))).min())


def shared(a: BaseGeometry, b: BaseGeometry) -> float:
    """Area that two outlines share, as a share of the smaller of them."""
    smaller = min(a.area, b.area)
    return float(a.intersection(b).area / smaller) if smaller > 0 else 0.0


def share_within(a: BaseGeometry, b: BaseGeometry) -> float:
    """The share of the first outline's area that lies within the second."""
    return float(a.intersection(b).area / a.area) if a.area > 0 else 0.0
