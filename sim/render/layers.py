"""A room as layers: each object cast by itself, kept, and put together by depth.

Evenly lit objects throw no shadows, so a picture of many is that of each, the nearest first. What stands where it stood
in the picture before is not cast again.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.asset import Asset
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.frame import NOTHING, ROOM, cast
from thinkblox.sim.render.plan_view import plan_of
from thinkblox.sim.render.preview import corner_view
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.shading import tone_mapped
from thinkblox.sim.render.soup import Soup, pose_of
from thinkblox.sim.render.surfels import Surfels, see_part
from thinkblox.sim.render.tessellate import Floats, Ints
from thinkblox.sim.render.vectors import dot
from thinkblox.value import Vec3

MARGIN = 0.085
"""Share of a picture left free round the room, where the metres are written."""
_ELEVATION = 48.0
_SUN = np.array([-0.42, 0.46, 1.0], np.float32) / np.float32(np.linalg.norm([-0.42, 0.46, 1.0]))
_SUN_COLOUR = np.array([1.10, 1.03, 0.93], np.float32) * np.float32(0.5)


@dataclass(frozen=True, eq=False)
class Viewpoint:
    """Where a picture of a room is taken from.

    Attributes:
        azimuth: where the camera stands, seen from the room [degrees]; None above it.
        camera: the camera; it is the same whatever stands in the room.
        standing: which walls are drawn at full height.
    """

    azimuth: float | None
    camera: Camera
    standing: tuple[bool, ...]


@dataclass(frozen=True)
class Layer:
    """What a camera sees of one object, in the box of pixels from (left, top).

    Attributes:
        colour: sRGB (h, w, 3).
        depth: along each pixel's ray [m], infinite where the object is not (h, w).
        clear: of glass with nothing of the object behind: what it lets through and adds, in parts of 1 (h, w, 2), and
            how far away it is [m].
    """

    left: int
    top: int
    colour: NDArray[np.uint8]
    depth: Floats
    clear: Floats | None = None
    glass: float = 0.0


@dataclass(frozen=True)
class Canvas:
    """A picture in the making.

    Attributes:
        colour: sRGB (size, size, 3).
        depth: along each pixel's ray [m] (size, size).
        ids: index of the object, ROOM, or NOTHING (size, size).
        floor: whether a pixel shows the bare floor (size, size).
    """

    colour: NDArray[np.uint8]
    depth: Floats
    ids: Ints
    floor: NDArray[np.bool_]


@lru_cache(256)
def viewpoint(room: Room, azimuth: float | None) -> Viewpoint:
    """A view of a room from above (None), or from over one of its corners with the near walls cut away."""
    if azimuth is None:
        return Viewpoint(None, plan_of(room, margin=MARGIN), (False,) * len(room.walls))
    view = corner_view(room, azimuth, elevation=_ELEVATION, margin=MARGIN * 0.7)
    return Viewpoint(azimuth, view.camera, view.standing)


def canvas(scene: Scene, view: Viewpoint, size: int) -> Canvas:
    """The room and what stands in it, `size` pixels wide; objects have their numbers in the scene's order.

    Left out is what hangs on a wall that is cut away, and from above what hangs from the ceiling.
    """
    bare = _bare(scene.room, view, size)
    colour, depth, ids = bare.colour.copy(), bare.depth.copy(), bare.ids.copy()
    glass: list[Layer] = []
    cut = {wall.name for wall, stands in zip(scene.room.walls, view.standing, strict=True) if not stands}
    for number, placement in enumerate(scene.placements):
        asset = scene.asset_of(placement)
        if asset.mount == "ceiling" if view.azimuth is None else asset.mount == "wall" and placement.support in cut:
            continue
        layer = _layer(asset, placement.position, placement.yaw, view, size)
        if layer is None:
            continue
        box = _box(layer)
        nearer = layer.depth < depth[box]
        depth[box][nearer] = layer.depth[nearer]
        colour[box][nearer] = layer.colour[nearer]
        ids[box][nearer] = number
        if layer.clear is not None:
            glass.append(layer)
            seen = (layer.clear[..., 0] < 1.0) & (layer.glass < depth[box]) & (ids[box] < 0)
            ids[box][seen] = number
    for layer in glass:
        _look_through(colour, depth, layer)
    return Canvas(colour, depth, ids, bare.floor & (depth == bare.depth))


def _look_through(colour: NDArray[np.uint8], depth: Floats, layer: Layer) -> None:
    """Dim and brighten what is behind the glass of a layer."""
    if layer.clear is None:
        return
    box = _box(layer)
    seen = (layer.clear[..., 0] < 1.0) & (layer.glass < depth[box])
    through, adds = layer.clear[seen, 0], layer.clear[seen, 1]
    behind = colour[box][seen] * through[:, None] + 255.0 * adds[:, None]
    colour[box][seen] = np.minimum(behind, 255.0).astype(np.uint8)


def _box(layer: Layer) -> tuple[slice, slice]:
    height, width = layer.depth.shape
    return slice(layer.top, layer.top + height), slice(layer.left, layer.left + width)


@lru_cache(64)
def _bare(room: Room, view: Viewpoint, size: int) -> Canvas:
    """The empty room."""
    from PIL import Image, ImageDraw

    frame = cast(Scene(room=room), view.camera, size=size, standing=view.standing)
    sheet = Image.new("L", (size, size))
    corners = view.camera.project(np.array([(x, y, 0.0) for x, y in room.floor]), size)
    ImageDraw.Draw(sheet).polygon([(float(x), float(y)) for x, y in corners], fill=255)
    return Canvas(frame.colour, frame.depth, frame.ids, (frame.ids == ROOM) & (np.asarray(sheet) > 0))


class _Caster:
    """An asset ready to be cast in its own frame."""

    def __init__(self, asset: Asset) -> None:
        soup = Soup()
        soup.add_asset(asset, pose_of((0.0, 0.0, 0.0), 0.0), 0)
        self.tracer = Tracer(soup.triangles())
        patches = self.tracer.triangles.patches
        self.textures = [p.texture for p in patches]
        self.density = np.array([p.density for p in patches], np.float32)
        own = [p.mean_colour if p.texture is None else p.colour for p in patches]
        self.colour = np.array(own, np.float32)
        finishes = [p.reflectance for p in patches]
        self.glow = np.array([f.glow for f in finishes], np.float32)
        vertices = self.tracer.triangles.vertices
        low, high = vertices.min(0), vertices.max(0)
        picks = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], bool)
        self.corners = np.where(picks, high, low).astype(np.float64)

    def base(self, points: Surfels, pixel: float) -> Floats:
        """Linear colour of what is seen, without light; `pixel` is its width [m]."""
        patch = np.maximum(points.patch, 0)
        base: Floats = self.colour.take(patch, 0)
        if points.uv is not None:
            for number in np.unique(patch):
                texture = self.textures[number]
                if texture is not None:
                    mine = np.flatnonzero(patch == number)
                    texels = np.full(len(mine), pixel * self.density[number] * max(texture.size), np.float32)
                    base[mine] *= texture.colours(points.uv[mine], texels)
        return base


@lru_cache(128)  # each holds about half a megabyte
def _caster(asset: Asset) -> _Caster:
    return _Caster(asset)


@lru_cache(1024)
def _layer(asset: Asset, position: Vec3, yaw: float, view: Viewpoint, size: int) -> Layer | None:
    return cast_alone(asset, position, yaw, view.camera, size)


def cast_alone(asset: Asset, position: Vec3, yaw: float, camera: Camera, size: int) -> Layer | None:
    """One object as a camera sees it; None where it is not in the picture."""
    caster = _caster(asset)
    cosine, sine = np.cos(np.radians(yaw)), np.sin(np.radians(yaw))
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    place = np.array(position)
    pixels = camera.project(caster.corners @ turn.T + place, size)
    left, top = np.clip(np.floor(pixels.min(0)), 0, size).astype(int)
    right, bottom = np.clip(np.ceil(pixels.max(0)), 0, size).astype(int)
    if right <= left or bottom <= top:
        return None
    y, x = (axis.ravel().astype(np.float32) + np.float32(0.5) for axis in np.mgrid[top:bottom, left:right])
    own = Camera(
        turn.T @ (camera.position - place),
        turn.T @ camera.right,
        turn.T @ camera.up,
        turn.T @ camera.forward,
        camera.reach,
        camera.perspective,
    )
    points = see_part(caster.tracer, own, x, y, size)
    shape = (bottom - top, right - left)
    solid = points.patch >= 0
    middle = place + np.array([0.0, 0.0, asset.size[2] / 2])
    away = float(np.linalg.norm(middle - camera.position))
    away = away if camera.perspective else float(camera.position[2] - place[2] - asset.size[2])
    pixel = 2 * camera.reach / size * (away if camera.perspective else 1.0)
    colour = _lit(caster, points, (turn.T @ _SUN).astype(np.float32), pixel)
    clear = None
    only_glass = ~solid & (points.front >= 0)
    if points.clear is not None and points.shine is not None and bool(only_glass.any()):
        through = np.where(only_glass, np.sqrt(points.clear.mean(1)), np.float32(1))
        adds = np.where(only_glass, points.shine, np.float32(0))
        clear = np.stack([through, adds], -1).reshape(*shape, 2).astype(np.float32)
    depth = np.where(solid, points.distance, np.float32(np.inf)).astype(np.float32)
    return Layer(left, top, colour.reshape(*shape, 3), depth.reshape(shape), clear, away)


def _lit(caster: _Caster, points: Surfels, sun: Floats, pixel: float) -> NDArray[np.uint8]:
    """Light from above and from the eye, without shadows."""
    base = caster.base(points, pixel)
    head = np.clip(-dot(points.normal, points.view), np.float32(0), np.float32(1))
    up = np.float32(0.5) + np.float32(0.5) * points.normal[:, 2]
    sky = np.float32(0.45) + np.float32(0.3) * up + np.float32(0.2) * head
    shine = np.maximum(dot(points.normal, sun), np.float32(0))
    glow = caster.glow.take(np.maximum(points.patch, 0))
    light = (sky + glow * np.float32(0.6))[:, None] + shine[:, None] * _SUN_COLOUR
    colour = base * light
    if points.clear is not None and points.shine is not None:
        colour = colour * points.clear + points.shine[:, None]
    return np.asarray(np.rint(tone_mapped(colour) * 255), np.uint8)


def outlined(canvas: Canvas) -> NDArray[np.uint8]:
    """The colours of a picture, darkened where one object ends and another begins."""
    ids, colour = canvas.ids, canvas.colour.copy()
    edge = np.zeros(ids.shape, bool)
    edge[1:] |= ids[1:] != ids[:-1]
    edge[:, 1:] |= ids[:, 1:] != ids[:, :-1]
    colour[edge] = colour[edge] // 3
    return colour


__all__ = ["NOTHING", "ROOM", "Canvas", "Layer", "Viewpoint", "canvas", "cast_alone", "outlined", "viewpoint"]
