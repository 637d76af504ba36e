"""The parts of a room in which one sleeps, cooks or sits at leisure, and what makes each of them."""

import tomllib
from functools import lru_cache
from pathlib import Path

from thinkblox.knowledge.habits import load_habits


@lru_cache(maxsize=1)
def _zones() -> dict[str, tuple[str, ...]]:
    table: dict[str, str] = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    return {zone: tuple(names.split(", ")) for zone, names in table.items()}


def zone_of(category: str) -> str:
    """The part of a room that a thing helps to make; empty for what belongs anywhere."""
    habits = load_habits()
    for zone, names in _zones().items():
        groups = (name.removeprefix("@") for name in names if name.startswith("@"))
        if category in names or habits.is_in(category, *groups):
            return zone
    return ""
