"""Kitchen and laundry machines: insulated boxes whose doors open, and what stands on a worktop."""

from thinkblox.assets.carcasses import door, face_of, flap
from thinkblox.assets.palette import (
    BLACK_GLASS,
    BLACK_PLASTIC,
    CHROME,
    DARK_PLASTIC,
    GLASS,
    GLOW,
    GREY_METAL,
    IRON,
    STEEL,
    WATER,
    WHITE_METAL,
    WHITE_PLASTIC,
)
from thinkblox.assets.part import Build, Finish, MovingParts, Part, Range
from thinkblox.assets.shapes import around, box, cushion, cylinder, disc, frustum, inner_surface, top_surface
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Joint

WALL = 0.035


def chamber(
    finish: Finish, x: Range, y: Range, z: Range, *, wall: float = WALL, base: float = WALL, lid: float = WALL
) -> list[Part]:
    """Return a box open to +x, with thick walls."""
    inner = (y[0] + wall, y[1] - wall)
    return [
        box(finish, x, (y[0], y[0] + wall), z),
        box(finish, x, (y[1] - wall, y[1]), z),
        box(finish, x, inner, (z[0], z[0] + base)),
        box(finish, x, inner, (z[1] - lid, z[1])),
        box(finish, (x[0], x[0] + wall), inner, (z[0] + base, z[1] - lid)),
    ]


def _top(build: Build, spec: Spec, x: Range, name: str = "top") -> None:
    y = spec.size[1]
    build.surfaces.append(top_surface(name, x, (-y / 2, y / 2), spec.size[2]))


