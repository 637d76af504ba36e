"""Files that a model names: found where the engine would look for them, never outside a folder, and read once."""

import os
import re
import stat
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from thinkblox.errors import InputError

LONGEST = 1000
"""Of a path that a model names [characters]."""
_LISTED = 5
_ABSOLUTE = re.compile(r"^(/|[A-Za-z][A-Za-z0-9+.-]*:)")


WIDEN = "only files inside it are read. Name a folder that holds them all with --root."


def is_absolute(text: str) -> bool:
    """Whether a path, of any system, starts at a root, a drive or a scheme such as "http:"."""
    return bool(_ABSOLUTE.match(text.replace("\\", "/")))


def is_file(path: Path) -> bool:
    """Whether there is an ordinary file that may be looked at; a name that no file can have names none."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def is_inside(path: Path, folder: Path) -> bool:
    """Whether a path is in a folder once all symbolic links on both are followed."""
    try:
        return path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError):
        return False


def locate(text: str, where: object, *, bases: Iterable[Path], folder: Path) -> Path:
    """The file that a relative path names.

    Neither the path itself nor a symbolic link on it may lead out of the folder.

    Args:
        text: the path as written.
        where: the element that names it, for messages.
        bases: folders to look in, in order.
        folder: what it must not leave.

    Raises:
        InputError: the path is absolute or leaves `folder`, or no such file exists; names the element.
    """
    if len(text) > LONGEST:
        raise InputError(f"{where} names a file by {len(text)} characters; at most {LONGEST} are read.")
    if is_absolute(text):
        raise InputError(f'{where} names the absolute path "{text}": only paths inside {folder} are read.')
    bases = tuple(dict.fromkeys(bases))
    candidates = [Path(os.path.normpath(base / text.replace("\\", "/"))) for base in bases]
    inside = [candidate for candidate in candidates if candidate.is_relative_to(folder)]
    if not inside or any(is_file(path) for path in candidates if path not in inside):
        raise InputError(f'{where} names "{text}", which leaves the folder {folder}: {WIDEN}')
    for candidate in inside:
        if is_file(candidate):
            if not is_inside(candidate, folder):
                raise InputError(f'{where} names "{text}", a link that leaves the folder {folder}: {WIDEN}')
            return candidate
    raise InputError(f'{where} names "{text}", which is not in {_folders(inside)}.{_instead(inside)}')


def read_limited(path: Path, where: object, largest: int) -> bytes:
    """The bytes of a file, read once.

    Args:
        path: of the file.
        where: what names it, for messages.
        largest: more is refused [bytes].

    Raises:
        InputError: it is missing, no ordinary file (a device, a pipe, a folder), unreadable or too large.
    """
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            raise InputError(f'{where}: cannot be read: "{path.name}" is no ordinary file.')
        with path.open("rb") as file:
            size = max(os.fstat(file.fileno()).st_size, 0)
            data = file.read(largest + 1) if size <= largest else b""
    except (OSError, ValueError) as error:
        raise InputError(f"{where}: cannot be read: {getattr(error, 'strerror', None) or error}") from error
    size = max(size, len(data))
    if size > largest:
        raise InputError(f'{where}: "{path.name}" has {size / 2**20:.0f} MiB; at most {largest // 2**20} MiB are read.')
    return data


def _folders(candidates: list[Path]) -> str:
    return " or ".join(dict.fromkeys(str(candidate.parent) for candidate in candidates))


def _instead(candidates: list[Path]) -> str:
    """What is there of the same kind."""
    found: list[str] = []
    for candidate in candidates:
        with suppress(OSError):
            found += sorted(p.name for p in candidate.parent.iterdir() if p.suffix.lower() == candidate.suffix.lower())
    if not found:
        return ""
    more = f" and {len(found) - _LISTED} more" if len(found) > _LISTED else ""
    return f" There are {', '.join(found[:_LISTED])}{more}."
