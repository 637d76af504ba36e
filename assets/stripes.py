"""Stripes and checks on cloth: bands of another tone around what is made of fabric."""

from collections.abc import Collection, Iterator, Sequence
from itertools import product

import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.assets.repaint import faces
from thinkblox.scene.asset import Link, Shape
from thinkblox.scene.corners import rotation
from thinkblox.value import Vec3

STRIPED, CHECKED = "striped", "checked"
"""The words that ask for them."""
_CLOTH = frozenset(("fabric", "leather", "paper"))
_LEAST = 0.03
"""Least share of the cloth that a part of it has to have stripes [of its faces]."""
_BAND, _FEWEST, _MOST = 0.09, 3, 9
"""How wide a band and a gap about are [m], and how many bands a part has."""
_SHARE = 0.36
"""How wide a band is, as a share of it and a gap."""
_FLAT = 0.05
"""What is no higher lies in layers [m]."""
_OVER = 0.0006
"""How far a band stands off what it is on [m]."""
_BRIGHT = 0.55
"""What is brighter has darker stripes, and what is darker has lighter ones."""


def patterned(links: tuple[Link, ...], words: Collection[str]) -> tuple[Link, ...]:
    """Links with bands of another tone around each larger part of cloth: across its longer side, or both for checks."""
    sides = 2 if CHECKED in words else 1 if STRIPED in words else 0
    if not sides:
        return links
    cloth = [shape for link in links for shape in link.shapes if shape.material in _CLOTH]
    whole = sum(map(faces, cloth))
    large = {id(shape) for shape in _seen(cloth) if faces(shape) >= _LEAST * whole}
    return tuple(
        structs.replace(
            link, shapes=(*link.shapes, *(band for s in link.shapes if id(s) in large for band in _bands(s, sides)))
        )
        for link in links
    )


def _seen(cloth: Sequence[Shape]) -> list[Shape]:
    """The parts that are seen: of what lies flat in layers, the topmost that is large."""
    tops = [float(points[:, 2].max()) for points in map(_corners, cloth) if points is not None]
    if not tops or max(tops) > _FLAT:
        return [*cloth]
    large = [shape for shape in cloth if faces(shape) >= 0.5 * max(map(faces, cloth))]
    return [max(large, key=lambda shape: shape.position[2] + shape.size[2] / 2)]


def _bands(shape: Shape, sides: int) -> list[Shape]:
    """Every second slice of a convex shape across one or both sides of its plan, a little larger than that."""
    points = _corners(shape)
    if points is None:
        return []
    low, high = points.min(axis=0), points.max(axis=0)
    across = np.argsort(low[:2] - high[:2])[:sides].tolist()
    middle = (low + high) / 2
    grown = middle + (points - middle) * (1.0 + 2 * _OVER / np.maximum(high - low, 1e-4))
    tones = (_other_tone(shape.colour), _darker(shape.colour, 0.94 if sum(shape.colour) / 3 > _BRIGHT else 0.86))
    made = [(each, tone) for axis, tone in zip(across, tones, strict=False) for each in _slices(grown, axis)]
    return [
        Shape(
            kind="hull",
            size=_vec(corners.max(axis=0) - corners.min(axis=0)),
            position=(0.0, 0.0, 0.0),
            points=tuple(_vec(corner) for corner in corners),
            colour=tone,
            material=shape.material,
            collide=False,
            smooth=shape.smooth,
        )
        for corners, tone in made
    ]


def _slices(points: NDArray[np.float64], axis: int) -> Iterator[NDArray[np.float64]]:
    low, high = float(points[:, axis].min()), float(points[:, axis].max())
    number = int(np.clip(round((high - low) / _BAND / 2), _FEWEST, _MOST))
    pitch = (high - low) / number
    for k in range(number):
        middle = low + (k + 0.5) * pitch
        corners = _slice(points, axis, middle - _SHARE * pitch / 2, middle + _SHARE * pitch / 2)
        if corners is not None:
            yield corners


def _corners(shape: Shape) -> NDArray[np.float64] | None:
    """The corners of a box or hull in the asset's frame [m]; None for what is round."""
    if shape.kind == "hull":
        local = np.array(shape.points)
    elif shape.kind == "box":
        local = np.array([[s * side / 2 for s, side in zip(signs, shape.size, strict=True)] for signs in _SIGNS])
    else:
        return None
    return np.asarray(local @ rotation(shape.quat_wxyz).T + np.array(shape.position))


_SIGNS = tuple(product((-1.0, 1.0), repeat=3))


def _slice(points: NDArray[np.float64], axis: int, low: float, high: float) -> NDArray[np.float64] | None:
    """The corners of what of a convex hull lies between two planes [m]; None where that is nothing solid."""
    import trimesh

    part = trimesh.convex.convex_hull(points)
    ahead = np.eye(3)[axis]
    for origin, normal in ((low * ahead, ahead), (high * ahead, -ahead)):
        part = part.slice_plane(origin, normal)
        if len(part.vertices) < 4:
            return None
    corners = np.asarray(trimesh.convex.convex_hull(part.vertices).vertices)
    return corners.round(5) if np.ptp(corners, axis=0).min() > 1e-4 else None


def _other_tone(colour: Vec3) -> Vec3:
    r, g, b = (1.0 - 0.25 * (1.0 - c) for c in colour)
    return _darker(colour, 0.6) if sum(colour) / 3 > _BRIGHT else (r, g, b)


def _darker(colour: Vec3, share: float) -> Vec3:
    r, g, b = (share * c for c in colour)
    return (r, g, b)


def _vec(values: NDArray[np.float64]) -> Vec3:
    x, y, z = (float(v) for v in values)
    return (x, y, z)
