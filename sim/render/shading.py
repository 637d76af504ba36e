"""From surfaces and the light on them to linear colours, and from those to pixels."""

import numpy as np

from thinkblox.sim.render.layings import colours as laid_colours
from thinkblox.sim.render.lighting import SKY_STEPS, Irradiance, Lights
from thinkblox.sim.render.materials import MATERIALS, SILVER, linear
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.surfels import Surfels
from thinkblox.sim.render.tessellate import Floats, Ints
from thinkblox.sim.render.textures import weave, wood
from thinkblox.sim.render.vectors import dot, largest, scaled

_SILVERED = np.float32(0.8)
"""How much of what is before it a mirror shows."""
_SHADE = np.array([1.0, 0.86, 0.62], np.float32)
"""The colour of a lamp's light as it comes through its shade, linear RGB."""


class Shader:
    """The patches of a scene as tables, ready to colour points.

    Mirrors show what is before them where the light that faces send back is given, as `bounce_table` has it.
    """

    def __init__(self, tracer: Tracer, lights: Lights, pixel: float, bounce: Floats | None = None) -> None:
        patches = tracer.triangles.patches
        self._tracer, self._bounce = tracer, bounce
        self._patches = patches
        self._lights = lights
        self._pixel = np.float32(pixel)
        self._colour = np.array([p.colour for p in patches], np.float32)
        self._material = np.array([p.material for p in patches], np.int64)
        self._turn = np.array([p.rotation for p in patches], np.float32)
        self._origin = np.array([p.origin for p in patches], np.float32)
        self._size = np.array([p.size for p in patches], np.float32)
        self._axis = np.argmax(self._size, 1)
        finishes = [p.reflectance for p in patches]
        self._finish = {
            name: np.array([float(getattr(finish, name)) for finish in finishes], np.float32)
            for name in ("diffuse", "mirror", "gloss", "tinted", "sheen", "glow")
        }
        self._planes = list(dict.fromkeys(p.plane for p in patches if p.plane is not None))
        numbers = {plane: number + 1 for number, plane in enumerate(self._planes)}
        self._plane_of = np.array([0 if p.plane is None else numbers[p.plane] for p in patches], np.int64)
        self._density = np.array([p.density for p in patches], np.float32)
        silver = (linear(SILVER), MATERIALS.index("metal"))
        self._silvered = np.array([bounce is not None and (p.colour, p.material) == silver for p in patches], bool)
        self._textured = np.array([p.texture is not None for p in patches], bool)

    def colours(self, points: Surfels, light: Irradiance, background: Floats, spread: float) -> Floats:
        """Linear RGB (n, 3) of points.

        Args:
            points: what is seen.
            light: what arrives there.
            background: linear RGB (n, 3) behind the scene.
            spread: growth of a pixel's width with distance; 0 for an orthographic camera.
        """
        material = np.where(points.patch < 0, np.int64(-1), self._material.take(points.patch))
        ground = np.flatnonzero(material == MATERIALS.index("ground"))
        inside = np.flatnonzero((material >= 0) & (material != MATERIALS.index("ground")))
        if len(inside) == len(material):
            colour = self._lit(points, light, material, spread)
        else:
            colour = np.array(background, np.float32)
            if len(ground):
                colour[ground] = self._backdrop(light[ground], background.take(ground, 0))
            if len(inside):
                colour[inside] = self._lit(points[inside], light[inside], material.take(inside), spread)
        if points.clear is not None and points.shine is not None:
            colour = colour * points.clear + points.shine[:, None]
        return colour

    def _lit(self, points: Surfels, light: Irradiance, material: Ints, spread: float) -> Floats:
        cosine = np.clip(-dot(points.normal, points.view), np.float32(0.05), np.float32(1))
        width = self._pixel + np.float32(spread) * points.distance
        base = self._base(points, material, width / cosine)
        grazing = 1 - cosine
        patch, finish = points.patch, self._finish
        scatter = finish["diffuse"].take(patch) + finish["sheen"].take(patch) * grazing**2
        colour = scaled(base, scatter) * (light.sky + light.sun)
        glow = finish["glow"].take(patch)
        lit = np.flatnonzero(glow > 0)
        if len(lit):
            glow = glow[lit] * (np.float32(0.45) + np.float32(0.55) * cosine[lit])
            shade = (material[lit] == MATERIALS.index("light"))[:, None]
            colour[lit] += base[lit] * np.where(shade, _SHADE, np.float32(1)) * glow[:, None]
        shiny = np.flatnonzero(finish["mirror"].take(patch) > 0)
        if len(shiny):
            turned = cosine.take(shiny)
            bent = points.view.take(shiny, 0) + scaled(points.normal.take(shiny, 0), 2 * turned)
            colour[shiny] += self._shine(bent, light[shiny], patch.take(shiny), base.take(shiny, 0), turned)
        mirrors = np.flatnonzero(self._silvered.take(patch))
        if len(mirrors) and self._bounce is not None:
            colour[mirrors] = self._mirrored(self._bounce, points[mirrors], colour[mirrors])
        return np.asarray(colour, np.float32)

    def _mirrored(self, bounce: Floats, points: Surfels, own: Floats) -> Floats:
        """What mirrors show: what stands before them in its mean colours, and the sky where nothing does."""
        bent = points.view - scaled(points.facing, 2 * dot(points.view, points.facing))
        hits = self._tracer.solid(points.position + points.facing * np.float32(1e-3), bent)
        sky = (bent[:, 2] * np.float32(SKY_STEPS / 2 - 0.5) + np.float32(SKY_STEPS / 2)).astype(np.intp)
        seen = bounce.take(np.where(hits.face < 0, sky, hits.face + np.intp(SKY_STEPS)), 0)
        return np.asarray(seen * _SILVERED + own * (1 - _SILVERED), np.float32)

    def _shine(self, bent: Floats, light: Irradiance, patch: Ints, base: Floats, cosine: Floats) -> Floats:
        mirror, gloss = self._finish["mirror"].take(patch), self._finish["gloss"].take(patch)
        mirror = mirror + np.float32(0.35) * (1 - mirror) * (1 - cosine) ** 5
        sharp = np.maximum(dot(bent, self._lights.sun), np.float32(0)) ** gloss
        sharp *= mirror * np.sqrt(gloss) * np.float32(0.25)
        arrives = (light.sky[:, 0] + light.sky[:, 1] + light.sky[:, 2]) * np.float32(0.5)
        shine = scaled(self._lights.sky(bent[:, 2]), mirror * np.minimum(arrives, np.float32(1)))
        shine += scaled(light.sun, sharp)
        tinted = np.flatnonzero(self._finish["tinted"].take(patch) > 0)
        shine[tinted] *= base.take(tinted, 0)
        return np.asarray(shine, np.float32)

    def _base(self, points: Surfels, material: Ints, width: Floats) -> Floats:
        base = self._colour.take(points.patch, 0)
        for name, paint in (
            ("wood", self._wood),
            ("fabric", self._fabric),
            ("pane", self._pane),
        ):
            mine = np.flatnonzero(material == MATERIALS.index(name))
            if len(mine):
                base[mine] = paint(points.patch[mine], points.position[mine], base[mine], width[mine])
        self._paint_planes(points, base, width)
        if points.uv is not None:
            self._paint_textures(points, base, width)
        return base

    def _paint_planes(self, points: Surfels, base: Floats, width: Floats) -> None:
        """Colour what shows a floor or the inner side of a wall by what it is covered with."""
        numbers = self._plane_of.take(points.patch)
        for number in np.flatnonzero(np.bincount(numbers, minlength=len(self._planes) + 1)[1:]):
            plane = self._planes[number]
            mine = np.flatnonzero(numbers == number + 1)
            mine = mine[dot(points.normal.take(mine, 0), plane.facing) > 0.5]
            offset = points.position.take(mine, 0) - np.array(plane.origin, np.float32)
            along, across = (dot(offset, np.array(axis, np.float32)) for axis in (plane.along, plane.across))
            base[mine] = laid_colours(plane.covering, along, across, width.take(mine), floor=plane.floor)

    def _paint_textures(self, points: Surfels, base: Floats, width: Floats) -> None:
        """Multiply the colours of textured points by what their textures show there."""
        for number in np.unique(points.patch[self._textured[points.patch]]):
            texture = self._patches[number].texture
            if texture is not None and points.uv is not None:
                mine = np.flatnonzero(points.patch == number)
                texels = width[mine] * self._density[number] * np.float32(max(texture.size))
                base[mine] *= texture.colours(points.uv[mine], texels)

    def _local(self, patch: Ints, position: Floats) -> Floats:
        """Points in the frames of their patches [m]."""
        offset, turn = position - self._origin.take(patch, 0), self._turn.take(patch, 0)
        return np.stack([dot(offset, turn[:, :, axis]) for axis in range(3)], 1)

    def _wood(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        local, axis, rows = self._local(patch, position), self._axis[patch], np.arange(len(base))
        along = local[rows, axis]
        across = local[rows, (axis + 1) % 3] + np.float32(0.8) * local[rows, (axis + 2) % 3]
        return scaled(base, wood(along, across, width, (patch % 97).astype(np.float32)))

    def _fabric(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        local = self._local(patch, position)
        return scaled(base, weave(local[:, 0] + local[:, 2], local[:, 1] + local[:, 2], width))

    def _pane(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        """A blurred garden under a pale sky."""
        high = self._local(patch, position)[:, 2] / self._size[patch, 2] + np.float32(0.5)
        stops = np.array([0.0, 0.22, 0.42, 1.0])
        views = np.array([[0.42, 0.52, 0.33], [0.62, 0.70, 0.52], [0.96, 0.95, 0.90], [0.66, 0.82, 0.98]])
        return np.stack([np.interp(high, stops, views[:, c]) for c in range(3)], 1).astype(np.float32)

    def _backdrop(self, light: Irradiance, background: Floats) -> Floats:
        """Outside, only shadows show on a plain backdrop."""
        full = self._lights.sky(np.ones(1, np.float32)) * np.float32(0.97)
        full = full + self._lights.sun_colour * self._lights.sun[2]
        share = np.clip((light.sky + light.sun) / full, np.float32(0), np.float32(1)).mean(1, keepdims=True)
        share = np.float32(0.35) + np.float32(0.65) * share
        return np.asarray(background * share, np.float32)


def tone_mapped(colour: Floats, exposure: float = 1.0) -> Floats:
    """Linear RGB to sRGB in 0 to 1; highlights roll off and keep their hue (after the Khronos PBR neutral curve)."""
    x = np.maximum(colour * np.float32(exposure), np.float32(0))
    start, fall = np.float32(0.72), np.float32(0.28)
    bright = np.flatnonzero(largest(x) > start)
    if len(bright):
        high = x.take(bright, 0)
        peak = largest(high)
        over = peak - start
        pressed = start + over * fall / (over + fall)
        white = 1 - 1 / (np.float32(0.15) * (peak - pressed) + 1)
        x[bright] = high * (pressed / peak * (1 - white))[:, None] + (pressed * white)[:, None]
    curve = np.float32(1.055) * x ** np.float32(1 / 2.4) - np.float32(0.055)
    return np.asarray(np.maximum(curve, np.minimum(x, np.float32(0.0031308)) * np.float32(12.92)), np.float32)
