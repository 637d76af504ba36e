"""Doors that open and windows with panes: what is measured stays as it is, and nothing of theirs is in its way."""

from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from PIL import Image
from pxr import Usd, UsdPhysics

import thinkblox
from tests.export_rooms import L_ROOM, sample_scene
from thinkblox.cli import main
from thinkblox.exporters.exporting import export_scene
from thinkblox.exporters.saving import write_scene
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene

LEAF = "door_1_frame_door_leaf"


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return thinkblox.to_mjmodel(sample_scene(), doors=True)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("doors") / "out"
    return export_scene(sample_scene(), out, formats=("mjcf", "usd", "glb", "urdf", "sdf"), doors=True)


def at_rest(model: mujoco.MjModel) -> mujoco.MjData:
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_forward(model, data)
    return data


def pushed(model: mujoco.MjModel, steps: int = 1000) -> mujoco.MjData:
    """With a torque of 2 N m on every door of the room."""
    data = at_rest(model)
    for name in (model.joint(i).name for i in range(model.njnt)):
        if name.endswith("door_leaf"):
            data.qfrc_applied[model.joint(name).dofadr[0]] = 2.0
    mujoco.mj_step(model, data, nstep=steps)
    return data


def test_what_was_measured_stays_as_it_is(model: mujoco.MjModel) -> None:
    plain = thinkblox.to_mjmodel(sample_scene())
    bodies, dofs = plain.nbody, plain.nv
    assert [model.body(i).name for i in range(bodies)] == [plain.body(i).name for i in range(bodies)]
    assert [model.body(i).name for i in range(bodies, model.nbody)] == ["door_1_frame", LEAF, "window_1_frame"]
    for name in ("mass", "inertia", "pos", "quat", "ipos", "iquat"):
        np.testing.assert_array_equal(getattr(model, f"body_{name}")[:bodies], getattr(plain, f"body_{name}"))
    np.testing.assert_array_equal(model.dof_frictionloss[:dofs], plain.dof_frictionloss)
    np.testing.assert_array_equal(model.key("settled").qpos[: plain.nq], plain.key("settled").qpos)
    assert not model.key("settled").qpos[plain.nq :].any()


def test_shut_doors_touch_nothing_and_sleep(model: mujoco.MjModel) -> None:
    data = at_rest(model)
    hung = {model.body(name).id for name in ("door_1_frame", LEAF, "window_1_frame")}
    assert not any(hung & set(model.geom_bodyid[contact.geom].tolist()) for contact in data.contact)
    before = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=500)
    assert (data.tree_asleep >= 0).all()
    np.testing.assert_allclose(data.qpos, before, atol=1e-5)


def test_a_door_opens_into_the_room_and_moves_nothing(model: mujoco.MjModel) -> None:
    data = pushed(model)
    joint = model.joint(LEAF)
    assert np.degrees(data.qpos[joint.qposadr[0]]) == pytest.approx(90.0, abs=1.0)
    assert data.site(f"{LEAF}_handle").xpos[1] > 0.6
    np.testing.assert_allclose(data.qpos[:-1], model.key("settled").qpos[:-1], atol=1e-4)


def test_robots_pass_an_open_door_and_no_window(model: mujoco.MjModel) -> None:
    geom = np.zeros(1, np.int32)
    solid = np.array([0, 0, 0, 1, 0, 0], np.uint8)

    def free(data: mujoco.MjData, start: tuple[float, ...], way: tuple[float, ...]) -> float:
        found = mujoco.mj_ray(model, data, np.array(start), np.array(way), solid, 1, -1, geom)
        return float("inf") if found < 0 else float(found)

    shut, opened = at_rest(model), pushed(model)
    through = ((5.4, 0.5, 1.5), (0.0, -1.0, 0.0))
    assert free(shut, *through) == pytest.approx(0.53, abs=0.01)
    assert free(opened, *through) == np.inf
    assert free(opened, (5.5, 1.3, 1.5), (1.0, 0.0, 0.0)) < 0.6


@pytest.mark.parametrize("hinge", ["start", "end"])
def test_the_hinge_is_where_the_room_has_it(hinge: str) -> None:
    opening = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.0, hinge=hinge)  # type: ignore
    model = thinkblox.to_mjmodel(Scene(room=rectangle(3.0, 3.0, openings=(opening,))), doors=True)
    x, y, _ = pushed(model).site(f"{LEAF}_handle").xpos
    assert x == pytest.approx(1.0 if hinge == "start" else 1.9, abs=0.1)
    assert y > 0.6


