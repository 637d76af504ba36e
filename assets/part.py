"""A piece of furniture under construction: convex parts in the asset frame, which can be stretched to an exact box."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np
from msgspec import structs

from thinkblox.scene.asset import Joint, Material, Surface
from thinkblox.value import Vec3

Range = tuple[float, float]
Kind = Literal["box", "cylinder", "capsule", "sphere", "ellipsoid", "hull"]


@dataclass(frozen=True)
class Finish:
    """What a part is made of.

    Attributes:
        colour: sRGB, 0 to 1.
    """

    colour: Vec3
    material: Material


@dataclass(frozen=True)
class Part:
    """A convex solid, never turned except by quarter turns: what is turned is a hull.

    Attributes:
        lo, hi: its bounding box in the asset frame [m].
        axis: the axis of a cylinder or capsule, 0 to 2.
        points: corners of a hull in the asset frame [m].
    """

    kind: Kind
    lo: Vec3
    hi: Vec3
    finish: Finish
    axis: int = 2
    points: tuple[Vec3, ...] = ()
    collide: bool = True
    smooth: bool = False

    @property
    def size(self) -> Vec3:
        """Full extents [m]."""
        return (self.hi[0] - self.lo[0], self.hi[1] - self.lo[1], self.hi[2] - self.lo[2])

    @property
    def centre(self) -> Vec3:
        """Centre of the bounding box [m]."""
        return ((self.lo[0] + self.hi[0]) / 2, (self.lo[1] + self.hi[1]) / 2, (self.lo[2] + self.hi[2]) / 2)


@dataclass(frozen=True)
class MovingParts:
    """Parts that move together about a joint."""

    name: str
    parts: tuple[Part, ...]
    joint: Joint


@dataclass
class Build:
    """What a generator hands back: fixed parts, doors and drawers, and where things can be put.

    Attributes:
        front: overrides the category's ways round ("any" for a round table).
    """

    body: list[Part] = field(default_factory=list)
    moving: list[MovingParts] = field(default_factory=list)
    surfaces: list[Surface] = field(default_factory=list)
    front: Literal["one", "two", "any"] | None = None

    @property
    def parts(self) -> list[Part]:
        """All parts, fixed and moving."""
        return self.body + [part for moving in self.moving for part in moving.parts]


def bounds(parts: Iterable[Part]) -> tuple[Vec3, Vec3]:
    """Lower and upper corner of the box around `parts` [m]."""
    listed = list(parts)
    lo = np.min([p.lo for p in listed], axis=0)
    hi = np.max([p.hi for p in listed], axis=0)
    return (float(lo[0]), float(lo[1]), float(lo[2])), (float(hi[0]), float(hi[1]), float(hi[2]))


def hull(finish: Finish, points: Iterable[Vec3], *, smooth: bool = False, collide: bool = True) -> Part:
    """Return the convex hull of `points` [m, asset frame]."""
    cloud = np.array(list(points), dtype=float)
    corners = tuple((float(x), float(y), float(z)) for x, y, z in cloud)
    lo, hi = cloud.min(axis=0), cloud.max(axis=0)
    return Part(
        "hull",
        (float(lo[0]), float(lo[1]), float(lo[2])),
        (float(hi[0]), float(hi[1]), float(hi[2])),
        finish,
        points=corners,
        smooth=smooth,
        collide=collide,
    )


def stretched(part: Part, scale: Vec3, offset: Vec3) -> Part:
    """`part` after p -> scale * p + offset; a cylinder that stops being round becomes a hull."""
    if part.kind == "hull" or (_distorts(part, scale)):
        corners = np.array(part.points if part.kind == "hull" else outline_points(part)) * scale + offset
        points = ((float(x), float(y), float(z)) for x, y, z in corners)
        return hull(part.finish, points, smooth=part.smooth or part.kind != "hull", collide=part.collide)
    lo = tuple(l * s + o for l, s, o in zip(part.lo, scale, offset, strict=True))
    hi = tuple(h * s + o for h, s, o in zip(part.hi, scale, offset, strict=True))
    kind: Kind = "ellipsoid" if part.kind == "sphere" and len({round(s, 9) for s in scale}) > 1 else part.kind
    return replace(part, kind=kind, lo=(lo[0], lo[1], lo[2]), hi=(hi[0], hi[1], hi[2]))


def _distorts(part: Part, scale: Vec3) -> bool:
    if part.kind == "cylinder":
        a, b = (scale[i] for i in range(3) if i != part.axis)
        return abs(a - b) > 1e-9
    return part.kind == "capsule" and max(scale) - min(scale) > 1e-9


def moved(part: Part, offset: Vec3) -> Part:
    """`part` shifted by `offset` [m]."""
    return stretched(part, (1.0, 1.0, 1.0), offset)


def turned(part: Part, axis: int, degrees: float, about: Vec3) -> Part:
    """`part` as a hull, turned about an axis (0 to 2, right-handed) through the point `about`."""
    angle, (i, j) = np.radians(degrees), ((axis + 1) % 3, (axis + 2) % 3)
    local = np.array(part.points if part.kind == "hull" else outline_points(part)) - about
    result = local.copy()
    result[:, i] = local[:, i] * np.cos(angle) - local[:, j] * np.sin(angle)
    result[:, j] = local[:, i] * np.sin(angle) + local[:, j] * np.cos(angle)
    points = ((float(x), float(y), float(z)) for x, y, z in result + np.array(about))
    smooth = part.smooth or part.kind not in ("box", "hull")
    return hull(part.finish, points, smooth=smooth, collide=part.collide)


def half_turned(build: Build) -> Build:
    """`build` with its back to the front: turned by half a turn about the vertical axis."""
    surfaces = [structs.replace(s, position=(-s.position[0], -s.position[1], s.position[2])) for s in build.surfaces]
    moving = [replace(m, parts=tuple(map(_half_turned, m.parts)), joint=_joint_turned(m.joint)) for m in build.moving]
    return replace(build, body=list(map(_half_turned, build.body)), moving=moving, surfaces=surfaces)


def _half_turned(part: Part) -> Part:
    return replace(
        part,
        lo=(-part.hi[0], -part.hi[1], part.lo[2]),
        hi=(-part.lo[0], -part.lo[1], part.hi[2]),
        points=tuple((-x, -y, z) for x, y, z in part.points),
    )


def _joint_turned(joint: Joint) -> Joint:
    (ax, ay, az), (px, py, pz) = joint.axis, joint.anchor
    return structs.replace(joint, axis=(0.0 - ax, 0.0 - ay, az), anchor=(-px, -py, pz))


def outline_points(part: Part) -> list[Vec3]:
    """Corners of a primitive, a round one as a polyhedron inscribed in it and touching its bounding box [m]."""
    unit = {"box": _cube, "cylinder": _drum, "capsule": _ball, "sphere": _ball, "ellipsoid": _ball}[part.kind]()
    if part.kind == "cylinder":
        unit = [_rolled(p, part.axis) for p in unit]
    c, s = part.centre, part.size
    return [(c[0] + x * s[0] / 2, c[1] + y * s[1] / 2, c[2] + z * s[2] / 2) for x, y, z in unit]


def _rolled(p: Vec3, axis: int) -> Vec3:
    return p if axis == 2 else (p[2], p[0], p[1]) if axis == 0 else (p[1], p[2], p[0])


def _cube() -> list[Vec3]:
    return [(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)]


def _drum(sides: int = 32) -> list[Vec3]:
    angles = np.arange(sides) * 2 * np.pi / sides
    return [(float(np.cos(a)), float(np.sin(a)), z) for a in angles for z in (-1.0, 1.0)]


def _ball(sides: int = 12, rings: int = 5) -> list[Vec3]:
    points = [(0.0, 0.0, -1.0), (0.0, 0.0, 1.0)]
    for ring in range(1, rings + 1):
        z, r = np.cos(np.pi * ring / (rings + 1)), np.sin(np.pi * ring / (rings + 1))
        angles = np.arange(sides) * 2 * np.pi / sides
        points += [(float(r * np.cos(a)), float(r * np.sin(a)), float(z)) for a in angles]
    return points
