"""Chairs, stools and benches. The back is at -x; what is in front of it goes under a table."""

from dataclasses import replace
from math import atan, cos, degrees, pi, sin

from thinkblox.assets.palette import BLACK_PLASTIC, CHARCOAL_WOOL, CHROME, IRON
from thinkblox.assets.part import Build, Finish, Part, turned
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, leg, rod, round_leg, sphere, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.assets.stripes import CHECKED, STRIPED

_THICKNESS = {"slats": 0.028, "shell": 0.022, "upholstered": 0.06}


def _seat_height(z: float) -> float:
    return min(0.46, 0.54 * z) if z > 0.75 else 0.52 * z


def chair(spec: Spec) -> Build:
    """Return a side chair: wooden with slats, upholstered, or a moulded shell; a "folding" one on crossed legs."""
    if spec.has("folding"):
        return _folding_chair(spec)
    x, y, z = spec.size
    seat = _seat_height(z)
    kind = "shell" if spec.has("school", "plastic") else spec.choice(("slats", "upholstered", "slats", "shell"))
    kind = "upholstered" if spec.has("leather", "fabric", "upholstered", STRIPED, CHECKED) else kind
    frame = spec.style.metal if kind == "shell" and spec.has("school") else spec.wood
    build = Build(surfaces=[top_surface("seat", (-x / 2 + 0.09, x / 2), (-y / 2 + 0.02, y / 2 - 0.02), seat)])
    build.body = _chair_frame(spec, frame, seat, _THICKNESS[kind], posts=kind == "slats")
    cover = spec.fabric if spec.has("leather") else spec.main(spec.style.accent)
    cover = cover if kind == "upholstered" else spec.main(spec.style.wood)
    if kind == "upholstered":
        build.body += [
            cushion(cover, (-x / 2 + 0.02, x / 2), (-y / 2, y / 2), (seat - 0.07, seat), radius=0.025),
            _tilted_back(
                cushion(cover, (-x / 2, -x / 2 + 0.06), (-y / 2 + 0.01, y / 2 - 0.01), (seat + 0.03, z), radius=0.025),
                x,
                seat,
            ),
        ]
        build.body += [
            leg(
                frame,
                (-x / 2 + 0.05, s * 0.3 * y),
                (-x / 2 + 0.03, s * 0.3 * y),
                (seat - 0.05, seat + 0.08),
                0.025,
                0.025,
            )
            for s in (-1, 1)
        ]
    elif kind == "shell":
        shell = spec.main(Finish(spec.style.accent.colour, "plastic"))
        build.body += [
            cushion(shell, (-x / 2 + 0.02, x / 2), (-y / 2, y / 2), (seat - 0.022, seat), radius=0.011),
            _tilted_back(
                cushion(shell, (-x / 2, -x / 2 + 0.02), (-y / 2 + 0.01, y / 2 - 0.01), (seat + 0.06, z), radius=0.05),
                x,
                seat,
            ),
        ]
        build.body += [
            leg(
                shell,
                (-x / 2 + 0.045, s * 0.3 * y),
                (-x / 2 + 0.02, s * 0.3 * y),
                (seat - 0.02, seat + 0.1),
                0.03,
                0.02,
            )
            for s in (-1, 1)
        ]
    else:
        build.body.append(
            cushion(spec.wood, (-x / 2 + 0.03, x / 2), (-y / 2, y / 2), (seat - 0.028, seat), radius=0.012)
        )
        build.body += _slats(spec, seat)
    return build


