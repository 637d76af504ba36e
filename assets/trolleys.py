"""Things on wheels that are pushed: trolleys, wheelchairs, strollers, trucks. Who pushes stands at -x."""

import itertools
from collections.abc import Callable

from thinkblox.assets.palette import BLACK_PLASTIC, BRASS, DARK_PLASTIC, GLASS, GREY_METAL, IRON, STEEL
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    gusset,
    inner_surface,
    rod,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc, ring, tube
from thinkblox.value import Vec2

_SEAT = Finish((0.14, 0.15, 0.18), "fabric")


def wheel(at: Vec2, size: float, width: float, *, low: float = 0.0) -> Part:
    """Return an upright wheel that rolls along x, of diameter `size` about (x, y), its underside at `low` [m]."""
    return cylinder(BLACK_PLASTIC, around(at[0], size), around(at[1], width), (low, low + size), axis=1)


def castors(x: float, y: float, size: float) -> list[Part]:
    """Return four small wheels at (±x, ±y) with their forks, up to a height of 1.3 times their size [m]."""
    parts: list[Part] = []
    for u in (-x, x):
        for v in (-y, y):
            parts += [wheel((u, v), size, 0.4 * size), disc(GREY_METAL, (u, v), 0.12 * size, (0.9 * size, 1.3 * size))]
    return parts


def trolley(
    levels: tuple[float, ...],
    frame: Finish,
    board: Finish | None,
    *,
    rim: float = 0.03,
    bags: bool = False,
) -> Callable[[Spec], Build]:
    """Return a generator of trolleys with shelves between four posts, longest across its front.

    Args:
        levels: heights of the shelves' tops, in shares of the height, the highest last.
        frame: finish of the posts unless a colour is asked for.
        board: finish of the shelves; None for that of the frame.
        rim: how far an edge stands over each shelf, in shares of the height.
        bags: whether a cloth bag hangs at either end.
    """

    def generate(spec: Spec) -> Build:
        x, y, z = spec.size
        metal, size = spec.main(frame), 0.11 * z
        inner = y * (0.62 if bags else 0.94) / 2
        post = 0.014 * z
        build = Build(body=castors(x / 2 - 0.06 * x - post, inner - 0.04 * y, size))
        build.body += [
            disc(metal, (sx * (x / 2 - 0.06 * x), sy * (inner - post)), post, (1.3 * size, z))
            for sx in (-1, 1)
            for sy in (-1, 1)
        ]
        area = ((-x / 2, x / 2), (-inner, inner))
        for k, share in enumerate(levels):
            level, head = share * z, (levels[k + 1] - share - 0.06) * z if k + 1 < len(levels) else None
            build.body.append(box(board or metal, *area, (level - 0.02 * z, level)))
            build.body += [
                box(metal, area[0], around(s * (inner - 0.006), 0.012), (level, level + rim * z)) for s in (-1, 1)
            ]
            build.surfaces.insert(
                0, top_surface(f"shelf {k + 1}", area[0], (-inner + 0.02 * y, inner - 0.02 * y), level, headroom=head)
            )
        for s in (-1, 1):
            reach = [(sx * (x / 2 - 0.06 * x), s * inner * 0.97, 0.96 * z) for sx in (-1, 1)]
            outer = [(u, s * (y / 2 - post), 0.98 * z) for u, _, _ in reach]
            build.body += tube(metal, [reach[0], outer[0], outer[1], reach[1]], post)
            if bags:
                cloth = Finish(spec.style.accent.colour, "fabric")
                build.body.append(
                    cushion(
                        cloth,
                        around(0, 0.84 * x),
                        around(s * (inner + y / 2 - 0.02) / 2, y / 2 - inner - 0.04),
                        (0.3 * z, 0.94 * z),
                        radius=0.05,
                    )
                )
        return build

    return generate


bar_cart = trolley((0.3, 0.86), BRASS, GLASS, rim=0.07)
serving_trolley = trolley((0.24, 0.56, 0.9), STEEL, None)
instrument_cart = trolley((0.3, 0.92), STEEL, None, rim=0.05)
housekeeping_cart = trolley((0.2, 0.55, 0.9), GREY_METAL, Finish((0.84, 0.82, 0.78), "plastic"), bags=True)


