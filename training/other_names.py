"""Rows whose object goes by another name, which a model cannot guess from the size: so it learns to read."""

import re
from typing import Any

import numpy as np

from thinkblox.training.rows import Row


def with_other_names(rows: Any, share: float, seed: int) -> Any:
    """Rows of a dataset, some of them with another id for their object, in what is shown and in what is answered alike.

    Args:
        rows: as `datasets` has them.
        share: of the rows that are changed.
        seed: of the choice.
    """
    names = sorted(set(rows["category"]))

    def changed(prompt: Any, completion: Any, id: str, index: int) -> Row:
        rng = np.random.default_rng((seed, index))
        if rng.random() >= share:
            return {"prompt": prompt, "completion": completion}
        other = f"{names[int(rng.integers(len(names)))]}_{int(rng.integers(1, 10))}"
        return {"prompt": _said_of(other, id, prompt), "completion": _said_of(other, id, completion)}

    return rows.map(changed, input_columns=["prompt", "completion", "id"], with_indices=True)


def _said_of(other: str, id: str, messages: Any) -> Any:
    """Messages with another id in the place of one."""
    old = re.compile(rf"(?<![a-z0-9_]){re.escape(id)}(?![a-z0-9_])")

    def block(part: Row) -> Row:
        return {**part, "text": old.sub(other, part["text"])} if part.get("text") else part

    return [{**message, "content": [block(part) for part in message["content"]]} for message in messages]
