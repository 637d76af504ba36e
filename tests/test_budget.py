"""A budget ends the placing of objects with what stands by then, and an honest report."""

import json
import time
from pathlib import Path

import pytest

from thinkblox.cli import main
from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.placing import Effort
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.value import to_json

MANY = "A room of 4 m by 4 m with 1000 chairs."


@pytest.mark.slow
def test_what_the_budget_left_out_is_absent_and_says_why() -> None:
    begin = time.process_time()
    result = generate_room(MANY, effort=Effort(seconds=1.0))
    assert time.process_time() - begin < 120.0, "of computing, whatever else the machine does"
    assert not result.report.complete
    placed, absent = len(result.scene.placements), result.report.absent
    chairs = [absence for absence in absent if absence.category == "chair"]
    assert placed + len(chairs) == len(result.plan.targets)
    assert any("the budget of 1 s was over" in absence.reason for absence in chairs)
    assert not any(done.attempt for done in result.trace), "it is not begun anew"


def test_a_budget_that_is_not_used_up_changes_nothing() -> None:
    rooms = [generate_room("A room with a chair.", effort=Effort(seconds=s)).scene for s in (600.0, 9000.0)]
    assert to_json(rooms[0]) == to_json(rooms[1])


@pytest.mark.parametrize("seconds", [0.0, -1.0, float("nan")])
def test_a_budget_is_more_than_nothing(seconds: float) -> None:
    with pytest.raises(InputError, match="budget"):
        Effort(seconds=seconds)


def test_the_command_has_a_budget(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["generate", MANY, "--out", str(tmp_path / "room"), "--no-pictures", "--json"]
    assert main([*command, "--budget", "0.000001"]) == 1
    report = json.loads(capsys.readouterr().out)
    assert report["objects"] == []
    assert "the budget of 1e-06 s was over" in report["absent"][0]["reason"]


def test_rooms_have_only_so_many_corners_and_openings() -> None:
    corners = (*((x / 100, 0.0) for x in range(0, 500, 2)), (5.0, 4.0), (0.0, 4.0))
    with pytest.raises(InputError, match="252 corners; at most 200 are read"):
        Room(floor=corners)
    windows = [Opening(id=f"window_{n}", kind="window", wall=0, offset=0, width=1, height=1) for n in range(9000)]
    with pytest.raises(InputError, match="9000 entries; at most 200 are read"):
        rectangle(4.0, 4.0, openings=tuple(windows))
