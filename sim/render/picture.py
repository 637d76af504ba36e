"""A picture of triangles: cast once for every pixel, light on a coarser grid, edges cast again more finely."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.lighting import CELLS, Irradiance, Lights, bounce_table, irradiance, plainer
from thinkblox.sim.render.rays import Tracer, in_parallel
from thinkblox.sim.render.shading import Shader, tone_mapped
from thinkblox.sim.render.smoothing import Grid, Rows, rows_of, sampled, smoothed
from thinkblox.sim.render.surfels import Surfels, is_material, see, see_part
from thinkblox.sim.render.tessellate import Floats

_CHUNK = 1 << 14


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
class _Job:
    tracer: Tracer
    camera: Camera
    size: int
    lights: Lights
    settings: Settings
    bounce: Floats
    shader: Shader

    @property
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


def paint(tracer: Tracer, camera: Camera, size: int, lights: Lights, settings: Settings) -> NDArray[np.uint8]:
    """An sRGB picture (size, size, 3)."""
    shader = Shader(tracer.triangles, lights, _pixel(camera, size))
    job = _Job(tracer, camera, size, lights, settings, bounce_table(tracer, lights), shader)
    y, x = (axis.ravel().astype(np.float32) for axis in np.mgrid[0:size, 0:size])
    points = see(tracer, camera, x + np.float32(0.5), y + np.float32(0.5), size)
    light, colour = _painted(job, points, x, y)
    if settings.edge_rays:
        _soften_edges(job, points, light, colour)
    picture = np.rint(colour.reshape(size, size, 3) * 255)
    return picture.astype(np.uint8)


def _painted(job: _Job, points: Surfels, x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Light (n, 6) and colour (n, 3) of all pixels, the light being cast on a coarse grid and smoothed there."""
    grid = _coarse_light(job, points)
    rows = rows_of(smoothed(smoothed(grid, radius=2), radius=1, step=2))
    light, colour = np.empty((len(x), 6), np.float32), np.empty((len(x), 3), np.float32)
    scale = np.float32(1 / job.settings.coarse)

    def fill(at: int) -> None:
        here = slice(at, at + _CHUNK)
        part = points[here]
        light[here] = _found_light(job, rows, part, x[here] * scale, y[here] * scale, least=0.02, times=4)
        colour[here] = _shaded(job, part, light[here], x[here], y[here])

    in_parallel(fill, range(0, len(x), _CHUNK))
    return light, colour


def _found_light(job: _Job, rows: Rows, points: Surfels, x: Floats, y: Floats, *, least: float, times: int) -> Floats:
    """Light (n, 6) looked up at grid coordinates, and cast where none is found."""
    light = np.zeros((len(x), 6), np.float32)
    seen = np.flatnonzero(points.patch >= 0)
    light[seen], found = sampled(rows, x[seen], y[seen], points.position[seen], points.normal[seen], least=least)
    lost = seen[~found]
    if len(lost):
        light[lost] = _cast_part(job, points[lost], lost % CELLS, job.lights, times)
    return light


def _coarse_light(job: _Job, points: Surfels) -> Grid:
    size, coarse = job.size, job.settings.coarse
    index = np.arange(size * size).reshape(size, size)[::coarse, ::coarse]
    rows, columns = np.indices(index.shape)
    cell = ((rows % 4) * 4 + columns % 4).ravel()
    chosen = points[index.ravel()]
    seen = chosen.patch >= 0
    light = np.zeros((len(cell), 6), np.float32)
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
    light = np.empty((len(cell), 6), np.float32)

    def fill(at: int) -> None:
        here = slice(at, at + _CHUNK // 2)
        light[here] = _cast_part(job, points[here], cell[here], lights, 1)

    in_parallel(fill, range(0, len(cell), _CHUNK // 2))
    return light


def _cast_part(job: _Job, points: Surfels, cell: NDArray[np.int64], lights: Lights, times: int) -> Floats:
    light = irradiance(job.tracer, lights, job.bounce, points, cell, times=times)
    return np.concatenate([light.sky, light.sun], 1)


def _shaded(job: _Job, points: Surfels, light: Floats, x: Floats, y: Floats) -> Floats:
    behind = job.settings.background[y.astype(np.int32), x.astype(np.int32)]
    linear = job.shader.colours(points, Irradiance(light[:, :3], light[:, 3:]), behind, job.spread)
    return tone_mapped(linear, job.settings.exposure)


def _soften_edges(job: _Job, points: Surfels, light: Floats, colour: Floats) -> None:
    """Cast the pixels on edges again and average."""
    edge = np.flatnonzero(_edges(job, points))
    rows = Rows(light, points.position, points.normal, *_seen_and_spacing(job, points), job.size)

    def soften(at: int) -> None:
        mine = edge[at : at + _CHUNK]
        x, y = (mine % job.size).astype(np.float32), (mine // job.size).astype(np.float32)
        total = colour[mine]
        for across, down in _spread_over_pixel(job.settings.edge_rays):
            fine = see_part(job.tracer, job.camera, x + across, y + down, job.size)
            at_x, at_y = x + across - np.float32(0.5), y + down - np.float32(0.5)
            total += _shaded(job, fine, _found_light(job, rows, fine, at_x, at_y, least=1e-3, times=1), x, y)
        colour[mine] = total / np.float32(job.settings.edge_rays + 1)

    in_parallel(soften, range(0, len(edge), _CHUNK))


def _seen_and_spacing(job: _Job, points: Surfels) -> tuple[Floats, Floats]:
    """Whether a pixel shows anything, 1 or 0, and how wide it is there [m]."""
    seen = (points.patch >= 0).astype(np.float32)
    return seen, np.float32(job.pixel) + np.float32(job.spread) * (points.distance * seen)


def _spread_over_pixel(count: int) -> Floats:
    """Places (count, 2) in and a little around a unit square, one in each row and column of a grid.

    They reach past the pixel, so that a line thinner than it does not turn into dashes.
    """
    i = np.arange(count)
    places = np.stack([(i + 0.5) / count, (i * max(round(count * 0.42), 1) % count + 0.5) / count], 1)
    return (np.float32(1.5) * (places - 0.5) + 0.5).astype(np.float32)


def _edges(job: _Job, points: Surfels) -> NDArray[np.bool_]:
    """Pixels next to another patch, another facing or a step in depth."""
    size = job.size
    patch, front = points.patch.reshape(size, size), points.front.reshape(size, size)
    normal = points.normal.reshape(size, size, 3)
    depth = np.minimum(points.distance, np.float32(1e4)).reshape(size, size)
    edge = np.zeros((size, size), bool)
    for first, second in (
        ((slice(None), slice(1, None)), (slice(None), slice(None, -1))),
        ((slice(1, None),), (slice(None, -1),)),
    ):
        differs = (patch[first] != patch[second]) | (front[first] != front[second])
        differs |= np.einsum("ijk,ijk->ij", normal[first], normal[second]) < 0.94
        differs |= np.abs(depth[first] - depth[second]) > 0.02 * depth[first]
        edge[first] |= differs
        edge[second] |= differs
    return edge.ravel()
