"""Lengths and areas in words: "4 m by 5 m", "12 ft x 15 ft", "18 square metres"."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from thinkblox.errors import InputError
from thinkblox.knowledge.rooms import MAX_SIDE, MIN_SIDE
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

METRES = {
    "m": 1.0,
    "cm": 0.01,
    "mm": 0.001,
    "km": 1000.0,
    "ft": 0.3048,
    "inch": 0.0254,
    "yard": 0.9144,
    "mile": 1609.344,
}
SQUARE_METRES = {"m2": 1.0, "ft2": 0.09290304}
_MARKS = {"'": "ft", "’": "ft", "′": "ft", '"': "inch", "”": "inch", "″": "inch", "′′": "inch"}
_AXES = ("width", "depth", "length", "height", "diameter")
_NOT_FINITE = {"nan": math.nan, "inf": math.inf, "infinity": math.inf, "infinite": math.inf}


@dataclass(frozen=True, slots=True)
class Length:
    """A length [m], or an area [m2] with the axis "area"; the axis is empty where the prompt names none."""

    metres: float
    axis: str
    unit: str


@dataclass(frozen=True, slots=True)
class Size:
    """One, two or three lengths that were said together, and the words."""

    lengths: tuple[Length, ...]
    text: str

    @property
    def area(self) -> float | None:
        """The area [m2], if that is what it is."""
        return self.lengths[0].metres if self.lengths[0].axis == "area" else None

    def along(self, axis: str) -> float | None:
        """The length said to be the width, depth or height [m]."""
        return next((length.metres for length in self.lengths if length.axis == axis), None)


def read_size(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[Size, int] | None:
    """The size that begins at `start` and the index after it; None when there is none."""
    first = _length(lexicon, tokens, start)
    if first is None:
        return None
    lengths, end = [first[0]], first[1]
    while len(lengths) < 3 and (after := _joiner(lexicon, tokens, end, lengths[-1])) is not None:
        following = _length(lexicon, tokens, after)
        if following is None or (lengths[-1].axis and not following[0].axis and not _is_by(lexicon, tokens, end)):
            break
        lengths.append(following[0])
        end = following[1]
    if len(lengths) == 1 and not lengths[0].unit:
        return None
    text = " ".join(token.shown for token in tokens[start:end])
    return Size(tuple(_in_metres(lengths)), text), end


def check_side(metres: float, text: str) -> float:
    """The side of a room [m]; raises InputError outside MIN_SIDE to MAX_SIDE."""
    if not MIN_SIDE <= metres <= MAX_SIDE:
        raise InputError(
            f"the room's size {text!r} cannot be used: a side of {metres:g} m is not within "
            f"{MIN_SIDE:g} to {MAX_SIDE:g} m; write it like '4 m by 5 m'"
        )
    return round(metres, 4)


def check_area(area: float, text: str) -> float:
    """The area of a room [m2]; raises InputError outside MIN_SIDE² to MAX_SIDE²."""
    if not MIN_SIDE**2 <= area <= MAX_SIDE**2:
        raise InputError(
            f"the room's size {text!r} cannot be used: {area:g} m2 is not within "
            f"{MIN_SIDE**2:g} to {MAX_SIDE**2:g} m2; write it like '18 square metres'"
        )
    return round(area, 4)


def _in_metres(lengths: list[Length]) -> Iterator[Length]:
    units = [length.unit for length in lengths if length.unit]
    fallback = units[-1] if units else "m"
    for length in lengths:
        unit = length.unit or fallback
        factor = SQUARE_METRES.get(unit) or METRES[unit]
        yield Length(length.metres * factor, length.axis, unit)


def _length(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[Length, int] | None:
    number = _number(lexicon, tokens, start)
    if number is None:
        return None
    value, end = number
    unit, after = _unit(lexicon, tokens, end)
    if unit in SQUARE_METRES:
        return Length(value, "area", unit), after
    if unit == "ft":
        value, after = _with_inches(lexicon, tokens, value, after)
    axis, after = _axis(lexicon, tokens, after) if unit else ("", after)
    return Length(value, axis, unit), after


def _with_inches(lexicon: Lexicon, tokens: list[Token], feet: float, start: int) -> tuple[float, int]:
    number = _number(lexicon, tokens, start)
    if number is not None and 0 <= number[0] < 12:
        unit, end = _unit(lexicon, tokens, number[1])
        if unit == "inch":
            return feet + number[0] / 12.0, end
    return feet, start


def _number(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[float, int] | None:
    if start >= len(tokens):
        return None
    token = tokens[start]
    if token.kind == "number":
        return token.value, start + 1
    lexeme = lexicon.longest(tokens, start) if token.text in lexicon.begun("count") else None
    if lexeme is not None and (entry := lexeme.entry("count")):
        return float(entry.value), start + lexeme.length
    if token.text in _NOT_FINITE and start + 1 < len(tokens):
        unit, _ = _unit(lexicon, tokens, start + 1)
        return (_NOT_FINITE[token.text], start + 1) if unit or _is_by(lexicon, tokens, start + 1) else None
    return None


def _unit(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[str, int]:
    if start < len(tokens) and (mark := _MARKS.get(tokens[start].text)):
        return mark, start + 1
    if start < len(tokens):
        lexeme = lexicon.longest(tokens, start)
        entry = lexeme.entry("unit")
        if entry and entry.value not in (*_AXES, "by"):
            end = start + lexeme.length
            dot = (
                end < len(tokens) and tokens[end].text == "." and end + 1 < len(tokens) and tokens[end + 1].text == "x"
            )
            return entry.value, end + dot
    return "", start


def _axis(lexicon: Lexicon, tokens: list[Token], start: int) -> tuple[str, int]:
    if start < len(tokens):
        lexeme = lexicon.longest(tokens, start)
        entry = lexeme.entry("unit")
        if entry and entry.value in _AXES:
            return entry.value, start + lexeme.length
    return "", start


def _is_by(lexicon: Lexicon, tokens: list[Token], index: int) -> bool:
    return index < len(tokens) and lexicon.longest(tokens, index).entry("unit", value="by") is not None


def _joiner(lexicon: Lexicon, tokens: list[Token], index: int, before: Length) -> int | None:
    """The index after "by", or after "and" or a comma where an axis was named ("4 m wide and 5 m long")."""
    if before.axis == "area" or index >= len(tokens):
        return None
    if _is_by(lexicon, tokens, index):
        return index + 1
    if before.axis and (tokens[index].text == "," or lexicon.longest(tokens, index).entry("word", value="and")):
        skip = index + 1
        if skip < len(tokens) and lexicon.longest(tokens, skip).entry("word", value="and"):
            skip += 1
        return skip
    return None
