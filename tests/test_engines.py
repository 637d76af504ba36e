"""The bench of other engines: what its drivers are given, what is made of what they say, and one of them."""

import json
from pathlib import Path

import pytest
from pxr import Usd, UsdGeom, UsdPhysics

from tests.bench.engines.__main__ import PINS, driven, row
from tests.bench.engines.case import TILTED, moved, write_case
from tests.bench.engines.marble import marble_case, marble_told
from tests.bench.engines.page import page
from tests.environment_rooms import robot_room
from thinkblox.exporters.stocktaking import inventory_of

ROOM = robot_room()


def test_a_case_has_every_thing_where_it_rests_and_its_model(tmp_path: Path) -> None:
    case = write_case(ROOM, tmp_path / "room")
    assert json.loads((tmp_path / "room" / "case.json").read_text())["things"][0]["name"] == "table_1"
    items = inventory_of(ROOM, doors=True).objects
    for thing, item in zip(case["things"], items, strict=True):
        assert thing["mass"] == pytest.approx(sum(body.mass for body in item.bodies))
        assert Path(thing["model"]).is_file()
    assert [thing["name"] for thing in case["swinging"]] == ["wardrobe_1", "door_1_frame"]
    opened = case["swings"]["wardrobe-0"]
    assert set(opened) == {"door_left_joint", "door_right_joint"}
    assert all(0.02 < early < late < 1.92 for early, late in opened.values())


def test_a_case_has_the_room_in_usd_and_what_swings_alone(tmp_path: Path) -> None:
    case = marble_case(tmp_path / "mug")
    stage = Usd.Stage.Open(case["stage"])
    for thing in case["things"]:
        place = UsdGeom.XformCache().GetLocalToWorldTransform(stage.GetPrimAtPath(thing["prims"][0]))
        assert list(place.ExtractTranslation()) == pytest.approx(thing["position"])
    case = write_case(ROOM, tmp_path / "room")
    wardrobe = case["swinging"][0]
    stage = Usd.Stage.Open(wardrobe["stage"])
    gravity = UsdPhysics.Scene(stage.GetPrimAtPath("/World/PhysicsScene"))
    assert gravity.GetGravityMagnitudeAttr().Get() * gravity.GetGravityDirectionAttr().Get() == pytest.approx(TILTED)
    assert wardrobe["joint_prims"].keys() == case["swings"]["wardrobe-0"].keys()
    joints = [stage.GetPrimAtPath(path) for path in wardrobe["joint_prims"].values()]
    assert all(joint.IsA(UsdPhysics.RevoluteJoint) for joint in joints)
    assert stage.GetPrimAtPath("/World/Objects/wardrobe_1/Joints/mount").IsA(UsdPhysics.FixedJoint)


def test_differences_are_told_by_the_largest(tmp_path: Path) -> None:
    case = write_case(ROOM, tmp_path / "room")
    poses = {thing["name"]: [list(thing["position"]), list(thing["quat"])] for thing in case["things"]}
    away, turned, which = moved(case, poses)
    assert (away, which) == (0.0, "")
    assert turned < 1e-3
    poses["desk_1"][0][0] += 0.012
    away, _, which = moved(case, poses)
    assert away == pytest.approx(12.0)
    assert which == "desk_1"
    masses = {thing["name"]: thing["mass"] for thing in case["things"]}
    told = {"masses": {**masses, "vase_1": 1.1 * masses["vase_1"]}, "poses": poses, "swings": {}, "took": 0.5}
    assert case["slipping"]["wardrobe-0"]["door_left_joint"] > case["swings"]["wardrobe-0"]["door_left_joint"]
    assert row("a", "dartpy", case, told) == "| a | dartpy | 10.0000 | 12.00 desk_1 | 0.00 | - | - | 0.5 |"
    # What is fixed has no mass where a format gives it none; what is free must have its own.
    fixed = {thing["name"] for thing in case["things"] if not thing["free"]}
    bare = {name: mass for name, mass in masses.items() if name not in fixed}
    assert row("a", "dartpy", case, {**told, "masses": bare}).startswith("| a | dartpy | 0.0000 |")
    assert row("a", "dartpy", case, {**told, "masses": {}}).startswith("| a | dartpy | 100.0000 |")


def test_a_marble_falls_into_the_mug_and_is_told_of(tmp_path: Path) -> None:
    case = marble_case(tmp_path / "room")
    mug, marble = case["things"]
    assert marble["position"][2] > mug["rests"][2] + 0.09 > marble["rests"][2] + 0.05
    poses = {thing["name"]: [list(thing["rests"]), list(thing["quat"])] for thing in case["things"]}
    assert 5.0 < float(marble_told(case, poses)) < 20.0
    poses[marble["name"]][0][2] += 0.08
    assert marble_told(case, poses) == "not in the mug"


def test_the_page_has_every_engine_and_both_tables() -> None:
    text = page(PINS, ["| room |", "|---|", "| 01 | a |", "| 02 | a |"], ["| engine |", "|---|", "| MuJoCo | 11.9 |"])
    assert "## 2 rooms" in text
    assert all(pin["title"] in text for pin in PINS.values())
    assert "| MuJoCo | 11.9 |\n" in text


def test_what_takes_minutes_to_install_is_driven_only_when_asked_for() -> None:
    usual = [engine for engine, pin in PINS.items() if not pin.get("opt_in", False)]
    assert usual == ["rapier3d", "dartpy", "sapien", "pybullet", "drake"]
    drivers = Path("tests/bench/engines")
    assert all((drivers / f"drive_{pin.get('driver', engine)}.py").is_file() for engine, pin in PINS.items())


@pytest.mark.slow
def test_rapier_reads_our_mjcf(tmp_path: Path) -> None:
    case = write_case(ROOM, tmp_path / "room")
    try:
        told = driven("rapier3d", tmp_path / "room" / "case.json", tmp_path / "engines")
    except RuntimeError as error:
        if "cannot be installed" in str(error):
            pytest.skip(str(error))
        raise
    for thing in case["things"]:
        assert told["masses"][thing["name"]] == pytest.approx(thing["mass"], rel=1e-5)
    assert moved(case, told["poses"])[0] < 5.0
    for asset, joints in case["slipping"].items():
        for joint, values in joints.items():
            assert told["swings"][asset][joint] == pytest.approx(values, abs=0.05), joint
