"""Bathroom fittings."""

from itertools import pairwise

from thinkblox.assets.carcasses import Cell, cabinet_parts
from thinkblox.assets.mounting import PROPPED
from thinkblox.assets.palette import CHROME, GLASS, KRAFT, PORCELAIN, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, Range, hull, moved
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, ellipsoid, oval, prism, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.assets.worktop import tap
from thinkblox.value import Vec3


def bathtub(spec: Spec) -> Build:
    """Return a bath with a real hollow, longest across its front; the tap is at its right end."""
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
    """Return a basin on a cabinet with two doors, and a tap."""
    _, y, z = spec.size
    build = _basin_cabinet(spec, (-y / 2, y / 2), 2)
    rim = z - 0.13
    build.surfaces = [top_surface("rim", (-spec.size[0] / 2, -spec.size[0] / 2 + 0.13), (0.06, y / 2), rim)]
    return build


def vanity(spec: Spec) -> Build:
    """Return a basin at the right end of a worktop over a cabinet, with a tap; a double one has a basin at each end."""
    x, y, z = spec.size
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


def _basin_cabinet(spec: Spec, basin: Range, doors: int) -> Build:
    """A cabinet over the whole width with a basin and a tap over a part of it [m], without surfaces."""
    x, y, z = spec.size
    rim = z - 0.13
    parts = cabinet_parts(
        spec,
        (-x / 2, x / 2 - 0.015),
        (-y / 2 + 0.01, y / 2 - 0.01),
        (0.0, rim - 0.1),
        [[Cell("door")]] * doors,
        plinth=0.1,
        finish=spec.wood,
    )
    return Build(body=parts.body + _basin(spec, basin), moving=parts.moving)


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
    """Return folded towels on each other."""
    x, y, z = spec.size
    count = max(2, round(z / 0.06))
    tones = (spec.main(spec.style.accent), spec.main(spec.style.fabric))
    body = [
        cushion(
            tones[k % 2], (-x / 2, x / 2), (-y / 2, y / 2), (k * z / count, (k + 1) * z / count), radius=0.4 * z / count
        )
        for k in range(count)
    ]
    return Build(body=body)


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
