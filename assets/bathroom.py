"""Bathroom fittings."""

from dataclasses import replace
from itertools import pairwise

from thinkblox.assets.carcasses import Cell, cabinet_parts
from thinkblox.assets.mounting import PROPPED
from thinkblox.assets.palette import CHROME, GLASS, GREY_METAL, KRAFT, PORCELAIN, STEEL, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, Range, hull, moved
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    inner_surface,
    oval,
    prism,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.assets.worktop import tap
from thinkblox.value import Vec2, Vec3


def bathtub(spec: Spec) -> Build:
    """Return a bath with a real hollow, longest across its front; the tap is at its right end.

    A "standing" one is an oval tub with a tap on a post beside it.
    """
    if spec.has("standing"):
        return _standing_tub(spec)
    x, y, z = spec.size
    white, rim = spec.main(PORCELAIN), 0.07
    inner = ((-x / 2 + rim, x / 2 - rim), (-y / 2 + rim + 0.06, y / 2 - rim))
    deep = z - 0.06
    body: list[Part] = [
        *(
            cushion(
                white, (-x / 2, inner[0][0]) if s < 0 else (inner[0][1], x / 2), (-y / 2, y / 2), (0, deep), radius=0.02
            )
            for s in (-1, 1)
        ),
        cushion(white, inner[0], (-y / 2, inner[1][0]), (0, deep), radius=0.02),
        cushion(white, inner[0], (inner[1][1], y / 2), (0, deep), radius=0.02),
        box(white, *inner, (0, 0.12)),
        prism(white, [(inner[1][1], 0.12), (inner[1][1] - 0.25, 0.12), (inner[1][1], deep - 0.01)], inner[0], axis=0),
        disc(CHROME, (0, -y / 2 + 0.065), 0.012, (deep, z)),
        box(CHROME, around(0, 0.022), (-y / 2 + 0.06, -y / 2 + 0.22), (z - 0.02, z)),
        *(disc(CHROME, (s * 0.1, -y / 2 + 0.065), 0.022, (deep, deep + 0.035)) for s in (-1, 1)),
    ]
    return Build(body=body)


def _standing_tub(spec: Spec) -> Build:
    x, y, z = spec.size
    white, post = spec.main(PORCELAIN), 0.09
    tall, long, middle = z - 0.08, y - post, post / 2
    rings = ((0.0, 0.74, 0.84), (0.5, 0.88, 0.92), (0.9, 0.95, 0.97), (1.0, 1.0, 1.0))
    wall, floor = 0.05, 0.12
    sides = 24
    body: list[Part] = [prism(white, _ellipse(0.78 * x, 0.86 * long, middle, sides), (0.0, floor))]
    for (a, ax, ay), (b, bx, by) in pairwise(rings):
        low, high = _ellipse(ax * x, ay * long, middle, sides), _ellipse(bx * x, by * long, middle, sides)
        inner = [_ellipse(sx * x - 2 * wall, sy * long - 2 * wall, middle, sides) for sx, sy in ((ax, ay), (bx, by))]
        for k in range(sides):
            ends = (k, (k + 1) % sides)
            points = [
                (*ring[e], h * tall)
                for rings_at, h in (((low, inner[0]), a), ((high, inner[1]), b))
                for ring in rings_at
                for e in ends
            ]
            body.append(hull(white, points))
    at = -y / 2 + 0.03
    body += [
        disc(CHROME, (0, at), 0.03, (0, 0.012)),
        disc(CHROME, (0, at), 0.014, (0.012, z)),
        box(CHROME, around(0, 0.022), (at, at + 0.2), (z - 0.022, z)),
        disc(CHROME, (0, at + 0.19), 0.01, (z - 0.045, z - 0.02)),
    ]
    return Build(body=body)


def _ellipse(x: float, y: float, middle: float, sides: int) -> list[Vec2]:
    """An oval moved along y to its middle [m]."""
    return [(a, b + middle) for a, b in oval(x, y, sides=sides, squareness=2.6)]


