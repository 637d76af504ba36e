"""Prompt text to a Brief, by rules and tables; no language model."""

from thinkblox.brief import Brief
from thinkblox.fills import Fill
from thinkblox.reading.reader import read_brief


class GrammarBriefer:
    """The Briefer that needs no model: it reads with a grammar and a lexicon."""

    def __init__(self, fill: Fill = "essentials") -> None:
        self._fill = fill

    def brief(self, prompt: str) -> Brief:
        """What the prompt asks for."""
        return read_brief(prompt, fill=self._fill)


__all__ = ["GrammarBriefer", "read_brief"]
