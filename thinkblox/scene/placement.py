"""An asset at a pose in a room."""

import math
from collections.abc import Iterable
from typing import Annotated

from msgspec import Meta
from shapely import Polygon

from thinkblox.checked import CheckedValue, Coordinate, Extent
from thinkblox.value import Vec2, Vec3


class Placement(CheckedValue, frozen=True, kw_only=True):
    """An asset at a pose.

    Attributes:
        id: unique in its scene, "<category>_<n>".
        asset: key into the scene's assets.
        position: centre of the footprint at the object's base, in the room [m].
        yaw: counter-clockwise [degrees]; at 0 the front faces +x.
        size: (along the front axis, across, up) [m].
        support: what it rests on or hangs from: "floor", "ceiling", a wall's name or another placement's id; the scene
            that it is part of derives it.

    Raises:
        InputError: a field out of range, or not a finite number.
    """

    id: Annotated[str, Meta(pattern=r"^[A-Za-z][A-Za-z0-9_.-]*\Z", max_length=120)]
    category: str
    asset: str
    position: tuple[Coordinate, Coordinate, Coordinate]
    yaw: Coordinate
    size: tuple[Extent, Extent, Extent]
    support: str = ""

    @property
    def front(self) -> Vec2:
        """Unit vector its front faces."""
        turn = math.radians(self.yaw)
        return (math.cos(turn), math.sin(turn))

    @property
    def left(self) -> Vec2:
        """Unit vector to its own left, seen facing the way it faces."""
        x, y = self.front
        return (-y, x)

    @property
    def footprint(self) -> Polygon:
        """Its bounding rectangle on the floor."""
        return Polygon(self.corners)

    @property
    def corners(self) -> tuple[Vec2, Vec2, Vec2, Vec2]:
        """Corners of the footprint, counter-clockwise from its right rear [m]."""
        x, y = self.size[0] / 2, self.size[1] / 2
        return (self.to_room((-x, -y)), self.to_room((x, -y)), self.to_room((x, y)), self.to_room((-x, y)))

    @property
    def top(self) -> float:
        """Height of its highest point [m]."""
        return self.position[2] + self.size[2]

    def to_room(self, local: Vec2) -> Vec2:
        """A point of its own frame (x to the front, y to the left) in the room's frame [m]."""
        fx, fy = self.front
        return (self.position[0] + fx * local[0] - fy * local[1], self.position[1] + fy * local[0] + fx * local[1])

    def to_local(self, point: Vec2) -> Vec2:
        """A point of the room in its own frame [m]: the inverse of `to_room`."""
        dx, dy, (fx, fy) = point[0] - self.position[0], point[1] - self.position[1], self.front
        return (dx * fx + dy * fy, dy * fx - dx * fy)


def apart(a: Placement, b: Placement) -> float:
    """Horizontal distance between the circles round two footprints: their own distance is no less [m]."""
    radii = (math.hypot(*a.size[:2]) + math.hypot(*b.size[:2])) / 2
    return math.hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]) - radii


def to_micrometres(position: Iterable[float]) -> Vec3:
    """A position rounded as it is written."""
    x, y, z = (round(float(c), 6) for c in position)
    return (x, y, z)
