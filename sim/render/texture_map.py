"""Pictures on surfaces as linear light, halved again and again, so that a pixel finds the detail that it can show."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.texture import pixels_of
from thinkblox.scene.textured_mesh import TexturedMesh
from thinkblox.sim.render.tessellate import Floats, Ints

FINEST = 1024
"""Longest side of a texture as it is drawn [texels]."""


@dataclass(frozen=True)
class TextureMap:
    """Linear RGB (height, width, 3), its top row first, and the same at half the size, and so on."""

    levels: tuple[Floats, ...]

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the finest level [texels]."""
        return self.levels[0].shape[0], self.levels[0].shape[1]

    @property
    def mean(self) -> Floats:
        """Its mean colour, linear RGB (3,)."""
        return np.asarray(self.levels[-1].mean((0, 1)), np.float32)

    def colours(self, uv: Floats, texels: Floats) -> Floats:
        """Linear RGB (n, 3) at places (n, 2), for pixels that are so many of its finest texels wide (n,)."""
        finest = np.log2(np.maximum(texels, np.float32(1)))
        level = np.minimum(np.rint(finest).astype(np.int64), len(self.levels) - 1)
        found = np.empty((len(uv), 3), np.float32)
        for number in np.unique(level):
            mine = np.flatnonzero(level == number)
            found[mine] = _between_texels(self.levels[number], uv[mine])
        return found


def _between_texels(level: Floats, uv: Floats) -> Floats:
    """Bilinear, repeating; v counts upwards from the lowest row."""
    height, width, _ = level.shape
    x = uv[:, 0] * np.float32(width) - np.float32(0.5)
    y = (1 - uv[:, 1]) * np.float32(height) - np.float32(0.5)
    left, top = np.floor(x), np.floor(y)
    fx, fy = (x - left)[:, None], (y - top)[:, None]
    i, j = left.astype(np.int64) % width, top.astype(np.int64) % height
    i1, j1 = (i + 1) % width, (j + 1) % height
    high = level[j, i] * (1 - fx) + level[j, i1] * fx
    low = level[j1, i] * (1 - fx) + level[j1, i1] * fx
    return np.asarray(high * (1 - fy) + low * fy, np.float32)


@lru_cache(maxsize=32)
def texture_map(id: str) -> TextureMap:
    """The texture in a blob; raises InputError when there is none."""
    from PIL import Image

    pixels = pixels_of(id)
    factor = -(-max(pixels.shape) // FINEST)
    if factor > 1:
        pixels = np.asarray(Image.fromarray(pixels).reduce(factor))
    levels = [_linear_table()[pixels]]
    while min(levels[-1].shape[:2]) > 1:
        levels.append(_halved(levels[-1]))
    return TextureMap(tuple(levels))


@lru_cache(maxsize=1)
def _linear_table() -> Floats:
    """Linear light of each of the 256 sRGB values."""
    value = np.arange(256) / 255.0
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4).astype(np.float32)


def _halved(level: Floats) -> Floats:
    height, width = (side // 2 for side in level.shape[:2])
    blocks = level[: 2 * height, : 2 * width].reshape(height, 2, width, 2, 3)
    return np.asarray(blocks.mean((1, 3)), np.float32)


def stretch(mesh: TexturedMesh) -> float:
    """How much of a texture a metre of the mesh shows, as a share of the texture's side [1/m]."""
    surface = _areas(mesh.vertices.astype(np.float64), mesh.faces)
    flat = np.pad(mesh.uv.astype(np.float64), ((0, 0), (0, 1)))
    return float(np.sqrt(_areas(flat, mesh.faces) / max(surface, 1e-12)))


def _areas(points: NDArray[Any], faces: Ints) -> float:
    a, b, c = (points[faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
