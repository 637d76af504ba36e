"""A dataset of demonstrations: what is in it, what is kept out, and that it is made once, whatever happens."""

import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from thinkblox import InputError
from thinkblox.chat import Chat
from thinkblox.cli import main
from thinkblox.episode import Episode, episode_of
from thinkblox.free_places import free_places
from thinkblox.generate import generate_room
from thinkblox.observe import Observation, Sight
from thinkblox.phrases import planned_constraints
from thinkblox.placing import Effort
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.steps import Step, parse, write_step
from thinkblox.training.building import build
from thinkblox.training.demonstration import demonstrations, scene_of
from thinkblox.training.episodes import Episodes
from thinkblox.training.filters import Filters, fault_of
from thinkblox.training.recipe import Recipe
from thinkblox.training.repredict import repredicted
from thinkblox.training.rows import rows_of
from thinkblox.training.shard import row

pytest.importorskip("datasets")
PROMPTS = (
    "A bedroom, 4 m by 4 m, with a bed, two nightstands with a lamp on each, a desk with a chair and a picture.",
    "A dining room with a table, four chairs around it and a vase on the table.",
)
SMALL = Recipe(
    scenes=3, seed=5, block=2, prompts=PROMPTS, sight=Sight(size=56, views=1, words="compact"), worked=True, least=3
)


@pytest.fixture(scope="module")
def episode() -> Episode:
    return generate_room(PROMPTS[0], seed=2, effort=Effort(restarts=0)).episode


def files(folder: Path) -> dict[str, bytes]:
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("data") / "small"
    build(SMALL, folder)
    return folder


@pytest.mark.slow
def test_it_is_read_by_datasets(dataset: Path) -> None:
    rows = rows_of(dataset, "train")
    assert {"prompt", "completion", "images", "scene", "at", "id", "category", "room", "asked"} <= set(
        rows.column_names
    )
    first = rows[0]
    assert [part["type"] for part in first["prompt"][-1]["content"]].count("image") == len(first["images"]) == 2
    assert first["images"][0].size == (56, 56)
    assert isinstance(parse(first["completion"][0]["content"][0]["text"]), Step)
    assert "steps of 3 rooms" in (dataset / "README.md").read_text()


class Recorder:
    """The expert, and what it was shown."""

    def __init__(self) -> None:
        self.seen: dict[str, Chat] = {}

    def propose(self, observation: Observation, n: int, rng: np.random.Generator) -> list[str]:
        self.seen[observation.target.id] = observation.chat(SMALL.sight)
        return ExpertPolicy().propose(observation, n, rng)


def test_a_row_is_what_the_policy_saw() -> None:
    """From the saved episode, the very bytes come that were shown at run time."""
    policy = Recorder()
    made = generate_room(PROMPTS[1], seed=1, policy=policy, effort=Effort(restarts=0)).episode
    saved = episode_of(made.to_jsonl().splitlines(), "saved")
    found = list(demonstrations(saved, Filters(), worked=False, refused=Counter()))
    assert len(found) >= 6
    for each, decision in found:
        again = row(each, decision.observation.chat(SMALL.sight), scene=0, at="0/0/0")
        assert again == row(each, policy.seen[each.id], scene=0, at="0/0/0")


def test_a_row_names_its_decision(dataset: Path) -> None:
    rows = rows_of(dataset, "train")
    episodes = Episodes(dataset)
    for each in rows.select(range(0, len(rows), 4)):
        case = episodes.case(each["at"])
        assert case.target.id == each["id"]
        assert each["id"] not in case.scene


def test_whole_rooms_belong_to_one_split() -> None:
    recipe = Recipe(scenes=2000, held_out=(0.1, 0.2))
    found = [recipe.split_of(number) for number in range(2000)]
    assert found == [recipe.split_of(number) for number in range(2000)]
    assert 0.07 < found.count("validation") / 2000 < 0.13
    assert 0.16 < found.count("test") / 2000 < 0.24


@pytest.mark.slow
def test_made_twice_it_is_the_same(dataset: Path, tmp_path: Path) -> None:
    done: list[int] = []
    build(SMALL, tmp_path / "again", workers=2, on_shard=lambda count, *_: done.append(count.shard))
    assert sorted(done) == [0, 1]
    assert files(tmp_path / "again") == files(dataset)


@pytest.mark.slow
def test_what_is_there_is_not_made_again(dataset: Path, tmp_path: Path) -> None:
    def nobody(function, shards):
        assert shards == []
        return []

    before = files(dataset)
    build(SMALL, dataset, work=nobody)
    assert files(dataset) == before
    with pytest.raises(InputError, match="another recipe"):
        build(structs.replace(SMALL, seed=6), dataset)
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(InputError, match="no dataset of ours"):
        build(SMALL, tmp_path)


