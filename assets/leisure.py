"""Play, sport, music and the open air: machines, boards, balls, weights, hammocks."""

from math import cos, pi, sin

from thinkblox.assets.palette import (
    BLACK_PLASTIC,
    BRIGHT,
    CHROME,
    DARK_PLASTIC,
    EBONY,
    GREY_METAL,
    IRON,
    LINEN,
    STEEL,
)
from thinkblox.assets.part import Build, Finish, Part, hull, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    frustum,
    leg,
    oval,
    pad,
    prism,
    rod,
    round_leg,
    sphere,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc, ring, tube
from thinkblox.assets.vessels import turned_solid

_IVORY = Finish((0.94, 0.93, 0.89), "plastic")


def grand_piano(spec: Spec) -> Build:
    """Return a grand piano with its lid open, or "closed"; one plays at +x, the long string side is on the left."""
    x, y, z = spec.size
    case = spec.main(spec.choice((Finish((0.06, 0.06, 0.07), "plastic"), EBONY)))
    bed, rim, keys = 0.58 * z, 0.8 * z if not spec.has("closed") else z, x / 2 - 0.24
    curve = [(keys, -y / 2), (keys, y / 2), (-0.38 * x, y / 2), (-0.47 * x, 0.42 * y), (-x / 2, 0.22 * y)]
    curve += [(-0.42 * x, 0.02 * y), (-0.2 * x, -0.16 * y), (-0.02 * x, -0.42 * y), (0.1 * x, -y / 2)]
    body: list[Part] = [
        prism(case, curve, (bed, rim)),
        box(case, (keys, x / 2), (-y / 2, y / 2), (bed, bed + 0.05 * z)),
        *(box(case, (keys, x / 2), (s * y / 2, s * (y / 2 - 0.05 * y)), (bed + 0.05 * z, rim)) for s in (-1, 1)),
        box(_IVORY, (x / 2 - 0.16, x / 2 - 0.02), around(0, 0.88 * y), (bed + 0.05 * z, bed + 0.08 * z)),
        *(
            box(
                BLACK_PLASTIC,
                (x / 2 - 0.16, x / 2 - 0.07),
                around((k - 14.5) * 0.029 * y, 0.011 * y),
                (bed + 0.08 * z, bed + 0.1 * z),
            )
            for k in range(30)
            if k % 7 not in (2, 6)
        ),
        *(
            round_leg(case, at, at, (0, bed), 0.045, 0.07)
            for at in ((0.34 * x, 0.42 * y), (0.34 * x, -0.42 * y), (-0.38 * x, 0.24 * y))
        ),
        box(case, around(0.34 * x, 0.06), around(0, 0.2 * y), (0.06 * z, 0.1 * z)),
        *(leg(case, (0.34 * x, s * 0.06 * y), (0.34 * x, s * 0.06 * y), (0.08 * z, bed), 0.03, 0.03) for s in (-1, 1)),
    ]
    if rim < z:
        body.append(box(case, (keys - 0.1, keys - 0.08), around(0, 0.5 * y), (rim, rim + 0.16 * z)))
        lid = [(u, v, rim + 0.01) for u, v in curve] + [(u, v, rim + 0.03) for u, v in curve]
        opened = turned(hull(case, [(min(u, keys - 0.14), v, w) for u, v, w in lid]), 0, 32.0, (0.0, y / 2, rim))
        lowest = min(p[2] for p in opened.points)
        highest = max(p[2] for p in opened.points)
        share = (z - rim) / (highest - lowest)
        body.append(hull(case, [(u, v, rim + (w - lowest) * share) for u, v, w in opened.points]))
    return Build(body=body)


