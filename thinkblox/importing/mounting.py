"""What a thing is placed on, read off the geometry where its layout does not say."""

from collections.abc import Sequence

import numpy as np

from thinkblox.asset import Mount
from thinkblox.importing.body import Body
from thinkblox.importing.frames import Array
from thinkblox.importing.usual import is_rug
from thinkblox.room import Room

TOUCHING = 0.02
"""A base this near the floor or another's top stands on it; a top this near the ceiling hangs from it [m]."""
NEAR_WALL = 0.03
"""What comes this near to a wall, and touches nothing else, hangs on it [m]; Holodeck leaves 0.01."""


def mounts_of(room: Room, bodies: Sequence[Body]) -> list[Mount]:
    """The mount of each body; what touches nothing is said to stand on the floor, so that it is found to float."""
    spans = [[np.array([piece.min(axis=0), piece.max(axis=0)]) for piece in body.in_room] for body in bodies]
    return [body.item.mount or _mount(room, body, i, bodies, spans) for i, body in enumerate(bodies)]


def _mount(room: Room, body: Body, index: int, bodies: Sequence[Body], spans: Sequence[list[Array]]) -> Mount:
    base = body.position[2]
    if base <= TOUCHING:
        return "floor"
    mine = np.array([np.min([s[0] for s in spans[index]], axis=0), np.max([s[1] for s in spans[index]], axis=0)])
    for other, theirs in enumerate(spans):
        carries = other != index and not is_rug(bodies[other].item.kind, bodies[other].size[2])
        if carries and any(_rests_on(mine, span) for span in theirs):
            return "surface"
    if abs(room.height - base - body.size[2]) <= TOUCHING:
        return "ceiling"
    return "wall" if _touches_wall(room, np.vstack(body.in_room)) else "floor"


def _rests_on(mine: Array, theirs: Array) -> bool:
    level = abs(float(mine[0, 2] - theirs[1, 2])) <= TOUCHING
    return level and all(mine[0, k] < theirs[1, k] and theirs[0, k] < mine[1, k] for k in (0, 1))


def _touches_wall(room: Room, points: Array) -> bool:
    for wall in room.walls:
        local = (points[:, :2] - np.asarray(wall.start)) @ np.array([wall.along, wall.inward]).T
        near = np.abs(local[:, 1]) <= NEAR_WALL
        if (near & (local[:, 0] >= 0.0) & (local[:, 0] <= wall.length)).any():
            return True
    return False