def toilet(spec: Spec) -> Build:
    """Return a close-coupled WC; the cistern is at -x."""
    x, y, z = spec.size
    white, seat = spec.main(PORCELAIN), 0.52 * z
    bowl = x - 0.2
    middle = x / 2 - bowl / 2
    rings = ((0.0, 0.62, 0.6, -0.04), (0.35, 0.6, 0.56, -0.05), (0.8, 0.96, 0.94, 0.0), (1.0, 1.0, 1.0, 0.0))
    body: list[Part] = []
    for low, high in pairwise(rings):
        points: list[Vec3] = []
        for h, sx, sy, shift in (low, high):
            points += [
                (middle + shift * x + a, b, h * (seat - 0.05))
                for a, b in oval(bowl * sx, y * sy, sides=28, squareness=2.3)
            ]
        body.append(hull(white, points, smooth=True))
    lid = [(middle + a, b) for a, b in oval(bowl, y, squareness=2.3)]
    body.append(prism(WHITE_PLASTIC, lid, (seat - 0.048, seat), smooth=True))
    body += [
        box(white, (-x / 2 + 0.02, -x / 2 + 0.24), around(0, 0.62 * y), (0, seat - 0.05)),
        cushion(white, (-x / 2, -x / 2 + 0.19), (-y / 2, y / 2), (seat - 0.04, z - 0.03), radius=0.025),
        cushion(white, (-x / 2, -x / 2 + 0.195), (-y / 2 + 0.001, y / 2 - 0.001), (z - 0.03, z - 0.008), radius=0.008),
        disc(CHROME, (-x / 2 + 0.1, 0), 0.022, (z - 0.008, z)),
    ]
    return Build(body=body)


def washbasin(spec: Spec) -> Build:
    """Return a basin on a cabinet with two doors, and a tap; a double one has two basins."""
    if spec.has("double"):
        return _double_vanity(spec)
    _, y, z = spec.size
    build = _basin_cabinet(spec, (-y / 2, y / 2), 2)
    rim = z - 0.13
    build.surfaces = [top_surface("rim", (-spec.size[0] / 2, -spec.size[0] / 2 + 0.13), (0.06, y / 2), rim)]
    return build


def vanity(spec: Spec) -> Build:
    """Return a basin at the right end of a worktop over a cabinet, with a tap; a double one has a basin at each end.

    One with a plain top has none: basins are to stand on it.
    """
    x, y, z = spec.size
    if spec.has("plain-top"):
        return _plain_vanity(spec)
    if spec.has("double"):
        return _double_vanity(spec)
    split = -y / 2 + min(0.56, 0.5 * y)
    build = _basin_cabinet(spec, (-y / 2, split), max(2, round(y / 0.45)))
    build.body.append(box(PORCELAIN, (-x / 2, x / 2), (split, y / 2), (z - 0.23, z - 0.13)))
    build.surfaces = [top_surface("worktop", (-x / 2, x / 2), (split, y / 2), z - 0.13)]
    return build


def _double_vanity(spec: Spec) -> Build:
    x, y, z = spec.size
    end = min(0.56, 0.4 * y)
    build = _basin_cabinet(spec, (-y / 2, -y / 2 + end), max(2, round(y / 0.45)))
    build.body += _basin(spec, (y / 2 - end, y / 2))
    between = (-y / 2 + end, y / 2 - end)
    build.body.append(box(PORCELAIN, (-x / 2, x / 2), between, (z - 0.23, z - 0.13)))
    build.surfaces = [top_surface("worktop", (-x / 2, x / 2), between, z - 0.13)]
    return build


def _plain_vanity(spec: Spec) -> Build:
    x, y, z = spec.size
    rim = z - 0.13
    build = _cabinet(spec, max(2, round(y / 0.45)))
    build.body.append(box(PORCELAIN, (-x / 2, x / 2), (-y / 2, y / 2), (rim - 0.1, rim)))
    build.surfaces = [top_surface("worktop", (-x / 2, x / 2), (-y / 2, y / 2), rim)]
    return build


def _basin_cabinet(spec: Spec, basin: Range, doors: int) -> Build:
    """A cabinet over the whole width with a basin and a tap over a part of it [m], without surfaces."""
    build = _cabinet(spec, doors)
    build.body += _basin(spec, basin)
    return build


def _cabinet(spec: Spec, doors: int) -> Build:
    """A cabinet over the whole width, below what its worktop is."""
    x, y, z = spec.size
    parts = cabinet_parts(
        spec,
        (-x / 2, x / 2 - 0.015),
        (-y / 2 + 0.01, y / 2 - 0.01),
        (0.0, z - 0.23),
        [[Cell("door")]] * doors,
        plinth=0.1,
        finish=spec.wood,
    )
    return Build(body=parts.body, moving=parts.moving)


def _basin(spec: Spec, basin: Range) -> list[Part]:
    """A basin with a tap over a part of the width [m]."""
    x, _, z = spec.size
    rim, (low, high) = z - 0.13, basin
    white = PORCELAIN
    hollow = ((-x / 2 + 0.13, x / 2 - 0.04), (low + 0.07, high - 0.07))
    drain = sum(hollow[1]) / 2
    return [
        box(white, (-x / 2, x / 2), basin, (rim - 0.1, rim - 0.08)),
        box(white, (-x / 2, hollow[0][0]), basin, (rim - 0.08, rim)),
        box(white, (hollow[0][1], x / 2), basin, (rim - 0.08, rim)),
        *(box(white, hollow[0], side, (rim - 0.08, rim)) for side in ((low, low + 0.07), (high - 0.07, high))),
        disc(CHROME, (0.04, drain), 0.025, (rim - 0.08, rim - 0.077)),
        *(moved(part, (0.0, drain, 0.0)) for part in tap(-x / 2 + 0.06, rim, z)),
    ]


