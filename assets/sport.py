"""Things for sport: machines, weights, a bicycle."""

from math import cos, pi, sin

from thinkblox.assets.palette import (
    BLACK_GLASS,
    BLACK_PLASTIC,
    CHARCOAL_WOOL,
    CHROME,
    COGNAC,
    DARK_PLASTIC,
    GREY_METAL,
    IRON,
    SCREEN,
    STEEL,
    YELLOW_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    leg,
    prism,
    rod,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.value import Vec3


def treadmill(spec: Spec) -> Build:
    """Return a treadmill; its console is at +x, where the runner looks, who steps on from -x."""
    x, y, z = spec.size
    body = [
        box(DARK_PLASTIC, (-x / 2, x / 2 - 0.2), around(0, 0.62 * y), (0.1, 0.17)),
        box(BLACK_PLASTIC, (-x / 2 + 0.02, x / 2 - 0.25), around(0, 0.56 * y), (0.17, 0.174)),
        *(box(GREY_METAL, (-x / 2, x / 2 - 0.1), (s * 0.31 * y, s * 0.44 * y), (0.06, 0.19)) for s in (-1, 1)),
        cushion(DARK_PLASTIC, (x / 2 - 0.34, x / 2), around(0, 0.9 * y), (0.03, 0.28), radius=0.05),
        *(
            box(BLACK_PLASTIC, around(a, 0.1), around(s * 0.375 * y, 0.08), (0, 0.06))
            for a in (x / 2 - 0.3, 0.1 - x / 2)
            for s in (-1, 1)
        ),
        *(
            leg(GREY_METAL, (x / 2 - 0.2, s * 0.42 * y), (x / 2 - 0.1, s * 0.42 * y), (0.2, z - 0.16), 0.07, 0.05)
            for s in (-1, 1)
        ),
        cushion(DARK_PLASTIC, (x / 2 - 0.16, x / 2 - 0.04), around(0, y), (z - 0.3, z), radius=0.03),
        box(SCREEN, (x / 2 - 0.162, x / 2 - 0.16), around(0, 0.5 * y), (z - 0.24, z - 0.06), collide=False),
        *(
            cylinder(
                BLACK_PLASTIC, (x / 2 - 0.6, x / 2 - 0.1), around(s * 0.45 * y, 0.04), around(z - 0.28, 0.04), axis=0
            )
            for s in (-1, 1)
        ),
    ]
    return Build(body=body)


def exercise_bike(spec: Spec) -> Build:
    """Return an exercise bike, ridden towards +x."""
    x, y, z = spec.size
    front = x / 2
    body = [
        *(box(GREY_METAL, around(a, 0.06), (-y / 2, y / 2), (0, 0.06)) for a in (front - 0.08, 0.08 - x / 2)),
        box(GREY_METAL, (0.08 - x / 2, front - 0.08), around(0, 0.06), (0.06, 0.12)),
        cylinder(DARK_PLASTIC, around(front - 0.3, 0.46), around(0, 0.1), (0.1, 0.56), axis=1),
        cylinder(STEEL, around(front - 0.3, 0.3), around(0, 0.11), (0.18, 0.48), axis=1),
        rod(DARK_PLASTIC, (front - 0.36, 0, 0.4), (front - 0.22, 0, z - 0.1), 0.035),
        rod(DARK_PLASTIC, (0.36 - x / 2, 0, 0.1), (0.22 - x / 2, 0, 0.72 * z), 0.035),
        cushion(CHARCOAL_WOOL, (0.1 - x / 2, 0.38 - x / 2), around(0, 0.24), (0.72 * z, 0.78 * z), radius=0.03),
        cylinder(BLACK_PLASTIC, around(front - 0.2, 0.035), around(0, 0.9 * y), around(z - 0.12, 0.035), axis=1),
        box(BLACK_GLASS, (front - 0.21, front - 0.18), around(0, 0.22), (z - 0.12, z)),
        *(
            rod(DARK_PLASTIC, (front - 0.2, s * 0.4 * y, z - 0.12), (front - 0.4, s * 0.4 * y, z - 0.06), 0.017)
            for s in (-1, 1)
        ),
        *(
            box(BLACK_PLASTIC, around(0.02 - s * 0.14, 0.1), (s * 0.08, s * 0.2), around(0.3 + s * 0.08, 0.025))
            for s in (-1, 1)
        ),
        rod(GREY_METAL, (0.16, 0, 0.22), (-0.12, 0, 0.38), 0.018),
        box(DARK_PLASTIC, (0.3 - x / 2, front - 0.3), around(0, 0.07), (0.22, 0.36)),
    ]
    return Build(body=body)


def dumbbells(spec: Spec) -> Build:
    """Return a rack with two rows of dumbbells."""
    x, y, z = spec.size
    body: list[Part] = [box(IRON, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.04)), (0, 0.05)) for s in (-1, 1)]
    body += [box(IRON, (-x / 2, -x / 2 + 0.06), (s * y / 2, s * (y / 2 - 0.04)), (0.05, z)) for s in (-1, 1)]
    for row, (level, front) in enumerate(((0.35 * z, x / 2), (0.78 * z, 0.2 * x))):
        body.append(box(GREY_METAL, (front - 0.3, front), (-y / 2 + 0.04, y / 2 - 0.04), (level - 0.03, level)))
        body.append(box(GREY_METAL, (-x / 2 + 0.01, front - 0.3), around(0, y - 0.1), (level - 0.03, level)))
        count = int((y - 0.16) / 0.17)
        for k in range(count):
            at = -y / 2 + 0.08 + (k + 0.5) * (y - 0.16) / count
            r = 0.05 + 0.012 * row
            body += [
                cylinder(IRON, (a, a + 0.07), around(at, 2 * r), (level, level + 2 * r), axis=0)
                for a in (front - 0.27, front - 0.09)
            ]
            body.append(
                cylinder(CHROME, (front - 0.2, front - 0.09), around(at, 0.03), around(level + r, 0.03), axis=0)
            )
    return Build(body=body)


