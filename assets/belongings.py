"""What people carry and wear: bags, cases, shoes, hats, umbrellas."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.open_forms import lidded
from thinkblox.assets.palette import BRASS, BRIGHT, DARK_PLASTIC, IRON, STEEL
from thinkblox.assets.part import Build, Finish, Part, Range, hull, turned
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, frustum, oval, prism, rod
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc, tube
from thinkblox.value import Vec2, Vec3

_CLOTHS: tuple[Vec3, ...] = ((0.24, 0.34, 0.50), (0.62, 0.24, 0.22), (0.32, 0.42, 0.34), (0.20, 0.20, 0.23))
_SOLE = Finish((0.88, 0.87, 0.84), "plastic")
_LEATHERS: tuple[Vec3, ...] = ((0.48, 0.29, 0.18), (0.20, 0.16, 0.15), (0.66, 0.45, 0.28))


def backpack(spec: Spec) -> Build:
    """Return a backpack that stands, its pocket to the front."""
    x, y, z = spec.size
    cloth = spec.main(Finish(spec.choice(_CLOTHS), "fabric"))
    trim = Finish((0.15, 0.15, 0.16), "fabric")
    body: list[Part] = [
        cushion(cloth, (-0.36 * x, 0.3 * x), (-0.46 * y, 0.46 * y), (0, 0.94 * z), radius=0.16 * y),
        cushion(cloth, (0.1 * x, x / 2), around(0, 0.68 * y), (0.06 * z, 0.5 * z), radius=0.08 * y),
        box(trim, (0.28 * x, 0.33 * x), around(0, 0.7 * y), around(0.62 * z, 0.02 * z)),
        *(
            cushion(cloth, around(0, 0.3 * x), around(s * 0.46 * y, 0.08 * y), (0.08 * z, 0.34 * z), radius=0.02)
            for s in (-1, 1)
        ),
    ]
    for s in (-1, 1):
        strap = [
            (-0.34 * x, s * 0.2 * y, 0.86 * z),
            (-0.48 * x, s * 0.26 * y, 0.6 * z),
            (-0.36 * x, s * 0.34 * y, 0.12 * z),
        ]
        body += tube(trim, strap, 0.05 * x, sides=6)
    loop = arc((-0.2 * x, 0.0, 0.92 * z), (0.12 * y, 0.07 * z), (0.0, 180.0), axis=0, steps=6)
    return Build(body=body + tube(trim, loop, 0.01 * z, sides=6))


_CASES = ((0.20, 0.32, 0.44), (0.58, 0.22, 0.24), (0.24, 0.25, 0.27), (0.80, 0.66, 0.34))
"""Colours of suitcases."""


def suitcase(spec: Spec) -> Build:
    """Return an upright wheeled case with ribs, its handle pulled out a little.

    It is the same "lying" on its back, or "open": one half lies, and the other stands up behind it.
    """
    if spec.has("open"):
        half = spec.main(Finish(spec.choice(_CASES), "plastic"))
        return lidded(spec.size, half, half, 0.3 * spec.size[2])
    if spec.has("lying"):
        upright = Spec(spec.category, (spec.size[2], spec.size[0], spec.size[1]), frozenset(), spec.style, spec.rng)
        laid = [turned(part, 1, -90.0, (0.0, 0.0, 0.0)) for part in suitcase(upright).body]
        return Build(body=[turned(part, 2, 90.0, (0.0, 0.0, 0.0)) for part in laid])
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(_CASES), "plastic"))
    low, high = 0.06 * z, 0.86 * z
    body: list[Part] = [cushion(shell, (-0.46 * x, 0.46 * x), (-y / 2, y / 2), (low, high), radius=0.16 * x)]
    body += [
        cushion(
            shell, (-x / 2, x / 2), around((k - 2) * 0.17 * y, 0.06 * y), (low + 0.06 * z, high - 0.06 * z), radius=0.02
        )
        for k in range(5)
    ]
    for s in (-1, 1):
        body += [
            cylinder(DARK_PLASTIC, around(a * 0.3 * x, 0.09 * z), around(s * 0.36 * y, 0.06 * y), (0, 0.09 * z), axis=1)
            for a in (-1, 1)
        ]
        body.append(disc(STEEL, (-0.24 * x, s * 0.2 * y), 0.008, (high - 0.02 * z, z - 0.02)))
    body.append(cushion(DARK_PLASTIC, around(-0.24 * x, 0.03), around(0, 0.48 * y), (z - 0.03, z), radius=0.01))
    body.append(
        box(DARK_PLASTIC, (-0.48 * x, 0.48 * x), (-y / 2 + 0.01, y / 2 - 0.01), around((low + high) / 2, 0.006))
    )
    return Build(body=body)


def handbag(spec: Spec) -> Build:
    """Return a bag that stands, with two handles; a shopping or tote bag is a larger one."""
    x, y, z = spec.size
    hide = spec.main(Finish(spec.choice(_LEATHERS), "leather"))
    low, top = 0.62 * z, (0.3 * x, 0.86 * y)
    corners = [(u, v, 0.0) for u in (-x / 2, x / 2) for v in (-y / 2, y / 2)]
    corners += [(u, v, 0.2 * z) for u in (-x / 2, x / 2) for v in (-y / 2, y / 2)]
    corners += [(su * top[0] / 2, sv * top[1] / 2, low) for su in (-1, 1) for sv in (-1, 1)]
    body: list[Part] = [hull(hide, corners)]
    for s in (-1, 1):
        bow = arc((s * 0.1 * x, 0.0, low - 0.02 * z), (0.26 * y, 0.98 * z - low), (0.0, 180.0), axis=0, steps=8)
        body += tube(hide, bow, 0.02 * z, sides=6)
    body.append(box(BRASS, around(0.24 * x, 0.02 * x), around(0, 0.12 * y), around(0.5 * z, 0.08 * z)))
    return Build(body=body)


_DOME = ((0.0, 0.84), (0.16, 0.96), (0.4, 1.0), (0.65, 0.9), (0.85, 0.62), (1.0, 0.16))


def helmet(spec: Spec) -> Build:
    """Return a helmet, its visor to the front; that of a cyclist or a builder has a peak and a ridge."""
    x, y, z = spec.size
    tones = ((0.80, 0.20, 0.18), (0.92, 0.92, 0.90), (0.90, 0.70, 0.18), (0.18, 0.19, 0.21))
    shell = spec.main(Finish(spec.choice(tones), "plastic"))
    body = [_dome_piece(spec, shell, _DOME, (0.0, 350.0), 1.0)]
    if spec.category == "helmet":
        visor = Finish((0.10, 0.12, 0.15), "screen")
        body.append(_dome_piece(spec, visor, ((0.36, 0.99), (0.5, 0.97), (0.66, 0.9)), (-68.0, 68.0), 1.04))
        body.append(_dome_piece(spec, shell, ((0.0, 0.94), (0.16, 1.0), (0.32, 0.98)), (-60.0, 60.0), 1.06))
    else:
        peak = [(0.1 * x, -0.36 * y), (0.44 * x, -0.26 * y), (x / 2, 0.0), (0.44 * x, 0.26 * y), (0.1 * x, 0.36 * y)]
        body.append(prism(shell, peak, (0.0, 0.06 * z)))
        ridge = arc((-0.02 * x, 0.0, 0.0), (0.98 * z, 0.45 * x), (-64.0, 64.0), axis=1)
        body += tube(shell, ridge, 0.04 * z, sides=6)
    return Build(body=body)


def _dome_piece(spec: Spec, finish: Finish, rings: Sequence[Vec2], degrees: Range, swell: float) -> Part:
    """The hull of arcs (share of height, share of radius) of a helmet's outline, `swell` times as wide."""
    x, y, z = spec.size
    unit = arc((0.0, 0.0, 0.0), (1.0, 1.0), degrees, axis=2, steps=23)
    points = [(swell * r * 0.46 * x * u - 0.02 * x, swell * r * y / 2 * v, h * z) for h, r in rings for u, v, _ in unit]
    return hull(finish, points, smooth=True)


