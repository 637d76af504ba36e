"""What an asset fills, worked out once per asset: volumes, manifolds, corner points and footprints."""

import atexit
import math
from functools import cached_property, lru_cache
from weakref import WeakKeyDictionary

import numpy as np
import shapely
from manifold3d import Manifold, OpType
from numpy.typing import NDArray
from shapely import MultiPoint
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Asset, Link, Shape
from thinkblox.scene.corners import rotation
from thinkblox.scene.derived import kept_by_content
from thinkblox.scene.placement import Placement
from thinkblox.sim.geometry.collider import collider
from thinkblox.sim.geometry.materials import usual_weight

Array = NDArray[np.float64]
SEGMENTS = 48
"""Sides of the polygon that stands for a circle where distances are measured."""
COARSE = 24
"""The same where volumes are."""
_CUBE = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])


def pose(placement: Placement) -> Array:
    """The 3x4 matrix from the asset's frame to the room's."""
    fx, fy = placement.front
    x, y, z = placement.position
    return np.array([[fx, -fy, 0.0, x], [fy, fx, 0.0, y], [0.0, 0.0, 1.0, z]])


def shape_points(shape: Shape) -> Array:
    """Points in the asset's frame [m] whose convex hull is the shape, shape (n, 3); round ones are sampled."""
    return _placed(shape, _local_points(shape, SEGMENTS))


def _placed(shape: Shape, local: Array) -> Array:
    placed: Array = local @ rotation(shape.quat_wxyz).T + np.asarray(shape.position)
    return placed


def _local_points(shape: Shape, segments: int) -> Array:
    half = np.asarray(shape.size) / 2
    if shape.kind == "hull":
        return np.asarray(collider(shape).points, dtype=np.float64)
    if shape.kind == "box":
        return _CUBE * half
    if shape.kind == "cylinder":
        ring = _ring(segments) * half[:2]
        return np.vstack([np.column_stack([ring, np.full(segments, z)]) for z in (-half[2], half[2])])
    ball = _ball(segments)
    if shape.kind == "capsule":
        straight = half[2] - half[0]
        return np.vstack([ball * half[0] + (0.0, 0.0, z) for z in (-straight, straight)])
    return ball * half


@lru_cache(maxsize=4)
def _ring(segments: int) -> Array:
    angles = np.arange(segments) * (2 * math.pi / segments)
    return np.column_stack([np.cos(angles), np.sin(angles)])


