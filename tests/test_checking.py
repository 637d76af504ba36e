"""Whatever a path holds is measured, or refused with a sentence that helps."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

from tests.sim_rooms import asset, put, scene, table
from thinkblox.checking import VerifyOptions, verify_file
from thinkblox.cli import main
from thinkblox.errors import InputError
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.value import to_json

CRATE = asset("crate", (0.5, 0.5, 0.5))
FALLING = """<mujoco><worldbody><geom name="floor" type="plane" size="5 5 .1"/>
<body name="crate" pos="0 0 {z}"><freejoint/><geom type="box" size=".2 .2 .2" mass="5"/></body></worldbody></mujoco>"""


@pytest.fixture
def room(tmp_path: Path) -> Path:
    sunk = put(CRATE, 2.0, 2.0, -0.004)
    return _written(tmp_path, scene(None, (sunk, CRATE), (put(table(), 1.0, 4.0), table())))


def _written(folder: Path, what: Scene) -> Path:
    file = folder / "scene.json"
    file.write_bytes(to_json(what))
    return file


def test_a_scene_is_measured_as_a_file_and_as_its_folder(room: Path) -> None:
    report = verify_file(room)
    assert report.source == "thinkblox"
    assert {v.id: v.reasons for v in report.objects if not v.valid} == {"crate_1": ("outside",)}
    assert verify_file(room.parent) == report


def test_what_is_mended_is_written_and_every_move_told(room: Path, capsys: pytest.CaptureFixture[str]) -> None:
    mended = room.with_name("mended.json")
    assert main(["verify", str(room), "--fix", "--out", str(mended)]) == 0
    assert "crate_1: moved" in capsys.readouterr().out
    again = load_scene(mended)
    assert again["table_1"] == load_scene(room)["table_1"]
    assert again["crate_1"].position[2] == pytest.approx(0.0, abs=0.001)
    assert main(["verify", str(mended)]) == 0


def test_suites_are_printed_by_criterion_and_by_object(room: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", str(room), "--suite", "scenesmith,sceneeval_sim"]) == 1
    printed = capsys.readouterr().out
    assert "scenesmith: " in printed
    assert "collision_rate" in printed
    assert "crate_1" in printed
    assert main(["verify", str(room), "--suite", "scenesmith", "--json"]) == 1
    document = json.loads(capsys.readouterr().out)
    assert document["suites"][0]["suite"] == "scenesmith"


def test_an_unknown_suite_or_format_lists_what_there_is(room: Path) -> None:
    with pytest.raises(InputError, match="molmospaces"):
        verify_file(room, VerifyOptions(suites=("sage",)))
    with pytest.raises(InputError, match="holodeck"):
        verify_file(room, VerifyOptions(format="fbx"))


@pytest.mark.parametrize(("z", "status"), [(0.2, 0), (0.6, 1)])
def test_a_model_is_measured_with_its_own_options(
    tmp_path: Path, z: float, status: int, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "model.xml"
    file.write_text(FALLING.format(z=z))
    assert main(["verify", str(file)]) == status
    assert ("crate: " in capsys.readouterr().out) == (status == 1)


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("missing.json", None, "no such file"),
        ("room.fbx", "", "not read"),
        ("broken.json", "{", "broken.json"),
        ("other.json", '{"rooms": 3}', "--format"),
        ("broken.xml", "<mujoco><worldbody>", "broken.xml"),
    ],
)
def test_what_cannot_be_read_is_refused(
    tmp_path: Path, name: str, content: str | None, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if content is not None:
        (tmp_path / name).write_text(content)
    assert main(["verify", str(tmp_path / name)]) == 2
    assert says in capsys.readouterr().err


def test_a_folder_without_a_scene_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"scene\.json"):
        verify_file(tmp_path)


def test_a_model_is_not_mended_and_has_no_scene(tmp_path: Path) -> None:
    file = tmp_path / "model.xml"
    file.write_text(FALLING.format(z=0.2))
    for reading in (VerifyOptions(fix=True), VerifyOptions(out=str(tmp_path / "scene.json"))):
        with pytest.raises(InputError):
            verify_file(file, reading)
    assert not (tmp_path / "scene.json").exists()


SCENE = """<mujoco><worldbody><geom type="plane" size="9 9 1"/>
<body name="arm" pos="0 0 1"><joint name="elbow"/>
<geom type="capsule" size=".05" fromto="0 0 0 .5 0 0" mass="3"/></body>
<body name="target_1" pos="3 0 .5"><freejoint/><geom size=".1"/></body>
<body name="target_2" pos="4 0 .5"><freejoint/><geom size=".1"/></body>
<body name="crate" pos="{x} 0 .95"><freejoint/><geom type="box" size=".05 .05 .95" mass="5"/></body>
</worldbody></mujoco>"""


def test_a_robot_stands_still_and_what_is_excluded_is_not_there(tmp_path: Path) -> None:
    file = tmp_path / "room.xml"
    file.write_text(SCENE.format(x=2))
    assert {v.id for v in verify_file(file).objects if not v.valid} == {"target_1", "target_2"}
    report = verify_file(file, VerifyOptions(exclude=("target*",), robot=("arm",)))
    assert [v.id for v in report.objects] == ["crate"]
    assert report.valid
    assert report.notes[:2] == (
        "Left out as asked: target_1, target_2.",
        "Held where it starts, as a robot: arm.",
    )
    assert not any("Joints moved" in note or "Armature" in note for note in (*report.notes, *report.unusual))


def test_what_stands_in_a_robot_collides_with_it_by_its_name(tmp_path: Path) -> None:
    file = tmp_path / "room.xml"
    file.write_text(SCENE.format(x=0.5))
    (crate,) = verify_file(file, VerifyOptions(exclude=("target*",), robot=("arm",))).objects
    assert [c.other for c in crate.collisions] == ["arm"]
    (alone,) = verify_file(file, VerifyOptions(exclude=("target*", "arm"))).objects
    assert alone.collisions == ()
    assert alone.valid


def test_a_robot_is_not_opened_by_a_suite(tmp_path: Path) -> None:
    file = tmp_path / "room.xml"
    file.write_text(SCENE.format(x=2))
    report = verify_file(file, VerifyOptions(robot=("arm",), suites=("molmospaces",)))
    found = {f.object for criterion in report.suites[0].criteria for f in criterion.findings}
    assert not found & {"arm", "elbow"}


def test_a_name_that_is_not_there_lists_what_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "room.xml"
    file.write_text(SCENE.format(x=2))
    assert main(["verify", str(file), "--robot", "panda", "--exclude", "arm"]) == 2
    said = capsys.readouterr().err
    assert 'nothing in the model is called "panda"; there are arm, target_1, target_2, crate' in said


def test_a_model_of_nothing_but_robots_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "room.xml"
    file.write_text(SCENE.format(x=2))
    with pytest.raises(InputError, match="nothing but what was set aside"):
        verify_file(file, VerifyOptions(robot=("*",)))


def test_a_root_widens_what_a_model_may_name(tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    (tmp_path / "part.xml").write_text("<mujocoinclude><option timestep='0.001'/></mujocoinclude>")
    file = tmp_path / "models" / "room.xml"
    file.write_text(FALLING.format(z=0.2).replace("<worldbody>", '<include file="../part.xml"/><worldbody>'))
    assert main(["verify", str(file)]) == 2
    assert main(["verify", str(file), "--root", str(tmp_path)]) == 0
    assert main(["verify", str(file), "--root", str(tmp_path / "nowhere")]) == 2


def test_options_of_models_are_refused_for_scenes(room: Path) -> None:
    with pytest.raises(InputError, match="--robot are for models"):
        verify_file(room, VerifyOptions(robot=("crate_1",)))


@pytest.mark.parametrize(
    ("option", "value"),
    [
        ("sizes", "nowhere.json"),
        ("assets", "nowhere"),
        ("height", 2.5),
        ("room", "bedroom"),
        ("short_side", 3.0),
        ("room_size", (4.0, 3.0)),
    ],
)
def test_options_of_layouts_are_refused_for_scenes_and_models(
    room: Path, tmp_path: Path, option: str, value: object
) -> None:
    model = tmp_path / "room.xml"
    model.write_text(SCENE.format(x=2))
    options = VerifyOptions(**{option: value})  # type: ignore[arg-type]
    name = f"--{option.replace('_', '-')}"
    for path, what in ((room, "one of our own scenes"), (model, "a model")):
        with pytest.raises(InputError, match=f"{name}: only for layouts of other generators, and this is {what}"):
            verify_file(path, options)


def test_the_models_in_a_folder_are_listed(tmp_path: Path) -> None:
    for name in ("a.xml", "b.urdf", "notes.txt"):
        (tmp_path / name).write_text("x")
    with pytest.raises(InputError, match=r"to be measured: there are a\.xml, b\.urdf$"):
        verify_file(tmp_path)


@pytest.mark.parametrize("value", ["nan", "inf", "-1", "0", "-inf", "1e999", "x", ""])
@pytest.mark.parametrize("option", ["--height", "--short-side", "--max-move", "--timeout", "--room-size"])
def test_numbers_that_no_option_can_have(
    room: Path, option: str, value: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["verify", str(room), f"{option}={value if option != '--room-size' else f'4,{value}'}"])
    assert ended.value.code == 2
    assert option in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "match"),
    [
        ({"height": float("nan")}, "height: nan; it must be 1.5 to 50 m"),
        ({"height": 1.0}, "height: 1.0; it must be 1.5 to 50 m"),
        ({"height": "3"}, "height: '3'"),
        ({"height": True}, "height: True"),
        ({"short_side": float("inf")}, "short side: inf; it must be 0.5 to 100 m"),
        ({"max_move": -1.0}, "max move: -1.0; it must be above 0 and at most 100 m"),
        ({"room_size": (4.0, float("nan"))}, "a room of 4.0 x nan m"),
        ({"room_size": (4.0,)}, "give two or three lengths"),
        ({"seed": -1}, "the seed is -1"),
        ({"seed": 2**63}, "the seed is"),
    ],
)
def test_options_that_cannot_be_are_refused_whatever_the_file(room: Path, options: dict[str, Any], match: str) -> None:
    with pytest.raises(InputError, match=match):
        verify_file(room, VerifyOptions(**options))


@pytest.mark.parametrize("timeout", [0.0, -1.0, float("nan"), float("inf"), "60"])
def test_a_timeout_is_more_than_nothing(room: Path, timeout: Any) -> None:
    with pytest.raises(InputError, match="a timeout of"):
        verify_file(room, timeout=timeout)


def test_a_model_that_was_changed_beside_its_scene_is_told(room: Path) -> None:
    model = room.with_name("scene.xml")
    model.write_text(FALLING.format(z=1))
    assert not [note for note in verify_file(room.parent).notes if "newer" in note]
    later = room.stat().st_mtime + 3600
    os.utime(model, (later, later))
    assert [note for note in verify_file(room.parent).notes if "scene.xml is newer" in note]
