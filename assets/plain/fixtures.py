"""Plain pieces for one trade: what a salon, a surgery, a laboratory, a garden and a hall are known by."""

from thinkblox.assets.palette import BLACK_PLASTIC, CHROME, GREY_METAL, IRON, MIRROR, PAPER, PORCELAIN, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, Range, hull
from thinkblox.assets.shapes import around, box, cushion, cylinder, prism, rod, top_surface
from thinkblox.assets.spec import Spec


def mirror_station(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a tall mirror over a shelf with drawers, at which one is made up or has the hair cut."""
    x, y, z = spec.size
    finish, back, level = spec.main(main), -0.5 * x + 0.1 * x, 0.42 * z
    body: list[Part] = [
        box(finish, (-x / 2, back), (-y / 2, y / 2), (0, z)),
        box(MIRROR, (back, back + 0.006), around(0, 0.86 * y), (0.48 * z, 0.97 * z), collide=False),
        box(finish, (back, x / 2), (-y / 2, y / 2), (level - 0.03, level)),
        *(box(finish, (back, 0.4 * x), (s * y / 2, s * (y / 2 - 0.03)), (0, level - 0.03)) for s in (-1, 1)),
    ]
    for s in (-1, 1):
        side = around(s * 0.26 * y, 0.4 * y)
        body.append(box(finish, (back, 0.42 * x), side, (0.3 * z, level - 0.03)))
        body.append(box(accent, (0.42 * x, 0.45 * x), around(s * 0.26 * y, 0.14 * y), around(0.36 * z, 0.012)))
    return Build(body=body, surfaces=[top_surface("shelf", (back + 0.02, x / 2), (-y / 2, y / 2), level)])


def backwash(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a reclining seat before a pedestal with a basin of the accent for the head."""
    x, y, z = spec.size
    cover, wall = spec.main(main), 0.05 * y
    rear, lip = -x / 2, -0.16 * x
    low, rim = 0.7 * z, 0.94 * z
    body: list[Part] = [
        box(cover, (rear + 0.04 * x, lip - 0.04 * x), around(0, 0.5 * y), (0, low)),
        box(accent, (rear, lip), around(0, 0.84 * y), (low, low + 0.05 * z)),
        box(accent, (rear, rear + wall), around(0, 0.84 * y), (low, rim)),
        box(accent, (lip - wall, lip), around(0, 0.84 * y), (low, 0.86 * z)),
        *(box(accent, (rear, lip), (s * 0.42 * y, s * (0.42 * y - wall)), (low, rim)) for s in (-1, 1)),
        rod(CHROME, (rear + 2 * wall, 0, low), (rear + 2 * wall, 0, z - 0.01), 0.01),
        rod(CHROME, (rear + 2 * wall, 0, z - 0.011), (rear + 0.16 * x, 0, z - 0.011), 0.01),
        box(IRON, (-0.06 * x, 0.3 * x), around(0, 0.5 * y), (0, 0.34 * z)),
        cushion(cover, (-0.12 * x, 0.36 * x), around(0, 0.8 * y), (0.34 * z, 0.46 * z), radius=0.04),
    ]
    back = [(lip + 0.01, 0.86 * z), (lip + 0.1 * x, 0.88 * z), (0.02 * x, 0.44 * z), (-0.1 * x, 0.36 * z)]
    body.append(prism(cover, back, around(0, 0.78 * y), axis=1))
    rest = [(0.34 * x, 0.36 * z), (0.34 * x, 0.46 * z), (x / 2, 0.28 * z), (x / 2 - 0.04, 0.22 * z)]
    body.append(prism(cover, rest, around(0, 0.7 * y), axis=1))
    for s in (-1, 1):
        arm = (s * y / 2, s * 0.4 * y)
        body += [
            cushion(cover, (-0.1 * x, 0.26 * x), arm, (0.56 * z, 0.62 * z), radius=0.02),
            box(IRON, around(0.08 * x, 0.06 * x), around(s * 0.44 * y, 0.04 * y), (0.38 * z, 0.57 * z)),
        ]
    seat = top_surface("seat", (0.02 * x, 0.34 * x), around(0, 0.72 * y), 0.46 * z)
    return Build(body=body, surfaces=[seat])


def couch(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a padded table on legs, with a pillow at its left end and a strip of paper over it."""
    x, y, z = spec.size
    pillow = min(0.07, 0.1 * z)
    top = z - pillow
    body: list[Part] = [
        cushion(spec.main(main), (-x / 2, x / 2), (-y / 2, y / 2), (top - 0.1, top), radius=0.03),
        cushion(spec.main(main), around(0, 0.62 * x), (0.5 * y - 0.34, 0.5 * y - 0.04), (top - 0.03, z), radius=0.03),
        box(PAPER, around(0, 0.74 * x), (-0.46 * y, y / 2 - 0.36), (top, top + 0.002), collide=False),
        box(accent, around(0, 0.84 * x), around(0, 0.94 * y), (top - 0.13, top - 0.09)),
        cylinder(PAPER, around(0, 0.6 * x), (y / 2 - 0.09, y / 2 - 0.01), (top - 0.2, top - 0.12), axis=0),
    ]
    for s in (-1, 1):
        for t in (-1, 1):
            at = (around(s * 0.38 * x, 0.045), around(t * 0.42 * y, 0.045))
            body.append(box(accent, *at, (0, top - 0.12)))
        body.append(box(accent, around(s * 0.38 * x, 0.03), around(0, 0.82 * y), around(0.22 * z, 0.03)))
    body += [box(accent, around(0, 0.74 * x), around(t * 0.42 * y, 0.03), around(0.22 * z, 0.03)) for t in (-1, 1)]
    free = top_surface("top", around(0, x - 0.04), (-y / 2 + 0.02, y / 2 - 0.36), top + 0.002)
    return Build(body=body, surfaces=[free])


def lab_bench(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a bench with a dark top, cupboards and drawers on either side of room for the knees, and a sink."""
    x, y, z = spec.size
    finish, slab, front = spec.main(main), z - 0.035, 0.42 * x
    body: list[Part] = [
        box(accent, (-x / 2, x / 2), (-y / 2, y / 2), (slab, z)),
        box(finish, (-0.47 * x, -0.42 * x), around(0, 0.96 * y), (0.1 * z, slab)),
        box(finish, (-0.42 * x, front), around(0, 0.3 * y), (slab - 0.14 * z, slab)),
        *_pull((front, 0.45 * x), 0.0, (slab - 0.13 * z, slab - 0.01), 0.27 * y, finish),
    ]
    for s in (-1, 1):
        side = around(s * 0.32 * y, 0.33 * y)
        body.append(box(GREY_METAL, (-0.45 * x, 0.36 * x), around(s * 0.32 * y, 0.3 * y), (0, 0.1 * z)))
        body.append(box(finish, (-0.42 * x, front), side, (0.1 * z, slab)))
        body += _pull((front, 0.45 * x), s * 0.32 * y, (slab - 0.2 * z, slab - 0.01), 0.31 * y, finish)
        for t in (-1, 1):
            door = ((0.11 * z, slab - 0.215 * z), 0.15 * y)
            body += _pull((front, 0.45 * x), (s * 0.32 + t * 0.08) * y, *door, finish, upright=True)
    basin = (around(-0.04 * x, 0.5 * x), around(0.38 * y, 0.16 * y))
    body.append(box(BLACK_PLASTIC, *basin, (z - 0.001, z + 0.001), collide=False))
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, x / 2), (-y / 2, 0.29 * y), z)])


