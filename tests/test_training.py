"""Trainers on a tiny model: they run, resume exactly, log what they measured, and refuse what cannot work."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from msgspec import structs

from tests.stub_server import stub
from thinkblox import InputError
from thinkblox.observe import Sight
from thinkblox.training.building import build
from thinkblox.training.config import GdpoConfig, SftConfig, read_experiment, section
from thinkblox.training.recipe import Recipe
from thinkblox.training.rows import rows_of

torch = pytest.importorskip("torch")
pytest.importorskip("trl")
CONFIGS = Path(__file__).parent.parent / "training" / "configs"
PROMPT = "A dining room with a table, four chairs around it, a sideboard and a vase on the table."


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("training") / "data"
    sight = Sight(size=56, views=1, words="compact")
    build(Recipe(scenes=3, prompts=(PROMPT,), least=3, sight=sight, held_out=(0.0, 0.0)), folder)
    return str(folder)


def sft(data: str, out: Path, **more: Any) -> SftConfig:
    from thinkblox.policies.tiny import TinySize

    size = TinySize(hidden=32, layers=1, heads=2, vocabulary=320, vision_hidden=16, vision_layers=1)
    defaults: dict[str, Any] = {"size": size, "steps": 4, "batch": 2, "learning_rate": 1e-3, "log": 1, "save": 2}
    return SftConfig(data=data, out=str(out), **(defaults | more))


@pytest.mark.parametrize("name", ["paper", "small", "gpu"])
def test_the_configurations_that_we_have_can_be_read(name: str) -> None:
    found = read_experiment(CONFIGS / f"{name}.yaml")
    assert None not in (found.data, found.sft, found.gdpo)
    assert found.gdpo is not None
    assert set(found.gdpo.tiers) == {"hard", "soft", "cons"}


def test_the_paper_s_numbers() -> None:
    found = read_experiment(CONFIGS / "paper.yaml")
    assert found.sft is not None
    assert found.sft.lora is not None
    assert found.gdpo is not None
    assert (found.sft.lora.rank, found.sft.lora.alpha, found.sft.learning_rate, found.sft.steps) == (
        16,
        32,
        2e-5,
        10000,
    )
    assert (found.gdpo.beta, found.gdpo.rollouts, found.gdpo.learning_rate, found.gdpo.steps) == (0.004, 8, 2e-5, 2000)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("sft: {data: d, out: o, steps: 1, speed: 3}", "unknown field `speed`.*there are `data`, `out`, `model`"),
        ("sft: {data: d, out: o, steps: 0}", r"`int` >= 1"),
        ("sft: {out: o, steps: 1}", "missing required field `data`"),
        ("gdpo: {data: d, out: o, steps: 1, soft: [align, beauty]}", "names the reward 'beauty'; there are format"),
        ("gdpo: {data: d, out: o, steps: 1, rollouts: 8, prompts: 3, batch: 5}", "choose a batch that divides 24"),
        (
            "gdpo: {data: d, out: o, steps: 1, weights: {firm: 1}}",
            "weights name 'firm'; the tiers are hard, soft, cons",
        ),
        ("gdpo: {data: d, out: o, steps: 1, soft: [render]}", "needs a judge"),
        ("gdpo: {data: d, out: o, steps: 1, soft: [coll]}", "'coll' is in two tiers"),
        ("gdpo: [", "line 2, column 1"),
        ("data: {scenes: 1}", "has no section 'sft'"),
    ],
)
def test_a_wrong_configuration_is_refused_at_once(tmp_path: Path, text: str, says: str) -> None:
    file = tmp_path / "run.yaml"
    file.write_text(text)
    with pytest.raises(InputError, match=says):
        section(file, "sft")


def test_schemes_are_tables_of_the_same_rewards() -> None:
    config = GdpoConfig(data="d", out="o", steps=1, hard="paper")
    assert config.tiers == {"hard": ("format", "coll", "layout"), "soft": ("align", "rules"), "cons": ("cons",)}
    assert [len(t) for t in structs.replace(config, scheme="grpo").tiers.values()] == [6]
    assert [len(t) for t in structs.replace(config, scheme="gdpo").tiers.values()] == [1] * 6


def test_what_is_no_dataset_is_said(tmp_path: Path, data: str) -> None:
    with pytest.raises(InputError, match="no dataset of ours"):
        rows_of(tmp_path, "train")
    with pytest.raises(InputError, match="no rows of the split 'test'"):
        rows_of(data, "test")
    broken = tmp_path / "broken"
    shutil.copytree(data, broken)
    next((broken / "data").glob("*.parquet")).write_bytes(b"PAR1 no more")
    with pytest.raises(InputError, match="cannot be read"):
        rows_of(broken, "train")


@pytest.mark.slow
def test_supervised_training_resumes_exactly(data: str, tmp_path: Path) -> None:
    from thinkblox.training.sft import train_sft

    whole = train_sft(sft(data, tmp_path / "whole"))
    cut = tmp_path / "cut"
    train_sft(sft(data, cut))
    shutil.rmtree(cut / "checkpoint-4")
    shutil.rmtree(cut / "model")
    again = train_sft(sft(data, cut))
    assert (again / "model.safetensors").read_bytes() == (whole / "model.safetensors").read_bytes()
    with pytest.raises(InputError, match="another configuration"):
        train_sft(sft(data, cut, seed=1))


def _files(folder: Path) -> dict[str, tuple[int, bytes]]:
    return {str(f): (f.stat().st_mtime_ns, f.read_bytes()) for f in sorted(folder.rglob("*")) if f.is_file()}


@pytest.mark.slow
def test_a_finished_training_is_left_alone(data: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The same command again changes nothing; a run that was stopped before its model was written writes it alone."""
    from thinkblox.cli import main
    from thinkblox.training.sft import train_sft

    out = tmp_path / "out"
    model = train_sft(sft(data, out, steps=2))
    weights, before = (model / "model.safetensors").read_bytes(), _files(out)
    assert train_sft(sft(data, out, steps=2)) == model
    file = tmp_path / "run.yaml"
    file.write_text(json.dumps({"sft": json.loads((out / "config.json").read_text())}))
    assert main(["train", "sft", "--config", str(file)]) == 0
    assert "finished before, all 2 steps; nothing was done" in capsys.readouterr().out
    assert _files(out) == before
    shutil.rmtree(model)
    (out / "trainer_state.json").unlink()
    train_sft(sft(data, out, steps=2))
    assert (model / "model.safetensors").read_bytes() == weights
    assert json.loads((out / "trainer_state.json").read_text())["global_step"] == 2
    assert not (out / "checkpoint-3").exists()


