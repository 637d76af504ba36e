"""Where in a compiled model the robot and the things of a room are, and distances between them."""

import math
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.exporters.inventory import InventoryObject
from thinkblox.sim.environment.places import RobotPlace
from thinkblox.sim.environment.robot import PREFIX, Robot
from thinkblox.sim.environment.room_source import OpenRoom

Array = NDArray[np.float64]
FRAME = f"{PREFIX}/"
"""The name of the body that a robot is attached by."""
_PAST = 0.001
_COLLIDING = np.array([0, 0, 0, 1, 0, 0], np.uint8)
"""The group of what collides."""
HIT = 0.0005
"""Deeper than this the robot is in something [m]."""


class ModelIndex:
    """The robot and the things of a room in its compiled model.

    Attributes:
        model, data: of the engine; the data change with every step.
        room, robot: what was put together.
        root: number of the robot's first body.
        joints: numbers of its joints, without the free one.
    """

    def __init__(self, physics: Any, room: OpenRoom, robot: Robot) -> None:
        self.model: mujoco.MjModel = physics.model.ptr
        self.data: mujoco.MjData = physics.data.ptr
        self.room, self.robot = room, robot
        model = self.model
        self.root = int(model.body(FRAME).id)
        mine = [b for b in range(model.nbody) if _above(model, b, self.root)]
        self._robot_geoms = np.isin(model.geom_bodyid, mine)
        self.joints = [
            j
            for j in range(model.njnt)
            if model.jnt_bodyid[j] in mine and model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE
        ]
        free = [j for j in range(model.njnt) if model.jnt_bodyid[j] == self.root and j not in self.joints]
        self._free = int(model.jnt_qposadr[free[0]]) if free else None
        self._tool = None if robot.tool is None else int(model.site(robot.tool).id)
        self._parts = {item.id: self._parts_of(item) for item in room.inventory.objects}

    def _parts_of(self, item: InventoryObject) -> NDArray[np.intp]:
        bodies = [int(self.model.body(body.name).id) for body in item.bodies]
        geoms = np.isin(self.model.geom_bodyid, bodies) & (self.model.geom_contype > 0)
        return np.flatnonzero(geoms)

    def owners(self) -> tuple[tuple[str, ...], NDArray[np.int32]]:
        """What pixels can show, and which of these every geom is a part of: "room", the objects by id, "robot"."""
        names = ("room", *(item.id for item in self.room.inventory.objects), "robot")
        owner = np.zeros(self.model.ngeom, np.int32)
        for number, item in enumerate(self.room.inventory.objects, 1):
            bodies = [int(self.model.body(body.name).id) for body in item.bodies]
            owner[np.isin(self.model.geom_bodyid, bodies)] = number
        owner[self._robot_geoms] = len(names) - 1
        return names, owner

    # The robot.

    def set_rest(self) -> None:
        """Put everything in the room where it rests."""
        for name, values in self.room.rest.items():
            start = int(self.model.joint(name).qposadr[0])
            self.data.qpos[start : start + len(values)] = values

    def set_home(self) -> None:
        """What of the robot's reference pose is beyond a joint's limits is put in the middle of them."""
        for joint in self.joints:
            low, high = self.model.jnt_range[joint]
            at = int(self.model.jnt_qposadr[joint])
            if self.model.jnt_limited[joint] and not low <= self.data.qpos[at] <= high:
                self.data.qpos[at] = (low + high) / 2

    def put_robot(self, place: RobotPlace) -> None:
        """Stand or mount the robot somewhere."""
        position, quat = (place.x, place.y, place.z), (np.cos(place.yaw / 2), 0.0, 0.0, np.sin(place.yaw / 2))
        if self._free is None:
            self.model.body_pos[self.root], self.model.body_quat[self.root] = position, quat
        else:
            self.data.qpos[self._free : self._free + 7] = (*position, *quat)
        self._forward_all()

    def _forward_all(self) -> None:
        """Work out where everything is; what is fixed is passed over where things may sleep, and has been moved."""
        flags = int(self.model.opt.enableflags)
        self.model.opt.enableflags = flags & ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        mujoco.mj_forward(self.model, self.data)
        self.model.opt.enableflags = flags

    def robot_is_clear(self) -> bool:
        """Whether the robot is in nothing but what carries it, nor in itself."""
        for contact in self.data.contact:
            first, second = contact.geom
            if contact.dist < -HIT and (self._robot_geoms[first] or self._robot_geoms[second]):
                return False
        return True

    def touched_by_robot(self, id: str) -> bool:
        """Whether the robot touches an object."""
        return self.robot_touches(set(self._parts[id].tolist()))

    def robot_touches(self, parts: set[int]) -> bool:
        """Whether the robot touches any of these geoms."""
        for contact in self.data.contact:
            first, second = contact.geom.tolist()
            if (self._robot_geoms[first] and second in parts) or (self._robot_geoms[second] and first in parts):
                return True
        return False

    @property
    def pose(self) -> tuple[float, float, float]:
        """Where the robot stands [m], and which way it looks [rad]."""
        x, y, _ = self.data.xpos[self.root]
        ahead = self.data.xmat[self.root]
        return float(x), float(y), float(np.arctan2(ahead[3], ahead[0]))

    @property
    def velocity(self) -> Array:
        """Of the robot's first body in its own frame: ahead, left and up [m/s], and about these axes [rad/s]."""
        found = np.zeros(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, self.root, found, 1)
        return np.concatenate([found[3:], found[:3]])

    @property
    def tool(self) -> Array:
        """Where the robot works: its tool, or its middle where it has none [m]."""
        return np.array(self.data.xpos[self.root] if self._tool is None else self.data.site_xpos[self._tool])

    def from_robot(self, point: Array) -> Array:
        """A point of the room as the robot sees it: ahead, left and up of its origin [m]."""
        return np.asarray((point - self.data.xpos[self.root]) @ self.data.xmat[self.root].reshape(3, 3))

    # The things.

    def middle(self, id: str) -> Array:
        """The middle of an object's parts [m]."""
        low, high = self.box(self._parts[id])
        return np.asarray((low + high) / 2)

    def quat(self, body: str) -> Array:
        """The orientation wxyz of a body."""
        return np.array(self.data.body(body).xquat)

    def distance(self, id: str, point: Array, *, flat: bool = False) -> float:
        """From a point to the nearest box round one of an object's parts, 0 within; seen from above if `flat` [m]."""
        parts, model, data = self._parts[id], self.model, self.data
        turn = data.geom_xmat[parts].reshape(-1, 3, 3)
        middle = data.geom_xpos[parts] + np.einsum("nij,nj->ni", turn, model.geom_aabb[parts, :3])
        away = point - middle
        if flat:
            away[:, 2] = 0.0
        beyond = np.abs(np.einsum("nij,ni->nj", turn, away)) - model.geom_aabb[parts, 3:]
        return float(np.linalg.norm(np.maximum(beyond, 0.0), axis=1).min())

    def box(self, parts: NDArray[np.intp]) -> tuple[Array, Array]:
        """The box round some geoms, along the room's axes [m]."""
        low, high = self._boxes(parts)
        return low.min(0), high.max(0)

    def corners(self, id: str) -> tuple[Array, Array]:
        """The box round an object, along the room's axes [m]."""
        return self.box(self._parts[id])

    def foot(self, id: str) -> float:
        """The height of an object's origin [m]."""
        return float(self.data.body(self.first_body(id)).xpos[2])

    def first_body(self, id: str) -> str:
        """The name of an object's first body."""
        return self._item(id).name

    def top_at(self, id: str, x: float, y: float) -> float | None:
        """The height at which an object is first met from above [m]; None where something else is, or nothing."""
        high = float(self.corners(id)[1][2])
        start = np.array([x, y, high + _PAST])
        away = self.first_hit(start, np.array([0.0, 0.0, -1.0]), set(self._parts[id].tolist()), _COLLIDING)
        return None if away is None else high + _PAST - away

    def first_hit(self, start: Array, along: Array, parts: set[int], groups: NDArray[np.uint8]) -> float | None:
        """How far it is to the first geom of some groups on a line, where that is one of the parts [m]; else None."""
        geom = np.zeros(1, np.int32)
        away = mujoco.mj_ray(self.model, self.data, start, along, groups, 1, self.root, geom)
        return float(away) if int(geom[0]) in parts else None

    def free_way(self, start: Array, along: Array, groups: NDArray[np.uint8]) -> float:
        """How far it is on a line to anything of some groups but the robot [m]; infinite where there is nothing."""
        geom, gone = np.zeros(1, np.int32), 0.0
        while True:
            away = float(mujoco.mj_ray(self.model, self.data, start + gone * along, along, groups, 1, self.root, geom))
            if away < 0.0:
                return math.inf
            gone += away
            if not self._robot_geoms[geom[0]]:
                return gone
            gone += _PAST

    def speed(self, id: str) -> float:
        """How fast an object's first body moves [m/s]."""
        found = np.zeros(6)
        number = self.model.body(self._item(id).name).id
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, number, found, 0)
        return float(np.linalg.norm(found[3:]))

    def _item(self, id: str) -> InventoryObject:
        return next(item for item in self.room.inventory.objects if item.id == id)

    def _boxes(self, parts: NDArray[np.intp]) -> tuple[Array, Array]:
        turn = self.data.geom_xmat[parts].reshape(-1, 3, 3)
        middle = self.data.geom_xpos[parts] + np.einsum("nij,nj->ni", turn, self.model.geom_aabb[parts, :3])
        half = np.einsum("nij,nj->ni", np.abs(turn), self.model.geom_aabb[parts, 3:])
        return middle - half, middle + half


def _above(model: mujoco.MjModel, body: int, root: int) -> bool:
    while body > root:
        body = int(model.body_parentid[body])
    return body == root
