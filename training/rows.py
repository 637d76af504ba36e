"""The rows of a dataset, checked before hours are spent on them."""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any

from thinkblox.errors import InputError
from thinkblox.training.recipe import RECIPE, Recipe, Split
from thinkblox.value import read_json

NEEDED = ("prompt", "completion", "images", "at")
_TEXTS = 4000
"""Rows from which the tokens of a new model are learnt."""


def recipe_of(data: str | Path) -> Recipe:
    """How a dataset was made; raises InputError where the folder holds none of ours."""
    file = Path(data) / RECIPE
    if not file.is_file():
        raise InputError(f"{data}: no dataset of ours: it has no {RECIPE}; thinkblox data build makes one")
    return read_json(file, Recipe)


def rows_of(data: str | Path, split: Split) -> Any:
    """A split of a dataset, as `datasets` reads it.

    Raises:
        InputError: it is not there, lacks a column, or cannot be read.
    """
    import datasets

    recipe_of(data)
    files = sorted(str(file) for file in (Path(data) / "data").glob(f"{split}-*.parquet"))
    if not files:
        raise InputError(f"{data}: has no rows of the split {split!r}; build more scenes, or hold out another share")
    try:
        rows = datasets.load_dataset("parquet", data_files=files, split="train")
    except (datasets.exceptions.DatasetGenerationError, OSError, ValueError) as error:
        raise InputError(f"{data}: its rows cannot be read: {error}") from error
    missing = [name for name in NEEDED if name not in rows.column_names]
    if missing:
        raise InputError(f"{data}: its rows have no {', '.join(missing)}; they have {', '.join(rows.column_names)}")
    return rows


def texts_of(data: str | Path) -> Iterator[str]:
    """What is said in the first rows for training: from this the tokens of a new model are learnt."""
    rows = rows_of(data, "train").select_columns(["prompt", "completion"])
    for row in islice(rows, _TEXTS):
        for message in (*row["prompt"], *row["completion"]):
            yield from (block["text"] for block in message["content"] if block["text"])
