"""Turned things: vases, bowls, cups, bottles, baskets and bins. A flat disc is their foot."""

from collections.abc import Sequence
from dataclasses import replace
from math import cos, pi, sin

from thinkblox.assets.palette import (
    AMBER_GLASS,
    BRASS,
    CHROME,
    GLASS,
    GLAZES,
    GREEN_GLASS,
    GREY_METAL,
    IRON,
    KRAFT,
    PALE_GLASS,
    PORCELAIN,
    STEEL,
    WICKER,
)
from thinkblox.assets.part import Build, Finish, Part, moved
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    disc,
    ellipsoid,
    frustum,
    inner_surface,
    profile,
    rod,
    shell,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc, tube
from thinkblox.scene.asset import Surface
from thinkblox.value import Vec2


def turned_solid(
    finish: Finish, radius: float, height: float, rings: Sequence[Vec2], *, round: bool = False
) -> list[Part]:
    """Return a solid of revolution from rings (share of height, share of radius), standing on a disc."""
    foot = disc(finish, (0, 0), rings[0][1] * radius, (0, 0.002))
    return [foot, *profile(finish, (0, 0), [(max(0.002, h * height), r * radius) for h, r in rings], round=round)]


def hollow(finish: Finish, centre: Vec2, radius: float, height: float, foot: float, wall: float) -> list[Part]:
    """Return a round vessel with a real cavity: a floor and a wall of staves."""
    low = min(0.012, 0.2 * height)
    return [
        disc(finish, centre, foot * radius, (0, low)),
        *shell(finish, centre, (low * 0.5, height), foot * radius + 0.001, radius, wall, pieces=16),
    ]


def bottom(radius: float, height: float, foot: float, wall: float, centre: Vec2 = (0.0, 0.0)) -> Surface:
    """Return the floor of a `hollow` of these measures, on which things stand in it."""
    across = [around(at, 2 * (foot * radius - wall)) for at in centre]
    return inner_surface("bottom", across[0], across[1], min(0.012, 0.2 * height), round=True)


_VASES = (
    ((0.0, 0.5), (0.3, 0.95), (0.45, 1.0), (0.75, 0.55), (0.88, 0.4), (1.0, 0.52)),
    ((0.0, 0.62), (0.55, 1.0), (0.8, 0.72), (0.92, 0.42), (1.0, 0.46)),
    ((0.0, 0.7), (0.9, 1.0), (1.0, 0.94)),
)


def vase(spec: Spec) -> Build:
    """Return a glazed vase, tall or bellied; "open" one that widens to its mouth and holds flowers."""
    x, y, z = spec.size
    glaze, rings, radius = spec.main(spec.choice((spec.style.glaze, *GLAZES))), spec.choice(_VASES), min(x, y) / 2
    if spec.has("open"):
        wall = 0.06 * radius
        return Build(body=hollow(glaze, (0, 0), radius, z, 0.74, wall), surfaces=[bottom(radius, z, 0.74, wall)])
    mouth = disc(IRON, (0, 0), 0.82 * rings[-1][1] * radius, (z - 0.001, z), collide=False)
    return Build(body=[*turned_solid(glaze, radius, z - 0.001, rings, round=True), mouth])


