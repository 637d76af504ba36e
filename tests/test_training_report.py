"""What came of runs: tables and curves from what they left behind, and who can be scored."""

import json
from pathlib import Path

import pytest

from thinkblox import InputError
from thinkblox.training.curves import Panel, draw, smoothed
from thinkblox.training.held_out import Score
from thinkblox.training.report import BEGIN, END, ScoredAnswers, add_score, read_scores, report, write_between


def score(valid: float) -> Score:
    return Score(
        steps=40,
        parsed=1.0,
        free=0.9,
        inside=0.95,
        valid=valid,
        by_mount={"floor": (int(30 * valid), 30), "wall": (4, 10)},
        reasons={"collision": 3},
        hard=-0.2,
        soft=0.8,
        cons=-0.1,
    )


@pytest.fixture
def results(tmp_path: Path) -> Path:
    folder = tmp_path / "results"
    runs = {"sft_1": ({"seed": 1}, "loss"), "tiered_1": ({"seed": 1, "scheme": "tiered"}, "share/valid")}
    for name, (config, key) in runs.items():
        (folder / name).mkdir(parents=True)
        (folder / name / "config.json").write_text(json.dumps(config))
        history = [{"step": 10 * n, key: 1.0 / (n + 1)} for n in range(5)] + [{"step": 40, "train_runtime": 120.0}]
        (folder / name / "trainer_state.json").write_text(json.dumps({"log_history": history}))
    add_score(folder / "scores.json", ScoredAnswers(who="usual", data="test steps", score=score(0.4)))
    return folder


def test_a_report_has_every_run_and_every_score(results: Path, tmp_path: Path) -> None:
    made = report(results, tmp_path / "pictures")
    assert "| usual | 40 test steps | 100.0 | 90.0 | 95.0 | 40.0 |" in made
    assert "| tiered_1 | 40 | 2 | scheme tiered, seed 1 |" in made
    assert {file.name for file in (tmp_path / "pictures").iterdir()} == {"loss.png", "reward.png"}


def test_a_score_takes_the_place_of_an_older_one(results: Path) -> None:
    add_score(results / "scores.json", ScoredAnswers(who="usual", data="test steps", score=score(0.5)))
    add_score(results / "scores.json", ScoredAnswers(who="sft", data="test steps", score=score(0.8)))
    assert [(each.who, each.score.valid) for each in read_scores(results / "scores.json")] == [
        ("usual", 0.5),
        ("sft", 0.8),
    ]


def test_only_what_is_between_the_marks_is_made_anew(tmp_path: Path) -> None:
    file = tmp_path / "results.md"
    file.write_text(f"# Mine\n\n{BEGIN}\nold\n{END}\n\nStays.\n")
    write_between(file, "new\n")
    assert file.read_text() == f"# Mine\n\n{BEGIN}\n\nnew\n\n{END}\n\nStays.\n"
    file.write_text("no marks")
    with pytest.raises(InputError, match="has no place for the tables"):
        write_between(file, "new")


def test_a_folder_without_results_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="holds no results"):
        report(tmp_path, tmp_path)


def test_curves_are_drawn_and_smoothed() -> None:
    points = [(float(n), float(n % 2)) for n in range(40)]
    assert max(value for _, value in smoothed(points, 0.5)) < 0.7
    picture = draw([Panel("a", {"one": points, "two": points[:3]}), Panel("b", {"one": []})])
    assert picture.size == (840, 284)
    assert len(picture.getcolors(10_000) or []) > 3


def test_nobody_is_scored_who_is_not_known(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    from thinkblox.training.scoring import score_all

    with pytest.raises(InputError, match="'me' is nobody to score; give expert, usual"):
        next(score_all(["me"], tmp_path, tmp_path / "scores.json"))
