"""How well single steps of held-out rooms are placed: by a model, by simple rules to be beaten, and by the expert."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from thinkblox.free_places import free_places
from thinkblox.observe import Layout
from thinkblox.policies.pretrained import Pretrained
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.steps import Step, parse, write_step
from thinkblox.training.episodes import Episodes
from thinkblox.training.outcome import SHARES, Asked, Rollout, outcomes
from thinkblox.training.rewards import REWARDS
from thinkblox.training.rows import rows_of
from thinkblox.training.tiers import HARD
from thinkblox.value import Value

Answers = Callable[[Sequence[dict[str, Any]]], list[str]]
"""Answers rows of a dataset, one text each."""


class Score(Value, frozen=True, kw_only=True):
    """Shares over steps, 0 to 1, and means of the tiers' rewards.

    Attributes:
        steps: how many.
        parsed: could be used.
        free: not in anything.
        inside: not outside the room.
        valid: nothing speaks against it.
        by_mount: valid ones by what the object is placed on: (valid, of).
        reasons: how often each spoke against one.
        hard, soft, cons: mean of the sums of a tier's rewards.
    """

    steps: int
    parsed: float
    free: float
    inside: float
    valid: float
    by_mount: dict[str, tuple[int, int]]
    reasons: dict[str, int]
    hard: float
    soft: float
    cons: float


def score_steps(data: str | Path, answers: Answers, pool: VerdictPool, *, split: str = "test", most: int = 0) -> Score:
    """Let somebody answer the steps of a split, and measure that.

    Args:
        data: folder of a dataset.
        answers: who answers.
        pool: measures.
        split: of which rooms.
        most: rows, evenly spread over the split; all when 0.
    """
    rows = rows_of(data, split)  # type: ignore[arg-type]
    chosen = np.linspace(0, len(rows) - 1, min(most or len(rows), len(rows))).round().astype(int)
    picked = [rows[int(index)] for index in chosen]
    episodes = Episodes(data)
    cases = [episodes.case(row["at"]) for row in picked]
    texts = answers(picked)
    found = outcomes(pool, [(case, [text]) for case, text in zip(cases, texts, strict=True)])
    return score_of([row[0] for row in found])


def score_of(found: Sequence[Rollout]) -> Score:
    """The shares and means of what became of some steps."""
    verdicts = [each.tried.verdict for each in found]
    mounts: dict[str, list[bool]] = defaultdict(list)
    reasons: dict[str, int] = defaultdict(int)
    for each, verdict in zip(found, verdicts, strict=True):
        mounts[each.case.asset.mount].append(bool(verdict and verdict.valid))
        for reason in verdict.reasons if verdict else ("unread",):
            reasons[reason] += 1

    def share(holds: Iterable[bool]) -> float:
        return round(float(np.mean(list(holds))), 4)

    def measured(name: str) -> float:
        return share(verdict is not None and SHARES[name](verdict) for verdict in verdicts)

    return Score(
        steps=len(found),
        parsed=share(each.parsed for each in found),
        free=measured("free"),
        inside=measured("inside"),
        valid=measured("valid"),
        by_mount={mount: (sum(valid), len(valid)) for mount, valid in sorted(mounts.items())},
        reasons=dict(sorted(reasons.items(), key=lambda item: -item[1])),
        hard=_mean(found, HARD["simulation"]),
        soft=_mean(found, ("align", "rules")),
        cons=_mean(found, ("cons",)),
    )


def _mean(found: Sequence[Rollout], names: Sequence[str]) -> float:
    table = np.array([REWARDS[name](outcome=found) for name in names], float)
    return round(float(np.nansum(table, 0).mean()), 4)


def demonstrated(rows: Sequence[dict[str, Any]]) -> list[str]:
    """The answers of the demonstrations themselves."""
    return [row["completion"][0]["content"][0]["text"] for row in rows]


def anywhere(rows: Sequence[dict[str, Any]], episodes: Episodes, rng: np.random.Generator) -> list[str]:
    """Random poses in the room, at the height where such things are."""

    def pose(case: Asked) -> tuple[float, float, float, float]:
        width, depth = case.scene.room.extent
        return (rng.uniform(0, width), rng.uniform(0, depth), _height(case), float(rng.integers(4)) * 90)

    return [_said(episodes.case(row["at"]), *pose(episodes.case(row["at"]))) for row in rows]


def _height(case: Asked) -> float:
    room, asset = case.scene.room, case.asset
    return {"ceiling": room.height - asset.size[2], "wall": 1.5}.get(asset.mount, 0.0)


def _said(case: Asked, x: float, y: float, z: float, yaw: float) -> str:
    return write_step(("It goes here.",), id=case.target.id, position=(x, y, z), yaw=yaw, size=case.asset.size)


@dataclass
class UsualPoses:
    """Puts everything at the median pose of its category, scaled to the room: what a policy must beat."""

    episodes: Episodes
    poses: dict[str, list[tuple[float, float, float, float]]] = field(default_factory=lambda: defaultdict(list))

    def learn(self, rows: Iterable[dict[str, Any]]) -> "UsualPoses":
        """Take in where the demonstrations put things."""
        for row in rows:
            step = parse(demonstrated([row])[0])
            if isinstance(step, Step) and step.position is not None and step.yaw is not None:
                width, depth = self.episodes.case(row["at"]).scene.room.extent
                x, y, z = step.position
                self.poses[row["category"]].append((x / width, y / depth, z, step.yaw))
        return self

    def __call__(self, rows: Sequence[dict[str, Any]]) -> list[str]:
        """A text for each row."""
        return list(self._answers(rows))

    def _answers(self, rows: Sequence[dict[str, Any]]) -> Iterator[str]:
        every = [pose for poses in self.poses.values() for pose in poses]
        for row in rows:
            case = self.episodes.case(row["at"])
            width, depth = case.scene.room.extent
            seen = self.poses.get(row["category"]) or every
            x, y, z = (median(pose[axis] for pose in seen) for axis in range(3))
            yaws = [round(pose[3] / 90) % 4 * 90 for pose in seen]
            yield _said(case, x * width, y * depth, z, float(max(set(yaws), key=yaws.count)))


class FirstFree:
    """Puts everything in the middle of the first line that is told to be free (`thinkblox.free_places`).

    What a policy knows that is shown these lines, and heeds nothing else.
    """

    def __init__(self, episodes: Episodes) -> None:
        self._episodes = episodes

    def __call__(self, rows: Sequence[dict[str, Any]]) -> list[str]:
        """A text for each row."""
        return [self._answer(self._episodes.case(row["at"])) for row in rows]

    def _answer(self, case: Asked) -> str:
        width, depth = case.scene.room.extent
        found = free_places(Layout.of(case.scene), case.target, case.asset.card)
        if not found:
            return _said(case, width / 2, depth / 2, _height(case), 0.0)
        x, y, z = ((a + b) / 2 for a, b in zip(found[0].start, found[0].end, strict=True))
        return _said(case, x, y, z, found[0].yaw)


class ModelAnswers:
    """Lets a model answer many rows at once."""

    def __init__(self, model: Pretrained, *, batch: int = 32, tokens: int = 400, temperature: float = 0.0) -> None:
        self._model, self._batch, self._tokens, self._temperature = model, batch, tokens, temperature

    def __call__(self, rows: Sequence[dict[str, Any]]) -> list[str]:
        """A text for each row; the likeliest one where the temperature is 0."""
        texts: list[str] = []
        for start in range(0, len(rows), self._batch):
            texts += self._some(rows[start : start + self._batch])
        return texts

    def _some(self, rows: Sequence[dict[str, Any]]) -> list[str]:
        import torch

        processor, model = self._model.processor, self._model.model
        processor.tokenizer.padding_side = "left"
        said = [processor.apply_chat_template(_kept(row), tokenize=False, add_generation_prompt=True) for row in rows]
        pictures = [image for row in rows for image in row["images"]]
        inputs = processor(text=said, images=pictures or None, padding=True, return_tensors="pt").to(model.device)
        drawn = {"do_sample": True, "temperature": self._temperature} if self._temperature else {"do_sample": False}
        with torch.inference_mode():
            out = model.generate(**inputs, max_new_tokens=self._tokens, **drawn)
        said_back = out[:, inputs["input_ids"].shape[1] :]
        return list(processor.tokenizer.batch_decode(said_back, skip_special_tokens=True))


def _kept(row: dict[str, Any]) -> list[dict[str, Any]]:
    """The messages of a row without the empty fields that a table gives to each block."""
    return [
        {
            "role": message["role"],
            "content": [{k: v for k, v in block.items() if v is not None} for block in message["content"]],
        }
        for message in row["prompt"]
    ]
