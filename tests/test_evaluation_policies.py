"""Policies measured by their own first answers: one request an object, nothing repaired, nothing lost when stopped."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec import structs

from tests.model_answers import answer_to, asked_of
from tests.stub_server import Body, Stub, stub
from thinkblox.cli import main
from thinkblox.crew import Done, work_through
from thinkblox.errors import InputError
from thinkblox.evaluation import policy_run
from thinkblox.evaluation.comparison import (
    Comparison,
    ContenderResult,
    comparison_json,
    comparison_markdown,
    comparison_text,
)
from thinkblox.evaluation.contenders import Contender
from thinkblox.evaluation.measures import ROOMS, STEPS, figure, psa
from thinkblox.evaluation.room_tally import RoomTally, StepTally
from thinkblox.observe import Sight
from thinkblox.value import to_json

pytest.importorskip("openai")
PROMPT = "An empty room, 4 m by 3 m, with nothing in it but a table and a chair."
GOOD = StepTally(
    id="bed_1", category="bed", parsed=True, valid=True, outside=0.0, free=True, supported=True, stable=True
)


def answered(body: Body) -> str:
    text = asked_of(body)
    if text.startswith("You judge a furnished room"):
        return '<think>So.</think><answer>{"position": 80, "rotation": 60}</answer>'
    return answer_to(text)


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    """One job is done in this process: others take seconds to begin."""

    def worked(function: Any, things: Any, *, jobs: int, seconds: float) -> Any:
        if jobs > 1:
            return work_through(function, things, jobs=jobs, seconds=seconds)
        return (Done(number, function(thing)) for number, thing in enumerate(things))

    monkeypatch.setattr(policy_run, "work_through", worked)


@pytest.fixture
def server() -> Iterator[Stub]:
    with stub(answered) as made:
        yield made


@pytest.fixture
def prompts(tmp_path: Path) -> Path:
    file = tmp_path / "prompts.txt"
    file.write_text(f"{PROMPT}\n\n")
    return file


def evaluate(out: Path, prompts: Path, *arguments: object) -> dict[str, Any]:
    said = ["evaluate", "--prompts", prompts, "--out", out, "--runs", 2, *arguments]
    assert main([str(argument) for argument in said]) == 0
    found: dict[str, Any] = json.loads((out / "evaluation.json").read_text())
    return found


@pytest.mark.slow
def test_policies_beside_one_another(server: Stub, prompts: Path, tmp_path: Path) -> None:
    found = evaluate(tmp_path / "out", prompts, "--policy", "expert", "--policy", server.spec, "--jobs", 2)
    expert, model = found["rows"]
    assert [row["contender"]["policy"] for row in (expert, model)] == ["expert", server.spec]
    assert [room["run"] for room in model["rooms"]] == [1, 2]
    steps = [step for room in model["rooms"] for step in room["steps"]]
    assert len(server.seen) == len(steps) == 4, "one request an object"
    assert all(body.get("n", 1) == 1 for body in server.seen)
    figures = model["figures"]["all"]
    assert figures["steps"]["parsed"][:2] == [100.0, 0.0]
    assert figures["rooms"]["CF"][2] == figures["rooms"]["IB 1 mm"][2] == [100.0, 100.0]
    assert "rated" not in figures
    text = (tmp_path / "out" / "evaluation.md").read_text()
    assert "1 prompts of prompts.txt, 2 runs from seed 0" in text


def test_what_cannot_be_read_or_stand_is_left_out(prompts: Path, tmp_path: Path) -> None:
    """The table is answered for with nonsense, and the chair is put into the wall."""

    def bad(body: Body) -> str:
        text = asked_of(body)
        said = json.loads(text.rpartition("Place: ")[2].partition("\n")[0])
        if said["category"] != "chair":
            return "Somewhere in the middle, I would say."
        answer = {"id": said["id"], "position": [4.0, 1.5, 0.0], "yaw": 0, "size": said["size"]}
        return f"<think>1. So.</think><answer>{json.dumps(answer)}</answer>"

    with stub(bad) as server:
        found = evaluate(tmp_path / "out", prompts, "--policy", server.spec, "--runs", 1)
        assert len(server.seen) == 2, "nobody is asked twice"
    (room,) = found["rows"][0]["rooms"]
    unread, outside = sorted(room["steps"], key=lambda step: step["parsed"])
    assert (unread["parsed"], unread["valid"]) == (False, False)
    assert outside["reasons"][0] in ("collision", "outside")
    assert outside["outside"] > 0.1
    assert (room["planned"], room["placed"]) == (2, 0)
    figures = found["rows"][0]["figures"]["all"]
    assert figures["steps"]["parsed"][0] == 50.0
    assert figures["rooms"]["CF"][0] == figures["rooms"]["IB 5 cm"][0] == figures["rooms"]["placed"][0] == 0.0


def test_at_once_the_model_is_asked_once(server: Stub, prompts: Path, tmp_path: Path) -> None:
    found = evaluate(tmp_path / "out", prompts, "--policy", server.spec, "--mode", "one-shot")
    assert len(server.seen) == 2
    assert found["rows"][0]["figures"]["all"]["steps"]["parsed"][0] == 100.0


def test_marks_can_be_left_out(server: Stub, prompts: Path, tmp_path: Path) -> None:
    evaluate(tmp_path / "a", prompts, "--policy", server.spec, "--runs", 1)
    evaluate(tmp_path / "b", prompts, "--policy", server.spec, "--runs", 1, "--without", "target", "--without", "ids")
    whole, less = (
        [part["type"] for part in server.seen[number]["messages"][-1]["content"]].count("image_url")
        for number in (0, 2)
    )
    assert (whole, less) == (4, 3)


def test_what_was_stopped_goes_on(server: Stub, prompts: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    before = evaluate(out, prompts, "--policy", server.spec)
    (out / "evaluation.json").unlink()
    next((out / "rooms").iterdir()).unlink()
    asked = len(server.seen)
    after = evaluate(out, prompts, "--policy", server.spec)
    assert len(server.seen) == asked + 2, "one room of two"
    assert after["rows"][0]["figures"]["all"]["steps"] == before["rows"][0]["figures"]["all"]["steps"]
    evaluate(out, prompts, "--policy", server.spec, "--overwrite")
    assert len(server.seen) == asked + 2 + 4


@pytest.mark.slow
def test_a_model_that_is_not_there_is_found_out_before_the_others_are_measured(
    server: Stub, prompts: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    gone = "openai:http://127.0.0.1:9/v1#gone"
    assert main(["evaluate", "--prompts", str(prompts), "--policy", server.spec, "--policy", gone]) == 2
    assert len(server.seen) == 2, "one room of three"
    assert "gone: http://127.0.0.1:9/v1: cannot be reached" in capsys.readouterr().err


@pytest.mark.slow
def test_a_model_that_is_not_there_leaves_nothing(prompts: Path, tmp_path: Path) -> None:
    gone = ["evaluate", "--prompts", str(prompts), "--policy", "openai:http://127.0.0.1:9/v1#gone"]
    assert main([*gone, "--out", str(tmp_path / "some" / "where")]) == 2
    assert sorted(tmp_path.iterdir()) == [prompts]
    measured = tmp_path / "rooms" / "0123456789abcdef.json"
    measured.parent.mkdir()
    measured.write_bytes(b"{}")
    assert main([*gone, "--out", str(tmp_path), "--overwrite"]) == 2
    assert list(measured.parent.iterdir()) == [measured], "what was measured before is still there"


def test_a_judge_rates_what_was_furnished(server: Stub, prompts: Path, tmp_path: Path) -> None:
    found = evaluate(tmp_path / "out", prompts, "--policy", "expert", "--judge", server.spec)
    assert found["judge"] == "stub"
    rated = found["rows"][0]["figures"]["all"]["rated"]
    assert (rated["Pos"][0], rated["Rot"][0], rated["PSA"][0]) == (80.0, 60.0, 70.0)
    assert "Rated by stub: a reconstruction" in (tmp_path / "out" / "evaluation.md").read_text()


def test_a_judge_that_does_not_rate_is_found_out_at_once(
    prompts: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with stub(lambda body: "It is nice.") as server:
        said = ["evaluate", "--prompts", str(prompts), "--policy", "expert", "--judge", server.spec]
        assert main(said) == 2
        assert len(server.seen) == 1
    assert "the judge stub does not rate" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--policy", "hf:{tmp}/nothing"], "hf:{tmp}/nothing: "),
        pytest.param(["--policy", "openai:http://127.0.0.1:9/v1#model"], "cannot be reached", marks=pytest.mark.slow),
        (["--policy", "replay:trace.jsonl"], "plays one room again"),
        (["--policy", "somebody"], "'somebody' names nobody"),
        (["--policy", "expert", "--mode", "one-shot"], "the expert answers step by step"),
        (["--policy", "expert", "--without", "grid"], "the expert answers step by step"),
        (["--policy", "expert", "--policy", "expert"], "expert is named twice"),
        (["--policy", "expert", "--reading"], "--reading does not go with --prompts"),
        (["--policy", "expert", "--judge", "rules"], "a judge of pictures is a model behind a server"),
        ([], "which policies?"),
    ],
)
def test_what_cannot_be_measured_is_said(
    prompts: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], says: str
) -> None:
    given = [argument.format(tmp=tmp_path) for argument in arguments]
    assert main(["evaluate", "--prompts", str(prompts), *given]) == 2
    assert says.format(tmp=tmp_path) in capsys.readouterr().err


def test_options_for_policies_need_prompts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", "--annotations", str(tmp_path), "--policy", "expert"]) == 2
    assert "--policy does not go with --annotations" in capsys.readouterr().err


def test_a_model_of_our_training_is_shown_what_it_was_trained_on(tmp_path: Path) -> None:
    sight = Sight(size=112, views=1, grid=False, words="compact")
    (tmp_path / "sight.json").write_bytes(to_json(sight))
    policy = f"hf:{tmp_path}"
    assert Contender(name="a", policy=policy).sight() == sight
    assert Contender(name="a", policy=policy, without=("ids",)).sight() == structs.replace(sight, ids=False)
    with pytest.raises(InputError, match="trained without grid"):
        Contender(name="a", policy=policy, without=("grid",)).check()
    (tmp_path / "sight.json").write_text('{"size": 3}')
    with pytest.raises(InputError, match=r"sight\.json"):
        Contender(name="a", policy=policy).check()


@pytest.mark.slow
def test_a_model_on_this_machine_has_its_tokens_counted(tiny_folder: Path, prompts: Path, tmp_path: Path) -> None:
    found = evaluate(tmp_path / "out", prompts, "--policy", f"hf:{tiny_folder}", "--runs", 1)
    (room,) = found["rows"][0]["rooms"]
    assert [step["parsed"] for step in room["steps"]] == [False, False]
    assert room["read"] > 200
    assert room["written"] > 2


def room(run: int, *steps: StepTally, planned: int | None = None, **more: Any) -> RoomTally:
    return RoomTally(prompt=1, run=run, kind="bedroom", steps=steps, planned=planned or len(steps), **more)


def test_scenes_are_free_and_inside_where_every_object_is() -> None:
    out = structs.replace(GOOD, outside=0.03, valid=False)
    into = structs.replace(GOOD, free=False, valid=False)
    assert room(1, GOOD, GOOD).free
    assert not room(1, GOOD, into).free
    assert room(1, GOOD, out).free
    assert [room(1, GOOD, out).inside(tolerance) for tolerance in (0.001, 0.01, 0.05)] == [False, False, True]
    assert not room(1, GOOD, planned=2).free
    assert not room(1, GOOD, planned=2).inside(0.05)


def test_psa_counts_what_is_free_and_inside() -> None:
    rated: dict[str, Any] = {"position": 90.0, "rotation": 50.0}
    assert psa(room(1, GOOD, **rated)) == 70.0
    assert psa(room(1, structs.replace(GOOD, free=False), **rated)) == 0.0
    assert psa(room(1, structs.replace(GOOD, outside=0.009), **rated)) == 70.0
    assert psa(room(1, structs.replace(GOOD, outside=0.02), **rated)) == 0.0
    assert psa(room(1, GOOD)) is None


def test_means_are_over_rooms_and_spreads_over_runs() -> None:
    bad = structs.replace(GOOD, valid=False)
    rooms = [room(1, GOOD, bad), room(1, bad, bad), room(2, GOOD, GOOD), room(2, bad, bad)]
    valid = next(measure for measure in STEPS if measure.name == "valid")
    found = figure(valid.of, rooms)
    assert found is not None
    assert found.runs == (25.0, 50.0)
    assert found.mean == 37.5
    assert found.spread == pytest.approx(17.68, abs=0.01)
    relations = next(measure for measure in STEPS if measure.name == "relations")
    assert figure(relations.of, rooms) is None
    alone = figure(valid.of, rooms[:2])
    assert alone is not None
    assert alone.spread is None


def test_refused_rooms_count_against_who_was_asked() -> None:
    rooms = [room(1, GOOD), RoomTally(prompt=2, run=1, refused="no")]
    shares = {measure.name: figure(measure.of, rooms) for measure in ROOMS}
    assert shares["CF"] is not None
    assert shares["CF"].mean == 50.0
    assert shares["refused"] is not None
    assert shares["refused"].mean == 1.0


def test_what_is_missing_is_in_every_table() -> None:
    here = ContenderResult(contender=Contender(name="SFT", policy="hf:a"), rooms=(room(1, GOOD),), published=21.9)
    gone = ContenderResult(contender=Contender(name="GRPO", policy="hf:b|c"), missing="b is not there")
    comparison = Comparison(prompts="p.txt", count=1, runs=1, seed=0, judge="j", rows=(here, gone))
    assert "b is not there" in comparison_text(comparison)
    text = comparison_markdown(comparison)
    assert "| GRPO | hf:b\\|c | b is not there |" in text
    assert "| PSA in the paper |" in text
    assert "no spread is known" in text
    assert json.loads(comparison_json(comparison))["rows"][1]["figures"]["all"]["steps"] == {}


def test_ablations_list_what_is_missing(server: Stub, prompts: Path, tmp_path: Path) -> None:
    file = tmp_path / "ablate.yaml"
    models = f"{{one_shot: '{server.spec}', sft: nowhere, size_order: expert}}"
    file.write_text(f"prompts: {prompts.name}\nruns: 1\nmodels: {models}\n")
    pytest.importorskip("yaml")
    assert main(["ablate", "--config", str(file), "--out", str(tmp_path / "out")]) == 1
    rows = {row["contender"]["name"]: row for row in json.loads((tmp_path / "out/evaluation.json").read_text())["rows"]}
    assert len(rows) == 16
    assert len(server.seen) == 1
    assert rows["SFT, one shot"]["contender"]["mode"] == "one-shot"
    assert not rows["SFT, one shot"]["missing"]
    assert rows["large objects first"]["contender"]["order"] == "size"
    assert rows["SFT"]["missing"] == f"{tmp_path}/nowhere is not there"
    assert rows["GRPO"]["missing"] == "models name no grpo"
    assert rows["without the grid"]["missing"] == "models name no without_grid"
    assert sum(not row["missing"] for row in rows.values()) == 2


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("prompts: p\nmodels: {best: expert}", "models name 'best'; there are one_shot"),
        ("models: {}", "missing required field `prompts`"),
        ("prompts: nothing.txt\nmodels: {}", "nothing.txt"),
    ],
)
def test_a_wrong_ablation_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, says: str) -> None:
    pytest.importorskip("yaml")
    file = tmp_path / "ablate.yaml"
    file.write_text(text)
    assert main(["ablate", "--config", str(file)]) == 2
    assert says in capsys.readouterr().err
