"""Carrying a small thing by its top: a suction cup comes down on it, lifts it over everything, and sets it down."""

import math
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import islice

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Point
from shapely.geometry.base import BaseGeometry

from thinkblox.errors import InputError
from thinkblox.sim.environment.driving import Driver, limited, turn_to
from thinkblox.sim.environment.goals import CarryGoal
from thinkblox.sim.environment.model_index import Array, ModelIndex
from thinkblox.sim.environment.opening import CUP, FIRST, HIGH, LAST, LOW
from thinkblox.sim.environment.places import surface_outline
from thinkblox.sim.environment.reaching import arm_free, places_near
from thinkblox.sim.environment.task import Errand
from thinkblox.sim.environment.ways import way_to_place

BODY = 0.21
"""What is held is at least so far from the base's middle [m]."""
ROOM_TO_SPARE = 0.03
"""Round what is carried [m]."""
TOP = HIGH - 0.01
"""Height at which the tool carries [m]."""
_FLAT, _ROUND = 0.002, 0.008
"""A top is flat where points so far from its middle are level with it [m]."""
_BESIDE = 0.02
"""How far from over its middle of mass a thing is held at most [m]."""
_GRID, _WAYS = 0.06, 12
_PRESS, _GENTLY, _LIFT, _STEPS = 0.06, 0.015, 0.2, 8
"""How fast it comes down, at the end, and rises [m/s], and for how many actions it holds before."""
_LOW = 0.03
"""So near its place it comes down at the end [m]."""
_CALM, _SWINGS = 0.02, 150
"""What is slower swings no more [m/s]; no longer than so many actions are waited for that."""
_STANDS = 0.01
"""What is no higher over a surface may stand on it [m]."""
_SINKS = 0.0002
"""What sinks by less in an action stands [m]."""
_DOWN = np.array([0.0, 0.0, -1.0])
_SOLID = np.array([0, 0, 0, 1, 0, 0], np.uint8)

Speeds = dict[str, float]
Move = Callable[[], Speeds | None]
"""What to do next; None when that is done."""


@dataclass(frozen=True)
class Stand:
    """Where the base's middle is [m], which way it looks [rad], and what its tool comes down to [m]."""

    middle: Array
    yaw: float
    tool: Array


@dataclass(frozen=True)
class Load:
    """A thing as it is carried.

    Attributes:
        grip: the middle of the flat part of its top [m].
        radius: of the upright cylinder round the grip that holds it [m].
        height: of the grip over its foot [m].
    """

    grip: Array
    radius: float
    height: float

    @property
    def held(self) -> float:
        """How far from the base's middle it is carried [m]."""
        return max(FIRST, BODY + self.radius)