@pytest.mark.slow
def test_tiered_training_measures_and_logs(data: str, tmp_path: Path) -> None:
    from thinkblox.policies.hf import HfModel
    from thinkblox.training.gdpo import train_gdpo
    from thinkblox.training.sft import train_sft

    start = train_sft(sft(data, tmp_path / "sft", steps=1))
    config = GdpoConfig(
        data=data,
        out=str(tmp_path / "gdpo"),
        model=str(start),
        steps=2,
        batch=4,
        rollouts=4,
        prompts=2,
        tokens=12,
        log=1,
    )
    with stub(lambda body: "Yes", logprobs={"Yes": 0.0}) as server:
        config = structs.replace(config, soft=("align", "rules", "render"), judge=server.spec)
        trained = train_gdpo(config)
        before = _files(tmp_path / "gdpo")
        assert len(server.seen) == 1, "nothing was there to be judged, but the judge was tried"
    assert train_gdpo(config) == trained
    assert _files(tmp_path / "gdpo") == before, "a finished run is left alone"
    state = json.loads((tmp_path / "gdpo" / "checkpoint-2" / "trainer_state.json").read_text())
    logged = state["log_history"][0]
    assert logged["rewards/render:stub/mean"] == 0.0, "the log says who judged"
    assert {"rewards/coll/mean", "share/parsed", "share/valid", "tiers/hard/live", "tiers/cons/spread"} <= set(logged)
    assert logged["rewards/format/mean"] == -1.0
    assert HfModel(trained, max_new_tokens=4).sight == Sight(size=56, views=1, words="compact")


