"""Furniture and things for small children and for pets."""

from math import cos, pi, sin

from thinkblox.assets.palette import BRIGHT, GREY_PLASTIC, IRON, LINEN, WHITE_COTTON, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, hull, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    inner_surface,
    leg,
    oval,
    pad,
    prism,
    rod,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.storage import dresser
from thinkblox.assets.tubes import arc, tube

_PLUSH = Finish((0.80, 0.74, 0.64), "fabric")
_ROPE = Finish((0.78, 0.64, 0.44), "fabric")


def changing_table(spec: Spec) -> Build:
    """Return a chest of drawers with a padded tray on it."""
    x, y, z = spec.size
    low = z - 0.1
    build = dresser(Spec(spec.category, (x, y, low), spec.words, spec.style, spec.rng))
    wood = build.body[0].finish
    deep = x - 0.03
    back = (-x / 2, -x / 2 + deep)
    build.body += [
        box(wood, (back[0], back[0] + 0.018), (-y / 2, y / 2), (low, z)),
        *(box(wood, (back[0] + 0.018, back[1]), (s * y / 2, s * (y / 2 - 0.018)), (low, z)) for s in (-1, 1)),
        box(wood, (back[1] - 0.018, back[1]), around(0, y - 0.036), (low, low + 0.05)),
        pad(
            WHITE_COTTON, (back[0] + 0.02, back[1] - 0.02), around(0, y - 0.05), (low, low + 0.06), edge=0.2, flat=True
        ),
    ]
    padded = top_surface("top", (back[0] + 0.03, back[1] - 0.03), around(0, y - 0.07), low + 0.06)
    build.surfaces = [padded, *(s for s in build.surfaces if s.name != "top")]
    return build


