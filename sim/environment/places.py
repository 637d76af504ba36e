"""Where in a room a robot can be: the free floor, and free spots on furniture for an arm."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint, Point
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.placement import Placement
from thinkblox.sim.environment.asking_for import Carrying, surfaces
from thinkblox.sim.environment.robot import Robot
from thinkblox.sim.environment.room_source import OpenRoom
from thinkblox.sim.geometry.free_space import FlatPiece, floor_plane, pieces_of

MARGIN = 0.02
"""Between a robot and what it is beside [m]."""
FLAT = 0.008
"""What is no higher is driven over [m]."""
TABLE = (0.3, 1.2)
"""Heights of surfaces that an arm is mounted on [m]."""
_GRID = 0.1
"""Between the places that are tried [m]."""
_SPECK = 0.01
"""Free floor smaller than this is none [m2]."""
_OVER = 0.002
"""Between a surface and the arm over it [m]."""


@dataclass(frozen=True)
class RobotPlace:
    """Where a robot's origin is [m], and which way it looks [rad]."""

    x: float
    y: float
    z: float
    yaw: float


class FreePlaces:
    """Where a robot's middle can be in a room, with everything in it as it was placed.

    Attributes:
        robot: whose places these are.
        floor: where its middle can be on the floor, with a margin.
    """

    def __init__(self, room: OpenRoom, robot: Robot) -> None:
        self._room, self.robot = room, robot
        self._plane = floor_plane(room.scene.room)
        high = robot.height if robot.mobile else math.inf
        around = [p for p in self._pieces if p.high > FLAT and p.low < high]
        self.floor: BaseGeometry = self._clear(room.scene.room.polygon, around)

    @cached_property
    def _pieces(self) -> list[FlatPiece]:
        scene = self._room.scene
        return [
            piece
            for placement in scene.placements
            if scene.asset_of(placement).collides
            for piece in pieces_of(self._plane, placement, scene.asset_of(placement))
        ]

    def _clear(self, outline: BaseGeometry, around: list[FlatPiece]) -> BaseGeometry:
        away = self.robot.radius + MARGIN
        taken = [_hull(piece.corners) for piece in around]
        inner = shapely.buffer(outline, -away)
        return shapely.difference(inner, shapely.buffer(shapely.union_all(taken), away)) if taken else inner

    def outline(self, id: str) -> BaseGeometry:
        """What an object covers of the floor [m]."""
        placement = self._room.scene[id]
        asset = self._room.scene.asset_of(placement)
        return shapely.union_all([_hull(piece.corners) for piece in pieces_of(self._plane, placement, asset)])

    def floor_under(self, bottom: float, wide: float, *, but: str) -> BaseGeometry:
        """Where its middle can be while it carries something so far round it [m] over all that is lower than `bottom`.

        `but` is the id of what is carried.
        """
        inner = shapely.buffer(self._room.scene.room.polygon, -wide)
        high = [piece for piece in self._all_but(but) if piece.high > bottom]
        return shapely.difference(inner, shapely.buffer(shapely.union_all([_hull(p.corners) for p in high]), wide))

    def free_of(self, area: BaseGeometry, low: float, high: float, away: float, *, but: str) -> BaseGeometry:
        """What of an area is so far from everything between two heights [m] but the object `but`."""
        found = [piece for piece in self._all_but(but) if piece.low < high and piece.high > low + FLAT]
        return shapely.difference(area, shapely.buffer(shapely.union_all([_hull(p.corners) for p in found]), away))

    def _all_but(self, id: str) -> list[FlatPiece]:
        scene = self._room.scene
        own = pieces_of(self._plane, scene[id], scene.asset_of(scene[id]))
        mine = {(piece.low, piece.high, piece.corners.tobytes()) for piece in own}
        return [p for p in self._pieces if (p.low, p.high, p.corners.tobytes()) not in mine]

    def floor_before(self, goal: BaseGeometry, within: float) -> BaseGeometry:
        """The parts of the free floor that hang together with a place from which the goal is so near [m]."""
        parts = [part for part in shapely.get_parts(self.floor) if part.area > _SPECK]
        return shapely.union_all([part for part in parts if shapely.dwithin(part, goal, within)])

    def floor_places(self, area: BaseGeometry, rng: np.random.RandomState) -> Iterator[RobotPlace]:
        """Places all over a part of the floor, in any order, looking anywhere."""
        for x, y in _spread(area, rng):
            yield RobotPlace(x, y, self.robot.lift, rng.uniform(-math.pi, math.pi))

    def beside(self, goal: BaseGeometry, within: float, rng: np.random.RandomState) -> Iterator[RobotPlace]:
        """Places on the floor from which the goal is so near [m], looking at it."""
        for x, y in _spread(shapely.intersection(self.floor, shapely.buffer(goal, within)), rng):
            yield RobotPlace(x, y, self.robot.lift, _toward(goal, x, y))

    def on_furniture(self, goal: BaseGeometry, within: float, rng: np.random.RandomState) -> Iterator[RobotPlace]:
        """The same on tables and the like, between what stands there."""
        every = [each for each in surfaces(self._room).values() if each.item.free]
        for each in (every[i] for i in rng.permutation(len(every))):
            placement = self._room.scene[each.item.id]
            height = placement.position[2] + each.surface.position[2]
            if not TABLE[0] <= height <= TABLE[1]:
                continue
            standing = [piece for piece in self._pieces if piece.high > height + FLAT]
            free = self._clear(surface_outline(placement, each), standing)
            for x, y in _spread(shapely.intersection(free, shapely.buffer(goal, within)), rng):
                yield RobotPlace(x, y, height + self.robot.lift + _OVER, _toward(goal, x, y))


def surface_outline(placement: Placement, carrying: Carrying) -> BaseGeometry:
    """The outline of a surface in the room [m]."""
    x, y = carrying.surface.position[:2]
    half = np.asarray(carrying.surface.size) / 2
    if carrying.surface.round:
        turns = np.radians(np.arange(0, 360, 10))
        local = np.column_stack([np.cos(turns), np.sin(turns)]) * half
    else:
        local = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * half
    return shapely.Polygon([placement.to_room((x + float(u), y + float(v))) for u, v in local])


def _hull(corners: NDArray[np.float64]) -> BaseGeometry:
    return MultiPoint(corners).convex_hull


def _spread(area: BaseGeometry, rng: np.random.RandomState) -> Iterator[tuple[float, float]]:
    """Points all over an area, in any order; one at least, where it is not empty."""
    if area.is_empty:
        return
    x0, y0, x1, y1 = area.bounds
    dx, dy = rng.uniform(0.0, _GRID, 2)
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(x0 + dx, x1, _GRID), np.arange(y0 + dy, y1, _GRID)))
    within = shapely.contains_xy(area, x, y)
    points = np.column_stack([x[within], y[within]])
    if not len(points):
        points = shapely.get_coordinates(area.representative_point())
    for i in rng.permutation(len(points)):
        yield float(points[i, 0]), float(points[i, 1])


def _toward(goal: BaseGeometry, x: float, y: float) -> float:
    near = shapely.get_coordinates(shapely.shortest_line(Point(x, y), goal))[-1]
    return math.atan2(float(near[1]) - y, float(near[0]) - x)
