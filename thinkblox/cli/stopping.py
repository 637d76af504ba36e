"""How a command is stopped."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def stoppable(stops: list[int]) -> Iterator[None]:
    """Let Ctrl-C and SIGTERM end a command as KeyboardInterrupt, so that nothing half-written stays behind.

    The signals that came are appended to `stops`.
    """

    def stop(number: int, frame: object) -> None:
        stops.append(number)
        raise KeyboardInterrupt

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    signals = (signal.SIGINT, signal.SIGTERM)
    before = [signal.signal(number, stop) for number in signals]
    try:
        yield
    finally:
        for number, handler in zip(signals, before, strict=True):
            signal.signal(number, handler)
