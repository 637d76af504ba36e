"""Counters, lecterns, hearths and other fixtures of rooms where people are served or gather."""

from itertools import pairwise
from math import cos, pi, sin

from thinkblox.assets.palette import (
    BLACK_PLASTIC,
    BRASS,
    CONCRETE,
    GLASS,
    IRON,
    LEAVES,
    MARBLE,
    PAPER,
    SCREEN,
    SOIL,
    STEEL,
)
from thinkblox.assets.part import Build, Finish, Part, Range, hull, turned
from thinkblox.assets.plants import kept_inside, leaf
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    frustum,
    inner_surface,
    prism,
    rod,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc, tube


def counter(spec: Spec) -> Build:
    """Return a shop counter: a slatted front to the customer at +x, a shelf on the other side, none when "open"."""
    x, y, z = spec.size
    wood = spec.wood
    front = spec.main(spec.choice((spec.style.paint, spec.style.wood)))
    top = MARBLE if front == wood and not spec.has("wooden") else wood
    build = Build()
    build.body = [
        box(top, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.04, z)),
        box(front, (x / 2 - 0.08, x / 2 - 0.055), (-y / 2 + 0.03, y / 2 - 0.03), (0.08, z - 0.04)),
        box(IRON, (x / 2 - 0.12, x / 2 - 0.09), (-y / 2 + 0.05, y / 2 - 0.05), (0, 0.08)),
        *(
            box(front, (-x / 2 + 0.03, x / 2 - 0.055), (s * (y / 2 - 0.03), s * (y / 2 - 0.005)), (0, z - 0.04))
            for s in (-1, 1)
        ),
    ]
    count = max(4, int((y - 0.1) / 0.09))
    build.body += [
        box(
            wood,
            (x / 2 - 0.055, x / 2 - 0.035),
            around(-y / 2 + 0.05 + (k + 0.5) * (y - 0.1) / count, 0.6 * (y - 0.1) / count),
            (0.1, z - 0.05),
        )
        for k in range(count)
    ]
    build.surfaces = [top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z)]
    if not spec.has("open"):
        area = ((-x / 2 + 0.05, x / 2 - 0.08), (-y / 2 + 0.03, y / 2 - 0.03))
        build.body.append(box(front, *area, (0.42 * z, 0.42 * z + 0.02)))
        build.surfaces.append(top_surface("shelf", *area, 0.42 * z + 0.02, headroom=0.58 * z - 0.06))
    return build


def podium(spec: Spec) -> Build:
    """Return a lectern; the speaker stands at -x, and the audience sees its front."""
    x, y, z = spec.size
    wood = spec.wood
    body = [
        box(wood, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.05)),
        box(wood, (0.1 * x, 0.1 * x + 0.03), around(0, 0.8 * y), (0.05, z - 0.16)),
        *(box(wood, (-0.3 * x, 0.1 * x), around(s * 0.385 * y, 0.025), (0.05, z - 0.16)) for s in (-1, 1)),
        box(wood, (-x / 2, 0.26 * x), around(0, 0.94 * y), (z - 0.16, z - 0.13)),
        *(box(wood, (0.22 * x, 0.26 * x), around(s * 0.42 * y, 0.04), (z - 0.13, z)) for s in (-1, 1)),
        rod(IRON, (0.23 * x, 0.32 * y, z - 0.14), (0.2 * x, 0.26 * y, z - 0.006), 0.006),
    ]
    top = top_surface("desk", (-x / 2, 0.18 * x), around(0, 0.9 * y), z - 0.13)
    return Build(body=body, surfaces=[top])


def altar(spec: Spec) -> Build:
    """Return an altar: a slab on a block with a step, and a cloth that falls over its front."""
    x, y, z = spec.size
    stone = spec.main(spec.choice((MARBLE, CONCRETE, spec.style.wood)))
    cloth, edge, thin = Finish((0.93, 0.92, 0.88), "fabric"), x / 2 - 0.008, 0.006
    body = [
        box(stone, around(0, 0.92 * x), around(0, 0.94 * y), (0, 0.08)),
        box(stone, around(0, 0.72 * x), around(0, 0.8 * y), (0.08, z - 0.1)),
        box(stone, (-x / 2, edge), (-y / 2, y / 2), (z - 0.1, z - thin)),
        box(cloth, (-x / 2, x / 2), around(0, 0.6 * y), (z - thin, z)),
        box(cloth, (edge, x / 2), around(0, 0.6 * y), (z - 0.34, z - thin)),
        box(BRASS, (edge, x / 2), around(0, 0.6 * y), (z - 0.36, z - 0.34)),
        box(stone, (-x / 2, edge), (0.3 * y, y / 2), (z - thin, z)),
        box(stone, (-x / 2, edge), (-y / 2, -0.3 * y), (z - thin, z)),
    ]
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, edge), (-y / 2, y / 2), z)])


