"""Rows of annotations from their fields, whatever file they come from; what is wrong in one is said."""

from collections.abc import Sequence

from thinkblox.errors import InputError
from thinkblox.evaluation.annotations import (
    MAX_COUNT,
    QUANTIFIERS,
    Attribute,
    Count,
    ElementRelation,
    ObjectRelation,
    Quantifier,
)

Field = str | int | float | None
MAX_FIELDS = 64
"""Most fields of a row."""


def count(fields: Sequence[Field]) -> Count:
    """A row [q, n, category]; raises InputError."""
    _check_length(fields, 3, 3, "q, n, category")
    return Count(*_quantity(fields), _name(fields[2]))


def attribute(fields: Sequence[Field]) -> Attribute:
    """A row [q, n, category, attribute, ...]; raises InputError."""
    _check_length(fields, 4, MAX_FIELDS, "q, n, category, attribute")
    return Attribute(*_quantity(fields), _name(fields[2]), tuple(_name(field) for field in fields[3:]))


def object_relation(fields: Sequence[Field]) -> ObjectRelation:
    """A row [q, n, relation, index of the anchor, category, category, ...]; raises InputError.

    An index of -1, with which SceneEval leaves the anchor open, takes the first.
    """
    _check_length(fields, 6, MAX_FIELDS, "q, n, relation, anchor, category, category")
    objects = [_name(field) for field in fields[4:]]
    index = _whole(fields[3], -1, len(objects) - 1, "the index of the anchor")
    anchor = objects.pop(max(index, 0))
    return ObjectRelation(*_quantity(fields), _name(fields[2]), anchor, tuple(objects))


def element_relation(fields: Sequence[Field]) -> ElementRelation:
    """A row [q, n, relation, category, element]; raises InputError."""
    _check_length(fields, 5, MAX_FIELDS, "q, n, relation, category, element")
    return ElementRelation(*_quantity(fields), _name(fields[2]), _name(fields[3]), _name(fields[4]))


def _check_length(fields: Sequence[Field], least: int, most: int, form: str) -> None:
    if not least <= len(fields) <= most:
        raise InputError(f"has {len(fields)} fields; the form is: {form}")


def _quantity(fields: Sequence[Field]) -> tuple[Quantifier, int]:
    quantifier = next((q for q in QUANTIFIERS if q == fields[0]), None)
    if quantifier is None:
        raise InputError(f"begins with {fields[0]!r}; a quantifier is one of {', '.join(QUANTIFIERS)}")
    return quantifier, _whole(fields[1], 0, MAX_COUNT, "the number")


def _whole(field: Field, least: int, most: int, what: str) -> int:
    try:
        number = int(field) if isinstance(field, str | int) and not isinstance(field, bool) else None
    except ValueError:
        number = None
    if number is None or not least <= number <= most:
        raise InputError(f"{what} is {field!r}; it must be a whole number from {least} to {most}")
    return number


def _name(field: Field) -> str:
    """A word or several; SceneEval tells instances of a category apart by ":0", ":1", which is left out."""
    if not isinstance(field, str) or not (name := field.split(":")[0].strip()):
        raise InputError(f"has {field!r} where a word is needed")
    return name