def wheelchair(spec: Spec) -> Build:
    """Return a wheelchair; who sits in it looks to +x."""
    x, y, z = spec.size
    metal, big, small = spec.main(GREY_METAL), 0.64 * z, 0.2 * z
    hub, seat = -0.16 * x, 0.54 * z
    side = y / 2 - 0.04 * y
    body: list[Part] = [
        cushion(_SEAT, (-0.26 * x, 0.2 * x), around(0, 0.74 * y), (seat - 0.05 * z, seat), radius=0.02 * z),
        turned(box(_SEAT, (-0.3 * x, -0.26 * x), around(0, 0.74 * y), (seat, 0.97 * z)), 1, -6.0, (-0.28 * x, 0, seat)),
    ]
    for s in (-1, 1):
        v = s * 0.38 * y
        body += ring(BLACK_PLASTIC, (hub, s * side, big / 2), (0.47 * big, 0.47 * big), 0.03 * big, axis=1, sides=14)
        body += [rod(STEEL, (hub, s * side, 0.04 * big), (hub, s * side, 0.96 * big), 0.006 * z)]
        body += [rod(STEEL, (hub - 0.46 * big, s * side, big / 2), (hub + 0.46 * big, s * side, big / 2), 0.006 * z)]
        body += [
            cylinder(
                metal, around(hub, 0.06 * z), (min(v, s * y / 2), max(v, s * y / 2)), around(big / 2, 0.06 * z), axis=1
            ),
            wheel((0.3 * x, v), small, 0.06 * y),
            disc(metal, (0.28 * x, v), 0.014 * z, (0.9 * small, seat)),
            rod(metal, (-0.29 * x, v, 0.12 * z), (-0.33 * x, v, 0.95 * z), 0.014 * z),
            rod(metal, (-0.29 * x, v, seat - 0.03 * z), (0.28 * x, v, seat - 0.03 * z), 0.014 * z),
            rod(DARK_PLASTIC, (-0.32 * x, v, 0.96 * z), (-x / 2, v, 0.98 * z), 0.02 * z),
            cushion(DARK_PLASTIC, (-0.26 * x, 0.12 * x), around(v, 0.08 * y), (0.74 * z, 0.78 * z), radius=0.01 * z),
            rod(metal, (0.1 * x, v, seat), (0.1 * x, v, 0.75 * z), 0.012 * z),
            rod(metal, (0.28 * x, v, seat - 0.03 * z), (0.4 * x, v * 0.8, 0.12 * z), 0.012 * z),
            box(DARK_PLASTIC, (0.34 * x, x / 2), around(s * 0.2 * y, 0.28 * y), (0.1 * z, 0.12 * z)),
        ]
    return Build(body=body, surfaces=[top_surface("seat", (-0.22 * x, 0.18 * x), around(0, 0.66 * y), seat)])


def stroller(spec: Spec) -> Build:
    """Return a baby's stroller; the child looks to +x."""
    x, y, z = spec.size
    cloth, size = spec.main(spec.choice((spec.style.accent, Finish((0.24, 0.28, 0.34), "fabric")))), 0.2 * z
    body: list[Part] = []
    for s in (-1, 1):
        v = s * (y / 2 - 0.06 * y)
        body += [
            wheel((x / 2 - size / 2, v), size, 0.1 * y),
            wheel((-0.3 * x, v), 1.2 * size, 0.1 * y),
            rod(GREY_METAL, (x / 2 - size / 2, 0.86 * v, 0.5 * size), (-0.28 * x, 0.86 * v, 0.66 * z), 0.012),
            rod(GREY_METAL, (-0.3 * x, 0.86 * v, 0.6 * size), (0.02 * x, 0.86 * v, 0.47 * z), 0.012),
            rod(GREY_METAL, (-0.28 * x, 0.86 * v, 0.66 * z), (-x / 2 + 0.02, 0.86 * v, z - 0.02), 0.012),
        ]
    wide = 0.62 * y
    body += [
        cylinder(DARK_PLASTIC, (-x / 2, -x / 2 + 0.04), around(0, 0.78 * y), (z - 0.04, z), axis=1),
        cushion(cloth, (-0.12 * x, 0.26 * x), around(0, wide), (0.38 * z, 0.46 * z), radius=0.03),
        turned(
            cushion(cloth, (-0.18 * x, -0.1 * x), around(0, wide), (0.4 * z, 0.84 * z), radius=0.03),
            1,
            -16.0,
            (-0.14 * x, 0, 0.4 * z),
        ),
        turned(
            cushion(cloth, (0.24 * x, 0.3 * x), around(0, 0.8 * wide), (0.2 * z, 0.42 * z), radius=0.02),
            1,
            -20.0,
            (0.26 * x, 0, 0.42 * z),
        ),
        box(DARK_PLASTIC, (0.3 * x, 0.44 * x), around(0, 0.66 * y), (0.19 * z, 0.21 * z)),
        cushion(DARK_PLASTIC, (-0.26 * x, 0.14 * x), around(0, 0.56 * y), (0.14 * z, 0.26 * z), radius=0.02),
    ]
    hood = arc((-0.22 * x, 0.0, 0.78 * z), (0.2 * z, 0.3 * x), (-40.0, 90.0), axis=1, steps=6)
    for a, b in itertools.pairwise(hood):
        body.append(gusset(cloth, (-0.2 * x, 0.78 * z), (a[0], a[2]), (b[0], b[2]), 0.7 * y))
    return Build(body=body)