def _folding_chair(spec: Spec) -> Build:
    x, y, z = spec.size
    seat = _seat_height(z)
    frame, board = spec.style.metal, spec.main(spec.style.wood)
    body: list[Part] = [cushion(board, (-0.3 * x, x / 2), around(0, y - 0.09), (seat - 0.02, seat), radius=0.008)]
    for s in (-1, 1):
        outer, inner = s * (y / 2 - 0.012), s * (y / 2 - 0.035)
        body.append(rod(frame, (x / 2 - 0.012, outer, 0.0), (-x / 2 + 0.012, outer, z), 0.011))
        body.append(rod(frame, (-x / 2 + 0.012, inner, 0.0), (0.36 * x, inner, seat - 0.02), 0.011))
    lean = (x - 0.024) / z
    for low, high, thick in ((0.03, 0.055, 0.011), (0.7, 0.94, 0.016)):
        at = x / 2 - 0.012 - lean * (low + high) / 2 * z
        bar = box(board if high > 0.5 else frame, around(at, thick), around(0, y - 0.02), (low * z, high * z))
        body.append(turned(bar, 1, -degrees(atan(lean)), bar.centre) if high > 0.5 else bar)
    body.append(box(frame, around(-x / 2 + 0.035, 0.011), around(0, y - 0.07), (0.03 * z, 0.055 * z)))
    area = ((-0.28 * x, x / 2 - 0.01), around(0, y - 0.1))
    return Build(body=body, surfaces=[top_surface("seat", *area, seat)])


def _tilted_back(part: Part, x: float, seat: float) -> Part:
    return turned(part, 1, -6.0, (-x / 2 + 0.05, 0.0, seat))


def _chair_frame(spec: Spec, frame: Finish, seat: float, thick: float, *, posts: bool) -> list[Part]:
    x, y, z = spec.size
    under = seat - thick
    parts = [
        leg(frame, (x / 2 - 0.025, s * (y / 2 - 0.025)), (x / 2 - 0.045, s * (y / 2 - 0.045)), (0, under), 0.024, 0.036)
        for s in (-1, 1)
    ]
    for s in (-1, 1):
        back = s * (y / 2 - 0.04)
        parts.append(
            leg(frame, (-x / 2 + 0.02, back), (-x / 2 + 0.055, back), (0, under if not posts else seat), 0.024, 0.034)
        )
        if posts:
            parts.append(leg(frame, (-x / 2 + 0.055, back), (-x / 2 + 0.014, back), (seat, z), 0.034, 0.026))
    rail = (under - 0.05, under)
    parts += [box(frame, (-x / 2 + 0.06, x / 2 - 0.05), around(s * (y / 2 - 0.045), 0.02), rail) for s in (-1, 1)]
    parts += [box(frame, around(s * (x / 2 - 0.055), 0.02), (-y / 2 + 0.05, y / 2 - 0.05), rail) for s in (-1, 1)]
    return parts


def _slats(spec: Spec, seat: float) -> list[Part]:
    x, y, z = spec.size
    inner = (-y / 2 + 0.052, y / 2 - 0.052)
    parts: list[Part] = []
    for low, high in ((0.46, 0.6), (0.72, 0.86)) if z < 0.95 else ((0.4, 0.5), (0.6, 0.7), (0.82, 0.97)):
        mid = -x / 2 + 0.055 - 0.041 * (low + high) / 2
        parts.append(box(spec.wood, around(mid, 0.016), inner, (seat + low * (z - seat), seat + high * (z - seat))))
    return parts