def utility_sink(spec: Spec) -> Build:
    """Return deep bowls on legs, each with a tap: of steel for a commercial sink, else of plastic."""
    x, y, z = spec.size
    shell = spec.main(STEEL if spec.category == "commercial_sink" else WHITE_PLASTIC)
    rim, wall = z - 0.2, 0.025
    low = rim - min(0.32, 0.4 * rim)
    hollow, count = (-x / 2 + 0.11, x / 2 - wall), max(1, round(y / 0.65))
    pitch = (y - wall) / count
    floor = low + 0.02
    body = [
        box(shell, (-x / 2, x / 2), (-y / 2, y / 2), (low, floor)),
        box(shell, (-x / 2, hollow[0]), (-y / 2, y / 2), (floor, rim)),
        box(shell, (hollow[1], x / 2), (-y / 2, y / 2), (floor, rim)),
        *(box(shell, hollow, around((k - count / 2) * pitch, wall), (floor, rim)) for k in range(count + 1)),
        *(
            box(GREY_METAL, around(s * (x / 2 - 0.04), 0.035), around(t * (y / 2 - 0.04), 0.035), (0, low))
            for s in (-1, 1)
            for t in (-1, 1)
        ),
        *(box(GREY_METAL, around(0, x - 0.08), around(t * (y / 2 - 0.04), 0.025), (0.16, 0.19)) for t in (-1, 1)),
        box(GREY_METAL, around(-x / 2 + 0.04, 0.025), around(0, y - 0.08), (0.16, 0.19)),
    ]
    build = Build(body=body)
    for k in range(count):
        at = (k + 0.5 - count / 2) * pitch
        build.body += [
            disc(GREY_METAL, (0.03, at), 0.035, (floor, floor + 0.004)),
            *(moved(part, (0.0, at, 0.0)) for part in tap(-x / 2 + 0.055, rim, z)),
        ]
        build.surfaces += [
            inner_surface(f"basin {k + 1}", hollow, around(at, pitch - wall), floor),
            top_surface(f"ledge {k + 1}", (-x / 2, hollow[0]), (at + 0.05, at + pitch / 2), rim),
        ]
    return build


def shower_cabin(spec: Spec) -> Build:
    """Return a shower: a tray, two walls at -x and -y, and a pane of glass; one enters from +x."""
    x, y, z = spec.size
    body = [
        box(WHITE_PLASTIC, (-x / 2, x / 2), (-y / 2, y / 2), (0, 0.06)),
        box(WHITE_PLASTIC, (-x / 2, -x / 2 + 0.02), (-y / 2, y / 2), (0.06, z)),
        box(WHITE_PLASTIC, (-x / 2 + 0.02, x / 2), (-y / 2, -y / 2 + 0.02), (0.06, z)),
        box(GLASS, (-x / 2 + 0.02, x / 2), (y / 2 - 0.01, y / 2), (0.06, z - 0.05)),
        box(CHROME, (-x / 2 + 0.02, x / 2), around(y / 2 - 0.01, 0.02), (z - 0.05, z - 0.03)),
        cylinder(CHROME, around(-x / 2 + 0.05, 0.022), around(0, 0.022), (0.9, z - 0.06)),
        box(CHROME, (-x / 2 + 0.05, -x / 2 + 0.3), around(0, 0.02), (z - 0.08, z - 0.06)),
        disc(CHROME, (-x / 2 + 0.3, 0), 0.1, (z - 0.095, z - 0.08)),
        box(CHROME, (-x / 2 + 0.02, -x / 2 + 0.07), around(0, 0.2), (1.0, 1.05)),
        disc(CHROME, (0, 0), 0.05, (0.06, 0.063)),
    ]
    return Build(body=body)


def towel_stack(spec: Spec) -> Build:
    """Return folded towels on each other; "rolled" ones lie three side by side with two on them."""
    x, y, z = spec.size
    if spec.has("rolled"):
        return _towel_rolls(spec)
    count = max(2, round(z / 0.06))
    tones = (spec.main(spec.style.accent), spec.main(spec.style.fabric))
    body = [
        cushion(
            tones[k % 2], (-x / 2, x / 2), (-y / 2, y / 2), (k * z / count, (k + 1) * z / count), radius=0.4 * z / count
        )
        for k in range(count)
    ]
    return Build(body=body)


