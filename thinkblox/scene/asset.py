"""What can be placed. Asset frame: origin at the centre of the footprint at the base, x to the front, y left, z up."""

import math
from collections.abc import Sequence
from functools import cached_property, lru_cache
from hashlib import sha256
from typing import Annotated, Literal

import numpy as np
from msgspec import Meta, structs

from thinkblox.checked import AboveZero, CheckedValue, Coordinate, Extent, NotNegative, Number, Share, is_unit
from thinkblox.scene.blobs import BlobKind
from thinkblox.scene.corners import corners_of
from thinkblox.scene.visuals import MeshVisual
from thinkblox.value import Value

Mount = Literal["floor", "wall", "ceiling", "surface"]
Gaze = Literal["front", "back"]
Material = Literal[
    "wood", "metal", "fabric", "leather", "glass", "ceramic", "plastic", "paper", "leaf", "stone", "light", "screen"
]
MAX_VISUALS = 256
"""Most meshes that one link shows."""
Point = tuple[Coordinate, Coordinate, Coordinate]
Direction = tuple[Number, Number, Number]
MAX_SHAPES = 2048
"""Most shapes of one asset."""
MAX_LINKS = 64
"""Most links of one asset."""
MAX_CORNERS = 4096
"""Most corners of one hull."""
FRONT_UNKNOWN = "front_unknown"
"""The flag of an asset whose source does not say which of its sides is its front."""
_THIN = 1e-6
_GROUND = 0.005
"""What is lower than this touches what a thing stands on [m]."""
_MOST = 0.85
"""Share of its sides from which a foot is about all of the outline."""


class Shape(CheckedValue, frozen=True, kw_only=True, omit_defaults=True, dict=True):
    """One convex primitive of a link, in the asset frame.

    Attributes:
        kind: "box", "cylinder" (along its z), "capsule" (along its z), "sphere", "ellipsoid", or "hull", the convex
            hull of `points`.
        size: full extents along the shape's own x, y, z [m]; a capsule's z includes its caps. For a hull, the
            extents of its points.
        position: centre of the shape [m]; for a hull, the origin of its points.
        quat_wxyz: orientation.
        points: corners of a hull [m], in the shape's frame.
        colour: linear base colour is derived from this sRGB triple, 0 to 1.
        collide: False for what is only looked at (a rug's pile, a screen's picture).
        smooth: shade curved, for a hull that stands for a round thing.

    Raises:
        InputError: a field out of range, a `quat_wxyz` whose length is not 1, or a hull whose points span no volume.
    """

    kind: Literal["box", "cylinder", "capsule", "sphere", "ellipsoid", "hull"]
    size: tuple[Extent, Extent, Extent]
    position: Point
    quat_wxyz: tuple[Number, Number, Number, Number] = (1.0, 0.0, 0.0, 0.0)
    points: Annotated[tuple[Point, ...], Meta(max_length=MAX_CORNERS)] = ()
    colour: tuple[Share, Share, Share] = (0.7, 0.7, 0.7)
    material: Material = "wood"
    collide: bool = True
    smooth: bool = False

    def __post_init__(self) -> None:
        super().__post_init__()
        if not is_unit(self.quat_wxyz):
            raise self.refused("quat_wxyz", f"is {self.quat_wxyz}; a unit quaternion is needed, of length 1")
        if self.kind == "hull" and not _spans_volume(self.points):
            raise self.refused("points", f"of the hull, {len(self.points)}, span no volume; 4 out of plane are needed")


def _spans_volume(points: tuple[Point, ...]) -> bool:
    """Whether some four of the points are the corners of a body, at least a micrometre thick in every direction."""
    if len(points) < 4:
        return False
    origin = points[0]
    arms = [tuple(c - o for c, o in zip(point, origin, strict=True)) for point in points[1:]]
    first = max(arms, key=_length)
    normal = max((_cross(first, arm) for arm in arms), key=_length)
    area = _length(normal)
    heights = [abs(sum(n * c for n, c in zip(normal, arm, strict=True))) for arm in arms]
    return area > _THIN**2 and max(heights) > _THIN * area


def _cross(a: tuple[float, ...], b: tuple[float, ...]) -> tuple[float, ...]:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _length(a: tuple[float, ...]) -> float:
    return math.hypot(*a)