def jukebox(spec: Spec) -> Build:
    """Return a jukebox with a lit arch over its records."""
    x, y, z = spec.size
    wood = spec.main(Finish((0.45, 0.24, 0.15), "wood"))
    front, radius, mid = 0.36 * x, y / 2, z - y / 2
    glow = (
        Finish((1.0, 0.72, 0.25), "light"),
        Finish((0.98, 0.36, 0.30), "light"),
        Finish((0.45, 0.80, 0.95), "light"),
    )

    def slab(finish: Finish, size: float, across: tuple[float, float]) -> Part:
        arch = [(v, mid + w) for _, v, w in arc((0.0, 0.0, 0.0), (size, size), (0.0, 180.0), axis=0, steps=14)]
        low = radius - size
        return prism(finish, [*arch, (-size, low), (size, low)], across, axis=0)

    body: list[Part] = [
        slab(wood, radius, (-x / 2, front)),
        slab(glow[0], 0.96 * radius, (front, front + 0.04 * x)),
        slab(Finish((0.30, 0.15, 0.10), "wood"), 0.82 * radius, (front, front + 0.07 * x)),
        slab(glow[2], 0.6 * radius, (front, front + 0.09 * x)),
        box(CHROME, (front, x / 2), around(0, 0.8 * y), (0.46 * z, 0.52 * z)),
        box(Finish((0.92, 0.86, 0.70), "paper"), (front, 0.47 * x), around(0, 0.7 * y), (0.56 * z, 0.66 * z)),
        *(box(glow[1], (front, 0.46 * x), around(k * 0.14 * y, 0.06 * y), (0.12 * z, 0.42 * z)) for k in range(-2, 3)),
        box(CHROME, (front, 0.48 * x), around(0, 0.9 * y), (0, 0.06 * z)),
    ]
    return Build(body=body)


def pinball_machine(spec: Spec) -> Build:
    """Return a pinball machine: a sloping playfield with a lit backbox; the player stands at +x."""
    x, y, z = spec.size
    paint = spec.main(Finish(spec.choice(BRIGHT), "wood"))
    low, near, far = 0.32 * z, 0.52 * z, 0.6 * z
    back = -x / 2 + 0.2 * x
    case = [(-x / 2, low), (0.48 * x, low), (0.48 * x, near), (-x / 2, far)]
    body: list[Part] = [
        prism(paint, case, around(0, 0.92 * y), axis=1),
        prism(
            CHROME,
            [(back, far - 0.01 * z), (0.47 * x, near), (0.47 * x, near + 0.012 * z), (back, far + 0.002 * z)],
            around(0, 0.8 * y),
            axis=1,
        ),
        box(paint, (-x / 2, back), (-y / 2, y / 2), (far, z)),
        box(
            Finish((0.98, 0.82, 0.36), "light"),
            (back, back + 0.002),
            around(0, 0.86 * y),
            (far + 0.1 * z, z - 0.03 * z),
        ),
        box(BLACK_PLASTIC, (back, back + 0.003), around(0, 0.7 * y), (far + 0.03 * z, far + 0.08 * z)),
        cylinder(STEEL, (0.48 * x, x / 2), around(-0.36 * y, 0.04 * y), around(low + 0.12 * z, 0.04 * y), axis=0),
        *(
            cylinder(
                BLACK_PLASTIC, around(0.36 * x, 0.04), (s * 0.46 * y, s * y / 2), around(near - 0.05 * z, 0.04), axis=1
            )
            for s in (-1, 1)
        ),
    ]
    for k in range(5):
        u, v = (0.22 - 0.1 * k) * x, (0.22, -0.2, 0.05, 0.24, -0.16)[k] * y
        level = near + (far - near) * (0.47 * x - u) / (0.97 * x)
        body.append(disc(Finish(BRIGHT[(k + 2) % 5], "light"), (u, v), 0.06 * y, (level, level + 0.03 * z)))
    for sx, top in ((-0.44, low), (0.42, low)):
        body += [
            leg(CHROME, (sx * 1.06 * x, s * 0.44 * y), (sx * x, s * 0.42 * y), (0, top + 0.01), 0.04, 0.05)
            for s in (-1, 1)
        ]
    return Build(body=body)