def shopping_cart(spec: Spec) -> Build:
    """Return a wire shopping trolley."""
    x, y, z = spec.size
    wire, size = spec.main(STEEL), 0.12 * z
    low, rim, r = 0.46 * z, 0.9 * z, 0.006
    body = castors(0.36 * x, 0.36 * y, size)
    body += [
        rod(wire, (-0.36 * x, s * 0.36 * y, 1.2 * size), (0.4 * x, s * 0.3 * y, 1.3 * size), 0.012) for s in (-1, 1)
    ]
    body += [rod(wire, (-0.36 * x, s * 0.36 * y, 1.2 * size), (-0.44 * x, s * 0.44 * y, rim), 0.012) for s in (-1, 1)]
    floor_ = (0.38 * x, 0.32 * y)
    top = (0.48 * x, 0.42 * y)
    body.append(box(wire, (-0.38 * x, floor_[0]), around(0, 2 * floor_[1]), (low, low + 0.01)))
    for level in (0.33, 0.66, 1.0):
        u, v = (floor_[i] + level * (top[i] - floor_[i]) for i in (0, 1))
        h = low + level * (rim - low)
        corners = [(-u * 0.92, -v, h), (u, -0.9 * v, h), (u, 0.9 * v, h), (-u * 0.92, v, h)]
        body += tube(wire, [*corners, corners[0]], r, sides=6)
    for k in range(7):
        share = -0.9 + 0.3 * k
        for s in (-1, 1):
            body.append(
                rod(wire, (share * floor_[0], s * floor_[1], low), (share * top[0], s * 0.93 * top[1], rim), r, sides=6)
            )
    for k in range(5):
        share = (k - 2) / 2.4
        body.append(rod(wire, (floor_[0], share * floor_[1], low), (top[0], 0.9 * share * top[1], rim), r, sides=6))
    body.append(cylinder(DARK_PLASTIC, (-x / 2, -x / 2 + 0.04), (-y / 2, y / 2), (z - 0.04, z), axis=1))
    body += [rod(wire, (-0.44 * x, s * 0.44 * y, rim), (-x / 2 + 0.02, s * 0.44 * y, z - 0.02), 0.012) for s in (-1, 1)]
    basket = inner_surface("basket", (-0.36 * x, floor_[0] - r), around(0, 2 * (floor_[1] - r)), low + 0.01)
    return Build(body=body, surfaces=[basket])


def hand_truck(spec: Spec) -> Build:
    """Return a sack truck standing on its toe plate and wheels."""
    x, y, z = spec.size
    paint, size = spec.main(Finish((0.72, 0.20, 0.16), "metal")), 0.2 * z
    back = -x / 2 + size
    body: list[Part] = [box(STEEL, (back, x / 2), around(0, 0.84 * y), (0, 0.01 * z))]
    for s in (-1, 1):
        body += [
            wheel((-x / 2 + size / 2, s * (y / 2 - 0.07 * y)), size, 0.14 * y),
            rod(paint, (back, s * 0.3 * y, 0.006 * z), (back - 0.06 * x, s * 0.3 * y, 0.9 * z), 0.014),
            rod(paint, (back - 0.06 * x, s * 0.3 * y, 0.9 * z), (-x / 2 + 0.04, s * 0.3 * y, z - 0.02), 0.016),
        ]
    body += [box(paint, (back - 0.07 * x, back), around(0, 0.6 * y), around(h * z, 0.03 * z)) for h in (0.2, 0.45, 0.7)]
    body.append(cylinder(DARK_PLASTIC, (-x / 2 + 0.01, -x / 2 + 0.05), around(0, 0.66 * y), (z - 0.04, z), axis=1))
    return Build(body=body)