def fridge(spec: Spec) -> Build:
    """Return a fridge with a freezer below; both doors open."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((WHITE_METAL, STEEL, WHITE_METAL)))
    front = x / 2 - 0.075
    low = 0.05 if z < 1.2 else 0.34 * z
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (0.03, z)))
    build.body.append(box(DARK_PLASTIC, (-x / 2 + 0.03, front - 0.03), (-y / 2 + 0.02, y / 2 - 0.02), (0, 0.03)))
    inner = (-y / 2 + WALL, y / 2 - WALL)
    if z >= 1.2:
        build.body.append(box(finish, (-x / 2 + WALL, front), inner, around(low, 0.05)))
    shelves = []
    count = max(1, min(4, round((z - low) / 0.4)))
    for k in range(count):
        level = low + k * (z - low) / count if k else max(low + 0.025, 0.03 + WALL) if z >= 1.2 else 0.03 + WALL
        free = low + (k + 1) * (z - low) / count - level - (0.008 if k < count - 1 else WALL)
        if k:
            build.body.append(box(GLASS, (-x / 2 + WALL, front - 0.06), inner, (level - 0.008, level)))
        shelves.append(inner_surface(f"shelf {k}", (-x / 2 + WALL, front - 0.06), inner, level, headroom=free))
    spans = [("door", (low + 0.003, z - 0.003))] + ([("freezer", (0.035, low - 0.003))] if z >= 1.2 else [])
    for name, span in spans:
        build.moving.append(_thick_door(spec, name, (front + 0.003, x / 2), span, finish))
    _top(build, spec, (-x / 2, x / 2 - 0.075))
    build.surfaces += shelves
    return build


def _thick_door(spec: Spec, name: str, x: Range, z: Range, finish: Finish, handle: Finish = STEEL) -> MovingParts:
    y = spec.size[1]
    slab = (x[0], x[1] - 0.025)
    grip = (y / 2 - 0.06, y / 2 - 0.035)
    bar = (z[1] - 0.45 if name == "door" else z[1] - 0.3, z[1] - 0.1)
    bar = (max(bar[0], z[0] + 0.04), bar[1])
    parts = (
        box(finish, slab, (-y / 2 + 0.002, y / 2 - 0.002), z),
        box(handle if handle != finish else GREY_METAL, (slab[1], x[1]), grip, bar),
    )
    joint = Joint(
        kind="hinge", axis=(0.0, 0.0, -1.0), anchor=(slab[1], -y / 2 + 0.002, sum(z) / 2), lower=0.0, upper=100.0
    )
    return MovingParts(name, parts, joint)


def display_fridge(spec: Spec) -> Build:
    """Return a glass-fronted counter fridge when low, a cooler with glass doors when tall; full unless "empty"."""
    return _tall_cooler(spec) if spec.size[2] > 1.55 else _display_case(spec)


def _display_case(spec: Spec) -> Build:
    x, y, z = spec.size
    finish, base = spec.main(WHITE_METAL), 0.36 * z
    build = Build(
        body=[
            box(IRON, (-x / 2 + 0.04, x / 2 - 0.06), (-y / 2 + 0.03, y / 2 - 0.03), (0, 0.08)),
            box(finish, (-x / 2, x / 2), (-y / 2, y / 2), (0.08, base)),
            box(spec.style.wood, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.03, z)),
            box(GLOW, (x / 2 - 0.1, x / 2 - 0.06), (-y / 2 + 0.04, y / 2 - 0.04), (z - 0.045, z - 0.03)),
        ]
    )
    build.body += [
        box(GLASS, (-x / 2 + 0.02, x / 2 - 0.02), (s * (y / 2 - 0.015), s * y / 2), (base, z - 0.03)) for s in (-1, 1)
    ]
    build.body.append(box(GLASS, (x / 2 - 0.02, x / 2 - 0.008), (-y / 2, y / 2), (base, z - 0.03)))
    inner = (-y / 2 + 0.015, y / 2 - 0.015)
    shelf, bottom = base + 0.5 * (z - base), base + 0.004
    build.body.append(box(GLASS, (-x / 2 + 0.04, x / 2 - 0.16), inner, (shelf - 0.01, shelf)))
    build.body.append(box(STEEL, (-x / 2 + 0.03, x / 2 - 0.02), inner, (base, bottom)))
    _top(build, spec, (-x / 2, x / 2))
    if spec.has("empty"):
        upper, lower = (-x / 2 + 0.04, x / 2 - 0.16), (-x / 2 + 0.03, x / 2 - 0.03)
        build.surfaces += [
            inner_surface("shelf", upper, inner, shelf, headroom=z - 0.05 - shelf),
            inner_surface("floor", lower, inner, bottom, headroom=shelf - 0.01 - bottom),
        ]
        return build
    build.body += _food(spec, (-x / 2 + 0.12, x / 2 - 0.2), inner, shelf)
    build.body += _food(spec, (-x / 2 + 0.12, x / 2 - 0.1), inner, bottom)
    return build


def _food(spec: Spec, x: Range, y: Range, z: float) -> list[Part]:
    colours = ((0.86, 0.68, 0.38), (0.72, 0.30, 0.24), (0.93, 0.88, 0.74), (0.50, 0.62, 0.34), (0.80, 0.50, 0.32))
    count = max(2, int((y[1] - y[0]) / 0.26))
    width = (y[1] - y[0]) / count
    parts: list[Part] = []
    for k in range(count):
        span = (y[0] + k * width + 0.025, y[0] + (k + 1) * width - 0.025)
        parts.append(box(WHITE_PLASTIC, x, span, (z, z + 0.02)))
        fill = Finish(spec.choice(colours), "fabric")
        parts.append(
            cushion(
                fill, (x[0] + 0.02, x[1] - 0.02), (span[0] + 0.02, span[1] - 0.02), (z + 0.02, z + 0.075), radius=0.025
            )
        )
    return parts


def _tall_cooler(spec: Spec) -> Build:
    x, y, z = spec.size
    finish, front = spec.main(WHITE_METAL), x / 2 - 0.043
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (0.0, z), base=0.2, lid=0.2))
    inner = (-y / 2 + WALL, y / 2 - WALL)
    rows, shelves = 5, []
    for k in range(rows):
        level = 0.2 + k * (z - 0.4) / rows
        if k:
            build.body.append(box(STEEL, (-x / 2 + WALL, front - 0.04), inner, (level - 0.012, level)))
        depth = (-x / 2 + WALL, front - 0.04)
        if spec.has("empty"):
            free = (z - 0.4) / rows - 0.012
            shelves.append(inner_surface(f"shelf {k + 1}", depth, inner, level, headroom=free))
        else:
            build.body += _drinks(spec, front - 0.1, inner, level)
    face = face_of("door", (front + 0.002, x / 2), (-y / 2 + 0.002, y / 2 - 0.002), (0.12, z - 0.16), IRON, STEEL)
    build.moving.append(door(face, left_hung=False, glazed=True))
    build.body.append(
        box(spec.style.accent, (front, front + 0.004), (-y / 2 + 0.05, y / 2 - 0.05), (z - 0.14, z - 0.03))
    )
    _top(build, spec, (-x / 2, front))
    build.surfaces += shelves
    return build


def _drinks(spec: Spec, x: float, y: Range, z: float) -> list[Part]:
    colours = ((0.72, 0.22, 0.18), (0.28, 0.50, 0.36), (0.93, 0.62, 0.22), (0.90, 0.88, 0.80), (0.28, 0.42, 0.62))
    count = int((y[1] - y[0] - 0.04) / 0.09)
    return [
        disc(Finish(spec.choice(colours), "plastic"), (x, y[0] + 0.065 + 0.09 * k), 0.033, (z, z + 0.2))
        for k in range(count)
    ]


def vending_machine(spec: Spec) -> Build:
    """Return a snack machine behind glass."""
    x, y, z = spec.size
    finish = spec.main(spec.choice((Finish((0.62, 0.20, 0.18), "metal"), Finish((0.20, 0.32, 0.45), "metal"), IRON)))
    front = x / 2 - 0.03
    pane = (-y / 2 + 0.06, 0.2 * y)
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (0.0, z), wall=0.06, base=0.5, lid=0.1))
    build.body += [
        box(finish, (-x / 2 + 0.06, front), (pane[1], y / 2 - 0.06), (0.5, z - 0.1)),
        box(GLASS, (front, front + 0.01), (pane[0] - 0.02, pane[1] + 0.02), (0.48, z - 0.08)),
        box(BLACK_GLASS, (front, x / 2 - 0.012), (pane[1] + 0.04, y / 2 - 0.06), (1.15, 1.4)),
        box(GREY_METAL, (front, x / 2 - 0.01), (pane[1] + 0.06, y / 2 - 0.09), (0.9, 1.08)),
        box(BLACK_PLASTIC, (front, x / 2), (pane[0], pane[1]), (0.2, 0.38)),
    ]
    for k in range(5):
        level = 0.5 + k * (z - 0.6) / 5
        if k:
            build.body.append(box(GREY_METAL, (-x / 2 + 0.06, front - 0.03), pane, (level - 0.01, level)))
        build.body += _drinks(spec, front - 0.09, pane, level)
    _top(build, spec, (-x / 2, front))
    return build


def stove(spec: Spec) -> Build:
    """Return a free-standing cooker: four plates over an oven."""
    x, y, z = spec.size
    finish, front = spec.main(spec.choice((STEEL, WHITE_METAL))), x / 2 - 0.042
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (0.0, z - 0.008), base=0.1, lid=0.14))
    build.body.append(box(BLACK_GLASS, (-x / 2, front), (-y / 2, y / 2), (z - 0.008, z)))
    build.body += plates(spec, (-x / 2, front), z)
    build.body += _knobs(front, y, z - 0.075, 4)
    face = face_of(
        "oven door", (front + 0.002, x / 2), (-y / 2 + 0.004, y / 2 - 0.004), (0.1, z - 0.15), finish, GREY_METAL
    )
    build.moving.append(flap(face, window=True))
    build.body.append(
        box(STEEL, (-x / 2 + WALL, front - 0.02), (-y / 2 + WALL, y / 2 - WALL), (0.34 * z, 0.34 * z + 0.01))
    )
    _top(build, spec, (-x / 2, front), "hob")
    return build


def plates(spec: Spec, x: Range, z: float) -> list[Part]:
    """Return four cooking plates on a hob at height z: mere rings on a stove, flat discs on a thin hob."""
    y = spec.size[1]
    mid, depth = (x[0] + x[1]) / 2, x[1] - x[0]
    ring = Finish((0.22, 0.22, 0.24), "metal")
    spots = [
        (mid + a * 0.23 * depth, b * 0.23 * y, r)
        for a, b, r in ((1, 1, 0.07), (1, -1, 0.09), (-1, 1, 0.09), (-1, -1, 0.07))
    ]
    return (
        [disc(ring, (px, py), min(r, 0.2 * depth, 0.2 * y), (z - 0.008, z), collide=False) for px, py, r in spots]
        if z > 0.5
        else [disc(ring, (px, py), min(r, 0.2 * depth, 0.2 * y), (z - 0.002, z)) for px, py, r in spots]
    )


def _knobs(front: float, y: float, z: float, count: int) -> list[Part]:
    return [
        cylinder(
            DARK_PLASTIC,
            (front, front + 0.025),
            around((k - (count - 1) / 2) * 0.7 * y / count, 0.04),
            around(z, 0.04),
            axis=0,
        )
        for k in range(count)
    ]


def oven(spec: Spec) -> Build:
    """Return a built-in oven; where it is as high as a worktop, in a unit with a drawer's front under it and a top."""
    x, y, z = spec.size
    finish, front = spec.main(STEEL), x / 2 - 0.042
    low, high = (z - _UNIT_TOP - _BUILT_IN, z - _UNIT_TOP) if z >= _UNIT else (0.0, z)
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (low, high), lid=0.12))
    build.body += _knobs(front, y, high - 0.06, 2)
    face = face_of(
        "door", (front + 0.002, x / 2), (-y / 2 + 0.004, y / 2 - 0.004), (low + 0.02, high - 0.125), finish, GREY_METAL
    )
    build.moving.append(flap(face, window=True))
    if low:
        plinth, case = min(0.1, 0.5 * low), spec.style.paint
        build.body += [
            box(DARK_PLASTIC, (-x / 2, front - 0.05), (-y / 2, y / 2), (0, plinth)),
            box(case, (-x / 2, front), (-y / 2, y / 2), (plinth, low)),
            box(case, (front, front + 0.018), around(0, y - 0.006), (plinth + 0.002, low - 0.002)),
            box(
                spec.style.metal, (front + 0.018, x / 2 - 0.004), around(0, 0.3 * y), around((plinth + low) / 2, 0.014)
            ),
            box(spec.style.worktop, (-x / 2, x / 2), (-y / 2, y / 2), (high, z)),
        ]
    _top(build, spec, (-x / 2, front))
    return build


