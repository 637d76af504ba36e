"""Plain devices and panels that are known by what is on their fronts: faders, trays, panes, numbers."""

from thinkblox.assets.palette import BLACK_PLASTIC, BRIGHT, CHROME, GREY_PLASTIC, IRON, PAPER, SCREEN
from thinkblox.assets.part import Build, Finish, Part, hull
from thinkblox.assets.shapes import around, box, cushion, disc, oval, prism, rod
from thinkblox.assets.spec import Spec

_PANES = ((0.16, 0.34, 0.66), (0.72, 0.18, 0.16), (0.90, 0.66, 0.18), (0.18, 0.48, 0.30), (0.48, 0.24, 0.54))
"""Colours of glass in lead."""


def copier(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a copier: trays of paper below, a slot for copies, a scanner with its lid and a panel with a screen."""
    x, y, z = spec.size
    finish, face = spec.main(main), 0.44 * x
    body: list[Part] = [
        box(BLACK_PLASTIC, around(0, 0.84 * x), around(0, 0.9 * y), (0, 0.04 * z)),
        box(finish, (-x / 2, face), (-y / 2, y / 2), (0.03 * z, 0.58 * z)),
        box(accent, (-x / 2, -0.1 * x), around(0, 0.96 * y), (0.58 * z, 0.72 * z)),
        box(finish, (-x / 2, face), (0.34 * y, y / 2), (0.58 * z, 0.72 * z)),
        box(BLACK_PLASTIC, (-0.1 * x, face - 0.02), (-0.46 * y, 0.34 * y), (0.58 * z, 0.585 * z), collide=False),
        cushion(finish, (-x / 2, face), (-y / 2, y / 2), (0.72 * z, 0.86 * z), radius=0.02),
        cushion(accent, (-x / 2, 0.38 * x), around(0, 0.96 * y), (0.865 * z, 0.93 * z), radius=0.015),
        cushion(finish, (-0.46 * x, 0.1 * x), (-0.46 * y, 0.1 * y), (0.92 * z, z), radius=0.02),
    ]
    panel = [(face, 0.76 * z), (x / 2, 0.78 * z), (face, 0.88 * z), (face - 0.04, 0.88 * z)]
    body.append(prism(accent, panel, around(0.1 * y, 0.7 * y), axis=1))
    glass = [(face + 0.004, 0.874 * z), (x / 2 - 0.006, 0.795 * z), (x / 2, 0.795 * z), (face + 0.012, 0.876 * z)]
    body.append(hull(SCREEN, [(a, b, c) for a, c in glass for b in (-0.06 * y, 0.24 * y)], collide=False))
    for k in range(3):
        low = (0.06 + 0.17 * k) * z
        body.append(box(finish, (face, face + 0.02), around(0, 0.94 * y), (low, low + 0.155 * z)))
        body.append(box(accent, (face + 0.02, face + 0.028), around(0, 0.3 * y), around(low + 0.11 * z, 0.02 * z)))
    return Build(body=body)


def console(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a mixing desk: a slope with a fader and knobs for each channel, and meters along its back."""
    x, y, z = spec.size
    low, high = 0.5 * z, 0.86 * z
    slope = [(x / 2, 0.0), (x / 2, low), (-0.3 * x, high), (-x / 2, z), (-x / 2, 0.0)]
    body: list[Part] = [
        prism(spec.main(main), slope, around(0, 0.96 * y), axis=1),
        *(box(accent, (-x / 2, x / 2), (s * y / 2, s * 0.47 * y), (0, 0.9 * low)) for s in (-1, 1)),
    ]
    count = max(4, min(12, round(y / 0.07)))
    for k in range(count):
        at = ((k + 0.5) / count - 0.5) * 0.9 * y

        def height(depth: float) -> float:
            return low + (high - low) * (0.5 * x - depth) / (0.8 * x)

        slot = [(d, at + s * 0.004, height(d) + 0.001) for d in (0.06 * x, 0.42 * x) for s in (-1, 1)]
        body.append(hull(GREY_PLASTIC, [(a, b, c + t) for a, b, c in slot for t in (-0.004, 0.001)], collide=False))
        fader = (0.14 + 0.05 * (k * 7 % 5)) * x
        knob = height(fader)
        cap = (around(fader, 0.05 * x), around(at, 0.4 * y / count), (knob - 0.004, knob + 0.014))
        body.append(box(PAPER if k < count - 2 else _red(), *cap))
        for row, colour in enumerate(BRIGHT[1:4]):
            depth = (-0.04 - 0.09 * row) * x
            level = height(depth)
            round_ = min(0.014, 0.28 * y / count)
            body.append(disc(Finish(colour, "plastic"), (depth, at), round_, (level - 0.006, level + 0.012)))
    meters = [
        (a, c) for a, c in ((-0.32 * x, high + 0.012), (-0.47 * x, z - 0.006), (-0.47 * x, z), (-0.32 * x, high + 0.02))
    ]
    body.append(hull(SCREEN, [(a, b, c) for a, c in meters for b in (-0.3 * y, 0.3 * y)], collide=False))
    return Build(body=body)


def _red() -> Finish:
    return Finish(BRIGHT[0], "plastic")


def power_tower(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a tower on four feet with slots for air, a display, a button and lamps on its front."""
    x, y, z = spec.size
    face = 0.47 * x
    body: list[Part] = [
        *(
            box(IRON, around(s * 0.36 * x, 0.14 * x), around(t * 0.36 * y, 0.2 * y), (0, 0.04 * z))
            for s in (-1, 1)
            for t in (-1, 1)
        ),
        box(spec.main(main), (-x / 2, face), (-y / 2, y / 2), (0.03 * z, z)),
        box(accent, (face, x / 2), around(0, 0.9 * y), (0.62 * z, 0.97 * z)),
        box(SCREEN, (x / 2 - 0.001, x / 2), around(0, 0.6 * y), (0.78 * z, 0.9 * z), collide=False),
        box(
            Finish((0.35, 0.85, 0.55), "light"),
            (x / 2 - 0.001, x / 2),
            around(0, 0.12 * y),
            around(0.69 * z, 0.03 * z),
            collide=False,
        ),
    ]
    body += [
        box(accent, (face, face + 0.006), around(0, 0.8 * y), around((0.1 + 0.07 * k) * z, 0.03 * z), collide=False)
        for k in range(7)
    ]
    return Build(body=body)


def leaded(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a window of coloured panes in lead, with a rose of the accent in its upper part."""
    x, y, z = spec.size
    bar, lead = 0.07 * min(y, z), 0.012
    finish = spec.main(main)
    inner_y, inner_z = y - 2 * bar, z - 2 * bar
    body: list[Part] = [
        *(box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - bar)), (0, z)) for s in (-1, 1)),
        *(box(finish, (-x / 2, x / 2), around(0, inner_y), level) for level in ((0, bar), (z - bar, z))),
        box(finish, (-0.3 * x, -0.1 * x), around(0, inner_y), (bar, z - bar)),
    ]
    columns, rows = 3, max(3, round(3 * inner_z / inner_y))
    wide, tall = inner_y / columns, inner_z / rows
    for row in range(rows):
        for column in range(columns):
            colour = _PANES[(2 * row + 3 * column + row * column) % len(_PANES)]
            at = around((column - 1) * wide, wide - lead)
            up = around(bar + (row + 0.5) * tall, tall - lead)
            body.append(box(Finish(colour, "ceramic"), (-0.1 * x, 0.1 * x), at, up, collide=False))
    rose, radius = bar + 0.68 * inner_z, 0.34 * min(inner_y, inner_z)
    for share, tone, front in ((1.0, finish, 0.16), (0.9, Finish(_PANES[2], "ceramic"), 0.2), (0.42, accent, 0.24)):
        wheel = [(a, b + rose) for a, b in oval(2 * share * radius, 2 * share * radius, sides=20)]
        body.append(prism(tone, wheel, (-0.1 * x, front * x), axis=0, smooth=True))
    return Build(body=body)


