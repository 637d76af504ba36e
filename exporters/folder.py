"""The output folder of a room: written whole or not at all, and never over somebody else's files."""

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path

import msgspec

from thinkblox.errors import InputError
from thinkblox.exporters.manifest import MANIFEST, PICTURES, foreign_files
from thinkblox.holding import note_placed, signals_held
from thinkblox.renaming import exchange, rename_if_free
from thinkblox.scene.scene import Scene
from thinkblox.value import read_json
from thinkblox.whole_file import check_name, check_writable
from thinkblox.workplace import leftovers, workplace

_UNFINISHED, _FINISHED, _ASIDE = "unfinished", "finished", "aside"
"""What a room is called in its workplace until it is whole, and then; and what it replaces, where the two cannot change
places in one step."""


def check_folder(out: str | Path, *, overwrite: bool = False) -> Path:
    """Make sure that a room can be saved to `out`, before any work is done for it; returns its path.

    Raises:
        InputError: `out` is a file, a folder that is neither empty nor one of ours, or one of ours without `overwrite`;
            or the folder it would be made in cannot be written.
    """
    out = Path(out)
    check_name(out)
    _sweep(out)
    if os.path.lexists(out):
        _check_ours(out, overwrite)
    check_writable(out)
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
    sweep_pictures(out)
    if _is_empty(out):
        return
    try:
        foreign = _strangers(out)
    except InputError as error:
        raise InputError(f"{out}: exists and is not a room that we wrote; choose another folder") from error
    if foreign:
        raise InputError(f"{out}: exists and holds other files ({', '.join(foreign)}); choose another folder")
    try:
        read_json(out / "scene.json", Scene)
        if (out / "report.json").exists() or not (out / MANIFEST).exists():
            read_json(out / "report.json", _AnyReport)
    except InputError as error:
        raise InputError(f"{out}: exists and is not a room that we wrote; choose another folder") from error
    if not overwrite:
        raise InputError(f"{out}: already holds a room; choose another folder, or ask for it to be overwritten")


def check_pictures(out: Path) -> None:
    """Make sure that pictures can be written to a folder, which need not exist, before they are drawn.

    Raises:
        InputError: nothing can be written there.
    """
    if os.path.lexists(out) and not out.is_dir():
        raise InputError(f"{out}: is not a folder; name one for the pictures")
    check_writable(out / PICTURES[0])
    sweep_pictures(out)


def sweep_pictures(out: Path) -> None:
    """Take away what was left behind by processes that were killed while they drew pictures into a folder."""
    for work in leftovers(out / PICTURES[0]):
        if {entry.name for entry in work.iterdir()} <= {*PICTURES}:
            shutil.rmtree(work, ignore_errors=True)


def _strangers(folder: Path) -> list[str]:
    """Some of what lies in a room's folder and is not ours; raises InputError when its manifest is not one."""
    return list(islice(foreign_files(folder), 3))


def _is_empty(folder: Path) -> bool:
    return next(folder.iterdir(), None) is None


def _has_strangers(folder: Path) -> bool:
    try:
        return not _is_empty(folder) and bool(_strangers(folder))
    except InputError:
        return True


@contextmanager
def whole_folder(out: str | Path, *, overwrite: bool) -> Iterator[Path]:
    """A folder to write a room to, which becomes `out` at the end; after any failure or interruption, `out` is as
    it was before.

    A process that is killed leaves a hidden folder behind, which the next one that writes `out` takes away.

    Raises:
        InputError: as for `check_folder`, or the disk refused.
    """
    out = check_folder(out, overwrite=overwrite)
    try:
        with made_parents(out), workplace(out) as work:
            room = work / _UNFINISHED
            room.mkdir()
            yield room
            check_folder(out, overwrite=overwrite)
            room = room.rename(work / _FINISHED)
            with signals_held():
                _put_in_place(room, out, aside=work / _ASIDE)
                note_placed(out)
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


def _put_in_place(room: Path, out: Path, aside: Path) -> None:
    """Let `room` be `out`; what was there is in the workplace then, and comes back if a stranger's file is in it."""
    if not os.path.lexists(out):
        rename_if_free(room, out)
    elif exchange(room, out):
        _check_replaced(room, out, lambda: exchange(room, out))
    else:
        out.rename(aside)
        try:
            _check_replaced(aside, out, lambda: aside.rename(out))
            rename_if_free(room, out)
        except OSError:
            aside.rename(out)
            raise


def _check_replaced(old: Path, out: Path, undo: Callable[[], object]) -> None:
    """See to it that nobody has put anything into a folder since it was looked at; raises InputError."""
    if _has_strangers(old):
        undo()
        raise InputError(f"{out}: files that are not ours were put there meanwhile; choose another folder")


def _sweep(out: Path) -> None:
    """Take away what was left behind by processes that were killed while they wrote `out`, and nothing else."""
    for work in leftovers(out):
        if not {entry.name for entry in work.iterdir()} <= {_UNFINISHED, _FINISHED, _ASIDE}:
            continue
        if (work / _ASIDE).is_dir() and not os.path.lexists(out):
            (work / _ASIDE).rename(out)
        replaced = [work / name for name in (_FINISHED, _ASIDE) if (work / name).is_dir()]
        if not any(map(_has_strangers, replaced)):
            shutil.rmtree(work, ignore_errors=True)
