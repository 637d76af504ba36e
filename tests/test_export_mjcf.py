"""scene.xml as plain mujoco reads it."""

from pathlib import Path

import mujoco
import numpy as np
import pytest

from tests.export_rooms import sample_scene
from thinkblox.exporters.mjcf import mjcf_text, write_mjcf
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.verdict.settle import settle


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(sample_scene())))


def test_it_is_the_model_that_was_measured(model: mujoco.MjModel) -> None:
    measured = build_spec(sample_scene()).compile()
    names = [measured.body(i).name for i in range(measured.nbody)]
    assert [model.body(i).name for i in range(model.nbody)] == names
    np.testing.assert_allclose(model.body_mass, measured.body_mass, rtol=1e-5)
    np.testing.assert_allclose(model.body_ipos, measured.body_ipos, atol=2e-6)
    np.testing.assert_allclose(model.body_inertia, measured.body_inertia, rtol=1e-4, atol=1e-8)
    np.testing.assert_allclose(model.body_pos, measured.body_pos, atol=1e-9)
    np.testing.assert_allclose(model.body_quat, measured.body_quat, atol=1e-9)
    np.testing.assert_allclose(model.jnt_range, measured.jnt_range, atol=1e-5)
    assert (model.opt.timestep, model.opt.cone, model.opt.integrator) == (
        measured.opt.timestep, measured.opt.cone, measured.opt.integrator,
    )  # fmt: skip


def test_placements_are_its_reference_pose(model: mujoco.MjModel) -> None:
    for placement in sample_scene().placements:
        np.testing.assert_allclose(model.body(placement.id).pos, placement.position, atol=1e-9)


def test_keyframe_settled_rests_without_deep_contacts_or_warnings(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    np.testing.assert_allclose(data.qpos, settle(sample_scene()).qpos, atol=1e-9)
    assert not data.qvel.any()
    mujoco.mj_forward(model, data)
    assert all(contact.dist > -0.001 for contact in data.contact)
    start = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=250)
    assert np.abs(data.qpos - start).max() < 1e-3
    assert not any(warning.number for warning in data.warning)


def test_the_text_stands_by_itself() -> None:
    text = mjcf_text(inventory_of(sample_scene()))
    assert "file=" not in text
    assert "/work" not in text
    assert "/tmp" not in text
    assert '\n  <worldbody>\n    <geom name="floor"' in text
    assert f"mujoco {mujoco.__version__}" in text.partition("<custom>")[2]
    assert text.partition("<mesh ")[2].partition("/>")[0].count("vertex=") == 1


def test_the_same_scene_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a.xml", "b.xml"):
        write_mjcf(inventory_of(sample_scene()), tmp_path / name)
    assert (tmp_path / "a.xml").read_bytes() == (tmp_path / "b.xml").read_bytes()


def test_the_first_view_shows_the_room(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    camera = model.camera("overview").id
    towards = model.stat.center - data.cam_xpos[camera]
    ahead = -data.cam_xmat[camera].reshape(3, 3)[:, 2]
    np.testing.assert_allclose(ahead, towards / np.linalg.norm(towards), atol=1e-4)
    assert data.cam_xpos[camera][2] > sample_scene().room.height


def test_an_empty_room_is_a_model_too() -> None:
    model = mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(Scene(room=sample_scene().room))))
    assert (model.nbody, model.nkey) == (1, 1)
