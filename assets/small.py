"""Small things for tables and floors: books, papers, cushions, toys, trays and tools."""

from itertools import pairwise

import numpy as np

from thinkblox.assets.books import open_book, shut_book
from thinkblox.assets.palette import (
    BRASS,
    BRIGHT,
    IRON,
    PAPER,
    SPINES,
    STEEL,
    WHITE_COTTON,
)
from thinkblox.assets.part import Build, Finish, Part, Range, turned
from thinkblox.assets.plain.pieces import plush
from thinkblox.assets.shapes import (
    around,
    box,
    cushion,
    cylinder,
    disc,
    ellipsoid,
    inner_surface,
    pad,
    panel,
    prism,
    sphere,
    top_surface,
)
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Surface
from thinkblox.value import Vec3


def book(spec: Spec) -> Build:
    """Return a closed book lying down, or an "open" one; a notebook or magazine is a thinner one."""
    x, y, z = spec.size
    if spec.has("open"):
        cover = spec.main(spec.choice(SPINES))
        return Build(body=open_book(cover, spec.size))
    return Build(
        body=shut_book(spec.main(spec.choice(SPINES)), (-x / 2, x / 2), (-y / 2, y / 2), (0, z)),
        surfaces=[top_surface("cover", (-x / 2, x / 2), (-y / 2, y / 2), z)],
    )


def book_stack(spec: Spec) -> Build:
    """Return a pile of books, each a little askew."""
    x, y, z = spec.size
    count = max(2, round(z / 0.036))
    body: list[Part] = []
    for k in range(count):
        half = (x / 2 - 0.012 * (k % 3), y / 2 - 0.01 * ((k + 1) % 3))
        shift = (spec.between(-1, 1) * (x / 2 - half[0]), spec.between(-1, 1) * (y / 2 - half[1]))
        body += shut_book(
            spec.choice(SPINES),
            (shift[0] - half[0], shift[0] + half[0]),
            (shift[1] - half[1], shift[1] + half[1]),
            (k * z / count, (k + 1) * z / count),
        )
    return Build(body=body, surfaces=[top_surface("top", around(0, 0.7 * x), around(0, 0.7 * y), z)])


def book_row(spec: Spec) -> Build:
    """Return books that stand side by side, some a little lower or further back; they are one block to the touch."""
    x, y, z = spec.size
    count = max(3, round(y / 0.055))
    thick = np.array([spec.between(0.035, 0.075) for _ in range(count)])
    ends = -y / 2 + np.cumsum([0.0, *(thick * y / thick.sum())])
    body = [box(PAPER, (-x / 2, x / 2 - 0.003), (-y / 2, y / 2), (0, 0.78 * z))]
    for k, (low, high) in enumerate(pairwise(ends.tolist())):
        tall = z if k == count // 2 else z * spec.between(0.8, 1.0)
        front = x / 2 - 0.02 * spec.between(0.0, 1.0)
        whole = k == count // 2
        body.append(
            box(spec.choice(SPINES), (-x / 2, x / 2 if whole else front), (low, high), (0, tall), collide=whole)
        )
    return Build(body=body)


def magazine(spec: Spec) -> Build:
    """Return a few magazines fanned on each other."""
    x, y, z = spec.size
    body: list[Part] = []
    count = max(1, round(z / 0.007))
    for k in range(count):
        sheet = (
            around((k - (count - 1) / 2) * 0.012, x - 0.012 * (count - 1)),
            around((k % 2) * 0.006, y - 0.012),
            (k * z / count, (k + 1) * z / count),
        )
        tint = Finish(
            spec.choice(((0.82, 0.45, 0.35), (0.86, 0.80, 0.70), (0.45, 0.56, 0.60), (0.80, 0.68, 0.42))), "paper"
        )
        body.append(box(tint, *sheet))
    body.append(box(PAPER, (0.2 * x, 0.36 * x), around(0, 0.6 * y), (z - 0.0001, z + 0.0004), collide=False))
    return Build(body=body)


def paper_stack(spec: Spec) -> Build:
    """Return a sheaf of paper."""
    x, y, z = spec.size
    return Build(body=[box(spec.main(PAPER), (-x / 2, x / 2), (-y / 2, y / 2), (0, z))])


