"""Beds: a frame, a mattress, a duvet and pillows. The head is at -x."""

from thinkblox.assets.palette import GREY_METAL, LINEN, WHITE_COTTON, WHITE_PLASTIC
from thinkblox.assets.part import Build, Finish, Part, Range, turned
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, leg, pad, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Surface


def bed(spec: Spec) -> Build:
    """Return a bed with a wooden or upholstered head; two pillows when 1.2 m or wider.

    A "raised" one is of wood, on higher legs with room for a case below.
    """
    x, y, z = spec.size
    posts, raised = spec.has("four-poster", "canopy"), spec.has("raised")
    z = min(z, 0.95) if posts else z
    wooden = posts or raised or spec.has("wooden")
    soft = (spec.has("upholstered") and not (posts or raised)) or (spec.rng.random() < 0.4 and not wooden)
    top = 0.64 * z if raised else min(0.56, 0.62 * z)
    build = Build()
    if soft:
        cover = spec.fabric
        build.body = [cushion(cover, (-x / 2, -x / 2 + 0.1), (-y / 2, y / 2), (0.06, z), radius=0.04)]
        build.body.append(cushion(cover, (-x / 2 + 0.1, x / 2), (-y / 2, y / 2), (0.1, top - 0.2), radius=0.03))
    else:
        build.body = [cushion(spec.wood, (-x / 2, -x / 2 + 0.04), (-y / 2, y / 2), (0.22, z), radius=0.012)]
        build.body += _rails(spec, top - 0.2, 0.06 if raised else 0.12)
    feet = [(sx, sy * (y / 2 - 0.06)) for sx in (-x / 2 + 0.05, x / 2 - 0.06) for sy in (-1, 1)]
    build.body += [leg(spec.style.wood, at, at, (0, 0.1 if soft else max(0.24, top - 0.26)), 0.03, 0.05) for at in feet]
    if posts:
        build.body += _posts(spec)
    margin = 0.1 if soft else 0.045
    bedding(build, spec, (-x / 2 + margin, x / 2 - 0.02), (-y / 2 + 0.02, y / 2 - 0.02), (top - 0.2, top))
    return build


def _posts(spec: Spec) -> list[Part]:
    """Four posts with rails between their heads."""
    x, y, z = spec.size
    post = 0.06
    ends = [(sx * (x - post) / 2, sy * (y - post) / 2) for sx in (-1, 1) for sy in (-1, 1)]
    rails = (z - post, z)
    return [
        *(box(spec.wood, around(px, post), around(py, post), (0, z - post)) for px, py in ends),
        *(box(spec.wood, (-x / 2, x / 2), around(s * (y - post) / 2, post), rails) for s in (-1, 1)),
        *(box(spec.wood, around(s * (x - post) / 2, post), (post - y / 2, y / 2 - post), rails) for s in (-1, 1)),
    ]


def _rails(spec: Spec, top: float, deep: float) -> list[Part]:
    x, y, _ = spec.size
    zs = (top - deep, top + 0.02)
    sides = [box(spec.wood, (-x / 2 + 0.04, x / 2), (s * (y / 2 - 0.025), s * y / 2), zs) for s in (-1, 1)]
    inner = (-y / 2 + 0.025, y / 2 - 0.025)
    return [
        *sides,
        box(spec.wood, (x / 2 - 0.025, x / 2), inner, zs),
        box(spec.wood, (-x / 2 + 0.04, x / 2 - 0.025), inner, (top - 0.03, top)),
    ]


def bedding(build: Build, spec: Spec, x: Range, y: Range, z: Range, *, blanket: bool = True) -> None:
    """Add a mattress between z[0] and a few centimetres below z[1], a duvet up to z[1] and pillows; and the surface."""
    mattress_top = z[1] - 0.04
    cover = spec.choice((WHITE_COTTON, LINEN, WHITE_COTTON))
    build.body.append(cushion(WHITE_COTTON, x, (y[0] + 0.015, y[1] - 0.015), (z[0], mattress_top), radius=0.04))
    fold = x[0] + 0.30 * (x[1] - x[0])
    build.body.append(cushion(cover, (fold, x[1] - 0.002), y, (z[1] - 0.13, z[1]), radius=0.035))
    build.body.append(
        cushion(
            WHITE_COTTON,
            (fold - 0.04, fold + 0.16),
            (y[0] + 0.004, y[1] - 0.004),
            (z[1] - 0.05, z[1] + 0.012),
            radius=0.02,
        )
    )
    if blanket:
        throw = (x[0] + 0.72 * (x[1] - x[0]), x[0] + 0.93 * (x[1] - x[0]))
        build.body.append(
            cushion(spec.style.accent, throw, (y[0] - 0.004, y[1] + 0.004), (z[1] - 0.135, z[1] + 0.006), radius=0.03)
        )
    width = y[1] - y[0]
    count = 2 if width > 1.15 else 1
    size = min(0.62, 0.86 * width / count)
    for k in range(count):
        mid = (y[0] + y[1]) / 2 + (k - (count - 1) / 2) * width / count
        pillow = pad(
            WHITE_COTTON if k % 2 == 0 or count == 2 else cover,
            (x[0] + 0.03, x[0] + 0.42),
            around(mid, size),
            (mattress_top - 0.06, mattress_top + 0.14),
            edge=0.26,
            flat=True,
        )
        build.body.append(turned(pillow, 1, 9.0, (x[0] + 0.4, mid, mattress_top + 0.01)))
    across = (y[0] + 0.05, y[1] - 0.05)
    build.surfaces.append(
        top_surface("mattress", (fold + 0.17, throw[0] - 0.01 if blanket else x[1] - 0.06), across, z[1])
    )
    if blanket:
        build.surfaces.append(top_surface("throw", (throw[0] + 0.03, throw[1] - 0.03), across, z[1] + 0.006))