def fireplace(spec: Spec) -> Build:
    """Return a mantelpiece with logs and fire; "empty" without them."""
    x, y, z = spec.size
    stone = spec.main(spec.choice((MARBLE, CONCRETE, spec.style.paint)))
    inner, head = 0.3 * y, 0.7 * z
    body = [
        *(box(stone, (-x / 2, 0.36 * x), (s * inner, s * (y / 2 - 0.03)), (0.04, z - 0.05)) for s in (-1, 1)),
        box(stone, (-x / 2, 0.36 * x), (-inner, inner), (head, z - 0.05)),
        box(stone, (-x / 2, -x / 2 + 0.02), (-inner, inner), (0.04, head)),
        box(Finish((0.16, 0.13, 0.12), "stone"), (-x / 2 + 0.02, -x / 2 + 0.05), (-inner, inner), (0.04, head)),
        box(stone, (-x / 2, x / 2), (-y / 2 + 0.02, y / 2 - 0.02), (0, 0.04)),
        cushion(stone, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.05, z), radius=0.012),
    ]
    if spec.has("empty"):
        hearth = inner_surface("hearth", (-x / 2 + 0.05, 0.36 * x), (-inner, inner), 0.04, headroom=head - 0.04)
        mantelpiece = top_surface("mantelpiece", (-x / 2, x / 2), (-y / 2, y / 2), z)
        return Build(body=body, surfaces=[mantelpiece, hearth])
    log = Finish((0.36, 0.24, 0.16), "wood")
    body += [
        cylinder(log, around(a, 0.09), around(0, 0.42), around(h, 0.09), axis=1)
        for a, h in ((-0.1 * x, 0.085), (0.16 * x, 0.085), (0.03 * x, 0.16))
    ]
    for k, at in enumerate((-0.12, 0.0, 0.11)):
        body.append(
            frustum(
                Finish((1.0, 0.62 + 0.1 * (k % 2), 0.25), "light"),
                (0.03 * x, at),
                (0.205, 0.34 + 0.06 * (k % 2)),
                0.045,
                0.004,
                sides=8,
            )
        )
    return Build(body=body, surfaces=[top_surface("mantelpiece", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def bar_counter(spec: Spec) -> Build:
    """Return a bar: a counter with a brass foot rail on the guests' side at +x."""
    build = counter(spec)
    x, y, _ = spec.size
    build.body.append(cylinder(BRASS, (x / 2 - 0.03, x / 2), (-y / 2 + 0.05, y / 2 - 0.05), (0.17, 0.2), axis=1))
    return build


def planter(spec: Spec) -> Build:
    """Return a long trough of low plants."""
    x, y, z = spec.size
    low = 0.56 * z
    body: list[Part] = [
        box(spec.wood, around(0, x), (-y / 2, y / 2), (0, low)),
        box(SOIL, around(0, 0.8 * x), around(0, y - 0.06), (low, low + 0.01)),
    ]
    count = max(3, int(y / 0.2))
    for k in range(count):
        at = -y / 2 + (k + 0.5) * y / count
        grown = [
            leaf(LEAVES[(k + j) % 4], (0, at, low), 40 + 72 * j + 50 * k, 80 - 9 * j, 0.44 * z, 0.07, droop=10)
            for j in range(5)
        ]
        body += kept_inside(grown, (x / 2, y / 2), z)
    return Build(body=body)


def clothes_rack(spec: Spec) -> Build:
    """Return a rail of clothes on hangers."""
    x, y, z = spec.size
    body: list[Part] = [cylinder(IRON, around(0, 0.03), (-y / 2 + 0.05, y / 2 - 0.05), (z - 0.03, z), axis=1)]
    for s in (-1, 1):
        at = s * (y / 2 - 0.06)
        body += [
            box(IRON, around(0, 0.03), around(at, 0.03), (0.03, z - 0.03)),
            box(IRON, (-x / 2, x / 2), around(at, 0.04), (0, 0.03)),
        ]
    tones = (
        (0.84, 0.80, 0.72),
        (0.32, 0.38, 0.46),
        (0.74, 0.46, 0.36),
        (0.55, 0.60, 0.50),
        (0.20, 0.20, 0.22),
        (0.90, 0.88, 0.86),
    )
    count = max(4, int((y - 0.3) / 0.09))
    for k in range(count):
        at = -y / 2 + 0.15 + (k + 0.5) * (y - 0.3) / count
        cloth = Finish(spec.choice(tones), "fabric")
        low = z - spec.between(0.75, 1.1)
        width = min(x, 0.44)
        outline = [
            (-0.5 * width, low),
            (0.5 * width, low),
            (0.46 * width, z - 0.16),
            (0.1 * width, z - 0.07),
            (-0.1 * width, z - 0.07),
            (-0.46 * width, z - 0.16),
        ]
        body.append(prism(cloth, outline, around(at, 0.035), axis=1))
        body.append(disc(STEEL, (0, at), 0.003, (z - 0.07, z - 0.03)))
    return Build(body=body)


def dentist_chair(spec: Spec) -> Build:
    """Return a treatment chair: leaning back, with a lamp on an arm."""
    x, y, z = spec.size
    cover = spec.main(Finish((0.46, 0.62, 0.66), "leather"))
    shell, seat = Finish((0.90, 0.90, 0.89), "plastic"), 0.52
    body: list[Part] = [
        cushion(shell, (-0.12 * x, 0.2 * x), around(0, 0.42), (0, 0.08), radius=0.03),
        box(shell, (-0.04 * x, 0.12 * x), around(0, 0.24), (0.08, seat - 0.12)),
        cushion(cover, (-0.14 * x, 0.2 * x), around(0, 0.56), (seat - 0.12, seat), radius=0.04),
        turned(
            cushion(cover, (0.19 * x, 0.48 * x), around(0, 0.48), (seat - 0.11, seat - 0.01), radius=0.04),
            1,
            14.0,
            (0.19 * x, 0, seat),
        ),
        turned(
            cushion(cover, (-0.46 * x, -0.13 * x), around(0, 0.54), (seat - 0.11, seat), radius=0.04),
            1,
            32.0,
            (-0.13 * x, 0, seat),
        ),
        *(
            cushion(shell, (-0.16 * x, 0.08 * x), around(s * 0.32, 0.07), (seat + 0.12, seat + 0.17), radius=0.02)
            for s in (-1, 1)
        ),
        *(box(shell, around(-0.04 * x, 0.06), around(s * 0.32, 0.04), (seat - 0.1, seat + 0.12)) for s in (-1, 1)),
        *(
            box(
                shell,
                around(-0.04 * x, 0.06),
                (min(s * 0.26, s * 0.34), max(s * 0.26, s * 0.34)),
                (seat - 0.11, seat - 0.07),
            )
            for s in (-1, 1)
        ),
        disc(shell, (0.0, y / 2 - 0.12), 0.03, (0.05, 0.8 * z)),
        box(shell, (-0.03, 0.2 * x), (0.1, y / 2 - 0.12), (0.02, 0.06)),
        rod(shell, (0.0, y / 2 - 0.12, 0.8 * z), (-0.2 * x, 0.05, z - 0.06), 0.018),
        cushion(
            Finish((1.0, 0.97, 0.90), "light"),
            around(-0.2 * x, 0.2),
            around(0.0, 0.3),
            (z - 0.12, z - 0.02),
            radius=0.03,
        ),
        box(BLACK_PLASTIC, around(-0.2 * x, 0.05), around(0, 0.05), (z - 0.02, z)),
    ]
    return Build(body=body)


def display_case(spec: Spec) -> Build:
    """Return a glass case on a plinth, with a cloth on which things are shown."""
    x, y, z = spec.size
    wood, low = spec.wood, 0.6 * z
    pane = 0.008
    cloth = Finish(spec.style.accent.colour, "fabric")
    area = (around(0, x - 0.06), around(0, y - 0.06))
    body = [
        box(wood, around(0, x - 0.04), around(0, y - 0.04), (0.06, low - 0.03)),
        box(IRON, around(0, x - 0.1), around(0, y - 0.1), (0, 0.06)),
        box(wood, (-x / 2, x / 2), (-y / 2, y / 2), (low - 0.03, low)),
        box(cloth, *area, (low, low + 0.01)),
        *(
            box(GLASS, around(0, x - 0.02), (s * (y / 2 - 0.01), s * (y / 2 - 0.01 - pane)), (low, z - pane))
            for s in (-1, 1)
        ),
        *(
            box(GLASS, (s * (x / 2 - 0.01), s * (x / 2 - 0.01 - pane)), around(0, y - 0.02 - 2 * pane), (low, z - pane))
            for s in (-1, 1)
        ),
        box(GLASS, around(0, x - 0.02), around(0, y - 0.02), (z - pane, z)),
    ]
    if not spec.has("empty"):
        body += _shown(spec, y - 0.06, low + 0.01, z - low - 0.06)
    inside = inner_surface("cloth", *area, low + 0.01, headroom=z - low - 0.02 - pane)
    return Build(body=body, surfaces=[top_surface("top", around(0, x - 0.02), around(0, y - 0.02), z), inside])


def _shown(spec: Spec, width: float, base: float, most: float) -> list[Part]:
    """What is shown along the back of a glass case: boxes, books on edge and small stands, so wide and high [m]."""
    parts: list[Part] = []
    count = max(2, int(width / 0.22))
    for n in range(count):
        at = width * ((n + 0.5) / count - 0.5)
        tall = spec.between(0.3, 0.8) * min(most, 0.3)
        colour = spec.choice(
            ((0.62, 0.24, 0.2), (0.2, 0.3, 0.42), (0.85, 0.72, 0.42), (0.36, 0.46, 0.36), (0.9, 0.88, 0.82))
        )
        wide = spec.between(0.08, 0.15)
        parts.append(
            box(Finish(colour, "paper"), around(-0.25 * spec.size[0], 0.05), around(at, wide), (base, base + tall))
        )
    return parts


def pastry_case(spec: Spec) -> Build:
    """Return a glass case of cakes and pastries on two levels: low for a counter, or on a closed base."""
    x, y, z = spec.size
    shell = spec.wood if z > 0.8 else spec.main(STEEL)
    low, pane = 0.46 * z if z > 0.8 else 0.12 * z, 0.008
    middle, roof = (low + z) / 2, z - 0.02
    tray, shelf = (around(0, x - 0.06), around(0, y - 0.06)), ((-x / 2 + 0.03, 0.12 * x), around(0, y - 0.06))
    body = [
        box(IRON, around(0, x - 0.06), around(0, y - 0.06), (0, 0.3 * low)),
        box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0.3 * low, low)),
        box(PAPER, *tray, (low, low + 0.006)),
        box(STEEL, *shelf, (middle - 0.01, middle)),
        *(box(GLASS, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - pane)), (low, roof)) for s in (-1, 1)),
        box(GLASS, (x / 2 - pane, x / 2), around(0, y - 2 * pane), (low, roof)),
        *(box(STEEL, (-x / 2, -x / 2 + 0.02), around(s * (y / 2 - 0.02), 0.02), (low, roof)) for s in (-1, 1)),
        box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (roof, z)),
    ]
    levels = ((tray, low + 0.006, middle - low - 0.016), (shelf, middle, roof - middle))
    if not spec.has("empty"):
        body += [part for area, level, room in levels for part in _pastries(spec, area, level, 0.7 * room)]
    return Build(
        body=body,
        surfaces=[
            top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z),
            *(
                inner_surface(name, *area, level, headroom=room)
                for name, (area, level, room) in zip(("tray", "shelf"), levels, strict=True)
            ),
        ],
    )


