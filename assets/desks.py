"""Desks: a top with knee room, a set of drawers or none, and their relatives for schools, shops and dressing."""

from thinkblox.assets.carcasses import Cell, cabinet_parts
from thinkblox.assets.palette import BLACK_PLASTIC, GREY_METAL, IRON, MIRROR, WHITE_PAINT
from thinkblox.assets.part import Build, Finish, Part, Range, half_turned
from thinkblox.assets.shapes import around, box, leg, panel, rod, top_surface
from thinkblox.assets.spec import Spec


def desk(spec: Spec) -> Build:
    """Return a desk: drawers on its right for a broad one, else four legs and a shallow drawer box."""
    if spec.has("l-shaped", "corner"):
        return corner_desk(spec)
    if spec.has("height-adjustable"):
        return height_adjustable_desk(spec)
    x, y, z = spec.size
    build = _topped(spec, spec.wood)
    if y >= 1.15 and not spec.has("simple", "small", "open"):
        _drawers(build, spec, (-y / 2 + 0.02, -y / 2 + 0.4), z - 0.028)
        build.body += _legs(spec, spec.wood if spec.rng.random() < 0.5 else spec.style.metal, (1,))
    else:
        build.body += _legs(spec, spec.wood, (1, -1))
    rails = (-y / 2 + 0.4 if build.moving else -y / 2 + 0.09, y / 2 - 0.09)
    build.body.append(box(spec.wood, (-x / 2 + 0.05, -x / 2 + 0.07), rails, (z - 0.088, z - 0.028)))
    return build


def height_adjustable_desk(spec: Spec) -> Build:
    """Return a desk on two columns that are drawn out of each other, on feet, with a switch under its edge."""
    x, y, z = spec.size
    build, metal = _topped(spec, spec.wood), spec.style.metal
    foot, middle = 0.03, 0.5 * z
    for side in (-1, 1):
        at = side * (y / 2 - 0.18)
        build.body += [
            box(metal, (-x / 2 + 0.04, x / 2 - 0.04), around(at, 0.07), (0, foot)),
            box(metal, around(0, 0.08), around(at, 0.06), (foot, middle)),
            box(metal, around(0, 0.06), around(at, 0.045), (middle, z - 0.06)),
            box(metal, (-x / 2 + 0.08, x / 2 - 0.08), around(at, 0.05), (z - 0.06, z - 0.028)),
        ]
    beam = (-y / 2 + 0.155, y / 2 - 0.155)
    build.body.append(box(metal, around(0, 0.05), beam, (z - 0.058, z - 0.03)))
    switch = (-y / 2 + 0.12, -y / 2 + 0.24)
    build.body.append(box(BLACK_PLASTIC, (x / 2 - 0.06, x / 2 - 0.01), switch, (z - 0.046, z - 0.028)))
    return build


def _topped(spec: Spec, finish: Finish, thickness: float = 0.028) -> Build:
    x, y, z = spec.size
    area = ((-x / 2, x / 2), (-y / 2, y / 2))
    return Build(body=[box(finish, *area, (z - thickness, z))], surfaces=[top_surface("top", *area, z)])


def _legs(spec: Spec, finish: Finish, sides: tuple[int, ...]) -> list[Part]:
    x, y, z = spec.size
    ends = [(sx * (x / 2 - 0.06), side * (y / 2 - 0.05)) for side in sides for sx in (-1, 1)]
    return [leg(finish, at, at, (0, z - 0.028), 0.03, 0.048) for at in ends]


def _drawers(build: Build, spec: Spec, y: Range, height: float) -> None:
    x = spec.size[0]
    parts = cabinet_parts(
        spec,
        (-x / 2 + 0.03, x / 2 - 0.02),
        y,
        (0, height),
        [[Cell("drawer", 1.6), Cell("drawer"), Cell("drawer")]],
        plinth=0.04,
        finish=spec.wood,
    )
    build.body += parts.body
    build.moving += parts.moving


