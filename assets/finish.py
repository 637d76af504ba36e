"""From a generator's parts to an asset's shapes: stretched to the exact box, on a grid of 0.1 mm."""

from math import sqrt

from msgspec import structs

from thinkblox.assets.part import Build, MovingParts, Part, bounds, stretched
from thinkblox.scene.asset import Joint, Link, Shape, Surface
from thinkblox.value import Quat, Vec3

_GRID = 4
_QUARTERS: dict[int, Quat] = {
    0: (round(sqrt(0.5), 8), 0.0, round(sqrt(0.5), 8), 0.0),
    1: (round(sqrt(0.5), 8), round(-sqrt(0.5), 8), 0.0, 0.0),
    2: (1.0, 0.0, 0.0, 0.0),
}
"""Orientation of a cylinder whose own z lies along an axis."""


def fitted(build: Build, size: Vec3) -> Build:
    """Return `build` stretched so that its bounding box is `size`, centred over the origin with its base at 0."""
    lo, hi = bounds(build.parts)
    sx, sy, sz = (s / (h - l) for s, l, h in zip(size, lo, hi, strict=True))
    scale = (sx, sy, sz)
    offset = (-sx * (lo[0] + hi[0]) / 2, -sy * (lo[1] + hi[1]) / 2, -sz * lo[2])
    return Build(
        body=[stretched(p, scale, offset) for p in build.body],
        moving=[_fitted_moving(m, scale, offset) for m in build.moving],
        surfaces=[_fitted_surface(s, scale, offset) for s in build.surfaces],
        front=build.front,
    )


def _at(p: Vec3, scale: Vec3, offset: Vec3) -> Vec3:
    x, y, z = (round(v * s + o, _GRID) for v, s, o in zip(p, scale, offset, strict=True))
    return (x, y, z)


def _fitted_moving(moving: MovingParts, scale: Vec3, offset: Vec3) -> MovingParts:
    joint: Joint = moving.joint
    upper = round(joint.upper * scale[0], 3) if joint.kind == "slide" else joint.upper
    parts = tuple(stretched(p, scale, offset) for p in moving.parts)
    return MovingParts(moving.name, parts, structs.replace(joint, anchor=_at(joint.anchor, scale, offset), upper=upper))


def _fitted_surface(surface: Surface, scale: Vec3, offset: Vec3) -> Surface:
    room = surface.headroom
    return structs.replace(
        surface,
        position=_at(surface.position, scale, offset),
        size=(round(surface.size[0] * scale[0], _GRID), round(surface.size[1] * scale[1], _GRID)),
        headroom=None if room is None else round(room * scale[2], _GRID),
    )


def links_of(build: Build, size: Vec3) -> tuple[Link, ...]:
    """Return the body and its moving parts as links."""
    body = Link(name="body", shapes=tuple(_shape(p, size) for p in build.body))
    moving = [Link(name=m.name, shapes=tuple(_shape(p, size) for p in m.parts), joint=m.joint) for m in build.moving]
    return (body, *moving)


def _snap(value: float, axis: int, size: Vec3) -> float:
    """Round to the grid, but keep what lies on the faces of the box exactly there."""
    low, high = (0.0, size[2]) if axis == 2 else (-size[axis] / 2, size[axis] / 2)
    for face in (low, high):
        if abs(value - face) < 0.6 * 10**-_GRID:
            return round(face, _GRID + 1)
    return round(value, _GRID)


def _shape(part: Part, size: Vec3) -> Shape:
    return _hull_shape(part, size) if part.kind == "hull" else _primitive(part, size)


def _primitive(part: Part, size: Vec3) -> Shape:
    lo = [_snap(v, i, size) for i, v in enumerate(part.lo)]
    hi = [_snap(v, i, size) for i, v in enumerate(part.hi)]
    extent = [max(1e-4, h - l) for l, h in zip(lo, hi, strict=True)]
    for group in _round_axes(part):
        # What fills the box along one axis is as wide as that, whatever the grid made of the others.
        across = next((extent[i] for i in group if abs(extent[i] - size[i]) < 1e-6), extent[group[0]])
        extent = [across if i in group else e for i, e in enumerate(extent)]
    centre = [_middle(lo[i], hi[i], extent[i], size[i] / 2 if i < 2 else size[2]) for i in range(3)]
    if part.kind in ("cylinder", "capsule"):
        across = extent[(part.axis + 1) % 3]
        extent = [across, across, extent[part.axis]]
    return Shape(
        kind=part.kind,
        size=(round(extent[0], 5), round(extent[1], 5), round(extent[2], 5)),
        position=(round(centre[0], 6), round(centre[1], 6), round(centre[2], 6)),
        quat_wxyz=_QUARTERS[part.axis] if part.kind in ("cylinder", "capsule") else (1.0, 0.0, 0.0, 0.0),
        colour=part.finish.colour,
        material=part.finish.material,
        collide=part.collide,
        smooth=part.smooth,
    )


def _round_axes(part: Part) -> list[tuple[int, ...]]:
    if part.kind == "sphere":
        return [(0, 1, 2)]
    return [((part.axis + 1) % 3, (part.axis + 2) % 3)] if part.kind in ("cylinder", "capsule") else []


def _middle(low: float, high: float, extent: float, face: float) -> float:
    """Centre of an extent that keeps the side lying on a face of the box there."""
    if abs(high - face) < 1e-6:
        return high - extent / 2
    if abs(low + face) < 1e-6 or abs(low) < 1e-6:
        return low + extent / 2
    return (low + high) / 2


def _hull_shape(part: Part, size: Vec3) -> Shape:
    corners = sorted({(_snap(x, 0, size), _snap(y, 1, size), _snap(z, 2, size)) for x, y, z in part.points})
    origin = [round((min(c[i] for c in corners) + max(c[i] for c in corners)) / 2, _GRID) for i in range(3)]
    points = tuple((round(x - origin[0], 5), round(y - origin[1], 5), round(z - origin[2], 5)) for x, y, z in corners)
    extent = [round(max(p[i] for p in points) - min(p[i] for p in points), 5) for i in range(3)]
    return Shape(
        kind="hull",
        size=(extent[0], extent[1], extent[2]),
        position=(origin[0], origin[1], origin[2]),
        points=points,
        colour=part.finish.colour,
        material=part.finish.material,
        collide=part.collide,
        smooth=part.smooth,
    )
