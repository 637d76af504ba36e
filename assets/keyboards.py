"""Electric pianos and organs: instruments with rows of keys and no strings."""

from math import cos, pi

from thinkblox.assets.palette import BLACK_PLASTIC, DARK_PLASTIC, GREY_PLASTIC, IRON, OAK, STEEL, WALNUT, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, Range
from thinkblox.assets.shapes import around, box, disc, frustum, rod, top_surface
from thinkblox.assets.spec import Spec

_KEY = 0.024
"""Width of a white key [m]."""
_PIPES = 17
"""Pipes in the front of an organ."""


def _keys(x: Range, width: float, low: float) -> list[Part]:
    """A row of white and black keys over a depth and a width, on a bed that ends at `low`; it is 0.03 high [m]."""
    count = int(width / _KEY)
    pitch, reach = width / count, x[0] + 0.6 * (x[1] - x[0])
    black = [k for k in range(count - 1) if k % 7 not in (2, 6)]
    return [
        box(WHITE_PLASTIC, x, around(0, width), (low, low + 0.02)),
        *(
            box(
                BLACK_PLASTIC,
                (x[0], reach),
                around((k + 1) * pitch - width / 2, 0.45 * pitch),
                (low + 0.02, low + 0.03),
            )
            for k in black
        ),
    ]


def electric_piano(spec: Spec) -> Build:
    """Return an electric piano on a crossed stand; one plays at +x, and the top is behind the keys."""
    x, y, z = spec.size
    case, low = spec.main(spec.choice((BLACK_PLASTIC, DARK_PLASTIC))), z - 0.11
    back, cheek = 0.04 * x, 0.045
    body: list[Part] = [
        box(case, (-x / 2, x / 2), (-y / 2, y / 2), (low, z - 0.05)),
        box(case, (-x / 2, back), (-y / 2, y / 2), (z - 0.05, z)),
        *(box(case, (back, x / 2), (s * y / 2, s * (y / 2 - cheek)), (z - 0.05, z - 0.015)) for s in (-1, 1)),
        *_keys((back, x / 2 - 0.01), y - 2 * cheek, z - 0.05),
        box(GREY_PLASTIC, (back, back + 0.001), around(0, 0.5 * y), (z - 0.016, z - 0.006), collide=False),
    ]
    for s in (-1, 1):
        at = s * 0.3 * x
        body += [
            rod(IRON, (at, -0.36 * y, 0.03), (at, 0.36 * y, low), 0.014),
            rod(IRON, (at, 0.36 * y, 0.03), (at, -0.36 * y, low), 0.014),
            box(IRON, (-x / 2, x / 2), around(s * 0.36 * y, 0.04), (0, 0.035)),
            box(IRON, around(0, 0.9 * x), around(s * 0.36 * y, 0.03), (low - 0.025, low)),
        ]
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, back), (-y / 2, y / 2), z)])


def pipe_organ(spec: Spec) -> Build:
    """Return a church organ: rows of keys, stops and pedals below its pipes; one plays at +x."""
    x, y, z = spec.size
    wood, bench = spec.main(spec.choice((OAK, WALNUT))), min(0.72, 0.34 * z)
    chest, face, wide = 0.46 * z, 0.05 * x, 0.56 * y
    body: list[Part] = [
        box(wood, (-x / 2, face), (-y / 2, y / 2), (0, chest)),
        box(wood, (-x / 2, 0.12 * x), (-y / 2, y / 2), (chest, chest + 0.03 * z)),
        box(wood, (-x / 2, -0.4 * x), (-y / 2, y / 2), (chest + 0.03 * z, 0.96 * z)),
        *(box(wood, (-0.4 * x, face), (s * y / 2, s * 0.47 * y), (chest + 0.03 * z, 0.96 * z)) for s in (-1, 1)),
        box(wood, (-x / 2, 0.12 * x), (-y / 2, y / 2), (0.96 * z, z)),
        box(wood, (face, 0.4 * x), around(0, wide), (bench - 0.08, bench)),
        *(box(wood, (face, 0.4 * x), (s * 0.5 * wide, s * (0.5 * wide + 0.03)), (0, bench + 0.16)) for s in (-1, 1)),
        *_keys((0.22 * x, 0.38 * x), 0.86 * wide, bench),
        box(wood, (face, 0.22 * x), around(0, wide), (bench, bench + 0.06)),
        *_keys((face + 0.01 * x, 0.21 * x), 0.86 * wide, bench + 0.06),
        *(
            disc(IRON, (face + 0.02, s * (0.36 * wide + 0.04 * wide * k)), 0.014, (bench + 0.09, bench + 0.13))
            for s in (-1, 1)
            for k in range(3)
        ),
        *(box(wood, (face, x / 2), around(k * 0.08 * wide, 0.03), (0, 0.05)) for k in range(-5, 6)),
    ]
    pitch, foot = 0.94 * y / _PIPES, chest + 0.03 * z
    for k in range(_PIPES):
        at = (k - (_PIPES - 1) / 2) * pitch
        top = foot + (0.93 * z - foot) * (0.72 + 0.28 * cos(4 * pi * at / y))
        radius = 0.42 * pitch
        body += [
            frustum(STEEL, (-0.12 * x, at), (foot, foot + 0.06 * z), 0.3 * radius, radius, sides=12),
            disc(STEEL, (-0.12 * x, at), radius, (foot + 0.06 * z, top)),
            box(
                BLACK_PLASTIC,
                around(-0.12 * x + radius, 0.006),
                around(at, radius),
                around(foot + 0.075 * z, 0.012 * z),
                collide=False,
            ),
        ]
    return Build(body=body)


def home_organ(spec: Spec) -> Build:
    """Return a small organ: two rows of keys in a case, with pedals; one plays at +x."""
    x, y, z = spec.size
    wood = spec.main(spec.choice((WALNUT, OAK)))
    keys, side, deep = 0.68 * z, 0.04, (0.08 * x, 0.44 * x)
    middle = sum(deep) / 2
    body: list[Part] = [
        box(wood, (-x / 2, -0.3 * x), (-y / 2, y / 2), (0, z - 0.03)),
        box(wood, (-x / 2, deep[0]), (-y / 2, y / 2), (z - 0.03, z)),
        box(wood, (-0.3 * x, deep[1]), around(0, y - 2 * side), (keys - 0.1, keys)),
        *(box(wood, (-0.3 * x, x / 2), (s * y / 2, s * (y / 2 - side)), (0, keys + 0.05)) for s in (-1, 1)),
        *(box(wood, (-0.3 * x, deep[0]), (s * y / 2, s * (y / 2 - side)), (keys + 0.05, z - 0.03)) for s in (-1, 1)),
        *_keys((middle, deep[1]), y - 2 * side - 0.04, keys),
        box(wood, (-0.3 * x, middle), around(0, y - 2 * side), (keys, keys + 0.05)),
        *_keys((deep[0], middle), y - 2 * side - 0.04, keys + 0.05),
        box(
            Finish((0.86, 0.82, 0.72), "plastic"), (-0.3 * x, -0.28 * x), around(0, 0.6 * y), (keys + 0.08, keys + 0.14)
        ),
        *(box(wood, (-0.2 * x, 0.3 * x), around(k * 0.06, 0.03), (0, 0.05)) for k in range(-3, 4)),
    ]
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, deep[0]), (-y / 2, y / 2), z)])