def corner_desk(spec: Spec) -> Build:
    """Return an L of two tops along the back and the right side ("left" for the other); the user sits in the angle."""
    x, y, z = spec.size
    side = 1 if spec.has("left") else -1
    depth_main, depth_wing = min(0.7, 0.55 * x), min(0.6, 0.5 * y)
    inner_y = side * (y / 2 - depth_wing)
    back = ((-x / 2, -x / 2 + depth_main), (-y / 2, y / 2))
    wing = ((-x / 2 + depth_main, x / 2), (min(inner_y, side * y / 2), max(inner_y, side * y / 2)))
    build = Build()
    for name, area in (("top", back), ("wing", wing)):
        build.body.append(box(spec.wood, *area, (z - 0.028, z)))
        build.surfaces.append(top_surface(name, *area, z))
    metal = spec.style.metal if spec.rng.random() < 0.6 else spec.wood
    feet = [(-x / 2 + 0.05, s * (y / 2 - 0.05)) for s in (-1, 1)] + [(x / 2 - 0.05, side * (y / 2 - 0.05))]
    feet += [(-x / 2 + depth_main - 0.05, -side * (y / 2 - 0.05)), (x / 2 - 0.05, inner_y + side * 0.05)]
    build.body += [leg(metal, at, at, (0, z - 0.028), 0.035, 0.045) for at in feet]
    build.body.append(
        box(spec.wood, (-x / 2 + 0.05, -x / 2 + 0.068), (-y / 2 + 0.08, y / 2 - 0.08), (z - 0.2, z - 0.028))
    )
    return build


def school_desk(spec: Spec) -> Build:
    """Return a pupil's desk: a light top on two steel frames and a tray under it."""
    x, y, z = spec.size
    build, metal = _topped(spec, spec.main(spec.style.wood), 0.022), GREY_METAL
    for side in (-1, 1):
        at = side * (y / 2 - 0.05)
        build.body += [
            box(metal, around(-0.1 * x, 0.035), around(at, 0.03), (0.03, z - 0.022)),
            box(metal, (-x / 2 + 0.03, x / 2 - 0.05), around(at, 0.032), (0, 0.03)),
        ]
    tray = ((-x / 2 + 0.04, -0.02), (-y / 2 + 0.066, y / 2 - 0.066))
    build.body.append(box(metal, *tray, (z - 0.11, z - 0.1)))
    build.surfaces.append(top_surface("tray", *tray, z - 0.1, headroom=0.078))
    return build


def teacher_desk(spec: Spec) -> Build:
    """Return a desk with drawers on its right and a panel that hides the knees; four legs when "open"."""
    x, y, z = spec.size
    build = _topped(spec, spec.wood)
    if spec.has("open"):
        build.body += _legs(spec, spec.wood, (1, -1))
        return build
    _drawers(build, spec, (-y / 2 + 0.02, -y / 2 + 0.42), z - 0.028)
    build.body.append(box(spec.wood, (-x / 2 + 0.03, x / 2 - 0.04), (y / 2 - 0.045, y / 2 - 0.02), (0, z - 0.028)))
    build.body.append(box(spec.wood, (-x / 2 + 0.05, -x / 2 + 0.07), (-y / 2 + 0.42, y / 2 - 0.045), (0.25, z - 0.028)))
    return build


def executive_desk(spec: Spec) -> Build:
    """Return a desk whose panelled front is turned to visitors; who works there sits behind it, on the -x side."""
    return half_turned(teacher_desk(spec))