def _shoe(spec: Spec, upper: Finish, at: float, wide: float, collar: float) -> list[Part]:
    """One shoe about y = `at`, `wide` across, its collar at a height; what is higher is a boot's shaft [m]."""
    x, _, z = spec.size
    low = 0.16 * min(collar, 0.8 * wide)
    heel, toe = (-0.48 * x, -0.1 * x), (-0.46 * x, 0.34 * x)
    sections = (((-0.49 * x, 0.49 * x), 0.96, low), (toe, 0.8, low + 0.36 * wide), (heel, 0.6, collar))
    points = [
        (sum(span) / 2 + u, at + v, h)
        for span, share, h in sections
        for u, v in oval(span[1] - span[0], share * wide, sides=20, squareness=2.6)
    ]
    sole = [(u, at + v) for u, v in oval(x, wide, sides=20, squareness=2.6)]
    parts = [prism(_SOLE, sole, (0, low)), hull(upper, points, smooth=True)]
    if z > collar:
        shaft = [(sum(heel) / 2 + u, at + v) for u, v in oval(0.4 * x, 0.66 * wide, sides=16)]
        parts.append(prism(upper, shaft, (0.8 * collar, z), smooth=True))
    mouth = [(sum(heel) / 2 + u, at + v) for u, v in oval(0.28 * x, 0.46 * wide, sides=16)]
    return [*parts, replace(prism(IRON, mouth, (z - 0.002, z + 0.0006)), collide=False)]


