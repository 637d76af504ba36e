"""What an asset covers of the floor, exact enough to measure against walls."""

import math
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Shape
from thinkblox.scene.corners import rotation
from thinkblox.scene.derived import kept
from thinkblox.scene.placement import Placement
from thinkblox.sim.geometry.solid import Array, Solid, pose, shape_points

SAG = 5e-7
"""How far the polygon that stands for a round outline stays inside it, at most [m]."""


class Footprint:
    """The outlines of an asset's shapes in plan, in the asset's frame; each is convex, as the shapes are.

    Attributes:
        pieces: corners of the outlines that no other one covers, shape (n, 2) each [m].
        corners: of the convex hull of them all, shape (n, 2) [m].
    """

    def __init__(self, solid: Solid) -> None:
        shapes = [shape for link in solid.asset.links for shape in link.shapes]
        self.pieces = _uncovered([_outline(shape) for shape in shapes])
        self.corners = _hull(np.vstack(self.pieces))

    @cached_property
    def area(self) -> BaseGeometry:
        """The union of the pieces."""
        return shapely.union_all([shapely.Polygon(piece) for piece in self.pieces if len(piece) > 2])

    @cached_property
    def convex(self) -> bool:
        """Whether the pieces together leave nothing of their hull free."""
        return shapely.Polygon(self.corners).area - self.area.area < 1e-9


@kept
def footprint_of(solid: Solid) -> Footprint:
    """The one `Footprint` of a solid."""
    return Footprint(solid)


def in_room(points: Array, placement: Placement) -> Array:
    """Plan points of the asset's frame in the room's, shape (n, 2) [m]."""
    matrix = pose(placement)
    placed: Array = points @ matrix[:2, :2].T + matrix[:2, 3]
    return placed


def _outline(shape: Shape) -> Array:
    if shape.kind in ("box", "hull"):
        return _hull(shape_points(shape)[:, :2])
    half = np.asarray(shape.size) / 2
    turned = rotation(shape.quat_wxyz)[:2]
    middle, along = np.asarray(shape.position)[:2], turned[:, 2]
    if shape.kind == "cylinder":
        return _hull(
            np.vstack([_ellipse(turned[:, :2] * half[:2]) + middle + end * along for end in (-half[2], half[2])])
        )
    if shape.kind == "capsule":
        ends = (half[0] - half[2], half[2] - half[0])
        return _hull(np.vstack([_ellipse(np.eye(2) * half[0]) + middle + end * along for end in ends]))
    spread = turned * half
    return _hull(_ellipse(np.linalg.cholesky(spread @ spread.T)) + middle)


def _ellipse(axes: NDArray[Any]) -> Array:
    """Points on the image of the unit circle under a 2x2 matrix [m]."""
    longest = float(np.linalg.norm(axes, 2))
    count = 4 * math.ceil(math.pi / math.acos(max(0.5, 1.0 - SAG / longest)) / 4)
    angles = np.arange(count) * (2 * math.pi / count)
    points: Array = np.column_stack([np.cos(angles), np.sin(angles)]) @ axes.T
    return points


def _hull(points: Array) -> Array:
    hull = shapely.get_coordinates(_around(points))
    return hull[:-1] if len(hull) > 3 else hull


def _around(points: Array) -> BaseGeometry:
    """The convex hull of two points and more; a line through them is made sooner than as many points."""
    return shapely.LineString(points).convex_hull


def _uncovered(outlines: list[Array]) -> tuple[Array, ...]:
    """The outlines that are not inside a single other one, largest first."""
    areas = [_around(outline) for outline in outlines]
    kept: list[int] = []
    for number in sorted(range(len(areas)), key=lambda number: -areas[number].area):
        if not any(shapely.covers(areas[other], areas[number]) for other in kept):
            kept.append(number)
    return tuple(outlines[number] for number in kept)