def hammock(spec: Spec) -> Build:
    """Return a hammock in a wooden stand, along y."""
    x, y, z = spec.size
    cloth, wood = spec.main(spec.choice((LINEN, spec.style.accent))), spec.style.wood
    dip, end = 0.34 * z, 0.84 * z
    body: list[Part] = [
        box(wood, around(0, 0.06), around(0, 0.72 * y), (0.04 * z, 0.11 * z)),
        *(box(wood, around(0, 0.7 * x), around(s * 0.3 * y, 0.07), (0, 0.05 * z)) for s in (-1, 1)),
        *(rod(wood, (0, s * 0.3 * y, 0.08 * z), (0, s * (y / 2 - 0.03), z - 0.03), 0.035) for s in (-1, 1)),
    ]
    count = 10
    across = [-0.36 * y + 0.72 * y * k / count for k in range(count + 1)]
    depth = [dip + (end - dip) * abs(v / (0.36 * y)) ** 2 for v in across]
    for k in range(count):
        span = [(across[k], depth[k]), (across[k + 1], depth[k + 1])]
        points = [
            (s * x / 2 * (1 - 0.35 * abs(v / (0.36 * y)) ** 3), v, w + t)
            for v, w in span
            for s in (-1, 1)
            for t in (0.0, 0.02)
        ]
        body.append(hull(cloth, points))
    for s in (-1, 1):
        tip = (0.0, s * (y / 2 - 0.05), 0.95 * z)
        body += [rod(LINEN, (u * x, s * 0.36 * y, end), tip, 0.006, sides=6) for u in (-0.3, -0.1, 0.1, 0.3)]
    return Build(body=body)


def surfboard(spec: Spec) -> Build:
    """Return a surfboard: upright in a stand, or flat on wall brackets with its length along the wall."""
    x, y, z = spec.size
    foam = spec.main(Finish(spec.choice(((0.94, 0.92, 0.86), (0.90, 0.72, 0.36), (0.40, 0.62, 0.68))), "plastic"))
    stripe = Finish(BRIGHT[0], "plastic")
    if spec.category.startswith("wall"):
        thick = (x / 2 - 0.5 * x, x / 2)
        shape = [(u, z / 2 + v) for u, v in _board(y, z)]
        rail = box(stripe, (x / 2 - 0.001, x / 2 + 0.0006), around(0, 0.9 * y), around(z / 2, 0.03 * z), collide=False)
        hooks = [box(IRON, (-x / 2, 0.02 * x), around(s * 0.2 * y, 0.04), (0.1 * z, 0.9 * z)) for s in (-1, 1)]
        return Build(body=[prism(foam, shape, thick, axis=0, smooth=False), rail, *hooks])
    low, deep = 0.03 * z, 0.07
    shape = [(v, low + (z - low) / 2 + u) for u, v in _board(z - low, y)]
    body: list[Part] = [
        prism(foam, shape, around(0, deep), axis=0),
        box(stripe, (deep / 2 - 0.001, deep / 2 + 0.0006), around(0, 0.04 * y), (0.1 * z, 0.94 * z), collide=False),
        box(spec.style.wood, (-x / 2, x / 2), around(0, 0.7 * y), (0, low)),
        *(
            box(spec.style.wood, (s * (deep / 2 + 0.005), s * (deep / 2 + 0.035)), around(0, 0.5 * y), (low, 0.22 * z))
            for s in (-1, 1)
        ),
    ]
    return Build(body=body)


def _board(long: float, wide: float) -> list[tuple[float, float]]:
    """Outline of a surfboard along its first axis, round at the tail and pointed at the nose."""
    shares = (
        (-0.5, 0.3),
        (-0.48, 0.5),
        (-0.36, 0.8),
        (-0.1, 1.0),
        (0.15, 0.96),
        (0.36, 0.64),
        (0.47, 0.24),
        (0.5, 0.04),
    )
    edge = [(u * long, v * wide / 2) for u, v in shares]
    return edge + [(u, -v) for u, v in reversed(edge)]


