"""Prompt text to a Brief, by rules and tables; no language model."""

from thinkblox.reading.reader import read_brief

__all__ = ["read_brief"]