def pallet_jack(spec: Spec) -> Build:
    """Return a pallet truck, its forks to the front."""
    x, y, z = spec.size
    paint = spec.main(Finish((0.90, 0.66, 0.14), "metal"))
    body: list[Part] = [box(paint, (-0.3 * x, -0.2 * x), (-y / 2, y / 2), (0.05 * z, 0.28 * z))]
    for s in (-1, 1):
        v = s * 0.34 * y
        body += [
            box(paint, (-0.2 * x, x / 2), around(v, 0.3 * y), (0.03 * z, 0.07 * z)),
            wheel((0.4 * x, v), 0.05 * z, 0.2 * y),
            wheel((-0.34 * x, s * 0.1 * y), 0.15 * z, 0.1 * y),
        ]
    body += [
        box(paint, (-0.38 * x, -0.28 * x), around(0, 0.3 * y), (0.1 * z, 0.34 * z)),
        rod(IRON, (-0.34 * x, 0, 0.3 * z), (-0.44 * x, 0, 0.86 * z), 0.02),
        cylinder(DARK_PLASTIC, (-x / 2, -x / 2 + 0.04), around(0, 0.5 * y), (z - 0.04, z), axis=1),
        *(rod(IRON, (-0.44 * x, 0, 0.86 * z), (-x / 2 + 0.02, s * 0.22 * y, z - 0.02), 0.012) for s in (-1, 1)),
    ]
    return Build(body=body)


def walker(spec: Spec) -> Build:
    """Return a walking frame with two wheels."""
    x, y, z = spec.size
    metal, size = spec.main(GREY_METAL), 0.14 * z
    body: list[Part] = []
    for s in (-1, 1):
        v = s * (y / 2 - 0.04 * y)
        frame = [(-x / 2 + 0.02, v, 0.0), (-0.3 * x, 0.94 * v, 0.94 * z), (0.12 * x, 0.94 * v, 0.94 * z)]
        body += tube(metal, [*frame, (x / 2 - size / 2, v, size / 2)], 0.013)
        body += [
            rod(DARK_PLASTIC, (-0.32 * x, 0.94 * v, 0.97 * z), (0.06 * x, 0.94 * v, 0.97 * z), 0.02),
            disc(DARK_PLASTIC, (-x / 2 + 0.02, v), 0.02, (0, 0.04 * z)),
            wheel((x / 2 - size / 2, v), size, 0.05 * y),
        ]
    body += [
        cylinder(metal, around(a * x, 0.026), around(0, 0.88 * y), around(h * z, 0.026), axis=1)
        for a, h in ((0.2, 0.8), (0.3, 0.5))
    ]
    return Build(body=body)


def drip_stand(spec: Spec) -> Build:
    """Return a stand on five castors with a bag hung on it."""
    x, y, z = spec.size
    metal, radius = spec.main(STEEL), min(x, y) / 2
    size = 0.035 * z
    body: list[Part] = [
        disc(metal, (0, 0), 0.012, (size, 0.96 * z)),
        disc(metal, (0, 0), 0.05, (1.1 * size, 1.7 * size)),
    ]
    for at in arc((0.0, 0.0, 0.0), (0.9 * radius, 0.9 * radius), (0.0, 288.0), axis=2, steps=4):
        body.append(rod(metal, (0, 0, 1.5 * size), (at[0], at[1], 1.2 * size), 0.012))
        body.append(ellipsoid(BLACK_PLASTIC, around(at[0], 0.05), around(at[1], 0.05), (0, size)))
        body.append(disc(BLACK_PLASTIC, (at[0], at[1]), 0.01, (0, size)))
    body.append(cylinder(metal, around(0, 0.012), around(0, 0.5 * y), (0.96 * z - 0.012, 0.96 * z), axis=1))
    body += [rod(metal, (0, s * 0.25 * y, 0.95 * z), (0, s * 0.27 * y, z), 0.006) for s in (-1, 1)]
    body.append(
        cushion(
            Finish((0.86, 0.92, 0.94), "plastic"),
            around(0, 0.03),
            (0.14 * y, 0.36 * y),
            (0.8 * z, 0.94 * z),
            radius=0.01,
        )
    )
    body.append(rod(Finish((0.80, 0.86, 0.88), "plastic"), (0, 0.25 * y, 0.8 * z), (0, 0.06 * y, 0.5 * z), 0.004))
    return Build(body=body)
