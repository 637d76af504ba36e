"""Counters, lecterns, hearths and other fixtures of rooms where people are served or gather."""

from thinkblox.assets.palette import BLACK_PLASTIC, BRASS, CONCRETE, IRON, LEAVES, MARBLE, SOIL, STEEL
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.plants import kept_inside, leaf
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, frustum, prism, rod, top_surface
from thinkblox.assets.spec import Spec


def counter(spec: Spec) -> Build:
    """Return a shop counter: a slatted front to the customer at +x, shelves on the other side."""
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
    area = ((-x / 2 + 0.05, x / 2 - 0.08), (-y / 2 + 0.03, y / 2 - 0.03))
    build.body.append(box(front, *area, (0.42 * z, 0.42 * z + 0.02)))
    build.surfaces = [
        top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z),
        top_surface("shelf", *area, 0.42 * z + 0.02, headroom=0.58 * z - 0.06),
    ]
    return build


def podium(spec: Spec) -> Build:
    """Return a lectern; the speaker stands at -x, and the audience sees its front."""
    x, y, z = spec.size
    wood = spec.wood
    body = [
        box(wood, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.05)),
        box(wood, (0.1 * x, 0.1 * x + 0.03), around(0, 0.8 * y), (0.05, z - 0.16)),
        *(box(wood, (-0.3 * x, 0.1 * x), around(s * 0.385 * y, 0.025), (0.05, z - 0.16)) for s in (-1, 1)),
        box(wood, (-0.4 * x, 0.2 * x), around(0, 0.94 * y), (z - 0.16, z - 0.13)),
        *(box(wood, (0.16 * x, 0.2 * x), around(s * 0.42 * y, 0.04), (z - 0.13, z)) for s in (-1, 1)),
        rod(IRON, (0.12 * x, 0, z - 0.14), (-0.1 * x, 0, z - 0.006), 0.006),
    ]
    top = top_surface("desk", (-0.4 * x, 0.1 * x), around(0, 0.9 * y), z - 0.13)
    return Build(body=body, surfaces=[top])


def fireplace(spec: Spec) -> Build:
    """Return a mantelpiece with logs and fire."""
    x, y, z = spec.size
    stone = spec.main(spec.choice((MARBLE, CONCRETE, spec.style.paint)))
    inner, head = 0.3 * y, 0.7 * z
    body = [
        *(box(stone, (-x / 2, 0.36 * x), (s * inner, s * (y / 2 - 0.03)), (0.04, z - 0.05)) for s in (-1, 1)),
        box(stone, (-x / 2, 0.36 * x), (-inner, inner), (head, z - 0.05)),
        box(Finish((0.16, 0.13, 0.12), "stone"), (-x / 2, -x / 2 + 0.04), (-inner, inner), (0.04, head)),
        box(stone, (-x / 2, x / 2), (-y / 2 + 0.02, y / 2 - 0.02), (0, 0.04)),
        cushion(stone, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.05, z), radius=0.012),
    ]
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
    low = 0.5 * z
    body: list[Part] = [
        box(spec.wood, around(0, x), (-y / 2, y / 2), (0, low)),
        box(SOIL, around(0, 0.8 * x), around(0, y - 0.06), (low, low + 0.01)),
    ]
    count = max(3, int(y / 0.14))
    for k in range(count):
        at = -y / 2 + (k + 0.5) * y / count
        grown = [
            leaf(LEAVES[(k + j) % 4], (0, at, low), 40 + 72 * j + 50 * k, 80 - 9 * j, 0.5 * z, 0.07, droop=10)
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
