"""Any MJCF opens as things that stand somewhere, and keeps its own options."""

from pathlib import Path

import numpy as np
import pytest

from tests.foreign_models import FLOOR, MODELS, crate, mjcf, opened
from thinkblox.errors import InputError
from thinkblox.sim.foreign.opening import open_model


def test_a_room_of_several_files_opens() -> None:
    subject = open_model(MODELS / "room" / "room.xml")
    assert [(t.id, t.free, len(t.bodies)) for t in subject.things] == [
        ("walls", False, 1),
        ("cabinet", False, 2),
        ("table", True, 1),
        ("body_6", True, 1),
    ]
    assert subject.source == "mjcf"
    assert subject.unusual == ()
    assert subject.model.opt.timestep == 0.002
    assert subject.room is None


def test_the_model_keeps_its_own_options(tmp_path: Path) -> None:
    head = '<option timestep="0.007" integrator="RK4" gravity="0 0 -3.7" cone="elliptic" noslip_iterations="3"/>'
    option = opened(tmp_path, mjcf(crate("a", "0 0 .1"), head=head)).model.opt
    assert (option.timestep, option.integrator, option.cone, option.noslip_iterations) == (0.007, 1, 1, 3)
    assert option.gravity.tolist() == [0.0, 0.0, -3.7]


def test_wrappers_are_looked_through_and_markers_are_not_things(tmp_path: Path) -> None:
    world = (
        '<body name="scene"><body><body name="shelf"><geom size=".1"/></body></body>'
        + crate("box", "0 0 1", free="")
        + "</body>"
        '<body name="marker"><site/></body><body mocap="true" name="target"/><camera pos="0 0 1"/>'
    )
    assert [thing.id for thing in opened(tmp_path, mjcf(world)).things] == ["shelf", "box"]


def test_made_up_names_are_unique(tmp_path: Path) -> None:
    world = '<body><geom size=".1"/></body><body name="body_1"><geom size=".1" pos="1 0 0"/></body>'
    ids = [thing.id for thing in opened(tmp_path, mjcf(world)).things]
    assert len(set(ids)) == 2
    assert "body_1" in ids


def test_a_thing_has_all_that_hangs_on_it(tmp_path: Path) -> None:
    world = (
        '<body name="desk"><geom size=".1"/><body name="drawer"><joint type="slide"/><geom size=".1" pos="0 0 .3"/>'
        '<body name="knob"><geom size=".01"/></body></body></body>' + crate("mug", "0 0 1")
    )
    desk, mug = opened(tmp_path, mjcf(world)).things
    assert (desk.id, desk.bodies, desk.free) == ("desk", (1, 2, 3), False)
    assert (mug.id, mug.bodies, mug.free) == ("mug", (4,), True)


def test_a_soft_body_is_one_thing(tmp_path: Path) -> None:
    world = '<flexcomp name="cushion" type="grid" count="3 3 3" spacing=".1 .1 .1" pos="0 0 1" radius=".01" dim="3"/>'
    (cushion,) = opened(tmp_path, mjcf(world)).things
    assert (cushion.id, len(cushion.bodies)) == ("cushion", 27)


KEYS = '<keyframe><key name="other" qpos="0 0 1 1 0 0 0"/>{}</keyframe>'


@pytest.mark.parametrize(
    ("keys", "height", "keyframe"),
    [
        ("", 0.1, None),
        (KEYS.format(""), 1.0, 0),
        (KEYS.format('<key name="settled" qpos="0 0 2 1 0 0 0"/>'), 2.0, 1),
        (KEYS.format('<key name="third" qpos="0 0 3 1 0 0 0"/>'), 0.1, None),
    ],
)
def test_the_start_is_the_keyframe_settled_or_the_only_one(
    tmp_path: Path, keys: str, height: float, keyframe: int | None
) -> None:
    text = mjcf(crate("a", "0 0 .1")).replace("</mujoco>", keys + "</mujoco>")
    subject = opened(tmp_path, text)
    assert subject.start[2] == height
    assert subject.keyframe == keyframe
    assert subject.data().qpos[2] == height