def shoes(spec: Spec) -> Build:
    """Return a pair of shoes or boots side by side, their toes to the front."""
    x, y, z = spec.size
    collar = min(z, 0.45 * x)
    wide, upper = 0.42 * y, spec.main(Finish(spec.choice((*_LEATHERS, *_CLOTHS)), "leather"))
    return Build(body=[part for s in (-1, 1) for part in _shoe(spec, upper, s * (y - wide) / 2, wide, collar)])


def umbrella(spec: Spec) -> Build:
    """Return a rolled umbrella lying down, its crook to the front; "upright", with a straight handle, on its tip."""
    x, y, z = spec.size
    cloth = spec.main(Finish(spec.choice(((0.18, 0.20, 0.26), (0.62, 0.20, 0.20), (0.26, 0.38, 0.34))), "fabric"))
    if spec.has("upright"):
        r = min(x, y) / 2
        return Build(
            body=[
                disc(STEEL, (0, 0), 0.5 * r, (0, 0.16 * z)),
                frustum(cloth, (0, 0), (0.16 * z, 0.7 * z), 0.5 * r, r),
                frustum(cloth, (0, 0), (0.7 * z, 0.75 * z), r, 0.4 * r),
                disc(spec.style.wood, (0, 0), 0.35 * r, (0.75 * z, z)),
            ],
            front="any",
        )
    mid, r = z / 2, z / 2
    start, end = -0.42 * x, 0.2 * x
    crook = 0.3 * y
    bow = arc((x / 2 - crook - 0.012, y / 2 - 0.02 - crook, 0.011), (crook, crook), (-90.0, 120.0), axis=2)
    at = bow[0][1]
    body: list[Part] = [
        rod(STEEL, (-x / 2, at, 0.4 * r), (start, at, 0.4 * r), 0.006),
        rod(cloth, (start, at, 0.4 * r), (end, at, r), 0.4 * r, end_radius=r, sides=12),
        rod(cloth, (end, at, mid), (end + 0.05 * x, at, mid), r, end_radius=0.4 * r, sides=8),
        rod(spec.style.wood, (end + 0.04 * x, at, mid), (bow[0][0], at, 0.011), 0.011),
    ]
    return Build(body=body + tube(spec.style.wood, bow, 0.011))


