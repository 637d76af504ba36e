"""Which doors and drawers of furniture an object keeps shut: its own, and those of what stands near it."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import fcl
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.bounds import placed_bounds
from thinkblox.sim.geometry.solid import Array, pose, solid_of
from thinkblox.sim.geometry.sweep import FINEST, Piece, Sweep, Swept, body_of, moving_of, turned_bounds
from thinkblox.sim.geometry.walls import Slab, wall_slabs
from thinkblox.sim.settings import Walking
from thinkblox.verdict import PushedAside, Swing

THICK = 0.3
"""Of the walls, floor and ceiling that doors and drawers meet [m]; more than a step of any."""
FULL = 1.0 - 1e-9
GRAVITY = 9.81
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class _Object:
    """Something that a door can meet: bodies in a frame, that frame in the room, and whether it yields."""

    id: str
    bodies: Sequence[Piece]
    turn: Array
    shift: Array
    yields: bool
    moving: Swept | None = None


@dataclass(frozen=True)
class _Opening:
    """The value to which a door or drawer opens, and the ids of what it pushes aside and of what ends it."""

    value: float
    pushed: tuple[str, ...] = ()
    ends: tuple[str, ...] = ()


class Surroundings:
    """What stands in a room, as the doors and drawers of the next object meet it."""

    def __init__(self, room: Room, walking: Walking) -> None:
        self._walking = walking
        self._shell = _shell(room)
        self._standing: tuple[tuple[Placement, Asset], ...] = ()
        self._rests_on: dict[str, str] = {}
        self._opens = False
        self._objects: dict[int, _Object] = {}
        self._free: dict[tuple[str, str], list[float]] = {}

    def with_objects(self, objects: Iterable[tuple[Placement, Asset]]) -> "Surroundings":
        """These surroundings with more objects in them."""
        more, added = Surroundings.__new__(Surroundings), tuple(objects)
        more._walking, more._shell = self._walking, self._shell
        more._rests_on = self._rests_on | {placement.id: placement.support for placement, _ in added}
        more._standing = (*self._standing, *added)
        more._opens = self._opens or any(asset.made_of[2] for _, asset in added)
        more._objects, more._free = dict(self._objects), {}
        return more

    @cached_property
    def _boxes(self) -> Array:
        """Bounding box of each of those that stand there, shape (n, 2, 3) [m]."""
        return placed_bounds(_bounds([asset for _, asset in self._standing]), [p for p, _ in self._standing])

    @cached_property
    def _reaches(self) -> Array:
        """The same of what their doors and drawers sweep."""
        return placed_bounds(_reaches([asset for _, asset in self._standing]), [p for p, _ in self._standing])

    def swings(self, placement: Placement, asset: Asset) -> tuple[Swing, ...]:
        """The doors and drawers that do not simply open through all of their range because of where an object stands.

        They are its own, and those of others that would open further without it: `Swing.of` tells. What is light and
        free is pushed aside: it is among `Swing.hits`, with its force in `Swing.pushes`, and ends nothing. Walls,
        floor and ceiling end an opening, the openings in them being shut. An object's own body and doors never do, nor
        does what it carries in or on itself, which moves along. Everything else stands as it is, with its own doors and
        drawers shut.

        Args:
            placement: an object of the same id among these is looked past.
            asset: what it places.
        """
        if not (self._opens or asset.made_of[2]):
            return ()
        one = self._object(placement, asset)
        own = self._own(one, placement) if one.moving and one.moving.sweeps else ()
        return (*own, *(() if one.yields else self._others(one, placement)))

    def _number(self, number: int) -> _Object:
        """One of those that stand there, made when it is first met."""
        if number not in self._objects:
            self._objects[number] = self._object(*self._standing[number])
        return self._objects[number]

    def _object(self, placement: Placement, asset: Asset) -> _Object:
        moving, matrix = moving_of(solid_of(asset)), pose(placement)
        light = asset.free and asset.mass < self._walking.movable
        return _Object(placement.id, moving.bodies, matrix[:, :3], matrix[:, 3], light, moving)

    def _own(self, one: _Object, placement: Placement) -> Iterator[Swing]:
        near = self._near(one, {placement.id} | self._carried_by(placement.id))
        for sweep, opening in _openings(one, [*near, *self._shell]):
            if sweep.share(opening.value) < FULL or opening.pushed:
                yield self._swing(one, sweep, opening)

    def _others(self, one: _Object, placement: Placement) -> Iterator[Swing]:
        below = self._chain(placement.support)
        near = (self._number(index) for index in _numbers(_meet(self._reaches, _box(one))))
        for other in (other for other in near if other.id != one.id and other.id not in below):
            for number, (sweep, opening) in enumerate(_openings(other, [one])):
                share = sweep.share(opening.value)
                if share < FULL and share < self._without(other, one.id)[number]:
                    yield self._swing(other, sweep, opening)

    def _swing(self, one: _Object, sweep: Sweep, opening: _Opening) -> Swing:
        return Swing(
            of=one.id,
            link=sweep.link.name,
            opens=round(sweep.share(opening.value), 4),
            hits=(*opening.pushed, *opening.ends),
            pushes=tuple(PushedAside(other=id, force=round(self._force(id), 2)) for id in opening.pushed),
        )

    def _force(self, id: str) -> float:
        """What slides an object with all that it carries [N]; of those that are pushed aside."""
        carried = {id} | self._carried_by(id)
        weights = [asset.mass for placement, asset in self._standing if placement.id in carried]
        grip = next(asset.friction for placement, asset in self._standing if placement.id == id)
        return grip * sum(weights) * GRAVITY

    def _without(self, one: _Object, id: str) -> list[float]:
        """How far the doors and drawers of an object open while another one is not there."""
        past = id if id in self._rests_on else ""
        if (one.id, past) not in self._free:
            near = self._near(one, {one.id, past} | self._carried_by(one.id))
            found = _openings(one, [*near, *self._shell])
            self._free[one.id, past] = [sweep.share(opening.value) for sweep, opening in found]
        return self._free[one.id, past]

    def _near(self, one: _Object, but: set[str]) -> list[_Object]:
        """The objects that its doors and drawers may meet."""
        near = (self._number(index) for index in _numbers(_meet(self._boxes, _reach(one))))
        return [other for other in near if other.id not in but]

    def _carried_by(self, id: str) -> set[str]:
        return {other for other, support in self._rests_on.items() if id in self._chain(support)}

    def _chain(self, id: str) -> list[str]:
        """An object and what is under it, down to the floor."""
        found: list[str] = []
        while id in self._rests_on and id not in found:
            found.append(id)
            id = self._rests_on[id]
        return found


def surroundings(scene: Scene, walking: Walking | None = None) -> Surroundings:
    """The surroundings that a scene is."""
    empty = Surroundings(scene.room, walking or Walking())
    return empty.with_objects((p, scene.asset_of(p)) for p in scene.placements)


def swings(scene: Scene, placement: Placement, asset: Asset, *, walking: Walking | None = None) -> tuple[Swing, ...]:
    """What `Surroundings.swings` finds for one placement in a scene."""
    return surroundings(scene, walking).swings(placement, asset)


def _openings(one: _Object, others: Sequence[_Object]) -> Iterator[tuple[Sweep, _Opening]]:
    """For each door and drawer the value to which it opens among other objects, and what it meets on the way."""
    assert one.moving is not None
    obstacles = [obstacle for other in others for obstacle in _obstacles(one, other)]
    for sweep in one.moving.sweeps:
        yield sweep, _opened(sweep, obstacles)


@dataclass(frozen=True)
class _Obstacle:
    """One convex shape in the frame of what opens."""

    owner: _Object
    body: Piece
    bounds: Array
    turn: Array
    shift: Array

    def touches(self, shapes: Iterable[fcl.CollisionObject]) -> bool:
        """Whether any of some shapes is in it."""
        mine = fcl.CollisionObject(self.body.geometry, fcl.Transform(self.turn, self.shift))
        request = fcl.CollisionRequest()
        return any(fcl.collide(shape, mine, request, fcl.CollisionResult()) for shape in shapes)


def _obstacles(one: _Object, other: _Object) -> Iterator[_Obstacle]:
    """The shapes of another object that are where the doors and drawers of one get to."""
    assert one.moving is not None
    turn, shift = one.turn.T @ other.turn, one.turn.T @ (other.shift - one.shift)
    bounds = turned_bounds(np.array([body.bounds for body in other.bodies]), turn, shift)
    for index in _numbers(_meet(bounds, one.moving.reach)):
        body = other.bodies[index]
        yield _Obstacle(other, body, bounds[index], turn @ body.turn, turn @ body.shift + shift)


def _opened(sweep: Sweep, obstacles: Sequence[_Obstacle]) -> _Opening:
    """How far a door or drawer opens."""
    if not obstacles:
        return _Opening(float(sweep.values[-1]))
    boxes = np.array([obstacle.bounds for obstacle in obstacles])
    near: Mask = np.logical_or.reduce(_meet(sweep.bounds[:, :, None], boxes), axis=1)
    pushed: dict[str, None] = {}
    for step in _numbers(np.logical_or.reduce(near, axis=1)):
        shapes, ends = sweep.put(float(sweep.values[step])), []
        for obstacle in (obstacles[index] for index in _numbers(near[step])):
            if obstacle.owner.id not in pushed and obstacle.touches(shapes):
                if obstacle.owner.yields:
                    pushed[obstacle.owner.id] = None
                else:
                    ends.append(obstacle)
        if ends:
            return _Opening(_end(sweep, step, ends), tuple(pushed), tuple(dict.fromkeys(end.owner.id for end in ends)))
    return _Opening(float(sweep.values[-1]), tuple(pushed))


def _end(sweep: Sweep, step: int, ends: Sequence[_Obstacle]) -> float:
    """The last value before some step at which none of the obstacles that it meets there is met."""
    if step == 0:
        return 0.0
    low, high = float(sweep.values[step - 1]), float(sweep.values[step])
    while sweep.share(high - low) > FINEST:
        middle = (low + high) / 2
        shapes = sweep.put(middle)
        low, high = (low, middle) if any(end.touches(shapes) for end in ends) else (middle, high)
    return low


def _box(one: _Object) -> Array:
    """Bounding box in the room, shape (2, 3) [m]; of what does not collide an empty one."""
    return turned_bounds(one.moving.bounds, one.turn, one.shift) if one.moving and one.bodies else _EMPTY


def _reach(one: _Object) -> Array:
    """Bounding box of what its doors and drawers sweep, in the room, shape (2, 3) [m]; an empty one if it has none."""
    return turned_bounds(one.moving.reach, one.turn, one.shift) if one.moving and one.moving.sweeps else _EMPTY


_EMPTY = np.array([[math.inf] * 3, [-math.inf] * 3])


def _bounds(assets: Sequence[Asset]) -> Array:
    """Bounding box of each asset in its own frame, shape (n, 2, 3) [m]; of what does not collide an empty one."""
    solids = [solid_of(asset) if asset.collides else None for asset in assets]
    return np.array([_EMPTY if solid is None else (solid.low, solid.high) for solid in solids]).reshape(-1, 2, 3)


def _reaches(assets: Sequence[Asset]) -> Array:
    """Bounding box of what each asset's doors and drawers sweep in its own frame, shape (n, 2, 3) [m]."""
    reaches = [moving_of(solid_of(asset)).reach if asset.made_of[2] else _EMPTY for asset in assets]
    return np.array(reaches).reshape(-1, 2, 3)


