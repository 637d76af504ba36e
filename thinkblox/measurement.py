"""Records of measured numbers, which have one form however they were computed."""

from functools import cache
from typing import Any, get_args

from msgspec.structs import fields, force_setattr

from thinkblox.value import Value


class Measurement(Value, frozen=True):
    """A record of which every number that is declared a float is one, and no zero is negative.

    A sum of nothing is the int 0, and rounding -1e-9 gives -0.0: without this the same measurement would have other
    bytes once it has been read again, and a reader would meet "-0.0".
    """

    def __post_init__(self) -> None:
        for name in _floats(type(self)):
            force_setattr(self, name, _plain(getattr(self, name)))


@cache
def _floats(kind: type[Measurement]) -> tuple[str, ...]:
    """Names of the fields that hold floats: one, one or None, or a tuple of them."""
    return tuple(field.name for field in fields(kind) if float in (field.type, *get_args(field.type)))


def _plain(value: Any) -> Any:
    if value is None:
        return None
    return tuple(map(_plain, value)) if isinstance(value, tuple) else float(value) + 0.0