def _pastries(spec: Spec, area: tuple[Range, Range], level: float, most: float) -> list[Part]:
    """Cakes and loaves by turns in a line along an area, no higher than `most` [m]."""
    depth, width = (high - low for low, high in area)
    at, parts = sum(area[0]) / 2, list[Part]()
    count = max(2, int(width / 0.26))
    radius, first = min(0.36 * width / count, 0.44 * depth), int(spec.rng.integers(2))
    for k in range(count):
        middle, tall = (k + 0.5) * width / count - width / 2, min(most, spec.between(0.08, 0.12))
        if (k + first) % 2:
            icing = Finish(spec.choice(((0.95, 0.90, 0.82), (0.45, 0.28, 0.18), (0.93, 0.72, 0.74))), "plastic")
            parts += [
                disc(icing, (at, middle), radius, (level, level + 0.85 * tall)),
                disc(Finish((0.76, 0.18, 0.18), "plastic"), (at, middle), 0.16 * radius, (level, level + tall)),
            ]
        else:
            crust = Finish(spec.choice(((0.80, 0.58, 0.33), (0.72, 0.46, 0.24), (0.88, 0.70, 0.42))), "fabric")
            parts += [
                cushion(
                    crust,
                    around(at + s * 0.5 * radius, 0.8 * radius),
                    around(middle, 1.7 * radius),
                    (level, level + 0.6 * tall),
                )
                for s in (-1, 1)
            ]
    return parts