class Carrier:
    """Carries the thing of an errand, step by step.

    Raises:
        InputError: it is no robot for that, the thing has no flat top over its middle of mass, or there is no place to
            take it from or to set it down from, or no way between them.
    """

    def __init__(self, errand: Errand, actuators: Sequence[str]) -> None:
        goal = errand.goal
        if not isinstance(goal, CarryGoal) or errand.robot.name != "picker":
            raise InputError("only the task 'carry' with the robot 'picker' is solved by this script")
        self._index, self._actuators, self._errand, self._goal = errand.index, list(actuators), errand, goal
        self._suction, self._foot, self._rests = 0.0, math.inf, 0
        load = load_of(errand.index, goal.id)
        plan = None if load is None else next(_plans(errand, goal, load), None)
        if load is None or plan is None:
            why = "its top is not flat over its middle of mass" if load is None else "there is no place to do it from"
            raise InputError(f"{errand.room.name}: the script cannot {goal.says()}: {why}")
        self._load, (take, put, first, second) = load, plan
        self._moves: deque[Move] = deque([*self._taking(take, first), *self._putting(put, second)])

    def action(self) -> NDArray[np.float64]:
        """What all actuators are given."""
        speeds: Speeds | None = {}
        while self._moves:
            speeds = self._moves[0]()
            if speeds is not None:
                break
            self._moves.popleft()
        given = {"suction": self._suction, **(speeds or {})}
        return np.array([given.get(name, 0.0) for name in self._actuators])

    def _taking(self, stand: Stand, corners: NDArray[np.float64]) -> list[Move]:
        over = min(stand.tool[2] + 0.1, TOP)
        return [
            Drive(self._index, self._actuators, corners), partial(self._turn, stand), partial(self._lift, over),
            partial(self._out, stand, over), partial(self._press, stand), self._hold(_STEPS),
            partial(self._out, stand, TOP), partial(self._in, self._load.held),
        ]  # fmt: skip

    def _putting(self, stand: Stand, corners: NDArray[np.float64]) -> list[Move]:
        return [
            Drive(self._index, self._actuators, corners), partial(self._turn, stand), partial(self._out, stand, TOP),
            self._calm(), partial(self._lower, stand), self._let_go, self._hold(_STEPS, lift=0.03),
            partial(self._out, stand, TOP),
        ]  # fmt: skip

    def _turn(self, stand: Stand) -> Speeds | None:
        aside = turn_to(self._index.pose[2], stand.yaw)
        return None if abs(aside) < 0.01 else {"turn": limited(2.0 * aside, 0.6)}

    def _lift(self, height: float) -> Speeds | None:
        away = height - float(self._index.tool[2])
        return None if abs(away) < 0.005 else {"lift": limited(3.0 * away, _LIFT)}

    def _out(self, stand: Stand, height: float) -> Speeds | None:
        """The tool to over what it comes down to, at a height; up first, then out."""
        away = np.array([*stand.tool[:2], height]) - self._index.tool
        if abs(away[2]) < 0.008 and np.hypot(*away[:2]) < 0.006:
            return None
        level = abs(away[2]) < 0.02
        along, out = self._across(away)
        lift = {"lift": limited(3.0 * float(away[2]), _LIFT)}
        held = {"turn": self._straight(stand)}
        return {**lift, **held, "ahead": limited(2.0 * along, 0.1), "arm": limited(2.0 * out, 0.15)} if level else lift

    def _in(self, held: float) -> Speeds | None:
        x, y, yaw = self._index.pose
        out = float((self._index.tool[:2] - (x, y)) @ (-math.sin(yaw), math.cos(yaw)))
        return None if out < held + 0.005 else {"arm": limited(2.0 * (held - out), 0.15)}

    def _press(self, stand: Stand) -> Speeds | None:
        self._suction = 1.0
        if self._index.touched_by_robot(self._goal.id):
            return None
        return {**self._over(stand), "lift": -_PRESS}

    def _lower(self, stand: Stand) -> Speeds | None:
        """Down until it sinks no more: whoever presses on tips over with the arm reached out."""
        foot = self._index.foot(self._goal.id)
        away = float(stand.tool[2] - self._index.tool[2])
        low = foot - float(self._goal.destination()[2]) < _STANDS
        self._rests = self._rests + 1 if low and self._foot - foot < _SINKS else 0
        self._foot = foot
        if self._rests > 2:
            return None
        return {**self._over(stand), "lift": -_PRESS if away < -_LOW else -_GENTLY}

    def _over(self, stand: Stand) -> Speeds:
        """Keep the tool over what it comes down to."""
        along, out = self._across(stand.tool - self._index.tool)
        return {"ahead": limited(along, 0.05), "arm": limited(out, 0.05), "turn": self._straight(stand)}

    def _hold(self, steps: int, lift: float = 0.0) -> Move:
        left = iter(range(steps))
        return lambda: None if next(left, None) is None else {"lift": lift}

    def _calm(self) -> Move:
        """Wait until what hangs no longer swings."""
        left, lately = iter(range(_SWINGS)), deque([1.0], maxlen=_STEPS)

        def move() -> Speeds | None:
            lately.append(self._index.speed(self._goal.id))
            return None if max(lately) < _CALM or next(left, None) is None else {}

        return move

    def _let_go(self) -> Speeds | None:
        self._suction = 0.0
        return None

    def _straight(self, stand: Stand) -> float:
        return limited(2.0 * turn_to(self._index.pose[2], stand.yaw), 0.4)

    def _across(self, away: Array) -> tuple[float, float]:
        """What of a way is ahead of the base, and what to its left [m]."""
        yaw = self._index.pose[2]
        c, s = math.cos(yaw), math.sin(yaw)
        return float(away[0] * c + away[1] * s), float(away[1] * c - away[0] * s)


class Drive:
    """Driving along a way as a move."""

    def __init__(self, index: ModelIndex, actuators: Sequence[str], corners: NDArray[np.float64]) -> None:
        self._driver = Driver(index, actuators, corners)

    def __call__(self) -> Speeds | None:
        """The speeds of the base; None at the end of the way."""
        ahead, turn = self._driver.speeds()
        return None if self._driver.arrived else {"ahead": ahead, "turn": turn}


