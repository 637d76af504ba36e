"""The families of the catalogue: one TOML file for each, one entry in it for all that is known of a category.

Beside them, general.toml: words that are no categories ("any_table"), of which the company says what they mean.

An entry is written as the fields of `Category`, with `make` for the generator ("beds.bed": the function `bed` of the
module `thinkblox.assets.beds`). The noun is the name unless it is given. An entry with `kind_of`, another entry of the
same file, has all that it does not say itself from there, but for the words: "a teddy bear" is a toy with a name of its
own.
"""

import tomllib
from collections.abc import Iterator
from dataclasses import fields
from importlib import import_module
from pathlib import Path
from typing import Any, cast

import msgspec

from thinkblox.assets.category import Category, Generator
from thinkblox.assets.facts import Facts
from thinkblox.errors import InputError

FAMILIES = (
    "beds storage tables seats appliances electronics lamps plants small "
    "kitchenware workshop trolleys belongings nursery leisure laboratory "
    "shopfittings bathroom walls fixtures games textiles"
).split()
"""The files, in the order in which their categories are listed."""
_OF_ITS_OWN = ("noun", "words", "senses", "rooms", "like")
"""Fields that a kind of another category does not have from there."""
_FIELDS = frozenset(field.name for field in fields(Category)) - {"name", "generator"} | {"make"}


def general_words() -> dict[str, Facts]:
    """What is known of the words that are no categories themselves."""
    return msgspec.convert(_read("general"), dict[str, Facts])


def categories() -> Iterator[Category]:
    """Every category of every family, in order."""
    for family in FAMILIES:
        entries = _read(family)
        for name, entry in entries.items():
            yield category_from(name, _whole(name, entry, entries))


def _whole(name: str, entry: dict[str, Any], entries: dict[str, Any]) -> dict[str, Any]:
    """An entry with what it has from the one that it is a kind of."""
    if "kind_of" not in entry:
        return entry
    if entry["kind_of"] not in entries:
        raise InputError(f"category {name!r} is a kind of {entry['kind_of']!r}, which is not in the same file")
    general = {key: value for key, value in entries[entry["kind_of"]].items() if key not in _OF_ITS_OWN}
    return general | {key: value for key, value in entry.items() if key != "kind_of"}


def category_from(name: str, entry: dict[str, Any]) -> Category:
    """The category of one entry; raises InputError for a field that there is not, or a value of the wrong type."""
    if extra := entry.keys() - _FIELDS:
        raise InputError(f"category {name!r} has no field {', '.join(sorted(extra))}; it has {sorted(_FIELDS)}")
    values = {"name": name, "noun": name.replace("_", " "), "generator": _generator(entry["make"])} | entry
    try:
        return msgspec.convert(values, Category)
    except msgspec.ValidationError as error:
        raise InputError(f"category {name!r}: {error}") from error


def _read(family: str) -> dict[str, Any]:
    return tomllib.loads(Path(__file__).with_name(f"{family}.toml").read_text(encoding="utf-8"))


def _generator(path: str) -> Generator:
    module, _, function = path.partition(".")
    return cast(Generator, getattr(import_module(f"thinkblox.assets.{module}"), function))
