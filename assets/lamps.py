"""Lamps: a foot, a pole and a shade; pendants hang from the ceiling, so that their top is at the ceiling."""

from math import cos, pi, sin

from thinkblox.assets.palette import GLOW, IRON, LINEN, SHADE, WHITE_PAINT
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import around, box, cylinder, disc, ellipsoid, frustum, profile, rod, sphere
from thinkblox.assets.spec import Spec

_BAR = 1.7
"""What is so many times as wide as it is deep is a bar."""


def floor_lamp(spec: Spec) -> Build:
    """Return a standing lamp: a drum shade on a pole or on a tripod."""
    x, y, z = spec.size
    radius, drop, metal = min(x, y) / 2, 0.17 * z, spec.main(spec.style.metal)
    shade = frustum(SHADE, (0, 0), (z - drop, z), radius, 0.78 * radius)
    if spec.rng.random() < 0.35:
        feet = [(0.8 * radius * cos(a), 0.8 * radius * sin(a)) for a in (0, 2 * pi / 3, 4 * pi / 3)]
        legs = [
            rod(spec.style.wood, (fx, fy, 0.008), (0.1 * fx, 0.1 * fy, z - drop - 0.02), 0.013, end_radius=0.009)
            for fx, fy in feet
        ]
        return Build(body=[*legs, disc(metal, (0, 0), 0.035, (z - drop - 0.05, z - drop)), shade])
    body = [disc(metal, (0, 0), 0.66 * radius, (0, 0.02)), disc(metal, (0, 0), 0.011, (0.02, z - drop)), shade]
    return Build(body=body)


def table_lamp(spec: Spec) -> Build:
    """Return a lamp with a ceramic or wooden body and a fabric shade."""
    x, y, z = spec.size
    radius, split = min(x, y) / 2, 0.55 * z
    finish = spec.main(spec.choice((spec.style.glaze, spec.style.wood, spec.style.metal)))
    kind = spec.choice(("bulb", "column", "cone"))
    if kind == "bulb":
        rings = [
            (0.0, 0.4 * radius),
            (0.12 * split, 0.62 * radius),
            (0.45 * split, 0.72 * radius),
            (0.72 * split, 0.42 * radius),
            (0.88 * split, 0.16 * radius),
        ]
    elif kind == "cone":
        rings = [(0.0, 0.56 * radius), (0.05 * split, 0.56 * radius), (0.88 * split, 0.14 * radius)]
    else:
        rings = [
            (0.0, 0.58 * radius),
            (0.08 * split, 0.58 * radius),
            (0.081 * split, 0.2 * radius),
            (0.88 * split, 0.2 * radius),
        ]
    base = 0.006
    body = [disc(finish, (0, 0), rings[0][1], (0, base))]
    body += profile(finish, (0, 0), [(max(h, base), r) for h, r in rings], round=kind == "bulb")
    body.append(disc(spec.style.metal, (0, 0), 0.008, (0.88 * split, split)))
    return Build(body=[*body, frustum(SHADE, (0, 0), (split, z), radius, 0.7 * radius)])


