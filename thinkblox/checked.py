"""Values that check their fields whenever they are built: in Python, by `structs.replace`, and when they are read.

msgspec holds a field to its type and its `Meta` only when it decodes. A `CheckedValue` is held to the same when it is
made in Python, by the same compiled code: it is converted to a twin that has its fields and nothing else.
"""

import re
from functools import cache
from numbers import Integral, Real
from typing import Annotated, Any, get_type_hints

import msgspec
from msgspec import Meta

from thinkblox.errors import InputError
from thinkblox.json_faults import spelled
from thinkblox.value import Value

LARGEST = 1e12
"""Beyond this no number of ours means anything; it keeps out NaN and the infinities."""
Number = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
NotNegative = Annotated[float, Meta(ge=0.0, le=LARGEST)]
AboveZero = Annotated[float, Meta(gt=0.0, le=LARGEST)]
Share = Annotated[float, Meta(ge=0.0, le=1.0)]
Coordinate = Annotated[float, Meta(ge=-1000.0, le=1000.0)]
"""Of a point in a room or an asset [m]."""
Extent = Annotated[float, Meta(gt=0.0, le=100.0)]
"""Of a thing along one axis [m]."""
ObjectId = Annotated[str, Meta(pattern=r"^[a-z][a-z0-9_]*_[0-9]+\Z", max_length=80)]
"""Of an object that a policy can name: "<category>_<n>"."""
UNIT_TOLERANCE = 1e-6
"""How far the length of a unit vector or quaternion may be from 1."""

_COMPLAINT = re.compile(r"(?P<expected>.*) - at `\$(?P<path>.*)`", re.DOTALL)
_STEP = re.compile(r"\.(\w+)|\[(\d+)\]|(\[\.\.\.\])")
_SHOWN = 80


class CheckedValue(Value, frozen=True):
    """A value none of whose fields is ever out of range, and whose fields are what they are once it has been read.

    An int in place of a float becomes one, a list in place of a tuple too, and numbers of numpy become plain ones.

    Raises:
        InputError: a field of another type, out of the range of its `Meta`, or not a finite number; it names the value,
            the field and what was expected of it.
    """

    def __post_init__(self) -> None:
        try:
            twin = msgspec.convert(self, _twin(type(self)), from_attributes=True)
        except msgspec.ValidationError:
            twin = _made_plain(self)
        for name in self.__struct_fields__:
            msgspec.structs.force_setattr(self, name, getattr(twin, name))

    def refused(self, field: str, why: str) -> InputError:
        """The error that says why this value cannot be, by its kind, its name and the field that is wrong."""
        kind = type(self).__name__
        named = next((f for f in ("id", "name", "key") if f in self.__struct_fields__), "")
        name = getattr(self, named, None)
        if isinstance(name, str) and name and not field.startswith(named):
            return InputError(f"{kind.lower()} {_shown(name)}: {field} {why}")
        return InputError(f"{kind}.{field} {why}")


@cache
def _twin(kind: type[CheckedValue]) -> type[msgspec.Struct]:
    """A struct of the same fields that checks nothing by itself."""
    hints = get_type_hints(kind, include_extras=True)
    return msgspec.defstruct(f"{kind.__name__}Fields", [(name, hints[name]) for name in kind.__struct_fields__])


def _made_plain(value: CheckedValue) -> msgspec.Struct:
    """Give a value that was refused plain numbers for those of numpy; what is refused then is an InputError."""
    for name in value.__struct_fields__:
        msgspec.structs.force_setattr(value, name, _plain(getattr(value, name)))
    try:
        return msgspec.convert(value, _twin(type(value)), from_attributes=True)
    except msgspec.ValidationError as error:
        raise value.refused(*_field(value, str(error))) from None


def _plain(found: Any) -> Any:
    if isinstance(found, tuple):
        return tuple(map(_plain, found))
    if type(found) in (bool, int, float):
        return found
    if isinstance(found, Integral):
        return int(found)
    return float(found) if isinstance(found, Real) else found


def _field(value: CheckedValue, complaint: str) -> tuple[str, str]:
    """The field that msgspec complains of, and the complaint with what the field holds."""
    match = _COMPLAINT.fullmatch(complaint)
    if match is None:
        return "it", complaint
    found: Any = value
    for name, index, some in _STEP.findall(match["path"]):
        if some:
            break
        found = getattr(found, name) if name else found[int(index)]
    expected = spelled(match["expected"]).replace("`", "")
    return match["path"].removeprefix("."), f"is {_shown(found)}; {expected[0].lower()}{expected[1:]}"


def _shown(found: Any) -> str:
    text = found if isinstance(found, str) and found.isprintable() and found else repr(found)
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."


def is_unit(vector: tuple[float, ...]) -> bool:
    """Whether a vector or quaternion has the length 1, to UNIT_TOLERANCE."""
    squared = sum(part * part for part in vector)
    return abs(squared - 1.0) <= 2.0 * UNIT_TOLERANCE
