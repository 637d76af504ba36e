"""Flat things for walls: their back is at -x and is fixed to the wall. Also screens that stand."""

from dataclasses import replace
from math import cos, pi, sin

from thinkblox.assets.palette import (
    BLACK_PLASTIC,
    BRASS,
    IRON,
    MIRROR,
    PAPER,
    SLATE,
    STEEL,
    WHITE_METAL,
    WHITE_PAINT,
)
from thinkblox.assets.part import Build, Finish, Part
from thinkblox.assets.shapes import around, box, cylinder, oval, panel, prism, rod
from thinkblox.assets.spec import Spec


def _sheet(spec: Spec, frame: Finish, sheet: Finish, bar: float) -> list[Part]:
    x, y, z = spec.size
    return panel(frame, (-x / 2, x / 2), (-y / 2, y / 2), (0, z), min(bar, 0.2 * min(y, z)), sheet)


def whiteboard(spec: Spec) -> Build:
    """Return a whiteboard with a tray for pens; a blackboard is dark in a wooden frame."""
    x, y, z = spec.size
    dark = spec.category == "blackboard"
    frame = spec.style.wood if dark else STEEL
    face = spec.main(SLATE if dark else Finish((0.97, 0.97, 0.97), "plastic"))
    back = (-x / 2, -x / 2 + 0.025)
    body = panel(frame, back, (-y / 2, y / 2), (0.03, z), 0.025, face)
    body.append(box(frame, (-x / 2, x / 2), around(0, 0.5 * y), (0, 0.02)))
    for k, colour in enumerate(((0.2, 0.3, 0.6), (0.7, 0.2, 0.2), (0.15, 0.15, 0.15))):
        at = around((k - 1) * 0.14, 0.11)
        body.append(
            cylinder(
                Finish(colour if not dark else (0.95, 0.94, 0.9), "plastic"),
                around(x / 2 - 0.02, 0.016),
                at,
                (0.02, 0.036),
                axis=1,
            )
        )
    return Build(body=body)


_SEA, _LAND = Finish((0.70, 0.83, 0.89), "paper"), ((0.62, 0.72, 0.45), (0.88, 0.76, 0.48), (0.80, 0.56, 0.42))
_LANDS = (
    ((-0.45, 0.84), (-0.2, 0.88), (-0.15, 0.74), (-0.29, 0.56), (-0.36, 0.62)),
    ((-0.36, 0.62), (-0.29, 0.58), (-0.23, 0.48), (-0.26, 0.48)),
    ((-0.28, 0.5), (-0.14, 0.42), (-0.2, 0.22), (-0.25, 0.14), (-0.26, 0.34)),
    ((-0.16, 0.92), (-0.06, 0.91), (-0.12, 0.78)),
    ((-0.06, 0.66), (0.1, 0.66), (0.1, 0.86), (0.02, 0.87)),
    ((-0.08, 0.6), (0.08, 0.6), (0.14, 0.48), (0.08, 0.24), (0.04, 0.24), (-0.07, 0.46)),
    ((0.1, 0.62), (0.1, 0.88), (0.44, 0.88), (0.38, 0.66), (0.28, 0.5), (0.2, 0.5)),
    ((0.28, 0.32), (0.4, 0.36), (0.44, 0.24), (0.31, 0.21)),
)
"""Outlines of the lands of the earth, in shares of the width from its middle and of the height of a map."""


def wall_map(spec: Spec) -> Build:
    """Return a map of the world that hangs from a rod, with another at its foot, or a "framed" one."""
    x, y, z = spec.size
    wood, bar = spec.main(spec.style.wood), min(x, 0.03)
    skin = (0.2 * x, 0.2 * x + 0.0008)
    body = (
        _sheet(spec, wood, _SEA, bar)
        if spec.has("framed")
        else [
            *(box(wood, (-x / 2, x / 2), (-y / 2, y / 2), level) for level in ((0, bar), (z - bar, z))),
            box(_SEA, (-0.2 * x, 0.2 * x), around(0, 0.97 * y), (bar, z - bar)),
        ]
    )
    for k, land in enumerate(_LANDS):
        patch = prism(Finish(_LAND[k % 3], "paper"), [(u * y, v * z) for u, v in land], skin, axis=0)
        body.append(replace(patch, collide=False))
    return Build(body=body)


