"""Values of USD attributes as numbers, or a refusal that names the attribute."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Gf

from thinkblox.errors import InputError

_QUATERNIONS = (Gf.Quath, Gf.Quatf, Gf.Quatd)


def number_of(attribute: Any, otherwise: float) -> float:
    """The number that an attribute has; `otherwise` where it has none.

    Raises:
        InputError: it is no number.
    """
    value = _value(attribute)
    if value is None:
        return otherwise
    if isinstance(value, bool) or not isinstance(value, int | float) or np.isnan(value):
        raise InputError(f"{attribute.GetPath()}: {str(value)[:40]!r} is not a number")
    return float(value)


def numbers_of(attribute: Any, otherwise: Iterable[float]) -> NDArray[np.float64]:
    """The numbers of a vector, or of an array of them; `otherwise` where it has none.

    Raises:
        InputError: they are no numbers.
    """
    value = _value(attribute)
    if value is None:
        return np.array(tuple(otherwise), np.float64)
    refusal = InputError(f"{attribute.GetPath()}: {str(value)[:40]!r} is not made of numbers")
    try:
        numbers = np.array(value, np.float64)
    except (TypeError, ValueError) as error:
        raise refusal from error
    if np.isnan(numbers).any():
        raise refusal
    return numbers


def points_of(attribute: Any) -> NDArray[np.float64]:
    """The points that an attribute has (n, 3).

    Raises:
        InputError: they are no points.
    """
    numbers = numbers_of(attribute, ())
    if numbers.size % 3:
        raise InputError(f"{attribute.GetPath()}: has {numbers.size} numbers, which are no points in space")
    return numbers.reshape(-1, 3)


def turn_of(attribute: Any) -> NDArray[np.float64]:
    """The rotation that a quaternion says (3, 3); none where there is no quaternion.

    Raises:
        InputError: it is something else.
    """
    value = _value(attribute)
    if value is None:
        return np.eye(3)
    if not isinstance(value, _QUATERNIONS):
        raise InputError(f"{attribute.GetPath()}: {str(value)[:40]!r} is not a quaternion")
    numbers = np.array([value.GetReal(), *value.GetImaginary()], np.float64)
    if not np.isfinite(numbers).all():
        raise InputError(f"{attribute.GetPath()}: {str(value)[:40]!r} is not made of finite numbers")
    return np.array(Gf.Matrix3d(Gf.Quatd(value).GetNormalized())).T


def word_of(attribute: Any, words: Iterable[str], otherwise: str) -> str:
    """Which one of some words an attribute says; `otherwise` where it says nothing.

    Raises:
        InputError: it says something else.
    """
    value, known = _value(attribute), tuple(words)
    if value is None or value == "":
        return otherwise
    if value not in known:
        raise InputError(f"{attribute.GetPath()}: {str(value)[:40]!r} is none of {', '.join(known)}")
    return str(value)


def _value(attribute: Any) -> Any:
    return attribute.Get() if attribute else None
