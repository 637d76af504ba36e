"""Books, shut and open."""

from dataclasses import replace

from thinkblox.assets.palette import PAPER
from thinkblox.assets.part import Finish, Part, Range
from thinkblox.assets.shapes import around, box, prism
from thinkblox.value import Vec2, Vec3

_INK = Finish((0.35, 0.34, 0.33), "paper")
"""What print looks like from a little way off."""


def shut_book(finish: Finish, x: Range, y: Range, z: Range) -> list[Part]:
    """Return a book that lies closed over three ranges, its spine to the right [m]."""
    cover = min(0.003, 0.2 * (z[1] - z[0]))
    return [
        box(finish, x, y, (z[0], z[0] + cover)),
        box(PAPER, (x[0] + 0.003, x[1] - 0.003), (y[0] + 0.004, y[1] - 0.003), (z[0] + cover, z[1] - cover)),
        box(finish, x, (y[0], y[0] + 0.004), (z[0] + cover, z[1] - cover)),
        box(finish, x, y, (z[1] - cover, z[1])),
    ]


def open_book(cover: Finish, size: Vec3) -> list[Part]:
    """Return an open book over a box of that size, for who reads it from the front [m]."""
    return [*_half_open(cover, size, -1), *_half_open(cover, size, 1)]


def _half_open(cover: Finish, size: Vec3, side: int) -> list[Part]:
    """The left or right half of an open book, with lines of print on its page, for who reads it from the front."""
    x, y, z = size
    half, thin, ends = y / 2, 0.1 * z, (-x / 2 + 0.004, x / 2 - 0.004)
    bend, edge = (0.3 * half, z - 0.001), (0.97 * half, z - min(0.45 * z, 0.022))
    pages = [(0.0, thin), (0.0, z - min(0.2 * z, 0.01)), bend, edge, (edge[0], thin)]
    body = [box(cover, (-x / 2, x / 2), (0.0, side * half), (0.0, thin))]
    body.append(prism(PAPER, [(side * a, b) for a, b in pages], ends, axis=0))
    body += [_line_of_print(bend, edge, side, (0.38 - 0.09 * k) * x) for k in range(9)]
    return body


def _line_of_print(bend: Vec2, edge: Vec2, side: int, x: float) -> Part:
    """A thin dark strip across the level part of a page."""
    fall = (edge[1] - bend[1]) / (edge[0] - bend[0])
    ends = [(a, bend[1] + fall * (a - bend[0])) for a in (1.05 * bend[0], 0.93 * edge[0])]
    outline = [*ends, *((a, b + 0.001) for a, b in reversed(ends))]
    strip = prism(_INK, [(side * a, b) for a, b in outline], around(x, 0.006), axis=0)
    return replace(strip, collide=False)
