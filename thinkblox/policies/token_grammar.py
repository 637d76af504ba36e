"""Answers that cannot but be readable: a grammar that a model's texts must follow. For use, never for training."""

import json
from typing import Any

from thinkblox.errors import InputError

_ID = "^[a-z][a-z0-9_]{0,59}_[0-9]{1,4}$"


def step_grammar(*, lines: int = 8, characters: int = 200) -> str:
    """A step that adds an object, as a Lark grammar: millimetres, tenths of a degree, and no longer than it says.

    Args:
        lines: most lines of reasoning.
        characters: most characters of each.
    """
    metres = {"type": "number", "minimum": -100, "maximum": 100, "multipleOf": 0.001}
    extent = {"type": "number", "minimum": 0.001, "maximum": 50, "multipleOf": 0.001}
    fields: dict[str, Any] = {
        "id": {"type": "string", "pattern": _ID},
        "position": _three(metres),
        "yaw": {"type": "number", "minimum": 0, "maximum": 360, "multipleOf": 0.1},
        "size": _three(extent),
    }
    schema = {
        "type": "object",
        "properties": fields,
        "required": list(fields),
        "additionalProperties": False,
        "x-guidance": {"whitespace_flexible": False},
    }
    line = rf"/[1-9][0-9]?\. [^\x00-\x1f<]{{1,{characters}}}/"
    return (
        rf'start: "<think>\n" line{{1,{lines}}} "</think>\n<answer>" answer "</answer>"'
        f"\nline: {line} "
        r'"\n"'
        f"\nanswer: %json {json.dumps(schema)}\n"
    )


def _three(number: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": number, "minItems": 3, "maxItems": 3}


class TokenGrammar:
    """A grammar, ready for the tokens of one tokenizer."""

    def __init__(self, grammar: str, tokenizer: Any, vocabulary: int) -> None:
        """Prepare a Lark grammar; raises InputError for one that cannot be read, or where llguidance is missing."""
        try:
            from llguidance import LLMatcher
            from llguidance.hf import from_tokenizer
        except ImportError as error:
            raise InputError(f"a grammar needs llguidance ({error}): pip install 'thinkblox[vlm]'") from error
        self._compiled = LLMatcher.grammar_from_lark(grammar)
        self._tokenizer = from_tokenizer(tokenizer, n_vocab=vocabulary)
        wrong = LLMatcher.validate_grammar(self._compiled, self._tokenizer)
        if wrong and not wrong.startswith("WARNING"):
            raise InputError(f"the grammar cannot be used: {wrong}")
        self._start = LLMatcher(self._tokenizer, self._compiled)

    def matcher(self) -> Any:
        """One text's way through the grammar, from its beginning."""
        return self._start.deep_copy()
