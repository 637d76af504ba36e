"""A worker process of a verdict pool, seen from the process that started it."""

import contextlib
import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

from thinkblox.errors import ThinkBloxError
from thinkblox.sim.workers.wire import WorkerSettings, encode, receive_frame, send_frame

START = 120.0
"""How long a worker may take to load the engine [s]."""
_SURROUNDINGS = {
    **dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"),
    "MUJOCO_GL": "disable",
}
"""One thread for each worker; and nothing is drawn, so no display need be looked for."""


class LostError(ThinkBloxError):
    """A worker process died or gave no answer in time; it has been ended."""


class StartError(ThinkBloxError):
    """A worker process could not be started."""


class WorkerProcess:
    """A fresh interpreter that runs thinkblox.sim.workers.worker and nothing of the caller's own program.

    Attributes:
        known: keys of the scenes and assets that it has.
    """

    def __init__(self, settings: WorkerSettings) -> None:
        """Start it; raises StartError when the system refuses."""
        self.known: set[bytes] = set()
        self._ready = False
        self._timeout = settings.timeout
        self._channel, theirs = socket.socketpair()
        with theirs:
            try:
                self._process = _started(theirs.fileno())
            except (OSError, ValueError, subprocess.SubprocessError) as error:
                self._channel.close()
                raise StartError(f"no worker process could be started with {sys.executable}: {error}") from error
        # It fits in the socket's buffer, and a process that is gone already is found out by `wait_until_ready`.
        with contextlib.suppress(OSError):
            send_frame(self._channel, encode(settings))

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._process.pid

    @property
    def alive(self) -> bool:
        """Whether it runs, or hangs."""
        return self._process.poll() is None

    def wait_until_ready(self) -> None:
        """Wait until it has loaded the engine; raises StartError when it does not come to that."""
        if self._ready:
            return
        try:
            receive_frame(self._channel, until=time.monotonic() + START)
        except (EOFError, OSError) as error:
            raise StartError(
                f"a worker process {self._lost(error, START)} while loading the engine; it runs"
                f" `{' '.join(_command('SOCKET'))}`, and what it wrote to stderr says more"
            ) from error
        self._ready = True

    def ask(self, message: bytes) -> bytes:
        """Its answer to a message; raises LostError when it dies over it or takes longer than its time limit."""
        until = time.monotonic() + self._timeout
        try:
            send_frame(self._channel, message, until=until)
            return receive_frame(self._channel, until=until)
        except (EOFError, OSError) as error:
            raise LostError(f"the worker process {self._lost(error, self._timeout)}") from error

    def kill(self) -> None:
        """End it at once; whoever waits for its answer finds it lost."""
        self._process.kill()

    def end(self) -> None:
        """End it at once and leave nothing of it behind. To be called by the thread that asks it."""
        self.kill()
        self._reap()
        self._channel.close()

    def _lost(self, error: Exception, limit: float) -> str:
        """What became of it, in words; ends it."""
        if not isinstance(error, TimeoutError):
            return f"died ({_cause(self._reap())})"
        self.kill()
        self._reap()
        return f"gave no answer for {limit:g} s and was ended"

    def _reap(self) -> int | None:
        try:
            return self._process.wait(timeout=5.0)
        except subprocess.TimeoutExpired:
            self.kill()
            return None


def _started(descriptor: int) -> subprocess.Popen[bytes]:
    """Start the process in a process group of its own, so that Ctrl-C in a terminal ends it in order, through us."""
    paths = os.pathsep.join(path or str(Path.cwd()) for path in sys.path)
    return subprocess.Popen(
        _command(str(descriptor)),
        stdin=subprocess.DEVNULL,
        env={**os.environ, **_SURROUNDINGS, "PYTHONPATH": paths},
        pass_fds=(descriptor,),
        process_group=0,
    )


def _command(descriptor: str) -> list[str]:
    return [sys.executable, "-P", "-m", "thinkblox.sim.workers.worker", descriptor, str(os.getpid())]


def _cause(status: int | None) -> str:
    if status is None:
        return "how is not known"
    if status >= 0:
        return f"exit status {status}"
    try:
        return f"signal {-status}, {signal.Signals(-status).name}"
    except ValueError:
        return f"signal {-status}"
