"""Scenes as files: MJCF, USD, formats that users register, and the output folder."""

from thinkblox.exporters.formats import ExportFormat, formats, register

__all__ = ["ExportFormat", "formats", "register"]