def bowl(spec: Spec) -> Build:
    """Return an open bowl."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    body = hollow(spec.main(spec.choice(GLAZES)), (0, 0), radius, z, 0.5, 0.012)
    return Build(body=body, surfaces=[bottom(radius, z, 0.5, 0.012)])


def fruit_bowl(spec: Spec) -> Build:
    """Return a bowl with fruit in it, unless it is "empty"."""
    x, y, z = spec.size
    radius, rim = min(x, y) / 2, z if spec.has("empty") else 0.62 * z
    body = hollow(spec.main(spec.choice((spec.style.wood, *GLAZES))), (0, 0), radius, rim, 0.6, 0.012)
    if spec.has("empty"):
        return Build(body=body, surfaces=[bottom(radius, rim, 0.6, 0.012)])
    fruit = ((0.80, 0.25, 0.20), (0.92, 0.58, 0.20), (0.60, 0.68, 0.28), (0.93, 0.78, 0.30))
    size = 0.29 * radius
    for k in range(5):
        at = (0.4 * radius * cos(2 * pi * k / 5), 0.4 * radius * sin(2 * pi * k / 5))
        body.append(sphere(Finish(spec.choice(fruit), "plastic"), (at[0], at[1], 0.03 + size), size))
    body.append(sphere(Finish(spec.choice(fruit), "plastic"), (0, 0, z - size), size))
    return Build(body=body)


def plate(spec: Spec) -> Build:
    """Return a plate with a raised rim."""
    x, y, z = spec.size
    radius, finish = min(x, y) / 2, spec.main(spec.choice((PORCELAIN, *GLAZES)))
    low = 0.35 * z
    body = [
        disc(finish, (0, 0), 0.72 * radius, (0, low)),
        *shell(finish, (0, 0), (low * 0.6, z), 0.76 * radius, radius, 0.05 * radius),
    ]
    across = around(0, 1.42 * radius)
    return Build(body=body, surfaces=[top_surface("plate", across, across, low, round=True)])


def cup(spec: Spec) -> Build:
    """Return a mug with a handle on its +y side."""
    x, y, z = spec.size
    radius, finish = x / 2, spec.main(spec.choice(GLAZES))
    at = (0.0, -y / 2 + radius)
    body = hollow(finish, at, radius, z, 0.86, 0.005)
    edge = at[1] + 0.9 * radius
    body += [box(finish, around(0, 0.012), (y / 2 - 0.008, y / 2), (0.22 * z, 0.78 * z))]
    body += [box(finish, around(0, 0.012), (edge, y / 2 - 0.008), around(h * z, 0.01)) for h in (0.26, 0.74)]
    return Build(body=body, surfaces=[bottom(radius, z, 0.86, 0.005, at)])


def glass(spec: Spec) -> Build:
    """Return a drinking glass."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    return Build(body=hollow(spec.main(GLASS), (0, 0), radius, z, 0.8, 0.004), surfaces=[bottom(radius, z, 0.8, 0.004)])


def teapot(spec: Spec) -> Build:
    """Return a teapot, its spout to the front."""
    x, y, z = spec.size
    finish, radius = spec.main(spec.choice(GLAZES)), 0.5 * y
    body = turned_solid(
        finish, radius, 0.8 * z, ((0.0, 0.55), (0.3, 0.95), (0.5, 1.0), (0.8, 0.78), (1.0, 0.4)), round=True
    )
    body += [
        disc(finish, (0, 0), 0.42 * radius, (0.8 * z, 0.86 * z)),
        sphere(finish, (0, 0, z - 0.012), 0.012),
        rod(finish, (0.8 * radius, 0, 0.3 * z), (x / 2 - 0.01, 0, 0.72 * z), 0.02, end_radius=0.009),
        box(finish, (-x / 2, -x / 2 + 0.012), around(0, 0.016), (0.25 * z, 0.65 * z)),
        *(box(finish, (-x / 2 + 0.012, -0.8 * radius), around(0, 0.016), around(h * z, 0.012)) for h in (0.27, 0.62)),
    ]
    return Build(body=body)


def tea_set(spec: Spec) -> Build:
    """Return a tray with a teapot and cups, or with glasses of drinks; bare when "empty"."""
    x, y, z = spec.size
    rim, floor, bare = 0.022, 0.01, spec.has("empty")
    high = rim if bare else z
    wood, edge = spec.wood, 0.012
    inner = (around(0, x - 2 * edge), around(0, y - 2 * edge))
    body = [
        box(wood, *inner, (0, floor)),
        *(box(wood, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - edge)), (0, rim)) for s in (-1, 1)),
        *(box(wood, (s * x / 2, s * (x / 2 - edge)), inner[1], (0, rim)) for s in (-1, 1)),
    ]
    surfaces = [top_surface("tray", *inner, floor), inner_surface("inside", *inner, floor)]
    if bare:
        return Build(body=body, surfaces=surfaces)
    glaze, wide = spec.main(spec.choice(GLAZES)), spec.category == "drinks_tray"
    for k in range(4):
        at = ((0.22 if k % 2 else -0.22) * x, -0.3 * y if k < 2 else 0.3 * y if wide else -0.02 * y)
        if wide:
            body += _filled(GLASS, at, 0.15 * x, floor, high)
        else:
            body += _filled(glaze, at, 0.15 * x, floor, floor + 0.45 * (high - floor))
    if not wide:
        pot = teapot(replace(spec, size=(0.62 * x, 0.4 * x, high - floor)))
        body += [replace(moved(part, (0.0, 0.27 * y, floor)), finish=glaze) for part in pot.body]
    return Build(body=body)


