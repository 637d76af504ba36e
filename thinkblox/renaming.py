"""Renaming in one step that nothing comes between: two paths change places, or a name is taken only if it is free."""

import ctypes
import errno
import os
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

_HERE = -100
"""AT_FDCWD of openat(2): paths are relative to the working folder."""
_IMPOSSIBLE = (errno.ENOSYS, errno.EINVAL, errno.ENOTSUP, errno.EOPNOTSUPP)
"""What a system or a file system says that cannot do it."""
_EXCHANGE = {"linux": 2, "darwin": 2}
"""RENAME_EXCHANGE of renameat2(2), RENAME_SWAP of renamex_np(2)."""
_IF_FREE = {"linux": 1, "darwin": 4}
"""RENAME_NOREPLACE and RENAME_EXCL of the same."""


def exchange(one: Path, other: Path) -> bool:
    """Let two paths change places in one step; False, and nothing is done, where the system cannot.

    Raises:
        OSError: the system can, and refuses.
    """
    return _renamed(one, other, _EXCHANGE)


def rename_if_free(path: Path, new: Path) -> None:
    """Rename a folder to a name that nothing has.

    Where the system cannot do both in one step, an empty folder that comes to have the name meanwhile is replaced.

    Raises:
        OSError: the name is taken, or the system refuses.
    """
    if _renamed(path, new, _IF_FREE):
        return
    if os.path.lexists(new):
        raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(new))
    path.rename(new)


def _renamed(path: Path, new: Path, flags: dict[str, int]) -> bool:
    rename = _system_call()
    if rename is None:
        return False
    if rename(os.fsencode(path), os.fsencode(new), flags[sys.platform]) == 0:
        return True
    number = ctypes.get_errno()
    if number in _IMPOSSIBLE:
        return False
    raise OSError(number, os.strerror(number), str(new))


@cache
def _system_call() -> Callable[[bytes, bytes, int], int] | None:
    """Rename with flags, of (path, new path, flags); None where the C library has none."""
    library = ctypes.CDLL(None, use_errno=True)
    if sys.platform == "linux" and hasattr(library, "renameat2"):
        return lambda path, new, flags: int(library.renameat2(_HERE, path, _HERE, new, ctypes.c_uint(flags)))
    if sys.platform == "darwin" and hasattr(library, "renamex_np"):
        return lambda path, new, flags: int(library.renamex_np(path, new, ctypes.c_uint(flags)))
    return None
