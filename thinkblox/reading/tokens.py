"""Text to tokens: words folded to plain lower-case letters, numbers, and punctuation."""

import re
import unicodedata

from msgspec import Struct
from msgspec.structs import replace

_TOKEN = re.compile(
    r"(?P<unit>(?<![^\W\d_])(?:sq)?(?:m|ft)\s?(?:²|\^2|2(?!\w)))"
    r"|(?P<name>(?<![\w.,])\d-?[dDkK](?!\w))"
    r"|(?P<number>(?:(?<![\w.)])[-−])?\d{1,40}(?:[.,]\d{1,6})?(?:[eE][-+]?\d{1,2}(?!\w))?)"
    r"|(?P<word>[^\W\d_]+(?:['’`´][^\W\d_]+)*)"
    r"|(?P<mark>[^\w\s])"
)
_PLAIN = re.compile(r"[a-z ]*")
_HYPHENS = "-‐‑"
_JOINED = ("s", "t", "re", "ll", "ve", "m", "d")
_LETTERS = str.maketrans({"ß": "ss", "æ": "ae", "œ": "oe", "ø": "o", "×": "x", "ł": "l"})


class Token(Struct, frozen=True, gc=False):
    """A word, number or mark.

    Attributes:
        text: folded (lower case, no accents); what the lexicon is asked for.
        shown: as it was written.
        kind: "word", "number" or "mark".
        value: of a number, else 0.
        start: where it begins in the text [characters].
        glued: a hyphen joins it to the next one ("two-burner").
        owner: it has a genitive ending ("the bed's").
    """

    text: str
    shown: str
    kind: str
    value: float = 0.0
    start: int = 0
    glued: bool = False
    owner: bool = False


def fold(text: str) -> str:
    """Lower case without accents: "Küche" and "kuche" are the same word to us."""
    if text.isascii():
        return text.lower()
    plain = unicodedata.normalize("NFKD", text.casefold().translate(_LETTERS))
    return "".join(c for c in plain if not unicodedata.combining(c))


def tokenise(text: str) -> list[Token]:
    """The tokens of a text, in order. Hyphens part words; an apostrophe joins an English ending and parts others."""
    tokens: list[Token] = []
    text = unicodedata.normalize("NFC", text)
    for match in _TOKEN.finditer(text):
        kind, start = match.lastgroup, match.start()
        if kind == "number":
            tokens.append(_number(match[0], start))
        elif kind == "name":
            tokens.append(Token(fold(match[0]).replace("-", ""), match[0], "word", start=start))
        elif kind == "unit":
            tokens.append(Token("m2" if "m" in match[0].lower() else "ft2", match[0], "word", start=start))
        elif kind == "word":
            tokens += _words(match[0], start)
        elif _is_genitive(text, start, tokens):
            tokens[-1] = replace(tokens[-1], owner=True)
        elif match[0] not in _HYPHENS:
            tokens.append(Token(fold(match[0]), match[0], "mark", start=start))
        elif not _is_inner(text, start):
            tokens.append(Token("–", match[0], "mark", start=start))
        elif tokens and tokens[-1].start + len(tokens[-1].shown) == start:
            tokens[-1] = replace(tokens[-1], glued=True)
    return tokens


def texts(phrase: str) -> tuple[str, ...]:
    """The texts of the tokens of a phrase; quick where it is plain words, as thousands in the tables are."""
    return tuple(phrase.split() if _PLAIN.fullmatch(phrase) else (token.text for token in tokenise(phrase)))


def _is_genitive(text: str, index: int, tokens: list[Token]) -> bool:
    """Whether an apostrophe after a plural says whose: "two guests' chairs"; one that ends a quotation does not."""
    if text[index] not in "'’" or not tokens or tokens[-1].start + len(tokens[-1].shown) != index:
        return False
    quoted = any(token.kind == "mark" and token.text in ("'", "‘") for token in tokens)
    return tokens[-1].text.endswith("s") and text[index + 1 : index + 2].isspace() and not quoted


def _is_inner(text: str, index: int) -> bool:
    """Whether a hyphen stands within a word rather than for a dash."""
    return not (text[index - 1 : index].isspace() and text[index + 1 : index + 2].isspace())


def _number(shown: str, start: int) -> Token:
    text = shown.replace("−", "-")
    head, _, tail = text.partition(",")
    value = float(head + tail) if len(tail) == 3 else float(text.replace(",", "."))
    return Token(text, shown, "number", value, start)


def _words(shown: str, start: int) -> list[Token]:
    if shown.isalpha():
        return [Token(fold(shown), shown, "word", start=start)]
    parts = re.split("['’`´]", shown)
    if fold(parts[-1]) in _JOINED:
        return [Token(fold("".join(parts)), shown, "word", start=start, owner=fold(parts[-1]) == "s")]
    starts = [start + sum(len(part) + 1 for part in parts[:index]) for index in range(len(parts))]
    return [Token(fold(part), part, "word", start=at) for part, at in zip(parts, starts, strict=True)]
