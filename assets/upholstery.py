"""Upholstered seats: sofas, armchairs, ottomans, bean bags. The back is at -x."""

from math import cos, pi, sin

from thinkblox.assets.part import Build, Finish, Part, Range, hull, moved, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    disc,
    ellipsoid,
    leg,
    oval,
    pad,
    prism,
    rod,
    round_leg,
    top_surface,
)
from thinkblox.assets.spec import Spec

FOOT = 0.12
"""Height of the feet under a sofa [m]."""


def sofa(spec: Spec) -> Build:
    """Return a sofa of separate cushions, one for each place; "corner" adds a chaise."""
    if spec.has("corner", "corner-sofa", "l-shaped", "sectional", "chaise"):
        return _corner_sofa(spec)
    x, y, z = spec.size
    places = 2 if y < 1.75 else 3 if y < 2.45 else 4
    return _seating(spec, (-x / 2, x / 2), (-y / 2, y / 2), z, places)


def armchair(spec: Spec) -> Build:
    """Return an armchair: a small sofa, or cushions in a light wooden frame."""
    x, y, z = spec.size
    if spec.rng.random() < 0.4:
        return _lounge_chair(spec)
    cover = spec.main(spec.choice((spec.style.accent, spec.style.fabric)))
    return _seating(spec, (-x / 2, x / 2), (-y / 2, y / 2), z, 1, cover)


def _seating(spec: Spec, x: Range, y: Range, z: float, places: int, cover: Finish | None = None) -> Build:
    cover = cover or spec.fabric
    arm = min(0.16, 0.09 * (y[1] - y[0]) + 0.04)
    seat, arm_top = min(0.44, 0.52 * z), min(0.6, 0.72 * z)
    inner = (y[0] + arm, y[1] - arm)
    build = Build()
    build.body = [
        cushion(cover, x, (a, b), (FOOT, arm_top), radius=0.045) for a, b in ((y[0], inner[0]), (inner[1], y[1]))
    ]
    build.body += [
        box(cover, (x[0] + 0.02, x[1] - 0.02), inner, (FOOT + 0.02, seat - 0.15)),
        cushion(cover, (x[0], x[0] + 0.16), inner, (FOOT, z - 0.06), radius=0.05),
    ]
    width = (inner[1] - inner[0]) / places
    for k in range(places):
        span = (inner[0] + k * width + 0.002, inner[0] + (k + 1) * width - 0.002)
        build.body.append(cushion(cover, (x[0] + 0.16, x[1] - 0.005), span, (seat - 0.15, seat), radius=0.045))
        back = cushion(cover, (x[0] + 0.14, x[0] + 0.3), span, (seat + 0.005, z), radius=0.06)
        build.body.append(turned(back, 1, -8.0, (x[0] + 0.2, 0.0, seat)))
    build.body += _sofa_feet(spec, x, y)
    if places > 1:
        build.body += _throw_pillows(spec, x[0] + 0.38, inner, seat)
    build.surfaces = [top_surface("seat", (x[0] + 0.38, x[1] - 0.04), (inner[0] + 0.03, inner[1] - 0.03), seat)]
    return build


def _sofa_feet(spec: Spec, x: Range, y: Range) -> list[Part]:
    finish = spec.style.wood if spec.rng.random() < 0.7 else spec.style.metal
    ends = [(a, b) for a in (x[0] + 0.08, x[1] - 0.08) for b in (y[0] + 0.09, y[1] - 0.09)]
    return [round_leg(finish, at, at, (0, FOOT), 0.014, 0.024) for at in ends]


def _throw_pillows(spec: Spec, x: float, y: Range, seat: float) -> list[Part]:
    size, ends = 0.4, [y[0] + 0.02]
    if spec.rng.random() < 0.6:
        ends.append(y[1] - 0.02 - size)
    return [_leaning(spec.style.accent, x, (low, low + size), seat) for low in ends]


