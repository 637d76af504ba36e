"""A room as an environment: dm_control's and Gymnasium's own checks, and what a robot meets in it."""

import sys
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import mujoco
import numpy as np
import pytest
import shapely
from absl.testing import absltest
from dm_env import test_utils
from gymnasium.utils.env_checker import check_env

from tests.environment_rooms import FLOATING, MOUNTED, full_room, robot_room
from tests.sim_rooms import asset, box, put
from thinkblox.errors import InputError
from thinkblox.exporters.mjcf import mjcf_text
from thinkblox.exporters.saving import write_scene
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.sim.environment import (
    Pictures,
    RandomPolicy,
    ScriptedCarry,
    ScriptedDrive,
    ScriptedOpen,
    ScriptedReach,
    make_environment,
    run_episode,
    vector_environment,
)

ROOM = robot_room()
RAYS = Pictures(("eye",), ("rgb", "depth", "segmentation"), (36, 48), "rays")


def put_robot(environment: Any, x: float, y: float, yaw: float) -> None:
    """Stand the robot somewhere, whatever is there."""
    from thinkblox.sim.environment.places import RobotPlace

    errand = environment.task.errand
    errand.index.put_robot(RobotPlace(x, y, errand.robot.lift, yaw))


class DriveAsDmEnv(test_utils.EnvironmentTestMixin, absltest.TestCase):  # type: ignore[misc]
    def make_object_under_test(self) -> Any:
        return make_environment(ROOM, "drive", "wardrobe_1", seed=0, time_limit=0.5)


class OpenAsDmEnv(test_utils.EnvironmentTestMixin, absltest.TestCase):  # type: ignore[misc]
    def make_object_under_test(self) -> Any:
        return make_environment([ROOM, ROOM], "open", seed=0, time_limit=0.5, pictures=RAYS)


@pytest.mark.parametrize("task", ["Drive", "Reach", "Open", "Carry"])
def test_gymnasium_finds_nothing_to_complain_of(task: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        environment = gymnasium.make(f"ThinkBLOX/{task}-v0", room=ROOM, render_mode="rgb_array", pictures=RAYS)
        check_env(environment.unwrapped)
        assert environment.metadata["render_fps"] == 25


@pytest.mark.parametrize(("task", "robot"), [("drive", "base"), ("carry", "picker"), ("reach", "jaco")])
def test_a_thousand_random_actions_raise_no_warning(task: str, robot: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        environment = make_environment(ROOM, task, robot=robot, seed=3, time_limit=100.0)  # type: ignore[arg-type]
        ran = run_episode(environment, RandomPolicy(environment, seed=3), steps=1000)
    assert ran.steps == 1000 or ran.reached
    assert not any(warning.number for warning in environment.physics.data.ptr.warning)
    assert np.isfinite(environment.physics.data.qpos).all()


def test_the_arena_is_the_model_that_is_exported() -> None:
    exported = mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(ROOM)))
    environment = make_environment(ROOM, "drive", seed=0)
    model = environment.physics.model.ptr
    for body in range(1, exported.nbody):
        name = exported.body(body).name
        np.testing.assert_allclose(model.body(name).mass, exported.body_mass[body], rtol=1e-9)
        np.testing.assert_allclose(model.body(name).inertia, exported.body_inertia[body], rtol=1e-6)
    assert (model.opt.timestep, model.opt.cone) == (exported.opt.timestep, exported.opt.cone)
    assert model.opt.enableflags & mujoco.mjtEnableBit.mjENBL_SLEEP


def test_everything_begins_where_it_rests_and_the_robot_where_there_is_room() -> None:
    environment = make_environment(ROOM, "drive", "wardrobe_1", seed=5)
    rest, errand = inventory_of(ROOM).state, environment.task.errand
    seen = set()
    for _ in range(20):
        environment.reset()
        x, y, yaw = errand.index.pose
        seen.add((round(x, 1), round(y, 1), round(yaw, 1)))
        assert shapely.contains_xy(errand.places.floor, x, y)
        assert errand.index.robot_is_clear()
        assert not errand.goal.reached()
        np.testing.assert_allclose(environment.physics.data.qpos[: len(rest.qpos)], rest.qpos, atol=1e-9)
    assert len(seen) > 15


def test_the_same_seed_is_the_same_episode() -> None:
    told = []
    for _ in range(2):
        environment = make_environment(ROOM, "open", seed=11)
        first, policy = environment.reset(), RandomPolicy(environment, seed=2)
        told.append([first, *(environment.step(policy(first)) for _ in range(20))])
    for one, other in zip(*told, strict=True):
        assert one.reward == other.reward
        for name, value in one.observation.items():
            np.testing.assert_array_equal(value, other.observation[name])