def skateboard(spec: Spec) -> Build:
    """Return a skateboard on its wheels, along x."""
    x, y, z = spec.size
    deck, low = spec.main(Finish(spec.choice(BRIGHT), "wood")), 0.6 * z
    body: list[Part] = [prism(deck, [(u, v) for u, v in oval(0.72 * x, y, squareness=6.0)], (low, low + 0.12 * z))]
    for s in (-1, 1):
        tip = [(s * 0.34 * x, low), (s * x / 2, z - 0.1 * z), (s * x / 2, z), (s * 0.34 * x, low + 0.12 * z)]
        body.append(prism(deck, tip, around(0, 0.86 * y), axis=1))
        body.append(box(GREY_METAL, around(s * 0.26 * x, 0.05 * x), around(0, 0.6 * y), (0.3 * z, low)))
        body += [
            cylinder(_IVORY, around(s * 0.26 * x, 0.5 * z), around(t * 0.38 * y, 0.18 * y), (0, 0.5 * z), axis=1)
            for t in (-1, 1)
        ]
    return Build(body=body)


def dumbbell(spec: Spec) -> Build:
    """Return a dumbbell with hexagonal heads, along y."""
    x, y, z = spec.size
    iron = spec.main(IRON)
    heads = [
        prism(iron, [(u, w + z / 2) for u, w in oval(x, 1.155 * z, sides=6)], (s * 0.24 * y, s * y / 2), axis=1)
        for s in (-1, 1)
    ]
    grip = cylinder(CHROME, around(0, 0.3 * z), around(0, 0.5 * y), around(z / 2, 0.3 * z), axis=1)
    return Build(body=[*heads, grip])


def kettlebell(spec: Spec) -> Build:
    """Return a kettlebell."""
    x, y, z = spec.size
    iron, radius = spec.main(spec.choice((IRON, Finish((0.28, 0.40, 0.52), "metal")))), min(x, y) / 2
    bell = turned_solid(iron, radius, 0.7 * z, ((0.0, 0.6), (0.2, 0.9), (0.5, 1.0), (0.8, 0.8), (1.0, 0.4)), round=True)
    loop = arc((0.0, 0.0, 0.6 * z), (0.62 * radius, 0.34 * z), (-10.0, 190.0), axis=0, steps=10)
    return Build(body=bell + tube(iron, loop, 0.06 * z))


def punching_bag(spec: Spec) -> Build:
    """Return a punch bag on chains under the ceiling."""
    x, y, z = spec.size
    hide, radius, top = spec.main(Finish((0.60, 0.16, 0.14), "leather")), min(x, y) / 2, 0.72 * z
    body: list[Part] = [
        disc(hide, (0, 0), radius, (0, top)),
        *(disc(IRON, (0, 0), 1.01 * radius, (h * z, (h + 0.03) * z), collide=False) for h in (0.04, 0.66)),
        disc(IRON, (0, 0), 0.3 * radius, (z - 0.02 * z, z)),
        disc(STEEL, (0, 0), 0.02, (0.86 * z, z - 0.02 * z)),
    ]
    for k in range(4):
        at = (0.9 * radius * cos(pi * k / 2), 0.9 * radius * sin(pi * k / 2))
        body.append(rod(STEEL, (at[0], at[1], top), (0, 0, 0.87 * z), 0.008))
    return Build(body=body)


def trampoline(spec: Spec) -> Build:
    """Return a round trampoline on legs."""
    x, y, z = spec.size
    mat, rim = Finish((0.12, 0.12, 0.14), "fabric"), spec.main(Finish((0.24, 0.44, 0.62), "fabric"))
    body: list[Part] = [
        prism(mat, oval(0.8 * x, 0.8 * y, sides=32), (z - 0.1 * z, z - 0.06 * z)),
        *ring(rim, (0, 0, z - 0.06 * z), (0.45 * x, 0.45 * y), 0.06 * z, axis=2, sides=20),
    ]
    for k in range(6):
        u, v = 0.45 * x * cos(pi * k / 3), 0.45 * y * sin(pi * k / 3)
        body.append(rod(STEEL, (u, v, 0.0), (u, v, z - 0.06 * z), 0.018))
    body += ring(rim, (0, 0, z - 0.03 * z), (x / 2 - 0.03 * z, y / 2 - 0.03 * z), 0.03 * z, axis=2, sides=20)
    return Build(body=body)