def bicycle(spec: Spec) -> Build:
    """Return a bicycle on its stand, riding to +x."""
    hub, reach = -spec.size[0] / 2 + _wheel_radius(spec.size), (-0.2, 0.2)
    stand = [rod(IRON, (hub + 0.1, 0, 0.3), (hub + 0.1, y, 0.012), 0.012, sides=8) for y in reach]
    return Build(body=_bicycle(spec, spec.size) + stand)


def wall_bicycle(spec: Spec) -> Build:
    """Return a bicycle hung flat on a wall by its top tube, riding to +y."""
    across, length, height = spec.size
    body = [turned(part, 2, 90.0, (0.0, 0.0, 0.0)) for part in _bicycle(spec, (length, across, height))]
    hooks = [box(IRON, (-across / 2, 0.03), around(y, 0.03), around(0.76 * height, 0.03)) for y in (0.0, 0.14 * length)]
    return Build(body=body + hooks)


def _wheel_radius(size: Vec3) -> float:
    return min(0.34, 0.33 * size[2])


def _bicycle(spec: Spec, size: Vec3) -> list[Part]:
    """A bicycle of a size, without a stand, riding to +x."""
    x, y, z = size
    r, paint = _wheel_radius(size), spec.main(Finish(spec.style.accent.colour, "metal"))
    parts: list[Part] = []
    hubs = (-x / 2 + r, x / 2 - r)
    for hub in hubs:
        parts += _wheel(hub, r)
    crank, seat, head = (-0.06 * x, 0.0, 0.28), (-0.15 * x, 0.0, 0.8 * z), (0.24 * x, 0.0, 0.84 * z)
    for a, b in (
        (crank, seat),
        (crank, head),
        (seat, head),
        ((hubs[0], 0.0, r), crank),
        ((hubs[0], 0.0, r), seat),
        ((hubs[1], 0.0, r), (0.22 * x, 0.0, z - 0.06)),
    ):
        parts.append(rod(paint, a, b, 0.016, sides=8))
    parts += [
        cushion(COGNAC, around(seat[0] - 0.03, 0.26), around(0, 0.15), (0.86 * z, 0.92 * z), radius=0.025),
        disc(CHROME, (seat[0], 0), 0.012, (0.78 * z, 0.86 * z)),
        cylinder(BLACK_PLASTIC, around(0.21 * x, 0.028), (-y / 2, y / 2), (z - 0.06, z - 0.032), axis=1),
        sphere(CHROME, (0.21 * x, 0, z - 0.02), 0.02),
        rod(CHROME, crank, (crank[0] + 0.12, 0.08, 0.2), 0.01, sides=6),
        rod(CHROME, crank, (crank[0] - 0.12, -0.08, 0.36), 0.01, sides=6),
        box(YELLOW_PLASTIC, around(0.3 * x, 0.04), around(0, 0.05), (0.74 * z, 0.79 * z)),
    ]
    return parts


