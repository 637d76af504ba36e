"""A foreign JSON file, read with limits: every fault is an InputError that names the file and the place in it."""

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, NoReturn, TypeVar

import msgspec
from msgspec import Meta

from thinkblox.errors import InputError
from thinkblox.json_faults import place_in
from thinkblox.regular_file import read_text

MAX_BYTES = 64_000_000
"""Largest layout file that is read."""
MAX_DIGITS = 18
"""Longest whole number that is read."""
MAX_NAME = 200
"""Longest name that is kept."""

Metres = Annotated[float, Meta(ge=-1000.0, le=1000.0)]
Extent = Annotated[float, Meta(gt=0.0, le=100.0)]
"""Of an object [m]; more is taken for centimetres or millimetres, and refused."""
Degrees = Annotated[float, Meta(ge=-1e6, le=1e6)]


class Foreign(msgspec.Struct, frozen=True, kw_only=True):
    """A record of somebody else's format: unknown keys are passed over, the ones it names are checked."""


F = TypeVar("F")


@dataclass(frozen=True)
class Document:
    """A file and the JSON value in it."""

    path: Path
    raw: Any

    def typed(self, kind: type[F]) -> F:
        """The whole of it as a typed value; raises InputError."""
        return self.part(kind, self.raw, "$")

    def part(self, kind: type[F], raw: Any, at: str) -> F:
        """A part that stands at the JSON path `at`, as a typed value; raises InputError."""
        try:
            return msgspec.convert(raw, type=kind)
        except (msgspec.ValidationError, OverflowError, RecursionError) as error:
            raise InputError(f"{self.path}: {_told(str(error), raw, at)}") from error

    def fail(self, at: str, what: str) -> NoReturn:
        """Raise the InputError that names the file and the JSON path `at`."""
        raise InputError(f"{self.path}: {what} - at `{at}`")


def _told(message: str, raw: Any, at: str) -> str:
    """A complaint about a part that stands at a JSON path, with what is found there."""
    what, _, path = message.partition(" - at `$")
    path = path.removesuffix("`")
    found = _at(raw, path)
    if isinstance(found, int | float) and not isinstance(found, bool):
        what += f", not {found:g}"
        if re.search(r"<= 1000?\.0$|>= -1000\.0$", message.partition(" - at ")[0]):
            what += "; lengths are read in metres"
    elif isinstance(found, dict) and what.startswith("Object missing"):
        what += f"; there are {', '.join(f'`{plain(key)[:40]}`' for key in list(found)[:8]) or 'no fields'}"
    return f"{what} - at `{at}{path}`"


def _at(raw: Any, path: str) -> Any:
    """What stands at a path such as ".boundary.floor_vertices[1][0]"; None where it cannot be followed."""
    for step in re.finditer(r"\.(\w+)|\[(\d+)\]|(.)", path, re.DOTALL):
        try:
            raw = raw[step[1] if step[1] is not None else int(step[2])]
        except (KeyError, IndexError, TypeError):
            return None
    return raw


def read_document(path: Path) -> Document:
    """Read a JSON file.

    Raises:
        InputError: it cannot be read, is too large, is not JSON, nests too deep, holds NaN or an infinite number, or a
            key twice in one object.
    """
    return Document(path, _parsed(path, read_text(path, most=MAX_BYTES)))


def beside(document: Document, belongs: Callable[[Any], bool]) -> list[Document]:
    """The JSON files in a document's folder whose values belong to it; what cannot be read is passed over."""
    found = []
    for file in sorted(document.path.parent.glob("*.json"))[:1000]:
        if file.resolve() != document.path.resolve():
            try:
                other = read_document(file)
            except InputError:
                continue
            if belongs(other.raw):
                found.append(other)
    return found


def _parsed(path: Path, data: bytes) -> Any:
    try:
        if not data.strip():
            raise InputError("is not JSON: it is empty")
        return json.loads(
            data, object_pairs_hook=_distinct, parse_constant=_not_a_number, parse_int=_whole, parse_float=_finite
        )
    except InputError as error:
        raise InputError(f"{path}: {error}{_place_of(str(error), data)}") from error
    except RecursionError as error:
        raise InputError(f"{path}: is nested too deeply to be a layout") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8: {place_in(data, error.start)}") from error
    except ValueError as error:
        raise InputError(f"{path}: is not JSON: {error}") from error


def _distinct(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        keys = [key for key, _ in pairs]
        twice = next(key for key in keys if keys.count(key) > 1)
        raise InputError(f"the key {plain(twice)!r} stands twice in one object; ids and keys must differ")
    return found


_NOT_HELD = "is not a number that JSON or a layout can hold"


def _not_a_number(token: str) -> NoReturn:
    raise InputError(f"{token} {_NOT_HELD}")


_NO_NUMBER = re.compile(rb"[\[:,\s](?P<token>NaN|-?Infinity)\s*[\],}]")


def _place_of(message: str, data: bytes) -> str:
    """Where the first value that is no number stands, as ", line 3, column 14"."""
    found = _NO_NUMBER.search(data) if message.endswith(_NOT_HELD) else None
    return f", {place_in(data, found.start('token'))}" if found else ""


def _whole(token: str) -> int:
    if len(token) > MAX_DIGITS:
        raise InputError(f"a whole number of {len(token)} digits is no length, angle or count")
    return int(token)


def _finite(token: str) -> float:
    value = float(token)
    if abs(value) > 1e18:
        raise InputError(f"the number {token[:30]} is no length, angle or count")
    return value


def plain(text: str) -> str:
    """A name or description fit to be shown and written: one line, printable, not endless."""
    line = " ".join("".join(c if c.isprintable() else " " for c in text[: 4 * MAX_NAME]).split())
    return line[:MAX_NAME]