def chess_board(spec: Spec) -> Build:
    """Return a chessboard with its men set up."""
    x, y, z = spec.size
    pale, dark, base = Finish((0.90, 0.80, 0.62), "wood"), Finish((0.36, 0.23, 0.15), "wood"), 0.22 * z
    body: list[Part] = [box(dark, (-x / 2, x / 2), (-y / 2, y / 2), (0, base))]
    u, v = 0.115 * x, 0.115 * y
    for row in range(8):
        body += [
            box(
                pale,
                around((row - 3.5) * u, u),
                around((k - 3.5) * v, v),
                (base - 0.0005, base + 0.0006),
                collide=False,
            )
            for k in range(8)
            if (row + k) % 2
        ]
    for row, finish in ((0, pale), (1, pale), (6, dark), (7, dark)):
        for k in range(8):
            at = ((row - 3.5) * u, (k - 3.5) * v)
            tall = (1.0 if k in (3, 4) else 0.78) * (z - base) if row in (0, 7) else 0.58 * (z - base)
            body.append(frustum(finish, at, (base, base + tall), 0.34 * u, 0.14 * u, sides=10))
    return Build(body=body)


def balloon(spec: Spec) -> Build:
    """Return a balloon on a string that is tied to a weight."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    skin = spec.main(Finish(spec.choice(BRIGHT), "plastic"))
    low = z - 2.5 * radius
    return Build(
        body=[
            frustum(CHROME, (0, 0), (0, 0.05 * z), 0.4 * radius, 0.3 * radius),
            disc(LINEN, (0, 0), 0.012 * radius + 0.001, (0.05 * z, low)),
            frustum(skin, (0, 0), (low - 0.02, low + 0.3 * radius), 0.06 * radius, 0.3 * radius),
            ellipsoid(skin, (-radius, radius), (-radius, radius), (low, z)),
        ]
    )


def motorcycle(spec: Spec) -> Build:
    """Return a motorcycle on its stand, heading to the front."""
    x, y, z = spec.size
    paint, size = (
        spec.main(Finish(spec.choice(((0.66, 0.14, 0.13), (0.12, 0.13, 0.15), (0.16, 0.30, 0.46))), "metal")),
        0.56 * z,
    )
    front, rear = x / 2 - size / 2, -x / 2 + size / 2
    body: list[Part] = []
    for at in (front, rear):
        body += ring(BLACK_PLASTIC, (at, 0, size / 2), (0.43 * size, 0.43 * size), 0.07 * size, axis=1, sides=14)
        body.append(
            cylinder(GREY_METAL, around(at, 0.3 * size), around(0, 0.12 * y), around(size / 2, 0.3 * size), axis=1)
        )
        body += [
            rod(STEEL, (at - u, 0, size / 2 - w), (at + u, 0, size / 2 + w), 0.012)
            for u, w in ((0.4 * size, 0.0), (0.0, 0.4 * size))
        ]
    body += [
        cushion(paint, (-0.1 * x, 0.2 * x), around(0, 0.34 * y), (0.62 * z, 0.8 * z), radius=0.06),
        cushion(DARK_PLASTIC, (-0.36 * x, -0.08 * x), around(0, 0.32 * y), (0.62 * z, 0.71 * z), radius=0.04),
        cushion(GREY_METAL, (-0.14 * x, 0.16 * x), around(0, 0.42 * y), (0.22 * z, 0.56 * z), radius=0.03),
        box(IRON, (-0.3 * x, 0.2 * x), around(0, 0.12 * y), (0.55 * z, 0.63 * z)),
        cushion(paint, (-x / 2 + 0.06 * x, -0.3 * x), around(0, 0.24 * y), (0.56 * z, 0.64 * z), radius=0.02),
        rod(CHROME, (-0.44 * x, -0.26 * y, 0.26 * z), (0.1 * x, -0.26 * y, 0.24 * z), 0.035),
        sphere(CHROME, (0.31 * x, 0, 0.78 * z), 0.07 * z),
        cylinder(CHROME, around(0.2 * x, 0.03), (-y / 2, y / 2), around(z - 0.02, 0.03), axis=1),
        *(rod(CHROME, (0.2 * x, s * 0.14 * y, 0.97 * z), (front, s * 0.14 * y, size / 2), 0.02) for s in (-1, 1)),
        *(rod(IRON, (-0.02 * x, s * 0.16 * y, 0.26 * z), (-0.06 * x, s * 0.4 * y, 0.01 * z), 0.018) for s in (-1, 1)),
        *(box(IRON, around(-0.06 * x, 0.1 * x), around(s * 0.4 * y, 0.1 * y), (0, 0.02 * z)) for s in (-1, 1)),
        *(rod(IRON, (-0.1 * x, s * 0.14 * y, 0.4 * z), (rear, s * 0.12 * y, size / 2), 0.02) for s in (-1, 1)),
    ]
    return Build(body=body)


def string_instrument(spec: Spec) -> Build:
    """Return a cello or violin on a stand."""
    x, y, z = spec.size
    wood = spec.main(Finish((0.58, 0.30, 0.14), "wood"))
    deep, low = 0.34 * x, 0.1 * z
    at = 0.06 * x
    body: list[Part] = []
    for level, wide, tall in ((0.26, 1.0, 0.32), (0.41, 0.66, 0.16), (0.53, 0.8, 0.24)):
        shape = [(v, level * z + w) for v, w in oval(wide * y, tall * z, sides=20)]
        body.append(prism(wood, shape, around(at, deep), axis=0, smooth=True))
    face = at + deep / 2
    body += [
        box(EBONY, (at, face + 0.03 * x), around(0, 0.08 * y), (0.46 * z, 0.97 * z)),
        box(EBONY, (face, face + 0.1 * x), around(0, 0.16 * y), (0.33 * z, 0.36 * z)),
        sphere(wood, (at, 0, z - 0.03 * z), 0.03 * z),
        rod(STEEL, (at, 0, 0.0), (at, 0, 0.14 * z), 0.008),
        *(rod(IRON, (-x / 2 + 0.01, s * 0.4 * y, 0.01), (at - deep / 2, 0, 0.5 * z), 0.01) for s in (-1, 1)),
        *(rod(IRON, (x / 2 - 0.01, s * 0.36 * y, 0.01), (-0.26 * x, s * 0.3 * y, low), 0.01) for s in (-1, 1)),
        box(IRON, (-0.3 * x, x / 2 - 0.02), around(0, 0.3 * y), (0.0, 0.02 * z)),
    ]
    return Build(body=body)


def gong(spec: Spec) -> Build:
    """Return a gong in its frame."""
    x, y, z = spec.size
    wood, bronze, size = spec.wood, Finish((0.72, 0.54, 0.24), "metal"), min(0.78 * y, 0.74 * z)
    mid = 0.5 * z
    body: list[Part] = [box(wood, around(0, 0.2 * x), (-y / 2, y / 2), (z - 0.06 * z, z))]
    for s in (-1, 1):
        body += [
            box(wood, around(0, 0.2 * x), around(s * 0.46 * y, 0.06 * y), (0.05 * z, z - 0.06 * z)),
            box(wood, (-x / 2, x / 2), around(s * 0.46 * y, 0.06 * y), (0, 0.05 * z)),
            rod(LINEN, (0, s * 0.2 * y, mid + 0.4 * size), (0, s * 0.2 * y, z - 0.05 * z), 0.006),
        ]
    body += [
        cylinder(bronze, around(0, 0.08 * x), around(0, size), around(mid, size), axis=0),
        cylinder(bronze, around(0, 0.14 * x), around(0, 0.3 * size), around(mid, 0.3 * size), axis=0),
    ]
    return Build(body=body)


def grill(spec: Spec) -> Build:
    """Return a barbecue with a lid on a trolley, its shelves at both sides."""
    x, y, z = spec.size
    lid, low = spec.main(IRON), 0.66 * z
    profile = ((0.4, 0.0), (0.36, 0.2), (0.1, 0.34), (-0.2, 0.34), (-0.4, 0.16), (-0.4, 0.0))
    hood = [(u * x, low + w * z) for u, w in profile]
    body: list[Part] = [
        box(IRON, around(0, 0.86 * x), around(0, 0.56 * y), (0.5 * z, low)),
        prism(lid, hood, around(0, 0.56 * y), axis=1),
        cylinder(CHROME, (0.44 * x, x / 2), around(0, 0.4 * y), around(low + 0.1 * z, 0.06 * x), axis=1),
        *(
            box(CHROME, (0.38 * x, 0.46 * x), around(s * 0.18 * y, 0.02 * y), around(low + 0.1 * z, 0.02 * z))
            for s in (-1, 1)
        ),
        *(
            box(STEEL, around(0, 0.74 * x), (s * 0.28 * y, s * y / 2), (low - 0.04 * z, low - 0.01 * z))
            for s in (-1, 1)
        ),
        box(GREY_METAL, around(0, 0.7 * x), around(0, 0.52 * y), (0.06 * z, 0.5 * z)),
        *(
            cylinder(CHROME, (0.43 * x, 0.46 * x), around(k * 0.14 * y, 0.05 * y), around(0.58 * z, 0.05 * y), axis=0)
            for k in (-1, 0, 1)
        ),
        *(
            cylinder(
                BLACK_PLASTIC, around(sx * 0.28 * x, 0.1 * z), around(sy * 0.22 * y, 0.05 * y), (0, 0.1 * z), axis=1
            )
            for sx in (-1, 1)
            for sy in (-1, 1)
        ),
    ]
    return Build(body=body)


def rowing_machine(spec: Spec) -> Build:
    """Return a rowing machine; the rower looks to +x."""
    x, y, z = spec.size
    frame = spec.main(IRON)
    drum = min(0.56 * z, 0.24 * x)
    body: list[Part] = [
        box(GREY_METAL, (-0.44 * x, 0.3 * x), around(0, 0.2 * y), (0.3 * z, 0.36 * z)),
        box(frame, (-x / 2, -0.44 * x), (-y / 2, y / 2), (0, 0.06 * z)),
        box(frame, (-0.48 * x, -0.44 * x), around(0, 0.2 * y), (0.06 * z, 0.36 * z)),
        box(frame, (0.3 * x, 0.36 * x), (-y / 2, y / 2), (0, 0.06 * z)),
        box(frame, (0.24 * x, 0.4 * x), around(0, 0.3 * y), (0.06 * z, 0.34 * z)),
        cylinder(frame, (x / 2 - drum, x / 2), around(0, 0.5 * y), (0.18 * z, 0.18 * z + drum), axis=1),
        pad(DARK_PLASTIC, (-0.28 * x, -0.12 * x), around(0, 0.66 * y), (0.38 * z, 0.46 * z), edge=0.2, flat=True),
        box(GREY_METAL, (-0.24 * x, -0.16 * x), around(0, 0.3 * y), (0.36 * z, 0.38 * z)),
        *(
            turned(
                box(DARK_PLASTIC, (0.1 * x, 0.12 * x), around(s * 0.24 * y, 0.24 * y), (0.3 * z, 0.56 * z)),
                1,
                24.0,
                (0.1 * x, 0, 0.3 * z),
            )
            for s in (-1, 1)
        ),
        cylinder(DARK_PLASTIC, around(0.16 * x, 0.03), around(0, 0.9 * y), around(0.66 * z, 0.03), axis=1),
        rod(STEEL, (0.16 * x, 0, 0.66 * z), (0.3 * x, 0, 0.6 * z), 0.006),
        rod(frame, (0.34 * x, 0, 0.3 * z), (0.22 * x, 0, 0.92 * z), 0.02),
        box(DARK_PLASTIC, (0.19 * x, 0.22 * x), around(0, 0.4 * y), (0.84 * z, z)),
    ]
    return Build(body=body)
