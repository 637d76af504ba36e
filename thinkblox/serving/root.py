"""The one folder in which an agent's files are read and written."""

import os
from collections.abc import Iterator
from pathlib import Path

from thinkblox.errors import InputError

LONGEST = 1000
"""Longest path that an agent can give [characters]."""
MOST_LISTED = 500
"""Most entries of a folder that are listed."""


class Root:
    """A folder that nothing leads out of: paths are relative to it, without "..", and without links on their way.

    Attributes:
        folder: where it is, links followed.
    """

    def __init__(self, folder: str | Path) -> None:
        """Take a folder.

        Raises:
            InputError: there is no such folder.
        """
        given = Path(folder)
        try:
            self.folder = given.resolve(strict=True)
        except (OSError, RuntimeError, ValueError) as error:
            raise InputError(f"{str(given)!r}: there is no such folder; make it first, or name another") from error
        if not self.folder.is_dir():
            raise InputError(f"{given}: is not a folder; name one in which rooms may be read and written")

    def reading(self, path: str) -> Path:
        """A file or folder that is there.

        Raises:
            InputError: a path that leads out of the root, or to nothing.
        """
        whole = self._inside(path)
        if not os.path.lexists(whole):
            raise InputError(f"{path}: there is no such file or folder under the root; list_files shows what there is")
        return whole

    def writing(self, path: str) -> Path:
        """Where something may be written, which need not be there.

        Raises:
            InputError: a path that leads out of the root, or the root itself.
        """
        whole = self._inside(path)
        if whole == self.folder:
            raise InputError(f"{path!r}: is the root itself; name a folder in it, such as 'bedroom'")
        return whole

    def shown(self, path: Path) -> str:
        """A path below the root as an agent writes it."""
        return path.relative_to(self.folder).as_posix()

    def entries(self, path: str) -> Iterator[str]:
        """The names in a folder, in order, folders with a slash; links and what is hidden are left out.

        Raises:
            InputError: it is no folder under the root, or cannot be read.
        """
        folder = self.reading(path)
        if not folder.is_dir():
            raise InputError(f"{path}: is not a folder")
        try:
            found = sorted(entry for entry in folder.iterdir() if not entry.is_symlink())
        except OSError as error:
            raise InputError(f"{path}: cannot be read: {error.strerror}") from error
        yield from (f"{e.name}/" if e.is_dir() else e.name for e in found if not e.name.startswith("."))

    def _inside(self, path: str) -> Path:
        if len(path) > LONGEST or "\0" in path:
            raise InputError(f"{path[:50]!r}: is no path; give at most {LONGEST} characters, none of them NUL")
        given = Path(path)
        if given.is_absolute() or ".." in given.parts or path.startswith("~"):
            raise InputError(f"{path}: leads out of the root; give a path relative to it, without '..'")
        whole = self.folder
        for part in given.parts:
            whole = whole / part
            if self._is_link(whole, path):
                raise InputError(f"{path}: {part} is a link, which is not followed; name the file itself")
        return whole

    def _is_link(self, whole: Path, path: str) -> bool:
        try:
            return whole.is_symlink()
        except OSError as error:  # such as too long a name
            raise InputError(f"{path[:50]!r}: is no path: {error.strerror}") from error
