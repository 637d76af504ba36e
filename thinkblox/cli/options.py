"""What commands share: where they are added, and how the texts of their options are read."""

import argparse
import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    Commands = argparse._SubParsersAction[argparse.ArgumentParser]

MARKS = ("grid", "ids", "fronts", "target", "pictures")
"""What a model may be left without, as `Sight` calls it."""


def whole(text: str, least: int, most: int) -> int:
    """A whole number from `least` to `most`; raises ArgumentTypeError."""
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number") from None
    if not least <= number <= most:
        raise argparse.ArgumentTypeError(f"{number} is not between {least} and {most}")
    return number


def natural(text: str) -> int:
    """A seed."""
    return whole(text, 0, 2**63 - 1)


def seconds(text: str) -> float:
    """A duration of at most a day [s]; raises ArgumentTypeError."""
    try:
        number = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds") from None
    if not 0.0 < number <= 86400.0:
        raise argparse.ArgumentTypeError(f"{text} is not between 0 and 86400 seconds")
    return number


def length(text: str) -> float:
    """A length above 0 [m]; raises ArgumentTypeError."""
    try:
        number = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of metres") from None
    if not 0.0 < number < math.inf:
        raise argparse.ArgumentTypeError(f"{text} m is no length; give one above 0")
    return number


def lengths(text: str) -> tuple[float, ...]:
    """Lengths above 0 between commas [m]; raises ArgumentTypeError."""
    try:
        return tuple(length(part) for part in text.split(","))
    except argparse.ArgumentTypeError:
        raise argparse.ArgumentTypeError(f"{text!r} is not lengths in metres between commas, such as 4,5,2.6") from None
