"""A hull is the same to the engine as points that its cache knows and as the OBJ file that is exported."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

from tests.bench.hull_rooms import step
from tests.sim_rooms import put, scene
from thinkblox.assets import make_asset
from thinkblox.exporters.hulls import hull_mesh, hull_obj
from thinkblox.exporters.mjcf import mjcf_text, write_mjcf
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.asset import Asset, Shape
from thinkblox.sim.build import add_geom, build_spec, compiled, new_spec
from thinkblox.sim.geometry.solid import shape_volume
from thinkblox.sim.settings import Physics


def model(shapes: tuple[Shape, ...]) -> mujoco.MjModel:
    spec = new_spec(Physics())
    body = spec.worldbody.add_body()
    for shape in shapes:
        add_geom(spec, body, shape).mass = 1.0
    return compiled(spec)


@pytest.mark.parametrize("kind", [step(3, 0).asset, make_asset("bowl", seed=0)], ids=["prisms", "bowl"])
def test_the_exported_model_is_the_measured_one(kind: Asset, tmp_path: Path) -> None:
    assert any(shape.kind == "hull" for shape in kind.links[0].shapes)
    room = scene(None, (put(kind, 2.0, 2.0), kind))
    inventory = inventory_of(room)
    write_mjcf(inventory, tmp_path / "scene.xml")
    measured = build_spec(room).compile()
    for found in (
        mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml")),
        mujoco.MjModel.from_xml_string(mjcf_text(inventory)),
    ):
        np.testing.assert_allclose(found.body_mass, measured.body_mass, rtol=1e-9)
        np.testing.assert_allclose(found.body_inertia, measured.body_inertia, rtol=1e-5)
        np.testing.assert_allclose(found.body_ipos, measured.body_ipos, atol=1e-6)
        solid = found.geom_contype > 0
        np.testing.assert_allclose(found.geom_aabb[solid], measured.geom_aabb, atol=1e-6)
        np.testing.assert_allclose(found.geom_pos[solid], measured.geom_pos, atol=1e-6)


def test_hulls_are_files_that_others_read(tmp_path: Path) -> None:
    bowl = make_asset("bowl", seed=0)
    shapes = [shape for link in bowl.links for shape in link.shapes if shape.kind == "hull"]
    write_mjcf(inventory_of(scene(None, (put(bowl, 2.0, 2.0), bowl))), tmp_path / "scene.xml")
    for shape in shapes:
        name, data = hull_obj(shape.points, smooth=shape.smooth)
        read = trimesh.load_mesh(tmp_path / name, process=False)
        assert (tmp_path / name).read_bytes() == data
        assert read.volume == pytest.approx(shape_volume(shape), rel=1e-5)
        assert (read.face_normals * (read.triangles_center - read.vertices.mean(axis=0))).sum(axis=1).min() > 0.0
    assert " vertex=" not in (tmp_path / "scene.xml").read_text()
    assert "file=" not in mjcf_text(inventory_of(scene(None, (put(bowl, 2.0, 2.0), bowl))))


def test_points_inside_a_hull_are_no_corners_of_it() -> None:
    cube = tuple((x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0))
    found = hull_mesh((*cube, (0.5, 0.5, 0.5), (0.5, 0.5, 0.2)), smooth=False)
    assert (len(found.points), len(found.faces)) == (8, 12)


def test_a_hull_of_one_asset_is_never_that_of_another() -> None:
    """The engine remembers by name, whoever built the model."""
    sizes = []
    for scale in (1.0, 2.0, 1.0):
        corners = tuple((scale * x, scale * y, scale * z) for x in (0, 1) for y in (0, 1) for z in (0, 1))
        shape = Shape(kind="hull", size=(scale, scale, scale), position=(0.0, 0.0, 0.0), points=corners)
        sizes.append(float(np.ptp(model((shape,)).mesh_vert, axis=0)[0]))
    assert sizes == pytest.approx([1.0, 2.0, 1.0])
