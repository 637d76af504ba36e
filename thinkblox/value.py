"""Immutable values that read and write strict JSON: the base of the whole vocabulary."""

import json
import re
from collections.abc import Sequence
from inspect import cleandoc
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from thinkblox.errors import InputError
from thinkblox.json_faults import json_fault
from thinkblox.regular_file import read_text

Vec2 = tuple[float, float]
Vec3 = tuple[float, float, float]
Quat = tuple[float, float, float, float]


class Value(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A frozen record, compared by content. Unknown JSON keys and wrong types are errors that name their path."""


_VECTOR = re.compile(rb"\[\n\s*(-?[0-9][-+.eE0-9,\s]*)\]")

V = TypeVar("V", bound=msgspec.Struct)


def to_json(value: Value) -> bytes:
    """UTF-8 JSON, indented, vectors on one line, a final newline; the same value gives the same bytes."""
    text = msgspec.json.format(msgspec.json.encode(value), indent=2)
    return _VECTOR.sub(_on_one_line, text) + b"\n"


def all_to_json(values: Sequence[Value]) -> bytes:
    """A JSON array of values, written as `to_json` writes one."""
    text = msgspec.json.format(msgspec.json.encode(values), indent=2)
    return _VECTOR.sub(_on_one_line, text) + b"\n"


def _on_one_line(vector: re.Match[bytes]) -> bytes:
    return b"[" + b", ".join(number.strip() for number in vector[1].split(b",")) + b"]"


def from_json(data: bytes | str, kind: type[V], *, where: str = "JSON") -> V:
    """Read `kind` from JSON text.

    Raises:
        InputError: not JSON, a missing or unknown key, a wrong type or a value out of range; names `where` it came from
            and the line and column, or the path in the document, and for an unknown key those that there are.
    """
    try:
        return msgspec.json.decode(data, type=kind)
    except (InputError, msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise InputError(f"{where}: {json_fault(error, data, kind)}") from error


def read_json(path: Path, kind: type[V]) -> V:
    """Read `kind` from a JSON file.

    Raises:
        InputError: it is missing, unreadable, too large or wrong, or an object in it has a key twice; names the file.
    """
    return read_json_and_text(path, kind)[0]


def read_json_and_text(path: Path, kind: type[V]) -> tuple[V, bytes]:
    """Read `kind` from a JSON file, as `read_json`, and return its text as well."""
    data = read_text(path)
    value = from_json(data, kind, where=str(path))
    refuse_double_keys(data, str(path))
    return value, data


def refuse_double_keys(data: bytes, where: str) -> None:
    """Raise InputError for a JSON text in which an object has a key twice."""
    # msgspec takes the last of several silently; this costs half as much again as reading.
    try:
        json.loads(data, object_pairs_hook=_distinct)
    except (ValueError, RecursionError, InputError) as error:
        raise InputError(f"{where}: {error}") from error


def _distinct(pairs: list[tuple[str, Any]]) -> None:
    keys = [key for key, _ in pairs]
    if len(set(keys)) < len(keys):
        twice = next(key for key in keys if keys.count(key) > 1)
        raise InputError(f"an object has the key {twice!r} twice; keep one of them")


def json_schema(kind: type[Value]) -> dict[str, Any]:
    """The JSON Schema (2020-12) of a value type."""
    schema: dict[str, Any] = _for_everybody(msgspec.json.schema(kind))
    return {"$schema": "https://json-schema.org/draft/2020-12/schema"} | schema


def _for_everybody(schema: Any) -> Any:
    """A schema without what only Python says: its end of a text in patterns, and the indents of docstrings."""
    if isinstance(schema, list):
        return [_for_everybody(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    plain = {key: _for_everybody(part) for key, part in schema.items()}
    if isinstance(plain.get("pattern"), str):
        plain["pattern"] = re.sub(r"\\Z\Z", "$", plain["pattern"])
    if isinstance(plain.get("description"), str):
        plain["description"] = cleandoc(plain["description"])
    return plain