def bunk_bed(spec: Spec) -> Build:
    """Return two beds over each other, or a "loft" with the upper one alone, with a rail and a ladder on the left."""
    x, y, z = spec.size
    build, post, loft = Build(), 0.06, spec.has("loft")
    for sx in (-1, 1):
        for sy in (-1, 1):
            build.body.append(
                box(
                    spec.wood,
                    around(sx * (x / 2 - post / 2), post),
                    around(sy * (y / 2 - 0.02 - post / 2), post),
                    (0, z),
                )
            )
    inner_x, inner_y = (-x / 2 + post, x / 2 - post), (-y / 2 + 0.05, y / 2 - 0.05)
    for top in (0.8 * z,) if loft else (0.24 * z + 0.02, 0.78 * z):
        build.body += [
            box(spec.wood, inner_x, around(s * (y / 2 - 0.05), 0.025), (top - 0.2, top - 0.06)) for s in (-1, 1)
        ]
        build.body.append(
            box(
                spec.wood,
                (-x / 2 + 0.01, x / 2 - 0.01),
                (inner_y[0] + 0.015, inner_y[1] - 0.015),
                (top - 0.17, top - 0.15),
            )
        )
        bedding(
            build,
            spec,
            (inner_x[0] - 0.02, inner_x[1] + 0.02),
            (inner_y[0] + 0.02, inner_y[1] - 0.02),
            (top - 0.15, top),
            blanket=False,
        )
    build.body += [
        box(spec.wood, around(s * (x / 2 - post / 2), 0.025), (-y / 2 + 0.08, y / 2 - 0.08), (a * z, a * z + 0.09))
        for s in (-1, 1)
        for a in ((0.88, 0.94) if loft else (0.36, 0.86, 0.94))
    ]
    guard = (0.93 * z, 0.98 * z)
    build.body += [
        box(spec.wood, inner_x, around(-(y / 2 - 0.05), 0.025), guard),
        box(spec.wood, (-x / 2 + post, x / 2 - 0.5), around(y / 2 - 0.05, 0.025), guard),
    ]
    build.body += _ladder(spec, (x / 2 - 0.48, x / 2 - 0.1), y / 2, 0.93 * z)
    if loft:
        return build
    build.surfaces.reverse()
    build.surfaces[1] = top_surface(
        "lower mattress", *_area(build.surfaces[1]), build.surfaces[1].position[2], headroom=0.78 * z - 0.2 - 0.24 * z
    )
    return build


def _area(surface: Surface) -> tuple[Range, Range]:
    (px, py, _), (sx, sy) = surface.position, surface.size
    return (px - sx / 2, px + sx / 2), (py - sy / 2, py + sy / 2)


def _ladder(spec: Spec, x: Range, y: float, height: float) -> list[Part]:
    rails = [box(spec.wood, around(a, 0.03), (y - 0.03, y), (0, height)) for a in x]
    count = max(3, round(height / 0.28))
    rungs = [(0.03 + (k + 0.6) * (height - 0.1) / count) for k in range(count)]
    return rails + [
        cylinder(spec.wood, (x[0] + 0.015, x[1] - 0.015), around(y - 0.015, 0.026), around(h, 0.026), axis=0)
        for h in rungs
    ]


