"""A picture of triangles: cast once for every pixel, light on a coarser grid, edges cast again more finely."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.lighting import CELLS, Irradiance, Lights, bounce_table, irradiance, plainer
from thinkblox.sim.render.rays import Tracer, in_parallel
from thinkblox.sim.render.shading import Shader, tone_mapped
from thinkblox.sim.render.smoothing import Grid, Rows, lattice_of, sampled, smoothed, spread
from thinkblox.sim.render.surfels import Surfels, is_material, see, see_part
from thinkblox.sim.render.tessellate import Floats
from thinkblox.sim.render.vectors import dot

_CHUNK = 1 << 14
_AROUND = tuple(sorted(((j, i) for j in (-1, 0, 1) for i in (-1, 0, 1)), key=lambda at: at[0] ** 2 + at[1] ** 2))
"""The pixels at and round one, nearest first, as (down, across)."""
_SAME_SIDE = 0.97
"""Cosine between the normals of two places from which on they take each other's colour."""


@dataclass(frozen=True)
class Settings:
    """How a picture is made.

    Attributes:
        exposure: factor on the light before tone mapping.
        background: linear RGB (size, size, 3) behind everything.
        coarse: pixels from one point of the light's grid to the next.
        edge_rays: how many more rays a pixel on an edge gets.
    """

    exposure: float
    background: Floats
    coarse: int = 2
    edge_rays: int = 11


@dataclass(frozen=True)
class _Window:
    """The part of a picture in which anything is seen [pixels]; its pixels are numbered line by line."""

    left: int
    top: int
    width: int
    height: int

    @cached_property
    def part(self) -> tuple[slice, slice]:
        """Its lines and columns in the picture."""
        return slice(self.top, self.top + self.height), slice(self.left, self.left + self.width)

    def rest(self, size: int) -> list[tuple[slice, slice]]:
        """The lines and columns above, below and beside it."""
        lines, columns = self.part
        beside = (slice(0, self.left), slice(columns.stop, size))
        return [
            (slice(0, self.top), slice(0, size)),
            (slice(lines.stop, size), slice(0, size)),
            *((lines, side) for side in beside),
        ]

    def place(self, pixel: NDArray[np.int64]) -> tuple[Floats, Floats]:
        """Where the upper left corners of some pixels are in the picture, across and down."""
        x, y = self.left + pixel % self.width, self.top + pixel // self.width
        return x.astype(np.float32), y.astype(np.float32)