def _filled(finish: Finish, at: Vec2, radius: float, low: float, high: float) -> list[Part]:
    """A vessel that is full, between two heights [m]."""
    wall = shell(finish, at, (low, high), 0.72 * radius, radius, 0.004, pieces=12)
    return [*wall, disc(AMBER_GLASS, at, 0.7 * radius, (low, low + 0.75 * (high - low)))]


_BOTTLE = ((0.0, 0.94), (0.04, 1.0), (0.58, 1.0), (0.72, 0.42), (0.75, 0.36), (0.93, 0.34), (0.931, 0.42), (1.0, 0.42))


def bottle(spec: Spec) -> Build:
    """Return a bottle with a label."""
    x, y, z = spec.size
    radius, finish = min(x, y) / 2, spec.main(spec.choice((GREEN_GLASS, AMBER_GLASS, PALE_GLASS)))
    label = disc(
        Finish(spec.choice(((0.90, 0.86, 0.76), (0.76, 0.30, 0.24), (0.24, 0.34, 0.44))), "paper"),
        (0, 0),
        1.004 * radius,
        (0.18 * z, 0.46 * z),
        collide=False,
    )
    return Build(body=[*turned_solid(finish, radius, z, _BOTTLE), label])


def jar(spec: Spec) -> Build:
    """Return a preserving jar, full, with a lid."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    fill = Finish(
        spec.choice(((0.72, 0.25, 0.18), (0.85, 0.60, 0.22), (0.45, 0.50, 0.24), (0.55, 0.34, 0.20))), "ceramic"
    )
    body = turned_solid(spec.main(fill), radius, 0.8 * z, ((0.0, 0.92), (0.06, 1.0), (0.9, 1.0), (1.0, 0.82)))
    return Build(body=[*body, disc(spec.choice((BRASS, STEEL, IRON)), (0, 0), 0.9 * radius, (0.8 * z, z))])


def waste_bin(spec: Spec) -> Build:
    """Return an open bin, round."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((IRON, GREY_METAL, STEEL, WICKER)))
    radius = min(x, y) / 2
    return Build(body=hollow(finish, (0, 0), radius, z, 0.82, 0.008), surfaces=[bottom(radius, z, 0.82, 0.008)])


def umbrella_stand(spec: Spec) -> Build:
    """Return a tall open cylinder, with two umbrellas that hang their crooks out unless it is "empty"."""
    x, y, z = spec.size
    radius, rim = min(x, y) / 2, z if spec.has("empty") else 0.62 * z
    body = hollow(spec.main(spec.style.metal), (0, 0), radius, rim, 0.96, 0.008)
    if spec.has("empty"):
        return Build(body=body, surfaces=[bottom(radius, rim, 0.96, 0.008)])
    for k, colour in enumerate(((0.20, 0.27, 0.38), (0.66, 0.28, 0.22))):
        s, crook = 1 - 2 * k, 0.28 * radius
        foot, head = (0.4 * s * radius, -0.3 * s * radius), (0.3 * s * radius, 0.1 * s * radius)
        top = z - 0.012 - 0.05 * k * z - crook
        hook = arc((head[0], head[1] + s * crook, top), (crook, crook), (90.0 + 90.0 * s, 90.0 - 110.0 * s), axis=0)
        body += [
            rod(Finish(colour, "fabric"), (*foot, 0.02), (*head, 0.76 * z), 0.016, end_radius=0.034),
            rod(Finish(colour, "fabric"), (*head, 0.76 * z), (*head, 0.8 * z), 0.034, end_radius=0.012),
            *tube(spec.style.wood, [(*head, 0.78 * z), *hook], 0.011),
        ]
    return Build(body=body)


def basket(spec: Spec) -> Build:
    """Return a woven basket with a fabric lining that stands over its rim."""
    x, y, z = spec.size
    radius, finish = min(x, y) / 2, spec.main(WICKER)
    body = hollow(finish, (0, 0), radius, z, 0.85, 0.014)
    if spec.category == "laundry_basket" and not spec.has("empty"):
        cloth = Finish((0.90, 0.88, 0.84), "fabric")
        body.append(disc(cloth, (0, 0), 0.84 * radius, (0.5 * z, 0.8 * z)))
        body.append(
            ellipsoid(spec.style.accent, around(0.05, 1.1 * radius), around(0, 1.2 * radius), (0.68 * z, 0.95 * z))
        )
        return Build(body=body)
    return Build(body=body, surfaces=[bottom(radius, z, 0.85, 0.014)])


