"""How much light reaches a point: sky, sun, what other surfaces send back, and lamps."""

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.materials import MATERIALS
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.surfels import Surfels
from thinkblox.sim.render.tessellate import Floats
from thinkblox.sim.render.vectors import dot, scaled

CELLS = 16
"""Points take turns with this many sets of directions, 4 x 4 in the picture; a blur of that width joins them."""
_OFFSET = np.float32(2.5e-4)
SKY_STEPS = 128
_WARM = np.array([1.0, 0.72, 0.44], np.float32)
LAMP_REACH = 2.2
"""Distance at which a lamp's glow ends [m]."""
SMALLEST_LAMP = 0.03
"""Mean extent from which on a glowing shape lights its surroundings [m]."""
FULL_LAMP = 0.2
"""Mean extent from which on it does so at full strength [m]."""
MOST_LAMPS = 16


@dataclass(frozen=True)
class Lights:
    """The light of a picture.

    Attributes:
        sun: unit vector towards the sun.
        sun_colour: its irradiance, linear RGB.
        spread: tangent of the sun's angular radius: how soft its shadows are.
        zenith, horizon, below: the sky's radiance overhead, at eye level and under the floor, linear RGB.
        lamps: (n, 5) centres [m], radii [m] and strengths of what glows.
        gather, sun_rays: rays a point sends to the sky and to the sun.
    """

    sun: Floats
    sun_colour: Floats
    spread: float
    zenith: Floats
    horizon: Floats
    below: Floats
    lamps: Floats
    gather: int = 12
    sun_rays: int = 6

    @cached_property
    def sky_table(self) -> Floats:
        """Radiance (SKY_STEPS, 3) by direction, from straight down to straight up."""
        return self.sky(np.linspace(-1, 1, SKY_STEPS, dtype=np.float32))

    def sky(self, up: Floats) -> Floats:
        """Radiance (n, 3) of the sky in directions whose vertical part is `up` (n,)."""
        height = np.sqrt(np.clip(up, np.float32(0), np.float32(1)))[:, None]
        above = self.horizon + (self.zenith - self.horizon) * height
        return np.where(up[:, None] > 0, above, self.below)


def lights(
    tracer: Tracer,
    towards_sun: Floats,
    *,
    gather: int = 12,
    sun_rays: int = 6,
    spread: float = 4.0,
    strength: float = 1.0,
) -> Lights:
    """Warm sun of some strength with an angular radius of `spread` [degrees], a cooler sky, and the scene's lamps."""

    def rgb(*values: float) -> Floats:
        return np.array(values, np.float32)

    sun = towards_sun / np.linalg.norm(towards_sun)
    return Lights(
        sun=sun.astype(np.float32),
        sun_colour=rgb(1.10, 1.03, 0.93) * np.float32(strength),
        spread=math.tan(math.radians(spread)),
        zenith=rgb(0.62, 0.67, 0.73),
        horizon=rgb(0.80, 0.82, 0.84),
        below=rgb(0.45, 0.42, 0.39),
        lamps=_lamps(tracer),
        gather=gather,
        sun_rays=sun_rays,
    )


def _lamps(tracer: Tracer) -> Floats:
    """What is large enough to light a room, not the small lights of machines; the largest ones where there are many."""
    glowing = MATERIALS.index("light")
    large = [(np.prod(p.size) ** (1 / 3), p) for p in tracer.triangles.patches if p.material == glowing]
    large = sorted((pair for pair in large if pair[0] > SMALLEST_LAMP), key=lambda pair: -pair[0])[:MOST_LAMPS]
    found = [(*patch.origin, min(patch.size) / 2, min(extent / FULL_LAMP, 1.0)) for extent, patch in large]
    return np.array(found, np.float32).reshape(-1, 5)


def bounce_table(tracer: Tracer, lights: Lights) -> Floats:
    """Radiance of the sky's steps, then that which each face sends back as if nothing stood in its light."""
    triangles = tracer.triangles
    finishes = [p.reflectance for p in triangles.patches]
    colour = np.array([p.mean_colour for p in triangles.patches], np.float32)[triangles.patch]
    diffuse = np.array([finish.diffuse for finish in finishes], np.float32)[triangles.patch][:, None]
    glow = np.array([finish.glow for finish in finishes], np.float32)[triangles.patch][:, None]
    facing = np.maximum(tracer.face_normals @ lights.sun, 0)[:, None]
    light = np.float32(0.42) + np.float32(0.34) * facing * lights.sun_colour
    back = colour * (np.maximum(diffuse, np.float32(0.4)) * light + glow)
    return np.concatenate([lights.sky_table, back]).astype(np.float32)


@dataclass(frozen=True)
class Irradiance:
    """Light that arrives at points (n, 3), divided by pi: `sky` from everywhere round, `sun` straight from the sun."""

    sky: Floats
    sun: Floats

    def __getitem__(self, pick: NDArray[np.int64] | slice) -> "Irradiance":
        """The light at some of the points."""
        return Irradiance(self.sky[pick], self.sun[pick])


def irradiance(
    tracer: Tracer, lights: Lights, bounce: Floats, points: Surfels, cell: NDArray[np.int64], *, times: int = 1
) -> Irradiance:
    """Light at points; `cell` (n,) says which of the direction sets each takes, `times` how many of them it uses."""
    origin = points.position + points.facing * _OFFSET
    sky = np.zeros_like(origin)
    sun = np.zeros(len(origin), np.float32)
    for turn in range(times):
        sets = (cell + turn * 5) % CELLS
        sky += _gathered(tracer, lights, bounce, points, origin, sets)
        sun += _sunlit(tracer, lights, points, origin, sets)
    sky += _lamp_light(tracer, lights, points, origin, cell) * np.float32(times)
    scale = np.float32(1 / times)
    return Irradiance(sky * scale, scaled(lights.sun_colour, sun * scale))


