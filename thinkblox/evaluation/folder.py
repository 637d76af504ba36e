"""Where an evaluation is written: evaluation.json and evaluation.md, beside the rooms that were made for it."""

import os
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.evaluation.document import as_json, as_markdown
from thinkblox.evaluation.results import Evaluation
from thinkblox.whole_file import check_name, check_writable, write_whole

JSON, MARKDOWN = "evaluation.json", "evaluation.md"


def check_evaluation(out: Path, *, overwrite: bool) -> None:
    """Make sure that an evaluation can be written, before any work is done for it; nothing is made yet.

    Raises:
        InputError: nothing can be written there, or an evaluation is there and `overwrite` is not given.
    """
    check_name(out)
    if os.path.lexists(out) and not out.is_dir():
        raise InputError(f"{out}: exists and is not a folder; choose another name")
    if not overwrite and os.path.lexists(out / JSON):
        raise InputError(f"{out}: holds an evaluation; choose another folder, or ask for it to be overwritten")
    check_writable(out / JSON)


def make_folder(out: Path) -> None:
    """Make the folder of an evaluation; raises InputError."""
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{out}: cannot be made: {error.strerror}") from error


def write_evaluation(evaluation: Evaluation, out: Path) -> None:
    """Write both files, and make their folder; raises InputError."""
    make_folder(out)
    write_whole(out / JSON, as_json(evaluation))
    write_whole(out / MARKDOWN, as_markdown(evaluation).encode("utf-8", "replace"))
