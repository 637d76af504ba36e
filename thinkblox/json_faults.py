"""What is wrong with a JSON text, in words that let a person find and mend it."""

import re
from typing import Any

from thinkblox.plain_text import escaped

_MALFORMED = re.compile(r"JSON is malformed: (?P<what>.+) \(byte (?P<byte>\d+)\)")
_UNKNOWN = re.compile(r"Object contains unknown field `(?P<field>.*?)`(?: - at `\$(?P<path>[^`]*)`)?", re.DOTALL)
_PATTERNS = {
    r"^[A-Za-z][A-Za-z0-9_.-]*\Z": "a letter, then letters, digits, underscores, dots and dashes",
    r"^[a-z][a-z0-9_]*\Z": "a small letter, then small letters, digits and underscores",
    r"^[a-z][a-z0-9_]*_[0-9]+\Z": "small letters, digits and underscores, with a number at the end, such as chair_1",
}
_STEP = re.compile(r"\.(?P<field>\w+)|\[(?:\d+|\.\.\.)\]")


def json_fault(error: Exception, data: bytes | str, kind: Any) -> str:
    """Say why a text could not be read: with its line and column where it is no JSON, else with the path in it.

    Args:
        error: what msgspec raised on it.
        data: the text.
        kind: the type it was to be read as; the fields that it knows are listed beside one that it does not.
    """
    text = data if isinstance(data, bytes) else data.encode("utf-8", "surrogatepass")
    if isinstance(error, UnicodeDecodeError):
        return f"is not UTF-8: {place_in(text, _first_bad(text))}"
    if isinstance(error, RecursionError):
        return "is not read: it nests too deeply"
    said = str(error)
    if said == "Input data was truncated":
        return f"is not JSON: it ends too early, {place_in(text, len(text))}"
    if malformed := _MALFORMED.fullmatch(said):
        return f"is not JSON: {malformed['what']}, {place_in(text, int(malformed['byte']))}"
    # A key that is not known stands in the message as it was read.
    return escaped(spelled(said)) + known_fields(said, kind)


def spelled(said: str) -> str:
    """A complaint of msgspec's with the patterns that names must match in words."""
    for pattern, words in _PATTERNS.items():
        said = said.replace(f"matching regex {pattern!r}", f"of {words}")
    return said


def place_in(data: bytes, byte: int) -> str:
    """The line and the column of a byte of UTF-8 text, both from 1, as "line 3, column 14"."""
    before = data[:byte]
    column = len(before[before.rfind(b"\n") + 1 :].decode("utf-8", "replace")) + 1
    line = before.count(b"\n") + 1
    return f"line {line}, column {column}"


def known_fields(said: str, kind: Any) -> str:
    """What to add to msgspec's complaint of an unknown field: the fields there are; empty for any other complaint."""
    unknown = _UNKNOWN.fullmatch(said)
    if unknown is None:
        return ""
    from msgspec import inspect

    found = _structs(inspect.type_info(kind))
    for step in _STEP.finditer(unknown["path"] or ""):
        found = [inner for part in found for inner in _inside(part, step["field"])]
    lists = [", ".join(f"`{field.encode_name}`" for field in part.fields) for part in found if _is_struct(part)]
    return f"; there are {' - or '.join(lists)}" if lists else ""


def _first_bad(text: bytes) -> int:
    try:
        text.decode("utf-8")
    except UnicodeDecodeError as error:
        return error.start
    return len(text)


def _is_struct(info: Any) -> bool:
    return hasattr(info, "fields")


def _structs(info: Any) -> list[Any]:
    """The types that a value may have, without None and with unions taken apart."""
    return [kind for part in info.types for kind in _structs(part)] if hasattr(info, "types") else [info]


def _inside(info: Any, field: str | None) -> list[Any]:
    """The types of a field of a record, or of what a list or a mapping holds."""
    if field is not None:
        fields = getattr(info, "fields", ())
        return [kind for part in fields if part.encode_name == field for kind in _structs(part.type)]
    held = [getattr(info, name) for name in ("item_type", "value_type") if hasattr(info, name)]
    return [kind for part in (*held, *getattr(info, "item_types", ())) for kind in _structs(part)]
