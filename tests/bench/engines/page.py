"""The page that tells what other engines make of exported rooms."""

from collections.abc import Mapping, Sequence
from typing import Any

_BEGINNING = """\
# Exported rooms in other engines

    python -m tests.bench.engines ROOMS [--engines rapier3d,newton] [--home out/engines] [--out docs/engines.md]

exports rooms, and lets each engine read them in a virtual environment of its own, which is made from pinned versions
(`tests/bench/engines/pins.toml`) when it is first needed, and driven as a process of its own. Everything stands where
it came to rest in MuJoCo and is let alone for 2 s. Then each thing with doors or drawers is held still by itself under
gravity (2, 0, -9.6), which draws them open: how far they are after 0.4 s and 0.8 s tells far more than settling does. A
cell is the largest difference from MuJoCo in the room; an engine that fails has its error in its row. This page is what
the command writes.

## {count} rooms

Seconds are those that 2 s of the whole room take on one busy core. Of an engine that knows no dry friction of joints,
what is in brackets is the difference from MuJoCo without any.

"""
_MARBLE = """
## A marble in a mug

A marble of 16 mm is let go 1 cm over the rim of a mug that is made of convex pieces. After 2 s its lowest point is so
high over the mug's own; in an engine that fills what is hollow it would lie on top.

"""
_ENGINES = """
## The engines

| engine | reads | what is known |
|---|---|---|
"""


def page(pins: Mapping[str, Any], rooms: Sequence[str], marbles: Sequence[str]) -> str:
    """The text, from the lines of both tables with their heads."""
    count = len({line.split("|")[1] for line in rooms[2:]})
    known = [f"| {pin['title']} | {pin['reads']} | {' '.join(pin['known'].split())} |" for pin in pins.values()]
    parts = [_BEGINNING.format(count=count), *_joined(rooms), _MARBLE, *_joined(marbles)]
    return "".join([*parts, _ENGINES, *_joined(known)])


def _joined(lines: Sequence[str]) -> list[str]:
    return [line + "\n" for line in lines]