def load_of(index: ModelIndex, id: str) -> Load | None:
    """How a thing can be held by its top; None where that is not flat over its middle of mass."""
    low, high = index.corners(id)
    body = index.data.body(index.first_body(id))
    near = np.array([(x, y) for x in (0.0, -_BESIDE, _BESIDE) for y in (0.0, -_BESIDE, _BESIDE)])
    for x, y in body.xipos[:2] + near[np.argsort(np.hypot(*near.T))]:
        tops = [index.top_at(id, x + dx, y + dy) for dx, dy in _AROUND]
        level = all(top is not None and abs(top - tops[0]) < _FLAT for top in tops)  # type: ignore[operator]
        if level and tops[0] is not None and tops[0] > high[2] - 0.01 and tops[0] > body.xipos[2]:
            reach = np.maximum(high[:2] - (x, y), (x, y) - low[:2])
            return Load(np.array([x, y, tops[0]]), float(np.hypot(*reach)), float(tops[0] - low[2]))
    return None


_AROUND = ((0.0, 0.0), (_ROUND, 0.0), (-_ROUND, 0.0), (0.0, _ROUND), (0.0, -_ROUND))


def _plans(
    errand: Errand, goal: CarryGoal, load: Load
) -> Iterator[tuple[Stand, Stand, NDArray[np.float64], NDArray[np.float64]]]:
    """Where to take and to put a thing, with the ways to both."""
    index, places = errand.index, errand.places
    bottom = TOP - CUP - load.height - ROOM_TO_SPARE
    wide = load.held + load.radius + ROOM_TO_SPARE
    floor = shapely.intersection(places.floor, places.floor_under(bottom, wide, but=goal.id))
    taking = _stands(errand, floor, [load.grip + np.array([0.0, 0.0, CUP])], load)
    putting = list(islice(_stands(errand, floor, _spots(errand, goal, load), load), _WAYS))
    for take in islice(taking, _WAYS):
        first = way_to_place(places.floor, index.pose[:2], take.middle)
        for put in putting if first is not None else ():
            second = way_to_place(floor, (float(take.middle[0]), float(take.middle[1])), put.middle)
            if first is not None and second is not None:
                yield take, put, first, second


def _stands(errand: Errand, floor: BaseGeometry, tools: Sequence[Array], load: Load) -> Iterator[Stand]:
    """Where the base can stand so that the tool comes down to one of some places."""
    for tool in tools:
        if not LOW <= tool[2] <= TOP - 0.03:
            continue
        for middle in places_near(floor, Point(tool[:2]), LAST, errand.index.pose[:2]):
            away = tool[:2] - middle
            far = float(np.hypot(*away))
            angle = math.atan2(away[1], away[0])
            clear = far - load.radius - 0.01
            low, high = (arm_free(errand.index, middle, angle, height) for height in (tool[2] + 0.02, TOP))
            if load.held <= far <= LAST - 0.01 and low >= clear and high >= far + CUP:
                yield Stand(middle, angle - math.pi / 2, tool)
                break


def _spots(errand: Errand, goal: CarryGoal, load: Load) -> list[Array]:
    """Where the tool is when a thing stands on the surface, free of others, the nearest to its edge first."""
    placement = errand.room.scene[goal.carrying.item.id]
    outline, height = surface_outline(placement, goal.carrying), float(goal.destination()[2])
    inner = shapely.buffer(outline, -load.radius - ROOM_TO_SPARE)
    inner = inner if not inner.is_empty else shapely.buffer(outline, -min(load.radius, 0.06))
    free = errand.places.free_of(inner, height, height + load.height, load.radius + ROOM_TO_SPARE, but=goal.id)
    if free.is_empty:
        return []
    x0, y0, x1, y1 = free.bounds
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(x0, x1 + _GRID, _GRID), np.arange(y0, y1 + _GRID, _GRID)))
    points = np.column_stack([x, y])[shapely.contains_xy(free, x, y)]
    if not len(points):
        points = shapely.get_coordinates(free.representative_point())
    points = points[np.argsort(shapely.distance(shapely.boundary(outline), shapely.points(points)))]
    top = height + load.height + CUP
    return [np.array([px, py, top]) for px, py in points[:: max(len(points) // 40, 1)]]
