"""Screens, computers and shop devices."""

from math import cos, pi, sin

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
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, pad, prism, rod, top_surface
from thinkblox.assets.spec import Spec


def _display(
    x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], rim: float, shell: Finish
) -> list[Part]:
    glass = ((y[0] + rim, y[1] - rim), (z[0] + rim * 1.4, z[1] - rim))
    return [box(shell, x, y, z), box(SCREEN, (x[1], x[1] + 0.002), *glass, collide=False)]


def tv(spec: Spec) -> Build:
    """Return a flat television on two feet, or for the wall when it is thin."""
    x, y, z = spec.size
    if x < 0.12:
        return Build(
            body=[
                box(IRON, (-x / 2, 0), around(0, 0.4 * y), around(z / 2, 0.4 * z)),
                *_display((0, x / 2 - 0.002), (-y / 2, y / 2), (0, z), 0.012, BLACK_PLASTIC),
            ]
        )
    body = _display((-0.02, 0.018), (-y / 2, y / 2), (0.06, z), 0.012, BLACK_PLASTIC)
    body.append(box(DARK_PLASTIC, (-0.05, -0.02), around(0, 0.5 * y), (0.12, 0.12 + 0.5 * (z - 0.06))))
    for side in (-1, 1):
        at = side * 0.3 * y
        body += [
            box(IRON, (-x / 2, x / 2), around(at, 0.035), (0, 0.012)),
            box(IRON, (-0.015, 0.012), around(at, 0.03), (0.012, 0.06)),
        ]
    return Build(body=body)


def monitor(spec: Spec) -> Build:
    """Return a screen on a stand."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((BLACK_PLASTIC, DARK_PLASTIC, GREY_METAL)))
    low = 0.28 * z
    body = _display((0.0, 0.028), (-y / 2, y / 2), (low, z), 0.01, shell)
    body += [
        cushion(shell, (-x / 2, x / 2), around(0, 0.42 * y), (0, 0.012), radius=0.006),
        box(shell, (-0.05, -0.025), around(0, 0.07), (0.012, 0.62 * z)),
        box(shell, (-0.025, 0.0), around(0, 0.1), (0.5 * z, 0.62 * z)),
    ]
    return Build(body=body)


def laptop(spec: Spec) -> Build:
    """Return an open laptop, or a "closed" one; the user sits on the +x side."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((STEEL, GREY_METAL, DARK_PLASTIC)))
    if spec.has("closed"):
        seam = around(0.48 * z, 0.08 * z)
        halves = ((0.0, seam[0]), (seam[1], z))
        shut = [cushion(shell, (-x / 2, x / 2), (-y / 2, y / 2), half, radius=0.3 * z) for half in halves]
        return Build(body=[*shut, box(DARK_PLASTIC, around(0, 0.97 * x), around(0, 0.98 * y), seam)])
    hinge, depth = -0.2 * x, 0.7 * x
    body: list[Part] = [
        box(shell, (x / 2 - depth, x / 2), (-y / 2, y / 2), (0, 0.014)),
        box(
            DARK_PLASTIC,
            (x / 2 - 0.9 * depth, x / 2 - 0.45 * depth),
            around(0, 0.86 * y),
            (0.014, 0.016),
            collide=False,
        ),
        box(
            GREY_PLASTIC,
            (x / 2 - 0.36 * depth, x / 2 - 0.06 * depth),
            around(0, 0.3 * y),
            (0.014, 0.0145),
            collide=False,
        ),
    ]
    lean = (-x / 2, hinge)
    body.append(
        prism(
            shell,
            [(lean[1], 0.008), (lean[1] - 0.01, 0.008), (lean[0], z), (lean[0] + 0.006, z)],
            (-y / 2, y / 2),
            axis=1,
        )
    )
    glass = [
        (lean[1] - 0.002, 0.03),
        (lean[1] - 0.004, 0.03),
        (lean[0] + 0.005, z - 0.01),
        (lean[0] + 0.0075, z - 0.01),
    ]
    body.append(prism(SCREEN, [(a + 0.001, b) for a, b in glass], (-y / 2 + 0.01, y / 2 - 0.01), axis=1))
    return Build(body=body)