def _leaning(finish: Finish, x: float, y: Range, seat: float) -> Part:
    """A loose cushion that stands on a seat and leans against the back."""
    flat = pad(finish, (x, x + y[1] - y[0]), y, (seat + 0.03, seat + 0.15), edge=0.4)
    return turned(flat, 1, -106.0, (x + 0.02, 0.0, seat + 0.02))


def _corner_sofa(spec: Spec) -> Build:
    x, y, z = spec.size
    depth = min(0.95, 0.62 * x)
    side = 1 if spec.has("left") else -1
    cover = spec.fabric
    build = _seating(spec, (-x / 2, -x / 2 + depth), (-y / 2, y / 2), z, 3 if y < 2.7 else 4, cover)
    seat = min(0.44, 0.52 * z)
    width = min(0.95, 0.4 * y)
    span = (side * (y / 2 - width), side * y / 2)
    span = (min(span), max(span))
    ahead = (-x / 2 + depth - 0.004, x / 2)
    build.body += [
        box(cover, (ahead[0], ahead[1] - 0.02), (span[0] + 0.02, span[1] - 0.02), (FOOT + 0.02, seat - 0.15)),
        cushion(cover, ahead, span, (seat - 0.15, seat), radius=0.045),
    ]
    build.body += [
        round_leg(spec.style.wood, (ahead[1] - 0.09, at), (ahead[1] - 0.09, at), (0, FOOT + 0.02), 0.014, 0.024)
        for at in (span[0] + 0.09, span[1] - 0.09)
    ]
    build.surfaces.append(
        top_surface("chaise", (ahead[0] + 0.05, ahead[1] - 0.05), (span[0] + 0.05, span[1] - 0.05), seat)
    )
    return build


def recliner(spec: Spec) -> Build:
    """Return a padded armchair that is tilted back, its footrest out."""
    x, y, z = spec.size
    depth = 0.78 * x
    cover = spec.fabric if spec.has("fabric") or spec.words else Finish((0.40, 0.26, 0.18), "leather")
    build = _seating(spec, (-x / 2, -x / 2 + depth), (-y / 2, y / 2), z, 1, cover)
    seat, ahead = min(0.44, 0.52 * z), -x / 2 + depth
    wide = 0.62 * y
    rest = cushion(cover, (ahead + 0.01, x / 2), around(0, wide), (seat - 0.13, seat - 0.02), radius=0.04)
    build.body += [
        turned(rest, 1, 9.0, (ahead, 0.0, seat)),
        *(
            rod(
                Finish((0.3, 0.3, 0.32), "metal"),
                (ahead - 0.06, s * 0.3 * wide, 0.2),
                (x / 2 - 0.1, s * 0.3 * wide, seat - 0.16),
                0.015,
            )
            for s in (-1, 1)
        ),
        rod(spec.style.wood, (ahead - 0.3, y / 2 - 0.01, 0.36), (ahead - 0.38, y / 2 - 0.01, 0.47), 0.012),
    ]
    return build


def chaise(spec: Spec) -> Build:
    """Return a long seat to lie on, raised at its back end at -x, with one arm."""
    x, y, z = spec.size
    cover, seat = spec.fabric, 0.5 * z
    back = cushion(cover, (-x / 2 + 0.02, -x / 2 + 0.2), around(0, y - 0.02), (seat - 0.1, z), radius=0.06)
    arm = (-x / 2 + 0.1, -0.1 * x)
    build = Build(
        body=[
            cushion(cover, (-x / 2, x / 2), (-y / 2, y / 2), (FOOT, seat), radius=0.06),
            turned(back, 1, -14.0, (-x / 2 + 0.12, 0.0, seat)),
            cushion(cover, arm, (y / 2 - 0.14, y / 2), (seat - 0.08, 0.5 * (seat + z)), radius=0.05),
            *_sofa_feet(spec, (-x / 2, x / 2), (-y / 2, y / 2)),
        ]
    )
    build.surfaces = [top_surface("seat", (-0.2 * x, 0.46 * x), (-0.42 * y, 0.4 * y - 0.1), seat)]
    return build