def _wheel(hub: float, r: float) -> list[Part]:
    parts: list[Part] = [cylinder(CHROME, around(hub, 0.05), around(0, 0.09), around(r, 0.05), axis=1)]
    for k in range(16):
        a, b = 2 * pi * k / 16, 2 * pi * (k + 1) / 16
        inner, points = r - 0.04, []
        for t in (a, b):
            points += [(hub + r * sin(t), r - r * cos(t)), (hub + inner * sin(t), r - inner * cos(t))]
        parts.append(prism(BLACK_PLASTIC, points, (-0.02, 0.02), axis=1))
    parts += [
        rod(
            STEEL,
            (hub - (r - 0.03) * cos(t), 0, r - (r - 0.03) * sin(t)),
            (hub + (r - 0.03) * cos(t), 0, r + (r - 0.03) * sin(t)),
            0.003,
            sides=5,
        )
        for t in (0.2, 0.99, 1.77, 2.56)
    ]
    return parts


def weight_bench(spec: Spec) -> Build:
    """Return a padded bench on a steel frame with a barbell in its rack."""
    x, y, z = spec.size
    seat, rack = min(0.45, 0.5 * z), -x / 2 + 0.25
    parts = [
        cushion(CHARCOAL_WOOL, (-x / 2 + 0.1, x / 2), around(0, 0.28), (seat - 0.06, seat), radius=0.025),
        box(GREY_METAL, (-x / 2 + 0.1, x / 2 - 0.1), around(0, 0.06), (seat - 0.11, seat - 0.06)),
        box(GREY_METAL, around(x / 2 - 0.15, 0.06), around(0, 0.06), (0.03, seat - 0.11)),
        box(GREY_METAL, around(x / 2 - 0.15, 0.06), around(0, 0.5), (0, 0.03)),
    ]
    for s in (-1, 1):
        at = s * min(0.3 * y, 0.4)
        parts += [
            box(GREY_METAL, around(rack, 0.06), around(at, 0.06), (0.03, z - 0.225)),
            box(GREY_METAL, (-x / 2, rack + 0.3), around(at, 0.06), (0, 0.03)),
        ]
        for k, radius in enumerate((0.225, 0.16)):
            plate = (y / 2 - 0.16 + 0.045 * k, y / 2 - 0.12 + 0.045 * k)
            parts.append(_plate(IRON, rack, (s * plate[0], s * plate[1]), z - 0.225, radius))
    parts.append(
        box(
            GREY_METAL,
            around(rack, 0.05),
            (-min(0.3 * y, 0.4) + 0.03, min(0.3 * y, 0.4) - 0.03),
            (seat - 0.2, seat - 0.12),
        )
    )
    parts.append(_plate(CHROME, rack, (-y / 2, y / 2), z - 0.21, 0.014))
    return Build(body=parts, surfaces=[top_surface("seat", (rack + 0.05, x / 2 - 0.03), (-0.12, 0.12), seat)])


def _plate(finish: Finish, x: float, y: tuple[float, float], z: float, radius: float) -> Part:
    return cylinder(finish, around(x, 2 * radius), y, around(z, 2 * radius), axis=1)