def mannequin(spec: Spec) -> Build:
    """Return a shop's figure without a face, or a tailor's bust on a stand."""
    x, y, z = spec.size
    skin = spec.main(Finish((0.88, 0.84, 0.78), "plastic"))
    bust = spec.category == "dress_form"
    hip, neck = 0.52 * z, (0.97 if bust else 0.84) * z
    trunk = (neck - hip) / 0.32
    rings = ((0.0, 0.66), (0.05, 0.72), (0.14, 0.5), (0.24, 0.7), (0.3, 0.62), (0.32, 0.24))
    wide = 0.5 * y if not bust else 0.66 * y
    points = [
        [(0.36 * x * r * cos(k * pi / 10), wide * r * sin(k * pi / 10), hip + h * trunk) for k in range(20)]
        for h, r in rings
    ]
    body: list[Part] = [hull(skin, [*a, *b], smooth=True) for a, b in pairwise(points)]
    foot = disc(IRON, (0, 0), 0.48 * min(x, y), (0, 0.02 * z))
    if bust:
        body += [
            foot,
            disc(IRON, (0, 0), 0.016, (0.02 * z, hip)),
            disc(spec.style.wood, (0, 0), 0.04, (neck - 0.01 * z, z)),
        ]
        return Build(body=body)
    body += [
        foot,
        disc(IRON, (-0.3 * x, 0), 0.01, (0.02 * z, hip)),
        rod(skin, (0, 0, neck - 0.02 * z), (0, 0, 0.9 * z), 0.045),
        ellipsoid(skin, around(0.02 * x, 0.44 * x), around(0, 0.3 * y), (0.87 * z, z)),
    ]
    for s in (-1, 1):
        knee, ankle = (0.04 * x, s * 0.15 * y, 0.28 * z), (0.0, s * 0.14 * y, 0.05 * z)
        elbow = (-0.02 * x, s * 0.42 * y, 0.64 * z)
        body += [
            rod(skin, (0, s * 0.16 * y, hip + 0.03 * z), knee, 0.085, end_radius=0.055),
            rod(skin, knee, ankle, 0.055, end_radius=0.035),
            rod(skin, (0, s * 0.33 * y, neck - 0.05 * z), elbow, 0.048, end_radius=0.04),
            rod(skin, elbow, (0.1 * x, s * 0.46 * y, 0.47 * z), 0.04, end_radius=0.026),
            cushion(skin, (-0.1 * x, 0.4 * x), around(s * 0.14 * y, 0.14 * y), (0.02 * z, 0.06 * z), radius=0.02),
        ]
    return Build(body=body)


