"""Layouts of other generators as scenes: every convention is converted here and nowhere else."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from thinkblox.importing.formats import FORMATS

if TYPE_CHECKING:
    from thinkblox.importing.layout import ForeignLayout, read_layout
    from thinkblox.importing.signatures import detect

__all__ = ["FORMATS", "ForeignLayout", "detect", "read_layout"]
_HOME = {"ForeignLayout": "layout", "detect": "signatures", "read_layout": "layout"}


def __getattr__(name: str) -> Any:
    """What reads layouts loads the mesh libraries, so it is imported when first asked for."""
    if name in _HOME:
        return getattr(import_module(f"thinkblox.importing.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