def crib(spec: Spec) -> Build:
    """Return a cot: barred sides around a small mattress."""
    x, y, z = spec.size
    build, post = Build(), 0.04
    paint = spec.main(spec.choice((spec.style.paint, spec.style.wood)))
    for sx in (-1, 1):
        build.body += [
            box(paint, around(sx * (x / 2 - post / 2), post), around(sy * (y / 2 - post / 2), post), (0, z))
            for sy in (-1, 1)
        ]
        build.body.append(
            box(paint, around(sx * (x / 2 - post / 2), 0.02), (-y / 2 + post, y / 2 - post), (0.24, z - 0.03))
        )
    along = (-x / 2 + post, x / 2 - post)
    bars = max(5, round(x / 0.12))
    for s in (-1, 1):
        at = s * (y / 2 - post / 2)
        build.body += [box(paint, along, around(at, 0.025), zs) for zs in ((0.22, 0.26), (z - 0.06, z - 0.02))]
        build.body += [
            disc(paint, (along[0] + (k + 1) * (along[1] - along[0]) / (bars + 1), at), 0.008, (0.26, z - 0.06))
            for k in range(bars)
        ]
    inner = (-y / 2 + 0.035, y / 2 - 0.035)
    build.body += [
        box(paint, along, inner, (0.26, 0.28)),
        cushion(WHITE_COTTON, along, (inner[0] + 0.005, inner[1] - 0.005), (0.28, 0.38), radius=0.03),
        cushion(
            spec.style.accent, (0.0, along[1] - 0.005), (inner[0] + 0.004, inner[1] - 0.004), (0.34, 0.395), radius=0.02
        ),
    ]
    build.surfaces = [
        top_surface("mattress", (along[0] + 0.05, -0.03), (inner[0] + 0.05, inner[1] - 0.05), 0.38, headroom=None),
        top_surface("cover", (0.03, along[1] - 0.05), (inner[0] + 0.05, inner[1] - 0.05), 0.395, headroom=None),
    ]
    return build


def hospital_bed(spec: Spec) -> Build:
    """Return a bed on castors with a raised back, side rails and plastic ends."""
    x, y, z = spec.size
    top, build = min(0.6, 0.62 * z), Build()
    ends = Finish((0.80, 0.76, 0.68), "plastic")
    rail = around(0, y - 0.12)
    build.body = [
        cushion(ends, (-x / 2, -x / 2 + 0.04), (-y / 2 + 0.03, y / 2 - 0.03), (0.3, z), radius=0.02),
        cushion(ends, (x / 2 - 0.04, x / 2), (-y / 2 + 0.03, y / 2 - 0.03), (0.3, 0.86 * z), radius=0.02),
        box(GREY_METAL, (-x / 2 + 0.04, x / 2 - 0.04), rail, (top - 0.2, top - 0.14)),
        box(GREY_METAL, around(-0.18 * x, 0.08), around(0, 0.5 * y), (0.16, top - 0.2)),
        box(GREY_METAL, around(0.18 * x, 0.08), around(0, 0.5 * y), (0.16, top - 0.2)),
        box(GREY_METAL, around(0, 0.84 * x), around(0, 0.5 * y), (0.11, 0.16)),
    ]
    for sx in (-1, 1):
        build.body.append(box(GREY_METAL, around(sx * 0.4 * x, 0.06), around(0, 0.8 * y), (0.11, 0.15)))
        build.body += [
            cylinder(WHITE_PLASTIC, around(sx * 0.4 * x, 0.11), around(sy * 0.37 * y, 0.04), (0, 0.11), axis=1)
            for sy in (-1, 1)
        ]
    joint = -0.08 * x
    build.body.append(
        cushion(
            WHITE_COTTON, (joint, x / 2 - 0.05), (-y / 2 + 0.08, y / 2 - 0.08), (top - 0.14, top - 0.02), radius=0.03
        )
    )
    back = cushion(
        WHITE_COTTON, (-x / 2 + 0.1, joint), (-y / 2 + 0.08, y / 2 - 0.08), (top - 0.14, top - 0.02), radius=0.03
    )
    build.body.append(turned(back, 1, 14.0, (joint, 0.0, top - 0.14)))
    pillow = pad(
        WHITE_COTTON, (-x / 2 + 0.13, -x / 2 + 0.48), around(0, 0.55), (top - 0.04, top + 0.1), edge=0.3, flat=True
    )
    build.body.append(turned(pillow, 1, 14.0, (joint, 0.0, top - 0.14)))
    blanket = spec.main(Finish((0.55, 0.68, 0.70), "fabric"))
    build.body.append(
        cushion(blanket, (0.02 * x, x / 2 - 0.045), (-y / 2 + 0.065, y / 2 - 0.065), (top - 0.12, top), radius=0.025)
    )
    for s in (-1, 1):
        at = s * (y / 2 - 0.015)
        build.body += [
            cylinder(GREY_METAL, (-0.12 * x, 0.28 * x), around(at, 0.025), around(h, 0.025), axis=0)
            for h in (top + 0.06, top + 0.2)
        ]
        build.body += [
            box(GREY_METAL, around(a * x, 0.022), around(at, 0.03), (top - 0.2, top + 0.22))
            for a in (-0.12, 0.08, 0.28)
        ]
        build.body.append(
            box(GREY_METAL, (-0.12 * x, 0.28 * x), (s * (y / 2 - 0.07), s * (y / 2 - 0.03)), (top - 0.2, top - 0.17))
        )
    build.surfaces = [top_surface("mattress", (0.06 * x, x / 2 - 0.1), (-y / 2 + 0.12, y / 2 - 0.12), top)]
    return build
