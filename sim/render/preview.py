"""The three-quarter picture of a room, opened like a dolls' house."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from shapely import Polygon, contains_xy, get_coordinates
from shapely.affinity import translate

from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import Camera, Vector, framed
from thinkblox.sim.render.curtains import curtains_at
from thinkblox.sim.render.foreground import coverage, in_the_way
from thinkblox.sim.render.frame import inside_walls
from thinkblox.sim.render.interior import RIM, SLAB, THICKNESS, Shell, add_floor, add_room
from thinkblox.sim.render.lighting import lights
from thinkblox.sim.render.materials import GROUND, linear
from thinkblox.sim.render.picture import Settings, paint
from thinkblox.sim.render.picture_size import check_picture_size
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.soup import Pose, Soup, add_objects
from thinkblox.sim.render.surfels import see
from thinkblox.sim.render.tessellate import Floats

if TYPE_CHECKING:
    from PIL.Image import Image

ELEVATION = 40.0
"""How steeply the camera looks down [degrees]."""


_CLEAR = 0.62
"""How far what stands before the room is seen through."""
_IN_THE_WAY = 0.15
"""What it counts for among what is seen."""
_LOST = 3.0
"""What each thing costs that is not seen at all, since its wall is cut away."""
_ACCENT = 1.1
"""What a wall that stands out adds to all that is seen, as a factor."""
_SPARE = 0.8
"""How far from the room its walls darken the ground that lies in the sun, in heights of the room."""
MARGIN = 0.045
"""Share of the picture left free round the room."""


@dataclass(frozen=True)
class View:
    """A corner to look from: azimuth [degrees], the camera, and which walls are drawn at full height."""

    azimuth: float
    camera: Camera
    standing: tuple[bool, ...]


def render_preview(scene: Scene, *, size: int = 1024, poses: Mapping[str, Pose] | None = None) -> "Image":
    """A picture of the room from above one corner, its near walls cut away, and what stands on them seen through.

    Args:
        scene: what to show.
        size: width and height [pixels].
        poses: poses of asset origins that go before those in the scene, by placement id, as after settling.

    Raises:
        InputError: a size that no picture has.
    """
    from PIL import Image

    check_picture_size(size)
    view = best_view(scene, poses)
    hidden = _hidden(scene, view.standing)
    tracer = Tracer(_soup(scene, view, poses, hidden).triangles())
    settings = Settings(1.0, _backdrop(size))
    light = lights(tracer, _sun(view.azimuth))
    picture = paint(tracer, view.camera, size, light, settings)
    faded = in_the_way(scene, view.standing) - hidden
    if faded:
        owners = [number for number, placement in enumerate(scene.placements) if placement.id in faded]
        share, corners = coverage(tracer, view.camera, size, owners)
        behind = Tracer(_soup(scene, view, poses, hidden | faded).triangles())
        cleared = paint(behind, view.camera, size, light, settings, within=corners)
        share = np.float32(_CLEAR) * share[..., None]
        picture = np.rint(picture * (1 - share) + cleared * share).astype(np.uint8)
    return Image.fromarray(picture)


def best_view(scene: Scene, poses: Mapping[str, Pose] | None = None) -> View:
    """The corner from which most of the room is seen."""
    soup = Soup()
    add_floor(soup, scene.room, scene.surfaces)
    add_objects(soup, scene, poses)
    tracer = Tracer(soup.triangles())
    views = [corner_view(scene.room, azimuth) for azimuth in (225.0, 315.0, 135.0, 45.0)]
    return max(views, key=lambda view: _score(scene, tracer, view))


def corner_view(room: Room, azimuth: float, *, elevation: float = ELEVATION, margin: float = MARGIN) -> View:
    """From above one corner: all of the room with the walls cut away that hide it, whatever stands in it."""
    towards = np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    standing = tuple(bool(np.dot(wall.inward, towards) > 0.05) for wall in room.walls)
    for _ in range(2):
        camera = framed(_outline(room, standing), azimuth=azimuth, elevation=elevation, margin=margin)
        standing = tuple(
            inside and not _hides_floor(room, i, camera) for i, inside in enumerate(inside_walls(room, camera))
        )
    return View(azimuth, camera, standing)


def _hides_floor(room: Room, index: int, camera: Camera) -> bool:
    """Whether a wall, at full height, stands before a part of the floor, as in an L-shaped room."""
    wall, eye = room.walls[index], camera.position
    x, y = (axis.ravel() for axis in np.meshgrid(*(np.linspace(0.02, 0.98, 24) * side for side in room.extent)))
    within = contains_xy(room.polygon, x, y)
    x, y = x[within], y[within]
    normal, along = np.array(wall.inward), np.array(wall.along)
    ground = np.stack([x, y], 1) - wall.start
    before, behind = float((eye[:2] - wall.start) @ normal), ground @ normal
    share = before / np.maximum(before - behind, 1e-9)
    crossing = (ground + (eye[:2] - np.stack([x, y], 1)) * (1 - share)[:, None]) @ along
    hidden = (behind < -0.05) & (crossing > 0) & (crossing < wall.length) & (eye[2] * (1 - share) < room.height)
    return bool(hidden.mean() > 0.01) if len(hidden) else False


def _outline(room: Room, standing: tuple[bool, ...]) -> Vector:
    """Points that the picture must hold."""
    points: list[tuple[float, float, float]] = []
    for wall, stands in zip(room.walls, standing, strict=True):
        top = room.height if stands else RIM
        for along in (-THICKNESS, wall.length + THICKNESS):
            x, y = wall.point(along, -THICKNESS)
            points += [(x, y, -SLAB), (x, y, top)]
    return np.array(points)


def _score(scene: Scene, tracer: Tracer, view: View) -> float:
    """How much is seen from a corner, on a thumbnail: every object counts, and so do fronts, windows and floor."""
    size = 72
    y, x = (axis.ravel().astype(np.float32) + np.float32(0.5) for axis in np.mgrid[0:size, 0:size])
    front = see(tracer, view.camera, x, y, size).front
    owners = np.array([patch.owner for patch in tracer.triangles.patches])[front[front >= 0]]
    pixels = np.bincount(owners + 1, minlength=len(scene.placements) + 1)
    hidden = _hidden(scene, view.standing)
    before = in_the_way(scene, view.standing)
    worth = [
        _IN_THE_WAY if p.id in before else (p.id not in hidden) * _worth(scene, p, view.azimuth)
        for p in scene.placements
    ]
    windows = sum(o.width * o.height for o in scene.room.openings if o.kind == "window" and view.standing[o.wall])
    accent = scene.surfaces.accent_wall
    shown = _ACCENT if accent is not None and view.standing[accent] else 1.0
    seen = (np.sqrt(pixels[1:]) * np.array(worth)).sum() + 4.0 * windows + 0.3 * np.sqrt(pixels[0])
    seen -= _LOST * len(hidden)
    return float(seen * shown)


def _worth(scene: Scene, placement: Placement, azimuth: float) -> float:
    """From 1 where an object's front is seen to 0.1 where its back is."""
    if scene.asset_of(placement).front != "one":
        return 0.6
    away = np.radians(placement.yaw - azimuth)
    return float(0.55 + 0.45 * np.cos(away))


