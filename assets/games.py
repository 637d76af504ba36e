"""Things for play, music and sport."""

from math import cos, sin

from thinkblox.assets.palette import (
    BEECH,
    BLACK_PLASTIC,
    CHROME,
    DARK_PLASTIC,
    EBONY,
    FELT,
    GREY_METAL,
    IRON,
    PAPER,
    WALNUT,
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    leg,
    oval,
    prism,
    rod,
    round_leg,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec


def pool_table(spec: Spec) -> Build:
    """Return a pool table with rails, pockets, a rack of balls and a cue; it is longest across its front."""
    x, y, z = spec.size
    wood, rail, bed = spec.main(WALNUT), 0.14, z - 0.045
    cloth = FELT
    body = [
        box(wood, around(0, x - 0.06), around(0, y - 0.06), (bed - 0.16, bed - 0.03)),
        box(cloth, around(0, x - 2 * rail + 0.04), around(0, y - 2 * rail + 0.04), (bed - 0.03, bed)),
        *(cushion(wood, (-x / 2, -x / 2 + rail), (-y / 2, y / 2), (bed - 0.03, z), radius=0.015) for s in (-1,)),
        cushion(wood, (x / 2 - rail, x / 2), (-y / 2, y / 2), (bed - 0.03, z), radius=0.015),
        *(
            cushion(
                wood,
                (-x / 2 + rail, x / 2 - rail),
                (s * (y / 2 - rail / 2) - rail / 2, s * (y / 2 - rail / 2) + rail / 2),
                (bed - 0.03, z),
                radius=0.015,
            )
            for s in (-1, 1)
        ),
    ]
    body += [
        box(cloth, (s * (x / 2 - rail) - 0.02, s * (x / 2 - rail) + 0.02), around(0, y - 2 * rail), (bed, z - 0.008))
        for s in (-1, 1)
    ]
    body += [
        box(
            cloth,
            around(0, x - 2 * rail - 0.04),
            (s * (y / 2 - rail) - 0.02, s * (y / 2 - rail) + 0.02),
            (bed, z - 0.008),
        )
        for s in (-1, 1)
    ]
    pockets = [(sx * (x / 2 - rail + 0.01), sy * (y / 2 - rail + 0.01)) for sx in (-1, 1) for sy in (-1, 0, 1)]
    body += [disc(BLACK_PLASTIC, at, 0.062, (z - 0.001, z + 0.0005), collide=False) for at in pockets]
    for sx in (-1, 1):
        body += [
            leg(
                wood,
                (sx * (x / 2 - 0.2), sy * (y / 2 - 0.22)),
                (sx * (x / 2 - 0.2), sy * (y / 2 - 0.22)),
                (0, bed - 0.16),
                0.1,
                0.17,
            )
            for sy in (-1, 1)
        ]
    body += _balls(0.18 * y, bed)
    body.append(
        rod(
            Finish((0.80, 0.64, 0.42), "wood"),
            (-0.2 * x, -0.34 * y, bed + 0.014),
            (0.1 * x, 0.1 * y, bed + 0.011),
            0.013,
            end_radius=0.006,
        )
    )
    return Build(
        body=body, surfaces=[top_surface("bed", around(0, x - 2 * rail - 0.1), around(0, y - 2 * rail - 0.1), bed)]
    )


def _balls(start: float, bed: float) -> list[Part]:
    colours = (
        (0.90, 0.72, 0.20),
        (0.20, 0.30, 0.60),
        (0.74, 0.20, 0.18),
        (0.40, 0.24, 0.48),
        (0.88, 0.46, 0.20),
        (0.16, 0.40, 0.28),
        (0.45, 0.16, 0.14),
        (0.08, 0.08, 0.09),
    )
    radius, parts, k = 0.028, [], 0
    for row in range(4):
        for place in range(row + 1):
            at = ((place - row / 2) * 2.05 * radius, start + row * 1.78 * radius, bed + radius)
            parts.append(sphere(Finish(colours[k % len(colours)], "ceramic"), at, radius))
            k += 1
    parts.append(sphere(Finish((0.95, 0.94, 0.90), "ceramic"), (0, -start, bed + radius), radius))
    return parts


def table_football(spec: Spec) -> Build:
    """Return a football table: a pitch between boards, with rods of players."""
    x, y, z = spec.size
    wood, wide = spec.main(spec.choice((WALNUT, EBONY))), min(0.7, 0.62 * x)
    floor, rods = 0.82 * z, 0.94 * z
    body = [
        box(wood, around(0, wide), (-y / 2, y / 2), (0.68 * z, floor - 0.01)),
        box(FELT, around(0, wide - 0.05), around(0, y - 0.05), (floor - 0.01, floor)),
        *(box(wood, around(s * (wide / 2 - 0.0125), 0.025), (-y / 2, y / 2), (floor - 0.01, z)) for s in (-1, 1)),
        *(box(wood, around(0, wide - 0.05), around(s * (y / 2 - 0.0125), 0.025), (floor - 0.01, z)) for s in (-1, 1)),
        *(
            leg(
                wood,
                (sx * (wide / 2 - 0.06), sy * (y / 2 - 0.08)),
                (sx * (wide / 2 - 0.07), sy * (y / 2 - 0.1)),
                (0, 0.68 * z),
                0.06,
                0.1,
            )
            for sx in (-1, 1)
            for sy in (-1, 1)
        ),
    ]
    for k in range(6):
        at, side = (k - 2.5) * 0.15 * y, 1 if k % 2 else -1
        reach = (-wide / 2 - 0.06, x / 2 - 0.1) if side > 0 else (-x / 2 + 0.1, wide / 2 + 0.06)
        body.append(cylinder(CHROME, reach, around(at, 0.016), around(rods, 0.016), axis=0))
        grip = (x / 2 - 0.1, x / 2) if side > 0 else (-x / 2, -x / 2 + 0.1)
        body.append(cylinder(BLACK_PLASTIC, grip, around(at, 0.032), around(rods, 0.032), axis=0))
        team = Finish((0.74, 0.2, 0.18) if side > 0 else (0.2, 0.32, 0.58), "plastic")
        body += [
            box(team, around((p - 1) * 0.26 * wide, 0.025), around(at, 0.02), (floor + 0.01, rods + 0.035))
            for p in range(3)
        ]
    return Build(body=body)


def table_tennis(spec: Spec) -> Build:
    """Return a table-tennis table with lines and a net."""
    x, y, z = spec.size
    top, white = z - 0.155, Finish((0.95, 0.95, 0.95), "plastic")
    body = [box(spec.main(Finish((0.14, 0.34, 0.46), "wood")), around(0, x - 0.02), (-y / 2, y / 2), (top - 0.03, top))]
    body += [
        box(white, around(a, 0.02), around(0, y), (top, top + 0.001), collide=False)
        for a in (-x / 2 + 0.02, 0, x / 2 - 0.02)
    ]
    body += [
        box(white, around(0, x - 0.02), around(s * (y / 2 - 0.01), 0.02), (top, top + 0.001), collide=False)
        for s in (-1, 1)
    ]
    body.append(box(white, (-x / 2, x / 2), around(0, 0.006), (top + 0.002, z)))
    for sy in (-1, 1):
        body += [
            box(GREY_METAL, around(sx * 0.4 * x, 0.05), around(sy * 0.35 * y, 0.05), (0, top - 0.03)) for sx in (-1, 1)
        ]
        body.append(box(GREY_METAL, around(0, 0.8 * x - 0.05), around(sy * 0.35 * y, 0.03), (0.3, 0.34)))
    halves = [
        top_surface(f"half {k + 1}", around(0, x - 0.1), (0.05, y / 2 - 0.05) if k else (-y / 2 + 0.05, -0.05), top)
        for k in range(2)
    ]
    return Build(body=body, surfaces=halves)


def arcade_cabinet(spec: Spec) -> Build:
    """Return an upright arcade machine: leaning screen, controls and a lit sign."""
    x, y, z = spec.size
    colour = spec.main(
        Finish(spec.choice(((0.20, 0.24, 0.42), (0.58, 0.20, 0.22), (0.16, 0.40, 0.40), (0.14, 0.14, 0.16))), "wood")
    )
    inner, back = (-y / 2 + 0.025, y / 2 - 0.025), -x / 2
    body: list[Part] = []
    for span in ((-y / 2, inner[0]), (inner[1], y / 2)):
        body += [
            box(colour, (back, 0.34 * x), span, (0, 0.5 * z)),
            prism(
                colour,
                [(back, 0.5 * z), (x / 2, 0.5 * z), (x / 2, 0.57 * z), (0.2 * x, 0.63 * z), (back, 0.63 * z)],
                span,
                axis=1,
            ),
            prism(
                colour, [(back, 0.63 * z), (0.2 * x, 0.63 * z), (0.02 * x, 0.84 * z), (back, 0.84 * z)], span, axis=1
            ),
            prism(
                colour,
                [(back, 0.84 * z), (0.02 * x, 0.84 * z), (0.3 * x, 0.88 * z), (0.3 * x, z), (back, z)],
                span,
                axis=1,
            ),
        ]
    body += [
        box(EBONY, (back + 0.02, 0.3 * x), inner, (0.04, 0.5 * z)),
        prism(
            DARK_PLASTIC,
            [
                (back + 0.02, 0.5 * z),
                (0.46 * x, 0.5 * z),
                (0.46 * x, 0.545 * z),
                (0.16 * x, 0.6 * z),
                (back + 0.02, 0.6 * z),
            ],
            inner,
            axis=1,
        ),
        prism(
            IRON,
            [(back + 0.02, 0.6 * z), (0.1 * x, 0.6 * z), (-0.06 * x, 0.84 * z), (back + 0.02, 0.84 * z)],
            inner,
            axis=1,
        ),
        prism(
            Finish((0.16, 0.30, 0.44), "screen"),
            [(0.086 * x, 0.63 * z), (0.094 * x, 0.63 * z), (-0.026 * x, 0.81 * z), (-0.034 * x, 0.81 * z)],
            (inner[0] + 0.05, inner[1] - 0.05),
            axis=1,
        ),
        box(Finish((0.98, 0.84, 0.48), "light"), (back + 0.02, 0.28 * x), inner, (0.885 * z, 0.985 * z)),
        box(IRON, (0.3 * x, 0.302 * x), around(0, 0.3), (0.16 * z, 0.34 * z), collide=False),
    ]
    for side, tone in ((-1, (0.80, 0.22, 0.2)), (1, (0.93, 0.74, 0.25))):
        at = (0.3 * x, side * 0.2 * y, 0.572 * z)
        body += [
            rod(CHROME, at, (at[0], at[1], at[2] + 0.05), 0.005, sides=6),
            sphere(Finish(tone, "plastic"), (at[0], at[1], at[2] + 0.06), 0.017),
        ]
        body += [
            disc(
                Finish(tone, "plastic"),
                (0.3 * x + 0.03 * (k % 2), at[1] + 0.04 + 0.03 * k),
                0.011,
                (0.565 * z, 0.585 * z),
            )
            for k in range(2)
        ]
    return Build(body=body)


def piano(spec: Spec) -> Build:
    """Return an upright piano."""
    x, y, z = spec.size
    wood, keys = spec.main(spec.choice((EBONY, WALNUT))), min(0.72, 0.62 * z)
    body = [
        box(wood, (-x / 2, -0.02 * x), (-y / 2, y / 2), (0.02, z - 0.025)),
        box(wood, (-x / 2, 0.02 * x), (-y / 2, y / 2), (z - 0.025, z)),
        box(wood, (-0.02 * x, x / 2), (-y / 2, y / 2), (keys - 0.1, keys - 0.025)),
        box(WHITE_PLASTIC, (0.08 * x, 0.46 * x), around(0, y - 0.2), (keys - 0.025, keys - 0.01)),
        box(wood, (-0.02 * x, 0.08 * x), around(0, y - 0.2), (keys - 0.025, keys + 0.05)),
        *(box(wood, (-0.02 * x, x / 2), (s * y / 2, s * (y / 2 - 0.1)), (keys - 0.025, keys + 0.04)) for s in (-1, 1)),
        *(
            leg(wood, (0.43 * x, s * (y / 2 - 0.07)), (0.43 * x, s * (y / 2 - 0.07)), (0.03, keys - 0.1), 0.05, 0.08)
            for s in (-1, 1)
        ),
        *(box(wood, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.12)), (0, 0.03)) for s in (-1, 1)),
        box(wood, (-0.02 * x, 0.0), around(0, 0.5 * y), (keys + 0.1, keys + 0.25)),
        *(
            box(Finish((0.80, 0.64, 0.38), "metal"), (-0.02 * x, 0.16 * x), around(0.09 * s, 0.03), (0.05, 0.065))
            for s in (-1, 0, 1)
        ),
    ]
    count = int((y - 0.2) / 0.024)
    for k in range(count):
        if k % 7 not in (2, 6):
            at = -y / 2 + 0.1 + (k + 1) * (y - 0.2) / count
            body.append(box(BLACK_PLASTIC, (0.08 * x, 0.32 * x), around(at, 0.011), (keys - 0.01, keys - 0.001)))
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, 0.02 * x), (-y / 2, y / 2), z)])


