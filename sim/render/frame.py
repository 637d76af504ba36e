"""One cast of a scene: colour, depth and object numbers in the same pixels."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from shapely import MultiPoint

from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.interior import Shell, add_room
from thinkblox.sim.render.lighting import Irradiance, lights
from thinkblox.sim.render.materials import GROUND, linear
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.shading import Shader, tone_mapped
from thinkblox.sim.render.soup import ROOM, Pose, Soup, add_objects
from thinkblox.sim.render.surfels import Surfels, see
from thinkblox.sim.render.tessellate import Floats, Ints

NOTHING = -2
"""The number of a pixel that shows neither an object (0 and up) nor the room (ROOM)."""


_BESIDE = 0.05
"""What is less far ahead of a camera has no place in its picture [m]."""


@dataclass(frozen=True)
class Frame:
    """What a camera sees.

    Attributes:
        colour: sRGB (size, size, 3).
        depth: distance along each pixel's ray [m], infinite where it leaves the scene (size, size).
        ids: index into `names`, ROOM for floor and walls, NOTHING beyond them (size, size).
        names: ids of the scene's placements, in their order.
    """

    colour: NDArray[np.uint8]
    depth: Floats
    ids: Ints
    names: tuple[str, ...]


def cast(
    scene: Scene,
    camera: Camera,
    *,
    size: int = 448,
    poses: Mapping[str, Pose] | None = None,
    standing: tuple[bool, ...] | None = None,
) -> Frame:
    """Colour, depth and ids of a scene by one ray a pixel, evenly lit.

    Args:
        scene: what to show.
        camera: where from.
        size: width and height [pixels].
        poses: poses that go before those in the scene, by placement id.
        standing: which walls are drawn at full height; those that the camera sees from inside, when None.
    """
    soup = Soup()
    upright = inside_walls(scene.room, camera) if standing is None else standing
    shell = Shell(upright)
    add_room(soup, scene.room, scene.surfaces, shell)
    add_objects(soup, scene, poses)
    tracer = Tracer(soup.triangles())
    there = _covered(tracer.triangles.vertices, camera, size)
    y, x = (axis.astype(np.float32) + np.float32(0.5) for axis in np.nonzero(there))
    points = see(tracer, camera, x, y, size)
    owners = np.array([*(p.owner for p in tracer.triangles.patches), NOTHING], np.int32)
    behind = np.rint(tone_mapped(np.array([linear(GROUND)], np.float32)) * 255).astype(np.uint8)
    colour = np.full((size, size, 3), behind, np.uint8)
    depth, ids = np.full((size, size), np.inf, np.float32), np.full((size, size), NOTHING, np.int32)
    colour[there] = _evenly_lit(tracer, camera, points, size)
    depth[there] = np.where(points.patch < 0, np.float32(np.inf), points.distance)
    ids[there] = owners[points.front]
    return Frame(colour, depth, ids, tuple(p.id for p in scene.placements))


def _covered(vertices: Floats, camera: Camera, size: int) -> NDArray[np.bool_]:
    """The pixels within the outline of all there is (size, size); all of them where some of it is beside the camera."""
    from PIL import Image, ImageDraw

    ahead = (vertices.astype(np.float64) - camera.position) @ camera.forward
    if camera.perspective and float(ahead.min()) < _BESIDE:
        return np.ones((size, size), bool)
    outline = MultiPoint(camera.project(vertices.astype(np.float64), size)).convex_hull.buffer(1.0, join_style="mitre")
    sheet = Image.new("1", (size, size))
    ImageDraw.Draw(sheet).polygon([(float(a), float(b)) for a, b in outline.exterior.coords], fill=1)
    return np.asarray(sheet)


def inside_walls(room: Room, camera: Camera) -> tuple[bool, ...]:
    """For each wall, whether the camera sees its inner face; an orthographic camera from above sees none."""
    x, y = float(camera.position[0]), float(camera.position[1])
    return tuple(camera.perspective and wall.coordinates((x, y))[1] > 0.3 for wall in room.walls)


def _evenly_lit(tracer: Tracer, camera: Camera, points: Surfels, size: int) -> NDArray[np.uint8]:
    """Light from above and from the eye, without shadows (n, 3)."""
    light = lights(tracer, np.array([-0.42, 0.46, 1.0], np.float32))
    head = np.clip(-np.einsum("ij,ij->i", points.normal, points.view), 0, 1)[:, None]
    up = np.float32(0.5) + np.float32(0.5) * points.normal[:, 2:]
    sky = np.broadcast_to(np.float32(0.45) + np.float32(0.3) * up + np.float32(0.2) * head, points.normal.shape)
    sun = np.maximum(points.normal @ light.sun, np.float32(0))[:, None] * light.sun_colour * np.float32(0.5)
    wide = 2 * camera.reach / size
    shader = Shader(tracer, light, 0.0 if camera.perspective else wide)
    behind = np.broadcast_to(np.array(linear(GROUND), np.float32), points.normal.shape)
    colour = shader.colours(points, Irradiance(sky, sun), behind, wide if camera.perspective else 0.0)
    return np.asarray(np.rint(tone_mapped(colour) * 255), np.uint8)


__all__ = ["NOTHING", "ROOM", "Frame", "cast", "inside_walls"]