def screen(spec: Spec) -> Build:
    """Return a projection screen under its housing, or a flat display when the category says so."""
    x, y, z = spec.size
    body = [
        box(WHITE_METAL, (-x / 2, x / 2), (-y / 2, y / 2), (z - 0.09, z)),
        box(Finish((0.98, 0.98, 0.98), "fabric"), around(0, 0.006), around(0, y - 0.08), (0.03, z - 0.09)),
        box(WHITE_METAL, around(0, 0.03), around(0, y - 0.06), (0, 0.03)),
    ]
    body += [
        box(BLACK_PLASTIC, (0.003, 0.004), (s * (y / 2 - 0.04), s * (y / 2 - 0.07)), (0.03, z - 0.09), collide=False)
        for s in (-1, 1)
    ]
    return Build(body=body)


def menu_board(spec: Spec) -> Build:
    """Return a dark board with lines of chalk lettering."""
    x, y, z = spec.size
    body = _sheet(spec, spec.wood, SLATE, 0.035)
    chalk = Finish((0.93, 0.91, 0.85), "paper")
    ink = (x / 6, x / 6 + 0.002)
    body.append(
        box(Finish((0.90, 0.72, 0.40), "paper"), ink, around(0, 0.4 * y), around(0.86 * z, 0.05 * z), collide=False)
    )
    for row in range(6):
        height = around((0.72 - 0.11 * row) * z, 0.025 * z)
        for column in (-1, 1):
            start = column * 0.24 * y
            length = spec.between(0.5, 1.0) * 0.22 * y
            body.append(box(chalk, ink, (start + 0.15 * y - length, start + 0.15 * y), height, collide=False))
            body.append(box(chalk, ink, (start - 0.17 * y, start - 0.12 * y), height, collide=False))
    return Build(body=body)


def picture(spec: Spec) -> Build:
    """Return a framed print: a mat and a few flat forms; a poster is the same without a mat, unless it is "framed"."""
    x, y, z = spec.size
    poster = spec.category == "poster" and not spec.has("framed")
    frame = spec.main(spec.choice((spec.style.wood, IRON, BRASS, WHITE_PAINT)))
    body = _sheet(spec, frame, PAPER, 0.012 if poster else 0.022)
    margin = 0.03 if poster else 0.16 * min(y, z)
    face = x / 6
    art = (around(0, y - 2 * margin), (margin, z - margin))
    grounds = ((0.90, 0.85, 0.76), (0.84, 0.87, 0.84), (0.93, 0.88, 0.84), (0.80, 0.84, 0.87))
    body.append(box(Finish(spec.choice(grounds), "paper"), (face, face + 0.001), *art, collide=False))
    body += spec.choice((_hills, _discs, _blocks))(spec, face + 0.001, art[0][1], art[1])
    return Build(body=body)


_INKS = (
    (0.74, 0.43, 0.31),
    (0.24, 0.33, 0.42),
    (0.80, 0.61, 0.30),
    (0.50, 0.58, 0.48),
    (0.86, 0.70, 0.62),
    (0.30, 0.42, 0.40),
)


def _inks(spec: Spec) -> list[Finish]:
    return [Finish(_INKS[int(k)], "paper") for k in spec.rng.permutation(len(_INKS))]


def _hills(spec: Spec, x: float, half: float, z: tuple[float, float]) -> list[Part]:
    inks, height = _inks(spec), z[1] - z[0]
    parts = [
        cylinder(
            inks[0],
            (x, x + 0.0004),
            around(half * spec.between(-0.4, 0.4), 0.24 * height),
            around(z[0] + 0.72 * height, 0.24 * height),
            axis=0,
            collide=False,
        )
    ]
    for k in range(3):
        a, b = height * spec.between(0.2, 0.5) * (1.1 - 0.25 * k), height * spec.between(0.2, 0.5) * (1.1 - 0.25 * k)
        top = max(a, b) + 0.04 * height
        outline = [
            (-half, z[0]),
            (half, z[0]),
            (half, z[0] + b),
            (half * spec.between(-0.3, 0.3), z[0] + top),
            (-half, z[0] + a),
        ]
        parts.append(_flat(inks[k + 1], outline, x + 0.0004 * (k + 1)))
    return parts


def _flat(finish: Finish, outline: list[tuple[float, float]], x: float) -> Part:
    return replace(prism(finish, outline, (x, x + 0.0004), axis=0), collide=False)