def high_chair(spec: Spec) -> Build:
    """Return a child's high chair with its tray and footrest."""
    x, y, z = spec.size
    wood, seat = spec.wood, 0.56 * z
    shell = Finish(spec.style.accent.colour, "plastic")
    body: list[Part] = [
        leg(
            wood,
            (sx * (x / 2 - 0.025), sy * (y / 2 - 0.025)),
            (0.52 * sx * x / 2, 0.62 * sy * y / 2),
            (0, seat - 0.02),
            0.03,
            0.036,
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    back = cushion(shell, (-0.26 * x, -0.2 * x), around(0, 0.56 * y), (seat, z), radius=0.03)
    body += [
        cushion(shell, (-0.26 * x, 0.2 * x), around(0, 0.62 * y), (seat - 0.03, seat), radius=0.012),
        turned(back, 1, -5.0, (-0.24 * x, 0.0, seat)),
        *(
            cushion(shell, (-0.22 * x, 0.14 * x), around(s * 0.3 * y, 0.03), (seat, seat + 0.17 * z), radius=0.012)
            for s in (-1, 1)
        ),
        cushion(
            WHITE_PLASTIC, (0.04 * x, 0.42 * x), around(0, 0.82 * y), (seat + 0.17 * z, seat + 0.2 * z), radius=0.02
        ),
        *(
            box(WHITE_PLASTIC, around(0.1 * x, 0.03), around(s * 0.3 * y, 0.02), (seat, seat + 0.18 * z))
            for s in (-1, 1)
        ),
        box(wood, (0.2 * x, 0.4 * x), around(0, 0.7 * y), (0.3 * z, 0.32 * z)),
    ]
    tray = top_surface("tray", (0.08 * x, 0.38 * x), around(0, 0.7 * y), seat + 0.2 * z)
    return Build(body=body, surfaces=[tray])


def mobile(spec: Spec) -> Build:
    """Return a mobile: a ring under the ceiling from which figures hang."""
    x, y, z = spec.size
    radius, level = min(x, y) / 2 - 0.04, 0.52 * z
    wood = spec.style.wood
    hoop = arc((0.0, 0.0, level), (radius, radius), (0.0, 360.0), axis=2, steps=16)
    body: list[Part] = [
        *tube(wood, hoop, 0.008),
        disc(wood, (0, 0), 0.02, (0.8 * z, 0.83 * z)),
        disc(IRON, (0, 0), 0.002, (0.83 * z, z - 0.01)),
        disc(IRON, (0, 0), 0.03, (z - 0.012, z)),
    ]
    for k in range(6):
        u, v = cos(pi * k / 3), sin(pi * k / 3)
        at, low = (radius * u, radius * v), 0.02 * z + 0.1 * z * (k % 3)
        size = min(0.08, 0.12 * z)
        paint = Finish(BRIGHT[k % len(BRIGHT)], "fabric")
        body += [
            rod(IRON, (at[0], at[1], level), (0.0, 0.0, 0.81 * z), 0.0015, sides=4),
            rod(IRON, (at[0], at[1], low + 0.9 * size), (at[0], at[1], level), 0.0015, sides=4),
            sphere(paint, (at[0], at[1], low + size / 2), size / 2)
            if k % 2
            else ellipsoid(paint, around(at[0], size), around(at[1], 0.5 * size), (low, low + size)),
        ]
    body.append(sphere(Finish((0.95, 0.82, 0.4), "fabric"), (0, 0, 0.06 * z), 0.05))
    body.append(rod(IRON, (0, 0, 0.06 * z), (0, 0, 0.81 * z), 0.0015, sides=4))
    return Build(body=body)


def cat_tree(spec: Spec) -> Build:
    """Return a cat tree: posts of rope, a house and three platforms."""
    x, y, z = spec.size
    plush = spec.main(_PLUSH)
    levels = (0.36 * z, 0.66 * z, 0.96 * z)
    body: list[Part] = [box(plush, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.03 * z))]
    house = ((-0.46 * x, 0.2 * x), (-0.46 * y, 0.1 * y))
    body += [
        box(plush, *house, (0.03 * z, 0.24 * z)),
        cylinder(
            IRON, (0.2 * x, 0.201 * x), around(-0.18 * y, 0.13 * z), around(0.13 * z, 0.13 * z), axis=0, collide=False
        ),
    ]
    posts = (
        (0.3 * x, 0.32 * y, 0.03 * z, levels[1]),
        (-0.3 * x, 0.32 * y, 0.03 * z, levels[2]),
        (-0.1 * x, -0.18 * y, 0.24 * z, levels[1]),
    )
    body += [disc(_ROPE, (u, v), 0.045, (low, high)) for u, v, low, high in posts]
    tops = ((0.16 * x, 0.2 * y, 0.5), (0.02 * x, -0.06 * y, 0.66), (-0.22 * x, 0.2 * y, 0.5))
    build = Build(body=body)
    for level, (u, v, wide) in zip(levels, tops, strict=True):
        spans = (around(u, wide * x), around(v, wide * y))
        body.append(box(plush, *spans, (level, level + 0.025 * z)))
        build.surfaces.append(
            top_surface(
                f"platform at {level:.1f} m", *spans, level + 0.025 * z, headroom=0.25 * z if level < 0.9 * z else None
            )
        )
    rim = [(spans[0], (s * wide * y / 2 + v)) for s in (-1, 1)]
    body += [cushion(plush, across, around(at * 0.98, 0.05), (0.98 * z - 0.01, z), radius=0.02) for across, at in rim]
    build.surfaces.pop()
    return build


def pet_bed(spec: Spec) -> Build:
    """Return a round bed with a soft rim, lower at the front."""
    x, y, z = spec.size
    cloth, lining = spec.main(spec.choice((spec.style.accent, Finish((0.50, 0.46, 0.42), "fabric")))), LINEN
    thick = 0.2 * min(x, y)
    body: list[Part] = [
        prism(cloth, oval(0.94 * x, 0.94 * y, sides=28), (0, 0.2 * z)),
        prism(lining, oval(x - 1.3 * thick, y - 1.3 * thick, sides=28), (0.2 * z, 0.45 * z), smooth=True),
    ]
    count = 14
    for k in range(count):
        angle = 2 * pi * k / count
        top = z * (0.58 if cos(angle) > 0.8 else 1.0)
        at = ((x - thick) / 2 * cos(angle), (y - thick) / 2 * sin(angle))
        lobe = cushion(cloth, around(at[0], thick), around(at[1], 0.34 * y), (0.04 * z, top), radius=0.45 * thick)
        body.append(turned(lobe, 2, angle * 180 / pi, (at[0], at[1], 0.0)))
    inner = (around(0, x - 2.1 * thick), around(0, y - 2.1 * thick), 0.45 * z)
    return Build(
        body=body, surfaces=[top_surface("cushion", *inner, round=True), inner_surface("nest", *inner, round=True)]
    )


def pet_carrier(spec: Spec) -> Build:
    """Return a carrier of plastic with a barred door and a handle; a cage is all bars."""
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(((0.52, 0.60, 0.66), (0.80, 0.78, 0.74))), "plastic"))
    high = 0.86 * z
    body: list[Part] = [
        cushion(GREY_PLASTIC, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.46 * high), radius=0.05),
        cushion(shell, (-0.48 * x, 0.48 * x), around(0, 0.96 * y), (0.4 * high, high), radius=0.07),
        box(IRON, (0.47 * x, 0.502 * x), around(0, 0.56 * y), (0.16 * high, 0.82 * high)),
        *(
            box(WHITE_PLASTIC, (0.5 * x, 0.508 * x), around((k - 3) * 0.09 * y, 0.008), (0.16 * high, 0.82 * high))
            for k in range(7)
        ),
    ]
    grip = arc((0.0, 0.0, high - 0.01), (0.95 * (z - high), 0.2 * x), (-90.0, 90.0), axis=1, steps=6)
    return Build(body=body + tube(GREY_PLASTIC, grip, 0.012))