def test_a_door_that_opens_outwards_turns_out_of_the_room() -> None:
    out = Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.7, height=2.0, opens="out")
    scene = Scene(room=rectangle(2.0, 2.0, openings=(out,)))
    model = thinkblox.to_mjmodel(scene, doors=True)
    assert at_rest(model).site(f"{LEAF}_handle").xpos[1] > -0.3
    assert pushed(model).site(f"{LEAF}_handle").xpos[1] < -0.5


def test_every_format_has_them(folder: Path) -> None:
    stage = Usd.Stage.Open(str(folder / "scene.usda"))
    joint = UsdPhysics.RevoluteJoint(stage.GetPrimAtPath(f"/World/Objects/door_1_frame/Joints/{LEAF}"))
    assert (joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()) == (0.0, 90.0)
    assert UsdPhysics.FixedJoint(stage.GetPrimAtPath("/World/Objects/door_1_frame/Joints/mount"))
    assert not stage.GetPrimAtPath("/World/Objects/window_1_frame").HasAPI(UsdPhysics.RigidBodyAPI)
    assert mujoco.MjModel.from_xml_path(str(folder / "scene.urdf")).joint(f"{LEAF}_joint").range[1] == pytest.approx(
        np.pi / 2
    )
    models = {model.get("name") for model in ElementTree.parse(folder / "scene.sdf").iterfind("world/model")}
    assert {"door_1_frame", "window_1_frame"} <= models
    assert LEAF.encode() in (folder / "scene.glb").read_bytes()


def test_a_pane_is_drawn_once(folder: Path) -> None:
    """What the room shows of a window with a pane of its own is the board and the curtains alone."""
    stage = Usd.Stage.Open(str(folder / "scene.usda"))
    looks = stage.GetPrimAtPath("/World/Room/window_1/Visual/Looks").GetChildren()
    assert not [prim.GetName() for prim in looks if prim.GetName().startswith("pane")]


def test_exported_rooms_with_doors_pass(folder: Path) -> None:
    assert thinkblox.verify_file(folder / "scene.usda").valid


def test_a_door_beside_a_corner_that_points_in_does_not_turn() -> None:
    opening = Opening(id="door_1", kind="door", wall=3, offset=0.0, width=0.9, height=2.0)
    room = Room(floor=L_ROOM.floor, openings=(opening,))
    model = thinkblox.to_mjmodel(Scene(room=room), doors=True)
    assert model.njnt == 0
    assert model.body("door_1_frame").id > 0


def test_openings_of_any_size_are_filled() -> None:
    sizes = [(0.02, 0.05), (0.1, 2.6), (3.0, 0.3)]
    openings = tuple(
        Opening(id=f"{kind}_{i}", kind=kind, wall=wall, offset=0.5 + i, width=width, height=height)  # type: ignore
        for wall, kind in enumerate(("door", "window"))
        for i, (width, height) in enumerate(sizes)
    )
    model = thinkblox.to_mjmodel(Scene(room=rectangle(8.0, 8.0, openings=openings)), doors=True)
    data = at_rest(model)
    assert not data.ncon
    mujoco.mj_step(model, data, nstep=400)
    assert (data.tree_asleep >= 0).all()


def test_an_opening_and_an_object_of_one_name() -> None:
    first = sample_scene().placements[0]
    renamed = sample_scene().without(first.id)
    placement = thinkblox.Placement(
        id="door_1_frame", category=first.category, asset=first.asset, position=first.position, yaw=first.yaw,
        size=first.size,
    )  # fmt: skip
    whole = renamed.with_placement(placement, sample_scene().asset_of(first))
    model = thinkblox.to_mjmodel(whole, doors=True)
    assert model.body("door_1_frame").mass[0] == pytest.approx(25.0)
    assert model.body("door_1_frame_2").id > model.body("door_1_frame").id


def test_the_command_asks_for_them(tmp_path: Path) -> None:
    write_scene(sample_scene(), tmp_path / "room.json")
    out = tmp_path / "out"
    said = ["--to", "mjcf,usd", "--doors", "--thumbnails"]
    assert main(["export", str(tmp_path / "room.json"), *said, "--out", str(out)]) == 0
    assert Image.open(out / ".thumbs/256x256/scene.usda.png").size == (256, 256)
    assert mujoco.MjModel.from_xml_path(str(out / "scene.xml")).body(LEAF).id > 0
    assert thinkblox.load_scene(out) == thinkblox.load_scene(tmp_path / "room.json")
    assert sample_scene().export(tmp_path / "room.xml", doors=True).read_text().count(LEAF) > 1