def guitar(spec: Spec) -> Build:
    """Return a guitar leaning in a stand."""
    x, y, z = spec.size
    lean = [turned(p, 1, -9.0, (0.0, 0.0, 0.1 * z)) for p in _guitar(spec)]
    stand = [
        rod(IRON, (-x / 2 + 0.012, s * 0.32 * y, 0.012), (x / 2 - 0.02, s * 0.32 * y, 0.012), 0.012) for s in (-1, 1)
    ]
    stand += [rod(IRON, (0.0, s * 0.32 * y, 0.012), (-0.17, 0.0, 0.46 * z), 0.01) for s in (-1, 1)]
    stand += [
        cylinder(IRON, around(0.02, 0.022), around(0, 0.7 * y), (0.1 * z - 0.01, 0.1 * z + 0.012), axis=1),
        *(box(IRON, around(0.02, 0.02), around(s * 0.32 * y, 0.02), (0.012, 0.1 * z)) for s in (-1, 1)),
    ]
    return Build(body=lean + stand)


def wall_guitar(spec: Spec) -> Build:
    """Return a guitar hung by its head from a hook on the wall."""
    z = spec.size[2]
    hook = box(IRON, (-0.08, 0.05), around(0, 0.04), around(0.86 * z, 0.02))
    plate = box(WALNUT, (-0.1, -0.08), around(0, 0.09), around(0.86 * z, 0.12))
    return Build(body=[*_guitar(spec), hook, plate])