class Joint(CheckedValue, frozen=True, kw_only=True):
    """How a link moves against its parent, at rest at 0.

    Attributes:
        axis: unit vector in the asset frame.
        anchor: a point on the axis in the asset frame [m].
        lower, upper: range, degrees for a hinge and metres for a slide; positive opens.

    Raises:
        InputError: a field out of range, an axis whose length is not 1, or a `lower` above `upper`.
    """

    kind: Literal["hinge", "slide"]
    axis: Direction
    anchor: Point
    lower: Coordinate
    upper: Coordinate

    def __post_init__(self) -> None:
        super().__post_init__()
        if not is_unit(self.axis):
            raise self.refused("axis", f"is {self.axis}; a unit vector is needed, of length 1")
        if self.lower > self.upper:
            raise self.refused("lower", f"is {self.lower:g}, above upper, which is {self.upper:g}")


class Link(CheckedValue, frozen=True, kw_only=True, omit_defaults=True):
    """A rigid part. The first link of an asset is its body and has no joint; doors and drawers are joined to it.

    Attributes:
        shapes: what collides and weighs; also what is seen, where there are no `visuals`.
        joint: how it moves against the body; None for the body itself and what is fixed to it.
        visuals: meshes that are seen instead of the shapes.
    """

    name: Annotated[str, Meta(pattern=r"^[^\x00]+\Z", max_length=200)]
    shapes: Annotated[tuple[Shape, ...], Meta(min_length=1)]
    joint: Joint | None = None
    visuals: Annotated[tuple[MeshVisual, ...], Meta(max_length=MAX_VISUALS)] = ()


class Surface(CheckedValue, frozen=True, kw_only=True, omit_defaults=True):
    """A level area that carries things.

    Attributes:
        position: its centre in the asset frame [m].
        size: extent along the asset's x and y [m].
        headroom: free height above it [m]; None when open.
        round: the ellipse within `size` instead of the rectangle.
        within: it is behind a door or at the bottom of a hollow: what stands on it is in the thing, not on it.
    """

    name: str
    position: Point
    size: tuple[Extent, Extent]
    headroom: NotNegative | None = None
    round: bool = False
    within: bool = False

    @property
    def inner(self) -> bool:
        """Whether what stands on it is inside the thing: under another board, behind a door, in a hollow."""
        return self.within or self.headroom is not None


class AssetCard(Value, frozen=True, kw_only=True, omit_defaults=True):
    """What of an asset a policy may know, and a relation depends on; attributes as of Asset.

    Attributes:
        collides: whether any part of it can be touched; a rug cannot.
        opens: names of its doors and drawers.
        foot: where it touches what it stands on, x0, y0, x1, y1 in the asset frame [m]; None where that is about all
            of its outline.
    """

    id: str
    category: str
    description: str
    size: tuple[Extent, Extent, Extent]
    mass: float
    mount: Mount
    front: Literal["one", "two", "any"] = "one"
    clearance: float = 0.0
    surfaces: tuple[Surface, ...] = ()
    gaze: Gaze = "front"
    collides: bool = True
    opens: tuple[str, ...] = ()
    foot: tuple[Coordinate, Coordinate, Coordinate, Coordinate] | None = None

    @cached_property
    def free(self) -> bool:
        """Whether it can move: it is not fixed to a wall or a ceiling, and is not a rug."""
        return self.mount in ("floor", "surface") and self.collides


