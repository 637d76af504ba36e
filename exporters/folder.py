"""The output folder of a room: written whole or not at all, and never over somebody else's files."""

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path

import msgspec

from thinkblox.errors import InputError
from thinkblox.exporters.manifest import foreign_files
from thinkblox.scene.scene import Scene
from thinkblox.value import read_json


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
    try:
        foreign = list(islice(foreign_files(out), 3))
    except InputError as error:
        raise InputError(f"{out}: exists and is not a room that we wrote; choose another folder") from error
    if foreign:
        raise InputError(f"{out}: exists and holds other files ({', '.join(foreign)}); choose another folder")
    try:
        read_json(out / "scene.json", Scene)
        read_json(out / "report.json", _AnyReport)
    except InputError as error:
        raise InputError(f"{out}: exists and is not a room that we wrote; choose another folder") from error
    if not overwrite:
        raise InputError(f"{out}: already holds a room; choose another folder, or ask for it to be overwritten")


@contextmanager
def whole_folder(out: str | Path, *, overwrite: bool) -> Iterator[Path]:
    """A folder to write a room to, which becomes `out` at the end; after any failure or interruption, `out` is as
    it was before.

    Raises:
        InputError: as for `check_folder`, or the disk refused.
    """
    out = check_folder(out, overwrite=overwrite)
    try:
        with made_parents(out), tempfile.TemporaryDirectory(prefix=f".{out.name}-", dir=out.parent) as work:
            room = Path(work) / "room"
            room.mkdir()
            yield room
            check_folder(out, overwrite=overwrite)
            _move_into_place(room, out, aside=Path(f"{work}-replaced"))
    except OSError as error:
        raise InputError(f"{error.filename or out}: cannot be written: {error.strerror}") from error


@contextmanager
def made_parents(out: Path) -> Iterator[None]:
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