def computer(spec: Spec) -> Build:
    """Return a desktop computer's upright case."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((IRON, WHITE_PLASTIC)))
    body = [
        box(shell, (-x / 2, x / 2 - 0.012), (-y / 2, y / 2), (0.012, z)),
        box(DARK_PLASTIC, (x / 2 - 0.012, x / 2), (-y / 2 + 0.008, y / 2 - 0.008), (0.02, z - 0.01)),
        *(box(BLACK_PLASTIC, around(sx * 0.36 * x, 0.04), (-y / 2 + 0.01, y / 2 - 0.01), (0, 0.012)) for sx in (-1, 1)),
        cylinder(
            Finish((0.4, 0.7, 0.95), "light"),
            (x / 2, x / 2 + 0.001),
            around(0, 0.018),
            around(0.9 * z, 0.018),
            axis=0,
            collide=False,
        ),
    ]
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, x / 2 - 0.012), (-y / 2, y / 2), z)])


def keyboard(spec: Spec) -> Build:
    """Return a keyboard; the user sits on the +x side."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((DARK_PLASTIC, WHITE_PLASTIC, GREY_METAL)))
    keys = BLACK_PLASTIC if shell != DARK_PLASTIC else GREY_PLASTIC
    base = z - 0.005
    body = [box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0, base))]
    for row in range(4):
        at = around((row - 1.5) * 0.21 * x, 0.17 * x)
        body.append(box(keys, at, (-0.48 * y, 0.26 * y), (base, z)))
        body.append(box(keys, at, (0.3 * y, 0.48 * y), (base, z)))
    return Build(body=body)


def mouse(spec: Spec) -> Build:
    """Return a computer mouse."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((DARK_PLASTIC, WHITE_PLASTIC)))
    return Build(body=[pad(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0, z), edge=0.35, flat=True)])


def printer(spec: Spec) -> Build:
    """Return a desktop printer with paper in its tray."""
    x, y, z = spec.size
    shell = spec.main(WHITE_PLASTIC)
    body = [
        cushion(shell, (-x / 2, x / 2 - 0.1), (-y / 2, y / 2), (0, 0.72 * z), radius=0.012),
        cushion(
            GREY_PLASTIC, (-x / 2 + 0.01, x / 2 - 0.11), (-y / 2 + 0.01, y / 2 - 0.01), (0.72 * z, z), radius=0.012
        ),
        box(DARK_PLASTIC, (x / 2 - 0.1, x / 2), around(0, 0.62 * y), (0.2 * z, 0.24 * z)),
        box(PAPER, (x / 2 - 0.1, x / 2 - 0.01), around(0, 0.5 * y), (0.24 * z, 0.26 * z)),
        box(SCREEN, (x / 2 - 0.1, x / 2 - 0.098), (-0.4 * y, -0.22 * y), (0.52 * z, 0.64 * z), collide=False),
    ]
    return Build(
        body=body, surfaces=[top_surface("top", (-x / 2 + 0.03, x / 2 - 0.13), (-y / 2 + 0.03, y / 2 - 0.03), z)]
    )


def slab(spec: Spec) -> Build:
    """Return a tablet or a phone lying on its back."""
    x, y, z = spec.size
    shell = spec.main(GREY_METAL)
    body = [box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0, z - 0.001))]
    body.append(box(BLACK_GLASS, (-x / 2 + 0.003, x / 2 - 0.003), (-y / 2 + 0.003, y / 2 - 0.003), (z - 0.001, z)))
    return Build(body=body)


def speaker(spec: Spec) -> Build:
    """Return a loudspeaker with two cones."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((spec.style.wood, IRON)))
    body = [box(shell, (-x / 2, x / 2 - 0.006), (-y / 2, y / 2), (0, z))]
    for height, radius in ((0.33, 0.36), (0.76, 0.2)):
        size = 2 * radius * min(y, 0.5 * z)
        body.append(cylinder(DARK_PLASTIC, (x / 2 - 0.006, x / 2), around(0, size), around(height * z, size), axis=0))
    return Build(body=body, surfaces=[top_surface("top", (-x / 2, x / 2 - 0.006), (-y / 2, y / 2), z)])