def test_what_is_told_is_where_things_are() -> None:
    environment = make_environment(ROOM, "carry", "vase_1", destination="desk_1", seed=0)
    told = environment.reset().observation
    np.testing.assert_allclose(told["target_position"], (1.3, 1.2, 0.9), atol=2e-3)
    np.testing.assert_allclose(told["destination_position"], (3.6, 2.4, 0.75), atol=2e-3)
    put_robot(environment, 2.5, 1.2, np.pi / 2)
    told = environment.step(np.zeros(5)).observation
    np.testing.assert_allclose(told["robot_pose"], (2.5, 1.2, 0.0, 1.0), atol=1e-2)
    np.testing.assert_allclose(told["target_from_robot"], (0.0, 1.2, 0.9), atol=2e-2)
    np.testing.assert_allclose(told["tool_from_robot"], (0.0, 0.19, 0.32), atol=1e-2)


def test_driving_is_done_when_the_object_is_at_hand() -> None:
    environment = make_environment(ROOM, "drive", "wardrobe_1", seed=0)
    environment.reset()
    put_robot(environment, 1.5, 3.6, 0.0)
    told = environment.step(np.zeros(2))
    # Its front is at 4.35 m.
    assert not told.last()
    assert told.reward == pytest.approx(0.0, abs=1e-4)
    put_robot(environment, 1.5, 3.85, 0.0)
    told = environment.step(np.zeros(2))
    assert told.last()
    assert told.discount == 0.0
    assert told.reward == pytest.approx(1.0, abs=1e-4)


def test_rewards_of_an_episode_add_up_to_what_it_came_nearer_and_one() -> None:
    environment = make_environment(ROOM, "drive", "wardrobe_1", seed=1)
    environment.reset()
    goal = environment.task.goal
    total, policy = 0.0, ScriptedDrive(environment)
    told = environment.reset()
    start = goal.nearness()
    while not told.last():
        told = environment.step(policy(told))
        total += told.reward
    assert told.discount == 0.0
    assert total == pytest.approx(1.0 + goal.nearness() - start)


@pytest.mark.parametrize("robot", ["base", "picker"])
def test_the_script_drives_to_everything(robot: str) -> None:
    environment = make_environment(ROOM, "drive", robot=robot, seed=4)
    for _ in range(4):
        assert run_episode(environment, ScriptedDrive(environment)).reached, environment.task.goal.says()


@pytest.mark.parametrize("door", ["wardrobe_1/door_left", "wardrobe_1_door_right"])
def test_the_script_opens_doors(door: str) -> None:
    environment = make_environment(ROOM, "open", door, seed=2)
    ran = run_episode(environment, ScriptedOpen(environment))
    assert ran.reached
    assert environment.task.goal.share >= 0.6


@pytest.mark.parametrize("target", ["desk_1", "vase_1", "wardrobe_1"])
def test_the_script_reaches_things(target: str) -> None:
    environment = make_environment(ROOM, "reach", target, seed=3)
    assert run_episode(environment, ScriptedReach(environment)).reached


def test_the_script_carries_a_vase_to_another_table() -> None:
    environment = make_environment(ROOM, "carry", "vase_1", destination="desk_1", seed=0)
    ran = run_episode(environment, ScriptedCarry(environment))
    assert ran.reached
    x, y, z = environment.physics.data.ptr.body("vase_1").xpos
    assert abs(x - 3.6) < 0.6
    assert abs(y - 2.4) < 0.4
    assert z == pytest.approx(0.75, abs=0.01)


def test_what_has_no_flat_top_is_not_carried_by_the_script() -> None:
    walls = [box((0.02, 0.2, 0.1), (x, 0.0, 0.05)) for x in (-0.09, 0.09)]
    kind = asset("trough", (0.2, 0.2, 0.1), box((0.16, 0.2, 0.02), (0.0, 0.0, 0.01)), *walls, mass=0.5)
    scene = ROOM.with_placement(put(kind, 1.7, 1.2, 0.75, on="table_1"), kind)
    environment = make_environment(scene, "carry", "trough_1", destination="desk_1", seed=0)
    with pytest.raises(InputError, match="not flat"):
        ScriptedCarry(environment)(environment.reset())


def test_a_thing_is_carried_when_it_stands_there_and_is_let_go() -> None:
    environment = make_environment(ROOM, "carry", "vase_1", destination="desk_1/top", seed=0)
    environment.reset()
    goal, data = environment.task.goal, environment.physics.data.ptr
    at = int(environment.physics.model.ptr.joint("vase_1_free").qposadr[0])
    assert not goal.reached()
    data.qpos[at : at + 3] = (3.4, 2.4, 1.2)
    mujoco.mj_forward(environment.physics.model.ptr, data)
    assert not goal.reached()
    data.qpos[at : at + 3] = (3.4, 2.4, 0.751)
    told = environment.step(np.zeros(5))
    assert told.last()
    assert told.discount == 0.0


