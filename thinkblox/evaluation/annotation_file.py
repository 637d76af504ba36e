"""Reading annotations: CSV as SceneEval publishes them, or JSON with the same rows and what else a prompt demands."""

import csv
import io
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from thinkblox.errors import InputError
from thinkblox.evaluation import rows
from thinkblox.evaluation.annotations import Annotation, RoomDemand
from thinkblox.json_faults import json_fault, place_in
from thinkblox.regular_file import read_text

R = TypeVar("R")
MAX_BYTES = 64_000_000
"""Largest file of annotations that is read [bytes]."""
_COLUMNS = ("ID", "Difficulty", "Description", "ObjCount", "ObjAttr", "OORel", "OARel")


class _Entry(msgspec.Struct, forbid_unknown_fields=True):
    id: str
    prompt: str
    style: str = ""
    count: list[list[rows.Field]] = []
    attr: list[list[rows.Field]] = []
    oo: list[list[rows.Field]] = []
    oa: list[list[rows.Field]] = []
    absent: list[str] = []
    room: RoomDemand | None = None


def read_annotations(path: Path) -> tuple[Annotation, ...]:
    """Read annotated prompts, from CSV where the name ends so, from JSON otherwise.

    Raises:
        InputError: the file cannot be read, or something in it is wrong; names the entry, the column and the row.
    """
    data = read_text(path, most=MAX_BYTES)
    try:
        text = data.decode()
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8: {place_in(data, error.start)}") from error
    try:
        found = _from_csv(text) if path.suffix.lower() == ".csv" else _from_json(text)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    _check_ids(path, found)
    return found


def _check_ids(path: Path, found: Sequence[Annotation]) -> None:
    if not found:
        raise InputError(f"{path}: holds no annotated prompt")
    ids = [annotation.id for annotation in found]
    if twice := next((id for id in ids if ids.count(id) > 1), None):
        raise InputError(f"{path}: two entries have the id {twice!r}; ids must differ")


def _from_json(text: str) -> tuple[Annotation, ...]:
    try:
        entries = msgspec.json.decode(text, type=list[dict[str, Any]])
    except (msgspec.MsgspecError, RecursionError) as error:
        fault = json_fault(error, text, list[dict[str, Any]])
        raise InputError(f"is no list of annotated prompts: {fault}") from error
    return tuple(_json_entry(number, raw) for number, raw in enumerate(entries, 1))


def _json_entry(number: int, raw: dict[str, Any]) -> Annotation:
    where = f"entry {number} ({raw.get('id', 'without id')})"
    try:
        entry = msgspec.convert(raw, _Entry)
    except msgspec.ValidationError as error:
        raise InputError(f"{where}: {json_fault(error, b'', _Entry)}") from error
    return Annotation(
        id=entry.id,
        style=entry.style,
        prompt=entry.prompt,
        counts=_parsed(rows.count, entry.count, f"{where}, count"),
        attributes=_parsed(rows.attribute, entry.attr, f"{where}, attr"),
        object_relations=_parsed(rows.object_relation, entry.oo, f"{where}, oo"),
        element_relations=_parsed(rows.element_relation, entry.oa, f"{where}, oa"),
        absent=tuple(entry.absent),
        room=entry.room or RoomDemand(),
    )


def _from_csv(text: str) -> tuple[Annotation, ...]:
    reader = csv.DictReader(io.StringIO(text, newline=""))
    if missing := [column for column in _COLUMNS if column not in (reader.fieldnames or ())]:
        raise InputError(f"has no column {', '.join(missing)}; SceneEval's are {', '.join(_COLUMNS)}")
    try:
        return tuple(_csv_entry(reader.line_num, record) for record in reader)
    except csv.Error as error:
        raise InputError(f"line {reader.line_num}: {error}") from error


def _csv_entry(line: int, record: dict[str, str | None]) -> Annotation:
    cells = {column: (record[column] or "").strip() for column in _COLUMNS}
    where = f"entry that ends in line {line} ({cells['ID'] or 'without ID'})"
    for column in ("ID", "Description"):
        if not cells[column]:
            raise InputError(f"{where}: the column {column} is empty")
    return Annotation(
        id=cells["ID"],
        style=cells["Difficulty"],
        prompt=cells["Description"],
        counts=_parsed(rows.count, _split(cells["ObjCount"]), f"{where}, ObjCount"),
        attributes=_parsed(rows.attribute, _split(cells["ObjAttr"]), f"{where}, ObjAttr"),
        object_relations=_parsed(rows.object_relation, _split(cells["OORel"]), f"{where}, OORel"),
        element_relations=_parsed(rows.element_relation, _split(cells["OARel"]), f"{where}, OARel"),
    )


def _split(cell: str) -> list[list[rows.Field]]:
    """The rows of a cell: a semicolon between two, a comma between two fields."""
    return [[field.strip() for field in row.split(",")] for row in cell.split(";") if row.strip()]


def _parsed(parse: Callable[[Sequence[rows.Field]], R], written: list[list[rows.Field]], where: str) -> tuple[R, ...]:
    parsed: list[R] = []
    for number, fields in enumerate(written, 1):
        try:
            parsed.append(parse(fields))
        except InputError as error:
            raise InputError(f"{where}, row {number}: {error}") from error
    return tuple(parsed)
