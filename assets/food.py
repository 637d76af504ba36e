"""Bread, cakes and other food that is not turned: loaves, rolls, bananas, cheese."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, pi, sin

from thinkblox.assets.part import Build, Finish, Part, Range, hull, turned
from thinkblox.assets.shapes import around, box, cushion, prism, rod
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc
from thinkblox.value import Vec2

_CRUST = Finish((0.72, 0.48, 0.24), "fabric")
_CRUMB = Finish((0.93, 0.84, 0.64), "fabric")
_BANANA = Finish((0.94, 0.80, 0.25), "plastic")
_TIP = Finish((0.40, 0.34, 0.16), "plastic")


def bread(spec: Spec) -> Build:
    """Return a loaf with three cuts along its top."""
    x, y, z = spec.size
    crust = spec.main(_CRUST)
    body: list[Part] = [cushion(crust, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.97 * z), radius=0.34 * min(x, z))]
    body += [_cut(0.27 * k * y, 0.5 * x, 0.05 * y, (0.9 * z, z), 20.0) for k in (-1, 0, 1)]
    return Build(body=body)


def baguette(spec: Spec) -> Build:
    """Return a long loaf with slanting cuts."""
    x, y, z = spec.size
    crust, third = spec.main(_CRUST), y / 3
    body = [
        _lying_stump(crust, (-third, -y / 2), x, 0.97 * z, 0.35),
        _lying_stump(crust, (-third, third), x, 0.97 * z, 1.0),
        _lying_stump(crust, (third, y / 2), x, 0.97 * z, 0.35),
    ]
    body += [_cut(0.15 * (k - 2) * y, 0.2 * x, 0.11 * y, (0.8 * z, z), -14.0) for k in range(5)]
    return Build(body=body)


def _cut(at: float, along: float, across: float, z: Range, degrees: float) -> Part:
    return turned(box(_CRUMB, around(0, along), around(at, across), z), 2, degrees, (0.0, at, 0.0))


def _lying_stump(finish: Finish, y: Range, wide: float, tall: float, tip: float) -> Part:
    """A loaf's piece along y with a flat underside, that narrows to a share `tip` at y[1]."""
    outline = [(cos(2 * pi * k / 20), max(-0.86, sin(2 * pi * k / 20))) for k in range(20)]
    points = [
        (share * wide / 2 * u, at, share * tall * (0.86 + v) / 1.86)
        for at, share in ((y[0], 1.0), (y[1], tip))
        for u, v in outline
    ]
    return hull(finish, points, smooth=True)


def croissant(spec: Spec) -> Build:
    """Return a curved roll in ridges, thick in the middle."""
    x, y, z = spec.size
    crust, shares = spec.main(_CRUST), (0.3, 0.6, 0.85, 1.0, 1.0, 0.85, 0.6, 0.3)
    return Build(body=_curved(crust, (0.9 * x, 0.44 * y), 84.0, shares, z / 2, ridge=0.84))


def _curved(
    finish: Finish, radii: Vec2, degrees: float, shares: Sequence[float], thick: float, *, ridge: float = 1.0
) -> list[Part]:
    """A lying bow of stumps as thick as `shares` of `thick`, flat below, narrowed by `ridge` outwards [m]."""
    flat = arc((-radii[0], 0.0, 0.0), radii, (-degrees, degrees), axis=2, steps=len(shares) - 1)
    points = [(u, v, share * thick) for (u, v, _), share in zip(flat, shares, strict=True)]
    parts: list[Part] = []
    for k, (a, b) in enumerate(pairwise(points)):
        rising = shares[k] < shares[k + 1]
        ends = (ridge * shares[k] if rising else shares[k], shares[k + 1] if rising else ridge * shares[k + 1])
        reach = [0.12 * (v - u) for u, v in zip(a, b, strict=True)]
        start = (a[0] - reach[0], a[1] - reach[1], a[2])
        end = (b[0] + reach[0], b[1] + reach[1], b[2])
        stump = rod(finish, start, end, ends[0] * thick, end_radius=ends[1] * thick, sides=12)
        parts.append(hull(finish, [(u, v, max(w, 0.16 * thick)) for u, v, w in stump.points], smooth=True))
    return parts


def doughnut(spec: Spec) -> Build:
    """Return a ring of dough with icing."""
    x, y, z = spec.size
    icing = spec.main(Finish(spec.choice(((0.90, 0.56, 0.62), (0.36, 0.20, 0.13), (0.95, 0.92, 0.86))), "plastic"))
    body: list[Part] = []
    for k in range(12):
        ends = (2 * pi * (k - 0.5) / 12, 2 * pi * (k + 0.5) / 12)
        for finish, low, high, inner, outer in ((_CRUST, 0.0, 0.6, 0.32, 1.0), (icing, 0.6, 1.0, 0.4, 0.9)):
            points = [
                (r * x / 2 * cos(a), r * y / 2 * sin(a), h * z)
                for a in ends
                for r, h in (
                    (inner + 0.1, low),
                    (outer - 0.1, low),
                    (outer, 0.6),
                    (inner, 0.6),
                    (inner + 0.16, high),
                    (outer - 0.16, high),
                )
            ]
            body.append(hull(finish, points, smooth=True))
    return Build(body=body)


def banana(spec: Spec) -> Build:
    """Return a banana lying on its side."""
    x, y, z = spec.size
    shares = (0.3, 0.7, 0.92, 1.0, 1.0, 1.0, 0.9, 0.66, 0.28)
    body = _curved(spec.main(_BANANA), (1.5 * x, 0.47 * y), 76.0, shares, z / 2)
    for end in (body[0], body[-1]):
        side = 1 if end.centre[1] > 0 else -1
        tip = (end.lo[0], end.hi[1] if side > 0 else end.lo[1], 0.21 * z)
        body.append(rod(_TIP, tip, (tip[0] - 0.1 * x, tip[1] + 0.03 * side * y, tip[2]), 0.12 * z, sides=8))
    return Build(body=body)


def cheese(spec: Spec) -> Build:
    """Return a wedge of cheese with a rind."""
    x, y, z = spec.size
    paste = spec.main(Finish((0.95, 0.80, 0.42), "plastic"))
    rind = Finish((0.80, 0.55, 0.22), "plastic")
    wedge = [(-0.46 * x, -y / 2), (-0.46 * x, y / 2), (x / 2, 0.06 * y), (x / 2, -0.06 * y)]
    return Build(body=[prism(paste, wedge, (0, z)), box(rind, (-x / 2, -0.46 * x), (-y / 2, y / 2), (0, z))])
