"""Whatever a path holds is measured, or refused with a sentence that helps."""

import json
from pathlib import Path

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
