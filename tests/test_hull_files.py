"""A hull is the same to the engine as points of the spec and as a file of it, which the engine remembers."""

import mujoco
import numpy as np
import pytest

from tests.bench.hull_rooms import step
from tests.sim_rooms import put, scene
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset, Shape
from thinkblox.sim.build import add_geom, build_spec, compiled, new_spec
from thinkblox.sim.settings import Physics

NAMES_OF_FILES = {"_sizes", "mesh_pathadr", "paths"}


def model(shapes: tuple[Shape, ...], *, inline: bool) -> mujoco.MjModel:
    spec = new_spec(Physics())
    body = spec.worldbody.add_body()
    for shape in shapes:
        add_geom(spec, body, shape, inline=inline).mass = 1.0
    return compiled(spec)


@pytest.mark.parametrize("kind", [step(3, 0).asset, make_asset("bowl", seed=0)], ids=["prisms", "bowl"])
def test_the_model_is_the_same_to_the_bit(kind: Asset) -> None:
    shapes = kind.links[0].shapes
    assert any(shape.kind == "hull" for shape in shapes)
    inline = model(shapes, inline=True)
    for known in (model(shapes, inline=False), model(shapes, inline=False)):
        for name in dir(inline):
            values = getattr(inline, name)
            if isinstance(values, np.ndarray) and name not in NAMES_OF_FILES:
                assert np.array_equal(values, getattr(known, name)), name


def test_a_hull_of_one_asset_is_never_that_of_another() -> None:
    """The engine remembers by name, whoever built the model."""
    sizes = []
    for scale in (1.0, 2.0, 1.0):
        corners = tuple((scale * x, scale * y, scale * z) for x in (0, 1) for y in (0, 1) for z in (0, 1))
        shape = Shape(kind="hull", size=(scale, scale, scale), position=(0.0, 0.0, 0.0), points=corners)
        sizes.append(float(np.ptp(model((shape,), inline=False).mesh_vert, axis=0)[0]))
    assert sizes == pytest.approx([1.0, 2.0, 1.0])


def test_a_written_spec_needs_no_files() -> None:
    bowl = make_asset("bowl", seed=0)
    spec = build_spec(scene(None, (put(bowl, 2.0, 2.0), bowl)), visuals=True)
    spec.compile()
    assert mujoco.MjModel.from_xml_string(spec.to_xml()).nmesh > 0
