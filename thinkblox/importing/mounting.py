"""What a thing is placed on, where its layout does not say: by what it is called, and by the geometry."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.importing.body import ItemBody
from thinkblox.importing.frames import Array
from thinkblox.importing.usual import hangs, is_lamp, is_rug
from thinkblox.scene.asset import Mount
from thinkblox.scene.room import Room

TOUCHING = 0.02
"""A base this near the floor or another's top stands on it; a top this near the ceiling hangs from it [m]."""
NEAR_WALL = 0.03
"""What comes this near to a wall, and touches nothing else, hangs on it [m]; Holodeck leaves 0.01."""

OVERHEAD = 1.2
"""A lamp that touches nothing hangs where it is higher than this [m]."""


def mounts_of(room: Room, bodies: Sequence[ItemBody], *, ceiling: bool = True) -> list[Mount]:
    """The mount of each body; what touches nothing is said to stand on the floor, so that it is found to float.

    Args:
        room: with its walls.
        bodies: all that is in it.
        ceiling: whether the room's height is known, so that what touches its ceiling hangs from it. Where it is not,
            lamps that touch nothing do.
    """
    boxes = _boxes(bodies)
    return [body.item.mount or _mount(room, body, index, boxes, ceiling) for index, body in enumerate(bodies)]


@dataclass(frozen=True)
class _Boxes:
    """Bounds in the room (n, 3) of all pieces that can carry something, and the number of the body of each (n,)."""

    low: Array
    high: Array
    owner: NDArray[np.int64]


def _boxes(bodies: Sequence[ItemBody]) -> _Boxes:
    found = [
        (piece.min(axis=0), piece.max(axis=0), index)
        for index, body in enumerate(bodies)
        if not is_rug(body.item.kind, body.size[2])
        for piece in body.in_room
    ]
    low, high = (np.array([entry[k] for entry in found]).reshape(-1, 3) for k in (0, 1))
    return _Boxes(low, high, np.array([entry[2] for entry in found], dtype=np.int64))


def _mount(room: Room, body: ItemBody, index: int, boxes: _Boxes, ceiling: bool) -> Mount:
    base, points = body.position[2], np.vstack(body.in_room)
    if base <= TOUCHING:
        return "floor"
    if hangs(body.item.kind):
        return "ceiling"
    if _rests_on_another(points, index, boxes):
        return "surface"
    if ceiling and abs(room.height - base - body.size[2]) <= TOUCHING:
        return "ceiling"
    if _touches_wall(room, points):
        return "wall"
    return "ceiling" if not ceiling and is_lamp(body.item.kind) and base >= OVERHEAD else "floor"


def _rests_on_another(points: Array, index: int, boxes: _Boxes) -> bool:
    low, high = points.min(axis=0), points.max(axis=0)
    level = np.abs(boxes.high[:, 2] - low[2]) <= TOUCHING
    beneath = ((boxes.low[:, :2] < high[:2]) & (low[:2] < boxes.high[:, :2])).all(axis=1)
    return bool((level & beneath & (boxes.owner != index)).any())


def _touches_wall(room: Room, points: Array) -> bool:
    for wall in room.walls:
        local = (points[:, :2] - np.asarray(wall.start)) @ np.array([wall.along, wall.inward]).T
        near = np.abs(local[:, 1]) <= NEAR_WALL
        if (near & (local[:, 0] >= 0.0) & (local[:, 0] <= wall.length)).any():
            return True
    return False
