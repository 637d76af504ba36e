"""Plain solids that stand for small things: each fills its box, in one finish with an accent."""

from math import cos, pi, sin

from thinkblox.assets.books import open_book, shut_book
from thinkblox.assets.part import Build, Finish, Part, hull
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    disc,
    inner_surface,
    oval,
    pad,
    prism,
    profile,
    rod,
    shell,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.value import Vec2

_TRAY = 0.13
"""What is no higher is a tray: what lies in it is also on it [m]."""
_FLAT = 16
"""Sides of what lies rolled up, one of them level underneath so that it stays."""


def block(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a box with rounded edges and a label on its front."""
    x, y, z = spec.size
    thin = min(0.001, 0.05 * x)
    body = cushion(spec.main(main), (-x / 2, x / 2 - thin), (-y / 2, y / 2), (0, z), radius=0.06 * min(x, y, z))
    label = box(accent, (x / 2 - 2 * thin, x / 2), around(0, 0.6 * y), (0.25 * z, 0.75 * z), collide=False)
    return Build(body=[body, label])


def slab(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a thin plate with rounded edges, lying or upright, with a field of the accent on its broad side."""
    x, y, z = spec.size
    lying = z <= min(x, y)
    thin = 0.08 * min(x, z)
    top = z - thin if lying else z
    front = x / 2 if lying else x / 2 - thin
    body = cushion(spec.main(main), (-x / 2, front), (-y / 2, y / 2), (0, top), radius=0.3 * min(x, y, z))
    inner = around(0, 0.75 * y)
    if lying:
        field = box(accent, around(0, 0.75 * x), inner, (top - thin, z), collide=False)
    else:
        field = box(accent, (front - thin, x / 2), inner, (0.12 * z, 0.88 * z), collide=False)
    return Build(body=[body, field])


def tome(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a book that lies, its title in the accent on its cover, or an "open" one."""
    x, y, z = spec.size
    if spec.has("open"):
        return Build(body=open_book(spec.main(main), spec.size))
    title = box(accent, around(0, 0.3 * x), around(0, 0.5 * y), (z - 0.0005, z + 0.0005), collide=False)
    body = shut_book(spec.main(main), (-x / 2, x / 2), (-y / 2, y / 2), (0, z))
    return Build(body=[*body, title], surfaces=[top_surface("cover", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def can(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return an upright cylinder with a lid."""
    x, y, z = spec.size
    r = min(x, y) / 2
    return Build(body=[disc(spec.main(main), (0, 0), r, (0, 0.88 * z)), disc(accent, (0, 0), 0.92 * r, (0.88 * z, z))])


def roll(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a cylinder that lies across, with ends of the accent."""
    x, y, z = spec.size
    outline = [
        (x / 2 * cos(2 * pi * (k + 0.5) / _FLAT), z / 2 + z / 2 * sin(2 * pi * (k + 0.5) / _FLAT)) for k in range(_FLAT)
    ]
    inner = [(0.7 * a, z / 2 + 0.7 * (b - z / 2)) for a, b in outline]
    body = [prism(spec.main(main), outline, around(0, 0.98 * y), axis=1, smooth=True)]
    body.append(prism(accent, inner, around(0, y), axis=1))
    return Build(body=body)


def ball(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a ball that stands on a small flat and carries a cap of the accent, a stalk or a valve."""
    x, y, z = spec.size
    stem = disc(accent, (0, 0), 0.06 * min(x, y), (0.9 * z, z))
    return Build(body=[_globe(spec.main(main), (x, y), 0.0, 0.98 * z), stem], front="any")


def _globe(finish: Finish, extent: Vec2, low: float, high: float) -> Part:
    """An ellipsoid between two heights, cut level underneath so that it does not roll."""
    points = []
    for ring in range(9):
        angle = pi * (0.12 + 0.88 * ring / 8)
        share = sin(angle) if ring < 8 else 0.0
        level = (cos(0.12 * pi) - cos(angle)) / (cos(0.12 * pi) + 1)
        points += [(a * share, b * share, low + level * (high - low)) for a, b in oval(*extent, sides=20)]
    return hull(finish, points, smooth=True)


def dome(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a half ball with a knob on top."""
    x, y, z = spec.size
    points = []
    for ring in range(6):
        share, level = cos(0.5 * pi * ring / 5.2), sin(0.5 * pi * ring / 5.2) / sin(0.5 * pi * 5 / 5.2)
        points += [(a * share, b * share, 0.92 * z * level) for a, b in oval(x, y, sides=20)]
    knob = disc(accent, (0, 0), 0.08 * min(x, y), (0.85 * z, z))
    return Build(body=[hull(spec.main(main), points, smooth=True), knob], front="any")


def bowl(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round vessel that is open at the top, with something of the accent in it."""
    x, y, z = spec.size
    r, finish = min(x, y) / 2, spec.main(main)
    wall = max(0.004, 0.05 * r)
    body = shell(finish, (0, 0), (0.06 * z, z), 0.68 * r, r, wall)
    body += [disc(finish, (0, 0), 0.62 * r, (0, 0.1 * z)), disc(accent, (0, 0), 0.64 * r, (0.1 * z, 0.2 * z))]
    return Build(body=body, front="any")


def bucket(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round vessel with a steep wall that is open at the top."""
    x, y, z = spec.size
    r, finish = min(x, y) / 2, spec.main(main)
    wall = max(0.004, 0.05 * r)
    body = shell(finish, (0, 0), (0, 0.96 * z), 0.82 * r, 0.97 * r, wall)
    body += [disc(finish, (0, 0), 0.8 * r, (0, 0.05 * z))]
    body += shell(accent, (0, 0), (0.93 * z, z), 0.99 * r, r, wall)
    return Build(body=body, front="any")


def pot(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round pot with a lid, a knob and two handles."""
    x, y, z = spec.size
    r = 0.42 * min(x, y)
    finish = spec.main(main)
    body: list[Part] = [
        disc(finish, (0, 0), r, (0, 0.78 * z)),
        disc(finish, (0, 0), 0.94 * r, (0.78 * z, 0.86 * z)),
        disc(accent, (0, 0), 0.15 * r, (0.86 * z, z)),
    ]
    body += [box(accent, around(0, 0.3 * x), (s * 0.9 * r, s * y / 2), (0.56 * z, 0.68 * z)) for s in (-1, 1)]
    return Build(body=body)


def pan(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round flat vessel with a long handle to one side."""
    x, y, z = spec.size
    r, finish = min(x / 2, 0.32 * y), spec.main(main)
    at = -y / 2 + r
    body: list[Part] = [disc(finish, (0, at), 0.92 * r, (0, 0.16 * z))]
    body += shell(finish, (0, at), (0, 0.9 * z), 0.92 * r, r, max(0.004, 0.05 * r))
    body.append(box(accent, around(0, 0.12 * x), (at + 0.95 * r, y / 2), (0.6 * z, z)))
    return Build(body=body)


def bottle(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round body that narrows to a neck with a cap."""
    x, y, z = spec.size
    r = min(x, y) / 2
    rings: list[Vec2] = [(0, 0.92 * r), (0.04 * z, r), (0.58 * z, r), (0.76 * z, 0.4 * r), (0.88 * z, 0.36 * r)]
    body = profile(spec.main(main), (0, 0), rings, sides=16)
    return Build(body=[*body, disc(accent, (0, 0), 0.4 * r, (0.88 * z, z))], front="any")


def jug(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round body with a spout and a handle."""
    x, y, z = spec.size
    r, finish = min(0.36 * y, x / 2), spec.main(main)
    rings: list[Vec2] = [(0, 0.8 * r), (0.3 * z, r), (0.75 * z, 0.68 * r), (0.96 * z, 0.76 * r)]
    body = profile(finish, (0, 0), rings, sides=16)
    body.append(disc(accent, (0, 0), 0.6 * r, (0.96 * z, z)))
    body += [
        box(finish, around(0, 0.16 * r), (0.6 * r, y / 2), (0.76 * z, 0.86 * z)),
        box(finish, around(0, 0.16 * r), (0.42 * y, y / 2), (0.3 * z, 0.78 * z)),
        rod(finish, (0, -0.8 * r, 0.55 * z), (0, -y / 2 + 0.12 * r, 0.85 * z), 0.12 * r),
    ]
    return Build(body=body)


def cone(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a cone on a flat foot with a band of the accent."""
    x, y, z = spec.size
    r = min(x, y) / 2
    rings: list[Vec2] = [(0.05 * z, 0.78 * r), (0.4 * z, 0.52 * r)]
    band: list[Vec2] = [(0.4 * z, 0.52 * r), (0.65 * z, 0.34 * r)]
    tip: list[Vec2] = [(0.65 * z, 0.34 * r), (z, 0.1 * r)]
    finish = spec.main(main)
    body = [*profile(finish, (0, 0), rings), *profile(accent, (0, 0), band), *profile(finish, (0, 0), tip)]
    return Build(body=[cushion(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.06 * z), radius=0.01), *body])


def wedge(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a body that slopes down to its front, with a foot of the accent."""
    x, y, z = spec.size
    outline = [(-x / 2, 0.1 * z), (x / 2, 0.1 * z), (x / 2, 0.25 * z), (-0.2 * x, z), (-x / 2, z)]
    return Build(
        body=[
            box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.1 * z)),
            prism(spec.main(main), outline, (-y / 2, y / 2), axis=1),
        ]
    )


def gable(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a ridged roof down to the ground that is open at its front, such as a tent, on a floor of the accent."""
    x, y, z = spec.size
    thin = min(0.03, 0.05 * min(x, y))
    body = [box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.5 * thin))]
    for s in (-1, 1):
        slope = [(s * y / 2, 0.0), (s * (y / 2 - 2 * thin), 0.0), (0.0, z - 2 * thin), (0.0, z)]
        body.append(prism(spec.main(main), slope, (-x / 2, x / 2), axis=0))
    back = [(-0.48 * y, 0.0), (0.48 * y, 0.0), (0.0, 0.94 * z)]
    body.append(prism(spec.main(main), back, (-x / 2, -x / 2 + thin), axis=0))
    return Build(body=body)


def soft(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a soft body with a level underside and a seam of the accent."""
    x, y, z = spec.size
    body = pad(spec.main(main), (-x / 2, x / 2), (-y / 2, y / 2), (0, z), flat=True)
    seam = box(accent, around(0, 0.9 * x), around(0, 0.9 * y), (0.04 * z, 0.1 * z), collide=False)
    return Build(body=[body, seam])


def cloth(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a folded cloth of a few layers, one of them of the accent."""
    x, y, z = spec.size
    finish, step = spec.main(main), z / 4
    layers = [
        cushion(
            accent if k == 2 else finish,
            around(0.004 * k * x, (1 - 0.02 * k) * x),
            around(0, (1 - 0.01 * k) * y),
            (k * step, (k + 1) * step),
            radius=0.45 * step,
        )
        for k in range(4)
    ]
    return Build(body=[*layers])


def heap(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a pile of soft or round pieces in the finish and its accent."""
    x, y, z = spec.size
    finish = spec.main(main)
    body = [pad(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.45 * z), flat=True)]
    for k, (a, b, top) in enumerate(((-0.2, -0.18, 0.85), (0.18, -0.1, 0.75), (0.0, 0.2, 1.0), (-0.16, 0.16, 0.7))):
        part = pad(
            accent if k % 2 else finish,
            around(a * x, 0.5 * x),
            around(b * y, 0.5 * y),
            (0.2 * z, top * z),
        )
        body.append(part)
    return Build(body=body, front="any")


def stack(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return flat pieces in a stack, one and the next of the accent by turns."""
    x, y, z = spec.size
    finish, count = spec.main(main), 5
    return Build(
        body=[
            box(
                accent if k % 2 else finish,
                around(0, (0.94 if k % 2 else 1.0) * x),
                around(0, (0.96 if k % 2 else 1.0) * y),
                (k * z / count, (k + 1) * z / count),
            )
            for k in range(count)
        ]
    )


def stick(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return something long and thin that lies across, with a tip of the accent."""
    x, y, z = spec.size
    edge = 0.3 * min(x, z)
    body = cushion(spec.main(main), (-x / 2, x / 2), (-y / 2, 0.4 * y), (0, z), radius=edge)
    return Build(body=[body, cushion(accent, around(0, 0.9 * x), (0.4 * y, y / 2), (0, 0.9 * z), radius=edge)])


def tool(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a handle that lies across, with a broad head of the main finish."""
    x, y, z = spec.size
    grip = min(0.3 * x, z)
    body = [
        cushion(accent, around(0, grip), (-y / 2, 0.28 * y), (0, min(z, grip)), radius=0.3 * grip),
        cushion(spec.main(main), (-x / 2, x / 2), (0.24 * y, y / 2), (0, z), radius=0.2 * min(x, z)),
    ]
    return Build(body=body)


def ring(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a ring, lying, or upright on one of its flat sides, with an accent at its front or top."""
    x, y, z = spec.size
    upright = z > x
    across, depth = (z, x) if upright else (x, z)
    count, wall = 12, 0.17
    body: list[Part] = []
    for k in range(count):
        angles = [2 * pi * (k + step) / count for step in (-0.5, 0.5)]
        finish = accent if k == count // 4 else spec.main(main)
        corners = [(r * cos(a) * y, r * sin(a) * across) for a in angles for r in (0.5 - wall, 0.5)]
        if upright:
            points = [(d, u, v + z / 2) for u, v in corners for d in (-depth / 2, depth / 2)]
        else:
            points = [(v, u, d) for u, v in corners for d in (0.0, depth)]
        body.append(hull(finish, points))
    return Build(body=body)


def tyre(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a wheel lying with its rim of the accent; upright it is a ring, which does not roll.

    It is solid: of many that lie on each other, rings touch in hundreds of points.
    """
    x, y, z = spec.size
    if z > x:
        return ring(spec, main, accent)
    r, thin = min(x, y) / 2, 0.02 * z
    rubber = spec.main(main)
    rim = disc(accent, (0, 0), 0.55 * r, (z - thin, z), collide=False)
    hub = disc(rubber, (0, 0), 0.14 * r, (z - 0.5 * thin, z), collide=False)
    return Build(body=[disc(rubber, (0, 0), r, (0, z - thin)), rim, hub])


def crate(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a box that is open at the top; things can be put into it, and on it where it is as low as a tray.

    When "closed" it has a lid that carries.
    """
    x, y, z = spec.size
    wall = max(0.003, min(0.02, 0.06 * min(x, y)))
    floor = max(0.003, min(0.02, 0.12 * z))
    finish = spec.main(main)
    body = [
        *(box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), (0, z)) for s in (-1, 1)),
        *(box(finish, (s * x / 2, s * (x / 2 - wall)), around(0, y - 2 * wall), (0, z)) for s in (-1, 1)),
        box(accent, around(0, x - 2 * wall), around(0, y - 2 * wall), (0, floor)),
    ]
    inner = (around(0, x - 2 * wall), around(0, y - 2 * wall))
    surfaces = [inner_surface("inside", *inner, floor)]
    if spec.has("closed") and z > _TRAY:
        lid = box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (z, z + floor))
        return Build(body=[*body, lid], surfaces=[top_surface("lid", (-x / 2, x / 2), (-y / 2, y / 2), z + floor)])
    if z <= _TRAY:
        surfaces.append(top_surface("tray", *inner, floor))
    return Build(body=body, surfaces=surfaces)


def tuft(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return leaves or flowers of the main finish in a pot of the accent."""
    x, y, z = spec.size
    r = min(x, y) / 2
    body = profile(accent, (0, 0), [(0, 0.42 * r), (0.4 * z, 0.6 * r)])
    body += [
        _globe(spec.main(main), (1.1 * r, 1.1 * r), 0.36 * z, z),
        *(
            pad(spec.main(main), around(a * 0.5 * r, r), around(b * 0.5 * r, r), (0.42 * z, 0.85 * z))
            for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1))
        ),
    ]
    return Build(body=body, front="any")


def strings(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return an instrument that lies: a belly, a neck and a head."""
    x, y, z = spec.size
    body = [
        pad(spec.main(main), (-x / 2, x / 2), (-y / 2, -0.02 * y), (0, 0.8 * z), flat=True),
        pad(spec.main(main), around(0, 0.8 * x), (-0.16 * y, 0.12 * y), (0, 0.8 * z), flat=True),
        box(accent, around(0, 0.14 * x), (-0.1 * y, 0.42 * y), (0.5 * z, z)),
        box(accent, around(0, 0.2 * x), (0.4 * y, y / 2), (0, z)),
    ]
    return Build(body=body)