def _pull(x: Range, middle: float, z: Range, wide: float, finish: Finish, *, upright: bool = False) -> list[Part]:
    """The front of a drawer or a door with its handle [m]."""
    level, long = (z[0] + z[1]) / 2, min(0.12, 0.5 * wide)
    grip = (
        (around(middle, 0.014), around(z[1] - 0.1, 0.12)) if upright else (around(middle, long), around(level, 0.014))
    )
    return [
        box(finish, x, around(middle, wide), z),
        box(GREY_METAL, (x[1], x[1] + 0.02), *grip, collide=False),
    ]


def potting_bench(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a bench of boards with a slatted shelf below, and a board with a narrow shelf at its back."""
    x, y, z = spec.size
    finish, level, post = spec.main(main), 0.64 * z, 0.06
    body: list[Part] = []
    for t in (-1, 1):
        side = (t * y / 2, t * (y / 2 - post))
        body += [
            box(finish, (-x / 2, -x / 2 + post), side, (0, z - 0.02)),
            box(finish, (x / 2 - post, x / 2), side, (0, level - 0.03)),
            box(finish, (-x / 2 + post, x / 2 - post), side, (0.16 * z, 0.16 * z + 0.05)),
            box(finish, (-x / 2 + post, x / 2), (t * y / 2, t * (y / 2 - 0.02)), (level, level + 0.07)),
        ]
    slats = 5
    for k in range(slats):
        at = around((k - (slats - 1) / 2) * (x / slats), 0.94 * x / slats)
        body.append(box(finish, at, (-y / 2, y / 2), (level - 0.03, level)))
        if 0 < k < slats - 1:
            body.append(box(finish, at, around(0, y - 0.01), (0.16 * z + 0.05, 0.16 * z + 0.07)))
    body += [
        box(finish, (-x / 2, -x / 2 + 0.02), around(0, y - 2 * post), (level, 0.86 * z)),
        box(finish, (-x / 2, -x / 2 + 0.3 * x), (-y / 2, y / 2), (z - 0.02, z)),
        *(
            box(accent, (-x / 2 + 0.02, -x / 2 + 0.06), around(k * 0.2 * y, 0.02), around(0.78 * z, 0.02))
            for k in (-1, 1)
        ),
    ]
    top = top_surface("top", (-x / 2 + 0.32 * x, x / 2), around(0, y - 0.05), level)
    below = top_surface("lower", around(0, 0.55 * x), around(0, y - 2 * post), 0.16 * z + 0.07, headroom=0.3 * z)
    return Build(body=body, surfaces=[top, below, top_surface("shelf", (-x / 2, -0.2 * x), (-y / 2, y / 2), z)])


def slatted_table(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a table of slats in a rim, on four thin legs with a brace, for the garden and for plants."""
    x, y, z = spec.size
    finish, rim, thick = spec.main(main), 0.035, 0.03
    body: list[Part] = [
        *(box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - rim)), (z - thick, z)) for s in (-1, 1)),
        *(box(finish, (s * x / 2, s * (x / 2 - rim)), around(0, y - 2 * rim), (z - thick, z)) for s in (-1, 1)),
    ]
    count = max(4, round((y - 2 * rim) / 0.09))
    pitch = (y - 2 * rim) / count
    for k in range(count):
        at = around((k - (count - 1) / 2) * pitch, pitch - 0.012)
        body.append(box(finish, around(0, x - 2 * rim), at, (z - thick, z - 0.004)))
    post = 0.035
    for t in (-1, 1):
        for s in (-1, 1):
            foot, head = s * (x / 2 - post), s * (0.5 * x - 2 * post)
            beside = t * (y / 2 - 1.5 * post)
            body.append(rod(accent, (foot, beside, 0.0), (head, beside, z - thick), post / 2))
        low = 0.32 * z
        body.append(box(accent, around(0, x - 3 * post), around(t * (y / 2 - 1.5 * post), 0.02), around(low, 0.02)))
    body.append(box(accent, around(0, 0.02), around(0, y - 3 * post), around(0.32 * z, 0.02)))
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def column_scale(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a scale that one stands on: a plate with a mat, a column at its back, a beam with a weight at its top."""
    x, y, z = spec.size
    finish, column = spec.main(main), -0.4 * x
    return Build(
        body=[
            cushion(finish, (-x / 2, x / 2), around(0, 0.84 * y), (0, 0.08), radius=0.012),
            box(BLACK_PLASTIC, (-0.28 * x, 0.46 * x), around(0, 0.7 * y), (0.07, 0.084)),
            box(finish, around(column, 0.08 * x), around(0, 0.14 * y), (0.06, 0.93 * z)),
            box(accent, around(column, 0.1 * x), (-y / 2, y / 2), (0.9 * z, 0.925 * z)),
            box(WHITE_PLASTIC, (column, column + 0.08 * x), around(0, 0.8 * y), (0.84 * z, 0.9 * z)),
            box(IRON, around(column + 0.04 * x, 0.14 * x), around(-0.12 * y, 0.1 * y), (0.885 * z, 0.95 * z)),
            box(IRON, around(column + 0.04 * x, 0.12 * x), around(0.24 * y, 0.06 * y), (0.885 * z, 0.94 * z)),
            box(accent, around(column, 0.03 * x), around(0, 0.05 * y), (0.93 * z, z)),
        ],
        surfaces=[top_surface("plate", (-0.28 * x, 0.46 * x), around(0, 0.7 * y), 0.084)],
    )


def longcase(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a tall clock: a plinth, a waist with a pendulum behind glass, and a hood with a dial."""
    x, y, z = spec.size
    finish, face = spec.main(main), 0.47 * x
    dial = min(0.36 * y, 0.09 * z)
    centre, waist = 0.81 * z, 0.4 * x
    gable = [(-0.46 * y, 0.93 * z), (0.46 * y, 0.93 * z), (0.12 * y, z), (-0.12 * y, z)]
    body: list[Part] = [
        box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.06 * z)),
        box(finish, (-x / 2, 0.46 * x), around(0, 0.92 * y), (0.06 * z, 0.26 * z)),
        box(finish, (-x / 2, x / 2), around(0, 0.96 * y), (0.26 * z, 0.285 * z)),
        box(finish, (-x / 2, waist), around(0, 0.7 * y), (0.285 * z, 0.69 * z)),
        box(IRON, (waist, waist + 0.004), around(0, 0.42 * y), (0.32 * z, 0.66 * z), collide=False),
        box(accent, (waist, waist + 0.012), around(0, 0.03 * y), (0.42 * z, 0.65 * z), collide=False),
        _dial(accent, (waist, waist + 0.02), 0.0, 0.41 * z, 0.12 * y),
        box(finish, (-x / 2, x / 2), around(0, 0.98 * y), (0.69 * z, 0.715 * z)),
        box(finish, (-x / 2, face), around(0, 0.86 * y), (0.715 * z, 0.93 * z)),
        prism(finish, gable, (-x / 2, face), axis=0),
        _dial(accent, (face, face + 0.004), 0.0, centre, 1.1 * dial),
        _dial(PORCELAIN, (face, face + 0.007), 0.0, centre, dial),
    ]
    for k in range(4):
        side, up = ((0.84, 0.0), (-0.84, 0.0), (0.0, 0.84), (0.0, -0.84))[k]
        spot = (around(side * dial, 0.012), around(centre + up * dial, 0.012))
        body.append(box(BLACK_PLASTIC, (face, face + 0.009), *spot, collide=False))
    hands = ((0.0, 0.0, 0.74 * dial), (0.5 * dial, 0.25 * dial, 0.0))
    body.append(
        box(BLACK_PLASTIC, (face, face + 0.009), around(0, 0.01), (centre, centre + hands[0][2]), collide=False)
    )
    tip = [(a, 0.01 * s, centre) for a in (face, face + 0.009) for s in (-1, 1)]
    tip += [(a, -hands[1][0], centre + hands[1][1] + 0.008 * s) for a in (face, face + 0.009) for s in (-1, 1)]
    body.append(hull(BLACK_PLASTIC, tip, collide=False))
    return Build(body=body)


def _dial(finish: Finish, x: Range, y: float, z: float, radius: float) -> Part:
    return cylinder(finish, x, around(y, 2 * radius), around(z, 2 * radius), axis=0, collide=False)