def stanchion(spec: Spec) -> Build:
    """Return two posts with a rope between them."""
    x, y, z = spec.size
    metal, radius = spec.main(BRASS), x / 2
    rope = Finish((0.55, 0.10, 0.14), "fabric")
    body: list[Part] = []
    for s in (-1, 1):
        at = (0.0, s * (y / 2 - radius))
        body += [
            disc(metal, at, radius, (0, 0.03 * z)),
            disc(metal, at, 0.026, (0.03 * z, 0.96 * z)),
            disc(metal, at, 0.045, (0.96 * z, z)),
        ]
    bow = arc((0.0, 0.0, 0.9 * z), (y / 2 - radius, 0.24 * z), (180.0, 360.0), axis=0, steps=10)
    return Build(body=body + tube(rope, bow, 0.02))


def popcorn_machine(spec: Spec) -> Build:
    """Return a popcorn machine: a lit glass cabinet, half full, on a painted base."""
    x, y, z = spec.size
    paint = spec.main(Finish((0.74, 0.16, 0.14), "metal"))
    low, high = 0.2 * z, 0.86 * z
    pane = 0.012
    body: list[Part] = [
        box(paint, (-x / 2, x / 2), (-y / 2, y / 2), (0, low)),
        box(paint, (-x / 2, x / 2), (-y / 2, y / 2), (high, z - 0.03 * z)),
        cushion(BRASS, around(0, 0.7 * x), around(0, 0.7 * y), (z - 0.05 * z, z), radius=0.02),
        *(box(GLASS, around(0, 0.96 * x), (s * 0.48 * y, s * (0.48 * y - pane)), (low, high)) for s in (-1, 1)),
        *(box(GLASS, (s * 0.48 * x, s * (0.48 * x - pane)), around(0, 0.9 * y), (low, high)) for s in (-1, 1)),
        cushion(
            Finish((0.96, 0.89, 0.66), "fabric"),
            around(0, 0.86 * x),
            around(0, 0.86 * y),
            (low, low + 0.18 * z),
            radius=0.05,
        ),
        frustum(STEEL, (0, 0), (0.66 * z, 0.8 * z), 0.16 * y, 0.2 * y),
        disc(STEEL, (0, 0), 0.02, (0.8 * z, high)),
    ]
    return Build(body=body)


