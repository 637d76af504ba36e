"""The extra that a room as an environment needs, imported when it is first used."""

import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from typing import Any

from thinkblox.errors import InputError

EXTRA = "pip install 'thinkblox[env]'"
BACKENDS = ("egl", "osmesa", "disable")
"""What dm_control draws by where there is no display, the first that is there."""
_SAYS = "MUJOCO_GL"


def needed(module: str) -> Any:
    """Import a module of dm-control, dm-env or Gymnasium.

    Raises:
        InputError: it is not installed; says what to install.
    """
    try:
        if module.startswith("dm_control"):
            _choose_backend()
        return import_module(module)
    except ImportError as error:
        raise InputError(f"a room as an environment needs dm-control and Gymnasium ({error}): {EXTRA}") from None


@cache
def _choose_backend() -> None:
    """Let dm_control draw without a display, where nobody says by what: it takes GLFW then, which cannot."""
    shown = {"DISPLAY", "WAYLAND_DISPLAY", _SAYS} & set(os.environ)
    if shown or not sys.platform.startswith("linux"):
        return
    for backend in BACKENDS:
        with _saying(backend), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                import_module("dm_control._render")
            except (ImportError, AttributeError, RuntimeError):
                continue
            return


@contextmanager
def _saying(backend: str) -> Iterator[None]:
    os.environ[_SAYS] = backend
    try:
        yield
    finally:
        del os.environ[_SAYS]