def floor_cushion(spec: Spec) -> Build:
    """Return a thick cushion to sit on the floor on."""
    x, y, z = spec.size
    cover = spec.main(spec.choice((spec.style.accent, spec.style.fabric)))
    shape = [cushion(cover, (-x / 2, x / 2), (-y / 2, y / 2), (0, z), radius=0.45 * z)]
    if spec.has("round", "circular"):
        rims = ((1.0, 0.25, 0.75), (0.96, 0.1, 0.9), (0.88, 0.0, 1.0))
        shape = [prism(cover, oval(share * x, share * y), (low * z, high * z)) for share, low, high in rims]
    return Build(body=shape, surfaces=[top_surface("top", around(0, 0.6 * x), around(0, 0.6 * y), z)])


def salon_chair(spec: Spec) -> Build:
    """Return a barber's or stylist's chair: arms, a footrest, and a column on a round foot."""
    x, y, z = spec.size
    cover, chrome = spec.main(Finish((0.13, 0.13, 0.14), "leather")), Finish((0.80, 0.81, 0.83), "metal")
    seat = 0.54 * z
    back = cushion(cover, (-0.34 * x, -0.22 * x), around(0, 0.74 * y), (seat - 0.02, z), radius=0.04)
    body: list[Part] = [
        disc(chrome, (-0.06 * x, 0), min(0.42 * x, 0.48 * y), (0, 0.04 * z)),
        disc(chrome, (-0.06 * x, 0), 0.05, (0.04 * z, seat - 0.12)),
        cushion(cover, (-0.34 * x, 0.24 * x), around(0, 0.76 * y), (seat - 0.12, seat), radius=0.04),
        turned(back, 1, -7.0, (-0.28 * x, 0.0, seat)),
        *(
            cushion(cover, (-0.3 * x, 0.2 * x), around(s * 0.46 * y, 0.08 * y), (seat + 0.16, seat + 0.21), radius=0.02)
            for s in (-1, 1)
        ),
        *(
            box(chrome, (-0.1 * x, 0.02 * x), around(s * 0.44 * y, 0.03 * y), (seat - 0.1, seat + 0.16))
            for s in (-1, 1)
        ),
        box(chrome, (-0.1 * x, 0.02 * x), around(0, 0.9 * y), (seat - 0.13, seat - 0.1)),
        *(rod(chrome, (0.12 * x, s * 0.2 * y, seat - 0.1), (0.42 * x, s * 0.2 * y, 0.2 * z), 0.014) for s in (-1, 1)),
        box(chrome, (0.34 * x, x / 2), around(0, 0.6 * y), (0.17 * z, 0.2 * z)),
    ]
    return Build(body=body, surfaces=[top_surface("seat", (-0.18 * x, 0.2 * x), around(0, 0.62 * y), seat)])


def _lounge_chair(spec: Spec) -> Build:
    x, y, z = spec.size
    seat, cover, frame = min(0.42, 0.5 * z), spec.main(spec.style.accent), spec.style.wood
    inner = (-y / 2 + 0.05, y / 2 - 0.05)
    build = Build()
    for side in (-1, 1):
        at = side * (y / 2 - 0.0225)
        build.body += [
            leg(frame, (x / 2 - 0.03, at), (x / 2 - 0.06, at), (0, 0.6), 0.028, 0.04),
            leg(frame, (-x / 2 + 0.03, at), (-x / 2 + 0.11, at), (0, 0.6), 0.028, 0.04),
            cushion(frame, (-x / 2 + 0.04, x / 2), around(at, 0.045), (0.6, 0.63), radius=0.01),
            box(frame, (-x / 2 + 0.1, x / 2 - 0.05), around(at, 0.025), (seat - 0.18, seat - 0.12)),
        ]
    build.body += [
        box(frame, around(a, 0.03), inner, (seat - 0.18, seat - 0.13)) for a in (-x / 2 + 0.12, x / 2 - 0.08)
    ]
    build.body.append(cushion(cover, (-x / 2 + 0.12, x / 2 - 0.02), inner, (seat - 0.13, seat), radius=0.04))
    back = cushion(cover, (-x / 2 + 0.08, -x / 2 + 0.2), inner, (seat - 0.02, z), radius=0.045)
    build.body.append(turned(back, 1, -12.0, (-x / 2 + 0.14, 0.0, seat)))
    build.surfaces = [top_surface("seat", (-x / 2 + 0.24, x / 2 - 0.07), (inner[0] + 0.04, inner[1] - 0.04), seat)]
    return build


