"""Tables: a top on legs, on a pedestal or on panels. Legs stand at the corners, so that seats go under."""

from thinkblox.assets.palette import CHARCOAL_PAINT, GLASS, IRON, MARBLE, STEEL, WHITE_PAINT
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import (
    around,
    box,
    cylinder,
    disc,
    frustum,
    leg,
    oval,
    polygon,
    prism,
    rod,
    round_leg,
    top_surface,
)
from thinkblox.assets.sizing import POLYGONS
from thinkblox.assets.spec import Spec
from thinkblox.value import Vec2

APRON = 0.055
"""Depth of the rail under a table's top [m]."""


def is_round(spec: Spec) -> bool:
    """Whether a round or oval top was asked for."""
    return spec.has("round", "circular", "oval")


def corners_of(spec: Spec) -> int:
    """How many corners a top has that is neither round nor four-cornered; 0 for any other."""
    return next((count for word, count in POLYGONS.items() if spec.has(word)), 0)


def _is_cut(spec: Spec) -> bool:
    """Whether its top leaves the corners of its box free."""
    return is_round(spec) or corners_of(spec) > 0


def table_top(spec: Spec, finish: Finish, thickness: float) -> list[Part]:
    """Return the top, over the whole box, with a bevelled lower edge where it is thick enough."""
    x, y, z = spec.size
    finish = GLASS if spec.has("glass") else finish
    if count := corners_of(spec):
        return [prism(finish, polygon(x, y, count), (z - thickness, z))]
    if is_round(spec):
        if abs(x - y) < 1e-9:
            return [disc(finish, (0, 0), x / 2, (z - thickness, z))]
        return [prism(finish, oval(x, y, squareness=2.4), (z - thickness, z), smooth=True)]
    return [box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (z - thickness, z))]


def corner_legs(spec: Spec, finish: Finish, height: float, kind: str, inset: float) -> list[Part]:
    """Return four legs near the corners of the box, up to `height`."""
    x, y = spec.size[0] / 2 - inset, spec.size[1] / 2 - inset
    if _is_cut(spec):
        inward = 0.64 if corners_of(spec) else 0.72
        x, y = x * inward, y * inward
    width = min(0.07, 0.09 * min(spec.size[0], spec.size[1]) + 0.012)
    legs: list[Part] = []
    for sx, sy in ((1, 1), (1, -1), (-1, -1), (-1, 1)):
        foot, head = (sx * x, sy * y), (sx * (x - 0.02), sy * (y - 0.02))
        if kind == "splayed":
            head = (sx * (x - 0.06), sy * (y - 0.06))
            legs.append(round_leg(finish, foot, head, (0, height), width * 0.26, width * 0.42))
        elif kind == "tapered":
            legs.append(leg(finish, head, head, (0, height), width * 0.55, width))
        else:
            legs.append(box(finish, around(head[0], width * 0.8), around(head[1], width * 0.8), (0, height)))
    return legs


def _apron(spec: Spec, finish: Finish, z: float, inset: float) -> list[Part]:
    x, y = spec.size[0] / 2 - inset, spec.size[1] / 2 - inset
    zs = (z - APRON, z)
    parts = [box(finish, around(s * x, 0.02), (-y, y), zs) for s in (-1, 1)]
    return parts + [box(finish, (-x + 0.01, x - 0.01), around(s * y, 0.02), zs) for s in (-1, 1)]


def _pedestal(spec: Spec, finish: Finish, height: float) -> list[Part]:
    radius = 0.29 * min(spec.size[0], spec.size[1])
    column = min(0.045, 0.12 * radius + 0.015)
    return [
        disc(finish, (0, 0), radius, (0, 0.012)),
        frustum(finish, (0, 0), (0.012, 0.05), radius * 0.9, column * 1.15),
        disc(finish, (0, 0), column, (0.05, height - 0.02)),
        disc(finish, (0, 0), radius * 0.6, (height - 0.02, height)),
    ]


def _top_area(spec: Spec) -> Build:
    x, y, z = spec.size
    if corners_of(spec):
        x, y = min(x, y), min(x, y)
    surface = top_surface("top", (-x / 2, x / 2), (-y / 2, y / 2), z, round=_is_cut(spec))
    circular = is_round(spec) and abs(x - y) < 0.02
    return Build(surfaces=[surface], front="any" if circular else None)