def games_console(spec: Spec) -> Build:
    """Return a games console: a low box of two slabs."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((WHITE_PLASTIC, DARK_PLASTIC)))
    body = [
        box(BLACK_PLASTIC, (-x / 2 + 0.006, x / 2 - 0.006), (-y / 2 + 0.006, y / 2 - 0.006), (0.3 * z, 0.55 * z)),
        box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.3 * z)),
        box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0.55 * z, z)),
        box(
            Finish((0.35, 0.6, 0.95), "light"),
            (x / 2 - 0.006, x / 2 - 0.004),
            around(0, 0.5 * y),
            around(0.42 * z, 0.004),
            collide=False,
        ),
    ]
    return Build(body=body)


def cash_register(spec: Spec) -> Build:
    """Return a till: drawer, keys towards the cashier on the +x side, and a screen."""
    x, y, z = spec.size
    shell = spec.main(DARK_PLASTIC)
    drawer = 0.3 * z
    body = [
        box(shell, (-x / 2, x / 2 - 0.008), (-y / 2, y / 2), (0, drawer)),
        box(GREY_PLASTIC, (x / 2 - 0.008, x / 2), (-y / 2 + 0.02, y / 2 - 0.02), (0.02, drawer - 0.015)),
        prism(
            GREY_PLASTIC,
            [(x / 2 - 0.03, drawer), (-0.1 * x, drawer), (-0.1 * x, 0.48 * z), (x / 2 - 0.03, 0.36 * z)],
            (-y / 2 + 0.02, 0.14 * y),
            axis=1,
        ),
        box(shell, (-x / 2 + 0.03, -0.12 * x), (-0.3 * y, 0.3 * y), (drawer, 0.55 * z)),
        box(shell, (-x / 2 + 0.06, -0.2 * x), (-0.06 * y, 0.06 * y), (0.55 * z, 0.62 * z)),
    ]
    screen = box(shell, (-0.3 * x, -0.3 * x + 0.02), (-0.36 * y, 0.36 * y), (0.6 * z, z))
    glass = box(
        SCREEN, (-0.3 * x + 0.02, -0.3 * x + 0.022), (-0.33 * y, 0.33 * y), (0.63 * z, z - 0.012), collide=False
    )
    body += [turned(p, 1, -12.0, (-0.3 * x, 0.0, 0.62 * z)) for p in (screen, glass)]
    body.append(box(PAPER, (0.0, 0.16 * x), (0.2 * y, 0.4 * y), (drawer, drawer + 0.04)))
    return Build(body=body)


def scale(spec: Spec) -> Build:
    """Return a shop scale: a steel plate on a box, and a display."""
    x, y, z = spec.size
    shell = spec.main(GREY_PLASTIC)
    plate = 0.42 * z
    body = [
        box(shell, (-x / 2 + 0.01, x / 2), (-y / 2 + 0.02, y / 2 - 0.02), (0, plate - 0.012)),
        box(STEEL, (-x / 2 + 0.06, x / 2 - 0.06), (-y / 2, y / 2), (plate - 0.012, plate)),
        disc(GREY_METAL, (-x / 2 + 0.03, 0), 0.012, (plate - 0.012, 0.8 * z)),
        box(shell, (-x / 2, -x / 2 + 0.05), around(0, 0.6 * y), (0.7 * z, z)),
        box(
            Finish((0.45, 0.75, 0.50), "screen"),
            (-x / 2 + 0.05, -x / 2 + 0.052),
            around(0, 0.45 * y),
            (0.78 * z, 0.92 * z),
            collide=False,
        ),
    ]
    return Build(body=body, surfaces=[top_surface("plate", (-x / 2 + 0.06, x / 2 - 0.06), (-y / 2, y / 2), plate)])


def microphone_stand(spec: Spec) -> Build:
    """Return a microphone on a round foot."""
    x, y, z = spec.size
    foot = min(x, y) / 2
    body = [
        disc(IRON, (0, 0), foot, (0, 0.02)),
        disc(STEEL, (0, 0), 0.01, (0.02, z - 0.1)),
        rod(BLACK_PLASTIC, (0, 0, z - 0.14), (0.1, 0, z - 0.02), 0.022),
    ]
    return Build(body=body)


def remote_control(spec: Spec) -> Build:
    """Return a remote control with rows of buttons."""
    x, y, z = spec.size
    shell = spec.main(spec.choice((BLACK_PLASTIC, DARK_PLASTIC)))
    body: list[Part] = [cushion(shell, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.9 * z), radius=0.3 * z)]
    for row in range(5):
        body += [
            box(
                GREY_PLASTIC,
                around((row - 1.5) * 0.14 * x, 0.07 * x),
                around((k - 1) * 0.28 * y, 0.16 * y),
                (0.86 * z, z),
            )
            for k in range(3)
        ]
    body.append(
        box(
            Finish((0.75, 0.18, 0.16), "plastic"),
            around(-0.42 * x, 0.05 * x),
            around(-0.28 * y, 0.14 * y),
            (0.86 * z, z),
        )
    )
    return Build(body=body)


def record_player(spec: Spec) -> Build:
    """Return a record player with its arm on a record."""
    x, y, z = spec.size
    low, wide = 0.72 * z, 0.8 * min(x, 0.84 * y)
    at = -0.1 * y
    plate = around(0, wide), around(at, wide)
    body: list[Part] = [
        box(spec.wood, (-x / 2, x / 2), (-y / 2, y / 2), (0.12 * z, low)),
        *(
            disc(BLACK_PLASTIC, (sx * 0.4 * x, sy * 0.42 * y), 0.05 * x, (0, 0.12 * z))
            for sx in (-1, 1)
            for sy in (-1, 1)
        ),
        cylinder(STEEL, *plate, (low, low + 0.08 * z)),
        cylinder(BLACK_PLASTIC, around(0, 0.98 * wide), around(at, 0.98 * wide), (low + 0.08 * z, low + 0.12 * z)),
        cylinder(
            Finish((0.80, 0.30, 0.24), "paper"),
            around(0, 0.3 * wide),
            around(at, 0.3 * wide),
            (low + 0.12 * z, low + 0.13 * z),
        ),
        disc(STEEL, (-0.36 * x, 0.42 * y), 0.05 * y, (low, z)),
        rod(STEEL, (-0.36 * x, 0.42 * y, 0.95 * z), (0.12 * x, 0.2 * y, low + 0.18 * z), 0.006),
    ]
    return Build(body=body)


def radio(spec: Spec) -> Build:
    """Return a table radio with a dial, knobs and a handle."""
    x, y, z = spec.size
    shell, high = spec.main(spec.choice((spec.style.wood, Finish(spec.style.accent.colour, "plastic")))), 0.84 * z
    face = (0.47 * x, x / 2)
    body: list[Part] = [
        cushion(shell, (-x / 2, 0.48 * x), (-y / 2, y / 2), (0, high), radius=0.1 * min(x, z)),
        box(Finish((0.78, 0.72, 0.60), "fabric"), face, (-0.44 * y, 0.08 * y), (0.12 * z, 0.72 * z)),
        box(PAPER, face, (0.14 * y, 0.44 * y), (0.5 * z, 0.7 * z)),
        *(cylinder(STEEL, face, around(v * y, 0.12 * y), around(0.28 * z, 0.12 * y), axis=0) for v in (0.2, 0.37)),
        *(box(STEEL, around(0, 0.1 * x), around(s * 0.36 * y, 0.03 * y), (0.8 * high, 0.98 * z)) for s in (-1, 1)),
        box(STEEL, around(0, 0.1 * x), around(0, 0.75 * y), (0.93 * z, z)),
    ]
    return Build(body=body)


def _legs(spec: Spec, head: float, reach: float) -> list[Part]:
    """Three splayed legs, and a pole between them that ends at a height [m]."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    body: list[Part] = [disc(IRON, (0, 0), 0.02, (0.62 * z, head))]
    for k in range(3):
        a = 2 * pi * k / 3 + pi
        foot = (0.97 * radius * cos(a), 0.97 * radius * sin(a))
        body += [
            rod(IRON, (foot[0], foot[1], 0.008 * z), (0.02 * cos(a), 0.02 * sin(a), reach), 0.014),
            disc(IRON, foot, 0.022, (0, 0.02 * z)),
        ]
    return body


