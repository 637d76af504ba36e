"""Text to tokens: words folded to plain lower-case letters, numbers, and punctuation."""

import re
import unicodedata
from dataclasses import dataclass

_TOKEN = re.compile(
    r"(?P<unit>(?<![^\W\d_])(?:sq)?(?:m|ft)\s?(?:²|\^2|2(?!\w)))"
    r"|(?P<number>(?:(?<![\w.)])[-−])?\d{1,40}(?:[.,]\d{1,6})?(?:[eE][-+]?\d{1,2}(?!\w))?)"
    r"|(?P<word>[^\W\d_]+(?:['’`´][^\W\d_]+)*)"
    r"|(?P<mark>[^\w\s])"
)
_JOINED = ("s", "t", "re", "ll", "ve", "m", "d")
_LETTERS = str.maketrans({"ß": "ss", "æ": "ae", "œ": "oe", "ø": "o", "×": "x", "ł": "l"})


@dataclass(frozen=True, slots=True)
class Token:
    """A word, number or mark.

    Attributes:
        text: folded (lower case, no accents); what the lexicon is asked for.
        shown: as it was written.
        kind: "word", "number" or "mark".
        value: of a number, else 0.
    """

    text: str
    shown: str
    kind: str
    value: float = 0.0


def fold(text: str) -> str:
    """Lower case without accents: "Küche" and "kuche" are the same word to us."""
    if text.isascii():
        return text.lower()
    plain = unicodedata.normalize("NFKD", text.casefold().translate(_LETTERS))
    return "".join(c for c in plain if not unicodedata.combining(c))


def tokenise(text: str) -> list[Token]:
    """The tokens of a text, in order. Hyphens part words; an apostrophe joins an English ending and parts others."""
    tokens: list[Token] = []
    for match in _TOKEN.finditer(unicodedata.normalize("NFC", text)):
        kind = match.lastgroup
        if kind == "number":
            tokens.append(_number(match[0]))
        elif kind == "unit":
            tokens.append(Token("m2" if "m" in match[0].lower() else "ft2", match[0], "word"))
        elif kind == "word":
            tokens += _words(match[0])
        elif match[0] not in "-‐‑":
            tokens.append(Token(fold(match[0]), match[0], "mark"))
    return tokens


def _number(shown: str) -> Token:
    text = shown.replace("−", "-")
    head, _, tail = text.partition(",")
    value = float(head + tail) if len(tail) == 3 else float(text.replace(",", "."))
    return Token(text, shown, "number", value)


def _words(shown: str) -> list[Token]:
    parts = re.split("['’`´]", shown)
    if len(parts) == 1:
        return [Token(fold(shown), shown, "word")]
    if fold(parts[-1]) in _JOINED:
        return [Token(fold("".join(parts)), shown, "word")]
    return [Token(fold(part), part, "word") for part in parts]
