"""Bent bars: round rods through a row of points, on arcs and rings."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, pi, sin

from thinkblox.assets.part import Finish, Part, Range
from thinkblox.assets.shapes import rod
from thinkblox.value import Vec2, Vec3


def tube(finish: Finish, points: Sequence[Vec3], radius: float, *, sides: int = 8) -> list[Part]:
    """Return a bar through `points`, a straight rod between each two [m]."""
    return [rod(finish, a, b, radius, sides=sides) for a, b in pairwise(points)]


def arc(centre: Vec3, radii: Vec2, degrees: Range, *, axis: int, steps: int = 8) -> list[Vec3]:
    """Return points on an elliptic arc about an axis (0 to 2), counted from the next axis on [m].

    The radii are along the two axes that follow `axis`: for axis 0 those are y and z.
    """
    i, j = (axis + 1) % 3, (axis + 2) % 3
    points: list[Vec3] = []
    for k in range(steps + 1):
        angle = pi / 180 * (degrees[0] + (degrees[1] - degrees[0]) * k / steps)
        at = list(centre)
        at[i] += radii[0] * cos(angle)
        at[j] += radii[1] * sin(angle)
        points.append((at[0], at[1], at[2]))
    return points


def ring(finish: Finish, centre: Vec3, radii: Vec2, radius: float, *, axis: int, sides: int = 12) -> list[Part]:
    """Return a closed ring of a bar `radius` thick about an axis (0 to 2) [m]."""
    return tube(finish, arc(centre, radii, (0.0, 360.0), axis=axis, steps=sides), radius, sides=6)
