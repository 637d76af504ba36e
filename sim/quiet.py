"""Keeping the engine's warnings out of the terminal and out of a log file in the current folder."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import mujoco

Handler = Callable[[str], None]


class _Silence:
    """The one handler of warnings that the engine has in a process, taken by the first of several threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._held = 0
        self._before: Handler | None = None

    def hold(self) -> None:
        """Silence the engine until everybody who holds it silent has let go."""
        with self._lock:
            if not self._held:
                self._before = mujoco.get_mju_user_warning()
                mujoco.set_mju_user_warning(_ignore)
            self._held += 1

    def release(self) -> None:
        """Let go; the last one gives the engine back the handler that it had."""
        with self._lock:
            self._held -= 1
            if not self._held:
                mujoco.set_mju_user_warning(self._before)
                self._before = None


_silence = _Silence()


@contextmanager
def quiet_engine() -> Iterator[None]:
    """Within it the engine's warnings are only counted in `MjData.warning`, where `diverged` finds them.

    It may be nested and used in several threads at once: the engine, which has one handler for all of them, is silent
    while any of them is within.
    """
    _silence.hold()
    try:
        yield
    finally:
        _silence.release()


def _ignore(_text: str) -> None:
    """The warning stays counted; nothing is written."""