def test_what_was_moved_in_a_file_since_its_keyframes_is_measured_where_it_stands_now(tmp_path: Path) -> None:
    keys = (
        '<keyframe><key name="settled" qpos="0 0 .099 -1 0 0 0 2 0 .098 1 0 0 0"/>'
        '<key name="home" qpos="0 0 .1 -1 0 0 0 2 0 .1 1 0 0 0"/></keyframe>'
    )
    for second, height, told in (("2 0 .1", 0.098, ()), ("2 0 .7", 0.7, ("b",))):
        text = mjcf(crate("a", "0 0 .1") + crate("b", second)).replace("</mujoco>", keys + "</mujoco>")
        subject = opened(tmp_path, text)
        assert subject.start[[2, 9]].tolist() == [0.099, height]
        assert subject.data().qpos[9] == height
        assert [note.rpartition(": ")[2].rstrip(".") for note in subject.notes] == list(told)
    alone = mjcf(crate("a", "0 0 .1")).replace("</mujoco>", KEYS.format("") + "</mujoco>")
    assert opened(tmp_path, alone).notes == (
        "Measured from the keyframe 'other', which has elsewhere than the bodies stand: a.",
    )


def test_keyframes_of_another_number_of_bodies_are_refused_with_what_to_do(tmp_path: Path) -> None:
    keys = '<keyframe><key name="settled" qpos="0 0 .1 1 0 0 0 2 0 .1 1 0 0 0"/></keyframe>'
    text = mjcf(crate("a", "0 0 .1")).replace("</mujoco>", keys + "</mujoco>")
    with pytest.raises(InputError, match="take the <key> elements out"):
        opened(tmp_path, text)


def test_a_keyframe_brings_its_controls_and_no_speed(tmp_path: Path) -> None:
    world = '<body name="arm"><joint name="j" type="hinge"/><geom size=".1" pos="0 0 1"/></body>'
    tail = (
        '<actuator><position joint="j" kp="50"/></actuator>'
        '<keyframe><key name="home" qpos="0.5" qvel="3" ctrl="0.5" time="7"/></keyframe>'
    )
    data = opened(tmp_path, mjcf(world).replace("</mujoco>", tail + "</mujoco>")).data()
    assert (data.qpos[0], data.qvel[0], data.ctrl[0], data.time) == (0.5, 0.0, 0.5, 0.0)


def test_comments_with_dashes_and_a_late_declaration_are_borne(tmp_path: Path) -> None:
    text = '\n<?xml version="1.0"?>\n<!-- ---- by hand -- \xe9 ---- -->\n' + mjcf(crate("a", "0 0 .1"))
    assert [thing.id for thing in opened(tmp_path, text).things] == ["a"]


def test_attached_models_and_replicates_are_things(tmp_path: Path) -> None:
    (tmp_path / "chair.xml").write_text(mjcf(crate("chair", "0 0 .1", free=""), floor=""))
    text = (
        '<mujoco><asset><model name="c" file="chair.xml"/></asset><worldbody>' + FLOOR + '<frame pos="1 0 0">'
        '<attach model="c" body="chair" prefix="one_"/></frame><frame>'
        '<attach model="c" body="chair" prefix="two_"/></frame>'
        '<replicate count="3" offset="0 1 0">' + crate("stool", "2 0 .1") + "</replicate></worldbody></mujoco>"
    )
    ids = [thing.id for thing in opened(tmp_path, text).things]
    assert ids == ["one_chair", "two_chair", "stool0", "stool1", "stool2"]


def test_a_subject_is_the_same_every_time() -> None:
    first, second = (open_model(MODELS / "room" / "room.xml") for _ in range(2))
    assert np.array_equal(first.start, second.start)
    assert (first.things, first.unusual, first.notes) == (second.things, second.unusual, second.notes)
