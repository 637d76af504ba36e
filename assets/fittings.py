"""Fittings and screens: curtains, rails, hooks, radiators, coat stands, folding screens."""

from math import cos, pi, sin

from thinkblox.assets.mounting import WALL_MOUNTED
from thinkblox.assets.palette import (
    CREAM_PAINT,
    GREY_METAL,
    LINEN,
    MIRROR,
    STEEL,
    WHITE_METAL,
)
from thinkblox.assets.panels import mirror
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import around, box, capsule, cylinder, disc, oval, prism, rod, round_leg, sphere
from thinkblox.assets.spec import Spec


def standing_mirror(spec: Spec) -> Build:
    """Return a long mirror that leans back on a strut, or is flat to hang on a wall."""
    if spec.has(WALL_MOUNTED):
        return mirror(spec)
    x, y, z = spec.size
    frame = spec.wood
    lean, half = 0.22 * x, y / 2
    corners = ((-half, -half + 0.03), (half - 0.03, half))
    stile = [(x / 2 - 0.03, 0.0), (x / 2, 0.0), (x / 2 - lean, z), (x / 2 - lean - 0.03, z)]
    body = [prism(frame, stile, across, axis=1) for across in corners]
    for low, high in ((0.05, 0.07), (0.98, 1.0)):
        front = [x / 2 - lean * t for t in (low, high)]
        body.append(
            prism(
                frame,
                [(front[0] - 0.03, low * z), (front[0], low * z), (front[1], high * z), (front[1] - 0.03, high * z)],
                (-half + 0.03, half - 0.03),
                axis=1,
            )
        )
    front = [x / 2 - lean * t - 0.008 for t in (0.07, 0.98)]
    body.append(
        prism(
            MIRROR,
            [(front[0] - 0.01, 0.07 * z), (front[0], 0.07 * z), (front[1], 0.98 * z), (front[1] - 0.01, 0.98 * z)],
            (-half + 0.03, half - 0.03),
            axis=1,
        )
    )
    body += [
        rod(frame, (-x / 2 + 0.014, s * 0.3 * y, 0.012), (x / 2 - 0.6 * lean - 0.035, s * 0.3 * y, 0.6 * z), 0.012)
        for s in (-1, 1)
    ]
    body += [box(frame, (-x / 2, -x / 2 + 0.03), around(s * 0.3 * y, 0.03), (0, 0.012)) for s in (-1, 1)]
    return Build(body=body)


def curtain(spec: Spec) -> Build:
    """Return two drawn-back curtains in folds on a rail."""
    x, y, z = spec.size
    cloth = spec.fabric if spec.words else spec.choice((LINEN, spec.style.accent, spec.style.fabric))
    body = [_rail(spec, z)]
    for side in (-1, 1):
        folds = 5
        wide = 0.22 * y / folds
        for k in range(folds):
            at = side * (y / 2 - 0.03 - wide * (k + 0.5))
            depth = x * (1.0 if k % 2 else 0.66)
            body.append(
                prism(cloth, [(a, b + at) for a, b in oval(depth, wide * 1.12, sides=12)], (0, z - 0.03), smooth=True)
            )
    return Build(body=body)


def _rail(spec: Spec, z: float) -> Part:
    y = spec.size[1]
    return cylinder(spec.style.metal, around(0, 0.024), (-y / 2, y / 2), (z - 0.027, z - 0.003), axis=1)


def curtain_rail(spec: Spec) -> Build:
    """Return a privacy curtain on a rail held off the wall."""
    x, y, z = spec.size
    cloth = spec.main(Finish((0.66, 0.76, 0.74), "fabric"))
    rail = x / 2 - 0.02
    body: list[Part] = [cylinder(STEEL, around(rail, 0.025), (-y / 2, y / 2), (z - 0.025, z), axis=1)]
    body += [box(STEEL, (-x / 2, rail), around(s * (y / 2 - 0.03), 0.02), (z - 0.022, z - 0.003)) for s in (-1, 1)]
    folds = max(4, int(y / 0.14))
    for k in range(folds):
        at = -y / 2 + 0.06 + (0.55 * y) * k / folds
        body.append(
            prism(
                cloth,
                [
                    (rail - (0.012 if k % 2 else -0.0) + a * 0.5, at + b)
                    for a, b in oval(0.06, 0.56 * y / folds * 1.1, sides=10)
                ],
                (0, z - 0.03),
                smooth=True,
            )
        )
    return Build(body=body)