_BUILT_IN, _UNIT_TOP, _UNIT = 0.6, 0.034, 0.74
"""Heights of a built-in oven, of the worktop over it, and of a unit that has one [m]."""


def dishwasher(spec: Spec) -> Build:
    """Return a dishwasher whose front folds down; where it is as high as a worktop, with one on top."""
    x, y, high = spec.size
    finish, front = spec.main(spec.choice((WHITE_METAL, STEEL))), x / 2 - 0.046
    built_in = high >= _UNIT
    z = high - _UNIT_TOP if built_in else high
    build = Build(body=chamber(finish, (-x / 2, front), (-y / 2, y / 2), (0.0, z), base=0.1))
    if built_in:
        build.body.append(box(spec.style.worktop, (-x / 2, x / 2), (-y / 2, y / 2), (z, high)))
    edge = z - 0.004 if built_in else z - 0.035
    face = face_of(
        "door", (front + 0.002, x / 2 - 0.004), (-y / 2 + 0.002, y / 2 - 0.002), (0.09, edge), finish, GREY_METAL
    )
    build.moving.append(flap(face))
    _top(build, spec, (-x / 2, x / 2 if built_in else front))
    rack, inner = (-x / 2 + WALL, front - 0.03), (-y / 2 + WALL, y / 2 - WALL)
    for level, above in ((0.2, 0.5 * z), (0.5 * z, z - WALL)):
        build.body.append(box(STEEL, rack, inner, (level, level + 0.012)))
        free = above - level - 0.012
        build.surfaces.append(inner_surface(f"rack at {level:.2f}", rack, inner, level + 0.012, headroom=free))
    return build


