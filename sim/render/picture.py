"""A picture of triangles: cast once for every pixel, light on a coarser grid, edges cast again more finely."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.lighting import CELLS, Irradiance, Lights, bounce_table, irradiance, plainer
from thinkblox.sim.render.rays import Tracer, in_parallel
from thinkblox.sim.render.shading import Shader, tone_mapped
from thinkblox.sim.render.smoothing import Grid, sampled, smoothed
from thinkblox.sim.render.surfels import Surfels, is_material, see
from thinkblox.sim.render.tessellate import Floats

_CHUNK = 1 << 13


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
    light = _light(job, points, x, y)
    colour = _shaded(job, points, light, x, y)
    if settings.edge_rays:
        _soften_edges(job, points, light, colour)
    picture = np.rint(colour.reshape(size, size, 3) * 255)
    return picture.astype(np.uint8)


def _light(job: _Job, points: Surfels, x: Floats, y: Floats) -> Irradiance:
    """Light at all pixels: cast on the coarse grid, smoothed, brought to the pixels, cast where that finds none."""
    coarse = job.settings.coarse
    grid = _coarse_light(job, points)
    grid = smoothed(smoothed(grid, radius=2), radius=1, step=2)

    _ = grid.table

    def fine(at: int) -> tuple[Floats, NDArray[np.bool_]]:
        part = slice(at, at + _CHUNK)
        return sampled(
            grid, x[part] / np.float32(coarse), y[part] / np.float32(coarse), points.position[part], points.normal[part]
        )

    parts = in_parallel(fine, range(0, len(x), _CHUNK))
    light, found = _joined(parts)
    lost = np.flatnonzero(~found & (points.patch >= 0))
    light[lost] = _cast_light(job, points[lost], np.zeros(len(lost), np.int64), times=4)
    return Irradiance(light[:, :3], light[:, 3:])


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
    light[seen] = _cast_light(job, chosen[seen], cell[seen])
    light[ground] = _cast_light(job, chosen[ground], cell[ground], lights=plainer(job.lights))
    seen = seen | ground
    width = (np.float32(job.pixel) + np.float32(job.spread) * np.where(seen, chosen.distance, 0)) * coarse

    def plane(values: NDArray[Any]) -> Floats:
        return np.ascontiguousarray(values.T.reshape(-1, *index.shape), dtype=np.float32)

    return Grid(
        plane(light), plane(chosen.position), plane(chosen.normal), plane(seen[:, None])[0], plane(width[:, None])[0]
    )


def _cast_light(
    job: _Job, points: Surfels, cell: NDArray[np.int64], *, times: int = 1, lights: Lights | None = None
) -> Floats:
    def part(at: int) -> Floats:
        here = slice(at, at + _CHUNK // 2)
        light = irradiance(job.tracer, lights or job.lights, job.bounce, points[here], cell[here], times=times)
        return np.concatenate([light.sky, light.sun], 1)

    parts = in_parallel(part, range(0, len(cell), _CHUNK // 2))
    return np.concatenate(parts) if parts else np.zeros((0, 6), np.float32)


def _shaded(job: _Job, points: Surfels, light: Irradiance, x: Floats, y: Floats) -> Floats:
    background = job.settings.background

    def part(at: int) -> Floats:
        here = slice(at, at + _CHUNK)
        behind = background[y[here].astype(int), x[here].astype(int)]
        linear = job.shader.colours(points[here], light[here], behind, job.spread)
        return tone_mapped(linear, job.settings.exposure)

    return np.concatenate(in_parallel(part, range(0, len(x), _CHUNK)))


def _soften_edges(job: _Job, points: Surfels, light: Irradiance, colour: Floats) -> None:
    """Cast the pixels on edges again and average."""
    edge = np.flatnonzero(_edges(job, points))
    x, y = (edge % job.size).astype(np.float32), (edge // job.size).astype(np.float32)
    grid = _full_grid(job, points, light)
    _ = grid.table
    total = colour[edge]
    for across, down in _spread_over_pixel(job.settings.edge_rays):
        fine = see(job.tracer, job.camera, x + across, y + down, job.size)
        found = _sub_light(job, grid, fine, x + across - np.float32(0.5), y + down - np.float32(0.5))
        total += _shaded(job, fine, found, x, y)
    colour[edge] = total / np.float32(job.settings.edge_rays + 1)


def _spread_over_pixel(count: int) -> Floats:
    """Places (count, 2) in and a little around a unit square, one in each row and column of a grid.

    They reach past the pixel, so that a line thinner than it does not turn into dashes.
    """
    i = np.arange(count)
    places = np.stack([(i + 0.5) / count, (i * max(round(count * 0.42), 1) % count + 0.5) / count], 1)
    return (np.float32(1.5) * (places - 0.5) + 0.5).astype(np.float32)


def _full_grid(job: _Job, points: Surfels, light: Irradiance) -> Grid:
    size = job.size
    seen = (points.patch >= 0).astype(np.float32)
    width = np.float32(job.pixel) + np.float32(job.spread) * np.where(seen > 0, points.distance, np.float32(0))

    def plane(values: Floats) -> Floats:
        return values.T.reshape(-1, size, size)

    return Grid(
        plane(np.concatenate([light.sky, light.sun], 1)),
        plane(points.position),
        plane(points.normal),
        seen.reshape(size, size),
        width.reshape(size, size),
    )


def _sub_light(job: _Job, grid: Grid, points: Surfels, x: Floats, y: Floats) -> Irradiance:
    def part(at: int) -> tuple[Floats, NDArray[np.bool_]]:
        here = slice(at, at + _CHUNK)
        return sampled(grid, x[here], y[here], points.position[here], points.normal[here], least=1e-3)

    light, found = _joined(in_parallel(part, range(0, len(x), _CHUNK)))
    lost = np.flatnonzero(~found & (points.patch >= 0))
    light[lost] = _cast_light(job, points[lost], lost % CELLS)
    return Irradiance(light[:, :3], light[:, 3:])


def _joined(parts: list[tuple[Floats, NDArray[np.bool_]]]) -> tuple[Floats, NDArray[np.bool_]]:
    light = np.concatenate([np.zeros((0, 6), np.float32), *(part[0] for part in parts)])
    return light, np.concatenate([np.zeros(0, bool), *(part[1] for part in parts)])


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
