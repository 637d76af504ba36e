"""Meshes with textures in the pictures: their colours, which way up they are, and that nothing else changes."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.textured import chequered_png, crate, crate_scene, without_visuals
from thinkblox.scene.texture import put_texture
from thinkblox.scene.visuals import Look
from thinkblox.sim.render import cast, framed, render_asset, render_preview, render_top
from thinkblox.sim.render.materials import reflectance_of
from thinkblox.sim.render.soup import Soup, pose_of
from thinkblox.sim.render.texture_map import FINEST, texture_map


def painted(picture: NDArray[np.uint8]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which pixels are red, and which are blue."""
    red, green, blue = (picture[..., channel].astype(int) for channel in range(3))
    return (red > green + 80) & (red > blue + 80), (blue > green + 60) & (blue > red + 80)


@pytest.mark.parametrize("render", [render_preview, render_top])
def test_textures_are_drawn(render: object) -> None:
    red, blue = painted(np.asarray(render(crate_scene(), size=192)))  # type: ignore[operator]
    plain = np.asarray(render(crate_scene(without_visuals(crate())), size=192))  # type: ignore[operator]
    assert red.sum() > 60
    assert blue.sum() > 60
    assert not any(colour.any() for colour in painted(plain))


def test_a_texture_stands_upright() -> None:
    red, blue = painted(np.asarray(render_asset(crate(), size=96))[40:])
    rows = np.arange(len(red))[:, None]
    assert (red * rows).sum() / red.sum() < (blue * rows).sum() / blue.sum() - 5


def test_frames_show_them_too() -> None:
    camera = framed(np.array([[1.2, 1.2, 0.0], [1.8, 1.8, 0.6]]), azimuth=-60.0, elevation=20.0)
    red, blue = painted(cast(crate_scene(), camera, size=64).colour)
    assert red.sum() > 30
    assert blue.sum() > 30


def test_the_shapes_under_a_mesh_are_not_drawn() -> None:
    soup = Soup()
    soup.add_asset(crate(), pose_of((0.0, 0.0, 0.0), 0.0), 0)
    assert [patch.look is not None for patch in soup.patches] == [True, True]
    assert soup.triangles().uv is not None
    assert max(mesh.vertices[:, 2].max() for mesh in soup.meshes) == pytest.approx(0.555)
    plain = Soup()
    plain.add_asset(without_visuals(crate()), pose_of((0.0, 0.0, 0.0), 0.0), 0)
    assert len(plain.patches) == 3
    assert plain.triangles().uv is None


def test_a_texture_repeats_and_blurs() -> None:
    texture = texture_map(put_texture(chequered_png(cells=4, cell=8)))
    assert texture.size == (32, 32)
    uv = np.array([[0.125, 0.875], [0.125, 0.125], [0.375, 0.125], [1.125, -1.125]], np.float32)
    red, white, blue, again = texture.colours(uv, np.ones(4, np.float32))
    assert red[0] > 0.5 > 0.1 > red[2]
    assert white == pytest.approx(0.87, abs=0.02)
    assert blue[2] > 0.5 > 0.1 > blue[0]
    assert again == pytest.approx(red)
    far = texture.colours(uv, np.full(4, 64.0, np.float32))
    np.testing.assert_allclose(far, np.tile(texture.mean, (4, 1)), atol=1e-6)


def test_a_large_texture_is_drawn_smaller() -> None:
    assert max(texture_map(put_texture(chequered_png(cells=2, cell=FINEST))).size) <= FINEST


def test_what_a_metre_shows() -> None:
    soup = Soup()
    soup.add_asset(crate(), pose_of((0.0, 0.0, 0.0), 0.0), 0)
    patch = soup.patches[0]
    sides = 2 * (0.6 * 0.8 + 0.6 * 0.5 + 0.8 * 0.5)
    assert patch.density == pytest.approx((6 / sides) ** 0.5, rel=1e-5)
    assert replace(patch, look=Look()).mean_colour == patch.colour
    assert patch.mean_colour[1] < patch.colour[1]


def test_metal_mirrors_and_chalk_does_not() -> None:
    chalk, metal = reflectance_of(Look(roughness=1.0)), reflectance_of(Look(roughness=0.3, metallic=1.0))
    assert chalk.mirror == 0.0
    assert metal.mirror > 0.5
    assert metal.gloss > 50 * chalk.gloss
    assert (metal.tinted, chalk.tinted) == (True, False)
