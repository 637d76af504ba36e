"""Grids, which are so many rows of so many: "a 3x3 grid of cubes" is three rows of three cubes."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

_GRIDS = ("grid", "array", "matrix")
_BY = ("x", "by")
_NUMBERS = ("", *"one two three four five six seven eight nine ten eleven twelve".split())
_LENGTH = 4
"""Words of "3 x 3 grid"."""
_EACH = "individual"
"""What asks for nothing before a noun."""
_THERE = "there"
"""What asks for nothing after one."""


def with_grids(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "3 rows of 3" for "a 3x3 grid of"; what was written stays as it is."""
    made = list(tokens)
    for at in range(len(made) - _LENGTH + 1):
        if not _is_grid(made[at : at + _LENGTH]):
            continue
        start = at - 1 if at and made[at - 1].text == "a" else at
        of = at + _LENGTH < len(made) and made[at + _LENGTH].text == "of"
        end = at + _LENGTH + of
        rows, columns = (_word(_in_words(made[n])) for n in (at, at + 2))
        said = [rows, _word("rows"), _word("of"), columns]
        said += [_word(_EACH if of else _THERE)] * (end - start - len(said))
        made[start:end] = [
            structs.replace(new, shown=old.shown, start=old.start, glued=False)
            for new, old in zip(said, made[start:end], strict=True)
        ]
    return made


def _word(text: str) -> Token:
    return Token(text, text, "word")


def _in_words(number: Token) -> str:
    """A number as a word, since its digits are not what was written in its place."""
    return _NUMBERS[int(number.value)] if number.kind == "number" else number.text


def _is_grid(said: Sequence[Token]) -> bool:
    numbers = all(
        0 < token.value < len(_NUMBERS) and token.value.is_integer()
        if token.kind == "number"
        else grammar().at([token], 0, "count") is not None
        for token in (said[0], said[2])
    )
    return numbers and said[1].text in _BY and said[3].text in _GRIDS
