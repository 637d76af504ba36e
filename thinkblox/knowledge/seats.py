"""Which seats are drawn up to a desk or a table, where neither the prompt nor the type of room says."""

import tomllib
from functools import lru_cache
from pathlib import Path

from thinkblox.assets import kind_of
from thinkblox.assets.stand_ins import stand_in
from thinkblox.knowledge.rooms import Usual, read_usual


def usual_seat(category: str) -> Usual | None:
    """The seats at a thing: how many, of which kind and in which relation; None where nobody sits at it."""
    return _seats().get(category)


def places_at(category: str) -> int:
    """How many have a place on such a seat, or at such a desk or bench."""
    drawn = usual_seat(category) or usual_seat(stand_in(category).like)
    return max(1, kind_of(category).seats, drawn.count if drawn else 1)


@lru_cache(maxsize=1)
def _seats() -> dict[str, Usual]:
    table: dict[str, str] = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    return {category: read_usual((f"{seats} {category}",))[0] for category, seats in table.items()}
