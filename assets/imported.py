"""Assets of shapes that were not made here: convex pieces of somebody's mesh, or the box that stands for one."""

import colorsys
import hashlib
import zlib
from collections.abc import Sequence

import msgspec
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.scene.asset import FRONT_UNKNOWN, Asset, Link, Mount, Shape
from thinkblox.value import Vec3

Array = NDArray[np.float64]
BOX_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
"""Corners of the unit box about the origin."""


def imported_asset(
    shapes: Sequence[Shape],
    *,
    category: str,
    description: str,
    size: Vec3,
    mass: float,
    friction: float,
    mount: Mount,
    provenance: str,
) -> Asset:
    """A rigid asset of shapes that lie in the asset's frame; nobody's licence is known for it, and nobody says
    that its mesh has its front where the layout turns it to.
    """
    asset = Asset(
        id="",
        category=category,
        description=description,
        size=size,
        mass=mass,
        friction=friction,
        mount=mount,
        links=(Link(name="body", shapes=tuple(shapes)),),
        licence="unknown",
        author="unknown",
        provenance=provenance,
        flags=(FRONT_UNKNOWN,),
    )
    digest = hashlib.sha256(msgspec.json.encode(asset)).hexdigest()[:8]
    return structs.replace(
        asset, id=f"{category}-{digest}", gaze=CATALOGUE[category].gaze if category in CATALOGUE else "front"
    )


def box_shape(size: Vec3, *, category: str, collide: bool = True) -> Shape:
    """The box of a size that stands on the origin."""
    return Shape(kind="box", size=size, position=(0.0, 0.0, size[2] / 2), colour=colour_of(category), collide=collide)


def hull_shape(points: Array, *, category: str, collide: bool = True) -> Shape:
    """The convex hull of points (n, 3) in the asset's frame [m]."""
    extent = np.ptp(points, axis=0)
    return Shape(
        kind="hull",
        size=(float(extent[0]), float(extent[1]), float(extent[2])),
        position=(0.0, 0.0, 0.0),
        points=tuple((float(x), float(y), float(z)) for x, y, z in points),
        colour=colour_of(category),
        collide=collide,
    )


def colour_of(category: str) -> Vec3:
    """A quiet colour, the same for all things of a category."""
    red, green, blue = colorsys.hsv_to_rgb(zlib.crc32(category.encode()) % 360 / 360.0, 0.14, 0.78)
    return (round(red, 4), round(green, 4), round(blue, 4))
