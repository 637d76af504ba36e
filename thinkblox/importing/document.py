"""A foreign JSON file, read with limits: every fault is an InputError that names the file and the place in it."""

import json
from codecs import BOM_UTF8
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, NoReturn, TypeVar

import msgspec
from msgspec import Meta

from thinkblox.errors import InputError
from thinkblox.json_faults import place_in
from thinkblox.regular_file import read_regular

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
            raise InputError(f"{self.path}: {_placed(str(error), at)}") from error

    def fail(self, at: str, what: str) -> NoReturn:
        """Raise the InputError that names the file and the JSON path `at`."""
        raise InputError(f"{self.path}: {what} - at `{at}`")


def _placed(message: str, at: str) -> str:
    return message.replace("`$", f"`{at}", 1) if "`$" in message else f"{message} - at `{at}`"


def read_document(path: Path) -> Document:
    """Read a JSON file.

    Raises:
        InputError: it cannot be read, is too large, is not JSON, nests too deep, holds NaN or an infinite number, or a
            key twice in one object.
    """
    return Document(path, _parsed(path, read_regular(path, most=MAX_BYTES).removeprefix(BOM_UTF8)))


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
        return json.loads(
            data, object_pairs_hook=_distinct, parse_constant=_not_a_number, parse_int=_whole, parse_float=_finite
        )
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
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


def _not_a_number(token: str) -> NoReturn:
    raise InputError(f"{token} is not a number that JSON or a layout can hold")


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
