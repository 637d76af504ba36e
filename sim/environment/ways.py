"""Ways over the free floor of a room, for what drives."""

import heapq
import math

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Point
from shapely.geometry.base import BaseGeometry

CELL = 0.05
"""Of the grid on which ways are sought [m]."""
_AT_PLACE = 0.05
"""A way to a place is sought to within this of it [m]."""
_STEPS = [(dx, dy, math.hypot(dx, dy)) for dx in (-1, 0, 1) for dy in (-1, 0, 1) if dx or dy]


def way(floor: BaseGeometry, start: tuple[float, float], goal: BaseGeometry) -> NDArray[np.float64] | None:
    """Corners (n, 2) of a short way from near a start to a place in the goal; None where there is none.

    Args:
        floor: where one may be [m].
        start: where one is; the way begins at the nearest place of the floor.
        goal: where to, a part of the floor.
    """
    if floor.is_empty or goal.is_empty:
        return None
    x0, y0, x1, y1 = floor.bounds
    x, y = (np.arange(low, high + CELL, CELL) for low, high in ((x0, x1), (y0, y1)))
    columns, rows = np.meshgrid(x, y)
    free, there = (np.asarray(shapely.contains_xy(area, columns, rows)) for area in (floor, goal))
    if not free.any():
        return None
    away = np.where(free, np.hypot(columns - start[0], rows - start[1]), np.inf)
    begin = tuple(int(i) for i in np.unravel_index(np.argmin(away), away.shape))
    cells = _search(free, there & free, (begin[0], begin[1]))
    if cells is None:
        return _straight(floor, start, goal)
    points = np.array([start, *((x[column], y[row]) for row, column in cells)])
    return _shortened(floor, points)


def _straight(floor: BaseGeometry, start: tuple[float, float], goal: BaseGeometry) -> NDArray[np.float64] | None:
    """To a goal that is smaller than the grid, where nothing is between."""
    line = shapely.shortest_line(Point(start), goal)
    return shapely.get_coordinates(line) if shapely.covers(shapely.buffer(floor, 0.01), line) else None


def _search(free: NDArray[np.bool_], there: NDArray[np.bool_], begin: tuple[int, int]) -> list[tuple[int, int]] | None:
    """Dijkstra's shortest way over the cells of a grid."""
    best, came = {begin: 0.0}, {begin: begin}
    queue = [(0.0, begin)]
    while queue:
        length, cell = heapq.heappop(queue)
        if length > best[cell]:
            continue
        if there[cell]:
            return _back(came, cell)
        for dy, dx, step in _STEPS:
            other = (cell[0] + dy, cell[1] + dx)
            if not (0 <= other[0] < free.shape[0] and 0 <= other[1] < free.shape[1] and free[other]):
                continue
            if length + step < best.get(other, math.inf) - 1e-9:
                best[other], came[other] = length + step, cell
                heapq.heappush(queue, (length + step, other))
    return None


def _back(came: dict[tuple[int, int], tuple[int, int]], cell: tuple[int, int]) -> list[tuple[int, int]]:
    found = [cell]
    while came[cell] != cell:
        cell = came[cell]
        found.append(cell)
    return found[::-1]


def _shortened(floor: BaseGeometry, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same with every corner left out that can be cut over free floor."""
    shapely.prepare(floor)
    kept, at = [0], 0
    while at < len(points) - 1:
        ahead = len(points) - 1
        while ahead > at + 1 and not shapely.covers(floor, LineString(points[[at, ahead]])):
            ahead -= 1
        kept.append(ahead)
        at = ahead
    return np.asarray(points[kept])


def way_to_place(
    floor: BaseGeometry, start: tuple[float, float], middle: NDArray[np.float64]
) -> NDArray[np.float64] | None:
    """Corners (n, 2) of a way over a floor that ends exactly at a place (2,) [m]; None where there is none."""
    found = way(floor, start, shapely.intersection(floor, Point(middle).buffer(_AT_PLACE)))
    return None if found is None else np.vstack([found, middle])