def pillow(spec: Spec) -> Build:
    """Return a cushion lying flat, its edges thin."""
    x, y, z = spec.size
    cover = spec.main(spec.choice((spec.style.accent, spec.style.fabric)))
    return Build(body=[pad(cover, (-x / 2, x / 2), (-y / 2, y / 2), (0, z), edge=0.4)])


def blanket(spec: Spec) -> Build:
    """Return a soft blanket folded in three, its folds to the front, with a band of another tone along its hem."""
    x, y, z = spec.size
    cloth, layer = spec.main(spec.style.accent), z / 3
    hem, band = Finish(_paler(cloth), cloth.material), around(0.28 * y, 0.1 * y)
    body: list[Part] = []
    for k in range(3):
        back, top = (-0.5 + 0.03 * k) * x, (k + 1) * layer
        body.append(
            cushion(
                cloth,
                (back, (0.5 - 0.012 * k) * x),
                around(0, (1 - 0.02 * k) * y),
                (k * layer, top),
                radius=0.49 * layer,
            )
        )
    rest = 0.5 * layer
    body.append(cushion(hem, (-0.444 * x, 0.478 * x), band, (2 * layer, z + 0.002), radius=0.98 * rest))
    return Build(body=body)


def _paler(finish: Finish) -> Vec3:
    r, g, b = (1 - 0.5 * (1 - c) for c in finish.colour)
    return (r, g, b)


def photo_frame(spec: Spec) -> Build:
    """Return a picture in a frame that leans on its strut."""
    x, y, z = spec.size
    frame = spec.main(spec.choice((spec.style.wood, spec.style.metal)))
    sheet = panel(frame, (-0.006, 0.006), (-y / 2, y / 2), (0.006, z), 0.014, Finish((0.72, 0.66, 0.58), "paper"))
    body = [turned(p, 1, -14.0, (0.0, 0.0, 0.0)) for p in sheet]
    body.append(box(frame, (-0.012, 0.008), (-y / 2, y / 2), (0, 0.008)))
    height = 0.6 * z
    body.append(
        prism(
            frame,
            [
                (-x * 0.95, 0),
                (-x * 0.95 + 0.014, 0),
                (-0.24 * height - 0.002, height),
                (-0.24 * height - 0.012, height),
            ],
            around(0, 0.03),
            axis=1,
        )
    )
    return Build(body=body)


def alarm_clock(spec: Spec) -> Build:
    """Return a round clock on two feet."""
    x, y, z = spec.size
    shell, size = spec.main(spec.choice((BRASS, IRON, Finish(spec.style.accent.colour, "metal")))), min(y, z - 0.02)
    mid = z - size / 2
    return Build(
        body=[
            cylinder(shell, (-x / 2 + 0.004, x / 2 - 0.002), around(0, size), around(mid, size), axis=0),
            cylinder(PAPER, (x / 2 - 0.002, x / 2), around(0, 0.88 * size), around(mid, 0.88 * size), axis=0),
            box(IRON, (x / 2 - 0.0005, x / 2 + 0.0005), around(0, 0.004), (mid, mid + 0.32 * size), collide=False),
            box(IRON, (x / 2 - 0.0005, x / 2 + 0.0005), (0, 0.24 * size), around(mid, 0.004), collide=False),
            box(shell, (-x / 2, x / 2 - 0.002), around(0, 0.8 * size), (0, mid - 0.36 * size)),
        ]
    )


def toy(spec: Spec) -> Build:
    """Return a toy: a teddy bear, a train of blocks or a stack of rings."""
    if spec.has("teddy", "bear") or spec.category == "teddy_bear":
        return _teddy(spec)
    return spec.choice((_teddy, _blocks, _rings))(spec)


def _teddy(spec: Spec) -> Build:
    return plush(spec, Finish((0.66, 0.47, 0.30), "fabric"), Finish((0.84, 0.72, 0.56), "fabric"))