def bird_cage(spec: Spec) -> Build:
    """Return a domed wire cage with a perch."""
    x, y, z = spec.size
    wire, radius, rim = spec.main(spec.style.metal), min(x, y) / 2, 0.62 * z
    body: list[Part] = [disc(wire, (0, 0), radius, (0, 0.06 * z)), sphere(wire, (0, 0, 0.97 * z), 0.03 * z)]
    for k in range(16):
        u, v = 0.95 * radius * cos(pi * k / 8), 0.95 * radius * sin(pi * k / 8)
        points = [(u, v, 0.05 * z), (u, v, rim), (0.72 * u, 0.72 * v, 0.82 * z), (0.0, 0.0, 0.95 * z)]
        body += tube(wire, points, 0.004, sides=4)
    body += tube(
        wire, arc((0.0, 0.0, rim), (0.95 * radius, 0.95 * radius), (0.0, 360.0), axis=2, steps=16), 0.005, sides=4
    )
    body.append(cylinder(spec.style.wood, around(0, 0.014), around(0, 1.86 * radius), around(0.4 * z, 0.014), axis=1))
    bird = Finish((0.95, 0.80, 0.25), "fabric")
    body += [
        ellipsoid(bird, around(0, 0.2 * radius), around(0, 0.34 * radius), (0.41 * z, 0.5 * z)),
        sphere(bird, (0, 0.14 * radius, 0.51 * z), 0.1 * radius),
    ]
    return Build(body=body)


def rocking_horse(spec: Spec) -> Build:
    """Return a horse on two runners that are flat where they touch the floor; it looks to the front."""
    x, y, z = spec.size
    wood, mane = spec.wood, Finish((0.86, 0.80, 0.68), "fabric")
    body: list[Part] = []
    for s in (-1, 1):
        at = around(s * (y / 2 - 0.02), 0.035)
        body.append(
            prism(wood, [(-0.3 * x, 0.0), (0.3 * x, 0.0), (0.38 * x, 0.06 * z), (-0.38 * x, 0.06 * z)], at, axis=1)
        )
        for t in (-1, 1):
            tip = [(t * 0.3 * x, 0.0), (t * x / 2, 0.1 * z), (t * x / 2, 0.15 * z), (t * 0.38 * x, 0.06 * z)]
            body.append(prism(wood, tip, at, axis=1))
            body.append(
                leg(
                    wood,
                    (t * 0.3 * x, s * (y / 2 - 0.03)),
                    (t * 0.18 * x, s * 0.16 * y),
                    (0.05 * z, 0.5 * z),
                    0.04,
                    0.06,
                )
            )
    neck = [(0.12 * x, 0.6 * z), (0.3 * x, 0.56 * z), (0.36 * x, 0.92 * z), (0.24 * x, 0.96 * z)]
    body += [
        cushion(wood, (-0.3 * x, 0.3 * x), around(0, 0.5 * y), (0.46 * z, 0.68 * z), radius=0.1 * z),
        prism(wood, neck, around(0, 0.22 * y), axis=1),
        cushion(wood, (0.22 * x, 0.5 * x), around(0, 0.24 * y), (0.8 * z, 0.96 * z), radius=0.04 * z),
        prism(
            mane, [(0.1 * x, 0.64 * z), (0.16 * x, 0.6 * z), (0.28 * x, z), (0.2 * x, z)], around(0, 0.1 * y), axis=1
        ),
        cylinder(Finish(BRIGHT[0], "wood"), around(0.27 * x, 0.03), around(0, 0.7 * y), around(0.76 * z, 0.03), axis=1),
        cushion(
            Finish(BRIGHT[0], "fabric"), (-0.16 * x, 0.1 * x), around(0, 0.54 * y), (0.66 * z, 0.71 * z), radius=0.02
        ),
        rod(mane, (-0.29 * x, 0, 0.62 * z), (-0.42 * x, 0, 0.36 * z), 0.03 * z),
    ]
    return Build(body=body)