def _discs(spec: Spec, x: float, half: float, z: tuple[float, float]) -> list[Part]:
    inks, height = _inks(spec), z[1] - z[0]
    parts: list[Part] = []
    for k, size in enumerate((0.5, 0.36, 0.22)):
        wide = size * min(height, 2 * half)
        at = (spec.between(-0.8, 0.8) * (half - wide / 2), z[0] + wide / 2 + spec.between(0.1, 0.9) * (height - wide))
        parts.append(
            cylinder(
                inks[k], (x, x + 0.0004 * (k + 1)), around(at[0], wide), around(at[1], wide), axis=0, collide=False
            )
        )
    return parts


def _blocks(spec: Spec, x: float, half: float, z: tuple[float, float]) -> list[Part]:
    inks, height = _inks(spec), z[1] - z[0]
    parts: list[Part] = []
    for k in range(4):
        wide, tall = spec.between(0.5, 1.1) * half, spec.between(0.2, 0.42) * height
        at = (spec.between(-0.9, 0.9) * (half - wide / 2), z[0] + 0.06 * height + (0.9 * height - tall) * k / 3)
        parts.append(box(inks[k], (x, x + 0.0004 * (k + 1)), around(at[0], wide), (at[1], at[1] + tall), collide=False))
    return parts


def mirror(spec: Spec) -> Build:
    """Return a wall mirror, round or oval when asked for."""
    x, y, z = spec.size
    frame = spec.main(spec.choice((spec.style.metal, spec.style.wood)))
    if spec.has("round", "oval", "circular"):
        rim = [(a, b + z / 2) for a, b in oval(y, z)]
        glass = [(a, b + z / 2) for a, b in oval(y - 0.05, z - 0.05)]
        return Build(
            body=[
                prism(frame, rim, (-x / 2, x / 2 - 0.002), axis=0),
                prism(MIRROR, glass, (x / 2 - 0.002, x / 2), axis=0),
            ]
        )
    return Build(body=_sheet(spec, frame, MIRROR, 0.03))


def clock(spec: Spec) -> Build:
    """Return a round clock at ten past ten; "propped" on a foot that it stands on."""
    x, y, z = spec.size
    size, mid = min(y, z), z / 2
    rim = spec.main(spec.choice((IRON, spec.style.wood, BRASS)))
    body = [cylinder(rim, (-x / 2, x / 2 - 0.006), around(0, size), around(mid, size), axis=0)]
    body.append(cylinder(PAPER, (x / 2 - 0.006, x / 2 - 0.004), around(0, 0.9 * size), around(mid, 0.9 * size), axis=0))
    for degrees, length in ((30, 0.24), (-60 - 240, 0.34)):
        a = degrees * pi / 180
        tip = (x / 2 + 0.0, -length * size * sin(a), mid + length * size * cos(a))
        body.append(rod(IRON, (x / 2 - 0.002, 0, mid), (x / 2 - 0.002, tip[1], tip[2]), 0.002, sides=6))
    for k in range(12):
        a = pi * k / 6
        body.append(
            box(
                IRON,
                (x / 2 - 0.004, x / 2 - 0.003),
                around(0.4 * size * sin(a), 0.012),
                around(mid + 0.4 * size * cos(a), 0.012),
                collide=False,
            )
        )
    if spec.has("propped"):
        body.append(box(rim, (-x / 2, x / 2), around(0, 0.6 * size), (0, 0.08 * size)))
    return Build(body=body)


def dart_board(spec: Spec) -> Build:
    """Return a dart board on its surround."""
    x, y, z = spec.size
    size, mid = min(y, z), z / 2
    tones = (
        (IRON, 1.0),
        (Finish((0.86, 0.80, 0.66), "fabric"), 0.76),
        (Finish((0.18, 0.42, 0.28), "fabric"), 0.6),
        (Finish((0.86, 0.80, 0.66), "fabric"), 0.55),
        (Finish((0.70, 0.20, 0.18), "fabric"), 0.38),
        (Finish((0.15, 0.14, 0.14), "fabric"), 0.33),
        (Finish((0.18, 0.42, 0.28), "fabric"), 0.12),
        (Finish((0.75, 0.2, 0.18), "fabric"), 0.05),
    )
    body: list[Part] = []
    for k, (finish, share) in enumerate(tones):
        outer = x / 2 - 0.001 * (len(tones) - 1 - k)
        body.append(
            cylinder(
                finish,
                (-x / 2 if k == 0 else outer - 0.001, outer),
                around(0, share * size),
                around(mid, share * size),
                axis=0,
                collide=k == 0 or share > 0.7,
            )
        )
    return Build(body=body)
