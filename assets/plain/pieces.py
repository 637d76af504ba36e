"""Plain pieces that stand for furniture, machines and fixtures: each fills its box, in one finish with an accent."""

from dataclasses import replace
from itertools import pairwise
from math import cos, pi, sin

from thinkblox.assets.goods import is_filled, put_goods
from thinkblox.assets.palette import BLACK_PLASTIC, GREY_METAL, IRON, SCREEN
from thinkblox.assets.part import Build, Finish, Part, Range, hull
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    frustum,
    inner_surface,
    oval,
    panel,
    prism,
    profile,
    rod,
    shell,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Surface


def cabinet(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a closed case on a plinth, with two doors or drawers and a top that carries."""
    x, y, z = spec.size
    body: list[Part] = [
        box(accent, (-x / 2, 0.46 * x), around(0, 0.94 * y), (0, 0.06 * z)),
        box(spec.main(main), (-x / 2, 0.46 * x), (-y / 2, y / 2), (0.06 * z, z)),
    ]
    sides = ((-0.48 * y, -0.01 * y), (0.01 * y, 0.48 * y)) if y > 0.5 * z else ((-0.46 * y, 0.46 * y),)
    levels = ((0.1 * z, 0.96 * z),) if y > 0.5 * z else ((0.1 * z, 0.5 * z), (0.53 * z, 0.96 * z))
    for side in sides:
        for low, high in levels:
            body.append(box(spec.main(main), (0.46 * x, 0.485 * x), side, (low, high)))
            knob = around(side[1] - 0.06 * y if side[1] > 0.1 * y else side[1] - 0.04 * y, 0.03 * y)
            body.append(box(accent, (0.48 * x, x / 2), knob, around((low + high) / 2, 0.1 * z)))
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, 0.46 * x), (-y / 2, y / 2), z)])


def machine(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return an appliance: a case with a control panel, a dark opening and feet."""
    x, y, z = spec.size
    face = x / 2
    body: list[Part] = [
        box(BLACK_PLASTIC, around(0, 0.9 * x), around(0, 0.9 * y), (0, 0.05 * z)),
        cushion(spec.main(main), (-x / 2, 0.985 * face), (-y / 2, y / 2), (0.04 * z, z), radius=0.04 * min(x, y, z)),
        box(accent, (0.96 * face, face), around(0, 0.8 * y), (0.72 * z, 0.92 * z), collide=False),
        box(SCREEN, (0.96 * face, 0.995 * face), around(0, 0.6 * y), (0.18 * z, 0.62 * z), collide=False),
    ]
    return Build(body=body)


def shelves(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return an open rack with a back; each shelf carries, and with "filled" has goods on it."""
    x, y, z = spec.size
    thick = max(0.008, min(0.025, 0.06 * z))
    finish, count = spec.main(main), max(1, min(5, round(z / 0.38)))
    body: list[Part] = [box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - thick)), (0, z)) for s in (-1, 1)]
    body.append(box(accent, (-x / 2, -x / 2 + 0.5 * thick), around(0, y - 2 * thick), (0, z)))
    inner_x, inner_y = (-x / 2 + 0.5 * thick, x / 2), around(0, y - 2 * thick)
    pitch = (z - thick) / count
    surfaces: list[Surface] = []
    for k in range(count + 1):
        level = k * pitch + thick
        body.append(box(finish, inner_x, inner_y, (level - thick, level)))
        room = pitch - thick if k < count else None
        if room is None or room > 0.05:
            surfaces.append(top_surface(f"shelf_{k + 1}", inner_x, inner_y, level, headroom=room))
    build = Build(body=body, surfaces=surfaces)
    if is_filled(spec):
        put_goods(build, spec)
    return build


def _is_round(spec: Spec) -> bool:
    return spec.has("round", "circular", "oval")


def _slab(spec: Spec, finish: Finish, share: float, z: Range, *, collide: bool = True) -> Part:
    """A level slab over a share of both sides of the box, round or oval where words say so."""
    x, y = share * spec.size[0], share * spec.size[1]
    if not _is_round(spec):
        return box(finish, around(0, x), around(0, y), z, collide=collide)
    if abs(x - y) < 1e-9:
        return disc(finish, (0, 0), x / 2, z, collide=collide)
    return replace(prism(finish, oval(x, y), z, smooth=True), collide=collide)


def _top(spec: Spec) -> Surface:
    x, y, z = spec.size
    return top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z, round=_is_round(spec))


def stand(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a table: a top that carries, on four legs; round or oval where words say so."""
    x, y, z = spec.size
    thick = min(0.04, 0.2 * z)
    post = min(0.06, 0.12 * min(x, y))
    reach = 0.33 if _is_round(spec) else 0.46
    body: list[Part] = [_slab(spec, spec.main(main), 1.0, (z - thick, z))]
    for s in (-1, 1):
        for t in (-1, 1):
            corner = ((s * reach * x, s * (reach * x - post)), (t * reach * y, t * (reach * y - post)))
            body.append(box(accent, *corner, (0, z - thick)))
    return Build(body=body, surfaces=[_top(spec)])


def platform(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a solid body with a level top that carries, and a foot of the accent; on legs when "open".

    It is round or oval where words say so.
    """
    if spec.has("open"):
        return stand(spec, main, accent)
    z = spec.size[2]
    body = [_slab(spec, accent, 0.96, (0, 0.12 * z)), _slab(spec, spec.main(main), 1.0, (0.12 * z, z))]
    return Build(body=body, surfaces=[_top(spec)])


def seat(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a seat with a back on four legs, padded in the accent."""
    x, y, z = spec.size
    level = min(0.45, 0.55 * z)
    post = min(0.05, 0.12 * min(x, y))
    finish = spec.main(main)
    body: list[Part] = [
        box(finish, *corner, (0, 0.86 * level))
        for corner in (
            ((s * x / 2, s * (x / 2 - post)), (t * y / 2, t * (y / 2 - post))) for s in (-1, 1) for t in (-1, 1)
        )
    ]
    body += [
        cushion(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0.84 * level, level), radius=0.02),
        cushion(accent, (-x / 2, -x / 2 + 0.14 * x), (-y / 2, y / 2), (level, z), radius=0.02),
    ]
    front = (-x / 2 + 0.16 * x, x / 2 - 0.02)
    return Build(body=body, surfaces=[top_surface("seat", front, around(0, y - 0.04), level)])


def cart(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a trolley: two levels that carry between four posts on wheels, and a handle at its back."""
    x, y, z = spec.size
    finish = spec.main(main)
    wheel, post = min(0.1, 0.1 * z), min(0.03, 0.06 * min(x, y))
    body: list[Part] = []
    for s in (-1, 1):
        for t in (-1, 1):
            at = (s * (x / 2 - wheel / 2), t * (y / 2 - wheel / 2))
            body.append(cylinder(BLACK_PLASTIC, around(at[0], wheel), around(at[1], 0.4 * wheel), (0, wheel), axis=1))
            body.append(box(accent, around(at[0], post), around(at[1], post), (wheel, 0.88 * z)))
    body += [box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (h - 0.02, h)) for h in (0.3 * z, 0.9 * z)]
    body += [box(accent, (-x / 2, -x / 2 + post), (s * 0.4 * y, s * (0.4 * y - post)), (0.9 * z, z)) for s in (-1, 1)]
    body.append(box(accent, (-x / 2, -x / 2 + post), around(0, 0.8 * y), (z - post, z)))
    inner = ((-x / 2 + 2 * post, x / 2), (-y / 2, y / 2))
    low = top_surface("lower", *inner, 0.3 * z, headroom=0.6 * z - 0.02)
    return Build(body=body, surfaces=[top_surface("top", *inner, 0.9 * z), low])


def post(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a pole on a broad foot with a head of the main finish."""
    x, y, z = spec.size
    r = min(x, y) / 2
    thin = max(0.004, min(0.02, 0.12 * r))
    head = min(0.25 * z, 1.6 * r)
    finish = spec.main(main)
    return Build(
        body=[
            frustum(accent, (0, 0), (0, 0.05 * z), r, 0.75 * r),
            disc(accent, (0, 0), thin, (0.05 * z, z - head)),
            cushion(finish, around(0, 1.1 * r), around(0, 1.3 * r), (z - head, z), radius=0.1 * min(r, head)),
        ]
    )


def tripod(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a device on three splayed legs."""
    x, y, z = spec.size
    r, thin = min(x, y) / 2, max(0.006, 0.02 * min(x, y))
    top = 0.8 * z
    feet = [(r * cos(a) * 0.96, r * sin(a) * 0.96) for a in (0.0, 2 * pi / 3, 4 * pi / 3)]
    body: list[Part] = [rod(accent, (a, b, thin), (0.06 * a, 0.06 * b, top), thin) for a, b in feet]
    body += [disc(accent, foot, 1.6 * thin, (0, 2 * thin)) for foot in feet]
    body.append(cushion(spec.main(main), around(0, 0.5 * x), around(0, 0.3 * y), (top, z), radius=0.02))
    return Build(body=body)


def screen(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a panel on a foot, its face of the accent."""
    x, y, z = spec.size
    thin = min(0.04, 0.3 * x)
    low = 0.14 * z
    body: list[Part] = [
        box(spec.main(main), (-x / 2, x / 2), around(0, 0.6 * y), (0, 0.04 * z)),
        box(spec.main(main), around(-0.1 * thin, 0.6 * thin), around(0, 0.14 * y), (0.04 * z, low)),
        box(spec.main(main), around(0, thin), (-y / 2, y / 2), (low, z)),
        box(accent, (0.45 * thin, 0.55 * thin), around(0, 0.92 * y), (low + 0.05 * z, 0.96 * z), collide=False),
    ]
    return Build(body=body)


def booth(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a cabin with walls of the accent between its posts, open at its front; things have room in it."""
    x, y, z = spec.size
    post, finish = min(0.08, 0.08 * min(x, y)), spec.main(main)
    floor, roof = 0.02 * z, 0.94 * z
    body: list[Part] = [
        box(finish, (s * x / 2, s * (x / 2 - post)), (t * y / 2, t * (y / 2 - post)), (floor, roof))
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    body += [box(finish, (-x / 2, x / 2), (-y / 2, y / 2), height) for height in ((0, floor), (roof, z))]
    body.append(box(accent, (-x / 2, -x / 2 + 0.3 * post), around(0, y - 2 * post), (floor, roof)))
    body += [
        box(accent, around(0, x - 2 * post), (s * y / 2, s * (y / 2 - 0.3 * post)), (floor, roof)) for s in (-1, 1)
    ]
    inner = ((-x / 2 + post, x / 2), around(0, y - 2 * post))
    return Build(body=body, surfaces=[inner_surface("floor", *inner, floor, headroom=roof - floor)])


def board(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a framed panel that hangs flat, its field of the accent."""
    x, y, z = spec.size
    bar = 0.08 * min(y, z)
    return Build(body=panel(spec.main(main), (-x / 2, x / 2), (-y / 2, y / 2), (0, z), bar, accent))


def rail(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a bar that stands off the wall on two brackets, at the height of its middle."""
    x, y, z = spec.size
    thin = min(z, 0.5 * x)
    body: list[Part] = [cushion(spec.main(main), (x / 2 - thin, x / 2), (-y / 2, y / 2), (0, z), radius=0.3 * thin)]
    body += [box(accent, (-x / 2, x / 2 - 0.9 * thin), around(s * 0.4 * y, 0.06 * y), (0.2 * z, z)) for s in (-1, 1)]
    return Build(body=body)


def pendant(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return something that hangs from the ceiling by a cord."""
    x, y, z = spec.size
    r = min(x, y) / 2
    body: list[Part] = [disc(accent, (0, 0), 0.3 * r, (0.97 * z, z)), disc(accent, (0, 0), 0.008, (0.5 * z, 0.98 * z))]
    drop = [frustum(spec.main(main), (0, 0), (low * z, high * z), a * r, b * r) for low, high, a, b in _DROP]
    return Build(body=[*body, *drop])


_DROP = ((0.0, 0.25, 0.7, 1.0), (0.25, 0.5, 1.0, 0.3))
"""Lower and upper height of the body of a pendant with their radii, as shares."""


def cage(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return bars between a floor and a roof."""
    x, y, z = spec.size
    thin, finish = max(0.004, 0.012 * z), spec.main(main)
    body: list[Part] = [box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.08 * z))]
    body.append(box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0.95 * z, z)))
    for k in range(5):
        at = (k / 4 - 0.5) * (y - 2 * thin)
        body += [box(finish, around(s * (x / 2 - thin), thin), around(at, thin), (0.08 * z, 0.95 * z)) for s in (-1, 1)]
    for k in range(1, 4):
        at = (k / 4 - 0.5) * (x - 2 * thin)
        body += [box(finish, around(at, thin), around(s * (y / 2 - thin), thin), (0.08 * z, 0.95 * z)) for s in (-1, 1)]
    return Build(body=body)


def frame(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return two uprights on feet with a crossbar and something of the accent on it."""
    x, y, z = spec.size
    bar, finish = min(0.08, 0.16 * max(x, 0.2), 0.1 * y), spec.main(main)
    body: list[Part] = []
    for s in (-1, 1):
        side = (s * y / 2, s * (y / 2 - bar))
        body += [box(finish, (-x / 2, x / 2), side, (0, 0.05 * z)), box(finish, around(0, bar), side, (0.05 * z, z))]
    body.append(box(finish, around(0, bar), around(0, y - 2 * bar), (z - bar, z)))
    body.append(box(accent, around(0, 0.8 * bar), around(0, y - 2 * bar), (0.45 * z, 0.45 * z + bar)))
    return Build(body=body)


def figure(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a figure: a foot of the accent, a body and a head."""
    x, y, z = spec.size
    r, finish = min(x, y) / 2, spec.main(main)
    rings = [(0.06 * z, 0.5 * r), (0.3 * z, 0.44 * r), (0.55 * z, 0.62 * r), (0.74 * z, 0.85 * r), (0.82 * z, 0.3 * r)]
    wide = [(h, q * 1.0) for h, q in rings]
    return Build(
        body=[
            cushion(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.06 * z), radius=0.01),
            *profile(finish, (0, 0), wide, sides=16),
            ellipsoid(finish, around(0, 0.8 * r), around(0, 0.7 * r), (0.82 * z, z)),
        ]
    )


def plush(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a stuffed animal that sits: a body with a snout of the accent, ears, arms and legs."""
    x, y, z = spec.size
    fur = spec.main(main)
    body: list[Part] = [
        disc(fur, (-0.08 * x, 0), 0.26 * y, (0, 0.1 * z)),
        ellipsoid(fur, around(-0.1 * x, 0.62 * x), around(0, 0.62 * y), (0.02 * z, 0.62 * z)),
        ellipsoid(fur, around(-0.06 * x, 0.52 * x), around(0, 0.56 * y), (0.52 * z, 0.96 * z)),
        ellipsoid(accent, around(0.2 * x, 0.2 * x), around(0, 0.24 * y), (0.6 * z, 0.76 * z)),
    ]
    for s in (-1, 1):
        body += [
            ellipsoid(fur, around(-0.06 * x, 0.14 * x), around(s * 0.22 * y, 0.2 * y), (0.84 * z, z)),
            ellipsoid(fur, around(0.3 * x, 0.4 * x), around(s * 0.22 * y, 0.26 * y), (0.0, 0.24 * z)),
            ellipsoid(fur, around(0.06 * x, 0.3 * x), around(s * 0.38 * y, 0.24 * y), (0.26 * z, 0.54 * z)),
            sphere(IRON, (0.2 * x, s * 0.1 * y, 0.78 * z), 0.012),
        ]
    return Build(body=body)


def pillar(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a round shaft between a base and a capital."""
    x, y, z = spec.size
    r = min(x, y) / 2
    return Build(
        body=[
            box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.06 * z)),
            frustum(spec.main(main), (0, 0), (0.06 * z, 0.95 * z), 0.86 * r, 0.74 * r),
            box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0.95 * z, z)),
        ]
    )


def fountain(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a pedestal with a basin that holds something of the accent, nothing when "open"."""
    x, y, z = spec.size
    finish = spec.main(main)
    r = min(x, y) / 2
    build = Build(
        body=[
            frustum(finish, (0, 0), (0, 0.12 * z), 0.6 * r, 0.5 * r),
            frustum(finish, (0, 0), (0.12 * z, 0.7 * z), 0.3 * r, 0.3 * r),
            frustum(finish, (0, 0), (0.7 * z, 0.97 * z), 0.5 * r, r),
            disc(accent, (0, 0), 0.85 * r, (0.97 * z, z)),
        ],
        front="any",
    )
    return _open_basin(build, r, z) if spec.has("open") else build


def _open_basin(build: Build, radius: float, height: float) -> Build:
    """A pedestal whose basin is empty [m]."""
    finish, floor = build.body[0].finish, 0.72 * height
    wall = 0.06 * radius
    body = [*build.body[:2], disc(finish, (0, 0), 0.6 * radius, (0.7 * height, floor))]
    body += shell(finish, (0, 0), (0.7 * height, height), 0.6 * radius + wall, radius, wall)
    across = around(0, 1.18 * radius)
    return Build(body=body, surfaces=[inner_surface("basin", across, across, floor, round=True)], front="any")


def vehicle(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a body on four wheels with a cabin of the accent; its front is +x. When "open" it has a bed to load."""
    x, y, z = spec.size
    wheel, finish = min(0.36 * z, 0.24 * x), spec.main(main)
    body: list[Part] = [
        cushion(finish, (-x / 2, x / 2), around(0, 0.9 * y), (0.5 * wheel, 0.62 * z), radius=0.1 * z),
        cushion(accent, (-0.36 * x, 0.2 * x), around(0, 0.78 * y), (0.6 * z, z), radius=0.1 * z),
    ]
    surfaces: list[Surface] = []
    if spec.has("open"):
        thin, low, back = 0.03 * y, 1.05 * wheel, 0.12 * x
        bed = ((-x / 2 + thin, back - thin), around(0, 0.9 * y - 2 * thin))
        body = [
            box(finish, (-x / 2, x / 2), around(0, 0.9 * y), (0.5 * wheel, low)),
            cushion(accent, (back, x / 2), around(0, 0.9 * y), (low, z), radius=0.06 * z),
            *(box(finish, (-x / 2, back), (s * 0.45 * y, s * (0.45 * y - thin)), (low, 0.75 * z)) for s in (-1, 1)),
            *(box(finish, (at, at + thin), bed[1], (low, 0.75 * z)) for at in (-x / 2, back - thin)),
        ]
        surfaces.append(inner_surface("bed", *bed, low))
    for s in (-1, 1):
        for t in (-1, 1):
            side = (t * 0.36 * y, t * y / 2)
            body.append(cylinder(BLACK_PLASTIC, around(s * 0.3 * x, wheel), side, (0, wheel), axis=1))
    return Build(body=body, surfaces=surfaces)


def hung(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a cloth that hangs from a bar at the top, in folds."""
    x, y, z = spec.size
    finish, folds, thin = spec.main(main), 5, min(0.02, 0.5 * x)
    body: list[Part] = [box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (0.97 * z, z))]
    for k in range(folds):
        at = -y / 2 + (k + 0.5) * y / folds
        depth = x / 2 - thin / 2
        body.append(box(finish, around(depth if k % 2 else -depth, thin), around(at, y / folds), (0, 0.97 * z)))
    return Build(body=body)


def festoon(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return bulbs or leaves on a cord that hangs in two arcs from three nails."""
    x, y, z = spec.size
    finish, drop, count = spec.main(main), 0.55 * z, 16
    bulb = min(0.5 * x, 0.16 * z, 0.4 * y / count)
    spots = [(y * (k / count - 0.5), z - bulb - drop * abs(sin(2 * pi * k / count))) for k in range(count + 1)]
    body: list[Part] = [
        rod(accent, (-x / 4, a, up), (-x / 4, b, to), min(0.006, 0.2 * x)) for (a, up), (b, to) in pairwise(spots)
    ]
    for k, (at, height) in enumerate(spots[1:-1]):
        low = height - bulb - (k % 3) * 0.1 * z
        body.append(ellipsoid(finish, around(0.0, 2 * bulb), around(at, 2 * bulb), (low - bulb, low + bulb)))
        body.append(rod(accent, (-x / 4, at, height), (0.0, at, low), min(0.004, 0.1 * x)))
    return Build(body=body)


def steps(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a flight of steps that rises towards its back."""
    x, y, z = spec.size
    count = max(2, min(16, round(z / 0.19)))
    finish = spec.main(main)
    body: list[Part] = []
    for k in range(count):
        top = (k + 1) * z / count
        body.append(
            box(accent if k % 2 else finish, (-x / 2, x / 2 - k * x / count), (-y / 2, y / 2), (top - z / count, top))
        )
    return Build(body=body)


def tub(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a large oval vessel that is open at the top and holds something of the accent, little when "open"."""
    x, y, z = spec.size
    finish = spec.main(main)
    outer, inner = oval(x, y, sides=20, squareness=4.0), oval(0.86 * x, 0.86 * y, sides=20, squareness=4.0)
    body: list[Part] = []
    for k in range(20):
        n = (k + 1) % 20
        quad = [outer[k], outer[n], inner[n], inner[k]]
        body.append(hull(finish, [(a, b, h) for a, b in quad for h in (0.0, z)]))
    level = 0.12 * z if spec.has("open") else 0.6 * z
    body.append(prism(accent, inner, (0, level)))
    bottom = [inner_surface("bottom", around(0, 0.78 * x), around(0, 0.78 * y), level)] if spec.has("open") else []
    return Build(body=body, surfaces=bottom)


def bag(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return an upright bag with a handle of the accent."""
    x, y, z = spec.size
    body: list[Part] = [
        cushion(spec.main(main), (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.8 * z), radius=0.25 * min(x, y)),
        box(accent, around(0, 0.12 * x), around(0, 0.4 * y), (0.95 * z, z)),
    ]
    body += [box(accent, around(0, 0.12 * x), around(s * 0.18 * y, 0.04 * y), (0.7 * z, 0.97 * z)) for s in (-1, 1)]
    return Build(body=body)


def rack(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a frame on feet with bars that hold things of the accent."""
    x, y, z = spec.size
    bar, finish = min(0.05, 0.1 * min(x, y, z)), spec.main(main)
    body: list[Part] = []
    for s in (-1, 1):
        side = (s * y / 2, s * (y / 2 - bar))
        body += [box(finish, (-x / 2, x / 2), side, (0, bar)), box(finish, around(0, bar), side, (bar, z))]
    for k in (0.35, 0.65, 1.0):
        body.append(box(finish, around(0, bar), around(0, y - 2 * bar), (k * z - bar, k * z)))
        if k < 1.0:
            body += [
                cushion(accent, around(0, 0.8 * x), around(t * y, 0.18 * y), (k * z, k * z + 0.2 * z), radius=0.02)
                for t in (-0.28, 0.0, 0.28)
            ]
    return Build(body=body)


def robot(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a stout base, a column and an arm that reaches forward, such as a machine tool or a lamp on an arm."""
    x, y, z = spec.size
    finish = spec.main(main)
    return Build(
        body=[
            box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.12 * z)),
            box(
                GREY_METAL if finish != GREY_METAL else IRON, (-0.45 * x, -0.2 * x), around(0, 0.36 * y), (0.12 * z, z)
            ),
            cushion(finish, (-0.45 * x, 0.4 * x), around(0, 0.5 * y), (0.7 * z, 0.96 * z), radius=0.04 * z),
            disc(accent, (0.25 * x, 0), 0.1 * min(x, y), (0.45 * z, 0.72 * z)),
        ]
    )


def mat(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a flat covering that is walked on, with a border of the accent; round or oval where words say so."""
    z = spec.size[2]
    border = _slab(spec, accent, 1.0, (0, 0.8 * z), collide=False)
    return Build(body=[border, _slab(spec, spec.main(main), 0.88, (0.2 * z, z), collide=False)])