def radiator(spec: Spec) -> Build:
    """Return a ribbed radiator for the wall."""
    x, y, z = spec.size
    paint = spec.main(WHITE_METAL)
    ribs = max(4, int(y / 0.07))
    body: list[Part] = [
        cylinder(paint, around(0, 0.04), (-y / 2, y / 2), around(h * z, 0.04), axis=1) for h in (0.1, 0.9)
    ]
    body += [
        box(paint, (-x / 2 + 0.03, x / 2), around(-y / 2 + (k + 0.5) * y / ribs, 0.68 * y / ribs), (0, z))
        for k in range(ribs)
    ]
    body += [
        box(GREY_METAL, (-x / 2, -x / 2 + 0.03), around(s * 0.35 * y, 0.03), around(0.8 * z, 0.05)) for s in (-1, 1)
    ]
    return Build(body=body)


def towel_rail(spec: Spec) -> Build:
    """Return a rail with a towel over it."""
    x, y, z = spec.size
    towel = spec.main(spec.style.accent)
    bar = (x / 2 - 0.035, z - 0.03)
    body: list[Part] = [cylinder(STEEL, around(bar[0], 0.02), (-y / 2, y / 2), around(bar[1], 0.02), axis=1)]
    body += [box(STEEL, (-x / 2, bar[0]), around(s * (y / 2 - 0.02), 0.02), around(bar[1], 0.014)) for s in (-1, 1)]
    across = (-0.36 * y, 0.3 * y)
    body.append(box(towel, (bar[0] + 0.01, x / 2), across, (0, z - 0.01)))
    body.append(box(towel, (bar[0] - 0.03, bar[0] - 0.01), across, (0.2 * z, z - 0.01)))
    body.append(box(towel, (bar[0] - 0.03, x / 2), across, (z - 0.012, z)))
    return Build(body=body)


def coat_rack(spec: Spec) -> Build:
    """Return a coat stand with eight pegs and a hat."""
    x, y, z = spec.size
    reach = min(x, y) / 2
    wood = spec.wood
    body: list[Part] = [disc(wood, (0, 0), 0.022, (0.1, z - 0.03)), sphere(wood, (0, 0, z - 0.028), 0.028)]
    for k in range(4):
        a = pi * k / 2
        c, s = cos(a), sin(a)
        body.append(round_leg(wood, (0.92 * reach * c, 0.92 * reach * s), (0.02 * c, 0.02 * s), (0, 0.22), 0.014, 0.02))
        for height, length in ((0.88 * z, 0.75), (0.72 * z, 0.55)):
            body.append(
                rod(
                    wood,
                    (0.01 * c, 0.01 * s, height),
                    (length * reach * c, length * reach * s, height + 0.1),
                    0.011,
                    sides=8,
                )
            )
    return Build(body=body)


def room_divider(spec: Spec) -> Build:
    """Return a folding screen of three panels that stands by its angles."""
    x, y, z = spec.size
    frame, cloth = spec.wood, spec.choice((LINEN, CREAM_PAINT))
    count, thick = 3, 0.028
    wide = y / count
    body: list[Part] = []
    for k in range(count):
        a, b = -y / 2 + k * wide, -y / 2 + (k + 1) * wide
        xa, xb = (-x / 2, x / 2 - thick) if k % 2 == 0 else (x / 2 - thick, -x / 2)
        for t0, t1 in ((0.0, 0.08), (0.92, 1.0)):
            body.append(prism(frame, _slant(a, b, xa, xb, t0, t1, thick), (0, z)))
        for low, high, finish in ((0.06, 0.12, frame), (0.12, 0.94, cloth), (0.94, 0.98, frame)):
            body.append(prism(finish, _slant(a, b, xa, xb, 0.08, 0.92, 0.7 * thick), (low * z, high * z)))
    return Build(body=body)


def _slant(a: float, b: float, xa: float, xb: float, t0: float, t1: float, thick: float) -> list[tuple[float, float]]:
    ends = [(xa + (xb - xa) * t, a + (b - a) * t) for t in (t0, t1)]
    return [ends[0], (ends[0][0] + thick, ends[0][1]), (ends[1][0] + thick, ends[1][1]), ends[1]]


def hooks(spec: Spec) -> Build:
    """Return a board of hooks for the wall."""
    x, y, z = spec.size
    body: list[Part] = [box(spec.wood, (-x / 2, -x / 2 + 0.02), (-y / 2, y / 2), (0, z))]
    count = max(3, int(y / 0.15))
    for k in range(count):
        at = -y / 2 + (k + 0.5) * y / count
        body.append(
            cylinder(
                spec.style.metal, (-x / 2 + 0.02, x / 2 - 0.008), around(at, 0.014), around(0.55 * z, 0.014), axis=0
            )
        )
        body.append(capsule(spec.style.metal, (x / 2 - 0.016, x / 2), around(at, 0.016), (0.5 * z, 0.5 * z + 0.05)))
    return Build(body=body)
