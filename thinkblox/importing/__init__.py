"""Layouts of other generators as scenes: every convention is converted here and nowhere else."""

from typing import TYPE_CHECKING, Any

from thinkblox.importing.detect import FORMATS, detect

if TYPE_CHECKING:
    from thinkblox.importing.layout import ForeignLayout, read_layout

__all__ = ["FORMATS", "ForeignLayout", "detect", "read_layout"]


def __getattr__(name: str) -> Any:
    """`ForeignLayout` and `read_layout` load the mesh libraries, so they are imported when first asked for."""
    if name in ("ForeignLayout", "read_layout"):
        from thinkblox.importing import layout

        return getattr(layout, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
