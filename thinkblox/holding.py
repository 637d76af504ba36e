"""Steps that are not to be stopped half-way: Ctrl-C and SIGTERM wait until they are done."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

STOPS = (signal.SIGINT, signal.SIGTERM, signal.SIGALRM)
"""The signals that stop a command; one that came while a module was loaded comes again as an alarm."""
_PLACED: list[Path] = []


@contextmanager
def signals_held() -> Iterator[None]:
    """Let the signals that stop a command wait until the end of the block, where they do what they ever do.

    Only the main thread can hold them; in another one nothing is held.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    signal.pthread_sigmask(signal.SIG_BLOCK, STOPS)
    before = _redirected(came.append)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for number in came:
            signal.raise_signal(number)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, STOPS)


def _redirected(tell: Callable[[int], None]) -> dict[int, Any]:
    """Have `tell` called instead of the handlers, which are handed back; those that are not Python's stay."""
    # The mask keeps a signal from this thread alone: one that another thread takes is handled here all the same.
    found: dict[int, Any] = {int(number): signal.getsignal(number) for number in STOPS}
    before = {number: h for number, h in found.items() if callable(h) or h is signal.SIG_DFL}
    for number in before:
        signal.signal(number, lambda came, _: tell(came))
    return before


def note_placed(path: Path) -> None:
    """Take down that a file or folder was put in place; to be called while signals are held."""
    _PLACED.append(path)


def placed() -> tuple[Path, ...]:
    """The files and folders that this process has put in place since `forget_placed`."""
    return tuple(_PLACED)


def forget_placed() -> None:
    """Begin a new list of what is put in place."""
    _PLACED.clear()
