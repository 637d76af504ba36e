"""A process in which spoiled files are measured one after the other, and that sees what they do."""

import contextlib
import ctypes
import multiprocessing
import multiprocessing.connection
import os
import struct
import sys
import sysconfig
import time
import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

from msgspec import structs

from thinkblox.checking import VerifyOptions, verify_file
from thinkblox.errors import InputError
from thinkblox.value import to_json

MEMORY = 8 * 2**30
"""Address space that the process may use, as that of a command [bytes]."""
_OPENED, _CHANGED = 0x20, 0x2 | 0x100 | 0x200
"""IN_OPEN, and IN_MODIFY, IN_CREATE and IN_DELETE of inotify(7)."""
_FOLDER = 0x40000000
"""IN_ISDIR: a folder, which may be listed."""
_OPENING = ("open", "os.rename", "os.remove", "os.mkdir", "os.symlink", "os.link", "os.truncate")
"""Audit events of what touches files."""
_ANYWHERE = ("/proc/", "/sys/", "/dev/null", "/dev/urandom", "/etc/mime.types", "/etc/httpd/", "/usr/local/etc/")
"""Where the standard library looks, whatever it is given."""


class Job(NamedTuple):
    """A file, and how it is read."""

    path: Path
    reading: VerifyOptions


@dataclass(frozen=True)
class Outcome:
    """What became of a file.

    Attributes:
        end: "passed", "failed", "refused", "broken" or "over the limit".
        seconds: that it took.
        memory: that was in use at most [bytes].
        report: of a file that was measured, without its notes.
        faults: what must not be.
    """

    end: str
    seconds: float
    memory: int = 0
    report: bytes = b""
    faults: tuple[str, ...] = ()


class Worker:
    """The process, begun anew whenever a file ends or outlasts it."""

    def __init__(self, home: Path, limit: float) -> None:
        self._home, self._limit = home, limit
        self._process: Any = None
        self._watch = _Watch(home / "files" / "outside")

    def run(self, job: Job) -> Outcome:
        """Measure one file."""
        if self._process is None:
            self._begin()
        begin = time.monotonic()
        self._channel.send(job)
        try:
            if not self._channel.poll(self._limit):
                self.end()
                return Outcome("over the limit", time.monotonic() - begin, faults=self._watch.seen())
            outcome: Outcome = self._channel.recv()
        except EOFError:
            self.end()
            return Outcome("broken", time.monotonic() - begin, faults=self._watch.seen())
        return replace(outcome, faults=(*outcome.faults, *self._watch.seen()))

    def end(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._process = None

    def _begin(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._channel, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, self._home), daemon=True)
        self._process.start()
        theirs.close()


class _Watch:
    """Whoever opens or changes anything in a folder is seen, also from outside of Python."""

    def __init__(self, folder: Path) -> None:
        libc = ctypes.CDLL(None, use_errno=True)
        self._descriptor = libc.inotify_init1(os.O_NONBLOCK)
        if libc.inotify_add_watch(self._descriptor, os.fsencode(folder), _OPENED | _CHANGED) < 0:
            raise OSError(ctypes.get_errno(), f"{folder} cannot be watched")

    def seen(self) -> tuple[str, ...]:
        """What was touched since it was last asked."""
        found = []
        with contextlib.suppress(BlockingIOError):
            data = os.read(self._descriptor, 65536)
            while data:
                _, mask, _, length = struct.unpack_from("iIII", data)
                name, data = data[16 : 16 + length].rstrip(b"\0").decode(), data[16 + length :]
                if not mask & _FOLDER:
                    found.append(f"{'read' if mask & _OPENED else 'written'} outside: {name}")
        return tuple(dict.fromkeys(found))


def _serve(channel: multiprocessing.connection.Connection, home: Path) -> None:
    from thinkblox.sim.workers import guard
    from thinkblox.sim.workers.inside import be_quiet, limit_memory

    be_quiet()
    limit_memory(MEMORY)
    # This process is the fence.
    guard.guarded = _called
    touched: list[str] = []
    sys.addaudithook(_watcher(home, touched))
    os.chdir(home / "cwd")
    while True:
        with contextlib.suppress(EOFError):
            job = channel.recv()
            channel.send(_outcome(job, home, touched))
            continue
        return


def _called(function: Callable[..., Any], *args: object, **_: object) -> Any:
    return function(*args)


def _outcome(job: Job, home: Path, touched: list[str]) -> Outcome:
    there = dict(_files(home))
    touched.clear()
    Path("/proc/self/clear_refs").write_text("5")
    begin = time.monotonic()
    report, faults = b"", []
    try:
        measured = verify_file(job.path, job.reading)
        end = "passed" if measured.valid and all(suite.passed for suite in measured.suites) else "failed"
        report = to_json(structs.replace(measured, notes=(), prompt=""))
    except InputError as error:
        end = "refused"
        if not str(error).strip().isprintable():
            faults.append(f"says {str(error)[:200]!r}")
    except MemoryError:
        end = "refused"  # as the fence does
    except Exception:
        end = "broken"
        faults.append(traceback.format_exc()[-1500:])
    seconds = time.monotonic() - begin
    faults += dict.fromkeys(touched)
    written = {job.reading.out, job.reading.page}
    faults += [f"written: {name}" for name, state in _files(home) if there.get(name) != state and name not in written]
    return Outcome(end, seconds, _most_memory(), report, tuple(faults))


def _files(home: Path) -> Iterator[tuple[str, tuple[int, int]]]:
    for folder, _, names in os.walk(home):
        for name in names:
            path = Path(folder) / name
            state = path.stat()
            yield str(path), (state.st_size, state.st_mtime_ns)


def _most_memory() -> int:
    line = next(line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM"))
    return int(line.split()[1]) * 1024


def _watcher(home: Path, touched: list[str]) -> Callable[[str, tuple[Any, ...]], None]:
    inside = (str(home), str(Path(__file__).parents[2]), sys.prefix, sys.base_prefix, *sysconfig.get_paths().values())

    def hook(event: str, args: tuple[Any, ...]) -> None:
        if event not in _OPENING or not isinstance(args[0], str | bytes | os.PathLike):
            return
        path = os.path.abspath(os.fsdecode(args[0]))  # noqa: PTH100 (links are to be seen as they are)
        if not path.startswith((*inside, *_ANYWHERE)):
            touched.append(f"{event} {path}")

    return hook