def terminal(spec: Spec) -> Build:
    """Return a machine with a screen, keys and a slot: for cash, or for games with a lit top."""
    x, y, z = spec.size
    paint = spec.main(Finish(spec.choice(((0.20, 0.34, 0.52), (0.60, 0.16, 0.18), (0.24, 0.26, 0.28))), "metal"))
    side = [
        (-x / 2, 0.0),
        (0.4 * x, 0.0),
        (0.4 * x, 0.52 * z),
        (x / 2, 0.56 * z),
        (x / 2, 0.6 * z),
        (0.22 * x, 0.66 * z),
    ]
    side_up = [(-x / 2, 0.0), (0.22 * x, 0.0), (0.22 * x, 0.66 * z), (0.12 * x, 0.9 * z), (-x / 2, 0.9 * z)]
    glass = [(0.215 * x, 0.68 * z), (0.225 * x, 0.68 * z), (0.135 * x, 0.88 * z), (0.125 * x, 0.88 * z)]
    body: list[Part] = [
        prism(paint, side, (-y / 2, y / 2), axis=1),
        prism(paint, side_up, (-y / 2, y / 2), axis=1),
        prism(SCREEN, glass, around(0, 0.76 * y), axis=1),
        box(Finish((1.0, 0.86, 0.45), "light"), (-x / 2, 0.14 * x), (-y / 2, y / 2), (0.9 * z, z)),
        *(
            box(STEEL, around(0.38 * x, 0.08 * x), around((k - 1) * 0.2 * y, 0.1 * y), (0.6 * z, 0.625 * z))
            for k in range(3)
        ),
        box(BLACK_PLASTIC, (0.4 * x, 0.402 * x), around(0, 0.5 * y), around(0.42 * z, 0.04 * z), collide=False),
    ]
    return Build(body=body)


def letter_tray(spec: Spec) -> Build:
    """Return trays on each other, open to the front, with paper in them unless they are "empty"."""
    x, y, z = spec.size
    shell, count = spec.main(spec.choice((BLACK_PLASTIC, STEEL))), max(1, round(z / 0.09))
    step, wall = z / count, 0.004
    build = Build()
    for k in range(count):
        low = k * step
        build.body += [
            box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (low, low + wall)),
            *(box(shell, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), (low + wall, low + step)) for s in (-1, 1)),
            box(shell, (-x / 2, -x / 2 + wall), around(0, y - 2 * wall), (low + wall, low + 0.6 * step)),
        ]
        if spec.has("empty"):
            inner = ((-x / 2 + wall, x / 2), around(0, y - 2 * wall))
            room = step - wall if k < count - 1 else None
            build.surfaces.append(inner_surface(f"tray {k + 1}", *inner, low + wall, headroom=room))
        else:
            paper = box(PAPER, around(0, 0.9 * x), around(0, 0.86 * y), (low + wall, low + 0.3 * step))
            build.body.append(paper)
    return build
