"""What comes as one piece though it is several: a small kitchen in one run, a booth with its table."""

from thinkblox.assets.palette import COGNAC, GREY_METAL, IRON, MARBLE, NAVY_WOOL, STEEL, TERRACOTTA_WOOL
from thinkblox.assets.part import Build, Finish, Part, moved
from thinkblox.assets.shapes import around, box, cushion, disc, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.assets.storage import base_cabinet
from thinkblox.assets.worktop import hob, tap

_SPLASH = 0.32
"""Height of the tiles behind a worktop [m]."""
_SEAT, _BENCH = 0.46, 0.5
"""Height and depth of a bench in a booth [m]."""
_TABLE = 0.75
"""Height of its table [m]."""


def kitchenette(spec: Spec) -> Build:
    """Return cabinets under one worktop with a sink at its left, two rings at its right, and tiles behind."""
    x, y, z = spec.size
    top = z - _SPLASH
    build = base_cabinet(Spec(spec.category, (x, y, top), spec.words, spec.style, spec.rng))
    basin = min(0.42, 0.3 * y)
    left, right = y / 2 - 0.06 - basin / 2, -y / 2 + 0.06 + basin / 2
    tiles = spec.choice((MARBLE, Finish((0.86, 0.88, 0.86), "ceramic")))
    bowl = (around(0.03, 0.5 * x), around(left, basin - 0.1))
    plates = hob(Spec("hob", (0.8 * x, basin, 0.02), frozenset(), spec.style, spec.rng))
    build.body += [
        *(moved(part, (0.0, right, top)) for part in plates.body),
        box(STEEL, around(0.02, 0.7 * x), around(left, basin), (top, top + 0.006)),
        box(GREY_METAL, *bowl, (top + 0.006, top + 0.008)),
        disc(IRON, (0.03, left), 0.022, (top + 0.008, top + 0.01)),
        *(moved(part, (0.0, left, 0.0)) for part in tap(-x / 2 + 0.07, top, z)),
        box(tiles, (-x / 2, -x / 2 + 0.012), (-y / 2, y / 2), (top, z)),
    ]
    middle = (right + basin / 2 + 0.03, left - basin / 2 - 0.03)
    build.surfaces = [top_surface("worktop", (-x / 2 + 0.02, x / 2), middle, top)]
    return build


def booth(spec: Spec) -> Build:
    """Return two high-backed benches that face each other over a table, open to the aisle at +x."""
    x, y, z = spec.size
    seat = spec.main(spec.choice((COGNAC, TERRACOTTA_WOOL, NAVY_WOOL, Finish((0.55, 0.12, 0.12), "leather"))))
    parts: list[Part] = []
    for side in (-1, 1):
        back = (side * y / 2, side * (y / 2 - 0.12))
        bench = (side * (y / 2 - 0.12), side * (y / 2 - _BENCH))
        parts += [
            box(spec.wood, (-x / 2, x / 2), _range(back), (0.0, 0.3)),
            cushion(seat, (-x / 2, x / 2), _range(back), (0.3, z), radius=0.04),
            box(spec.wood, (-x / 2 + 0.02, x / 2 - 0.02), _range(bench), (0.0, _SEAT - 0.1)),
            cushion(seat, (-x / 2, x / 2), _range(bench), (_SEAT - 0.1, _SEAT), radius=0.03),
        ]
    half = (y - 2 * _BENCH) / 2 + 0.02
    top = ((-x / 2, x / 2 - 0.06), (-half, half))
    parts += [
        box(spec.wood, *top, (_TABLE - 0.04, _TABLE)),
        box(IRON, around(0.0, 0.09), around(0.0, 0.09), (0.02, _TABLE - 0.04)),
        box(IRON, around(0.0, 0.5), around(0.0, 0.4), (0.0, 0.02)),
    ]
    return Build(body=parts, surfaces=[top_surface("top", *top, _TABLE)])


def _range(pair: tuple[float, float]) -> tuple[float, float]:
    return (min(pair), max(pair))
