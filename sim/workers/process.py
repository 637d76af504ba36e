"""A worker process of a verdict pool, seen from the process that started it."""

import contextlib
import time

from thinkblox.errors import ThinkBloxError
from thinkblox.sim.workers.child import START, Child, EndedError, StartError
from thinkblox.sim.workers.wire import WorkerSettings, encode

WORKER = "thinkblox.sim.workers.worker"
"""The module that a worker runs."""
_SURROUNDINGS = {
    **dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"),
    "MUJOCO_GL": "disable",
}
"""One thread for each worker; and nothing is drawn, so no display need be looked for."""


class LostError(ThinkBloxError):
    """A worker process died or gave no answer in time; it has been ended."""


class WorkerProcess:
    """A child that measures candidates, and what it is known to have.

    Attributes:
        known: keys of the scenes and assets that it has; none once it has ended.
    """

    def __init__(self, settings: WorkerSettings) -> None:
        """Start it; raises StartError when the system refuses."""
        self.known: set[bytes] = set()
        self._ready = False
        self._timeout = settings.timeout
        self._child = Child(WORKER, surroundings=_SURROUNDINGS)
        # It fits in the socket's buffer, and a process that is gone already is found out by `wait_until_ready`.
        with contextlib.suppress(EndedError):
            self._child.send(encode(settings), until=time.monotonic() + START)

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._child.pid

    @property
    def alive(self) -> bool:
        """Whether it runs, or hangs."""
        return self._child.alive

    def wait_until_ready(self) -> None:
        """Wait until it has loaded the engine; raises StartError when it does not come to that."""
        if self._ready:
            return
        try:
            self._child.receive(until=time.monotonic() + START)
        except (EndedError, TimeoutError) as error:
            self.end()
            raise StartError(
                f"a worker process {_lost(error, START)} while loading the engine; it runs"
                f" `{' '.join(self._child.command)}`, and what it wrote to stderr says more",
                killed=isinstance(error, EndedError) and error.killed,
            ) from error
        self._ready = True

    def ask(self, message: bytes) -> bytes:
        """Its answer to a message; raises LostError when it dies over it or takes longer than its time limit."""
        until = time.monotonic() + self._timeout
        try:
            self._child.send(message, until=until)
            return self._child.receive(until=until)
        except (EndedError, TimeoutError) as error:
            self.end()
            raise LostError(f"the worker process {_lost(error, self._timeout)}") from error

    def kill(self) -> None:
        """End it at once, from any thread; whoever waits for its answer finds it lost."""
        self._child.kill()

    def end(self) -> None:
        """End it at once and leave nothing of it behind. To be called by the thread that asks it."""
        self._child.end()
        self.known.clear()


def _lost(error: EndedError | TimeoutError, limit: float) -> str:
    return f"died ({error})" if isinstance(error, EndedError) else f"gave no answer for {limit:g} s and was ended"
