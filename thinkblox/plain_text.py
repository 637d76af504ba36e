"""Text of unknown origin, such as names in files that were read, made safe to be shown."""

from unicodedata import category

TURNING = frozenset("\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Characters that make text run the other way, and so let one name look like another."""


def is_harmful(character: str) -> bool:
    """Whether a character steers a terminal or a page, ends a line, or is none: an escape, a break, half a pair."""
    return category(character) in ("Cc", "Cs", "Zl", "Zp") or character in TURNING


def escaped(text: str, *, keep: str = "") -> str:
    """The text with what is harmful in it as Python writes it, an escape character as a backslash and "x1b".

    Args:
        text: of any origin.
        keep: harmful characters that are meant, such as line ends.
    """
    if text.isprintable():
        return text
    return "".join(_escape(c) if is_harmful(c) and c not in keep else c for c in text)


def _escape(character: str) -> str:
    return character.encode("unicode_escape").decode("ascii")
