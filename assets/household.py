"""Things of the household: boards, racks, ladders, fans, tanks."""

from math import cos, pi, sin

from thinkblox.assets.mounting import WALL_MOUNTED
from thinkblox.assets.palette import (
    BRIGHT,
    CHROME,
    GREY_METAL,
    IRON,
    LEAVES,
    SCREEN,
    STEEL,
    WATER,
    WHITE_COTTON,
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    inner_surface,
    leg,
    prism,
    rod,
    top_surface,
)
from thinkblox.assets.spec import Spec


def aquarium(spec: Spec) -> Build:
    """Return a tank with sand, plants and fish; "open" one without a lid and fish, for what is put into it."""
    x, y, z = spec.size
    if spec.has("open"):
        return _open_tank(spec)
    body: list[Part] = [
        box(IRON, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.03)),
        box(Finish((0.82, 0.74, 0.58), "stone"), around(0, x - 0.014), around(0, y - 0.014), (0.03, 0.03 + 0.12 * z)),
        *(box(WATER, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.006)), (0.03, z - 0.04)) for s in (-1, 1)),
        *(box(WATER, (s * x / 2, s * (x / 2 - 0.006)), around(0, y - 0.012), (0.03, z - 0.04)) for s in (-1, 1)),
        box(IRON, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.04, z)),
    ]
    for k in range(5):
        at = ((k % 2 - 0.5) * 0.4 * x, (k - 2) * 0.18 * y)
        body.append(
            leg(LEAVES[k % 4], at, (at[0] + 0.02, at[1]), (0.03 + 0.12 * z, (0.45 + 0.08 * (k % 3)) * z), 0.03, 0.008)
        )
        body.append(
            ellipsoid(
                Finish(BRIGHT[k], "plastic"),
                around(at[0] * 0.5, 0.02),
                around(at[1] + 0.05, 0.055),
                around((0.55 + 0.05 * k) * z, 0.03),
            )
        )
    return Build(body=body, surfaces=[top_surface("lid", (-x / 2, x / 2), (-y / 2, y / 2), z)])


def _open_tank(spec: Spec) -> Build:
    """A tank of glass that is open at the top: sand, and water that nothing is held up by."""
    x, y, z = spec.size
    sand, pane = 0.03 + 0.08 * z, 0.006
    inner = (around(0, x - 2 * pane), around(0, y - 2 * pane))
    body: list[Part] = [
        box(IRON, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.03)),
        box(Finish((0.82, 0.74, 0.58), "stone"), *inner, (0.03, sand)),
        box(WATER, around(0, x - 4 * pane), around(0, y - 4 * pane), (sand, 0.86 * z), collide=False),
        *(box(WATER, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - pane)), (0.03, z)) for s in (-1, 1)),
        *(box(WATER, (s * x / 2, s * (x / 2 - pane)), inner[1], (0.03, z)) for s in (-1, 1)),
    ]
    return Build(body=body, surfaces=[inner_surface("sand", *inner, sand)])


def ironing_board(spec: Spec) -> Build:
    """Return an ironing board on crossed legs."""
    x, y, z = spec.size
    cover, top = spec.main(spec.style.accent), z - 0.03
    outline = [
        (-x / 2, -y / 2 + 0.04),
        (-x / 2 + 0.04, -y / 2),
        (x / 2 - 0.04, -y / 2),
        (x / 2, -y / 2 + 0.04),
        (x / 2, 0.2 * y),
        (0.3 * x, 0.4 * y),
        (0.1 * x, y / 2),
        (-0.1 * x, y / 2),
        (-0.3 * x, 0.4 * y),
        (-x / 2, 0.2 * y),
    ]
    body: list[Part] = [prism(cover, outline, (top, z))]
    for k, (foot, head) in enumerate(((-0.36, 0.28), (0.36, -0.3))):
        at = 0.02 * (1 - 2 * k)
        body.append(rod(STEEL, (at, foot * y, 0.012), (at, head * y, top), 0.012))
        body.append(cylinder(STEEL, around(0, 0.9 * x), around(foot * y, 0.024), (0, 0.024), axis=0))
    return Build(body=body, surfaces=[top_surface("top", around(0, 0.8 * x), (-y / 2 + 0.05, 0.25 * y), z)])


