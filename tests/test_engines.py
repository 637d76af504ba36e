"""The bench of other engines: what its drivers are given, what is made of what they say, and one of them."""

import json
from pathlib import Path

import pytest

from tests.bench.engines.__main__ import driven, row
from tests.bench.engines.case import moved, swings, write_case
from tests.environment_rooms import robot_room
from thinkblox.exporters.stocktaking import inventory_of

ROOM = robot_room()


def test_a_case_has_every_thing_where_it_rests_and_its_model(tmp_path: Path) -> None:
    case = write_case(ROOM, tmp_path / "room")
    assert json.loads((tmp_path / "room" / "case.json").read_text())["things"][0]["name"] == "table_1"
    items = inventory_of(ROOM).objects
    for thing, item in zip(case["things"], items, strict=True):
        assert thing["mass"] == pytest.approx(sum(body.mass for body in item.bodies))
        assert Path(thing["model"]).is_file()
    assert [thing["name"] for thing in case["swinging"]] == ["wardrobe_1"]
    opened = swings(ROOM, case)["wardrobe-0"]
    assert set(opened) == {"door_left_joint", "door_right_joint"}
    assert all(0.02 < early < late < 1.92 for early, late in opened.values())


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
    assert row("a", "b", case, told, {}) == "| a | b | 10.0000 | 12.00 desk_1 | 0.00 | - | - | 0.5 |"


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
