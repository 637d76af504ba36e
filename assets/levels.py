"""Level areas found in the shape of a thing: tops that carry, and the bottoms of hollows."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Link, Shape, Surface
from thinkblox.scene.corners import corners_of
from thinkblox.value import Vec3

SAME_LEVEL = 0.0005
"""Faces that differ by less in height are one level [m]."""
_SLATS = 0.06
"""Half of how far the slats of a top may be apart that covers what is under it [m]."""
CLEAR = 0.04
"""What begins lower than this over a face stands on it [m]."""
NARROWEST = 0.08
"""Least side of an area that carries [m]."""
DEPTH = 0.06
"""How far below the rim of a hollow its bottom lies at least: less is the edge of a tray [m]."""
TOP_SHARE, HOLLOW_SHARE = 0.3, 0.15
"""Least share of the outline of a thing that a top of it, and the bottom of a hollow, takes."""
HIGH = 0.6
"""Share of its height from which the top of a small thing is one."""
WALLED = 0.5
"""Share of a side of an area along which something rises, from which that side is a wall."""
_CELLS = 40
"""Cells along each side of the grid on which areas are sought."""
_EDGE = 0.012
"""How far beyond an area its walls are sought [m]."""


class _Solid(NamedTuple):
    """A convex shape: its outline from above, its heights, its level top face if it has one, whether it is fixed."""

    outline: BaseGeometry
    low: float
    high: float
    face: Polygon | None
    fixed: bool


def found_surfaces(links: Sequence[Link], size: Vec3, *, small: bool) -> tuple[Surface, ...]:
    """Where other things can be put on or into a thing whose maker named no place for them.

    Its hollows, and of its open tops those that take a good share of its outline; of a small thing that itself lies on
    others only a top that is near its full height, so that nothing is put on the foot of a screen.

    Args:
        links: of the asset.
        size: its full extents [m].
        small: whether it is kept on other things.
    """
    outline = size[0] * size[1]
    lowest = HIGH * size[2] if small else 0.0
    tops, hollows = [], []
    for surface in levels_of(links):
        share = surface.size[0] * surface.size[1] / outline
        if surface.within and share >= HOLLOW_SHARE:
            hollows.append(surface)
        elif not surface.inner and share >= TOP_SHARE and surface.position[2] >= lowest:
            tops.append(surface)
    return (*tops, *hollows)


def levels_of(links: Sequence[Link]) -> tuple[Surface, ...]:
    """The level areas of a thing that can carry another, the highest first: open tops, shelves and bottoms of hollows.

    Each is the largest upright rectangle that nothing stands on. What is walled on three sides or more and lies below
    its rim is `within` the thing; the bottoms of drawers, which move, are left out.
    """
    solids = _solids(links)
    heights: list[float] = []
    for solid in sorted((s for s in solids if s.face is not None), key=lambda s: -s.high):
        if solid.high > 0.0 and all(abs(solid.high - height) > SAME_LEVEL for height in heights):
            heights.append(solid.high)
    return tuple(surface for height in heights for surface in _at_height(solids, height))


def _solids(links: Sequence[Link]) -> list[_Solid]:
    return [_solid(shape, link.joint is None) for link in links for shape in link.shapes if shape.collide]


def _solid(shape: Shape, fixed: bool) -> _Solid:
    corners = corners_of(shape)
    low, high = float(corners[:, 2].min()), float(corners[:, 2].max())
    face = MultiPoint(corners[corners[:, 2] > high - 1e-4][:, :2]).convex_hull
    outline = MultiPoint(corners[:, :2]).convex_hull
    if not isinstance(face, Polygon) or face.area < NARROWEST**2 / 4 or shape.kind not in ("box", "cylinder", "hull"):
        return _Solid(outline, low, high, None, fixed)
    return _Solid(outline, low, high, face, fixed)


def _at_height(solids: Sequence[_Solid], height: float) -> Iterator[Surface]:
    level = [s for s in solids if s.face is not None and abs(s.high - height) <= SAME_LEVEL]
    faces = [s.face for s in level]
    standing = [s.outline for s in solids if s.high > height + SAME_LEVEL and s.low < height + CLEAR]
    free = (
        shapely.union_all(faces)
        .buffer(0.001, join_style="mitre")
        .buffer(-0.001, join_style="mitre")
        .difference(shapely.union_all(standing))
    )
    area = _largest_rectangle(free)
    if area is None:
        return
    low, high = area[:2], area[2:]
    rectangle = shapely.box(*low, *high)
    over = [s.low - height for s in solids if s.low >= height + CLEAR and s.outline.intersection(rectangle).area > 1e-4]
    headroom = min(over, default=None)
    if headroom is not None and headroom < NARROWEST:
        return
    walled = _walls(solids, height, rectangle) >= 3
    if walled and not all(s.fixed for s in level):
        return
    yield Surface(
        name=f"level at {height:.2f} m",
        position=(round((low[0] + high[0]) / 2, 4), round((low[1] + high[1]) / 2, 4), height),
        size=(round(high[0] - low[0], 4), round(high[1] - low[1], 4)),
        headroom=None if headroom is None else round(headroom, 4),
        round=_is_round(free),
        within=walled,
    )


def _walls(solids: Sequence[_Solid], height: float, area: Polygon) -> int:
    """How many sides of an area are walled."""
    x0, y0, x1, y1 = area.bounds
    reach = max(_EDGE, 0.3 * max(x1 - x0, y1 - y0))
    rising = [s.outline for s in solids if s.high > height + DEPTH and s.low < height + 5 * DEPTH]
    walls = shapely.union_all(rising) if rising else Polygon()
    sides = (
        (shapely.box(x0 - reach, y0, x0, y1), y1 - y0, 1),
        (shapely.box(x1, y0, x1 + reach, y1), y1 - y0, 1),
        (shapely.box(x0, y0 - reach, x1, y0), x1 - x0, 0),
        (shapely.box(x0, y1, x1, y1 + reach), x1 - x0, 0),
    )
    return sum(_length(strip.intersection(walls), axis) > WALLED * length for strip, length, axis in sides)


def _length(found: BaseGeometry, axis: int) -> float:
    """How long what is found is along an axis, as seen across it [m]."""
    spans = sorted((part.bounds[axis], part.bounds[axis + 2]) for part in getattr(found, "geoms", [found]) if part.area)
    total, end = 0.0, -np.inf
    for start, stop in spans:
        total += max(0.0, stop - max(start, end))
        end = max(end, stop)
    return float(total)


def _is_round(free: BaseGeometry) -> bool:
    """Whether an area fills its box as an ellipse does."""
    x0, y0, x1, y1 = free.bounds
    box = (x1 - x0) * (y1 - y0)
    return bool(box > 0.0 and abs(free.area / box - np.pi / 4) < 0.02 and abs((x1 - x0) - (y1 - y0)) < 0.02 * (x1 - x0))


def _largest_rectangle(free: BaseGeometry) -> tuple[float, float, float, float] | None:
    """The largest upright rectangle within an area, or the box round a disc, as x0, y0, x1, y1 [m]; None if narrow."""
    if free.area < NARROWEST**2:
        return None
    x0, y0, x1, y1 = free.bounds
    if _is_round(free):
        return (x0, y0, x1, y1)
    if free.area > (1.0 - 1e-9) * (x1 - x0) * (y1 - y0):
        return (x0, y0, x1, y1) if min(x1 - x0, y1 - y0) >= NARROWEST else None
    xs, ys = np.linspace(x0, x1, _CELLS + 1), np.linspace(y0, y1, _CELLS + 1)
    (west, south), (east, north) = np.meshgrid(xs[:-1], ys[:-1]), np.meshgrid(xs[1:], ys[1:])
    cells = shapely.box(west.ravel(), south.ravel(), east.ravel(), north.ravel())
    wide = free.buffer(1e-4, join_style="mitre")
    shapely.prepare(wide)
    inside = shapely.covers(wide, cells).reshape(_CELLS, _CELLS)
    if not inside.any():
        return None
    row, rows, column, columns = _most_cells(inside, (x1 - x0) / _CELLS, (y1 - y0) / _CELLS)
    found = (float(xs[column]), float(ys[row]), float(xs[column + columns]), float(ys[row + rows]))
    return found if min(found[2] - found[0], found[3] - found[1]) >= NARROWEST else None


def _most_cells(inside: NDArray[np.bool_], width: float, height: float) -> tuple[int, int, int, int]:
    """First row, rows, first column and columns of the largest rectangle of cells that are inside.

    Of several as large it is the one whose first row, then rows, then first column is the greatest.
    """
    largest, best = 0.0, (0, 0, 0, 0)
    run = np.zeros(inside.shape[1], dtype=int)
    for row in range(inside.shape[0]):
        run = np.where(inside[row], run + 1, 0)
        stack: list[tuple[int, int]] = []
        for column, tall in enumerate([*run.tolist(), 0]):
            start = column
            while stack and stack[-1][1] >= tall:
                start, rows = stack.pop()
                area = rows * height * (column - start) * width
                if area >= largest:
                    found = (row - rows + 1, rows, start, column - start)
                    largest, best = area, found if area > largest else max(best, found)
            stack.append((start, tall))
    return best


def room_under(links: Sequence[Link], height: float) -> tuple[float, float] | None:
    """Depth and width of the largest place on the floor under a thing for what is so high [m]; None for none."""
    solids = _solids(links)
    if not solids:  # a rug is only seen
        return None
    low = [s.outline for s in solids if s.low < height]
    over = shapely.union_all([s.outline for s in solids if s.low >= height])
    closed = over.buffer(_SLATS, join_style="mitre").buffer(-_SLATS, join_style="mitre")
    area = _largest_rectangle(closed.difference(shapely.union_all(low)))
    return None if area is None else (area[2] - area[0], area[3] - area[1])
