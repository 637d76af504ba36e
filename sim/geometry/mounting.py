"""Whether something fixed touches what it is fixed to, and which way round."""

import numpy as np

from thinkblox.scene.asset import FRONT_UNKNOWN, Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.sim.geometry.solid import Solid, pose


def hangs(room: Room, placement: Placement, solid: Solid, touching: float) -> bool:
    """Whether a mounted object is within `touching` [m] of the wall or ceiling it names; a rug, of the floor."""
    mount = solid.asset.mount
    if mount == "ceiling":
        return abs(room.height - placement.position[2] - solid.highest) <= touching
    if mount == "wall":
        return _touches_wall(room, placement, solid, touching)
    return abs(placement.position[2] + solid.lowest) <= touching


def faces_its_wall(room: Room, placement: Placement, asset: Asset) -> bool:
    """Whether something mounted has its front to the wall it names; not what has no front, or none that is known."""
    if asset.mount != "wall" or asset.front != "one" or FRONT_UNKNOWN in asset.flags:
        return False
    return any(wall.name == placement.support and wall.is_faced(placement.yaw) for wall in room.walls)


def _touches_wall(room: Room, placement: Placement, solid: Solid, touching: float) -> bool:
    wall = next((w for w in room.walls if w.name == placement.support), None)
    if wall is None:
        return False
    matrix = pose(placement)
    points = solid.points[:, :2] @ matrix[:2, :2].T + matrix[:2, 3]
    coordinates = (points - np.asarray(wall.start)) @ np.array([wall.along, wall.inward]).T
    along, inward = coordinates.T
    gap = inward.min()
    middle = along[inward <= gap + touching].mean()
    return bool(abs(gap) <= touching and 0.0 <= middle <= wall.length)