def _blocks(spec: Spec) -> Build:
    x, y, z = spec.size
    paint = [Finish(BRIGHT[int(k)], "wood") for k in spec.rng.permutation(5)]
    half = z / 2
    return Build(
        body=[
            box(paint[0], (-x / 2, -0.02 * x), (-y / 2, -0.02 * y), (0, half)),
            box(paint[1], (0.02 * x, x / 2), (-0.4 * y, 0.1 * y), (0, half)),
            box(paint[2], (-0.4 * x, 0.1 * x), (0.12 * y, y / 2), (0, half)),
            box(paint[3], around(-0.05 * x, 0.42 * x), around(-0.12 * y, 0.42 * y), (half, z)),
        ]
    )


def _rings(spec: Spec) -> Build:
    x, y, z = spec.size
    radius, step, paint = min(x, y) / 2, 0.17 * z, [Finish(colour, "wood") for colour in BRIGHT]
    rings: list[Part] = [disc(paint[k], (0, 0), radius * (1 - 0.14 * k), (k * step, (k + 1) * step)) for k in range(5)]
    return Build(body=[*rings, sphere(paint[0], (0, 0, 0.85 * z), 0.15 * z)])


def food_tray(spec: Spec) -> Build:
    """Return a steel buffet tray filled with food, unless it is "empty"."""
    x, y, z = spec.size
    inner = ((-x / 2 + 0.015, x / 2 - 0.015), (-y / 2 + 0.015, y / 2 - 0.015))
    food = spec.choice(
        ((0.85, 0.65, 0.30), (0.55, 0.62, 0.32), (0.75, 0.38, 0.24), (0.93, 0.88, 0.74), (0.62, 0.40, 0.24))
    )
    body = [
        *(box(STEEL, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.015)), (0, z - 0.004)) for s in (-1, 1)),
        *(box(STEEL, (s * x / 2, s * (x / 2 - 0.015)), inner[1], (0, z - 0.004)) for s in (-1, 1)),
        box(STEEL, *inner, (0, 0.01)),
    ]
    if spec.has("empty"):
        return Build(body=body, surfaces=_tray_floor(*inner, 0.01))
    body.append(cushion(Finish(food, "fabric"), *inner, (0.01, 0.78 * z), radius=0.02))
    for _ in range(5):
        at, size = (spec.between(-0.3, 0.3) * x, spec.between(-0.34, 0.34) * y), 0.09 * min(x, y) + 0.01
        tint = (min(1.0, food[0] * 1.12), min(1.0, food[1] * 1.1), min(1.0, food[2] * 1.1))
        body.append(ellipsoid(Finish(tint, "fabric"), around(at[0], 2.2 * size), around(at[1], 2 * size), (0.5 * z, z)))
    return Build(body=body)


def tray(spec: Spec) -> Build:
    """Return a serving tray with a rim."""
    x, y, z = spec.size
    inner = ((-x / 2 + 0.012, x / 2 - 0.012), (-y / 2 + 0.012, y / 2 - 0.012))
    body = [box(spec.wood, *inner, (0, 0.4 * z))]
    body += [box(spec.wood, (-x / 2, x / 2), (s * y / 2, s * (y / 2 - 0.012)), (0, z)) for s in (-1, 1)]
    body += [box(spec.wood, (s * x / 2, s * (x / 2 - 0.012)), inner[1], (0, z)) for s in (-1, 1)]
    return Build(body=body, surfaces=_tray_floor(*inner, 0.4 * z))


def _tray_floor(x: Range, y: Range, z: float) -> list[Surface]:
    """The floor of a tray at a height [m]: what lies there is on it, and in it as well."""
    return [top_surface("tray", x, y, z), inner_surface("inside", x, y, z)]


def cutlery(spec: Spec) -> Build:
    """Return a knife and a fork on a napkin."""
    x, y, z = spec.size
    low = 0.4 * z
    body: list[Part] = [box(spec.main(WHITE_COTTON), (-x / 2, x / 2), (-y / 2, y / 2), (0, low))]
    for s in (-1, 1):
        body.append(box(STEEL, (-0.42 * x, 0.42 * x), around(s * 0.22 * y, 0.012), (low, z)))
        body.append(box(STEEL, (-0.42 * x, -0.1 * x), around(s * 0.22 * y, 0.02), (low, z)))
    return Build(body=body)