def test_nothing_drives_out_by_a_doorway() -> None:
    environment = make_environment(ROOM, "drive", "wardrobe_1", seed=0)
    environment.reset()
    put_robot(environment, 3.65, 0.6, -np.pi / 2)
    for _ in range(100):
        environment.step(np.array([0.6, 0.0]))
    assert -0.3 < environment.task.errand.index.pose[1] < 0.4


def test_pictures_say_which_object_is_where() -> None:
    environment = make_environment(ROOM, "drive", "wardrobe_1", robot="picker", seed=0, pictures=RAYS)
    environment.reset()
    put_robot(environment, 1.5, 2.6, np.pi / 2)
    told = environment.step(np.zeros(5)).observation
    labels = environment.task.errand.picturing.labels
    assert labels == ("room", "table_1", "vase_1", "desk_1", "wardrobe_1", "robot")
    shown = told["eye_segmentation"]
    assert labels[shown[18, 24]] == "wardrobe_1"
    # The camera looks down by 20 degrees, and depth is along where it looks.
    assert told["eye_depth"][18, 24] == pytest.approx((4.35 - 2.6) / np.cos(np.radians(20)), abs=0.05)
    assert told["eye_rgb"].shape == (36, 48, 3)
    assert told["eye_rgb"].std() > 10.0


def drawn(pictures: Pictures) -> dict[str, Any]:
    try:
        environment = make_environment(ROOM, "drive", seed=0, pictures=pictures)
        return environment.reset().observation  # type: ignore[no-any-return]
    except InputError as error:
        pytest.skip(str(error))


def test_opengl_shows_the_same_objects_as_rays_do() -> None:
    shown = {}
    for renderer in ("gl", "rays"):
        looks = Pictures(("corner_1",), ("segmentation", "depth"), (60, 80), renderer)
        shown[renderer] = drawn(looks)
    same = shown["gl"]["corner_1_segmentation"] == shown["rays"]["corner_1_segmentation"]
    assert same.mean() > 0.98
    gl, rays = (shown[each]["corner_1_depth"][same] for each in ("gl", "rays"))
    # OpenGL takes one of several samples of a pixel, not its middle.
    assert np.median(np.abs(gl - rays) / rays) < 0.02


@pytest.mark.parametrize("mount", ["floor", "furniture"])
def test_an_arm_is_mounted_where_there_is_room(mount: str) -> None:
    environment = make_environment(ROOM, "reach", "vase_1", robot="jaco", mount=mount, seed=0)  # type: ignore[arg-type]
    for _ in range(5):
        environment.reset()
        x, y, _ = environment.task.errand.index.pose
        foot = (
            environment.physics.data.ptr.xpos[environment.task.errand.index.root, 2]
            - environment.task.errand.robot.lift
        )
        assert foot == pytest.approx(0.0 if mount == "floor" else 0.752, abs=1e-3)
        assert np.hypot(x - 1.3, y - 1.2) < 0.85
        assert environment.task.errand.index.robot_is_clear()
    assert environment.action_spec().shape == (9,)


def test_a_robot_of_ones_own_is_taken_as_it_is(tmp_path: Path) -> None:
    ship, arm = tmp_path / "ship.xml", tmp_path / "arm.xml"
    ship.write_text(FLOATING)
    arm.write_text(MOUNTED)
    sails = make_environment(
        ROOM, "drive", "wardrobe_1", robot=ship, seed=0, pictures=Pictures(("bow",), renderer="rays")
    )
    told = sails.reset()
    assert told.observation["bow_rgb"].shape == (84, 84, 3)
    model = sails.physics.model.ptr
    assert model.opt.timestep == 0.002
    np.testing.assert_allclose(model.joint("robot/flap").range, np.radians([-90, 90]), rtol=1e-5)
    mounted = make_environment(ROOM, "reach", "vase_1", robot=arm, seed=0)
    mounted.reset()
    assert mounted.task.errand.robot.tool == "robot/attachment_site"
    assert mounted.task.errand.robot.radius == pytest.approx(0.05, abs=1e-3)


@pytest.mark.slow
def test_another_room_each_episode(tmp_path: Path) -> None:
    for name, room in {"a": ROOM, "b": ROOM.without("desk_1"), "c": ROOM.without("wardrobe_1")}.items():
        (tmp_path / name).mkdir()
        write_scene(room, tmp_path / name / "scene.json")
    environment = make_environment(tmp_path, "open", seed=0)
    names = []
    for _ in range(4):
        environment.reset()
        names.append(environment.task.errand.room.name)
    assert set(names[:2]) == set(names[2:]) == {"a", "b"}
    assert "no doors or drawers" in environment.skipped["c"]
    assert environment.step(np.zeros(5)).observation.keys() == environment.observation_spec().keys()