def table(spec: Spec) -> Build:
    """Return a dining, kitchen, play or square table."""
    build, (x, y, z) = _top_area(spec), spec.size
    thickness = min(0.032, 0.06 * z)
    under = z - thickness
    build.body = table_top(spec, spec.wood, thickness)
    if is_round(spec) and max(x, y) < 1.45 and spec.rng.random() < 0.6:
        build.body += _pedestal(spec, spec.main(spec.choice((spec.style.metal, spec.style.wood))), under)
        return build
    inset = min(0.06, 0.07 * min(x, y))
    kind = spec.choice(("tapered", "square", "splayed"))
    legs = spec.wood if spec.rng.random() < 0.75 else spec.style.paint
    build.body += corner_legs(spec, legs, under, kind, inset)
    if not _is_cut(spec):
        build.body += _apron(spec, legs, under, inset + 0.03)
    return build


def coffee_table(spec: Spec) -> Build:
    """Return a low table, now and then with a shelf below."""
    build, (x, y, z) = _top_area(spec), spec.size
    thickness = min(0.03, 0.09 * z)
    marble = spec.rng.random() < 0.25 and not spec.words
    build.body = table_top(spec, MARBLE if marble else spec.wood, thickness)
    frame = spec.style.metal if marble or spec.rng.random() < 0.3 else spec.wood
    build.body += corner_legs(spec, frame, z - thickness, spec.choice(("tapered", "splayed", "square")), 0.05)
    if not _is_cut(spec) and z > 0.3 and spec.rng.random() < 0.6 and not spec.has("open"):
        area = ((-x / 2 + 0.085, x / 2 - 0.085), (-y / 2 + 0.085, y / 2 - 0.085))
        shelf = 0.3 * z
        bars = [
            box(frame, around(s * (x / 2 - 0.08), 0.02), (-y / 2 + 0.06, y / 2 - 0.06), (shelf - 0.03, shelf))
            for s in (-1, 1)
        ]
        build.body += [*bars, box(spec.wood, *area, (shelf - 0.018, shelf))]
        build.surfaces.append(top_surface("shelf", *area, shelf, headroom=z - thickness - shelf))
    return build


def side_table(spec: Spec) -> Build:
    """Return a small table beside a seat: on a pedestal when round, else with a shelf."""
    build, (_, _, z) = _top_area(spec), spec.size
    build.body = table_top(spec, spec.wood, 0.022)
    if _is_cut(spec):
        build.body += _pedestal(spec, spec.style.metal, z - 0.022)
    else:
        build.body += corner_legs(spec, spec.wood, z - 0.022, "tapered", 0.03)
        build.body += _apron(spec, spec.wood, z - 0.022, 0.05)
    return build


def console_table(spec: Spec) -> Build:
    """Return a narrow table for a wall, on slim metal or wooden legs, with a shelf unless it is "open"."""
    build, (x, y, z) = _top_area(spec), spec.size
    frame = spec.choice((spec.style.metal, spec.style.wood))
    build.body = table_top(spec, spec.wood, 0.03)
    build.body += corner_legs(spec, frame, z - 0.03, "square", 0.03)
    if spec.has("open"):
        return build
    shelf = ((-x / 2 + 0.03, x / 2 - 0.03), (-y / 2 + 0.03, y / 2 - 0.03), (0.15, 0.17))
    build.body.append(box(spec.wood, *shelf))
    build.surfaces.append(top_surface("shelf", shelf[0], shelf[1], 0.17, headroom=z - 0.2))
    return build


def high_table(spec: Spec) -> Build:
    """Return a standing-height table on one foot, its top round unless "square" was asked for."""
    words = spec.words if spec.has("square", "long", "rectangular") else spec.words | {"round"}
    spec = Spec(spec.category, spec.size, words, spec.style, spec.rng)
    build, z = _top_area(spec), spec.size[2]
    build.body = table_top(spec, spec.wood, 0.03)
    if max(spec.size[:2]) > 1.6 * min(spec.size[:2]):
        build.body += corner_legs(spec, spec.style.metal, z - 0.03, "square", 0.06)
    else:
        build.body += _pedestal(spec, spec.style.metal if spec.style.metal != STEEL else IRON, z - 0.03)
    return build