def parasol(spec: Spec) -> Build:
    """Return an open parasol in its heavy foot."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    cloth = spec.main(Finish(spec.choice(((0.90, 0.84, 0.72), (0.70, 0.28, 0.24), (0.30, 0.46, 0.44))), "fabric"))
    low = 0.8 * z
    body: list[Part] = [
        disc(Finish((0.42, 0.42, 0.41), "stone"), (0, 0), min(0.3, 0.5 * radius), (0, 0.05 * z)),
        disc(spec.style.wood, (0, 0), 0.024, (0.05 * z, 0.97 * z)),
        frustum(cloth, (0, 0), (low, 0.97 * z), radius, 0.04 * radius, sides=10, smooth=False),
        disc(spec.style.wood, (0, 0), 0.03, (0.97 * z, z)),
    ]
    return Build(body=body)


def hat(spec: Spec) -> Build:
    """Return a hat with a brim and a band."""
    x, y, z = spec.size
    felt = spec.main(Finish(spec.choice(((0.72, 0.58, 0.40), (0.22, 0.20, 0.20), (0.50, 0.36, 0.24))), "fabric"))
    crown = 0.3 * min(x, y)
    return Build(
        body=[
            prism(felt, oval(x, y), (0, 0.08 * z)),
            frustum(felt, (0, 0), (0.06 * z, 0.94 * z), crown, 0.82 * crown),
            frustum(felt, (0, 0), (0.94 * z, z), 0.82 * crown, 0.66 * crown),
            frustum(IRON, (0, 0), (0.08 * z, 0.3 * z), 1.02 * crown, 0.98 * crown),
        ]
    )


def headphones(spec: Spec) -> Build:
    """Return headphones lying on their ear cups."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((DARK_PLASTIC, Finish((0.90, 0.90, 0.89), "plastic"))))
    body: list[Part] = []
    for s in (-1, 1):
        body += [
            cushion(shell, (-x / 2, x / 2), around(s * 0.4 * y, 0.16 * y), (0, x), radius=0.06 * y),
            cushion(IRON, (-0.42 * x, 0.42 * x), around(s * 0.28 * y, 0.12 * y), (0.08 * x, 0.92 * x), radius=0.05 * y),
        ]
    band = arc((0.0, 0.0, 0.6 * x), (0.44 * y, z - 0.66 * x), (0.0, 180.0), axis=0, steps=10)
    return Build(body=body + tube(shell, band, 0.06 * x))


def hair_dryer(spec: Spec) -> Build:
    """Return a hair dryer lying on its side."""
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(((0.16, 0.16, 0.18), (0.80, 0.40, 0.48), (0.86, 0.86, 0.85))), "plastic"))
    at, mid = y / 2 - 0.5 * z, z / 2
    body: list[Part] = [
        rod(shell, (-0.34 * x, at, mid), (0.3 * x, at, mid), mid, sides=12),
        rod(DARK_PLASTIC, (-x / 2, at, mid), (-0.34 * x, at, mid), 0.7 * mid, end_radius=mid, sides=12),
        rod(DARK_PLASTIC, (0.3 * x, at, mid), (x / 2, at, mid), 0.6 * mid, end_radius=0.74 * mid, sides=12),
        cushion(shell, (-0.16 * x, 0.06 * x), (-y / 2, at), (0, 0.7 * z), radius=0.2 * z),
        box(DARK_PLASTIC, around(-0.05 * x, 0.08 * x), around(-0.1 * y, 0.16 * y), (0.68 * z, 0.76 * z)),
        box(
            Finish(BRIGHT[0], "plastic"), around(-0.05 * x, 0.04 * x), around(-0.1 * y, 0.04 * y), (0.74 * z, 0.79 * z)
        ),
    ]
    return Build(body=body)