def test_rooms_side_by_side(tmp_path: Path) -> None:
    for number in range(3):
        (tmp_path / f"room{number}").mkdir()
        write_scene(
            ROOM.moved("desk_1", position=(3.6, 2.4 - 0.2 * number, 0.0)), tmp_path / f"room{number}" / "scene.json"
        )
    side_by_side = vector_environment(tmp_path, "drive", target="desk")
    told, info = side_by_side.reset(seed=0)
    assert list(info["room"]) == ["room0", "room1", "room2"]
    np.testing.assert_allclose(told["target_position"][:, 1], (2.4, 2.2, 2.0), atol=1e-2)
    told, reward, *_ = side_by_side.step(side_by_side.action_space.sample())
    assert told["robot_pose"].shape == (3, 4)
    assert reward.shape == (3,)
    assert side_by_side.skipped == {}
    side_by_side.close()
    side_by_side = vector_environment([ROOM, tmp_path / "room1"], "open", target="wardrobe_1", render_mode="rgb_array")
    assert side_by_side.num_envs == 2
    side_by_side.close()
    without = ROOM.without("wardrobe_1")
    side_by_side = vector_environment([ROOM, without], "open")
    assert side_by_side.num_envs == 1
    assert side_by_side.skipped == {"room": "room: the room has no doors or drawers"}
    with pytest.raises(InputError, match="in none of the rooms: room: the room has no doors"):
        vector_environment([without, without], "open")


BAD: list[tuple[dict[str, Any], str]] = [
    ({"target": "wardrob_1"}, "no objects called 'wardrob_1'; the nearest are wardrobe_1"),
    ({"task": "open", "target": "desk_1"}, "desk_1 has no doors or drawers; wardrobe_1 would do"),
    ({"task": "open", "room": ROOM.without("wardrobe_1")}, "the room has no doors or drawers"),
    ({"task": "carry", "target": "table_1"}, "table_1 is more than 2 kg or 35 cm, or fixed; vase_1 would do"),
    ({"task": "carry", "destination": "dask_1"}, "no surfaces called 'dask_1'; the nearest are desk_1"),
    ({"task": "carry", "destination": "table_1"}, "vase_1 stand on table_1 already"),
    ({"task": "reach", "robot": "base"}, "has no tool to reach with; take 'picker'"),
    ({"task": "carry", "destination": "vase_1"}, "vase_1 has no surface that is open to above"),
    ({"task": "carry", "target": "mug"}, "no small objects, of at most 2 kg and 35 cm, called 'mug'"),
    ({"destination": "desk_1"}, "only 'carry' has a destination, not 'drive'"),
    ({"mount": "ceiling"}, "no mount 'ceiling'; there are any, floor, furniture"),
    ({"time_limit": 0}, "time_limit is 0; it must be a time above 0"),
    ({"seed": -1}, "the seed is -1; it must be a whole number"),
    ({"room": None}, "a NoneType is given for a Scene"),
    ({"robot": "mine.xml"}, "mine.xml: there is no such file"),
    ({"robot": "jaco"}, "is mounted and cannot drive"),
    ({"robot": "bass"}, "no robot 'bass'; there are base, picker, jaco, or give the path"),
    ({"task": "fly"}, "no task 'fly'; there are"),
    ({"room": full_room()}, "no free floor for the robot 'base', 0.3"),
    ({"room": "/nowhere"}, "no room is there; name a scene.json"),
    ({"pictures": Pictures(("nose",), renderer="rays")}, "no camera 'nose'; there are eye, overview, top, corner_1"),
]


@pytest.mark.parametrize(("options", "says"), BAD, ids=[says for _, says in BAD])
def test_what_cannot_be_done_is_said(options: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError) as refused:
        make_environment(**{"room": ROOM, "task": "drive", **options})
    assert says in str(refused.value)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("<mujoco>", "cannot be read as a robot"),
        ("<mujoco><worldbody><body><geom size='1'/></body></worldbody></mujoco>", "the robot has no actuators"),
    ],
)
def test_a_file_that_is_no_robot_is_refused(text: str, says: str, tmp_path: Path) -> None:
    (tmp_path / "robot.xml").write_text(text)
    with pytest.raises(InputError, match=says):
        make_environment(ROOM, "drive", robot=tmp_path / "robot.xml")


def test_the_extra_is_named_when_it_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "dm_control.composer", None)
    with pytest.raises(InputError, match=r"pip install 'thinkblox\[env\]'"):
        make_environment(ROOM, "drive")
