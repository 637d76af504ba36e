"""Helpers that make parts from ranges along the axes: boxes, turned profiles, cushions, legs, rods."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, pi, sin

import numpy as np
from msgspec import structs

from thinkblox.assets.part import Finish, Kind, Part, Range, hull
from thinkblox.scene.asset import Surface
from thinkblox.value import Vec2, Vec3


def box(finish: Finish, x: Range, y: Range, z: Range, *, collide: bool = True) -> Part:
    """Return a box over three ranges [m]."""
    return _part("box", finish, (x, y, z), 2, collide)


def cylinder(finish: Finish, x: Range, y: Range, z: Range, *, axis: int = 2, collide: bool = True) -> Part:
    """Return a cylinder inscribed in three ranges [m]; across `axis` the ranges must be equally long."""
    return _part("cylinder", finish, (x, y, z), axis, collide)


def ellipsoid(finish: Finish, x: Range, y: Range, z: Range, *, collide: bool = True) -> Part:
    """Return an ellipsoid inscribed in three ranges [m]."""
    return _part("ellipsoid", finish, (x, y, z), 2, collide)


def capsule(finish: Finish, x: Range, y: Range, z: Range, *, axis: int = 2) -> Part:
    """Return a capsule along `axis` inscribed in three ranges [m]."""
    return _part("capsule", finish, (x, y, z), axis, True)


def _part(kind: Kind, finish: Finish, ranges: Sequence[Range], axis: int, collide: bool) -> Part:
    lo, hi = [min(r) for r in ranges], [max(r) for r in ranges]
    return Part(kind, (lo[0], lo[1], lo[2]), (hi[0], hi[1], hi[2]), finish, axis=axis, collide=collide)


def around(centre: float, length: float) -> Range:
    """Return the range of `length` about `centre` [m]."""
    return (centre - length / 2, centre + length / 2)


def sphere(finish: Finish, centre: Vec3, radius: float) -> Part:
    """Return a ball [m]."""
    x, y, z = (around(c, 2 * radius) for c in centre)
    return _part("sphere", finish, (x, y, z), 2, True)


def disc(finish: Finish, centre: Vec2, radius: float, z: Range, *, collide: bool = True) -> Part:
    """Return an upright cylinder [m]."""
    return cylinder(finish, around(centre[0], 2 * radius), around(centre[1], 2 * radius), z, collide=collide)


def frustum(
    finish: Finish, centre: Vec2, z: Range, bottom: float, top: float, *, sides: int = 20, smooth: bool = True
) -> Part:
    """Return an upright cone stump with radii `bottom` and `top` [m]."""
    angles = [2 * pi * k / sides for k in range(sides)]
    points = [
        (centre[0] + r * cos(a), centre[1] + r * sin(a), h) for h, r in ((z[0], bottom), (z[1], top)) for a in angles
    ]
    return hull(finish, points, smooth=smooth)


def profile(finish: Finish, centre: Vec2, rings: Sequence[Vec2], *, sides: int = 20, round: bool = False) -> list[Part]:
    """Return a solid turned about an upright axis: a stack of stumps through rings (z, radius) [m].

    With `round`, the outline bends smoothly through the rings.
    """
    fine = rounded_rings(rings) if round else list(rings)
    pairs = pairwise(fine)
    return [frustum(finish, centre, (a[0], b[0]), a[1], b[1], sides=sides) for a, b in pairs]


def rounded_rings(rings: Sequence[Vec2]) -> list[Vec2]:
    """Return rings (z, radius) and one more between each two, on a Catmull-Rom curve [m]."""
    ends = [rings[0], *rings, rings[-1]]
    fine: list[Vec2] = [rings[0]]
    for before, a, b, after in zip(ends, ends[1:], ends[2:], ends[3:], strict=False):
        middle = (9 * (a[1] + b[1]) - before[1] - after[1]) / 16
        fine += [((a[0] + b[0]) / 2, max(middle, 0.9 * min(a[1], b[1]))), b]
    return fine


def shell(
    finish: Finish, centre: Vec2, z: Range, bottom: float, top: float, wall: float, *, pieces: int = 12
) -> list[Part]:
    """Return the wall of a round vessel as convex staves, outer radii `bottom` and `top` [m]."""
    staves: list[Part] = []
    for k in range(pieces):
        angles = [2 * pi * (k + step) / pieces for step in (-0.5, -0.17, 0.17, 0.5)]
        rings = ((z[0], bottom), (z[0], bottom - wall), (z[1], top), (z[1], top - wall))
        points = [
            (centre[0] + r * cos(a), centre[1] + r * sin(a), h)
            for h, r in rings
            for a in (angles if r in (bottom, top) else angles[::3])
        ]
        staves.append(hull(finish, points, smooth=False))
    return staves


def cushion(finish: Finish, x: Range, y: Range, z: Range, *, radius: float = 0.04, smooth: bool = True) -> Part:
    """Return a box with rounded edges and corners [m]; the radius is cut down to fit."""
    ranges = (x, y, z)
    r = min(radius, *((hi - lo) / 2.001 for lo, hi in ranges))
    normals = [np.array(n, dtype=float) / np.linalg.norm(n) for n in np.ndindex(2, 2, 2) if any(n)]
    points: list[Vec3] = []
    for signs in np.ndindex(2, 2, 2):
        corner = [ranges[i][signs[i]] + (r if signs[i] == 0 else -r) for i in range(3)]
        points += [_offset(corner, signs, r * n) for n in normals]
    return hull(finish, points, smooth=smooth)


def _offset(corner: Sequence[float], signs: tuple[int, ...], n: np.ndarray) -> Vec3:
    x, y, z = (corner[i] + float(n[i]) * (1 if signs[i] else -1) for i in range(3))
    return (x, y, z)


def pad(finish: Finish, x: Range, y: Range, z: Range, *, edge: float = 0.25, flat: bool = False) -> Part:
    """Return a soft pad, thick in the middle and thin at its edge; with `flat` its underside is level [m].

    Top and bottom are drawn in from the plan by `edge`, in shares of the height.
    """
    centre = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2)
    tall = z[1] - z[0]
    levels = ((0.0, 1.0), (0.35, 0.98), (0.7, 0.86), (1.0, 0.5)) if flat else _LENS
    points: list[Vec3] = []
    for height, share in levels:
        draw = edge * tall * (1 - share) * 4
        outline = oval(max(x[1] - x[0] - draw, 1e-3), max(y[1] - y[0] - draw, 1e-3), sides=24, squareness=4.0)
        points += [(centre[0] + a, centre[1] + b, z[0] + height * tall) for a, b in outline]
    return hull(finish, points, smooth=True)


_LENS = ((0.0, 0.3), (0.14, 0.7), (0.5, 1.0), (0.86, 0.7), (1.0, 0.3))


def leg(finish: Finish, foot: Vec2, head: Vec2, z: Range, foot_width: float, head_width: float) -> Part:
    """Return a square leg from `foot` at z[0] to `head` at z[1], tapered and splayed [m]."""
    points = [
        (at[0] + dx * width / 2, at[1] + dy * width / 2, height)
        for at, width, height in ((foot, foot_width, z[0]), (head, head_width, z[1]))
        for dx in (-1, 1)
        for dy in (-1, 1)
    ]
    return hull(finish, points)


def round_leg(finish: Finish, foot: Vec2, head: Vec2, z: Range, foot_radius: float, head_radius: float) -> Part:
    """Return a round leg from `foot` at z[0] to `head` at z[1], tapered and splayed [m]."""
    angles = [2 * pi * k / 12 for k in range(12)]
    ends = ((foot, foot_radius, z[0]), (head, head_radius, z[1]))
    points = [(at[0] + r * cos(a), at[1] + r * sin(a), h) for at, r, h in ends for a in angles]
    return hull(finish, points, smooth=True)


def rod(
    finish: Finish, start: Vec3, end: Vec3, radius: float, *, sides: int = 10, end_radius: float | None = None
) -> Part:
    """Return a straight round bar between two points [m]."""
    a, b = np.array(start), np.array(end)
    along = (b - a) / np.linalg.norm(b - a)
    side = np.cross(along, [0.0, 0.0, 1.0] if abs(along[2]) < 0.9 else [1.0, 0.0, 0.0])
    side /= np.linalg.norm(side)
    other = np.cross(along, side)
    points: list[Vec3] = []
    for at, r in ((a, radius), (b, radius if end_radius is None else end_radius)):
        for k in range(sides):
            p = at + r * (cos(2 * pi * k / sides) * side + sin(2 * pi * k / sides) * other)
            points.append((float(p[0]), float(p[1]), float(p[2])))
    return hull(finish, points, smooth=True)


def prism(finish: Finish, outline: Sequence[Vec2], across: Range, *, axis: int = 2, smooth: bool = False) -> Part:
    """Return a convex outline drawn out along `axis`; the outline is in the other two axes, in their order [m]."""
    points: list[Vec3] = []
    for h in across:
        for u, v in outline:
            points.append((h, u, v) if axis == 0 else (u, h, v) if axis == 1 else (u, v, h))
    return hull(finish, points, smooth=smooth)


def oval(x: float, y: float, *, sides: int = 40, squareness: float = 2.0) -> list[Vec2]:
    """Return the corners of an ellipse of full extents x, y [m], squarer with a higher exponent."""
    angles = [2 * pi * k / sides for k in range(sides)]
    bend = 2 / squareness
    return [
        (
            x / 2 * abs(cos(a)) ** bend * (1 if cos(a) >= 0 else -1),
            y / 2 * abs(sin(a)) ** bend * (1 if sin(a) >= 0 else -1),
        )
        for a in angles
    ]


def polygon(x: float, y: float, count: int) -> list[Vec2]:
    """Return the corners of a regular polygon stretched to full extents x, y, with sides across the x axis [m]."""
    angles = [2 * pi * (k + 0.5) / count for k in range(count)]
    wide, high = max(cos(a) for a in angles), max(sin(a) for a in angles)
    return [(x / 2 * cos(a) / wide, y / 2 * sin(a) / high) for a in angles]


def panel(finish: Finish, x: Range, y: Range, z: Range, bar: float, fill: Finish | None = None) -> list[Part]:
    """Return an upright frame of bars `bar` wide that faces x, filled with a thinner sheet when `fill` is given [m]."""
    parts = [
        box(finish, x, (y[0], y[0] + bar), z),
        box(finish, x, (y[1] - bar, y[1]), z),
        box(finish, x, (y[0] + bar, y[1] - bar), (z[0], z[0] + bar)),
        box(finish, x, (y[0] + bar, y[1] - bar), (z[1] - bar, z[1])),
    ]
    if fill:
        mid, third = (x[0] + x[1]) / 2, (x[1] - x[0]) / 3
        parts.append(box(fill, around(mid, third), (y[0] + bar, y[1] - bar), (z[0] + bar, z[1] - bar)))
    return parts


def inner_surface(
    name: str, x: Range, y: Range, z: float, *, headroom: float | None = None, round: bool = False
) -> Surface:
    """Return the level area at the bottom of a hollow or behind a door [m]."""
    return structs.replace(top_surface(name, x, y, z, headroom=headroom, round=round), within=True)


def top_surface(
    name: str, x: Range, y: Range, z: float, *, headroom: float | None = None, round: bool = False
) -> Surface:
    """Return the level area over two ranges at height z [m]."""
    return Surface(
        name=name,
        position=((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, z),
        size=(x[1] - x[0], y[1] - y[0]),
        headroom=headroom,
        round=round,
    )


def gusset(finish: Finish, corner: Vec2, a: Vec2, b: Vec2, width: float) -> Part:
    """Return a triangular wedge over three points (x, z), `width` across [m]."""
    return prism(finish, [corner, a, b], (-width / 2, width / 2), axis=1)
