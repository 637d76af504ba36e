"""Saving what the loop has made: its scene as any other, with the trace of how it came about."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.errors import InputError
from thinkblox.exporters.formats import DEFAULT
from thinkblox.exporters.saving import save_scene

if TYPE_CHECKING:
    from thinkblox.editing.edit import Made


def save_room(
    result: "Made",
    out: str | Path,
    *,
    formats: Sequence[str] = DEFAULT,
    pictures: bool = True,
    overwrite: bool = False,
) -> Path:
    """Write a room to the folder `out` with all its files, whole or not at all; returns its path.

    Args:
        result: what `generate_room` or `edit_room` returned.
        out: the folder, made together with its parents.
        formats: names of export formats, as `thinkblox.exporters.formats` lists them.
        pictures: with preview.png and top.png.
        overwrite: replace a room that we wrote there earlier.

    Raises:
        InputError: as for `thinkblox.save_scene`.
    """
    if not hasattr(result, "scene") or not hasattr(result, "episode"):
        raise InputError(
            f"a {type(result).__name__} is no result of generate_room or edit_room; save_scene saves a Scene"
        )
    return save_scene(
        result.scene,
        out,
        result.report,
        formats=formats,
        pictures=pictures,
        overwrite=overwrite,
        extra={"trace.jsonl": result.episode.to_jsonl()},
    )