@pytest.mark.slow
def test_killed_again_and_again_it_loses_and_doubles_nothing(dataset: Path, tmp_path: Path) -> None:
    prompts = tmp_path / "prompts.txt"
    prompts.write_text("\n".join(PROMPTS))
    command = [sys.executable, "-m", "thinkblox", "data", "build", "--scenes", "8", "--prompts", str(prompts)]
    whole, cut = tmp_path / "whole", tmp_path / "cut"
    subprocess.run([*command, "--out", str(whole)], check=True, capture_output=True)
    for number in range(10):
        process = subprocess.Popen([*command, "--out", str(cut)], stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        time.sleep(1.0 + 0.7 * number)
        process.send_signal(signal.SIGKILL if number % 2 else signal.SIGTERM)
        process.wait()
    subprocess.run([*command, "--out", str(cut)], check=True, capture_output=True)
    assert files(cut) == files(whole)


def test_the_reasons_lead_to_the_answer(episode: Episode) -> None:
    for decision in episode.decisions():
        assert decision.round.chosen is not None
        text = decision.round.tries[decision.round.chosen].text
        step = parse(text)
        assert isinstance(step, Step)
        found = repredicted(scene_of(decision), step)
        assert found is not None, text
        assert found[0] == pytest.approx(step.position, abs=0.05)
        assert found[1] == pytest.approx(step.yaw, abs=0.1)


def test_filters_refuse_what_is_not_good(episode: Episode) -> None:
    """Each kind of fault, put into every step of an episode, is found."""
    refused = dict.fromkeys(("tags", "steps", "words", "agreement", "verdict"), 0)
    seen = 0
    for decision in episode.decisions():
        assert decision.round.chosen is not None
        tried, scene = decision.round.tries[decision.round.chosen], scene_of(decision)
        step = parse(tried.text)
        assert isinstance(step, Step)
        assert step.position is not None
        assert fault_of(scene, tried.text, tried.verdict, Filters()) is None
        lines = [line.partition(". ")[2] for line in step.think.splitlines()]
        x, y, z = step.position

        def said(lines, position, yaw=step.yaw, step=step):
            return write_step(lines, id=step.id, position=position, yaw=yaw, size=step.size)

        moved = said(lines, (x + 0.5, y, z))
        faults = {
            "tags": tried.text.replace("</think>", ""),
            "steps": said([" ".join(lines)], step.position),
            "words": said(["Here.", "It fits.", "So be it."], step.position),
            "agreement": moved,
        }
        seen += 1
        for kind, text in faults.items():
            refused[kind] += fault_of(scene, text, tried.verdict, Filters()) == kind
        assert tried.verdict is not None
        bad = structs.replace(tried.verdict, valid=False, reasons=("collision",))
        refused["verdict"] += fault_of(scene, tried.text, bad, Filters()) == "verdict"
    assert seen >= 7
    assert refused == dict.fromkeys(refused, seen)


def test_what_is_worked_out_leads_to_the_answer(episode: Episode) -> None:
    """The last line of reasoning has the pose of the answer, and the free line that is named holds it."""
    named = 0
    for made, decision in demonstrations(episode, Filters(), worked=True, refused=Counter()):
        step = parse(made.text)
        assert isinstance(step, Step)
        assert step.position is not None
        said = {constraint.kind: constraint.values for constraint in planned_constraints(step)}
        assert said["at"] == step.position[:2]
        assert said["turned"] == (step.yaw,)
        free = step.think.splitlines()[1]
        seen = decision.observation
        by = {f"Free {stretch.by}" for stretch in free_places(seen.layout, seen.target, seen.asset)}
        if free.partition(". ")[2].partition(":")[0] in by:
            named += 1
        else:
            assert free.endswith("None of the free lines is taken.")
    assert named >= 4


def test_a_bad_row_is_named(dataset: Path) -> None:
    with pytest.raises(InputError, match="99999"):
        Episodes(dataset).case("99999/0/0")
    with pytest.raises(InputError, match="has no episode 8"):
        Episodes(dataset).case("0/7/0")
    with pytest.raises(InputError, match="no decision 900"):
        Episodes(dataset).case("0/0/900")
    with pytest.raises(InputError, match="is no place"):
        Episodes(dataset).case("first")


def test_an_empty_dataset_says_why_and_its_recipe_makes_it_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "prompts.txt").write_text("Just a chair and nothing else.\n")
    asked = ["--scenes", "1", "--prompts", str(tmp_path / "prompts.txt"), "--out", str(tmp_path / "a")]
    assert main(["data", "build", *asked]) == 1
    said = capsys.readouterr()
    assert "1 rooms of fewer than 5 objects" in said.out
    assert "nothing is in the dataset" in said.err
    card = (tmp_path / "a" / "README.md").read_text()
    assert "| rooms of fewer than 5 objects | 1 |" in card
    assert "thinkblox data build --recipe recipe.json --out DIR" in card
    again = ["--recipe", str(tmp_path / "a" / "recipe.json"), "--out", str(tmp_path / "b")]
    assert main(["data", "build", *again]) == 1
    assert (tmp_path / "b" / "manifest.json").read_bytes() == (tmp_path / "a" / "manifest.json").read_bytes()
