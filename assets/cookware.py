"""Pots, pans and what stands about a cook: boards, racks, blocks, mixers, hoods."""

from thinkblox.assets.palette import (
    CHROME,
    DARK_PLASTIC,
    GLASS,
    GREY_METAL,
    IRON,
    PORCELAIN,
    STEEL,
    WHITE_METAL,
)
from thinkblox.assets.part import Build, Finish, Part, hull
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    frustum,
    prism,
    profile,
    rod,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.tubes import arc, tube
from thinkblox.assets.vessels import bottom, hollow


def pan(spec: Spec) -> Build:
    """Return a frying pan or a saucepan, its handle to the front."""
    x, y, z = spec.size
    metal, radius = spec.main(spec.choice((IRON, GREY_METAL, STEEL))), y / 2
    rim = 0.8 * z
    at = -x / 2 + radius
    handle = rod(DARK_PLASTIC, (at + 0.94 * radius, 0, 0.78 * rim), (x / 2, 0, z - 0.014), 0.013)
    floor = bottom(radius, rim, 0.82, 0.05 * radius, (at, 0.0))
    return Build(body=[*hollow(metal, (at, 0.0), radius, rim, 0.82, 0.05 * radius), handle], surfaces=[floor])


def cooking_pot(spec: Spec) -> Build:
    """Return a pot with a lid and two handles; "open" without the lid."""
    x, y, z = spec.size
    metal, radius = spec.main(spec.choice((STEEL, STEEL, Finish((0.66, 0.22, 0.18), "metal"), IRON))), x / 2
    bare = spec.has("open")
    rim = z if bare else 0.76 * z
    body: list[Part] = [
        disc(metal, (0, 0), radius, (0, rim)),
        frustum(metal, (0, 0), (rim, 0.86 * z), 1.02 * radius, 0.6 * radius),
        disc(DARK_PLASTIC, (0, 0), 0.13 * radius, (0.86 * z, z)),
    ]
    if bare:
        body = hollow(metal, (0, 0), radius, rim, 0.96, 0.03 * radius)
    for s in (-1, 1):
        bow = arc(
            (0.0, s * 0.96 * radius, 0.8 * rim), (0.4 * radius, s * (y / 2 - 0.97 * radius)), (0.0, 180.0), axis=2
        )
        body += tube(DARK_PLASTIC, bow, 0.06 * radius, sides=6)
    return Build(body=body, surfaces=[bottom(radius, rim, 0.96, 0.03 * radius)] if bare else [])


def cutting_board(spec: Spec) -> Build:
    """Return a wooden board with a hole to hang it by."""
    x, y, z = spec.size
    body = [
        cushion(spec.wood, (-x / 2, x / 2), (-y / 2, y / 2), (0, z), radius=0.4 * z),
        disc(IRON, (0.4 * x, 0), 0.03 * x, (0.9 * z, z + 0.0006), collide=False),
    ]
    surface = top_surface("top", (-0.46 * x, 0.32 * x), around(0, 0.9 * y), z)
    return Build(body=body, surfaces=[surface])


def knife_block(spec: Spec) -> Build:
    """Return a leaning block with knives in it."""
    x, y, z = spec.size
    outline = [(-x / 2, 0.0), (0.2 * x, 0.0), (x / 2, 0.5 * z), (0.06 * x, 0.78 * z)]
    body = [prism(spec.wood, outline, (-y / 2, y / 2), axis=1)]
    for row, at in enumerate(((0.19, 0.7), (0.4, 0.57))):
        for k in range(3):
            v = (k - 1) * 0.28 * y
            start = (at[0] * x, v, at[1] * z)
            body.append(rod(DARK_PLASTIC, start, (start[0] + 0.1 * x, v, start[2] + (0.29 - 0.1 * row) * z), 0.09 * y))
    return Build(body=body)