def doll_house(spec: Spec) -> Build:
    """Return a doll's house, open at the front."""
    x, y, z = spec.size
    paint, roof = spec.main(Finish((0.93, 0.86, 0.80), "wood")), Finish(BRIGHT[0], "wood")
    eaves, wall = 0.72 * z, 0.012
    body: list[Part] = [
        *(box(paint, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), (wall, eaves)) for s in (-1, 1)),
        *(
            box(paint, (-x / 2, x / 2), around(0, y - 2 * wall * (h > 0)), (h * eaves, h * eaves + wall))
            for h in (0.0, 0.48)
        ),
        box(paint, (-x / 2, -x / 2 + wall), around(0, y - 2 * wall), (wall, eaves)),
        box(paint, (-x / 2 + wall, x / 2), around(0.1 * y, wall), (wall, eaves)),
        prism(paint, [(-0.5 * y, eaves), (0.5 * y, eaves), (0.0, 0.97 * z)], (-x / 2, -x / 2 + wall), axis=0),
    ]
    for s in (-1, 1):
        slope = [(s * y / 2, eaves), (s * y / 2, eaves + 0.03 * z), (0.0, z), (0.0, 0.97 * z)]
        body.append(prism(roof, slope, (-x / 2, x / 2), axis=0))
    inks = [Finish(c, "wood") for c in BRIGHT]
    body += [
        box(
            inks[k],
            around(0.1 * x, 0.3 * x),
            around((k - 1.5) * 0.2 * y, 0.12 * y),
            ((k % 2) * 0.48 * eaves + wall, (k % 2) * 0.48 * eaves + 0.2 * eaves),
        )
        for k in range(4)
    ]
    return Build(body=body)


def play_kitchen(spec: Spec) -> Build:
    """Return a child's wooden kitchen: a hob, a basin, doors and a shelf behind."""
    x, y, z = spec.size
    paint, top = spec.paint, 0.52 * z
    back = -x / 2 + 0.05 * x
    body: list[Part] = [
        box(paint, (-x / 2, 0.46 * x), (-y / 2, y / 2), (0, top - 0.03 * z)),
        box(spec.style.wood, (-x / 2, x / 2), (-y / 2, y / 2), (top - 0.03 * z, top)),
        box(paint, (-x / 2, back), (-y / 2, y / 2), (top, z)),
        *(box(paint, (back, -0.1 * x), (s * y / 2, s * (y / 2 - 0.02)), (top, z)) for s in (-1, 1)),
        box(spec.style.wood, (back, -0.1 * x), around(0, y - 0.04), (0.8 * z, 0.82 * z)),
        *(disc(IRON, (u * x, -0.25 * y), 0.16 * x, (top, top + 0.006)) for u in (-0.1, 0.26)),
        cushion(GREY_PLASTIC, around(0.1 * x, 0.5 * x), around(0.24 * y, 0.3 * y), (top, top + 0.02 * z), radius=0.01),
        rod(GREY_PLASTIC, (-0.3 * x, 0.24 * y, top), (-0.3 * x, 0.24 * y, top + 0.14 * z), 0.012),
        rod(GREY_PLASTIC, (-0.3 * x, 0.24 * y, top + 0.14 * z), (0.0, 0.24 * y, top + 0.12 * z), 0.01),
    ]
    for k, at in enumerate((-0.25, 0.25)):
        face = (0.46 * x, 0.475 * x)
        body.append(box(spec.style.wood, face, around(at * y, 0.44 * y), (0.06 * z, 0.4 * z)))
        body.append(
            cylinder(
                Finish(BRIGHT[k], "wood"), (0.475 * x, 0.49 * x), around(at * y, 0.05), around(0.36 * z, 0.05), axis=0
            )
        )
    return Build(body=body, surfaces=[top_surface("shelf", (back, -0.1 * x), around(0, y - 0.04), 0.82 * z)])