def _gathered(
    tracer: Tracer, lights: Lights, bounce: Floats, points: Surfels, origin: Floats, cell: NDArray[np.int64]
) -> Floats:
    rays, inside = _fans(_ball(lights.gather).take(cell, 0), points)
    hits = tracer.solid(_repeated(origin, lights.gather), rays)
    missed = hits.face < 0
    sky = (rays[:, 2] * np.float32(SKY_STEPS / 2 - 0.5) + np.float32(SKY_STEPS / 2)).astype(np.intp)
    light = bounce.take(np.where(missed, sky, hits.face + np.intp(SKY_STEPS)), 0).reshape(*inside.shape, 3)
    near = np.float32(0.35) + np.float32(0.65) * np.minimum(hits.distance, np.float32(1.0))
    weight = np.where(missed, np.float32(1), near).reshape(inside.shape) * inside
    total: Floats = (weight[:, None, :] @ light)[:, 0]
    return total * np.float32(1 / lights.gather)


def _fans(ball: Floats, points: Surfels) -> tuple[Floats, NDArray[np.bool_]]:
    """Unit vectors (n k, 3) round the normals, from vectors of a ball (n, k, 3), and which leave the face (n, k)."""
    columns = [ball[..., axis] + points.normal[:, axis, None] * np.float32(1.002) for axis in range(3)]
    x, y, z = columns
    facing = points.facing[:, :, None]
    inside = x * facing[:, 0] + y * facing[:, 1] + z * facing[:, 2] > 0
    shrink = np.reciprocal(np.sqrt(x * x + y * y + z * z))
    rays = np.empty((inside.size, 3), np.float32)
    for axis, column in enumerate(columns):
        rays[:, axis] = (column * shrink).ravel()
    return rays, inside


def _repeated(rows: Floats, times: int) -> Floats:
    """Each row (n, 3) so many times over."""
    return np.ascontiguousarray(np.broadcast_to(rows[:, None], (len(rows), times, 3))).reshape(-1, 3)


def _sunlit(tracer: Tracer, lights: Lights, points: Surfels, origin: Floats, cell: NDArray[np.int64]) -> Floats:
    cosine = np.maximum(dot(points.normal, lights.sun), np.float32(0))
    lit = np.flatnonzero((cosine > 0) & (dot(points.facing, lights.sun) > -0.05))
    result = np.zeros(len(origin), np.float32)
    if not len(lit):
        return result
    rays = _sun_directions(lights).take(cell[lit], 0).reshape(-1, 3)
    hidden = tracer.blocked(_repeated(origin.take(lit, 0), lights.sun_rays), rays)
    result[lit] = cosine[lit] * (1 - hidden.reshape(-1, lights.sun_rays).mean(1, dtype=np.float32))
    return result


def _lamp_light(tracer: Tracer, lights: Lights, points: Surfels, origin: Floats, cell: NDArray[np.int64]) -> Floats:
    """Warm light of the lamps, shadowed by what stands between."""
    total = np.zeros_like(origin)
    jitter = _ball(4)[cell, 0]
    for lamp in lights.lamps:
        way = lamp[:3] + jitter * lamp[3] - origin
        square = dot(way, way)
        cosine = dot(way, points.normal) / np.sqrt(square + np.float32(1e-9))
        near = np.flatnonzero((square < LAMP_REACH**2) & (cosine > 0))
        if not len(near):
            continue
        fall = (1 - square[near] / np.float32(LAMP_REACH**2)) ** 2 / (square[near] + np.float32(0.06))
        reach = np.maximum(1 - (lamp[3] + np.float32(0.02)) / np.sqrt(square[near]), np.float32(0))
        open_way = ~tracer.blocked(origin[near], np.ascontiguousarray(way[near]), reach)
        total[near] += scaled(_WARM, np.float32(0.15) * lamp[4] * fall * cosine[near] * open_way)
    return total


def _fibonacci(count: int) -> NDArray[np.float64]:
    i = np.arange(count) + 0.5
    height, turn = 1 - 2 * i / count, i * math.pi * (3 - math.sqrt(5))
    level = np.sqrt(1 - height**2)
    return np.stack([level * np.cos(turn), level * np.sin(turn), height], 1)


@lru_cache(maxsize=8)
def _ball(count: int) -> Floats:
    """Evenly spread unit vectors, turned another way for each cell: (CELLS, count, 3)."""
    rng = np.random.default_rng(11)
    base = _fibonacci(count)
    turns = [np.linalg.qr(rng.normal(size=(3, 3)))[0] for _ in range(CELLS)]
    return np.stack([base @ turn for turn in turns]).astype(np.float32)


def plainer(lights: Lights) -> Lights:
    """The same light with fewer rays, for what matters less."""
    return replace(lights, gather=max(lights.gather // 2, 1), sun_rays=max(lights.sun_rays // 2, 1))


def _sun_directions(lights: Lights) -> Floats:
    """Directions to points of the sun's disk, turned another way for each cell: (CELLS, sun_rays, 3)."""
    side = np.cross(lights.sun, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side)
    over = np.cross(side, lights.sun)
    index = np.arange(CELLS * lights.sun_rays)
    radius = np.sqrt((index + 0.5) / len(index)) * lights.spread
    turn = index * math.pi * (3 - math.sqrt(5))
    disk = lights.sun + (radius * np.cos(turn))[:, None] * side + (radius * np.sin(turn))[:, None] * over
    spread = disk.reshape(lights.sun_rays, CELLS, 3).transpose(1, 0, 2)
    return np.ascontiguousarray(spread, dtype=np.float32)