def dish_rack(spec: Spec) -> Build:
    """Return a wire rack with plates drying in it."""
    x, y, z = spec.size
    wire, r = spec.main(CHROME), 0.03 * z
    body: list[Part] = [box(DARK_PLASTIC, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.1 * z))]
    for level in (0.22 * z, 0.55 * z):
        body += [
            cylinder(wire, (-x / 2, x / 2), around(s * (y / 2 - r), 2 * r), around(level, 2 * r), axis=0)
            for s in (-1, 1)
        ]
        body += [
            cylinder(wire, around(s * (x / 2 - r), 2 * r), (-y / 2, y / 2), around(level, 2 * r), axis=1)
            for s in (-1, 1)
        ]
    body += [
        disc(wire, (sx * (x / 2 - r), sy * (y / 2 - r)), r, (0.1 * z, 0.58 * z)) for sx in (-1, 1) for sy in (-1, 1)
    ]
    wide = min(0.86 * z, 0.7 * x)
    for k in range(5):
        at = (k - 2.2) * 0.13 * y
        body.append(cylinder(PORCELAIN, around(0, wide), around(at, 0.012), (0.12 * z, 0.12 * z + wide), axis=1))
    body.append(disc(STEEL, (0.2 * x, 0.4 * y), 0.07 * y, (0.1 * z, z)))
    return Build(body=body)


def mug_tree(spec: Spec) -> Build:
    """Return a stand with four mugs hung on its arms."""
    x, y, z = spec.size
    wood, radius = spec.wood, min(x, y) / 2
    body: list[Part] = [
        disc(wood, (0, 0), 0.6 * radius, (0, 0.05 * z)),
        disc(wood, (0, 0), 0.07 * radius, (0.05 * z, z)),
    ]
    glaze = spec.style.glaze
    for k, (u, v) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1))):
        level = (0.88 - 0.32 * (k % 2)) * z
        body.append(rod(wood, (0, 0, level - 0.06 * z), (0.62 * u * radius, 0.62 * v * radius, level), 0.05 * radius))
        at = (0.66 * u * radius, 0.66 * v * radius)
        body.append(frustum(glaze, at, (level - 0.27 * z, level - 0.03 * z), 0.3 * radius, 0.34 * radius))
    return Build(body=body)


def stand_mixer(spec: Spec) -> Build:
    """Return a kitchen mixer over its bowl."""
    x, y, z = spec.size
    shell = spec.main(Finish(spec.choice(((0.72, 0.22, 0.20), (0.90, 0.87, 0.80), (0.50, 0.66, 0.66))), "metal"))
    body: list[Part] = [
        cushion(shell, (-x / 2, x / 2), around(0, y), (0, 0.12 * z), radius=0.05 * z),
        cushion(shell, (-x / 2 + 0.02 * x, -0.14 * x), around(0, 0.6 * y), (0.1 * z, 0.7 * z), radius=0.05 * x),
        cushion(shell, (-0.48 * x, 0.46 * x), around(0, 0.66 * y), (0.66 * z, z), radius=0.14 * z),
        rod(CHROME, (0.2 * x, 0, 0.3 * z), (0.2 * x, 0, 0.68 * z), 0.03 * x),
    ]
    bowl = [(0.12 * z, 0.14 * x), (0.2 * z, 0.2 * x), (0.52 * z, 0.27 * x)]
    return Build(body=body + profile(STEEL, (0.2 * x, 0.0), bowl))


def blender(spec: Spec) -> Build:
    """Return a blender with a glass jug."""
    x, y, z = spec.size
    radius, shell = min(x, y) / 2, spec.main(spec.choice((DARK_PLASTIC, STEEL, WHITE_METAL)))
    jug = [(0.36 * z, 0.62 * radius), (0.9 * z, 0.86 * radius)]
    body: list[Part] = [
        frustum(shell, (0, 0), (0, 0.34 * z), radius, 0.72 * radius),
        disc(CHROME, (0, 0), 0.6 * radius, (0.34 * z, 0.36 * z)),
        *profile(GLASS, (0, 0), jug),
        disc(shell, (0, 0), 0.88 * radius, (0.9 * z, 0.96 * z)),
        disc(shell, (0, 0), 0.4 * radius, (0.96 * z, z)),
        disc(CHROME, (0.86 * radius, 0), 0.14 * radius, (0.1 * z, 0.2 * z), collide=False),
    ]
    return Build(body=body)