def rocking_chair(spec: Spec) -> Build:
    """Return a lounge chair on two runners that are flat where they touch the floor."""
    x, y, z = spec.size
    upper = _lounge_chair(Spec(spec.category, (0.8 * x, y, z - 0.06), spec.words, spec.style, spec.rng))
    runners: list[Part] = []
    for side in (-1, 1):
        at = around(side * (y / 2 - 0.0225), 0.03)
        middle = [(-0.22 * x, 0.0), (0.22 * x, 0.0), (0.34 * x, 0.065), (-0.34 * x, 0.065)]
        runners.append(prism(spec.style.wood, middle, at, axis=1))
        for s in (-1, 1):
            tip = [(s * 0.22 * x, 0.0), (s * x / 2, 0.07), (s * x / 2, 0.1), (s * 0.34 * x, 0.065)]
            runners.append(prism(spec.style.wood, tip, at, axis=1))
    body = [moved(p, (0.0, 0.0, 0.06)) for p in upper.body]
    seat = upper.surfaces[0]
    px, py, pz = seat.position
    area = ((px - seat.size[0] / 2, px + seat.size[0] / 2), (py - seat.size[1] / 2, py + seat.size[1] / 2))
    return Build(body=runners + body, surfaces=[top_surface("seat", *area, pz + 0.06)])


def ottoman(spec: Spec) -> Build:
    """Return a footstool: a thick cushion on short legs, round when asked for."""
    x, y, z = spec.size
    cover = spec.main(spec.style.accent)
    if spec.has("round") or (spec.rng.random() < 0.4 and abs(x - y) < 0.05):
        radius = min(x, y) / 2
        body: list[Part] = [
            disc(cover, (0, 0), radius, (0.03, z)),
            disc(spec.style.wood, (0, 0), radius - 0.03, (0, 0.03)),
        ]
        return Build(
            body=body, surfaces=[top_surface("top", (-radius, radius), (-radius, radius), z, round=True)], front="any"
        )
    feet = [(sx * (x / 2 - 0.07), sy * (y / 2 - 0.07)) for sx in (-1, 1) for sy in (-1, 1)]
    body = [cushion(cover, (-x / 2, x / 2), (-y / 2, y / 2), (0.1, z), radius=0.05)]
    body += [leg(spec.style.wood, at, at, (0, 0.1), 0.025, 0.04) for at in feet]
    return Build(
        body=body, surfaces=[top_surface("top", (-x / 2 + 0.04, x / 2 - 0.04), (-y / 2 + 0.04, y / 2 - 0.04), z)]
    )


def bean_bag(spec: Spec) -> Build:
    """Return a soft bag, flat below, higher at the back."""
    x, y, z = spec.size
    cover = spec.main(spec.style.accent)
    rings = (
        (0.0, 0.42, 0.42, 0.0),
        (0.25, 0.5, 0.5, 0.0),
        (0.5, 0.42, 0.44, -0.04),
        (0.8, 0.22, 0.26, -0.16),
        (1.0, 0.08, 0.1, -0.22),
    )
    points = [
        (x * (shift + rx * cos(2 * pi * k / 20)), y * ry * sin(2 * pi * k / 20), h * z)
        for h, rx, ry, shift in rings
        for k in range(20)
    ]
    return Build(
        body=[
            hull(cover, points, smooth=True),
            ellipsoid(cover, (-0.24 * x - 0.04, -0.24 * x + 0.04), around(0, 0.1), (z - 0.06, z)),
        ]
    )