def dressing_table(spec: Spec) -> Build:
    """Return a table with two shallow drawers and a mirror at its back; without the mirror when "bare"."""
    x, y, z = spec.size
    bare = spec.has("bare")
    top = z if bare else min(0.76, 0.56 * z)
    area = ((-x / 2, x / 2), (-y / 2, y / 2))
    build = Build(surfaces=[top_surface("top", (-x / 2 + 0.045, x / 2), (-y / 2, y / 2), top)])
    build.body.append(box(spec.wood, *area, (top - 0.022, top)))
    row = [[Cell("drawer")], [Cell("drawer")]]
    parts = cabinet_parts(
        spec,
        (-x / 2 + 0.02, x / 2 - 0.005),
        (-y / 2 + 0.02, y / 2 - 0.02),
        (top - 0.125, top - 0.022),
        row,
        finish=spec.wood,
    )
    build.body += parts.body
    build.moving += parts.moving
    feet = [(sx * (x / 2 - 0.065), sy * (y / 2 - 0.05)) for sx in (-1, 1) for sy in (-1, 1)]
    build.body += [leg(spec.wood, at, at, (0, top - 0.125), 0.024, 0.04) for at in feet]
    if not bare:
        build.body += panel(spec.wood, (-x / 2, -x / 2 + 0.025), around(0, min(0.7, 0.7 * y)), (top, z), 0.03, MIRROR)
    return build


def reception_desk(spec: Spec) -> Build:
    """Return a desk whose high front hides the work top from the visitor, who stands on the +x side."""
    x, y, z = spec.size
    work = min(0.74, 0.68 * z)
    front, shelf = spec.main(spec.style.paint), spec.style.wood
    build = Build()
    build.body = [
        box(front, (x / 2 - 0.12, x / 2 - 0.06), (-y / 2 + 0.02, y / 2 - 0.02), (0.08, z - 0.035)),
        box(IRON, (x / 2 - 0.12, x / 2 - 0.08), (-y / 2 + 0.04, y / 2 - 0.04), (0, 0.08)),
        box(shelf, (x / 2 - 0.32, x / 2), (-y / 2, y / 2), (z - 0.035, z)),
        box(shelf, (-x / 2, x / 2 - 0.12), (-y / 2 + 0.05, y / 2 - 0.05), (work - 0.03, work)),
    ]
    build.body += [
        box(front, (-x / 2 + 0.02, x / 2 - 0.12), (s * (y / 2 - 0.05), s * (y / 2 - 0.02)), (0, z - 0.035))
        for s in (-1, 1)
    ]
    strips = int((y - 0.2) / 0.12)
    build.body += [
        box(shelf, (x / 2 - 0.06, x / 2 - 0.045), around((k - (strips - 1) / 2) * 0.12, 0.05), (0.1, z - 0.06))
        for k in range(strips)
    ]
    build.surfaces = [
        top_surface("counter", (x / 2 - 0.32, x / 2), (-y / 2, y / 2), z),
        top_surface("work top", (-x / 2, x / 2 - 0.32), (-y / 2 + 0.05, y / 2 - 0.05), work),
    ]
    return build


def easel(spec: Spec) -> Build:
    """Return a painter's tripod that holds a canvas; a "bare" one has a ledge for whatever is put on it."""
    x, y, z = spec.size
    canvas = box(WHITE_PAINT, (x / 2 - 0.2, x / 2 - 0.18), around(0, 0.8 * y), (0.45 * z, 0.9 * z))
    top = (-0.02, 0.0, z - 0.02)
    legs = [
        rod(spec.wood, (x / 2 - 0.02, s * (y / 2 - 0.02), 0.01), (x / 2 - 0.24, s * 0.06, z), 0.016) for s in (-1, 1)
    ]
    back = rod(spec.wood, (-x / 2 + 0.02, 0, 0.01), (x / 2 - 0.26, 0, z - 0.05), 0.016)
    head = box(spec.wood, around(x / 2 - 0.25, 0.05), around(top[1], 0.16), (z - 0.12, z - 0.06))
    if spec.has("bare"):
        shelf = ((x / 2 - 0.1, x / 2), around(0, 0.95 * y))
        board = box(spec.wood, (x / 2 - 0.2, x / 2), shelf[1], (0.45 * z - 0.03, 0.45 * z))
        return Build(body=[*legs, back, board, head], surfaces=[top_surface("ledge", *shelf, 0.45 * z)])
    ledge = box(spec.wood, (x / 2 - 0.22, x / 2 - 0.13), around(0, 0.85 * y), (0.45 * z - 0.03, 0.45 * z))
    return Build(body=[canvas, *legs, back, ledge, head])
