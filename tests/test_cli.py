import json
import os
import signal
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
    assert names == ["assets", "manifest.json", "report.json", "scene.json", "scene.usda", "scene.xml", "trace.jsonl"]


def test_json_is_the_report_and_nothing_else(tmp_path):
    done = run("generate", CHAIR, "--out", tmp_path / "room", "--no-pictures", "--json")
    report = json.loads(done.stdout)
    assert report["valid"] is True
    assert [verdict["id"] for verdict in report["objects"]] == ["chair_1"]
    assert done.stderr == ""


def test_what_the_catalogue_lacks_has_a_plain_stand_in_and_that_is_said(tmp_path):
    done = run("generate", "A room with a griffin and a table.", "--out", tmp_path / "room", "--no-pictures")
    assert done.returncode == 1
    assert "as plain stand-ins: griffin" in done.stdout
    assert "no such thing is known" in done.stdout


@pytest.mark.slow
def test_what_cannot_be_shown_is_said_and_the_status_is_1(tmp_path):
    done = run("generate", "A room with a haunted chair and a table.", "--out", tmp_path / "room", "--no-pictures")
    assert done.returncode == 1
    assert "haunted" in done.stdout
    assert (tmp_path / "room" / "scene.json").exists()


@pytest.mark.slow
def test_which_attempt_was_kept_is_said(tmp_path):
    prompt = "An empty room of 2 m by 2 m with two beds."
    done = run("generate", prompt, "--out", tmp_path / "room", "--no-pictures")
    assert done.returncode == 1
    said = done.stderr.splitlines()
    again = next(line for line in said if line.endswith("; attempt 2, begun anew"))
    assert "bed_2" in again, "it says what was not as asked"
    assert said[-1] == "attempt 1 of 2 is kept"


@pytest.mark.slow
def test_more_than_a_room_is_given_is_said_before_anything_is_placed(tmp_path):
    done = run("generate", "A hall with 800 chairs", "--out", tmp_path / "r", "--no-pictures", "--budget", "0.01")
    first = "not placed: 600 more of '800 chairs': a room is given at most 400 things, and 200 of a kind"
    assert done.stderr.splitlines()[0] == first
    assert f"  {first}" in done.stdout


@pytest.mark.slow
def test_verify_says_that_the_prompt_is_not_looked_at(tmp_path):
    run("generate", CHAIR, "--out", tmp_path / "room", "--no-pictures")
    done = run("verify", tmp_path / "room")
    assert done.returncode == 0
    assert "What the prompt asks for is not looked at here" in done.stdout


@pytest.mark.slow
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


def shape(**change: object) -> dict[str, object]:
    return {"kind": "box", "size": [1, 1, 1], "position": [0, 0, 0.5]} | change


def broken_scene(**changes: object) -> dict[str, object]:
    asset = {
        "id": "box-0", "category": "box", "description": "a box", "size": [1, 1, 1], "mass": 1, "friction": 0.5,
        "mount": "floor", "links": [{"name": "body", "shapes": [shape()]}],
    }  # fmt: skip
    placement = {
        "id": "box_1", "category": "box", "asset": "box-0", "position": [2, 2, 0], "yaw": 0, "size": [1, 1, 1],
        "support": "floor",
    }  # fmt: skip
    asset |= {key: value for key, value in changes.items() if key in asset}
    placement |= {key.removeprefix("at_"): value for key, value in changes.items() if key.startswith("at_")}
    room = {"floor": [[0, 0], [4, 0], [4, 4], [0, 4]], "openings": changes.get("openings", [])}
    return {"room": room, "placements": [placement] * int(str(changes.get("times", 1))), "assets": {"box-0": asset}}


def hull(*points: list[float]) -> list[object]:
    return [{"name": "body", "shapes": [shape(kind="hull", points=list(points))]}]