def ladder(spec: Spec) -> Build:
    """Return a step ladder, open."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((GREY_METAL, spec.style.wood)))
    body: list[Part] = []
    for s in (-1, 1):
        body.append(
            leg(finish, (x / 2 - 0.03, s * (y / 2 - 0.02)), (0.03, s * (y / 2 - 0.06)), (0, z - 0.02), 0.04, 0.04)
        )
        body.append(
            leg(finish, (-x / 2 + 0.03, s * (y / 2 - 0.02)), (-0.03, s * (y / 2 - 0.06)), (0, z - 0.02), 0.04, 0.04)
        )
    steps = max(2, round(z / 0.26))
    for k in range(1, steps):
        t = k / steps
        mid, half = x / 2 - 0.03 - t * (x / 2 - 0.06), y / 2 - 0.04 - 0.04 * t
        body.append(box(finish, around(mid, 0.09), (-half, half), (t * z - 0.02, t * z)))
    body.append(box(finish, (-0.1, 0.1), around(0, y - 0.06), (z - 0.02, z)))
    return Build(body=body, surfaces=[top_surface("top", (-0.1, 0.1), around(0, y - 0.06), z)])


def drying_rack(spec: Spec) -> Build:
    """Return a clothes airer with two shirts over it."""
    x, y, z = spec.size
    body: list[Part] = []
    for s in (-1, 1):
        at = s * (y / 2 - 0.012)
        body += [
            rod(
                STEEL,
                (a * (x / 2 - 0.012), at - s * 0.02 * (a > 0), 0.012),
                (-a * 0.3 * x, at - s * 0.02 * (a > 0), z - 0.012),
                0.01,
            )
            for a in (-1, 1)
        ]
    count = 10
    for k in range(count):
        at = -x / 2 + 0.03 + k * (x - 0.06) / (count - 1)
        body.append(cylinder(STEEL, around(at, 0.012), around(0, y), (z - 0.012, z), axis=1))
    body += [
        cylinder(STEEL, (-x / 2, x / 2), around(s * (y / 2 - 0.012), 0.012), (z - 0.014, z - 0.002), axis=0)
        for s in (-1, 1)
    ]
    body += [cylinder(STEEL, around(s * (x / 2 - 0.012), 0.024), around(0, y), (0, 0.024), axis=1) for s in (-1, 1)]
    body.append(box(STEEL, (-x / 2 + 0.03, x / 2 - 0.03), around(0, y - 0.06), (z - 0.006, z)))
    for at, finish in ((-0.25 * y, WHITE_COTTON), (0.2 * y, spec.style.accent)):
        body.append(box(finish, (0.1 * x - 0.004, 0.1 * x), around(at, 0.42), (0.45 * z, z - 0.02)))
    return Build(body=body, surfaces=[top_surface("bars", (-x / 2 + 0.03, x / 2 - 0.03), around(0, y - 0.06), z)])


def vacuum_robot(spec: Spec) -> Build:
    """Return a flat round robot."""
    x, y, z = spec.size
    radius = min(x, y) / 2
    return Build(
        body=[
            disc(IRON, (0, 0), radius, (0, 0.85 * z)),
            disc(GREY_METAL, (0.1 * radius, 0), 0.25 * radius, (0.85 * z, z)),
        ]
    )


def fan(spec: Spec) -> Build:
    """Return a standing fan, a low one for a table, or one on an arm from the wall."""
    x, y, z = spec.size
    hangs = spec.has(WALL_MOUNTED)
    size, shell = min(y, z if hangs else 0.42 * z if z > 0.7 else 0.74 * z), spec.main(WHITE_PLASTIC)
    mid = z - size / 2
    body: list[Part] = [
        disc(shell, (0, 0), min(x, y) / 2 * 0.95, (0, 0.03)),
        disc(CHROME, (-0.04, 0), 0.014, (0.03, mid)),
    ]
    if hangs:
        plate = box(shell, (-x / 2, 0.02 - x / 2), around(0, 0.14), around(mid, 0.2))
        body = [plate, cylinder(CHROME, (0.02 - x / 2, -0.09), around(0, 0.04), around(mid, 0.04), axis=0)]
    body += [
        cylinder(shell, (-0.09, 0.0), around(0, 0.12), around(mid, 0.12), axis=0),
    ]
    for k in range(12):
        a, b = 2 * pi * k / 12, 2 * pi * (k + 1) / 12
        body.append(
            rod(
                shell,
                (0.03, size / 2 * sin(a) * 0.98, mid + size / 2 * cos(a) * 0.98),
                (0.03, size / 2 * sin(b) * 0.98, mid + size / 2 * cos(b) * 0.98),
                0.008,
                sides=6,
            )
        )
        body.append(
            rod(
                shell,
                (0.035, 0.03 * sin(a), mid + 0.03 * cos(a)),
                (0.03, size / 2 * sin(a) * 0.98, mid + size / 2 * cos(a) * 0.98),
                0.002,
                sides=4,
            )
        )
    for k in range(3):
        a = 2 * pi * k / 3
        blade = cushion(
            Finish((0.55, 0.66, 0.72), "plastic"),
            (0.005, 0.012),
            around(0, 0.3 * size),
            (mid + 0.03, mid + 0.46 * size),
            radius=0.003,
        )
        body.append(turned(blade, 0, k * 120.0, (0.0, 0.0, mid)))
        del a
    return Build(body=[*body, cylinder(shell, (0.0, 0.045), around(0, 0.07), around(mid, 0.07), axis=0)])


def telephone(spec: Spec) -> Build:
    """Return a desk telephone."""
    x, y, z = spec.size
    shell = spec.main(IRON)
    return Build(
        body=[
            prism(shell, [(-x / 2, 0), (x / 2, 0), (x / 2, 0.3 * z), (-x / 2, 0.7 * z)], (-y / 2, y / 2), axis=1),
            cushion(shell, (-x / 2 + 0.01, x / 2 - 0.02), (y / 2 - 0.08, y / 2 - 0.03), (0.62 * z, z), radius=0.012),
            box(SCREEN, (-0.3 * x, -0.1 * x), (-0.4 * y, 0.1 * y), (0.62 * z, 0.64 * z)),
        ]
    )
