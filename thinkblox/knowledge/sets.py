"""What comes with a thing that is of no use alone: a screen and a keyboard with a computer."""

import tomllib
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple


class Rest(NamedTuple):
    """The categories of the rest of a set, which is there where anything of a group is."""

    group: str
    categories: tuple[str, ...]


def rest_of_set(category: str) -> Rest | None:
    """The rest of the set that a thing is part of; None for one that is whole by itself."""
    return _sets().get(category)


@lru_cache(maxsize=1)
def _sets() -> dict[str, Rest]:
    table: dict[str, str] = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    pairs = {category: line.partition(": ") for category, line in table.items()}
    return {category: Rest(group, tuple(rest.split(", "))) for category, (group, _, rest) in pairs.items()}