class Asset(CheckedValue, frozen=True, kw_only=True, omit_defaults=True, cache_hash=True, dict=True):
    """Something placeable, made of convex shapes: what is seen is what collides, but for links that have visuals.

    Attributes:
        id: "<category>-<hash of its content>".
        size: full extents (along the front axis, across, up) [m]; the shapes fill this box.
        mass: of the whole, spread over its shapes by what they are of [kg].
        friction: sliding coefficient.
        mount: what it is placed on. Wall and ceiling things are fixed to it.
        front: how many ways round look the same: "one" (a sofa), "two" (a rectangular table), "any" (a stool).
        gaze: which way one looks who uses it: over its front (a sofa), or over its back (a desk, worked at from its
            front); a desk faces a board when its front points away from the board.
        clearance: depth that should stay free before its front for use [m].
        surfaces: where other things can be put, largest useful first.
        attributes: the words it was made for, such as "round", "double", "three-seat".
        flags: what is not known of it, such as FRONT_UNKNOWN.

    Raises:
        InputError: a field out of range, two links of one name, or more than MAX_LINKS links or MAX_SHAPES shapes.
    """

    id: str
    category: str
    description: str
    size: tuple[Extent, Extent, Extent]
    mass: AboveZero
    friction: AboveZero
    mount: Mount
    links: Annotated[tuple[Link, ...], Meta(min_length=1, max_length=MAX_LINKS)]
    front: Literal["one", "two", "any"] = "one"
    gaze: Gaze = "front"
    clearance: NotNegative = 0.0
    surfaces: tuple[Surface, ...] = ()
    attributes: tuple[str, ...] = ()
    licence: str = "Apache-2.0"
    author: str = "ThinkBLOX procedural furniture"
    provenance: str = ""
    flags: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        names = [link.name for link in self.links]
        if twice := next((name for name in names if names.count(name) > 1), None):
            raise self.refused("links", f"has two of the name {twice!r}; names must differ")
        shapes = sum(len(link.shapes) for link in self.links)
        if shapes > MAX_SHAPES:
            raise self.refused("links", f"have {shapes} shapes in all; at most {MAX_SHAPES} are read")

    @cached_property
    def collides(self) -> bool:
        """Whether any part of it can be touched; a rug cannot: it is walked on."""
        return any(shape.collide for link in self.links for shape in link.shapes)

    @cached_property
    def free(self) -> bool:
        """Whether it can move: it is not fixed to a wall or a ceiling, and is not a rug."""
        return self.mount in ("floor", "surface") and self.collides

    @cached_property
    def made_of(self) -> tuple[int, int, int]:
        """How many links, shapes and joints it has."""
        joints = sum(link.joint is not None for link in self.links)
        return (len(self.links), sum(len(link.shapes) for link in self.links), joints)

    @property
    def name(self) -> str:
        """What it is called: its description without the attributes before and after it."""
        before, after = _around(self.attributes)
        plain = self.description.removeprefix(" ".join(self.attributes)).strip()
        return plain.removeprefix(before).removesuffix(after).strip()

    def called(self, name: str) -> "Asset":
        """The same thing by another name in its description: a "white massage table" as "treatment table"."""
        return self.described(worded(self.attributes, name))

    def described(self, description: str) -> "Asset":
        """The same thing with another description, and an id of its own."""
        return self if description == self.description else _described(self, description)

    @property
    def card(self) -> AssetCard:
        """What a policy may know of it."""
        return AssetCard(
            id=self.id,
            category=self.category,
            description=self.description,
            size=self.size,
            mass=self.mass,
            mount=self.mount,
            front=self.front,
            clearance=self.clearance,
            surfaces=self.surfaces,
            gaze=self.gaze,
            collides=self.collides,
            opens=tuple(link.name for link in self.links if link.joint is not None),
            foot=self._foot,
        )

    @cached_property
    def _foot(self) -> tuple[float, float, float, float] | None:
        """Box of what touches the ground; None where it is nearly the box of the whole."""
        points = np.vstack(
            [corners_of(s) for link in self.links for s in link.shapes if s.collide] or [np.zeros((1, 3))]
        )
        low = points[points[:, 2] < _GROUND]
        if not len(low):
            return None
        x0, y0, x1, y1 = (round(float(v), 4) for v in (*low[:, :2].min(axis=0), *low[:, :2].max(axis=0)))
        whole = x1 - x0 > _MOST * self.size[0] and y1 - y0 > _MOST * self.size[1]
        return None if whole else (x0, y0, x1, y1)

    @property
    def blobs(self) -> tuple[tuple[str, BlobKind], ...]:
        """Names and kinds of the blobs that it needs, each once."""
        found: dict[tuple[str, BlobKind], None] = {}
        for visual in (visual for link in self.links for visual in link.visuals):
            found[(visual.mesh, "bin")] = None
            if visual.look.texture is not None:
                found[(visual.look.texture, "png")] = None
        return tuple(found)


def worded(attributes: Sequence[str], name: str) -> str:
    """What a thing of some attributes is called: "long table for 6", and not "long for-6 table"."""
    before, after = _around(attributes)
    return " ".join(part for part in (before, name, after) if part)


def _around(attributes: Sequence[str]) -> tuple[str, str]:
    """The attributes that are said before a name, and those after it."""
    after = [a.replace("-", " ") for a in attributes if a.startswith("for-")]
    return " ".join(a for a in attributes if not a.startswith("for-")), " ".join(after)


@lru_cache(maxsize=512)
def _described(asset: Asset, description: str) -> Asset:
    digest = sha256(f"{asset.id} {description}".encode()).hexdigest()[:8]
    return structs.replace(asset, id=f"{asset.category}-{digest}", description=description)
