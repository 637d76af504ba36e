"""Scores of policies and of simple rules on held-out steps, into a file."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from thinkblox.errors import InputError
from thinkblox.policies.pretrained import load_pretrained
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.training.episodes import Episodes
from thinkblox.training.held_out import (
    Answers,
    FirstFree,
    ModelAnswers,
    UsualPoses,
    anywhere,
    demonstrated,
    score_steps,
)
from thinkblox.training.recipe import Split
from thinkblox.training.report import ScoredAnswers, add_score
from thinkblox.training.rows import rows_of

RULES = ("expert", "usual", "anywhere", "first-free")
TOKENS = 200
"""Longest answer of a model."""


def score_all(
    names: Sequence[str],
    data: Path,
    out: Path,
    *,
    split: Split = "test",
    most: int = 0,
    temperature: float = 0.0,
    workers: int = 2,
) -> Iterator[ScoredAnswers]:
    """Let each of several answer the same held-out steps, and add each score to a file as it is known.

    Args:
        names: of `RULES`, or NAME=FOLDER of a model.
        data: folder of a dataset.
        out: the file.
        split: of which rooms.
        most: rows, evenly spread; all when 0.
        temperature: of models.
        workers: processes that measure.

    Raises:
        InputError: a name that is none, a model or a dataset that cannot be used; said before any is scored.
    """
    episodes = Episodes(data)
    found = [(name.partition("=")[0], _answers(name, data, episodes, temperature)) for name in names]
    rows = f"{split} steps" + ("" if temperature == 0.0 else f", temperature {temperature:g}")
    with VerdictPool(workers=workers) as pool:
        for who, answers in found:
            score = score_steps(data, answers, pool, split=split, most=most)
            scored = ScoredAnswers(who=who, data=rows, score=score)
            add_score(out, scored)
            yield scored


def _answers(name: str, data: Path, episodes: Episodes, temperature: float) -> Answers:
    who, equals, folder = name.partition("=")
    if equals and who and folder:
        return ModelAnswers(load_pretrained(folder), tokens=TOKENS, temperature=temperature)
    if name == "expert":
        return demonstrated
    if name == "usual":
        return UsualPoses(episodes).learn(rows_of(data, "train"))
    if name == "first-free":
        return FirstFree(episodes)
    if name == "anywhere":
        return lambda rows: _anywhere(rows, episodes)
    raise InputError(f"{name!r} is nobody to score; give {', '.join(RULES)} or NAME=MODEL_FOLDER")


def _anywhere(rows: Sequence[dict[str, Any]], episodes: Episodes) -> list[str]:
    return anywhere(rows, episodes, np.random.default_rng(0))