@lru_cache(maxsize=4)
def _ball(segments: int) -> Array:
    levels = np.linspace(-math.pi / 2, math.pi / 2, segments // 4 + 1)[1:-1]
    rings = [np.column_stack([_ring(segments) * math.cos(t), np.full(segments, math.sin(t))]) for t in levels]
    return np.vstack([*rings, [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]])


def shape_volume(shape: Shape) -> float:
    """Volume of a shape [m3]."""
    x, y, z = shape.size
    if shape.kind == "box":
        return x * y * z
    if shape.kind == "cylinder":
        return math.pi / 4 * x * y * z
    if shape.kind == "capsule":
        return math.pi / 4 * x * x * (z - x) + math.pi / 6 * x**3
    if shape.kind == "hull":
        return float(Manifold.hull_points(np.asarray(shape.points)).volume())
    return math.pi / 6 * x * y * z


def shape_area(shape: Shape) -> float:
    """Surface of a shape [m2]; of an ellipsoid by Thomsen's formula, to a hundredth."""
    x, y, z = shape.size
    if shape.kind == "box":
        return 2 * (x * y + y * z + z * x)
    if shape.kind == "cylinder":
        return math.pi * (x * y / 2 + (x + y) / 2 * z)
    if shape.kind == "capsule":
        return math.pi * x * z
    if shape.kind == "hull":
        return float(Manifold.hull_points(np.asarray(shape.points)).surface_area())
    a, b, c = ((extent / 2) ** 1.6075 for extent in (x, y, z))
    return float(4 * math.pi * ((a * b + b * c + c * a) / 3) ** (1 / 1.6075))


def weighing(link: Link) -> tuple[Shape, ...]:
    """The shapes that carry a link's mass: those that collide, or all of them when none does."""
    return tuple(s for s in link.shapes if s.collide) or link.shapes


# Polyhedra that are alive when the interpreter ends are complained of on standard error: so a solid does not keep them.
_PIECES: "WeakKeyDictionary[Solid, tuple[Manifold, ...]]" = WeakKeyDictionary()
_UNIONS: "WeakKeyDictionary[Solid, Manifold]" = WeakKeyDictionary()
atexit.register(_PIECES.clear)
atexit.register(_UNIONS.clear)


class Solid:
    """An asset as geometry; everything is in the asset's frame and worked out when first asked for."""

    def __init__(self, asset: Asset) -> None:
        self.asset = asset
        self._shapes = [shape for link in asset.links for shape in link.shapes]
        self._outlines: dict[tuple[float, float], BaseGeometry] = {}

    @cached_property
    def _points(self) -> list[Array]:
        return [shape_points(shape) for shape in self._shapes]

    @cached_property
    def colliders(self) -> tuple[Shape, ...]:
        """The shapes that collide, link by link: its pieces."""
        return tuple(shape for shape in self._shapes if shape.collide)

    @cached_property
    def cloud(self) -> tuple[Array, NDArray[np.intp]]:
        """Points of the pieces one after the other [m], shape (n, 3), and the index at which each piece begins."""
        points = [p for shape, p in zip(self._shapes, self._points, strict=True) if shape.collide]
        return np.vstack(points), np.cumsum([0, *map(len, points[:-1])])

    @cached_property
    def low(self) -> Array:
        """Lowest corner of the box round its pieces [m]."""
        corner: Array = self.cloud[0].min(axis=0)
        return corner

    @cached_property
    def high(self) -> Array:
        """Highest corner of the box round its pieces [m]."""
        corner: Array = self.cloud[0].max(axis=0)
        return corner

    @property
    def pieces(self) -> tuple[Manifold, ...]:
        """Each piece as a polyhedron of its volume."""
        if self not in _PIECES:
            _PIECES[self] = tuple(_hull(shape) for shape in self.colliders)
        return _PIECES[self]

    @cached_property
    def masses(self) -> tuple[tuple[float, ...], ...]:
        """For each link the mass of each of its `weighing` shapes [kg]: its share of the asset's, by what it is of."""
        weights = [[_weight(shape) for shape in weighing(link)] for link in self.asset.links]
        share = self.asset.mass / sum(map(sum, weights))
        return tuple(tuple(weight * share for weight in link) for link in weights)

    @property
    def manifold(self) -> Manifold:
        """Union of the colliding shapes; round ones keep their volume."""
        if self not in _UNIONS:
            _UNIONS[self] = Manifold.batch_boolean(list(self.pieces), OpType.Add)
        return _UNIONS[self]

    @cached_property
    def volume(self) -> float:
        """What the colliding shapes fill, overlaps counted once [m3]."""
        return float(self.manifold.volume())

    @cached_property
    def points(self) -> Array:
        """Points of all shapes [m], shape (n, 3)."""
        return np.vstack(self._points)

    @cached_property
    def lowest(self) -> float:
        """Height of its lowest point above its base [m]."""
        return float(self.points[:, 2].min())

    @cached_property
    def highest(self) -> float:
        """Height of its highest point above its base [m]."""
        return float(self.points[:, 2].max())

    def outline(self, *, above: float = -math.inf, below: float = math.inf) -> BaseGeometry:
        """What it covers of the floor with the shapes that reach into the heights between `above` and `below` [m]."""
        key = (above, below)
        if key not in self._outlines:
            reaching = [p for p in self._points if p[:, 2].min() < below and p[:, 2].max() > above]
            self._outlines[key] = _union([MultiPoint(points[:, :2]).convex_hull for points in reaching])
        return self._outlines[key]


def _weight(shape: Shape) -> float:
    return usual_weight(shape.material, shape_volume(shape), shape_area(shape))


def _union(hulls: list[BaseGeometry]) -> BaseGeometry:
    """The union of areas, most of which the largest is likely to cover."""
    if not hulls:
        return shapely.Polygon()
    largest = max(hulls, key=shapely.area)
    rest = [hull for hull in hulls if not shapely.covers(largest, hull)]
    return shapely.union_all([largest, *rest]) if rest else largest


@kept_by_content
def solid_of(asset: Asset) -> Solid:
    """The one `Solid` of an asset."""
    return Solid(asset)


def _hull(shape: Shape) -> Manifold:
    """A polyhedron of the shape's volume: what sampling cuts off a round one is given back by widening it."""
    local = _local_points(shape, COARSE)
    missing = shape_volume(shape) / Manifold.hull_points(local).volume()
    if shape.kind == "cylinder":
        local = local * (missing**0.5, missing**0.5, 1.0)
    elif shape.kind in ("sphere", "ellipsoid", "capsule"):
        local = local * missing ** (1 / 3)
    return Manifold.hull_points(_placed(shape, local))


def on_floor(local: BaseGeometry, placement: Placement) -> BaseGeometry:
    """An outline in the asset's frame moved to where the placement stands in the room."""
    matrix = pose(placement)
    return shapely.transform(local, lambda xy: xy @ matrix[:2, :2].T + matrix[:2, 3])
