"""How a command is stopped."""

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import FrameType

STOPPED = 130
_SOON = 0.01
"""How long after an import was found under way it is looked again [s]."""
SIGNALS = (signal.SIGINT, signal.SIGTERM)
_CAME: list[int] = []


class StoppedError(KeyboardInterrupt):
    """A signal came.

    A plain KeyboardInterrupt that ends an `exec`, of which the standard library has some, makes the interpreter end by
    SIGINT, even if it was handled.
    """


@contextmanager
def stoppable(*, to_the_end: bool) -> Iterator[list[int]]:
    """Let Ctrl-C and SIGTERM end a command as KeyboardInterrupt, so that nothing half-written stays behind.

    Args:
        to_the_end: this is all that the process does: signals that come after it are too late and pass unheard.

    Yields:
        The signals that came.
    """
    _CAME.clear()
    if threading.current_thread() is not threading.main_thread():
        yield _CAME
        return
    alarm = signal.signal(signal.SIGALRM, _raise_outside_imports)
    before = [signal.signal(number, _stop) for number in SIGNALS]
    try:
        yield _CAME
    finally:
        signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, alarm)
        for number, handler in zip(SIGNALS, before, strict=True):
            signal.signal(number, signal.SIG_IGN if to_the_end else handler)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS)


def heed_stops() -> None:
    """Raise KeyboardInterrupt when a signal came: compiled code may have made another error of it that was handled."""
    if _CAME:
        raise StoppedError


def say_stopped() -> None:
    """Say on stderr that the command was stopped, and what it had written by then."""
    from thinkblox.holding import placed

    written = ", ".join(str(path) for path in placed())
    with suppress(OSError):
        print(f"thinkblox: stopped; {written or 'nothing'} was written", file=sys.stderr)


def _stop(number: int, frame: FrameType | None) -> None:
    _CAME.append(number)
    _raise_outside_imports(number, frame)


def _raise_outside_imports(_: int, frame: FrameType | None) -> None:
    # A compiled module that is stopped while it loads prints a traceback, or makes another error of it.
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            signal.setitimer(signal.ITIMER_REAL, _SOON)
            return
        frame = frame.f_back
    raise StoppedError
