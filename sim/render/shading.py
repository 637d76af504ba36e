"""From surfaces and the light on them to linear colours, and from those to pixels."""

import numpy as np

from thinkblox.sim.render.lighting import Irradiance, Lights
from thinkblox.sim.render.materials import MATERIALS
from thinkblox.sim.render.soup import SoupTriangles
from thinkblox.sim.render.surfels import Surfels
from thinkblox.sim.render.tessellate import Floats, Ints
from thinkblox.sim.render.textures import planks, weave, wood


class Shader:
    """The patches of a scene as tables, ready to colour points."""

    def __init__(self, triangles: SoupTriangles, lights: Lights, pixel: float) -> None:
        patches = triangles.patches
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
        self._density = np.array([p.density for p in patches], np.float32)
        self._textured = np.array([p.texture is not None for p in patches], bool)

    def colours(self, points: Surfels, light: Irradiance, background: Floats, spread: float) -> Floats:
        """Linear RGB (n, 3) of points.

        Args:
            points: what is seen.
            light: what arrives there.
            background: linear RGB (n, 3) behind the scene.
            spread: growth of a pixel's width with distance; 0 for an orthographic camera.
        """
        colour = np.empty((len(points.patch), 3), np.float32)
        material = np.where(points.patch < 0, np.int64(-1), self._material[points.patch])
        outside = (material < 0) | (material == MATERIALS.index("ground"))
        out, inside = np.flatnonzero(outside), np.flatnonzero(~outside)
        colour[out] = self._backdrop(points.patch[out], light[out], background[out])
        if len(out):
            colour[inside] = self._lit(points[inside], light[inside], material[inside], spread)
        else:
            colour = self._lit(points, light, material, spread)
        if points.clear is not None and points.shine is not None:
            colour = colour * points.clear + points.shine[:, None]
        return colour

    def _lit(self, points: Surfels, light: Irradiance, material: Ints, spread: float) -> Floats:
        cosine = np.clip(-np.einsum("ij,ij->i", points.normal, points.view), np.float32(0.05), np.float32(1))
        width = self._pixel + np.float32(spread) * points.distance
        base = self._base(points, material, width / cosine)
        grazing = 1 - cosine
        patch, finish = points.patch, self._finish
        scatter = finish["diffuse"][patch] + finish["sheen"][patch] * grazing**2
        colour = base * scatter[:, None] * (light.sky + light.sun)
        glow = finish["glow"][patch] * (np.float32(0.45) + np.float32(0.55) * cosine)
        colour += base * glow[:, None]
        shiny = np.flatnonzero(finish["mirror"][patch] > 0)
        bent = points.view[shiny] + 2 * cosine[shiny, None] * points.normal[shiny]
        colour[shiny] += self._shine(bent, light[shiny], patch[shiny], base[shiny], cosine[shiny])
        return np.asarray(colour, np.float32)

    def _shine(self, bent: Floats, light: Irradiance, patch: Ints, base: Floats, cosine: Floats) -> Floats:
        mirror, gloss = self._finish["mirror"][patch][:, None], self._finish["gloss"][patch][:, None]
        mirror = mirror + np.float32(0.35) * (1 - mirror) * (1 - cosine[:, None]) ** 5
        sharp = np.maximum(bent @ self._lights.sun, np.float32(0))[:, None] ** gloss
        sky = self._lights.sky(bent[:, 2]) * np.minimum(light.sky.mean(1, keepdims=True) * np.float32(1.5), 1)
        shine = mirror * (sky + sharp * np.sqrt(gloss) * np.float32(0.25) * light.sun)
        return np.asarray(np.where(self._finish["tinted"][patch][:, None] > 0, base * shine, shine), np.float32)

    def _base(self, points: Surfels, material: Ints, width: Floats) -> Floats:
        base = self._colour[points.patch]
        for name, paint in (
            ("floor", self._floor),
            ("wood", self._wood),
            ("fabric", self._fabric),
            ("pane", self._pane),
        ):
            mine = np.flatnonzero(material == MATERIALS.index(name))
            if len(mine):
                base[mine] = paint(points.patch[mine], points.position[mine], base[mine], width[mine])
        if points.uv is not None:
            self._paint_textures(points, base, width)
        return base

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
        return np.asarray(np.einsum("nij,ni->nj", self._turn[patch], position - self._origin[patch]), np.float32)

    def _floor(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        local = self._local(patch, position)
        tone, warmth = planks(local[:, 0], local[:, 1], width)
        return base * tone[:, None] * (1 + warmth[:, None] * np.array([1.0, 0.0, -1.0], np.float32))

    def _wood(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        local, axis, rows = self._local(patch, position), self._axis[patch], np.arange(len(base))
        along = local[rows, axis]
        across = local[rows, (axis + 1) % 3] + np.float32(0.8) * local[rows, (axis + 2) % 3]
        return base * wood(along, across, width, (patch % 97).astype(np.float32))[:, None]

    def _fabric(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        local = self._local(patch, position)
        return base * weave(local[:, 0] + local[:, 2], local[:, 1] + local[:, 2], width)[:, None]

    def _pane(self, patch: Ints, position: Floats, base: Floats, width: Floats) -> Floats:
        """A blurred garden under a pale sky."""
        high = self._local(patch, position)[:, 2] / self._size[patch, 2] + np.float32(0.5)
        stops = np.array([0.0, 0.22, 0.42, 1.0])
        views = np.array([[0.42, 0.52, 0.33], [0.62, 0.70, 0.52], [0.96, 0.95, 0.90], [0.66, 0.82, 0.98]])
        return np.stack([np.interp(high, stops, views[:, c]) for c in range(3)], 1).astype(np.float32)

    def _backdrop(self, patch: Ints, light: Irradiance, background: Floats) -> Floats:
        """Outside, only shadows show on a plain backdrop."""
        full = self._lights.sky(np.ones(1, np.float32)) * np.float32(0.97)
        full = full + self._lights.sun_colour * self._lights.sun[2]
        share = np.clip((light.sky + light.sun) / full, np.float32(0), np.float32(1)).mean(1, keepdims=True)
        share = np.where(patch[:, None] < 0, np.float32(1), np.float32(0.35) + np.float32(0.65) * share)
        return np.asarray(background * share, np.float32)


def tone_mapped(colour: Floats, exposure: float = 1.0) -> Floats:
    """Linear RGB to sRGB in 0 to 1; highlights roll off and keep their hue (after the Khronos PBR neutral curve)."""
    x = np.maximum(colour * np.float32(exposure), np.float32(0))
    start, fall = np.float32(0.72), np.float32(0.28)
    peak = x.max(-1, keepdims=True)
    over = np.maximum(peak - start, np.float32(0))
    pressed = start + over * fall / (over + fall)
    x = np.where(peak > start, x * (pressed / np.maximum(peak, np.float32(1e-6))), x)
    white = np.where(peak > start, 1 - 1 / (np.float32(0.15) * (peak - pressed) + 1), np.float32(0))
    x = x * (1 - white) + pressed * white
    curve = np.float32(1.055) * x ** np.float32(1 / 2.4) - np.float32(0.055)
    return np.asarray(np.where(x <= 0.0031308, x * np.float32(12.92), curve), np.float32)