def pen_holder(spec: Spec) -> Build:
    """Return a cup of pens and pencils, unless it is "empty"."""
    x, y, z = spec.size
    radius, rim = min(x, y) / 2, z if spec.has("empty") else 0.58 * z
    body = hollow(spec.main(spec.choice((spec.style.metal, spec.style.wood))), (0, 0), radius, rim, 0.98, 0.005)
    if spec.has("empty"):
        return Build(body=body, surfaces=[bottom(radius, rim, 0.98, 0.005)])
    for k, colour in enumerate(((0.85, 0.66, 0.2), (0.2, 0.3, 0.5), (0.7, 0.25, 0.2), (0.2, 0.2, 0.2))):
        a = 2 * pi * k / 4 + 0.4
        tip = (0.7 * radius * cos(a), 0.7 * radius * sin(a), z - 0.012 * k)
        body.append(rod(Finish(colour, "plastic"), (0.2 * tip[0], 0.2 * tip[1], 0.014), tip, 0.004, sides=6))
    return Build(body=body)


def globe(spec: Spec) -> Build:
    """Return a globe on a turned foot."""
    x, y, z = spec.size
    ball = min(x, y) / 2 - 0.012
    body: list[Part] = [
        disc(spec.style.wood, (0, 0), 0.62 * ball, (0, 0.02)),
        frustum(spec.style.wood, (0, 0), (0.02, z - 2 * ball - 0.006), 0.3 * ball, 0.09 * ball),
    ]
    centre = (0.0, 0.0, z - ball - 0.008)
    body.append(sphere(spec.main(Finish((0.32, 0.52, 0.66), "plastic")), centre, ball))
    land = Finish((0.62, 0.64, 0.42), "plastic")
    for a, b, deep in (
        (0.3, 0.5, 0.1),
        (1.5, -0.2, 0.2),
        (2.4, 0.3, 0.07),
        (3.4, -0.5, 0.2),
        (4.3, 0.4, 0.08),
        (5.3, -0.4, 0.14),
    ):
        at = [centre[i] + v * deep * ball for i, v in enumerate((cos(a) * cos(b), sin(a) * cos(b), sin(b)))]
        body.append(
            ellipsoid(
                land,
                around(at[0], 2 * (1.012 - deep) * ball),
                around(at[1], 2 * (1.012 - deep) * ball),
                around(at[2], 2 * (1.012 - deep) * ball),
                collide=False,
            )
        )
    for k in range(12):
        p, q = (-100 + 200 * k / 12) * pi / 180, (-100 + 200 * (k + 1) / 12) * pi / 180
        r = ball + 0.007
        body.append(
            rod(BRASS, (0, r * cos(p), centre[2] + r * sin(p)), (0, r * cos(q), centre[2] + r * sin(q)), 0.004, sides=6)
        )
    return Build(body=body)


def trophy(spec: Spec) -> Build:
    """Return a cup on a dark base."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    gold = spec.main(BRASS)
    body = [cushion(IRON, around(0, 1.2 * radius), around(0, 1.2 * radius), (0, 0.18 * z), radius=0.004)]
    rings = ((0.18, 0.4), (0.24, 0.12), (0.45, 0.12), (0.55, 0.5), (0.8, 0.8), (1.0, 1.0))
    return Build(body=body + profile(gold, (0, 0), [(h * z, r * radius) for h, r in rings]))


def box_of_card(spec: Spec) -> Build:
    """Return a closed cardboard or storage box."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((KRAFT, Finish(spec.style.accent.colour, "paper"))))
    lid = min(0.06, 0.25 * z)
    return Build(
        body=[
            box(finish, around(0, x - 0.008), around(0, y - 0.008), (0, z - lid)),
            box(finish, around(0, x), around(0, y), (z - lid, z)),
            box(
                CHROME,
                (x / 2 - 0.004, x / 2 - 0.002),
                around(0, 0.25 * y),
                around(0.4 * (z - lid), 0.25 * z),
                collide=False,
            ),
        ],
        surfaces=[top_surface("top", around(0, x), around(0, y), z)],
    )