def _guitar(spec: Spec) -> list[Part]:
    """A guitar standing upright, its strings to +x."""
    if spec.has("electric"):
        return _electric_guitar(spec)
    _, y, z = spec.size
    top, dark = spec.main(Finish((0.76, 0.50, 0.26), "wood")), WALNUT
    parts: list[Part] = []
    for at, wide, tall in ((0.30, 1.0, 0.36), (0.50, 0.74, 0.28)):
        outline = [(a, b + at * z) for a, b in oval(wide * y, tall * z, sides=24)]
        parts.append(prism(top, outline, (-0.05, 0.05), axis=0, smooth=True))
    parts += [
        box(dark, (0.045, 0.062), around(0, 0.055), (0.42 * z, 0.88 * z)),
        box(dark, (0.04, 0.06), around(0, 0.08), (0.88 * z, z)),
        cylinder(EBONY, (0.05, 0.0512), around(0, 0.1), around(0.47 * z, 0.1), axis=0, collide=False),
        box(EBONY, (0.05, 0.06), around(0, 0.16), around(0.27 * z, 0.025)),
    ]
    return parts


def _electric_guitar(spec: Spec) -> list[Part]:
    """The same with a thin solid body with two horns, pickups and a plate."""
    _, y, z = spec.size
    lacquer = spec.main(Finish(spec.choice(((0.62, 0.12, 0.12), (0.10, 0.10, 0.11), (0.24, 0.44, 0.56))), "plastic"))
    neck, thick = spec.choice((BEECH, WALNUT)), (-0.022, 0.022)
    lower = [(a, b + 0.24 * z) for a, b in oval(y, 0.3 * z, sides=24, squareness=2.4)]
    waist = [(-0.34 * y, 0.26 * z), (0.34 * y, 0.26 * z), (0.32 * y, 0.44 * z), (-0.32 * y, 0.44 * z)]
    horns = [
        [(s * 0.08 * y, 0.3 * z), (s * 0.36 * y, 0.3 * z), (s * 0.46 * y, (tip - 0.02) * z), (s * 0.4 * y, tip * z)]
        for s, tip in ((-1, 0.47), (1, 0.5))
    ]
    plate = [(-0.3 * y, 0.2 * z), (0.1 * y, 0.18 * z), (0.24 * y, 0.42 * z), (-0.28 * y, 0.44 * z)]
    return [
        *(prism(lacquer, outline, thick, axis=0) for outline in (lower, waist, *horns)),
        prism(PAPER, plate, (0.022, 0.025), axis=0),
        box(neck, (0.012, 0.036), around(0, 0.05), (0.4 * z, 0.88 * z)),
        prism(neck, [(-0.04, 0.88 * z), (0.025, 0.88 * z), (0.045, z), (-0.03, z)], (0.01, 0.026), axis=0),
        *(box(BLACK_PLASTIC, (0.022, 0.034), around(0, 0.085), around(h * z, 0.03)) for h in (0.27, 0.36)),
        box(CHROME, (0.022, 0.036), around(0, 0.09), around(0.19 * z, 0.025)),
        *(
            cylinder(CHROME, (0.022, 0.036), around(-0.32 * y, 0.024), around(h * z, 0.024), axis=0)
            for h in (0.17, 0.22)
        ),
    ]