def office_chair(spec: Spec) -> Build:
    """Return a swivel chair on five castors; its arms are low and set back, so that it goes under a desk."""
    x, y, z = spec.size
    seat = min(0.48, 0.5 * z)
    cover = spec.main(spec.choice((CHARCOAL_WOOL, spec.style.accent, CHARCOAL_WOOL)))
    frame = spec.choice((BLACK_PLASTIC, CHROME)) if spec.rng.random() < 0.5 else BLACK_PLASTIC
    reach = min(x, y) / 2 - 0.03
    parts: list[Part] = [
        disc(frame, (0, 0), 0.04, (0.07, 0.16)),
        disc(CHROME, (0, 0), 0.025, (0.16, seat - 0.1)),
        disc(frame, (0, 0), 0.09, (seat - 0.1, seat - 0.07)),
    ]
    for k in range(5):
        c, s = cos(2 * pi * k / 5 + pi), sin(2 * pi * k / 5 + pi)
        parts.append(
            rod(frame, (0.03 * c, 0.03 * s, 0.1), (reach * c, reach * s, 0.07), 0.025, end_radius=0.014, sides=8)
        )
        parts.append(sphere(BLACK_PLASTIC, (reach * c, reach * s, 0.028), 0.028))
    parts.append(
        cushion(cover, (-x / 2 + 0.1, x / 2 - 0.03), (-y / 2 + 0.06, y / 2 - 0.06), (seat - 0.075, seat), radius=0.035)
    )
    back = cushion(cover, (-x / 2 + 0.06, -x / 2 + 0.12), (-y / 2 + 0.08, y / 2 - 0.08), (seat + 0.1, z), radius=0.03)
    parts.append(turned(back, 1, -7.0, (-x / 2 + 0.1, 0.0, seat)))
    parts.append(leg(frame, (-x / 2 + 0.15, 0), (-x / 2 + 0.045, 0), (seat - 0.08, seat + 0.3), 0.05, 0.03))
    if not spec.has("armless"):
        for side in (-1, 1):
            at = side * (y / 2 - 0.03)
            parts += [
                cushion(frame, (-x / 2 + 0.14, 0.06), around(at, 0.05), (seat + 0.12, seat + 0.145), radius=0.012),
                box(frame, (-0.1, -0.06), around(at, 0.02), (seat - 0.08, seat + 0.12)),
                box(frame, (-0.1, -0.06), (min(0.09 * side, at), max(0.09 * side, at)), (seat - 0.095, seat - 0.075)),
            ]
    area = ((-x / 2 + 0.14, x / 2 - 0.07), (-y / 2 + 0.1, y / 2 - 0.1))
    return Build(body=parts, surfaces=[top_surface("seat", *area, seat)])


def stool(spec: Spec) -> Build:
    """Return a stool with a round seat on four splayed legs, which stand under it where "round" is asked for.

    The seat of a "square" one is square. A high one has a foot ring, a "swivel" one a column on a foot, a "folding" one
    crossed legs.
    """
    if spec.has("swivel", "folding"):
        return _swivel_stool(spec) if spec.has("swivel") else _folding_stool(spec)
    x, y, z = spec.size
    top = spec.wood if spec.rng.random() < 0.6 else spec.main(spec.style.accent)
    frame = spec.style.metal if spec.rng.random() < 0.4 else spec.style.wood
    radius = min(x, y) / 2
    soft = top.material == "fabric"
    thick = 0.06 if soft else 0.032
    upright = spec.has("round", "circular")
    seat_radius = radius if upright else radius - 0.02
    angular = spec.has("square", "rectangular")
    parts: list[Part] = [disc(top, (0, 0), seat_radius, (z - thick, z))]
    if angular:
        parts = [cushion(top, (-radius, radius), (-radius, radius), (z - thick, z), radius=0.012)]
    corners = [(sx, sy) for sx in (-1, 1) for sy in (-1, 1)]
    foot, head = (0.66 if upright else 1.0) * radius - 0.016, (0.42 if upright else 0.5) * radius
    parts += [
        round_leg(frame, (sx * foot, sy * foot), (sx * head, sy * head), (0, z - thick), 0.012, 0.018)
        for sx, sy in corners
    ]
    height = 0.3 if z > 0.6 else 0.4 * z
    at = foot + (head - foot) * height / (z - thick)
    for s in (-1, 1):
        parts.append(rod(frame, (-at, s * at, height), (at, s * at, height), 0.008))
        parts.append(rod(frame, (s * at, -at, height + 0.03), (s * at, at, height + 0.03), 0.008))
    area = around(0, 2 * seat_radius)
    surface = top_surface("seat", area, area, z, round=not angular)
    return Build(body=parts, surfaces=[surface], front="two" if angular else "any")