def tripod(spec: Spec) -> Build:
    """Return a tripod with a plate that carries a camera or a lamp."""
    z, black, half = spec.size[2], spec.main(BLACK_PLASTIC), min(0.09, 0.2 * min(spec.size[:2]))
    plate = (-half, half)
    body = _legs(spec, z - 0.06, 0.8 * z)
    body += [
        cushion(black, around(0, 0.07), around(0, 0.07), (z - 0.1, z - 0.012), radius=0.01),
        box(black, plate, plate, (z - 0.012, z)),
    ]
    return Build(body=body, surfaces=[top_surface("plate", plate, plate, z)])


def camera_tripod(spec: Spec) -> Build:
    """Return a camera on a tripod, its lens to the front; a telescope is a long tube instead."""
    x, _, z = spec.size
    black, head = spec.main(BLACK_PLASTIC), 0.8 * z
    body = _legs(spec, head, 0.72 * z)
    if spec.category == "telescope":
        tube_finish = spec.main(WHITE_PLASTIC)
        body += [
            rod(tube_finish, (-0.4 * x, 0, 0.74 * z), (x / 2 - 0.03 * x, 0, 0.97 * z), 0.05, end_radius=0.06),
            rod(black, (-x / 2, 0, 0.72 * z), (-0.38 * x, 0, 0.755 * z), 0.026),
        ]
        return Build(body=body)
    body += [
        cushion(black, around(-0.02 * x, 0.12), around(0, 0.2), (head, z - 0.02), radius=0.01),
        box(black, around(-0.02 * x, 0.06), around(0, 0.08), (z - 0.03, z)),
        cylinder(black, (-0.02 * x + 0.06, -0.02 * x + 0.2), around(0, 0.1), around((head + z) / 2, 0.1), axis=0),
        cylinder(
            BLACK_GLASS, (-0.02 * x + 0.2, -0.02 * x + 0.204), around(0, 0.08), around((head + z) / 2, 0.08), axis=0
        ),
    ]
    return Build(body=body)


def camera(spec: Spec) -> Build:
    """Return a camera, its lens to the front."""
    x, y, z = spec.size
    black, high = spec.main(BLACK_PLASTIC), 0.8 * z
    size = 0.72 * high
    body: list[Part] = [
        cushion(black, (-x / 2, 0.05 * x), (-y / 2, y / 2), (0, high), radius=0.08 * z),
        box(black, (-0.4 * x, 0.0), around(0, 0.3 * y), (0.7 * z, z)),
        cylinder(DARK_PLASTIC, (0.04 * x, 0.48 * x), around(0, size), around(0.48 * high, size), axis=0),
        cylinder(BLACK_GLASS, (0.48 * x, x / 2), around(0, 0.8 * size), around(0.48 * high, 0.8 * size), axis=0),
        disc(STEEL, (-0.22 * x, -0.36 * y), 0.06 * y, (0.78 * z, 0.86 * z)),
    ]
    return Build(body=body)
