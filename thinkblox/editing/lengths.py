"""Lengths and angles of instructions, in figures or in words: "half a metre", "a quarter turn"."""

from collections.abc import Sequence
from typing import NamedTuple

from thinkblox.editing.grammar import longest
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.sizes import METRES, read_size
from thinkblox.reading.tokens import Token

DEGREES = ("degrees", "degree", "deg", "°")
_AXES = {("longer", 1): "length", ("wider", 1): "width", ("deeper", 1): "depth", ("higher", 1): "height"}
_HALF = ("and", "a", "half")
_SHARES = {("half",): 0.5, ("a", "half"): 0.5, ("a", "quarter"): 0.25, ("one", "quarter"): 0.25,
           ("three", "quarters"): 0.75, ("a", "third"): 1 / 3, ("quarter",): 0.25}  # fmt: skip


class SaidLengths(NamedTuple):
    """One or more lengths [m] with their axes ("" where none is said), and the tokens that they take."""

    lengths: tuple[tuple[float, str], ...]
    tokens: int


def is_number(token: Token) -> bool:
    """Whether a token is a number, in figures or as a word."""
    return token.kind == "number" or grammar().at([token], 0, "count") is not None


def lengths_at(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> SaidLengths | None:
    """The lengths that begin at a token; None when none does."""
    said = _shared(lexicon, tokens, at) or _halved(lexicon, tokens, at)
    if said is None:
        return _in_figures(lexicon, tokens, at)
    axis = _AXES.get(longest("absolutes", tokens, at + said.tokens) or ("", 0))
    return said if axis is None else SaidLengths(((said.lengths[0][0], axis),), said.tokens + 1)


def _in_figures(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> SaidLengths | None:
    few = grammar().at(tokens, at, "vague")
    if few is not None and tokens[at].text == "a" and (unit := _unit(lexicon, tokens, at + few.length)):
        return SaidLengths(((float(few.value) * METRES[unit], ""),), few.length + 1)
    if not is_number(tokens[at]) and grammar().at(tokens, at, "count") is None:
        return None
    size = read_size(lexicon, list(tokens), at)
    if size is None:
        return None
    lengths = tuple((part.metres, part.axis) for part in size[0].lengths)
    return SaidLengths(lengths, size[1] - at)


def _shared(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> SaidLengths | None:
    """Read "half a metre", "a quarter of a metre", "a metre", "a metre and a half"."""
    for words, share in _SHARES.items():
        end = at + len(words)
        if _words(tokens, at, len(words)) != words:
            continue
        skip = next(
            (n for n in ((2, 1, 0)) if _words(tokens, end, n) in (("of", "a"), ("of", "an"), ("a",), ("an",), ())), 0
        )
        if unit := _unit(lexicon, tokens, end + skip):
            return SaidLengths(((share * METRES[unit], ""),), len(words) + skip + 1)
    unit = _unit(lexicon, tokens, at + 1) if tokens[at].text in ("a", "an", "one") else ""
    if not unit:
        return None
    if _words(tokens, at + 2, 3) == _HALF:
        return SaidLengths(((1.5 * METRES[unit], ""),), 5)
    return SaidLengths(((METRES[unit], ""),), 2) if tokens[at].text != "one" else None


def _halved(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> SaidLengths | None:
    """Read "two and a half metres", "2 metres and a half"."""
    number = tokens[at].value if tokens[at].kind == "number" else _count(tokens, at)
    if number is None:
        return None
    if _words(tokens, at + 1, 3) == _HALF and (unit := _unit(lexicon, tokens, at + 4)):
        return SaidLengths((((number + 0.5) * METRES[unit], ""),), 5)
    unit = _unit(lexicon, tokens, at + 1)
    if unit and _words(tokens, at + 2, 3) == _HALF:
        return SaidLengths((((number + 0.5) * METRES[unit], ""),), 5)
    return None


def _count(tokens: Sequence[Token], at: int) -> float | None:
    found = grammar().at(tokens[at : at + 1], 0, "count")
    return float(found.value) if found is not None else None


def _words(tokens: Sequence[Token], at: int, length: int) -> tuple[str, ...]:
    return tuple(token.text for token in tokens[at : at + length])


def _unit(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> str:
    if at >= len(tokens):
        return ""
    entry = lexicon.longest(list(tokens), at).entry("unit")
    return entry.value if entry is not None and entry.value in METRES else ""


def angle_at(tokens: Sequence[Token], at: int, *, words: bool) -> tuple[float, int] | None:
    """The angle that begins there [degrees], and its length [tokens]: "90 degrees"; with `words` "a quarter turn"."""
    found = longest("turns", tokens, at) if words else None
    if found is not None:
        return float(found[0]), found[1]
    if tokens[at].kind == "number":
        value, length = tokens[at].value, 1
    else:
        count = grammar().at(tokens, at, "count")
        if count is None:
            return None
        value, length = float(count.value), count.length
        tens = grammar().at(tokens, at + length, "count") if at + length < len(tokens) else None
        if tens is not None and value >= 20 and float(tens.value) < 10:
            value, length = value + float(tens.value), length + tens.length
    after = tokens[at + length].text if at + length < len(tokens) else ""
    return (value, length + 1) if after in DEGREES else None