def _towel_rolls(spec: Spec) -> Build:
    x, y, _ = spec.size
    r, raised = y / 6, 3**0.5 * y / 6
    tones = (spec.main(spec.style.accent), spec.main(spec.style.fabric))
    rows = [(2 * k * r, r) for k in (-1, 0, 1)] + [(k * r, r + raised) for k in (-1, 1)]
    along = (-x / 2, x / 2)
    return Build(body=[part for k, at in enumerate(rows) for part in _towel_roll(tones[k % 2], at, r, along)])


def _towel_roll(cloth: Finish, middle: Vec2, radius: float, along: Range) -> list[Part]:
    """A rolled towel, with the turns that are seen at its ends."""
    dark = Finish((0.7 * cloth.colour[0], 0.7 * cloth.colour[1], 0.7 * cloth.colour[2]), cloth.material)
    parts = []
    for step, (finish, share) in enumerate(((cloth, 1.0), (dark, 0.8), (cloth, 0.68), (dark, 0.4), (cloth, 0.28))):
        inset = 0.004 - 0.001 * step
        outline = [(middle[0] + a, middle[1] + b) for a, b in oval(2 * share * radius, 2 * share * radius, sides=20)]
        parts.append(prism(finish, outline, (along[0] + inset, along[1] - inset), axis=0, smooth=True))
    return [parts[0], *(replace(part, collide=False) for part in parts[1:])]


def toilet_paper(spec: Spec) -> Build:
    """Return a holder with a roll, for the wall, or a roll that stands by itself."""
    x, y, z = spec.size
    if spec.has(PROPPED):
        radius, paper = min(x, y) / 2, Finish(PORCELAIN.colour, "paper")
        core = disc(KRAFT, (0, 0), 0.4 * radius, (z - 0.001, z), collide=False)
        return Build(body=[disc(paper, (0, 0), radius, (0, z - 0.001)), core])
    size = min(x - 0.02, z)
    body: list[Part] = [
        box(CHROME, (-x / 2, -x / 2 + 0.01), around(0, 0.04), around(z / 2, 0.05)),
        box(CHROME, (-x / 2 + 0.01, x / 2 - size / 2), around(-y / 2 + 0.006, 0.012), around(z / 2, 0.012)),
        box(CHROME, (-x / 2 + 0.01, -x / 2 + 0.02), (-y / 2, 0.02), around(z / 2, 0.012)),
        cylinder(
            PORCELAIN, (x / 2 - size, x / 2), (-y / 2 + 0.012, y / 2), (z / 2 - size / 2, z / 2 + size / 2), axis=1
        ),
    ]
    return Build(body=body)


def soap_dispenser(spec: Spec) -> Build:
    """Return a bottle of soap with a pump."""
    x, y, z = spec.size
    radius = y / 2
    at = -x / 2 + radius
    return Build(
        body=[
            disc(spec.main(spec.style.glaze), (at, 0), radius, (0, 0.68 * z)),
            ellipsoid(spec.main(spec.style.glaze), (at - radius, at + radius), (-radius, radius), (0.6 * z, 0.76 * z)),
            disc(CHROME, (at, 0), 0.18 * radius, (0.74 * z, z - 0.012)),
            box(CHROME, (at, x / 2), around(0, 0.012), (z - 0.012, z)),
        ]
    )


def massage_table(spec: Spec) -> Build:
    """Return a padded couch with a head part, along x."""
    x, y, z = spec.size
    cover, wood = spec.main(spec.style.accent), spec.style.wood
    body: list[Part] = [cushion(cover, (-x / 2 + 0.34, x / 2), (-y / 2, y / 2), (z - 0.1, z), radius=0.03)]
    body.append(cushion(cover, (-x / 2, -x / 2 + 0.33), around(0, 0.5 * y), (z - 0.1, z), radius=0.04))
    body += [box(wood, (-x / 2 + 0.2, x / 2 - 0.05), around(s * 0.3 * y, 0.04), (z - 0.16, z - 0.1)) for s in (-1, 1)]
    body += [
        box(wood, around(a, 0.06), around(s * 0.4 * y, 0.05), (0, z - 0.1))
        for a in (-x / 2 + 0.5, x / 2 - 0.12)
        for s in (-1, 1)
    ]
    body += [box(wood, around(a, 0.03), around(0, 0.8 * y), (0.2, 0.26)) for a in (-x / 2 + 0.5, x / 2 - 0.12)]
    return Build(body=body, surfaces=[top_surface("couch", (-x / 2 + 0.38, x / 2 - 0.04), around(0, y - 0.08), z)])
