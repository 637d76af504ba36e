"""Keeping the engine's warnings out of the terminal and out of a log file in the current folder."""

from collections.abc import Iterator
from contextlib import contextmanager

import mujoco


@contextmanager
def quiet_engine() -> Iterator[None]:
    """Within it the engine's warnings are only counted in `MjData.warning`, where `diverged` finds them."""
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(_ignore)
    try:
        yield
    finally:
        mujoco.set_mju_user_warning(before)


def _ignore(_text: str) -> None:
    """The warning stays counted; nothing is written."""