def _meet(boxes: Array, others: Array) -> Mask:
    """Which bounding boxes overlap, shape (..., 2, 3) each, broadcast."""
    apart = (boxes[..., 0, :] >= others[..., 1, :]) | (boxes[..., 1, :] <= others[..., 0, :])
    return np.asarray(~apart.any(axis=-1))


def _numbers(chosen: Mask) -> list[int]:
    return [int(number) for number in np.flatnonzero(chosen)]


@lru_cache(maxsize=64)
def _shell(room: Room) -> tuple[_Object, ...]:
    """Walls without their openings, floor and ceiling."""
    x0, y0, x1, y1 = room.polygon.bounds
    middle, across = ((x0 + x1) / 2, (y0 + y1) / 2), (x1 - x0 + 2 * THICK, y1 - y0 + 2 * THICK, THICK)
    slabs = [
        *wall_slabs(structs.replace(room, openings=()), THICK),
        Slab(name="floor", position=(*middle, -THICK / 2), size=across, yaw=0.0),
        Slab(name="ceiling", position=(*middle, room.height + THICK / 2), size=across, yaw=0.0),
    ]
    return tuple(_Object(slab.name, [_body(slab)], np.eye(3), np.zeros(3), yields=False) for slab in slabs)


def _body(slab: Slab) -> Piece:
    half = math.radians(slab.yaw) / 2
    quat = (math.cos(half), 0.0, 0.0, math.sin(half))
    return body_of(Shape(kind="box", size=slab.size, position=slab.position, quat_wxyz=quat))
