"""What a child process sees to itself, from inside: its socket, its parent, its limits."""

import contextlib
import ctypes
import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Sequence
from pathlib import Path

LOOK = 2.0
"""An idle child looks this often whether the process that started it is still there [s]."""
_WATCH = 0.5
"""How often a child looks that cannot be told by the kernel [s]."""
_SET_DEATH_SIGNAL = 1
"""PR_SET_PDEATHSIG of prctl(2)."""


def attached(arguments: Sequence[str]) -> tuple[socket.socket, int]:
    """The socket to the parent, and its process id, from the arguments SOCKET PARENT that `Child` gives."""
    descriptor, parent = arguments
    return socket.socket(fileno=int(descriptor)), int(parent)


def wait_for_message(channel: socket.socket, parent: int) -> bool:
    """Wait for a message; False when the parent is gone, even if some other process holds its end of the socket."""
    while os.getppid() == parent:
        channel.settimeout(LOOK)
        try:
            return bool(channel.recv(1, socket.MSG_PEEK))
        except TimeoutError:
            continue
    return False


def die_with(parent: int) -> None:
    """See to it that this process ends at once when its parent does, even if that is killed, and in the engine too."""
    if sys.platform == "linux":
        # Works even while the engine holds the interpreter.
        ctypes.CDLL(None, use_errno=True).prctl(_SET_DEATH_SIGNAL, signal.SIGKILL, 0, 0, 0)
    else:
        threading.Thread(target=_watch, args=(parent,), daemon=True).start()
    if os.getppid() != parent:
        os._exit(1)


def go_first() -> None:
    """When the machine runs out of memory, let Linux end this process and not the one that started it."""
    with contextlib.suppress(OSError):
        Path("/proc/self/oom_score_adj").write_text("800")


def be_quiet() -> None:
    """Turn off the terminal, also for libraries in C: Qhull writes a page about every flat mesh."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):
        os.dup2(nowhere, stream)


def limit_memory(memory: int | None) -> None:
    """Allow this process so much address space [bytes], None for no limit, and no core file."""
    import resource

    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if memory is not None:
        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        soft = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _watch(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(_WATCH)
    os._exit(1)
