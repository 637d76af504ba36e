import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from thinkblox.cli import main

CHAIR = "An empty room with nothing in it but a chair."


def run(*arguments: object, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "thinkblox", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, cwd=cwd, check=False)


def test_a_room_is_written_and_the_status_says_all_as_asked(tmp_path):
    done = run("generate", CHAIR, "--out", tmp_path / "room", "--no-pictures")
    assert done.returncode == 0, done.stderr
    assert "all as asked" in done.stdout
    assert "1/1 chair_1 placed" in done.stderr
    names = sorted(path.name for path in (tmp_path / "room").iterdir())
    assert names == ["report.json", "scene.json", "scene.usda", "scene.xml", "trace.jsonl"]


def test_json_is_the_report_and_nothing_else(tmp_path):
    done = run("generate", CHAIR, "--out", tmp_path / "room", "--no-pictures", "--json")
    report = json.loads(done.stdout)
    assert report["valid"] is True
    assert [verdict["id"] for verdict in report["objects"]] == ["chair_1"]
    assert done.stderr == ""


def test_what_the_catalogue_lacks_is_said_and_the_status_is_1(tmp_path):
    done = run("generate", "A room with a hoverboard and a table.", "--out", tmp_path / "room", "--no-pictures")
    assert done.returncode == 1
    assert "hoverboard" in done.stdout
    assert (tmp_path / "room" / "scene.json").exists()


def test_six_wardrobes_in_two_metres_end_honestly(tmp_path):
    done = run("generate", "Six wardrobes in a 2 m by 2 m room.", "--out", tmp_path / "room", "--no-pictures", "--json")
    assert done.returncode == 1
    report = json.loads(done.stdout)
    placed = [verdict["id"] for verdict in report["objects"]]
    absent = [entry["id"] for entry in report["absent"]]
    assert sorted(placed + absent) == [f"wardrobe_{n}" for n in range(1, 7)]
    assert all(entry["reason"] for entry in report["absent"])
    assert report["depth"] <= 0.001


ROOMS = {
    "not json": "floor: big",
    "too few": '{"floor": [[0, 0], [3, 0]]}',
    "crossing": '{"floor": [[0, 0], [4, 3], [4, 0], [0, 3]]}',
    "unknown key": '{"floor": [[0, 0], [4, 0], [4, 3], [0, 3]], "walls": 4}',
    "nan": '{"floor": [[0, 0], [NaN, 0], [4, 3], [0, 3]]}',
    "huge": '{"floor": [[0, 0], [1000, 0], [1000, 3], [0, 3]]}',
}


@pytest.mark.parametrize("text", ROOMS.values(), ids=ROOMS.keys())
def test_a_bad_room_file_is_refused_and_nothing_is_written(tmp_path, capsys, text):
    (tmp_path / "room.json").write_text(text)
    status = main(["generate", CHAIR, "--out", str(tmp_path / "out"), "--room", str(tmp_path / "room.json")])
    assert status == 2
    assert "room.json" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "prompt",
    [
        "",
        "   \n ",
        "A bedroom, 0 m by 4 m.",
        "A bedroom, -3 m by 4 m.",
        "A bedroom of NaN m by 4 m.",
        "A bedroom, 1 km by 4 m.",
        "静かな寝室にベッドと机を置いてください。",
        "A bedroom with a bed. " * 5000,
    ],
    ids=["empty", "blank", "zero", "negative", "nan", "kilometre", "japanese", "100 kB"],
)
def test_an_unusable_prompt_is_refused_and_nothing_is_written(tmp_path, capsys, prompt):
    status = main(["generate", prompt, "--out", str(tmp_path / "out")])
    assert status == 2
    assert len(capsys.readouterr().err.strip()) > 20
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_ours_is_left_alone(tmp_path, capsys):
    (tmp_path / "notes.txt").write_text("mine")
    assert main(["generate", CHAIR, "--out", str(tmp_path), "--overwrite"]) == 2
    assert "notes.txt" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_our_own_folder_needs_overwrite(tmp_path, capsys):
    arguments = ["generate", CHAIR, "--out", str(tmp_path / "room"), "--no-pictures"]
    assert main(arguments) == 0
    before = (tmp_path / "room" / "scene.json").read_bytes()
    assert main([*arguments, "--seed", "5"]) == 2
    assert (tmp_path / "room" / "scene.json").read_bytes() == before
    assert main([*arguments, "--seed", "5", "--overwrite"]) == 0
    assert (tmp_path / "room" / "scene.json").read_bytes() != before
    capsys.readouterr()


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_an_unwritable_folder_is_named(tmp_path, capsys):
    tmp_path.chmod(0o500)
    assert main(["generate", CHAIR, "--out", str(tmp_path / "room")]) == 2
    assert str(tmp_path) in capsys.readouterr().err


@pytest.mark.parametrize("option", [["--seed", "-1"], ["--seed", "x"], ["--candidates", "0"], ["--candidates", "1e3"]])
def test_wrong_options_are_refused(tmp_path, capsys, option):
    with pytest.raises(SystemExit) as stopped:
        main(["generate", CHAIR, "--out", str(tmp_path / "room"), *option])
    assert stopped.value.code == 2
    assert option[0] in capsys.readouterr().err


def test_a_room_file_is_furnished(tmp_path, capsys):
    room = {"floor": [[0, 0], [4, 0], [4, 5], [0, 5]], "height": 2.5}
    (tmp_path / "room.json").write_text(json.dumps(room))
    arguments = ["generate", "A room with a sofa.", "--out", str(tmp_path / "out"), "--no-pictures"]
    assert main([*arguments, "--room", str(tmp_path / "room.json")]) == 0
    written = json.loads((tmp_path / "out" / "scene.json").read_text())
    assert written["room"]["floor"] == [[0, 0], [4, 0], [4, 5], [0, 5]]
    assert written["room"]["height"] == 2.5
    capsys.readouterr()


def test_verify_measures_a_scene_again_and_finds_what_was_broken(tmp_path, capsys):
    assert main(["generate", CHAIR, "--out", str(tmp_path / "room"), "--no-pictures"]) == 0
    assert main(["verify", str(tmp_path / "room")]) == 0
    scene = json.loads((tmp_path / "room" / "scene.json").read_text())
    scene["placements"][0]["position"][2] += 0.3
    (tmp_path / "broken.json").write_text(json.dumps(scene))
    capsys.readouterr()
    assert main(["verify", str(tmp_path / "broken.json")]) == 1
    assert "fell" in capsys.readouterr().out


def test_verify_of_nothing_says_so(tmp_path, capsys):
    assert main(["verify", str(tmp_path / "gone.json")]) == 2
    assert "gone.json" in capsys.readouterr().err


def test_render_draws_both_pictures(tmp_path, capsys):
    assert main(["generate", CHAIR, "--out", str(tmp_path / "room"), "--no-pictures"]) == 0
    capsys.readouterr()
    assert main(["render", str(tmp_path / "room"), "--out", str(tmp_path / "pictures"), "--size", "96", "--json"]) == 0
    paths = [Path(path) for path in json.loads(capsys.readouterr().out)]
    assert [path.name for path in paths] == ["preview.png", "top.png"]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths)