def tent(spec: Spec) -> Build:
    """Return a tent with its entrance to the front: a pointed one of poles, or a ridge tent."""
    x, y, z = spec.size
    cloth = spec.main(spec.choice((LINEN, spec.style.accent)))
    if spec.category == "play_tent":
        return _teepee(spec, cloth)
    ridge = z - 0.01
    body: list[Part] = [box(cloth, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.01))]
    for s in (-1, 1):
        slope = [(s * y / 2, 0.0), (s * (y / 2 - 0.02), 0.0), (0.0, ridge - 0.02), (0.0, ridge)]
        body.append(prism(cloth, slope, (-x / 2, x / 2), axis=0))
        body.append(rod(IRON, (s * (x / 2 - 0.01), 0, 0), (s * (x / 2 - 0.01), 0, z), 0.01))
        flap = [(s * y / 2, 0.0), (s * 0.3 * y, 0.0), (0.0, ridge - 0.02)]
        body.append(prism(cloth, flap, (x / 2 - 0.01, x / 2), axis=0))
    body.append(prism(cloth, [(-y / 2, 0.0), (y / 2, 0.0), (0.0, ridge)], (-x / 2, -x / 2 + 0.01), axis=0))
    return Build(body=body)


def _teepee(spec: Spec, cloth: Finish) -> Build:
    x, y, z = spec.size
    knot, count = 0.84 * z, 6
    corners = [(x / 2 * cos(pi / 6 + pi * k / 3), y / 2 * sin(pi / 6 + pi * k / 3)) for k in range(count)]
    body: list[Part] = []
    for k, (u, v) in enumerate(corners):
        body.append(rod(spec.style.wood, (0.95 * u, 0.95 * v, 0.0), (-0.16 * u, -0.16 * v, z), 0.014))
        if k == count - 1:
            continue
        nxt = corners[(k + 1) % count]
        body.append(_sheet(cloth, (u, v), nxt, knot))
    door = (corners[-1], corners[0])
    share = ((0.72, 0.28), (0.28, 0.72))
    mid = [(a * door[0][0] + b * door[1][0], a * door[0][1] + b * door[1][1]) for a, b in share]
    body += [_sheet(cloth, door[0], mid[0], knot), _sheet(cloth, mid[1], door[1], knot)]
    return Build(body=body)


def _sheet(cloth: Finish, a: tuple[float, float], b: tuple[float, float], top: float) -> Part:
    """A sheet from two corners on the floor up to the knot of the poles."""
    corners = [(0.96 * share * u, 0.96 * share * v, 0.0) for u, v in (a, b) for share in (1.0, 0.985)]
    return hull(cloth, [*corners, (0.06 * a[0], 0.06 * a[1], top), (0.05 * b[0], 0.05 * b[1], top)])


def litter_box(spec: Spec) -> Build:
    """Return a tray of litter with a raised rim."""
    x, y, z = spec.size
    shell, wall = spec.main(Finish((0.62, 0.66, 0.70), "plastic")), 0.02
    body: list[Part] = [
        *(box(shell, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), (0, z)) for s in (-1, 1)),
        box(shell, (-x / 2, -x / 2 + wall), around(0, y - 2 * wall), (0, z)),
        box(shell, (x / 2 - wall, x / 2), around(0, y - 2 * wall), (0, 0.6 * z)),
        box(Finish((0.80, 0.77, 0.72), "stone"), around(0, x - 2 * wall), around(0, y - 2 * wall), (0, 0.36 * z)),
    ]
    return Build(body=body)