def number_board(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a framed board with rows of cards, each with a number on it."""
    x, y, z = spec.size
    bar, face = 0.08 * y, 0.1 * x
    finish = spec.main(main)
    body: list[Part] = [
        *(box(finish, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - bar)), (0, z)) for s in (-1, 1)),
        *(box(finish, (-x / 2, x / 2), around(0, y - 2 * bar), level) for level in ((0, bar), (z - bar, z))),
        box(accent, (-x / 2, face), around(0, y - 2 * bar), (bar, z - bar)),
    ]
    rows, pitch = 4, (z - 3 * bar) / 4
    for row in range(rows):
        level = 1.5 * bar + (row + 0.5) * pitch
        body.append(
            box(finish, (face, face + 0.3 * x), around(0, 0.78 * y), around(level - 0.45 * pitch, 0.06 * pitch))
        )
        for column in range(3):
            at = (column - 1) * 0.23 * y
            body.append(
                box(PAPER, (face, face + 0.1 * x), around(at, 0.19 * y), around(level, 0.78 * pitch), collide=False)
            )
            strokes = _strokes(2 * row + column + row * column, at, level, 0.09 * y, 0.5 * pitch)
            body += [box(BLACK_PLASTIC, (face, face + 0.14 * x), *stroke, collide=False) for stroke in strokes]
    return Build(body=body)


def _strokes(
    number: int, at: float, level: float, wide: float, tall: float
) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """The strokes of a figure as on a calculator, few of them: 1, 7 or 4."""
    thick = 0.22 * wide
    right = (around(at + wide / 2, thick), around(level, tall))
    if number % 3 == 0:
        return [(around(at, thick), around(level, tall))]
    if number % 3 == 1:
        return [right, (around(at, wide), around(level + tall / 2, thick))]
    left = (around(at - wide / 2, thick), around(level + tall / 4, tall / 2))
    return [right, left, (around(at, wide), around(level, thick))]


def visor_helmet(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a helmet that covers the face, with a dark window in a frame, and a band round the head behind it."""
    x, y, z = spec.size
    finish = spec.main(main)
    rings = ((0.0, 0.5, 0.62), (0.16 * z, 0.62, 0.86), (0.5 * z, 0.7, 1.0), (0.78 * z, 0.62, 0.94), (z, 0.34, 0.5))
    face = [
        (0.5 * x - deep * x / 2 + a, b, height)
        for height, deep, wide in rings
        for a, b in oval(deep * x, wide * y, sides=20, squareness=3.0)
        if a > -0.12 * x
    ]
    window = (around(0, 0.62 * y), (0.46 * z, 0.72 * z))
    band = [(a - 0.18 * x, b) for a, b in oval(0.64 * x, 0.84 * y, sides=20)]
    return Build(
        body=[
            hull(finish, face, smooth=True),
            box(BLACK_PLASTIC, (0.36 * x, 0.492 * x), *window),
            box(accent, (0.4 * x, x / 2), around(0, 0.5 * y), (0.51 * z, 0.67 * z)),
            prism(IRON, band, (0.5 * z, 0.6 * z), smooth=True),
            prism(IRON, [(0.8 * a, 0.8 * b) for a, b in band], (0.0, 0.5 * z), smooth=True),
        ]
    )


def bars(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return bars of sound, each shorter than the last, in bright colours on two rails, with two mallets on them."""
    x, y, z = spec.size
    finish, count = spec.main(main), 8
    body: list[Part] = [
        *(_rail(finish, s, (x, y, z)) for s in (-1, 1)),
        *(
            box(finish, around(0, share * x), (t * y / 2, t * (y / 2 - 0.03 * y)), (0, 0.6 * z))
            for t, share in ((-1, 0.9), (1, 0.5))
        ),
    ]
    colours = (*BRIGHT, (0.48, 0.36, 0.62))
    for k in range(count):
        at = ((k + 0.5) / count - 0.5) * 0.92 * y
        tone = Finish(colours[k % len(colours)], "plastic")
        body.append(
            cushion(
                tone, around(0, (1.0 - 0.055 * k) * x), around(at, 0.76 * y / count), (0.6 * z, 0.82 * z), radius=0.006
            )
        )
    for s in (-1, 1):
        stick = (0.1 * s * x, -0.3 * y, 0.88 * z), (0.16 * s * x, 0.1 * y, 0.9 * z)
        body.append(rod(CHROME if accent == finish else accent, *stick, 0.05 * z))
        body.append(disc(accent, stick[1][:2], min(0.16 * z, 0.02), (0.82 * z, z)))
    return Build(body=body)


def _rail(finish: Finish, side: int, size: tuple[float, float, float]) -> Part:
    x, y, z = size
    ends = [(side * 0.38 * x, -y / 2), (side * 0.28 * x, -y / 2), (side * 0.12 * x, y / 2), (side * 0.22 * x, y / 2)]
    return prism(finish, ends, (0, 0.6 * z))


def sealed_sack(spec: Spec, main: Finish, accent: Finish) -> Build:
    """Return a filled sack that stands, sewn shut along its top, with a label of the accent on its front."""
    x, y, z = spec.size
    rings = ((0.0, 0.8, 0.9), (0.08 * z, 0.96, 0.98), (0.35 * z, 1.0, 1.0), (0.7 * z, 0.86, 0.97), (0.9 * z, 0.3, 0.95))
    bulge = [
        (a, b, height) for height, deep, wide in rings for a, b in oval(deep * x, wide * y, sides=20, squareness=5.0)
    ]
    face = 0.5 * x
    label = [
        (depth * face, s * 0.34 * y, height)
        for height, depths in ((0.22 * z, (0.9, 0.994)), (0.35 * z, (0.9, 1.0)), (0.62 * z, (0.85, 0.925)))
        for depth in depths
        for s in (-1, 1)
    ]
    return Build(
        body=[
            hull(spec.main(main), bulge, smooth=True),
            box(PAPER, around(0, 0.08 * x), around(0, 0.95 * y), (0.88 * z, z)),
            hull(accent, label, collide=False),
        ]
    )