_THRONE = 0.5
"""Depth that the drummer takes behind the drums [m]."""


def drum_kit(spec: Spec) -> Build:
    """Return a drum kit: bass, snare, two toms, two cymbals and, at -x, a stool; who listens is at +x."""
    depth, y, z = spec.size
    x = depth - _THRONE
    middle = _THRONE / 2
    shell = spec.main(Finish((0.55, 0.16, 0.16), "plastic"))
    skin = Finish((0.93, 0.92, 0.88), "plastic")
    radius = min(0.28, 0.24 * z)
    body: list[Part] = [
        cylinder(
            shell,
            (middle + x / 2 - 0.48, middle + x / 2 - 0.06),
            around(0, 2 * radius),
            (0.02, 0.02 + 2 * radius),
            axis=0,
        )
    ]
    body.append(
        cylinder(
            skin,
            (middle + x / 2 - 0.06, middle + x / 2 - 0.05),
            around(0, 1.9 * radius),
            around(0.02 + radius, 1.9 * radius),
            axis=0,
        )
    )
    body += [
        box(CHROME, (middle + x / 2 - 0.14, middle + x / 2 - 0.1), (s * 0.3 - 0.05, s * 0.3 + 0.05), (0, 0.05))
        for s in (-1, 1)
    ]
    body += [
        rod(CHROME, (middle + x / 2 - 0.12, s * 0.32, 0.01), (middle + x / 2 - 0.14, s * 0.9 * radius, radius), 0.01)
        for s in (-1, 1)
    ]
    drums = ((middle - 0.12 * x, 0.27 * y, 0.6, 0.17, 0.14), (middle - 0.1 * x, -0.3 * y, 0.55, 0.2, 0.38))
    for ax, ay, top, r, tall in drums:
        body += [disc(shell, (ax, ay), r, (top - tall, top - 0.01)), disc(skin, (ax, ay), r * 0.98, (top - 0.01, top))]
        body += [
            round_leg(
                CHROME,
                (ax + 0.9 * r * cos(a), ay + 0.9 * r * sin(a)),
                (ax + 0.6 * r * cos(a), ay + 0.6 * r * sin(a)),
                (0, top - tall),
                0.01,
                0.01,
            )
            for a in (0.5, 2.6, 4.7)
        ]
    for s in (-1, 1):
        at = (middle + x / 2 - 0.27, 0.17 * s)
        body += [
            disc(shell, at, 0.15, (2 * radius + 0.07, 2 * radius + 0.23)),
            disc(skin, at, 0.148, (2 * radius + 0.23, 2 * radius + 0.24)),
            disc(CHROME, at, 0.015, (2 * radius, 2 * radius + 0.07)),
        ]
        tip = (middle + 0.18 * x, s * (y / 2 - 0.2))
        body += [
            disc(CHROME, tip, 0.01, (0.12, z - 0.02)),
            disc(Finish((0.83, 0.68, 0.34), "metal"), tip, 0.2, (z - 0.03, z - 0.022)),
            disc(CHROME, tip, 0.015, (z - 0.022, z)),
        ]
        body += [
            round_leg(CHROME, (tip[0] + 0.18 * cos(a), tip[1] + 0.18 * sin(a)), tip, (0, 0.2), 0.009, 0.009)
            for a in (0.0, 2.1, 4.2)
        ]
    seat = (-depth / 2 + 0.17, 0.0)
    body += [disc(BLACK_PLASTIC, seat, 0.16, (0.42, 0.5)), disc(CHROME, seat, 0.015, (0.1, 0.42))]
    body += [
        round_leg(CHROME, (seat[0] + 0.15 * cos(a), 0.15 * sin(a)), seat, (0, 0.15), 0.01, 0.01)
        for a in (0.0, 2.1, 4.2)
    ]
    return Build(body=body)
