"""Devices and fittings of walls and ceilings: conditioners, dryers, dispensers, signs, rails, cameras, projectors."""

from collections.abc import Callable

from thinkblox.assets.palette import (
    BLACK_GLASS,
    BLACK_PLASTIC,
    DARK_PLASTIC,
    GREY_METAL,
    GREY_PLASTIC,
    IRON,
    PAPER,
    SCREEN,
    STEEL,
    WHITE_METAL,
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part, Range
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, oval, panel, prism, rod, sphere
from thinkblox.assets.spec import Spec

Mark = tuple[Finish, Range, Range]
"""A flat patch on a front: its finish, and what it covers of the width (from -0.5) and of the height (from 0)."""

_GREEN = Finish((0.12, 0.52, 0.32), "plastic")
_RED = Finish((0.80, 0.14, 0.12), "plastic")
_LAMP = Finish((0.35, 0.85, 0.55), "light")


def housing(shell: Finish, *marks: Mark, rounded: float = 0.06) -> Callable[[Spec], Build]:
    """Return a generator of boxes on a wall with patches on their fronts.

    Args:
        shell: finish of the box unless a colour is asked for.
        marks: the patches, each thinner than a millimetre.
        rounded: radius of its edges, in shares of its smallest extent.
    """

    def generate(spec: Spec) -> Build:
        x, y, z = spec.size
        body = [cushion(spec.main(shell), (-x / 2, x / 2), (-y / 2, y / 2), (0, z), radius=rounded * min(x, y, z))]
        for finish, across, up in marks:
            span, rise = (across[0] * y, across[1] * y), (up[0] * z, up[1] * z)
            body.append(box(finish, (x / 2 - 0.001, x / 2 + 0.0006), span, rise, collide=False))
        return Build(body=body)

    return generate


air_conditioner = housing(
    WHITE_PLASTIC,
    (DARK_PLASTIC, (-0.46, 0.46), (0.05, 0.17)),
    (GREY_PLASTIC, (-0.48, 0.48), (0.2, 0.215)),
    (GREY_PLASTIC, (-0.48, 0.48), (0.74, 0.75)),
    (_LAMP, (0.36, 0.42), (0.3, 0.34)),
    rounded=0.28,
)
cooling_unit = housing(
    WHITE_METAL,
    *((GREY_METAL, (-0.44, 0.44), (0.08 + 0.035 * k, 0.1 + 0.035 * k)) for k in range(10)),
    *((GREY_METAL, (-0.44, 0.44), (0.78 + 0.035 * k, 0.8 + 0.035 * k)) for k in range(5)),
    (SCREEN, (-0.12, 0.12), (0.56, 0.66)),
    (_LAMP, (0.18, 0.21), (0.62, 0.64)),
    rounded=0.02,
)
control_cabinet = housing(
    GREY_METAL,
    (SCREEN, (-0.3, 0.12), (0.7, 0.86)),
    (_LAMP, (0.22, 0.28), (0.8, 0.84)),
    (_RED, (0.22, 0.28), (0.7, 0.74)),
    (IRON, (0.4, 0.43), (0.36, 0.56)),
    (IRON, (-0.47, 0.47), (0.02, 0.024)),
)
first_aid_kit = housing(WHITE_METAL, (_RED, (-0.28, 0.28), (0.4, 0.6)), (_RED, (-0.1, 0.1), (0.22, 0.78)))
thermostat = housing(
    WHITE_PLASTIC, (SCREEN, (-0.36, 0.36), (0.4, 0.86)), (GREY_PLASTIC, (-0.12, 0.12), (0.12, 0.26)), rounded=0.2
)
light_box = housing(GREY_METAL, (Finish((0.93, 0.97, 1.0), "light"), (-0.46, 0.46), (0.06, 0.94)))
paper_dispenser = housing(
    WHITE_PLASTIC, (DARK_PLASTIC, (-0.36, 0.36), (0.03, 0.09)), (SCREEN, (-0.3, 0.3), (0.42, 0.5)), rounded=0.2
)
mailbox = housing(
    Finish((0.24, 0.34, 0.46), "metal"),
    (BLACK_PLASTIC, (-0.38, 0.38), (0.8, 0.85)),
    (PAPER, (-0.2, 0.2), (0.52, 0.62)),
    (STEEL, (0.3, 0.36), (0.3, 0.36)),
)


def hand_dryer(spec: Spec) -> Build:
    """Return a hand dryer with its nozzle below and a sensor."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((WHITE_METAL, STEEL)))
    side = [(-x / 2, 0.12 * z), (0.2 * x, 0.12 * z), (x / 2, 0.4 * z), (0.42 * x, z), (-x / 2, z)]
    body = [
        prism(shell, side, (-y / 2, y / 2), axis=1),
        box(DARK_PLASTIC, (-0.3 * x, 0.1 * x), around(0, 0.5 * y), (0, 0.13 * z)),
        cylinder(SCREEN, (0.44 * x, 0.49 * x), around(0, 0.14 * y), around(0.44 * z, 0.14 * y), axis=0, collide=False),
    ]
    return Build(body=body)


def wall_dispenser(spec: Spec) -> Build:
    """Return a dispenser of soap or disinfectant with its lever below."""
    x, y, z = spec.size
    shell = spec.main(WHITE_PLASTIC)
    body: list[Part] = [
        cushion(shell, (-x / 2, 0.4 * x), (-y / 2, y / 2), (0.2 * z, z), radius=0.12 * y),
        box(BLACK_GLASS, (0.36 * x, 0.42 * x), around(0, 0.3 * y), (0.36 * z, 0.8 * z)),
        box(shell, (-x / 2, -0.36 * x), around(0, 0.6 * y), (0.04 * z, 0.24 * z)),
        cushion(GREY_PLASTIC, (-0.4 * x, x / 2), around(0, 0.5 * y), (0, 0.09 * z), radius=0.03 * z),
        disc(GREY_PLASTIC, (0.1 * x, 0), 0.06 * y, (0.1 * z, 0.22 * z)),
    ]
    return Build(body=body)


def sign(spec: Spec) -> Build:
    """Return a sign with an arrow and a line of text, or a lit one that shows the way out."""
    x, y, z = spec.size
    lit = spec.has("exit", "emergency", "neon", "lit") or spec.category == "exit_sign"
    ground = (
        _GREEN if lit else Finish(spec.choice(((0.18, 0.30, 0.48), (0.93, 0.92, 0.88), (0.20, 0.20, 0.21))), "plastic")
    )
    ground = spec.main(ground)
    ink = Finish((0.95, 0.98, 0.95), "light") if lit else PAPER if sum(ground.colour) < 1.6 else IRON
    skin = (x / 2 - 0.001, x / 2 + 0.0006)
    tip = 0.4 * y
    arrow = [(tip, 0.5 * z), (tip - 0.14 * y, 0.78 * z), (tip - 0.14 * y, 0.22 * z)]
    body = [
        cushion(ground, (-x / 2, x / 2), (-y / 2, y / 2), (0, z), radius=0.2 * x),
        _inlay(ink, arrow, skin),
        box(ink, skin, (0.0, tip - 0.13 * y), around(0.5 * z, 0.16 * z), collide=False),
        *(box(ink, skin, (-0.42 * y, -0.08 * y), around(h * z, 0.1 * z), collide=False) for h in (0.66, 0.4)),
    ]
    return Build(body=body)


def _inlay(finish: Finish, outline: list[tuple[float, float]], skin: Range) -> Part:
    part = prism(finish, outline, skin, axis=0)
    return Part(part.kind, part.lo, part.hi, finish, points=part.points, collide=False)


def floor_sign(spec: Spec) -> Build:
    """Return a folding sign that stands on the floor, written on both sides."""
    x, y, z = spec.size
    board = spec.main(Finish((0.95, 0.80, 0.18), "plastic") if spec.category == "warning_sign" else IRON)
    ink = IRON if sum(board.colour) > 1.2 else PAPER
    body: list[Part] = []
    for s in (-1, 1):
        leaf = [(s * x / 2, 0.0), (s * (x / 2 - 0.025), 0.0), (0.0, 0.98 * z), (s * 0.03, z)]
        body.append(prism(board, leaf, (-y / 2, y / 2), axis=1))
        for low, high, wide in ((0.72, 0.8, 0.5), (0.55, 0.6, 0.7), (0.42, 0.47, 0.7), (0.29, 0.34, 0.6)):
            face = [(s * (x / 2 * (1 - h) + 0.03 * h + 0.0012), h * z) for h in (low, high)]
            line = [*face, (face[1][0] - s * 0.002, face[1][1]), (face[0][0] - s * 0.002, face[0][1])]
            part = prism(ink, line, around(0, wide * y), axis=1)
            body.append(Part(part.kind, part.lo, part.hi, ink, points=part.points, collide=False))
    return Build(body=body)


def hand_rail(spec: Spec) -> Build:
    """Return a rail along a wall on brackets; a grab bar is a short one."""
    x, y, z = spec.size
    metal = spec.main(spec.choice((STEEL, spec.style.wood)) if spec.category == "hand_rail" else STEEL)
    bar = min(0.5 * x, z)
    body: list[Part] = [cylinder(metal, (x / 2 - bar, x / 2), (-y / 2, y / 2), (z - bar, z), axis=1)]
    count = max(2, round(y / 0.8) + 1)
    for k in range(count):
        at = (k / (count - 1) - 0.5) * (y - 0.12 * min(1.0, y))
        body += [
            rod(STEEL, (-x / 2, at, 0.25 * z), (x / 2 - bar / 2, at, z - 0.7 * bar), 0.2 * bar),
            cylinder(STEEL, (-x / 2, -x / 2 + 0.08 * x), around(at, 0.8 * bar), (0, 0.8 * bar), axis=0),
        ]
    return Build(body=body)


def security_camera(spec: Spec) -> Build:
    """Return a camera on its arm, looking down to the front."""
    x, y, z = spec.size
    shell = spec.main(WHITE_PLASTIC)
    lens = (x / 2 - 0.01 * x, 0.0, 0.3 * z)
    body: list[Part] = [
        cylinder(shell, (-x / 2, -0.42 * x), around(0, 0.7 * y), around(0.7 * z, 0.6 * z), axis=0),
        rod(shell, (-0.44 * x, 0, 0.7 * z), (-0.1 * x, 0, 0.62 * z), 0.08 * z),
        rod(shell, (-0.2 * x, 0, 0.62 * z), (0.42 * x, 0, 0.36 * z), 0.34 * z, sides=12),
        rod(BLACK_GLASS, (0.38 * x, 0, 0.38 * z), lens, 0.26 * z, sides=12),
    ]
    return Build(body=body)


def projector(spec: Spec) -> Build:
    """Return a projector, its lens to the front; one for the ceiling hangs on a pole."""
    x, y, z = spec.size
    hung = spec.category == "ceiling_projector"
    shell = spec.main(spec.choice((WHITE_PLASTIC, DARK_PLASTIC)))
    high = min(0.5 * z, 0.42 * x) if hung else z
    low = 0.0 if hung else 0.1 * z
    lens, size = -0.22 * y, 0.62 * (high - low)
    body: list[Part] = [
        cushion(shell, (-x / 2, 0.46 * x), (-y / 2, y / 2), (low, high), radius=0.2 * (high - low)),
        cylinder(IRON, (0.4 * x, 0.49 * x), around(lens, size), around((low + high) / 2, size), axis=0),
        cylinder(
            BLACK_GLASS, (0.48 * x, x / 2), around(lens, 0.8 * size), around((low + high) / 2, 0.8 * size), axis=0
        ),
        *(
            box(
                GREY_METAL,
                around(0.46 * x, 0.002),
                around(0.24 * y, 0.36 * y),
                around(low + h * (high - low), 0.05 * high),
                collide=False,
            )
            for h in (0.35, 0.5, 0.65)
        ),
    ]
    if hung:
        plate = 0.3 * min(x, y)
        body += [
            disc(GREY_METAL, (0, 0), 0.06 * x, (high - 0.02 * z, z - 0.04 * z)),
            box(GREY_METAL, around(0, plate), around(0, plate), (z - 0.05 * z, z)),
        ]
    else:
        body += [
            disc(BLACK_PLASTIC, (sx * 0.36 * x, sy * 0.4 * y), 0.04 * x, (0, low + 0.01))
            for sx in (-1, 1)
            for sy in (-1, 1)
        ]
    return Build(body=body)


def basketball_hoop(spec: Spec) -> Build:
    """Return a backboard on the wall with its ring."""
    x, y, z = spec.size
    face, hoop = -x / 2 + 0.12 * x, 0.44 * x
    level = 0.2 * z
    body: list[Part] = [
        *panel(
            spec.main(WHITE_PLASTIC),
            (-x / 2, face),
            (-y / 2, y / 2),
            (0, z),
            0.03,
            Finish((0.90, 0.93, 0.95), "plastic"),
        ),
        *(
            box(_RED, (face, face + 0.001), around(s * 0.16 * y, 0.012), (0.28 * z, 0.62 * z), collide=False)
            for s in (-1, 1)
        ),
        box(_RED, (face, face + 0.001), around(0, 0.33 * y), around(0.62 * z, 0.012), collide=False),
        box(_RED, (-x / 2 + 0.02 * x, x / 2 - 2 * hoop + 0.05 * x), around(0, 0.1 * y), around(level, 0.05 * z)),
    ]
    outline = [(x / 2 - hoop + u, v) for u, v in oval(2 * hoop, 2 * hoop, sides=16)]
    body += [
        rod(_RED, (*a, level), (*b, level), 0.01) for a, b in zip(outline, [*outline[1:], outline[0]], strict=True)
    ]
    net = [(x / 2 - hoop + u, v) for u, v in oval(1.2 * hoop, 1.2 * hoop, sides=16)]
    body += [rod(PAPER, (*a, level), (*b, 0.0), 0.004) for a, b in zip(outline, net, strict=True)]
    return Build(body=body)


def mirror_ball(spec: Spec) -> Build:
    """Return a mirrored ball on its cord."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    return Build(
        body=[
            sphere(spec.main(Finish((0.82, 0.86, 0.90), "metal")), (0, 0, radius), radius),
            disc(IRON, (0, 0), 0.05 * radius, (1.9 * radius, z - 0.02)),
            disc(IRON, (0, 0), 0.2 * radius, (z - 0.03, z)),
        ]
    )