def _swivel_stool(spec: Spec) -> Build:
    x, y, z = spec.size
    cover, metal = spec.main(spec.style.accent), spec.choice((CHROME, IRON))
    radius, hub = min(x, y) / 2, 0.1
    parts: list[Part] = [
        disc(metal, (0, 0), 0.032, (0.03, hub)),
        disc(metal, (0, 0), 0.02, (hub, z - 0.08)),
        disc(metal, (0, 0), 0.45 * radius, (z - 0.08, z - 0.06)),
        disc(cover, (0, 0), radius, (z - 0.06, z)),
    ]
    for k in range(5):
        c, s = cos(2 * pi * k / 5), sin(2 * pi * k / 5)
        reach = radius - 0.02
        parts.append(rod(metal, (0, 0, 0.06), (reach * c, reach * s, 0.02), 0.02, end_radius=0.013, sides=8))
        parts.append(disc(BLACK_PLASTIC, (reach * c, reach * s), 0.018, (0, 0.02)))
    area = around(0, 2 * radius)
    return Build(body=parts, surfaces=[top_surface("seat", area, area, z, round=True)], front="any")


def _folding_stool(spec: Spec) -> Build:
    x, y, z = spec.size
    cloth = spec.main(Finish(spec.style.accent.colour, "fabric"))
    parts: list[Part] = [cushion(cloth, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.03, z), radius=0.012)]
    for s in (-1, 1):
        for turn, at in ((1, y / 2 - 0.014), (-1, y / 2 - 0.042)):
            ends = ((turn * (x / 2 - 0.016), s * at, 0.0), (-turn * (x / 2 - 0.03), s * at, z - 0.03))
            parts.append(rod(spec.style.wood, *ends, 0.013))
    for turn, wide in ((1, y - 0.03), (-1, y - 0.09)):
        at = turn * (x / 2 - 0.016 - 0.1 * (x - 0.046))
        parts.append(cylinder(spec.style.wood, around(at, 0.018), around(0, wide), around(0.1 * z, 0.018), axis=1))
    area = (around(0, x - 0.03), around(0, y - 0.03))
    return Build(body=parts, surfaces=[top_surface("seat", *area, z)], front="two")


def bar_stool(spec: Spec) -> Build:
    """Return a high seat: four legs, or a column on a foot with a low back."""
    if spec.rng.random() < 0.5 or spec.has("swivel", "folding"):
        return stool(spec)
    x, y, z = spec.size
    seat = min(0.75, 0.86 * z) if not spec.has("backless") else z
    cover, metal = spec.main(spec.style.accent), spec.choice((CHROME, IRON))
    radius = min(x, y) / 2
    parts = [
        disc(metal, (0, 0), radius, (0, 0.015)),
        disc(metal, (0, 0), 0.03, (0.015, seat - 0.08)),
        disc(metal, (0, 0), 0.1, (seat - 0.08, seat - 0.06)),
        disc(metal, (0, 0), 0.16, (0.28, 0.298)),
        disc(cover, (0, 0), radius - 0.01, (seat - 0.06, seat)),
    ]
    if z - seat > 0.06:
        back = cushion(cover, (-x / 2, -x / 2 + 0.045), (-0.8 * radius, 0.8 * radius), (seat + 0.03, z), radius=0.02)
        parts += [back, box(metal, (-x / 2 + 0.015, -x / 2 + 0.035), around(0, 0.06), (seat - 0.05, seat + 0.06))]
    area = around(0.01, 2 * radius * 0.8)
    return Build(body=parts, surfaces=[top_surface("seat", area, area, seat, round=True)])


def sauna_bench(spec: Spec) -> Build:
    """Return a bench of bare boards."""
    return bench(replace(spec, words=spec.words | {"wooden"}))