def _soup(scene: Scene, view: View, poses: Mapping[str, Pose] | None, hidden: Collection[str]) -> Soup:
    soup = Soup()
    shell = Shell(view.standing, _shadowed(scene.room, _sun(view.azimuth)), curtains=curtains_at(scene))
    add_room(soup, scene.room, scene.surfaces, shell)
    add_objects(soup, scene, poses, hidden=hidden)
    return soup


def _shadowed(room: Room, sun: Floats) -> Polygon:
    """The ground that a room takes light from, with some to spare; beyond, it is as bright as its backdrop."""
    far, spare = room.height / float(sun[2]), _SPARE * room.height
    falls = translate(room.polygon.buffer(spare / 2), -far * float(sun[0]), -far * float(sun[1]))
    return Polygon(get_coordinates(room.polygon.buffer(spare).union(falls).convex_hull))


def _hidden(scene: Scene, standing: tuple[bool, ...]) -> set[str]:
    """What hangs on walls that are cut away, and what stands on that: it would float before the view."""
    cut = {wall.name for wall, stands in zip(scene.room.walls, standing, strict=True) if not stands}
    hidden: set[str] = set()
    for placement in _by_support(scene):
        hangs = scene.asset_of(placement).mount == "wall" and placement.support in cut
        if hangs or placement.support in hidden:
            hidden.add(placement.id)
    return hidden


def _by_support(scene: Scene) -> list[Placement]:
    return sorted(scene.placements, key=lambda p: p.position[2])


def _sun(azimuth: float) -> Floats:
    """A sun behind the viewer's left shoulder, so that the two far walls differ."""
    turn, high = np.radians(azimuth - 21.0), np.radians(50.0)
    return np.array([np.cos(high) * np.cos(turn), np.cos(high) * np.sin(turn), np.sin(high)], np.float32)


def _backdrop(size: int) -> Floats:
    """A plain ground that darkens gently towards the corners (size, size, 3)."""
    across = np.linspace(-1, 1, size, dtype=np.float32)
    far = across[:, None] ** 2 + across[None, :] ** 2
    colour = np.array(linear(GROUND), np.float32)
    backdrop: Floats = colour * (1 - np.float32(0.07) * far)[..., None]
    return backdrop