@pytest.mark.slow
def test_advantages_that_differ_move_the_model(data: str, tmp_path: Path) -> None:
    """With a reward that prefers some rollouts, the trainer's advantages are those of the tiers, and weights change."""
    from thinkblox.judging import Try
    from thinkblox.policies.pretrained import load_pretrained
    from thinkblox.policies.tiny import TinySize, build_tiny
    from thinkblox.steps import Rejection
    from thinkblox.training.gdpo import gdpo_trainer
    from thinkblox.training.outcome import Asked, Rollout

    size = TinySize(hidden=32, layers=1, heads=2, vocabulary=320, vision_hidden=16, vision_layers=1)
    start = load_pretrained(build_tiny(tmp_path / "tiny", size=size))
    from thinkblox.training.episodes import Episodes

    case: Asked = Episodes(data).case("0/0/0")

    def measure(at, texts):
        good, bad = Try(text=""), Try(text="", rejection=Rejection(reason="format", message="no"))
        return [Rollout(case, good if number % 3 else bad) for number, _ in enumerate(texts)]

    config = GdpoConfig(
        data=data, out=str(tmp_path / "out"), steps=1, batch=8, rollouts=4, prompts=2, tokens=8, hard="paper", log=1,
        learning_rate=1e-2,
    )  # fmt: skip
    before = {name: weight.clone() for name, weight in start.model.named_parameters()}
    trainer = gdpo_trainer(config, start.model.train(), start.processor, rows_of(data, "train"), measure)
    trainer.train()
    assert any(not torch.equal(before[name], weight) for name, weight in start.model.named_parameters())
    advantages = list(trainer._logs["advantages"])
    assert len(advantages) == 8
    assert sum(advantages) == pytest.approx(0.0, abs=1e-5)
    assert advantages[0] < 0.0 < advantages[1]


@pytest.mark.slow
def test_a_model_learns_to_read_before_it_answers(data: str, tmp_path: Path) -> None:
    """The loss is on all that is said for as many updates as are asked for, and then on the answer alone."""
    from thinkblox.training.models import starting_model
    from thinkblox.training.running import run
    from thinkblox.training.sft import sft_trainer

    config = sft(data, tmp_path / "sft", steps=4, reading=2)
    start = starting_model(config)
    trainer = sft_trainer(config, start.model, start.processor, rows_of(data, "train"))
    taken = []
    step = trainer.training_step

    def training_step(model: Any, inputs: Any, *more: Any) -> Any:
        taken.append(float((inputs["labels"] != -100).sum() / inputs["attention_mask"].sum()))
        return step(model, inputs, *more)

    trainer.training_step = training_step
    run(trainer, config)
    assert taken[:2] == [1.0, 1.0]
    assert max(taken[2:]) < 0.8


@pytest.mark.slow
def test_pictures_keep_their_places_where_prompts_are_padded(data: str, tmp_path: Path) -> None:
    """Of prompts of different lengths in one batch, TRL is told rightly which tokens stand for pictures."""
    from thinkblox.training.gdpo import gdpo_trainer
    from thinkblox.training.models import starting_model

    config = GdpoConfig(data=data, out=str(tmp_path / "out"), steps=1, batch=4, rollouts=2, prompts=2, tokens=4)
    start = starting_model(sft(data, tmp_path / "sft"))
    rows = rows_of(data, "train")
    gdpo_trainer(config, start.model, start.processor, rows, lambda at, texts: [])
    template = start.processor.apply_chat_template
    said = [template([{"role": "user", "content": "<|image_pad|>" + "long " * n}], tokenize=False) for n in (1, 9)]
    found = start.processor(text=said, images=[[row["images"][0]] for row in (rows[0], rows[1])], padding=True)
    for ids, types, mask in zip(found["input_ids"], found["mm_token_type_ids"], found["attention_mask"], strict=True):
        assert mask[-1] == 1
        picture = start.processor.image_token_id
        assert [kind == 1 for kind in types] == [token == picture for token in ids]