def washing_machine(spec: Spec) -> Build:
    """Return a front loader with a round door that opens; a dryer looks alike, with a clear door."""
    x, y, z = spec.size
    finish, front = spec.main(WHITE_METAL), x / 2 - 0.045
    mid, radius = 0.5 * z, min(0.19, 0.33 * y)
    hole = (mid - 0.62 * radius, mid + 0.62 * radius)
    side = 0.62 * radius
    build = Build(
        body=[
            box(finish, (-x / 2, front), (-y / 2, -side), (0.02, z)),
            box(finish, (-x / 2, front), (side, y / 2), (0.02, z)),
            box(finish, (-x / 2, front), (-side, side), (0.02, hole[0])),
            box(finish, (-x / 2, front), (-side, side), (hole[1], z)),
            box(GREY_METAL, (-x / 2, -x / 2 + 0.1), (-side, side), hole),
            box(DARK_PLASTIC, (-x / 2 + 0.03, front - 0.03), (-y / 2 + 0.03, y / 2 - 0.03), (0, 0.02)),
            box(GREY_METAL, (front, front + 0.006), (-y / 2 + 0.01, y / 2 - 0.01), (z - 0.14, z - 0.02)),
            cylinder(CHROME, (front + 0.006, front + 0.028), around(0, 0.06), around(z - 0.08, 0.06), axis=0),
            box(BLACK_GLASS, (front + 0.006, front + 0.008), (-0.4 * y, -0.18 * y), (z - 0.1, z - 0.06), collide=False),
        ]
    )
    glass = GLASS if spec.category == "dryer" else Finish((0.20, 0.22, 0.25), "screen")
    ring = (front + 0.002, x / 2 - 0.012)
    parts = (
        cylinder(
            CHROME if spec.category == "washing_machine" else WHITE_PLASTIC,
            ring,
            around(0, 2 * radius),
            around(mid, 2 * radius),
            axis=0,
        ),
        cylinder(glass, (ring[1], x / 2), around(0, 1.4 * radius), around(mid, 1.4 * radius), axis=0),
        box(GREY_METAL, (ring[1], x / 2 - 0.002), (-0.97 * radius, -0.78 * radius), around(mid, 0.07)),
    )
    joint = Joint(kind="hinge", axis=(0.0, 0.0, 1.0), anchor=(x / 2, radius, mid), lower=0.0, upper=100.0)
    build.moving = [MovingParts("door", parts, joint)]
    _top(build, spec, (-x / 2, front))
    return build


def water_dispenser(spec: Spec) -> Build:
    """Return a cooler with a bottle on top."""
    x, y, z = spec.size
    finish, top = spec.main(WHITE_PLASTIC), 0.7 * z
    radius = 0.42 * min(x, y)
    body = [
        cushion(finish, (-x / 2, x / 2 - 0.03), (-y / 2, y / 2), (0, top), radius=0.02),
        box(DARK_PLASTIC, (x / 2 - 0.03, x / 2), around(0, 0.7 * y), (0.52 * z, 0.53 * z)),
        disc(finish, (-0.015, 0), 0.6 * radius, (top, top + 0.03)),
        frustum(WATER, (-0.015, 0), (top + 0.03, top + 0.08), 0.35 * radius, radius),
        disc(WATER, (-0.015, 0), radius, (top + 0.08, z)),
    ]
    for side, colour in ((-1, (0.25, 0.45, 0.75)), (1, (0.78, 0.25, 0.2))):
        body.append(
            box(
                Finish(colour, "plastic"),
                (x / 2 - 0.03, x / 2 - 0.005),
                around(side * 0.2 * y, 0.03),
                (0.62 * z, 0.65 * z),
            )
        )
    return Build(body=body)