def desk_lamp(spec: Spec) -> Build:
    """Return a jointed reading lamp; its light is on the +x side."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((spec.style.metal, IRON)))
    foot = min(0.5 * y, 0.35 * x)
    radius = min(0.05, 0.28 * y)  # a wider shade would tip a small lamp over
    at, elbow, head = -0.16 * x, (-x / 2 + 0.014, 0.0, 0.55 * z), (x / 2 - radius, 0.0, z - 0.03)
    body = [
        disc(finish, (at, 0), foot, (0, 0.03)),
        rod(finish, (at, 0, 0.03), elbow, 0.008),
        sphere(finish, elbow, 0.014),
        rod(finish, elbow, head, 0.008),
        frustum(finish, (head[0], 0), (z - 0.085, z), radius, 0.4 * radius),
        disc(GLOW, (head[0], 0), 0.8 * radius, (z - 0.09, z - 0.085)),
    ]
    return Build(body=body)


def pendant_lamp(spec: Spec) -> Build:
    """Return a lamp that hangs on a cord: a cone, a dome or a globe; a long one is a bar that hangs on two."""
    x, y, z = spec.size
    if y > _BAR * x:
        return _bar_lamp(spec)
    radius = min(x, y) / 2
    deep = min(0.5 * z, 1.1 * radius)
    metal = spec.main(spec.choice((spec.style.metal, spec.style.glaze, IRON)))
    body: list[Part] = [disc(IRON, (0, 0), 0.004, (deep, z - 0.025)), disc(metal, (0, 0), 0.05, (z - 0.025, z))]
    kind = spec.choice(("cone", "globe", "dome"))
    if kind == "globe":
        deep = 2 * radius
        body[0] = disc(IRON, (0, 0), 0.004, (deep, z - 0.025))
        return Build(body=[*body, ellipsoid(SHADE, (-radius, radius), (-radius, radius), (0, deep))])
    if kind == "cone":
        body.append(frustum(metal, (0, 0), (0.01, deep), radius, 0.16 * radius))
    else:
        body += profile(
            metal,
            (0, 0),
            [(0.01, radius), (0.45 * deep, 0.86 * radius), (0.8 * deep, 0.5 * radius), (deep, 0.14 * radius)],
        )
    return Build(body=[*body, disc(GLOW, (0, 0), 0.88 * radius, (0, 0.01))])


def _bar_lamp(spec: Spec) -> Build:
    x, y, z = spec.size
    metal, high = spec.main(spec.choice((spec.style.metal, spec.style.glaze, IRON))), min(0.12, 0.3 * z)
    body: list[Part] = [
        box(metal, (-x / 2, x / 2), (-y / 2, y / 2), (0.012, high)),
        box(GLOW, around(0, 0.86 * x), around(0, 0.94 * y), (0, 0.012)),
        box(metal, around(0, 0.6 * x), around(0, 0.5 * y), (z - 0.025, z)),
    ]
    body += [disc(IRON, (0, side * 0.2 * y), 0.004, (high, z - 0.025)) for side in (-1, 1)]
    return Build(body=body)


def ceiling_lamp(spec: Spec) -> Build:
    """Return a flat round lamp on the ceiling."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    metal = spec.main(spec.style.metal)
    return Build(body=[disc(metal, (0, 0), 0.9 * radius, (0.6 * z, z)), disc(SHADE, (0, 0), radius, (0, 0.6 * z))])


def chandelier(spec: Spec) -> Build:
    """Return a ring of candle-like lights under a stem."""
    x, y, z = spec.size
    metal, radius = spec.main(spec.style.metal), min(x, y) / 2 - 0.03
    body: list[Part] = [
        disc(metal, (0, 0), 0.012, (0.1, z - 0.03)),
        disc(metal, (0, 0), 0.06, (z - 0.03, z)),
        sphere(metal, (0, 0, 0.05), 0.05),
    ]
    for k in range(8):
        at = (radius * cos(pi * k / 4), radius * sin(pi * k / 4))
        body += [
            rod(metal, (0, 0, 0.08), (at[0], at[1], 0.14), 0.008),
            disc(metal, at, 0.03, (0.135, 0.15)),
            disc(LINEN, at, 0.012, (0.15, 0.23)),
            ellipsoid(GLOW, around(at[0], 0.036), around(at[1], 0.036), (0.23, 0.29)),
        ]
    return Build(body=body)


def wall_lamp(spec: Spec) -> Build:
    """Return a lamp on a short arm."""
    x, y, z = spec.size
    metal, radius = spec.main(spec.style.metal), min(0.45 * x, 0.5 * y)
    at = x / 2 - radius
    return Build(
        body=[
            cylinder(metal, (-x / 2, -x / 2 + 0.02), around(0, 0.09), around(0.3 * z, 0.09), axis=0),
            box(metal, (-x / 2 + 0.02, at), around(0, 0.015), around(0.3 * z, 0.015)),
            disc(metal, (at, 0), 0.012, (0, 0.42 * z)),
            frustum(SHADE, (at, 0), (0.42 * z, z), radius, 0.7 * radius),
        ]
    )


def candle(spec: Spec) -> Build:
    """Return a thick candle on a small plate."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    wax = spec.main(Finish(WHITE_PAINT.colour, "plastic"))
    return Build(
        body=[
            disc(spec.style.metal, (0, 0), radius, (0, 0.008)),
            disc(wax, (0, 0), 0.78 * radius, (0.008, z - 0.02)),
            ellipsoid(GLOW, around(0, 0.008), around(0, 0.008), (z - 0.02, z)),
        ]
    )
