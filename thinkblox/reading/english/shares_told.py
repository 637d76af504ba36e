"""Shares of a number: "half of the ten chairs" is "5 of the ten chairs", "25% of the lockers" a quarter of them."""

import re
from fractions import Fraction

_NUMBERS = (
    "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen twenty"
).split()
_PARTS = {"half": 2, "third": 3, "thirds": 3, "quarter": 4, "quarters": 4, "fourth": 4, "fifth": 5, "fifths": 5}
_TOPS = {"a": 1, "one": 1, "two": 2, "three": 3, "four": 4}
_NAMES = {
    Fraction(1, 2): "half",
    Fraction(1, 3): "a third",
    Fraction(2, 3): "two thirds",
    Fraction(1, 4): "a quarter",
    Fraction(3, 4): "three quarters",
    Fraction(1, 5): "a fifth",
    Fraction(2, 5): "two fifths",
}
"""Shares that have a word of their own."""
_SHARE = re.compile(
    r"\b(?:(?P<percent>\d{1,3})(?: ?%| percent| per cent)|(?:(?P<top>a|one|two|three|four) )?"
    r"(?P<part>half|thirds?|quarters?|fourth|fifths?)) of (?P<the>the|these|those|all|our|my)\b"
    rf"(?: (?P<number>\d{{1,3}}|{'|'.join(_NUMBERS)})(?= [a-z]))?",
    re.IGNORECASE,
)


def with_shares(text: str) -> str:
    """The text with the number for a share of a number, as long as the words that it stands for where that fits."""
    return _SHARE.sub(lambda match: _plainly(match).ljust(len(match[0])), text)


def _plainly(said: re.Match[str]) -> str:
    """The same share as a number of so many, or in words; as it was said where it is neither."""
    share, number = _share(said), _number(said["number"])
    if number and (number * share).denominator == 1 and 0 < share < 1:
        return f"{number * share} of {said['the']} {said['number']}"
    if number or not said["percent"]:
        return said[0]
    return f"{_NAMES[share]} of {said['the']}" if share in _NAMES else said[0]


def _share(said: re.Match[str]) -> Fraction:
    if said["percent"]:
        return Fraction(int(said["percent"]), 100)
    return Fraction(_TOPS[(said["top"] or "one").lower()], _PARTS[said["part"].lower()])


def _number(word: str | None) -> int:
    """The number that a word or digits say; 0 where none is said."""
    if not word:
        return 0
    return int(word) if word.isdigit() else _NUMBERS.index(word.lower()) + 1