def conference_table(spec: Spec) -> Build:
    """Return a long table on two inset panels, so that seats go in all round."""
    build, (x, y, z) = _top_area(spec), spec.size
    build.body = table_top(spec, spec.wood, 0.035)
    frame = spec.style.metal if spec.style.metal == IRON else CHARCOAL_PAINT
    count = 2 if y < 3.4 else 3
    for k in range(count):
        at = (k / (count - 1) - 0.5) * 0.56 * y
        build.body += [
            box(frame, around(0, 0.42 * x), around(at, 0.09), (0, 0.03)),
            box(frame, around(0, 0.24 * x), around(at, 0.06), (0.03, z - 0.06)),
            box(frame, around(0, 0.5 * x), around(at, 0.09), (z - 0.06, z - 0.035)),
        ]
    build.body.append(box(frame, around(0, 0.03), around(0, 0.56 * y - 0.06), (z - 0.2, z - 0.12)))
    return build


def display_table(spec: Spec) -> Build:
    """Return a broad shop table with a shelf near the floor, unless it is "open"."""
    build, (x, y, z) = _top_area(spec), spec.size
    build.body = table_top(spec, spec.wood, 0.04) + corner_legs(spec, spec.wood, z - 0.04, "square", 0.04)
    if not is_round(spec):
        build.body += _apron(spec, spec.wood, z - 0.04, 0.06)
    if not is_round(spec) and not spec.has("open"):
        area = ((-x / 2 + 0.05, x / 2 - 0.05), (-y / 2 + 0.05, y / 2 - 0.05))
        build.body.append(box(spec.wood, *area, (0.16, 0.185)))
        build.surfaces.append(top_surface("shelf", *area, 0.185, headroom=z - 0.185 - 0.04 - APRON))
    return build


def tiered_table(spec: Spec) -> Build:
    """Return a stand of three steps that rise to the back."""
    x, y, z = spec.size
    build, depth = Build(), x / 3
    for k in range(3):
        front = x / 2 - k * depth
        height = z * (0.45 + 0.275 * k)
        build.body.append(
            box(spec.wood, (front - depth + (0.004 if k < 2 else 0), front), (-y / 2, y / 2), (height - 0.025, height))
        )
        for side in (-1, 0, 1) if y > 1.4 else (-1, 1):
            at = side * (y / 2 - 0.05)
            build.body += _trestle(spec.wood, (front - 0.03, front - depth + 0.04), at, height - 0.025)
        area = (front - depth + 0.004, front)
        build.surfaces.append(top_surface(f"tier {k + 1}", area, (-y / 2, y / 2), height))
        build.body.append(
            box(
                spec.wood, (front - 0.04, front - 0.02), (-y / 2 + 0.03, y / 2 - 0.03), (height - 0.085, height - 0.025)
            )
        )
    return build


def _trestle(finish: Finish, xs: tuple[float, float], y: float, height: float) -> list[Part]:
    return [box(finish, around(x, 0.035), around(y, 0.035), (0, height)) for x in xs]


def folding_table(spec: Spec) -> Build:
    """Return a light table on crossed tubes."""
    build, (x, y, z) = _top_area(spec), spec.size
    build.body = table_top(spec, spec.main(WHITE_PAINT), 0.03)
    reach, apart = (x / 2 - 0.09, y / 2 - 0.16) if not _is_cut(spec) else (0.3 * x, 0.3 * y)
    for side in (-1, 1):
        at = side * apart
        ends: tuple[Vec2, Vec2] = ((-reach, reach), (reach, -reach))
        for shift, (foot, head) in zip((-0.013, 0.013), ends, strict=True):
            build.body.append(rod(STEEL, (foot, at + shift, 0.012), (head, at + shift, z - 0.031), 0.011))
        for foot in ends[0]:
            build.body.append(cylinder(STEEL, around(foot, 0.026), around(at, 0.2), (0, 0.026), axis=1))
    return build


def workbench(spec: Spec) -> Build:
    """Return a heavy bench with a thick top and, unless it is "open", a shelf."""
    build, (x, y, z) = _top_area(spec), spec.size
    build.body = table_top(spec, spec.wood, 0.06) + corner_legs(spec, spec.wood, z - 0.06, "square", 0.03)
    area = ((-x / 2 + 0.04, x / 2 - 0.04), (-y / 2 + 0.04, y / 2 - 0.04))
    build.body += _apron(spec, spec.wood, z - 0.06, 0.05)
    if spec.has("open"):
        return build
    build.body.append(box(spec.wood, *area, (0.2, 0.23)))
    build.surfaces.append(top_surface("shelf", *area, 0.23, headroom=z - 0.29 - APRON))
    return build
