"""A hidden folder beside what is to be written, in which it is made before it is put in place.

Its owner holds a lock on it, which ends with the process however that ends. What a process left behind that was killed
is therefore known as such, and whoever writes to the same name next sweeps it up.
"""

import fcntl
import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from hashlib import sha256
from pathlib import Path

from thinkblox.holding import signals_held

_TRIES = 16


@contextmanager
def workplace(out: Path) -> Iterator[Path]:
    """A new, locked folder beside `out`, which is gone with all that is in it at the end; raises OSError."""
    with ExitStack() as stack:
        with signals_held():
            folder, lock = _claimed(out)
            stack.callback(_given_up, folder, lock)
        yield folder


def leftovers(out: Path) -> Iterator[Path]:
    """The workplaces of processes that are gone and were to write `out`; each is locked while it is looked at."""
    with suppress(OSError):
        found = sorted(path for path in out.parent.iterdir() if path.name.startswith(_prefix(out)))
        for path in found:
            with suppress(OSError), _locked(path):
                yield path


def _prefix(out: Path) -> str:
    # A name may be as long as names can be, so that nothing can be added to it.
    return f".thinkblox-{sha256(os.fsencode(out.name)).hexdigest()[:12]}-"


def _claimed(out: Path) -> tuple[Path, int]:
    """A new folder and its lock. One that was taken for a leftover before it was locked is gone, and made again."""
    for _ in range(_TRIES):
        folder = out.parent / f"{_prefix(out)}{secrets.token_hex(6)}"
        folder.mkdir(mode=0o700)
        with suppress(FileNotFoundError, BlockingIOError):
            lock = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
            if _is_locked(folder, lock):
                return folder, lock
            os.close(lock)
    raise OSError(f"{out.parent}: no folder that is made there stays")


def _is_locked(folder: Path, lock: int) -> bool:
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks, where nothing is ever swept up
        return True
    return folder.exists() and os.path.samestat(os.fstat(lock), folder.stat())


def _given_up(folder: Path, lock: int) -> None:
    try:
        with signals_held():
            shutil.rmtree(folder, ignore_errors=True)
            os.close(lock)
    except KeyboardInterrupt:  # it may have come before anything was held
        with signals_held():
            shutil.rmtree(folder, ignore_errors=True)
        raise


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """Raises OSError when somebody is at work in it, or it cannot be known."""
    lock = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    finally:
        os.close(lock)