DOOR = {"id": "door_1", "kind": "door", "wall": 0, "offset": 1, "width": 0.9, "height": 2}
FLAT = ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0])
BROKEN: dict[str, dict[str, object]] = {
    "no links": {"links": []},
    "no shapes": {"links": [{"name": "body", "shapes": []}]},
    "zero size": {"links": [{"name": "body", "shapes": [shape(size=[0, 1, 1])]}]},
    "negative size": {"links": [{"name": "body", "shapes": [shape(size=[1, -1, 1])]}]},
    "hull of two points": {"links": hull(*FLAT[:2])},
    "flat hull": {"links": hull(*FLAT)},
    "hull of one place": {"links": hull(*[FLAT[1]] * 5)},
    "negative mass": {"mass": -1},
    "empty id": {"at_id": ""},
    "id with a slash": {"at_id": "a/b_1"},
    "id with NUL": {"at_id": "a\0b"},
    "id of the floor": {"at_id": "floor"},
    "id of a wall": {"at_id": "north_wall"},
    "id of a door": {"at_id": "door_1", "openings": [DOOR]},
    "two alike": {"times": 2},
    "too many": {"times": 3000},
    "two doors in one place": {"openings": [DOOR, DOOR | {"id": "door_2", "offset": 1.5}]},
    "two doors of one id": {"openings": [DOOR, DOOR | {"offset": 2.5}]},
}


@pytest.mark.parametrize("changes", BROKEN.values(), ids=BROKEN.keys())
@pytest.mark.parametrize("command", ["verify", "render"])
def test_a_broken_scene_is_refused_by_name(tmp_path, capsys, command, changes):
    (tmp_path / "scene.json").write_text(json.dumps(broken_scene(**changes)))
    assert main([command, str(tmp_path / "scene.json")]) == 2
    assert "scene.json: " in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["scene.json"]


def test_the_scene_that_is_broken_above_is_fine_unbroken(tmp_path, capsys):
    (tmp_path / "scene.json").write_text(json.dumps(broken_scene(openings=[DOOR])))
    assert main(["verify", str(tmp_path / "scene.json")]) == 0
    assert "all passed" in capsys.readouterr().out


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
@pytest.mark.parametrize("placed", [pytest.param(1, marks=pytest.mark.slow), 7])
def test_a_stopped_run_leaves_nothing_behind(tmp_path, placed, number):
    prompt = "A buffet restaurant with five square tables with four chairs each and a long counter."
    command = [sys.executable, "-m", "thinkblox", "generate", prompt, "--out", str(tmp_path / "a" / "b" / "room")]
    running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert running.stderr is not None
    for _ in range(placed):
        assert "placed" in running.stderr.readline()
    running.send_signal(number)
    _, errors = running.communicate(timeout=300)
    assert running.returncode == 130
    assert "nothing was written" in errors
    assert list(tmp_path.iterdir()) == []


def test_verify_of_nothing_says_so(tmp_path, capsys):
    assert main(["verify", str(tmp_path / "gone.json")]) == 2
    assert "gone.json" in capsys.readouterr().err


def test_pictures_that_cannot_be_written_are_not_drawn(tmp_path, capsys):
    (tmp_path / "taken").write_text("mine")
    for out in (tmp_path / "taken", tmp_path / "taken" / "deeper"):
        assert main(["render", str(tmp_path / "gone.json"), "--out", str(out)]) == 2
        assert "is not a folder" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]


def test_render_draws_both_pictures(tmp_path, capsys):
    assert main(["generate", CHAIR, "--out", str(tmp_path / "room"), "--no-pictures"]) == 0
    capsys.readouterr()
    assert main(["render", str(tmp_path / "room"), "--out", str(tmp_path / "pictures"), "--size", "96", "--json"]) == 0
    paths = [Path(path) for path in json.loads(capsys.readouterr().out)]
    assert [path.name for path in paths] == ["preview.png", "top.png"]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths)


def test_a_stop_that_comes_out_as_another_error_is_still_a_stop():
    code = """
import os, signal, sys
from thinkblox.cli import main, schema

def stopped_in_a_call(arguments):
    try:
        os.kill(os.getpid(), signal.SIGTERM)
        signal.pause()
    except KeyboardInterrupt:
        raise TypeError("incompatible function arguments") from None

schema._schema = stopped_in_a_call
sys.exit(main(["schema"]))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (130, "thinkblox: stopped; nothing was written\n")


def test_an_instruction_may_stand_behind_the_options(tmp_path, capsys):
    assert main(["generate", CHAIR, "--out", str(tmp_path / "room"), "--no-pictures"]) == 0
    last = ["edit", str(tmp_path / "room"), "--out", str(tmp_path / "after"), "--no-pictures", "Remove the chair"]
    assert main(last) == 0
    assert "chair_1 taken away" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main([*last, "and the rug"])
    assert "unrecognized arguments" in capsys.readouterr().err
