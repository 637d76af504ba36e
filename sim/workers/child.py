"""A child process with a socket to it: started, asked, waited for and ended, with all that it started itself."""

import contextlib
import os
import select
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Mapping
from pathlib import Path

from thinkblox.errors import ThinkBloxError
from thinkblox.sim.workers.frames import left, receive_frame, send_frame

START = 120.0
"""How long a child may take to start and load its modules [s]."""
LOOK = 0.5
"""Whoever waits for a child's answer looks this often whether the child is still there [s]."""
REAPED = 20.0
"""How long a child that has hung up, or was killed, may take to be gone [s]."""
_OUTSIDE = tuple(-int(number) for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP))


class StartError(ThinkBloxError):
    """A child process could not be started.

    Attributes:
        killed: somebody else ended it, or the system for want of memory; it may well start the next time.
    """

    def __init__(self, text: str, *, killed: bool = False) -> None:
        super().__init__(text)
        self.killed = killed


class EndedError(ThinkBloxError):
    """A child process ended without an answer.

    Attributes:
        status: its exit status, or a signal as a number less than 0; None when that is not known.
    """

    def __init__(self, status: int | None) -> None:
        super().__init__(_cause(status))
        self.status = status

    @property
    def killed(self) -> bool:
        """Whether it was ended by somebody else, or by the system for want of memory."""
        return self.status in _OUTSIDE


class Child:
    """A fresh interpreter that runs a module of ours, as `python -m MODULE SOCKET PARENT`, in a group of its own.

    It inherits no lock and no open file, and finds the modules that its parent finds. Ctrl-C in a terminal does not
    reach it, so that it ends in order, through its parent. Whatever it starts belongs to its group and ends with it.
    """

    def __init__(self, module: str, *, surroundings: Mapping[str, str] | None = None) -> None:
        """Start it, with these environment variables besides; raises StartError when the system refuses."""
        self.command = _command(module, "SOCKET")
        self._lock = threading.Lock()
        self._swept = False
        self._channel, theirs = socket.socketpair()
        with theirs:
            try:
                self._process = _started(module, theirs.fileno(), surroundings or {})
            except (OSError, ValueError, subprocess.SubprocessError) as error:
                self._channel.close()
                raise StartError(f"no process could be started with {sys.executable}: {error}") from error

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._process.pid

    @property
    def alive(self) -> bool:
        """Whether it runs, or hangs."""
        if self._process.poll() is None:
            return True
        self._sweep()
        return False

    def send(self, message: bytes, *, until: float) -> None:
        """Send it a message; raises TimeoutError at the monotonic time `until` [s], EndedError when it is gone."""
        try:
            send_frame(self._channel, message, until=until)
        except TimeoutError:
            raise
        except OSError as error:
            raise EndedError(self._reap()) from error

    def receive(self, *, until: float) -> bytes:
        """Its next message; raises TimeoutError at the monotonic time `until` [s], EndedError when it is gone."""
        try:
            self._wait(until)
            return receive_frame(self._channel, until=until)
        except TimeoutError:
            raise
        except (EOFError, OSError) as error:
            raise EndedError(self._reap()) from error

    def kill(self) -> None:
        """End it and all that it started at once; whoever waits for its answer is told. From any thread."""
        with self._lock:
            if not self._swept:
                self._kill_group()

    def end(self) -> None:
        """End it at once and leave nothing of it behind; by the thread that asks it."""
        self.kill()
        self._reap()
        self._channel.close()

    def _wait(self, until: float) -> None:
        """Wait for something to read. That it hung up may never be seen: what it started may hold its socket."""
        poll = select.poll()
        poll.register(self._channel, select.POLLIN)
        while not poll.poll(1000.0 * min(LOOK, left(until) or LOOK)):
            if time.monotonic() >= until:
                raise TimeoutError
            if not self.alive and not poll.poll(0):
                raise EOFError

    def _reap(self) -> int | None:
        """Its exit status, for which it is waited a while."""
        try:
            status = self._process.wait(timeout=REAPED)
        except subprocess.TimeoutExpired:
            self.kill()
            return None
        self._sweep()
        return status

    def _sweep(self) -> None:
        """End what it left behind: once and right after it is gone, for its number may later be another's."""
        with self._lock:
            if not self._swept:
                self._kill_group()
            self._swept = True

    def _kill_group(self) -> None:
        # Nobody is left in it, or (on macOS) only the dead.
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self._process.pid, signal.SIGKILL)


def signal_name(number: int) -> str:
    """What a signal is called, such as "SIGSEGV"; "unknown" for one that has no name."""
    return signal.Signals(number).name if number in signal.valid_signals() else "unknown"


def _started(module: str, descriptor: int, surroundings: Mapping[str, str]) -> subprocess.Popen[bytes]:
    paths = os.pathsep.join(path or str(Path.cwd()) for path in sys.path)
    return subprocess.Popen(
        _command(module, str(descriptor)),
        stdin=subprocess.DEVNULL,
        env={**os.environ, **surroundings, "PYTHONPATH": paths},
        pass_fds=(descriptor,),
        process_group=0,
    )


def _command(module: str, descriptor: str) -> list[str]:
    return [sys.executable, "-P", "-m", module, descriptor, str(os.getpid())]


def _cause(status: int | None) -> str:
    if status is None:
        return "how is not known"
    return f"exit status {status}" if status >= 0 else f"signal {-status}, {signal_name(-status)}"