def bench(spec: Spec) -> Build:
    """Return a bench: a wooden seat or a cushion on four legs; "waiting" or tall ones have a back."""
    x, y, z = spec.size
    backed = z > 0.62
    seat = min(0.46, 0.55 * z) if backed else z
    soft = spec.has("upholstered") or (not backed and spec.rng.random() < 0.45 and not spec.has("wooden"))
    cover = spec.main(spec.style.accent) if soft else spec.wood
    thick = 0.09 if soft else 0.035
    make = cushion(cover, (-x / 2, x / 2), (-y / 2, y / 2), (seat - thick, seat), radius=0.03 if soft else 0.008)
    feet = [(sx * (x / 2 - 0.05), sy * (y / 2 - 0.1)) for sx in (-1, 1) for sy in (-1, 1)]
    parts = [make, *(leg(spec.style.wood, at, at, (0, seat - thick), 0.03, 0.045) for at in feet)]
    parts += [
        box(
            spec.style.wood,
            around(s * (x / 2 - 0.05), 0.022),
            (-y / 2 + 0.1, y / 2 - 0.1),
            (seat - thick - 0.05, seat - thick),
        )
        for s in (-1, 1)
    ]
    if backed:
        parts += [box(spec.wood, (-x / 2, -x / 2 + 0.04), around(s * (y / 2 - 0.1), 0.04), (seat, z)) for s in (-1, 1)]
        parts += [
            box(
                spec.wood,
                (-x / 2 + 0.04, -x / 2 + 0.06),
                (-y / 2, y / 2),
                (seat + a * (z - seat), seat + b * (z - seat)),
            )
            for a, b in ((0.35, 0.6), (0.72, 0.97))
        ]
    area = ((-x / 2 + (0.07 if backed else 0.02), x / 2 - 0.02), (-y / 2 + 0.02, y / 2 - 0.02))
    return Build(body=parts, surfaces=[top_surface("seat", *area, seat)], front="one" if backed else "two")


def pew(spec: Spec) -> Build:
    """Return a long seat with a closed back and panelled ends."""
    x, y, z = spec.size
    seat = min(0.45, 0.5 * z)
    parts = [box(spec.wood, (-x / 2, x / 2), (s * (y / 2 - 0.04), s * y / 2), (0, 0.72 * z)) for s in (-1, 1)]
    inner = (-y / 2 + 0.04, y / 2 - 0.04)
    parts += [
        box(spec.wood, (-x / 2 + 0.04, x / 2 - 0.03), inner, (seat - 0.035, seat)),
        box(spec.wood, (-x / 2, -x / 2 + 0.03), inner, (seat - 0.1, z)),
        box(spec.wood, (-x / 2 + 0.1, -x / 2 + 0.12), inner, (0.02, seat - 0.035)),
    ]
    return Build(body=parts, surfaces=[top_surface("seat", (-x / 2 + 0.04, x / 2 - 0.03), inner, seat)])


def child_chair(spec: Spec) -> Build:
    """Return a small chair: a thick seat, four stout legs and one back board."""
    x, y, z = spec.size
    seat = 0.52 * z
    paint = spec.main(
        Finish(spec.choice(((0.86, 0.66, 0.34), (0.52, 0.66, 0.60), (0.85, 0.56, 0.46), (0.90, 0.87, 0.80))), "wood")
    )
    feet = [(sx * (x / 2 - 0.02), sy * (y / 2 - 0.02)) for sx in (-1, 1) for sy in (-1, 1)]
    parts: list[Part] = [
        round_leg(spec.style.wood, at, (0.82 * at[0], 0.82 * at[1]), (0, seat - 0.025), 0.014, 0.019) for at in feet
    ]
    parts.append(cushion(paint, (-x / 2 + 0.015, x / 2), (-y / 2, y / 2), (seat - 0.025, seat), radius=0.012))
    parts += [
        leg(
            spec.style.wood, (-x / 2 + 0.035, s * 0.3 * y), (-x / 2 + 0.018, s * 0.3 * y), (seat, z - 0.02), 0.024, 0.02
        )
        for s in (-1, 1)
    ]
    parts.append(
        cushion(paint, (-x / 2 + 0.003, -x / 2 + 0.033), (-y / 2 + 0.01, y / 2 - 0.01), (0.74 * z, z), radius=0.014)
    )
    return Build(
        body=parts, surfaces=[top_surface("seat", (-x / 2 + 0.05, x / 2 - 0.01), (-y / 2 + 0.01, y / 2 - 0.01), seat)]
    )
