"""What a robot is to do in a room: four kinds of goals, each with what is nearer to it and what has reached it."""

from abc import ABC, abstractmethod

import numpy as np

from thinkblox.sim.environment.asking_for import Carrying, Moving
from thinkblox.sim.environment.model_index import Array, ModelIndex

AT_HAND = 0.6
"""An object that is no farther from a robot's middle, seen from above, is within its reach [m]."""
TOUCHING = 0.05
"""How near a tool must come to what it is to reach [m]."""
OPEN = 0.6
"""Share of its range to which a door or drawer must be opened."""
ON, STILL = 0.03, 0.05
"""What stands on a surface is no higher over it [m], and moves no faster [m/s]."""


class RobotGoal(ABC):
    """What is to be done with one object.

    Attributes:
        id: of the object.
    """

    def __init__(self, index: ModelIndex, id: str) -> None:
        self._index, self.id = index, id

    @abstractmethod
    def nearness(self) -> float:
        """How near the goal is: 1 is there, 0 is infinitely far."""

    @abstractmethod
    def reached(self) -> bool:
        """Whether it is done."""

    @abstractmethod
    def says(self) -> str:
        """What is to be done, in words."""

    def point(self) -> Array:
        """Where the target is [m]."""
        return self._index.middle(self.id)

    def quat(self) -> Array:
        """How it is turned, wxyz."""
        return self._index.quat(self._body)

    def second(self) -> Array:
        """What else is to be known: where the object is to be brought [m], or how far it is open (share, 0, 0)."""
        return np.zeros(3)

    @property
    def _body(self) -> str:
        return next(item.name for item in self._index.room.inventory.objects if item.id == self.id)

    def _tool_near(self, scale: float) -> float:
        return _near(self._index.distance(self.id, self._index.tool), scale)


class ReachGoal(RobotGoal):
    """The tool is to come to an object."""

    def nearness(self) -> float:
        """By the distance from the tool to the object."""
        return self._tool_near(0.3)

    def reached(self) -> bool:
        """The tool is at the object."""
        return self._index.distance(self.id, self._index.tool) <= TOUCHING

    def says(self) -> str:
        """What is to be done, in words."""
        return f"reach {self.id}"


class DriveGoal(RobotGoal):
    """The robot is to come to where an object is within its reach."""

    def _away(self) -> float:
        x, y, _ = self._index.pose
        return self._index.distance(self.id, np.array([x, y, 0.0]), flat=True)

    def nearness(self) -> float:
        """By the distance from the robot to the object, seen from above."""
        return _near(self._away() - AT_HAND, 1.0)

    def reached(self) -> bool:
        """The object is at hand."""
        return self._away() <= AT_HAND

    def says(self) -> str:
        """What is to be done, in words."""
        return f"drive to {self.id}"


class OpenGoal(RobotGoal):
    """A door or drawer is to be opened.

    Attributes:
        moving: which.
        parts: its geoms that collide.
    """

    def __init__(self, index: ModelIndex, moving: Moving) -> None:
        super().__init__(index, moving.item.id)
        self.moving = moving
        joint = index.model.joint(moving.body.name)
        self._at, (_, self._upper) = int(joint.qposadr[0]), joint.range
        body = int(index.model.body(moving.body.name).id)
        self.parts = np.flatnonzero((index.model.geom_bodyid == body) & (index.model.geom_contype > 0))

    @property
    def share(self) -> float:
        """How far it is open, of its range."""
        return float(self._index.data.qpos[self._at] / self._upper)

    def nearness(self) -> float:
        """Half by the distance from the tool to the door or drawer, half by how far it is open."""
        away = float(np.linalg.norm(self._index.tool - self.point()))
        return 0.5 * _near(away, 0.5) + 0.5 * float(np.clip(self.share / OPEN, 0.0, 1.0))

    def reached(self) -> bool:
        """It is open as far as must be."""
        return self.share >= OPEN

    def point(self) -> Array:
        """The middle of what opens [m]."""
        return np.asarray(self._index.data.geom_xpos[self.parts].mean(axis=0))

    def second(self) -> Array:
        """How far it is open, of its range."""
        return np.array([self.share, 0.0, 0.0])

    def says(self) -> str:
        """What is to be done, in words."""
        return f"open {self.moving.name}"

    @property
    def _body(self) -> str:
        return self.moving.body.name


class CarryGoal(RobotGoal):
    """A small object is to be brought to a surface, and left there."""

    def __init__(self, index: ModelIndex, id: str, carrying: Carrying) -> None:
        super().__init__(index, id)
        self.carrying = carrying

    def destination(self) -> Array:
        """The middle of the surface [m]."""
        local = np.asarray(self.carrying.surface.position)
        body = self._index.data.body(self.carrying.item.name)
        return np.asarray(body.xpos + body.xmat.reshape(3, 3) @ local)

    def nearness(self) -> float:
        """By the distances from the tool to the object, and from the object to the surface."""
        away = float(np.linalg.norm(self.destination() - self._foot()))
        return 0.4 * self._tool_near(0.3) + 0.6 * _near(0.0 if self._over() else away, 1.0)

    def reached(self) -> bool:
        """It stands on the surface, still, and the robot has let go."""
        return self._over() and self._index.speed(self.id) <= STILL and not self._index.touched_by_robot(self.id)

    def second(self) -> Array:
        """Where it is to be brought [m]."""
        return self.destination()

    def says(self) -> str:
        """What is to be done, in words."""
        return f"carry {self.id} to {self.carrying.name}"

    def _foot(self) -> Array:
        return np.array(self._index.data.body(self._body).xpos)

    def _over(self) -> bool:
        body = self._index.data.body(self.carrying.item.name)
        local = (self._foot() - body.xpos) @ body.xmat.reshape(3, 3) - np.asarray(self.carrying.surface.position)
        half = np.asarray(self.carrying.surface.size) / 2
        share = np.abs(local[:2]) / half
        within = float(np.hypot(*share)) <= 1.0 if self.carrying.surface.round else bool((share <= 1.0).all())
        return within and abs(float(local[2])) <= ON


def _near(distance: float, scale: float) -> float:
    """1 at no distance, a half at `scale`, 0 infinitely far."""
    return scale / (scale + max(distance, 0.0))
