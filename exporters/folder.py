"""The output folder of a room: written whole or not at all, and never over somebody else's files."""

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from thinkblox.errors import InputError
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.value import read_json, to_json

if TYPE_CHECKING:
    from thinkblox.generate import Generation
    from thinkblox.sim.verdict.settle import SettledState

PICTURES = ("preview.png", "top.png")
FILES = ("scene.json", "scene.xml", "scene.usda", "report.json", "trace.jsonl", *PICTURES)
"""What an output folder holds; a folder with anything else in it is not ours to replace."""


def check_folder(out: str | Path, *, overwrite: bool = False) -> Path:
    """Make sure that a room can be saved to `out`, before any work is done for it; returns its path.

    Raises:
        InputError: `out` is a file, a folder that is not one of ours, or one of ours without `overwrite`; or the
            folder it would be made in cannot be written.
    """
    out = Path(out)
    if os.path.lexists(out):
        _check_ours(out, overwrite)
    parent = out.absolute().parent
    while not os.path.lexists(parent):
        parent = parent.parent
    if not parent.is_dir():
        raise InputError(f"{out}: cannot be made, for {parent} is not a folder")
    try:
        tempfile.TemporaryDirectory(prefix=f".{out.name}"[:20], dir=parent).cleanup()
    except OSError as error:
        raise InputError(f"{out}: cannot be made, for the folder {parent} is not writable: {error.strerror}") from error
    return out


class _AnyReport(msgspec.Struct):
    """What a report of any release has."""

    valid: bool
    versions: dict[str, str]


def _check_ours(out: Path, overwrite: bool) -> None:
    if out.is_symlink():
        raise InputError(f"{out}: is a symbolic link; name the folder itself")
    if not out.is_dir():
        raise InputError(f"{out}: exists and is not a folder; choose another name")
    foreign = sorted(entry.name for entry in out.iterdir() if entry.name not in FILES or entry.is_dir())
    if foreign:
        raise InputError(f"{out}: exists and holds other files ({', '.join(foreign[:3])}); choose another folder")
    try:
        load_scene(out)
        read_json(out / "report.json", _AnyReport)
    except InputError as error:
        raise InputError(f"{out}: exists and is not a room that we wrote; choose another folder") from error
    if not overwrite:
        raise InputError(f"{out}: already holds a room; choose another folder, or --overwrite it")


def save_room(result: "Generation", out: str | Path, *, pictures: bool = True, overwrite: bool = False) -> Path:
    """Write a room to the folder `out` in every format; returns its path.

    The files are written beside it first and then moved into place, so that `out` is complete or, after any failure
    or interruption, as it was before.

    Args:
        result: what `generate_room` returned.
        out: the folder, made together with its parents.
        pictures: with preview.png and top.png.
        overwrite: replace a room that we wrote there earlier.

    Raises:
        InputError: as for `check_folder`, or the disk refused.
    """
    out = check_folder(out, overwrite=overwrite)
    try:
        with _made_parents(out), tempfile.TemporaryDirectory(prefix=f".{out.name}-", dir=out.parent) as work:
            room = Path(work) / "room"
            room.mkdir()
            _write_files(result, room, pictures)
            check_folder(out, overwrite=overwrite)
            _move_into_place(room, out, aside=Path(f"{work}-replaced"))
    except OSError as error:
        raise InputError(f"{error.filename or out}: cannot be written: {error.strerror}") from error
    return out


def save_pictures(scene: Scene, out: str | Path, *, size: int = 1024) -> tuple[Path, ...]:
    """Write preview.png and top.png of a scene, `size` pixels square, into the folder `out`; returns their paths.

    Raises:
        InputError: the folder cannot be written.
    """
    from thinkblox.sim.verdict.settle import settle

    out = Path(out)
    try:
        with _made_parents(out / PICTURES[0]), tempfile.TemporaryDirectory(prefix=".pictures-", dir=out) as work:
            _write_pictures(scene, settle(scene), Path(work), size)
            for name in PICTURES:
                (Path(work) / name).replace(out / name)
    except OSError as error:
        raise InputError(f"{error.filename or out}: cannot be written: {error.strerror}") from error
    return tuple(out / name for name in PICTURES)


def _write_files(result: "Generation", room: Path, pictures: bool) -> None:
    from thinkblox.exporters.mjcf import write_mjcf
    from thinkblox.exporters.usd import write_usd
    from thinkblox.sim.verdict.settle import settle

    settled = settle(result.scene)
    (room / "scene.json").write_bytes(to_json(result.scene))
    (room / "report.json").write_bytes(to_json(result.report))
    (room / "trace.jsonl").write_bytes(result.episode.to_jsonl())
    write_mjcf(result.scene, room / "scene.xml", settled=settled)
    write_usd(result.scene, room / "scene.usda", settled=settled)
    if pictures:
        _write_pictures(result.scene, settled, room)


def _write_pictures(scene: Scene, settled: "SettledState", folder: Path, size: int = 1024) -> None:
    from thinkblox.sim.render import render_preview, render_top

    for name, render in zip(PICTURES, (render_preview, render_top), strict=True):
        render(scene, size=size, poses=settled.poses).save(folder / name)


@contextmanager
def _made_parents(out: Path) -> Iterator[None]:
    """Make the folders above `out`; after a failure, take away those that were made and are empty."""
    missing = [parent for parent in out.absolute().parents if not parent.exists()]
    try:
        out.absolute().parent.mkdir(parents=True, exist_ok=True)
        yield
    except BaseException:
        for parent in missing:
            if parent.is_dir() and not any(parent.iterdir()):
                parent.rmdir()
        raise


def _move_into_place(room: Path, out: Path, aside: Path) -> None:
    """Put `room` where `out` is; what was there is kept aside until the new one stands, and put back if it cannot."""
    try:
        if out.exists():
            out.rename(aside)
        room.rename(out)
    except BaseException:
        if aside.exists() and not out.exists():
            aside.rename(out)
        raise
    if aside.exists():
        shutil.rmtree(aside)