def _window(vertices: Floats, camera: Camera, size: int, unit: int) -> _Window:
    """What points (n, 3) fill of a picture, widened to whole units; all of it where some are beside the eye."""
    points = vertices.astype(np.float64)
    if not len(points) or (camera.perspective and ((points - camera.position) @ camera.forward).min() < 1e-3):
        return _Window(0, 0, size, size)
    places = camera.project(points, size)
    left, top = (max(int(low) // unit * unit - unit, 0) for low in np.clip(places.min(0), 0, size - 1))
    right, bottom = (min(-(-int(high) // unit) * unit + unit, size) for high in np.clip(places.max(0), 1, size))
    return _Window(left, top, right - left, bottom - top)


@dataclass(frozen=True)
class _Job:
    tracer: Tracer
    camera: Camera
    size: int
    window: _Window
    lights: Lights
    settings: Settings
    bounce: Floats
    shader: Shader

    @cached_property
    def background(self) -> Floats:
        """Linear RGB behind everything, a row for each pixel of the window."""
        return np.ascontiguousarray(self.settings.background[self.window.part]).reshape(-1, 3)

    @cached_property
    def ground(self) -> NDArray[np.bool_]:
        """For each patch, whether it is the ground outside; the last one stands for nothing."""
        return np.append(is_material(self.tracer.triangles, "ground"), False)

    @property
    def spread(self) -> float:
        """Growth of a pixel's width with distance."""
        return 2 * self.camera.reach / self.size if self.camera.perspective else 0.0

    @property
    def pixel(self) -> float:
        """Width of a pixel at no distance [m]."""
        return _pixel(self.camera, self.size)


def _pixel(camera: Camera, size: int) -> float:
    return 0.0 if camera.perspective else 2 * camera.reach / size


def paint(
    tracer: Tracer, camera: Camera, size: int, lights: Lights, settings: Settings, *, within: Floats | None = None
) -> NDArray[np.uint8]:
    """An sRGB picture (size, size, 3); only the part that points (n, 3) of the room fill, the rest empty, if given."""
    bounce = bounce_table(tracer, lights)
    shader = Shader(tracer, lights, _pixel(camera, size), bounce)
    filled = tracer.triangles.vertices if within is None else within
    window = _window(filled, camera, size, 4 * settings.coarse)
    job = _Job(tracer, camera, size, window, lights, settings, bounce, shader)
    middle = np.arange(size, dtype=np.float32) + np.float32(0.5)
    down, across = (middle[part] for part in window.part)
    points = see(tracer, camera, np.tile(across, window.height), np.repeat(down, window.width), size)
    light, colour = _painted(job, points)
    if settings.edge_rays:
        _soften_edges(job, points, light, colour)
    behind = settings.background
    picture = np.empty((size, size, 3), np.uint8)
    for part in (window.part, *window.rest(size)):
        seen = colour if part is window.part else tone_mapped(behind[part].reshape(-1, 3), settings.exposure)
        picture[part] = np.rint(seen * np.float32(255)).reshape(picture[part].shape)
    return picture


def _painted(job: _Job, points: Surfels) -> tuple[Floats, Floats]:
    """Light (n, 4) and colour (n, 3) of all pixels, the light being cast on a coarse grid and smoothed there."""
    (width, height), step = (job.window.width, job.window.height), job.settings.coarse
    lattice = lattice_of(smoothed(smoothed(_coarse_light(job, points), radius=2), radius=1, step=2), step)
    light, colour = np.empty((width * height, 4), np.float32), np.empty((width * height, 3), np.float32)
    lines = step * max(4 * _CHUNK // (width * step), 1)

    def fill(top: int) -> None:
        here = slice(top * width, min(top + lines, height) * width)
        part = points[here]
        planes = (values.reshape(-1, width, 3) for values in (part.position, part.normal))
        found, weights = spread(lattice, top, *planes)
        light[here] = found.reshape(-1, 4)
        lost = np.flatnonzero((weights.ravel() <= 0.02) & (part.patch >= 0))
        if len(lost):
            light[here][lost] = _cast_part(job, part[lost], lost % CELLS, job.lights, 4)
        colour[here] = _shaded(job, part, light[here], np.arange(here.start, here.stop))

    in_parallel(fill, range(0, height, lines))
    return light, colour


def _coarse_light(job: _Job, points: Surfels) -> Grid:
    window, coarse = job.window, job.settings.coarse
    index = np.arange(window.height * window.width).reshape(window.height, window.width)[::coarse, ::coarse]
    down, across = (np.arange(side) % 4 for side in index.shape)
    cell = (down[:, None] * 4 + across).ravel()
    chosen = points[index.ravel()]
    seen = chosen.patch >= 0
    light = np.zeros((len(cell), 4), np.float32)
    ground = job.ground[chosen.patch] & seen
    seen = seen & ~ground
    light[seen] = _cast_light(job, chosen[seen], cell[seen], job.lights)
    light[ground] = _cast_light(job, chosen[ground], cell[ground], plainer(job.lights))
    seen = seen | ground
    width = _seen_and_spacing(job, chosen)[1] * np.float32(coarse)

    def plane(values: NDArray[Any]) -> Floats:
        return np.ascontiguousarray(values.T.reshape(-1, *index.shape), dtype=np.float32)

    return Grid(
        plane(light), plane(chosen.position), plane(chosen.normal), plane(seen[:, None])[0], plane(width[:, None])[0]
    )


def _cast_light(job: _Job, points: Surfels, cell: NDArray[np.int64], lights: Lights) -> Floats:
    light = np.empty((len(cell), 4), np.float32)

    def fill(at: int) -> None:
        here = slice(at, at + _CHUNK // 2)
        light[here] = _cast_part(job, points[here], cell[here], lights, 1)

    in_parallel(fill, range(0, len(cell), _CHUNK // 2))
    return light


def _cast_part(job: _Job, points: Surfels, cell: NDArray[np.int64], lights: Lights, times: int) -> Floats:
    light = irradiance(job.tracer, lights, job.bounce, points, cell, times=times)
    return np.concatenate([light.sky, light.sun[:, :1] / lights.sun_colour[:1]], 1)


def _shaded(job: _Job, points: Surfels, light: Floats, pixel: NDArray[np.int64]) -> Floats:
    """Colours (n, 3), sRGB, of points in some pixels; light (n, 4) is that of the sky, and the share of the sun's."""
    behind = job.background.take(pixel, 0)
    irradiance = Irradiance(light[:, :3], light[:, 3:] * job.lights.sun_colour)
    linear = job.shader.colours(points, irradiance, behind, job.spread)
    return tone_mapped(linear, job.settings.exposure)


def _soften_edges(job: _Job, points: Surfels, light: Floats, colour: Floats) -> None:
    """Cast the pixels on edges again and average.

    A ray that meets what a pixel beside it shows takes that pixel's colour; only the others are lit and shaded.
    """
    edge = np.flatnonzero(_edges(job, points))
    rows = Rows(light, points.position, points.normal, *_seen_and_spacing(job, points), job.window.width)
    sharp = colour.copy()

    def soften(at: int) -> None:
        mine = edge[at : at + _CHUNK]
        x, y = job.window.place(mine)
        total = colour[mine]
        for across, down in _spread_over_pixel(job.settings.edge_rays):
            same = _pixels_alike(job, points, x + across, y + down)
            found = sharp.take(same, 0)
            new = np.flatnonzero(same < 0)
            if len(new):
                at_x, at_y = x[new] + across, y[new] + down
                fine = see_part(job.tracer, job.camera, at_x, at_y, job.size)
                in_rows = (at_x - np.float32(job.window.left + 0.5), at_y - np.float32(job.window.top + 0.5))
                light = _found_light(job, rows, fine, *in_rows)
                found[new] = _shaded(job, fine, light, mine[new])
            total += found
        colour[mine] = total / np.float32(job.settings.edge_rays + 1)

    in_parallel(soften, range(0, len(edge), _CHUNK))


def _pixels_alike(job: _Job, points: Surfels, x: Floats, y: Floats) -> NDArray[np.int64]:
    """For rays through pixel coordinates (n,), the nearest pixel that shows the same side of the same; -1 for none."""
    tracer, window = job.tracer, job.window
    origins, directions = job.camera.rays(x, y, job.size)
    hits = tracer.solid(origins, directions)
    face = hits.face.astype(np.intp)
    patch = np.where(face < 0, np.int32(-1), tracer.triangles.patch.take(face))
    facing = tracer.face_normals.take(face, 0)
    same = np.full(len(x), -1, np.int64)
    left = np.arange(len(x))
    if tracer.has_glass:
        left = np.flatnonzero(tracer.glass(origins, directions).distance >= hits.distance)
    column, row = (np.floor(at).astype(np.int64) - low for at, low in ((x, window.left), (y, window.top)))
    for down, across in _AROUND:
        beside = np.clip(column[left] + across, 0, window.width - 1)
        at = np.clip(row[left] + down, 0, window.height - 1) * window.width + beside
        wanted = patch.take(left)
        alike = (points.patch.take(at) == wanted) & (points.front.take(at) == wanted)
        cosine = dot(points.facing.take(at, 0), facing.take(left, 0))
        alike &= (np.abs(cosine) > _SAME_SIDE) | (wanted < 0)
        same[left[alike]] = at[alike]
        left = left[~alike]
        if not len(left):
            break
    return same


def _found_light(job: _Job, rows: Rows, points: Surfels, x: Floats, y: Floats) -> Floats:
    """Light (n, 4) looked up among the window's pixels, and cast where none is found."""
    light = np.zeros((len(x), 4), np.float32)
    seen = np.flatnonzero(points.patch >= 0)
    light[seen], found = sampled(rows, x[seen], y[seen], points.position[seen], points.normal[seen], least=1e-3)
    lost = seen[~found]
    if len(lost):
        light[lost] = _cast_part(job, points[lost], lost % CELLS, job.lights, 1)
    return light


def _seen_and_spacing(job: _Job, points: Surfels) -> tuple[Floats, Floats]:
    """Whether a pixel shows anything, 1 or 0, and how wide it is there [m]."""
    seen = (points.patch >= 0).astype(np.float32)
    return seen, np.float32(job.pixel) + np.float32(job.spread) * (points.distance * seen)


def _spread_over_pixel(count: int) -> Floats:
    """Places (count, 2) in and a little around a unit square, one in each row and column of a grid.

    They reach past the pixel, so that a line thinner than it does not turn into dashes; and no few of them lie in line
    along the edges of a room that is seen over its corner, two pixels across for one down.
    """
    i = np.arange(count)
    places = np.stack([(i + 0.5) / count, (i * max(round(count * 0.2), 1) % count + 0.5) / count], 1)
    return (np.float32(1.5) * (places - 0.5) + 0.5).astype(np.float32)


def _edges(job: _Job, points: Surfels) -> NDArray[np.bool_]:
    """Pixels next to another patch, another facing or a step in depth."""
    shape = (job.window.height, job.window.width)
    patch, front = points.patch.reshape(shape), points.front.reshape(shape)
    normal = points.normal.reshape(*shape, 3)
    depth = np.minimum(points.distance, np.float32(1e4)).reshape(shape)
    edge = np.zeros(shape, bool)
    for first, second in (
        ((slice(None), slice(1, None)), (slice(None), slice(None, -1))),
        ((slice(1, None),), (slice(None, -1),)),
    ):
        differs = (patch[first] != patch[second]) | (front[first] != front[second])
        differs |= dot(normal[first], normal[second]) < 0.94
        differs |= np.abs(depth[first] - depth[second]) > 0.02 * depth[first]
        edge[first] |= differs
        edge[second] |= differs
    return edge.ravel()
