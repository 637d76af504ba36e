"""What callers give by mistake is refused with what to give instead, and NumPy's numbers are numbers."""

import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from msgspec import structs

import thinkblox
from tests.sim_rooms import put, scene, table
from thinkblox.given import seed_given
from thinkblox.scene.placement import Placement
from thinkblox.scene.support import placed_at
from thinkblox.sim import settle
from thinkblox.value import from_json, to_json

TABLE = table()
ROOM = scene(None, (put(TABLE, 2.0, 2.0), TABLE))


def _refused(match: str, call, *arguments, **named) -> None:
    with pytest.raises(thinkblox.InputError, match=match):
        call(*arguments, **named)


def test_what_is_no_scene_is_refused_wherever_one_is_wanted(tmp_path):
    calls = (
        thinkblox.verify,
        thinkblox.World,
        thinkblox.to_mjspec,
        thinkblox.to_mjmodel,
        settle,
        lambda it: thinkblox.save_scene(it, tmp_path / "out"),
        lambda it: thinkblox.export_scene(it, tmp_path / "out"),
    )
    for call in calls:
        _refused("a str is given for a Scene; load_scene reads one", call, "out/bedroom")
        _refused("a SimpleNamespace is given for a Scene; give its .scene", call, SimpleNamespace(scene=ROOM))
    _refused("a NoneType is no result of generate_room", thinkblox.save_room, None, tmp_path / "out")
    assert not list(tmp_path.iterdir())


def test_seeds_are_whole_numbers_also_those_of_numpy():
    assert [seed_given(seed) for seed in (0, np.int64(7), 2**63 - 1)] == [0, 7, 2**63 - 1]
    for seed in (True, 1.0, "1", None, -1, 2**63):
        _refused("whole number from 0", seed_given, seed)


def test_one_text_is_no_list_of_names(tmp_path):
    _refused(
        r"give a tuple of names, such as \('mjcf',\)", thinkblox.export_scene, ROOM, tmp_path / "x", formats="mjcf"
    )
    for what in ("suites", "exclude", "robot"):
        options = structs.replace(thinkblox.VerifyOptions(), **{what: "a*"})
        _refused(rf"{what} is the text 'a\*'", thinkblox.verify_file, tmp_path / "scene.xml", options)
    _refused("give VerifyOptions", thinkblox.verify_file, tmp_path / "scene.xml", {"suites": ()})


def test_poses_and_ids_that_cannot_be_say_what_can():
    for position in ((1, 2), (1, 2, float("nan")), ("a", 1, 2), 3):
        _refused("a position is three finite numbers", ROOM.moved, "table_1", position=position)
    _refused("a yaw one", ROOM.moved, "table_1", position=(1, 1, 0), yaw="left")
    meant: tuple[Any, ...] = (np.array([1, 1, 0]), [1.0, 1.0, 0.0], (1, 1, 0))
    assert len({ROOM.moved("table_1", position=position)["table_1"] for position in meant}) == 1
    _refused("a position is three numbers", placed_at, ROOM, TABLE, id="t", position=(1.0, 1.0), yaw=0.0)
    says = "a letter, then letters, digits, underscores, dots and dashes"
    _refused(says, placed_at, ROOM, TABLE, id="my table!", position=(1.0, 1.0, 0.0), yaw=0.0)
    text = to_json(ROOM.placements[0]).replace(b'"table_1"', b'"my table!"')
    _refused(re.escape(says) + r" - at `\$\.id`", from_json, text, Placement)
    _refused("a list of placements", thinkblox.World(ROOM).check, TABLE, [ROOM.placements[0]])
