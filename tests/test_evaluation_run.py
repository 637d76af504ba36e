import contextlib
import json
import os
import subprocess
import sys
from multiprocessing import active_children
from pathlib import Path

import pytest

from tests.evaluation_work import worked
from thinkblox import InputError
from thinkblox.cli import main
from thinkblox.crew import work_through

ENTRIES = [
    {
        "id": "chair",
        "style": "plain",
        "prompt": "An empty room with nothing in it but a chair.",
        "count": [["eq", 1, "chair"]],
        "absent": ["bed"],
    },
    {
        "id": "hoverboard",
        "style": "odd",
        "prompt": "An empty room with nothing in it but a chair and a bed.",
        "count": [["eq", 1, "chair"], ["eq", 3, "bed"]],
        "oo": [["eq", 1, "on_top", 0, "bed", "chair"]],
        "attr": [["eq", 1, "chair", "Windsor"]],
    },
]


@pytest.fixture
def annotations(tmp_path):
    path = tmp_path / "annotations.json"
    path.write_text(json.dumps(ENTRIES))
    return path


def evaluate(*arguments):
    command = [sys.executable, "-m", "thinkblox", "evaluate", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_work_is_done_whatever_becomes_of_some_of_it():
    things = ["a", "die", "b", "raise", "leave", "c", "d"]
    done = sorted(work_through(worked, things, jobs=2, seconds=600.0))
    assert [d.number for d in done] == list(range(7))
    assert [d.result for d in done] == ["A", None, "B", None, None, "C", "D"]
    assert "with status -9" in done[1].fault
    assert "ValueError: it was asked to" in done[3].fault
    assert "with status 3" in done[4].fault
    assert active_children() == []


def test_what_hangs_is_stopped():
    (done,) = work_through(worked, ["hang"], jobs=1, seconds=0.2)
    assert (done.result, done.fault) == (None, "it took too long and was stopped")
    assert active_children() == []


def test_processes_are_gone_when_nobody_wants_the_rest():
    with contextlib.closing(work_through(worked, ["a", "hang", "hang"], jobs=2, seconds=600.0)) as results:
        assert next(results).result == "A"
    assert active_children() == []


def test_rooms_are_made_judged_and_judged_again(tmp_path, annotations):
    out = tmp_path / "out"
    done = evaluate("--annotations", annotations, "--out", out, "--jobs", 2)
    assert done.returncode == 1, done.stderr
    assert "chair in " in done.stdout
    assert "hoverboard count: eq 3 bed | 1 there: bed_1" in done.stdout
    assert 'the report says "all as asked", the judge finds 2 demands not met' in done.stdout
    written = json.loads((out / "evaluation.json").read_text())
    chair, bed = written["judgements"]
    assert (chair["id"], chair["whole"], chair["complete"], chair["disagrees"]) == ("chair", True, True, False)
    assert (bed["whole"], bed["complete"], bed["disagrees"]) == (False, True, True)
    assert [row["met"] for row in bed["rows"]] == [True, False, None, False]
    text = (out / "evaluation.md").read_text()
    assert "## Where the report and the judge disagree" in text
    assert "| plain | 1 | 1/1 (100 %) |" in text

    again = evaluate("--annotations", annotations, "--rooms", out / "rooms", "--json")
    assert again.returncode == 1
    rejudged = json.loads(again.stdout)["judgements"]
    assert [entry["rows"] for entry in rejudged] == [entry["rows"] for entry in written["judgements"]]

    (out / "rooms" / "chair" / "report.json").unlink()
    alone = evaluate("--annotations", annotations, "--rooms", out / "rooms", "--only", "chair", "--json")
    (unreported,) = json.loads(alone.stdout)["judgements"]
    assert unreported == rejudged[0] | {"complete": None, "valid": None, "seconds": unreported["seconds"]}

    refused = evaluate("--annotations", annotations, "--out", out)
    assert refused.returncode == 2
    assert "holds an evaluation" in refused.stderr


def test_a_room_that_is_not_there_meets_nothing(tmp_path, annotations, capsys):
    assert main(["evaluate", "--annotations", str(annotations), "--rooms", str(tmp_path), "--only", "chair"]) == 1
    told = capsys.readouterr().out
    assert "chair refused: " in told
    assert "chair count: eq 1 chair | there is no room" in told


def test_the_reading_alone(annotations, capsys):
    assert main(["evaluate", "--annotations", str(annotations), "--reading"]) == 1
    told = capsys.readouterr().out
    assert "hoverboard count: eq 3 bed | asks for 1 (bed)" in told
    assert "Demands met, by style" in told
    assert main(["evaluate", "--annotations", str(annotations), "--reading", "--only", "chair"]) == 0


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--only", "nobody"], "no prompt has the id 'nobody'"),
        (["--annotations", "/dev/zero"], "not a file"),
        (["--annotations", "{tmp}/nothing.csv"], "No such file"),
        (["--out", "{tmp}/annotations.json"], "not a folder"),
    ],
)
def test_unusable_input(annotations, tmp_path, capsys, arguments, says):
    given = [argument.format(tmp=tmp_path) for argument in arguments]
    assert main(["evaluate", "--annotations", str(annotations), *given]) == 2
    assert says in capsys.readouterr().err


def test_an_id_that_leads_out_of_the_folder_is_refused(tmp_path, capsys):
    path = tmp_path / "a.json"
    path.write_text(json.dumps([ENTRIES[0] | {"id": "../escape"}]))
    assert main(["evaluate", "--annotations", str(path), "--out", str(tmp_path / "out")]) == 2
    assert "cannot name a folder" in capsys.readouterr().err
    assert not os.path.lexists(tmp_path / "escape")


def test_a_folder_of_rooms_that_is_not_there_is_refused(tmp_path: Path) -> None:
    from thinkblox.evaluation.room_run import judge_rooms

    with pytest.raises(InputError, match=r"nosuch: there is no such folder"):
        judge_rooms([], tmp_path / "nosuch")