def rice_cooker(spec: Spec) -> Build:
    """Return a squat cooker with a hinged lid and a panel."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((WHITE_METAL, STEEL, DARK_PLASTIC)))
    body: list[Part] = [
        cushion(shell, (-x / 2, 0.46 * x), (-y / 2, y / 2), (0, 0.72 * z), radius=0.14 * min(x, y)),
        cushion(GREY_METAL, (-0.46 * x, 0.42 * x), around(0, 0.94 * y), (0.66 * z, z), radius=0.16 * z),
        box(DARK_PLASTIC, (0.4 * x, x / 2), around(0, 0.36 * y), (0.16 * z, 0.5 * z)),
    ]
    return Build(body=body)


def range_hood(spec: Spec) -> Build:
    """Return an extractor hood with its chimney, for the wall above a stove."""
    x, y, z = spec.size
    steel = spec.main(STEEL)
    back = -x / 2
    low, high, neck = 0.1 * z, 0.42 * z, 0.24 * y
    corners = [(u, v, low) for u in (back, x / 2) for v in (-y / 2, y / 2)]
    corners += [(u, v, high) for u in (back, back + 0.55 * x) for v in (-neck, neck)]
    body = [
        box(steel, (back, x / 2), (-y / 2, y / 2), (0, low)),
        hull(steel, corners),
        box(steel, (back, back + 0.55 * x), (-neck, neck), (high, z)),
        box(DARK_PLASTIC, (x / 2, x / 2 + 0.001), around(0, 0.2 * y), (0.03 * z, 0.07 * z), collide=False),
    ]
    return Build(body=body)


def watering_can(spec: Spec) -> Build:
    """Return a can with a long spout to the front and a bow over it."""
    x, y, z = spec.size
    metal, radius = spec.main(spec.choice((GREY_METAL, Finish((0.32, 0.48, 0.36), "metal")))), y / 2
    at, rim = -0.1 * x, 0.62 * z
    body: list[Part] = [
        disc(metal, (at, 0), radius, (0, rim)),
        rod(metal, (at + 0.9 * radius, 0, 0.16 * z), (x / 2 - 0.06 * x, 0, 0.8 * z), 0.1 * y, end_radius=0.06 * y),
        rod(metal, (x / 2 - 0.1 * x, 0, 0.76 * z), (x / 2, 0, 0.88 * z), 0.07 * y, end_radius=0.2 * y),
    ]
    body += tube(metal, arc((at, 0.0, rim), (0.34 * z, 0.7 * radius), (-90.0, 90.0), axis=1), 0.05 * y)
    bow = arc(
        (at - 0.9 * radius, 0.0, 0.34 * z), (0.2 * z, max(0.05 * x, 0.4 * x - 0.9 * radius)), (-10.0, -170.0), axis=1
    )
    return Build(body=[*body, *tube(metal, bow, 0.05 * y)])


def bucket(spec: Spec) -> Build:
    """Return an open bucket, its handle folded down to the rim."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    shell = spec.main(Finish(spec.choice(((0.28, 0.46, 0.66), (0.60, 0.62, 0.64), (0.74, 0.28, 0.22))), "plastic"))
    body = hollow(shell, (0, 0), 0.96 * radius, 0.98 * z, 0.74, 0.02 * radius)
    bail = arc((0.0, 0.0, 0.86 * z), (radius, radius), (0.0, 180.0), axis=2, steps=10)
    drop = [(u, v, 0.86 * z + 0.12 * z * (1 if 1 < k < 9 else 0.0)) for k, (u, v, _) in enumerate(bail)]
    floor = bottom(0.96 * radius, 0.98 * z, 0.74, 0.02 * radius)
    return Build(body=body + tube(STEEL, drop, 0.015 * radius, sides=6), surfaces=[floor])


def mop_bucket(spec: Spec) -> Build:
    """Return a wringer bucket on castors with a mop standing in it."""
    x, y, z = spec.size
    shell, rim = spec.main(Finish((0.90, 0.72, 0.20), "plastic")), 0.42 * z
    low = 0.08 * z
    wall = 0.06 * y
    body: list[Part] = [
        box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (low, low + 0.03 * z)),
        *(box(shell, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - wall)), (low + 0.03 * z, rim)) for s in (-1, 1)),
        *(box(shell, (s * x / 2, s * (x / 2 - wall)), around(0, y - 2 * wall), (low + 0.03 * z, rim)) for s in (-1, 1)),
        box(shell, (-0.44 * x, -0.06 * x), around(0, 0.8 * y), (0.34 * z, 0.54 * z)),
        rod(spec.style.wood, (0.2 * x, 0, 0.2 * z), (0.06 * x, 0, z), 0.012),
        ellipsoid(
            Finish((0.90, 0.88, 0.82), "fabric"), (0.02 * x, 0.36 * x), around(0, 0.5 * y), (low + 0.03 * z, 0.34 * z)
        ),
    ]
    body += [
        cylinder(DARK_PLASTIC, around(sx * 0.38 * x, low), around(sy * 0.34 * y, 0.06 * y), (0, low), axis=1)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return Build(body=body)
