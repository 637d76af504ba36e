"""Writing a file whole or not at all, and over nothing that is not ours."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.holding import note_placed, signals_held
from thinkblox.workplace import leftovers, workplace

_DRAFT = "draft"


def write_whole(path: Path, data: bytes) -> None:
    """Write a file; one that is there is replaced at once, or stays as it was after any failure.

    Raises:
        InputError: it cannot be written.
    """
    try:
        sweep(path)
        with workplace(path) as work:
            draft = work / _DRAFT
            draft.write_bytes(data)
            draft.chmod(0o644)
            with signals_held():
                draft.replace(path)
                note_placed(path)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from error


def check_file(path: Path, *, ours: Callable[[Path], bool], overwrite: bool = False) -> None:
    """Make sure that a file can be written, before any work is done for it.

    Args:
        path: of the file.
        ours: whether a file that is there is one that we wrote, which may be replaced.
        overwrite: replace any file.

    Raises:
        InputError: it is there and is a folder, a link or a device; or is not ours and `overwrite` is not given; or the
            folder that it is to lie in does not exist or cannot be written.
    """
    check_name(path)
    if os.path.lexists(path):
        _check_replaceable(path, ours, overwrite)
    if nearest_folder(path) != path.absolute().parent:
        raise InputError(f"{path}: cannot be written: there is no folder {path.absolute().parent}")
    check_writable(path)


def check_name(path: Path) -> None:
    """Raise InputError for a path that nothing can have, such as one with too long a name in it."""
    if "\0" in str(path):
        raise InputError(f"{str(path)!r}: cannot be made: there is a NUL in the name")
    whole = path.absolute()
    longest = os.pathconf(nearest_folder(whole), "PC_NAME_MAX")
    for name in whole.parts:
        if len(os.fsencode(name)) > longest:
            raise InputError(f"{path}: cannot be made: {name[:20]}... is too long for a name; {longest} bytes are most")


def nearest_folder(path: Path) -> Path:
    """The nearest thing above a path that exists; the root is above itself."""
    whole = path.absolute()
    return next((parent for parent in whole.parents if os.path.lexists(parent)), Path(whole.anchor))


def check_writable(path: Path) -> None:
    """Raise InputError when nothing can be made where `path` is to be, or in the nearest folder above that exists."""
    home = nearest_folder(path)
    if not home.is_dir():
        raise InputError(f"{path}: cannot be made, for {home} is not a folder")
    try:
        sweep(home / path.name)
        with workplace(home / path.name):
            pass
    except OSError as error:
        raise InputError(f"{path}: cannot be made, for the folder {home} is not writable: {error.strerror}") from error


def sweep(path: Path) -> None:
    """Remove what was left behind by a process that was killed while it wrote the file `path`."""
    for folder in leftovers(path):
        if {entry.name for entry in folder.iterdir()} <= {_DRAFT}:
            shutil.rmtree(folder, ignore_errors=True)


def _check_replaceable(path: Path, ours: Callable[[Path], bool], overwrite: bool) -> None:
    if path.is_symlink():
        raise InputError(f"{path}: is a symbolic link; name the file itself")
    if not path.is_file():
        raise InputError(f"{path}: exists and is not a file; choose another name")
    if not overwrite and not ours(path):
        raise InputError(
            f"{path}: exists and is not one that we wrote; choose another name, or ask for it to be overwritten"
        )
