"""Where a room is looked at from, and lit: cameras at eye height in its corners, over it and beside it."""

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Point

from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.value import Quat, Vec3

EYE = 1.6
"""Height of eyes [m]."""
AZIMUTH, ELEVATION = 125.0, -40.0
"""Where a viewer looks to at first [degrees]."""
_FOVY = 45.0
_INSIDE = 75.0
"""Vertical fields of view, from outside and from within [degrees]."""
_LOOKED_AT = 0.9
"""Height of what the cameras in the corners look at [m]."""
_NEAREST, _STEP, _ABOUT, _CLEAR = 0.15, 0.1, 0.1, 0.8
"""How cameras are put into corners: from how near, in which steps, how far from things, and how far they see [m]."""
_LIGHT_AREA, _MOST_LIGHTS = 9.0, 4
"""Floor that one light is for [m2]; viewers draw few lights."""


@dataclass(frozen=True)
class RoomCamera:
    """A camera that looks along its -z, with y up, in the room.

    Attributes:
        fovy: vertical field of view [degrees].
    """

    name: str
    position: Vec3
    quat_wxyz: Quat
    fovy: float


def middle_of(room: Room) -> Vec3:
    """What a viewer turns about [m]."""
    width, depth = room.extent
    return (width / 2, depth / 2, room.height / 3)


def cameras_of(scene: Scene) -> tuple[RoomCamera, ...]:
    """Cameras from outside ("overview"), from straight above ("top"), and within ("corner_1", "corner_2", ...)."""
    return (_overview(scene.room), _top(scene.room), *_corners(scene))


def lights_of(room: Room) -> tuple[Vec3, ...]:
    """Where lights hang under the ceiling [m], spread over the floor."""
    width, depth = room.extent
    number = min(max(math.ceil(room.polygon.area / _LIGHT_AREA), 1), _MOST_LIGHTS)
    columns, rows = {1: (1, 1), 2: (2, 1), 3: (3, 1), 4: (2, 2)}[number]
    if depth > width:
        columns, rows = rows, columns
    height = room.height - 0.1
    grid = [((i + 0.5) * width / columns, (j + 0.5) * depth / rows) for i in range(columns) for j in range(rows)]
    within = [place for place in grid if room.polygon.contains(Point(place))]
    x, y = shapely.get_coordinates(room.polygon.representative_point())[0]
    return tuple((float(px), float(py), height) for px, py in within or [(x, y)])


def _overview(room: Room) -> RoomCamera:
    extent = math.hypot(*room.extent, room.height)
    turn, tilt = math.radians(AZIMUTH), math.radians(ELEVATION)
    ahead = np.array([math.cos(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), math.sin(tilt)])
    place = np.array(middle_of(room)) - 1.5 * extent * ahead
    return RoomCamera("overview", _vec3(place), _looking(ahead), _FOVY)


def _top(room: Room) -> RoomCamera:
    width, depth = room.extent
    away = 1.1 * max(width, depth) / 2 / math.tan(math.radians(_FOVY / 2))
    return RoomCamera("top", (width / 2, depth / 2, room.height + away), (1.0, 0.0, 0.0, 0.0), _FOVY)


def _corners(scene: Scene) -> list[RoomCamera]:
    """One in each corner that points out of the room, further in where something stands there."""
    room, found = scene.room, list[RoomCamera]()
    target = room.polygon.centroid
    target = target if room.polygon.contains(target) else room.polygon.representative_point()
    for before, wall in zip((room.walls[-1], *room.walls), room.walls, strict=False):
        (ax, ay), (bx, by) = before.along, wall.along
        if ax * by - ay * bx < 1e-6:
            continue
        inward = np.add(before.inward, wall.inward)
        place = _free_place(scene, np.array(wall.start), inward / np.linalg.norm(inward), target)
        ahead = np.array([target.x, target.y, min(_LOOKED_AT, place[2])]) - place
        if np.linalg.norm(ahead) > 1e-3:
            camera = RoomCamera(f"corner_{len(found) + 1}", place, _looking(ahead / np.linalg.norm(ahead)), _INSIDE)
            found.append(camera)
    return found


def _free_place(scene: Scene, corner: np.ndarray, inward: np.ndarray, target: Point) -> Vec3:
    """A place near a corner that is in nothing and close before nothing on the way to what is looked at.

    It is close under the ceiling where there is none at eye height.
    """
    room = scene.room
    reach = math.hypot(*room.extent) / 3
    for height in (min(EYE, room.height - 0.2), room.height - 0.1):
        tall = [
            placement.footprint.buffer(_ABOUT)
            for placement in scene.placements
            if placement.position[2] - _ABOUT < height < placement.top + _ABOUT
        ]
        for away in np.arange(_NEAREST, reach, _STEP):
            x, y = corner + float(away) * inward
            ahead = np.array([target.x - x, target.y - y])
            near = np.array([x, y]) + ahead * min(_CLEAR / max(float(np.linalg.norm(ahead)), 1e-6), 1.0)
            view = LineString(np.array([(x, y), near]))
            if room.polygon.contains(Point(x, y)) and not any(area.intersects(view) for area in tall):
                return (float(x), float(y), height)
    x, y = corner + _NEAREST * inward
    return (float(x), float(y), room.height - 0.1)


def _looking(ahead: np.ndarray) -> Quat:
    """The orientation of a camera that looks along a unit vector, its right side level."""
    right = np.cross(ahead, (0.0, 0.0, 1.0))
    right = right / np.linalg.norm(right)
    x, y, z = right, np.cross(right, ahead), -ahead
    w = math.sqrt(max(1.0 + x[0] + y[1] + z[2], 0.0)) / 2
    if w > 1e-3:
        return (w, float(y[2] - z[1]) / (4 * w), float(z[0] - x[2]) / (4 * w), float(x[1] - y[0]) / (4 * w))
    # A half turn: about the axis that the matrix leaves as it is.
    i = int(np.argmax([x[0], y[1], z[2]]))
    matrix = np.column_stack([x, y, z])
    axis = (matrix[:, i] + np.eye(3)[i]) / 2
    axis = axis / np.linalg.norm(axis)
    return (0.0, float(axis[0]), float(axis[1]), float(axis[2]))


def _vec3(values: np.ndarray) -> Vec3:
    x, y, z = map(float, values)
    return (x, y, z)
